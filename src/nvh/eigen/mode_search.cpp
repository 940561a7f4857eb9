// SPDX-License-Identifier: Apache-2.0
#include "nvh/eigen/mode_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "base/index.hpp"

namespace nugget::nvh {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

double squared(double frequency) {
  return two_pi * frequency * two_pi * frequency;
}

/// One factorization after the other; the next takes the place of the last.
class Shifts {
 public:
  Shifts(const Matrices& m, const ProgressCallback& progress, Modes& modes)
      : m_(m), progress_(progress), modes_(modes) {}

  /// Factors K - lambda M; the number of eigenvalues below. Moves lambda a little where it hits an eigenvalue.
  int below(double& lambda) {
    progress(fmt::format("factorization {} of {} equations", modes_.cost.factorizations + 1, m_.size()));
    for (double nudge = 1e-7;; nudge *= 10.0) {
      try {
        if (factor_)
          factor_->shift_to(-lambda);
        else
          factor_.emplace(m_, -lambda);
        ++modes_.cost.factorizations;
        modes_.cost.factor_seconds += factor_->cost().seconds;
        modes_.cost.factor_entries = factor_->cost().entries;
        modes_.cost.most_memory = factor_->cost().most_memory;
        modes_.cost.memory = factor_->cost().memory;
        return factor_->negative();
      } catch (const Factorization::SolverError&) {
        if (lambda <= 0.0 || nudge > 1e-4) throw;
        lambda *= 1.0 + nudge;
      }
    }
  }
  /// The pairs nearest to the last place.
  Eigenpairs nearest(std::size_t count) {
    const auto begin = std::chrono::steady_clock::now();
    Eigenpairs p = nvh::nearest(m_, *factor_, static_cast<int>(count),
                                [&](int done) { progress(fmt::format("{} of {} modes", done, count)); });
    modes_.cost.lanczos_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    modes_.cost.solves += p.solves;
    return p;
  }

 private:
  void progress(const std::string& text) const {
    if (progress_) progress_(text);
  }
  const Matrices& m_;
  const ProgressCallback& progress_;
  Modes& modes_;
  std::optional<Factorization> factor_;
};

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
  double dof_map() const { return apart ? 0.5 * (distance[end - 1] + distance[end]) : 1.001 * distance[end - 1]; }
};

/// The first `count` of a list of pairs, in ascending order.
Eigenpairs ascending(const Nearest& n, std::size_t count) {
  std::vector<std::size_t> chosen(n.order.begin(), n.order.begin() + static_cast<std::ptrdiff_t>(count));
  std::sort(chosen.begin(), chosen.end());
  Eigenpairs p;
  p.vector = Columns(n.pairs.vector.rows, count);
  for (std::size_t j = 0; j < count; ++j) {
    p.value.push_back(n.pairs.value[chosen[j]]);
    std::ranges::copy(n.pairs.vector[chosen[j]], p.vector[j].begin());
  }
  return p;
}

void refuse_negative(std::ptrdiff_t count) {
  if (count > 0)
    throw Factorization::SolverError{fmt::format(
        "{} eigenvalues are negative: the structure is not stable, it buckles or has negative stiffness", count)};
}

}  // namespace

double frequency_of(double eigenvalue) {
  return std::sqrt(std::max(0.0, eigenvalue)) / two_pi;
}

Eigenpairs search_modes(const Matrices& m, const ModeRequest& r, const ProgressCallback& progress, Modes& modes) {
  Shifts shifts(m, progress, modes);
  const std::size_t all = m.size();
  double low = r.low > 0.0 ? squared(r.low) : -std::numeric_limits<double>::infinity();
  double high = std::isfinite(r.high) ? squared(r.high) : std::numeric_limits<double>::infinity();
  const int up_to = std::isfinite(high) ? shifts.below(high) : static_cast<int>(all);
  const int before = r.low > 0.0 ? shifts.below(low) : 0;
  const int inside = up_to - before;
  modes.proof = {std::max(r.low, 0.0), r.high, inside, 0};
  if (inside <= 0) return {};
  const std::size_t wanted = r.count > 0 ? std::min(at(r.count), at(inside)) : at(inside);
  const bool whole = wanted == at(inside);  // interval

  double place = r.centre > 0.0                                ? squared(r.centre)
                 : whole && r.low > 0.0 && std::isfinite(high) ? 0.5 * (low + high)
                 : r.low > 0.0                                 ? low
                                                               : -small_shift(m);
  const int left = place == low ? 0 : shifts.below(place) - before;  // between the lower end and the place
  if (place < 0.0) refuse_negative(left);
  // One more than wanted shows the gap; where there are pairs on both sides, as many again.
  std::size_t take = wanted;
  if (place < 0.0 && !whole) ++take;
  if (place > 0.0 && !(whole && r.centre <= 0.0)) take += 1 + (left <= 0 || left >= inside ? 0 : wanted);
  for (;;) {
    take = std::min(take, all);
    const Nearest found(shifts.nearest(take), place, low, high, wanted);
    const bool known = found.apart || found.end == at(inside), more = found.pairs.value.size() == take && take < all;
    if (!known && more && found.pairs.converged) {
      take += found.order.size() < wanted ? take : 4;
      continue;
    }
    if (place < 0.0)  // those of rigid motions are round-off
      refuse_negative(std::ranges::count_if(found.pairs.value, [&](double v) { return v < 1e-3 * place; }));
    modes.proof.found = static_cast<int>(found.end);
    if (found.end > 0 && found.end < at(inside)) {
      double from = place - found.dof_map(), to = place + found.dof_map();
      const int first = from <= low || left <= 0 ? before : shifts.below(from);
      const int last = to >= high ? before + inside : shifts.below(to);
      modes.proof = {frequency_of(std::max(from, std::max(low, 0.0))), frequency_of(std::min(to, high)), last - first,
                     static_cast<int>(found.end)};
    }
    return ascending(found, std::min(wanted, found.end));
  }
}

}  // namespace nugget::nvh
