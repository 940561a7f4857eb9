// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/rigid_welds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/index.hpp"

namespace nugget::impact {

RigidWelds::RigidWelds(system::System& system, Findings& findings) : system_(system) {
  for (const model::RigidWeld& source : system.model.rigid_welds) {
    if (source.kind == model::RigidWeld::Kind::rivet) continue;
    Weld weld;
    weld.source = &source;
    weld.body = at(system.body_of[source.body]);
    for (const model::Index n : source.nodes) weld.nodes.push_back(system.node_of[n]);
    weld.loads.resize(weld.nodes.size());
    weld.around.resize(weld.nodes.size());
    if (source.axis) weld.axis = *source.axis;
    add_joints(weld);
    welds_.push_back(std::move(weld));
  }
  find_neighbours();
  refuse_ties_on_failing_welds(findings);
}

void RigidWelds::add_joints(Weld& weld) const {
  const model::RigidWeld& source = *weld.source;
  for (const model::Seam& seam : source.seams) {
    const auto node = [&](std::size_t end) { return system_.node_of[source.nodes[seam.nodes[end]]]; };
    weld.seams.push_back({&seam, {node(0), node(1)}, seam.tension, seam.normal, {}});
    weld.joints.emplace_back(source, &seam);
  }
  if (weld.seams.empty()) weld.joints.assign(weld.nodes.size() > 2 ? 2 : 1, weld::RigidWeldHistory(source));
}

void RigidWelds::find_neighbours() {
  std::vector<std::vector<Neighbour>*> wanted(system_.nodes, nullptr);
  bool any = false;
  for (Weld& weld : welds_) {
    const auto by_strain = [](const model::Seam& seam) { return seam.failure_strain > 0.0; };
    const auto& seams = weld.source->seams;
    if (weld.source->failure_strain <= 0.0 && std::none_of(seams.begin(), seams.end(), by_strain)) continue;
    any = true;
    for (std::size_t i = 0; i < weld.nodes.size(); ++i) wanted[weld.nodes[i]] = &weld.around[i];
  }
  if (!any) return;
  for (std::size_t g = 0; g < system_.groups.size(); ++g) {
    const system::ElementGroup& group = *system_.groups[g];
    if (group.kind != model::ElementKind::shell && group.kind != model::ElementKind::solid) continue;
    for (std::size_t e = 0; e < group.size(); ++e) {
      const auto nodes = group.nodes(e);
      for (int a = 0; a < group.nodes_per_element; ++a)
        if (auto* list = wanted[nodes[a]]) list->push_back({static_cast<int>(g), e});
    }
  }
}

/// What a tied node hands over to a node of the weld reaches the body without being seen as a load of that node.
void RigidWelds::refuse_ties_on_failing_welds(Findings& findings) const {
  std::vector<const Weld*> at_node(system_.all_nodes(), nullptr);
  for (const Weld& weld : welds_)
    if (weld.source->can_fail())
      for (const int n : weld.nodes) at_node[n] = &weld;
  for (std::size_t d = 0; d < system_.nodes; ++d) {
    if (!system_.map.dependent(static_cast<int>(d))) continue;
    for (const auto& term : system_.map.terms(static_cast<int>(d))) {
      const Weld* weld = at_node[term.node];
      if (weld == nullptr) continue;
      findings.error(weld->source->place, "",
                     fmt::format("node {} is tied to a sheet at a node of rigid weld {}, which can fail; a tie on such "
                                 "a node is not built",
                                 system_.node_id(static_cast<int>(d)), weld->source->id),
                     "move one of the two welds to other nodes, or take the failure of the rigid weld out");
    }
  }
}

void RigidWelds::store_loads(const system::State& state) {
  for (Weld& weld : welds_)
    for (std::size_t i = 0; i < weld.nodes.size(); ++i)
      weld.loads[i] = {vec(state.f[weld.nodes[i]]), vec(state.m[weld.nodes[i]])};
}

/// Force and moment of the weld on its node number `i`.
RigidWelds::Load RigidWelds::force_on(const Weld& weld, std::size_t i, const system::State& state) const {
  const system::RigidBody& body = system_.bodies[weld.body];
  const auto c = at(body.node);
  const Vec3d omega = vec(state.w[c]);
  const Vec3d acceleration = (1.0 / body.mass) * vec(state.f[c]);
  const Vec3d alpha = body.spin(vec(state.m[c]) - cross(omega, body.momentum(omega, body.axes)), body.axes);

  const auto k = at(weld.nodes[i]);
  const Vec3d r = vec(state.x[k]) - vec(state.x[c]);
  const Vec3d own = acceleration + cross(alpha, r) + cross(omega, cross(omega, r));
  return {system_.own_mass[k] * own - weld.loads[i].force, system_.own_inertia()[k] * alpha - weld.loads[i].moment};
}

weld::RigidWeldLoad RigidWelds::joint_load(const Weld& weld, bool last, const system::State& state) const {
  const Frame3d& axes = system_.bodies[weld.body].axes;
  const std::size_t i = last ? weld.nodes.size() - 1 : 0, other = weld.nodes.size() - 1 - i;
  const Load on_node = force_on(weld, i, state);
  const Vec3d line = vec(state.x[weld.nodes[other]]) - vec(state.x[weld.nodes[i]]);
  const bool given = norm(weld.axis) > 0.0;
  const Vec3d axis = given              ? axes.global(last ? -1.0 * weld.axis : weld.axis)
                     : norm(line) > 0.0 ? unit(line)
                                        : Vec3d{};  // a spot at one place that cannot fail: all its force is shear
  const Vec3d middle = on_node.moment - cross(0.5 * line, on_node.force);
  const double torsion = dot(middle, axis);
  return {axes.local(on_node.force), axes.local(axis), {}, norm(middle - torsion * axis), torsion};
}

/// Force of a seam on its first node, and its moment at mid-length. In a triangle, whose forces no statics give, each
/// seam is as stiff as the others, and its moments are not known.
weld::RigidWeldLoad RigidWelds::seam_load(const Weld& weld, std::size_t j, const system::State& state) const {
  const SeamNow& seam = weld.seams[j];
  const auto meets = [&](std::size_t k, int node) {
    return !weld.joints[k].failed() && (weld.seams[k].nodes[0] == node || weld.seams[k].nodes[1] == node);
  };
  double beside = 0.0;                    // seams between the same two nodes, itself among them
  std::array<bool, 2> alone{true, true};  // whether an end has no other neighbour
  for (std::size_t k = 0; k < weld.seams.size(); ++k) {
    const std::array<bool, 2> both{meets(k, seam.nodes[0]), meets(k, seam.nodes[1])};
    if (both[0] && both[1]) beside += 1.0;
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}})
      if (both[end] && !both[1 - end]) alone[end] = false;
  }
  const auto on = [&](std::size_t end) {
    const auto node = std::find(weld.nodes.begin(), weld.nodes.end(), seam.nodes[end]);
    return force_on(weld, static_cast<std::size_t>(node - weld.nodes.begin()), state);
  };
  const Vec3d line = vec(state.x[seam.nodes[1]]) - vec(state.x[seam.nodes[0]]);
  Load load;
  if (alone[0]) {
    load = on(0);
    load.moment -= cross(0.5 * line, load.force);
  } else if (alone[1]) {
    const Load second = on(1);
    load = {-1.0 * second.force, -1.0 * (second.moment + cross(0.5 * line, second.force))};
  } else {
    load.force = (1.0 / 3.0) * (on(0).force - on(1).force);
  }
  const Frame3d& axes = system_.bodies[weld.body].axes;
  const Vec3d force = (1.0 / beside) * axes.local(load.force), moment = (1.0 / beside) * axes.local(load.moment);
  const Vec3d axis = norm(seam.tension) > 0.0 ? seam.tension : norm(line) > 0.0 ? unit(axes.local(line)) : Vec3d{};
  const double torsion = dot(moment, axis);
  return {force, axis, seam.normal, norm(moment - torsion * axis), torsion};
}

