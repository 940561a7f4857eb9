// SPDX-License-Identifier: Apache-2.0
#include "system/system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/free_room.hpp"
#include "base/index.hpp"
#include "system/archive_by_element.hpp"
#include "system/order.hpp"
#include "system/share.hpp"
#include "system/spring_group.hpp"
#include "system/sums_by_rank.hpp"
#include "weld/tie/tie_findings.hpp"

namespace nugget::system {
namespace {

/// Nodes in a line without rotary inertia leave one direction without any: a small isotropic share keeps it solvable.
void regularize_inertia(Inertia& i) {
  const double trace = i[0] + i[3] + i[5];
  const double det =
      i[0] * (i[3] * i[5] - i[4] * i[4]) - i[1] * (i[1] * i[5] - i[2] * i[4]) + i[2] * (i[1] * i[4] - i[2] * i[3]);
  if (det > 1e-12 * trace * trace * trace) return;
  const double share = trace > 0.0 ? 1e-3 * trace : 1.0;
  i[0] += share;
  i[3] += share;
  i[5] += share;
}

/// The motion of a body whose mass is given, so that its nodes' masses say nothing of its centre: that of its nodes'
/// rigid motion, from sums over them of mass m, m v, r x m v + j w, m r, m w and the tensor. Where the nodes stand in
/// one place or on a line, their own spins determine the rest.
void fit_motion(RigidBody& body, double m, const Vec3d& linear, const Vec3d& angular, const Vec3d& first,
                const Vec3d& turning, Inertia spread, State& state) {
  Vec3d velocity, spin;
  if (m > 0.0) {
    const Vec3d middle = (1.0 / m) * first, mean = (1.0 / m) * turning;
    add_point(spread, -m, 0.0, middle);
    const double trace = spread[0] + spread[3] + spread[5], share = trace > 1e-12 * m ? 1e-6 * trace : m;
    for (std::size_t i : {0u, 3u, 5u}) spread[i] += share;
    spin = solve(spread, angular - cross(middle, linear) + share * mean);
    velocity = (1.0 / m) * linear - cross(spin, middle);
  }
  set(state.v[body.node], velocity);
  set(state.w[body.node], spin);
  body.angular_momentum = body.momentum(spin, body.axes);
}

}  // namespace

System::~System() = default;

System::System(const model::Model& m, const weld::Ties& t, Findings& findings, ElementPeriods periods,
               ElementsStart elements_start)
    : model(m),
      ties(t),
      elements_have_started_(elements_start == ElementsStart::at_once),
      periods_(std::move(periods)) {
  order_nodes();
  make_groups(findings);
  make_constraints(findings);
  link_slots();
  if (periods_.on()) subcycles_ = Subcycles(*this);
  assemble_mass();
  find_scaled_elements();
  transfer_dependent_mass();
  make_bodies();
  check_springs(*this, findings);
  free_room(start_);
}

void System::order_nodes() {
  nodes = model.nodes.size();
  const std::vector<int> order = morton_order(ties.x);
  node_of.resize(nodes);
  model_node.resize(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    model_node[i] = order[i];
    node_of[order[i]] = static_cast<int>(i);
  }
}

void System::make_constraints(Findings& findings) {
  using Kind = ConstraintSource::Kind;
  constraint_source_.assign(nodes, {});
  const auto claim = [&](model::Index node, const ConstraintSource& who, const Place& place) {
    ConstraintSource& held = constraint_source_[node_of[node]];
    if (!held.none()) {
      findings.error(
          place, "",
          fmt::format("node {} is made dependent twice: by {} and by {}", model.nodes.id[node], name(held), name(who)),
          "a node may follow only one rigid body or tie: remove it from one of them");
      return false;
    }
    held = who;
    return true;
  };
  body_of.assign(model.rigid_bodies.size(), -1);
  for (std::size_t b = 0; b < model.rigid_bodies.size(); ++b) {
    const model::RigidBody& source = model.rigid_bodies[b];
    RigidBody body;
    body.source = static_cast<model::Index>(b);
    body.id = source.id;
    body.title = source.title;
    body.node = static_cast<int>(nodes + bodies.size());
    body.fixed = source.fixed;
    body.fixed_axes = source.fixed_axes;
    body.axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    body_of[b] = static_cast<int>(bodies.size());
    for (model::Index n : source.nodes) {
      if (!claim(n, {Kind::body, static_cast<model::Index>(b)}, source.place)) continue;
      // Arms hold the node's position until the centre is known; see make_bodies.
      const ConstraintMap::Term term{body.node, 1.0, ties.x[n]};
      map.add(node_of[n], true, {&term, 1});
    }
    bodies.push_back(std::move(body));
  }
  for (std::size_t t = 0; t < ties.ties.size(); ++t) {
    const weld::Tie& tie = ties.ties[t];
    const model::Contact& contact = model.contacts[tie.contact];
    const Vec3d gap = ties.x[tie.node] - tie.point;
    // With TIEDPRJ = 1 or an offset the node keeps its gap, which then turns with the segment.
    const bool projected = dot(gap, gap) <= 1e-24 * (1.0 + dot(tie.point, tie.point));
    if (tie.spring) {
      const int anchor = static_cast<int>(nodes + bodies.size() + springs.size());
      springs.push_back({t, node_of[tie.node], anchor});
      add_tie(anchor, tie, projected || !tie.lever ? Vec3d{} : gap, true);
    } else if (claim(tie.node, {Kind::contact, tie.contact}, contact.place)) {
      add_tie(node_of[tie.node], tie, projected || !tie.lever ? Vec3d{} : gap, tie.rotations);
    }
  }
  for (std::size_t k = 0; k < model.interpolations.size(); ++k) {
    const model::Interpolation& i = model.interpolations[k];
    if (claim(i.node, {Kind::interpolation, static_cast<model::Index>(k)}, i.place))
      add_best_fit(node_of[i.node], i.rotations, i.independent, i.weight, ties.x[i.node]);
  }
  const auto body_at = [&](model::Index n) {
    const ConstraintSource& held = constraint_source_[node_of[n]];
    return held.kind == Kind::body ? held.index : model::none;
  };
  for (std::size_t k = 0; k < model.hanging_nodes.size(); ++k) {
    const model::HangingNode& h = model.hanging_nodes[k];
    const model::Index body = body_at(h.node);
    // A side that is rigid as a whole asks of its nodes what their body does.
    if (body != model::none && body == body_at(h.ends[0]) && body == body_at(h.ends[1])) continue;
    if (!claim(h.node, {Kind::side, static_cast<model::Index>(k)}, h.place)) continue;
    // Off the line between the ends the arm turns with them, so that the node keeps to any rigid motion.
    const Vec3d a = ties.x[h.ends[0]], along = ties.x[h.ends[1]] - a, off = ties.x[h.node] - a;
    const double share = dot(off, along) / dot(along, along);
    const Vec3d arm = off - share * along;
    const std::array<ConstraintMap::Term, 2> terms{
        {{node_of[h.ends[0]], 1.0 - share, arm}, {node_of[h.ends[1]], share, arm}}};
    map.add(node_of[h.node], true, terms);
  }
  for (std::size_t k = 0; k < model.tied_nodes.size(); ++k) {
    const model::TiedNodes& tied = model.tied_nodes[k];
    const ConstraintMap::Term first{node_of[tied.nodes.front()], 1.0, {}};
    for (const model::Index n : tied.nodes)
      if (claim(n, {Kind::tied, static_cast<model::Index>(k)}, tied.place) && n != tied.nodes.front())
        map.add(node_of[n], true, {&first, 1});
  }
  for (const model::LinearConstraint& equation : model.linear_constraints)
    for (const model::LinearConstraint::Term& term : equation.terms)
      if (const ConstraintSource& held = constraint_source_[node_of[term.node]]; !held.none())
        findings.error(equation.place, equation.keyword,
                       fmt::format("node {} of equation {} moves with {}, and an equation cannot move it",
                                   model.nodes.id[term.node], equation.id, name(held)),
                       "take nodes that follow neither a rigid body nor a tie");
  for (int node : map.sort_rows(static_cast<int>(all_nodes())))
    findings.error({model.deck, 0, 0}, "", fmt::format("node {} is tied to itself through other ties", node_id(node)),
                   "tie the weld to a sheet whose nodes are free");
}

void System::add_best_fit(int dependent, bool rotations, std::span<const model::Index> independent,
                          std::span<const double> weights, const Vec3d& place) {
  std::vector<ConstraintMap::Term> terms;
  std::vector<ConstraintMap::Corner> corners;
  Vec3d centre;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const Vec3d x = ties.x[independent[k]];
    const int node = node_of[independent[k]];
    terms.push_back({node, weights[k], {}});
    corners.push_back({node, weights[k], x});
    centre += weights[k] * x;
  }
  map.add(dependent, rotations, terms, ConstraintMap::Turn::whole, corners, place - centre);
}

