// SPDX-License-Identifier: Apache-2.0
// *CONTACT_..._TIEBREAK: the stresses that glue carries and the work that parts two plates are what the law's card
// says, in tension, shear and both.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double area = 400.0, strength = 1.0, shear_strength = 1.5;
// SFSB is small enough that the step does not bound the springs. Penalty stiffness by area of a shell [N/mm^3]:
// SLSFAC SFSB K / diagonal.
constexpr double soft = 0.1;
const double stiffness = 0.1 * soft * 210000.0 / (3.0 * (1.0 - 2.0 * 0.3)) / (40.0 * std::sqrt(2.0));

/// A way of the upper plate: until `time` it moves at these speeds along x and z; then the next leg.
struct Leg {
  double time, along, up;
};

/// A rigid plate of 20 x 20 in 2 x 2 shells over a fixed one of 40 x 40 in `cells` x `cells`, both 1 mm thick.
struct Plates {
  double gap = 0.0;
  int cells = 1;
  std::string curves = {};
};

struct Parting {
  double work = 0.0;                    ///< in the glue and the contact, at the end [N mm]
  double tension = 0.0, shear = 0.0;    ///< largest forces on the upper plate, downward and along x [N]
  double pressure = 0.0;                ///< upward, when the shear was largest [N]
  double last = 0.0, last_shear = 0.0;  ///< forces in the end: upward, along x [N]
  double height = 0.0;                  ///< of the upper plate's middle at the end [mm]
  double ratio = 1.0;                   ///< of energies, at the end
  int start = 0, later = 0, failed = 0;
};

/// Moves the upper plate along `way`; `contact`: keyword and cards, with sides 2 (upper) and 1.
Parting part(const std::string& contact, const std::vector<Leg>& way, const Plates& plates = {}) {
  Specimen s;
  s.card("MAT_ELASTIC", {1, 7.85e-9, 210000.0, 0.3});
  s.card("MAT_RIGID", {2, 7.85e-9, 210000.0, 0.3}).text(fields({1, 2, 7}) + fields({}));
  s.text("*SECTION_SHELL\n" + fields({1, 2, 1, 2}) + fields({1, 1, 1, 1})).part(1, 1, 1).part(2, 1, 2);
  const Grid lower = s.shells(1, {-10.0, -10.0, 0.0}, {40.0, 40.0, 0.0}, plates.cells, plates.cells);
  const Grid upper = s.shells(2, {0.0, 0.0, 1.0 + plates.gap}, {20.0, 20.0, 0.0}, 2, 2);
  s.node_set(1, lower.all()).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
  s.node_set(2, upper.all());
  s.card("BOUNDARY_PRESCRIBED_MOTION_RIGID", {2, 1, 0, 1, 1.0})
      .card("BOUNDARY_PRESCRIBED_MOTION_RIGID", {2, 3, 0, 2, 1.0});
  // From one leg to the next within a hundredth of the shorter one.
  std::string along = "*DEFINE_CURVE\n" + fields({1}), up = "*DEFINE_CURVE\n" + fields({2});
  const auto point = [](double x, double y) { return fmt::format("{:20.12g}{:20.12g}\n", x, y); };
  double from = 0.0;
  for (const Leg& leg : way) {
    const double start = from + (from > 0.0 ? 0.01 * (leg.time - from) : 0.0);
    along += point(start, leg.along) + point(leg.time, leg.along);
    up += point(start, leg.up) + point(leg.time, leg.up);
    from = leg.time;
  }
  s.text(along + point(from + 1.0, 0.0)).text(up + point(from + 1.0, 0.0)).text(plates.curves).text(contact);
  s.card("CONTROL_ENERGY", {2, 2, 2, 2}).card("CONTROL_TERMINATION", {from});
  Experiment experiment(s.deck());
  Parting p;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    p.work = now.energy.contact;
    const Vec3d force = now.components.contacts.all()[0].resultant();
    p.tension = std::max(p.tension, -force.z);
    if (-force.x > p.shear) {
      p.shear = -force.x;
      p.pressure = force.z;
    }
    p.last = force.z;
    p.last_shear = force.x;
    p.height = experiment.position(now, upper(1, 1)).z;
    p.ratio = now.energy.ratio();
    const auto& glue = *now.components.contacts.all()[0].glue();
    p.start = glue.at_start();
    p.later = glue.later();
    p.failed = glue.failed();
  });
  return p;
}

