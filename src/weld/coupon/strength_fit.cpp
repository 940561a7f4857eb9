// SPDX-License-Identifier: Apache-2.0
#include "weld/coupon/strength_fit.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <unsupported/Eigen/NonLinearOptimization>

#include "base/index.hpp"

namespace nugget::weld {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Residuals and their derivatives over the logarithms of the strengths that are sought.
class ForceErrors {
 public:
  ForceErrors(const std::vector<StrengthSample>& samples, std::vector<std::size_t> sought, const StrengthForm& form)
      : samples_(samples), sought_(std::move(sought)), form_(form) {}

  int inputs() const { return static_cast<int>(sought_.size()); }
  int values() const { return static_cast<int>(samples_.size()); }

  /// load_k / S_k.
  double ratio(std::size_t sample, std::size_t k, const VectorXd& log_strength) const {
    return samples_[sample].load[sought_[k]] / std::exp(log_strength[static_cast<Eigen::Index>(k)]);
  }
  /// Of each group the sum of its ratios.
  std::array<double, 4> groups(std::size_t sample, const VectorXd& log_strength) const {
    std::array<double, 4> sums{};
    for (std::size_t k = 0; k < sought_.size(); ++k) sums[group(k)] += ratio(sample, k, log_strength);
    return sums;
  }
  double failure_value(const std::array<double, 4>& sums) const {
    double f = 0.0;
    for (const double sum : sums) f += std::pow(sum, form_.exponent);
    return f;
  }

  int operator()(const VectorXd& log_strength, VectorXd& residual) const {
    for (std::size_t i = 0; i < samples_.size(); ++i)
      residual[static_cast<Eigen::Index>(i)] = std::log(failure_value(groups(i, log_strength))) / form_.exponent;
    return 0;
  }
  int df(const VectorXd& log_strength, MatrixXd& derivative) const {
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const std::array<double, 4> sums = groups(i, log_strength);
      const double f = failure_value(sums);
      for (std::size_t k = 0; k < sought_.size(); ++k)
        derivative(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
            -std::pow(sums[group(k)], form_.exponent - 1.0) * ratio(i, k, log_strength) / f;
    }
    return 0;
  }

 private:
  std::size_t group(std::size_t k) const { return at(form_.group[sought_[k]]); }

