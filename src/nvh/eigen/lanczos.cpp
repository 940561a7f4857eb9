// SPDX-License-Identifier: Apache-2.0
#include "nvh/eigen/lanczos.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <thread>
#include <utility>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "nvh/eigen/followed_calls.hpp"
#include "nvh/eigen/kept_memory.hpp"
#include "nvh/eigen/shift_invert.hpp"
#include "nvh/matrices/dense.hpp"
#include "nvh/matrices/mumps.hpp"

namespace nugget::nvh {
namespace {

constexpr double tolerance = 1e-7;

/// The growing basis V, orthonormal in M, and the projection T = V^t M A^-1 M V.
class Basis {
 public:
  Basis(const ShiftInvert& a, std::size_t most) : a_(a), v_(a.rows(), 0), t_(most, most) {
    v_.value.reserve(a.rows() * most);  // memory is not touched before it is used
  }

  std::size_t size() const { return size_; }
  /// Makes w, A^-1 M times the last block, orthonormal to the basis and in itself, in the inner product of M, and drops
  /// directions that are dependent. R and H with w_before = V H + w R, and M w.
  struct Orthonormal {
    Columns h, r, mass;
  };
  void orthonormalize(Columns& w, Orthonormal& o) {
    o.h = Columns(size_, w.count);
    o.r = Columns(w.count, w.count);
    o.mass.reshape(w.rows, w.count);
    for (std::size_t i = 0; i < w.count; ++i) o.r[i][i] = 1.0;
    // First what the recurrence knows of, then the whole basis against round-off.
    for (const std::size_t first : {coupled_, std::size_t{0}}) {
      a_.multiply_mass(w, o.mass);
      Columns h = inner(v_, size_ - first, o.mass, first);
      a_.add_up(h);
      add_product(-1.0, v_, size_ - first, h, 1.0, w, first);
      for (std::size_t j = 0; j < o.r.count; ++j)
        for (std::size_t k = 0; k < h.count; ++k)
          for (std::size_t i = 0; i < h.rows; ++i) o.h[j][first + i] += h[k][i] * o.r[j][k];
      scale(w, o);
    }
    a_.multiply_mass(w, o.mass);
  }
  void append(const Columns& w) {
    v_.value.insert(v_.value.end(), w.value.begin(), w.value.end());
    v_.count += w.count;
    coupled_ = std::exchange(last_, size_);
    size_ += w.count;
  }
  /// Column block of T from `first` on, and by symmetry its rows.
  void project(std::size_t first, const Columns& h) {
    for (std::size_t j = 0; j < h.count; ++j)
      for (std::size_t i = 0; i < h.rows; ++i) t_[first + j][i] = t_[i][first + j] = h[j][i];
  }
  /// Eigenpairs of T.
  std::vector<double> ritz(Columns& y) const {
    y = Columns(size_, size_);
    for (std::size_t j = 0; j < size_; ++j)
      for (std::size_t i = 0; i < size_; ++i) y[j][i] = 0.5 * (t_[j][i] + t_[i][j]);
    return eigenvalues(y);
  }
  Columns vectors(const Columns& y) const {
    Columns x(v_.rows, y.count);
    add_product(1.0, v_, size_, y, 0.0, x);
    return x;
  }
  /// Keeps the Ritz vectors y with their values.
  void restart(const Columns& y, const std::vector<double>& theta) {
    Columns x = vectors(y);
    v_.value.assign(x.value.begin(), x.value.end());
    v_.count = size_ = y.count;
    last_ = 0;
    std::fill(t_.value.begin(), t_.value.end(), 0.0);
    for (std::size_t i = 0; i < size_; ++i) t_[i][i] = theta[i];
  }