/// The first three cards.
std::string sides(const std::string& keyword, double sfsb = soft, int type_a = 3, double friction = 0.0) {
  return "*CONTACT_" + keyword + "\n" + fields({2, 1, static_cast<double>(type_a), 3}) + fields({friction, friction}) +
         fields({1.0, sfsb});
}

std::string tiebreak(std::initializer_list<double> card, const std::string& more = {}) {
  return sides("AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK") + fields(card) + more;
}

/// Parts the plates by a millimetre along a straight way: all glue fails.
Parting part_straight(const std::string& contact, double along, double up, const Plates& plates = {}) {
  const Parting p = part(contact, {{1.0 / std::hypot(along, up), along, up}}, plates);
  EXPECT_EQ(p.start, 9);
  EXPECT_EQ(p.failed, 9);
  return p;
}

double work_of_parting(std::initializer_list<double> card, double along, double up) {
  return part_straight(tiebreak(card), along, up).work;
}

// The triangle under the stress: strength up to the distance. Sabotage: damage that begins at an opening of 0.
TEST(Glue, StressFallsToNothingAtTheDistance) {
  const auto work = [](double along, double up) {
    return work_of_parting({6, strength, shear_strength, 0.4}, along, up);
  };
  expect_reference("glue", "OPTION 6, tension, work to part [N mm]", work(0.0, 500.0), 0.5 * strength * 0.4 * area,
                   0.01);
  expect_reference("glue", "OPTION 6, shear, work to part [N mm]", work(500.0, 0.0), 0.5 * shear_strength * 0.4 * area,
                   0.01);
}

// Sabotage: ERATES for ERATEN; the sign of PARAM not looked at; an end that does not depend on the mix.
TEST(Glue, ModesMixAsThePowerLawOrAsBenzeggaghAndKenaneSay) {
  constexpr double tension = 0.2, shear = 0.6;
  const auto work = [](double exponent, double along, double up) {
    return work_of_parting({9, strength, shear_strength, exponent, tension, shear, 1.0, 10.0}, along, up);
  };
  expect_reference("glue", "OPTION 9, tension, work to part [N mm]", work(1.0, 0.0, 500.0), tension * area, 0.01);
  expect_reference("glue", "OPTION 9, shear, work to part [N mm]", work(1.0, 500.0, 0.0), shear * area, 0.01);
  // As stiff in shear as in tension: at 45 degrees each mode has half of the energy.
  expect_reference("glue", "OPTION 9, 45 degrees, power law of 1, work to part [N mm]", work(1.0, 400.0, 400.0),
                   area / (0.5 / tension + 0.5 / shear), 0.01);
  expect_reference("glue", "OPTION 9, 45 degrees, power law of 2, work to part [N mm]", work(2.0, 400.0, 400.0),
                   area / std::hypot(0.5 / tension, 0.5 / shear), 0.01);
  expect_reference("glue", "OPTION 9, 45 degrees, Benzeggagh and Kenane 1.5, work to part [N mm]",
                   work(-1.5, 400.0, 400.0), area * (tension + (shear - tension) * std::pow(0.5, 1.5)), 0.01);
}

