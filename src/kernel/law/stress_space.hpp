// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/batch.hpp"
#include "base/vec3.hpp"

// The three stress spaces in which an element and a law meet. The same structs hold stresses [stress], strain rates
// [1/time] and strain increments [1]; shear strains are engineering shears.
namespace nugget::kernel {

using nugget::select;

/// A plane-stress layer of a shell, in the element's frame.
template <class R>
struct LayerTensor {
  R xx{}, yy{}, xy{}, xz{}, yz{};
  static constexpr int size = 5;
};

/// A point of a solid, in global axes.
template <class R>
struct SolidTensor {
  R xx{}, yy{}, zz{}, xy{}, yz{}, zx{};
  static constexpr int size = 6;
};

/// A fibre of a beam: normal and shear stress on the cross-section.
template <class R>
struct FibreTensor {
  R rr{}, rs{}, rt{};
  static constexpr int size = 3;
};

/// Strain increment through the thickness of a layer, for the update of a shell's thickness.
template <class R>
struct ThicknessStrain {
  R total{}, plastic{};
};

// Fields of the state arrays: field i of lane l stands at state[i * lanes<R> + l].

template <class R>
R load_field(const Number<R>* state, int field) {
  return real_load<R>(state + field * lanes<R>);
}
template <class R>
void store_field(Number<R>* state, int field, const R& value) {
  real_store(state + field * lanes<R>, value);
}

/// Adds to a sum of the state. In single precision, where many small parts would be lost beside the sum, field `rest`
/// keeps what it could not take of them.
template <class R>
[[gnu::always_inline]] inline R add_to_field(Number<R>* state, int field, const R& more, int rest) {
  const R old = load_field<R>(state, field);
  R sum = old + more;
  if constexpr (is_single<R>) {
    const R part = more + load_field<R>(state, rest);
    sum = old + part;
    const R taken = sum - old;  // Knuth's two-sum: what is lost, whichever is larger
    store_field(state, rest, (old - (sum - taken)) + (part - taken));
  }
  store_field(state, field, sum);
  return sum;
}

/// `s`: a pointer, or what stands in the place of one (twin_place.hpp).
template <class R, class Place>
LayerTensor<R> load_layer(const Place& s) {
  return {load_field<R>(s, 0), load_field<R>(s, 1), load_field<R>(s, 2), load_field<R>(s, 3), load_field<R>(s, 4)};
}
template <class R, class Place>
void store_layer(const Place& s, const LayerTensor<R>& a) {
  store_field(s, 0, a.xx);
  store_field(s, 1, a.yy);
  store_field(s, 2, a.xy);
  store_field(s, 3, a.xz);
  store_field(s, 4, a.yz);
}

template <class R>
SolidTensor<R> load_solid(const Number<R>* s) {
  return {load_field<R>(s, 0), load_field<R>(s, 1), load_field<R>(s, 2),
          load_field<R>(s, 3), load_field<R>(s, 4), load_field<R>(s, 5)};
}
template <class R>
void store_solid(Number<R>* s, const SolidTensor<R>& a) {
  store_field(s, 0, a.xx);
  store_field(s, 1, a.yy);
  store_field(s, 2, a.zz);
  store_field(s, 3, a.xy);
  store_field(s, 4, a.yz);
  store_field(s, 5, a.zx);
}

template <class R>
FibreTensor<R> load_fibre(const Number<R>* s) {
  return {load_field<R>(s, 0), load_field<R>(s, 1), load_field<R>(s, 2)};
}
template <class R>
void store_fibre(Number<R>* s, const FibreTensor<R>& a) {
  store_field(s, 0, a.rr);
  store_field(s, 1, a.rs);
  store_field(s, 2, a.rt);
}

template <class R>
Vec3<R> load_vector(const Number<R>* state, int field) {
  return {load_field<R>(state, field), load_field<R>(state, field + 1), load_field<R>(state, field + 2)};
}
template <class R>
void store_vector(Number<R>* state, int field, const Vec3<R>& a) {
  store_field(state, field, a.x);
  store_field(state, field + 1, a.y);
  store_field(state, field + 2, a.z);
}

template <class R>
Vec3<R> select(const MaskOf<R>& m, const Vec3<R>& yes, const Vec3<R>& no) {
  return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z)};
}

template <class R>
LayerTensor<R> select(const MaskOf<R>& m, const LayerTensor<R>& a, const LayerTensor<R>& b) {
  return {select(m, a.xx, b.xx), select(m, a.yy, b.yy), select(m, a.xy, b.xy), select(m, a.xz, b.xz),
          select(m, a.yz, b.yz)};
}
template <class R>
SolidTensor<R> select(const MaskOf<R>& m, const SolidTensor<R>& a, const SolidTensor<R>& b) {
  return {select(m, a.xx, b.xx), select(m, a.yy, b.yy), select(m, a.zz, b.zz),
          select(m, a.xy, b.xy), select(m, a.yz, b.yz), select(m, a.zx, b.zx)};
}
template <class R>
FibreTensor<R> select(const MaskOf<R>& m, const FibreTensor<R>& a, const FibreTensor<R>& b) {
  return {select(m, a.rr, b.rr), select(m, a.rs, b.rs), select(m, a.rt, b.rt)};
}

template <class R>
LayerTensor<R> operator*(const R& a, const LayerTensor<R>& t) {
  return {a * t.xx, a * t.yy, a * t.xy, a * t.xz, a * t.yz};
}
template <class R>
LayerTensor<R> operator+(const LayerTensor<R>& a, const LayerTensor<R>& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}
template <class R>
SolidTensor<R> operator*(const R& a, const SolidTensor<R>& t) {
  return {a * t.xx, a * t.yy, a * t.zz, a * t.xy, a * t.yz, a * t.zx};
}
template <class R>
SolidTensor<R> operator+(const SolidTensor<R>& a, const SolidTensor<R>& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.yz + b.yz, a.zx + b.zx};
}
template <class R>
FibreTensor<R> operator*(const R& a, const FibreTensor<R>& t) {
  return {a * t.rr, a * t.rs, a * t.rt};
}

/// A symmetric tensor in axes that were turned with the material: q a q^T, with the rows of `q` the new axes' images.
template <class R>
[[gnu::always_inline]] inline SolidTensor<R> rotated(const Frame<R>& q, const SolidTensor<R>& a) {
  const auto times = [&](const Vec3<R>& u) {
    return Vec3<R>{a.xx * u.x + a.xy * u.y + a.zx * u.z, a.xy * u.x + a.yy * u.y + a.yz * u.z,
                   a.zx * u.x + a.yz * u.y + a.zz * u.z};
  };
  const Vec3<R> x = times(q.e1), y = times(q.e2), z = times(q.e3);
  return {dot(q.e1, x), dot(q.e2, y), dot(q.e3, z), dot(q.e1, y), dot(q.e2, z), dot(q.e3, x)};
}

}  // namespace nugget::kernel
