// SPDX-License-Identifier: Apache-2.0
#include "nvh/response/frequencies.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "nvh/matrices/factorization.hpp"

namespace nugget::nvh {

std::vector<double> frequencies(const model::Frequencies& wanted, const Modes& modes) {
  if (!wanted.near_modes) return wanted.frequency;
  const double low = wanted.frequency.front(), high = wanted.frequency.back();
  std::vector<double> natural;
  for (std::size_t i = 0; i < modes.eigenvalue.size(); ++i) {
    const double f = modes.frequency(i);
    const bool again = !natural.empty() && f - natural.back() < 1e-9 * f;  // of a double eigenvalue
    if (modes.elastic(i) && f >= low && f <= high && !again) natural.push_back(f);
  }
  if (*wanted.near_modes == 0) {
    if (natural.empty())
      throw Factorization::SolverError{
          fmt::format("no natural frequency lies between {:.6g} and {:.6g}: FSPACE 3 leaves no frequency for the "
                      "response; widen FMIN to FMAX, or write FSPACE 0",
                      low, high)};
    return natural;
  }
  std::vector<double> marks = natural;
  if (marks.empty() || marks.front() > low) marks.insert(marks.begin(), low);
  if (marks.back() < high) marks.push_back(high);
  const std::size_t intervals = marks.size() - 1;
  if (at(*wanted.near_modes) < marks.size())
    throw Factorization::SolverError{
        fmt::format("{} frequencies are asked for at {} natural ones (FSPACE 2): raise NFREQ to {} at least",
                    *wanted.near_modes, natural.size(), marks.size())};
  const std::size_t inner = at(*wanted.near_modes) - marks.size();
  std::vector<double> f;
  for (std::size_t j = 0; j < intervals; ++j) {
    const std::size_t n = inner / intervals + (j < inner % intervals ? 1 : 0);
    const double half = 0.5 * (marks[j + 1] - marks[j]);
    f.push_back(marks[j]);
    for (std::size_t i = 1; i <= n; ++i)
      f.push_back(marks[j] + half -
                  half * std::cos(std::numbers::pi * static_cast<double>(i) / static_cast<double>(n + 1)));
  }
  f.push_back(marks.back());
  return f;
}

}  // namespace nugget::nvh
