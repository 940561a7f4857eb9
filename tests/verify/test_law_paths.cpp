// SPDX-License-Identifier: Apache-2.0
// Material laws driven through whole paths of deformation: tension, compression, shear, a cycle, two rates. Every node
// of a shell of ELFORM 2, one of ELFORM 16, a brick of ELFORM 1 and one of ELFORM 2 is moved as a homogeneous
// deformation says; the stress is compared with an integration of the law that is written here, in tensors, on its own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

using Tensor = Eigen::Matrix3d;

constexpr double E = 210000.0, nu = 0.3, G = E / 2.6, K = E / 1.2;

/// A logarithmic strain along fixed axes: `tensor` times what a polygon over the share of the time says.
struct Path {
  std::string name;
  std::vector<std::pair<double, double>> amount;
  Tensor in_bricks, in_shells;

  double at(double share) const {
    std::size_t i = 1;
    while (i + 1 < amount.size() && share > amount[i].first) ++i;
    const auto& [x0, y0] = amount[i - 1];
    const auto& [x1, y1] = amount[i];
    return y0 + (y1 - y0) * (share - x0) / (x1 - x0);
  }
};

Tensor diagonal(double x, double y, double z) {
  return Eigen::Vector3d(x, y, z).asDiagonal();
}
Tensor shear() {
  Tensor t = Tensor::Zero();
  t(0, 1) = t(1, 0) = 1.0;
  return t;
}

/// Tension and compression, shear, two pulls at right angles, and last a cycle of tension and shear; bricks without
/// change of volume.
std::vector<Path> paths(double size) {
  const Tensor pull = diagonal(1, -0.5, -0.5), sheet = diagonal(1, -0.5, 0),
               both = diagonal(0.7, -0.5, -0.2) + 0.4 * shear(), both_in_sheet = diagonal(0.7, -0.3, 0) + 0.4 * shear();
  return {{"tension", {{0, 0}, {1, size}}, pull, sheet},
          {"compression", {{0, 0}, {1, -size}}, pull, sheet},
          {"shear", {{0, 0}, {1, size}}, shear(), shear()},
          {"two pulls", {{0, 0}, {1, size}}, diagonal(0.6, 0.4, -1), diagonal(0.8, 0.7, 0)},
          {"cycle", {{0, 0}, {0.3, 0.6 * size}, {0.7, -0.5 * size}, {1, 0.4 * size}}, both, both_in_sheet}};
}

Tensor exponential(const Tensor& e) {
  const Eigen::SelfAdjointEigenSolver<Tensor> axes(e);
  return axes.eigenvectors() * axes.eigenvalues().array().exp().matrix().asDiagonal() * axes.eigenvectors().transpose();
}

/// What the four elements have; `first` to `last`: parts 1 and 2 are shells, 3 and 4 bricks.
struct Elements {
  int first = 1, last = 4;
};
constexpr Elements all{}, only_shells{1, 2}, only_bricks{3, 4};

Tensor tensor(const std::array<double, 6>& s) {
  Tensor t;
  t << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  return t;
}

/// Stress of an element at a share of the time, by part.
using Reference = std::function<Tensor(int part, double share)>;

