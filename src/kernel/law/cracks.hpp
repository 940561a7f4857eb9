// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/point_damage.hpp"
#include "kernel/law/stress_space.hpp"

namespace nugget::kernel {

/// Damage of a layer by direction (MAT_082, MAT_099). Once the greatest principal plastic strain in the plane reaches
/// the onset, its direction n1 and the one across, n2, are kept; from then on w_i is the damage of the plastic strain
/// along n_i and never falls. The layer hands out M s M, M = diag(sqrt(1 - w1), sqrt(1 - w2), 1) in n1, n2 and the
/// normal: the stress on the area that is left (J.P. Cordebois, F. Sidoroff, 1982), s that of the undamaged layer. It
/// has failed when one w is 1.
class Cracks {
 public:
  static constexpr int history = 7;  ///< plastic strain xx, yy, xy (tensorial); w1, w2; n1

  explicit Cracks(const PlasticDamage& law) : law_(law) {}

  /// Adds a step's effective plastic strain, which flows with the undamaged stress given. True once failed.
  bool advance(const SolidTensor<double>& stress, double increment, double* h, int stride) const;

  /// M s M, or the way back.
  static LayerTensor<double> weakened(const LayerTensor<double>& s, const double* h, int stride);
  static LayerTensor<double> undamaged(const LayerTensor<double>& s, const double* h, int stride);

 private:
  PlasticDamage law_;
};

}  // namespace nugget::kernel
