// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "model/model.hpp"

// What the beams of all kinds share.
namespace nugget::system {

/// Layout of the state of a beam's kernel as BatchGroup wants it.
template <class KernelLayout>
struct BeamLayout : KernelLayout {
  static constexpr int hourglass_energy = -1;  ///< it has none
};

/// Direction from the first node to the third, which orients the section; zero where there is none.
inline Vec3d towards_third_node(const model::Beams& beams, const std::vector<Vec3d>& x, model::Index e,
                                const Vec3d& from) {
  const model::Index third = beams.orientation[static_cast<std::size_t>(e)];
  return third == model::none ? Vec3d{} : x[static_cast<std::size_t>(third)] - from;
}

/// N_rr N_rs N_rt M_rr M_ss M_tt from a state that has them in a row.
template <class Layout, class Field>
std::array<double, 8> beam_resultants(const Field& field) {
  std::array<double, 8> r{};
  for (int i = 0; i < 6; ++i) r[static_cast<std::size_t>(i)] = field(Layout::resultant + i);
  return r;
}

}  // namespace nugget::system