 private:
  /// Orthonormal in itself: w := w G D^-1/2 with w^t M w = G D G^t, so w_before = w_after (D^1/2 G^t); the largest
  /// first.
  void scale(Columns& w, Orthonormal& o) {
    if (w.count == 0) return;
    a_.multiply_mass(w, o.mass);
    Columns g = inner(w, w.count, o.mass);
    a_.add_up(g);
    const std::vector<double> d = eigenvalues(g);
    const double least = 1e-28 * std::max(d.back(), 1e-300);
    std::vector<std::size_t> kept;
    for (std::size_t i = d.size(); i-- > 0;)
      if (d[i] > least) kept.push_back(i);
    Columns turn(w.count, kept.size()), back(kept.size(), w.count);
    for (std::size_t k = 0; k < kept.size(); ++k)
      for (std::size_t i = 0; i < w.count; ++i) {
        turn[k][i] = g[kept[k]][i] / std::sqrt(d[kept[k]]);
        back[i][k] = g[kept[k]][i] * std::sqrt(d[kept[k]]);
      }
    Columns r(kept.size(), o.r.count);
    turned_.reshape(w.rows, kept.size());
    add_product(1.0, w, w.count, turn, 0.0, turned_);
    add_product(1.0, back, back.count, o.r, 0.0, r);
    std::swap(w, turned_);
    o.r = std::move(r);
    o.mass.reshape(w.rows, w.count);
  }

  /// As `diagonalize`: what follows depends on it, so that all ranks take that of the first.
  std::vector<double> eigenvalues(Columns& y) const {
    std::vector<double> d = diagonalize(y);
    a_.agree(d);
    a_.agree(y.value);
    return d;
  }

