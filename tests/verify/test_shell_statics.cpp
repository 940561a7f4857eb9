// SPDX-License-Identifier: Apache-2.0
// Linear statics of shells by the tangents of the explicit kernels: the problems of MacNeal and Harder (1985) and
// others. ELFORM 16 throughout, as NVH and impact with IHQ 8 compute it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "experiment.hpp"
#include "statics.hpp"

namespace nugget::verify {
namespace {

using std::numbers::pi;

constexpr int ux = 0, uy = 1, uz = 2, rx = 3, ry = 4, rz = 5;

/// Shares of a unit load on the n + 1 nodes of a side, consistent with a uniform one.
double share(int i, int n) {
  return (i == 0 || i == n ? 0.5 : 1.0) / n;
}

// ---- patch tests

/// The distorted patch of five elements: outer corners first, then the inner ones.
Statics patch() {
  Statics s({1e6, 0.25}, 0.001);
  s.add({{0, 0, 0},
         {0.24, 0, 0},
         {0.24, 0.12, 0},
         {0, 0.12, 0},
         {0.04, 0.02, 0},
         {0.18, 0.03, 0},
         {0.16, 0.08, 0},
         {0.08, 0.08, 0}},
        {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}});
  return s;
}

/// Prescribes the motion of the outer nodes and gives all nodes' (error of the inner ones is what is tested).
template <class Field>
void hold_outside(Statics& s, const Field& field) {
  for (int n = 0; n < 4; ++n) {
    const std::array<double, 6> u = field(s.x[n]);
    for (int dof = 0; dof < 6; ++dof) s.hold(n, {dof}, u[dof]);
  }
}

// Sabotage: the weight A/4 of the points taken as their own Jacobian.
TEST(ShellStatics, MembranePatch) {
  for (const ShellKind kind : {ShellKind::full, ShellKind::one_point}) {
    Statics s = patch();
    s.use(kind);
    hold_outside(s, [](const Vec3d& p) {
      return std::array<double, 6>{1e-3 * (p.x + 0.5 * p.y), 1e-3 * (p.y + 0.5 * p.x), 0, 0, 0, 0};
    });
    const Eigen::VectorXd u = s.solve();
    double worst_xx = 1333.3333333, worst_xy = 400.0;
    for (std::size_t e = 0; e < s.shells.size(); ++e)
      for (const auto& stress : s.stresses(u, e)) {
        for (std::size_t c : {0u, 1u})
          if (std::abs(stress[c] - 1333.3333333) > std::abs(worst_xx - 1333.3333333)) worst_xx = stress[c];
        if (std::abs(stress[3] - 400.0) > std::abs(worst_xy - 400.0)) worst_xy = stress[3];
      }
    const std::string name = fmt::format("membrane patch, ELFORM {}: ", elform(kind));
    expect_reference("membrane patch", name + "direct stress, worst point", worst_xx, 4000.0 / 3.0, 1e-6);
    expect_reference("membrane patch", name + "shear stress, worst point", worst_xy, 400.0, 1e-6);
  }
}

// Sabotage: the weight A/4 of the points taken as their own Jacobian.
TEST(ShellStatics, BendingPatch) {
  Statics s = patch();
  hold_outside(s, [](const Vec3d& p) {
    return std::array<double, 6>{
        0, 0, 0.5e-3 * (p.x * p.x + p.x * p.y + p.y * p.y), 1e-3 * (p.y + 0.5 * p.x), -1e-3 * (p.x + 0.5 * p.y), 0};
  });
  const Eigen::VectorXd u = s.solve();
  // Gauss layers stand at t / (2 sqrt 3); the stress at the surface is sqrt 3 times theirs.
  const double surface = std::sqrt(3.0), xx = 2.0 / 3.0, xy = 0.2;
  double worst_xx = xx, worst_xy = xy;
  for (std::size_t e = 0; e < s.shells.size(); ++e)
    for (const auto& stress : s.stresses(u, e)) {
      for (std::size_t c : {0u, 1u}) {
        const double value = surface * std::abs(stress[c]);
        if (std::abs(value - xx) > std::abs(worst_xx - xx)) worst_xx = value;
      }
      const double value = surface * std::abs(stress[3]);
      if (std::abs(value - xy) > std::abs(worst_xy - xy)) worst_xy = value;
    }
  expect_reference("bending patch", "bending patch, ELFORM 16: direct stress at the surface, worst point", worst_xx, xx,
                   1e-4);
  expect_reference("bending patch", "bending patch, ELFORM 16: shear stress at the surface, worst point", worst_xy, xy,
                   1e-4);
}

// ---- beams

/// A strip with its root, u = 0, held, and a unit load spread over its end.
struct Beam : Statics {
  int n, m;
  Beam(const kernel::Elastic& elastic, double t, int along, int across,
       const std::function<Vec3d(double, double)>& surface)
      : Statics(elastic, t), n(along), m(across) {
    grid(n, m, surface);
    for (int j = 0; j <= m; ++j) hold(j * (n + 1), {0, 1, 2, 3, 4, 5});
  }
  int tip(int j) const { return j * (n + 1) + n; }
  /// Mean displacement of the end in the direction of a unit force on it.
  double deflection(int dof, double size = 1.0) {
    for (int j = 0; j <= m; ++j) load(tip(j), dof, size * share(j, m));
    const Eigen::VectorXd u = solve();
    double sum = 0.0;
    for (int j = 0; j <= m; ++j) sum += share(j, m) * u(6 * tip(j) + dof);
    return sum;
  }
};

// Sabotage: the in-plane bending patterns given the full strains of the bilinear field (locks); drilling taken against
// the rotation at the centre alone (in-plane shear stiffens with the drilling stiffness).
TEST(ShellStatics, StraightCantilever) {
  const auto beam = [](int along, int across) {
    return Beam({1e7, 0.3}, 0.1, along, across, [](double u, double v) { return Vec3d{6 * u, 0.2 * v, 0}; });
  };
  expect_reference("straight cantilever", "straight cantilever of 6 shells: extension", beam(6, 1).deflection(ux),
                   3.0e-5, 0.03);
  expect_reference("straight cantilever", "straight cantilever of 6 shells: in-plane shear", beam(6, 1).deflection(uy),
                   0.1081, 0.03);
  expect_reference("straight cantilever", "straight cantilever of 6 shells: out-of-plane shear",
                   beam(6, 1).deflection(uz), 0.4321, 0.03);
  Beam stiffer = beam(6, 1);
  stiffer.shell.drilling *= 1000.0;
  expect_reference("straight cantilever", "the same with the drilling stiffness times 1000: in-plane shear",
                   stiffer.deflection(uy), 0.1081, 0.03);
}

double twist(int along, int across) {
  Beam b({1e7, 0.3}, 0.1, along, across, [](double u, double v) { return Vec3d{6 * u, 0.2 * (v - 0.5), 0}; });
  for (int j = 0; j <= across; ++j) b.load(b.tip(j), rx, share(j, across));
  const Eigen::VectorXd u = b.solve();
  return (u(6 * b.tip(across) + uz) - u(6 * b.tip(0) + uz)) / 0.2;
}
// One row of shells is 6 % too stiff in twist, as all quadrilaterals with one point less than a quadratic field are; so
// rows enough to see the stress across the width are taken here and in the curved beam.
TEST(ShellStatics, TwistOfTheStraightCantilever) {
  expect_reference("straight cantilever", "straight cantilever of 24 x 4 shells: twist", twist(24, 4), 0.03208, 0.03);
}

TEST(ShellStatics, CurvedBeam) {
  const auto beam = [](int along, int across) {
    return Beam({1e7, 0.25}, 0.1, along, across, [](double u, double v) {
      const double r = 4.12 + 0.2 * v, a = 0.5 * pi * u;
      return Vec3d{r * std::sin(a), r * std::cos(a), 0};
    });
  };
  expect_reference("curved beam", "curved beam of 24 shells: in-plane load", beam(24, 1).deflection(ux), 0.08734, 0.02);
  expect_reference("curved beam", "curved beam of 24 x 6 shells: load out of plane", beam(24, 6).deflection(uz), 0.5022,
                   0.02);
}

// Sabotage: nodal spins about the normal of a warped element left in its curvature.
TEST(ShellStatics, TwistedBeam) {
  struct Case {
    double t, force, along, across;
  };
  for (const Case& c : {Case{0.32, 1.0, 5.4245e-3, 1.75325e-3}, {0.0032, 1e-6, 5.256e-3, 1.294e-3}}) {
    const auto beam = [&c] {
      return Beam({29e6, 0.22}, c.t, 12, 2, [](double u, double v) {
        const double a = 0.5 * pi * u, y = 1.1 * (v - 0.5);
        return Vec3d{12 * u, y * std::cos(a), y * std::sin(a)};
      });
    };
    const std::string name = fmt::format("twisted beam of 12 x 2 shells, t = {}: load ", c.t);
    expect_reference("twisted beam", name + "along the width of the end", beam().deflection(uz, c.force), c.along,
                     0.03);
    expect_reference("twisted beam", name + "across it", beam().deflection(uy, c.force), c.across, 0.03);
  }
}

/// In 8 + 48 shells along its two arcs, 12 across, each divided in `n`.
double hook_deflection(int n) {
  const int first = 8 * n, second = 48 * n, across = 12 * n;
  Beam hook({3300, 0.35}, 2.0, first + second, across, [&](double u, double v) {
    const double i = u * (first + second), z = 20.0 * v;
    if (i <= first) {
      const double a = pi / 3.0 * i / first;
      return Vec3d{14.0 * std::sin(a), 14.0 * (std::cos(a) - 1.0), z};
    }
    // The second arc goes on from there, bent the other way.
    const double a = 5.0 * pi / 6.0 * (i - first) / second, start = pi / 3.0;
    const Vec3d end{14.0 * std::sin(start), 14.0 * (std::cos(start) - 1.0), z},
        out{std::sin(start), std::cos(start), 0};
    const double turned = start - a;
    return end + 46.0 * (out - Vec3d{std::sin(turned), std::cos(turned), 0});
  });
  return hook.deflection(uz);
}
// Shells of t, and of t / 2, whose drilling stiffness goes with their area. Sabotage: a hundredth of that.
TEST(ShellStatics, RaaschHook) {
  expect_reference("Raasch hook", "Raasch hook of 56 x 12 shells: deflection", hook_deflection(1), 5.0220, 0.04);
  expect_reference("Raasch hook", "Raasch hook of 112 x 24 shells: deflection", hook_deflection(2), 5.0220, 0.01);
}

// ---- shells

TEST(ShellStatics, ScordelisLoRoof) {
  for (int n : {8, 16}) {
    Statics s({4.32e8, 0.0}, 0.25);
    s.grid(n, n, [](double u, double v) {  // quarter: u from the diaphragm to the middle, v from the crown to the edge
      const double a = 40.0 / 180.0 * pi * v;
      return Vec3d{25.0 * u, 25.0 * std::sin(a), 25.0 * std::cos(a)};
    });
    for (int k = 0; k <= n; ++k) {
      s.hold(k * (n + 1), {uy, uz});          // diaphragm
      s.hold(k * (n + 1) + n, {ux, ry, rz});  // middle
      s.hold(k, {uy, rx, rz});                // crown
    }
    s.distribute({0, 0, -90.0});
    expect_reference("Scordelis-Lo roof", fmt::format("Scordelis-Lo roof, {0} x {0} on a quarter: free edge", n),
                     -s.solve()(6 * (n * (n + 1) + n) + uz), 0.3024, 0.03);
  }
}

TEST(ShellStatics, HemisphereWithAHole) {
  for (int n : {8, 16}) {
    Statics s({6.825e7, 0.3}, 0.04);
    s.grid(n, n, [](double u, double v) {
      const double a = 0.5 * pi * u, b = 72.0 / 180.0 * pi * v;
      return Vec3d{10 * std::cos(a) * std::cos(b), 10 * std::sin(a) * std::cos(b), 10 * std::sin(b)};
    });
    for (int k = 0; k <= n; ++k) {
      s.hold(k * (n + 1), {uy, rx, rz});
      s.hold(k * (n + 1) + n, {ux, ry, rz});
    }
    s.hold(0, {uz});
    s.load(0, ux, 1.0);
    s.load(n, uy, -1.0);
    const Eigen::VectorXd u = s.solve();
    expect_reference("hemisphere with a hole", fmt::format("hemisphere with a hole, {0} x {0} on a quarter", n), u(ux),
                     0.094, 0.04);
  }
}

TEST(ShellStatics, PinchedCylinder) {
  for (int n : {16, 32}) {
    Statics s({3e6, 0.3}, 3.0);
    s.grid(n, n, [](double u, double v) {  // octant: u from the diaphragm to the middle
      const double a = 0.5 * pi * v;
      return Vec3d{300.0 * u, 300.0 * std::sin(a), 300.0 * std::cos(a)};
    });
    for (int k = 0; k <= n; ++k) {
      s.hold(k * (n + 1), {uy, uz});
      s.hold(k * (n + 1) + n, {ux, ry, rz});
      s.hold(k, {uy, rx, rz});
      s.hold(n * (n + 1) + k, {uz, rx, ry});
    }
    s.load(n, uz, -0.25);
    expect_reference("pinched cylinder", fmt::format("pinched cylinder, {0} x {0} on an octant", n),
                     -s.solve()(6 * n + uz), 1.82488e-5, n == 16 ? 0.08 : 0.05);
  }
}

TEST(ShellStatics, ZSectionInTorsion) {  // NAFEMS LE5
  const int n = 40, flange = 4, web = 8, m = 2 * flange + web;
  Beam z({210e9, 0.3}, 0.1, n, m, [&](double u, double v) {
    const double i = v * m;
    if (i <= flange) return Vec3d{10 * u, -1.0 + i / flange, -1.0};
    if (i >= flange + web) return Vec3d{10 * u, (i - flange - web) / flange, 1.0};
    return Vec3d{10 * u, 0.0, -1.0 + 2.0 * (i - flange) / web};
  });
  for (int k = 0; k <= flange; ++k) {
    z.load(z.tip(k), uy, 0.6e6 * share(k, flange));
    z.load(z.tip(m - k), uy, -0.6e6 * share(k, flange));
  }
  const Eigen::VectorXd u = z.solve();
  // Axial mid-surface stress at x = 2.5 on the free edge: mean of the two cells beside it, in the two outer rows,
  // drawn on to the edge.
  const auto axial = [&](int row) {
    double sum = 0.0;
    for (int column : {n / 4 - 1, n / 4}) {
      const auto stress = z.stresses(u, at(row * n + column));
      for (const auto& s : stress) sum += s[0] / static_cast<double>(2 * stress.size());
    }
    return sum;
  };
  const double edge = 1.5 * axial(0) - 0.5 * axial(1);
  expect_reference("Z-section in torsion (LE5)", "LE5 Z-section: axial stress at the flange's edge, x = 2.5 m [MPa]",
                   -std::abs(edge) * 1e-6, -108.0, 0.04);
}

TEST(ShellStatics, ClampedCircularPlate) {
  const double a = 10.0, E = 1e7, nu = 0.3;
  for (double t : {0.1, 2.0}) {
    const int n = 12;
    Statics s({E, nu}, t);
    s.grid(n, n, [&](double u, double v) {  // quarter: the sides u = 1 and v = 1 become the circle
      const double p = std::max(u, v), q = std::hypot(u, v), round = q > 0.0 ? 1.0 + p * (p / q - 1.0) : 1.0;
      return Vec3d{a * u * round, a * v * round, 0};
    });
    for (int k = 0; k <= n; ++k) {
      s.hold(k, {uy, rx, rz});
      s.hold(k * (n + 1), {ux, ry, rz});
      s.hold(n * (n + 1) + k, {ux, uy, uz, rx, ry, rz});
      s.hold(k * (n + 1) + n, {ux, uy, uz, rx, ry, rz});
    }
    s.distribute({0, 0, 1.0});
    const double D = E * t * t * t / (12 * (1 - nu * nu));
    const double exact = a * a * a * a / (64 * D) * (1.0 + 3.2 / (1.0 - nu) * t * t / (a * a));
    expect_reference("clamped circular plate",
                     fmt::format("clamped circular plate, t / a = {}: deflection of the centre", t / a),
                     s.solve()(uz) / exact, 1.0, 0.02);
  }
}

}  // namespace
}  // namespace nugget::verify
