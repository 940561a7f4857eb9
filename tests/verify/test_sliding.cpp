// SPDX-License-Identifier: Apache-2.0
// Penalty contact of two bodies: bars that collide, a block that slides.
#include <gtest/gtest.h>

#include <cmath>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double modulus = 210000.0, density = 7.85e-9;

Vec3d momentum(const Experiment& experiment, const impact::Snapshot& now, const std::vector<int>& nodes) {
  Vec3d sum;
  for (int id : nodes) sum += now.system.mass[experiment.node(id)] * vec(now.state.v[experiment.node(id)]);
  return sum;
}

/// Two bars, of `length` and twice that, of elements of 1 mm; the short one runs into the other.
struct Bars {
  static constexpr double speed = 10000.0, area = 100.0, c = 5172194.0;
  Specimen s;
  Grid left, right;

  Bars(int length, double end, int soft = 1) {
    s.card("MAT_ELASTIC", {1, density, modulus, 0.0}).card("SECTION_SOLID", {1, 1}).part(1, 1, 1).part(2, 1, 1);
    left = s.bricks(1, {}, {1.0 * length, 10.0, 10.0}, {length, 1, 1});
    right = s.bricks(2, {1.0 * length, 0.0, 0.0}, {2.0 * length, 10.0, 10.0}, {2 * length, 1, 1});
    s.text("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n" + fields({1, 2, 3, 3}) + fields({}) + fields({20, 20}) +
           fields({1.0 * soft, 1.0}));
    s.card("CONTROL_ENERGY", {2, 2, 2, 2});
    s.card("INITIAL_VELOCITY_GENERATION", {1, 2, 0, speed}).text(fields({}));
    s.card("CONTROL_TERMINATION", {end});
  }
};

// St. Venant: the short bar stops, the long one carries all the momentum away. Sabotage: reactions on segments left
// out, or contact energy that is not in the balance.
TEST(Sliding, TwoBarsCollide) {
  constexpr double speed = Bars::speed, area = Bars::area, c = Bars::c;
  Bars bars(200, 1.1e-4);
  const Grid &left = bars.left, &right = bars.right;
  Experiment experiment(bars.s.deck());

  double begin = 0.0, end = 0.0, impulse = 0.0, after_left = 0.0, after_right = 0.0, worst = 1.0, before = 0.0;
  TimeMean plateau;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const double force = -now.components.contacts.all()[0].resultant().x, t = now.state.time;
    impulse += force * now.velocity_interval();
    if (force > 0.5 * 20300.9) end = t;
    if (begin == 0.0 && force > 0.5 * 20300.9) begin = t;
    if (t > 1e-5 && t < 7e-5) plateau.add(force, now.state.dt);
    after_left = momentum(experiment, now, left.all()).x;
    after_right = momentum(experiment, now, right.all()).x;
    if (now.state.cycle == 0) before = after_left;
    if (std::abs(now.energy.ratio() - 1.0) > std::abs(worst - 1.0)) worst = now.energy.ratio();
  });
  expect_reference("impact of two rods", "coaxial bars, contact force [N]", plateau.value(),
                   0.5 * density * c * speed * area, 0.02);
  expect_reference("impact of two rods", "coaxial bars, time in contact [s]", end - begin, 400.0 / c, 0.02);
  expect_reference("impact of two rods", "coaxial bars, momentum left in the short bar, of its first",
                   after_left / before, 0.0, 0.02, 1.0);
  expect_reference("impact of two rods", "coaxial bars, mean velocity of the long bar [mm/s]",
                   after_right / (density * area * 400.0), 0.5 * speed, 0.02);
  expect_reference("impact of two rods", "coaxial bars, sum of momenta at the end, of the first",
                   (after_left + after_right) / before, 1.0, 1e-12);
  expect_reference("impact of two rods", "coaxial bars, worst energy ratio", worst, 1.0, 1e-3);
}

