// SPDX-License-Identifier: Apache-2.0
// *BOUNDARY_... and *CONSTRAINED_GLOBAL: nodes held, and motions prescribed.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "reading/bodies/rigid_bodies.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/turning_nodes.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

// ---- single point constraints

struct SpcCard {
  int target = 0, cid = 0;
  std::array<int, 6> dof{};
};
CardOf<SpcCard> spc_card(const FieldOf<SpcCard>& target) {
  return {
      target,
      {&SpcCard::cid, id("cid", IdSpace::define, 0, "coordinate system of the constraint; 0: global axes")},
      {at(&SpcCard::dof, 0), integer("dofx", 0, between(0, 1), "1: no translation along x")},
      {at(&SpcCard::dof, 1), integer("dofy", 0, between(0, 1), "1: no translation along y")},
      {at(&SpcCard::dof, 2), integer("dofz", 0, between(0, 1), "1: no translation along z")},
      {at(&SpcCard::dof, 3), integer("dofrx", 0, between(0, 1), "1: no rotation about x")},
      {at(&SpcCard::dof, 4), integer("dofry", 0, between(0, 1), "1: no rotation about y")},
      {at(&SpcCard::dof, 5), integer("dofrz", 0, between(0, 1), "1: no rotation about z")},
  };
}
const CardOf<SpcCard> spc_node_card = spc_card({&SpcCard::target, id("nid", IdSpace::node, required, "node")});
const CardOf<SpcCard> spc_set_card = spc_card({&SpcCard::target, id("nsid", IdSpace::set, required, "node set")});

struct BirthDeathCard {
  double birth = 0, death = 0;
};
const CardOf<BirthDeathCard> birth_death_card{
    {&BirthDeathCard::birth, real("birth", dimension::time, 0, at_least(0), "the constraint acts from this time on")},
    {&BirthDeathCard::death, real("death", dimension::time, forever, at_least(0), "until this time")},
};

unsigned fixed_bits(const std::array<int, 6>& dof) {
  unsigned bits = 0;
  for (std::size_t i = 0; i < dof.size(); ++i)
    if (dof[i] == 1) bits |= 1U << i;
  return bits;
}

/// A rigid body moves as one, so nothing can be prescribed to one of its nodes: they are taken out of `nodes`, with a
/// finding.
void leave_out_rigid(Builder& builder, const deck::Entry& field, Severity severity, std::vector<Index>& nodes,
                     std::string_view remedy) {
  const auto body_of = [&](Index node) { return builder.body_of_node[node]; };
  const auto first = std::find_if(nodes.begin(), nodes.end(), [&](Index node) { return body_of(node) != none; });
  if (first == nodes.end()) return;
  const auto count = std::count_if(nodes.begin(), nodes.end(), [&](Index node) { return body_of(node) != none; });
  field.report(
      builder.findings, severity,
      fmt::format("node {} belongs to rigid body {}, which moves as one: nothing is prescribed to it ({} such node{})",
                  builder.model.nodes.id[*first], builder.model.rigid_bodies[body_of(*first)].id, count,
                  count == 1 ? "" : "s"),
      std::string(remedy));
  std::erase_if(nodes, [&](Index node) { return body_of(node) != none; });
}

/// A card whose time ends before it begins does nothing, which is reported.
void warn_of_no_time(Builder& builder, const deck::Entry& field, double birth, double death) {
  if (birth < death) return;
  field.report(builder.findings, Severity::warning,
               fmt::format("it ends before it begins (birth {}): the card does nothing", birth),
               "give a death later than the birth, or 0 for none");
}

/// The nodes of a card for one node or a set.
template <bool set>
std::vector<Index> nodes_of(Builder& builder, const deck::Entry& field) {
  if constexpr (set) {
    const auto* nodes = builder.node_set(field);
    return nodes ? nodes->members : std::vector<Index>{};
  } else {
    const Index node = builder.node(field);
    return node == none ? std::vector<Index>{} : std::vector<Index>{node};
  }
}

