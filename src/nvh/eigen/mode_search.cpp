// SPDX-License-Identifier: Apache-2.0
#include "nvh/eigen/mode_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/index.hpp"
#include "nvh/eigen/mode_slices.hpp"

namespace nugget::nvh {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// Pairs inside an interval, the nearest to a place first.
struct Nearest {
  Eigenpairs pairs;
  std::vector<std::size_t> order;
  std::vector<double> distance;
  std::size_t end = 0;  ///< behind the wanted ones, and those that form a cluster with the last of them
  bool apart = false;   ///< whether a gap follows

  Nearest(Eigenpairs found, double place, double low, double high, std::size_t wanted) : pairs(std::move(found)) {
    for (std::size_t i = 0; i < pairs.value.size(); ++i)
      if (pairs.value[i] >= low && pairs.value[i] <= high) order.push_back(i);
    const auto away = [&](std::size_t i) { return std::abs(pairs.value[i] - place); };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return away(a) < away(b); });
    for (const std::size_t i : order) distance.push_back(away(i));
    end = std::min(wanted, order.size());
    constexpr double gap = 1e-6;
    while (end > 0 && end < order.size() && distance[end] - distance[end - 1] < gap * distance[end]) ++end;
    apart = end < order.size();
  }
  /// Where to count: in the gap.
  double radius() const { return apart ? 0.5 * (distance[end - 1] + distance[end]) : 1.001 * distance[end - 1]; }
};

/// The first `count` of a list of pairs, in ascending order; in place, since vectors are large.
Eigenpairs ascending(Nearest n, std::size_t count) {
  n.order.resize(count);
  std::ranges::sort(n.order);
  Eigenpairs p = std::move(n.pairs);
  for (std::size_t j = 0; j < count; ++j) {
    p.value[j] = p.value[n.order[j]];
    if (n.order[j] != j) std::ranges::copy(p.vector[n.order[j]], p.vector[j].begin());
  }
  p.value.resize(count);
  p.vector.value.resize(p.vector.rows * count);
  p.vector.count = count;
  return p;
}

void refuse_negative(std::ptrdiff_t count) {
  if (count > 0)
    throw Factorization::SolverError{fmt::format(
        "{} eigenvalues are negative: the structure is not stable, it buckles or has negative stiffness", count)};
}

/// Of pairs found from a place below zero: those of rigid motions are round-off, which lies above `limit`.
void refuse_negative(const Eigenpairs& found, double limit) {
  refuse_negative(std::ranges::count_if(found.value, [&](double v) { return v < limit; }));
}

/// How far round-off in K moves eigenvalues that are zero: a share of the stiffest translation's k/m.
double round_off_of_zeros(const Matrices& m) {
  double most = 0.0;
  for (std::size_t i = 0; i < m.size(); ++i)
    if (m.mass.diagonal(i) > 0.0 && !m.equations.is_rotation(static_cast<int>(i)))
      most = std::max(most, m.stiffness.diagonal(i) / m.mass.diagonal(i));
  return 1e-15 * most;
}

/// The pairs nearest to `start`, where `shifts` stand; `take` of them at first, more where no gap shows behind them.
Eigenpairs find_around(Shifts& shifts, const Spectrum& s, const Counted& start, double limit, std::size_t take,
                       Modes::Proof& proof) {
  const double place = start.place;
  const int left = start.below - s.before;
  const std::size_t all = shifts.matrices().size();
  for (;;) {
    take = std::min(take, all);
    Nearest found(shifts.nearest({.count = take}, 0, take), place, s.low, s.high, s.wanted);
    const bool known = found.apart || found.end == at(s.inside), more = found.pairs.value.size() == take && take < all;
    if (!known && more && found.pairs.converged) {
      take += found.order.size() < s.wanted ? take : 4;
      continue;
    }
    if (place < 0.0) refuse_negative(found.pairs, limit);
    proof.found = static_cast<int>(found.end);
    if (found.end > 0 && found.end < at(s.inside)) {
      double from = place - found.radius(), to = place + found.radius();
      const int first = from <= s.low || left <= 0 ? s.before : shifts.below(from);
      const int last = to >= s.high ? s.before + s.inside : shifts.below(to);
      proof = {frequency_of(std::max(from, std::max(s.low, 0.0))), frequency_of(std::min(to, s.high)), last - first,
               static_cast<int>(found.end)};
    }
    const std::size_t count = std::min(s.wanted, found.end);
    return ascending(std::move(found), count);
  }
}

}  // namespace

double frequency_of(double eigenvalue) {
  return std::sqrt(std::max(0.0, eigenvalue)) / two_pi;
}

double eigenvalue_of(double frequency) {
  return two_pi * frequency * two_pi * frequency;
}

Eigenpairs search_modes(const Matrices& m, const ModeRequest& r, const ProgressCallback& progress, Modes& modes) {
  Shifts shifts(m, progress, modes);
  const double infinity = std::numeric_limits<double>::infinity();
  Spectrum s{r.low > 0.0 ? eigenvalue_of(r.low) : -infinity, std::isfinite(r.high) ? eigenvalue_of(r.high) : infinity};
  const int up_to = std::isfinite(s.high) ? shifts.below(s.high) : static_cast<int>(m.size());
  s.before = r.low > 0.0 ? shifts.below(s.low) : 0;
  s.inside = up_to - s.before;
  modes.proof = {std::max(r.low, 0.0), r.high, s.inside, 0};
  if (s.inside <= 0) return {};
  s.wanted = r.count > 0 ? std::min(at(r.count), at(s.inside)) : at(s.inside);
  // From the lower end one shift finds most.
  const std::size_t from_one = (s.before == 0 ? 5 : 3) * r.slice / 2;
  const bool in_slices = r.centre <= 0.0 && s.wanted > from_one && m.size() > 4 * s.wanted;
  const bool interval = r.centre <= 0.0 && s.whole();

  Counted start{r.centre > 0.0                                                   ? eigenvalue_of(r.centre)
                : !in_slices && interval && r.low > 0.0 && std::isfinite(s.high) ? 0.5 * (s.low + s.high)
                : r.low > 0.0                                                    ? s.low
                                                                                 : -small_shift(m),
                s.before};
  if (start.place != s.low) start.below = shifts.below(start.place);
  double limit = 0.0;
  if (start.place < 0.0) {
    // Of free structures that are slender and fine at once rigid motions may lie far from zero, and below the shift.
    const double round_off = round_off_of_zeros(m);
    if (start.below > 0 && -10.0 * round_off < start.place) {
      start.place = -10.0 * round_off;
      start.below = shifts.below(start.place);
    }
    refuse_negative(start.below);
    limit = std::min(1e-3 * start.place, -round_off);
  }
  if (in_slices) {
    Eigenpairs found = find_in_slices(shifts, s, start, r.slice, modes.proof);
    if (start.place < 0.0) refuse_negative(found, limit);
    return found;
  }
  // One more than wanted shows the gap; where there are pairs on both sides, as many again.
  std::size_t take = s.wanted;
  if (start.place < 0.0 && !s.whole()) ++take;
  const int left = start.below - s.before;
  if (start.place > 0.0 && !interval) take += 1 + (left <= 0 || left >= s.inside ? 0 : s.wanted);
  return find_around(shifts, s, start, limit, take, modes.proof);
}

}  // namespace nugget::nvh
