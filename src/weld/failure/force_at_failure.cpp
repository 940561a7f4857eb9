// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/force_at_failure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace nugget::weld::failure {
namespace {

/// A force of 1: its share along the normal of the sheets, and along them.
struct UnitForce {
  double normal, shear;
  explicit UnitForce(double degrees) {
    const double radians = degrees * std::numbers::pi / 180.0;
    normal = std::sin(radians);
    shear = degrees == 90.0 ? 0.0 : std::cos(radians);
  }
};

constexpr int samples = 4096;  // of a curve whose largest value is sought

}  // namespace

double force_at_failure(const model::Model& model, const model::WeldLaw& law, const Geometry& weld, double angle) {
  const UnitForce direction(angle);
  // A function may remember loads, so each force meets a new one.
  const auto value = [&](double force) {
    Findings known;  // reported when the deck was read
    Load load;
    load.resultants.axial = force * direction.normal;
    load.resultants.shear_s = force * direction.shear;
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

double force_at_failure(const kernel::Spr3& joint, double angle) {
  const UnitForce direction(angle);
  const kernel::Spr3::Freedoms unit{direction.normal, direction.shear, 0, 0, 0, 0};
  const double surface = 1.0 / joint.equivalent_force(unit);
  if (joint.initiation.empty()) return surface * joint.yield.largest();
  const double mixity = kernel::Spr3::mode_mixity(unit);
  const double begins = joint.initiation.clamped(mixity), ends = joint.rupture.clamped(mixity);
  double largest = joint.yield.yield(begins);
  for (int i = 0; i < samples; ++i) {
    const double u = ends * i / samples;
    largest = std::max(largest, joint.yield.yield(u) * std::min(1.0, (ends - u) / (ends - begins)));
  }
  return surface * largest;
}

double force_at_failure(const kernel::Spr2& rivet, double angle) {
  const UnitForce direction(angle);
  double largest = 0.0;
  for (int i = 1; i < samples; ++i) {
    const double damage = static_cast<double>(i) / samples;
    const kernel::Spr2::Freedoms stiffness = rivet.forces({1.0, 1.0, 0, 0, 0, 0}, damage);
    const double size = rivet.effective_displacement(
        {direction.normal / stiffness[0], direction.shear / stiffness[1], 0, 0, 0, 0}, damage);
    largest = std::max(largest, damage / size);
  }
  return largest;
}

}  // namespace nugget::weld::failure
