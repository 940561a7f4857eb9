// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/axes.hpp"
#include "model/lumped_mass.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *NODE, *ELEMENT_... Nodes and elements are only collected here; make_mesh() works them out.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

struct MassCard {
  int eid = 0, nid = 0;
  double mass = 0;
};
const CardOf<MassCard> mass_card{
    {&MassCard::eid, wide(id("eid", IdSpace::element, 0, "element id"), 8)},
    {&MassCard::nid, wide(id("nid", IdSpace::node, required, "node"), 8)},
    {&MassCard::mass, wide(real("mass", dimension::mass, 0, at_least(0), "mass"), 16)},
    wide(id("pid", IdSpace::part, 0, "part, for listings only"), 8),
};

struct SetMassCard {
  int eid = 0, nsid = 0;
  double mass = 0;
};
const CardOf<SetMassCard> set_mass_card{
    {&SetMassCard::eid, wide(id("eid", IdSpace::element, 0, "element id"), 8)},
    {&SetMassCard::nsid, wide(id("nsid", IdSpace::set, required, "node set"), 8)},
    {&SetMassCard::mass,
     wide(real("mass", dimension::mass, 0, at_least(0), "mass, shared out evenly over the nodes of the set"), 16)},
    wide(id("pid", IdSpace::part, 0, "part, for listings only"), 8),
};

const CardOf<PartMassCard> element_part_mass_card{
    {&PartMassCard::pid, wide(id("pid", IdSpace::part, required, "part"), 8)},
    {&PartMassCard::addmass,
     wide(real("addmass", dimension::mass, 0, at_least(0), "mass to be spread over the part"), 16)},
    {&PartMassCard::finmass,
     wide(real("finmass", dimension::mass, 0, at_least(0), "mass that the part is to have in the end"), 16)},
    {&PartMassCard::lcid, wide(id("lcid", IdSpace::function, 0, "not supported"), 8)},
    wide(integer("mwd", 0, any_value, "only for part sets"), 8),
};

struct InertiaHeadCard {
  int eid = 0, nid = 0, csid = 0;
};
const CardOf<InertiaHeadCard> inertia_head_card{
    {&InertiaHeadCard::eid, wide(id("eid", IdSpace::element, 0, "element id"), 8)},
    {&InertiaHeadCard::nid, wide(id("nid", IdSpace::node, required, "node"), 8)},
    {&InertiaHeadCard::csid, wide(id("csid", IdSpace::define, 0, "coordinate system of the tensor; 0: global"), 8)},
};

struct InertiaCard {
  double ixx = 0, ixy = 0, ixz = 0, iyy = 0, iyz = 0, izz = 0, mass = 0;
};
const CardOf<InertiaCard> inertia_card{
    {&InertiaCard::ixx, real("ixx", dimension::inertia, 0, at_least(0), "inertia tensor about the node, xx")},
    {&InertiaCard::ixy, real("ixy", dimension::inertia, 0, any_value, "xy")},
    {&InertiaCard::ixz, real("ixz", dimension::inertia, 0, any_value, "xz")},
    {&InertiaCard::iyy, real("iyy", dimension::inertia, 0, at_least(0), "yy")},
    {&InertiaCard::iyz, real("iyz", dimension::inertia, 0, any_value, "yz")},
    {&InertiaCard::izz, real("izz", dimension::inertia, 0, at_least(0), "zz")},
    {&InertiaCard::mass, real("mass", dimension::mass, 0, at_least(0), "mass")},
};

/// `igrav`: a flag or, above 1, a curve.
struct AccelerometerCardOf {
  int sbacid = 0, nid1 = 0, nid2 = 0, nid3 = 0, igrav = 0, intopt = 0;
  double mass = 0;
};
CardOf<AccelerometerCardOf> accelerometer_card_of(IdSpace igrav) {
  return {
      {&AccelerometerCardOf::sbacid, id("sbacid", IdSpace::element, 0, "number")},
      {&AccelerometerCardOf::nid1,
       id("nid1", IdSpace::node, required, "node of a rigid body whose motion nodout gives in local axes")},
      {&AccelerometerCardOf::nid2, id("nid2", IdSpace::node, required, "node 2: local x from node 1 to node 2")},
      {&AccelerometerCardOf::nid3,
       id("nid3", IdSpace::node, required, "node 3: local z normal to x and to the direction to node 3")},
      {&AccelerometerCardOf::igrav, within_range(id("igrav", igrav, 0,
                                                    "accelerations of body loads are 0 contained, 1 left out, -1 x, -2 "
                                                    "y, -3 z, -4 xy, -5 yz, -6 zx left out; "
                                                    "above 1: a curve of this flag over time"),
                                                 at_least(-6))},
      {&AccelerometerCardOf::intopt,
       integer("intopt", 0, between(0, 1),
               "0: velocities turned into the local axes; 1: local accelerations summed up")},
      {&AccelerometerCardOf::mass,
       real("mass", dimension::mass, 0, at_least(0), "mass added, a third to each of the nodes")},
  };
}
const CardOf<AccelerometerCardOf> accelerometer_card = accelerometer_card_of(IdSpace::none);
const CardOf<AccelerometerCardOf> accelerometer_by_curve = accelerometer_card_of(IdSpace::function);

