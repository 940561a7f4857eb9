// SPDX-License-Identifier: Apache-2.0
// Material laws through the program's own path: single elements pulled, against the laws' formulas.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double E = 210000.0;

/// Which of the elements a law may have.
enum class Of { all, shells, bricks };

/// A shell of ELFORM 2, one of ELFORM 16, a brick of ELFORM 1 and one of ELFORM 2 (parts 1 to 4), side 1 mm, each
/// pulled along x by the velocity of its face and free to contract. Material 1 comes from outside.
struct Pulled {
  Specimen specimen;
  int first = 1, last = 4;

  /// `strain`, `rate`: true strain and its rate [1/s] at the end; `back`: that to which it goes back from there, with
  /// the same speed.
  Pulled(const std::string& material, double strain, double rate, Of of = Of::all, std::optional<double> back = {})
      : first(of == Of::bricks ? 3 : 1), last(of == Of::shells ? 2 : 4) {
    Specimen& s = specimen;
    s.text(material);
    s.text("*SECTION_SHELL\n" + fields({1, 2, 1.0, 3}) + fields({1, 1, 1, 1}) + fields({2, 16, 1.0, 3}) +
           fields({1, 1, 1, 1}));
    s.card("SECTION_SOLID", {3, 1}).card("SECTION_SOLID", {4, 2});
    for (int p = first; p <= last; ++p) s.part(p, p, 1);
    std::vector<int> left, right, front, shell_nodes, bottom;
    for (int p = first; p <= last; ++p) {
      const Vec3d corner{0.0, 10.0 * p, 0.0};
      const Grid grid = p <= 2 ? s.shells(p, corner, {1, 1, 0}, 1, 1) : s.bricks(p, corner, {1, 1, 1}, {1, 1, 1});
      for (int k = 0; k <= grid.cells[2]; ++k)
        for (int j = 0; j <= 1; ++j) {
          left.push_back(grid(0, j, k));
          right.push_back(grid(1, j, k));
          front.push_back(grid(j, 0, k));
          if (p > 2 && k == 0) bottom.push_back(grid(0, j)), bottom.push_back(grid(1, j));
          if (p <= 2) shell_nodes.push_back(grid(0, j)), shell_nodes.push_back(grid(1, j));
        }
    }
    s.node_set(1, left).card("BOUNDARY_SPC_SET", {1, 0, 1});
    s.node_set(2, front).card("BOUNDARY_SPC_SET", {2, 0, 0, 1});
    if (first == 1) s.node_set(3, shell_nodes).card("BOUNDARY_SPC_SET", {3, 0, 0, 0, 1, 1, 1, 1});
    if (last == 4) s.node_set(4, bottom).card("BOUNDARY_SPC_SET", {4, 0, 0, 0, 1});
    const double length = std::exp(strain), speed = rate * length, there = (length - 1.0) / speed;
    const double end = there + (back ? (length - std::exp(*back)) / speed : 0.0);
    s.node_set(5, right);
    if (back)
      s.text(curve(99, {{0.0, 1.0}, {there, 1.0}, {1.0001 * there, -1.0}, {1.0, -1.0}}));
    else
      s.text(constant_curve(99));
    s.card("BOUNDARY_PRESCRIBED_MOTION_SET", {5, 1, 0, 99, speed});
    s.card("CONTROL_TERMINATION", {end}).card("CONTROL_SHELL", {0, 0, 0, 1});
  }
};

constexpr const char* element_names[] = {"", "shell ELFORM 2", "shell ELFORM 16", "brick ELFORM 1", "brick ELFORM 2"};

/// Axial stress at the end of the elements, by part; 0 for those that were deleted. `eroded`: energy of these.
std::array<double, 5> stress_at_end(const Pulled& pulled, double* eroded = nullptr) {
  Experiment experiment(pulled.specimen.deck());
  std::array<double, 5> stress{};
  double ratio = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    for (int p = pulled.first; p <= pulled.last; ++p)
      stress[p] = (p <= 2 ? shell_layer(experiment, now, p, 1) : brick_layer(experiment, now, p - 2)).stress[0];
    ratio = now.energy.ratio();
    if (eroded) *eroded = now.energy.eroded;
  });
  EXPECT_NEAR(ratio, 1.0, 0.01);
  return stress;
}

/// Stress of a bar of the yield stress given over plastic strain, at a true strain beyond yield.
double flow_stress(const std::function<double(double)>& yield, double strain) {
  double low = 0.0, high = strain;
  for (int i = 0; i < 100; ++i) {
    const double ep = 0.5 * (low + high);
    (E * (strain - ep) > yield(ep) ? low : high) = ep;
  }
  return yield(low);
}

