// SPDX-License-Identifier: Apache-2.0
// Damping cards against closed forms: decay of free motion, log decrement of a cantilever and of a chain.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "base/index.hpp"
#include "impact/conditions/damping.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double modulus = 210000.0, density = 7.85e-9, pi = std::numbers::pi;
const double wave_speed = std::sqrt(modulus / density);

/// Largest departure from the energy balance, of the largest kinetic energy.
class Balance {
 public:
  /// Not where the step jumps: the kinetic energy is then that of other velocities than the work's.
  void add(const impact::Snapshot& now) {
    if (now.state.cycle > 0 && std::abs(now.state.dt / now.state.dt_previous - 1.0) > 1e-3) return;
    const impact::Energy& e = now.energy;
    worst_ = std::max(worst_, std::abs(e.total() - e.initial - e.external));
    kinetic_ = std::max(kinetic_, e.kinetic);
  }
  double worst() const { return worst_ / kinetic_; }

 private:
  double worst_ = 0.0, kinetic_ = 0.0;
};

/// Share of critical damping out of the maxima of a free vibration, and its circular frequency out of its zeros.
struct Decay {
  double share = 0.0, omega = 0.0;
  Decay(const std::vector<double>& time, const std::vector<double>& value) {
    std::vector<double> peaks, zeros;
    for (std::size_t i = 1; i + 1 < value.size(); ++i) {
      if (value[i - 1] < 0.0 && value[i] >= 0.0)
        zeros.push_back(time[i] - value[i] * (time[i] - time[i - 1]) / (value[i] - value[i - 1]));
      if (value[i] > 0.0 && value[i] > value[i - 1] && value[i] >= value[i + 1]) {
        // Top of the parabola through three samples.
        const double a = value[i - 1], b = value[i], c = value[i + 1];
        peaks.push_back(b + 0.125 * (a - c) * (a - c) / (2.0 * b - a - c));
      }
    }
    // The first two may hold what the start left in the filters.
    if (peaks.size() < 5 || zeros.size() < 5) return;
    peaks.erase(peaks.begin(), peaks.begin() + 2);
    const double decrement = std::log(peaks.front() / peaks.back()) / static_cast<double>(peaks.size() - 1);
    share = decrement / std::sqrt(4.0 * pi * pi + decrement * decrement);
    omega = 2.0 * pi * static_cast<double>(zeros.size() - 1) / (zeros.back() - zeros.front());
  }
};

/// The cantilever strip, 200 x 20 x 2, clamped at x = 0 and started in its first mode.
struct Cantilever {
  static constexpr double length = 200.0, first = 41.776;  ///< Hz, Euler
  Specimen specimen;
  int tip;

  Cantilever() {
    specimen.card("MAT_ELASTIC", {1, density, modulus, 0.0})
        .card("SECTION_SHELL", {1, 2, 0.8333, 2})
        .text(fields({2, 2, 2, 2}))
        .card("CONTROL_TERMINATION", {8.2 / first})
        .part(1, 1, 1);
    const Grid grid = specimen.shells(1, {}, {length, 20.0, 0.0}, 10, 1);
    specimen.node_set(1, grid.across(0)).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
    tip = grid(10, 0);
    constexpr double k = 1.8751040687, sigma = 0.7340955138;
    for (int i = 1; i <= 10; ++i) {
      const double x = k * i / 10.0;
      const double w = 0.5 * (std::cosh(x) - std::cos(x) - sigma * (std::sinh(x) - std::sin(x)));
      const double slope = 0.5 * k / length * (std::sinh(x) + std::sin(x) - sigma * (std::cosh(x) - std::cos(x)));
      for (const int id : grid.across(i))
        specimen.card("INITIAL_VELOCITY_NODE", {1.0 * id, 0, 0, 100.0 * w, 0, -100.0 * slope, 0});
    }
  }
  Decay run(double* balance = nullptr) {
    Experiment experiment(specimen.deck());
    std::vector<double> time, value;
    Balance energy;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      energy.add(now);
      if (now.state.cycle % 20 != 0) return;
      time.push_back(now.state.time);
      value.push_back(experiment.displacement(now, tip).z);
    });
    if (balance) *balance = energy.worst();
    return {time, value};
  }
};

