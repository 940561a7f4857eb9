// SPDX-License-Identifier: Apache-2.0
#include "output/nodout_ssd.hpp"

#include <cmath>
#include <numbers>

namespace nugget::output {

NodoutSsd::NodoutSsd(std::filesystem::path path, const Header& header)
    : file_(std::move(path), header, "\n\n S t e a d y   S t a t e   D y n a m i c s\n") {}

void NodoutSsd::write(double frequency, const std::vector<NodoutSsdRow>& rows) {
  const auto finite = [](double v) { return std::isfinite(v) ? column(v) : 0.0; };
  file_.print("\n\n nodal print out for frequency = {:12.5E}\n\n {:11}", column(frequency), "");
  for (const char* name : {"x-disp", "y-disp", "z-disp", "x-vel", "y-vel", "z-vel", "x-accl", "y-accl", "z-accl"})
    file_.print("{:>12}", name);
  for (const NodoutSsdRow& row : rows) {
    file_.print("\n{:10d}-\n amplitude  ", row.node);
    for (const std::complex<double>& v : row.amplitude) file_.print("{:12.4E}", finite(std::abs(v)));
    file_.print("\n angle      ");
    for (const std::complex<double>& v : row.amplitude)
      file_.print("{:12.4E}", finite(std::arg(v) * 180.0 / std::numbers::pi));
  }
  file_.print("\n");
  file_.end_state();
}

}  // namespace nugget::output
