// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *CONSTRAINED_JOINT_STIFFNESS_...: layouts as in the LS-DYNA manual, vol. I.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

struct JointStiffnessCard {
  int jsid = 0, pida = 0, pidb = 0, cida = 0, cidb = 0;
};
const CardOf<JointStiffnessCard> joint_stiffness_card{
    {&JointStiffnessCard::jsid, id("jsid", IdSpace::other, required, "id of the stiffness")},
    {&JointStiffnessCard::pida, id("pida", IdSpace::part, required, "rigid body A: a part or a nodal rigid body")},
    {&JointStiffnessCard::pidb, id("pidb", IdSpace::part, required, "rigid body B")},
    {&JointStiffnessCard::cida, id("cida", IdSpace::define, required, "coordinate system of body A")},
    {&JointStiffnessCard::cidb, id("cidb", IdSpace::define, 0, "coordinate system of body B; 0: that of A")},
    integer("jid", 0, any_value, "joint; no effect, as friction does not depend on its force"),
    real("rps", dimension::number, 1, any_value, "no effect: for FS and FD only"),
};

/// Of the rotations or translations, by axis.
struct FreedomCards {
  std::array<int, 3> load{}, damper{};
  std::array<double, 3> stiffness{}, friction{}, low{}, high{};
};

const CardOf<FreedomCards> rotary_curves_card{
    {at(&FreedomCards::load, 0), id("lcidph", IdSpace::function, 0, "curve: moment over the rotation about x [rad]")},
    {at(&FreedomCards::load, 1), id("lcidt", IdSpace::function, 0, "curve: about y")},
    {at(&FreedomCards::load, 2), id("lcidps", IdSpace::function, 0, "curve: about z")},
    {at(&FreedomCards::damper, 0), id("dlcidph", IdSpace::function, 0, "curve: damping moment over the rate about x")},
    {at(&FreedomCards::damper, 1), id("dlcidt", IdSpace::function, 0, "curve: about y")},
    {at(&FreedomCards::damper, 2), id("dlcidps", IdSpace::function, 0, "curve: about z")},
};
const CardOf<FreedomCards> rotary_friction_card{
    {at(&FreedomCards::stiffness, 0),
     real("esph", dimension::moment, 0, at_least(0), "stiffness of friction and stops about x, a radian")},
    {at(&FreedomCards::friction, 0),
     real("fmph", dimension::moment, 0, at_least(0), "friction moment about x; 0: none; no curves")},
    {at(&FreedomCards::stiffness, 1), real("est", dimension::moment, 0, at_least(0), "stiffness about y")},
    {at(&FreedomCards::friction, 1), real("fmt", dimension::moment, 0, at_least(0), "friction moment about y")},
    {at(&FreedomCards::stiffness, 2), real("esps", dimension::moment, 0, at_least(0), "stiffness about z")},
    {at(&FreedomCards::friction, 2), real("fmps", dimension::moment, 0, at_least(0), "friction moment about z")},
};
const CardOf<FreedomCards> rotary_stops_card{
    {at(&FreedomCards::low, 0), real("nsaph", dimension::number, 0, any_value,
                                     "stop angle of negative rotation about x, its size [degrees]; 0: none")},
    {at(&FreedomCards::high, 0),
     real("psaph", dimension::number, 0, any_value, "stop angle of positive rotation about x")},
    {at(&FreedomCards::low, 1), real("nsat", dimension::number, 0, any_value, "negative, about y")},
    {at(&FreedomCards::high, 1), real("psat", dimension::number, 0, any_value, "positive, about y")},
    {at(&FreedomCards::low, 2), real("nsaps", dimension::number, 0, any_value, "negative, about z")},
    {at(&FreedomCards::high, 2), real("psaps", dimension::number, 0, any_value, "positive, about z")},
};
const CardOf<FreedomCards> sliding_curves_card{
    {at(&FreedomCards::load, 0), id("lcidx", IdSpace::function, 0, "curve: force over the displacement along x")},
    {at(&FreedomCards::load, 1), id("lcidy", IdSpace::function, 0, "curve: along y")},
    {at(&FreedomCards::load, 2), id("lcidz", IdSpace::function, 0, "curve: along z")},
    {at(&FreedomCards::damper, 0), id("dlcidx", IdSpace::function, 0, "curve: damping force over the rate along x")},
    {at(&FreedomCards::damper, 1), id("dlcidy", IdSpace::function, 0, "curve: along y")},
    {at(&FreedomCards::damper, 2), id("dlcidz", IdSpace::function, 0, "curve: along z")},
};
const CardOf<FreedomCards> sliding_friction_card{
    {at(&FreedomCards::stiffness, 0),
     real("esx", dimension::force_per_length, 0, at_least(0), "stiffness of friction and stops along x")},
    {at(&FreedomCards::friction, 0),
     real("ffx", dimension::force, 0, at_least(0), "friction force along x; 0: none; no curves")},
    {at(&FreedomCards::stiffness, 1), real("esy", dimension::force_per_length, 0, at_least(0), "stiffness along y")},
    {at(&FreedomCards::friction, 1), real("ffy", dimension::force, 0, at_least(0), "friction force along y")},
    {at(&FreedomCards::stiffness, 2), real("esz", dimension::force_per_length, 0, at_least(0), "stiffness along z")},
    {at(&FreedomCards::friction, 2), real("ffz", dimension::force, 0, at_least(0), "friction force along z")},
};
const CardOf<FreedomCards> sliding_stops_card{
    {at(&FreedomCards::low, 0),
     real("nsdx", dimension::length, 0, any_value, "stop of negative displacement along x, its size; 0: none")},
    {at(&FreedomCards::high, 0),
     real("psdx", dimension::length, 0, any_value, "stop of positive displacement along x")},
    {at(&FreedomCards::low, 1), real("nsdy", dimension::length, 0, any_value, "negative, along y")},
    {at(&FreedomCards::high, 1), real("psdy", dimension::length, 0, any_value, "positive, along y")},
    {at(&FreedomCards::low, 2), real("nsdz", dimension::length, 0, any_value, "negative, along z")},
    {at(&FreedomCards::high, 2), real("psdz", dimension::length, 0, any_value, "positive, along z")},
    real("fs", dimension::number, 0, only(0), "friction that depends on the joint's force"),
    real("fd", dimension::number, 0, only(0), "friction that depends on the joint's force"),
};
struct StiffnessRows {
  RowOf<JointStiffnessCard> main;
  RowOf<FreedomCards> curves, friction, stops;  ///< the last has the values of all three
};

