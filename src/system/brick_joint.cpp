// SPDX-License-Identifier: Apache-2.0
#include "system/brick_joint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/index.hpp"
#include "system/system.hpp"
#include "weld/failure/brick_section.hpp"

namespace nugget::system {
namespace {

constexpr std::size_t joint_size = kernel::WeldJoint::size;
/// Six freedoms of each end face: translation of the weld's middle, as the face's rigid motion has it, and rotation.
constexpr std::size_t of_faces = 12;
using FaceVector = std::array<double, of_faces>;
using FaceMatrix = std::array<FaceVector, of_faces>;
using OfCorners = std::array<FaceVector, 24>;  ///< of the freedoms of a brick's corners, those of the faces

Vec3d global_axis(std::size_t i) {
  return {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
}

/// Which end faces the corners of a brick lie in, and where they are.
struct Corners {
  std::array<std::size_t, 8> end{};
  std::array<Vec3d, 8> x;
};

/// How the corners move with rigid faces.
OfCorners motion_of_corners(const Corners& corners, const Vec3d& middle) {
  OfCorners moved{};
  for (std::size_t a = 0; a < 8; ++a)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t column = 6 * corners.end[a] + j;
      const Vec3d turned = cross(global_axis(j), corners.x[a] - middle);
      moved[3 * a + j][column] = 1.0;
      moved[3 * a][column + 3] = turned.x;
      moved[3 * a + 1][column + 3] = turned.y;
      moved[3 * a + 2][column + 3] = turned.z;
    }
  return moved;
}

/// The rigid motions of the faces that the motion of a brick's corners means: the inverse of the above.
std::array<std::array<double, 24>, of_faces> motion_of_faces(const Corners& corners, const Vec3d& middle) {
  std::array<std::array<double, 24>, of_faces> faces{};
  for (std::size_t end = 0; end < 2; ++end) {
    std::vector<std::size_t> at_end;
    std::vector<Vec3d> x;
    for (std::size_t a = 0; a < 8; ++a)
      if (corners.end[a] == end) {
        at_end.push_back(a);
        x.push_back(corners.x[a]);
      }
    for (std::size_t i = 0; i < at_end.size(); ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        std::vector<Vec3d> v(x.size());
        v[i] = global_axis(j);
        const FaceMotion m = face_motion(x, v, middle);
        const std::array<double, 6> row{m.velocity.x, m.velocity.y, m.velocity.z, m.spin.x, m.spin.y, m.spin.z};
        for (std::size_t k = 0; k < 6; ++k) faces[6 * end + k][3 * at_end[i] + j] = row[k];
      }
  }
  return faces;
}

/// Motions of the faces for a unit of each freedom of the joint.
std::array<FaceVector, joint_size> motions_of_joint(const JointMotions& motions, const std::array<double, 2>& share) {
  std::array<FaceVector, joint_size> faces{};
  for (std::size_t i = 0; i < joint_size; ++i)
    for (std::size_t end = 0; end < 2; ++end) {
      const Vec3d axis = (end == 0 ? -share[0] : share[1]) * motions.axis(i);
      const std::size_t first = 6 * end + (motions.turns(i) ? 3 : 0);
      faces[i][first] = axis.x;
      faces[i][first + 1] = axis.y;
      faces[i][first + 2] = axis.z;
    }
  return faces;
}

using JointMatrix = std::array<std::array<double, joint_size>, joint_size>;

/// Of a symmetric positive definite matrix, by Gauss and Jordan.
JointMatrix inverse(JointMatrix a) {
  JointMatrix b{};
  for (std::size_t i = 0; i < joint_size; ++i) b[i][i] = 1.0;
  for (std::size_t p = 0; p < joint_size; ++p) {
    const double over = 1.0 / a[p][p];
    for (std::size_t j = 0; j < joint_size; ++j) a[p][j] *= over, b[p][j] *= over;
    for (std::size_t i = 0; i < joint_size; ++i) {
      if (i == p) continue;
      const double factor = a[i][p];
      for (std::size_t j = 0; j < joint_size; ++j) a[i][j] -= factor * a[p][j], b[i][j] -= factor * b[p][j];
    }
  }
  return b;
}

double product(const FaceVector& a, const FaceVector& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < of_faces; ++i) sum += a[i] * b[i];
  return sum;
}

FaceVector product(const FaceMatrix& k, const FaceVector& b) {
  FaceVector all{};
  for (std::size_t i = 0; i < of_faces; ++i) all[i] = product(k[i], b);
  return all;
}

/// What flexibilities c in series with the freedoms B, `motion`, do to the stiffness k: what they take away from it,
///     -k B q,  q = c^1/2 (1 + c^1/2 B^t k B c^1/2)^-1 c^1/2 B^t k,
/// and q, what they move.
struct InSeries {
  FaceMatrix change{};
  std::array<FaceVector, joint_size> moved{};
};
InSeries in_series(const FaceMatrix& k, const std::array<FaceVector, joint_size>& motion,
                   const kernel::WeldJoint::Freedoms& flexibility) {
  std::array<FaceVector, joint_size> force{};
  JointMatrix system{};
  for (std::size_t i = 0; i < joint_size; ++i) {
    force[i] = product(k, motion[i]);
    for (double& f : force[i]) f *= std::sqrt(flexibility[i]);
  }
  for (std::size_t i = 0; i < joint_size; ++i)
    for (std::size_t j = 0; j < joint_size; ++j)
      system[i][j] = (i == j ? 1.0 : 0.0) + std::sqrt(flexibility[i]) * product(motion[i], force[j]);
  const JointMatrix solved = inverse(system);
  InSeries s;
  for (std::size_t i = 0; i < joint_size; ++i)
    for (std::size_t j = 0; j < joint_size; ++j)
      for (std::size_t b = 0; b < of_faces; ++b) {
        s.moved[i][b] += std::sqrt(flexibility[i]) * solved[i][j] * force[j][b];
        for (std::size_t a = 0; a < of_faces; ++a) s.change[a][b] -= force[i][a] * solved[i][j] * force[j][b];
      }
  return s;
}

/// a^t k a, row by row; `a` by row of k.
template <std::size_t n, std::size_t m, class Value>
std::array<std::array<double, m>, m> transformed(const std::array<std::array<double, m>, n>& a, const Value& k) {
  std::array<std::array<double, m>, n> ka{};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t c = 0; c < m; ++c) ka[i][c] += k(i, j) * a[j][c];
  std::array<std::array<double, m>, m> all{};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t b = 0; b < m; ++b)
      for (std::size_t c = 0; c < m; ++c) all[b][c] += a[i][b] * ka[i][c];
  return all;
}

