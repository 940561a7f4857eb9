// SPDX-License-Identifier: Apache-2.0
#include "output/deforc.hpp"

namespace nugget::output {

Deforc::Deforc(std::filesystem::path path, const Header& header) : file_(std::move(path), header) {}

void Deforc::write(const DeforcState& state) {
  const auto quantity = [&](const char* name, double value) { file_.print(" {:.<29}{:14.5E}\n", name, column(value)); };
  file_.print("\n {:.<29}{:14.5E}\n", "time", column(state.time));
  for (const DeforcRow& r : state.rows) {
    file_.print(" {:.<29}{:10}\n", "spring/damper number", r.spring);
    quantity(r.torsional ? "x-moment" : "x-force", r.force.x);
    quantity(r.torsional ? "y-moment" : "y-force", r.force.y);
    quantity(r.torsional ? "z-moment" : "z-force", r.force.z);
    quantity(r.torsional ? "resultant moment" : "resultant force", r.resultant);
    quantity(r.torsional ? "relative rotation" : "change in length", r.displacement);
  }
  file_.end_state();
}

}  // namespace nugget::output
