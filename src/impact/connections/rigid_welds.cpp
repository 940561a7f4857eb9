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
    weld.joints.assign(weld.nodes.size() > 2 ? 2 : 1, weld::RigidWeldHistory(source));
    welds_.push_back(std::move(weld));
  }
  find_neighbours();
  refuse_ties_on_failing_welds(findings);
}

void RigidWelds::find_neighbours() {
  std::vector<std::vector<Neighbour>*> wanted(system_.nodes, nullptr);
  bool any = false;
  for (Weld& weld : welds_) {
    if (weld.source->failure_strain <= 0.0) continue;
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

weld::RigidWeldLoad RigidWelds::joint_load(const Weld& weld, bool last, const system::State& state) const {
  const system::RigidBody& body = system_.bodies[weld.body];
  const auto c = at(body.node);
  const Vec3d omega = vec(state.w[c]);
  const Vec3d acceleration = (1.0 / body.mass) * vec(state.f[c]);
  const Vec3d alpha = body.spin(vec(state.m[c]) - cross(omega, body.momentum(omega, body.axes)), body.axes);

  const std::size_t i = last ? weld.nodes.size() - 1 : 0, other = weld.nodes.size() - 1 - i;
  const auto k = at(weld.nodes[i]);
  const Vec3d x = vec(state.x[k]), r = x - vec(state.x[c]), line = vec(state.x[weld.nodes[other]]) - x;
  const Vec3d own = acceleration + cross(alpha, r) + cross(omega, cross(omega, r));
  const Vec3d force = system_.own_mass[k] * own - weld.loads[i].force;
  const Vec3d moment = system_.own_inertia()[k] * alpha - weld.loads[i].moment;

  const bool given = norm(weld.axis) > 0.0;
  const Vec3d axis = given              ? body.axes.global(last ? -1.0 * weld.axis : weld.axis)
                     : norm(line) > 0.0 ? unit(line)
                                        : Vec3d{};  // a spot at one place that cannot fail: all its force is shear
  const Vec3d middle = moment - cross(0.5 * line, force);
  const double torsion = dot(middle, axis);
  return {body.axes.local(force), body.axes.local(axis), norm(middle - torsion * axis), torsion};
}

double RigidWelds::plastic_strain(const Weld& weld, bool last, const system::State& state) const {
  double largest = 0.0;
  const auto find_largest = [&](const std::vector<Neighbour>& around) {
    for (const Neighbour& n : around) {
      const system::ElementGroup& group = *system_.groups[n.group];
      for (int layer = 0; layer < group.layers(); ++layer)
        largest = std::max(largest, group.layer(n.element, layer, state).plastic_strain);
    }
  };
  if (weld.nodes.size() == 2) {
    find_largest(weld.around[0]);
    find_largest(weld.around[1]);
  } else {
    find_largest(last ? weld.around.back() : weld.around.front());
  }
  return largest;
}

bool RigidWelds::update(system::State& state) {
  bool released = false;
  for (Weld& weld : welds_) {
    if (weld.nodes.empty()) continue;
    std::array<bool, 2> fails{};
    for (std::size_t j = 0; j < weld.joints.size(); ++j) {
      const bool last = j == 1;
      if (weld.joints[j].failed()) continue;
      const double strain = weld.source->failure_strain > 0.0 ? plastic_strain(weld, last, state) : 0.0;
      fails[j] = weld.joints[j].update(state.time, joint_load(weld, last, state), strain);
      if (fails[j]) report(weld, weld.joints[j], last ? weld.nodes.back() : weld.nodes.front(), state);
    }
    if (!fails[0] && !fails[1]) continue;
    release(weld, fails[0], fails[1], state);
    released = true;
  }
  return released;
}

/// Releases the first and the last node as asked; all of them where only one would be left, or at the failure time.
void RigidWelds::release(Weld& weld, bool first, bool last, system::State& state) {
  const std::size_t n = weld.nodes.size(), released_count = at(first) + at(last);
  const bool releases_all = n - released_count < 2 || weld.joints[first ? 0 : 1].mode() == weld::FailureMode::time;
  const std::size_t begin = releases_all ? n : first ? 1 : 0, end = !releases_all && last ? n - 1 : n;
  std::vector<int> released,
      kept(weld.nodes.begin() + static_cast<long>(begin), weld.nodes.begin() + static_cast<long>(end));
  const Frame3d axes = system_.bodies[weld.body].axes;
  for (std::size_t i = 0; i < n; ++i) {
    const auto k = at(weld.nodes[i]);
    set(state.f[k], weld.loads[i].force);
    set(state.m[k], weld.loads[i].moment);
    if (i < begin || i >= end) released.push_back(weld.nodes[i]);
  }
  system_.release_nodes(weld.body, released, kept, state);
  weld.axis = system_.bodies[weld.body].axes.local(axes.global(weld.axis));
  weld.nodes = std::move(kept);
  const auto keep = [&](auto& list) {
    list.erase(list.begin() + static_cast<long>(end), list.end());
    list.erase(list.begin(), list.begin() + static_cast<long>(begin));
  };
  keep(weld.loads);
  keep(weld.around);
  if (weld.nodes.empty()) {
    ++failed_;
    return;
  }
  weld.joints.resize(weld.nodes.size() > 2 ? 2 : 1, weld.joints.front());  // two nodes have one joint
  for (weld::RigidWeldHistory& joint : weld.joints) joint.move_inward();
}

void RigidWelds::report(const Weld& weld, const weld::RigidWeldHistory& joint, int node, const system::State& state) {
  events_.push_back(
      fmt::format("{} failed  id={:8d} time={:12.5E} cycle={} at node {} by {}",
                  weld.source->kind == model::RigidWeld::Kind::spotweld ? "constraint/weld" : "generalized weld",
                  weld.source->id, state.time, state.cycle, system_.node_id(node), weld::to_string(joint.mode())));
}

const weld::RigidWeldHistory& RigidWelds::history(std::size_t i) const {
  const auto& joints = welds_[i].joints;
  const auto nearer = [](const weld::RigidWeldHistory& a, const weld::RigidWeldHistory& b) {
    if (a.failed() != b.failed()) return b.failed();
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

void RigidWelds::Weld::archive(Archive& a) {
  a(nodes, loads, around, axis);
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
