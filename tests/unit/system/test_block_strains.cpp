// SPDX-License-Identifier: Apache-2.0
// Strains that the groups add up for results, against closed forms of homogeneous motions.
#include "system/block_strains.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace nugget::system {
namespace {

using R = NativeBatch;
constexpr int steps = 400;

/// Elements of one block, all of the same shape; lane 1 is not active.
class Block {
 public:
  Block(StrainRule rule, std::vector<Vec3d> corners) : at_(std::move(corners)) {
    strains_.start(std::move(rule), native_width);
  }

  /// Moves each corner from where it is to `to(corner)` of its first place, in even steps of the time 1; `spin`: about
  /// the axes, of every corner by its first place.
  void move(const std::function<Vec3d(const Vec3d&, double)>& place, const std::function<Vec3d(const Vec3d&)>& spin) {
    const double dt = 1.0 / steps;
    const std::vector<Vec3d> first = at_;
    for (int i = 1; i <= steps; ++i) {
      std::vector<Vec3<R>> x, v, w;
      for (std::size_t a = 0; a < at_.size(); ++a) {
        const Vec3d now = place(first[a], i * dt), speed = (1.0 / dt) * (now - at_[a]), turn = spin(first[a]);
        at_[a] = now;
        x.push_back({R(now.x), R(now.y), R(now.z)});
        v.push_back({R(speed.x), R(speed.y), R(speed.z)});
        w.push_back({R(turn.x), R(turn.y), R(turn.z)});
      }
      R active(1.0);
      set_lane(active, 1, 0.0);
      strains_.add(0, x, v, w, active, R(thickness), dt);
    }
  }
  double operator[](std::size_t i) const { return strains_.number(0, i); }
  double of_deleted(std::size_t i) const { return strains_.number(1, i); }

  static constexpr double thickness = 0.2;

 private:
  std::vector<Vec3d> at_;
  BlockStrains<double> strains_;
};

const std::vector<Vec3d> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const std::vector<Vec3d> tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const std::vector<Vec3d> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<Vec3d> triangle{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}};

StrainRule rule(StrainRule::Of of) {
  StrainRule r;
  r.of = of;
  r.lower = -0.5;
  r.upper = 0.5;
  return r;
}
Vec3d no_spin(const Vec3d&) {
  return {};
}
/// Stretched to 1.5 along x, 0.8 along y, 1.2 along z.
Vec3d stretched(const Vec3d& p, double t) {
  return {p.x * (1.0 + 0.5 * t), p.y * (1.0 - 0.2 * t), p.z * (1.0 + 0.2 * t)};
}

TEST(BlockStrains, AStretchAlongFixedAxesGivesLogarithmicStrains) {
  const double log_strain[3] = {std::log(1.5), std::log(0.8), std::log(1.2)};
  for (const auto& corners : {cube, tetrahedron})
    for (const StrainRule::Of of : {StrainRule::Of::solids, StrainRule::Of::thick_shells}) {
      Block b(rule(of), corners);
      b.move(stretched, no_spin);
      for (std::size_t c = 0; c < 6; ++c) {
        EXPECT_NEAR(b[c], c < 3 ? log_strain[c] : 0.0, 1e-6) << c;
        EXPECT_EQ(b.of_deleted(c), 0.0);
        if (of == StrainRule::Of::thick_shells) {
          EXPECT_NEAR(b[6 + c], b[c], 1e-12);
          EXPECT_NEAR(b[12 + c], b[c], 1e-12);
        }
      }
    }
  for (const auto& corners : {square, triangle}) {
    Block b(rule(StrainRule::Of::shells), corners);
    b.move(stretched, no_spin);
    for (const std::size_t face : {0, 5}) {
      // A triangle's x axis is the mean of its sides, a quadrilateral's bisects its diagonals: both along x here, and
      // by symmetry they stay there.
      EXPECT_NEAR(b[face], log_strain[0], 1e-6);
      EXPECT_NEAR(b[face + 1], log_strain[1], 1e-6);
      for (const std::size_t c : {2, 3, 4}) EXPECT_NEAR(b[face + c], 0.0, 1e-12);
      EXPECT_EQ(b.of_deleted(face), 0.0);
    }
  }
}

TEST(BlockStrains, AStrainTurnsWithTheElement) {
  Block b(rule(StrainRule::Of::solids), cube);
  b.move([](const Vec3d& p, double t) { return Vec3d{p.x * (1.0 + 0.1 * t), p.y, p.z}; }, no_spin);
  EXPECT_NEAR(b[0], std::log(1.1), 1e-6);
  // A quarter of a turn about z: what was along x is along y.
  b.move(
      [](const Vec3d& p, double t) {
        const double c = std::cos(0.5 * M_PI * t), s = std::sin(0.5 * M_PI * t);
        return Vec3d{c * p.x - s * p.y, s * p.x + c * p.y, p.z};
      },
      no_spin);
  const double expected[6] = {0.0, std::log(1.1), 0.0, 0.0, 0.0, 0.0};
  for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(b[c], expected[c], 1e-5) << c;
}

TEST(BlockStrains, BendingIsOppositeAtTheFaces) {
  // Spins about y that grow along x: w_y = kappa x, curvature kappa; at z the strain xx is z kappa.
  const double kappa = 0.01, z = 0.5 * 0.5 * Block::thickness;
  for (const auto& corners : {square, triangle}) {
    Block b(rule(StrainRule::Of::shells), corners);
    b.move([](const Vec3d& p, double) { return p; }, [&](const Vec3d& p) { return Vec3d{0.0, kappa * p.x, 0.0}; });
    EXPECT_NEAR(b[5], z * kappa, 1e-9);
    EXPECT_NEAR(b[0], -z * kappa, 1e-9);
  }
  // The same of a thick shell by the motion of its upper and lower nodes: at a quarter of its depth. So small that what
  // goes with its square, by the shear in it, does not count.
  const double small = 1e-4;
  Block b(rule(StrainRule::Of::thick_shells), cube);
  b.move([&](const Vec3d& p, double t) { return Vec3d{p.x * (1.0 + small * t * (p.z - 0.5)), p.y, p.z}; }, no_spin);
  EXPECT_NEAR(b[12], 0.25 * small, 1e-8);
  EXPECT_NEAR(b[6], -0.25 * small, 1e-8);
  EXPECT_NEAR(b[0], 0.0, 1e-8);
}

TEST(BlockStrains, AShellBesideItsNodesIsStrainedByWhereItIs) {
  StrainRule beside = rule(StrainRule::Of::shells);
  beside.offset.assign(native_width, 0.3);
  const double kappa = 0.01;
  Block b(beside, square);
  b.move([](const Vec3d& p, double) { return p; }, [&](const Vec3d& p) { return Vec3d{0.0, kappa * p.x, 0.0}; });
  EXPECT_NEAR(b[5], (0.3 + 0.05) * kappa, 1e-9);
  EXPECT_NEAR(b[0], (0.3 - 0.05) * kappa, 1e-9);
}

}  // namespace
}  // namespace nugget::system
