// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/barlat_lian.hpp"

#include <numbers>

namespace nugget::kernel {

double BarlatLian::ratio(double angle) const {
  const double c = std::cos(angle), s = std::sin(angle);
  const PlaneStress<double> flow = BarlatLianSurface(*this)(PlaneStress<double>{c * c, s * s, c * s}).flow;
  const double across = s * s * flow.aa + c * c * flow.bb - c * s * flow.ab;
  return across / -(flow.aa + flow.bb);
}

BarlatLian BarlatLian::from_ratios(double m, double r00, double r45, double r90) {
  BarlatLian surface{.m = m};
  const double along = r00 / (1.0 + r00), across = r90 / (1.0 + r90);
  surface.C = 2.0 * std::sqrt(along * across);
  surface.A = 2.0 - surface.C;
  surface.H = std::sqrt(along / across);
  // The ratio at 45 degrees grows with P.
  double low = 1e-3, high = 1e3;
  for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
    surface.P = std::sqrt(low * high);
    (surface.ratio(0.25 * std::numbers::pi) < r45 ? low : high) = surface.P;
  }
  return surface;
}

}  // namespace nugget::kernel
