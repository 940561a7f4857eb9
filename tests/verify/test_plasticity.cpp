// SPDX-License-Identifier: Apache-2.0
// Elastic-plastic transients: waves in a bilinear rod, the Balmer-Witmer beam, the Taylor bar.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

// Elastic-plastic wave in a rod. The theory is that of small strains: the stress times the strain rate must not add to
// the hardening, which is a hundredth of Young's modulus. So all stresses and velocities are a thousandth of the
// case's, and so are the references. Sabotage: the return to the yield surface with 2G instead of 3G.
TEST(Plasticity, WavesInABilinearRod) {
  constexpr double thousandth = 1e-3, end = 1.9334e-4;
  constexpr int cells = 500;  // of 2 mm
  Specimen s;
  s.card("MAT_PLASTIC_KINEMATIC", {1, 7.85e-9, 210000.0, 0.3, 300.0 * thousandth, 2100.0, 1.0}).text(fields({}));
  s.card("SECTION_SOLID", {1, 1}).part(1, 1, 1);
  const Grid grid = s.bricks(1, {}, {1000.0, 4.0, 4.0}, {cells, 1, 1});
  s.node_set(1, grid.across(0)).text(constant_curve(1));
  s.card("BOUNDARY_PRESCRIBED_MOTION_SET", {1, 1, 0, 1, -20000.0 * thousandth}).card("CONTROL_TERMINATION", {end});
  Experiment experiment(s.deck());

  // The state at the end: mean values between the fronts, and where the stress passes half of each step.
  TimeMean precursor, particle, behind, strain;
  Passage plastic_front(0.5 * 0.024139 * thousandth), elastic_front(0.5 * 300.0 * thousandth);
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.time < end) return;
    for (int e = 1; e <= cells; ++e) {
      const double x = 1000.0 * (e - 0.5) / cells;
      const system::ElementGroup::Layer layer = brick_layer(experiment, now, e);
      plastic_front.add(x, layer.plastic_strain);
      if (x > 500.0) elastic_front.add(x, layer.stress[0]);
      if (x > 20.0 && x < 80.0) behind.add(layer.stress[0], 1.0), strain.add(layer.plastic_strain, 1.0);
      if (x > 200.0 && x < 900.0)
        precursor.add(layer.stress[0], 1.0), particle.add(-experiment.velocity(now, grid(e, 0)).x, 1.0);
    }
  });
  ASSERT_TRUE(plastic_front.seen() && elastic_front.seen());
  expect_reference("elastic-plastic wave in a rod", "bilinear rod, in thousandths: stress of the precursor [MPa]",
                   precursor.value() / thousandth, 300.0, 0.01);
  expect_reference("elastic-plastic wave in a rod", "bilinear rod, in thousandths: its particle velocity [mm/s]",
                   particle.value() / thousandth, 7388.85, 0.01);
  expect_reference("elastic-plastic wave in a rod",
                   "bilinear rod, in thousandths: stress behind the plastic front [MPa]", behind.value() / thousandth,
                   351.203, 0.01);
  expect_reference("elastic-plastic wave in a rod", "bilinear rod, in thousandths: plastic strain there",
                   strain.value() / thousandth, 0.024139, 0.01);
  expect_reference("elastic-plastic wave in a rod", "bilinear rod: place of the elastic front [mm]",
                   elastic_front.time(), 1000.0, 0.02);
  expect_reference("elastic-plastic wave in a rod", "bilinear rod: place of the plastic front [mm]",
                   plastic_front.time(), 100.0, 0.02);
}