template <bool set>
void read_spc(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    SinglePointConstraint spc;
    spc.id = read_heading(cursor, options.contains("ID")).id;
    const auto row = cursor.read(set ? spc_set_card : spc_node_card);
    if (options.contains("BIRTH_DEATH")) {
      const auto times = cursor.read(birth_death_card);
      spc.birth = times->birth;
      spc.death = death_time(times->death);
      warn_of_no_time(builder, times[&BirthDeathCard::death], spc.birth, spc.death);
    }
    spc.fixed = fixed_bits(row->dof);
    if (row->cid == 0) warn_of_turned_codes(builder, block, row[&SpcCard::target], spc.fixed);
    builder.defer(Phase::conditions, [row, spc](Builder& b) mutable {
      spc.system = b.system(row[&SpcCard::cid]);
      if constexpr (set) spc.set_id = row->target;
      auto nodes = nodes_of<set>(b, row[&SpcCard::target]);
      const std::size_t all = nodes.size();
      constrain_bodies(b, row[&SpcCard::target], spc, nodes);
      if (nodes.size() < all) b.supports_of_bodies.insert(spc.id);
      for (const Index node : nodes) {
        spc.node = node;
        b.model.spcs.push_back(spc);
      }
    });
  }
}

// ---- planes of nodes held

struct PlaneCard {
  int tc = 0, rc = 0, dir = 0;
  double x = 0, y = 0, z = 0, tol = 0;
};
const CardOf<PlaneCard> plane_card{
    {&PlaneCard::tc,
     integer("tc", 0, between(0, 7), "translations that are held: 1 x, 2 y, 3 z, 4 xy, 5 yz, 6 zx, 7 xyz")},
    {&PlaneCard::rc, integer("rc", 0, between(0, 7), "rotations that are held, by the same codes")},
    {&PlaneCard::dir, integer("dir", 0, between(0, 3), "normal of the plane: 1 x, 2 y, 3 z; 0: the card does nothing")},
    {&PlaneCard::x, real("x", dimension::length, 0, any_value, "a point of the plane: x")},
    {&PlaneCard::y, real("y", dimension::length, 0, any_value, "y")},
    {&PlaneCard::z, real("z", dimension::length, 0, any_value, "z")},
    {&PlaneCard::tol, real("tol", dimension::length, 0, at_least(0),
                           "nodes so near to the plane are held; 0: a millionth of the model's diagonal")},
};

double component(const Vec3d& v, int direction) {
  return direction == 1 ? v.x : direction == 2 ? v.y : v.z;
}

double diagonal(const std::vector<Vec3d>& x) {
  Vec3d low = x.front(), high = low;
  for (const Vec3d& p : x) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return norm(high - low);
}

/// *CONSTRAINED_GLOBAL: the nodes in a plane across a global axis, by their places at the start.
void read_planes(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(plane_card);
    const int normal = row->dir;
    if (normal == 0) {
      row[&PlaneCard::dir].report(builder.findings, Severity::warning, "no plane is named, so nothing is held",
                                  "write 1, 2 or 3");
      continue;
    }
    warn_of_global_axis(builder, block, row[&PlaneCard::dir]);
    const double at = component(position(block, {row->x, row->y, row->z}), normal);
    SinglePointConstraint spc{.fixed = bits_of_code(row->tc) | bits_of_code(row->rc) << 3};
    builder.defer(Phase::conditions, [row, spc, normal, at](Builder& b) mutable {
      const std::vector<Vec3d>& x = b.model.nodes.x;
      if (x.empty()) return;
      const double tolerance = row->tol > 0.0 ? row->tol : 1e-6 * diagonal(x);
      std::vector<Index> nodes;
      for (std::size_t n = 0; n < x.size(); ++n)
        if (std::abs(component(x[n], normal) - at) <= tolerance) nodes.push_back(static_cast<Index>(n));
      if (nodes.empty())
        row[&PlaneCard::dir].report(b.findings, Severity::warning, "no node lies in this plane",
                                    "correct the point, or give TOL");
      constrain_bodies(b, row[&PlaneCard::tc], spc, nodes);
      for (const Index node : nodes) {
        spc.node = node;
        b.model.spcs.push_back(spc);
      }
    });
  }
}

// ---- prescribed motions

