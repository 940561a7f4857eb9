// SPDX-License-Identifier: Apache-2.0
// Every OPT of MAT_100 on a weld beam, on a brick and on a cluster of eight bricks: tension, shear, bending, torsion
// where the criterion has it, and a path on which all act until the surface is crossed. One table of criteria; each is
// written here a second time, as the manual's formula, and asked for the load that its weld has to carry. What the weld
// carries is shown by the supports of its lower sheet, not by the weld's own resultants.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "experiment.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

using std::numbers::pi;

constexpr double step = 1e-7;  // below the stable step of all welds here
constexpr double d = 6.0, length = 1.5, area = 0.25 * pi * d * d, modulus = area * d / 8.0;

/// How the weld stands in the model: RPBHX of *CONTROL_SPOTWELD_BEAM.
struct Kind {
  int bricks;
  const char* name;
};
constexpr Kind kinds[] = {{0, "beam"}, {1, "brick"}, {8, "8 bricks"}};

/// Forces and moments on the section at mid-length, r = z, s = x, t = y.
struct Load {
  double n = 0.0, vs = 0.0, vt = 0.0, t = 0.0, ms = 0.0, mt = 0.0;
  double v() const { return std::hypot(vs, vt); }
  double m() const { return std::hypot(ms, mt); }
  double pull() const { return std::max(n, 0.0); }
};
/// Grows in proportion with the load, and is 1 at failure.
using Measure = std::function<double(const Load&)>;

double square(double a) {
  return a * a;
}

/// Elongation, shear along s and t, twist, and bending about s and t without shear, at the end of the path.
struct Motion {
  double pull = 0.0, shear_s = 0.0, shear_t = 0.0, twist = 0.0, bend_s = 0.0, bend_t = 0.0;
};

/// A weld of 6 mm that does not yield, from sheet 2 (1 mm, fixed) at z = 0 to sheet 3 (1.5 mm, moved) at z = 1.5. Each
/// sheet is one shell; all its nodes are held or driven.
std::string deck_of(const Kind& kind, const std::string& material, const std::string& more, const Motion& u,
                    int cycles) {
  const double end = cycles * step;
  std::string deck =
      "*KEYWORD\n" + termination(end, 0.9, 0.0, 90) + curve(90, {{0.0, step}, {1.0, step}}) + "*PART\nwelds\n" +
      fields({1, 1, 1}) + "*SECTION_BEAM\n" + fields({1, 9, 1, 2, 1}) + fields({d, d, 0, 0}) +
      "*MAT_SPOTWELD_DAMAGE-FAILURE\n" + fields({1, 7.8e-9, 210000, 0.3, 1e6, 1000}) + material + more +
      beam_between(1, 1, 1, {0, 0, 0}, 2, {0, 0, length}) + "*MAT_ELASTIC\n" + fields({2, 7.85e-9, 210000, 0.3});
  if (kind.bricks > 0) deck += fmt::format("*CONTROL_SPOTWELD_BEAM\n{:60d}\n", kind.bricks);
  for (const int sheet : {2, 3}) {
    const double id = sheet, thickness = 0.5 * id;
    const SheetMesh mesh{.first = 100 * sheet, .part = sheet, .corner = {-5, -5, sheet == 2 ? 0.0 : length}};
    deck += "*PART\nsheet\n" + fields({id, id, 2}) + "*SECTION_SHELL\n" + fields({id, 2, 0.8333, 3}) +
            fields({thickness, thickness, thickness, thickness}) + mesh.text();
  }
  deck += "*CONTACT_SPOTWELD_WITH_TORSION\n" + fields({1, 1, 3, 2}) + fields({0}) + fields({1, 1}) +
          "*SET_PART_LIST\n" + fields({1}) + fields({2, 3}) + fixed({200, 201, 202, 203});
  for (int i = 0; i < 4; ++i) {
    const double x = i % 2 == 0 ? -5.0 : 5.0, y = i < 2 ? -5.0 : 5.0, half = 0.5 * length;
    const Path path = [=](double s) {
      return std::array<double, 6>{s * (u.shear_s + half * u.bend_t - u.twist * y),
                                   s * (u.shear_t - half * u.bend_s + u.twist * x),
                                   s * (u.pull + u.bend_s * y - u.bend_t * x),
                                   s * u.bend_s,
                                   s * u.bend_t,
                                   s * u.twist};
    };
    deck += driven(300 + i, path, end, 1, 100 + 10 * i);
  }
  return deck + "*END\n";
}

