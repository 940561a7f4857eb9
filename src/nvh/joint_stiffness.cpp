// SPDX-License-Identifier: Apache-2.0
#include "nvh/joint_stiffness.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "nvh/assembly.hpp"

namespace nugget::nvh {
namespace {

using Kind = model::Joint::Kind;
constexpr Vec3d axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

void put(JointRows::Row& row, std::size_t first, const Vec3d& v) {
  row[first] += v.x;
  row[first + 1] += v.y;
  row[first + 2] += v.z;
}

/// d . (B's displacement - A's), of points with these arms from the bodies' centres.
JointRows::Row displacement(const Vec3d& d, const Vec3d& arm_a, const Vec3d& arm_b) {
  JointRows::Row row{};
  put(row, 0, -d);
  put(row, 3, -cross(arm_a, d));  // d . (w x r) = w . (r x d)
  put(row, 6, d);
  put(row, 9, cross(arm_b, d));
  return row;
}

/// d . (B's rotation - A's).
JointRows::Row rotation(const Vec3d& d) {
  JointRows::Row row{};
  put(row, 3, -d);
  put(row, 9, d);
  return row;
}

/// Two unit vectors that make a triad with a.
std::array<Vec3d, 2> across(const Vec3d& a) {
  const Vec3d least = std::abs(a.x) < 0.6 ? axes[0] : axes[1];
  const Vec3d s = unit(least - dot(least, a) * a);
  return {s, cross(a, s)};
}

JointRows rows_of(const system::System& system, const model::Joint& joint) {
  const auto place = [&](std::size_t i) { return system.ties.x[at(joint.node[i])]; };
  JointRows rows;
  rows.scale = joint.stiffness_scale;
  std::array<Vec3d, 2> arm;
  for (std::size_t side = 0; side < 2; ++side) {
    const system::RigidBody& body = system.bodies[at(system.body_of[at(joint.body[side])])];
    rows.node[side] = body.node;
    arm[side] = place(0) - body.center0;
    const double gyration = body.mass > 0.0 ? (body.inertia[0] + body.inertia[3] + body.inertia[5]) / body.mass : 0.0;
    rows.reach = std::max(rows.reach, std::sqrt(dot(arm[side], arm[side]) + gyration));
  }
  const auto hold = [&](const Vec3d& d) { rows.displacements.push_back(displacement(d, arm[0], arm[1])); };
  if (joint.kind == Kind::spherical) {
    for (const Vec3d& d : axes) hold(d);
    return rows;
  }
  const Vec3d axis = unit(place(2) - place(0));
  const std::array<Vec3d, 2> sides = across(axis);
  if (joint.kind != Kind::cylindrical && joint.kind != Kind::translational) hold(axis);
  if (joint.kind != Kind::planar)
    for (const Vec3d& d : sides) hold(d);

  if (joint.kind == Kind::universal) {
    rows.rotations.push_back(rotation(unit(cross(axis, place(3) - place(1)))));
    return rows;
  }
  for (const Vec3d& d : sides) rows.rotations.push_back(rotation(d));
  if (joint.kind == Kind::translational || joint.kind == Kind::locking) rows.rotations.push_back(rotation(axis));
  return rows;
}

/// The largest diagonal entry of the stiffness among a node's translations, or rotations.
double stiffest(const Equations& equations, const Symmetric& k, int node, int first) {
  double most = 0.0;
  for (int i = first; i < first + 3; ++i)
    for (const Equations::Term& t : equations.terms(node, i))
      most = std::max(most, std::abs(k.diagonal(at(t.equation))));
  return most;
}

}  // namespace

std::vector<JointRows> joint_rows(const system::System& system) {
  std::vector<JointRows> all;
  for (const model::Joint& joint : system.model.joints) all.push_back(rows_of(system, joint));
  return all;
}

void add_joints(const std::vector<JointRows>& joints, const Equations& equations, Symmetric& stiffness) {
  double largest = 0.0;
  for (std::size_t i = 0; i < stiffness.size(); ++i) largest = std::max(largest, std::abs(stiffness.diagonal(i)));
  std::vector<std::array<double, 2>> springs;  // against displacements and rotations; by what is there before any joint
  for (const JointRows& joint : joints) {
    double across = 0.0, turning = 0.0;
    for (const int node : joint.node) {
      across = std::max(across, stiffest(equations, stiffness, node, 0));
      turning = std::max(turning, stiffest(equations, stiffness, node, 3));
    }
    if (across == 0.0) across = largest > 0.0 ? largest : 1.0;
    turning = std::max(turning, across * joint.reach * joint.reach);
    springs.push_back({joint_share * joint.scale * across, joint_share * joint.scale * turning});
  }
  for (std::size_t j = 0; j < joints.size(); ++j) {
    std::vector<double> k(144, 0.0);
    const auto add = [&](const std::vector<JointRows::Row>& rows, double spring) {
      for (const JointRows::Row& row : rows)
        for (std::size_t a = 0; a < 12; ++a)
          for (std::size_t b = 0; b < 12; ++b) k[12 * a + b] += spring * row[a] * row[b];
    };
    add(joints[j].displacements, springs[j][0]);
    add(joints[j].rotations, springs[j][1]);
    scatter(Reach(equations, joints[j].node, 6), k, stiffness);
  }
}

}  // namespace nugget::nvh
