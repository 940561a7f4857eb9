// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/brick_joints.hpp"

#include <algorithm>

#include "base/index.hpp"
#include "base/parallel.hpp"

namespace nugget::impact {

BrickJoints::Moving::Moving(const system::System& system, const system::BrickJoint& joint)
    : source(&joint), section(system.ties.welds[joint.weld], system.ties.x) {
  const weld::Weld& weld = system.ties.welds[joint.weld];
  of_first_face = weld.face[0].size();
  for (const model::Index n : section.nodes()) nodes.push_back(system.node_of[n]);
  for (const model::Index e : weld.elements) {
    const system::System::ElementLocation location = system.location_of(weld, e);
    const system::ElementNodes of_brick = system.groups[location.group]->nodes(at(location.element));
    for (int a = 0; a < 8; ++a)
      corners.push_back(
          {location, a, static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), of_brick[a]) - nodes.begin())});
  }
}

void BrickJoints::Moving::gather(const system::System& system, std::vector<Vec3d>& sum) const {
  sum.assign(nodes.size(), {});
  for (const Corner& c : corners) sum[c.node] += system.nodal_force(c.location, c.corner);
}

BrickJoints::BrickJoints(system::System& system) : system_(system) {
  for (const system::BrickJoint& joint : system.brick_joints) joints_.emplace_back(system, joint);
}

void BrickJoints::open(system::State& state) {
  if (state.dt == 0.0) return;
  parallel_for(joints_.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) open(joints_[i], state);
  });
}

void BrickJoints::open(Moving& joint, system::State& state) {
  joint.slid.clear();
  double integrity = 0.0;  // of a weld that has failed there is none
  for (const Moving::Corner& c : joint.corners) {
    const system::ElementGroup& group = *system_.groups[c.location.group];
    if (group.alive(at(c.location.element))) integrity = std::max(integrity, group.integrity(at(c.location.element)));
  }
  const auto follows = [&](int node) { return system_.map.dependent(node); };
  const std::array<double, 2>& share = joint.source->joint.share;
  const auto first_of_second = joint.nodes.begin() + static_cast<std::ptrdiff_t>(joint.of_first_face);
  const bool held = (share[0] == 0.0 || std::all_of(joint.nodes.begin(), first_of_second, follows)) &&
                    (share[1] == 0.0 || std::all_of(first_of_second, joint.nodes.end(), follows));
  if (!(integrity > 0.0) || !held) return;

  // In the middle of the step, where a turn of the weld as a whole is no motion of the joint.
  std::vector<Vec3d> x, v;
  for (const int node : joint.nodes) {
    v.push_back(vec(state.v[node]));
    x.push_back(vec(state.x[node]) + 0.5 * state.dt * v.back());
  }
  const weld::BrickSection::Shape shape = joint.section.shape(x);
  const system::JointMotions motions{shape.axes, 0.5 * (shape.centre[0] + shape.centre[1])};
  const std::span<const Vec3d> places(x), velocities(v);
  const system::FaceMotion first = system::face_motion(places.first(joint.of_first_face),
                                                       velocities.first(joint.of_first_face), motions.middle),
                           second = system::face_motion(places.subspan(joint.of_first_face),
                                                        velocities.subspan(joint.of_first_face), motions.middle);
  joint.gather(system_, joint.force);
  kernel::WeldJoint::Freedoms moved, stiffness, force{};
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved[i] =
        state.dt * dot(motions.axis(i), motions.turns(i) ? second.spin - first.spin : second.velocity - first.velocity);
    stiffness[i] = integrity * joint.source->stiffness[i];
    for (std::size_t n = 0; n < x.size(); ++n)
      force[i] += (n < joint.of_first_face ? -0.5 : 0.5) * dot(motions.velocity(i, x[n]), joint.force[n]);
  }
  const kernel::WeldJoint::Freedoms left =
      joint.source->joint.law.advance(joint.state, moved, stiffness, force, state.dt);
  for (std::size_t n = 0; n < x.size(); ++n) {
    const bool at_first = n < joint.of_first_face;
    const double share_of_face = at_first ? share[0] : share[1];
    Vec3d slid;
    if (share_of_face > 0.0)
      for (std::size_t i = 0; i < moved.size(); ++i)
        slid += ((at_first ? share_of_face : -share_of_face) * (moved[i] - left[i])) * motions.velocity(i, x[n]);
    joint.slid.push_back(slid);
    if (share_of_face == 0.0) continue;
    // The disc turns it on from the middle of the step to its end.
    const Vec3d at_end = slid + cross(0.5 * state.dt * (at_first ? first : second).spin, slid);
    add(state.v[joint.nodes[n]], (1.0 / state.dt) * at_end);
    system_.map.slide(joint.nodes[n], at_end);
  }
}

std::vector<BrickJoints::Work> BrickJoints::book() {
  std::vector<Work> all;
  std::vector<Vec3d> now;
  for (Moving& joint : joints_) {
    if (joint.slid.empty()) continue;
    joint.gather(system_, now);
    Work work{joint.source->weld, {}};
    for (std::size_t n = 0; n < now.size(); ++n)
      work.at_end[n < joint.of_first_face ? 0 : 1] -= 0.5 * dot(joint.force[n] + now[n], joint.slid[n]);
    joint.slid.clear();
    const Moving::Corner& first = joint.corners.front();
    system_.groups[first.location.group]->add_internal_energy(at(first.location.element),
                                                              work.at_end[0] + work.at_end[1]);
    all.push_back(work);
  }
  return all;
}

double BrickJoints::plastic_work(std::size_t weld) const {
  for (const Moving& joint : joints_)
    if (joint.source->weld == weld) return joint.state.work;
  return 0.0;
}

void BrickJoints::Moving::archive(Archive& a) {
  a(state);
  a.built(source, section, nodes, of_first_face, corners, slid, force);
}

void BrickJoints::archive(Archive& a) {
  a(joints_);
  a.built(system_);
}

}  // namespace nugget::impact
