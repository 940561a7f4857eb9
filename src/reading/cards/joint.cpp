// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/axes.hpp"
#include "reading/bodies/rigid_bodies.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *CONSTRAINED_JOINT_..., *CONTROL_RIGID. Layouts: public keyword tables (PyDYNA).
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

/// The card of a joint's nodes, or that of its bodies.
struct JointCard {
  std::array<int, 6> node{};
  std::array<int, 2> body{};
  double rps = 0, damp = 0;
  int rbidc = 0;
};
const CardOf<JointCard> joint_card{
    {at(&JointCard::node, 0), id("n1", IdSpace::node, required, "node of body A at the joint")},
    {at(&JointCard::node, 1), id("n2", IdSpace::node, required, "node of body B at the same place")},
    {at(&JointCard::node, 2), id("n3", IdSpace::node, 0, "node of body A: n1 to n3 is the joint's axis")},
    {at(&JointCard::node, 3),
     id("n4", IdSpace::node, 0,
        "node of body B at the place of n3; universal, gears and the like: n2 to n4 is the other axis")},
    {at(&JointCard::node, 4), id("n5", IdSpace::node, 0, "node of body A off the axis (translational, locking)")},
    {at(&JointCard::node, 5), id("n6", IdSpace::node, 0, "node of body B at the place of n5")},
    {&JointCard::rps,
     real("rps", dimension::number, 1, above_zero(), "factor on the penalty stiffness; 2 is the most that is stable")},
    {&JointCard::damp, real("damp", dimension::number, 1, between(0, 5), "factor on the damping; up to 0.01: none")},
};

const CardOf<JointCard> bodies_card{
    {at(&JointCard::body, 0),
     id("rbid_a", IdSpace::part, required, "rigid body A: part of *MAT_RIGID, or nodal rigid body")},
    {at(&JointCard::body, 1), id("rbid_b", IdSpace::part, required, "rigid body B")},
    {&JointCard::rps,
     real("rps", dimension::number, 1, above_zero(), "factor on the penalty stiffness; 2 is the most that is stable")},
    {&JointCard::damp, real("damp", dimension::number, 1, between(0, 5), "factor on the damping; up to 0.01: none")},
    real("tmass", dimension::mass, 0, only(0), "mass shared by the first points of A and B: not built"),
    real("rmass", dimension::inertia, 0, only(0), "rotary inertia of these points: not built"),
    {&JointCard::rbidc, id("rbidc", IdSpace::part, 0, "rigid body C, of harmonic drives only")},
};

struct JointPointCard {
  double x = 0, y = 0, z = 0;
};
CardOf<JointPointCard> joint_point_card(std::string_view meaning) {
  return {{&JointPointCard::x, real("x", dimension::length, 0, any_value, meaning)},
          {&JointPointCard::y, real("y", dimension::length, 0, any_value, meaning)},
          {&JointPointCard::z, real("z", dimension::length, 0, any_value, meaning)}};
}
const std::array<CardOf<JointPointCard>, 6> point_cards{
    joint_point_card("point 1 on body A: where the joint is"),
    joint_point_card("point 2 on body B: taken as point 1"),
    joint_point_card("point 3 on body A: point 1 to 3 is the joint's axis"),
    joint_point_card("point 4 on body B: taken as point 3; universal: point 2 to 4 is the other axis"),
    joint_point_card("point 5 on body A, off the axis (translational, locking)"),
    joint_point_card("point 6 on body B: taken as point 5"),
};

struct ControlCard {
  int lmf = 0;
};
const CardOf<ControlCard> joint_rigid_card{
    {&ControlCard::lmf, integer("lmf", 0, between(0, 1), "joints: 0 penalty, 1 Lagrange multipliers (not built)")},
    unused(),
    unused(),
    unused(),
    unused(),
    unused(),
    unused(),
    unused(),
};

struct TransmissionCard {
  double parm = 0, r1 = 0;
  int lcid = 0, type = 0;
};
CardOf<TransmissionCard> transmission_card(Dimension parm, std::string_view meaning) {
  return {
      {&TransmissionCard::parm, real("parm", parm, 0, any_value, meaning)},
      {&TransmissionCard::lcid, id("lcid", IdSpace::function, 0, "of motors: does nothing here")},
      {&TransmissionCard::type, integer("type", 0, any_value, "of motors: does nothing here")},
      {&TransmissionCard::r1, real("r1", dimension::length, 0, at_least(0),
                                   "radius R1 of gears and pulleys; 0: distance of n5 from the axis")},
      real("h_angle", dimension::number, 0, only(0), "helix angle of gears: not built"),
  };
}
const CardOf<TransmissionCard> ratio_card = transmission_card(dimension::number, "R2/R1");
const CardOf<TransmissionCard> way_card =
    transmission_card(dimension::length, "way of body B over the angle of A [1/rad]: h of a pinion, p of a screw");