void expect_stress(const std::string& what, const Pulled& pulled, double strain, double expected, double gate,
                   const std::string& test_case) {
  const std::array<double, 5> stress = stress_at_end(pulled);
  for (int p = pulled.first; p <= pulled.last; ++p)
    expect_reference(test_case,
                     fmt::format("{}, {}: true stress at a strain of {} [MPa]", what, element_names[p], strain),
                     stress[p], expected, gate);
}

void expect_law(const std::string& test_case, const std::string& what, const std::string& material, double strain,
                double rate, const std::function<double(double)>& yield, double gate, Of of = Of::all) {
  expect_stress(what, Pulled(material, strain, rate, of), strain, flow_stress(yield, strain), gate, test_case);
}

/// Everything is deleted on the way to a strain of 0.06, with the energy that the area under the curve says.
void expect_erosion(const std::string& what, const std::string& material, double energy) {
  double eroded = 0.0;
  stress_at_end(Pulled(material, 0.06, 100.0), &eroded);
  expect_reference("laws", what + ", four elements of 1 mm3: eroded energy [mJ]", eroded, 4.0 * energy, 0.01);
}

std::string mat(const std::string& name, std::initializer_list<std::initializer_list<double>> cards) {
  std::string text = "*MAT_" + name + "\n";
  for (const auto& card : cards) text += fields(card);
  return text;
}

// Cowper-Symonds rate effect. Sabotage: the exponent P instead of 1/P.
TEST(Laws, CowperSymonds) {
  const double factor = 1.0 + std::pow(100.0 / 40.4, 0.2);
  EXPECT_NEAR(factor, 2.19874, 1e-5);
  for (const double vp : {0.0, 1.0}) {
    const std::string kind = vp == 0.0 ? "VP 0" : "VP 1";
    expect_law(
        "Cowper-Symonds rate effect", "MAT_024 " + kind,
        mat("024", {{1, 7.85e-9, E, 0.3, 250.0}, {40.4, 5.0, 0, 0, vp}, {}, {}}), 0.05, 100.0,
        [&](double) { return 250.0 * factor; }, 0.01);
    expect_law(
        "Cowper-Symonds rate effect", "MAT_003 " + kind,
        mat("003", {{1, 7.85e-9, E, 0.3, 250.0, 0.0, 1.0}, {40.4, 5.0, 0, vp}}), 0.05, 100.0,
        [&](double) { return 250.0 * factor; }, 0.01);
  }
}

// VP 1 raises SIGY alone, whatever the hardening adds (blog.d3view.com on MAT_024 and SIGY; Keyword Manual, remarks on
// MAT_024). Sabotage: all of the yield stress raised, 8 % more.
TEST(Laws, ViscoplasticCowperSymondsRaisesSigyAlone) {
  const double raise = 250.0 * std::pow(100.0 / 40.4, 0.2);
  expect_law(
      "laws", "MAT_024 VP 1 with ETAN", mat("024", {{1, 7.85e-9, E, 0.3, 250.0, 1000.0}, {40.4, 5.0, 0, 0, 1}, {}, {}}),
      0.05, 100.0, [&](double ep) { return 250.0 + E * 1000.0 / (E - 1000.0) * ep + raise; }, 0.002);
  expect_law(
      "laws", "MAT_024 VP 1 with LCSS",
      mat("024", {{1, 7.85e-9, E, 0.3, 250.0}, {40.4, 5.0, 7, 0, 1}, {}, {}}) + curve(7, {{0.0, 300.0}, {0.1, 500.0}}),
      0.05, 100.0, [&](double ep) { return 300.0 + 2000.0 * ep + raise; }, 0.002);
}