double RigidWelds::largest_strain(const std::vector<Neighbour>& around, const system::State& state) const {
  double largest = 0.0;
  for (const Neighbour& n : around) {
    const system::ElementGroup& group = *system_.groups[n.group];
    for (int layer = 0; layer < group.layers(); ++layer)
      largest = std::max(largest, group.layer(n.element, layer, state).plastic_strain);
  }
  return largest;
}

double RigidWelds::plastic_strain(const Weld& weld, bool last, const system::State& state) const {
  if (weld.nodes.size() == 2)
    return std::max(largest_strain(weld.around[0], state), largest_strain(weld.around[1], state));
  return largest_strain(last ? weld.around.back() : weld.around.front(), state);
}

double RigidWelds::seam_strain(const Weld& weld, std::size_t j, const system::State& state) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < weld.nodes.size(); ++i)
    if (weld.nodes[i] == weld.seams[j].nodes[0] || weld.nodes[i] == weld.seams[j].nodes[1])
      largest = std::max(largest, largest_strain(weld.around[i], state));
  return largest;
}

bool RigidWelds::update(system::State& state) {
  bool released = false;
  for (Weld& weld : welds_) {
    if (weld.nodes.empty()) continue;
    const bool lost = weld.seams.empty() ? update_spot(weld, state) : update_seams(weld, state);
    released = released || lost;
  }
  return released;
}