  const ShiftInvert& a_;
  Columns v_, t_;
  std::size_t size_ = 0;
  Columns turned_;                      ///< room for a block: memory that is new costs as much as what is done with it
  std::size_t last_ = 0, coupled_ = 0;  ///< where the last block begins, and that before: A^-1 M of the last needs both
};

/// The same numbers on every machine, of columns of `size` rows of which x has those from `first` on.
void fill_at_random(Columns& x, std::size_t size, std::size_t first) {
  std::uint64_t s = 0x9e3779b97f4a7c15u;
  for (std::size_t j = 0; j < x.count; ++j)
    for (std::size_t i = 0; i < size; ++i) {
      s ^= s << 13;
      s ^= s >> 7;
      s ^= s << 17;
      if (i >= first && i < first + x.rows) x[j][i - first] = static_cast<double>(s >> 11) * 0x1p-53 - 0.5;
    }
}

struct Ritz {
  std::vector<std::size_t> order;  ///< by |theta|, the largest first
  std::vector<double> theta;
  Columns y;
  std::vector<double> residual;  ///< relative to theta
};

Ritz ritz_pairs(const Basis& basis, const Columns& r) {
  Ritz p;
  p.theta = basis.ritz(p.y);
  p.order.resize(p.theta.size());
  std::iota(p.order.begin(), p.order.end(), std::size_t{0});
  std::sort(p.order.begin(), p.order.end(),
            [&](std::size_t a, std::size_t b) { return std::abs(p.theta[a]) > std::abs(p.theta[b]); });
  // A^-1 M V y - theta V y = w (r y_last): its length in M is that of r y_last.
  const std::size_t first = basis.size() - r.count;
  for (std::size_t j = 0; j < p.theta.size(); ++j) {
    double square = 0.0;
    for (std::size_t i = 0; i < r.rows; ++i) {
      double sum = 0.0;
      for (std::size_t k = 0; k < r.count; ++k) sum += r[k][i] * p.y[j][first + k];
      square += sum * sum;
    }
    p.residual.push_back(std::sqrt(square) / std::max(std::abs(p.theta[j]), 1e-300));
  }
  return p;
}

Columns chosen(const Columns& y, const std::vector<std::size_t>& order, std::size_t count) {
  Columns c(y.rows, count);
  for (std::size_t j = 0; j < count; ++j) std::copy(y[order[j]].begin(), y[order[j]].end(), c[j].begin());
  return c;
}

/// Whether so many pairs can have converged in a basis of this size, so that they are worth being computed: that costs
/// the third power of it.
bool worth_a_look(std::size_t size, std::size_t want) {
  return size >= want + want / 2 && (want < 64 || size / 8 % 3 == 0);
}

/// The pairs, of whose vectors this rank has its rows.
Eigenpairs find_pairs(const ShiftInvert& a, const NearestPairs& wanted, const std::function<void(int)>& progress) {
  const std::size_t n = a.size();
  std::size_t want = std::min(wanted.count, n);
  const std::size_t width = std::min<std::size_t>({n, 8, std::max<std::size_t>(want, 2)});
  // Pairs that are wanted on one side of the shift may lie behind others that are nearer.
  const std::size_t sides = wanted.below + wanted.above;
  const std::size_t most_wanted = sides > 0 ? std::min(n, 2 * std::max(want, sides)) : want;
  const auto room = [&](std::size_t pairs) {  // restarts cost solutions
    return std::min(n, (sides > 0 ? 3 : 2) * pairs + 8 * width);
  };
  Basis basis(a, room(most_wanted) + width);  // all at once: a basis that moves needs its memory twice
  const KeptMemory kept;                      // not for the basis: its pages go back at the end
  Eigenpairs found;

  Columns w(a.rows(), width);
  fill_at_random(w, n, a.first_row());
  Basis::Orthonormal o;
  const auto apply = [&] {  // w := A^-1 (M w)
    std::swap(w, o.mass);
    a.solve(w);
    found.solves += static_cast<int>(w.count);
  };
  o.mass.reshape(a.rows(), width);
  a.multiply_mass(w, o.mass);
  apply();
  basis.orthonormalize(w, o);
  Ritz p;
  const auto lambda = [&](std::size_t i) { return 1.0 / p.theta[i] - a.shift(); };
  for (int restarts = 0;;) {
    const std::size_t first = basis.size();
    basis.append(w);
    apply();
    basis.orthonormalize(w, o);
    basis.project(first, o.h);
    const bool exhausted = w.count == 0 || basis.size() >= n, full = basis.size() + w.count > room(want);
    if (!exhausted && !full && !worth_a_look(basis.size(), want)) continue;
    p = ritz_pairs(basis, o.r);
    std::size_t converged = 0;
    while (converged < std::min(want, p.order.size()) && p.residual[p.order[converged]] < tolerance) ++converged;
    if (progress) progress(static_cast<int>(converged));
    if (exhausted) break;
    if (converged == want) {
      std::size_t below = 0, above = 0;
      for (std::size_t k = 0; k < want; ++k) {
        const double value = lambda(p.order[k]);
        if (value > -a.shift())
          ++above;
        else if (value > wanted.low)
          ++below;
      }
      if ((below >= wanted.below && above >= wanted.above) || want == most_wanted) break;
      want = std::min(want + width, most_wanted);
    }
    if (full) {
      if (++restarts > 60) {
        found.converged = false;
        break;
      }
      const std::size_t keep = std::min(p.order.size(), want + 2 * width);
      std::vector<double> theta;
      for (std::size_t j = 0; j < keep; ++j) theta.push_back(p.theta[p.order[j]]);
      basis.restart(chosen(p.y, p.order, keep), theta);
    }
  }
  p.order.resize(std::min(want, p.order.size()));
  std::sort(p.order.begin(), p.order.end(), [&](std::size_t i, std::size_t j) { return lambda(i) < lambda(j); });
  found.vector = basis.vectors(chosen(p.y, p.order, p.order.size()));
  for (const std::size_t i : p.order) found.value.push_back(lambda(i));
  return found;
}

/// What all ranks must know to search together.
struct Search {
  NearestPairs wanted;
  int threads = 1;
};

/// The rank's part in a search: all pairs on the first, nothing on the others.
Eigenpairs find_together(MumpsPart<double>& part, Search search, const std::function<void(int)>& progress) {
  Ranks& ranks = part.with_ranks();
  broadcast(ranks, search);
  if (ranks.rank() > 0) set_threads(std::min(search.threads, static_cast<int>(std::thread::hardware_concurrency())));
  Eigenpairs p = find_pairs(SharedShiftInvert(part), search.wanted, progress);
  p.vector = gather_rows(ranks, part.shares(), std::move(p.vector));
  return p;
}

}  // namespace

Eigenpairs nearest(const Matrices& m, const Factorization& a, const NearestPairs& wanted,
                   const std::function<void(int)>& progress) {
  if (ranks() == 1) return find_pairs(WholeShiftInvert(m, a), wanted, progress);
  Eigenpairs p;
  a.mumps().together(SolverCall::Kind::eigenpairs, 0, [&](MumpsPart<double>& part) {
    p = find_together(part, {wanted, threads()}, progress);
  });
  return p;
}

void follow_calls(Ranks& ranks, const std::function<SolverCall()>& next) {
  MumpsParts parts(ranks);
  for (SolverCall call = next(); call.kind != SolverCall::Kind::end; call = next()) {
    if (call.kind != SolverCall::Kind::eigenpairs) {
      parts.answer(call);
      continue;
    }
    try {
      find_together(parts.real(call.instance), {}, {});
    } catch (const Factorization::SolverError&) {  // the first rank has it, too
    }
  }
}

}  // namespace nugget::nvh
