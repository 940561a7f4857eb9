// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "kernel/element/uniform_gradient.hpp"

// Elastic resistance to the hourglass patterns of an eight-node brick (Belytschko and Bindeman). Included by .cpp files
// only.
namespace nugget::kernel {

/// Physical stabilisation (docs/theory/hourglass.md#physical-stabilisation): the strains of the hourglass rates by the
/// brick's own directions, those of xi, eta and zeta in its middle. Of q[k] the component d is the direct strain along
/// d that the pattern k makes, and of d = k the pattern's share of two shears; of q[3] those of xi eta zeta. Direct
/// strains are those of the edges.
template <class R>
[[gnu::always_inline]] inline Hourglass<R> strains_of(const Patterns<R>& x, const Hourglass<R>& q) {
  const Vec3<R>&q1 = q.q[0], &q2 = q.q[1], &q3 = q.q[2], &q4 = q.q[3];
  const Vec3<R>&h1 = x.h[0], &h2 = x.h[1], &h3 = x.h[2], &h4 = x.h[3];
  const R s1 = dot(h4, q1) + dot(h1, q4), s2 = dot(h4, q2) + dot(h2, q4), s3 = dot(h4, q3) + dot(h3, q4);
  return {{{dot(x.a, q1), dot(x.b, q1) + s3, dot(x.c, q1) + s2},
           {dot(x.a, q2) + s3, dot(x.b, q2), dot(x.c, q2) + s1},
           {dot(x.a, q3) + s2, dot(x.b, q3) + s1, dot(x.c, q3)},
           {dot(x.a, q4) + dot(h3, q2) + dot(h2, q3), dot(x.b, q4) + dot(h1, q3) + dot(h3, q1),
            dot(x.c, q4) + dot(h2, q1) + dot(h1, q2)}}};
}

/// Forces on the hourglass patterns that do the work of stresses on strains_of.
template <class R>
[[gnu::always_inline]] inline Hourglass<R> forces_on_patterns(const Patterns<R>& x, const Hourglass<R>& s) {
  const Vec3<R>&p1 = s.q[0], &p2 = s.q[1], &p3 = s.q[2], &p4 = s.q[3];
  const Vec3<R>&h1 = x.h[0], &h2 = x.h[1], &h3 = x.h[2], &h4 = x.h[3];
  const auto along = [&x](const Vec3<R>& p) { return p.x * x.a + p.y * x.b + p.z * x.c; };
  const R s1 = p2.z + p3.y, s2 = p1.z + p3.x, s3 = p1.y + p2.x;
  return {{along(p1) + s1 * h4 + p4.y * h3 + p4.z * h2, along(p2) + s2 * h4 + p4.x * h3 + p4.z * h1,
           along(p3) + s3 * h4 + p4.x * h2 + p4.y * h1, along(p4) + s1 * h1 + s2 * h2 + s3 * h3}};
}

/// Stress that varies along the third direction of a brick and lies in the plane of two others, of products `g`, `h`
/// and `gh`: plane stress, so that bending draws along the strains across it. Over twice the shear modulus, times the
/// square of g h - gh^2.
template <class R>
struct InPlane {
  R first, second, shear;

  [[gnu::always_inline]] InPlane(double nu, const R& g, const R& h, const R& gh, const R& along_first,
                                 const R& along_second, const R& both) {
    const R half = 0.5 * both, common = gh * half;
    const R a = h * along_first - common, c = g * along_second - common;
    const R b = h * half - gh * along_second, d = g * half - gh * along_first;
    const R lateral = (nu / (1.0 - nu)) * (a + c), one = lateral + a, two = lateral + c;
    first = one * h - b * gh;
    second = two * g - d * gh;
    shear = b * g - one * gh;
  }
};

/// Changes of the stresses of the hourglass patterns in a step, times the volume that they stand for, of strain rates
/// by strains_of; `share` of the elastic ones. And by how much each direction grows a time, as share of its length.
template <class R>
struct StabilizingStress {
  Hourglass<R> change;
  Vec3<R> growth;
  Vec3<R> shear;  ///< of `change` what goes with the shear in the plane across each direction

  [[gnu::always_inline]] StabilizingStress(const ElasticConstants& e, const R& share, const R& volume,
                                           const Patterns<R>& x, const Patterns<R>& v, const Hourglass<R>& strain) {
    const R g1 = dot(x.a, x.a), g2 = dot(x.b, x.b), g3 = dot(x.c, x.c);
    const R g23 = dot(x.b, x.c), g31 = dot(x.c, x.a), g12 = dot(x.a, x.b);
    const R gg1 = g2 * g3, gg2 = g3 * g1, gg3 = g1 * g2;
    const R over = 1.0 / (gg3 * g3), over1 = over * gg1, over2 = over * gg2, over3 = over * gg3;
    growth = {over1 * dot(x.a, v.a), over2 * dot(x.b, v.b), over3 * dot(x.c, v.c)};

    const Vec3<R>&e1 = strain.q[0], &e2 = strain.q[1], &e3 = strain.q[2], &e4 = strain.q[3];
    const InPlane<R> p1(e.nu, g2, g3, g23, e3.y, e2.z, e2.y + e3.z), p2(e.nu, g3, g1, g31, e1.z, e3.x, e1.x + e3.z),
        p3(e.nu, g1, g2, g12, e2.x, e1.y, e1.x + e2.y);
    const auto squared = [](const R& d) { return d * d; };
    const R d1 = squared(gg1 - g23 * g23), d2 = squared(gg2 - g31 * g31), d3 = squared(gg3 - g12 * g12), d12 = d1 * d2;
    const R modulus = (2.0 / 3.0 * e.shear) * share * volume, all = modulus / (d12 * d3);
    const R w1 = all * (d2 * d3), w2 = all * (d3 * d1), w3 = all * d12, last = ((1.0 + e.nu) / 3.0) * modulus;
    const R t1 = w1 * p1.shear, t2 = w2 * p2.shear, t3 = w3 * p3.shear;
    shear = {t1, t2, t3};
    change = {{{t2 + t3, w3 * p3.second, w2 * p2.first},
               {w3 * p3.first, t3 + t1, w1 * p1.second},
               {w2 * p2.second, w1 * p1.first, t1 + t2},
               {last * squared(over1) * e4.x, last * squared(over2) * e4.y, last * squared(over3) * e4.z}}};
  }
};

/// The same; in single precision of the shape in units of V^(1/3), as it takes lengths to the power of 24.
template <class R>
[[gnu::always_inline]] inline StabilizingStress<R> stabilizing_stress(const ElasticConstants& e, const R& share,
                                                                      const R& volume, const R& side,
                                                                      const Patterns<R>& x, const Patterns<R>& v,
                                                                      const Hourglass<R>& strain) {
  if constexpr (is_single<R>) {
    const R over = 1.0 / side, over2 = over * over;
    Patterns<R> shape{over * x.a, over * x.b, over * x.c, {}};
    Hourglass<R> scaled;
    for (int i = 0; i < 4; ++i) scaled.q[i] = over2 * strain.q[i];
    StabilizingStress<R> stress(e, share, volume, shape, v, scaled);
    for (Vec3<R>& change : stress.change.q) change = over2 * change;
    stress.growth = over * stress.growth;
    return stress;
  } else {
    return {e, share, volume, x, v, strain};
  }
}

}  // namespace nugget::kernel
