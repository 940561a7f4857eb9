// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "kernel/law/composed_law_kernel.hpp"
#include "one_element.hpp"

// One point of a law in one stress space, driven by strain increments.
namespace nugget::kernel {

template <class Law>
struct LayerPoint {
  LawKernel<Law> law;
  std::vector<double> history = std::vector<double>(128);
  LayerTensor<double> s{};
  ThicknessStrain<double> thickness{};
  double dt = 1.0;

  explicit LayerPoint(const Law& parameters) : law(parameters) {}
  void strain(const LayerTensor<double>& increment) { step((1.0 / dt) * increment, dt); }
  void step(const LayerTensor<double>& rate, double duration) {
    StateInAllLanes lanes(history);
    LayerTensor<NativeBatch> stress = in_all_lanes(s);
    thickness = in_first_lane(law.layer(stress, in_all_lanes(rate), duration, lanes.data()));
    s = in_first_lane(stress);
  }
  /// Axial strain with the transverse strain that leaves no transverse stress, found by secants on copies.
  void uniaxial(double axial, double shear = 0.0) {
    const auto lateral_stress = [&](double lateral) {
      LayerPoint copy = *this;
      copy.strain({axial, lateral, shear, 0, 0});
      return copy.s.yy;
    };
    double a = -0.3 * axial, b = -0.5 * axial, fa = lateral_stress(a), fb = lateral_stress(b);
    for (int i = 0; i < 60 && std::abs(fb) > 1e-9 && fb != fa; ++i) {
      const double c = b - fb * (b - a) / (fb - fa);
      a = b, fa = fb;
      b = c, fb = lateral_stress(c);
    }
    strain({axial, b, shear, 0, 0});
  }
  /// How much stiffer than elastic the layer is in its plane.
  double stiffening() { return lane(law.template layer_stiffening<NativeBatch>(StateInAllLanes(history).data()), 0); }
  double plastic_strain() const { return history[0]; }
  double effective(const LayerTensor<double>& back = {}) const {
    const double xx = s.xx - back.xx, yy = s.yy - back.yy, xy = s.xy - back.xy, xz = s.xz - back.xz,
                 yz = s.yz - back.yz;
    return std::sqrt(xx * xx + yy * yy - xx * yy + 3 * (xy * xy + xz * xz + yz * yz));
  }
};

/// A batch of points gives bit for bit what its lanes give alone: lane l is `point(l)`, strained by `increment(l)` in
/// each of `steps` steps of `dt`. `seen(l, point)` is called after each.
template <class Law, class Point, class Increment, class Seen>
void expect_bits_of_lanes(const Law& law, int steps, double dt, const Point& point, Increment&& increment,
                          const Seen& seen) {
  const LawKernel<Law> kernel(law);
  constexpr int width = lanes<NativeBatch>;
  std::vector<LayerPoint<Law>> alone;
  std::vector<double> history(static_cast<std::size_t>(kernel.layer_history() * width));
  for (int l = 0; l < width; ++l) {
    alone.push_back(point(l));
    alone.back().dt = dt;
    for (int i = 0; i < kernel.layer_history(); ++i) history[i * width + l] = alone[l].history[i];
  }
  LayerTensor<NativeBatch> s;
  for (int k = 0; k < steps; ++k) {
    LayerTensor<NativeBatch> rate;
    for (int l = 0; l < width; ++l) {
      const LayerTensor<double> step = increment(l), one = (1.0 / dt) * step;
      set_lane(rate.xx, l, one.xx);
      set_lane(rate.yy, l, one.yy);
      set_lane(rate.xy, l, one.xy);
      set_lane(rate.xz, l, one.xz);
      set_lane(rate.yz, l, one.yz);
      alone[l].strain(step);
    }
    kernel.layer(s, rate, dt, history.data());
    for (int l = 0; l < width; ++l) {
      ASSERT_EQ(lane(s.xx, l), alone[l].s.xx);
      ASSERT_EQ(lane(s.yy, l), alone[l].s.yy);
      ASSERT_EQ(lane(s.xy, l), alone[l].s.xy);
      ASSERT_EQ(lane(s.xz, l), alone[l].s.xz);
      ASSERT_EQ(lane(s.yz, l), alone[l].s.yz);
      for (int i = 0; i < kernel.layer_history(); ++i) ASSERT_EQ(history[i * width + l], alone[l].history[i]) << i;
      seen(l, alone[l]);
    }
  }
}

template <class Law>
struct SolidPoint {
  LawKernel<Law> law;
  std::vector<double> history = std::vector<double>(128);
  SolidTensor<double> s{};
  double dt = 1.0;

  explicit SolidPoint(const Law& parameters) : law(parameters) {}
  void strain(const SolidTensor<double>& increment) {
    StateInAllLanes lanes(history);
    SolidTensor<NativeBatch> stress = in_all_lanes(s);
    law.solid(stress, in_all_lanes((1.0 / dt) * increment), dt, lanes.data());
    s = in_first_lane(stress);
  }
  /// Turns stress and history with the material.
  void turn(const Frame3d& q) {
    StateInAllLanes lanes(history);
    law.rotate(in_all_lanes(q), lanes.data());
    s = rotated(q, s);
  }
  double wave_modulus() { return lane(law.template wave_modulus<NativeBatch>(StateInAllLanes(history).data()), 0); }
  /// Axial strain with the transverse strain that leaves no transverse stress, found by secants on copies.
  void uniaxial(double axial) {
    const auto lateral_stress = [&](double lateral) {
      SolidPoint copy = *this;
      copy.strain({axial, lateral, lateral, 0, 0, 0});
      return copy.s.yy;
    };
    double a = -0.3 * axial, b = -0.5 * axial, fa = lateral_stress(a), fb = lateral_stress(b);
    for (int i = 0; i < 60 && std::abs(fb) > 1e-9 && fb != fa; ++i) {
      const double c = b - fb * (b - a) / (fb - fa);
      a = b, fa = fb;
      b = c, fb = lateral_stress(c);
    }
    strain({axial, b, b, 0, 0, 0});
  }
  double plastic_strain() const { return history[0]; }
  double effective() const {
    const double m = (s.xx + s.yy + s.zz) / 3, x = s.xx - m, y = s.yy - m, z = s.zz - m;
    return std::sqrt(1.5 * (x * x + y * y + z * z) + 3 * (s.xy * s.xy + s.yz * s.yz + s.zx * s.zx));
  }
};

}  // namespace nugget::kernel
