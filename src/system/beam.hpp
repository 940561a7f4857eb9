// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

// What the beams of all kinds share.
namespace nugget::system {

/// Layout of the state of a beam's kernel as BatchGroup wants it.
template <class KernelLayout>
struct BeamLayout : KernelLayout {
  static constexpr int hourglass_energy = -1;  ///< it has none
};

/// N_rr N_rs N_rt M_rr M_ss M_tt from a state that has them in a row.
template <class Layout, class Field>
std::array<double, 8> beam_resultants(const Field& field) {
  std::array<double, 8> r{};
  for (int i = 0; i < 6; ++i) r[i] = field(Layout::resultant + i);
  return r;
}

}  // namespace nugget::system
