// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/batch.hpp"
#include "kernel/law/elastic_constants.hpp"
#include "kernel/law/law_kernel.hpp"
#include "kernel/law/stress_space.hpp"

// Laws of solids that are computed point by point, lane after lane: rubbers, foams, viscoelasticity. Their principal
// values and powers have no form for batches.
namespace nugget::kernel {

/// Principal values of a symmetric tensor, ascending, and their directions.
struct Principal {
  std::array<double, 3> value;
  std::array<Vec3d, 3> direction;
};
/// By Jacobi's rotations, exact to round-off. Shears are tensorial.
Principal principal_axes(const SolidTensor<double>& a);
/// The tensor with other principal values.
SolidTensor<double> with_values(const Principal& axes, const std::array<double, 3>& value);

/// Carries b - 1, b the left Cauchy-Green tensor, over a step of strain rate `d` (engineering shears): b := c b c with
/// Cayley's c = (1 - d dt/2)^-1 (1 + d dt/2), exact for a straight pull with mid-step rates. Rotation is the caller's.
void stretch(SolidTensor<double>& b_less_one, const SolidTensor<double>& d, double dt);

/// What a step makes of a point.
struct PointUpdate {
  SolidTensor<double> stress;
  double wave_modulus = 0.0;
  double plane_modulus = 0.0;  ///< at least that of waves in the plane of a layer [stress]; of laws of layers only
};

/// Whether strains are so small that a rubber is linear; its formulas would lose their digits.
bool is_linear(const SolidTensor<double>& b_less_one);
/// The point then.
PointUpdate linear_point(double E, double nu, const SolidTensor<double>& b_less_one);

/// A law of single points as the element kernels want it. `Point` has
///   history()   numbers it needs beside plastic strain and wave modulus, at most `most_history`
///   tensors()   how many tensors these begin with: they turn with the material
///   update()    stress after a step from the one before, its history, and the wave modulus for the stable step
///   in_layers   (a constant, where it is one) that layers of shells may have it, with a `plane_modulus`
/// History: wave modulus (of layers that of their plane), then the point's own.
template <class Point>
class SolidPointLaw {
 public:
  static constexpr std::size_t most_history = 112;
  static constexpr bool has_plastic_strain = false;
  static constexpr bool in_layers = requires { Point::in_layers; };

  template <class Law>
  explicit SolidPointLaw(const Law& law) : point_(law) {
    std::array<double, most_history> nothing{};
    initial_wave_modulus_ =
        std::max(ElasticConstants(law.E, law.nu).bulk_wave(), point_.update({}, {}, 0.0, nothing).wave_modulus);
  }

  int solid_history() const { return own_fields + point_.history(); }
  template <class R>
  R wave_modulus(const double* history) const {
    return max(R(initial_wave_modulus_), load_field<R>(history, wave_modulus_field));
  }
  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const {
    const auto lane_of = [](const SolidTensor<R>& a, int l) {
      return SolidTensor<double>{lane(a.xx, l), lane(a.yy, l), lane(a.zz, l),
                                 lane(a.xy, l), lane(a.yz, l), lane(a.zx, l)};
    };
    std::array<double, most_history> h;
    for (int l = 0; l < lanes<R>; ++l) {
      const auto at = [&](int i) -> double& { return history[(own_fields + i) * lanes<R> + l]; };
      for (int i = 0; i < point_.history(); ++i) h[i] = at(i);
      const PointUpdate now = point_.update(lane_of(s, l), lane_of(rate, l), dt, h);
      for (int i = 0; i < point_.history(); ++i) at(i) = h[i];
      history[wave_modulus_field * lanes<R> + l] = now.wave_modulus;
      set_lane(s.xx, l, now.stress.xx);
      set_lane(s.yy, l, now.stress.yy);
      set_lane(s.zz, l, now.stress.zz);
      set_lane(s.xy, l, now.stress.xy);
      set_lane(s.yz, l, now.stress.yz);
      set_lane(s.zx, l, now.stress.zx);
    }
  }
  /// A layer: the strain through its thickness is that which leaves no stress there, found by the secant. In the
  /// element's frame, which turns as the mean of the diagonals does: how the material turns against it is left out.
  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt,
                           double* history) const requires in_layers {
    std::array<double, most_history> h;
    ThicknessStrain<R> thickness;
    for (int l = 0; l < lanes<R>; ++l) {
      const auto at = [&](int i) -> double& { return history[(own_fields + i) * lanes<R> + l]; };
      for (int i = 0; i < point_.history(); ++i) h[i] = at(i);
      const LayerTensor<double> d{lane(rate.xx, l), lane(rate.yy, l), lane(rate.xy, l), lane(rate.xz, l),
                                  lane(rate.yz, l)};
      PointUpdate now;
      set_lane(thickness.total, l, in_plane(d, dt, h, now));
      for (int i = 0; i < point_.history(); ++i) at(i) = h[i];
      history[wave_modulus_field * lanes<R> + l] = now.plane_modulus;
      set_lane(s.xx, l, now.stress.xx);
      set_lane(s.yy, l, now.stress.yy);
      set_lane(s.xy, l, now.stress.xy);
      set_lane(s.xz, l, now.stress.zx);
      set_lane(s.yz, l, now.stress.yz);
    }
    return thickness;
  }
  int layer_history() const requires in_layers { return own_fields + point_.history(); }
  /// Modulus of the fastest wave in the plane of a layer as it is [stress].
  template <class R>
  R layer_modulus(const double* history) const requires in_layers {
    return load_field<R>(history, wave_modulus_field);
  }

  template <class R>
  void rotate(const Frame<R>& q, double* history) const {
    for (int t = 0; t < point_.tensors(); ++t) {
      double* tensor = history + (own_fields + t * SolidTensor<double>::size) * lanes<R>;
      store_solid(tensor, rotated(q, load_solid<R>(tensor)));
    }
  }

 private:
  static constexpr int wave_modulus_field = first_own_field, own_fields = wave_modulus_field + 1;

  /// Advances the history `h` of a layer by a step; returns the strain increment through the thickness.
  double in_plane(const LayerTensor<double>& d, double dt, std::array<double, most_history>& h,
                  PointUpdate& now) const {
    const std::array<double, most_history> start = h;
    const auto stress_at = [&](double zz) {
      h = start;
      const double rate = dt > 0.0 ? zz / dt : 0.0;
      now = point_.update({}, {d.xx, d.yy, rate, d.xy, d.yz, d.xz}, dt, h);
      return now.stress.zz;
    };
    if (!(dt > 0.0)) {
      stress_at(0.0);
      return 0.0;
    }
    double before = -0.5 * (d.xx + d.yy) * dt, of_before = stress_at(before);
    double zz = before - of_before / now.wave_modulus;
    for (int i = 0; i < 40; ++i) {
      const double left = stress_at(zz);
      // The digits that a stress has beside the modulus of the volume.
      if (std::abs(left) <= 1e-14 * now.wave_modulus || zz == before || left == of_before) break;
      const double next = zz - left * (zz - before) / (left - of_before);
      before = zz;
      of_before = left;
      zz = next;
    }
    return zz;
  }

  Point point_;
  double initial_wave_modulus_ = 0.0;
};

/// The kernel of a law that names the class of its points.
template <class Law>
requires requires {
  typename Law::Point;
}
class LawKernel<Law> : public SolidPointLaw<typename Law::Point> {
 public:
  using SolidPointLaw<typename Law::Point>::SolidPointLaw;
};

}  // namespace nugget::kernel
