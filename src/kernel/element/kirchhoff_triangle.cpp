// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/kirchhoff_triangle.hpp"

#include <algorithm>

#include "kernel/element/gyration.hpp"
#include "kernel/element/triangle.hpp"
#include "kernel/law/laminate_kernel.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {
namespace {

/// A side: along it, and -6 / l^2.
template <class R>
struct Side {
  int first, second;
  R x, y, scale;
};

/// The bubbles of the slopes, -6 L_i L_j (S / l^2) x_ij a side.
template <class R>
struct Bubbles {
  Side<R> side[3];  ///< 1-2, 1-3, 2-3
  R x[3], y[3];     ///< gradients of the area coordinates

  [[gnu::always_inline]] explicit Bubbles(const Triangle<R>& g) {
    const auto make = [](int i, int j, const R& dx, const R& dy) {
      return Side<R>{i, j, dx, dy, -6.0 / (dx * dx + dy * dy)};
    };
    side[0] = make(0, 1, g.x21, g.y21);
    side[1] = make(0, 2, g.x31, g.y31);
    side[2] = make(1, 2, g.x31 - g.x21, g.y31 - g.y21);
    x[1] = g.x2;
    y[1] = g.y2;
    x[2] = g.x3;
    y[2] = g.y3;
    x[0] = -(x[1] + x[2]);
    y[0] = -(y[1] + y[2]);
  }
  /// Gradient of L_i L_j of a side at the point next to a corner; the mean over the points where `corner` is none.
  static constexpr double coordinate(int corner, int node) {
    return corner < 0 ? 1.0 / 3.0 : corner == node ? 2.0 / 3.0 : 1.0 / 6.0;
  }
  R dx(const Side<R>& s, int corner) const {
    return coordinate(corner, s.first) * x[s.second] + coordinate(corner, s.second) * x[s.first];
  }
  R dy(const Side<R>& s, int corner) const {
    return coordinate(corner, s.first) * y[s.second] + coordinate(corner, s.second) * y[s.first];
  }
  /// Adds the curvature rates that go with shears of the sides.
  [[gnu::always_inline]] void bend(const SideShears<R>& shear, int corner, ShellRates<R>& d) const {
    const R along[3] = {side[0].scale * shear.s12, side[1].scale * shear.s13, side[2].scale * shear.s23};
    for (int k = 0; k < 3; ++k) {
      const R gx = along[k] * dx(side[k], corner), gy = along[k] * dy(side[k], corner);
      d.kxx += side[k].x * gx;
      d.kyy += side[k].y * gy;
      d.kxy += side[k].x * gy + side[k].y * gx;
    }
  }
  /// Adds the work of a point's moments to the forces on the shears of the sides: the transpose of `bend`.
  [[gnu::always_inline]] void collect(const ShellResultants<R>& n, const R& area, int corner, R (&force)[3]) const {
    for (int k = 0; k < 3; ++k) {
      const R gx = dx(side[k], corner), gy = dy(side[k], corner);
      const R work = side[k].x * (n.mxx * gx + n.mxy * gy) + side[k].y * (n.myy * gy + n.mxy * gx);
      force[k] += area * side[k].scale * work;
    }
  }
};

/// Square of the thickness of one material that is as stiff in bending for what it is in its plane, or as hard to turn
/// for its mass, whichever is more.
template <class R>
R depth2(const ThicknessProfile& profile, const R& t) {
  return std::max(profile.mass_spread, profile.stiffness_spread) * (t * t);
}

/// Square of the radius of gyration of a node's share of the element, without offset.
template <class R>
R gyration2(const R& t2, const R& area, const R& altitude2) {
  return max(max(R(1.0 / 12.0) * t2, 0.125 * area), 0.5 * area * t2 / altitude2);
}

/// Square of the length over the wave speed at which bending is stable: of motions across the plane h^2/t, of spins the
/// same with their inertia.
template <class R>
R bending_length2(const R& t2, const R& area, const R& altitude2) {
  const R spins = 0.4 * area / gyration2(t2, area, altitude2);
  return altitude2 * altitude2 / (t2 * (1.0 + spins));
}

}  // namespace