/// Ten shells of ELFORM 2, of ELFORM 16, ten bricks of ELFORM 1 and of ELFORM 2 in a row (parts 1 to 4), pulled along x
/// at 100/s of their first length from a state of uniform strain rate. Ratio of the true stress to the law's
/// `yield(plastic strain, strain rate)`, between strains of 0.035 and 0.05: mean, least and greatest over the time and
/// over the first, the fifth and the last element.
void expect_stress_along_strips(const std::string& what, const std::string& material,
                                const std::function<double(double, double)>& yield) {
  constexpr int n = 10;
  const double speed = 1000.0;
  Specimen s;
  s.text(material);
  s.text("*SECTION_SHELL\n" + fields({1, 2, 1.0, 3}) + fields({1, 1, 1, 1}) + fields({2, 16, 1.0, 3}) +
         fields({1, 1, 1, 1}));
  s.card("SECTION_SOLID", {3, 1}).card("SECTION_SOLID", {4, 2});
  std::vector<int> left, right, front, shell_nodes, bottom;
  std::string velocities = "*INITIAL_VELOCITY_NODE\n";
  for (int p = 1; p <= 4; ++p) {
    s.part(p, p, 1);
    const Vec3d corner{0.0, 10.0 * p, 0.0};
    const Grid grid = p <= 2 ? s.shells(p, corner, {n, 1, 0}, n, 1) : s.bricks(p, corner, {n, 1, 1}, {n, 1, 1});
    for (int k = 0; k <= grid.cells[2]; ++k)
      for (int j = 0; j <= 1; ++j)
        for (int i = 0; i <= n; ++i) {
          const int node = grid(i, j, k);
          velocities += fields({1.0 * node, speed * i / n});
          if (i == 0) left.push_back(node);
          if (i == n) right.push_back(node);
          if (j == 0) front.push_back(node);
          if (p <= 2) shell_nodes.push_back(node);
          if (p > 2 && k == 0) bottom.push_back(node);
        }
  }
  s.node_set(1, left).card("BOUNDARY_SPC_SET", {1, 0, 1});
  s.node_set(2, front).card("BOUNDARY_SPC_SET", {2, 0, 0, 1});
  s.node_set(3, shell_nodes).card("BOUNDARY_SPC_SET", {3, 0, 0, 0, 1, 1, 1, 1});
  s.node_set(4, bottom).card("BOUNDARY_SPC_SET", {4, 0, 0, 0, 1});
  s.node_set(5, right).text(velocities).text(constant_curve(99));
  s.card("BOUNDARY_PRESCRIBED_MOTION_SET", {5, 1, 0, 99, speed});
  s.card("CONTROL_TERMINATION", {n * (std::exp(0.05) - 1.0) / speed}).card("CONTROL_SHELL", {0, 0, 0, 1});

  Experiment experiment(s.deck());
  struct Ratio {
    TimeMean mean;
    double least = 1e9, most = 0.0;
  };
  std::array<Ratio, 4> ratios;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const double length = n + speed * now.state.time, strain = std::log(length / n);
    if (strain < 0.035) return;
    const double expected = flow_stress([&](double ep) { return yield(ep, speed / length); }, strain);
    for (int p = 0; p < 4; ++p)
      for (const int e : {1, 5, n}) {
        const int id = p % 2 * n + e;
        const double stress =
            (p < 2 ? shell_layer(experiment, now, id, 1) : brick_layer(experiment, now, id)).stress[0];
        Ratio& r = ratios[p];
        r.mean.add(stress / expected, 1.0);
        r.least = std::min(r.least, stress / expected);
        r.most = std::max(r.most, stress / expected);
      }
  });
  for (std::size_t p = 0; p < 4; ++p) {
    const std::string row = fmt::format("{}, ten in a row, {}: stress over the law's, ", what, element_names[p + 1]);
    expect_reference("laws", row + "mean", ratios[p].mean.value(), 1.0, 0.005);
    expect_reference("laws", row + "least", ratios[p].least, 1.0, 0.02);
    expect_reference("laws", row + "greatest", ratios[p].most, 1.0, 0.02);
  }
}

// With the total strain rate in the yield stress neighbours shake each other: means 22 % too high, scatter of 30 %, and
// one brick 4 % too low. Sabotage: VP 0 by the total rate.
TEST(Laws, RatesAlongStrips) {
  const double H = E * 2000.0 / (E - 2000.0);
  const auto symonds = [&](double ep, double rate) { return (300.0 + H * ep) * (1.0 + std::pow(rate / 40.4, 0.2)); };
  expect_stress_along_strips("MAT_024 VP 0, C 40.4 P 5",
                             mat("024", {{1, 7.85e-9, E, 0.3, 300.0, 2000.0}, {40.4, 5.0}, {}, {}}), symonds);
  expect_stress_along_strips("MAT_003 VP 0, SRC 40.4 SRP 5",
                             mat("003", {{1, 7.85e-9, E, 0.3, 300.0, 2000.0, 1.0}, {40.4, 5.0}}), symonds);
  expect_stress_along_strips("MAT_024 VP 0, LCSR",
                             mat("024", {{1, 7.85e-9, E, 0.3, 300.0, 2000.0}, {0, 0, 0, 5}, {}, {}}) +
                                 curve(5, {{0.0, 1.0}, {100.0, 1.5}, {1000.0, 2.0}}),
                             [&](double ep, double rate) { return (300.0 + H * ep) * (1.0 + 0.5 * rate / 100.0); });
}

// Sabotage: the rates of a factor in LCSR taken for plastic strains.
TEST(Laws, RateFactorInOneElement) {
  for (const double vp : {-1.0, 0.0, 1.0, 3.0, 4.0})
    expect_law(
        "laws", fmt::format("MAT_024 LCSR, VP {}", vp),
        mat("024", {{1, 7.85e-9, E, 0.3, 300.0}, {0, 0, 0, 5, vp}, {}, {}}) +
            curve(5, {{0.0, 1.0}, {100.0, 1.5}, {1000.0, 2.0}}),
        0.1, 100.0, [](double) { return 450.0; }, 0.002);
}

