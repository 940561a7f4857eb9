// SPDX-License-Identifier: Apache-2.0
#include "output/jntforc.hpp"

namespace nugget::output {

Jntforc::Jntforc(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend)
    : file_(std::move(path), header, legend_lines(legend)) {}

void Jntforc::write(const JntforcState& state) {
  const auto quantity = [&](const char* name, double value) { file_.print(" {:.<29}{:14.5E}\n", name, column(value)); };
  file_.print("\n {:.<29}{:14.5E}\n", "time", column(state.time));
  for (const JntforcRow& r : state.rows) {
    file_.print(" {:.<29}{:10}\n", "joint ID", r.joint);
    quantity("x-force", r.force.x);
    quantity("y-force", r.force.y);
    quantity("z-force", r.force.z);
    quantity("x-moment", r.moment.x);
    quantity("y-moment", r.moment.y);
    quantity("z-moment", r.moment.z);
    quantity("resultant force", norm(r.force));
    quantity("resultant moment", norm(r.moment));
  }
  file_.end_state();
}

}  // namespace nugget::output