bool RigidWelds::update_spot(Weld& weld, system::State& state) {
  std::array<bool, 2> fails{};
  for (std::size_t j = 0; j < weld.joints.size(); ++j) {
    const bool last = j == 1;
    if (weld.joints[j].failed()) continue;
    const double strain = weld.source->failure_strain > 0.0 ? plastic_strain(weld, last, state) : 0.0;
    fails[j] = weld.joints[j].update(state.time, joint_load(weld, last, state), strain);
    if (fails[j])
      report(weld, weld.joints[j],
             fmt::format("at node {}", system_.node_id(last ? weld.nodes.back() : weld.nodes.front())), state);
  }
  if (!fails[0] && !fails[1]) return false;
  release(weld, fails[0], fails[1], state);
  return true;
}

/// All seams are judged by what they carry together, before any of them is gone.
bool RigidWelds::update_seams(Weld& weld, system::State& state) {
  for (std::size_t j = 0; j < weld.joints.size(); ++j)
    if (!weld.joints[j].failed()) weld.seams[j].load = seam_load(weld, j, state);
  bool any = false;
  for (std::size_t j = 0; j < weld.joints.size(); ++j) {
    weld::RigidWeldHistory& joint = weld.joints[j];
    const SeamNow& seam = weld.seams[j];
    if (joint.failed() || !joint.update(state.time, seam.load, seam_strain(weld, j, state))) continue;
    report(weld, joint,
           fmt::format("between nodes {} and {}", system_.node_id(seam.nodes[0]), system_.node_id(seam.nodes[1])),
           state);
    any = true;
  }
  return any && release_unseamed(weld, state);
}

/// Releases the first and the last node as asked; all of them where only one would be left, or at the failure time.
void RigidWelds::release(Weld& weld, bool first, bool last, system::State& state) {
  const std::size_t n = weld.nodes.size(), released_count = at(first) + at(last);
  const bool releases_all = n - released_count < 2 || weld.joints[first ? 0 : 1].mode() == weld::FailureMode::time;
  std::vector<char> holds(n, releases_all ? 0 : 1);
  if (first) holds.front() = 0;
  if (last) holds.back() = 0;
  release_unmarked(weld, holds, state);
  if (weld.nodes.empty()) return;
  weld.joints.resize(weld.nodes.size() > 2 ? 2 : 1, weld.joints.front());  // two nodes have one joint
  for (weld::RigidWeldHistory& joint : weld.joints) joint.move_inward();
}