/// Angle about r from s to the principal axis about which the bricks bend the hardest; 0 where all axes are alike.
double principal_angle(const FaceMatrix& stiffness, const JointMotions& motions, const std::array<double, 2>& share) {
  constexpr double alike = 1e-6;
  const std::array<FaceVector, joint_size> motion = motions_of_joint(motions, share);
  const double ss = product(motion[3], product(stiffness, motion[3])),
               tt = product(motion[4], product(stiffness, motion[4])),
               st = product(motion[3], product(stiffness, motion[4]));
  return std::hypot(ss - tt, 2.0 * st) > alike * (ss + tt) ? 0.5 * std::atan2(2.0 * st, ss - tt) : 0.0;
}

}  // namespace

FaceMotion face_motion(std::span<const Vec3d> x, std::span<const Vec3d> v, const Vec3d& point) {
  const double share = 1.0 / static_cast<double>(x.size());
  Vec3d centre, mean, turning;
  for (std::size_t i = 0; i < x.size(); ++i) {
    centre += share * x[i];
    mean += share * v[i];
  }
  Inertia spread{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    add_point(spread, 1.0, 0.0, x[i] - centre);
    turning += cross(x[i] - centre, v[i]);
  }
  const Vec3d spin = solve(spread, turning);
  return {mean + cross(spin, point - centre), spin};
}

