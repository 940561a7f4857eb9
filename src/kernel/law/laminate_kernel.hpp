// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "kernel/law/composed_law_kernel.hpp"
#include "kernel/law/laminate.hpp"

namespace nugget::kernel {

/// A law made ready for each layer. All layers have as many numbers of history as the one that needs most. There is no
/// layer(): the elements ask for the law of each layer, law_of().
template <>
class LawKernel<Laminate> {
 public:
  static constexpr bool has_plastic_strain = true;
  /// Foams, and rubber by a test, are stiffer under compression than in tension, or the other way round.
  static constexpr bool may_pull_otherwise = true;

  struct Layer {
    LawKernel<ComposedLaw> law;
    double stiffness = 0.0;     ///< share in the stiffness in the plane [1]
    double angle = 0.0;         ///< B [rad]
    double shear_strain = 1.0;  ///< transverse shear strain over the element's [1]
    double shear_force = 1.0;   ///< factor on its transverse shear stress, on top of SHRF [1]
    int first_of_same_law = 0;  ///< the lowest layer of the same law
  };

  explicit LawKernel(const Laminate& laminate)
      : elastic_(laminate.E, laminate.nu), kept_by_unfailing_layers_(laminate.kept_by_unfailing_layers) {
    const std::vector<Laminate::Layer>& layers = *laminate.layers;
    for (const Laminate::Layer& l : layers) {
      const ElasticConstants own(l.law.E, l.law.nu);
      const auto alike = std::find_if(layers.begin(), layers.end(),
                                      [&](const auto& other) { return other.law.components == l.law.components; });
      const double force = laminate.shear_factor > 0.0 ? l.shear / laminate.shear_factor : 1.0;
      layers_.push_back({LawKernel<ComposedLaw>(l.law), l.share * own.plane / elastic_.plane, l.angle, l.shear,
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
  const Layer& of(int k) const { return layers_[k]; }
  /// Whether layers whose law has no failure keep an element alive.
  bool kept_by_unfailing_layers() const { return kept_by_unfailing_layers_; }

 private:
  ElasticConstants elastic_;
  std::vector<Layer> layers_;
  int history_ = 0;
  double deletion_step_ = 0.0;
  bool can_fail_ = false, kept_by_unfailing_layers_;
};

/// The law of layer k of a shell.
template <class Law>
const auto& law_of(const LawKernel<Law>& law, int k) {
  if constexpr (requires { law.of(k); })
    return law.of(k).law;
  else
    return law;
}

}  // namespace nugget::kernel
