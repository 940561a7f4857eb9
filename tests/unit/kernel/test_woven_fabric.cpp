// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/woven_fabric.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernel/element/membrane.hpp"
#include "kernel/law/law_components.hpp"
#include "law_point.hpp"
#include "membrane_kinds.hpp"

namespace nugget::kernel {
namespace {

constexpr double warp_modulus = 400.0, weft_modulus = 250.0, weave_poisson = 0.2, weave_shear = 20.0;

WovenFabric weave() {
  WovenFabric law;
  law.young_a = warp_modulus;
  law.young_b = weft_modulus;
  law.poisson_ba = weave_poisson;
  law.shear_ab = weave_shear;
  law.nu = 0.2;
  law.E = law.wave_modulus() * (1.0 - law.nu * law.nu);
  return law;
}

Curve points(std::vector<double> x, std::vector<double> y) {
  Curve c;
  c.x = std::move(x);
  c.y = std::move(y);
  return c;
}

const Curve soft_then_stiff = points({0.0, 0.1, 0.3}, {0.0, 10.0, 110.0}),
            steep_way_back = points({0.0, 0.1, 0.25}, {0.0, 5.0, 110.0}),
            of_the_shear = points({0.0, 0.2, 0.6}, {0.0, 2.0, 4.0});

WovenFabric weave_by_curves() {
  WovenFabric law = weave();
  law.poisson_ba = 0.0;
  law.by_curves = true;
  law.curves = {ThreadCurve(soft_then_stiff, steep_way_back), {}, ThreadCurve(of_the_shear)};
  law.E = law.wave_modulus() * (1.0 - law.nu * law.nu);
  return law;
}

/// A point whose axis a stands at an angle to x [rad], driven by gradients of deformation.
struct WovenPoint : LayerPoint<WovenFabric> {
  double xx = 1.0, xy = 0.0, yx = 0.0, yy = 1.0;  ///< the gradient now