// Sabotage: D acts on half of the mass; the moments are left out (5 % of it).
TEST(Damping, MassProportionalGivesTheLogDecrement) {
  constexpr double alpha = 10.0;
  Cantilever strip;
  strip.specimen.card("DAMPING_GLOBAL", {0, alpha});
  double balance = 0.0;
  const Decay decay = strip.run(&balance);
  expect_reference("damped cantilever strip", "cantilever, *DAMPING_GLOBAL 10/s: share of critical alpha/(2 w)",
                   decay.share, alpha / (2.0 * decay.omega), 2e-2);
  expect_reference("damped cantilever strip", "the same: first frequency [Hz]", decay.omega / (2.0 * pi),
                   Cantilever::first, 1e-2);
  expect_reference("damped cantilever strip", "the same: energy balance, of the kinetic energy", balance, 0.0, 1e-6,
                   1.0);
}

TEST(Damping, OfAPartIsThatOfTheWholeWhereItIsAllThereIs) {
  constexpr double alpha = 10.0;
  Cantilever strip;
  strip.specimen.text(constant_curve(1)).card("DAMPING_PART_MASS", {1, 1, alpha});
  const Decay decay = strip.run();
  expect_reference("damped cantilever strip", "cantilever, *DAMPING_PART_MASS 10/s: share of critical", decay.share,
                   alpha / (2.0 * decay.omega), 2e-2);
}

// Sabotage: the filters' weights without the factor of the ends; velocities instead of their high-passed part.
TEST(Damping, OverARangeOfFrequenciesHasItsShare) {
  Cantilever strip;
  strip.specimen.card("DAMPING_FREQUENCY_RANGE", {0.02, 10.0, 300.0});
  double balance = 0.0;
  const Decay decay = strip.run(&balance);
  expect_reference("damping", "cantilever, *DAMPING_FREQUENCY_RANGE 0.02 from 10 to 300 Hz: share of critical",
                   decay.share, 0.02, 5e-2);
  expect_reference("damping", "the same: energy balance, of the kinetic energy", balance, 0.0, 1e-6, 1.0);
  const impact::DampingFilters filters(0.02, 10.0, 300.0);
  const double slower = 1.0 / std::sqrt(1.0 + filters.growth_at(decay.omega));
  expect_reference("damping", "the same: first frequency, with the mass that the filters seem to add [Hz]",
                   decay.omega / (2.0 * pi), Cantilever::first * slower, 1e-2);
}

TEST(Damping, FiltersAreFlatOverTheirRange) {
  for (const double high : {3.0, 10.0, 30.0, 100.0}) {
    const impact::DampingFilters filters(0.01, 1.0, high);
    for (int i = 0; i <= 50; ++i) {
      const double omega = 2.0 * pi * std::pow(high, i / 50.0);
      EXPECT_NEAR(filters.share_at(omega), 0.01, 0.05 * 0.01) << high << ' ' << omega;
    }
  }
}

// The same strip damped by its forces: stiffer where the nodes' damping made it heavier. Sabotage: what passes low for
// what is left of it; the force of this step for its change; weights of motion.
TEST(Damping, OfDeformationHasItsShare) {
  for (const bool named : {false, true}) {
    Cantilever strip;
    if (named) strip.specimen.text("*SET_PART_LIST\n" + fields({5}) + fields({1}));
    strip.specimen.card("DAMPING_FREQUENCY_RANGE_DEFORM", {0.02, 10.0, 300.0, named ? 5.0 : 0.0});
    double balance = 0.0;
    const Decay decay = strip.run(&balance);
    expect_reference("damping", "cantilever, *DAMPING_FREQUENCY_RANGE_DEFORM 0.02, 10 to 300 Hz: share of critical",
                     decay.share, 0.02, 5e-2);
    expect_reference("damping", "the same: energy balance, of the kinetic energy", balance, 0.0, 1e-6, 1.0);
    const impact::DampingFilters filters(0.02, 10.0, 300.0, impact::DampingFilters::Of::deformation);
    const double faster = std::sqrt(1.0 + filters.growth_at(decay.omega));
    EXPECT_GT(faster, 1.01);
    expect_reference("damping", "the same: first frequency, with the stiffness that the filters seem to add [Hz]",
                     decay.omega / (2.0 * pi), Cantilever::first * faster, 1e-2);
  }
}