/// Runs the path in `end` and compares: mean over the time of the largest component's deviation, as a share of the
/// largest stress of the path, the worst of the elements.
void expect_path(const std::string& what, const std::string& material, const Path& path, double end,
                 const Reference& reference, double gate, Elements of = all) {
  constexpr int samples = 120;
  Specimen s;
  s.text(material);
  s.text("*SECTION_SHELL\n" + fields({1, 2, 1.0, 3}) + fields({1, 1, 1, 1}) + fields({2, 16, 1.0, 3}) +
         fields({1, 1, 1, 1}));
  s.card("SECTION_SOLID", {3, 1}).card("SECTION_SOLID", {4, 2});
  s.card("CONTROL_TERMINATION", {end}).card("CONTROL_SHELL", {0, 0, 0, 1});
  int curves = 100;
  for (int p = of.first; p <= of.last; ++p) {
    s.part(p, p, 1);
    const bool is_shell = p <= 2;
    const Vec3d corner{0.0, 10.0 * p, 0.0};
    const Grid grid = is_shell ? s.shells(p, corner, {1, 1, 0}, 1, 1) : s.bricks(p, corner, {1, 1, 1}, {1, 1, 1});
    for (int k = 0; k <= grid.cells[2]; ++k)
      for (int j = 0; j <= 1; ++j)
        for (int i = 0; i <= 1; ++i)
          for (int c = 0; c < 3; ++c) {
            std::string text = "*DEFINE_CURVE\n" + fields({double(++curves)});
            for (int n = 0; n <= samples + 1; ++n) {  // one more, so that the end is inside
              const double share = double(std::min(n, samples)) / samples;
              const Tensor strain = path.at(share) * (is_shell ? path.in_shells : path.in_bricks);
              const Eigen::Vector3d x(i, j, k), u = exponential(strain) * x - x;
              text += fmt::format("{:20.12e}{:20.12e}\n", end * n / samples, u[c]);
            }
            s.text(text).card("BOUNDARY_PRESCRIBED_MOTION_NODE",
                              {double(grid(i, j, k)), c + 1.0, 2, double(curves), 1});
          }
  }
  Experiment experiment(s.deck());
  std::map<int, double> sum;
  double largest = 0.0, time = 0.0, ratio = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const double share = std::min(now.state.time / end, 1.0), dt = now.state.time - time;
    time = now.state.time;
    for (int p = of.first; p <= of.last; ++p) {
      const auto point = p <= 2 ? shell_layer(experiment, now, p, 1) : brick_layer(experiment, now, p - 2);
      const Tensor expected = reference(p, share);
      sum[p] += dt / end * (tensor(point.stress) - expected).cwiseAbs().maxCoeff();
      largest = std::max(largest, expected.cwiseAbs().maxCoeff());
    }
    ratio = now.energy.ratio();
  });
  double worst = 0.0;
  for (const auto& [p, deviation] : sum) worst = std::max(worst, deviation);
  expect_reference("law paths",
                   fmt::format("{}, {}: mean deviation of the stress, of {:.4g} MPa", what, path.name, largest), worst,
                   0.0, gate, largest);
  EXPECT_NEAR(ratio, 1.0, 1e-3) << what << ", " << path.name;
}

// ---- metals

double effective(const Tensor& s) {
  const Tensor d = s - s.trace() / 3.0 * Tensor::Identity();
  return std::sqrt(1.5 * d.squaredNorm());
}

/// A metal by its yield stress over plastic strain, plastic rate and temperature rise.
struct Metal {
  std::function<double(double ep, double rate, double heat)> yield;
  double kinematic = 0.0;             ///< plastic modulus of the back stress
  double heating = 0.0;               ///< temperature rise of a unit of plastic work
  double onset = 0.0, rupture = 0.0;  ///< damage over the plastic strain; 0: none
  bool directional = false;           ///< by the plastic strain along the axes of the first crack
};

struct MetalPoint {
  Tensor stress = Tensor::Zero(), back = Tensor::Zero(), plastic = Tensor::Zero(), crack = Tensor::Zero();
  double ep = 0.0, heat = 0.0;
  std::array<double, 2> damage{};

  /// Adds a strain increment; radial return, the increment of plastic strain by halving.
  void add(const Metal& m, const Tensor& de, double dt) {
    stress += 2.0 * G * de + (K - 2.0 / 3.0 * G) * de.trace() * Tensor::Identity();
    const Tensor relative = stress - stress.trace() / 3.0 * Tensor::Identity() - back;
    const double trial = effective(relative);
    const auto excess = [&](double dp) {
      return trial - (3.0 * G + m.kinematic) * dp - m.yield(ep + dp, dp / dt, heat);
    };
    if (!(trial > 0.0) || excess(1e-16) <= 0.0) return;
    double low = 1e-16, high = trial / (3.0 * G);
    for (int i = 0; i < 60; ++i) {
      const double dp = 0.5 * (low + high);
      (excess(dp) > 0.0 ? low : high) = dp;
    }
    const Tensor direction = 1.5 / trial * relative;
    stress -= 2.0 * G * low * direction;
    back += 2.0 / 3.0 * m.kinematic * low * direction;
    plastic += low * direction;
    ep += low;
    heat += m.heating * effective(stress) * low;
  }
  /// The same with a strain across the plane that leaves no stress there.
  void add_in_plane(const Metal& m, Tensor de, double dt) {
    const auto across = [&](double zz) {
      MetalPoint p = *this;
      de(2, 2) = zz;
      p.add(m, de, dt);
      return p.stress(2, 2);
    };
    const double reach = 4.0 * de.cwiseAbs().maxCoeff() + 1e-14;
    double low = -reach, high = reach;
    for (int i = 0; i < 45; ++i) {
      const double zz = 0.5 * (low + high);
      (across(zz) < 0.0 ? low : high) = zz;
    }
    de(2, 2) = low;
    add(m, de, dt);
  }
  /// What is left of the stress.
  Tensor damaged(const Metal& m) {
    if (!(m.rupture > 0.0)) return stress;
    const auto lost = [&](double strain) { return std::clamp((strain - m.onset) / (m.rupture - m.onset), 0.0, 1.0); };
    if (!m.directional) return (1.0 - lost(ep)) * stress;
    if (crack.isZero()) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(plastic.topLeftCorner<2, 2>());
      if (axes.eigenvalues()[1] < m.onset) return stress;
      crack(2, 2) = 1.0;
      crack.topLeftCorner<2, 2>() = axes.eigenvectors();
    }
    Eigen::Vector3d left(1, 1, 1);
    for (int i = 0; i < 2; ++i) {
      double& w = damage[i];
      w = std::max(w, lost(crack.col(i).dot(plastic * crack.col(i))));
      left[i] = std::sqrt(1.0 - w);
    }
    const Tensor M = crack * left.asDiagonal() * crack.transpose();
    return M * stress * M;
  }
};

