// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/c0_triangle.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/element/gyration.hpp"
#include "kernel/element/triangle.hpp"
#include "kernel/law/laminate_kernel.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {
namespace {

/// Force against the shear that varies over the element, the sum of the shears around its sides, which leaves the shear
/// at the point alone: that of Lee and Bathe's MITC3, integrated, kappa G t (sum of sides^2) / (144 A). Twice its power
/// is added to `power`.
template <class R>
[[gnu::always_inline]] inline R resist_around(const ShellProperties& shell, const ElasticConstants& e,
                                              const Triangle<R>& g, const R& around, double dt, double* state,
                                              R& power) {
  const R gt = e.shear * dt * load_field<R>(state, ShellLayout::thickness);
  const R sides2 =
      2.0 * (g.x21 * g.x21 + g.y21 * g.y21 + g.x31 * g.x31 + g.y31 * g.y31 - g.x31 * g.x21 - g.y31 * g.y21);
  return resist(3, (shell.shear_factor / 144.0) * gt * sides2 / g.area, around, state, power);
}

/// Forces on the shears of the sides that do the work of the shear at the point and of the one around them.
template <class R>
[[gnu::always_inline]] inline SideShears<R> on_the_sides(const Triangle<R>& g, const ShellResultants<R>& n,
                                                         const R& around) {
  const R along = g.area * (g.x2 * n.qx + g.y2 * n.qy), across = g.area * (g.x3 * n.qx + g.y3 * n.qy),
          third = (1.0 / 3.0) * (across - along);
  return {along + third + around, across - third - around, third + around};
}

}  // namespace

template <class R, class Law>
NodalForces<R, 3> triangle_cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                 const NodalMotion<R, 3>& nodes, double dt, double* state) {
  using L = ShellLayout;
  const ElasticConstants& e = law.elastic();
  auto alive = load_field<R>(state, L::alive) > 0.5;

  const R half = R(0.5 * dt);
  Vec3<R> middle[3];
  for (int i = 0; i < 3; ++i) middle[i] = nodes.x[i] - half * nodes.v[i];
  const Triangle<R> mid(middle), end(nodes.x);

  TriangleRates<R> rates = rates_on(mid, nodes, alive);
  const auto& [s12, s13, s23] = rates.side;
  const R third = (1.0 / 3.0) * (s13 - s12 - s23);
  rates.constant.xz = mid.dx(s12 + third, s13 - third);
  rates.constant.yz = mid.dy(s12 + third, s13 - third);
  R drilling[3]{}, around{};
  if (shell.drilling > 0.0) {
    R power{};
    resist_drilling(shell, e, mid.area, rates.spin, dt, state, drilling, power);
    around = resist_around(shell, e, mid, s12 + s23 - s13, dt, state, power);
    store_field(state, L::hourglass_energy, load_field<R>(state, L::hourglass_energy) + (0.5 * dt) * power);
  }
  ShellResultants<R> n = advance_layers(shell, law, shell_layout(shell, law), rates.constant, dt, state, alive);
  if (shell.bulk_quadratic != 0.0 || shell.bulk_linear != 0.0) {
    const R viscous = viscous_membrane(shell, law, rates.constant.xx + rates.constant.yy, end.area, state);
    n.nxx -= viscous;
    n.nyy -= viscous;
  }

  const R scale = load_field<R>(state, L::density_scale) * (shell.density / e.plane) /
                  stiffening<R>(law, shell_layout(shell, law), state);
  const R step = sqrt(length2(nodes.x, end.area, shell.length, e.nu) * scale);
  if (law.deletion_step() > 0.0) alive = alive && step >= law.deletion_step();
  if (law.can_fail() || law.deletion_step() > 0.0) store_field(state, L::alive, select(alive, R(1.0), R(0.0)));

  NodalForces<R, 3> out = forces_on(end, n, on_the_sides(end, n, around), drilling, alive);
  out.stable_step = select(alive, step, R(std::numeric_limits<double>::infinity()));
  return out;
}

namespace {

Triangle<double> geometry_of(const std::array<Vec3d, 3>& x) {
  const Vec3d nodes[3] = {x[0], x[1], x[2]};
  return Triangle<double>(nodes);
}

}  // namespace

Frame3d triangle_frame(const std::array<Vec3d, 3>& x) {
  return geometry_of(x).frame;
}