void System::add_tie(int dependent, const weld::Tie& tie, const Vec3d& arm, bool rotations) {
  if (tie.rigid_body != model::none) {
    // Arms hold the position until the centre is known; see make_bodies.
    const ConstraintMap::Term term{bodies[body_of[tie.rigid_body]].node, 1.0, tie.point + arm};
    map.add(dependent, true, {&term, 1});
    return;
  }
  if (tie.by_area()) {
    add_best_fit(dependent, rotations, tie.disc.nodes, tie.disc.weights, tie.point + arm);
    return;
  }
  const std::size_t corners = tie.segment[3] == tie.segment[2] ? 3 : 4;
  std::vector<ConstraintMap::Term> terms;
  for (std::size_t i = 0; i < corners; ++i)
    if (tie.weight[i] != 0.0)
      terms.push_back({node_of[tie.segment[i]], tie.weight[i],
                       tie.couples ? Vec3d{} : weld::arm_from(tie, ties.x[tie.segment[i]], arm)});
  if (!tie.couples && !tie.twist) {
    map.add(dependent, rotations, terms);
    return;
  }
  std::vector<ConstraintMap::Corner> around;
  for (std::size_t i = 0; i < corners; ++i) around.push_back({node_of[tie.segment[i]], 1.0, ties.x[tie.segment[i]]});
  if (tie.couples)
    map.add(dependent, rotations, terms, ConstraintMap::Turn::whole, around, arm);
  else
    map.add(dependent, rotations, terms, ConstraintMap::Turn::twist, around);
}