/// The metal along a path, at 1000 moments.
class MetalHistory {
 public:
  MetalHistory(const Metal& metal, const Path& path, double end, bool in_plane) {
    MetalPoint p;
    const Tensor& unit = in_plane ? path.in_shells : path.in_bricks;
    stress_.push_back(Tensor::Zero());
    for (int n = 0; n < steps; ++n) {
      const Tensor de = (path.at((n + 1.0) / steps) - path.at(double(n) / steps)) * unit;
      in_plane ? p.add_in_plane(metal, de, end / steps) : p.add(metal, de, end / steps);
      stress_.push_back(p.damaged(metal));
    }
  }
  Tensor at(double share) const {
    const auto i = static_cast<std::size_t>(std::min(share * steps, steps - 1.0));
    const double w = share * steps - static_cast<double>(i);
    return (1.0 - w) * stress_[i] + w * stress_[i + 1];
  }

 private:
  static constexpr int steps = 1000;
  std::vector<Tensor> stress_;
};

void expect_metal(const std::string& what, const std::string& material, const Metal& metal, const Path& path,
                  double end, Elements of = all) {
  const MetalHistory in_shells(metal, path, end, true), in_bricks(metal, path, end, false);
  expect_path(
      what, material, path, end, [&](int part, double share) { return (part <= 2 ? in_shells : in_bricks).at(share); },
      0.003, of);
}

std::string mat(const std::string& name, std::initializer_list<std::initializer_list<double>> cards) {
  std::string text = "*MAT_" + name + "\n";
  for (const auto& card : cards) text += fields(card);
  return text;
}

struct Law {
  std::string name, material;
  Metal metal;
  bool by_rate = false;
  Elements of = all;
};

double symonds(double rate) {
  return 1.0 + std::pow(rate / 40.0, 0.2);
}
double logarithm(double rate) {
  return 1.0 + 0.02 * std::log(std::max(rate, 1.0));
}
double hardened(double ep) {
  return 300.0 + 500.0 * std::pow(ep, 0.3);
}
double piecewise(double ep) {
  return ep < 0.05 ? 300.0 + 1600.0 * ep : 380.0 + 70.0 / 0.15 * (ep - 0.05);
}