// Sabotage: the natural logarithm taken to base 10.
TEST(Laws, SimplifiedJohnsonCook) {
  const auto hardened = [](double ep) { return 300.0 + 500.0 * std::pow(ep, 0.3); };
  expect_law("laws", "MAT_098 without rates",
             mat("SIMPLIFIED_JOHNSON_COOK", {{1, 7.85e-9, E, 0.3}, {300.0, 500.0, 0.3}}), 0.1, 100.0, hardened, 0.005);
  for (const double vp : {0.0, 1.0})
    expect_law(
        "MAT_098", fmt::format("MAT_098 C 0.05, EPSO 0.1, 200/s, VP {}", vp),
        mat("098", {{1, 7.85e-9, E, 0.3, vp}, {300.0, 500.0, 0.3, 0.05, 0, 0, 0, 0.1}}), 0.1, 200.0,
        [&](double ep) { return hardened(ep) * (1.0 + 0.05 * std::log(200.0 / 0.1)); }, 0.005);
}

// Sabotage: the viscous stress scaled by the yield stress, as that of Cowper and Symonds.
TEST(Laws, Viscoplastic) {
  const auto hardened = [](double ep) {
    return 300.0 + 100.0 * (1.0 - std::exp(-25.0 * ep)) + 150.0 * (1.0 - std::exp(-4.0 * ep));
  };
  const std::string cards = "*MAT_103\n" + fields({1, 7.85e-9, E, 0.3, 300.0}) + fields({100.0, 25.0, 150.0, 4.0});
  expect_law("laws", "MAT_103 without VK", cards + "\n\n\n\n", 0.1, 100.0, hardened, 0.002);
  expect_law(
      "laws", "MAT_103 VK 30, VM 0.2, 100/s", cards + fields({30.0, 0.2}) + "\n\n\n", 0.1, 100.0,
      [&](double ep) { return hardened(ep) + 30.0 * std::pow(100.0, 0.2); }, 0.005);
}

/// Pulled across the rolling direction: of shells F + H = (1 + 1/R90) R00/(1 + R00), of bricks that of the card; stress
/// times, and plastic strain over, its root is what hardens, by isotropic and kinematic terms alike. Sabotage: R00 and
/// R90 exchanged; the back stress in the direction of the flow.
TEST(Laws, ViscoplasticAcrossTheRollingDirection) {
  const auto hardened = [](double ep) {
    return 300.0 + 100.0 * (1.0 - std::exp(-25.0 * ep)) + 150.0 * (1.0 - std::exp(-4.0 * ep)) +
           80.0 * (1.0 - std::exp(-30.0 * ep));
  };
  const std::string cards =
      "*MAT_103\n" + fields({1, 7.85e-9, E, 0.3, 300.0}) + fields({100.0, 25.0, 150.0, 4.0, 80.0, 30.0});
  const auto across = [&](const std::vector<double>& shape, double square, Of of, const char* what) {
    std::string line = "0.0,0.0";
    for (const double one : shape) line += fmt::format(",{}", one);
    const double root = std::sqrt(square);
    expect_law(
        "laws", what, cards + line + "\n2\n,,,0.0,1.0,0.0\n,,,-1.0,0.0,0.0\n", 0.1, 100.0,
        [&](double ep) { return hardened(ep / root) / root; }, 0.002, of);
  };
  across({0.8, 1.4, 1.9}, 0.8 / 1.8 * (1.0 + 1.0 / 1.9), Of::shells, "MAT_103, R00 0.8, R45 1.4, R90 1.9, along b");
  across({0.35, 0.6, 0.5, 1.2, 1.9, 1.6}, 0.85, Of::bricks, "MAT_103, F 0.35, H 0.5, along b");
}

// Sabotage: the temperature rise over TM instead of TM - TR.
TEST(Laws, JohnsonCook) {
  // Without hardening the heat is the work: T* = 1 - exp(-A ep / (rho c (TM - TR))).
  const double heat_to_melt = 7.85e-9 * 4.5e8 * 500.0;
  expect_law(
      "laws", "MAT_015, CP, M 1",
      mat("015", {{1, 7.85e-9, 8e4, E, 0.3}, {500.0, 0, 0, 0, 1.0, 800.0, 300.0, 1.0}, {4.5e8}, {}}), 0.3, 100.0,
      [&](double ep) { return 500.0 * std::exp(-500.0 * ep / heat_to_melt); }, 0.005, Of::shells);
}

