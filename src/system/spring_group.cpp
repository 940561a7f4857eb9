// SPDX-License-Identifier: Apache-2.0
#include "system/spring_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/index.hpp"
#include "system/mobility.hpp"

namespace nugget::system {

SpringGroup::SpringGroup(const model::Model& model, model::Index p, std::vector<model::Index> chosen,
                         const std::vector<int>& node_of, const std::vector<Vec3d>& x)
    : section_(model.discrete_sections[model.parts[p].section]),
      law_(std::get<kernel::Spring>(model.materials[model.parts[p].material].law)),
      model_(model) {
  kind = model::ElementKind::discrete;
  part = p;
  element = std::move(chosen);
  rotational = section_.torsional;
  nodes_per_element = model.discretes[element.front()].grounded() ? 1 : 2;
  State start;
  start.x.resize(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) set(start.x[k], x[k]);
  for (const model::Index e : element) {
    Entry s;
    s.source = &model.discretes[e];
    s.node[0] = node_of[s.source->node[0]];
    if (!s.source->grounded()) s.node[1] = node_of[s.source->node[1]];
    s.ground = x[s.node[0]];
    if (s.source->orientation != model::none)
      for (const std::size_t i : {0u, 1u})
        if (const model::Index n = model.spring_orientations[s.source->orientation].node[i]; n != model::none)
          s.direction[i] = node_of[n];
    s.state = law_.start();
    s.line = line_of(s, start, s.length);
    s.step = std::numeric_limits<double>::infinity();
    springs_.push_back(std::move(s));
  }
}

Vec3d SpringGroup::span(const Entry& s, const State& state) const {
  return (s.node[1] < 0 ? s.ground : vec(state.x[s.node[1]])) - vec(state.x[s.node[0]]);
}

Vec3d SpringGroup::line_of(const Entry& s, const State& state, double& length) const {
  const Vec3d span = this->span(s, state);
  const auto along = [&](const Vec3d& v) {
    length = norm(v);
    return length > 0.0 ? (1.0 / length) * v : s.line;
  };
  if (s.source->orientation == model::none) return along(span);
  const model::SpringOrientation& o = model_.spring_orientations[s.source->orientation];
  Vec3d direction = o.direction;
  if (s.direction[0] >= 0) direction = unit(vec(state.x[s.direction[1]]) - vec(state.x[s.direction[0]]));
  if (o.in_plane) return along(span - dot(span, direction) * direction);
  length = dot(span, direction);
  return direction;
}

void SpringGroup::cycle(std::size_t begin, std::size_t end, const State& state, double dt, Slots& slots,
                        Slots& damping) {
  for (std::size_t b = begin; b < end; ++b) {
    for (std::size_t e = b * width; e < std::min(size(), (b + 1) * width); ++e) {
      Entry& s = springs_[e];
      const bool lived = s.alive;
      if (s.alive) advance(s, state, dt);
      if (lived && !s.alive) ++deletions;
      // The slot's force is the internal one: on the node itself acts the opposite.
      const Vec3d pull = s.alive && !s.cancelled ? -s.force * s.line : Vec3d{};
      double work = 0.0;
      for (int a = 0; a < nodes_per_element; ++a) {
        const std::size_t place = rotational ? moment_slot(e, a) : slot(e, a);
        const Vec3d now = a == 0 ? pull : -pull;
        work += dot(slots[place] + now, vec((rotational ? state.w : state.v)[s.node[a]]));
        slots.set(place, now);
      }
      s.energy += 0.5 * dt * work;
      if (damped()) damp(e, state, damping);
    }
    find_block_step(b);
  }
}

void SpringGroup::find_block_step(std::size_t b) {
  block_step[b] = std::numeric_limits<double>::infinity();
  for (std::size_t e = b * width; e < std::min(size(), (b + 1) * width); ++e)
    if (springs_[e].alive) block_step[b] = std::min(block_step[b], springs_[e].step);
}

void SpringGroup::advance(Entry& s, const State& state, double dt) {
  double length = 0.0;
  s.line = line_of(s, state, length);
  const auto rate = [&](const Rows& of) {
    const Vec3d second = s.node[1] < 0 ? Vec3d{} : vec(of[s.node[1]]);
    return dot(second - vec(of[s.node[0]]), s.line);
  };
  double velocity = rate(section_.torsional ? state.w : state.v);
  if (section_.torsional)
    s.elongation += dt * velocity;
  else
    s.elongation = length - s.length + s.source->offset;
  if (!s.started && section_.torsional) s.elongation = s.source->offset;

  double pressed = s.elongation;
  if (section_.clearance > 0.0) {
    pressed = std::min(0.0, s.elongation + section_.clearance);
    if (pressed == 0.0) velocity = 0.0;
  }
  const double increment = pressed - s.pressed;
  s.pressed = pressed;
  const double magnified = 1.0 + section_.magnification * std::abs(velocity);
  s.force = s.source->scale * magnified * law_.advance(s.state, increment, velocity, dt);
  if (section_.clearance > 0.0 && pressed == 0.0) s.force = 0.0;
  // What the offset at time 0 has stored; later work comes from the nodes.
  if (!s.started) s.energy += 0.5 * s.force * increment;
  s.started = true;
  const double limit = section_.failure;
  if ((limit > 0.0 && s.elongation > limit) || (limit < 0.0 && s.elongation < limit)) {
    s.alive = false;
    s.force = 0.0;
  }
  s.step = stable_step_of(s);
}

double SpringGroup::greatest_stiffness(std::size_t e) const {
  return std::abs(springs_[e].source->scale) * law_.greatest_stiffness();
}

double SpringGroup::greatest_viscosity(std::size_t e, double force) const {
  return std::abs(springs_[e].source->scale) * law_.greatest_viscosity(force) +
         section_.magnification * std::abs(force);
}

double SpringGroup::stable_step_of(const Entry& s) const {
  const auto e = static_cast<std::size_t>(&s - springs_.data());
  const double a = 0.5 * (s.inverse_mass * greatest_viscosity(e, s.force) + s.viscosity_rate);
  const double fastest = a + std::sqrt(a * a + s.stiffness_rate);
  return fastest > 0.0 ? 2.0 / fastest : std::numeric_limits<double>::infinity();
}

void SpringGroup::set_bound(std::size_t e, double inverse_mass, double stiffness_rate, double viscosity_rate) {
  Entry& s = springs_[e];
  s.inverse_mass = inverse_mass;
  s.stiffness_rate = stiffness_rate;
  s.viscosity_rate = viscosity_rate;
  s.step = stable_step_of(s);
  if (block_step.empty()) return;
  double& smallest = block_step[e / width];
  if (s.alive) smallest = std::min(smallest, s.step);
}

double SpringGroup::pressed_at_start(const Entry& s) const {
  const double elongation = s.source->offset;
  return section_.clearance > 0.0 ? std::min(0.0, elongation + section_.clearance) : elongation;
}

bool SpringGroup::slack_at_start(const Entry& s) const {
  const double elongation = s.source->offset, limit = section_.failure;
  const bool deleted = (limit > 0.0 && elongation > limit) || (limit < 0.0 && elongation < limit);
  return deleted || (section_.clearance > 0.0 && elongation + section_.clearance > 0.0);
}

void SpringGroup::own_stiffness(std::size_t e, const State&, std::span<double> k) const {
  const Entry& s = springs_[e];
  along_line(e, slack_at_start(s) ? 0.0 : law_.stiffness_at(pressed_at_start(s)), k);
}

bool SpringGroup::force_at_start(std::size_t e, const State&, std::span<double> f) const {
  const Entry& s = springs_[e];
  kernel::Spring::State state = law_.start();
  const double force = slack_at_start(s) ? 0.0 : s.source->scale * law_.advance(state, pressed_at_start(s), 0.0, 0.0);
  if (force == 0.0) return false;
  std::fill(f.begin(), f.end(), 0.0);
  const std::array<double, 3> n{s.line.x, s.line.y, s.line.z};
  const std::size_t per_node = at(freedoms()), first = rotational ? 3 : 0;
  for (std::size_t a = 0; a < at_each_node(); ++a)
    for (std::size_t i = 0; i < 3; ++i) f[a * per_node + first + i] = (a == 0 ? -force : force) * n[i];
  return true;
}

bool SpringGroup::viscosity(std::size_t e, const State&, std::span<double> c) const {
  const double viscosity = law_.initial_viscosity();
  if (viscosity == 0.0) return false;
  along_line(e, viscosity, c);
  return true;
}

void SpringGroup::along_line(std::size_t e, double modulus, std::span<double> k) const {
  std::fill(k.begin(), k.end(), 0.0);
  const Entry& s = springs_[e];
  const double scaled = s.source->scale * modulus;
  const std::array<double, 3> n{s.line.x, s.line.y, s.line.z};
  const std::size_t per_node = at(freedoms()), first = rotational ? 3 : 0, size = at_each_node() * per_node;
  for (std::size_t a = 0; a < at_each_node(); ++a)
    for (std::size_t b = 0; b < at_each_node(); ++b)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          k[(a * per_node + first + i) * size + b * per_node + first + j] = (a == b ? scaled : -scaled) * n[i] * n[j];
}

void SpringGroup::damp(std::size_t e, const State& state, Slots& slots) const {
  const Rows& of = rotational ? state.w : state.v;
  const Entry& s = springs_[e];
  Vec3d pull{};
  if (s.alive && !s.cancelled && std::isfinite(s.step)) {  // not before its bound is known, nor where all is held
    const Vec3d second = s.node[1] < 0 ? Vec3d{} : vec(of[s.node[1]]);
    const double k = s.source->scale * law_.initial_stiffness();
    pull = (damping_time_at(s.step) * k * dot(second - vec(of[s.node[0]]), s.line)) * s.line;
  }
  for (int a = 0; a < nodes_per_element; ++a)
    slots.set(rotational ? moment_slot(e, a) : slot(e, a), a == 0 ? -pull : pull);
}

ElementNodes SpringGroup::nodes(std::size_t e) const {
  ElementNodes n{};
  for (std::size_t a = 0; a < at_each_node(); ++a) n[a] = springs_[e].node[a];
  return n;
}

namespace {

/// What of a vector at a node the supports leave free between two times.
Vec3d free_of_supports(const model::Model& model, model::Index node, const Vec3d& n, bool rotation, double from,
                       double to) {
  Vec3d rest = n;
  for (const model::SinglePointConstraint& spc : model.spcs) {
    if (spc.node != node || spc.control != model::none || spc.birth > from || spc.death < to) continue;
    const unsigned bits = rotation ? spc.fixed >> 3 : spc.fixed & 7u;
    const Frame3d axes =
        spc.system == model::none ? Frame3d{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}} : model.systems[spc.system].axes;
    const Vec3d* direction[3] = {&axes.e1, &axes.e2, &axes.e3};
    for (unsigned i = 0; i < 3; ++i)
      if (bits >> i & 1u) rest -= dot(rest, *direction[i]) * *direction[i];
  }
  return rest;
}

}  // namespace