std::vector<Law> metals() {
  const double H = E * 2000.0 / (E - 2000.0), rho = 7.85e-9, e0 = std::pow(E / 600.0, 1.0 / (0.2 - 1.0));
  const std::string points = curve(5, {{0.0, 300.0}, {0.05, 380.0}, {0.2, 450.0}}),
                    rates = curve(7, {{0.0, 280.0}, {400.0, 360.0}});
  const auto cold = [](double, double, double) { return 1e9; };
  const auto curve_stress = [](double ep, double, double) { return piecewise(ep); };
  const auto bilinear = [](double ep, double, double) { return 300.0 + E * 1000.0 / (E - 1000.0) * ep; };
  return {{"MAT_001", mat("001", {{1, rho, E, nu}}), {cold}},
          {"MAT_003, BETA 0",
           mat("003", {{1, rho, E, nu, 300, 2000, 0}, {}}),
           {[](double, double, double) { return 300.0; }, H}},
          {"MAT_003, BETA 0.5, SRC 40, SRP 5",
           mat("003", {{1, rho, E, nu, 300, 2000, 0.5}, {40, 5}}),
           {[H](double ep, double rate, double) { return (300.0 + 0.5 * H * ep) * symonds(rate); }, 0.5 * H},
           true},
          {"MAT_012", mat("012", {{1, rho, G, 300, 1000, K}}), {[](double ep, double, double) {
             return 300.0 + 1000.0 * ep;
           }}},
          {"MAT_015, heated",
           mat("015", {{1, rho, 0, E, nu}, {300, 500, 0.3, 0.02, 1, 1800, 300, 1}, {4.5e8}, {}}),
           {[](double ep, double rate, double heat) { return hardened(ep) * logarithm(rate) * (1.0 - heat / 1500.0); },
            0.0, 1.0 / (rho * 4.5e8)},
           true,
           only_shells},
          {"MAT_018", mat("018", {{1, rho, E, nu, 600, 0.2}, {}}), {[e0](double ep, double, double) {
             return 600.0 * std::pow(e0 + ep, 0.2);
           }}},
          {"MAT_019",
           mat("019", {{1, rho, E, nu}, {7, 1000}}) + rates,
           {[](double ep, double rate, double) { return 280.0 + 0.2 * std::min(rate, 400.0) + 1000.0 * ep; }},
           true},
          {"MAT_024 by a curve", mat("024", {{1, rho, E, nu}, {0, 0, 5}, {}, {}}) + points, {curve_stress}},
          {"MAT_081",
           mat("081", {{1, rho, E, nu, 300, 1000, 0.02}, {0, 0, 0, 0, 0.3}, {}, {}}),
           {bilinear, 0.0, 0.0, 0.02, 0.3}},
          {"MAT_082",
           mat("082", {{1, rho, E, nu, 300, 1000, 0.01}, {0, 0, 0, 0, 0.2}, {}, {}}),
           {bilinear, 0.0, 0.0, 0.01, 0.2, true},
           false,
           only_shells},
          {"MAT_098",
           mat("098", {{1, rho, E, nu}, {300, 500, 0.3, 0.02}}),
           {[](double ep, double rate, double) { return hardened(ep) * logarithm(rate); }},
           true},
          {"MAT_099",
           mat("099", {{1, rho, E, nu, 0, 0.2}, {300, 500, 0.3, 0.02, 0.01}}),
           {[](double ep, double rate, double) { return hardened(ep) * logarithm(rate); }, 0.0, 0.0, 0.01, 0.2, true},
           true,
           only_shells},
          {"MAT_123", mat("123", {{1, rho, E, nu}, {0, 0, 5}, {}, {}}) + points, {curve_stress}},
          {"MAT_003 with ADD_EROSION that is not met",
           mat("003", {{1, rho, E, nu, 300, 2000, 0}, {}}) + mat("ADD_EROSION", {{1}, {0, 0, 0, 5.0}}),
           {[](double, double, double) { return 300.0; }, H}}};
}

// Sabotage: the damage across the crack left out; half of the rate.
TEST(LawPaths, MetalsInTensionCompressionShearAndACycle) {
  for (const Law& law : metals())
    for (const Path& path : paths(0.1)) expect_metal(law.name, law.material, law.metal, path, 2e-4, law.of);
}

// Sabotage: half of the rate.
TEST(LawPaths, MetalsAtTenTimesTheTime) {
  for (const Law& law : metals())
    if (law.by_rate) expect_metal(law.name + ", slowly", law.material, law.metal, paths(0.1).back(), 2e-3, law.of);
}

// ---- rubber, foam, viscoelasticity

/// Cauchy stress by the principal stretches of the path: `nominal` forces (per first area) of stretches along the axes.
Tensor by_stretches(const Tensor& strain, const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& nominal) {
  const Eigen::SelfAdjointEigenSolver<Tensor> axes(strain);
  const Eigen::Vector3d l = axes.eigenvalues().array().exp(), n = nominal(l), s = n.cwiseProduct(l) / l.prod();
  return axes.eigenvectors() * s.asDiagonal() * axes.eigenvectors().transpose();
}

/// Nominal stresses as the slopes of an energy, by differences.
std::function<Eigen::Vector3d(const Eigen::Vector3d&)> slopes(const std::function<double(const Eigen::Vector3d&)>& W) {
  return [W](const Eigen::Vector3d& l) {
    Eigen::Vector3d n;
    for (int i = 0; i < 3; ++i) {
      Eigen::Vector3d up = l, down = l;
      up[i] += 1e-5;
      down[i] -= 1e-5;
      n[i] = (W(up) - W(down)) / 2e-5;
    }
    return n;
  };
}

struct Invariants {
  double first, second, third;  ///< third: J
  explicit Invariants(const Eigen::Vector3d& l) {
    const Eigen::Vector3d q = l.cwiseProduct(l);
    first = q.sum();
    second = q[0] * q[1] + q[1] * q[2] + q[2] * q[0];
    third = l.prod();
  }
};

void expect_elastic(const std::string& what, const std::string& material,
                    const std::function<double(const Eigen::Vector3d&)>& W) {
  for (Path path : paths(0.7)) {
    path.in_bricks += 0.02 * Tensor::Identity();  // some change of volume
    expect_path(
        what, material, path, 2e-2,
        [&](int, double share) { return by_stretches(path.at(share) * path.in_bricks, slopes(W)); }, 1e-3, only_bricks);
  }
}