std::string System::name(const ConstraintSource& constraint_name) const {
  const model::Index i = constraint_name.index;
  switch (constraint_name.kind) {
    case ConstraintSource::Kind::body: return weld::name_body(model.rigid_bodies[i]);
    case ConstraintSource::Kind::contact: return weld::name_contact(model.contacts[i]);
    case ConstraintSource::Kind::interpolation:
      return fmt::format("*CONSTRAINED_INTERPOLATION {}", model.interpolations[i].id);
    case ConstraintSource::Kind::side: return "the side of a shell (*CONSTRAINED_ADAPTIVITY)";
    case ConstraintSource::Kind::tied:
      return fmt::format("*CONSTRAINED_TIED_NODES_FAILURE of set {}", model.tied_nodes[i].set);
    case ConstraintSource::Kind::none: break;
  }
  return "nothing";
}

void System::release(std::size_t tie) {
  const int node = node_of[ties.ties[tie].node];
  if (map.dependent(node)) map.remove(node);
}

void System::part_tied_nodes(std::span<const int> staying, std::span<const int> leaving) {
  const auto free = [this](int node) {
    if (map.dependent(node)) map.remove(node);
  };
  std::ranges::for_each(leaving, free);
  if (staying.empty()) return;
  // The first that stays leads: no row is about it, so the order of rows holds.
  free(staying.front());
  if (staying.size() == 1) return;
  for (const int node : staying.subspan(1)) map.terms(node).front().node = staying.front();
}

void System::set_disc_weights(std::size_t tie, std::span<const double> weights) {
  int dependent = node_of[ties.ties[tie].node];
  for (const TieSpring& spring : springs)
    if (spring.tie == tie) dependent = spring.anchor;
  map.set_weights(dependent, weights);
}