/// Releases the nodes that no seam holds any more. False where all are still held.
bool RigidWelds::release_unseamed(Weld& weld, system::State& state) {
  std::vector<char> holds(weld.nodes.size(), 0);
  for (std::size_t j = 0; j < weld.seams.size(); ++j)
    for (std::size_t i = 0; i < weld.nodes.size(); ++i)
      if (!weld.joints[j].failed() &&
          (weld.seams[j].nodes[0] == weld.nodes[i] || weld.seams[j].nodes[1] == weld.nodes[i]))
        holds[i] = 1;
  if (std::find(holds.begin(), holds.end(), 0) == holds.end()) return false;
  const Frame3d axes = system_.bodies[weld.body].axes;
  release_unmarked(weld, holds, state);
  const Frame3d& now = system_.bodies[weld.body].axes;
  for (SeamNow& seam : weld.seams) {
    seam.tension = now.local(axes.global(seam.tension));
    seam.normal = now.local(axes.global(seam.normal));
  }
  for (weld::RigidWeldHistory& joint : weld.joints) joint.restart_filter();
  return true;
}

/// Releases the nodes that are not marked.
void RigidWelds::release_unmarked(Weld& weld, const std::vector<char>& holds, system::State& state) {
  const Frame3d axes = system_.bodies[weld.body].axes;
  std::vector<int> released, kept;
  for (std::size_t i = 0; i < weld.nodes.size(); ++i) {
    const auto k = at(weld.nodes[i]);
    set(state.f[k], weld.loads[i].force);
    set(state.m[k], weld.loads[i].moment);
    (holds[i] ? kept : released).push_back(weld.nodes[i]);
  }
  system_.release_nodes(weld.body, released, kept, state);
  weld.axis = system_.bodies[weld.body].axes.local(axes.global(weld.axis));
  const auto keep = [&](auto& list) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < holds.size(); ++i)
      if (holds[i] && count++ != i) list[count - 1] = std::move(list[i]);
    list.resize(count);
  };
  weld.nodes = std::move(kept);
  keep(weld.loads);
  keep(weld.around);
  if (weld.nodes.empty()) ++failed_;
}

void RigidWelds::report(const Weld& weld, const weld::RigidWeldHistory& joint, const std::string& where,
                        const system::State& state) {
  events_.push_back(
      fmt::format("{} failed  id={:8d} time={:12.5E} cycle={} {} by {}",
                  weld.source->kind == model::RigidWeld::Kind::spotweld ? "constraint/weld" : "generalized weld",
                  weld.source->id, state.time, state.cycle, where, weld::to_string(joint.mode())));
}

const weld::RigidWeldHistory& RigidWelds::history(std::size_t i) const {
  const auto& joints = welds_[i].joints;
  const bool seams = !welds_[i].seams.empty();
  const auto nearer = [&](const weld::RigidWeldHistory& a, const weld::RigidWeldHistory& b) {
    if (a.failed() != b.failed()) return seams ? a.failed() : b.failed();
    if (seams && a.failed()) return a.failure_time() < b.failure_time();
    return a.failure_value() < b.failure_value();
  };
  return *std::max_element(joints.begin(), joints.end(), nearer);
}

const weld::RigidWeldHistory* RigidWelds::history_of_body(model::Index body) const {
  for (std::size_t i = 0; i < welds_.size(); ++i)
    if (welds_[i].source->body == body) return &history(i);
  return nullptr;
}

double RigidWelds::length(std::size_t i, const system::State& state) const {
  const std::vector<model::Index>& nodes = welds_[i].source->nodes;
  const auto place = [&](model::Index n) { return vec(state.x[system_.node_of[n]]); };
  return norm(place(nodes.back()) - place(nodes.front()));
}

void RigidWelds::SeamNow::archive(Archive& a) {
  a(tension, normal);
  a.built(source, nodes, load);
}

void RigidWelds::Weld::archive(Archive& a) {
  a(nodes, loads, around, axis, seams);
  // A weld of many nodes that has lost some has one joint in place of two.
  std::size_t count = joints.size();
  a(count);
  joints.resize(count, joints.front());
  a(joints);
  a.built(source, body);
}

void RigidWelds::archive(Archive& a) {
  a(welds_, failed_, events_);
  a.built(system_);
}

}  // namespace nugget::impact