struct LocalCard {
  int raid = 0, lst = 0;
};
const CardOf<LocalCard> local_card{
    {&LocalCard::raid,
     id("raid", IdSpace::part, required, "LST 0: rigid body, LST 1: accelerometer, in the axes of which results are")},
    {&LocalCard::lst, integer("lst", 0, between(0, 1), "0: RAID is a rigid body, 1: an accelerometer")},
};

struct FailureCard {
  int cid = 0;
  double tfail = 0, coupl = 0;
};
const CardOf<FailureCard> joint_failure_card{
    {&FailureCard::cid, id("cid", IdSpace::define, 0, "axes of the limits below; 0: global")},
    {&FailureCard::tfail, real("tfail", dimension::time, 0, at_least(0), "time from which the joint is gone; 0: none")},
    {&FailureCard::coupl,
     real("coupl", dimension::number, 0, any_value, "up to 0: forces and moments count together; above 0: apart")},
};

struct LimitsCard {
  double nxx = 0, nyy = 0, nzz = 0, mxx = 0, myy = 0, mzz = 0;
};
const CardOf<LimitsCard> limits_card{
    {&LimitsCard::nxx, real("nxx", dimension::force, 0, at_least(0), "force along x at failure; 0: not considered")},
    {&LimitsCard::nyy, real("nyy", dimension::force, 0, at_least(0), "force along y at failure")},
    {&LimitsCard::nzz, real("nzz", dimension::force, 0, at_least(0), "force along z at failure")},
    {&LimitsCard::mxx, real("mxx", dimension::moment, 0, at_least(0), "moment about x at failure")},
    {&LimitsCard::myy, real("myy", dimension::moment, 0, at_least(0), "moment about y at failure")},
    {&LimitsCard::mzz, real("mzz", dimension::moment, 0, at_least(0), "moment about z at failure")},
};

using JointKind = Joint::Kind;

const CardOf<TransmissionCard>& card_of_ratio(JointKind kind) {
  return kind == JointKind::gears || kind == JointKind::pulley ? ratio_card : way_card;
}

/// How many pairs of nodes a joint has.
std::size_t pairs(JointKind kind) {
  switch (kind) {
    case JointKind::spherical: return 1;
    case JointKind::revolute:
    case JointKind::cylindrical:
    case JointKind::planar:
    case JointKind::universal: return 2;
    default: return 3;
  }
}

constexpr Frame3d global_axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// Where findings about a joint's points stand.
using JointPointFields = std::array<deck::Entry, 6>;

JointPointFields node_fields(const RowOf<JointCard>& row) {
  JointPointFields fields;
  for (std::size_t i = 0; i < fields.size(); ++i) fields[i] = row[at(&JointCard::node, i)];
  return fields;
}

/// The nodes and the two rigid bodies that they belong to; false and a finding where that fails.
bool find_bodies(Builder& b, const JointPointFields& fields, Joint& joint) {
  const std::size_t count = 2 * pairs(joint.kind);
  for (std::size_t i = 0; i < count; ++i) {
    const deck::Entry& field = fields[i];
    joint.node[i] = b.node(field);
    if (joint.node[i] == none) {
      if (field.integer() == 0)
        refuse(b, field, fmt::format("this joint has {} pairs of nodes", count / 2), "give the node");
      return false;
    }
    const Index body = b.body_of_node[joint.node[i]];
    if (body == none) {
      refuse(b, field, "a joint joins rigid bodies, but this node is on none",
             "make it a node of a *MAT_RIGID part (*CONSTRAINED_EXTRA_NODES) or of a *CONSTRAINED_NODAL_RIGID_BODY");
      return false;
    }
    Index& side = joint.body[i % 2];
    if (side == none) side = body;
    if (side != body) {
      refuse(b, field, fmt::format("this node is not on the body of {}", fields[i % 2].field),
             "odd nodes belong to body A, even ones to body B");
      return false;
    }
    joint.point[i] = b.model.nodes.x[joint.node[i]];
  }
  if (joint.body[0] != joint.body[1]) return true;
  refuse(b, fields[1], "both nodes belong to the same rigid body", "take the second node from the other body");
  return false;
}

