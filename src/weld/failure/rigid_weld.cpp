// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/rigid_weld.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::weld {

Vec3d ForceFilter::operator()(double time, const Vec3d& force) {
  if (length_ <= 1) return force;
  kept_.push_back({time, force});
  if (kept_.size() > length_) kept_.pop_front();
  if (window_ > 0.0)
    while (kept_.front().time < time - window_) kept_.pop_front();
  Vec3d sum;
  for (const Kept& k : kept_) sum += k.force;
  return (1.0 / static_cast<double>(kept_.size())) * sum;
}

RigidWeldHistory::Terms RigidWeldHistory::of_spot() const {
  const auto term = [](double value, double strength, double exponent) {
    return strength > 0.0 && value > 0.0 ? std::pow(value / strength, exponent) : 0.0;
  };
  const double normal = term(axial_, law_->normal_strength, law_->normal_exponent);
  const double across = term(shear_, law_->shear_strength, law_->shear_exponent);
  return {normal + across, normal, across};
}

RigidWeldHistory::Terms RigidWeldHistory::of_seam(const Vec3d& force, const Vec3d& normal) const {
  if (!(seam_->strength > 0.0)) return {};
  const double along = dot(force, normal), across = norm(force - along * normal);
  const double n = std::max(along, 0.0) / seam_->strength, t = across / seam_->strength;
  return {std::sqrt(n * n + 3.0 * t * t), n * n, 3.0 * t * t};
}

bool RigidWeldHistory::update(double time, const RigidWeldLoad& load, double plastic_strain) {
  if (failed()) return false;
  const Vec3d force = filter_(time, load.force);
  axial_ = dot(force, load.axis);
  shear_ = norm(force - axial_ * load.axis);
  moment_ = load.moment;
  torsion_ = load.torsion;
  peaks_.add(axial_, shear_, moment_, torsion_);
  const Terms terms = seam_ != nullptr ? of_seam(force, load.normal) : of_spot();
  value_ = terms.value;
  course_.add(time, value_);
  last_ = {axial_, shear_, moment_, torsion_, terms.value, terms.normal, terms.shear};
  if (value_ > peak_value_) {
    peak_value_ = value_;
    peak_time_ = time;
  }
  const double failure_time_given = seam_ != nullptr ? seam_->failure_time : law_->failure_time;
  const double failure_strain = seam_ != nullptr ? seam_->failure_strain : law_->failure_strain;
  if (value_ >= 1.0)
    fail(time, terms.normal >= terms.shear ? FailureMode::axial : FailureMode::shear);
  else if (failure_time_given > 0.0 && time >= failure_time_given)
    fail(time, FailureMode::time);
  else if (failure_strain > 0.0 && plastic_strain > failure_strain)
    fail(time, FailureMode::plastic_strain);
  return failed();
}

void RigidWeldHistory::move_inward() {
  const RigidWeldHistory outer = *this;
  *this = RigidWeldHistory(*law_);
  peaks_ = outer.peaks_;
  peak_value_ = outer.peak_value_;
  peak_time_ = outer.peak_time_;
  course_ = outer.course_;
}

void RigidWeldHistory::fail(double time, FailureMode mode) {
  mode_ = mode;
  failure_time_ = time;
  axial_ = shear_ = moment_ = torsion_ = 0.0;  // what has failed carries nothing
}

void ForceFilter::archive(Archive& a) {
  a(kept_);
  a.built(length_, window_);
}

void RigidWeldHistory::archive(Archive& a) {
  a(filter_, axial_, shear_, moment_, torsion_, value_, failure_time_, mode_, peaks_, last_, peak_value_, peak_time_,
    course_);
  a.built(law_, seam_);
}

}  // namespace nugget::weld