struct Outcome {
  bool failed = false;
  Load load;  ///< on the supports, in the last cycle that the weld holds
  double value = 0.0, rate = 0.0;
};

Outcome run(const Kind& kind, const std::string& material, const std::string& more, const Motion& u,
            int cycles = 2000) {
  Experiment run(deck_of(kind, material, more, u, cycles));
  Outcome out;
  run.run([&](const impact::Snapshot& now) {
    const weld::History& h = *now.components.welds.history(0);
    out.failed = h.failed();
    if (out.failed) return;
    Vec3d n, m;
    for (const auto& r : now.components.supports.spc_reactions()) {
      n -= r.force;
      m -= r.moment + cross(vec(now.state.x[r.node]), r.force);
    }
    m += Vec3d{0.5 * length * n.y, -0.5 * length * n.x, 0.0};  // to mid-length
    out.load = {n.z, n.x, n.y, m.z, m.x, m.y};
    out.value = h.failure_value();
    out.rate = h.strain_rate();
  });
  return out;
}

struct Criterion {
  std::string name, material;
  Measure measure;
  bool moments_at_ends = false;  ///< of bricks
  bool torsion = false, bending = true;
  std::string more{};
};

std::string cards(std::initializer_list<double> second, std::initializer_list<double> third) {
  return fields(second) + fields(third);
}

/// (sigma/S)^2 + (tau/T)^2 of beam theory.
Measure beam_stress(double normal, double shear) {
  return [=](const Load& l) {
    const double sigma = std::max(l.n / area + l.m() / modulus, 0.0);
    const double tau = std::abs(l.t) / (2.0 * modulus) + l.v() / area;
    return std::hypot(sigma / normal, tau / shear);
  };
}

double surface(const Load& l) {
  return std::sqrt(square(l.pull() / 8000) + square(l.vs / 6000) + square(l.vt / 5000) + square(l.t / 9000) +
                   square(l.ms / 7000) + square(l.mt / 7500));
}

/// K_eq over FVAL = 300, t = 1.
double stress_intensity(const Load& l) {
  const double opening = std::sqrt(3.0) * l.v() / (2 * pi * d) + 2 * std::sqrt(3.0) * l.m() / (pi * d) +
                         5 * std::sqrt(2.0) * l.pull() / (3 * pi * d);
  return std::hypot(opening, 2 * l.v() / (pi * d)) / 300.0;
}

/// Notch stress over FVAL = 1500, t = 1, radius 0.25.
double notch_stress(const Load& l) {
  const double sharp = 2.0;  // sqrt(t / rho)
  return (4 * l.v() / (pi * d) * (1 + (std::sqrt(3.0) + std::sqrt(19.0)) / (8 * std::sqrt(pi)) * sharp) +
          6 * l.m() / (pi * d) * (1 + 2 / std::sqrt(3 * pi) * sharp) +
          4 * l.pull() / (pi * d * d) * (1 + 5 / (3 * std::sqrt(2 * pi)) * d * sharp)) /
         1500.0;
}

/// The largest of the stresses around the nugget in both sheets (1 and 1.5) and in the nugget, over FVAL = 4, in a
/// thousand directions. A small load: sheared by more, a beam gets longer, and these stresses are 33 times as sensitive
/// to N as to V.
double structural_stress(const Load& l) {
  double most = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double a = 2 * pi * i / 1000, c = std::cos(a), s = std::sin(a);
    // each sheet with what it gets, r from it into the weld, s = x
    const Load upper{l.n, -l.vs, l.vt, l.t, -l.ms, l.mt};
    for (const auto& [t, at] : {std::pair{1.0, l}, std::pair{1.5, upper}})
      most = std::max(most, -(at.vs * c + at.vt * s) / (pi * d * t) + 1.744 * at.pull() / (t * t) +
                                1.872 * (at.ms * s - at.mt * c) / (d * t * t));
    const double sigma = 4 * l.pull() / (pi * d * d) + 32 * (l.ms * s - l.mt * c) / (pi * d * d * d);
    const double tau = 16 * (l.vs * s * s + l.vt * c * c) / (3 * pi * d * d);
    most = std::max(most, 0.5 * sigma + std::hypot(0.5 * sigma, tau));
  }
  return most / 4.0;
}

