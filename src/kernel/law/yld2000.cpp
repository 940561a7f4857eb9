// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/yld2000.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "base/index.hpp"

namespace nugget::kernel {
namespace {

using Values = std::array<double, 8>;

/// Effective stresses of the tests' stresses; of the ratios r/(1 + r), which stay within bounds; work of the flow on
/// the tangent.
Values values_of(const Yld2000& surface, const SheetTests& tests) {
  Values v;
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = 0.25 * std::numbers::pi * static_cast<double>(i), r = surface.ratio(angle);
    v[i] = tests.stress[i] / surface.stress(angle);
    v[3 + i] = r / (1.0 + r);
  }
  const SurfaceAt<double> at = Yld2000Surface(surface)(tests.point);
  const PlaneStress<double>& d = tests.tangent;
  v[6] = at.effective;
  v[7] = (at.flow.aa * d.aa + at.flow.bb * d.bb + at.flow.ab * d.ab) / std::hypot(d.aa, d.bb, d.ab);
  return v;
}
/// What they must be.
Values wanted_of(const SheetTests& tests) {
  const auto share = [&](std::size_t i) { return tests.ratio[i] / (1.0 + tests.ratio[i]); };
  return {1.0, 1.0, 1.0, share(0), share(1), share(2), 1.0, 0.0};
}

double off_by(const Values& a, const Values& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

/// x of A x = b by elimination; false: A has no inverse.
bool solve_equations(std::array<Values, 8> a, Values b, Values& x) {
  for (std::size_t i = 0; i < 8; ++i) {
    std::size_t pivot = i;
    for (std::size_t j = i; j < 8; ++j)
      if (std::abs(a[j][i]) > std::abs(a[pivot][i])) pivot = j;
    if (!(std::abs(a[pivot][i]) > 1e-12)) return false;
    std::swap(a[i], a[pivot]);
    std::swap(b[i], b[pivot]);
    for (std::size_t j = i + 1; j < 8; ++j) {
      const double share = a[j][i] / a[i][i];
      for (std::size_t k = i; k < 8; ++k) a[j][k] -= share * a[i][k];
      b[j] -= share * b[i];
    }
  }
  for (std::size_t i = 8; i-- > 0;) {
    x[i] = b[i];
    for (std::size_t k = i + 1; k < 8; ++k) x[i] -= a[i][k] * x[k];
    x[i] /= a[i][i];
  }
  return true;
}

}  // namespace

double Yld2000::stress(double angle) const {
  const double c = std::cos(angle), s = std::sin(angle);
  return 1.0 / Yld2000Surface(*this)(PlaneStress<double>{c * c, s * s, c * s}).effective;
}

double Yld2000::ratio(double angle) const {
  const double c = std::cos(angle), s = std::sin(angle);
  const PlaneStress<double> flow = Yld2000Surface(*this)(PlaneStress<double>{c * c, s * s, c * s}).flow;
  return (s * s * flow.aa + c * c * flow.bb - c * s * flow.ab) / -(flow.aa + flow.bb);
}

std::optional<Yld2000> Yld2000::from_tests(double m, const SheetTests& tests) {
  constexpr double close = 1e-12;
  Yld2000 found{.m = m};
  const Values start = values_of(found, tests), wanted = wanted_of(tests);
  // From the isotropic sheet to this one by steps, each by Newton's method on differences.
  double done = 0.0;
  for (double step = 1.0; done < 1.0 && step > 1e-4;) {
    const double next = std::min(1.0, done + step);
    Values goal;
    for (std::size_t i = 0; i < 8; ++i) goal[i] = start[i] + next * (wanted[i] - start[i]);
    Yld2000 tried = found;
    double off = off_by(values_of(tried, tests), goal);
    for (int n = 0; n < 60 && off > close; ++n) {
      const Values now = values_of(tried, tests);
      std::array<Values, 8> slopes;
      for (std::size_t k = 0; k < 8; ++k) {
        constexpr double h = 1e-6;
        Yld2000 up = tried, down = tried;
        up.alpha[k] += h;
        down.alpha[k] -= h;
        const Values a = values_of(up, tests), b = values_of(down, tests);
        for (std::size_t i = 0; i < 8; ++i) slopes[i][k] = (a[i] - b[i]) / (2.0 * h);
      }
      Values missing, change;
      for (std::size_t i = 0; i < 8; ++i) missing[i] = goal[i] - now[i];
      if (!solve_equations(slopes, missing, change)) break;
      double part = 1.0, after = off;
      Yld2000 moved = tried;
      for (int halved = 0; halved < 20; ++halved, part *= 0.5) {
        for (std::size_t k = 0; k < 8; ++k) moved.alpha[k] = tried.alpha[k] + part * change[k];
        after = off_by(values_of(moved, tests), goal);
        if (after < off) break;
      }
      if (!(after < off)) break;
      tried = moved;
      off = after;
    }
    if (off > 1e-9) {
      step *= 0.5;
      continue;
    }
    found = tried;
    done = next;
  }
  return done < 1.0 ? std::nullopt : std::optional(found);
}

}  // namespace nugget::kernel