/// Axes of A and B, ratio and radius of a joint that transmits; `ratio`: its second card.
bool check_transmission(Builder& b, const JointPointFields& field, const RowOf<TransmissionCard>& ratio, Joint& joint) {
  joint.ratio = ratio->parm;
  const bool turns = joint.kind == JointKind::gears || joint.kind == JointKind::pulley;
  if (turns ? !(joint.ratio > 0.0) : joint.ratio == 0.0) {
    refuse(b, ratio[&TransmissionCard::parm],
           turns ? "the ratio R2/R1 must be above 0" : "a ratio of 0 transmits nothing", "give the ratio");
    return false;
  }
  const Vec3d a = joint.point[2] - joint.point[0], other = joint.point[3] - joint.point[1];
  for (const std::size_t i : {0u, 1u}) {
    if (norm(i == 0 ? a : other) > 0.0) continue;
    refuse(b, field[2 + i], "this point and the one two before it are at one place, so there is no axis",
           "take points far apart");
    return false;
  }
  const double cosine = dot(unit(a), unit(other));
  if (joint.kind == JointKind::rack_and_pinion && std::abs(cosine) > 0.02) {
    refuse(b, field[3], "the rack's way (second to fourth point) must be perpendicular to the pinion's axis",
           "see the coordinates");
    return false;
  }
  if (joint.kind == JointKind::screw) {
    const Vec3d off = joint.point[1] - joint.point[0];
    if (std::abs(cosine) < 0.9998 || norm(cross(unit(a), off)) > 0.02 * std::max(norm(a), norm(off))) {
      refuse(b, field[1], "the first four points of a screw joint must lie on one axis", "see the coordinates");
      return false;
    }
  }
  if (turns) {
    joint.radius = ratio->r1;
    if (joint.radius == 0.0) joint.radius = norm(cross(unit(a), joint.point[4] - joint.point[0]));
    if (!(joint.radius > 0.0)) {
      refuse(b, field[4], "the fifth point lies on the axis, so the radius R1 is not known", "give R1");
      return false;
    }
  }
  return true;
}

bool check_places(Builder& b, const JointPointFields& field, const Joint& joint) {
  const auto place = [&](std::size_t i) { return joint.point[i]; };
  const std::size_t count = pairs(joint.kind);
  const Vec3d axis = count > 1 ? place(2) - place(0) : Vec3d{};
  if (count > 1 && !(norm(axis) > 0.0)) {
    refuse(b, field[2], "the first and third point are at one place, so the joint has no axis",
           "take points far apart");
    return false;
  }
  // Decks write coordinates with a few digits.
  const double near = 1e-3 * (count > 1 ? norm(axis) : 1.0);
  const std::size_t coincident = joint.kind == JointKind::universal ? 1 : count;
  for (std::size_t p = 0; p < coincident; ++p) {
    if (norm(place(2 * p + 1) - place(2 * p)) <= near) continue;
    refuse(b, field[2 * p + 1],
           fmt::format("{} and {} are to be at one place, but they are {:g} apart", field[2 * p].field,
                       field[2 * p + 1].field, norm(place(2 * p + 1) - place(2 * p))),
           "give both the same coordinates");
    return false;
  }
  if (joint.kind == JointKind::universal) {
    const Vec3d other = place(3) - place(1);
    if (!(norm(other) > 0.0) || std::abs(dot(axis, other)) > 0.02 * norm(axis) * norm(other)) {
      refuse(b, field[3],
             "the axes from the first point to the third and from the second to the fourth must be "
             "perpendicular",
             "see the coordinates");
      return false;
    }
  }
  if (count == 3 && !(norm(cross(axis, place(4) - place(0))) > 1e-6 * dot(axis, axis))) {
    refuse(b, field[4], "the fifth point lies on the axis from the first to the third, so it holds no rotation",
           "take one off the axis");
    return false;
  }
  return true;
}

/// The cards of _LOCAL and _FAILURE.
struct Extras {
  std::optional<RowOf<LocalCard>> local;
  std::optional<RowOf<FailureCard>> failure;
  LimitsCard limits;
};