Index rigid_body(Builder& b, const deck::Entry& field) {
  const Index body = b.bodies.find(field.integer());
  if (body == none)
    refuse(b, field, fmt::format("part {} is not a rigid body", field.integer()),
           "give a part of *MAT_RIGID or a *CONSTRAINED_NODAL_RIGID_BODY");
  return body;
}

void add_stiffness(Builder& b, const StiffnessRows& rows, bool rotational) {
  const auto& main = rows.main;
  JointStiffness s;
  s.id = main->jsid;
  s.rotational = rotational;
  s.place = main.place();
  s.body = {rigid_body(b, main[&JointStiffnessCard::pida]), rigid_body(b, main[&JointStiffnessCard::pidb])};
  const Index a = b.turning_or_fixed_system(main[&JointStiffnessCard::cida]),
              c = b.turning_or_fixed_system(main[&JointStiffnessCard::cidb]);
  if (s.body[0] == none || s.body[1] == none || a == none) return;
  if (s.body[0] == s.body[1]) return refuse(b, main[&JointStiffnessCard::pidb], "both are the same rigid body");
  for (const auto field : {&JointStiffnessCard::cida, &JointStiffnessCard::cidb})
    if (const deck::Entry& cid = main[field]; !rotational && b.systems_without_origin.contains(cid.integer()))
      cid.report(
          b.findings, Severity::warning,
          fmt::format("coordinate system {} of *DEFINE_COORDINATE_VECTOR has the global origin: the displacement "
                      "between the bodies is measured there, however far from the joint that is",
                      cid.integer()),
          "define it by *DEFINE_COORDINATE_NODES or _SYSTEM, with its origin at the joint");
  const Index systems[] = {a, c == none ? a : c};
  for (std::size_t side = 0; side < 2; ++side) {
    const CoordinateSystem& system = b.model.systems[systems[side]];
    s.origin[side] = system.origin;
    s.axes[side] = system.axes;
  }
  const double unit = rotational ? std::numbers::pi / 180.0 : 1.0;
  const FreedomCards& cards = *rows.stops;
  for (std::size_t i = 0; i < 3; ++i) {
    JointStiffness::Freedom& f = s.freedom[i];
    f.load = b.curve(rows.curves[at(&FreedomCards::load, i)]);
    f.damper = b.curve(rows.curves[at(&FreedomCards::damper, i)]);
    f.stiffness = cards.stiffness[i];
    f.friction = cards.friction[i];
    f.low_stop = unit * std::abs(cards.low[i]);
    f.high_stop = unit * std::abs(cards.high[i]);
    if (!(f.stiffness > 0.0) && (f.friction > 0.0 || f.low_stop > 0.0 || f.high_stop > 0.0))
      rows.friction[at(&FreedomCards::stiffness, i)].report(b.findings, Severity::warning,
                                                            "without a stiffness there is neither friction nor a stop",
                                                            "give the stiffness");
  }
  b.model.joint_stiffnesses.push_back(std::move(s));
}

void read_stiffness(Builder& b, const Block& block, const Options& options, const CardOf<FreedomCards>& curves,
                    const CardOf<FreedomCards>& friction, const CardOf<FreedomCards>& stops, bool rotational) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    FreedomCards cards;
    StiffnessRows rows;
    rows.main = cursor.read(joint_stiffness_card);
    rows.curves = cursor.read(curves, cards);
    rows.friction = cursor.read(friction, cards);
    rows.stops = cursor.read(stops, cards);
    b.defer(Phase::conditions, [rows, rotational](Builder& later) { add_stiffness(later, rows, rotational); });
  }
}

void read_rotary(Builder& b, const Block& block, const Options& options) {
  read_stiffness(b, block, options, rotary_curves_card, rotary_friction_card, rotary_stops_card, true);
}
void read_sliding(Builder& b, const Block& block, const Options& options) {
  read_stiffness(b, block, options, sliding_curves_card, sliding_friction_card, sliding_stops_card, false);
}

}  // namespace

std::vector<Keyword> joint_stiffness_keywords() {
  return {
      {.name = "CONSTRAINED_JOINT_STIFFNESS_GENERALIZED",
       .options = {"TITLE"},
       .layout = {{"", &joint_stiffness_card},
                  {"", &rotary_curves_card},
                  {"", &rotary_friction_card},
                  {"", &rotary_stops_card}},
       .read = read_rotary},
      {.name = "CONSTRAINED_JOINT_STIFFNESS_TRANSLATIONAL",
       .options = {"TITLE"},
       .layout = {{"", &joint_stiffness_card},
                  {"", &sliding_curves_card},
                  {"", &sliding_friction_card},
                  {"", &sliding_stops_card}},
       .read = read_sliding},
      {.name = "CONSTRAINED_JOINT_STIFFNESS_*",
       .status = KeywordStatus::refused,
       .why = "of the stiffnesses of joints GENERALIZED and TRANSLATIONAL are built"},
  };
}

}  // namespace nugget::reading