/// A bar 200 x 2 x 2 of 10 resultant beams, clamped at the origin, in its first mode.
struct Bar {
  Specimen specimen;
  int tip = 0;
  Bar() {
    specimen.card("MAT_ELASTIC", {1, density, modulus, 0.3})
        .text("*SECTION_BEAM\n" + fields({1, 2}) + fields({4, 4.0 / 3.0, 4.0 / 3.0, 2.25}))
        .card("CONTROL_TERMINATION", {8.2 / Cantilever::first})
        .card("DAMPING_FREQUENCY_RANGE_DEFORM", {0.02, 10.0, 300.0})
        .part(1, 1, 1);
    const int off = specimen.node({100.0, 50.0, 0.0});
    specimen.card("BOUNDARY_SPC_NODE", {1.0 * off, 0, 1, 1, 1, 1, 1, 1});
    constexpr double k = 1.8751040687, sigma = 0.7340955138;
    std::string beams = "*ELEMENT_BEAM\n";
    int before = 0;
    for (int i = 0; i <= 10; ++i) {
      const double x = k * i / 10.0, at = 20.0 * i;
      const double w = 0.5 * (std::cosh(x) - std::cos(x) - sigma * (std::sinh(x) - std::sin(x)));
      const double slope = 0.5 * k / 200.0 * (std::sinh(x) + std::sin(x) - sigma * (std::cosh(x) - std::cos(x)));
      tip = specimen.node({at, 0.0, 0.0});
      if (i > 0) beams += fmt::format("{:8}{:8}{:8}{:8}{:8}\n", i, 1, before, tip, off);
      specimen.card("INITIAL_VELOCITY_NODE", {1.0 * tip, 0, 0, 100.0 * w, 0, -100.0 * slope, 0});
      if (i == 0) specimen.card("BOUNDARY_SPC_NODE", {1.0 * tip, 0, 1, 1, 1, 1, 1, 1});
      before = tip;
    }
    specimen.text(beams);
  }
};

// Sabotage: the moments left out.
TEST(Damping, OfDeformationOfBeams) {
  Bar bar;
  Experiment experiment(bar.specimen.deck());
  std::vector<double> time, value;
  Balance energy;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    energy.add(now);
    time.push_back(now.state.time);
    value.push_back(experiment.displacement(now, bar.tip).z);
  });
  const Decay decay(time, value);
  expect_reference("damping", "bar of beams, *DAMPING_FREQUENCY_RANGE_DEFORM 0.02: share of critical", decay.share,
                   0.02, 5e-2);
  expect_reference("damping", "the same: energy balance, of the kinetic energy", energy.worst(), 0.0, 1e-6, 1.0);
}

TEST(Damping, FiltersOfDeformationAreFlatOverTheirRange) {
  for (const double high : {3.0, 10.0, 30.0, 100.0}) {
    const impact::DampingFilters filters(0.01, 1.0, high, impact::DampingFilters::Of::deformation);
    for (int i = 0; i <= 50; ++i) {
      const double omega = 2.0 * pi * std::pow(high, i / 50.0);
      EXPECT_NEAR(filters.share_at(omega), 0.01, 0.05 * 0.01) << high << ' ' << omega;
    }
  }
}

/// The bar of lumped masses, clamped and free, in its mode `mode`, with the damping that a card gives.
Decay chain(int mode, const std::function<void(Specimen&)>& damp) {
  constexpr int n = 10;
  Specimen specimen;
  specimen.card("MAT_ELASTIC", {1, density, modulus, 0.0})
      .card("SECTION_SOLID", {1, 1})
      .card("CONTROL_TIMESTEP", {0, 0.1})
      .card("CONTROL_BULK_VISCOSITY", {1e-30, 1e-30})
      .card("CONTROL_HOURGLASS", {2, 1e-30})
      .part(1, 1, 1);
  damp(specimen);
  const Grid grid = specimen.bricks(1, {}, {500.0, 100.0, 100.0}, {n, 1, 1});
  specimen.node_set(1, grid.all()).card("BOUNDARY_SPC_SET", {1, 0, 0, 1, 1});
  specimen.node_set(2, grid.across(0)).card("BOUNDARY_SPC_SET", {2, 0, 1});
  const auto shape = [&](int i) { return std::sin((2 * mode - 1) * pi * i / (2 * n)); };
  for (int i = 1; i <= n; ++i)
    for (const int id : grid.across(i)) specimen.card("INITIAL_VELOCITY_NODE", {1.0 * id, shape(i)});
  const double omega = 2.0 * wave_speed / 50.0 * std::sin((2 * mode - 1) * pi / (4.0 * n));
  specimen.card("CONTROL_TERMINATION", {8.2 * 2.0 * pi / omega});
  Experiment experiment(specimen.deck());
  std::vector<double> time, value;
  Balance energy;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    energy.add(now);
    time.push_back(now.state.time);
    value.push_back(experiment.displacement(now, grid(n, 0)).x);
  });
  // The step goes with the bricks' lengths, which the account of the kinetic energy follows to this order only.
  expect_reference("damping", fmt::format("chain, mode {}: energy balance, of the kinetic energy", mode),
                   energy.worst(), 0.0, 1e-5, 1.0);
  return {time, value};
}

