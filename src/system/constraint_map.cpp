// SPDX-License-Identifier: Apache-2.0
#include "system/constraint_map.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace nugget::system {

Vec3d turned(const Vec3d& a, const Vec3d& phi) {
  const double angle2 = dot(phi, phi);
  const double angle = std::sqrt(angle2);
  // Series where sin(angle)/angle would lose digits.
  const double s = angle > 1e-4 ? std::sin(angle) / angle : 1.0 - angle2 / 6.0;
  const double half = angle > 1e-4 ? std::sin(0.5 * angle) / angle : 0.5 - angle2 / 48.0;
  const Vec3d across = cross(phi, a);
  return a + s * across + (2.0 * half * half) * cross(phi, across);
}

void ConstraintMap::add(int dependent, bool rotations, std::span<const Term> terms) {
  const int begin = static_cast<int>(terms_.size());
  terms_.insert(terms_.end(), terms.begin(), terms.end());
  rows_.push_back({dependent, rotations, begin, static_cast<int>(terms_.size())});
}

std::vector<int> ConstraintMap::close(int nodes) {
  row_of_.assign(static_cast<std::size_t>(nodes), -1);
  for (std::size_t r = 0; r < rows_.size(); ++r)
    row_of_[static_cast<std::size_t>(rows_[r].dependent)] = static_cast<int>(r);

  std::vector<int> circular;
  std::vector<Term> closed;
  std::vector<RowHead> heads = rows_;
  for (RowHead& row : heads) {
    std::vector<Term> open(terms_.begin() + row.begin, terms_.begin() + row.end), done;
    for (std::size_t steps = 0; !open.empty(); ++steps) {
      const Term t = open.back();
      open.pop_back();
      const int chained = row_of_[static_cast<std::size_t>(t.node)];
      if (chained < 0) {
        done.push_back(t);
      } else if (steps > 4 * rows_.size() + 64 || t.node == row.dependent) {
        circular.push_back(row.dependent);
        done.clear();
        break;
      } else {
        // v_k + omega_k x a with v_k = sum w' (v_j + omega_j x a') and omega_k = sum w' omega_j.
        const RowHead& inner = rows_[static_cast<std::size_t>(chained)];
        for (int i = inner.end - 1; i >= inner.begin; --i) {
          const Term& j = terms_[static_cast<std::size_t>(i)];
          open.push_back({j.node, t.weight * j.weight, j.arm + t.arm});
        }
      }
    }
    std::stable_sort(done.begin(), done.end(), [](const Term& a, const Term& b) { return a.node < b.node; });
    const int begin = static_cast<int>(closed.size());
    for (const Term& t : done) {
      if (static_cast<int>(closed.size()) > begin && closed.back().node == t.node) {
        Term& merged = closed.back();
        const double weight = merged.weight + t.weight;
        if (weight != 0.0) merged.arm = (1.0 / weight) * (merged.weight * merged.arm + t.weight * t.arm);
        merged.weight = weight;
      } else {
        closed.push_back(t);
      }
    }
    row.begin = begin;
    row.end = static_cast<int>(closed.size());
  }
  rows_ = std::move(heads);
  terms_ = std::move(closed);
  return circular;
}

std::span<const ConstraintMap::Term> ConstraintMap::terms(int node) const {
  const RowHead& row = rows_[static_cast<std::size_t>(row_of_[static_cast<std::size_t>(node)])];
  return {terms_.data() + row.begin, static_cast<std::size_t>(row.end - row.begin)};
}

std::span<ConstraintMap::Term> ConstraintMap::terms(int node) {
  const RowHead& row = rows_[static_cast<std::size_t>(row_of_[static_cast<std::size_t>(node)])];
  return {terms_.data() + row.begin, static_cast<std::size_t>(row.end - row.begin)};
}

void ConstraintMap::follow(double dt, std::span<Row> v, std::span<Row> w) {
  parallel_for(rows_.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      const RowHead& row = rows_[r];
      Vec3d vd{}, wd{};
      for (int i = row.begin; i < row.end; ++i) {
        Term& t = terms_[static_cast<std::size_t>(i)];
        const std::size_t k = static_cast<std::size_t>(t.node);
        const Vec3d omega = vec(w[k]);
        Vec3d velocity = vec(v[k]);
        if (t.arm.x != 0.0 || t.arm.y != 0.0 || t.arm.z != 0.0) {
          const Vec3d arm = turned(t.arm, dt * omega);
          velocity += dt > 0.0 ? (1.0 / dt) * (arm - t.arm) : cross(omega, t.arm);
          t.arm = arm;
        }
        vd += t.weight * velocity;
        wd += t.weight * omega;
      }
      const std::size_t d = static_cast<std::size_t>(row.dependent);
      set(v[d], vd);
      if (row.rotations) set(w[d], wd);
    }
  });
}

void ConstraintMap::collect(std::span<Row> f, std::span<Row> m) const {
  for (const RowHead& row : rows_) {
    const std::size_t d = static_cast<std::size_t>(row.dependent);
    const Vec3d force = vec(f[d]);
    const Vec3d moment = row.rotations ? vec(m[d]) : Vec3d{};
    for (int i = row.begin; i < row.end; ++i) {
      const Term& t = terms_[static_cast<std::size_t>(i)];
      const std::size_t k = static_cast<std::size_t>(t.node);
      set(f[k], vec(f[k]) + t.weight * force);
      set(m[k], vec(m[k]) + t.weight * (moment + cross(t.arm, force)));
    }
    set(f[d], Vec3d{});
    if (row.rotations) set(m[d], Vec3d{});
  }
}

}  // namespace nugget::system
