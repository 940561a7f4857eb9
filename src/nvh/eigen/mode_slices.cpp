// SPDX-License-Identifier: Apache-2.0
#include "nvh/eigen/mode_slices.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "nvh/eigen/mode_search.hpp"
#include "nvh/matrices/dense.hpp"

namespace nugget::nvh {
namespace {

/// Pairs that are known: all between the lower end of the spectrum and `cut`, which lies in a gap.
class Known {
 public:
  Known(const Matrices& m, const Spectrum& s) : m_(m), cut_(s.low), below_cut_(s.before) {
    pairs_.vector = Columns(m.size(), 0);
    pairs_.vector.value.reserve(m.size() * (s.wanted + 1));  // memory is not touched before it is used
  }
  std::size_t size() const { return pairs_.value.size(); }
  double cut() const { return cut_; }
  int below_cut() const { return below_cut_; }
  const std::vector<double>& values() const { return pairs_.value; }

  /// What is known only up to a lower cut.
  void forget_above(const Counted& lower) {
    while (!pairs_.value.empty() && pairs_.value.back() > lower.place) pairs_.value.pop_back();
    resize();
    cut_ = lower.place, below_cut_ = lower.below;
  }
  /// Columns `first` to `last` of p, ascending, above the cut; from now on all below the new cut are known.
  void append(const Eigenpairs& p, std::size_t first, std::size_t last, double cut) {
    if (first < last) {
      Columns x(m_.size(), last - first);
      for (std::size_t j = first; j < last; ++j) std::ranges::copy(p.vector[j], x[j - first].begin());
      make_orthogonal(x);
      pairs_.value.insert(pairs_.value.end(), p.value.begin() + static_cast<std::ptrdiff_t>(first),
                          p.value.begin() + static_cast<std::ptrdiff_t>(last));
      pairs_.vector.value.insert(pairs_.vector.value.end(), x.value.begin(), x.value.end());
      pairs_.vector.count = pairs_.value.size();
    }
    cut_ = cut, below_cut_ += static_cast<int>(last - first);
  }
  /// The lowest `count` of them.
  Eigenpairs take(std::size_t count) {
    pairs_.value.resize(std::min(count, pairs_.value.size()));
    resize();
    return std::move(pairs_);
  }

 private:
  void resize() {
    pairs_.vector.count = pairs_.value.size();
    pairs_.vector.value.resize(m_.size() * pairs_.value.size());
  }
  /// Lanczos of two shifts leaves vectors that are orthogonal as far as they are exact; those on both sides of a cut
  /// are made so.
  void make_orthogonal(Columns& x) const {
    constexpr std::size_t near = 64;
    const std::size_t count = std::min(size(), near), first = size() - count;
    Columns mass(x.rows, x.count);
    if (count > 0) {
      multiply(m_.mass, x, mass);
      add_product(-1.0, pairs_.vector, count, inner(pairs_.vector, count, mass, first), 1.0, x, first);
    }
    multiply(m_.mass, x, mass);
    for (std::size_t j = 0; j < x.count; ++j) {
      double square = 0.0;
      for (std::size_t i = 0; i < x.rows; ++i) square += x[j][i] * mass[j][i];
      for (double& v : x[j]) v /= std::sqrt(square);
    }
  }

  const Matrices& m_;
  Eigenpairs pairs_;
  double cut_;
  int below_cut_;
};

/// Behind which of the pairs from `first` on a gap follows, the last one; `first` where there is none.
std::size_t last_gap(const std::vector<double>& value, std::size_t first, double place) {
  constexpr double gap = 1e-6;
  for (std::size_t k = value.size(); k-- > first + 1;)
    if (value[k] - value[k - 1] > gap * std::abs(value[k] - place)) return k;
  return first;
}

/// Where the next shift goes: so far above the cut that `ahead` pairs lie between, as they lie below.
double next_place(const Known& known, const Eigenpairs& last, double ahead) {
  const std::vector<double>& value = known.values();
  const double up_to = frequency_of(std::max(known.cut(), value.empty() ? 0.0 : value.back()));
  const std::size_t back = std::min<std::size_t>(value.size(), 64);
  double each =
      back > 1 ? (frequency_of(value.back()) - frequency_of(value[value.size() - back])) / static_cast<double>(back - 1)
               : 0.0;
  if (!last.value.empty())  // rigid motions lie all at one place
    each = std::max(each, frequency_of(last.value.back()) / static_cast<double>(value.size() + last.value.size()));
  return eigenvalue_of(up_to + ahead * each);
}

/// How many pairs a shift is worth: as many as there is memory for, counted in vectors. The last shift, of `slice`
/// pairs, needs all that are wanted and four times a slice, for basis and pairs of Lanczos; so much may each of them
/// take.
class SliceSizes {
 public:
  SliceSizes(std::size_t wanted, std::size_t slice) : wanted_(wanted), slice_(slice), room_(wanted + 4 * slice) {}
  /// At the lower end of the spectrum, where a pair takes some two vectors of the basis.
  std::size_t lowest() const {
    return whole(std::max(slice_, (room_ - std::min(room_, std::size_t{64})) / 3), wanted_);
  }
  /// In the middle, where it takes three.
  std::size_t next(std::size_t known) const {
    return whole(std::max(slice_, (room_ - std::min(room_, known)) / 4), wanted_ - known);
  }