struct PrescribedMotionCard {
  int target = 0, dof = 0, vad = 0, lcid = 0;
  double sf = 0;
  int vid = 0;
  double death = 0, birth = 0;
};
CardOf<PrescribedMotionCard> prescribed_motion_card(const FieldOf<PrescribedMotionCard>& target) {
  return {
      target,
      {&PrescribedMotionCard::dof,
       integer(
           "dof", required, any_value,
           "1, 2, 3 translation along x, y, z; 4 along the vector; -4 the same, motion normal to it held; 5, 6, 7 "
           "rotation about x, y, z; 8 about the vector; -8 the same, rotation normal to it held; nodes only: 9, 10, "
           "11 around an axis along x, y, z through the offsets; -9, -10, -11 the same, the radius free")},
      {&PrescribedMotionCard::vad, integer("vad", 0, any_value, "0 velocity, 1 acceleration, 2 displacement")},
      {&PrescribedMotionCard::lcid,
       within_range(id("lcid", IdSpace::function, required, "curve of the motion over time"), at_least(1))},
      {&PrescribedMotionCard::sf, real("sf", dimension::number, 1, any_value, "scale of the curve")},
      {&PrescribedMotionCard::vid,
       or_negative(id("vid", IdSpace::define, 0,
                      "vector of dof 4, -4, 8, -8; below 0: coordinate system of dof 1 to 3, 5 to 7"),
                   IdSpace::define)},
      {&PrescribedMotionCard::death, real("death", dimension::time, 1e28, at_least(0), "the motion ends at this time")},
      {&PrescribedMotionCard::birth,
       real("birth", dimension::time, 0, at_least(0), "and begins at this time; the curve starts then")},
  };
}
const CardOf<PrescribedMotionCard> motion_node_card =
    prescribed_motion_card({&PrescribedMotionCard::target, id("nid", IdSpace::node, required, "node")});
const CardOf<PrescribedMotionCard> motion_set_card =
    prescribed_motion_card({&PrescribedMotionCard::target, id("nsid", IdSpace::set, required, "node set")});
const CardOf<PrescribedMotionCard> motion_body_card = prescribed_motion_card(
    {&PrescribedMotionCard::target, id("pid", IdSpace::part, required, "part of *MAT_RIGID, or nodal rigid body")});

struct MotionAxisCard {
  double offset1 = 0, offset2 = 0;
  int lrb = 0, node1 = 0, node2 = 0;
};
const CardOf<MotionAxisCard> motion_axis_card{
    {&MotionAxisCard::offset1,
     real("offset1", dimension::length, 0, any_value, "where the axis is: y (dof 9), z (10), x (11)")},
    {&MotionAxisCard::offset2,
     real("offset2", dimension::length, 0, any_value, "where the axis is: z (dof 9), x (10), y (11)")},
    {&MotionAxisCard::lrb, id("lrb", IdSpace::part, 0, "leading rigid body of vad 4, which is not built")},
    {&MotionAxisCard::node1, id("node1", IdSpace::node, 0, "orientation of vad 4, which is not built")},
    {&MotionAxisCard::node2, id("node2", IdSpace::node, 0, "orientation of vad 4, which is not built")},
};

using Target = PrescribedMotion::Target;

bool is_circular(int dof) {
  return std::abs(dof) >= 9 && std::abs(dof) <= 11;
}

bool takes_vector(int dof) {
  return std::abs(dof) == 4 || std::abs(dof) == 8;
}

/// LS-DYNA's degree of freedom and kind of motion; false (and findings) for those that are not built.
bool take_degree_of_freedom(Builder& builder, const RowOf<PrescribedMotionCard>& row, PrescribedMotion& motion) {
  const int dof = row->dof, vad = row->vad;
  if (dof == 0) return false;  // missing: the row has said so
  const bool of_nodes = motion.target == Target::nodes, circular = is_circular(dof);
  const bool known = (dof >= 1 && dof <= 8) || dof == -4 || dof == -8 || (circular && of_nodes);
  if (circular && !of_nodes)
    refuse(builder, row[&PrescribedMotionCard::dof], "dof 9 to 11 drive nodes, not rigid bodies",
           "drive the body's rotation with dof 5 to 8, and its centre with 1 to 4");
  else if (!known)
    refuse(builder, row[&PrescribedMotionCard::dof],
           fmt::format("this degree of freedom is not built; expected 1 to 8, -4 or -8{}",
                       of_nodes ? ", or 9 to 11, -9 to -11" : ""));
  const bool quantity = vad >= 0 && vad <= 2;
  if (!quantity)
    refuse(builder, row[&PrescribedMotionCard::vad], "expected 0 (velocity), 1 (acceleration) or 2 (displacement)");
  if (!known || !quantity) return false;
  motion.rotation = std::abs(dof) >= 5 && !circular;
  motion.only_direction = dof > 0 || circular;
  motion.circular = circular;
  motion.radius_fixed = dof > 0;
  motion.quantity = static_cast<PrescribedMotion::Quantity>(vad);
  return true;
}

