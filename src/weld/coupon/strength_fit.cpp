// SPDX-License-Identifier: Apache-2.0
#include "weld/coupon/strength_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "base/index.hpp"
#include "weld/coupon/least_squares.hpp"

namespace nugget::weld {
namespace {

/// Residuals and their derivatives over the logarithms of the strengths that are sought.
class ForceErrors {
 public:
  ForceErrors(const std::vector<StrengthSample>& samples, std::vector<std::size_t> sought, const StrengthForm& form)
      : samples_(samples), sought_(std::move(sought)), form_(form) {}

  std::vector<double> residuals(const std::vector<double>& log_strength) const {
    std::vector<double> residual(samples_.size());
    for (std::size_t i = 0; i < residual.size(); ++i)
      residual[i] = std::log(failure_value(groups(i, log_strength))) / form_.exponent;
    return residual;
  }
  Columns derivatives(const std::vector<double>& log_strength) const {
    Columns derivative(sought_.size(), std::vector<double>(samples_.size()));
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const std::array<double, 4> sums = groups(i, log_strength);
      const double f = failure_value(sums);
      for (std::size_t k = 0; k < sought_.size(); ++k)
        derivative[k][i] = -std::pow(sums[group(k)], form_.exponent - 1.0) * ratio(i, k, log_strength) / f;
    }
    return derivative;
  }

 private:
  /// load_k / S_k.
  double ratio(std::size_t sample, std::size_t k, const std::vector<double>& log_strength) const {
    return samples_[sample].load[sought_[k]] / std::exp(log_strength[k]);
  }
  /// Of each group the sum of its ratios.
  std::array<double, 4> groups(std::size_t sample, const std::vector<double>& log_strength) const {
    std::array<double, 4> sums{};
    for (std::size_t k = 0; k < sought_.size(); ++k) sums[group(k)] += ratio(sample, k, log_strength);
    return sums;
  }
  double failure_value(const std::array<double, 4>& sums) const {
    double f = 0.0;
    for (const double sum : sums) f += std::pow(sum, form_.exponent);
    return f;
  }
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
std::optional<std::vector<double>> linear_solution(const std::vector<StrengthSample>& samples,
                                                   const std::vector<std::size_t>& sought) {
  // Forces and moments differ by orders of magnitude.
  Columns square(sought.size());
  std::vector<double> scale;
  for (std::size_t k = 0; k < sought.size(); ++k) {
    for (const StrengthSample& s : samples) square[k].push_back(std::pow(s.load[sought[k]], 2));
    scale.push_back(std::max(std::ranges::max(square[k]), 1e-300));
    for (double& entry : square[k]) entry /= scale[k];
  }
  const SingularParts parts = singular_parts(std::move(square));
  constexpr double nothing = 1e-12;  // of the largest: the samples do not say it
  if (!(parts.value.back() > nothing * parts.value.front())) return {};
  std::vector<double> x = least_squares(parts, std::vector<double>(samples.size(), 1.0));
  if (!(std::ranges::min(x) > 0.0)) return {};
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = -0.5 * std::log(x[k] / scale[k]);
  return x;
}

/// A strength of which the samples say nothing, or nothing apart from another one: its name; empty: there is none.
/// `parts`: of the derivatives.
std::string undetermined_strength(const Columns& derivative, const SingularParts& parts,
                                  const std::vector<std::size_t>& sought, const StrengthForm& form) {
  constexpr double little = 0.02;  // of a failure value, in the sample that it counts most in
  const auto less = [](double a, double b) { return std::abs(a) < std::abs(b); };
  for (std::size_t k = 0; k < sought.size(); ++k)
    if (std::abs(std::ranges::max(derivative[k], less)) < little) return form.name[sought[k]];
  if (parts.value.back() > 1e-3 * parts.value.front()) return {};
  const std::vector<double>& last = parts.right.back();
  return form.name[sought[static_cast<std::size_t>(std::ranges::max_element(last, less) - last.begin())]];
}

/// Diagonal entry i of the inverse of J^T J, by the parts of J.
double inverse_square(const SingularParts& parts, std::size_t i) {
  double sum = 0.0;
  for (std::size_t k = 0; k < parts.value.size(); ++k) sum += std::pow(parts.right[k][i] / parts.value[k], 2);
  return sum;
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

  const ForceErrors errors(samples, sought, form);
  std::vector<double> log_strength;
  for (const std::size_t k : sought) log_strength.push_back(std::log(start[k]));
  if (const std::optional<std::vector<double>> near = linear_solution(samples, sought)) log_strength = *near;
  const SquareSum sum{
      .residuals = [&](const std::vector<double>& x) { return errors.residuals(x); },
      .derivatives = [&](const std::vector<double>& x, const std::vector<double>&) { return errors.derivatives(x); }};
  log_strength = minimized(sum, log_strength);

  const std::vector<double> residual = errors.residuals(log_strength);
  const Columns derivative = errors.derivatives(log_strength);
  const SingularParts parts = singular_parts(derivative);
  if (const std::string name = undetermined_strength(derivative, parts, sought, form); !name.empty()) {
    fit.fault = undetermined(name);
    return fit;
  }
  for (const double r : residual) fit.ratio.push_back(std::exp(-r));
  for (std::size_t k = 0; k < sought.size(); ++k) fit.strength[sought[k]] = std::exp(log_strength[k]);
  const int freedom = static_cast<int>(samples.size()) - static_cast<int>(sought.size());
  if (freedom == 0) return fit;
  const double variance = std::inner_product(residual.begin(), residual.end(), residual.begin(), 0.0) / freedom;
  fit.scatter = std::sqrt(variance);
  const double t = student_limit(freedom);
  for (std::size_t k = 0; k < sought.size(); ++k) {
    const double half = t * std::sqrt(variance * inverse_square(parts, k));
    fit.low[sought[k]] = fit.strength[sought[k]] * std::exp(-half);
    fit.high[sought[k]] = fit.strength[sought[k]] * std::exp(half);
  }
  return fit;
}

}  // namespace nugget::weld