Decay chain(int mode, double coefficient) {
  return chain(mode, [&](Specimen& s) { s.card("DAMPING_PART_STIFFNESS", {1, coefficient}); });
}

// Sabotage: beta of the whole run's step instead of the element's; the damping force in the slots, which the internal
// energy is made of.
TEST(Damping, StiffnessProportionalGrowsWithTheFrequency) {
  constexpr double beta = 1e-6;
  for (const int mode : {1, 2}) {
    const Decay decay = chain(mode, -beta);
    expect_reference("damping", fmt::format("chain, mode {}, COEF = -1e-6: share of critical beta w/2", mode),
                     decay.share, 0.5 * beta * decay.omega, 2e-2);
  }
  const Decay decay = chain(1, 0.1);
  expect_reference("damping", "chain, mode 1, COEF = 0.1: share of critical 0.1 w/w_max", decay.share,
                   0.1 * decay.omega / (2.0 * wave_speed / 50.0), 2e-2);
}

// Modes of 2.6 and 7.7 kHz within a range: one share for both. A mode far above it keeps what the filters leave it.
TEST(Damping, OfDeformationIsTheSameForAllModes) {
  for (const int mode : {1, 2}) {
    const Decay decay = chain(mode, [](Specimen& s) { s.card("DAMPING_FREQUENCY_RANGE_DEFORM", {0.01, 1e3, 3e4}); });
    expect_reference("damping", fmt::format("chain, mode {}, _DEFORM 0.01 from 1 to 30 kHz: share of critical", mode),
                     decay.share, 0.01, 5e-2);
  }
}

/// A part that turns fast about its middle, under _DEFORM: damping energy, of the kinetic energy.
double lost_by_turning(Specimen& specimen, std::initializer_list<double> turn) {
  specimen.card("DAMPING_FREQUENCY_RANGE_DEFORM", {0.02, 50.0, 5000.0}).card("CONTROL_TERMINATION", {1e-2});
  specimen.text("*INITIAL_VELOCITY_GENERATION\n" + fields({0, 0, 1000}) + fields(turn));
  Experiment experiment(specimen.deck());
  double lost = 0.0, kinetic = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.cycle == 0) kinetic = now.energy.kinetic;
    lost = now.energy.damping;
  });
  return lost / kinetic;
}

