// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "base/batch.hpp"
#include "kernel/law/foam.hpp"
#include "kernel/law/prepared.hpp"
#include "kernel/law/rubber.hpp"
#include "kernel/law/viscoelastic.hpp"

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

/// One law, one point. `history`: numbers beside plastic strain and wave modulus; the first six are a tensor that turns
/// with the material if `has_tensor`. update() gives the stress after a step from the one before, and the wave modulus.
struct PointUpdate {
  SolidTensor<double> stress;
  double wave_modulus = 0.0;
};

class MooneyRivlinPoint {
 public:
  static constexpr int history = 6;
  static constexpr bool has_tensor = true;
  explicit MooneyRivlinPoint(const MooneyRivlin& law);
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  double E_, nu_, a_, b_, c_, d_;
};

class OgdenPoint {
 public:
  static constexpr int history = 6;
  static constexpr bool has_tensor = true;
  explicit OgdenPoint(const Ogden& law);
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  double E_, nu_;
  std::vector<Ogden::Term> terms_;
  double bulk_;
};

class LowDensityFoamPoint {
 public:
  static constexpr int history = 8;  // b - 1, greatest energy, torn
  static constexpr bool has_tensor = true;
  explicit LowDensityFoamPoint(const LowDensityFoam& law) : law_(law) {}
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  LowDensityFoam law_;
};

class CrushableFoamPoint {
 public:
  static constexpr int history = 1;  // logarithm of the relative volume
  static constexpr bool has_tensor = false;
  explicit CrushableFoamPoint(const CrushableFoam& law) : law_(law) {}
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  CrushableFoam law_;
};

class ViscoelasticPoint {
 public:
  static constexpr int history = 6;  // the part of the stress that decays
  static constexpr bool has_tensor = true;
  explicit ViscoelasticPoint(const Viscoelastic& law) : law_(law) {}
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  Viscoelastic law_;
};

/// Such a law as the element kernels want it. History: plastic strain (0), wave modulus, then the point's own. In
/// layers it has no stress; the model refuses it there.
template <class Point>
class SolidPointLaw {
 public:
  template <class Law>
  explicit SolidPointLaw(const Law& law) : point_(law), at_rest_(ElasticConstants(law.E, law.nu).bulk_wave()) {}

  int layer_history() const { return solid_history(); }
  int solid_history() const { return own + Point::history; }
  template <class R>
  R wave_modulus(const double* history) const {
    return max(R(at_rest_), load_field<R>(history, 1));
  }
  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>&, const LayerTensor<R>&, double, double*) const {
    return {};
  }
  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const {
    const auto lane_of = [](const SolidTensor<R>& a, int l) {
      return SolidTensor<double>{lane(a.xx, l), lane(a.yy, l), lane(a.zz, l),
                                 lane(a.xy, l), lane(a.yz, l), lane(a.zx, l)};
    };
    for (int l = 0; l < lanes<R>; ++l) {
      std::array<double, Point::history> h;
      const auto at = [&](int i) -> double& { return history[(own + i) * lanes<R> + l]; };
      for (int i = 0; i < Point::history; ++i) h[static_cast<std::size_t>(i)] = at(i);
      const PointUpdate now = point_.update(lane_of(s, l), lane_of(rate, l), dt, h);
      for (int i = 0; i < Point::history; ++i) at(i) = h[static_cast<std::size_t>(i)];
      history[lanes<R> + l] = now.wave_modulus;
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
    if constexpr (Point::has_tensor)
      store_solid(history + own * lanes<R>, rotated(q, load_solid<R>(history + own * lanes<R>)));
  }

 private:
  static constexpr int own = 2;
  Point point_;
  double at_rest_;
};

}  // namespace nugget::kernel
