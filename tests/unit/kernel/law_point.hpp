// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
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
