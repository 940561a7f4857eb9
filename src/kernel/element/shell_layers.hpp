// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include "base/index.hpp"
#include "kernel/element/shell.hpp"
#include "kernel/law/laminate_kernel.hpp"

// The walk through the layers, common to the shells. Included by their .cpp files only.
namespace nugget::kernel {

/// Membrane, curvature and transverse shear rates of a shell at its one point.
template <class R>
struct ShellRates {
  R xx{}, yy{}, xy{}, kxx{}, kyy{}, kxy{}, xz{}, yz{};
};

/// Stress resultants: forces and moments a length, shear with the shear factor.
template <class R>
struct ShellResultants {
  R nxx{}, nyy{}, nxy{}, mxx{}, myy{}, mxy{}, qx{}, qy{};
};

template <class R>
ShellRates<R> select(const MaskOf<R>& m, const ShellRates<R>& a, const ShellRates<R>& b) {
  return {select(m, a.xx, b.xx),   select(m, a.yy, b.yy),   select(m, a.xy, b.xy), select(m, a.kxx, b.kxx),
          select(m, a.kyy, b.kyy), select(m, a.kxy, b.kxy), select(m, a.xz, b.xz), select(m, a.yz, b.yz)};
}

/// What the layers of one column through the thickness give in a step: resultants for a thickness of 1.
template <class R>
struct Column {
  ShellResultants<R> n;
  ThicknessStrain<R> thinning;
};

/// Adds what layer k has to the sums over its column.
template <class R, class Law>
[[gnu::always_inline]] inline void add_layer(const ShellProperties& shell, [[maybe_unused]] const LawKernel<Law>& law,
                                             int k, const LayerTensor<R>& s, const ThicknessStrain<R>& e,
                                             Column<R>& c) {
  const double zeta = 0.5 * (shell.layers.zeta[at(k)] - shell.offset), weight = shell.layers.weight[at(k)];
  ShellResultants<R>& n = c.n;
  c.thinning.total += weight * e.total;
  c.thinning.plastic += weight * e.plastic;
  const R xx = weight * s.xx, yy = weight * s.yy, xy = weight * s.xy;
  n.nxx += xx;
  n.nyy += yy;
  n.nxy += xy;
  n.mxx += zeta * xx;
  n.myy += zeta * yy;
  n.mxy += zeta * xy;
  if constexpr (std::is_same_v<Law, Laminate>) {
    n.qx += (weight * law.of(k).shear_force) * s.xz;
    n.qy += (weight * law.of(k).shear_force) * s.yz;
  } else {
    n.qx += weight * s.xz;
    n.qy += weight * s.yz;
  }
}

/// Strain rate of layer k.
template <class R, class Law>
[[gnu::always_inline]] inline LayerTensor<R> rate_of_layer(const ShellProperties& shell,
                                                           [[maybe_unused]] const LawKernel<Law>& law, int k,
                                                           const ShellRates<R>& d, const R& t) {
  const R z = 0.5 * (shell.layers.zeta[at(k)] - shell.offset) * t;
  LayerTensor<R> rate{d.xx + z * d.kxx, d.yy + z * d.kyy, d.xy + z * d.kxy, d.xz, d.yz};
  if constexpr (std::is_same_v<Law, Laminate>) {
    rate.xz *= R(law.of(k).shear_strain);
    rate.yz *= R(law.of(k).shear_strain);
  }
  return rate;
}

/// Advances the layers of a column by a step, one after the other. `first`: the state of its first layer.
template <class R, class Law>
[[gnu::always_inline]] inline Column<R> advance_one_by_one(const ShellProperties& shell, const LawKernel<Law>& law,
                                                           const ShellRates<R>& d, const R& t, double dt,
                                                           Number<R>* first) {
  const int stride = (LayerTensor<R>::size + law.layer_history()) * lanes<R>;
  Column<R> c;
  for (int k = 0; k < shell.layers.count; ++k) {
    Number<R>* stress = first + k * stride;
    LayerTensor<R> s = load_layer<R>(stress);
    const ThicknessStrain<R> e =
        law_of(law, k).layer(s, rate_of_layer(shell, law, k, d, t), dt, stress + LayerTensor<R>::size * lanes<R>);
    store_layer(stress, s);
    add_layer(shell, law, k, s, e, c);
  }
  return c;
}

/// Advances the layers of a column by a step. `first`: the state of its first layer. Two neighbours that both yield
/// flow together where the law can do that (docs/decisions/0186).
template <class R, class Law>
[[gnu::always_inline]] inline Column<R> advance_column(const ShellProperties& shell, const LawKernel<Law>& law,
                                                       const ShellRates<R>& d, const R& t, double dt,
                                                       Number<R>* first) {
  if constexpr (!FlowsInPairs<Law>) {
    return advance_one_by_one(shell, law, d, t, dt, first);
  } else {
    const int count = shell.layers.count, stride = (LayerTensor<R>::size + law.layer_history()) * lanes<R>;
    ThicknessStrain<R> thickness[2];
    Column<R> c;
    const auto place = [&](int k, int of_pair) {
      Number<R>* stress = first + k * stride;
      return LayerPlace<R>{stress, stress + LayerTensor<R>::size * lanes<R>, &thickness[of_pair]};
    };
    const auto strain = [&](const LayerPlace<R>& layer, int k) {
      LayerTensor<R> s = load_layer<R>(layer.stress);
      const LayerTensor<R> rate = rate_of_layer(shell, law, k, d, t);
      const bool yields = law.strain_layer(s, rate, dt, layer.history);
      store_layer(layer.stress, s);
      *layer.thickness = law.elastic_thickness(rate, dt);
      return yields;
    };
    const auto add = [&](const LayerPlace<R>& layer, int k) {
      add_layer(shell, law, k, load_layer<R>(layer.stress), *layer.thickness, c);
    };
    int k = 0;
    for (; k + 1 < count; k += 2) {
      const LayerPlace<R> a = place(k, 0), b = place(k + 1, 1);
      const bool a_yields = strain(a, k), b_yields = strain(b, k + 1);
      if (a_yields && b_yields)
        law.flow_layers(a, b, dt);
      else if (a_yields || b_yields)
        law.flow_layer(a_yields ? a : b, dt);
      add(a, k);
      add(b, k + 1);
    }
    if (k < count) {
      const LayerPlace<R> last = place(k, 0);
      if (strain(last, k)) law.flow_layer(last, dt);
      add(last, k);
    }
    return c;
  }
}

/// The thickness after a step, stored as the element's (ISTUPD).
template <class R>
[[gnu::always_inline]] inline R thinned(const ShellProperties& shell, const ShellLayout& layout,
                                        const ThicknessStrain<R>& thinning, const R& t, Number<R>* state) {
  if (shell.thickness_update == ThicknessUpdate::none) return t;
  return add_to_field(state, ShellLayout::thickness,
                      t * (shell.thickness_update == ThicknessUpdate::all ? thinning.total : thinning.plastic),
                      layout.rest_of_thickness());
}

/// The resultants of a shell of thickness t from those for a thickness of 1.
template <class R>
[[gnu::always_inline]] inline ShellResultants<R> on_thickness(const ShellProperties& shell, const ShellResultants<R>& n,
                                                              const R& t) {
  const R t2 = t * t, qt = shell.shear_factor * t;
  return {t * n.nxx, t * n.nyy, t * n.nxy, t2 * n.mxx, t2 * n.myy, t2 * n.mxy, qt * n.qx, qt * n.qy};
}

/// Which elements have lost so many points that they are deleted: all, a number, or a percentage of the layers.
template <class R, class Law>
requires(!std::is_same_v<Law, Laminate>) MaskOf<R> enough_points_failed(const LawKernel<Law>& law,
                                                                        const ShellLayout& layout,
                                                                        const Number<R>* state) {
  const double limit = law.points_to_delete();
  const R none = R(0.0), one = R(1.0);
  R points = none, failed_layers = none;
  for (int k = 0; k < layout.layers; ++k) {
    R here = none;
    for (int c = 0; c < layout.columns; ++c)
      here += select(law.template failed<R>(state + layout.history_of(k, c) * lanes<R>), one, none);
    points += here;
    failed_layers += min(here, one);
  }
  const int all = layout.layers * layout.columns;
  if (limit < 0.0) return R(100.0) * failed_layers >= R(-limit * layout.layers);
  return points >= R(limit > 0.0 && limit < all ? limit : all);
}

/// Of a laminate. A law's number of points is one of its own layers, and one that these do not have counts for nothing;
/// its percentage is that of all layers which have its law and failed. In any case an element is deleted with the last
/// point of the layers that can fail.
template <class R>
MaskOf<R> enough_points_failed(const LawKernel<Laminate>& law, const ShellLayout& layout, const Number<R>* state) {
  const R none = R(0.0), one = R(1.0);
  auto failed_elements = none > one;
  R intact_points = none;
  for (int first = 0; first < layout.layers; ++first) {
    const LawKernel<ComposedLaw>& own = law.of(first).law;
    if (!own.can_fail()) {
      if (law.kept_by_unfailing_layers()) intact_points += one;
      continue;
    }
    if (law.of(first).first_of_same_law != first) continue;
    R points = none, failed_layers = none;
    int all = 0;
    for (int k = first; k < layout.layers; ++k) {
      if (law.of(k).first_of_same_law != first) continue;
      R here = none;
      for (int c = 0; c < layout.columns; ++c)
        here += select(own.template failed<R>(state + layout.history_of(k, c) * lanes<R>), one, none);
      points += here;
      failed_layers += min(here, one);
      all += layout.columns;
    }
    const double limit = own.points_to_delete();
    intact_points += R(all) - points;
    if (limit < 0.0) failed_elements = failed_elements || R(100.0) * failed_layers >= R(-limit * layout.layers);
    if (limit > 0.0 && limit <= all) failed_elements = failed_elements || points >= R(limit);
  }
  return failed_elements || intact_points < R(0.5);
}

/// What failed layers have left of an element's stiffness in the plane [1]; of one law 1, the element is deleted with
/// it.
template <class R, class Law>
R intact_fraction(const LawKernel<Law>& law, const ShellLayout& layout, const Number<R>* state) {
  if constexpr (std::is_same_v<Law, Laminate>) {
    R lost = R(0.0);
    for (int k = 0; k < layout.layers; ++k)
      if (law.of(k).law.can_fail())
        lost += select(law.of(k).law.template failed<R>(state + layout.history_of(k) * lanes<R>),
                       R(law.of(k).stiffness), R(0.0));
    return max(R(1.0) - lost, R(0.0));
  } else {
    return R(1.0);
  }
}

/// How much stiffer in its plane than its elastic constants say the stiffest layer has become, at least 1: the square
/// of what that leaves of the stable step.
template <class R, class Law>
R stiffening(const LawKernel<Law>& law, const ShellLayout& layout, const Number<R>* state) {
  R most = R(1.0);
  for (int k = 0; k < layout.layers; ++k) {
    const auto& own = law_of(law, k);
    if constexpr (requires { own.layers_stiffen(); })
      if (own.layers_stiffen())
        for (int c = 0; c < layout.columns; ++c)
          most = max(most, own.template layer_stiffening<R>(state + layout.history_of(k, c) * lanes<R>));
  }
  return most;
}

/// Share of the hourglass stiffness in the plane and in bending that is left: 1 while no layer has yielded. Afterwards
/// the material resists with its tangent, in steel that flows about a hundredth of Young's modulus. Twist is resisted
/// by transverse shear, which does not yield. LS-DYNA's results of type 4 in crash ask for that (docs/decisions/0006).
/// The share of failed layers of a laminate is removed, in twist too.
template <class R, class Law>
R tangent_share(const LawKernel<Law>& law, const ShellLayout& layout, const Number<R>* state) {
  if constexpr (!LawKernel<Law>::has_plastic_strain) return R(1.0);
  R strain = R(0.0);
  for (int k = 0; k < layout.layers; ++k) strain = max(strain, load_field<R>(state, layout.history_of(k)));
  return select(strain > 0.0, R(0.01), R(1.0)) * intact_fraction<R>(law, layout, state);
}

/// Advances all layers of a shell with one column by a step and adds them up on the new thickness. Elements with too
/// many failed points are deleted: `alive` is cleared for them.
template <class R, class Law>
[[gnu::always_inline]] inline ShellResultants<R> advance_layers(const ShellProperties& shell, const LawKernel<Law>& law,
                                                                const ShellLayout& layout, const ShellRates<R>& d,
                                                                double dt, Number<R>* state, MaskOf<R>& alive) {
  using L = ShellLayout;
  const R t = load_field<R>(state, L::thickness);
  const Column<R> c = advance_column(shell, law, d, t, dt, state + L::first_layer * lanes<R>);
  if (law.can_fail()) alive = alive && !enough_points_failed<R>(law, layout, state);
  return on_thickness(shell, c.n, thinned(shell, layout, c.thinning, t, state));
}

/// What drilling stiffness goes by besides G t: the square of the thickness in elements that are large beside it, the
/// area in small ones, where it vanishes under refinement (docs/theory/shell.md#drilling-stiffness).
template <class R>
R drilling_length2(const R& t, const R& area) {
  return min(t * t, area);
}

/// Viscous pressure a length in a shell that is compressed in its plane
/// (docs/theory/shell.md#bulk-viscosity-in-the-plane); 0 when stretched.
template <class R, class Law>
R viscous_membrane(const ShellProperties& shell, const LawKernel<Law>& law, const R& trace, const R& area,
                   const Number<R>* state) {
  const R density = shell.density * load_field<R>(state, ShellLayout::density_scale);
  const R side = sqrt(area), c = sqrt(law.elastic().plane / density);
  const R q = density * side * (shell.bulk_quadratic * side * trace * trace - shell.bulk_linear * c * trace);
  return select(trace < 0.0, q * load_field<R>(state, ShellLayout::thickness), R(0.0));
}

}  // namespace nugget::kernel