Extras read_extras(Builder& b, Cursor& cursor, const Options& options) {
  Extras extras;
  if (options.contains("LOCAL")) extras.local = cursor.read(local_card);
  if (options.contains("FAILURE")) {
    extras.failure = cursor.read(joint_failure_card);
    extras.limits = *cursor.read(limits_card);
    const FailureCard& failure = **extras.failure;
    const LimitsCard& l = extras.limits;
    if (!(std::max({failure.tfail, l.nxx, l.nyy, l.nzz, l.mxx, l.myy, l.mzz}) > 0.0))
      (*extras.failure)[&FailureCard::tfail].report(b.findings, Severity::warning,
                                                    "neither a time nor a limit: this joint never fails",
                                                    "give TFAIL or one of NXX to MZZ");
  }
  return extras;
}

/// The axes of _LOCAL; nothing and a finding where they are not to be had.
std::optional<Joint::Output> output_axes(Builder& b, const RowOf<LocalCard>& row) {
  const deck::Entry raid = row[&LocalCard::raid];
  if (row->lst == 0) {
    const Index body = find_body(b, raid);
    if (body == none) return std::nullopt;
    const Frame3d* own = body_axes(b, row->raid);
    return Joint::Output{body, own ? *own : global_axes};
  }
  const auto& all = b.model.accelerometers;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Accelerometer& a) { return a.id == row->raid; });
  if (found == all.end()) {
    refuse(b, raid, "no such *ELEMENT_SEATBELT_ACCELEROMETER is defined", "name one, or a rigid body with LST 0");
    return std::nullopt;
  }
  const auto at = [&](std::size_t i) { return b.model.nodes.x[found->node[i]]; };
  const Index body = b.body_of_node[found->node[0]];
  if (body == none) {
    refuse(b, raid, "this accelerometer is on no rigid body", "name one that is, or a rigid body with LST 0");
    return std::nullopt;
  }
  Joint::Output output{body, global_axes};
  frame_from(at(1) - at(0), at(2) - at(0), output.axes);
  return output;
}

void take_extras(Builder& b, const Extras& extras, Joint& joint) {
  if (extras.local) joint.output = output_axes(b, *extras.local);
  if (!extras.failure) return;
  Joint::Failure failure;
  const RowOf<FailureCard>& row = *extras.failure;
  failure.time = row->tfail;
  failure.system = b.turning_or_fixed_system(row[&FailureCard::cid]);
  failure.together = !(row->coupl > 0.0);
  failure.force = {extras.limits.nxx, extras.limits.nyy, extras.limits.nzz};
  failure.moment = {extras.limits.mxx, extras.limits.myy, extras.limits.mzz};
  joint.failure = failure;
}

/// RPS and DAMP, and an id where there is none.
void take_penalty(Builder& b, const RowOf<JointCard>& row, Joint& joint) {
  joint.stiffness_scale = row->rps;
  joint.damping = row->damp > 0.01 ? row->damp : 0.0;
  if (joint.id == 0) joint.id = static_cast<int>(b.model.joints.size()) + 1;
  if (joint.stiffness_scale > 2.0)
    row[&JointCard::rps].report(b.findings, Severity::warning, "computed with 2, the most that is stable",
                                "write 2 or less");
}

void add_joint(Builder& b, const RowOf<JointCard>& row, const Extras& extras, Joint joint) {
  take_penalty(b, row, joint);
  take_extras(b, extras, joint);
  const JointPointFields fields = node_fields(row);
  if (find_bodies(b, fields, joint) && check_places(b, fields, joint)) b.model.joints.push_back(std::move(joint));
}

Joint begun(Cursor& cursor, const Options& options, JointKind kind) {
  Joint joint;
  joint.kind = kind;
  const Heading heading = read_heading(cursor, options.contains("ID") || options.contains("TITLE"));
  joint.id = heading.id;
  joint.title = heading.text;
  return joint;
}

RowOf<TransmissionCard> read_ratio(Builder& b, Cursor& cursor, JointKind kind) {
  const auto row = cursor.read(card_of_ratio(kind));
  expect(b, Severity::warning,
         {{row[&TransmissionCard::lcid], 0, "belongs to motors: it does nothing here"},
          {row[&TransmissionCard::type], 0, "belongs to motors: it does nothing here"}});
  return row;
}

void add_transmission(Builder& b, const RowOf<JointCard>& row, const RowOf<TransmissionCard>& ratio,
                      const Extras& extras, Joint joint) {
  take_penalty(b, row, joint);
  take_extras(b, extras, joint);
  const JointPointFields fields = node_fields(row);
  if (find_bodies(b, fields, joint) && check_transmission(b, fields, ratio, joint))
    b.model.joints.push_back(std::move(joint));
}

