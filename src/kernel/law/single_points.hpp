// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
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
};

/// A law of single points as the element kernels want it. `Point` has
///   history()   numbers it needs beside plastic strain and wave modulus, at most `most_history`
///   tensors()   how many tensors these begin with: they turn with the material
///   update()    stress after a step from the one before, its history, and the wave modulus for the stable step.
/// History: wave modulus, then the point's own.
template <class Point>
class SolidPointLaw {
 public:
  static constexpr std::size_t most_history = 96;
  static constexpr bool has_plastic_strain = false;

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
  template <class R>
  void rotate(const Frame<R>& q, double* history) const {
    for (int t = 0; t < point_.tensors(); ++t) {
      double* tensor = history + (own_fields + t * SolidTensor<double>::size) * lanes<R>;
      store_solid(tensor, rotated(q, load_solid<R>(tensor)));
    }
  }

 private:
  static constexpr int wave_modulus_field = first_own_field, own_fields = wave_modulus_field + 1;
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
