// SPDX-License-Identifier: Apache-2.0
#include "system/constraint_map.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "system/rigid_body.hpp"

namespace nugget::system {
namespace {

using Matrix = std::array<std::array<double, 6>, 6>;

/// The matrix of b -> a x b.
std::array<std::array<double, 3>, 3> cross_matrix(const Vec3d& a) {
  return {{{0.0, -a.z, a.y}, {a.z, 0.0, -a.x}, {-a.y, a.x, 0.0}}};
}

void add_product(Matrix& sum, const Matrix& a, const Matrix& b) {
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < 6; ++k)
      for (std::size_t j = 0; j < 6; ++j) sum[i][j] += a[i][k] * b[k][j];
}

bool is_zero(const Vec3d& a) {
  return a.x == 0.0 && a.y == 0.0 && a.z == 0.0;
}

/// The velocity that an arm's end has beyond its root's, as the chord of its way over dt, and the arm at the end.
Vec3d swing(Vec3d& arm, const Vec3d& omega, double dt) {
  const Vec3d after = turned(arm, dt * omega);
  const Vec3d velocity = dt > 0.0 ? (1.0 / dt) * (after - arm) : cross(omega, arm);
  arm = after;
  return velocity;
}

}  // namespace

Vec3d turned(const Vec3d& a, const Vec3d& phi) {
  const double angle2 = dot(phi, phi);
  const double angle = std::sqrt(angle2);
  // Series where sin(angle)/angle would lose digits.
  const double s = angle > 1e-4 ? std::sin(angle) / angle : 1.0 - angle2 / 6.0;
  const double half = angle > 1e-4 ? std::sin(0.5 * angle) / angle : 0.5 - angle2 / 48.0;
  const Vec3d across = cross(phi, a);
  return a + s * across + (2.0 * half * half) * cross(phi, across);
}

/// The spin that the corners of a segment give, at one place of them.
struct ConstraintMap::Spin {
  Turn turn;
  Inertia spread{};  // J
  Vec3d n;           // of a twist

  /// From the sum of r x v to the spin that it stands for; of a twist the component along n.
  Vec3d of(const Vec3d& sum) const {
    const Vec3d omega = solve(spread, sum);
    return turn == Turn::twist ? dot(n, omega) * n : omega;
  }
  /// Transposed: from a moment to the vector that, crossed with r, is the force on a corner.
  Vec3d share(const Vec3d& moment) const { return solve(spread, turn == Turn::twist ? dot(n, moment) * n : moment); }
  /// Spin or moment without what the corners take care of.
  Vec3d rest(const Vec3d& a) const { return turn == Turn::twist ? a - dot(n, a) * n : Vec3d{}; }
};

ConstraintMap::Spin ConstraintMap::spin(const RowHead& row, std::span<const Corner> c) const {
  Spin s{row.turn, {}, {}};
  for (const Corner& corner : c) add_point(s.spread, corner.weight, 0.0, corner.arm);
  if (row.turn == Turn::twist) s.n = unit(cross(c[2].arm - c[0].arm, c[c.size() - 1].arm - c[1].arm));
  return s;
}

std::span<const ConstraintMap::Corner> ConstraintMap::corners(const RowHead& row) const {
  return {corners_.data() + row.first_corner, at(row.end_corner - row.first_corner)};
}

void ConstraintMap::add(int dependent, bool rotations, std::span<const Term> terms) {
  const int begin = static_cast<int>(terms_.size());
  terms_.insert(terms_.end(), terms.begin(), terms.end());
  rows_.push_back({dependent, rotations, begin, static_cast<int>(terms_.size())});
}

void ConstraintMap::add(int dependent, bool rotations, std::span<const Term> terms, Turn turn,
                        std::span<const Corner> corners, const Vec3d& arm) {
  add(dependent, rotations, terms);
  RowHead& row = rows_.back();
  row.turn = turn;
  row.arm = arm;
  row.first_corner = static_cast<int>(corners_.size());
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  row.end_corner = static_cast<int>(corners_.size());
  Vec3d centre{};
  double sum = 0.0;
  for (const Corner& c : corners) {
    centre += c.weight * c.arm;
    sum += c.weight;
  }
  for (int i = row.first_corner; i < row.end_corner; ++i) corners_[i].arm -= (1.0 / sum) * centre;
}

