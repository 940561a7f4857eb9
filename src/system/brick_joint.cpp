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
using CornerVector = std::array<double, 24>;   ///< freedoms of the corners of a brick
using OfCorners = std::array<FaceVector, 24>;  ///< of the freedoms of a brick's corners, those of the faces

Vec3d global_axis(std::size_t i) {
  return {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
}

/// Where the corners of a brick are, and how far from the first end face to the second: 0, 1, between layers a share.
struct Corners {
  std::array<double, 8> along{};
  std::array<Vec3d, 8> x;
};

/// Rigid motion of a place for a unit of each of the six freedoms of a face.
std::array<std::array<double, 6>, 3> motion_of_place(const Vec3d& x, const Vec3d& middle) {
  std::array<std::array<double, 6>, 3> moved{};
  for (std::size_t j = 0; j < 3; ++j) {
    const Vec3d turned = cross(global_axis(j), x - middle);
    moved[j][j] = 1.0;
    moved[0][j + 3] = turned.x;
    moved[1][j + 3] = turned.y;
    moved[2][j + 3] = turned.z;
  }
  return moved;
}

/// How the corners move with rigid faces, and in proportion between.
OfCorners motion_of_corners(const Corners& corners, const Vec3d& middle) {
  OfCorners moved{};
  for (std::size_t a = 0; a < 8; ++a) {
    const std::array<std::array<double, 6>, 3> rigid = motion_of_place(corners.x[a], middle);
    for (std::size_t end = 0; end < 2; ++end) {
      const double share = end == 0 ? 1.0 - corners.along[a] : corners.along[a];
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 6; ++j) moved[3 * a + i][6 * end + j] = share * rigid[i][j];
    }
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
      if (corners.along[a] == static_cast<double>(end)) {
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

template <std::size_t n>
double product(const std::array<double, n>& a, const std::array<double, n>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) sum += a[i] * b[i];
  return sum;
}

template <std::size_t n>
using Square = std::array<std::array<double, n>, n>;

template <std::size_t n>
std::array<double, n> product(const Square<n>& k, const std::array<double, n>& b) {
  std::array<double, n> all{};
  for (std::size_t i = 0; i < n; ++i) all[i] = product(k[i], b);
  return all;
}

/// What flexibilities c in series with the freedoms B, `motion`, do to the stiffness k: what they take away from it,
///     -k B q,  q = c^1/2 (1 + c^1/2 B^t k B c^1/2)^-1 c^1/2 B^t k,
/// and q, what they move.
template <std::size_t n>
struct InSeries {
  Square<n> change{};
  std::array<std::array<double, n>, joint_size> moved{};
};
template <std::size_t n>
InSeries<n> in_series(const Square<n>& k, const std::array<std::array<double, n>, joint_size>& motion,
                      const kernel::WeldJoint::Freedoms& flexibility) {
  std::array<std::array<double, n>, joint_size> force{};
  JointMatrix system{};
  for (std::size_t i = 0; i < joint_size; ++i) {
    force[i] = product(k, motion[i]);
    for (double& f : force[i]) f *= std::sqrt(flexibility[i]);
  }
  for (std::size_t i = 0; i < joint_size; ++i)
    for (std::size_t j = 0; j < joint_size; ++j)
      system[i][j] = (i == j ? 1.0 : 0.0) + std::sqrt(flexibility[i]) * product(motion[i], force[j]);
  const JointMatrix solved = inverse(system);
  InSeries<n> s;
  for (std::size_t i = 0; i < joint_size; ++i)
    for (std::size_t j = 0; j < joint_size; ++j)
      for (std::size_t b = 0; b < n; ++b) {
        s.moved[i][b] += std::sqrt(flexibility[i]) * solved[i][j] * force[j][b];
        for (std::size_t a = 0; a < n; ++a) s.change[a][b] -= force[i][a] * solved[i][j] * force[j][b];
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
    const JointMotions motions{shape.axes, 0.5 * (shape.centre[0] + shape.centre[1])};
    const auto in_face = [&](std::size_t end, int node) {
      const std::vector<model::Index>& face = weld.face[end];
      return std::find(face.begin(), face.end(), model_node[node]) != face.end();
    };
    const auto corners_of = [&](ElementLocation location) {
      Corners corners;
      const ElementNodes node = groups[location.group]->nodes(at(location.element));
      for (std::size_t a = 0; a < 8; ++a) {
        corners.x[a] = start_[node[a]];
        const double along = dot(shape.axes.e1, corners.x[a] - shape.centre[0]) / shape.length;
        corners.along[a] = in_face(1, node[a]) ? 1.0 : in_face(0, node[a]) ? 0.0 : along;
      }
      return corners;
    };
    FaceMatrix stiffness{};
    std::vector<double> k(24 * 24);
    const auto entry = [&](std::size_t i, std::size_t j) { return k[24 * i + j]; };
    for (const model::Index e : weld.elements) {
      const ElementLocation location = location_of(weld, e);
      groups[location.group]->stiffness(at(location.element), rest, k);
      const FaceMatrix one = transformed(motion_of_corners(corners_of(location), motions.middle), entry);
      for (std::size_t i = 0; i < of_faces; ++i)
        for (std::size_t j = 0; j < of_faces; ++j) stiffness[i][j] += one[i][j];
    }
    BrickJoint joint{.weld = w, .joint = *joints[w], .motions = motions};
    const std::array<FaceVector, joint_size> motion = motions_of_joint(motions, joint.joint.share);
    for (std::size_t i = 0; i < joint_size; ++i) joint.stiffness[i] = product(motion[i], product(stiffness, motion[i]));

    const model::Index softened = joint.joint.softened == model::none ? weld.elements.front() : joint.joint.softened;
    const ElementLocation location = location_of(weld, softened);
    const ElementNodes of_brick = groups[location.group]->nodes(at(location.element));
    std::copy_n(of_brick.begin(), 8, joint.of_corners.begin());
    const Corners corners = corners_of(location);
    Square<24> change{};
    if (joint.joint.softened == model::none) {
      // Rigid faces move as one brick of the layer says, so it takes the change for all of them.
      const InSeries<of_faces> series = in_series(stiffness, motion, joint.joint.law.flexibility());
      const auto faces = motion_of_faces(corners, motions.middle);
      change = transformed(faces, [&](std::size_t i, std::size_t j) { return series.change[i][j]; });
      for (std::size_t i = 0; i < joint_size; ++i)
        for (std::size_t face = 0; face < of_faces; ++face)
          for (std::size_t c = 0; c < 24; ++c) joint.elastic[i][c] += series.moved[i][face] * faces[face][c];
    } else {
      // The face of the brick at one end moves against its disc; what is behind that brick stays as it is.
      groups[location.group]->stiffness(at(location.element), rest, k);
      Square<24> own{};
      for (std::size_t i = 0; i < 24; ++i)
        for (std::size_t j = 0; j < 24; ++j) own[i][j] = entry(i, j);
      const OfCorners corners_with_faces = motion_of_corners(corners, motions.middle);
      std::array<CornerVector, joint_size> sliding{};
      for (std::size_t i = 0; i < joint_size; ++i)
        for (std::size_t c = 0; c < 24; ++c)
          if (const double along = corners.along[c / 3]; along == 0.0 || along == 1.0)
            sliding[i][c] = product(corners_with_faces[c], motion[i]);
      for (std::size_t i = 0; i < joint_size; ++i) joint.stiffness[i] = product(sliding[i], product(own, sliding[i]));
      const InSeries<24> series = in_series(own, sliding, joint.joint.law.flexibility());
      change = series.change;
      joint.elastic = series.moved;
    }
    std::vector<double> flat;
    for (const auto& row : change) flat.insert(flat.end(), row.begin(), row.end());
    groups[location.group]->soften(at(location.element), std::move(flat));
    for (const weld::Stack& stack : weld_stacks)
      for (const weld::Stack::Member& member : stack.welds)
        if (member.weld == w) joint.joint.law.flow_from_outside();
    brick_joints.push_back(std::move(joint));
  }
}

void System::slide_brick_faces(std::vector<Row>& motion) const {
  for (const BrickJoint& joint : brick_joints) {
    const weld::Weld& weld = ties.welds[joint.weld];
    CornerVector corners{};
    for (std::size_t a = 0; a < 8; ++a) {
      const Vec3d u = vec(motion[joint.of_corners[a]]);
      corners[3 * a] = u.x;
      corners[3 * a + 1] = u.y;
      corners[3 * a + 2] = u.z;
    }
    for (std::size_t i = 0; i < joint_size; ++i) {
      const double moved = product(joint.elastic[i], corners);
      for (std::size_t end = 0; end < 2; ++end)
        for (const model::Index node : weld.face[end])
          add(motion[node_of[node]], (end == 0 ? joint.joint.share[0] : -joint.joint.share[1]) * moved *
                                         joint.motions.velocity(i, ties.x[node]));
    }
  }
}

}  // namespace nugget::system