 private:
  /// All that is left where it is not much more: another shift costs some hundred vectors of its own.
  static std::size_t whole(std::size_t size, std::size_t left) { return left <= size + size / 4 ? left : size; }

  std::size_t wanted_, slice_, room_;
};

}  // namespace

Eigenpairs find_in_slices(Shifts& shifts, const Spectrum& s, Counted first, std::size_t slice, Modes::Proof& proof) {
  Known known(shifts.matrices(), s);
  const auto prove = [&](const Counted& c) {
    const auto found = std::ranges::count_if(known.values(), [&](double v) { return v < c.place; });
    proof = {frequency_of(std::max(s.low, 0.0)), frequency_of(c.place), c.below - s.before, static_cast<int>(found)};
  };
  const SliceSizes sizes(s.wanted, slice);
  Counted before{s.low, s.before}, now = first;
  std::size_t behind = 3;  // pairs behind the last one, which show the gap
  std::size_t size = s.before == 0 ? sizes.lowest() : sizes.next(0), count = size;
  for (;;) {
    const std::size_t rest = s.wanted - known.size(), between = at(std::max(0, now.below - known.below_cut()));
    const bool the_last = rest <= size;
    const std::size_t above = the_last && rest > between ? rest - between + (s.whole() ? 0 : behind) : 0;
    if (the_last) count = std::max({count, between + above, std::size_t{8}});
    const Eigenpairs p = shifts.nearest({count, known.cut(), between, above}, known.size(), s.wanted);
    const auto index = [&](double place) {
      return static_cast<std::size_t>(std::ranges::lower_bound(p.value, place) - p.value.begin());
    };
    const std::size_t from = index(known.cut()), middle = std::max(from, index(now.place));
    if (!p.converged || middle - from != between) {  // one is missing: of the shift before, or between the two
      if (before.place < known.cut()) {
        known.forget_above(before);
        count = size = sizes.next(known.size());
        continue;
      }
      prove(now);
      return known.take(s.wanted);
    }
    // Those on the right are all there are as far as the last of them, which may have a twin.
    const std::size_t up_to = std::max(middle, index(s.high));
    const bool to_the_end = s.whole() && up_to - from == rest;
    const std::size_t last = to_the_end ? up_to : std::min(last_gap(p.value, middle, now.place), up_to);
    if (last == from && count < shifts.matrices().size()) {  // all at one place, as rigid motions
      count *= 2;
      behind *= 2;
      continue;
    }
    known.append(p, from, last,
                 last == middle          ? now.place
                 : last < p.value.size() ? 0.5 * (p.value[last - 1] + p.value[last])
                                         : p.value[last - 1]);
    if (known.size() >= s.wanted) break;
    // Half of what is found there lies below the next shift.
    const std::size_t left = s.wanted - known.size();
    size = sizes.next(known.size());
    const double ahead = 0.45 * static_cast<double>(std::min(size, left));
    before = now;
    now.place = std::min(next_place(known, p, ahead), s.high);
    for (int tries = 0; tries < 4; ++tries) {  // nearer where there are many more between than was expected
      now.below = shifts.below(now.place);
      const double found = now.below - known.below_cut(), cut = frequency_of(known.cut());
      if (found < 1.2 * static_cast<double>(size)) break;
      now.place = eigenvalue_of(cut + (frequency_of(now.place) - cut) * 0.45 * static_cast<double>(size) / found);
    }
    count = left > size ? size : 0;
  }
  if (at(std::max(0, now.below - s.before)) < s.wanted) {
    if (s.whole()) {
      now = {s.high, s.before + s.inside};
    } else {
      now.place = known.cut();
      now.below = shifts.below(now.place);
    }
  }
  prove(now);
  return known.take(s.wanted);
}

}  // namespace nugget::nvh