// OPTION 7: the energies add up linearly, and pressure adds to the strength in shear by the sine of PARAM. Sabotage:
// the tangent for the sine; the pressure left out.
TEST(Glue, PressureAddsToTheShearStrengthOfTheCrackModel) {
  constexpr double tension = 0.2, shear = 0.6, angle = 30.0;
  for (const int option : {7, 10}) {
    const std::string card = tiebreak({static_cast<double>(option), strength, shear_strength, angle, tension, shear});
    const std::string name = fmt::format("OPTION {}", option);
    expect_reference("glue", name + ", tension, work to part [N mm]", part_straight(card, 0.0, 500.0).work,
                     tension * area, 0.01);
    expect_reference("glue", name + ", 45 degrees, work to part [N mm]", part_straight(card, 400.0, 400.0).work,
                     area / (0.5 / tension + 0.5 / shear), 0.01);
  }
  const Parting pressed =
      part(tiebreak({7, strength, shear_strength, angle, tension, shear}), {{1e-4, 0.0, -300.0}, {2.1e-3, 500.0, 0.0}});
  EXPECT_EQ(pressed.failed, 9);
  EXPECT_GT(pressed.pressure, 100.0);
  expect_reference("glue", "OPTION 7, shear under pressure, largest shear force [N]", pressed.shear,
                   shear_strength * area + 0.5 * pressed.pressure, 0.01);
}

/// Area under stress over opening: elastic up to the yield stress, times a factor that falls from 1 at `from` to 0 at
/// `to`; by small steps.
double yielding_work(double slope, double yield, double from, double to) {
  constexpr int steps = 100000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double opening = to * (i + 0.5) / steps;
    sum += std::min(slope * opening, yield) * std::min(1.0, (to - opening) / (to - from)) * to / steps;
  }
  return sum;
}

// OPTION 5: von Mises' yield stress, times the curve over the opening: 1 up to 0.1 mm, 0 from 0.5 mm on. Under shear
// alone it yields for ever. Sabotage: shear yields at NFLS; the curve over the whole opening, not its normal part.
TEST(Glue, YieldsAndFadesByACurve) {
  const std::string factor = curve(9, {{0.0, 1.0}, {0.1, 1.0}, {0.5, 0.0}});
  const std::string stress = curve(9, {{0.0, 2.0}, {0.1, 2.0}, {0.5, 0.0}});
  constexpr double yield = 2.0;
  for (const std::string& law : {factor, stress}) {
    const Plates plates{0.0, 1, law};
    const Parting tension = part_straight(tiebreak({5, yield, 9}), 0.0, 500.0, plates);
    expect_reference("glue", "OPTION 5, tension, work to part [N mm]", tension.work,
                     yielding_work(stiffness, yield, 0.1, 0.5) * area, 0.01);
    expect_reference("glue", "OPTION 5, tension, largest force [N]", tension.tension, yield * area, 0.01);
  }
  const Plates plates{0.0, 1, factor};
  const Parting shear = part(tiebreak({5, yield, 9}), {{2e-3, 500.0, 0.0}}, plates);
  EXPECT_EQ(shear.failed, 0);
  const double along = yield / std::sqrt(3.0);
  expect_reference("glue", "OPTION 5, shear over 1 mm, work [N mm]", shear.work,
                   (along - 0.5 * along * along / stiffness) * area, 0.01);
  // At 45 degrees both stresses are s, with s^2 + 3 s^2 = NFLS^2, and the openings are the same.
  const Parting both = part_straight(tiebreak({5, yield, 9}), 400.0, 400.0, plates);
  expect_reference("glue", "OPTION 5, 45 degrees, work to part [N mm]", both.work,
                   2.0 * yielding_work(stiffness, 0.5 * yield, 0.1, 0.5) * area, 0.01);
}

/// OPTION 13: yield, energy and share of the plateau, in tension and shear.
std::string layer(double plateau_tension, double plateau_shear, double option = 13) {
  return tiebreak({option, 0, 0, 0.3, 0, 0, 1.0, 30.0},
                  fields({0.9, 0, 0, 2.0, 0, 0, plateau_tension}) + fields({1.8, 0, 0, 3.0, 0, 0, plateau_shear}));
}

