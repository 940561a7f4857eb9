// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include "weld/failure/function.hpp"

namespace nugget::weld::failure {
namespace {

/// Rate of a force between cycles, the mean of the last `count` of them.
class ForceRate {
 public:
  explicit ForceRate(int count) : kept_(static_cast<std::size_t>(std::max(count, 1)), 0.0) {}
  double operator()(double force, double dt) {
    if (dt > 0.0) {
      kept_[next_] = (force - last_) / dt;
      next_ = (next_ + 1) % kept_.size();
      seen_ = std::min(seen_ + 1, kept_.size());
    }
    last_ = force;
    double sum = 0.0;
    for (std::size_t i = 0; i < seen_; ++i) sum += kept_[i];
    return seen_ > 0 ? std::abs(sum) / static_cast<double>(seen_) : 0.0;
  }

  void archive(Archive& a) { a(kept_, next_, seen_, last_); }

 private:
  std::vector<double> kept_;
  std::size_t next_ = 0, seen_ = 0;
  double last_ = 0.0;
};

/// OPT 10, after S. Lee and R. Balur (2011): nominal stresses of tension and shear over d t, their strengths raised by
/// the rate of the force,
///   (normal / S_N)^EXN + (shear / S_S)^EXS,   S = S_static max(1, DC1 + DC2 x + DC3 ln x),  x = force rate / DC4
class LoadRateStress final : public Function {
 public:
  LoadRateStress(const model::LoadRateStrengths& table, double normal, double shear, double diameter, double thickness)
      : table_(&table),
        normal_(normal),
        shear_(shear),
        area_(diameter * thickness),
        normal_rate_(table.averaged),
        shear_rate_(table.averaged) {}

  Value operator()(const Load& load) override {
    const double dt = load.time - time_, n = load.resultants.tension(), v = load.resultants.shear();
    time_ = load.time;
    Value f;
    f.add(FailureMode::normal_stress, term(n, normal_rate_(n, dt), normal_, table_->normal_exponent));
    f.add(FailureMode::shear_stress, term(v, shear_rate_(v, dt), shear_, table_->shear_exponent));
    return f;
  }

  void archive(Archive& a) override {
    a(normal_rate_, shear_rate_, time_);
    a.built(table_, normal_, shear_, area_);
  }

 private:
  double term(double force, double rate, double strength, double exponent) const {
    if (!(strength > 0.0) || !(area_ > 0.0)) return 0.0;
    return std::pow(force / (area_ * strength * dynamic_factor(rate)), exponent);
  }
  double dynamic_factor(double rate) const {
    const double x = rate / table_->dynamic[3];
    if (!(x > 0.0)) return 1.0;
    return std::max(1.0, table_->dynamic[0] + table_->dynamic[1] * x + table_->dynamic[2] * std::log(x));
  }

  const model::LoadRateStrengths* table_;
  double normal_, shear_, area_;
  ForceRate normal_rate_, shear_rate_;
  double time_ = 0.0;
};

}  // namespace

std::unique_ptr<Function> load_rate_stress(const model::LoadRateStrengths& table, double normal, double shear,
                                           double diameter, double thickness) {
  return std::make_unique<LoadRateStress>(table, normal, shear, diameter, thickness);
}

}  // namespace nugget::weld::failure