/// OPT 11: 6000 in shear, 8000 in tension.
double by_direction(const Load& l) {
  const double angle = std::atan2(std::abs(l.n), l.v()) * 180 / pi;
  return std::hypot(l.n, l.v()) / (6000 + 2000 * angle / 90);
}

std::vector<Criterion> criteria() {
  return {
      {"OPT 0", cards({0, 8000, 6000, 5000, 9000, 7000, 7500}, {0, 0}), surface, true, true},
      {"OPT 1", cards({0, 320, 190}, {0, 1}), beam_stress(320, 190), true, true},
      {"OPT 3", cards({0, 6, 1, 1, 1, 1, 0.25}, {0, 3, 1500}), notch_stress},
      {"OPT 4", cards({0, 6, 1, 1, 1, 1}, {0, 4, 300}), stress_intensity},
      {"OPT 5", cards({0}, {0, 5, 4}), structural_stress},
      {"OPT 6", cards({0}, {0, 6}), beam_stress(300, 240), false, true, true,
       "*DEFINE_SPOTWELD_RUPTURE_STRESS\n" + fields({2, 300, 240}) + fields({3, 400, 250})},
      {"OPT 7", cards({0}, {0, 7}), beam_stress(320, 190), true, true, true,
       "*DEFINE_SPOTWELD_FAILURE_RESULTANTS\n" + fields({1, 900, 900}) + fields({3, 2, 320, 190})},
      {"OPT 10", cards({0}, {0, 10, 5}),
       [](const Load& l) { return std::hypot(l.pull() / (d * 800), l.v() / (d * 600)); }, false, false, false,
       "*DEFINE_SPOTWELD_FAILURE\n" + fields({5, 0, 0, 0, 0, 1e30}) + fields({0, 900, 900}) + fields({2, 800, 600})},
      {"OPT 11", cards({0, 70, 71}, {0, 11}), by_direction, false, false, false,
       curve(70, {{0, 6000}, {90, 8000}}) + curve(71, {{0, 6000}, {90, 20000}})},
  };
}

/// The measure at the end where it is larger, the shear force acting over the weld's length.
double at_ends(const Measure& measure, Load l) {
  double most = 0.0;
  for (const double half : {-0.5 * length, 0.5 * length}) {
    Load end = l;
    end.ms += half * l.vt;
    end.mt -= half * l.vs;
    most = std::max(most, measure(end));
  }
  return most;
}

// Sabotage to be caught: resultants of one face only; the moments of the lower sheet for those of mid-length; torsion
// or a component of shear left out; the length of a brick for its diameter; strengths of the stronger sheet.
TEST(WeldOptions, EachOnBeamBrickAndCluster) {
  const WeldData w{.diameter = d, .length = length};
  for (const Criterion& c : criteria())
    for (const Kind& kind : kinds) {
      const bool ends = c.moments_at_ends && kind.bricks > 0;
      const Measure measure = [&](const Load& l) { return ends ? at_ends(c.measure, l) : c.measure(l); };
      const auto expect = [&](const char* load, const Load& unit, double Load::*part, double stiffness,
                              double Motion::*motion) {
        const double strength = 1.0 / measure(unit);
        Motion u;
        u.*motion = 1.6 * strength / stiffness;
        const Outcome out = run(kind, c.material, c.more, u);
        EXPECT_TRUE(out.failed) << c.name << ", " << kind.name << ", " << load;
        expect_reference("OPT table", fmt::format("{}, {}: {} at failure", c.name, kind.name, load),
                         std::abs(out.load.*part), strength, 5e-3);
      };
      expect("tension", {.n = 1}, &Load::n, w.axial_stiffness(), &Motion::pull);
      expect("shear along s", {.vs = 1}, &Load::vs, w.shear_stiffness(), &Motion::shear_s);
      expect("shear along t", {.vt = 1}, &Load::vt, w.shear_stiffness(), &Motion::shear_t);
      if (c.bending) {
        expect("bending about s", {.ms = 1}, &Load::ms, w.bending_stiffness(), &Motion::bend_s);
        expect("bending about t", {.mt = 1}, &Load::mt, w.bending_stiffness(), &Motion::bend_t);
      }
      if (c.torsion) expect("torsion", {.t = 1}, &Load::t, w.torsion_stiffness(), &Motion::twist);
      // A mixed path that goes to 1.6 times what a beam bears.
      const Load mixed{2000, 1500, 1000, c.torsion ? 1500.0 : 0.0, c.bending ? 800.0 : 0.0, c.bending ? 1200.0 : 0.0};
      const double scale = 1.6 / measure(mixed);
      const Outcome all = run(kind, c.material, c.more,
                              {scale * mixed.n / w.axial_stiffness(), scale * mixed.vs / w.shear_stiffness(),
                               scale * mixed.vt / w.shear_stiffness(), scale * mixed.t / w.torsion_stiffness(),
                               scale * mixed.ms / w.bending_stiffness(), scale * mixed.mt / w.bending_stiffness()});
      EXPECT_TRUE(all.failed) << c.name << ", " << kind.name;
      expect_reference("OPT table", fmt::format("{}, {}: measure of all loads together at failure", c.name, kind.name),
                       measure(all.load), 1.0, 5e-3);
    }
}