template <JointKind kind>
void read_transmission(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    Joint joint = begun(cursor, options, kind);
    const auto row = cursor.read(joint_card);
    const auto ratio = read_ratio(b, cursor, kind);
    const Extras extras = read_extras(b, cursor, options);
    joint.place = row.place();
    b.defer(Phase::conditions,
            [row, ratio, extras, joint](Builder& later) { add_transmission(later, row, ratio, extras, joint); });
  }
}

template <JointKind kind>
void read_joint(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    Joint joint = begun(cursor, options, kind);
    const auto row = cursor.read(joint_card);
    const Extras extras = read_extras(b, cursor, options);
    joint.place = row.place();
    b.defer(Phase::conditions, [row, extras, joint](Builder& later) { add_joint(later, row, extras, joint); });
  }
}

// ---- by points

JointPointFields body_fields(const RowOf<JointCard>& row) {
  JointPointFields fields;
  fields.fill(row[at(&JointCard::body, 0)]);
  return fields;
}

bool find_both(Builder& b, const RowOf<JointCard>& row, Joint& joint) {
  take_penalty(b, row, joint);
  for (std::size_t i = 0; i < 2; ++i) joint.body[i] = find_body(b, row[at(&JointCard::body, i)]);
  if (joint.body[0] == none || joint.body[1] == none) return false;
  if (joint.body[0] != joint.body[1]) return true;
  refuse(b, row[at(&JointCard::body, 1)], "a joint joins two bodies, but this is body A", "name the other one");
  return false;
}

void add_joint_by_points(Builder& b, const RowOf<JointCard>& row, const Extras& extras, Joint joint) {
  take_extras(b, extras, joint);
  if (find_both(b, row, joint) && check_places(b, body_fields(row), joint)) b.model.joints.push_back(std::move(joint));
}

void add_transmission_by_points(Builder& b, const RowOf<JointCard>& row, const RowOf<TransmissionCard>& ratio,
                                const Extras& extras, Joint joint) {
  take_extras(b, extras, joint);
  if (find_both(b, row, joint) && check_transmission(b, body_fields(row), ratio, joint))
    b.model.joints.push_back(std::move(joint));
}

/// The card of the bodies and six of points.
RowOf<JointCard> read_joint_points(Builder& b, Cursor& cursor, const Block& block, Joint& joint) {
  const auto row = cursor.read(bodies_card);
  joint.place = row.place();
  expect(b, Severity::warning, {{row[&JointCard::rbidc], 0, "belongs to harmonic drives: it does nothing here"}});
  for (std::size_t i = 0; i < point_cards.size() && !at_end(cursor); ++i) {
    const auto point = cursor.read(point_cards[i]);
    joint.point[i] = position(block, {point->x, point->y, point->z});
  }
  return row;
}

template <JointKind kind>
void read_joint_by_points(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    Joint joint = begun(cursor, options, kind);
    const auto row = read_joint_points(b, cursor, block, joint);
    // The second point of a pair is where the first one is, whatever its card says.
    for (std::size_t p = 0; p < pairs(kind); ++p)
      if (p == 0 || kind != JointKind::universal) joint.point[2 * p + 1] = joint.point[2 * p];
    const Extras extras = read_extras(b, cursor, options);
    b.defer(Phase::conditions,
            [row, extras, joint](Builder& later) { add_joint_by_points(later, row, extras, joint); });
  }
}

template <JointKind kind>
void read_transmission_by_points(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    Joint joint = begun(cursor, options, kind);
    const auto row = read_joint_points(b, cursor, block, joint);
    const auto ratio = read_ratio(b, cursor, kind);
    const Extras extras = read_extras(b, cursor, options);
    b.defer(Phase::conditions, [row, ratio, extras, joint](Builder& later) {
      add_transmission_by_points(later, row, ratio, extras, joint);
    });
  }
}

void read_joint_control(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const auto row = cursor.read(joint_rigid_card);
  b.defer(Phase::checks, [row](Builder& later) {
    if (row->lmf == 1 && !later.model.joints.empty())
      refuse(later, row[&ControlCard::lmf], "joints by Lagrange multipliers are not built",
             "write 0: joints by penalty");
  });
}