  const std::vector<StrengthSample>& samples_;
  std::vector<std::size_t> sought_;
  const StrengthForm& form_;
};

/// A force that is hardly there in any sample would only take up the scatter of the other ones: its name.
std::string force_not_seen(const std::vector<StrengthSample>& samples, const std::vector<std::size_t>& sought,
                           const StrengthForm& form) {
  constexpr double little = 0.05;  // of the weld's force
  for (const std::size_t k : sought) {
    const auto sees = [k](const StrengthSample& s) { return s.load[k] > little * std::hypot(s.load[0], s.load[1]); };
    if (k < 2 && std::none_of(samples.begin(), samples.end(), sees)) return form.name[k];
  }
  return {};
}

double student_density(double t, double n) {
  return std::exp(std::lgamma(0.5 * (n + 1.0)) - std::lgamma(0.5 * n)) / std::sqrt(n * std::numbers::pi) *
         std::pow(1.0 + t * t / n, -0.5 * (n + 1.0));
}

/// Probability that t lies between 0 and `limit`: Simpson's rule.
double student_share(double limit, double n) {
  constexpr int pieces = 400;
  const double h = limit / pieces;
  double sum = student_density(0.0, n) + student_density(limit, n);
  for (int i = 1; i < pieces; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * student_density(i * h, n);
  return sum * h / 3.0;
}

/// Failure values of resultants are linear in 1 / S^2: the least squares of f - 1, where that gives strengths, is a
/// start that cannot run into a corner.
std::optional<VectorXd> linear_solution(const std::vector<StrengthSample>& samples,
                                        const std::vector<std::size_t>& sought) {
  MatrixXd square(samples.size(), sought.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t k = 0; k < sought.size(); ++k)
      square(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = std::pow(samples[i].load[sought[k]], 2);
  // Forces and moments differ by orders of magnitude.
  const VectorXd scale = square.colwise().maxCoeff().cwiseMax(1e-300);
  const VectorXd x = (square * scale.cwiseInverse().asDiagonal())
                         .colPivHouseholderQr()
                         .solve(VectorXd::Ones(static_cast<Eigen::Index>(samples.size())));
  if (!(x.minCoeff() > 0.0)) return {};
  return VectorXd(-0.5 * (x.array() / scale.array()).log());
}

using Parts = Eigen::JacobiSVD<MatrixXd>;

/// A strength of which the samples say nothing, or nothing apart from another one: its name; empty: there is none.
/// `parts`: of the derivatives.
std::string undetermined_strength(const MatrixXd& derivative, const Parts& parts,
                                  const std::vector<std::size_t>& sought, const StrengthForm& form) {
  constexpr double little = 0.02;  // of a failure value, in the sample that it counts most in
  for (std::size_t k = 0; k < sought.size(); ++k)
    if (derivative.col(static_cast<Eigen::Index>(k)).cwiseAbs().maxCoeff() < little) return form.name[sought[k]];
  const auto last = parts.singularValues().size() - 1;
  if (parts.singularValues()[last] > 1e-3 * parts.singularValues()[0]) return {};
  Eigen::Index most = 0;
  parts.matrixV().col(last).cwiseAbs().maxCoeff(&most);
  return form.name[sought[static_cast<std::size_t>(most)]];
}

/// Diagonal entry i of the inverse of J^T J, by the parts of J.
double inverse_square(const Parts& parts, Eigen::Index i) {
  return (parts.matrixV().row(i).transpose().array() / parts.singularValues().array()).square().sum();
}

}  // namespace

double student_limit(int freedom) {
  double low = 0.0, high = 100.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (student_share(middle, freedom) < 0.475 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

StrengthFit fit_strengths(const std::vector<StrengthSample>& samples, const std::array<double, 4>& start,
                          const StrengthForm& form) {
  StrengthFit fit;
  std::vector<std::size_t> sought;
  for (std::size_t k = 0; k < 4; ++k)
    if (start[k] > 0.0) sought.push_back(k);
  if (sought.empty()) {
    fit.fault = "the card has no strength above 0, so that nothing is sought";
    return fit;
  }
  if (samples.size() < sought.size())
    fit.fault = fmt::format("{} tests for {} strengths", samples.size(), sought.size());
  for (const StrengthSample& s : samples)
    if (std::none_of(sought.begin(), sought.end(), [&](std::size_t k) { return s.load[k] > 0.0; }))
      fit.fault = fmt::format("{} loads none of the strengths that are sought", s.test);
  const auto undetermined = [](const std::string& name) {
    return fmt::format(
        "the tests do not determine {}: none of them loads it enough, or always together with another strength", name);
  };
  if (const std::string name = force_not_seen(samples, sought, form); fit.fault.empty() && !name.empty())
    fit.fault = undetermined(name);
  if (!fit.fault.empty()) return fit;

  ForceErrors errors(samples, sought, form);
  const auto parameters = static_cast<Eigen::Index>(sought.size()), values = static_cast<Eigen::Index>(samples.size());
  VectorXd log_strength(parameters), residual(values);
  for (std::size_t k = 0; k < sought.size(); ++k)
    log_strength[static_cast<Eigen::Index>(k)] = std::log(start[sought[k]]);
  if (const std::optional<VectorXd> near = linear_solution(samples, sought)) log_strength = *near;
  Eigen::LevenbergMarquardt<ForceErrors> solver(errors);
  solver.parameters.ftol = solver.parameters.xtol = 1e-12;
  solver.minimize(log_strength);

  MatrixXd derivative(values, parameters);
  errors(log_strength, residual);
  errors.df(log_strength, derivative);
  const Parts parts(derivative, Eigen::ComputeThinV);
  if (const std::string name = undetermined_strength(derivative, parts, sought, form); !name.empty()) {
    fit.fault = undetermined(name);
    return fit;
  }
  for (Eigen::Index i = 0; i < values; ++i) fit.ratio.push_back(std::exp(-residual[i]));
  for (std::size_t k = 0; k < sought.size(); ++k)
    fit.strength[sought[k]] = std::exp(log_strength[static_cast<Eigen::Index>(k)]);
  const int freedom = static_cast<int>(values - parameters);
  if (freedom == 0) return fit;
  const double variance = residual.squaredNorm() / freedom;
  fit.scatter = std::sqrt(variance);
  const double t = student_limit(freedom);
  for (std::size_t k = 0; k < sought.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const double half = t * std::sqrt(variance * inverse_square(parts, i));
    fit.low[sought[k]] = fit.strength[sought[k]] * std::exp(-half);
    fit.high[sought[k]] = fit.strength[sought[k]] * std::exp(half);
  }
  return fit;
}

}  // namespace nugget::weld