std::vector<int> ConstraintMap::sort_rows(int nodes) {
  constexpr int unknown = -1, waiting = -2;
  row_of_.assign(at(nodes), -1);
  for (std::size_t r = 0; r < rows_.size(); ++r) row_of_[rows_[r].dependent] = static_cast<int>(r);

  std::vector<int> level(rows_.size(), unknown), circular;
  const auto depth = [&](const auto& self, std::size_t r) -> int {
    if (level[r] == waiting) circular.push_back(rows_[r].dependent);
    if (level[r] != unknown) return std::max(level[r], 0);
    level[r] = waiting;
    int deepest = 0;
    const auto look_at = [&](int node) {
      const int row = row_of_[node];
      if (row >= 0) deepest = std::max(deepest, 1 + self(self, at(row)));
    };
    for (int i = rows_[r].begin; i < rows_[r].end; ++i) look_at(terms_[i].node);
    for (int i = rows_[r].first_corner; i < rows_[r].end_corner; ++i) look_at(corners_[i].node);
    return level[r] = deepest;
  };
  for (std::size_t r = 0; r < rows_.size(); ++r) depth(depth, r);

  std::vector<std::size_t> order(rows_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return level[a] < level[b]; });
  std::vector<RowHead> sorted;
  levels_.clear();
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && level[order[i]] != level[order[i - 1]]) levels_.push_back(i);
    sorted.push_back(rows_[order[i]]);
    row_of_[sorted.back().dependent] = static_cast<int>(i);
  }
  levels_.push_back(rows_.size());
  all_levels_ = levels_;
  rows_ = std::move(sorted);
  applied_.resize(rows_.size());
  std::iota(applied_.begin(), applied_.end(), 0);
  return circular;
}

void ConstraintMap::keep_to(const std::function<bool(int)>& followed) {
  std::vector<int> kept;
  std::size_t first = 0;
  for (std::size_t& last : levels_) {
    for (std::size_t i = first; i < last; ++i)
      if (followed(rows_[applied_[i]].dependent)) kept.push_back(applied_[i]);
    first = last;
    last = kept.size();
  }
  applied_ = std::move(kept);
}

void ConstraintMap::follow_all() {
  levels_ = all_levels_;
  applied_.resize(rows_.size());
  std::iota(applied_.begin(), applied_.end(), 0);
}

void ConstraintMap::carry(const std::function<bool(int)>& chosen, Parcel& parcel) {
  for (RowHead& row : rows_) {
    if (row.removed || !chosen(row.dependent)) continue;
    for (int i = row.begin; i < row.end; ++i) parcel(&terms_[i].arm, 1);
    for (int i = row.first_corner; i < row.end_corner; ++i) parcel(&corners_[i].arm, 1);
    parcel(&row.arm, 1);
  }
}

void ConstraintMap::set_weights(int dependent, std::span<const double> weights) {
  RowHead& row = rows_[row_of_[dependent]];
  Vec3d shift{};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    Corner& corner = corners_[at(row.first_corner) + i];
    corner.weight = terms_[at(row.begin) + i].weight = weights[i];
    shift += weights[i] * corner.arm;
  }
  for (int i = row.first_corner; i < row.end_corner; ++i) corners_[i].arm -= shift;
  row.arm -= shift;
}

void ConstraintMap::remove(int node) {
  rows_[row_of_[node]].removed = true;
  row_of_[node] = -1;
}

std::span<const ConstraintMap::Term> ConstraintMap::terms(int node) const {
  const RowHead& row = rows_[row_of_[node]];
  return {terms_.data() + row.begin, at(row.end - row.begin)};
}

std::span<ConstraintMap::Term> ConstraintMap::terms(int node) {
  const RowHead& row = rows_[row_of_[node]];
  return {terms_.data() + row.begin, at(row.end - row.begin)};
}

void ConstraintMap::apply_to_velocities(double dt, std::span<Row> v, std::span<Row> w) {
  std::size_t first = 0;
  for (const std::size_t last : levels_) {
    parallel_for(last - first, 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = first + begin; i < first + end; ++i)
        if (RowHead& row = rows_[applied_[i]]; !row.removed) apply_to_velocities(row, dt, v, w);
    });
    first = last;
  }
}

void ConstraintMap::apply_to_velocities(RowHead& row, double dt, std::span<Row> v, std::span<Row> w) {
  Vec3d vd{}, wd{};
  for (int i = row.begin; i < row.end; ++i) {
    Term& t = terms_[i];
    const Vec3d omega = vec(w[t.node]);
    Vec3d velocity = vec(v[t.node]);
    if (!is_zero(t.arm)) velocity += swing(t.arm, omega, dt);
    vd += t.weight * velocity;
    wd += t.weight * omega;
  }
  if (row.first_corner < row.end_corner) {
    const std::span<Corner> c(corners_.data() + row.first_corner, at(row.end_corner - row.first_corner));
    Vec3d mean{};
    double sum = 0.0;
    for (const Corner& corner : c) {
      mean += corner.weight * vec(v[corner.node]);
      sum += corner.weight;
    }
    mean = (1.0 / sum) * mean;
    const auto walk = [&](double time) {
      for (Corner& corner : c) corner.arm += time * (vec(v[corner.node]) - mean);
    };
    walk(0.5 * dt);
    Vec3d turning{};
    for (const Corner& corner : c) turning += corner.weight * cross(corner.arm, vec(v[corner.node]));
    const Spin s = spin(row, c);
    wd = s.rest(wd) + s.of(turning);
    walk(0.5 * dt);
    if (!is_zero(row.arm)) vd += swing(row.arm, wd, dt);
  }
  set(v[row.dependent], vd);
  if (row.rotations) set(w[row.dependent], wd);
}