void System::make_bodies() {
  const auto body_at = [&](int node) -> RigidBody& { return bodies[at(node) - nodes]; };
  std::vector<double> mass_sum(bodies.size(), 0.0);
  std::vector<Vec3d> moment(bodies.size()), middle(bodies.size());
  std::vector<int> count(bodies.size(), 0);
  const auto each_term = [&](auto&& visit) {
    for (std::size_t d = 0; d < all_nodes(); ++d) {
      if (!map.dependent(static_cast<int>(d))) continue;
      for (ConstraintMap::Term& t : map.terms(static_cast<int>(d)))
        if (at(t.node) >= nodes) visit(d, t);
    }
  };
  each_term([&](std::size_t d, ConstraintMap::Term& t) {
    const std::size_t b = at(t.node) - nodes;
    mass_sum[b] += t.weight * carried_mass_[d];
    moment[b] += (t.weight * carried_mass_[d]) * t.arm;
    if (d >= nodes) return;  // an anchor of a spring
    middle[b] += t.arm;
    ++count[b];
  });
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const model::RigidBody& source = model.rigid_bodies[bodies[b].source];
    bodies[b].mass = source.given ? source.inertia.mass : mass_sum[b];
    bodies[b].center0 = source.given        ? source.inertia.center
                        : mass_sum[b] > 0.0 ? (1.0 / mass_sum[b]) * moment[b]
                        : count[b] > 0      ? (1.0 / count[b]) * middle[b]
                                            : Vec3d{};
  }
  each_term([&](std::size_t d, ConstraintMap::Term& t) {
    RigidBody& body = body_at(t.node);
    t.arm -= body.center0;
    add_point(body.inertia, t.weight * carried_mass_[d], t.weight * carried_inertia_[d], t.arm);
  });
  // Nodes carry the mean of a point's moments of inertia; a body takes the whole tensor.
  for (const model::PointInertia& p : model.inertias) {
    const int node = node_of[p.node];
    if (!map.dependent(node) || at(map.terms(node).front().node) < nodes) continue;
    Inertia& tensor = body_at(map.terms(node).front().node).inertia;
    const double mean = (p.inertia[0] + p.inertia[3] + p.inertia[5]) / 3.0;
    for (std::size_t i = 0; i < 6; ++i) tensor[i] += p.inertia[i] - (i == 0 || i == 3 || i == 5 ? mean : 0.0);
  }
  for (RigidBody& body : bodies) {
    const model::RigidBody& source = model.rigid_bodies[body.source];
    if (source.given) body.inertia = source.inertia.inertia;
    regularize_inertia(body.inertia);
  }
}

void System::release_nodes(std::size_t b, std::span<const int> released, std::span<const int> kept, State& state) {
  RigidBody& body = bodies[b];
  const auto c = at(body.node);
  Vec3d momentum = body.mass * vec(state.v[c]);
  for (const int d : released) {
    map.remove(d);
    momentum -= own_mass[d] * vec(state.v[d]);
  }
  transfer_dependent_mass();
  body.axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  body.mass = 0.0;
  body.inertia = {};
  body.angular_momentum = {};
  state.f[c] = state.m[c] = Row{};
  if (kept.empty()) {
    state.v[c] = state.w[c] = Row{};
    return;
  }
  Vec3d moment;
  for (const int d : kept) {
    body.mass += own_mass[d];
    moment += own_mass[d] * map.terms(d).front().arm;
  }
  const Vec3d shift = (1.0 / body.mass) * moment;
  for (const int d : kept) {
    Vec3d& arm = map.terms(d).front().arm;
    arm -= shift;
    add_point(body.inertia, own_mass[d], own_inertia_[d], arm);
    add(state.f[c], vec(state.f[d]));
    add(state.m[c], vec(state.m[d]) + cross(arm, vec(state.f[d])));
    state.f[d] = state.m[d] = Row{};
  }
  regularize_inertia(body.inertia);
  add(state.x[c], shift);
  set(state.v[c], (1.0 / body.mass) * momentum);
  body.angular_momentum = body.momentum(vec(state.w[c]), body.axes);
}

void System::forget_start(model::Model& m) {
  free_room(m.initial_velocity);
  free_room(m.initial_spin);
  for (std::vector<model::Index>* named : {&m.named_nodes, &m.named_shells, &m.listed_nodes, &m.listed_shells})
    free_room(*named);  // for those who move nodes and merge shells
  m.shells.place = m.solids.place = m.beams.place = model::Places();
  free_room(carried_mass_);
  free_room(carried_inertia_);
  // The second time, when all is made: for messages of a deck that is refused.
  if (start_is_forgotten_) free_room(constraint_source_);
  start_is_forgotten_ = true;
}

