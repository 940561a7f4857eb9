// SPDX-License-Identifier: Apache-2.0
#include "nvh/statics/static_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <concepts>

#include "nvh/matrices/resistance.hpp"

namespace nugget::nvh {
namespace {

/// "nothing resists a force along (1 0 0) at node 7, and nothing holds it", and how many more there are.
std::string say_unresisted(const Matrices& m, const UnresistedLoad& first, std::size_t count) {
  const std::string node = name_of(m.system, first.node), more = count > 1 ? fmt::format(" ({} such)", count) : "";
  if (first.nothing_there)
    return first.moment ? fmt::format("{} carries a moment, but nothing there can turn{}", node, more)
                        : fmt::format("{} carries a load, but belongs to no element, mass or rigid body{}", node, more);
  const Vec3d& d = first.direction;
  return fmt::format("nothing resists a {} along ({:.3g} {:.3g} {:.3g}) at {}, and nothing holds it{}",
                     first.moment ? "moment" : "force", d.x, d.y, d.z, node, more);
}

/// The nodal load that acts on a node, or on one that follows it; null: none.
const model::NodalLoad* load_on(const Matrices& m, int node) {
  const auto acts = [&](model::Index n) {
    const int k = m.system.node_of[n];
    if (k == node) return true;
    if (!m.system.map.dependent(k)) return false;
    return std::ranges::any_of(m.system.map.blocks(k), [&](const auto& block) { return block.node == node; });
  };
  for (const model::NodalLoad& load : m.system.model.nodal_loads) {
    if (std::ranges::any_of(load.nodes, acts)) return &load;
    if (load.rigid_body != model::none && m.system.bodies[m.system.body_of[load.rigid_body]].node == node) return &load;
  }
  return nullptr;
}

}  // namespace

double StaticLoads::level(model::Index curve, double time) const {
  const Curve& c = m_.system.model.curves[curve];
  return c.in_run ? c.zero_outside(time) : 0.0;
}

void StaticLoads::add(const model::NodalLoad& load) {
  const std::array<model::Index, 3>& f = load.follower_nodes;
  const Vec3d direction =
      f[0] == model::none ? load.direction : unit(cross(place(f[1]) - place(f[0]), place(f[2]) - place(f[0])));
  const Vec3d force = load.scale * level(load.curve, time_) * direction;
  for (const model::Index n : load.nodes) add_to(load_[node(n)], load.moment, force);
  if (load.rigid_body == model::none) return;
  const system::RigidBody& body = m_.system.bodies[m_.system.body_of[load.rigid_body]];
  add_to(load_[body.node], load.moment, force);
}

void StaticLoads::add(const model::PressureLoad& load) {
  const double time = time_ - load.arrival;
  const double p = time >= 0.0 ? load.scale * level(load.curve, time) : 0.0;
  for (std::size_t i = 0; i < load.segments.size(); ++i) {
    const model::Segment& s = load.segments[i];
    const Vec3d force = p * force_of_pressure(m_, s);
    for (std::size_t a = 0; a < 4; ++a) add_to(load_[node(s[a])], false, load.share[i][a] * force);
  }
}

void StaticLoads::add(const model::BodyLoad& load) {
  const double a = -load.scale * level(load.curve, time_);
  for (std::size_t k = 0; k < load_.size(); ++k) add_to(load_[k], false, a * m_.nodal_mass[k].mass * load.direction);
}

void check_resistance(const Matrices& m, Findings& findings) {
  const model::Model& model = m.system.model;
  StaticLoads on_all(m, model.control.end_time), on_some(m, model.control.end_time);
  model::for_each_load(model, [&]<class Load>(const Load& load) {
    if constexpr (std::same_as<Load, model::BodyLoad>)
      on_all.add(load);
    else if constexpr (KnownInStatics<Load>)
      on_some.add(load);
  });
  const char* const remedy =
      "hold the node in that direction (*BOUNDARY_SPC_...), give it stiffness, or take the load off it";
  if (const auto lost = unresisted_loads(m, on_some.nodal()); !lost.empty()) {
    const model::NodalLoad* load = load_on(m, lost.front().node);
    const Place place = load != nullptr ? load->place : Place{model.deck, 0, 0};
    const char* const keyword = load == nullptr                   ? "*LOAD"
                                : load->rigid_body == model::none ? "*LOAD_NODE"
                                                                  : "*LOAD_RIGID_BODY";
    std::string text = say_unresisted(m, lost.front(), lost.size());
    // A lever on bricks makes a moment that nothing there takes, as it does in a run.
    const bool by_lever = lost.front().moment && (load == nullptr || !load->moment);
    if (model.implicit.geometric || by_lever)
      findings.warning(place, keyword, text + ": it takes no part", remedy);
    else
      findings.error(place, keyword, std::move(text), remedy);
  }
  if (const auto lost = unresisted_loads(m, on_all.nodal()); !lost.empty())
    findings.warning({model.deck, 0, 0}, "*LOAD_BODY",
                     say_unresisted(m, lost.front(), lost.size()) + ": body loads there are left out", remedy);
}

Nodal external_loads(const Matrices& matrices, double time) {
  StaticLoads loads(matrices, time);
  model::for_each_load(matrices.system.model, [&]<class Load>(const Load& load) {
    if constexpr (KnownInStatics<Load>) loads.add(load);
  });
  return loads.nodal();
}

Nodal static_loads(const Matrices& matrices, double time) {
  Nodal all = external_loads(matrices, time);
  const Nodal internal = forces_at_start(matrices);
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t i = 0; i < 6; ++i) all[k][i] -= internal[k][i];
  return all;
}

}  // namespace nugget::nvh
