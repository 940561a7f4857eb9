// SPDX-License-Identifier: Apache-2.0
// Tetrahedra whose nodes share a pressure (ELFORM 13): patch, and what ELFORM 10 locks in.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "linear.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

// Corners of a cube by their bits: 1 along x, 2 along y, 4 along z. Six tetrahedra around the diagonal 0-7.
constexpr std::array<std::array<int, 4>, 6> pieces{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

/// A block of cubes that are each parted into six; its inner nodes are moved out of line by `shift` of a cube.
class Block {
 public:
  Block(Specimen& s, const Vec3d& size, const std::array<int, 3>& n, double shift = 0.0) : n_(n) {
    const Vec3d cell{size.x / n[0], size.y / n[1], size.z / n[2]};
    for (int k = 0; k <= n[2]; ++k)
      for (int j = 0; j <= n[1]; ++j)
        for (int i = 0; i <= n[0]; ++i) {
          const bool inner = i % n[0] != 0 && j % n[1] != 0 && k % n[2] != 0;
          const double out = inner ? shift : 0.0;
          nodes_.push_back(s.node({cell.x * (i + out), cell.y * (j + 0.7 * out), cell.z * (k - 0.5 * out)}));
        }
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i)
          for (const auto& p : pieces) {
            const auto at = [&](int c) { return (*this)(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)); };
            const int last = at(p[3]);
            s.brick(1, {at(p[0]), at(p[1]), at(p[2]), last, last, last, last, last});
            ++elements;
          }
  }
  int operator()(int i, int j, int k) const { return nodes_[i + (n_[0] + 1) * (j + (n_[1] + 1) * k)]; }
  /// Nodes at the beginning (or end) of an axis.
  std::vector<int> plane(int axis, bool end = false) const {
    std::vector<int> chosen;
    for (int k = 0; k <= n_[2]; ++k)
      for (int j = 0; j <= n_[1]; ++j)
        for (int i = 0; i <= n_[0]; ++i)
          if (std::array{i, j, k}[axis] == (end ? n_[axis] : 0)) chosen.push_back((*this)(i, j, k));
    return chosen;
  }
  int elements = 0;  ///< ids from 1 on

 private:
  std::array<int, 3> n_;
  std::vector<int> nodes_;
};

Specimen material(int elform, const std::string& law) {
  Specimen s;
  s.text(law).card("SECTION_SOLID", {1, static_cast<double>(elform)}).part(1, 1, 1);
  return s;
}

void hold(Specimen& s, int set, const std::vector<int>& nodes, bool x, bool y, bool z) {
  s.node_set(set, nodes).card("BOUNDARY_SPC_SET", {double(set), 0, double(x), double(y), double(z)});
}

// A uniform strain in x, driven slowly between smooth walls: every element has the stress of Hooke's law, whatever the
// mesh. Sabotage: the mean of the nodes' pressures weighted by what is left of a node's elements.
TEST(NodalTetrahedra, PatchIsExact) {
  Specimen s = material(13, "*MAT_ELASTIC\n" + fields({1, 1e-9, 1000.0, 0.3}));
  const Block block(s, {30, 20, 20}, {3, 2, 2}, 0.2);
  for (int axis = 0; axis < 3; ++axis) hold(s, 1 + axis, block.plane(axis), axis == 0, axis == 1, axis == 2);
  s.node_set(4, block.plane(0, true)).text(curve(9, {{0, 0}, {0.004, 0.03}, {1, 0.03}}));
  s.card("BOUNDARY_PRESCRIBED_MOTION_SET", {4, 1, 2, 9});
  s.text("*CONTROL_TERMINATION\n0.02\n*DAMPING_GLOBAL\n0,3000.0\n");
  Experiment experiment(s.deck());
  double axial = 0.0, other = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    axial = other = 0.0;
    const double exact = 1000.0 * std::log1p(0.03 / 30.0);
    for (int e = 1; e <= block.elements; ++e) {
      const auto& stress = brick_layer(experiment, now, e).stress;
      axial = std::max(axial, std::abs(stress[0] / exact - 1.0));
      for (std::size_t i = 1; i < 6; ++i) other = std::max(other, std::abs(stress[i] / exact));
    }
  });
  expect_reference("patch", "bar of 72 tetrahedra, ELFORM 13: axial stress, furthest off", axial, 0.0, 1e-4, 1.0);
  expect_reference("patch", "bar of 72 tetrahedra, ELFORM 13: other stresses, of the axial one", other, 0.0, 1e-4, 1.0);
}