// Sabotage: J1 taken for I in the energy of 077_H; half of C in the volume's energy of 027.
TEST(LawPaths, Rubbers) {
  const double A = 0.8, B = 0.2, n = 0.45, C = 0.5 * A + B,
               D = (A * (5 * n - 2) + B * (11 * n - 5)) / (2 * (1 - 2 * n));
  expect_elastic("MAT_027", mat("027", {{1, 1.2e-9, n, A, B}}), [=](const Eigen::Vector3d& l) {
    const Invariants i(l);
    const double III = i.third * i.third;
    return A * (i.first - 3) + B * (i.second - 3) + C * (1 / (III * III) - 1) + D * (III - 1) * (III - 1);
  });
  const double k = 2.0 * 2.0 * (0.3 + 0.1) * (1 + n) / (3 * (1 - 2 * n));
  expect_elastic(
      "MAT_077_H", mat("077_H", {{1, 1.2e-9, n}, {0.3, 0.1, 0.02, -0.01, 0.01, 0.02}}), [=](const Eigen::Vector3d& l) {
        const Invariants i(l);
        const double x = i.first * std::pow(i.third, -2.0 / 3) - 3, y = i.second * std::pow(i.third, -4.0 / 3) - 3;
        return 0.3 * x + 0.1 * y + 0.02 * x * y - 0.01 * x * x + 0.01 * y * y + 0.02 * x * x * x +
               k * (i.third - 1 - std::log(i.third));
      });
  const std::array<std::pair<double, double>, 3> terms{{{0.63, 1.3}, {0.0012, 5.0}, {-0.01, -2.0}}};
  double shear_modulus = 0.0;
  for (const auto& [mu, alpha] : terms) shear_modulus += 0.5 * mu * alpha;
  const double k_ogden = 2.0 * shear_modulus * (1 + n) / (3 * (1 - 2 * n));
  expect_elastic("MAT_077_O", mat("077_O", {{1, 1.2e-9, n}, {0.63, 0.0012, -0.01}, {1.3, 5.0, -2.0}}),
                 [=](const Eigen::Vector3d& l) {
                   const double J = l.prod();
                   double w = k_ogden * (J - 1 - std::log(J));
                   for (const auto& [mu, alpha] : terms)
                     w += mu / alpha * ((l / std::cbrt(J)).array().pow(alpha).sum() - 3);
                   return w;
                 });
}

double on_curve(double strain) {  // that of the foams below
  if (strain < 0.05) return 2.0 * strain;
  return strain < 0.5 ? 0.1 + 0.05 / 0.45 * (strain - 0.05) : 0.15 + 2.0 * (strain - 0.5);
}
double area(double strain) {
  if (strain < 0.05) return strain * strain;
  if (strain < 0.5) return 0.0025 + 0.5 * (0.1 + on_curve(strain)) * (strain - 0.05);
  return 0.0025 + 0.5 * 0.25 * 0.45 + 0.5 * (0.15 + on_curve(strain)) * (strain - 0.5);
}
const std::string foam_curve = curve(7, {{0.0, 0.0}, {0.05, 0.1}, {0.5, 0.15}, {0.9, 0.95}});

// Pressed to 0.3 of its length, back, and pulled. Sabotage: SHAPE left out of the unloading.
TEST(LawPaths, LowDensityFoam) {
  for (const Path& path :
       {Path{"tension", {{0, 0}, {1, 0.3}}, diagonal(1, 0, 0), {}},
        Path{"compression and back", {{0, 0}, {0.4, -1.2}, {0.8, 0}, {1, -0.6}}, diagonal(1, 0.3, 0), {}},
        Path{"shear", {{0, 0}, {0.6, 0.5}, {1, 0}}, shear(), {}},
        Path{"cycle", {{0, 0}, {0.3, -0.8}, {0.6, 0.2}, {1, -1.0}}, diagonal(1, -0.2, 0), {}}}) {
    // The state needs the most energy so far: a polygon's corners are the only extremes.
    const auto energy = [&](double share) {
      const Eigen::SelfAdjointEigenSolver<Tensor> axes(path.at(share) * path.in_bricks);
      double w = 0.0;
      for (const double e : axes.eigenvalues()) w += e < 0.0 ? area(1.0 - std::exp(e)) : 0.0;
      return w;
    };
    const auto reference = [&](int, double share) {
      double most = energy(share);
      for (const auto& [corner, amount] : path.amount)
        if (corner < share) most = std::max(most, energy(corner));
      const double left = most > 0.0 ? 0.1 + 0.9 * std::pow(energy(share) / most, 3.0) : 1.0;
      return by_stretches(path.at(share) * path.in_bricks, [&](const Eigen::Vector3d& l) {
        Eigen::Vector3d n;
        for (int i = 0; i < 3; ++i)
          n[i] = l[i] < 1.0 ? -left * on_curve(1.0 - l[i]) : std::min(2.0 * (l[i] - 1.0), 0.3);
        return n;
      });
    };
    expect_path("MAT_057", mat("057", {{1, 5e-11, 2.0, 7, 0.3, 0.1}, {3.0}}) + foam_curve, path, 2e-2, reference, 2e-3,
                only_bricks);
  }
}