void ConstraintMap::transfer_forces(std::span<Row> f, std::span<Row> m) const {
  for (auto r = applied_.rbegin(); r != applied_.rend(); ++r)
    if (!rows_[*r].removed) transfer_forces(rows_[*r], f, m);
}

void ConstraintMap::transfer_forces(const RowHead& row, std::span<Row> f, std::span<Row> m) const {
  const std::size_t d = at(row.dependent);
  const Vec3d force = vec(f[d]);
  Vec3d moment = row.rotations ? vec(m[d]) : Vec3d{};
  if (row.first_corner < row.end_corner) {
    moment += cross(row.arm, force);
    const Spin s = spin(row, corners(row));
    const Vec3d share = s.share(moment);
    for (const Corner& c : corners(row)) nugget::add(f[c.node], c.weight * cross(share, c.arm));
    moment = s.rest(moment);
  }
  for (int i = row.begin; i < row.end; ++i) {
    const Term& t = terms_[i];
    const std::size_t k = at(t.node);
    set(f[k], vec(f[k]) + t.weight * force);
    set(m[k], vec(m[k]) + t.weight * (moment + cross(t.arm, force)));
  }
  set(f[d], Vec3d{});
  if (row.rotations) set(m[d], Vec3d{});
}

void ConstraintMap::transfer_mass(std::span<double> mass, std::span<double> inertia, int bodies) const {
  for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
    if (row->removed || terms_[row->begin].node >= bodies) continue;
    const std::size_t d = at(row->dependent);
    for (int i = row->begin; i < row->end; ++i) {
      const Term& t = terms_[i];
      mass[t.node] += t.weight * mass[d];
      inertia[t.node] += t.weight * ((row->rotations ? inertia[d] : 0.0) + mass[d] * dot(t.arm, t.arm));
    }
    mass[d] = 0.0;
    if (row->rotations) inertia[d] = 0.0;
  }
}

std::vector<ConstraintMap::Block> ConstraintMap::blocks(int dependent) const {
  const RowHead& row = rows_[row_of_[dependent]];
  std::map<int, Matrix> direct;  // with the nodes that the row itself names
  const auto add_crossed = [](Matrix& to, std::size_t i0, std::size_t j0, double factor, const Vec3d& a) {
    const auto x = cross_matrix(a);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) to[i0 + i][j0 + j] += factor * x[i][j];
  };
  const bool turned_by_corners = row.first_corner < row.end_corner;
  const Spin s = turned_by_corners ? spin(row, corners(row)) : Spin{Turn::twist, {}, {}};
  const Vec3d axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto column = [](Matrix& to, std::size_t i0, std::size_t j, const Vec3d& a) {
    to[i0][j] += a.x;
    to[i0 + 1][j] += a.y;
    to[i0 + 2][j] += a.z;
  };
  for (int i = row.begin; i < row.end; ++i) {
    const Term& t = terms_[i];
    Matrix& b = direct[t.node];
    for (std::size_t j = 0; j < 3; ++j) {
      b[j][j] += t.weight;
      column(b, 3, 3 + j, t.weight * (turned_by_corners ? s.rest(axes[j]) : axes[j]));
    }
    add_crossed(b, 0, 3, -t.weight, t.arm);
  }
  for (const Corner& c : corners(row)) {
    Matrix& b = direct[c.node];
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3d omega = s.of(c.weight * cross(c.arm, axes[j]));
      column(b, 3, j, omega);
      column(b, 0, j, cross(omega, row.arm));
    }
  }
  std::map<int, Matrix> closed;
  for (auto& [node, b] : direct) {
    if (!row.rotations)
      for (std::size_t i = 3; i < 6; ++i) b[i].fill(0.0);
    if (row_of_[node] < 0) {
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) closed[node][i][j] += b[i][j];
      continue;
    }
    for (const Block& inner : blocks(node)) add_product(closed[inner.node], b, inner.of);
    // A dependent node without a spin of its own in the map keeps the one that it has.
    if (!rotations(node)) {
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 3; j < 6; ++j) closed[node][i][j] += b[i][j];
    }
  }
  std::vector<Block> all;
  for (const auto& [node, b] : closed) all.push_back({node, b});
  return all;
}

void ConstraintMap::archive(Archive& a) {
  a(rows_, terms_, corners_, row_of_);
  a.built(applied_, levels_, all_levels_);
}

}  // namespace nugget::system
