// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/brick_joints.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "base/parallel.hpp"

namespace nugget::impact {

BrickJoints::Moving::Moving(const system::System& system, const system::BrickJoint& joint)
    : source(&joint), section(system.ties.welds[joint.weld], system.ties.x) {
  const weld::Weld& weld = system.ties.welds[joint.weld];
  if (weld.elements.size() > 1) {
    std::vector<Vec3d> start;
    for (const model::Index n : section.nodes()) start.push_back(system.ties.x[n]);
    const Frame3d axes = section.shape(start).axes;
    constexpr double none = 1e-9;
    if (const double turned = dot(axes.e3, joint.motions.axes.e2); std::abs(turned) > none) {
      cosine = dot(axes.e2, joint.motions.axes.e2);
      sine = turned;
    }
  }
  of_first_face = weld.face[0].size();
  for (const model::Index n : section.nodes()) nodes.push_back(system.node_of[n]);
  for (const model::Index e : weld.elements) {
    const system::System::ElementLocation location = system.location_of(weld, e);
    const system::ElementNodes of_brick = system.groups[location.group]->nodes(at(location.element));
    for (int a = 0; a < 8; ++a)
      corners.push_back(
          {location, a, static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), of_brick[a]) - nodes.begin())});
  }
  for (std::vector<Vec3d>* of_nodes : {&slid, &force, &force_after, &x, &v}) of_nodes->resize(nodes.size());
}

void BrickJoints::Moving::gather(const system::System& system, std::vector<Vec3d>& sum) const {
  std::fill(sum.begin(), sum.end(), Vec3d{});
  for (const Corner& c : corners) sum[c.node] += system.nodal_force(c.location, c.corner);
}

Frame3d BrickJoints::Moving::axes_in(const Frame3d& section_axes) const {
  if (sine == 0.0) return section_axes;
  const auto& [r, s, t] = section_axes;
  return {r, cosine * s + sine * t, cosine * t - sine * s};
}

BrickJoints::BrickJoints(system::System& system) : system_(system) {
  for (const system::BrickJoint& joint : system.brick_joints) joints_.emplace_back(system, joint);
}

void BrickJoints::meet(const system::State& state) {
  if (state.dt == 0.0) return;
  parallel_for(joints_.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) meet(joints_[i], state);
  });
}

void BrickJoints::slide(system::State& state) {
  if (state.dt == 0.0) return;
  parallel_for(joints_.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (joints_[i].acts) slide(joints_[i], state);
  });
}

std::optional<std::size_t> BrickJoints::of(std::size_t weld) const {
  for (std::size_t i = 0; i < joints_.size(); ++i)
    if (joints_[i].source->weld == weld) return i;
  return {};
}

kernel::WeldTrial BrickJoints::trial(std::size_t i) const {
  const Moving& joint = joints_[i];
  if (!joint.acts) return {};
  return {joint.source->joint.law.trial(joint.state, joint.moved, joint.stiffness, joint.resultant), joint.motions.axes,
          true};
}

void BrickJoints::meet(Moving& joint, const system::State& state) {
  joint.acts = false;
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
  joint.acts = true;

  // In the middle of the step, where a turn of the weld as a whole is no motion of the joint.
  for (std::size_t n = 0; n < joint.nodes.size(); ++n) {
    joint.v[n] = vec(state.v[joint.nodes[n]]);
    joint.x[n] = vec(state.x[joint.nodes[n]]) + 0.5 * state.dt * joint.v[n];
  }
  const weld::BrickSection::Shape shape = joint.section.shape(joint.x);
  joint.motions = {joint.axes_in(shape.axes), 0.5 * (shape.centre[0] + shape.centre[1])};
  const std::span<const Vec3d> places(joint.x), velocities(joint.v);
  joint.face = {system::face_motion(places.first(joint.of_first_face), velocities.first(joint.of_first_face),
                                    joint.motions.middle),
                system::face_motion(places.subspan(joint.of_first_face), velocities.subspan(joint.of_first_face),
                                    joint.motions.middle)};
  joint.gather(system_, joint.force);
  const Vec3d spin = joint.face[1].spin - joint.face[0].spin,
              velocity = joint.face[1].velocity - joint.face[0].velocity;
  joint.resultant = {};
  for (std::size_t i = 0; i < joint.moved.size(); ++i) {
    joint.moved[i] = state.dt * dot(joint.motions.axis(i), joint.motions.turns(i) ? spin : velocity);
    joint.stiffness[i] = integrity * joint.source->stiffness[i];
    for (std::size_t n = 0; n < joint.x.size(); ++n)
      joint.resultant[i] +=
          (joint.end_of(n) == 0 ? -0.5 : 0.5) * dot(joint.motions.velocity(i, joint.x[n]), joint.force[n]);
  }
  if (!joint.source->joint.law.flows_from_outside()) return;
  // A stack knows no directions across its axis; more than the bricks have is safe, see BrickJoint::stiffness.
  for (const std::size_t s : {1U, 3U})
    joint.stiffness[s] = joint.stiffness[s + 1] = std::max(joint.stiffness[s], joint.stiffness[s + 1]);
}

void BrickJoints::slide(Moving& joint, system::State& state) {
  const kernel::WeldJoint::Freedoms left =
      joint.source->joint.law.advance(joint.state, joint.moved, joint.stiffness, joint.resultant, state.dt);
  for (std::size_t n = 0; n < joint.nodes.size(); ++n) {
    const std::size_t end = joint.end_of(n);
    const double share_of_face = joint.source->joint.share[end];
    Vec3d slid;
    if (share_of_face > 0.0)
      for (std::size_t i = 0; i < left.size(); ++i)
        slid += ((end == 0 ? share_of_face : -share_of_face) * (joint.moved[i] - left[i])) *
                joint.motions.velocity(i, joint.x[n]);
    joint.slid[n] = slid;
    if (share_of_face == 0.0) continue;
    // The disc turns it on from the middle of the step to its end.
    const Vec3d at_end = slid + cross(0.5 * state.dt * joint.face[end].spin, slid);
    add(state.v[joint.nodes[n]], (1.0 / state.dt) * at_end);
    system_.map.slide(joint.nodes[n], at_end);
  }
}

const std::vector<BrickJoints::Work>& BrickJoints::book() {
  works_.clear();
  for (Moving& joint : joints_) {
    if (!joint.acts) continue;
    joint.acts = false;
    joint.gather(system_, joint.force_after);
    Work work{joint.source->weld, {}};
    for (std::size_t n = 0; n < joint.nodes.size(); ++n)
      work.at_end[joint.end_of(n)] -= 0.5 * dot(joint.force[n] + joint.force_after[n], joint.slid[n]);
    const Moving::Corner& first = joint.corners.front();
    system_.groups[first.location.group]->add_internal_energy(at(first.location.element),
                                                              work.at_end[0] + work.at_end[1]);
    works_.push_back(work);
  }
  return works_;
}

void BrickJoints::Moving::archive(Archive& a) {
  a(state);
  a.built(source, section, cosine, sine, nodes, of_first_face, corners, acts, slid, force, force_after, x, v, motions,
          face, moved, stiffness, resultant);
}

void BrickJoints::archive(Archive& a) {
  a(joints_);
  a.built(system_, works_);
}

}  // namespace nugget::impact