void SpringGroup::stop(State& state, std::span<const double> mass) {
  for (Entry& s : springs_) {
    if (!s.alive) continue;
    const bool pushed = section_.most_compression > 0.0 && s.elongation <= -section_.most_compression;
    const bool drawn = section_.most_elongation > 0.0 && s.elongation >= section_.most_elongation;
    if (!pushed && !drawn) continue;
    const std::size_t a = at(s.node[0]);
    const Vec3d va = vec(state.v[a]), vb = s.node[1] < 0 ? Vec3d{} : vec(state.v[s.node[1]]);
    const double opening = dot(vb - va, s.line);
    if (pushed ? opening >= 0.0 : opening <= 0.0) continue;
    // What a unit impulse along the line does to either node.
    const auto push = [&](std::size_t end) {
      const Vec3d free = free_of_supports(model_, s.source->node[end], s.line, false, state.time, state.time);
      return (1.0 / mass[s.node[end]]) * free;
    };
    const Vec3d push_a = push(0), push_b = s.node[1] < 0 ? Vec3d{} : push(1);
    const double both = dot(push_a + push_b, s.line);
    if (!(both > 0.0)) continue;
    const double impulse = opening / both;
    add(state.v[a], impulse * push_a);
    if (s.node[1] >= 0) add(state.v[s.node[1]], -impulse * push_b);
    s.energy += 0.5 * impulse * opening;
  }
}

