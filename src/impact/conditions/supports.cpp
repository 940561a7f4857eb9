// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/supports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "base/index.hpp"
#include "impact/conditions/directions.hpp"
#include "impact/conditions/in_force.hpp"
#include "model/circular_motion.hpp"
#include "system/share.hpp"

namespace nugget::impact {
namespace {

constexpr Vec3d axis_of[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

Vec3d axis(const model::Model& model, model::Index system, int i) {
  if (system == model::none) return axis_of[i];
  const Frame3d& a = model.systems[system].axes;
  return i == 0 ? a.e1 : i == 1 ? a.e2 : a.e3;
}

/// Where a node is driven in a direction in which it is held, or driven twice, the motion of the last card counts: what
/// is left of `items`, which `overrides(item, motion)` says to give way, acts before and after it only. So work is
/// counted once.
template <class Item, class PrescribedDof, class Yields>
void drop_overridden_supports(std::vector<Item>& items, const std::vector<PrescribedDof>& motions,
                              const system::System& system, Findings& findings, std::string_view what,
                              const Yields& overrides) {
  std::multimap<int, std::size_t> motion_at;
  for (std::size_t d = 0; d < motions.size(); ++d)
    if (motions[d].body < 0 && !motions[d].constrain_others && !motions[d].motion->circular)
      motion_at.emplace(motions[d].node, d);
  if (motion_at.empty()) return;
  std::vector<Item> left;
  for (std::size_t i = 0; i < items.size(); ++i) {
    std::vector<Item> parts{items[i]};
    const auto [first, last] = motion_at.equal_range(items[i].node);
    for (auto other = first; other != last; ++other) {
      const PrescribedDof& d = motions[other->second];
      const bool together = d.rotation == items[i].rotation && std::abs(dot(d.axis, items[i].axis)) >= 1.0 - 1e-9 &&
                            d.birth < items[i].death && d.death > items[i].birth;
      if (!together || !overrides(i, other->second)) continue;
      if (items[i].control != model::none || d.control != model::none) {
        findings.error(d.motion->place, "*BOUNDARY_PRESCRIBED_MOTION",
                       fmt::format("node {} {}, and one of them is turned on and off by *SENSOR_CONTROL: which one "
                                   "counts is not documented",
                                   system.node_id(d.node), what),
                       "take the node out of one of the two cards");
        continue;
      }
      findings.warning(d.motion->place, "*BOUNDARY_PRESCRIBED_MOTION",
                       fmt::format("node {} {}", system.node_id(d.node), what), "take it out of one of the two cards");
      std::vector<Item> cut;
      for (Item before : parts) {
        Item after = before;
        before.death = std::min(before.death, d.birth);
        after.birth = std::max(after.birth, d.death);
        for (const Item& part : {before, after})
          if (part.birth < part.death) cut.push_back(part);
      }
      parts = std::move(cut);
    }
    left.insert(left.end(), parts.begin(), parts.end());
  }
  items = std::move(left);
}

/// Directions of one node that are neither parallel nor at right angles.
bool are_oblique(const Vec3d& a, const Vec3d& b) {
  const double cosine = std::abs(dot(a, b));
  return cosine > 1e-9 && cosine < 1.0 - 1e-9;
}

/// Where supports hold a node in directions that are oblique to each other (the planes of a sector meet there), the
/// velocities would not all be 0 after one is met behind the other. So what is held at one time is put at right
/// angles, in the order of the cards (Gram and Schmidt); what adds no direction is left out.
template <class Item>
void orthogonalize(std::vector<Item>& items, const system::System& system, Findings& findings) {
  std::map<std::pair<int, bool>, std::vector<std::size_t>> of_node;
  for (std::size_t i = 0; i < items.size(); ++i) of_node[{items[i].node, items[i].rotation}].push_back(i);
  std::vector<char> replaced(items.size(), 0);
  std::vector<Item> made;
  for (const auto& [place, members] : of_node) {
    bool any = false;
    for (const std::size_t i : members)
      for (const std::size_t j : members) any = any || are_oblique(items[i].axis, items[j].axis);
    const auto switched = [&](std::size_t i) { return items[i].control != model::none; };
    if (!any) continue;
    if (const auto found = std::ranges::find_if(members, switched); found != members.end()) {
      findings.error(system.model.sensor_controls[items[*found].control].place, "*SENSOR_CONTROL",
                     fmt::format("node {} is held in directions that are oblique to each other, by a support that is "
                                 "turned on and off: this is not built",
                                 system.node_id(items[*found].node)),
                     "hold the node along axes at right angles");
      continue;
    }
    std::vector<double> times;
    for (const std::size_t i : members) {
      replaced[i] = 1;
      times.insert(times.end(), {items[i].birth, items[i].death});
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    for (std::size_t t = 0; t + 1 < times.size(); ++t) {
      const std::size_t first = made.size();
      for (const std::size_t i : members) {
        Item item = items[i];
        if (item.birth > times[t] || item.death < times[t + 1]) continue;
        for (std::size_t k = first; k < made.size(); ++k) item.axis -= dot(made[k].axis, item.axis) * made[k].axis;
        if (norm(item.axis) < 1e-6) continue;
        item.axis = unit(item.axis);
        item.birth = times[t];
        item.death = times[t + 1];
        made.push_back(item);
      }
    }
  }
  std::vector<Item> all;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (replaced[i] == 0) all.push_back(items[i]);
  all.insert(all.end(), made.begin(), made.end());
  items = std::move(all);
}

double time_on_curve(const model::PrescribedMotion& motion, const system::State& state) {
  return state.time - motion.birth - (motion.from_switch ? state.turned_on(motion.control) : 0.0);
}

/// Time on the curve at which the step begins; a motion activated within it has its curve from there on.
double begin_of_step(bool active, double t) {
  return active ? t : std::min(t, 0.0);
}

/// Whether the run ends at this state and, there too, the curve. The step that would follow is not taken, but
/// velocities, accelerations and reactions at the end are halfway into it, where the curve has nothing to say any more.
bool ends_with_run(const Curve& curve, const system::System& system, const system::State& state, double t) {
  const double end = system.model.control.end_time;
  return end > 0.0 && !state.relaxing && state.time >= end && std::abs(curve.x.back() - t) <= 1e-6 * state.dt;
}

/// Mean velocity of the step that begins at `t` on the curve: that of its middle.
double velocity_of_step(const Curve& curve, const system::System& system, const system::State& state, double t) {
  return ends_with_run(curve, system, state, t) ? curve.y.back() : curve.zero_outside(t + 0.5 * state.dt);
}

/// Way in that step. Beyond its last point a displacement holds its value: the node stays where it was brought.
double displacement_increment(const Curve& curve, const system::System& system, const system::State& state, double t,
                              bool active) {
  if (ends_with_run(curve, system, state, t)) return curve.y.back() - curve.clamped(t - state.dt);
  return curve.clamped(t + state.dt) - curve.clamped(begin_of_step(active, t));
}

}  // namespace

Supports::Supports(const system::System& system, Findings& findings) : system_(system) {
  const model::Model& model = system.model;
  for (std::size_t s = 0; s < model.spcs.size(); ++s) {
    const model::SinglePointConstraint& spc = model.spcs[s];
    const int node = system.node_of[spc.node];
    // A node that is tied by its translations alone has its own rotations. Nodes that are tied until the mesh tears are
    // all held alike, and each goes on being held when it is free.
    const bool is_own = !system.map.dependent(node) || system.follows_tied_node(node);
    const unsigned own = is_own ? 63u : system.map.rotations(node) ? 0u : 56u;
    const unsigned obeyed = spc.fixed & own;
    if (obeyed != spc.fixed)
      findings.warning({model.deck, 0, 0}, "*BOUNDARY_SPC",
                       "node " + std::to_string(model.nodes.id[spc.node]) + " is held by an SPC, but it moves with " +
                           system.constraint_name(node) +
                           (obeyed == 0 ? "; the SPC does nothing there" : "; the SPC holds its rotations only"),
                       "constrain what it moves with: the nodes of the segment it is tied to, or the rigid body "
                       "(MAT_RIGID CMO, *CONSTRAINED_NODAL_RIGID_BODY_SPC)");
    if (obeyed == 0) continue;
    for (int i = 0; i < 6; ++i) {
      if (!(obeyed >> i & 1u)) continue;
      constrained_dofs_.push_back(
          {spc_.size(), node, axis(model, spc.system, i % 3), i >= 3, spc.birth, spc.death, spc.control});
    }
    Reaction& reaction = spc_.emplace_back();
    reaction.node = node;
    reaction.source = static_cast<model::Index>(s);
    reaction.set_id = spc.set_id;
  }
  for (std::size_t k = 0; k < model.motions.size(); ++k) {
    const model::PrescribedMotion& motion = model.motions[k];
    const auto prescribe_node = [&](int node, int body) {
      std::vector<Vec3d> directions{motion.direction};
      if (motion.circular && motion.radius_fixed) directions.push_back({});  // found anew in each step
      if (!motion.only_direction)
        for (const Vec3d& n : normals(motion.direction)) directions.push_back(n);
      for (std::size_t d = 0; d < directions.size(); ++d) {
        PrescribedDof prescribed;
        static_cast<ConstrainedDof&>(prescribed) = {motion_.size(), node,         directions[d], motion.rotation,
                                                    motion.birth,   motion.death, motion.control};
        prescribed.motion = &motion;
        prescribed.body = body;
        prescribed.constrain_others = d > 0;
        prescribed.at_start = directions[d];
        prescribed_dofs_.push_back(prescribed);
      }
      Reaction& reaction = motion_.emplace_back();
      reaction.node = node;
      reaction.source = static_cast<model::Index>(k);
    };
    if (motion.target == model::PrescribedMotion::Target::nodes) {
      for (model::Index n : motion.nodes) {
        const int node = system.node_of[n];
        if (system.map.dependent(node) && !system.follows_tied_node(node)) {
          findings.error(motion.place, "*BOUNDARY_PRESCRIBED_MOTION",
                         "node " + std::to_string(model.nodes.id[n]) + " moves with " + system.constraint_name(node) +
                             " and cannot be driven on its own",
                         "drive the rigid body with *BOUNDARY_PRESCRIBED_MOTION_RIGID, or nodes of the sheet");
          continue;
        }
        prescribe_node(node, -1);
      }
    } else {
      const int body = system.body_of[motion.rigid_body];
      prescribe_node(system.bodies[body].node, body);
    }
  }
  drop_overridden_supports(constrained_dofs_, prescribed_dofs_, system, findings,
                           "is held by an SPC in the direction in which it is driven: it follows the motion",
                           [](std::size_t, std::size_t) { return true; });
  drop_overridden_supports(prescribed_dofs_, std::vector<PrescribedDof>(prescribed_dofs_), system, findings,
                           "is driven by two cards in one direction at one time: the last one counts",
                           [this](std::size_t one, std::size_t other) {
                             return one < other && !prescribed_dofs_[one].constrain_others &&
                                    prescribed_dofs_[one].motion != prescribed_dofs_[other].motion;
                           });
  orthogonalize(constrained_dofs_, system, findings);
  find_together(findings);
  for (std::size_t d = 0; d < prescribed_dofs_.size(); ++d)
    if (prescribed_dofs_[d].body < 0 && !prescribed_dofs_[d].rotation)
      of_translations_.push_back({prescribed_dofs_[d].node, false, d});
  for (std::size_t h = 0; h < constrained_dofs_.size(); ++h)
    if (!constrained_dofs_[h].rotation) of_translations_.push_back({constrained_dofs_[h].node, true, h});
  std::ranges::sort(of_translations_);
}

void Supports::find_together(Findings& findings) {
  std::map<std::tuple<int, bool, int>, Together> groups;
  for (std::size_t d = 0; d < prescribed_dofs_.size(); ++d) {
    const PrescribedDof& p = prescribed_dofs_[d];
    if (p.motion->circular) continue;
    Together& group =
        groups.try_emplace({p.node, p.rotation, p.body}, Together{p.node, p.rotation, p.body, {}, {}}).first->second;
    // Where more is asked for than can be met, the last card counts; of one card, its direction before what is across.
    auto after = group.driven.begin();
    while (after != group.driven.end() && prescribed_dofs_[*after].motion == p.motion) ++after;
    group.driven.insert(after, d);
  }
  if (groups.empty()) return;
  for (std::size_t h = 0; h < constrained_dofs_.size(); ++h) {
    const ConstrainedDof& held = constrained_dofs_[h];
    if (const auto group = groups.find({held.node, held.rotation, -1}); group != groups.end())
      group->second.held.push_back(h);
  }
  for (auto& [place, group] : groups) {
    const auto local = [&](std::size_t d) {
      return prescribed_dofs_[d].motion->target == model::PrescribedMotion::Target::rigid_body_local;
    };
    bool needed = group.body >= 0 && group.rotation;
    const auto at_one_time = [](const ConstrainedDof& a, const ConstrainedDof& b) {
      return a.birth < b.death && b.birth < a.death;
    };
    for (const std::size_t d : group.driven) {
      PrescribedDof& one = prescribed_dofs_[d];
      for (const std::size_t e : group.driven) {
        const PrescribedDof& other = prescribed_dofs_[e];
        if (e == d || !at_one_time(one, other)) continue;
        const bool turning = group.body >= 0 && local(d) != local(e);
        one.oblique = one.oblique || turning || are_oblique(one.axis, other.axis);
        if (group.body >= 0 && !turning && d < e && !one.constrain_others && !other.constrain_others &&
            one.motion != other.motion && std::abs(dot(one.axis, other.axis)) >= 1.0 - 1e-9)
          findings.warning(other.motion->place, "*BOUNDARY_PRESCRIBED_MOTION",
                           fmt::format("rigid body {} is driven by two cards in one direction at one time: the last "
                                       "one counts",
                                       system_.bodies[group.body].id),
                           "take it out of one of the two cards");
        needed = needed || turning || std::abs(dot(one.axis, other.axis)) > 1e-9;
      }
      for (const std::size_t h : group.held)
        one.oblique =
            one.oblique || (at_one_time(one, constrained_dofs_[h]) && are_oblique(constrained_dofs_[h].axis, one.axis));
      needed = needed || one.oblique;
    }
    if (!needed) continue;
    for (const std::size_t d : group.driven) prescribed_dofs_[d].together = true;
    for (const std::size_t h : group.held) constrained_dofs_[h].together = true;
    together_.push_back(std::move(group));
  }
}

void Supports::constrain_at_start(system::State& state) {
  for (const ConstrainedDof& h : constrained_dofs_) {
    if (h.birth > 0.0 || !state.acts(h.control)) continue;
    Row& row = h.rotation ? state.w[h.node] : state.v[h.node];
    add(row, -dot(h.axis, vec(row)) * h.axis);
  }
}

void Supports::hold_for_good(std::span<Row> v, std::span<Row> w) const {
  const double end = system_.model.control.end_time;
  const auto hold = [&](const ConstrainedDof& dof) {
    if (dof.birth > 0.0 || dof.death < end || dof.control != model::none) return;
    Row& row = dof.rotation ? w[dof.node] : v[dof.node];
    add(row, -dot(dof.axis, vec(row)) * dof.axis);
  };
  for (const ConstrainedDof& h : constrained_dofs_) hold(h);
  for (const PrescribedDof& d : prescribed_dofs_)
    if (!d.motion->circular && !d.oblique && !(d.body >= 0 && d.rotation)) hold(d);
}

Supports::OfNode Supports::of_node(int node, bool rotation) const {
  OfNode found;
  const double end = system_.model.control.end_time;
  for (const ConstrainedDof& h : constrained_dofs_) {
    if (h.node != node || h.rotation != rotation) continue;
    found.held.push_back(h.axis);
    found.passing = found.passing || h.birth > 0.0 || h.death < end || h.control != model::none;
  }
  for (std::size_t d = 0; d < prescribed_dofs_.size(); ++d) {
    const PrescribedDof& p = prescribed_dofs_[d];
    if (p.node != node || p.rotation != rotation || p.body >= 0) continue;
    found.driven.push_back(d);
    found.passing = found.passing || p.birth > 0.0 || p.death < end || p.control != model::none;
    found.turning = found.turning || p.motion->circular || p.oblique;
  }
  return found;
}

std::optional<double> Supports::coming_velocity(std::size_t driven, const system::State& state,
                                                double velocity_interval) const {
  PrescribedDof d = prescribed_dofs_[driven];
  if (!in_force(system_.model.curves[d.motion->curve], state)) return {};
  if (!d.active && state.cycle == 0) d.velocity = dot(d.axis, vec(d.rotation ? state.w[d.node] : state.v[d.node]));
  return target(d, state, d.velocity, velocity_interval);
}

double Supports::target(PrescribedDof& prescribed, const system::State& state, double old_velocity,
                        double velocity_interval) const {
  if (prescribed.motion->circular) return circular_target(prescribed, state, old_velocity, velocity_interval);
  if (prescribed.constrain_others) return 0.0;
  const model::PrescribedMotion& motion = *prescribed.motion;
  const Curve& curve = system_.model.curves[motion.curve];
  const double t = time_on_curve(motion, state);
  switch (motion.quantity) {
    case model::PrescribedMotion::Quantity::velocity: return motion.scale * velocity_of_step(curve, system_, state, t);
    case model::PrescribedMotion::Quantity::acceleration:
      return old_velocity + motion.scale * curve.zero_outside(t) * velocity_interval;
    case model::PrescribedMotion::Quantity::displacement: {
      if (state.dt <= 0.0) return 0.0;
      return motion.scale * displacement_increment(curve, system_, state, t, prescribed.active) / state.dt;
    }
  }
  return 0.0;
}

double Supports::circular_target(PrescribedDof& prescribed, const system::State& state, double old_velocity,
                                 double velocity_interval) const {
  const model::PrescribedMotion& motion = *prescribed.motion;
  const Curve& curve = system_.model.curves[motion.curve];
  const double dt = state.dt, t = time_on_curve(motion, state);
  if (!(dt > 0.0)) return 0.0;
  const auto node = at(prescribed.node);
  const model::PlaceOnCircle place = model::place_on_circle(motion, vec(state.x[node]));
  // The nodes end on the circle, not beside it: both components are those of a chord. This one follows that around.
  if (prescribed.constrain_others) {
    const double sine = place.radius > 0.0 ? dt * dot(place.around, vec(state.v[node])) / place.radius : 0.0;
    return -place.radius * sine * sine / (1.0 + std::sqrt(std::max(0.0, 1.0 - sine * sine))) / dt;
  }
  using Quantity = model::PrescribedMotion::Quantity;
  double turned = 0.0;  // angle of the step to come
  if (motion.quantity == Quantity::velocity) {
    turned = motion.scale * velocity_of_step(curve, system_, state, t) * dt;
  } else if (motion.quantity == Quantity::displacement) {
    turned = motion.scale * displacement_increment(curve, system_, state, t, prescribed.active);
  } else {
    if (!prescribed.active) prescribed.rate = place.radius > 0.0 ? old_velocity / place.radius : 0.0;
    prescribed.rate += motion.scale * curve.zero_outside(t) * velocity_interval;
    turned = prescribed.rate * dt;
  }
  // Where the radius is free, the velocity outwards stays, and the angle is met at the place where that leads.
  if (motion.radius_fixed) return place.radius * std::sin(turned) / dt;
  return (place.radius + dt * dot(place.outwards, vec(state.v[node]))) * std::tan(turned) / dt;
}

void Supports::set_component(ConstrainedDof& dof, double target, const system::RigidBody* body, system::State& state,
                             double velocity_interval, std::vector<Reaction>& reactions) {
  const auto node = at(dof.node);
  Row& row = dof.rotation ? state.w[node] : state.v[node];
  const double free_velocity = dot(dof.axis, vec(row));
  const Vec3d load = vec(dof.rotation ? state.m[node] : state.f[node]);
  const double inertia = body ? body->mass : (dof.rotation ? system_.inertia[node] : system_.mass[node]);
  const double impulse = inertia * (target - free_velocity);
  add(row, (target - free_velocity) * dof.axis);
  Reaction& reaction = reactions[dof.reaction];
  reaction.power += (target - free_velocity) * dot(dof.axis, load);
  dof.force = velocity_interval > 0.0 ? impulse / velocity_interval : 0.0;
  // A node without mass, as the end of a spring may be, feels what pulls at it and nothing else. The first card that
  // holds it takes that.
  if (!body && !(inertia > 0.0)) {
    dof.force = -dot(dof.axis, load);
    add(dof.rotation ? state.m[node] : state.f[node], dof.force * dof.axis);
  }
  (dof.rotation ? reaction.moment : reaction.force) += dof.force * dof.axis;
  // Closing half: the velocity component before the update is the one that `dof` kept from the last step.
  reaction.energy += 0.5 * dof.force * dof.velocity * state.dt_previous;
  dof.before = dof.velocity;
  dof.velocity = target;
}

bool Supports::acts(const PrescribedDof& dof, const system::State& state) const {
  return acts(static_cast<const ConstrainedDof&>(dof), state) &&
         in_force(system_.model.curves[dof.motion->curve], state);
}

void Supports::release(ConstrainedDof& dof, const system::State& state) const {
  dof.active = false;
  dof.force = 0.0;
  dof.velocity = dot(dof.axis, vec(dof.rotation ? state.w[dof.node] : state.v[dof.node]));
}

double Supports::wanted(PrescribedDof& dof, const system::State& state, double velocity_interval,
                        std::span<const system::RigidBody> bodies) const {
  // The body's axes at time 0 were the global ones.
  if (dof.body >= 0 && dof.motion->target == model::PrescribedMotion::Target::rigid_body_local)
    dof.axis = bodies[dof.body].axes.global(dof.at_start);
  if (!dof.active && state.cycle == 0)
    dof.velocity = dot(dof.axis, vec(dof.rotation ? state.w[dof.node] : state.v[dof.node]));
  const double velocity = target(dof, state, dof.velocity, velocity_interval);
  dof.active = true;
  return velocity;
}

void Supports::meet(const Together& group, system::State& state, double velocity_interval,
                    std::span<system::RigidBody> bodies) {
  struct Met {
    ConstrainedDof* dof = nullptr;  // none: a body's own constraint
    Reaction* reaction = nullptr;
  };
  std::array<Met, 3> met;
  Directions directions;
  const auto add_direction = [&](const Vec3d& d, double speed, bool across, ConstrainedDof* dof, Reaction* reaction) {
    if (directions.add(d, speed, across)) met[at(directions.size() - 1)] = {dof, reaction};
  };
  system::RigidBody* body = group.body >= 0 ? &bodies[group.body] : nullptr;
  if (body && group.rotation) {
    const std::array<Vec3d, 3> own{body->fixed_axes.e1, body->fixed_axes.e2, body->fixed_axes.e3};
    for (int i = 0; i < 3; ++i)
      if (body->fixed >> (3 + i) & 1u) add_direction(own[i], 0.0, false, nullptr, nullptr);
  }
  // Where more is asked for than can be met, what holds the node holds it across the motions.
  const auto count = [&](const auto& dofs, const std::vector<std::size_t>& places) {
    return std::count_if(places.begin(), places.end(), [&](std::size_t i) { return acts(dofs[i], state); });
  };
  const bool too_much =
      directions.size() + count(prescribed_dofs_, group.driven) + count(constrained_dofs_, group.held) > 3;
  for (const std::size_t d : group.driven) {
    PrescribedDof& driven = prescribed_dofs_[d];
    if (!acts(driven, state)) continue;
    const double speed = wanted(driven, state, velocity_interval, bodies);
    add_direction(driven.axis, speed, too_much && driven.constrain_others, &driven, &motion_[driven.reaction]);
  }
  for (const std::size_t h : group.held) {
    ConstrainedDof& held = constrained_dofs_[h];
    if (!acts(held, state)) continue;
    held.active = true;
    add_direction(held.axis, 0.0, too_much, &held, &spc_[held.reaction]);
  }

  const int n = directions.size();
  const auto node = at(group.node);
  Row& row = group.rotation ? state.w[node] : state.v[node];
  Row& load_row = group.rotation ? state.m[node] : state.f[node];
  const Vec3d free_velocity = vec(row), load = vec(load_row);
  bool massless = false;
  if (body && group.rotation) {
    if (std::any_of(met.begin(), met.begin() + n, [](const Met& m) { return m.dof; }))
      directions.drive_spin(*body, state);
  } else {
    const double mass = body ? body->mass : (group.rotation ? system_.inertia[node] : system_.mass[node]);
    massless = !body && !(mass > 0.0);
    for (int k = 0; k < n; ++k) {
      const Vec3d& direction = directions.unit(k);
      const double change = directions.speed(k) - dot(direction, free_velocity);
      add(row, change * direction);
      // A node without mass, as the end of a spring may be, feels what pulls at it and nothing else.
      const double impulse = massless ? -dot(direction, load) : mass * change;
      directions.set_impulse(k, impulse);
      if (massless) add(load_row, impulse * direction);
    }
  }
  directions.share_out();
  const Vec3d velocity = vec(row);
  bool counted = false;
  for (int j = n - 1; j >= 0; --j) {
    const Met& m = met[at(j)];
    if (!m.dof) continue;
    ConstrainedDof& dof = *m.dof;
    const double impulse = directions.impulse(j);
    dof.force = massless ? impulse : velocity_interval > 0.0 ? impulse / velocity_interval : 0.0;
    (dof.rotation ? m.reaction->moment : m.reaction->force) += dof.force * dof.axis;
    m.reaction->energy += 0.5 * dof.force * dof.velocity * state.dt_previous;
    if (!counted) m.reaction->power += dot(velocity - free_velocity, load);
    counted = true;
    dof.before = dof.velocity;
    dof.velocity = dot(dof.axis, velocity);
  }
  const auto pass = [&](ConstrainedDof& dof, bool is_in_force) {
    if (!is_in_force) return release(dof, state);
    if (std::any_of(met.begin(), met.begin() + n, [&](const Met& m) { return m.dof == &dof; })) return;
    dof.force = 0.0;
    dof.before = dof.velocity;
    dof.velocity = dot(dof.axis, velocity);
  };
  for (const std::size_t d : group.driven) pass(prescribed_dofs_[d], acts(prescribed_dofs_[d], state));
  for (const std::size_t h : group.held) pass(constrained_dofs_[h], acts(constrained_dofs_[h], state));
}

void Supports::prescribe(system::State& state, double velocity_interval, std::span<system::RigidBody> bodies) {
  dt_previous_ = state.dt_previous;
  velocity_interval_ = velocity_interval;
  for (std::vector<Reaction>* reactions : {&spc_, &motion_})
    for (Reaction& r : *reactions) {
      r.force = r.moment = {};
      r.power = 0.0;
    }
  for (ConstrainedDof& h : constrained_dofs_) {
    if (h.together || !meets(h)) continue;
    if (!acts(h, state)) {
      release(h, state);
      continue;
    }
    // What moved before it was held gives up its energy; at time 0 it stands still already (constrain_at_start).
    h.active = true;
    set_component(h, 0.0, nullptr, state, velocity_interval, spc_);
  }
  for (PrescribedDof& d : prescribed_dofs_) {
    if (d.together || !meets(d)) continue;
    if (!acts(d, state)) {
      release(d, state);
      continue;
    }
    if (d.motion->circular) {
      const model::PlaceOnCircle place = model::place_on_circle(*d.motion, vec(state.x[d.node]));
      if (place.radius == 0.0 && !d.motion->radius_fixed) {
        release(d, state);  // on the axis, where there is no way around it
        continue;
      }
      d.axis = d.constrain_others ? place.outwards : place.around;
      d.velocity = dot(d.axis, d.left);
    }
    const double velocity = wanted(d, state, velocity_interval, bodies);
    set_component(d, velocity, d.body >= 0 ? &bodies[d.body] : nullptr, state, velocity_interval, motion_);
  }
  for (const Together& group : together_)
    if (system_.follows(at(group.node))) meet(group, state, velocity_interval, bodies);
  for (PrescribedDof& d : prescribed_dofs_)
    if (d.motion->circular && meets(d)) d.left = vec(state.v[d.node]);
}

std::vector<std::size_t> Supports::motions_of_body(int body, bool rotation) const {
  std::vector<std::size_t> found;
  for (std::size_t d = 0; d < prescribed_dofs_.size(); ++d)
    if (prescribed_dofs_[d].body == body && prescribed_dofs_[d].rotation == rotation) found.push_back(d);
  return found;
}

void Supports::meet_stop(std::size_t driven, double impulse, double velocity_interval, const system::State& state) {
  PrescribedDof& dof = prescribed_dofs_[driven];
  if (!meets(dof)) return;
  dof.velocity = dot(dof.axis, vec(dof.rotation ? state.w[dof.node] : state.v[dof.node]));
  add_force(dof, motion_[dof.reaction], velocity_interval > 0.0 ? impulse / velocity_interval : 0.0);
}

void Supports::add_force(ConstrainedDof& dof, Reaction& reaction, double force) {
  dof.force += force;
  (dof.rotation ? reaction.moment : reaction.force) += force * dof.axis;
  reaction.energy += 0.5 * force * dof.before * dt_previous_;
}

struct Supports::Holding {
  Directions directions;
  std::array<const OfTranslations*, 3> of{};
};

Supports::Holding Supports::holding(int node) const {
  Holding found;
  for (auto t = std::ranges::lower_bound(of_translations_, node, {}, &OfTranslations::node);
       t != of_translations_.end() && t->node == node; ++t) {
    const ConstrainedDof& dof = t->is_held ? constrained_dofs_[t->number] : prescribed_dofs_[t->number];
    if (dof.active && found.directions.add(dof.axis, 0.0)) found.of[at(found.directions.size() - 1)] = &*t;
  }
  return found;
}

contact::HeldNodes::Held Supports::held(int node) const {
  const Holding holding = Supports::holding(node);
  Held found;
  found.count = holding.directions.size();
  for (int k = 0; k < found.count; ++k) found.axes[at(k)] = holding.directions.unit(k);
  return found;
}

void Supports::take_up(int node, const Vec3d& impulse) {
  if (!(velocity_interval_ > 0.0)) return;
  Holding holding = Supports::holding(node);
  Directions& directions = holding.directions;
  for (int k = 0; k < directions.size(); ++k) directions.set_impulse(k, dot(directions.unit(k), impulse));
  directions.share_out();
  for (int k = 0; k < directions.size(); ++k) {
    const OfTranslations& t = *holding.of[at(k)];
    const double force = directions.impulse(k) / velocity_interval_;
    if (t.is_held)
      add_force(constrained_dofs_[t.number], spc_[constrained_dofs_[t.number].reaction], force);
    else
      add_force(prescribed_dofs_[t.number], motion_[prescribed_dofs_[t.number].reaction], force);
  }
}

void Supports::average_reactions(const system::State& state) {
  if (state.period <= 1) return;
  const double time = system::time_of_mean(state);
  for (std::vector<Reaction>* reactions : {&spc_, &motion_})
    for (Reaction& r : *reactions) {
      r.force = r.mean_force.add(r.force, time, state.begins_period());
      r.moment = r.mean_moment.add(r.moment, time, state.begins_period());
    }
}

void Supports::book_opening_work(double dt) {
  // Both halves together are the impulse times the mean of the velocities before and after, whatever the two steps: a
  // node that is driven from rest in half a first step gets its kinetic energy, not twice that.
  const auto open = [&](const ConstrainedDof& dof, Reaction& reaction) {
    if (!dof.active || !meets(dof)) return;
    reaction.energy += 0.25 * dof.force * ((dt + dt_previous_) * dof.velocity + (dt - dt_previous_) * dof.before);
  };
  for (const ConstrainedDof& h : constrained_dofs_) open(h, spc_[h.reaction]);
  for (const PrescribedDof& d : prescribed_dofs_) open(d, motion_[d.reaction]);
  for (std::vector<Reaction>* reactions : {&spc_, &motion_})
    for (Reaction& r : *reactions) r.step_change += 0.25 * (dt - dt_previous_) * r.power;
}

void Supports::carry(system::Carried what, const system::System::Computed& of, system::Parcel& parcel) {
  const bool whole = what == system::Carried::restart;
  const auto reported = [&of](int node) {
    return !of.share.everyone_follows(node) && of.share.answering(node) == of.rank;
  };
  system::ParcelArchive archive(parcel);
  for (std::vector<Reaction>* reactions : {&spc_, &motion_})
    for (Reaction& r : *reactions) {
      if (!reported(r.node)) continue;
      if (whole)
        archive(r);
      else  // histories of forces may be due with a balance of energies
        archive(r.force, r.moment, r.energy, r.step_change);
    }
  if (!whole) return;
  for (ConstrainedDof& h : constrained_dofs_)
    if (reported(h.node)) archive(h);
  for (PrescribedDof& d : prescribed_dofs_)
    if (reported(d.node)) archive(d);
}

void Supports::Reaction::archive(Archive& a) {
  a(force, moment, energy, mean_force, mean_moment, power, step_change);
  a.built(node, source, set_id);
}

void Supports::ConstrainedDof::archive(Archive& a) {
  a(axis, force, before, velocity, active);
  a.built(reaction, node, rotation, birth, death, control, together);
}

void Supports::PrescribedDof::archive(Archive& a) {
  ConstrainedDof::archive(a);
  a(left, rate);
  a.built(motion, body, constrain_others, at_start, oblique);
}

void Supports::archive(Archive& a) {
  a(constrained_dofs_, prescribed_dofs_, spc_, motion_, dt_previous_);
  a.built(system_, together_, of_translations_, velocity_interval_);
}

}  // namespace nugget::impact
