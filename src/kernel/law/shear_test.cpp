// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/shear_test.hpp"

#include <cmath>
#include <vector>

#include "base/batch.hpp"
#include "base/index.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {

// Laws are compiled for lanes only: the same point stands in all of them. It is here and not where it is asked for,
// because the rooms above are compiled once for all numbers of lanes.
template <class Law>
Curve shear_test(const Law& law, double strain_rate, double most_strain, const EndOfTest& enough) {
  constexpr double step = 5e-4;
  const double dt = step / strain_rate;
  const LawKernel<Law> kernel(law);
  std::vector<double> history(at(kernel.layer_history() * native_width));
  Curve curve;
  LayerTensor<NativeBatch> stress{}, rate{};
  rate.xy = NativeBatch(strain_rate);
  double before = 0.0;
  const auto steps = static_cast<std::size_t>(std::ceil(most_strain / step));
  for (std::size_t i = 0; i < steps; ++i) {
    kernel.layer(stress, rate, dt, history.data());
    const double plastic = lane(load_field<NativeBatch>(history.data(), plastic_strain_field), 0),
                 effective = std::sqrt(3.0) * std::abs(lane(stress.xy, 0));
    if (effective < 0.5 * before) break;  // the point has failed
    before = effective;
    if (!(plastic > (curve.empty() ? 0.0 : curve.x.back()))) continue;
    curve.x.push_back(plastic);
    curve.y.push_back(effective);
    if (enough && enough(plastic, effective)) break;
  }
  if (curve.x.size() < 2) return {};
  // Back to the first yield by the first slope.
  curve.y.front() = curve.y[0] - curve.x[0] * (curve.y[1] - curve.y[0]) / (curve.x[1] - curve.x[0]);
  curve.x.front() = 0.0;
  return curve;
}

template Curve shear_test(const PlasticKinematic&, double, double, const EndOfTest&);
template Curve shear_test(const PiecewiseLinear&, double, double, const EndOfTest&);
template Curve shear_test(const ComposedLaw&, double, double, const EndOfTest&);

}  // namespace nugget::kernel
