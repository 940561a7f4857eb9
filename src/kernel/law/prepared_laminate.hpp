// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "kernel/law/laminate.hpp"
#include "kernel/law/prepared_compound.hpp"

namespace nugget::kernel {

/// A law made ready for each layer. All layers have as many numbers of history as the one that needs most. There is no
/// layer(): the elements ask for the law of each layer, law_of().
template <>
class Prepared<Laminate> {
 public:
  static constexpr bool has_plastic_strain = true;

  struct Layer {
    Prepared<Compound> law;
    double stiffness = 0.0;     ///< share in the stiffness in the plane [1]
    double angle = 0.0;         ///< B [rad]
    double shear_strain = 1.0;  ///< transverse shear strain over the element's [1]
    double shear_force = 1.0;   ///< what its transverse shear stress bears, on top of SHRF [1]
    int first_alike = 0;        ///< the lowest layer of the same law
  };

  explicit Prepared(const Laminate& laminate)
      : elastic_(laminate.E, laminate.nu), outlived_(laminate.outlived_by_sound) {
    const std::vector<Laminate::Layer>& layers = *laminate.layers;
    for (const Laminate::Layer& l : layers) {
      const ElasticConstants own(l.law.E, l.law.nu);
      const auto alike = std::find_if(layers.begin(), layers.end(),
                                      [&](const auto& other) { return other.law.made_of == l.law.made_of; });
      const double force = laminate.shear_factor > 0.0 ? l.shear / laminate.shear_factor : 1.0;
      layers_.push_back({Prepared<Compound>(l.law), l.share * own.plane / elastic_.plane, l.angle, l.shear,
                         l.shear_scale * force, static_cast<int>(alike - layers.begin())});
      history_ = std::max(history_, layers_.back().law.layer_history());
      deletion_step_ = std::max(deletion_step_, layers_.back().law.deletion_step());
      can_fail_ = can_fail_ || layers_.back().law.can_fail();
    }
  }

  const ElasticConstants& elastic() const { return elastic_; }
  int layer_history() const { return history_; }
  double deletion_step() const { return deletion_step_; }
  bool can_fail() const { return can_fail_; }
  const Layer& of(int k) const { return layers_[static_cast<std::size_t>(k)]; }
  /// Whether layers whose law knows no failure keep an element alive.
  bool outlived_by_sound() const { return outlived_; }

 private:
  ElasticConstants elastic_;
  std::vector<Layer> layers_;
  int history_ = 0;
  double deletion_step_ = 0.0;
  bool can_fail_ = false, outlived_;
};

/// The law of layer k of a shell.
template <class Law>
const auto& law_of(const Prepared<Law>& law, int k) {
  if constexpr (requires { law.of(k); })
    return law.of(k).law;
  else
    return law;
}

}  // namespace nugget::kernel