// Sabotage: the strain at first yield left out of the power law; ETAN of MAT_012 taken as a tangent modulus.
TEST(Laws, FormulasOfMetals) {
  const double e0 = std::pow(E / 600.0, 1.0 / (0.2 - 1.0));
  expect_law(
      "laws", "MAT_018 K 600 N 0.2", mat("018", {{1, 7.85e-9, E, 0.3, 600.0, 0.2}, {}}), 0.1, 100.0,
      [&](double ep) { return 600.0 * std::pow(e0 + ep, 0.2); }, 0.005);
  for (const double vp : {0.0, 1.0})
    expect_law(
        "laws", fmt::format("MAT_019, VP {}", vp),
        mat("019", {{1, 7.85e-9, E, 0.3, vp}, {7, 1000.0}}) + curve(7, {{0.0, 280.0}, {200.0, 320.0}}), 0.1, 100.0,
        [](double ep) { return 300.0 + 1000.0 * ep; }, 0.005);
  expect_law(
      "laws", "MAT_012", mat("012", {{1, 7.85e-9, E / 2.6, 300.0, 1000.0, E / 1.2}}), 0.1, 100.0,
      [](double ep) { return 300.0 + 1000.0 * ep; }, 0.005);
}

// Sabotage: the damage counted twice, (1 - w)^2.
TEST(Laws, PlasticityWithDamage) {
  const std::string material = mat("081", {{1, 7.85e-9, E, 0.3, 300.0, 0, 0.02}, {0, 0, 0, 0, 0.12}, {}, {}});
  const double ep = 0.08 - 300.0 / E;
  expect_stress("MAT_081 EPPF 0.02 EPPFR 0.12", Pulled(material, 0.08, 100.0), 0.08, 300.0 * (1.0 - (ep - 0.02) / 0.1),
                0.005, "laws");
}

// Sabotage: the rate as a logarithm; C1 for C2; WC as a strain.
TEST(Laws, ModifiedJohnsonCook) {
  const auto material = [](double wc) {
    return mat(
        "107",
        {{1, 7.85e-9, E, 0.3}, {5e-4, 0, 0, 0, 0, 1}, {490, 383, 0.45, 0.0114, 1}, {80, 30, 40, 4}, {1, wc}, {}});
  };
  const auto yield = [](double p) {
    return (490.0 + 383.0 * std::pow(p, 0.45) + 80.0 * (1.0 - std::exp(-30.0 * p)) +
            40.0 * (1.0 - std::exp(-4.0 * p))) *
           std::pow(1.0 + 100.0 / 5e-4, 0.0114);
  };
  expect_law("laws", "MAT_107 at 100/s", material(0.0), 0.1, 100.0, yield, 0.005);
  // Without hardening and rate the work of Cockcroft and Latham is A times the plastic strain.
  expect_erosion("MAT_107 with WC 15 at 300 MPa",
                 mat("107", {{1, 7.85e-9, E, 0.3}, {1, 0, 0, 0, 0, 1}, {300}, {}, {1, 15.0}, {}}),
                 15.0 + 0.5 * 300.0 * 300.0 / E);
}

// Lemaitre's damage in tension, dD/dp = s^2 / 2 E S: 4.286 with S 0.05. At DC 0.2 the element goes. Sabotage: EPSD, or
// the share of the mean stress, left out.
TEST(Laws, DamageByEnergy) {
  const double growth = 300.0 * 300.0 / (2.0 * E * 0.05);
  const auto material = [](double critical) {
    return mat("105", {{1, 7.85e-9, E, 0.3, 300.0, 0}, {0}, {0.02, 0.05, critical}, {}, {}});
  };
  const double ep = 0.06 - 300.0 / E;
  expect_stress("MAT_105 EPSD 0.02 S 0.05", Pulled(material(0.9), 0.06, 100.0), 0.06,
                300.0 * (1.0 - growth * (ep - 0.02)), 0.005, "laws");
  const double last = 0.02 + 0.1 / growth;  // plastic strain at DC 0.1
  expect_erosion("MAT_105 with DC 0.1 at 300 MPa", material(0.1),
                 300.0 * (last - 0.5 * 0.1 * (last - 0.02)) + 0.5 * 300.0 * 300.0 / E);
}

// Sabotage: a deleted element's energy left out of the eroded energy; MXEPS compared with the plastic strain.
TEST(Laws, FailureErodes) {
  const double elastic = 0.5 * 300.0 * 300.0 / E;
  expect_erosion("MAT_098 PSFAIL 0.05 at 300 MPa", mat("098", {{1, 7.85e-9, E, 0.3}, {300.0, 0, 0, 0, 0.05}}),
                 300.0 * 0.05 + elastic);
  expect_erosion("MAT_123 EPSMAJ 0.05 at 300 MPa",
                 mat("123", {{1, 7.85e-9, E, 0.3, 300.0}, {0, 0, 0, 0, 0, 0, 0.05, 1}, {}, {}}),
                 300.0 * 0.05 - elastic);
  expect_erosion("MAT_024 with ADD_EROSION MXEPS 0.05 at 300 MPa",
                 mat("024", {{1, 7.85e-9, E, 0.3, 300.0}, {}, {}, {}}) + mat("ADD_EROSION", {{1}, {0, 0, 0, 0.05}}),
                 300.0 * 0.05 - elastic);
  expect_erosion(
      "MAT_003 with ADD_EROSION FAILTM at 300 MPa",
      mat("003", {{1, 7.85e-9, E, 0.3, 300.0, 0, 1.0}, {}}) +
          mat("ADD_EROSION", {{1}, {0, 0, 0, 0, 0, 0, 0, (std::exp(0.05) - 1.0) / (100.0 * std::exp(0.06))}}),
      300.0 * 0.05 - elastic);
}