// OPTION 13: the energies are those of the card, whatever the plateau; the plateau ends where its share is spent.
// Sabotage: damage from the yield point on; the plateau's share of the opening taken for one of the energy.
TEST(Glue, YieldsAndSoftensAsATrapezoid) {
  const auto work = [](const std::string& card, double along, double up) {
    return part_straight(card, along, up).work;
  };
  expect_reference("glue", "OPTION 13, tension, work to part [N mm]", work(layer(0.5, 0.6), 0.0, 500.0), 0.9 * area,
                   0.01);
  expect_reference("glue", "OPTION 14, shear, work to part [N mm]", work(layer(0.5, 0.6, 14), 500.0, 0.0), 1.8 * area,
                   0.01);
  expect_reference("glue", "OPTION 13, 45 degrees, work to part [N mm]", work(layer(0.5, 0.6), 400.0, 400.0),
                   area / (0.5 / 0.9 + 0.5 / 1.8), 0.01);
  expect_reference("glue", "OPTION 13, plateau by openings, work to part [N mm]", work(layer(-0.4, -0.4), 0.0, 500.0),
                   0.9 * area, 0.01);
  // Half of 0.9 at 2: 0.225 mm beyond the yield point. There nothing is lost; half way down half is.
  const double yield = 2.0 / 30.0, soften = yield + 0.225, end = 2.0 * 0.9 / 2.0 - soften + yield;
  for (const auto& [opening, share] : {std::pair{soften, 1.0}, std::pair{0.5 * (soften + end), 0.5}}) {
    const Parting p = part(layer(0.5, 0.6), {{opening / 100.0, 0.0, 100.0}});
    expect_reference("glue", fmt::format("OPTION 13, force where {:.1f} is left [N]", share), -p.last,
                     2.0 * share * area, 0.01);
  }
}

// The yield stress grows with the logarithm of the rate, the energy from the low to the high value. Rate: 30 mm/s over
// 0.3 mm. Sabotage: the rate of each step instead of that at yield (the plate stops on the way).
TEST(Glue, ALayerIsStrongerWhereItIsPulledFast) {
  const std::string card = tiebreak({13, 0, 0, 0.3, 0, 0, 1.0, 30.0}, fields({-0.9, 1.8, 50.0, -2.0, -0.5, 1.0, 0.5}) +
                                                                          fields({1.8, 0, 0, -3.0, 0.1, 1.0, 0.6}));
  const double yield = 2.0 + 0.5 * std::log(30.0 / 0.3);
  // Yields at 0.14 mm, softens from 0.31 mm on; from 0.2 mm on it is pulled slowly.
  const Parting slows = part(card, {{0.2 / 30.0, 0.0, 30.0}, {0.2 / 30.0 + 0.01, 0.0, 0.1}});
  expect_reference("glue", "OPTION 13, rate, tension on the plateau [N]", -slows.last, yield * area, 0.01);
  const Parting whole = part(card, {{0.05, 0.0, 30.0}});
  EXPECT_EQ(whole.failed, 9);
  expect_reference("glue", "OPTION 13, rate, work to part [N mm]", whole.work,
                   (0.9 + 0.9 * std::exp(-50.0 / 100.0)) * area, 0.01);
  const double logarithm = std::log(0.5 * 30.0 / 0.3);
  const Parting shear = part(card, {{0.01, 30.0, 0.0}});
  expect_reference("glue", "OPTION 13, rate, largest shear [N]", shear.shear,
                   (3.0 + 0.1 * logarithm * logarithm) * area, 0.01);
}