namespace {

struct SpringEnd {
  SpringGroup* group;
  std::size_t spring;
};

/// Springs by node and kind, from the first node's end to the second's.
std::map<std::pair<int, bool>, std::vector<SpringEnd>> springs_at_nodes(const System& system) {
  std::map<std::pair<int, bool>, std::vector<SpringEnd>> at_node;
  for (const auto& group : system.groups) {
    auto* springs = dynamic_cast<SpringGroup*>(group.get());
    if (springs == nullptr) continue;
    for (std::size_t e = 0; e < springs->size(); ++e)
      for (int a = 0; a < springs->nodes_per_element; ++a)
        at_node[{springs->nodes(e)[a], springs->torsional()}].push_back({springs, e});
  }
  return at_node;
}

/// What of a vector at a node no motion is prescribed to.
Vec3d free_of_motions(const System& system, int node, const Vec3d& n, bool rotation) {
  const model::Index k = system.model_node[node];
  Vec3d rest = n;
  for (const model::PrescribedMotion& motion : system.model.motions)
    if (!motion.circular && motion.rotation == rotation &&
        std::find(motion.nodes.begin(), motion.nodes.end(), k) != motion.nodes.end())
      rest -= dot(rest, motion.direction) * motion.direction;
  return rest;
}

/// Whether supports or prescribed motion hold a direction of a node for ever.
bool is_constrained(const System& system, int node, const Vec3d& n, bool rotation) {
  const Vec3d rest = free_of_supports(system.model, system.model_node[node], n, rotation, 0.0, model::forever);
  return norm(free_of_motions(system, node, rest, rotation)) < 1e-9;
}

}  // namespace

