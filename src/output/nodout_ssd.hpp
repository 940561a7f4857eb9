// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "output/ascii.hpp"

namespace nugget::output {

/// One node at one frequency: amplitudes of displacement x y z, velocity x y z, acceleration x y z.
struct NodoutSsdRow {
  int node = 0;  ///< user id
  std::array<std::complex<double>, 9> amplitude{};
};

/// The ASCII file `nodout_ssd` of a steady-state response: amplitude and angle [degree] of each.
class NodoutSsd {
 public:
  NodoutSsd(std::filesystem::path path, const Header& header);
  void write(double frequency, const std::vector<NodoutSsdRow>& rows);

 private:
  AsciiFile file_;
};

}  // namespace nugget::output