// OPTION 4: over a shell and more without force along the surface, or at SFLS, and then off at NFLS. Sabotage: a foot
// that stays on its first segment; friction by the pressure with PARAM = 1.
TEST(Glue, SlidesAndHoldsAlongTheNormal) {
  const auto card = [](std::initializer_list<double> glue, double friction = 0.0) {
    return sides("AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", 0.01, 3, friction) + fields(glue);
  };
  const std::vector<Leg> way{{1.2e-3, 5000.0, 0.0}, {2.2e-3, 0.0, 500.0}};
  const Parting loose = part(card({4, strength, 0}), way, {0.0, 8});
  EXPECT_EQ(loose.failed, 9);
  expect_reference("glue", "OPTION 4, force along the surface [N]", loose.shear, 0.0, 1e-6, area);
  expect_reference("glue", "OPTION 4, largest tension after sliding 6 mm [N]", loose.tension, strength * area, 0.01);
  const Parting rubs = part(card({4, strength, shear_strength, 1}), way, {0.0, 8});
  EXPECT_EQ(rubs.failed, 9);
  expect_reference("glue", "OPTION 4, PARAM 1, force along the surface [N]", rubs.shear, shear_strength * area, 1e-3);
  expect_reference("glue", "OPTION 4, PARAM 1, work of friction over 6.03 mm [N mm]", rubs.work,
                   shear_strength * area * 6.025, 0.01);
  expect_reference("glue", "OPTION 4, PARAM 1, energy ratio", rubs.ratio, 1.0, 0.01);
  // Under pressure with friction of 0.3.
  const Parting pressed = part(card({4, strength}, 0.3), {{1e-4, 0.0, -50.0}, {1e-3, 1000.0, 0.0}}, {0.0, 8});
  EXPECT_GT(pressed.last, 10.0);
  expect_reference("glue", "OPTION 4, friction of 0.3 over the pressure", -pressed.last_shear / pressed.last, 0.3,
                   1e-6);
}

// OPTION 1, 3: the plate comes down over a gap and sticks; 3 fails at its strength, 1 never does. Sabotage: what
// touches later does not stick; what has failed sticks again.
TEST(Glue, WhatTouchesLaterSticks) {
  // It touches slowly: what sticks starts with the pressure of the touch, and a tool that is driven presses hard.
  const Leg down{1e-3, 0.0, -198.8}, touch{2e-3, 0.0, -0.3};
  const Parting intact = part(tiebreak({1}), {down, touch, {3e-3, 200.0, 200.0}}, {0.2});
  EXPECT_EQ(intact.start, 0);
  EXPECT_EQ(intact.later, 9);
  EXPECT_EQ(intact.failed, 0);
  // A hundredth of each leg is spent to come to its speed: it touches 0.0001 mm before it turns round, and goes 0.199
  // mm up from there, and along.
  expect_reference("glue", "OPTION 1, tension 0.1989 mm off [N]", intact.tension, stiffness * 0.1989 * area, 0.01);
  expect_reference("glue", "OPTION 1, shear 0.199 mm off [N]", intact.shear, stiffness * 0.199 * area, 0.01);
  const std::string fails = tiebreak({3, strength, shear_strength});
  const Parting up = part(fails, {down, touch, {4e-3, 0.0, 50.0}}, {0.2});
  EXPECT_EQ(up.failed, 9);
  expect_reference("glue", "OPTION 3, largest tension after it came to touch [N]", up.tension, strength * area, 0.01);
  const Parting along = part(fails, {down, touch, {4e-3, 50.0, 0.0}, {4.1e-3, 0.0, -10.0}}, {0.2});
  EXPECT_EQ(along.failed, 9);
  EXPECT_EQ(along.later, 9);
  expect_reference("glue", "OPTION 3, largest shear after it came to touch [N]", along.shear, shear_strength * area,
                   0.01);
}