void check_springs(const System& system, Findings& findings) {
  for (const auto& [key, ends] : springs_at_nodes(system)) {
    const auto& [node, rotation] = key;
    const Mobility m = mobility(system, node);
    for (const SpringEnd& end : ends) {
      const model::Discrete& d = system.model.discretes[end.group->element[end.spring]];
      const Vec3d n = end.group->line(end.spring);
      const int id = system.node_id(node);
      if (!(Mobility::along(rotation ? m.rotation : m.translation, n) > 0.0) &&
          !is_constrained(system, node, n, rotation))
        findings.error(d.place, "*ELEMENT_DISCRETE",
                       fmt::format("node {} of spring {} has no {}, so there is no time step for it", id, d.id,
                                   rotation ? "rotary inertia" : "mass"),
                       rotation ? "give it an *ELEMENT_INERTIA, or hold its rotations"
                                : "give it an *ELEMENT_MASS, or hold it by *BOUNDARY_SPC");
      if (end.group->has_stops() && (system.map.dependent(node) || !(system.mass[node] > 0.0)))
        findings.error(
            d.place, "*SECTION_DISCRETE",
            fmt::format("node {} of spring {}, which has a stop (CDL, TDL), follows other nodes or has no mass", id,
                        d.id),
            "use a law whose force rises steeply there");
      else if (end.group->has_stops() && norm(free_of_motions(system, node, n, false) - n) > 1e-9)
        findings.error(
            d.place, "*SECTION_DISCRETE",
            fmt::format("node {} of spring {}, which has a stop (CDL, TDL), is driven along the spring: motion "
                        "and stop would contradict each other",
                        id, d.id),
            "use a law whose force rises steeply there");
    }
  }
}

void SpringGroup::Entry::archive(Archive& a) {
  a(state, elongation, pressed, force, energy, step, line, alive, started, cancelled, inverse_mass, stiffness_rate,
    viscosity_rate);
  a.built(source, node, direction, ground, length);
}

void SpringGroup::archive(Archive& a) {
  ElementGroup::archive(a);
  a(springs_);
  a.built(section_, law_, model_);
  if (!a.reading()) return;
  for (std::size_t b = 0; b < blocks(); ++b) find_block_step(b);
}

}  // namespace nugget::system
