// SPDX-License-Identifier: Apache-2.0
#include "output/nodfor.hpp"

namespace nugget::output {
namespace {

/// Of all groups, one after the other.
std::vector<NodforRow> nodes(const NodforState& s) {
  std::vector<NodforRow> all;
  for (const NodforGroup& g : s.groups) all.insert(all.end(), g.rows.begin(), g.rows.end());
  return all;
}
std::vector<NodforGroup> groups_with_axes(const NodforState& s) {
  std::vector<NodforGroup> some;
  for (const NodforGroup& g : s.groups)
    if (g.axes) some.push_back(g);
  return some;
}

void print(AsciiFile& file, const NodforState& state) {
  file.print("\n\n\n\n\n n o d a l   f o r c e   g r o u p    o u t p u t   t={:9.3E}\n", column(state.time));
  int number = 0;
  for (const NodforGroup& group : state.groups) {
    file.print("\n\n\n\n\n nodal group output number {:2}\n\n", ++number);
    for (const NodforRow& row : group.rows)
      file.print(" nd#{:8}  xforce={:13.4E}   yforce={:13.4E}  zforce={:13.4E}   energy={:13.4E}   setid ={:8}\n",
                 row.node, column(row.force.x), column(row.force.y), column(row.force.z), column(row.energy),
                 group.set_id);
    const NodforRow sum = total(group);
    file.print("              xtotal={:13.4E}   ytotal={:13.4E}  ztotal={:13.4E}   etotal={:13.4E}\n",
               column(sum.force.x), column(sum.force.y), column(sum.force.z), column(sum.energy));
    if (!group.axes) continue;
    const Vec3d local = group.axes->local(sum.force);
    file.print("              xlocal={:13.4E}   ylocal={:13.4E}  zlocal={:13.4E}\n", column(local.x), column(local.y),
               column(local.z));
  }
}

}  // namespace

NodforRow total(const NodforGroup& group) {
  NodforRow sum;
  for (const NodforRow& row : group.rows) {
    sum.force += row.force;
    sum.energy += row.energy;
  }
  return sum;
}

const HistoryFormat<NodforState>& nodfor() {
  static const HistoryFormat<NodforState> format{
      .branches = {{
          .path = "nodfor",
          .ids =
              [](const NodforState& s) {
                std::vector<int> all;
                for (const NodforRow& r : nodes(s)) all.push_back(r.node);
                return all;
              },
          .once = columns(&NodforState::groups,
                          {
                              {"groups", [](const NodforGroup& g) { return static_cast<int>(g.rows.size()); },
                               dimension::number, "nodes of each group"},
                              {"local", [](const NodforGroup& g) { return g.axes.has_value(); }, dimension::number,
                               "1: the group's sum is there in local axes too"},
                          }),
          .columns = columns(nodes,
                             {
                                 {"time", &NodforState::time, dimension::time, "time"},
                                 {"*_force", &NodforRow::force, dimension::force, "force on a node"},
                                 {"energy", &NodforRow::energy, dimension::energy, "its work"},
                             }) +
                     columns(&NodforState::groups,
                             {
                                 {"*_total", [](const NodforGroup& g) { return total(g).force; }, dimension::force,
                                  "sum of a group's forces"},
                                 {"etotal", [](const NodforGroup& g) { return total(g).energy; }, dimension::energy,
                                  "sum of a group's work"},
                             }) +
                     columns(groups_with_axes,
                             {
                                 {"*_local", [](const NodforGroup& g) { return g.axes->local(total(g).force); },
                                  dimension::force, "sum of a group's forces in its axes"},
                             })
                         .where([](const NodforState& s) { return !groups_with_axes(s).empty(); }),
      }},
      .legend = LegendLines::empty,
      .print = print,
  };
  return format;
}

}  // namespace nugget::output
