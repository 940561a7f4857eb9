// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/batch.hpp"
#include "kernel/element/shell.hpp"
#include "kernel/law/own_kernels.hpp"

// Motions, rotations and random numbers for the kernel tests.
namespace nugget::kernel {

/// The same sequence of numbers in -1 .. 1 on every machine.
class Random {
 public:
  double operator()() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11) / 4503599627370496.0 - 1.0;
  }
  Vec3d vector(double size) { return {size * (*this)(), size * (*this)(), size * (*this)()}; }

 private:
  std::uint64_t state_ = 88172645463325252ULL;
};

/// Rotation by `angle` [rad] about the unit vector `axis`.
inline Vec3d turned(const Vec3d& axis, double angle, const Vec3d& a) {
  return std::cos(angle) * a + std::sin(angle) * cross(axis, a) + (1.0 - std::cos(angle)) * dot(axis, a) * axis;
}

/// Puts one element's motion into a lane of a batch's.
template <int W, int N>
void put(NodalMotion<Batch<W>, N>& to, int l, const NodalMotion<double, N>& from) {
  const auto set = [l](Vec3<Batch<W>>& a, const Vec3d& b) {
    set_lane(a.x, l, b.x);
    set_lane(a.y, l, b.y);
    set_lane(a.z, l, b.z);
  };
  for (int i = 0; i < N; ++i) {
    set(to.x[i], from.x[i]);
    set(to.v[i], from.v[i]);
    set(to.w[i], from.w[i]);
  }
}
template <int W>
Vec3d get(const Vec3<Batch<W>>& a, int l) {
  return {lane(a.x, l), lane(a.y, l), lane(a.z, l)};
}

/// Moves nodes by their velocities: x becomes the end position of a step.
template <int N>
void advance(NodalMotion<double, N>& nodes, double dt) {
  for (int i = 0; i < N; ++i) nodes.x[i] += dt * nodes.v[i];
}

/// A step of a rigid rotation about the origin from `x` (the nodes before): end positions, chord velocities, and the
/// spin of the chord.
template <int N>
NodalMotion<double, N> rotation_step(const NodalMotion<double, N>& before, const Vec3d& axis, double angle, double dt) {
  NodalMotion<double, N> now;
  for (int i = 0; i < N; ++i) {
    now.x[i] = turned(axis, angle, before.x[i]);
    now.v[i] = (1.0 / dt) * (now.x[i] - before.x[i]);
    now.w[i] = (2.0 / dt) * std::tan(0.5 * angle) * axis;
  }
  return now;
}

/// Work of forces on a step.
template <int N>
double power(const NodalForces<double, N>& f, const NodalMotion<double, N>& nodes) {
  double sum = 0.0;
  for (int i = 0; i < N; ++i) sum += dot(f.f[i], nodes.v[i]) + dot(f.m[i], nodes.w[i]);
  return sum;
}
template <int N>
double largest_force(const NodalForces<double, N>& f) {
  double most = 0.0;
  for (int i = 0; i < N; ++i) most = std::max(most, norm(f.f[i]));
  return most;
}

/// Eigenvalues of a symmetric matrix, by Jacobi rotations, in no order.
inline std::vector<double> eigenvalues(std::vector<double> a, std::size_t n) {
  const auto at = [&](std::size_t i, std::size_t j) -> double& { return a[i * n + j]; };
  for (int sweep = 0; sweep < 30; ++sweep)
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = p + 1; q < n; ++q) {
        if (at(p, q) == 0.0) continue;
        const double theta = 0.5 * std::atan2(2 * at(p, q), at(q, q) - at(p, p)), c = std::cos(theta),
                     s = std::sin(theta);
        for (std::size_t k = 0; k < n; ++k) {
          const double x = at(k, p), y = at(k, q);
          at(k, p) = c * x - s * y;
          at(k, q) = s * x + c * y;
        }
        for (std::size_t k = 0; k < n; ++k) {
          const double x = at(p, k), y = at(q, k);
          at(p, k) = c * x - s * y;
          at(q, k) = s * x + c * y;
        }
      }
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) values.push_back(at(i, i));
  return values;
}

/// Number of its zero eigenvalues.
inline int zero_modes(const std::vector<double>& a, std::size_t n) {
  const std::vector<double> values = eigenvalues(a, n);
  double largest = 0.0;
  for (double v : values) largest = std::max(largest, std::abs(v));
  return static_cast<int>(
      std::count_if(values.begin(), values.end(), [&](double v) { return std::abs(v) < 1e-10 * largest; }));
}

/// Steel in mm, t, s, N.
inline constexpr double steel_E = 210000.0, steel_nu = 0.3, steel_density = 7.85e-9;
inline const Elastic steel{steel_E, steel_nu};

inline PiecewiseLinear bilinear(double yield, double plastic_modulus) {
  PiecewiseLinear law;
  law.E = steel_E;
  law.nu = steel_nu;
  law.yield = {Curve{0, {0.0, 1.0}, {yield, yield + plastic_modulus}}};
  return law;
}
inline PiecewiseLinear curved() {
  PiecewiseLinear law = bilinear(0, 0);
  law.yield = {Curve{0, {0.0, 0.002, 0.01, 0.05, 0.2, 1.0}, {250, 280, 330, 400, 480, 560}}};
  return law;
}
inline PiecewiseLinear tabled() {
  PiecewiseLinear law = curved();
  law.yield.push_back(Curve{0, {0.0, 0.02, 0.1, 1.0}, {330, 420, 500, 600}});
  law.yield.push_back(Curve{0, {0.0, 0.1, 1.0}, {400, 560, 650}});
  law.rates = {0.001, 10.0, 1000.0};
  law.log_rates = true;
  return law;
}
inline PlasticKinematic mixed(double beta) {
  return {steel_E, steel_nu, 300.0, 2000.0, beta, 0.0, 0.0, 0.0};
}

}  // namespace nugget::kernel