// Sabotage: the volumetric strain as the logarithm.
TEST(LawPaths, CrushableFoam) {
  const std::string yield = curve(7, {{0.0, 0.05}, {0.5, 0.1}, {0.9, 2.1}});
  const auto at = [](double crushed) {
    return crushed < 0.5 ? 0.05 + 0.1 * std::max(crushed, 0.0) : 0.1 + 5.0 * (crushed - 0.5);
  };
  for (const Path& path :
       {Path{"tension", {{0, 0}, {1, 0.1}}, diagonal(1, 0, 0), {}},
        Path{"compression and back", {{0, 0}, {0.4, -1.2}, {0.7, -1.0}, {1, -1.3}}, diagonal(1, 0, 0), {}},
        Path{"shear", {{0, 0}, {0.6, 0.05}, {1, 0}}, shear(), {}},
        Path{"cycle", {{0, 0}, {0.3, -0.4}, {0.6, 0.0}, {1, -0.9}}, diagonal(1, 0.5, 0), {}}}) {
    constexpr int steps = 4000;
    std::vector<Tensor> stress{Tensor::Zero()};
    for (int n = 0; n < steps; ++n) {
      const double now = path.at((n + 1.0) / steps), before = path.at(double(n) / steps);
      const Eigen::SelfAdjointEigenSolver<Tensor> axes(stress.back() + 5.0 * (now - before) * path.in_bricks);
      const double limit = at(1.0 - std::exp(now * path.in_bricks.trace()));
      const Eigen::Vector3d held = axes.eigenvalues().cwiseMax(-limit).cwiseMin(0.02);
      stress.push_back(axes.eigenvectors() * held.asDiagonal() * axes.eigenvectors().transpose());
    }
    expect_path(
        "MAT_063", mat("063", {{1, 5e-11, 2.0, 0, 7, 0.02}}) + yield, path, 2e-2,
        [&](int, double share) { return stress[std::lround(share * steps)]; }, 5e-3, only_bricks);
  }
}

// ---- honeycomb

/// A honeycomb whose axis a stands at 30 degrees to x, in the plane of x and y.
struct Core {
  double young = 500.0, poisson = 0.25, yield = 12.0, compacted = 0.3;
  std::array<double, 6> modulus{100.0, 40.0, 30.0, 30.0, 20.0, 25.0};
  std::function<double(double)> direct, sheared;  ///< largest stresses aa = bb = cc, ab = bc = ca
  bool own_strains = false;
  double growth = 0.0;  ///< of the largest stresses by a unit of the deviatoric rate's norm

  std::vector<Tensor> stresses(const Path& path, double end, int steps) const {
    Tensor axes = Tensor::Identity(), strain = Tensor::Zero(), stress = Tensor::Zero();
    const double c = std::cos(std::numbers::pi / 6.0), s = 0.5;
    axes << c, -s, 0, s, c, 0, 0, 0, 1;
    std::vector<Tensor> history{stress};
    for (int n = 0; n < steps; ++n) {
      const double step = path.at((n + 1.0) / steps) - path.at(double(n) / steps);
      const Tensor de = axes.transpose() * (step * path.in_bricks) * axes;
      strain += de;
      const double V = std::exp(strain.trace()), shear = young / (2.0 * (1.0 + poisson));
      if (V > compacted) {
        const double beta = std::clamp((1.0 - V) / (1.0 - compacted), 0.0, 1.0);
        const Tensor rate = (de - de.trace() / 3.0 * Tensor::Identity()) / (end / steps);
        const double factor = 1.0 + growth * rate.norm();
        const auto held = [&](int i, int j, int component) {
          const double dense = component < 3 ? young : shear, twice = component < 3 ? 1.0 : 2.0;
          const double m = modulus[component];
          const double at = !own_strains ? 1.0 - V : component < 3 ? -strain(i, j) : 2.0 * std::abs(strain(i, j));
          const double most = factor * (component < 3 ? direct(at) : sheared(at));
          return std::clamp(stress(i, j) + twice * (m + beta * (dense - m)) * de(i, j), -most, most);
        };
        Tensor now;
        now << held(0, 0, 0), held(0, 1, 3), held(2, 0, 5), 0.0, held(1, 1, 1), held(1, 2, 4), 0.0, 0.0, held(2, 2, 2);
        stress = now.selfadjointView<Eigen::Upper>();
      } else {
        const Tensor mean = Tensor::Identity() * (stress.trace() / 3.0 + young / (3.0 - 6.0 * poisson) * de.trace());
        const Tensor d = stress - stress.trace() / 3.0 * Tensor::Identity() +
                         2.0 * shear * (de - de.trace() / 3.0 * Tensor::Identity());
        stress = mean + std::min(1.0, yield / std::max(effective(d), 1e-30)) * d;
      }
      history.push_back(axes * stress * axes.transpose());
    }
    return history;
  }
  /// The material, with the curves 7 and 8, and that of the rate in 9.
  std::string cards(const char* law) const {
    const auto& m = modulus;
    const double c = std::cos(std::numbers::pi / 6.0);
    return mat(law, {{1, 1e-8, young, poisson, yield, compacted, 1e-9},
                     {7, 0, 0, 8, 0, 0, 0, growth > 0.0 ? 9.0 : 0.0},
                     {m[0], m[1], m[2], m[3], m[4], m[5], 2},
                     {0, 0, 0, c, 0.5, 0},
                     {-0.5, c, 0}}) +
           (growth > 0.0 ? curve(9, {{0.0, 1.0}, {2e3, 1.0 + 2e3 * growth}}) : "");
  }
};

