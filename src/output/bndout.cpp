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

}  // namespace

BndoutTotal total(std::span<const BndoutNode> nodes) {
  return sum(nodes);
}
BndoutTotal total(std::span<const BndoutBody> bodies) {
  return sum(bodies);
}

Bndout::Bndout(std::filesystem::path path, const Header& header) : file_(std::move(path), header, legend_lines({})) {}

void Bndout::write(const BndoutState& state) {
  file_.print("\n\n\n\n\n n o d a l   f o r c e/e n e r g y    o u t p u t   t={:9.3E}\n", column(state.time));
  file_.print("\n\n\n\n\n velocity boundary condition forces/rigid body moments \n\n");
  for (const BndoutNode& node : state.nodes) {
    file_.print(" nd#{:8}", node.node);
    force_columns(file_, node.force, node.energy);
    file_.print("   setid ={:8}\n", node.set);
  }
  for (const BndoutBody& body : state.bodies) {
    file_.print("mat#{:8}", body.part);
    force_columns(file_, body.force, body.energy);
    file_.print("\n             xmoment={:13.4E}  ymoment={:13.4E} zmoment={:13.4E}\n", column(body.moment.x),
                column(body.moment.y), column(body.moment.z));
  }
  const BndoutTotal nodes = total(state.nodes), bodies = total(state.bodies);
  const Vec3d force = nodes.force + bodies.force;
  file_.print("              xtotal={:13.4E}   ytotal={:13.4E}  ztotal={:13.4E}   etotal={:13.4E}\n", column(force.x),
              column(force.y), column(force.z), column(nodes.energy + bodies.energy));
  file_.end_state();
}

}  // namespace nugget::output
