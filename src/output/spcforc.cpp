// SPDX-License-Identifier: Apache-2.0
#include "output/spcforc.hpp"

namespace nugget::output {
namespace {

void row(AsciiFile& file, const char* kind, const SpcforcRow& r) {
  file.print(" node={:8} local x,y,z {}={:14.4E}{:14.4E}{:14.4E}  setid={:8}\n", r.node, kind, column(r.value.x),
             column(r.value.y), column(r.value.z), r.set);
}

bool has_forces(const SpcforcState& s) {
  return !s.forces.empty();
}
bool has_moments(const SpcforcState& s) {
  return !s.moments.empty();
}

std::vector<int> supported_nodes(const SpcforcState& s) {
  std::vector<int> all;
  for (const SpcforcRow& r : s.forces) all.push_back(r.node);
  for (const SpcforcRow& r : s.moments) all.push_back(r.node);
  return all;
}

void print(AsciiFile& file, const SpcforcState& state) {
  file.print(" output at time ={:14.5E}\n", column(state.time));
  auto moment = state.moments.begin();
  for (const SpcforcRow& force : state.forces) {
    for (; moment != state.moments.end() && moment->node < force.node; ++moment) row(file, "moments", *moment);
    row(file, "forces ", force);
  }
  for (; moment != state.moments.end(); ++moment) row(file, "moments", *moment);
  file.print("             force resultants   ={:14.4E}{:14.4E}{:14.4E}\n", column(state.resultant.x),
             column(state.resultant.y), column(state.resultant.z));
}

}  // namespace

const HistoryFormat<SpcforcState>& spcforc() {
  static const HistoryFormat<SpcforcState> format{
      .branches = {{
          .path = "spcforc",
          .ids = supported_nodes,
          .once = columns(&SpcforcState::forces,
                          {
                              {"force_ids", &SpcforcRow::node, dimension::number, "nodes held in translation"},
                              {"spc_ids", &SpcforcRow::set, dimension::number, "ids of their supports"},
                          })
                      .where(has_forces) +
                  columns(&SpcforcState::moments,
                          {
                              {"moment_ids", &SpcforcRow::node, dimension::number, "nodes held in rotation"},
                              {"spc_mids", &SpcforcRow::set, dimension::number, "ids of their supports"},
                          })
                      .where(has_moments),
          .columns = columns<SpcforcState>({{"time", &SpcforcState::time, dimension::time, "time"}}) +
                     columns(&SpcforcState::forces,
                             {{"*_force", &SpcforcRow::value, dimension::force, "force of a support, in its axes"}})
                         .where(has_forces) +
                     columns(&SpcforcState::moments,
                             {{"*_moment", &SpcforcRow::value, dimension::moment, "moment of a support, in its axes"}})
                         .where(has_moments) +
                     columns<SpcforcState>({{"*_resultant", &SpcforcState::resultant, dimension::force,
                                             "sum of the forces in global axes"}}),
          .lists_ids = false,
      }},
      .legend = LegendLines::empty,
      .heading = " single point constraint forces\n\n",
      .print = print,
  };
  return format;
}

}  // namespace nugget::output