// Balmer-Witmer beam, in, lbf, s. Half of the span, one row of shells across, free to contract; ten layers. The node at
// the edge of the loaded part gets half of the velocity, as half of its mass is loaded. Sabotage: the factor 1/4 of the
// spins in the transverse shear strain taken as 1/2.
TEST(Plasticity, BalmerWitmerBeam) {
  constexpr int cells = 50;
  constexpr double end = 2.0e-3;
  Specimen s;
  s.card("MAT_PLASTIC_KINEMATIC", {1, 2.61e-4, 1.04e7, 0.3, 41400.0, 0.0, 1.0}).text(fields({}));
  s.text("*SECTION_SHELL\n" + fields({1, 2, 5.0 / 6.0, 10}) + fields({0.125, 0.125, 0.125, 0.125})).part(1, 1, 1);
  const Grid grid = s.shells(1, {}, {5.0, 0.6, 0.0}, cells, 3);
  s.node_set(1, grid.across(cells)).card("BOUNDARY_SPC_SET", {1, 0, 1, 0, 1, 1, 1, 1});
  s.node_set(2, grid.across(0)).card("BOUNDARY_SPC_SET", {2, 0, 1, 0, 0, 0, 1, 1});
  std::vector<int> middle;
  for (int i = 0; i <= cells; ++i) middle.push_back(grid(i, 0));
  s.node_set(3, middle).card("BOUNDARY_SPC_SET", {3, 0, 0, 1, 0, 1, 0, 1});
  for (int i = 0; i <= cells / 5; ++i)
    for (int id : grid.across(i)) s.card("INITIAL_VELOCITY_NODE", {1.0 * id, 0, 0, i < cells / 5 ? 5000.0 : 2500.0});
  s.card("CONTROL_HOURGLASS", {4, 0.1}).card("CONTROL_TERMINATION", {end});
  Experiment experiment(s.deck());

  double peak = 0.0, when = 0.0, ratio = 0.0;
  TimeMean late;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const double w = experiment.displacement(now, grid(0, 0)).z;
    if (when == 0.0 && experiment.velocity(now, grid(0, 0)).z < 0.0) when = now.state.time;
    peak = std::max(peak, w);
    if (now.state.time > 1.2e-3) late.add(w, now.state.dt);
    ratio = std::max(ratio, std::abs(now.energy.ratio() - 1.0));
  });
  expect_reference("Balmer-Witmer beam", "Balmer-Witmer beam, 50 x 3 shells: peak deflection of the middle [in]", peak,
                   0.737, 0.04);
  expect_reference("Balmer-Witmer beam", "Balmer-Witmer beam, 50 x 3 shells: first rest of the middle [s]", when,
                   4.80e-4, 0.04);
  expect_reference("Balmer-Witmer beam", "Balmer-Witmer beam, 50 x 3 shells: mean deflection after 1.2 ms [in]",
                   late.value(), 0.69, 0.04);
  expect_reference("Balmer-Witmer beam", "Balmer-Witmer beam, 50 x 3 shells: energy ratio", 1.0 + ratio, 1.0, 1e-3);
}

/// A quarter of a disc cut into 3 n^2 quadrilaterals: a square of n x n by the axis, bent outwards, and n rings of it.
class QuarterDisc {
 public:
  QuarterDisc(double radius, int n) : radius_(radius), n_(n) {}
  int n() const { return n_; }
  /// Core, i and j from 0 to n.
  Vec3d core(int i, int j) const {
    const double u = core_ * i / n_, v = core_ * j / n_;
    // Bent so that the corner comes nearer to the circle than a square's would not be.
    const double bend = 1.0 - 0.12 * (u / core_) * (v / core_);
    return {radius_ * u * bend, radius_ * v * bend, 0.0};
  }
  /// Rings: `along` the core's outer sides from 0 to 2n, `out` from 0 (on the core) to n (on the circle).
  Vec3d ring(int along, int out) const {
    const Vec3d from = along <= n_ ? core(n_, along) : core(2 * n_ - along, n_);
    const double angle = 0.25 * std::numbers::pi * along / n_;
    const Vec3d to{radius_ * std::cos(angle), radius_ * std::sin(angle), 0.0};
    const double share = static_cast<double>(out) / n_;
    return (1.0 - share) * from + share * to;
  }

 private:
  double radius_;
  int n_;
  static constexpr double core_ = 0.6;
};

