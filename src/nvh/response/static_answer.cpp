// SPDX-License-Identifier: Apache-2.0
#include "nvh/response/static_answer.hpp"

#include <algorithm>
#include <vector>

namespace nugget::nvh {
namespace {

double product(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// From x = 0, down to this share of the first residual.
bool converge(const Matrices& m, const Factorization& shifted, std::span<const double> f, double share,
              std::span<double> x) {
  constexpr int most = 300, patience = 40;
  std::vector<double> rest(f.begin(), f.end()), force(m.size());
  Columns z(m.size(), 1), p(m.size(), 1);
  const auto precondition = [&] {
    std::copy(rest.begin(), rest.end(), z.value.begin());
    shifted.solve(z);
    return product(rest, z.value);
  };
  double now = precondition(), best = now;
  const double goal = share * now;
  p.value = z.value;
  int since_best = 0;
  for (int pass = 0; pass < most && now > goal; ++pass) {
    m.stiffness.multiply(p[0], force);
    const double work = product(p.value, force);
    if (!(work > 0.0)) return false;
    const double step = now / work;
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] += step * p.value[i];
      rest[i] -= step * force[i];
    }
    const double next = precondition();
    for (std::size_t i = 0; i < x.size(); ++i) p.value[i] = z.value[i] + next / now * p.value[i];
    now = next;
    since_best = now < 0.5 * best ? 0 : since_best + 1;
    best = std::min(best, now);
    if (since_best > patience) return false;
  }
  return now <= goal;
}

}  // namespace

bool solve_statically(const Matrices& m, const Factorization& shifted, std::span<const double> f, std::span<double> x) {
  std::fill(x.begin(), x.end(), 0.0);
  if (!converge(m, shifted, f, 1e-24, x)) return false;
  // Once more from the forces that are really missing.
  std::vector<double> rest(x.size()), more(x.size(), 0.0);
  m.stiffness.multiply(x, rest);
  for (std::size_t i = 0; i < x.size(); ++i) rest[i] = f[i] - rest[i];
  converge(m, shifted, rest, 1e-6, more);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += more[i];
  return true;
}

}  // namespace nugget::nvh