namespace {

struct GreatestShear {
  double by_motion, by_spin;  ///< [1/length^2], [1]
};

/// Largest square of the shear at the point, by unit velocities normal to the plane and by unit spins of the nodes: the
/// mode of transverse shear has w^2 = 3 kappa G / rho (by_motion + by_spin / r^2), or less.
GreatestShear greatest_shear(const std::array<Vec3d, 3>& x) {
  const Triangle<double> g = geometry_of(x);
  // Along a = x2 - x1 and b = x3 - x1 the shear is that of the sides less a third of what goes around (rates_on): by
  // the velocity of each node, and by its slope as a vector.
  const std::array<double, 2> a{g.x21, g.y21}, b{g.x31, g.y31}, c{b[0] - a[0], b[1] - a[1]};
  std::array<double, 4> motion{2.0, 1.0, 1.0, 2.0}, spin{};  // products along a and b
  for (const std::size_t i : {0u, 1u}) {
    const double along_a[] = {0.5 * a[i] + c[i] / 6.0, 0.5 * a[i] - b[i] / 6.0, a[i] / 6.0};
    const double along_b[] = {0.5 * b[i] - c[i] / 6.0, b[i] / 6.0, 0.5 * b[i] - a[i] / 6.0};
    for (const std::size_t k : {0u, 1u, 2u}) {
      spin[0] += along_a[k] * along_a[k];
      spin[1] += along_a[k] * along_b[k];
      spin[3] += along_b[k] * along_b[k];
    }
  }
  spin[2] = spin[1];
  const auto largest = [&](const std::array<double, 4>& p) {
    // To the axes, as a gradient.
    const double xx = g.x2 * g.x2 * p[0] + 2.0 * g.x2 * g.x3 * p[1] + g.x3 * g.x3 * p[3];
    const double xy = g.x2 * g.y2 * p[0] + (g.x2 * g.y3 + g.x3 * g.y2) * p[1] + g.x3 * g.y3 * p[3];
    const double yy = g.y2 * g.y2 * p[0] + 2.0 * g.y2 * g.y3 * p[1] + g.y3 * g.y3 * p[3];
    return 0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy);
  };
  return {largest(motion), largest(spin)};
}

}  // namespace

double triangle_area(const std::array<Vec3d, 3>& x) {
  return geometry_of(x).area;
}

double triangle_stable_step(const std::array<Vec3d, 3>& x, ShellLength length, double E, double nu, double density) {
  const Vec3d nodes[3] = {x[0], x[1], x[2]};
  return std::sqrt(length2(nodes, triangle_area(x), length, nu) * density * (1.0 - nu * nu) / E);
}

NodalMass triangle_nodal_mass(const std::array<Vec3d, 3>& x, double thickness, double density, double offset,
                              double mass_per_area, double shear_share, const ThicknessProfile& profile) {
  const double area = triangle_area(x), arm = 0.5 * (profile.mass_centre - offset) * thickness;
  const double mass = area * (density * thickness + mass_per_area) / 3.0;
  const double section2 = thickness * thickness / 12.0;
  double gyration2 = std::max(profile.mass_spread * section2, area / 8.0) + arm * arm;
  if (shear_share > 0.0) {
    gyration2 = std::max(gyration2, elastic_gyration2(profile, offset, thickness, section2));
    const auto [by_motion, by_spin] = greatest_shear(x);
    const Vec3d nodes[3] = {x[0], x[1], x[2]};
    const double altitude2 = length2(nodes, area, ShellLength::area_over_side, 0.0);
    const double stable = 4.0 / (stable_courant_number * stable_courant_number * altitude2);
    if (const double left = stable / (3.0 * shear_share) - by_motion; left > 0.0)
      gyration2 = std::max(gyration2, by_spin / left);
  }
  return {mass, mass * gyration2};
}

template NodalForces<NativeBatch, 3> triangle_cycle(const ShellProperties&, const LawKernel<Elastic>&,
                                                    const NodalMotion<NativeBatch, 3>&, double, double*);
template NodalForces<NativeBatch, 3> triangle_cycle(const ShellProperties&, const LawKernel<PlasticKinematic>&,
                                                    const NodalMotion<NativeBatch, 3>&, double, double*);
template NodalForces<NativeBatch, 3> triangle_cycle(const ShellProperties&, const LawKernel<PiecewiseLinear>&,
                                                    const NodalMotion<NativeBatch, 3>&, double, double*);
template NodalForces<NativeBatch, 3> triangle_cycle(const ShellProperties&, const LawKernel<ComposedLaw>&,
                                                    const NodalMotion<NativeBatch, 3>&, double, double*);
template NodalForces<NativeBatch, 3> triangle_cycle(const ShellProperties&, const LawKernel<Laminate>&,
                                                    const NodalMotion<NativeBatch, 3>&, double, double*);

}  // namespace nugget::kernel
