// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace nugget {

/// A vector of three components over any real `R` (double, Batch, Dual). Plain data, no padding.
template <class R>
struct Vec3 {
  R x{}, y{}, z{};

  Vec3& operator+=(const Vec3& b) { return *this = *this + b; }
  Vec3& operator-=(const Vec3& b) { return *this = *this - b; }
  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend Vec3 operator*(const R& s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

// Inlined always: kernels are made of these, and a call that hands batches over in memory costs more than the product.
template <class R>
[[gnu::always_inline]] inline R dot(const Vec3<R>& a, const Vec3<R>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class R>
[[gnu::always_inline]] inline Vec3<R> cross(const Vec3<R>& a, const Vec3<R>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class R>
R norm(const Vec3<R>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// `a` scaled to length 1. The caller sees to it that `a` is not zero.
template <class R>
Vec3<R> unit(const Vec3<R>& a) {
  return (R(1.0) / norm(a)) * a;
}

/// An orthonormal right-handed triad; its rows are the unit base vectors in global axes.
template <class R>
struct Frame {
  Vec3<R> e1, e2, e3;

  /// Components of a global vector in this frame.
  Vec3<R> local(const Vec3<R>& a) const { return {dot(e1, a), dot(e2, a), dot(e3, a)}; }
  /// The global vector that has the components `a` in this frame.
  Vec3<R> global(const Vec3<R>& a) const { return a.x * e1 + a.y * e2 + a.z * e3; }
};

using Vec3d = Vec3<double>;
using Frame3d = Frame<double>;

}  // namespace nugget