void read_node(Builder& b, const Block& block, const Options&) {
  const std::size_t before = b.node_table.id.size();
  deck::read_nodes(b.deck, block, b.node_table, b.findings);
  if (!block.transform || block.transform->keeps_axes()) return;
  for (std::size_t n = before; n < b.node_table.id.size(); ++n) {
    const unsigned held = bits_of_code(b.node_table.tc[n]) | bits_of_code(b.node_table.rc[n]) << 3;
    if (!depends_on_axes(held)) continue;
    return b.findings.warning({block.place.file, b.node_table.line[n], 0}, block.starred(),
                              std::string(global_codes_text), std::string(global_codes_remedy));
  }
}
void read_shell_elements(Builder& b, const Block& block, const Options&) {
  deck::read_shells(b.deck, block, b.shell_table, b.findings);
}
void read_solid_elements(Builder& b, const Block& block, const Options&) {
  deck::read_solids(b.deck, block, b.solid_table, b.findings);
}
void read_thick_shell_elements(Builder& b, const Block& block, const Options&) {
  deck::read_thick_shells(b.deck, block, b.solid_table, b.findings);
}
void read_beam_elements(Builder& b, const Block& block, const Options&) {
  deck::read_beams(b.deck, block, b.beam_table, b.findings);
}

/// All rows of a table-like keyword by one card.
template <class Values>
std::vector<RowOf<Values>> read_rows(Builder& b, const Block& block, const CardOf<Values>& card) {
  std::vector<RowOf<Values>> rows;
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) rows.push_back(cursor.read(card));
  return rows;
}

void read_mass(Builder& b, const Block& block, const Options&) {
  b.defer(Phase::mesh, [rows = read_rows(b, block, mass_card)](Builder& later) {
    for (const auto& row : rows)
      if (const Index n = later.node(row[&MassCard::nid]); n != none)
        later.model.masses.push_back({row->eid, n, row->mass});
  });
}

void read_set_mass(Builder& b, const Block& block, const Options&) {
  b.defer(Phase::sets, [rows = read_rows(b, block, set_mass_card)](Builder& later) {
    for (const auto& row : rows)
      if (const auto* set = later.node_set(row[&SetMassCard::nsid]))
        for (const Index n : set->members)
          later.model.masses.push_back({row->eid, n, row->mass / static_cast<double>(set->members.size())});
  });
}

/// Spreads the added mass over the part's nodes in proportion to the mass they have of it.
void add_part_mass(Builder& b, const RowOf<PartMassCard>& row, const std::vector<std::vector<NodeMass>>& by_part) {
  refuse_nonzero(b, row[&PartMassCard::lcid], "mass over time is not supported",
                 "leave it blank: the mass is there from the start");
  const Index p = b.part(row[&PartMassCard::pid]);
  if (p == none) return;
  const auto& shares = by_part[p];
  double total = 0.0;
  for (const auto& share : shares) total += share.mass;
  const double wanted = row->finmass;
  const double added = wanted > 0.0 ? wanted - total : row->addmass;
  if (!(total > 0.0))
    return refuse(b, row[&PartMassCard::pid], "the part has no mass of its own in whose proportion to spread it");
  if (added < 0.0)
    return refuse(b, row[&PartMassCard::finmass], fmt::format("the part already weighs more: {:g}", total),
                  "lower its density");
  for (const auto& share : shares) b.model.masses.push_back({0, share.node, added * share.mass / total});
}

void read_element_part_mass(Builder& b, const Block& block, const Options&) {
  // Behind the layers of parts (Phase::sets), which say what a laminate weighs.
  if (b.part_mass_rows.empty())
    b.defer(Phase::parts, [](Builder& with_parts) {
      with_parts.defer(Phase::sets, [](Builder& later) {
        const auto by_part = lumped_masses(later.model);
        for (const auto& row : later.part_mass_rows) add_part_mass(later, row, by_part);
      });
    });
  for (const auto& row : read_rows(b, block, element_part_mass_card)) b.part_mass_rows.push_back(row);
}

/// The nodes of bodies take the whole tensor, others in explicit runs only its mean.
void report_mean(Builder& b, const RowOf<InertiaHeadCard>& head, const std::array<double, 6>& tensor) {
  const auto& [xx, xy, xz, yy, yz, zz] = tensor;
  const double mean = (xx + yy + zz) / 3.0;
  double most = 0.0;
  for (const double off : {xx - mean, yy - mean, zz - mean, xy, xz, yz}) most = std::max(most, std::abs(off));
  if (most > 1e-6 * mean)
    head[&InertiaHeadCard::nid].report(
        b.findings, Severity::warning,
        fmt::format("in an explicit run a node that belongs to no rigid body turns with the mean of the "
                    "moments of inertia, {:.4g}, about every axis",
                    mean),
        "make the node a *CONSTRAINED_NODAL_RIGID_BODY, which takes the tensor whole");
}

