// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "base/batch.hpp"
#include "base/index.hpp"
#include "base/vec3.hpp"
#include "kernel/element/hexahedron.hpp"
#include "system/imposed_stress.hpp"

// What groups do to the motions, forces and states of a block, lane by lane.
namespace nugget::system {

/// Rounds forces to a grid on which their sum has all its digits, and lets the last one be minus that of the others.
/// The grid is that of the floats about `corners` times the largest.
template <class R, std::size_t corners>
[[gnu::always_inline]] inline void balance(Vec3<R> (&f)[corners]) {
  for (R Vec3<R>::*c : {&Vec3<R>::x, &Vec3<R>::y, &Vec3<R>::z}) {
    R largest = abs(f[0].*c), sum(0.0);
    for (std::size_t a = 1; a < corners; ++a) largest = max(largest, abs(f[a].*c));
    const R coarse = R(static_cast<int>(corners)) * largest;
    for (std::size_t a = 0; a + 1 < corners; ++a) {
      f[a].*c = (f[a].*c + coarse) - coarse;
      sum += f[a].*c;
    }
    f[corners - 1].*c = -sum;
  }
}

template <class R>
void copy_lane(const Vec3<R>& from, Vec3<R>& to, int l) {
  set_lane(to.x, l, nugget::lane(from.x, l));
  set_lane(to.y, l, nugget::lane(from.y, l));
  set_lane(to.z, l, nugget::lane(from.z, l));
}

/// An inverted element has strains without meaning: it has no forces in the cycle that ends the run or deletes it, and
/// no step, whatever its kernel gives.
template <class R, bool rotational, class Forces>
[[gnu::always_inline]] inline void zero_forces_of_inverted(Forces& out) {
  const R none(0.0);
  const auto positive = out.volume > none;
  if (!any(!positive)) return;
  for (std::size_t a = 0; a < std::size(out.f); ++a) {
    out.f[a] = kernel::select(positive, out.f[a], Vec3<R>{});
    if constexpr (rotational) out.m[a] = kernel::select(positive, out.m[a], Vec3<R>{});
  }
  out.stable_step = select(positive, out.stable_step, none);
}

/// Gives an element the stress that is imposed on it. `values`: field i of its state at values[i * width].
template <int width, class Kernel, class N>
void put_stress(const Kernel& kernel, const ImposedStress& s, N* values) {
  const Vec3d& n = s.normal;
  const std::array<double, 6> nn{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
  const auto along = [&](const std::array<double, 6>& stress) {
    double sum = 0.0;
    for (std::size_t c = 0; c < 6; ++c) sum += (c < 3 ? 1.0 : 2.0) * nn[c] * stress[c];
    return sum;
  };
  const auto read = [values](int i) -> double { return values[i * width]; };
  const auto put = [values](int i, double value) { values[i * width] = static_cast<N>(value); };
  double mean = 0.0;
  if (s.area > 0.0) {
    mean = kernel.resultants(read)[0] / s.area;
  } else {
    int points = 0;
    kernel.change_stresses(
        read, [](int, double) {},
        [&](std::array<double, 6>& stress) {
          mean += along(stress);
          ++points;
        });
    mean /= points;
  }
  kernel.change_stresses(read, put, [&](std::array<double, 6>& stress) {
    const double change = s.stress - (s.others == ImposedStress::Others::bending ? mean : along(stress));
    for (std::size_t c = 0; c < 6; ++c)
      stress[c] = s.others == ImposedStress::Others::none ? s.stress * nn[c] : stress[c] + change * nn[c];
  });
}

/// In how many lanes `a` is below `b`.
template <class N, int width, class R>
int lanes_below(const R& a, const R& b) {
  N of_a[width], of_b[width];
  real_store(of_a, a);
  real_store(of_b, b);
  int count = 0;
  for (int l = 0; l < width; ++l) count += of_a[l] < of_b[l] ? 1 : 0;
  return count;
}

}  // namespace nugget::system