Vec3d axis(int dof) {
  const int k = is_circular(dof) ? std::abs(dof) - 9 : (dof - 1) % 4;
  return {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
}

/// VID < 0: the motion is along, or about, an axis of a coordinate system as it is at the start.
bool turn_into_system(Builder& builder, const RowOf<PrescribedMotionCard>& row, PrescribedMotion& motion) {
  if (motion.circular || motion.target == Target::rigid_body_local) {
    refuse(builder, row[&PrescribedMotionCard::vid],
           "a coordinate system beside axes of the body or an axis by offsets is not built", "leave VID empty");
    return false;
  }
  const Index system = builder.system_of_directions(row[&PrescribedMotionCard::vid]);
  if (system == none) return false;
  motion.direction = builder.model.systems[system].axes.global(motion.direction);
  return true;
}

/// The unit vector of the motion, or nothing and a finding.
bool resolve_direction(Builder& builder, const RowOf<PrescribedMotionCard>& row, PrescribedMotion& motion) {
  const int dof = row->dof;
  if (!takes_vector(dof)) {
    motion.direction = axis(dof);
    return row->vid >= 0 || turn_into_system(builder, row, motion);
  }
  if (row->vid <= 0) {
    refuse(builder, row[&PrescribedMotionCard::vid], fmt::format("dof {} needs a vector", dof),
           "name a *DEFINE_VECTOR");
    return false;
  }
  const Vec3d* vector = builder.vector(row[&PrescribedMotionCard::vid]);
  if (!vector) return false;
  if (norm(*vector) == 0.0) {
    refuse(builder, row[&PrescribedMotionCard::vid], "the vector has no length");
    return false;
  }
  motion.direction = unit(*vector);
  return true;
}

void resolve_body(Builder& builder, const RowOf<PrescribedMotionCard>& row, PrescribedMotion& motion) {
  motion.rigid_body = find_body(builder, row[&PrescribedMotionCard::target]);
  if (motion.rigid_body == none || motion.target != Target::rigid_body_local) return;
  const Frame3d* axes = body_axes(builder, row->target);
  if (!axes) {
    refuse(builder, row[&PrescribedMotionCard::target],
           "local axes of this body are not known: its principal axes are not used",
           "name a coordinate system in LCO of *MAT_RIGID, or in CID of *CONSTRAINED_NODAL_RIGID_BODY");
    return;
  }
  motion.direction = axes->global(motion.direction);
}

/// A displacement is made by its increments: what its curve begins with is the place at which the motion finds the
/// node.
void warn_of_start(Builder& b, const deck::Entry& lcid, const PrescribedMotion& motion) {
  if (motion.curve == none || motion.quantity != PrescribedMotion::Quantity::displacement) return;
  if (b.model.implicit.active) return;  // linear statics take the value at the end time
  const Curve& curve = b.model.curves[motion.curve];
  const double first = curve.clamped(0.0);
  double most = 0.0;
  for (const double y : curve.y) most = std::max(most, std::abs(y));
  if (std::abs(first) <= 1e-6 * most) return;
  lcid.report(b.findings, Severity::warning,
              fmt::format("curve {} begins with the displacement {:g}: that is where the motion finds what it drives, "
                          "which moves by the change since then",
                          lcid.integer(), first),
              "begin the curve with 0, and let it rise to where the motion is to lead");
}

/// Where the axis of a circular motion is.
void take_axis(Builder& builder, const Block& block, const RowOf<MotionAxisCard>& row, int dof,
               PrescribedMotion& motion) {
  if (block.transform && block.transform->matrix != deck::Transform{}.matrix)
    refuse(builder, row[&MotionAxisCard::offset1],
           "an axis by offsets in an include that is turned or moved is not built",
           "write the motion in the main file");
  expect(builder, Severity::warning,
         {{row[&MotionAxisCard::lrb], 0, "belongs to VAD 4: it does nothing here"},
          {row[&MotionAxisCard::node1], 0, "belongs to VAD 4: it does nothing here"},
          {row[&MotionAxisCard::node2], 0, "belongs to VAD 4: it does nothing here"}});
  const double first = row->offset1, second = row->offset2;
  const int k = std::abs(dof) - 9;
  motion.center = k == 0 ? Vec3d{0, first, second} : k == 1 ? Vec3d{second, 0, first} : Vec3d{first, second, 0};
}

template <Target target, bool set>
void read_motion(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    PrescribedMotion motion;
    motion.id = read_heading(cursor, options.contains("ID")).id;
    motion.place = cursor.place();
    const auto row = cursor.read(target != Target::nodes ? motion_body_card : set ? motion_set_card : motion_node_card);
    motion.target = target;
    motion.scale = row->sf;
    motion.birth = row->birth;
    motion.death = death_time(row->death);
    warn_of_no_time(builder, row[&PrescribedMotionCard::death], motion.birth, motion.death);
    // A motion that is refused may have a second card, which would be taken for the next definition.
    if (!take_degree_of_freedom(builder, row, motion)) return;
    if (!motion.circular && !takes_vector(row->dof) && row->vid >= 0 && target != Target::rigid_body_local)
      warn_of_global_axis(builder, block, row[&PrescribedMotionCard::dof]);
    if (is_mirrored(block) && (std::abs(row->dof) == 8 || (motion.rotation && row->vid < 0)))
      refuse(builder, row[&PrescribedMotionCard::dof], turning_in_mirror, mirror_remedy);
    if (motion.circular) take_axis(builder, block, cursor.read(motion_axis_card), row->dof, motion);
    builder.defer(Phase::conditions, [row, motion](Builder& b) mutable {
      motion.curve = b.curve(row[&PrescribedMotionCard::lcid]);
      warn_of_start(b, row[&PrescribedMotionCard::lcid], motion);
      if (!resolve_direction(b, row, motion)) return;
      if constexpr (target == Target::nodes) {
        motion.nodes = nodes_of<set>(b, row[&PrescribedMotionCard::target]);
        leave_out_rigid(b, row[&PrescribedMotionCard::target], Severity::error, motion.nodes,
                        "use *BOUNDARY_PRESCRIBED_MOTION_RIGID");
        if (motion.rotation)
          b.defer(Phase::checks, [row, nodes = motion.nodes](Builder& all) {
            warn_of_no_rotation(all, row[&PrescribedMotionCard::dof], nodes, nodes_that_turn(all),
                                "the motion has no effect there",
                                "drive them around an axis by dof 9, 10 or 11, or as a *CONSTRAINED_NODAL_RIGID_BODY");
          });
      } else {
        resolve_body(b, row, motion);
      }
      b.model.motions.push_back(std::move(motion));
    });
  }
}