void add_inertia(Builder& b, const RowOf<InertiaHeadCard>& head, const RowOf<InertiaCard>& row,
                 const Frame3d& of_include) {
  const Index n = b.node(head[&InertiaHeadCard::nid]);
  if (n == none) return;
  PointInertia point{head->eid, n, row->mass, {}};
  point.inertia = {row->ixx, row->ixy, row->ixz, row->iyy, row->iyz, row->izz};
  if (const Index s = b.system(head[&InertiaHeadCard::csid]); s != none)
    point.inertia = to_global(point.inertia, b.model.systems[s].axes);
  else if (head->csid == 0)
    point.inertia = to_global(point.inertia, of_include);
  b.model.inertias.push_back(point);
  b.defer(Phase::checks, [head, n, tensor = point.inertia](Builder& later) {
    if (later.body_of_node[n] == none) report_mean(later, head, tensor);
  });
}

void read_element_inertia(Builder& b, const Block& block, const Options&) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    const auto head = cursor.read(inertia_head_card);
    const auto row = cursor.read(inertia_card);
    refuse_in_mirror(b, block, head[&InertiaHeadCard::csid],
                     "products of inertia in local axes are not built in a file that *INCLUDE_TRANSFORM mirrors");
    b.defer(Phase::sets,
            [head, row, axes = axes_of_include(block)](Builder& later) { add_inertia(later, head, row, axes); });
  }
}

void add_accelerometer(Builder& b, const RowOf<AccelerometerCardOf>& row) {
  Accelerometer a;
  a.id = row->sbacid;
  a.node = {b.node(row[&AccelerometerCardOf::nid1]), b.node(row[&AccelerometerCardOf::nid2]),
            b.node(row[&AccelerometerCardOf::nid3])};
  if (a.node[0] == none || a.node[1] == none || a.node[2] == none) return;
  const int gravity = row->igrav;
  a.without_gravity = gravity_left_out(gravity);
  a.sums_local = row->intopt == 1;
  const auto at = [&](std::size_t i) { return b.model.nodes.x[a.node[i]]; };
  Frame3d axes;
  if (!frame_from(at(1) - at(0), at(2) - at(0), axes))
    return refuse(b, row[&AccelerometerCardOf::nid2], "the three nodes lie on a line, so they span no axes",
                  "take nodes apart");
  if (row->mass > 0.0)
    for (const Index n : a.node) b.model.masses.push_back({a.id, n, row->mass / 3.0});
  if (gravity > 1)
    b.defer(Phase::conditions, [row, number = b.model.accelerometers.size()](Builder& later) {
      later.model.accelerometers[number].gravity_curve = later.curve(row[&AccelerometerCardOf::igrav]);
    });
  b.model.accelerometers.push_back(a);
}

void read_accelerometer(Builder& b, const Block& block, const Options&) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    const auto row = cursor.read(cursor.peek_number(4) > 1.0 ? accelerometer_by_curve : accelerometer_card);
    b.defer(Phase::mesh, [row](Builder& later) { add_accelerometer(later, row); });
  }
}

}  // namespace

std::vector<Keyword> mesh_keywords() {
  return {
      {.name = "NODE", .layout = {{"", &deck::node_card()}}, .read = read_node},
      {.name = "ELEMENT_SHELL",
       .options = {"THICKNESS", "BETA", "MCID", "OFFSET", "DOF"},
       .layout = {{"", &deck::shell_card()},
                  {"with _THICKNESS, _BETA or _MCID", &deck::shell_thickness_card()},
                  {"with _OFFSET", &deck::shell_offset_card()}},
       .read = read_shell_elements},
      {.name = "ELEMENT_SOLID",
       .options = {"ORTHO", "DOF", "TET4TOTET10"},
       .layout = {{"", &deck::solid_card()}},
       .read = read_solid_elements},
      {.name = "ELEMENT_TSHELL", .layout = {{"", &deck::thick_shell_card()}}, .read = read_thick_shell_elements},
      {.name = "ELEMENT_BEAM",
       .options = {"THICKNESS", "PID", "OFFSET", "ORIENTATION"},
       .layout = {{"", &deck::beam_card()},
                  {"with _PID", &deck::beam_parts_card()},
                  {"with _ORIENTATION", &deck::beam_orientation_card()}},
       .read = read_beam_elements},
      {.name = "ELEMENT_MASS", .layout = {{"", &mass_card}}, .read = read_mass},
      {.name = "ELEMENT_MASS_NODE_SET", .layout = {{"", &set_mass_card}}, .read = read_set_mass},
      {.name = "ELEMENT_MASS_PART", .layout = {{"", &element_part_mass_card}}, .read = read_element_part_mass},
      {.name = "ELEMENT_SEATBELT_ACCELEROMETER", .layout = {{"", &accelerometer_card}}, .read = read_accelerometer},
      {.name = "ELEMENT_INERTIA",
       .layout = {{"", &inertia_head_card}, {"", &inertia_card}},
       .read = read_element_inertia},
  };
}

}  // namespace nugget::reading
