// SPDX-License-Identifier: Apache-2.0
#include "output/eigout.hpp"

#include <cmath>
#include <numbers>

namespace nugget::output {
namespace {

constexpr const char* directions =
    "        MODE         X-TRAN         Y-TRAN         Z-TRAN          X-ROT          Y-ROT          Z-ROT\n";

void table(AsciiFile& file, const char* title, const std::vector<EigoutMode>& modes,
           std::array<double, 6> EigoutMode::*what) {
  file.print("\n\n\n {}\n\n{}", title, directions);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    file.print("{:12d}", i + 1);
    for (const double v : modes[i].*what) file.print("{:15.6E}", column(v));
    file.print("\n");
  }
}

}  // namespace

void write_eigout(const std::filesystem::path& path, const Header& header, const std::vector<EigoutMode>& modes,
                  const std::array<double, 6>& total) {
  AsciiFile file(path, header);
  file.print("\n r e s u l t s   o f   e i g e n v a l u e   a n a l y s i s:\n\n problem time = {:13.5E}\n", 0.0);
  file.print("\n (all frequencies de-shifted)\n");
  file.print("\n                         |------ frequency -----|\n");
  file.print("        MODE    EIGENVALUE       RADIANS        CYCLES        PERIOD\n");
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const double radians = std::sqrt(std::max(0.0, modes[i].eigenvalue)), cycles = radians / (2.0 * std::numbers::pi);
    file.print("{:12d} {:14.6E}{:14.6E}{:14.6E}{:14.6E}\n", i + 1, column(modes[i].eigenvalue), column(radians),
               column(cycles), cycles > 0.0 ? 1.0 / cycles : 0.0);
  }
  table(file, "MODAL PARTICIPATION FACTORS", modes, &EigoutMode::participation);
  table(file, "MODAL EFFECTIVE MASS", modes, &EigoutMode::effective_mass);
  std::vector<EigoutMode> share = modes;
  std::array<double, 6> sum{};
  for (EigoutMode& m : share)
    for (std::size_t i = 0; i < 6; ++i) {
      sum[i] += m.effective_mass[i];
      m.effective_mass[i] = total[i] > 0.0 ? sum[i] / total[i] : 0.0;
    }
  table(file, "ACCUMULATED MODAL EFFECTIVE MASS AS A SHARE OF THE MASS", share, &EigoutMode::effective_mass);
  file.end_state();
}

}  // namespace nugget::output