template <Target target, bool set = false>
Keyword motion_keyword(std::string_view name, const Card& card) {
  std::vector<LayoutCard> layout{{"with _ID", &heading_card}, {{}, &card}};
  if (target == Target::nodes) layout.push_back({"if |DOF| is 9, 10 or 11", &motion_axis_card});
  return {.name = name, .options = {"ID"}, .layout = std::move(layout), .read = read_motion<target, set>};
}

}  // namespace

std::vector<Keyword> boundary_keywords() {
  const std::vector<std::string_view> spc_options{"ID", "BIRTH_DEATH"};
  return {
      {.name = "BOUNDARY_SPC_NODE",
       .options = spc_options,
       .layout = {{"with _ID", &heading_card}, {{}, &spc_node_card}, {"with _BIRTH_DEATH", &birth_death_card}},
       .read = read_spc<false>},
      {.name = "BOUNDARY_SPC_SET",
       .options = spc_options,
       .layout = {{"with _ID", &heading_card}, {{}, &spc_set_card}, {"with _BIRTH_DEATH", &birth_death_card}},
       .read = read_spc<true>},
      {.name = "CONSTRAINED_GLOBAL", .layout = {{"", &plane_card}}, .read = read_planes},
      motion_keyword<Target::nodes, false>("BOUNDARY_PRESCRIBED_MOTION_NODE", motion_node_card),
      motion_keyword<Target::nodes, true>("BOUNDARY_PRESCRIBED_MOTION_SET", motion_set_card),
      motion_keyword<Target::rigid_body>("BOUNDARY_PRESCRIBED_MOTION_RIGID", motion_body_card),
      motion_keyword<Target::rigid_body_local>("BOUNDARY_PRESCRIBED_MOTION_RIGID_LOCAL", motion_body_card),
  };
}

}  // namespace nugget::reading