// *CONTACT_TIEBREAK_NODES_...: forces of a node, of which there are 9; pulled slowly, since the force of the last step
// before it fails is the largest. Sabotage: stresses; exponents of 2.
TEST(Glue, OlderFormsCountForcesOfNodes) {
  const auto card = [](const std::string& form, double nen, double mes) {
    return sides("TIEBREAK_NODES_" + form, 1e-3, 4) + fields({50.0, 75.0, nen, mes});
  };
  const Parting up = part_straight(card("TO_SURFACE", 2, 2), 0.0, 50.0);
  expect_reference("glue", "nodes, tension, largest force [N]", up.tension, 9.0 * 50.0, 0.01);
  const Parting along = part_straight(card("ONLY", 2, 2), 50.0, 0.0);
  expect_reference("glue", "nodes, shear, largest force [N]", along.shear, 9.0 * 75.0, 0.01);
  const Parting both = part_straight(card("TO_SURFACE", 1, 1), 40.0, 40.0);
  expect_reference("glue", "nodes, 45 degrees, exponents of 1, largest tension [N]", both.tension,
                   9.0 / (1.0 / 50.0 + 1.0 / 75.0), 0.01);
  // Torn off and pressed back: _TO_SURFACE is a contact then, _ONLY is nothing.
  const std::vector<Leg> back{{1e-3, 0.0, 200.0}, {4e-3, 0.0, -200.0}};
  EXPECT_GT(part(card("TO_SURFACE", 2, 2), back).last, 100.0);
  EXPECT_EQ(part(card("ONLY", 2, 2), back).last, 0.0);
}

// *CONTACT_TIEBREAK_SURFACE_TO_SURFACE: OPTION 2, or with TBLCID OPTION 5; plates may be meshed at any distance.
TEST(Glue, OlderFormOfSurfaces) {
  const auto card = [](std::initializer_list<double> glue, const std::string& form = {}) {
    return sides("TIEBREAK_SURFACE_TO_SURFACE" + form) + fields(glue);
  };
  expect_reference("glue", "surfaces, shear, largest force [N]",
                   part_straight(card({strength, shear_strength}), 50.0, 0.0).shear, shear_strength * area, 0.01);
  for (const double gap : {-1.0, -0.5, 0.1}) {
    const Parting p = part_straight(card({strength, shear_strength}, "_ONLY"), 0.0, 50.0, {gap});
    expect_reference("glue", fmt::format("surfaces {:g} mm apart, tension, largest force [N]", 1.0 + gap), p.tension,
                     strength * area, 0.01);
  }
  const Plates fades{0.0, 1, curve(9, {{0.0, 1.0}, {0.4, 0.0}})};
  expect_reference("glue", "surfaces, TBLCID, work to part [N mm]",
                   part_straight(card({2.0, 0.0, 9}), 0.0, 500.0, fades).work,
                   yielding_work(stiffness, 2.0, 0.0, 0.4) * area, 0.01);
}

/// A tie of the upper plate to the lower one: strengths, from when until when it acts, SAST.
std::string tie(const std::string& keyword, double normal, double shear, double birth = 0.0, double death = 0.0,
                double sast = 0.0) {
  return "*CONTACT_" + keyword + "\n" + fields({2, 1, 3, 3}) + fields({normal, shear, 0, 0, 0, 0, birth, death}) +
         fields({1.0, soft, sast});
}

// *CONTACT_TIED_SURFACE_TO_SURFACE_FAILURE. Sabotage: FD for FS; strengths that count forces of nodes.
TEST(Glue, TiesFailAtTheirStress) {
  const std::string card = tie("TIED_SURFACE_TO_SURFACE_FAILURE", strength, shear_strength);
  for (const double gap : {-1.0, 0.1})
    expect_reference("glue", fmt::format("failing tie, {:g} mm apart, tension, largest force [N]", 1.0 + gap),
                     part_straight(card, 0.0, 50.0, {gap}).tension, strength * area, 0.01);
  expect_reference("glue", "failing tie, shear, largest force [N]", part_straight(card, 50.0, 0.0).shear,
                   shear_strength * area, 0.01);
  expect_reference("glue", "failing tie, 45 degrees, largest tension [N]", part_straight(card, 40.0, 40.0).tension,
                   area / std::hypot(1.0 / strength, 1.0 / shear_strength), 0.01);
  // A strength of 0 does not count.
  EXPECT_EQ(part(tie("TIED_SURFACE_TO_SURFACE_FAILURE", strength, 0.0), {{1e-3, 1000.0, 0.0}}).failed, 0);
  // What has failed is an ordinary contact without friction.
  const Parting back = part(card, {{1e-3, 0.0, 200.0}, {3e-3, 0.0, -200.0}, {4e-3, 300.0, 0.0}});
  EXPECT_EQ(back.failed, 9);
  EXPECT_GT(back.last, 100.0);
  EXPECT_LT(std::abs(back.last_shear), 1e-9);
}