// A cantilever of nearly incompressible rubber in plane strain, bent to rest by a shear on its end, over beam theory in
// plane strain: P L^3 / (3 E' I) + P L / (k G A), E' = E / (1 - nu^2).
double tip_deflection(int elform, double nu) {
  const double E = 3.0, L = 40.0, h = 10.0, t = 2.5, P = 0.002;
  Specimen s = material(elform, "*MAT_ELASTIC\n" + fields({1, 1e-9, E, nu}));
  const Block block(s, {L, h, t}, {16, 4, 1});
  std::vector<int> sides = block.plane(2), other = block.plane(2, true);
  sides.insert(sides.end(), other.begin(), other.end());
  hold(s, 1, sides, false, false, true);
  hold(s, 2, block.plane(0), true, true, false);
  const std::vector<int> end = block.plane(0, true);
  s.node_set(3, end).text(curve(9, {{0, 0}, {0.02, 1}, {10, 1}}));
  s.card("LOAD_NODE_SET", {3, 2, 9, P / double(end.size())});
  s.text("*CONTROL_TERMINATION\n0.05\n*DAMPING_GLOBAL\n0,500.0\n");
  Experiment experiment(s.deck());
  double tip = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) { tip = experiment.displacement(now, end.front()).y; });
  const double I = t * h * h * h / 12.0, G = E / (2.0 * (1.0 + nu));
  return tip / (P * L * L * L * (1.0 - nu * nu) / (3.0 * E * I) + P * L / (5.0 / 6.0 * G * h * t));
}

// Four cubes of six tetrahedra over the depth. Sabotage: each element's own pressure.
TEST(NodalTetrahedra, DoNotLockAtConstantVolume) {
  const double shared = tip_deflection(13, 0.49), own = tip_deflection(10, 0.49);
  expect_reference("locking", "rubber cantilever, nu 0.49, ELFORM 13: deflection over beam theory", shared, 1.0, 0.2);
  EXPECT_LT(own, 0.5) << "ELFORM 10 locks";
}

// A node's pressure is not an element's stiffness: linear analyses take that of ELFORM 10, and say so.
TEST(NodalTetrahedra, AreOfFormulationTenInLinearAnalyses) {
  std::vector<double> stiffness[2];
  for (const int elform : {13, 10}) {
    Specimen s = material(elform, "*MAT_ELASTIC\n" + fields({1, 1e-9, 3.0, 0.3}));
    s.card("CONTROL_IMPLICIT_GENERAL", {1, 1})
        .card("CONTROL_IMPLICIT_EIGENVALUE", {5})
        .card("CONTROL_TERMINATION", {1});
    const Block block(s, {10, 10, 10}, {1, 1, 1});
    const LinearExperiment experiment(s.deck());
    const bool reported = std::ranges::any_of(experiment.findings().all(), [](const Finding& finding) {
      return finding.text.find("ELFORM 13 are computed as 10") != std::string::npos;
    });
    EXPECT_EQ(reported, elform == 13);
    const nvh::Symmetric& k = experiment.matrices().stiffness;
    for (std::size_t j = 0; j < k.size(); ++j)
      stiffness[elform == 10].insert(stiffness[elform == 10].end(), k.values(j).begin(), k.values(j).end());
  }
  EXPECT_FALSE(stiffness[0].empty());
  EXPECT_EQ(stiffness[0], stiffness[1]);
}

}  // namespace
}  // namespace nugget::verify