// 1000/s about oblique axes within the range: damping of nodes would take 1 - exp(-2 0.02 1000 0.01) = a third of the
// motion. What is lost is that of the ringing by which a part that begins to turn stretches. Sabotage: axes that stand.
TEST(Damping, OfDeformationLeavesRigidMotionAlone) {
  Specimen sheet;
  sheet.card("MAT_ELASTIC", {1, density, modulus, 0.3})
      .card("SECTION_SHELL", {1, 2, 1, 3})
      .text(fields({1, 1, 1, 1}))
      .part(1, 1, 1);
  sheet.shells(1, {}, {20.0, 10.0, 0.0}, 4, 2);
  expect_reference("damping", "sheet that turns freely, _DEFORM: damping energy, of the kinetic energy",
                   lost_by_turning(sheet, {10, 5, 0, 1, 2, 3}), 0.0, 1e-3, 1.0);
  Specimen block;
  block.card("MAT_ELASTIC", {1, density, modulus, 0.3}).card("SECTION_SOLID", {1, 1}).part(1, 1, 1);
  block.bricks(1, {}, {20.0, 10.0, 10.0}, {4, 2, 2});
  expect_reference("damping", "block that turns freely, _DEFORM: damping energy, of the kinetic energy",
                   lost_by_turning(block, {10, 5, 5, 1, 2, 3}), 0.0, 1e-3, 1.0);
  // A ring of beams turns about its middle; each beam turns about an axis across its own line and about its line.
  Specimen ring;
  ring.card("MAT_ELASTIC", {1, density, modulus, 0.3})
      .text("*SECTION_BEAM\n" + fields({1, 2}) + fields({4, 4.0 / 3.0, 4.0 / 3.0, 2.25}))
      .part(1, 1, 1);
  const int middle = ring.node({0, 0, 0});
  ring.card("BOUNDARY_SPC_NODE", {1.0 * middle, 0, 1, 1, 1, 1, 1, 1});
  constexpr int sides = 12;
  std::string beams = "*ELEMENT_BEAM\n";
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * pi * i / sides;
    ring.node({20.0 * std::cos(angle), 20.0 * std::sin(angle), 0.0});
    beams += fmt::format("{:8}{:8}{:8}{:8}{:8}\n", i + 1, 1, middle + 1 + i, middle + 1 + (i + 1) % sides, middle);
  }
  ring.text(beams);
  expect_reference("damping", "ring of beams that turns freely, _DEFORM: damping energy, of the kinetic energy",
                   lost_by_turning(ring, {0, 0, 0, 1, 2, 3}), 0.0, 1e-3, 1.0);
}

// Stiffness damping does not see a rigid motion, however fast it turns.
TEST(Damping, ByStiffnessLeavesRigidMotionAlone) {
  Specimen specimen;
  specimen.card("MAT_ELASTIC", {1, density, modulus, 0.3})
      .card("SECTION_SHELL", {1, 2, 1, 3})
      .text(fields({1, 1, 1, 1}))
      .card("DAMPING_PART_STIFFNESS", {1, 0.1})
      .part(1, 1, 1);
  specimen.shells(1, {}, {20.0, 10.0, 0.0}, 4, 2);
  specimen.card("CONTROL_TERMINATION", {1e-3});
  specimen.text("*INITIAL_VELOCITY_GENERATION\n" + fields({0, 0, 1000}) + fields({10, 5, 0, 1, 2, 3}));
  Experiment experiment(specimen.deck());
  double lost = 0.0, kinetic = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.cycle == 0) kinetic = now.energy.kinetic;
    lost = now.energy.damping;
  });
  expect_reference("damping", "sheet that turns freely: damping energy, of the kinetic energy", lost / kinetic, 0.0,
                   1e-3, 1.0);
}

// Of an oscillator the share is the whole damping. A spring between held nodes and a discrete beam without a curve have
// no step that it could be a share of. Sabotage: COEF times that step, which is infinite: the run diverged at cycle 1.
TEST(Damping, ByStiffnessOfSpringsHasItsShare) {
  constexpr double share = 0.05, stiffness = 100.0, mass = 1e-3;
  Specimen specimen;
  specimen.card("SECTION_DISCRETE", {1, 0})
      .text("\n")
      .card("MAT_SPRING_ELASTIC", {1, stiffness})
      .part(1, 1, 1)
      .card("MAT_GENERAL_NONLINEAR_1DOF_DISCRETE_BEAM", {2, 1e-9})
      .text("\n\n")
      .card("SECTION_BEAM", {2, 6, 1, 0, 0, 2})
      .text(fields({1.0, 1e-3}))
      .part(2, 2, 2);
  const int held = specimen.node({0, 0, 0}), moved = specimen.mass_point({10, 0, 0}, mass),
            other = specimen.node({0, 20, 0}), apart = specimen.node({0, 40, 0}), last = specimen.node({0, 50, 0});
  specimen.text(fmt::format("*ELEMENT_DISCRETE\n1,1,{},{},0,1.0\n2,1,{},{},0,1.0\n*ELEMENT_BEAM\n3,2,{},{}\n", held,
                            moved, held, other, apart, last));
  specimen.node_set(1, {held, other, apart, last})
      .card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1})
      .card("BOUNDARY_SPC_NODE", {1.0 * moved, 0, 0, 1, 1, 1, 1, 1})
      .card("INITIAL_VELOCITY_NODE", {1.0 * moved, 100.0})
      .card("DAMPING_PART_STIFFNESS", {1, share})
      .card("DAMPING_PART_STIFFNESS", {2, share})
      .card("CONTROL_TIMESTEP", {0, 0.05})
      .card("CONTROL_TERMINATION", {0.25});
  Experiment experiment(specimen.deck());
  std::vector<double> time, value;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    time.push_back(now.state.time);
    value.push_back(experiment.displacement(now, moved).x);
  });
  const Decay decay(time, value);
  EXPECT_NEAR(decay.share, share, 0.01 * share);
  EXPECT_NEAR(decay.omega, std::sqrt((1.0 - share * share) * stiffness / mass), 1.0);
}

