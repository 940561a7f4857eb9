// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/force_at_failure.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace nugget::weld::failure {

double force_at_failure(const model::Model& model, const model::WeldLaw& law, const Geometry& weld, double angle) {
  const double radians = angle * std::numbers::pi / 180.0;
  const double axial = std::sin(radians), shear = angle == 90.0 ? 0.0 : std::cos(radians);
  // A function may remember loads, so each force meets a new one.
  const auto value = [&](double force) {
    Findings known;  // reported when the deck was read
    Load load;
    load.resultants.axial = force * axial;
    load.resultants.shear_s = force * shear;
    load.area = weld.area;
    return (*make_function(model, law, weld, {}, known))(load).value;
  };
  double high = 1.0;
  while (value(high) < 1.0) {
    high *= 2.0;
    if (high > 1e30) return std::numeric_limits<double>::infinity();
  }
  double low = 0.5 * high;
  while (low > 1e-30 && value(low) >= 1.0) {
    high = low;
    low *= 0.5;
  }
  while (high - low > 1e-12 * high) {
    const double middle = 0.5 * (low + high);
    (value(middle) >= 1.0 ? high : low) = middle;
  }
  return high;
}

}  // namespace nugget::weld::failure