TEST(Glue, TheToleranceOfAFailingTieIsThatOfTies) {
  const std::vector<Leg> up{{1e-5, 0.0, 1.0}};
  const Plates plates{0.5, 8};  // a twentieth of the diagonals is nothing
  EXPECT_EQ(part(tie("TIED_SURFACE_TO_SURFACE_FAILURE", strength, strength), up, plates).start, 0);
  EXPECT_EQ(part(tie("TIED_SURFACE_TO_SURFACE_FAILURE", strength, strength, 0.0, 0.0, -3.0), up, plates).start, 9);
}

// BT: the plate comes down without a force, is held from 1.02 ms on where it then is, and with DT let go. Sabotage: the
// place of the start; what was in reach at the start.
TEST(Glue, TiesThatBeginLater) {
  const std::vector<Leg> way{{1e-3, 0.0, -400.0}, {2e-3, 60.0, 40.0}};
  for (const std::string form : {"", "_OFFSET", "_CONSTRAINED_OFFSET"}) {
    const Parting p = part(tie("TIED_NODES_TO_SURFACE" + form, 0.0, 0.0, 1.02e-3), way, {0.5});
    EXPECT_EQ(p.start, 0);
    EXPECT_EQ(p.later, 9);
    EXPECT_EQ(p.failed, 0);
    const std::string name = "tie" + form + " from 1.02 ms on, ";
    expect_reference("glue", name + "tension at 2 ms [N]", p.tension, stiffness * 40.0 * 0.98e-3 * area, 0.01);
    expect_reference("glue", name + "shear at 2 ms [N]", p.shear, stiffness * 60.0 * 0.98e-3 * area, 0.01);
    expect_reference("glue", name + "work [N mm]", p.work,
                     0.5 * stiffness * area * (40.0 * 40.0 + 60.0 * 60.0) * 0.98e-3 * 0.98e-3, 0.01);
  }
  const Parting ends = part(tie("TIED_SURFACE_TO_SURFACE", 0.0, 0.0, 1.02e-3, 1.5e-3), way, {0.5});
  EXPECT_EQ(ends.failed, 9);
  EXPECT_EQ(ends.last, 0.0);
  expect_reference("glue", "tie from 1.02 to 1.5 ms, largest tension [N]", ends.tension,
                   stiffness * 40.0 * 0.48e-3 * area, 0.02);
  // Out of reach when it begins.
  EXPECT_EQ(part(tie("TIED_NODES_TO_SURFACE", 0.0, 0.0, 0.2e-3), way, {0.5, 8}).later, 0);
}

// BT counts for the older forms and for _TIEBREAK too.
TEST(Glue, GluesWhatTouchesAtItsBirth) {
  const std::string card = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n" + fields({2, 1, 3, 3}) +
                           fields({0, 0, 0, 0, 0, 0, 1.02e-3}) + fields({1.0, soft}) + fields({2, strength, strength});
  const Parting p = part(card, {{1e-3, 0.0, -198.8}, {3e-3, 0.0, 50.0}}, {0.2});
  EXPECT_EQ(p.start, 0);
  EXPECT_EQ(p.later, 9);
  EXPECT_EQ(p.failed, 9);
  expect_reference("glue", "TIEBREAK from 1.02 ms on, largest tension [N]", p.tension, strength * area, 0.01);
}

}  // namespace
}  // namespace nugget::verify