// A rigid block slows down as exp(-D t) in the directions that are scaled, and spins down alike.
TEST(Damping, OfRigidBodies) {
  constexpr double d = 50.0, time = 0.02;
  Specimen specimen;
  specimen.card("MAT_RIGID", {1, density, modulus, 0.3})
      .text("\n\n")
      .card("SECTION_SOLID", {1, 1})
      .part(1, 1, 1)
      .text(constant_curve(9, 1e-5))
      .card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 9})
      .card("DAMPING_GLOBAL", {0, d, 1, 0, 1, 1, 1, 1})
      .card("CONTROL_TERMINATION", {time});
  specimen.bricks(1, {}, {10.0, 10.0, 10.0}, {1, 1, 1});
  specimen.text("*INITIAL_VELOCITY_RIGID_BODY\n" + fields({1, 100, 200, 0, 0, 0, 30}));
  Experiment experiment(specimen.deck());
  Vec3d v, w;
  double balance = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const auto k = at(now.system.bodies.at(0).node);
    v = now.velocity(k), w = now.spin(k);
    balance = std::max(balance, std::abs(now.energy.ratio() - 1.0));
  });
  expect_reference("damping", "rigid block: velocity exp(-D t)", v.x, 100.0 * std::exp(-d * time), 1e-3);
  expect_reference("damping", "rigid block: velocity in a direction with scale 0", v.y, 200.0, 1e-12);
  expect_reference("damping", "rigid block: spin exp(-D t)", w.z, 30.0 * std::exp(-d * time), 1e-3);
  expect_reference("damping", "rigid block: energy ratio - 1", balance, 0.0, 1e-6, 1.0);
}

// A rigid block on a torsional spring. Sabotage: only the motion of its centre is damped, and it swings on for ever.
TEST(Damping, OverARangeOfFrequenciesOfABodyThatSwings) {
  constexpr double share = 0.02, frequency = 100.0, omega = 2.0 * pi * frequency;
  Specimen specimen;
  specimen.card("MAT_RIGID", {1, density, modulus, 0.3})
      .text("\n\n")
      .card("SECTION_SOLID", {1, 1})
      .part(1, 1, 1)
      .text(constant_curve(9, 2e-5))
      .card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 9})
      .text("*SET_PART_LIST\n" + fields({5}) + fields({1}))
      .card("DAMPING_FREQUENCY_RANGE", {share, 30, 300, 5})
      .card("CONTROL_TERMINATION", {12.0 / frequency});
  specimen.bricks(1, {-50, -5, -5}, {100.0, 10.0, 10.0}, {1, 1, 1});
  const double inertia = density * 1e4 * (50.0 * 50.0 + 5.0 * 5.0);  // of eight corners
  const int anchor = specimen.node({0, 0, 10}), middle = specimen.node({0, 0, 0});
  specimen.card("CONSTRAINED_EXTRA_NODES_NODE", {1, 1.0 * middle})
      .card("SECTION_DISCRETE", {2, 1})
      .text("\n")
      .card("MAT_SPRING_ELASTIC", {2, inertia * omega * omega})
      .part(2, 2, 2)
      .text(fmt::format("*ELEMENT_DISCRETE\n1,2,{},{},0,1.0\n", anchor, middle))
      .node_set(1, {anchor})
      .card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1})
      .text("*INITIAL_VELOCITY_RIGID_BODY\n" + fields({1, 0, 0, 0, 0, 0, 10}));
  Experiment experiment(specimen.deck());
  std::vector<double> time, value;
  double balance = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    time.push_back(now.state.time);
    value.push_back(now.spin(at(now.system.bodies.at(0).node)).z);
    balance = std::max(balance, std::abs(now.energy.ratio() - 1.0));
  });
  EXPECT_NEAR(Decay(time, value).share, share, 0.05 * share);
  EXPECT_LT(balance, 1e-6);
}