/// Stress of a bar of Mooney and Rivlin's energy, lateral stretch by halving an interval.
double mooney_rivlin_stress(double a, double b, double nu, double stretch) {
  const double c = 0.5 * a + b, d = (a * (5 * nu - 2) + b * (11 * nu - 5)) / (2 * (1 - 2 * nu));
  const auto along = [&](double x, double y, double z) {  // sigma_x
    const double first = x * x + y * y + z * z, third = x * x * y * y * z * z;
    const double of_third = -2 * c / (third * third * third) + 2 * d * (third - 1);
    return 2 / (x * y * z) * ((a + b * first) * x * x - b * x * x * x * x + third * of_third);
  };
  double low = 0.5, high = 1.5;
  for (int i = 0; i < 100; ++i) {
    const double y = 0.5 * (low + high);
    (along(y, y, stretch) < 0.0 ? low : high) = y;
  }
  return along(stretch, low, low);
}

// Blatz and Ko's bar: the lateral stretch is l^-nu exactly, so sigma = G l^(2 nu - 1) (l^2 - l^(-2 nu)).
// Sabotage: nu 0.49; the stress not divided by J.
TEST(Laws, BlatzKoRubber) {
  const double G = 2.0, nu = 0.463;
  for (const double strain : {0.5, -0.4}) {
    const double l = std::exp(strain);
    expect_stress("MAT_007 G 2", Pulled(mat("007", {{1, 1.2e-9, G}}), strain, std::copysign(20.0, strain)), strain,
                  G * std::pow(l, 2 * nu - 1) * (l * l - std::pow(l, -2 * nu)), 0.01, "laws");
  }
}