/// Taylor bar. A quarter of it, frictionless wall. `law`: *MAT_... 1 and *PART 1 of copper.
void expect_taylor_bar(const std::string& name, const std::string& law) {
  constexpr double radius = 3.2, length = 32.4, end = 8e-5;
  constexpr int n = 3, layers = 54;
  const QuarterDisc disc(radius, n);
  Specimen s;
  s.text(law).card("SECTION_SOLID", {1, 1});
  const auto at = [&](const Vec3d& p, int k) { return p + Vec3d{0.0, 0.0, length * k / layers}; };
  const Grid core = s.bricks(1, {n, n, layers}, [&](int i, int j, int k) { return at(disc.core(i, j), k); });
  // The rings share their inner nodes with the core's outer sides.
  const Grid rings{core(n, n, layers) + 1, {2 * n, n - 1, layers}};
  for (int k = 0; k <= layers; ++k)
    for (int out = 1; out <= n; ++out)
      for (int along = 0; along <= 2 * n; ++along) s.node(at(disc.ring(along, out), k));
  const auto node = [&](int along, int out, int k) {
    if (out > 0) return rings(along, out - 1, k);
    return along <= n ? core(n, along, k) : core(2 * n - along, n, k);
  };
  for (int k = 0; k < layers; ++k)
    for (int out = 0; out < n; ++out)
      for (int a = 0; a < 2 * n; ++a)
        s.brick(
            1, {node(a, out, k), node(a, out + 1, k), node(a + 1, out + 1, k), node(a + 1, out, k), node(a, out, k + 1),
                node(a, out + 1, k + 1), node(a + 1, out + 1, k + 1), node(a + 1, out, k + 1)});
  std::vector<int> on_x, on_y;
  for (int k = 0; k <= layers; ++k) {
    for (int i = 0; i <= n; ++i) on_x.push_back(core(i, 0, k)), on_y.push_back(core(0, i, k));
    for (int out = 1; out <= n; ++out) on_x.push_back(node(0, out, k)), on_y.push_back(node(2 * n, out, k));
  }
  s.node_set(1, on_x).card("BOUNDARY_SPC_SET", {1, 0, 0, 1}).node_set(2, on_y).card("BOUNDARY_SPC_SET", {2, 0, 1});
  s.card("INITIAL_VELOCITY_GENERATION", {1, 2, 0, 0, 0, -227000.0}).text(fields({}));
  s.text("*RIGIDWALL_PLANAR\n" + fields({0}) + fields({0, 0, 0, 0, 0, 1})).card("CONTROL_TERMINATION", {end});
  Experiment experiment(s.deck());

  double final_length = 0.0, foot = 0.0, strain = 0.0, ratio = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    ratio = std::max(ratio, std::abs(now.energy.ratio() - 1.0));
    if (now.state.time < end) return;
    final_length = experiment.position(now, core(0, 0, layers)).z;
    foot = experiment.position(now, node(0, n, 0)).x;
    for (int e : experiment.model().solids.id)
      strain = std::max(strain, brick_layer(experiment, now, e).plastic_strain);
  });
  expect_reference("Taylor bar", name + ", 27 x 54 bricks: final length [mm]", final_length, 21.47, 0.01);
  expect_reference("Taylor bar", name + ", 27 x 54 bricks: radius of the foot [mm]", foot, 7.05, 0.03);
  expect_reference("Taylor bar", name + ", 27 x 54 bricks: largest plastic strain", strain, 2.97, 0.10);
  expect_reference("Taylor bar", name + ", 27 x 54 bricks: energy ratio", 1.0 + ratio, 1.0, 1e-3);
}

// Sabotage: the return to the yield surface with 2G instead of 3G.
TEST(Plasticity, TaylorBar) {
  const double hardening = 100.0, modulus = 117000.0;
  expect_taylor_bar("Taylor bar",
                    "*MAT_PLASTIC_KINEMATIC\n" +
                        fields({1, 8.93e-9, modulus, 0.35, 400.0, modulus * hardening / (modulus + hardening), 1.0}) +
                        fields({}) + "*PART\nbar\n" + fields({1, 1, 1}));
}

// The shear modulus on MAT_015, the bulk modulus on the equation of state. Sabotage: C1 taken for 3 K.
TEST(Plasticity, TaylorBarOfJohnsonAndCook) {
  const double modulus = 117000.0, nu = 0.35;
  expect_taylor_bar("Taylor bar, MAT_015", "*MAT_JOHNSON_COOK\n" + fields({1, 8.93e-9, modulus / (2.0 * (1.0 + nu))}) +
                                               fields({400.0, 100.0, 1.0}) + fields({0.0}) + fields({0.0}) +
                                               "*EOS_LINEAR_POLYNOMIAL\n" +
                                               fields({7, 0.0, modulus / (3.0 * (1.0 - 2.0 * nu))}) + fields({}) +
                                               "*PART\nbar\n" + fields({1, 1, 1, 7}));
}

}  // namespace
}  // namespace nugget::verify