// A rigid block that spins about the line to another one, which takes its spin over. Sabotage: its centre alone is
// damped, and it spins on; the other block gets no moment.
TEST(Damping, RelativeToABodyOfABodyThatSpins) {
  constexpr double share = 0.1, frequency = 20.0, time = 0.05;
  Specimen specimen;
  specimen.card("MAT_RIGID", {1, density, modulus, 0.3})
      .text("\n\n")
      .card("MAT_RIGID", {2, density, modulus, 0.3})
      .text("\n\n")
      .card("SECTION_SOLID", {1, 1})
      .part(1, 1, 1)
      .part(2, 1, 2)
      .text(constant_curve(9, 1e-5))
      .card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 9})
      .text("*SET_PART_LIST\n" + fields({5}) + fields({2}))
      .card("DAMPING_RELATIVE", {share, frequency, 1, 5})
      .card("CONTROL_TERMINATION", {time});
  specimen.bricks(1, {}, {20.0, 20.0, 20.0}, {1, 1, 1});
  specimen.bricks(2, {5, 5, 30}, {10.0, 10.0, 10.0}, {1, 1, 1});
  specimen.text("*INITIAL_VELOCITY_RIGID_BODY\n" + fields({2, 0, 0, 0, 0, 0, 30}));
  Experiment experiment(specimen.deck());
  double heavy = 0.0, light = 0.0, balance = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    heavy = now.spin(at(now.system.bodies.at(0).node)).z;
    light = now.spin(at(now.system.bodies.at(1).node)).z;
    balance = std::max(balance, std::abs(now.energy.ratio() - 1.0));
  });
  constexpr double ratio = 32.0;  // of the moments of inertia: edges of 2 to 1
  const double rate = 2.0 * share * 2.0 * pi * frequency * (1.0 + 1.0 / ratio);
  EXPECT_NEAR(light - heavy, 30.0 * std::exp(-rate * time), 2e-3 * 30.0);
  EXPECT_NEAR(light + ratio * heavy, 30.0, 1e-9);
  EXPECT_LT(balance, 1e-6);
}

// Two blocks, a light one damped relative to a heavy one: what one loses the other gets.
TEST(Damping, RelativeToABodyConservesMomentum) {
  constexpr double share = 0.1, frequency = 20.0, time = 0.05;
  Specimen specimen;
  specimen.card("MAT_RIGID", {1, density, modulus, 0.3})
      .text("\n\n")
      .card("MAT_ELASTIC", {2, density, modulus, 0.3})
      .card("SECTION_SOLID", {1, 1})
      .part(1, 1, 1)
      .part(2, 1, 2)
      .text("*SET_PART_LIST\n" + fields({5}) + fields({2}))
      .card("DAMPING_RELATIVE", {share, frequency, 1, 5})
      .card("CONTROL_TERMINATION", {time});
  specimen.bricks(1, {}, {20.0, 20.0, 20.0}, {1, 1, 1});
  const Grid light = specimen.bricks(2, {5, 5, 30}, {10.0, 10.0, 10.0}, {1, 1, 1});
  for (const int id : light.all()) specimen.card("INITIAL_VELOCITY_NODE", {1.0 * id, 0, 0, 100});
  Experiment experiment(specimen.deck());
  double relative = 0.0, momentum = 0.0, ratio = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const Vec3d body = now.velocity(at(now.system.bodies.at(0).node));
    const Vec3d v = experiment.velocity(now, light(0, 0));
    relative = v.z - body.z;
    momentum = density * (8000.0 * body.z + 1000.0 * v.z);
    ratio = now.energy.ratio();
  });
  // The relative velocity decays with the reduced mass 8/9 of the light block.
  const double rate = 2.0 * share * 2.0 * pi * frequency * (1.0 + 1.0 / 8.0);
  expect_reference("damping", "relative to a body: relative velocity", relative, 100.0 * std::exp(-rate * time), 2e-3);
  expect_reference("damping", "relative to a body: momentum", momentum, density * 1000.0 * 100.0, 1e-9);
  expect_reference("damping", "relative to a body: energy ratio", ratio, 1.0, 1e-6);
}

}  // namespace
}  // namespace nugget::verify
