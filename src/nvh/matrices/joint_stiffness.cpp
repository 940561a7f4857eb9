// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/joint_stiffness.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "base/rotation_between.hpp"
#include "kernel/law/discrete_spring.hpp"

namespace nugget::nvh {
namespace {

using Kind = model::Joint::Kind;
using Row = ConstrainedMotion::Row;

void put(Row& row, std::size_t first, const Vec3d& v) {
  row[first] += v.x;
  row[first + 1] += v.y;
  row[first + 2] += v.z;
}

/// d . (B's displacement - A's), of points with these arms from the bodies' centres.
ConstrainedMotion displacement(const Vec3d& d, const Vec3d& arm_a, const Vec3d& arm_b) {
  ConstrainedMotion constrained{{}, d, false};
  put(constrained.row, 0, -d);
  put(constrained.row, 3, -cross(arm_a, d));  // d . (w x r) = w . (r x d)
  put(constrained.row, 6, d);
  put(constrained.row, 9, cross(arm_b, d));
  return constrained;
}

/// d . (B's rotation - A's).
ConstrainedMotion rotation(const Vec3d& d) {
  ConstrainedMotion constrained{{}, d, true};
  put(constrained.row, 3, -d);
  put(constrained.row, 9, d);
  return constrained;
}

/// The ratio that a joint keeps, between these axes of A and B; as in impact (impact/joints.hpp). `gap`: from A's point
/// to B's.
ConstrainedMotion transmission(const model::Joint& joint, const Vec3d& a, const Vec3d& b, const Vec3d& arm_a,
                               const Vec3d& arm_b, const Vec3d& gap) {
  if (joint.kind == Kind::gears || joint.kind == Kind::pulley) {
    const double sign = (joint.kind == Kind::gears ? 1.0 : -1.0) * (dot(a, b) < 0.0 ? -1.0 : 1.0);
    ConstrainedMotion constrained{{}, b, true};
    put(constrained.row, 3, sign / joint.ratio * a);
    put(constrained.row, 9, b);
    return constrained;
  }
  const bool screw = joint.kind == Kind::screw;
  ConstrainedMotion constrained = displacement(screw ? a : b, screw ? arm_a + gap : arm_a, arm_b);
  put(constrained.row, 3, -joint.ratio * a);
  if (screw) put(constrained.row, 9, joint.ratio * a);
  return constrained;
}

/// Two unit vectors that make a triad with a.
std::array<Vec3d, 2> across(const Vec3d& a) {
  const Vec3d least = std::abs(a.x) < 0.6 ? global_axes[0] : global_axes[1];
  const Vec3d s = unit(least - dot(least, a) * a);
  return {s, cross(a, s)};
}

const system::RigidBody& body_of(const system::System& system, model::Index body) {
  return system.bodies[system.body_of[body]];
}

BodyLink link_of(const system::System& system, const model::Joint& joint) {
  const auto place = [&](std::size_t i) { return joint.point[i]; };
  BodyLink link;
  link.rigid = true;
  link.scale = joint.stiffness_scale;
  std::array<Vec3d, 2>& arm = link.arm;
  for (std::size_t side = 0; side < 2; ++side) {
    const system::RigidBody& body = body_of(system, joint.body[side]);
    link.node[side] = body.node;
    arm[side] = place(0) - body.center0;
    const double gyration = body.mass > 0.0 ? (body.inertia[0] + body.inertia[3] + body.inertia[5]) / body.mass : 0.0;
    link.body_size = std::max(link.body_size, std::sqrt(dot(arm[side], arm[side]) + gyration));
  }
  const auto constrain = [&](const Vec3d& d) { link.constrained.push_back(displacement(d, arm[0], arm[1])); };
  if (joint.kind == Kind::spherical) {
    for (const Vec3d& d : global_axes) constrain(d);
    return link;
  }
  const Vec3d axis = unit(place(2) - place(0));
  if (joint.transmits()) {
    arm[1] = place(1) - body_of(system, joint.body[1]).center0;
    const Vec3d other = unit(place(3) - place(1));
    link.constrained.push_back(transmission(joint, axis, other, arm[0], arm[1], place(1) - place(0)));
    return link;
  }
  const std::array<Vec3d, 2> sides = across(axis);
  if (joint.kind != Kind::cylindrical && joint.kind != Kind::translational) constrain(axis);
  if (joint.kind != Kind::planar)
    for (const Vec3d& d : sides) constrain(d);

  if (joint.kind == Kind::universal) {
    link.constrained.push_back(rotation(unit(cross(axis, place(3) - place(1)))));
    return link;
  }
  for (const Vec3d& d : sides) link.constrained.push_back(rotation(d));
  if (joint.kind == Kind::translational || joint.kind == Kind::locking) link.constrained.push_back(rotation(axis));
  return link;
}

/// Slope of a freedom at rest, `start` away from where its curve is 0.
double slope_of(const system::System& system, const model::JointStiffness::Freedom& f, double start) {
  double slope = f.friction > 0.0 ? f.stiffness : 0.0;
  if (f.load != model::none) slope += kernel::ForceCurve(system.model.curves[f.load]).slope(start);
  const bool stopped = (f.high_stop > 0.0 && start > f.high_stop) || (f.low_stop > 0.0 && start < -f.low_stop);
  return stopped ? slope + f.stiffness : slope;
}

/// Force of a freedom that begins at `start`, in which its friction has not been moved yet.
double force_of(const system::System& system, const model::JointStiffness::Freedom& f, double start) {
  const double beyond = f.high_stop > 0.0 && start > f.high_stop  ? start - f.high_stop
                        : f.low_stop > 0.0 && start < -f.low_stop ? start + f.low_stop
                                                                  : 0.0;
  const double load = f.load == model::none ? 0.0 : kernel::ForceCurve(system.model.curves[f.load])(start);
  return load + f.stiffness * beyond;
}

BodyLink link_of(const system::System& system, const model::JointStiffness& s) {
  BodyLink link;
  std::array<Vec3d, 2>& arm = link.arm;
  for (std::size_t side = 0; side < 2; ++side) {
    const system::RigidBody& body = body_of(system, s.body[side]);
    link.node[side] = body.node;
    arm[side] = s.origin[0] - body.center0;  // forces act at the origin of A
  }
  const Vec3d own[3] = {s.axes[1].e1, s.axes[1].e2, s.axes[1].e3};
  const Vec3d start = s.rotational ? rotation_between(s.axes[0], s.axes[1]) : s.origin[1] - s.origin[0];
  for (std::size_t i = 0; i < 3; ++i) {
    ConstrainedMotion constrained = s.rotational ? rotation(own[i]) : displacement(own[i], arm[0], arm[1]);
    constrained.spring = slope_of(system, s.freedom[i], dot(own[i], start));
    if (const model::Index damper = s.freedom[i].damper; damper != model::none)
      constrained.dashpot = kernel::ForceCurve(system.model.curves[damper]).slope(0.0);
    constrained.start = force_of(system, s.freedom[i], dot(own[i], start));
    if (constrained.spring != 0.0 || constrained.dashpot != 0.0 || constrained.start != 0.0)
      link.constrained.push_back(constrained);
  }
  return link;
}

/// Matrix of the twelve freedoms.
std::vector<double> sum_of(const std::vector<ConstrainedMotion>& constrained, double ConstrainedMotion::*factor) {
  std::vector<double> k(144, 0.0);
  for (const ConstrainedMotion& h : constrained)
    for (std::size_t a = 0; a < 12; ++a)
      for (std::size_t b = 0; b < 12; ++b) k[12 * a + b] += h.*factor * h.row[a] * h.row[b];
  return k;
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

std::vector<double> BodyLink::stiffness() const {
  return sum_of(constrained, &ConstrainedMotion::spring);
}
std::vector<double> BodyLink::viscosity() const {
  return sum_of(constrained, &ConstrainedMotion::dashpot);
}
bool BodyLink::damps() const {
  return std::ranges::any_of(constrained, [](const ConstrainedMotion& h) { return h.dashpot != 0.0; });
}

SixDof BodyLink::on_second(const ConstrainedMotion::Row& motion) const {
  SixDof load{};
  for (const ConstrainedMotion& h : constrained) {
    double moved = 0.0;
    for (std::size_t a = 0; a < 12; ++a) moved += h.row[a] * motion[a];
    const Vec3d part = -h.spring * moved * h.direction;
    const double component[3] = {part.x, part.y, part.z};
    for (std::size_t i = 0; i < 3; ++i) load[i + (h.rotation ? 3 : 0)] += component[i];
  }
  return load;
}

double BodyLink::energy(const ConstrainedMotion::Row& motion) const {
  double sum = 0.0;
  for (const ConstrainedMotion& h : constrained) {
    double moved = 0.0;
    for (std::size_t a = 0; a < 12; ++a) moved += h.row[a] * motion[a];
    sum += 0.5 * h.spring * moved * moved;
  }
  return sum;
}

std::vector<BodyLink> body_links(const system::System& system) {
  std::vector<BodyLink> all;
  for (const model::Joint& joint : system.model.joints) all.push_back(link_of(system, joint));
  for (const model::JointStiffness& s : system.model.joint_stiffnesses) all.push_back(link_of(system, s));
  return all;
}

void stiffen_joints(std::vector<BodyLink>& links, const Equations& equations, const Symmetric& stiffness) {
  double largest = 0.0;
  for (std::size_t i = 0; i < stiffness.size(); ++i) largest = std::max(largest, std::abs(stiffness.diagonal(i)));
  for (BodyLink& link : links) {
    if (!link.rigid) continue;
    double across = 0.0, turning = 0.0;
    for (const int node : link.node) {
      across = std::max(across, stiffest(equations, stiffness, node, 0));
      turning = std::max(turning, stiffest(equations, stiffness, node, 3));
    }
    if (across == 0.0) across = largest > 0.0 ? largest : 1.0;
    turning = std::max(turning, across * link.body_size * link.body_size);
    for (ConstrainedMotion& constrained : link.constrained)
      constrained.spring = joint_share * link.scale * (constrained.rotation ? turning : across);
  }
}

}  // namespace nugget::nvh