/// A keyword with the cards that all joints may have before and after their own.
Keyword made(std::string_view name, std::vector<LayoutCard> own, void (*read)(Builder&, const Block&, const Options&)) {
  std::vector<LayoutCard> layout{{"with _ID", &heading_card}};
  layout.insert(layout.end(), own.begin(), own.end());
  layout.push_back({"with _LOCAL", &local_card});
  layout.push_back({"with _FAILURE", &joint_failure_card});
  layout.push_back({"with _FAILURE", &limits_card});
  return {.name = name, .options = {"ID", "TITLE", "LOCAL", "FAILURE"}, .layout = std::move(layout), .read = read};
}

std::vector<LayoutCard> cards_of_points() {
  std::vector<LayoutCard> cards{{"", &bodies_card}};
  for (const Card& card : point_cards) cards.push_back({"", &card});
  return cards;
}

template <JointKind kind>
Keyword joint(std::string_view name) {
  return made(name, {{"", &joint_card}}, read_joint<kind>);
}

template <JointKind kind>
Keyword joint_by_points(std::string_view name) {
  return made(name, cards_of_points(), read_joint_by_points<kind>);
}

template <JointKind kind>
Keyword transmission(std::string_view name) {
  return made(name, {{"", &joint_card}, {"", &card_of_ratio(kind)}}, read_transmission<kind>);
}

template <JointKind kind>
Keyword transmission_by_points(std::string_view name) {
  std::vector<LayoutCard> cards = cards_of_points();
  cards.push_back({"", &card_of_ratio(kind)});
  return made(name, std::move(cards), read_transmission_by_points<kind>);
}

}  // namespace

std::vector<Keyword> joint_keywords() {
  const auto refused = [](std::string_view name, std::string_view why) {
    return Keyword{.name = name, .status = KeywordStatus::refused, .why = why};
  };
  return {
      joint<JointKind::spherical>("CONSTRAINED_JOINT_SPHERICAL"),
      joint<JointKind::revolute>("CONSTRAINED_JOINT_REVOLUTE"),
      joint<JointKind::cylindrical>("CONSTRAINED_JOINT_CYLINDRICAL"),
      joint<JointKind::planar>("CONSTRAINED_JOINT_PLANAR"),
      joint<JointKind::universal>("CONSTRAINED_JOINT_UNIVERSAL"),
      joint<JointKind::translational>("CONSTRAINED_JOINT_TRANSLATIONAL"),
      joint<JointKind::locking>("CONSTRAINED_JOINT_LOCKING"),
      joint_by_points<JointKind::spherical>("CONSTRAINED_JOINT_COOR_SPHERICAL"),
      joint_by_points<JointKind::revolute>("CONSTRAINED_JOINT_COOR_REVOLUTE"),
      joint_by_points<JointKind::cylindrical>("CONSTRAINED_JOINT_COOR_CYLINDRICAL"),
      joint_by_points<JointKind::planar>("CONSTRAINED_JOINT_COOR_PLANAR"),
      joint_by_points<JointKind::universal>("CONSTRAINED_JOINT_COOR_UNIVERSAL"),
      joint_by_points<JointKind::translational>("CONSTRAINED_JOINT_COOR_TRANSLATIONAL"),
      joint_by_points<JointKind::locking>("CONSTRAINED_JOINT_COOR_LOCKING"),
      transmission<JointKind::gears>("CONSTRAINED_JOINT_GEARS"),
      transmission<JointKind::pulley>("CONSTRAINED_JOINT_PULLEY"),
      transmission<JointKind::rack_and_pinion>("CONSTRAINED_JOINT_RACK_AND_PINION"),
      transmission<JointKind::screw>("CONSTRAINED_JOINT_SCREW"),
      transmission_by_points<JointKind::gears>("CONSTRAINED_JOINT_COOR_GEARS"),
      transmission_by_points<JointKind::pulley>("CONSTRAINED_JOINT_COOR_PULLEY"),
      transmission_by_points<JointKind::rack_and_pinion>("CONSTRAINED_JOINT_COOR_RACK_AND_PINION"),
      transmission_by_points<JointKind::screw>("CONSTRAINED_JOINT_COOR_SCREW"),
      refused("CONSTRAINED_JOINT_*",
              "this joint is not built; SPHERICAL, REVOLUTE, CYLINDRICAL, PLANAR, UNIVERSAL, TRANSLATIONAL, LOCKING, "
              "GEARS, PULLEY, RACK_AND_PINION and SCREW are, by nodes and by points (_COOR_)"),
      {.name = "CONTROL_RIGID", .layout = {{"", &joint_rigid_card}}, .read = read_joint_control},
  };
}

}  // namespace nugget::reading
