// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/law/elastic_constants.hpp"
#include "kernel/law/law_kernel.hpp"
#include "kernel/law/orthotropic.hpp"

namespace nugget::kernel {

/// Where in the history of a point its material axes begin.
inline constexpr int first_axis_field = 1;

/// Material axes a, b, c of a solid's point, in its history.
template <class R>
Frame<R> load_solid_axes(const double* history) {
  const Vec3<R> a = load_vector<R>(history, first_axis_field), b = load_vector<R>(history, first_axis_field + 3);
  return {a, b, cross(a, b)};
}
template <class R>
void turn_solid_axes(const Frame<R>& q, double* history) {
  for (const int axis : {first_axis_field, first_axis_field + 3}) {
    const Vec3<R> v = load_vector<R>(history, axis);
    store_vector(history, axis, Vec3<R>{dot(q.e1, v), dot(q.e2, v), dot(q.e3, v)});
  }
}
/// A tensor with tensorial shears given in axes `a`, back in global ones.
template <class R>
SolidTensor<R> out_of_axes(const Frame<R>& a, const SolidTensor<R>& t) {
  return rotated(Frame<R>{{a.e1.x, a.e2.x, a.e3.x}, {a.e1.y, a.e2.y, a.e3.y}, {a.e1.z, a.e2.z, a.e3.z}}, t);
}
/// Increments of strain [1] in axes `a` from rates with engineering shears; tensorial shears.
template <class R>
SolidTensor<R> strain_in_axes(const Frame<R>& a, const SolidTensor<R>& rate, double dt) {
  SolidTensor<R> strain = R(dt) * rate;
  strain.xy *= R(0.5);
  strain.yz *= R(0.5);
  strain.zx *= R(0.5);
  return rotated(a, strain);
}

/// History of a point: plastic strain (0), then the material axes: of a layer, cosine and sine of the angle from the
/// element's axis to a; of a solid, a and b in global axes.
template <>
class LawKernel<Orthotropic> {
 public:
  explicit LawKernel(const Orthotropic& law);

  static constexpr int first_axis = first_axis_field;
  int layer_history() const { return first_axis + 2; }
  int solid_history() const { return first_axis + 6; }
  const MaterialAxes& axes() const { return axes_; }

  template <class R>
  R wave_modulus(const double*) const {
    return R(wave_modulus_);
  }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, double* history) const {
    const R c = load_field<R>(history, first_axis), t = load_field<R>(history, first_axis + 1);
    const R cc = c * c, tt = t * t, ct = c * t;
    const LayerTensor<R> e = R(dt) * rate;
    const R ea = cc * e.xx + tt * e.yy + ct * e.xy, eb = tt * e.xx + cc * e.yy - ct * e.xy;
    const R a = layer_aa_ * ea + layer_ab_ * eb, b = layer_ab_ * ea + layer_bb_ * eb;
    const R ab = shear_ab_ * (2.0 * ct * (e.yy - e.xx) + (cc - tt) * e.xy);
    const R az = shear_ca_ * (c * e.xz + t * e.yz), bz = shear_bc_ * (c * e.yz - t * e.xz);
    s.xx += cc * a + tt * b - 2.0 * ct * ab;
    s.yy += tt * a + cc * b + 2.0 * ct * ab;
    s.xy += ct * (a - b) + (cc - tt) * ab;
    s.xz += c * az - t * bz;
    s.yz += t * az + c * bz;
    return {thinning_a_ * a + thinning_b_ * b, R(0.0)};
  }

  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const {
    const Frame<R> axes = load_solid_axes<R>(history);
    const SolidTensor<R> e = strain_in_axes(axes, rate, dt);
    const auto normal = [&](int i) { return solid_[i][0] * e.xx + solid_[i][1] * e.yy + solid_[i][2] * e.zz; };
    const SolidTensor<R> change{
        normal(0), normal(1), normal(2), 2.0 * shear_ab_ * e.xy, 2.0 * shear_bc_ * e.yz, 2.0 * shear_ca_ * e.zx};
    s = s + out_of_axes(axes, change);
  }
  template <class R>
  void rotate(const Frame<R>& q, double* history) const {
    turn_solid_axes(q, history);
  }

 private:
  MaterialAxes axes_;
  double layer_aa_, layer_ab_, layer_bb_;  // plane stress
  double thinning_a_, thinning_b_;         // strain through the thickness over the stresses
  std::array<std::array<double, 3>, 3> solid_;
  double shear_ab_, shear_bc_, shear_ca_;
  double wave_modulus_;  // of the fastest plane wave
};

}  // namespace nugget::kernel
