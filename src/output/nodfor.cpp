// SPDX-License-Identifier: Apache-2.0
#include "output/nodfor.hpp"

namespace nugget::output {

NodforRow total(const NodforGroup& group) {
  NodforRow sum;
  for (const NodforRow& row : group.rows) {
    sum.force += row.force;
    sum.energy += row.energy;
  }
  return sum;
}

Nodfor::Nodfor(std::filesystem::path path, const Header& header) : file_(std::move(path), header, legend_lines({})) {}

void Nodfor::write(const NodforState& state) {
  file_.print("\n\n\n\n\n n o d a l   f o r c e   g r o u p    o u t p u t   t={:9.3E}\n", column(state.time));
  int number = 0;
  for (const NodforGroup& group : state.groups) {
    file_.print("\n\n\n\n\n nodal group output number {:2}\n\n", ++number);
    for (const NodforRow& row : group.rows)
      file_.print(" nd#{:8}  xforce={:13.4E}   yforce={:13.4E}  zforce={:13.4E}   energy={:13.4E}   setid ={:8}\n",
                  row.node, column(row.force.x), column(row.force.y), column(row.force.z), column(row.energy),
                  group.set_id);
    const NodforRow sum = total(group);
    file_.print("              xtotal={:13.4E}   ytotal={:13.4E}  ztotal={:13.4E}   etotal={:13.4E}\n",
                column(sum.force.x), column(sum.force.y), column(sum.force.z), column(sum.energy));
    if (!group.axes) continue;
    const Vec3d local = group.axes->local(sum.force);
    file_.print("              xlocal={:13.4E}   ylocal={:13.4E}  zlocal={:13.4E}\n", column(local.x), column(local.y),
                column(local.z));
  }
  file_.end_state();
}

}  // namespace nugget::output
