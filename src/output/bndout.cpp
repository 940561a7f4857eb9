// SPDX-License-Identifier: Apache-2.0
#include "output/bndout.hpp"

namespace nugget::output {
namespace {

template <class Row>
BndoutTotal sum(std::span<const Row> rows) {
  BndoutTotal result;
  for (const Row& row : rows) {
    result.force += row.force;
    result.energy += row.energy;
  }
  return result;
}

void force_columns(AsciiFile& file, const Vec3d& force, double energy) {
  file.print("  xforce={:13.4E}   yforce={:13.4E}  zforce={:13.4E}   energy={:13.4E}", column(force.x), column(force.y),
             column(force.z), column(energy));
}

template <auto rows>
BndoutTotal sum_of(const BndoutState& s) {
  return total(s.*rows);
}

/// What nodes and bodies have in common.
template <auto rows>
Columns<BndoutState> motion_columns() {
  using Row = typename std::decay_t<decltype(std::declval<BndoutState>().*rows)>::value_type;
  return columns(rows, {
                           {"time", &BndoutState::time, dimension::time, "time"},
                           {"*_force", &Row::force, dimension::force, "force of a prescribed motion"},
                           {"energy", &Row::energy, dimension::energy, "its work"},
                           {"*_total", [](const BndoutState& s) { return sum_of<rows>(s).force; }, dimension::force,
                            "sum of the forces"},
                           {"etotal", [](const BndoutState& s) { return sum_of<rows>(s).energy; }, dimension::energy,
                            "sum of their work"},
                       });
}

void print(AsciiFile& file, const BndoutState& state) {
  file.print("\n\n\n\n\n n o d a l   f o r c e/e n e r g y    o u t p u t   t={:9.3E}\n", column(state.time));
  file.print("\n\n\n\n\n velocity boundary condition forces/rigid body moments \n\n");
  for (const BndoutNode& node : state.nodes) {
    file.print(" nd#{:8}", node.node);
    force_columns(file, node.force, node.energy);
    file.print("   setid ={:8}\n", node.set);
  }
  for (const BndoutBody& body : state.bodies) {
    file.print("mat#{:8}", body.part);
    force_columns(file, body.force, body.energy);
    file.print("\n             xmoment={:13.4E}  ymoment={:13.4E} zmoment={:13.4E}\n", column(body.moment.x),
               column(body.moment.y), column(body.moment.z));
  }
  const BndoutTotal nodes = total(state.nodes), bodies = total(state.bodies);
  const Vec3d force = nodes.force + bodies.force;
  file.print("              xtotal={:13.4E}   ytotal={:13.4E}  ztotal={:13.4E}   etotal={:13.4E}\n", column(force.x),
             column(force.y), column(force.z), column(nodes.energy + bodies.energy));
}

}  // namespace

BndoutTotal total(std::span<const BndoutNode> nodes) {
  return sum(nodes);
}
BndoutTotal total(std::span<const BndoutBody> bodies) {
  return sum(bodies);
}

const HistoryFormat<BndoutState>& bndout() {
  static const HistoryFormat<BndoutState> format{
      .branches =
          {
              {.path = "bndout/velocity/nodes",
               .ids = ids(&BndoutState::nodes, &BndoutNode::node),
               .once = columns(&BndoutState::nodes,
                               {{"setid", &BndoutNode::set, dimension::number, "node set of the card"}}),
               .columns = motion_columns<&BndoutState::nodes>(),
               .written = [](const BndoutState& s) { return !s.nodes.empty(); }},
              {.path = "bndout/velocity/rigidbodies",
               .ids = ids(&BndoutState::bodies, &BndoutBody::part),
               .columns = motion_columns<&BndoutState::bodies>() +
                          columns(&BndoutState::bodies, {{"*moment", &BndoutBody::moment, dimension::moment,
                                                          "moment of the motion on a body"}}),
               .written = [](const BndoutState& s) { return !s.bodies.empty(); }},
          },
      .legend = LegendLines::empty,
      .print = print,
  };
  return format;
}

}  // namespace nugget::output
