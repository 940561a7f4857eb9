// SPDX-License-Identifier: Apache-2.0
#include "weld/coupon/damage_fit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unsupported/Eigen/NonLinearOptimization>

#include "base/index.hpp"
#include "weld/coupon/strength_fit.hpp"

namespace nugget::weld {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Residuals and their slopes over the logarithm of RS.
class WorkErrors {
 public:
  WorkErrors(const std::vector<double>& measured, const std::function<std::vector<double>(double)>& simulated)
      : measured_(measured), simulated_(simulated) {}

  int inputs() const { return 1; }
  int values() const { return static_cast<int>(measured_.size()); }

  int operator()(const VectorXd& log_rupture, VectorXd& residual) {
    const auto [found, is_new] = known_.try_emplace(log_rupture[0]);
    if (is_new) found->second = simulated_(std::exp(log_rupture[0]));
    const std::vector<double>& work = found->second;
    constexpr double least = 1e-3;  // a weld that is gone at its peak
    for (std::size_t i = 0; i < work.size(); ++i)
      residual[static_cast<Eigen::Index>(i)] = std::log(std::max(work[i] / measured_[i], least));
    last_ = residual;
    return 0;
  }
  int df(const VectorXd& log_rupture, MatrixXd& slope) {
    constexpr double step = 0.1;  // far above what the states of a run round off
    const VectorXd here = last_;
    VectorXd there(here.size());
    (*this)(log_rupture + VectorXd::Constant(1, step), there);
    slope.col(0) = (there - here) / step;
    last_ = here;
    return 0;
  }

 private:
  const std::vector<double>& measured_;
  const std::function<std::vector<double>(double)>& simulated_;
  std::map<double, std::vector<double>> known_;  ///< by ln RS: runs are dear
  VectorXd last_;
};

}  // namespace

double work_after_peak(std::span<const double> displacement, std::span<const double> force) {
  const auto peak = static_cast<std::size_t>(std::ranges::max_element(force) - force.begin());
  double work = 0.0;
  for (std::size_t i = peak + 1; i < force.size(); ++i)
    work += 0.5 * (force[i] + force[i - 1]) * (displacement[i] - displacement[i - 1]);
  return work;
}

DamageFit fit_damage(const std::vector<double>& measured, double start,
                     const std::function<std::vector<double>(double)>& simulated) {
  DamageFit fit;
  WorkErrors errors(measured, simulated);
  VectorXd log_rupture = VectorXd::Constant(1, std::log(start));
  Eigen::LevenbergMarquardt<WorkErrors> solver(errors);
  solver.parameters.xtol = 1e-3;
  solver.parameters.ftol = 1e-4;
  solver.parameters.maxfev = 12;
  solver.minimize(log_rupture);

  const auto values = static_cast<Eigen::Index>(measured.size());
  VectorXd residual(values);
  MatrixXd slope(values, 1);
  errors(log_rupture, residual);
  errors.df(log_rupture, slope);
  constexpr double little = 0.05;  // of the work, for as much of RS
  if (slope.cwiseAbs().maxCoeff() < little) {
    fit.fault = "the work behind the peak does not depend on RS in any of these tests [measure one in shear]";
    return fit;
  }
  fit.rupture = std::exp(log_rupture[0]);
  for (Eigen::Index i = 0; i < values; ++i) fit.ratio.push_back(std::exp(residual[i]));
  const int freedom = static_cast<int>(values) - 1;
  if (freedom == 0) return fit;
  const double half = student_limit(freedom) * std::sqrt(residual.squaredNorm() / freedom / slope.squaredNorm());
  fit.low = fit.rupture * std::exp(-half);
  fit.high = fit.rupture * std::exp(half);
  return fit;
}

}  // namespace nugget::weld
