// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/rigid_weld.hpp"

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

bool RigidWeldHistory::update(double time, const RigidWeldLoad& load, double plastic_strain) {
  if (failed()) return false;
  const Vec3d force = filter_(time, load.force);
  axial_ = dot(force, load.axis);
  shear_ = norm(force - axial_ * load.axis);
  moment_ = load.moment;
  torsion_ = load.torsion;
  peaks_.add(axial_, shear_, moment_, torsion_);
  const auto term = [](double value, double strength, double exponent) {
    return strength > 0.0 && value > 0.0 ? std::pow(value / strength, exponent) : 0.0;
  };
  const double normal = term(axial_, law_->normal_strength, law_->normal_exponent);
  const double across = term(shear_, law_->shear_strength, law_->shear_exponent);
  value_ = normal + across;
  course_.add(time, value_);
  last_ = {axial_, shear_, moment_, torsion_, normal, across};
  if (value_ > peak_value_) {
    peak_value_ = value_;
    peak_time_ = time;
  }
  if (value_ >= 1.0)
    fail(time, normal >= across ? FailureMode::axial : FailureMode::shear);
  else if (law_->failure_time > 0.0 && time >= law_->failure_time)
    fail(time, FailureMode::time);
  else if (law_->failure_strain > 0.0 && plastic_strain > law_->failure_strain)
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
  a.built(law_);
}

}  // namespace nugget::weld