State System::initial_state() {
  if (start_is_forgotten_) throw std::logic_error("the state at time 0 is asked for after it was set free");
  State state;
  for (const model::SensorControl& control : model.sensor_controls) state.controls.push_back({control.starts_on, 0.0});
  const std::size_t n = all_nodes();
  state.x.resize(n);
  state.v.resize(n);
  state.w.resize(n);
  state.f.resize(n);
  state.m.resize(n);
  for (std::size_t i = 0; i < nodes; ++i) {
    const std::size_t k = at(model_node[i]);
    set(state.x[i], ties.x[k]);
    if (!model.initial_velocity.empty()) set(state.v[i], model.initial_velocity[k]);
    if (!model.initial_spin.empty()) set(state.w[i], model.initial_spin[k]);
  }
  // Nodes that are tied until the mesh tears start with the momentum of all of them.
  for (const model::TiedNodes& tied : model.tied_nodes) {
    Vec3d momentum, angular_momentum;
    double sum_of_masses = 0.0, sum_of_inertias = 0.0;
    for (const model::Index node : tied.nodes) {
      const std::size_t k = at(node_of[node]);
      momentum += own_mass[k] * vec(state.v[k]);
      angular_momentum += own_inertia_[k] * vec(state.w[k]);
      sum_of_masses += own_mass[k];
      sum_of_inertias += own_inertia_[k];
    }
    const std::size_t first = at(node_of[tied.nodes.front()]);
    if (sum_of_masses > 0.0) set(state.v[first], (1.0 / sum_of_masses) * momentum);
    if (sum_of_inertias > 0.0) set(state.w[first], (1.0 / sum_of_inertias) * angular_momentum);
  }
  // A body starts with the momentum of its nodes.
  std::vector<Vec3d> linear(bodies.size()), angular(bodies.size()), first(bodies.size()), turning(bodies.size());
  std::vector<double> sum(bodies.size(), 0.0);
  std::vector<Inertia> spread(bodies.size());
  for (std::size_t d = 0; d < nodes; ++d) {
    if (!map.dependent(static_cast<int>(d))) continue;
    for (const ConstraintMap::Term& t : map.terms(static_cast<int>(d))) {
      if (at(t.node) < nodes) continue;
      const std::size_t b = at(t.node) - nodes;
      const double m = std::max(t.weight * carried_mass_[d], 1e-30);
      sum[b] += m;
      linear[b] += m * vec(state.v[d]);
      angular[b] += m * cross(t.arm, vec(state.v[d])) + (t.weight * carried_inertia_[d]) * vec(state.w[d]);
      add_point(spread[b], m, t.weight * carried_inertia_[d], t.arm);
      first[b] += m * t.arm;
      turning[b] += m * vec(state.w[d]);
    }
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    RigidBody& body = bodies[b];
    const std::size_t k = at(body.node);
    set(state.x[k], body.center0);
    if (model.rigid_bodies[body.source].given) {
      fit_motion(body, sum[b], linear[b], angular[b], first[b], turning[b], spread[b], state);
      continue;
    }
    const Vec3d velocity = sum[b] > 0.0 ? (1.0 / sum[b]) * linear[b] : Vec3d{};
    RigidBody nodal = body;
    const Inertia& own = spread[b];
    const double trace = own[0] + own[3] + own[5];
    nodal.inertia = own;
    for (std::size_t i : {0u, 3u, 5u}) nodal.inertia[i] += 1e-12 * trace + 1e-300;
    const Vec3d spin = trace > 0.0 ? nodal.spin(angular[b], body.axes) : Vec3d{};
    set(state.v[k], velocity);
    set(state.w[k], spin);
    body.angular_momentum = body.momentum(spin, body.axes);
  }
  // A step of no length and no force takes out the velocities that a body is held against.
  for (RigidBody& body : bodies)
    if (body.fixed != 0) body.advance(0.0, 0.0, state);
  for (const TieSpring& s : springs) {
    const weld::Tie& tie = ties.ties[s.tie];
    set(state.x[s.anchor], tie.lever ? ties.x[tie.node] : tie.point);
  }
  map.apply_to_velocities(0.0, state.v, state.w);
  for (Rows* rows : {&state.v, &state.w}) forget_zeros(*rows);  // dependent nodes that do not turn
  return state;
}

void System::start_elements() {
  if (elements_have_started_) return;
  elements_have_started_ = true;
  const auto place = [this](int node) { return ties.x[model_node[node]]; };
  for (const auto& group : groups) group->start(place, [](std::size_t) { return true; });
}

void System::compute_at_rest() {
  State rest = initial_state();
  rest.dt = 0.0;
  std::fill(rest.v.begin(), rest.v.end(), Row{});
  std::fill(rest.w.begin(), rest.w.end(), Row{});
  internal_force(rest);
  scale_mass(true);
}