// Sabotage: the stress not divided by J; b taken for its square root.
TEST(Laws, RubberAndFoam) {
  for (const double strain : {0.5, -0.4})
    expect_stress("MAT_027 A 0.8 B 0.2 PR 0.49",
                  Pulled(mat("027", {{1, 1.2e-9, 0.49, 0.8, 0.2}}), strain, std::copysign(20.0, strain)), strain,
                  mooney_rivlin_stress(0.8, 0.2, 0.49, std::exp(strain)), 0.01, "laws");
  // Ogden's one term with alpha 2 and nearly no change of volume: sigma = mu (l^2 - 1 / l).
  const double l = std::exp(0.5);
  expect_stress("MAT_077_O MU 1 ALPHA 2 PR 0.495", Pulled(mat("077_O", {{1, 1.2e-9, 0.495}, {1.0}, {2.0}}), 0.5, 20.0),
                0.5, l * l - 1 / l, 0.02, "laws");
  // Mooney's two constants at nearly no change of volume: sigma = 2 (l^2 - 1/l) (C10 + C01 / l).
  expect_stress("MAT_077_H C10 0.3 C01 0.2 PR 0.495", Pulled(mat("077_H", {{1, 1.2e-9, 0.495}, {0.3, 0.2}}), 0.5, 20.0),
                0.5, 2.0 * (l * l - 1 / l) * (0.3 + 0.2 / l), 0.02, "laws");
  // A test of a specimen of 20 x 5 x 2 mm in straight pieces: its true stress comes back, in tension and compression.
  const std::string test =
      curve(10, {{-12.0, -80.0}, {-6.0, -12.0}, {0.0, 0.0}, {4.0, 5.0}, {12.0, 8.0}, {30.0, 35.0}});
  for (const auto& [strain, force] : {std::pair{0.4, 5.0 + 3.0 * (20.0 * std::expm1(0.4) - 4.0) / 8.0},
                                      std::pair{-0.4, -12.0 - 68.0 * (-20.0 * std::expm1(-0.4) - 6.0) / 6.0}})
    expect_stress(
        "MAT_181 by a test of straight pieces",
        Pulled(mat("181", {{1, 1.2e-9, 200.0}, {20.0, 5.0, 2.0, 10}}) + test, strain, std::copysign(20.0, strain)),
        strain, std::exp(strain) * force / 10.0, 0.01, "laws");
  // On its way back from 1.6 to 1.2 of the length, by HU and SHAPE. Area under the curve of nominal stress: 0.31 at
  // 0.6, 0.05 at 0.2.
  expect_stress("MAT_181 HU 0.3 SHAPE 0.5, on its way back",
                Pulled(mat("181", {{1, 1.2e-9, 200.0}, {20.0, 5.0, 2.0, 10}, {0, 0.3, 0.5}}) + test, std::log(1.6),
                       20.0, Of::all, std::log(1.2)),
                std::log(1.2), 1.2 * 0.5 * (0.3 + 0.7 * std::sqrt(0.05 / 0.31)), 0.01, "laws");
  // The same tests of a foam with Poisson's ratio 0.3, whose section at the stretch l is l^-0.6 of the first; over the
  // rate, half way between 1 and 3 times the forces; on its way back by a curve.
  for (const auto& [strain, force] : {std::pair{0.4, 5.0 + 3.0 * (20.0 * std::expm1(0.4) - 4.0) / 8.0},
                                      std::pair{-0.4, -12.0 - 68.0 * (-20.0 * std::expm1(-0.4) - 6.0) / 6.0}})
    expect_stress("MAT_181 PR/BETA 0.3, by a test of straight pieces",
                  Pulled(mat("181", {{1, 1.2e-9, 200.0}, {20.0, 5.0, 2.0, 10, 0, 0, 0, 0.3}}) + test, strain,
                         std::copysign(20.0, strain)),
                  strain, std::exp(0.6 * strain) * force / 10.0, 0.01, "laws");
  const std::string fast =
      curve(11, {{-12.0, -240.0}, {-6.0, -36.0}, {0.0, 0.0}, {4.0, 15.0}, {12.0, 24.0}, {30.0, 105.0}}) +
      "*DEFINE_TABLE_2D\n" + fields({12}) + fmt::format("{:20g}{:20d}\n{:20g}{:20d}\n", 0.0, 10, 40.0, 11);
  expect_stress("MAT_181 by a table, 20/s between 0 and 40",
                Pulled(mat("181", {{1, 1.2e-9, 200.0}, {20.0, 5.0, 2.0, 12}}) + test + fast, 0.4, 20.0), 0.4,
                std::exp(0.4) * 2.0 * (5.0 + 3.0 * (20.0 * std::expm1(0.4) - 4.0) / 8.0) / 10.0, 0.01, "laws");
  const std::string back =
      curve(13, {{-12.0, -80.0}, {-6.0, -6.0}, {0.0, 0.0}, {4.0, 2.0}, {12.0, 8.0 / 3.0}, {30.0, 35.0}});
  expect_stress("MAT_181 LCUNLD, on its way back from the end of the test",
                Pulled(mat("181", {{1, 1.2e-9, 200.0}, {20.0, 5.0, 2.0, 10}, {13}}) + test + back, std::log(2.5), 20.0,
                       Of::all, std::log(1.2)),
                std::log(1.2), 1.2 * 0.2, 0.01, "laws");
  const std::string foam_curve = curve(7, {{0.0, 0.0}, {0.05, 0.1}, {0.5, 0.15}, {0.9, 0.95}});
  expect_stress("MAT_057",
                Pulled(mat("057", {{1, 5e-11, 2.0, 7}, {1.0, 0, 1.0}}) + foam_curve, std::log(0.4), -20.0, Of::bricks),
                std::log(0.4), -0.35, 0.01, "laws");
  // Half way between the rates 0 and 40 over the length at first.
  const std::string table = curve(8, {{0.0, 0.0}, {0.05, 0.3}, {0.5, 0.35}, {0.9, 1.55}}) + "*DEFINE_TABLE_2D\n" +
                            fields({9}) + fmt::format("{:20g}{:20d}\n{:20g}{:20d}\n", 0.0, 7, 40.0, 8);
  Pulled by_rate(mat("083", {{1, 5e-11, 2.0, 0, 0, 0, 0, 9}, {0, 1.0}, {}, {}, {}}) + foam_curve + table, std::log(0.4),
                 -50.0, Of::bricks);  // 50 of the last length are 20 of the first
  expect_stress("MAT_083 SFLAG 1, 20/s between 0 and 40", by_rate, std::log(0.4), -0.5 * (0.35 + 0.65), 0.01, "laws");
  expect_stress("MAT_063",
                Pulled(mat("063", {{1, 5e-11, 2.0, 0, 7, 0.05}}) + foam_curve, std::log(0.4), -20.0, Of::bricks),
                std::log(0.4), -0.35, 0.01, "laws");
}