std::vector<Path> crushes() {
  const double c2 = 0.75, s2 = 0.25, cs = std::sqrt(3.0) / 4.0;  // of 30 degrees
  Tensor along_a = diagonal(c2, s2, 0), sheared = shear();
  along_a(0, 1) = along_a(1, 0) = cs;
  return {{"tension", {{0, 0}, {1, 0.2}}, along_a, {}},
          {"crushed along a, back, and compacted", {{0, 0}, {0.4, -0.8}, {0.5, -0.76}, {1, -1.4}}, along_a, {}},
          {"crushed askew", {{0, 0}, {0.8, -0.9}, {1, -0.85}}, diagonal(1, 0, 0), {}},
          {"shear", {{0, 0}, {0.6, 0.1}, {1, 0}}, sheared, {}},
          {"cycle", {{0, 0}, {0.3, -0.5}, {0.6, 0.0}, {1, -0.6}}, diagonal(1, 0.3, 0) + 0.2 * shear(), {}}};
}

// Sabotages: beta of the volumetric strain alone; axes not turned back; no compacted branch; the first ordinate of a
// curve over the relative volume last.
TEST(LawPaths, Honeycomb) {
  constexpr int steps = 4000;
  Core core;
  core.direct = [](double x) { return x < 0.5 ? 0.6 + 0.4 * std::max(x, 0.0) : 0.8 + 5.0 * (x - 0.5); };
  core.sheared = [](double x) { return 0.3 + 0.5 * std::max(x, 0.0); };
  // aa over the relative volume, the shears over the volumetric strain.
  const std::string curves = curve(7, {{0.25, 2.05}, {0.5, 0.8}, {1.0, 0.6}}) + curve(8, {{0.0, 0.3}, {0.8, 0.7}});
  for (const double growth : {0.0, 5e-4}) {
    core.growth = growth;
    for (const Path& path : crushes()) {
      constexpr double end = 4e-3;
      const std::vector<Tensor> stress = core.stresses(path, end, steps);
      expect_path(
          growth > 0.0 ? "MAT_026 with LCSR" : "MAT_026", core.cards("026") + curves, path, end,
          [&](int, double share) { return stress[std::lround(share * steps)]; }, 5e-3, only_bricks);
    }
  }
}

// Sabotages: the strain of shears taken as tensorial; tension looked up as compression.
TEST(LawPaths, HoneycombByItsOwnStrains) {
  constexpr int steps = 4000;
  Core core;
  core.own_strains = true;
  core.direct = [](double x) { return x < 0.0 ? 0.6 - 2.0 * std::max(x, -0.2) : x < 0.5 ? 0.6 : 0.6 + x - 0.5; };
  core.sheared = [](double x) { return 0.3 + 0.5 * x; };
  const std::string curves =
      curve(7, {{-0.2, 1.0}, {0.0, 0.6}, {0.5, 0.6}, {1.5, 1.6}}) + curve(8, {{0.0, 0.3}, {0.8, 0.7}});
  for (const Path& path : crushes()) {
    constexpr double end = 4e-3;
    const std::vector<Tensor> stress = core.stresses(path, end, steps);
    expect_path(
        "MAT_126", core.cards("126") + curves, path, end,
        [&](int, double share) { return stress[std::lround(share * steps)]; }, 5e-3, only_bricks);
  }
}