System::Controlling System::controlling() const {
  Controlling c;
  c.step = std::numeric_limits<double>::infinity();
  std::size_t block = 0;
  const auto look_at = [&](std::size_t g, std::size_t b) {
    const ElementGroup& group = *groups[g];
    const double step = group.step_share * group.damped_step(group.block_step[b]) / group.period;
    if (!(step >= c.step)) {  // a NaN comes through, and stays
      c.step = step;
      c.group = static_cast<int>(g);
      block = b;
    }
  };
  const auto is_number = [&] { return c.step == c.step; };
  for (std::size_t i = 0; i < computed_.size() && is_number(); ++i)
    look_at(at(computed_[i].first), computed_[i].second);
  for (std::size_t g = 0; !share_ && g < groups.size(); ++g)
    for (std::size_t b = 0; b < groups[g]->block_step.size() && is_number(); ++b) look_at(g, b);
  if (c.group < 0) return c;
  const ElementGroup& group = *groups[c.group];
  const std::size_t width = group.block_width();
  for (std::size_t e = block * width; e < std::min(group.size(), (block + 1) * width); ++e) {
    // By the step that was looked for: rounding may make those of two elements equal, and then it is the first one's,
    // however many elements a block has.
    if (!(group.step_share * group.damped_step(group.stable_step(e)) / group.period > c.step))
      c.element = static_cast<int>(e);
    if (c.element >= 0) break;
  }
  return c;
}

std::string System::Controlling::describe(const System& s) const {
  if (group < 0) return "nothing";
  const ElementGroup& g = *s.groups[group];
  const model::Index e = element >= 0 ? g.element[element] : model::none;
  return fmt::format("{} {} of part {}", s.kind_name(g), e == model::none ? 0 : s.element_id(g, e),
                     s.model.parts[g.part].id);
}

std::string_view System::kind_name(const ElementGroup& group) const {
  switch (group.kind) {
    case model::ElementKind::shell: return "shell";
    case model::ElementKind::solid: return model.has_thick_shells(group.part) ? "thick shell" : "solid";
    case model::ElementKind::beam: return "beam";
    case model::ElementKind::discrete: return "spring";
    case model::ElementKind::nothing: break;
  }
  return "element";
}

int System::element_id(const ElementGroup& group, model::Index e) const {
  switch (group.kind) {
    case model::ElementKind::shell: return model.shells.id[e];
    case model::ElementKind::solid: return model.solids.id[e];
    case model::ElementKind::beam: return model.beams.id[e];
    case model::ElementKind::discrete: return model.discretes[e].id;
    case model::ElementKind::nothing: break;
  }
  return 0;
}

int System::rigid_body_of_node(int node) const {
  if (!map.dependent(node)) return -1;
  const std::size_t leader = at(map.terms(node).front().node);
  return leader >= nodes && leader - nodes < bodies.size() ? static_cast<int>(leader - nodes) : -1;
}

void System::archive(Archive& a) {
  a.section("system");
  a(mass, own_mass, own_inertia_, map, bodies, subcycles_);
  a.parts(inertia, {holders_of_nodes().giver, {}});  // the first rank sums up energies of nodes of others
  a.built(groups, slots_, single_slots_);            // a group's slots behind its states
  a.built(model, ties, brick_joints, weld_stacks, nodes, node_of, model_node, body_of, springs, shell_location,
          solid_location, beam_location, discrete_location, start_, start_is_forgotten_, elements_have_started_,
          carried_mass_, carried_inertia_, linked_nodes_, changed_mass_, scaled_elements_, mass_only_elements_,
          constraint_source_, damping_slots, sums_, blocks_, periods_, share_, sums_by_rank_, computed_, deleted_,
          deletions_seen_, steps_of_others_, reported_below, mass_changes_, masses_, masses_are_of_);
  a.section("elements");
  for (const auto& group : groups) {
    a(*group);
    const auto archive_slots = [&](auto& slots, std::size_t first) {
      archive_by_element(a, std::span(slots.data() + slots.place(first), 3 * group->slot_count()),
                         3 * group->rows_of_element(), group->slot_lanes(), group->holders);
    };
    if (group->single_precision())
      archive_slots(single_slots_, group->first_slot - slots_.size());
    else
      archive_slots(slots_, group->first_slot);
  }
  if (!a.reading()) return;
  ++mass_changes_;
  linked_nodes_.clear();
  find_scaled_elements();
  take_share_of_what_was_read();
}

}  // namespace nugget::system