template <class R, class Law>
NodalForces<R, 3> kirchhoff_triangle_cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                           const NodalMotion<R, 3>& nodes, double dt, double* state) {
  using L = ShellLayout;
  const ElasticConstants& e = law.elastic();
  const L layout = kirchhoff_layout(shell, law);
  auto alive = load_field<R>(state, L::alive) > 0.5;

  const R half = R(0.5 * dt);
  Vec3<R> middle[3];
  for (int i = 0; i < 3; ++i) middle[i] = nodes.x[i] - half * nodes.v[i];
  const Triangle<R> mid(middle), end(nodes.x);

  const TriangleRates<R> rates = rates_on(mid, nodes, alive);
  R drilling[3]{};
  if (shell.drilling > 0.0) {
    R power{};
    resist_drilling(shell, e, mid.area, rates.spin, dt, state, drilling, power);
    store_field(state, L::hourglass_energy, load_field<R>(state, L::hourglass_energy) + (0.5 * dt) * power);
  }

  const Bubbles<R> bubbles(mid);
  const R t = load_field<R>(state, L::thickness);
  constexpr double share = 1.0 / kirchhoff_columns;
  ShellResultants<R> n[kirchhoff_columns];
  ThicknessStrain<R> thinning;
  for (int p = 0; p < kirchhoff_columns; ++p) {
    ShellRates<R> d = rates.constant;
    bubbles.bend(rates.side, p, d);
    const Column<R> column = advance_column(shell, law, d, t, dt, state + layout.layer(0, p) * lanes<R>);
    n[p] = column.n;
    thinning.total += share * column.thinning.total;
    thinning.plastic += share * column.thinning.plastic;
  }
  if (law.can_fail()) alive = alive && !enough_points_failed<R>(law, layout, state);
  const R now = thinned(shell, layout, thinning, t, state);

  const Bubbles<R> at_end(end);
  ShellResultants<R> mean;
  R side[3]{};
  for (int p = 0; p < kirchhoff_columns; ++p) {
    const ShellResultants<R> m = on_thickness(shell, n[p], now);
    at_end.collect(m, share * end.area, p, side);
    mean.nxx += share * m.nxx;
    mean.nyy += share * m.nyy;
    mean.nxy += share * m.nxy;
    mean.mxx += share * m.mxx;
    mean.myy += share * m.myy;
    mean.mxy += share * m.mxy;
  }
  if (shell.bulk_quadratic != 0.0 || shell.bulk_linear != 0.0) {
    const R viscous = viscous_membrane(shell, law, rates.constant.xx + rates.constant.yy, end.area, state);
    mean.nxx -= viscous;
    mean.nyy -= viscous;
  }

  const R scale =
      load_field<R>(state, L::density_scale) * (shell.density / e.plane) / stiffening<R>(law, layout, state);
  const R altitude2 = length2(nodes.x, end.area, ShellLength::area_over_side, e.nu);
  const R shortest2 = min(length2(nodes.x, end.area, shell.length, e.nu),
                          bending_length2(depth2(shell.profile, now), end.area, altitude2));
  const R step = sqrt(shortest2 * scale);
  if (law.deletion_step() > 0.0) alive = alive && step >= law.deletion_step();
  if (law.can_fail() || law.deletion_step() > 0.0) store_field(state, L::alive, select(alive, R(1.0), R(0.0)));

  NodalForces<R, 3> out = forces_on(end, mean, SideShears<R>{side[0], side[1], side[2]}, drilling, alive);
  out.stable_step = select(alive, step, R(std::numeric_limits<double>::infinity()));
  return out;
}

std::array<double, 3> kirchhoff_mean_bending(const std::array<Vec3d, 3>& x, const std::array<Vec3d, 3>& v,
                                             const std::array<Vec3d, 3>& w) {
  NodalMotion<double, 3> nodes;
  for (std::size_t i = 0; i < 3; ++i) {
    nodes.x[i] = x[i];
    nodes.v[i] = v[i];
    nodes.w[i] = w[i];
  }
  const Triangle<double> g(nodes.x);
  ShellRates<double> d;
  Bubbles<double>(g).bend(rates_on(g, nodes, true).side, -1, d);
  return {d.kxx, d.kyy, d.kxy};
}

NodalMass kirchhoff_nodal_mass(const std::array<Vec3d, 3>& x, double thickness, double density, double offset,
                               double mass_per_area, const ThicknessProfile& profile) {
  const Vec3d nodes[3] = {x[0], x[1], x[2]};
  const double area = Triangle<double>(nodes).area, arm = 0.5 * (profile.mass_centre - offset) * thickness;
  const double mass = area * (density * thickness + mass_per_area) / 3.0;
  const double altitude2 = length2(nodes, area, ShellLength::area_over_side, 0.0);
  const double own2 = gyration2(depth2(profile, thickness), area, altitude2);
  const double elastic_arm = 0.5 * (profile.stiffness_centre - offset) * thickness;
  return {mass, mass * std::max(own2 + arm * arm, eccentric_gyration2(elastic_arm, own2))};
}

template NodalForces<NativeBatch, 3> kirchhoff_triangle_cycle(const ShellProperties&, const LawKernel<Elastic>&,
                                                              const NodalMotion<NativeBatch, 3>&, double, double*);
template NodalForces<NativeBatch, 3> kirchhoff_triangle_cycle(const ShellProperties&,
                                                              const LawKernel<PlasticKinematic>&,
                                                              const NodalMotion<NativeBatch, 3>&, double, double*);
template NodalForces<NativeBatch, 3> kirchhoff_triangle_cycle(const ShellProperties&, const LawKernel<PiecewiseLinear>&,
                                                              const NodalMotion<NativeBatch, 3>&, double, double*);
template NodalForces<NativeBatch, 3> kirchhoff_triangle_cycle(const ShellProperties&, const LawKernel<ComposedLaw>&,
                                                              const NodalMotion<NativeBatch, 3>&, double, double*);
template NodalForces<NativeBatch, 3> kirchhoff_triangle_cycle(const ShellProperties&, const LawKernel<Laminate>&,
                                                              const NodalMotion<NativeBatch, 3>&, double, double*);

}  // namespace nugget::kernel