// OPT -1 and -2 hold and give the value; compression and bending alone do not fail what does not count them.
TEST(WeldOptions, WhatHolds) {
  for (const Kind& kind : kinds) {
    for (const double option : {-1.0, -2.0}) {
      const Outcome out = run(kind, cards({0, 8000, 6000, 5000, 9000, 7000, 7500}, {0, option}), "",
                              {3e-3, 4e-3, 3e-3, 1e-3, 5e-4, 7e-4});
      EXPECT_FALSE(out.failed) << kind.name;
      const double f = square(kind.bricks > 0 ? at_ends(surface, out.load) : surface(out.load));
      expect_reference("OPT table",
                       fmt::format("OPT {}, {}: failure value over that of the supports' load", option, kind.name),
                       out.value / f, 1.0, 5e-3);
      EXPECT_GT(f, 1.5);
    }
    for (const Criterion& c : criteria()) {
      const bool fails_in_compression = c.name == "OPT 11";
      EXPECT_EQ(run(kind, c.material, c.more, {.pull = -1e-2}).failed, fails_in_compression) << c.name << kind.name;
    }
  }
}

// Strengths over the strain rate at three speeds. Of a brick whose sides are held the effective rate in tension is 2/3
// of the elongation's, von Mises' measure of a strain in one direction; in shear it is that of the beam.
// Sabotage to be caught: the rate of the engineering shear; the first value of the curve at all rates; the sum over the
// bricks of a cluster.
TEST(WeldOptions, StrengthsAtThreeStrainRates) {
  const std::string material = cards({0, -70, -71}, {0}),
                    more = curve(70, {{0.5, 6000}, {1, 8000}, {5, 9000}, {20, 10000}, {40, 15000}}) +
                           curve(71, {{0.5, 4000}, {1, 6000}, {5, 7000}, {20, 9000}, {40, 12000}});
  for (const Kind& kind : kinds) {
    const double share = kind.bricks > 0 ? 2.0 / 3.0 : 1.0;
    for (const auto& [rate, n, v] : {std::array{1.0, 8000.0, 6000.0}, {5.0, 9000.0, 7000.0}, {20.0, 10000.0, 9000.0}}) {
      const double pull = 3e-3, shear = 6e-3;
      const Outcome in_tension =
          run(kind, material, more, {.pull = pull}, static_cast<int>(share * pull / length / rate / step));
      const std::string what = fmt::format("{}: at {} 1/s ", kind.name, rate);
      expect_reference("rates", what + "effective strain rate in tension [1/s]", in_tension.rate, rate, 5e-3);
      expect_reference("rates", what + "N at failure", in_tension.load.n, n, 5e-3);
      const Outcome in_shear = run(kind, material, more, {.shear_s = shear},
                                   static_cast<int>(shear / length / std::sqrt(3.0) / rate / step));
      expect_reference("rates", what + "V at failure", in_shear.load.vs, v, 5e-3);
    }
  }
}

}  // namespace
}  // namespace nugget::verify
