// SPDX-License-Identifier: Apache-2.0
#include "output/spcforc.hpp"

namespace nugget::output {
namespace {

void row(AsciiFile& file, const char* kind, const SpcforcRow& r) {
  file.print(" node={:8} local x,y,z {}={:14.4E}{:14.4E}{:14.4E}  setid={:8}\n", r.node, kind, column(r.value.x),
             column(r.value.y), column(r.value.z), r.set);
}

}  // namespace

Spcforc::Spcforc(std::filesystem::path path, const Header& header)
    : file_(std::move(path), header, legend_lines({}) + " single point constraint forces\n\n") {}

void Spcforc::write(const SpcforcState& state) {
  file_.print(" output at time ={:14.5E}\n", column(state.time));
  auto moment = state.moments.begin();
  for (const SpcforcRow& force : state.forces) {
    for (; moment != state.moments.end() && moment->node < force.node; ++moment) row(file_, "moments", *moment);
    row(file_, "forces ", force);
  }
  for (; moment != state.moments.end(); ++moment) row(file_, "moments", *moment);
  file_.print("             force resultants   ={:14.4E}{:14.4E}{:14.4E}\n", column(state.resultant.x),
              column(state.resultant.y), column(state.resultant.z));
  file_.end_state();
}

}  // namespace nugget::output