// Sabotage: the rate of the fast curve for all.
TEST(LawPaths, FoamByRate) {
  const std::string material = mat("083", {{1, 5e-11, 2.0, 0, 0, 0, 1e-9, 9}, {}, {}, {}, {}}) + foam_curve +
                               curve(8, {{0.0, 0.0}, {0.05, 0.2}, {0.5, 0.3}, {0.9, 1.9}}) + "*DEFINE_TABLE_2D\n" +
                               fields({9}) + fmt::format("{:20g}{:20d}\n{:20g}{:20d}\n", 0.0, 7, 100.0, 8);
  struct Case {
    Path path;
    double end;
  };
  for (const Case& c :
       {Case{{"tension", {{0, 0}, {1, 0.3}}, diagonal(1, 0, 0), {}}, 1e-2},
        Case{{"compression at 100/s and back", {{0, 0}, {0.6, -1.2}, {1, -0.4}}, diagonal(1, 0, 0), {}}, 2e-2},
        Case{{"compression at 10/s and back", {{0, 0}, {0.6, -1.2}, {1, -0.4}}, diagonal(1, 0, 0), {}}, 2e-1},
        Case{{"shear at 25/s", {{0, 0}, {1, 0.5}}, shear(), {}}, 2e-2}}) {
    const auto reference = [&](int, double share) {
      const double h = 1e-6, rate = std::abs(c.path.at(share) - c.path.at(share - h)) / (h * c.end);
      const bool loads = std::abs(c.path.at(share)) >= std::abs(c.path.at(share - h));
      const double factor = loads ? 1.0 + std::min(rate, 100.0) / 100.0 : 1.0;  // the curves are one, twofold
      return by_stretches(c.path.at(share) * c.path.in_bricks, [&](const Eigen::Vector3d& l) {
        Eigen::Vector3d n;
        for (int i = 0; i < 3; ++i) n[i] = l[i] < 1.0 ? -factor * on_curve(1.0 - l[i]) : 2.0 * (l[i] - 1.0);
        return n;
      });
    };
    expect_path("MAT_083", material, c.path, c.end, reference, 0.01, only_bricks);
  }
}

// Sabotage: G0 relaxes instead of G0 - GI.
TEST(LawPaths, Viscoelasticity) {
  const double bulk = 50.0, first = 20.0, last = 5.0, beta = 300.0;
  for (const double end : {2e-3, 2e-2})
    for (const Path& path : paths(0.3)) {
      constexpr int steps = 4000;
      std::vector<Tensor> stress{Tensor::Zero()};
      Tensor relaxing = Tensor::Zero();
      const Tensor volume = path.in_bricks.trace() * Tensor::Identity(), shape = path.in_bricks - volume / 3.0;
      for (int n = 1; n <= steps; ++n) {
        const double now = path.at(double(n) / steps), change = now - path.at((n - 1.0) / steps), dt = end / steps;
        relaxing = std::exp(-beta * dt) * relaxing + 2.0 * (first - last) * std::exp(-0.5 * beta * dt) * change * shape;
        stress.push_back(relaxing + 2.0 * last * now * shape + bulk * now * volume);
      }
      expect_path(
          fmt::format("MAT_006 in {} s", end), mat("006", {{1, 1.2e-9, bulk, first, last, beta}}), path, end,
          [&](int, double share) { return stress[std::lround(share * steps)]; }, 3e-3, only_bricks);
    }
}

// Kelvin's formulation of MAT_061 as LS-DYNA's manual writes it, ds/dt + s / DC = 2 G0 de/dt + 2 GI e / DC, by the
// midpoint rule. Sabotage: DC as a rate; the retardation time DC G0 / GI for the relaxation time.
TEST(LawPaths, KelvinViscoelasticity) {
  const double bulk = 50.0, first = 20.0, last = 5.0, time = 4e-3;
  for (const double end : {2e-3, 2e-2})
    for (const Path& path : paths(0.3)) {
      constexpr int steps = 8000;
      std::vector<Tensor> stress{Tensor::Zero()};
      Tensor s = Tensor::Zero();
      const Tensor volume = path.in_bricks.trace() * Tensor::Identity(), shape = path.in_bricks - volume / 3.0;
      const double dt = end / steps;
      for (int n = 1; n <= steps; ++n) {
        const double before = path.at((n - 1.0) / steps), now = path.at(double(n) / steps);
        const Tensor force = 2.0 * first * (now - before) * shape + last * (now + before) * dt / time * shape;
        s = ((1.0 - 0.5 * dt / time) * s + force) / (1.0 + 0.5 * dt / time);
        stress.push_back(s + bulk * now * volume);
      }
      expect_path(
          fmt::format("MAT_061, Kelvin, in {} s", end), mat("061", {{1, 1.2e-9, bulk, first, last, time, 1}}), path,
          end, [&](int, double share) { return stress[std::lround(share * steps)]; }, 3e-3, only_bricks);
    }
}

}  // namespace
}  // namespace nugget::verify