// The same with the stiffness of segment-based contact. Sabotage: no stiffness, as of faces without mass.
TEST(Sliding, TwoBarsCollideBySegmentMasses) {
  Bars bars(60, 3.3e-5, 2);
  Experiment experiment(bars.s.deck());
  TimeMean plateau;
  double before = 0.0, after_left = 0.0, after_right = 0.0, worst = 1.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.time > 8e-6 && now.state.time < 2e-5)
      plateau.add(-now.components.contacts.all()[0].resultant().x, now.state.dt);
    after_left = momentum(experiment, now, bars.left.all()).x;
    after_right = momentum(experiment, now, bars.right.all()).x;
    if (now.state.cycle == 0) before = after_left;
    if (std::abs(now.energy.ratio() - 1.0) > std::abs(worst - 1.0)) worst = now.energy.ratio();
  });
  expect_reference("impact of two rods", "coaxial bars, SOFT 2, contact force [N]", plateau.value(),
                   0.5 * density * Bars::c * Bars::speed * Bars::area, 0.02);
  expect_reference("impact of two rods", "coaxial bars, SOFT 2, momentum left in the short bar, of its first",
                   after_left / before, 0.0, 0.02, 1.0);
  expect_reference("impact of two rods", "coaxial bars, SOFT 2, sum of momenta at the end, of the first",
                   (after_left + after_right) / before, 1.0, 1e-12);
  expect_reference("impact of two rods", "coaxial bars, SOFT 2, worst energy ratio", worst, 1.0, 1e-3);
}

// The end of the run cuts its last step to a tenth. The stiffness of the contact, m/dt^2, is that of the step before
// the cut, and so the force is still that of the plateau. Sabotage: the step itself for the one that it can bear.
TEST(Sliding, AShortLastStepDoesNotStiffenContact) {
  constexpr double plateau = 0.5 * density * Bars::c * Bars::speed * Bars::area;
  double end = 0.0, step = 0.0;
  Experiment whole(Bars(40, 1e-5).s.deck());
  run_to_end(whole, [&](const impact::Snapshot& now) {
    if (now.state.time > 8e-6 || now.state.dt == 0.0) return;
    step = now.state.dt;
    end = now.state.time + 1.1 * step;
  });
  double last_step = 0.0, force = 0.0;
  Experiment cut(Bars(40, end).s.deck());
  run_to_end(cut, [&](const impact::Snapshot& now) {
    last_step = now.state.dt_previous;
    force = -now.components.contacts.all()[0].resultant().x;
  });
  ASSERT_NEAR(last_step, 0.1 * step, 0.01 * step);
  expect_reference("impact of two rods", "coaxial bars, contact force after a last step of a tenth [N]", force, plateau,
                   0.03);
}

// Sabotage: friction in proportion to depth instead of force, or a coefficient of the wrong side.
TEST(Sliding, ABlockComesToRest) {
  constexpr double speed = 2000.0, gravity = 9.81e6, friction = 0.2;
  Specimen s;
  s.card("MAT_RIGID", {1, density, modulus, 0.3}).text(fields({}) + fields({}));
  s.card("MAT_ELASTIC", {2, density, modulus, 0.3});
  s.card("SECTION_SOLID", {1, 1}).text("*SECTION_SHELL\n" + fields({2, 2, 1, 2}) + fields({1, 1, 1, 1}));
  s.part(1, 1, 1).part(2, 2, 2);
  const Grid block = s.bricks(1, {10.0, 10.0, 0.5}, {20.0, 20.0, 4.0}, {4, 4, 1});
  const Grid plate = s.shells(2, {0.0, 0.0, 0.0}, {40.0, 40.0, 0.0}, 7, 7);
  s.node_set(1, plate.all()).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
  s.text("*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n" + fields({1, 2, 3, 3}) + fields({friction, friction, 0, 0, 20}) +
         fields({}));
  s.card("CONTROL_ENERGY", {2, 2, 2, 2});
  s.card("INITIAL_VELOCITY_GENERATION", {1, 2, 0, speed}).text(fields({}));
  s.text("*LOAD_BODY_Z\n" + fields({1, gravity})).text(constant_curve(1));
  s.card("CONTROL_TIMESTEP", {0, 0.9}).card("CONTROL_TERMINATION", {1.3e-3});
  Experiment experiment(s.deck());

  Passage slow(-0.01 * speed);
  double way = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const int corner = block(0, 0, 0);
    slow.add(now.state.time, -experiment.velocity(now, corner).x);
    way = std::max(way, experiment.displacement(now, corner).x);
  });
  ASSERT_TRUE(slow.seen());
  expect_reference("block sliding to rest", "Coulomb block, way to rest [mm]", way, 1.019368, 0.02);
  expect_reference("block sliding to rest", "Coulomb block, time to a hundredth of its speed [s]", slow.time(),
                   0.99 * 1.019368e-3, 0.02);
}

}  // namespace
}  // namespace nugget::verify