  WovenPoint(const WovenFabric& parameters, double angle) : LayerPoint(parameters) {
    start_layer_axes(history.data(), 1, std::cos(angle), std::sin(angle));
  }
  /// By a step of which the midpoint rule makes just this.
  void to(double fxx, double fxy, double fyx, double fyy) {
    const double mxx = 0.5 * (xx + fxx), mxy = 0.5 * (xy + fxy), myx = 0.5 * (yx + fyx), myy = 0.5 * (yy + fyy);
    const double over = 1.0 / (mxx * myy - mxy * myx), dxx = fxx - xx, dxy = fxy - xy, dyx = fyx - yx, dyy = fyy - yy;
    const double lxx = over * (dxx * myy - dxy * myx), lxy = over * (dxy * mxx - dxx * mxy),
                 lyx = over * (dyx * myy - dyy * myx), lyy = over * (dyy * mxx - dyx * mxy);
    history[static_cast<std::size_t>(law.spin_field())] = 0.5 * (lyx - lxy);
    strain({lxx, lyy, lxy + lyx, 0, 0});
    xx = fxx, xy = fxy, yx = fyx, yy = fyy;
  }
};

/// Cauchy's stress F S F^T / J along x, y by the stress S of threads that stood at `angle`.
LayerTensor<double> pushed_forward(const WovenPoint& p, double angle, double sa, double sb, double sab) {
  const double c = std::cos(angle), t = std::sin(angle), j = p.xx * p.yy - p.xy * p.yx;
  const double ax = p.xx * c + p.xy * t, ay = p.yx * c + p.yy * t, bx = -p.xx * t + p.xy * c, by = -p.yx * t + p.yy * c;
  return {(sa * ax * ax + sb * bx * bx + 2 * sab * ax * bx) / j, (sa * ay * ay + sb * by * by + 2 * sab * ay * by) / j,
          (sa * ax * ay + sb * bx * by + sab * (ax * by + ay * bx)) / j, 0, 0};
}

void expect_stress(const LayerTensor<double>& s, const LayerTensor<double>& expected) {
  EXPECT_NEAR(s.xx, expected.xx, 1e-9);
  EXPECT_NEAR(s.yy, expected.yy, 1e-9);
  EXPECT_NEAR(s.xy, expected.xy, 1e-9);
}

// S = C E of Green's strain, whatever the path and however much it turned. Sabotages: the spin left out, E of small
// strains, Cauchy's stress without the area.
TEST(WovenFabric, LinearInGreensStrain) {
  for (const double angle : {0.0, 0.6}) {
    WovenPoint p(weave(), angle);
    constexpr double xx = 1.3, xy = 0.4, yx = -0.1, yy = 0.9, turn = 1.1;
    for (int i = 1; i <= 30; ++i) {
      const double a = turn * i / 30, part = i / 30.0, fxx = 1 + part * (xx - 1), fxy = part * xy, fyx = part * yx,
                   fyy = 1 + part * (yy - 1);
      p.to(std::cos(a) * fxx - std::sin(a) * fyx, std::cos(a) * fxy - std::sin(a) * fyy,
           std::sin(a) * fxx + std::cos(a) * fyx, std::sin(a) * fxy + std::cos(a) * fyy);
    }
    const double c = std::cos(angle), t = std::sin(angle);
    const double exx = 0.5 * (xx * xx + yx * yx - 1), eyy = 0.5 * (xy * xy + yy * yy - 1), exy = xx * xy + yx * yy;
    const double ea = c * c * exx + t * t * eyy + c * t * exy, eb = t * t * exx + c * c * eyy - c * t * exy,
                 eab = 2 * c * t * (eyy - exx) + (c * c - t * t) * exy;
    const double over = 1.0 / (1.0 - weave_poisson * weave_poisson * warp_modulus / weft_modulus);
    expect_stress(p.s,
                  pushed_forward(p, angle, over * warp_modulus * (ea + weave_poisson * eb),
                                 over * (weft_modulus * eb + weave_poisson * warp_modulus * ea), weave_shear * eab));
    p.to(1, 0, 0, 1);
    expect_stress(p.s, {});
  }
}

// Pulled along a thread: l S(E)/1 of the cross-section at the start, E = (l^2 - 1)/2, by the curve of loading, back and
// forth by that of unloading, shifted; the other thread by its modulus. Sabotages: the strain of l - 1, the shift left
// out, the way back without memory.
TEST(WovenFabric, FollowsTheCurvesOfItsThreads) {
  WovenPoint p(weave_by_curves(), 0.0);
  const auto nominal = [&](double e) {
    p.to(std::sqrt(1.0 + 2.0 * e), 0, 0, 1);
    return p.s.xx / p.xx;  // over l: S, as sigma = l S over an area of l
  };
  EXPECT_NEAR(nominal(0.05), 5.0, 1e-9);
  EXPECT_NEAR(nominal(0.2), 60.0, 1e-9);
  // 60 of unloading stand at 0.1 + 55/700; it is shifted by 0.2 less that.
  const double shift = 0.2 - (0.1 + 55.0 / 700.0);
  EXPECT_NEAR(nominal(0.15), 5.0 + 700.0 * (0.15 - shift - 0.1), 1e-9);
  EXPECT_NEAR(nominal(shift + 0.05), 2.5, 1e-9);
  EXPECT_NEAR(nominal(0.5 * shift), 0.0, 1e-9);
  EXPECT_NEAR(nominal(-0.05), -0.05 * 100.0, 1e-9);  // with CSE 0, by the first slope
  EXPECT_NEAR(nominal(0.15), 5.0 + 700.0 * (0.15 - shift - 0.1), 1e-9);
  EXPECT_NEAR(nominal(0.25), 85.0, 1e-9);
  EXPECT_NEAR(nominal(0.4), 160.0, 1e-9);  // beyond the end
  p.to(1.0, 0, 0, std::sqrt(1.2));
  EXPECT_NEAR(p.s.yy / p.yy, 0.1 * weft_modulus, 1e-9);
}

// A thread that is shorter than at the start has no stress with CSE 1; the other, and the shear, have theirs.
TEST(WovenFabric, ThreadsWithoutCompression) {
  WovenFabric law = weave_by_curves();
  law.no_compression = true;
  WovenPoint p(law, 0.0);
  p.to(0.9, 0, 0, 1.1);
  expect_stress(p.s, pushed_forward(p, 0.0, 0.0, 0.5 * 0.21 * weft_modulus, 0.0));
}

// x to x + g y: the thread along x keeps its length and stress 0, that along y is 1 + g^2 long; 2 E_ab = g. Back and
// beyond the shear turns its sign. Sabotages: E_ab for 2 E_ab, the frame's turn taken for the material's.
TEST(WovenFabric, ShearOfThreads) {
  for (const double angle : {0.0, 0.8}) {
    WovenPoint p(weave_by_curves(), angle);
    const double c = std::cos(angle), t = std::sin(angle);
    for (const auto& [g, sab] : {std::pair{0.1, 1.0}, std::pair{0.4, 3.0}, std::pair{-0.4, -3.0}}) {
      // Q (1 g; 0 1) Q^T with threads along Q's columns.
      p.to(1 - g * c * t, g * c * c, -g * t * t, 1 + g * c * t);
      expect_stress(p.s, pushed_forward(p, angle, 0.0, 0.5 * g * g * weft_modulus, sab));
    }
  }
}

// A ligament's force that stays falls as S = F/l over E; behind the end S stays. Sabotage: the last slope going on, by
// which the stress falls to 0 and below.
TEST(WovenFabric, ThreadOfConstantForce) {
  std::vector<double> strain{0.0}, stress{0.0};
  for (const double l : {1.05, 1.2, 1.4, 1.6}) {
    strain.push_back(0.5 * (l * l - 1.0));
    stress.push_back(30.0 / l);
  }
  WovenFabric law = weave_by_curves();
  law.curves[0].emplace(points(strain, stress));
  WovenPoint p(law, 0.0);
  for (const double l : {1.05, 1.2, 1.4, 1.6}) {
    p.to(l, 0, 0, 1);
    EXPECT_NEAR(p.s.xx, 30.0, 1e-9) << l;
  }
  p.to(3.0, 0, 0, 1);
  EXPECT_NEAR(p.s.xx, 3.0 * 30.0 / 1.6, 1e-9);
}

// Steeper than loading: fine; below it and through the same end: stretched, fine. One that lies above it gives energy.
TEST(WovenFabric, WaysBackThatGiveEnergy) {
  EXPECT_FALSE(ThreadCurve(soft_then_stiff, steep_way_back).gives_energy());
  const Curve straight = points({0.0, 0.2}, {0.0, 100.0});
  const ThreadCurve below(straight, points({0.0, 0.1, 0.2}, {0.0, 10.0, 100.0}));
  EXPECT_FALSE(below.gives_energy());
  // Reached at half the strain: 50 stand at 0.1 + 4/90 of the way back, which is drawn together to 0.1.
  EXPECT_NEAR(below.stress(0.05, 0.1), 100.0 * 0.05 * (0.1 + 0.4 / 9.0) / 0.1, 1e-9);
  EXPECT_NEAR(below.stress(0.1, 0.1), 50.0, 1e-9);
  EXPECT_TRUE(ThreadCurve(straight, points({0.0, 0.1, 0.2}, {0.0, 90.0, 100.0})).gives_energy());
}

/// Sheared along x by `g` and turned about an axis, step by step: the threads, which stood along x and y, are as long
/// as simple shear makes them, and the stress is F S F^T/J.
template <class Kind>
void sheared_and_turned(const NodalMotion<double, Kind::corners>& start, double gate) {
  constexpr double g = 0.5, turn = 2.0, dt = 1e-6;
  constexpr int steps = 2000;
  const WovenFabric law = weave_by_curves();
  Driven<ComposedLaw, Kind> d(section(1), composed_law({law}), start);
  const auto frame_of = [](const auto& x) {
    if constexpr (Kind::corners == 4)
      return shell_frame({x[0], x[1], x[2], x[3]});
    else
      return triangle_frame({x[0], x[1], x[2]});
  };
  const Frame3d first = frame_of(start.x);
  for (int column = 0; column < Kind::columns; ++column)
    start_layer_axes(d.state.data() + d.layout.history_of(0, column), 1, first.e1.x, first.e2.x);
  const Vec3d axis = unit(Vec3d{1, 2, 3});
  for (int i = 1; i <= steps; ++i) {
    for (int n = 0; n < Kind::corners; ++n) {
      Vec3d x = start.x[n];
      x.x += g * i / steps * x.y;
      x = turned(axis, turn * i / steps, x);
      d.nodes.v[n] = (1.0 / dt) * (x - d.nodes.x[n]);
      d.nodes.x[n] = x;
    }
    d.cycle(dt);
  }
  const double sa = 0.0, sb = 0.5 * g * g * weft_modulus, sab = 3.5;
  const Vec3d a = turned(axis, turn, {1, 0, 0}), b = turned(axis, turn, {g, 1, 0});
  const Frame3d last = frame_of(d.nodes.x);
  const auto stress = [&](const Vec3d& e, const Vec3d& f) {
    return sa * dot(a, e) * dot(a, f) + sb * dot(b, e) * dot(b, f) +
           sab * (dot(a, e) * dot(b, f) + dot(b, e) * dot(a, f));
  };
  for (int column = 0; column < Kind::columns; ++column) {
    const int at = d.layout.layer(0, column);
    EXPECT_NEAR(d.at(at), stress(last.e1, last.e1), gate);
    EXPECT_NEAR(d.at(at + 1), stress(last.e2, last.e2), gate);
    EXPECT_NEAR(d.at(at + 2), stress(last.e1, last.e2), gate);
  }
}

// Elements that are no squares, whose own axes do not turn with the material. Sabotage: no spin beside the element's
// axes, or half of it.
TEST(WovenFabric, SimpleShearOfElements) {
  Motion slender = square(), skewed = square();
  slender.x[1].x = slender.x[2].x = 20.0;
  skewed.x[1] = {12, -1, 0};
  skewed.x[2] = {9, 6, 0};
  skewed.x[3] = {-2, 4, 0};
  for (const Motion& start : {slender, skewed}) {
    sheared_and_turned<OnePointMembrane>(start, 2e-4);
    sheared_and_turned<FullMembrane>(start, 2e-4);
  }
  NodalMotion<double, 3> triangle;
  triangle.x[1] = {9, 2, 0};
  triangle.x[2] = {1, 4, 0};
  sheared_and_turned<TriangleMembrane>(triangle, 2e-4);
}

// A warped element that tumbles as a rigid body: its points keep their stress.
TEST(WovenFabric, RigidTumblingOfAWarpedElement) {
  Motion start = square();
  start.x[2].z = 1.5;
  start.x[0].z = 0.5;
  Driven<ComposedLaw, FullMembrane> d(section(1), composed_law({weave()}), start);
  for (int column = 0; column < 4; ++column)
    start_layer_axes(d.state.data() + d.layout.history_of(0, column), 1, 1.0, 0.0);
  constexpr double dt = 1e-6;
  Motion stretched = start;
  for (Vec3d& x : stretched.x) x = {1.2 * x.x + 0.1 * x.y, x.y, x.z};
  for (int i = 0; i < 4; ++i) {
    d.nodes.v[i] = (1.0 / dt) * (stretched.x[i] - d.nodes.x[i]);
    d.nodes.x[i] = stretched.x[i];
  }
  d.cycle(dt);
  const std::vector<double> before = d.state;
  constexpr int steps = 2000;
  for (int i = 1; i <= steps; ++i) {
    for (int n = 0; n < 4; ++n) {
      const Vec3d x = turned(unit(Vec3d{2, 1, 0}), 2.0 * M_PI * i / steps, stretched.x[n]);
      d.nodes.v[n] = (1.0 / dt) * (x - d.nodes.x[n]);
      d.nodes.x[n] = x;
    }
    d.cycle(dt);
  }
  // All but the spin, which is that of a step: the gradient has not turned beside the element.
  for (int column = 0; column < 4; ++column) {
    const auto spin = static_cast<std::size_t>(d.layout.history_of(0, column) + d.law.spin_field());
    EXPECT_GT(std::abs(before[spin]), 1.0);
    EXPECT_NEAR(d.state[spin], 0.0, 1e-6);
    d.state[spin] = before[spin];
  }
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR(d.state[i], before[i], 1e-9 * (1.0 + std::abs(before[i])));
}

TEST(WovenFabric, BatchGivesTheBitsOfEachAlone) {
  constexpr int W = native_width;
  for (const bool by_curves : {false, true}) {
    WovenFabric law = by_curves ? weave_by_curves() : weave();
    law.no_compression = true;
    law.liner_young = 60.0;
    law.liner_share = 0.1;
    law.damping = 0.1;
    const LawKernel<WovenFabric> kernel(law);
    std::vector<double> together(static_cast<std::size_t>(kernel.layer_history()) * W);
    std::vector<WovenPoint> alone;
    LayerTensor<NativeBatch> s{};
    Random random;
    for (int l = 0; l < W; ++l) {
      alone.emplace_back(law, 0.3 * l);
      start_layer_axes(together.data() + l, W, std::cos(0.3 * l), std::sin(0.3 * l));
    }
    for (int cycle = 0; cycle < 200; ++cycle) {
      LayerTensor<NativeBatch> rate{};
      for (int l = 0; l < W; ++l) {
        WovenPoint& one = alone[static_cast<std::size_t>(l)];
        const LayerTensor<double> d{0.02 * random(), 0.02 * random(), 0.02 * random(), 0, 0};
        const double spin = 0.02 * random();
        one.history[static_cast<std::size_t>(kernel.spin_field())] = spin;
        together[static_cast<std::size_t>(kernel.spin_field() * W + l)] = spin;
        one.strain(d);
        set_lane(rate.xx, l, d.xx);
        set_lane(rate.yy, l, d.yy);
        set_lane(rate.xy, l, d.xy);
      }
      kernel.layer<NativeBatch>(s, rate, 1.0, together.data());
      for (int l = 0; l < W; ++l) {
        const WovenPoint& one = alone[static_cast<std::size_t>(l)];
        ASSERT_EQ(lane(s.xx, l), one.s.xx);
        ASSERT_EQ(lane(s.yy, l), one.s.yy);
        ASSERT_EQ(lane(s.xy, l), one.s.xy);
        ASSERT_EQ(lane(kernel.layer_modulus<NativeBatch>(together.data()), l),
                  kernel.layer_modulus<double>(one.history.data()));
      }
    }
  }
}

// A square alone that is drawn along a thread by l: it vibrates along it by d(l S)/dl = S + l^2 C of its first length,
// and no faster otherwise. Sabotage: the modulus at the start.
TEST(WovenFabric, StepWhereItIsStretched) {
  WovenFabric law = weave();
  law.poisson_ba = 0.0;
  law.E = law.wave_modulus() * (1.0 - law.nu * law.nu);
  Driven<ComposedLaw, FullMembrane> d(section(1), composed_law({law}), square());
  for (int column = 0; column < 4; ++column)
    start_layer_axes(d.state.data() + d.layout.history_of(0, column), 1, 1.0, 0.0);
  EXPECT_NEAR(d.step(0.0).stable_step, 5.0 / std::sqrt(warp_modulus / steel_density), 1e-9);
  constexpr double dt = 1e-6, l = 1.4;
  for (int i = 0; i < 4; ++i) d.nodes.v[i] = {(l - 1.0) / dt * d.nodes.x[i].x, (l - 1.0) / dt * d.nodes.x[i].y, 0};
  const double e = 0.5 * (l * l - 1.0), c = std::sqrt((warp_modulus * e + l * l * warp_modulus) / steel_density);
  EXPECT_NEAR(d.step(dt).stable_step, 5.0 / c, 1e-6 * 5.0 / c);
}

}  // namespace
}  // namespace nugget::kernel