void System::make_brick_joints() {
  const std::vector<std::optional<weld::Joint>> joints = weld::joints_of(model, ties);
  State rest;
  for (const Vec3d& x : start_) {
    rest.x.emplace_back();
    set(rest.x.back(), x);
  }
  for (std::size_t w = 0; w < joints.size(); ++w) {
    const weld::Weld& weld = ties.welds[w];
    if (!joints[w] || !weld.of_bricks()) continue;
    const weld::BrickSection section(weld, ties.x);
    std::vector<Vec3d> x;
    for (const model::Index node : section.nodes()) x.push_back(ties.x[node]);
    const weld::BrickSection::Shape shape = section.shape(x);
    JointMotions motions{shape.axes, 0.5 * (shape.centre[0] + shape.centre[1])};
    const auto corners_of = [&](ElementLocation location) {
      Corners corners;
      const ElementNodes node = groups[location.group]->nodes(at(location.element));
      for (std::size_t a = 0; a < 8; ++a) {
        const std::vector<model::Index>& second = weld.face[1];
        corners.end[a] = std::find(second.begin(), second.end(), model_node[node[a]]) != second.end() ? 1 : 0;
        corners.x[a] = start_[node[a]];
      }
      return corners;
    };
    FaceMatrix stiffness{};
    std::vector<double> k(24 * 24);
    for (const model::Index e : weld.elements) {
      const ElementLocation location = location_of(weld, e);
      groups[location.group]->stiffness(at(location.element), rest, k);
      const FaceMatrix one = transformed(motion_of_corners(corners_of(location), motions.middle),
                                         [&](std::size_t i, std::size_t j) { return k[24 * i + j]; });
      for (std::size_t i = 0; i < of_faces; ++i)
        for (std::size_t j = 0; j < of_faces; ++j) stiffness[i][j] += one[i][j];
    }
    BrickJoint joint{w, *joints[w], {}, motions, {}};
    // The s of an assembly starts from the global axes, which are no matter of its joint.
    if (weld.elements.size() > 1) {
      const double angle = principal_angle(stiffness, motions, joint.joint.share);
      const auto& [r, s, t] = shape.axes;
      if (angle != 0.0)
        motions.axes = {r, std::cos(angle) * s + std::sin(angle) * t, std::cos(angle) * t - std::sin(angle) * s};
      joint.motions = motions;
    }
    const std::array<FaceVector, joint_size> motion = motions_of_joint(motions, joint.joint.share);
    for (std::size_t i = 0; i < joint_size; ++i) joint.stiffness[i] = product(motion[i], product(stiffness, motion[i]));
    // Rigid faces move as one brick of the layer says, so it takes the change for all of them.
    const ElementLocation first = location_of(weld, weld.elements.front());
    const InSeries series = in_series(stiffness, motion, joint.joint.law.flexibility());
    joint.elastic = series.moved;
    const auto of_first = transformed(motion_of_faces(corners_of(first), motions.middle),
                                      [&](std::size_t i, std::size_t j) { return series.change[i][j]; });
    std::vector<double> flat;
    for (const auto& row : of_first) flat.insert(flat.end(), row.begin(), row.end());
    groups[first.group]->soften(at(first.element), std::move(flat));
    for (const weld::Stack& stack : weld_stacks)
      for (const weld::Stack::Member& member : stack.welds)
        if (member.weld == w) joint.joint.law.flow_from_outside();
    brick_joints.push_back(std::move(joint));
  }
}

void System::slide_brick_faces(std::span<Row> motion) const {
  for (const BrickJoint& joint : brick_joints) {
    const weld::Weld& weld = ties.welds[joint.weld];
    FaceVector faces{};
    for (std::size_t end = 0; end < 2; ++end) {
      std::vector<Vec3d> x, u;
      for (const model::Index node : weld.face[end]) {
        x.push_back(ties.x[node]);
        u.push_back(vec(motion[node_of[node]]));
      }
      const FaceMotion m = face_motion(x, u, joint.motions.middle);
      const std::array<double, 6> six{m.velocity.x, m.velocity.y, m.velocity.z, m.spin.x, m.spin.y, m.spin.z};
      std::copy(six.begin(), six.end(), faces.begin() + static_cast<std::ptrdiff_t>(6 * end));
    }
    for (std::size_t i = 0; i < joint_size; ++i) {
      const double moved = product(joint.elastic[i], faces);
      for (std::size_t end = 0; end < 2; ++end)
        for (const model::Index node : weld.face[end])
          add(motion[node_of[node]], (end == 0 ? joint.joint.share[0] : -joint.joint.share[1]) * moved *
                                         joint.motions.velocity(i, ties.x[node]));
    }
  }
}

}  // namespace nugget::system