// Plastics: a curve over the total strain comes back as it is; one curve in tension, another in compression.
// Sabotage: strains of MAT_089 taken as plastic ones; the curves of MAT_124 exchanged.
TEST(Laws, Plastics) {
  const std::string total = curve(7, {{0.0, 0.0}, {0.01, 20.0}, {0.065, 30.0}, {0.5, 60.0}});
  for (const double strain : {0.3, -0.3})
    expect_stress(
        "MAT_089, curve of the total strain",
        Pulled(mat("089", {{1, 1.1e-9, 2000.0, 0.4}, {0, 0, 7}, {}}) + total, strain, std::copysign(20.0, strain)),
        strain, std::copysign(30.0 + 30.0 * (0.3 - 0.065) / 0.435, strain), 0.01, "laws");
  const std::string pressed = curve(7, {{0.0, 60.0}, {0.5, 110.0}}), pulled = curve(8, {{0.0, 40.0}, {0.5, 50.0}});
  for (const auto& [strain, expected] : {std::pair{0.3, (40.0 + 20.0 * 0.3) / (1.0 + 20.0 / 2000.0)},
                                         std::pair{-0.3, -(60.0 + 100.0 * 0.3) / (1.0 + 100.0 / 2000.0)}})
    expect_stress(
        "MAT_124, tension weaker than compression",
        Pulled(mat("124", {{1, 1.1e-9, 2000.0, 0.4}, {7, 8}}) + pressed + pulled, strain, std::copysign(20.0, strain)),
        strain, expected, 0.01, "laws");
  // At 20/s half way between 0 and 40: 1.25 times 40 in tension, 1.5 times 60 in compression.
  const std::string flat = curve(7, {{0.0, 60.0}, {1.0, 60.0}}) + curve(8, {{0.0, 40.0}, {1.0, 40.0}}) +
                           curve(9, {{0.0, 1.0}, {40.0, 2.0}}) + curve(10, {{0.0, 1.0}, {40.0, 1.5}});
  for (const auto& [strain, expected] : {std::pair{0.3, 40.0 * 1.25}, std::pair{-0.3, -60.0 * 1.5}})
    expect_stress(
        "MAT_124 LCSRC, LCSRT, 20/s",
        Pulled(mat("124", {{1, 1.1e-9, 2000.0, 0.4}, {7, 8, 9, 10}}) + flat, strain, std::copysign(20.0, strain)),
        strain, expected, 0.01, "laws");
}

// A Prony series pulled at a constant rate d: with a stiff volume the bar has s = 3 d sum of G_i (1 - exp(-b_i t)) /
// b_i. Sabotage: G for 3 G; decays left out.
TEST(Laws, PronySeries) {
  const double strain = 0.1, t = strain / 20.0;
  const double series = 1.0 * t + 5.0 * -std::expm1(-300.0 * t) / 300.0 + 2.0 * -std::expm1(-50.0 * t) / 50.0;
  // The velocity of the end is constant: the rate is 20 at the end and exp(0.1) times that at the start.
  const double speed = 20.0 * std::exp(strain), end = (std::exp(strain) - 1.0) / speed;
  double stress = 0.0;
  constexpr int parts = 20000;
  for (int i = 0; i < parts; ++i) {
    const double u = (i + 0.5) * end / parts, rate = speed / (1.0 + speed * u), ago = end - u;
    stress += 3.0 * rate * (1.0 + 5.0 * std::exp(-300.0 * ago) + 2.0 * std::exp(-50.0 * ago)) * end / parts;
  }
  EXPECT_NEAR(stress, 60.0 * series, 0.05 * stress);
  expect_stress("MAT_076, three terms",
                Pulled(mat("076", {{1, 1.1e-9, 2000.0}, {}, {1.0, 0.0}, {5.0, 300.0}, {2.0, 50.0}}), strain, 20.0),
                strain, stress, 0.01, "laws");
}

// In a plain pull damage by direction is that of the plastic strain. Sabotage: the square of what is left.
TEST(Laws, DamageByDirection) {
  const double onset = 0.03, rupture = 0.13, strain = 0.08;
  const auto yield = [](double ep) { return 300.0 + 500.0 * std::pow(ep, 0.3); };
  const double sound = flow_stress(yield, strain), w = (strain - sound / E - onset) / (rupture - onset);
  expect_stress("MAT_099 PSFAIL 0.03, EPPFR 0.13",
                Pulled(mat("099", {{1, 7.85e-9, E, 0.3, 0.0, rupture}, {300.0, 500.0, 0.3, 0.0, onset}}), strain, 100.0,
                       Of::shells),
                strain, (1.0 - w) * sound, 0.01, "laws");
  const double flat = (strain - 250.0 / E - onset) / (rupture - onset);
  expect_stress("MAT_082 EPPF 0.03, EPPFR 0.13",
                Pulled(mat("082", {{1, 7.85e-9, E, 0.3, 250.0, 0.0, onset}, {0, 0, 0, 0, rupture}, {}, {}}), strain,
                       100.0, Of::shells),
                strain, (1.0 - flat) * 250.0, 0.01, "laws");
}

}  // namespace
}  // namespace nugget::verify
