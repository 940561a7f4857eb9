// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/damping.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "kernel/element/c0_triangle.hpp"
#include "system/share.hpp"

namespace nugget::impact {
namespace {

constexpr std::size_t nodes_per_range = 512;
constexpr std::size_t most_rows = 2 * std::tuple_size_v<system::ElementNodes>;

/// Forces, and moments, at the nodes of an element.
Frame3d frame(const Vec3d& first, const Vec3d& second) {
  const Vec3d e1 = unit(first), e3 = unit(cross(first, second));
  return {e1, cross(e3, e1), e3};
}

/// The axes next to three directions, which all turn them alike (the rotation of a polar decomposition): neither the
/// first corner nor the hand of a numbering counts. Where the directions lie in a plane, those by the first two.
Frame3d nearest_axes(const Vec3d& first, const Vec3d& second, const Vec3d& third) {
  constexpr double flat = 0.01, converged = 1e-14;
  constexpr int most = 20;
  std::array<Vec3d, 3> e{unit(first), unit(second), unit(third)};
  if (!(std::abs(dot(e[0], cross(e[1], e[2]))) > flat)) return frame(first, second);
  for (int i = 0; i < most; ++i) {
    const double scale = 1.0 / dot(e[0], cross(e[1], e[2]));
    const std::array<Vec3d, 3> dual{scale * cross(e[1], e[2]), scale * cross(e[2], e[0]), scale * cross(e[0], e[1])};
    double change = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d step = 0.5 * (dual[k] - e[k]);
      e[k] += step;
      change = std::max(change, norm(step));
    }
    if (change < converged) break;
  }
  return {e[0], e[1], e[2]};
}

/// Axes that turn with a shell or a solid: by the directions between opposite sides.
Frame3d axes_of(const system::ElementNodes& node, std::size_t corners, const system::State& state) {
  const auto x = [&](std::size_t a) { return vec(state.x[node[a]]); };
  if (corners == 8)
    return nearest_axes(x(1) + x(2) + x(5) + x(6) - x(0) - x(3) - x(4) - x(7),
                        x(2) + x(3) + x(6) + x(7) - x(0) - x(1) - x(4) - x(5),
                        x(4) + x(5) + x(6) + x(7) - x(0) - x(1) - x(2) - x(3));
  if (corners == 4 && node[2] != node[3]) {
    const Vec3d along = x(1) + x(2) - x(0) - x(3), across = x(2) + x(3) - x(0) - x(1);
    return nearest_axes(along, across, cross(along, across));
  }
  if (corners <= 4) return kernel::triangle_frame({x(0), x(1), x(2)});
  return frame(x(1) - x(0), x(2) - x(0));
}

/// Axes that turn with a beam: about its line by the mean spin of its ends.
Frame3d axes_along(const system::ElementNodes& node, const system::State& state, double dt, bool started,
                   Vec3d& across) {
  const std::size_t i = at(node[0]), j = at(node[1]);
  const Vec3d line = unit(vec(state.x[j]) - vec(state.x[i]));
  if (started)
    across += (0.5 * dt) * cross(vec(state.w[i]) + vec(state.w[j]), across);
  else
    across = std::abs(line.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  across = unit(across - dot(across, line) * line);
  return {line, across, cross(line, across)};
}

}  // namespace

DampingFilters::DampingFilters(double share, double low, double high, Of what) : of(what) {
  // Between corners that stand in equal ratios the sum of w^2 wi / (w^2 + wi^2) is pi/2 w over the logarithm of the
  // ratio, but for the ends: the row extends beyond the range on both sides, and its last filters count for those that
  // are missing. So chosen, the force goes with w within 2 % over ranges of 1:3 to 1:100.
  constexpr double ratio = 3.5, beyond = 2.0, end_weight = 1.5;
  const double first = 2.0 * std::numbers::pi * low / beyond, last = 2.0 * std::numbers::pi * high * beyond;
  const double steps = std::max(1.0, std::ceil(std::log(last / first) / std::log(ratio)));
  const double step = std::log(last / first) / steps;
  for (int i = 0; i <= static_cast<int>(steps); ++i) corner.push_back(first * std::exp(step * i));
  weight.assign(corner.size(), 1.0);
  weight.front() = weight.back() = end_weight;
  // The mean of the share over the range, at equal ratios, is made what is wanted. What is added to mass or stiffness
  // takes a little of it, so this is repeated.
  constexpr int samples = 33;
  for (int round = 0; round < 20; ++round) {
    double mean = 0.0;
    for (int i = 0; i < samples; ++i)
      mean += share_at(2.0 * std::numbers::pi * low * std::pow(high / low, i / (samples - 1.0))) / samples;
    for (double& w : weight) w *= share / mean;
  }
}

double DampingFilters::share_at(double omega) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < corner.size(); ++i)
    sum += weight[i] * corner[i] * omega / (omega * omega + corner[i] * corner[i]);
  return 0.5 * sum / (1.0 + growth_at(omega));
}

double DampingFilters::growth_at(double omega) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < corner.size(); ++i) {
    const double part = of == Of::motion ? corner[i] : omega;
    sum += weight[i] * part * part / (omega * omega + corner[i] * corner[i]);
  }
  return sum;
}

DampingFilters::Step DampingFilters::over(double dt) const {
  Step step;
  for (const double c : corner) {
    const double a = c * dt;
    step.left.push_back(std::exp(-a));
    step.nearer.push_back(-std::expm1(-a));
    step.gain.push_back(a > 0.0 ? -std::expm1(-a) / a : 1.0);
  }
  return step;
}

Damping::Damping(system::System& system) : system_(system), deforming_of_(system.groups.size(), -1) {
  const model::Model& model = system.model;
  const model::Damping& cards = model.damping;
  for (const model::MassDamping& card : cards.mass)
    mass_.push_back({&card, card.everything ? std::vector<Member>{} : of_parts({card.part})});
  std::vector<char> deformed(system.groups.size(), 0);  // cards with parts before those for all others
  for (const bool everything : {false, true})
    for (const model::FrequencyRangeDamping& card : cards.range)
      if (card.deform && card.everything == everything) add_deformation_damping(card, deformed);
  for (const model::FrequencyRangeDamping& card : cards.range) {
    if (card.deform) continue;
    ByRange range{
        &card, {card.share, card.low, card.high}, card.everything ? everything() : of_parts(card.parts), {}, {}, false};
    range.v.resize(range.members.size() * range.filters.corner.size());
    range.w.resize(range.v.size());
    range_.push_back(std::move(range));
  }
  for (const model::RelativeDamping& card : cards.relative) relative_.push_back({&card, of_parts(card.parts)});
  for (const model::StiffnessDamping& card : cards.stiffness)
    for (std::size_t g = 0; g < system.groups.size(); ++g) {
      system::ElementGroup& group = *system.groups[g];
      if (group.part != card.part) continue;
      group.damping_share = card.share;
      group.damping_time = card.time;
      system.start_elements();
      group.store_reference_state();
      system.allocate_damping_slots();
    }
  if (mass_.empty() && range_.empty() && relative_.empty() && system.damping_slots.empty()) return;
  for (auto* rows : {&force_, &moment_, &last_force_, &last_moment_}) rows->resize(system.all_nodes());
  energy_of_node_.resize(system.all_nodes());
}

std::vector<Damping::Member> Damping::everything() const {
  std::vector<Member> members;
  for (std::size_t k = 0; k < system_.nodes; ++k)
    if (system_.mass[k] > 0.0 || system_.inertia[k] > 0.0)
      members.push_back({k, system_.mass[k], system_.inertia[k], -1});
  for (std::size_t b = 0; b < system_.bodies.size(); ++b)
    members.push_back({at(system_.bodies[b].node), system_.bodies[b].mass, 0.0, static_cast<int>(b)});
  return members;
}

std::vector<Damping::Member> Damping::of_parts(const std::vector<model::Index>& parts) const {
  const auto named = [&](model::Index p) { return std::find(parts.begin(), parts.end(), p) != parts.end(); };
  std::map<int, std::pair<double, double>> own;
  for (const auto& group : system_.groups) {
    if (!named(group->part)) continue;
    for (std::size_t e = 0; e < group->size(); ++e) {
      const auto nodes = group->nodes(e);
      for (int a = 0; a < group->nodes_per_element; ++a) {
        auto& [mass, inertia] = own[nodes[a]];
        mass += group->mass_scale(e) * group->nodal_mass(e, a);
        inertia += group->mass_scale(e) * group->nodal_inertia(e);
      }
    }
  }
  std::vector<Member> members;
  for (const auto& [node, m] : own) members.push_back({at(node), m.first, m.second, -1});
  std::vector<int> bodies;
  for (const model::Index p : parts)
    if (const model::Index body = system_.model.parts[p].rigid_body; body != model::none)
      bodies.push_back(system_.body_of[body]);
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  for (const int b : bodies) members.push_back({at(system_.bodies[b].node), system_.bodies[b].mass, 0.0, b});
  return members;
}

Vec3d Damping::carried(model::Index body, const Vec3d& x, const system::State& state) const {
  if (body == model::none) return {};
  const auto k = at(system_.bodies[system_.body_of[body]].node);
  return vec(state.v[k]) + cross(vec(state.w[k]), x - vec(state.x[k]));
}

void Damping::push(std::size_t node, model::Index body, const Vec3d& force, const system::State& state) {
  nugget::add(force_[node], force);
  if (body == model::none) return;
  const auto k = at(system_.bodies[system_.body_of[body]].node);
  nugget::add(force_[k], -force);
  nugget::add(moment_[k], -cross(vec(state.x[node]) - vec(state.x[k]), force));
}

void Damping::apply(system::State& state, double dt) {
  if (force_.empty()) return;
  last_force_.swap(force_);
  last_moment_.swap(moment_);
  if (system_.damping_slots.empty()) {
    system_.for_each_node(nodes_per_range, [this](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) force_[k] = moment_[k] = Row{};
    });
  } else {
    if (!deforming_.empty()) add_deforming(state, dt);
    system_.gather_damping(force_, moment_);
  }
  for (const ByMass& d : mass_) add(d, state);
  for (ByRange& d : range_) add(d, state, dt);
  for (const Relative& d : relative_) add(d, state);
  system_.for_each_node(nodes_per_range, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      energy_of_node_[k] -= 0.5 * dt *
                            (dot(vec(last_force_[k]) + vec(force_[k]), vec(state.v[k])) +
                             dot(vec(last_moment_[k]) + vec(moment_[k]), vec(state.w[k])));
      nugget::add(state.f[k], vec(force_[k]));
      nugget::add(state.m[k], vec(moment_[k]));
    }
  });
}

double Damping::energy() const {
  return ordered_sum(energy_of_node_.size(), [this](std::size_t k) { return energy_of_node_[k]; });
}

bool Damping::looks_everywhere() const {
  return !relative_.empty() ||
         std::ranges::any_of(range_, [](const ByRange& d) { return d.card->relative_to != model::none; });
}

void Damping::add(const ByMass& damping, const system::State& state) {
  const model::MassDamping& card = *damping.card;
  const double d =
      card.factor * (card.curve == model::none ? 1.0 : system_.model.curves[card.curve].zero_outside(state.time));
  if (d == 0.0) return;
  const auto times = [](const Vec3d& a, const Vec3d& b) { return Vec3d{a.x * b.x, a.y * b.y, a.z * b.z}; };
  const auto one = [&](std::size_t k, double mass, double inertia) {
    nugget::add(force_[k], -d * mass * times(card.scale, vec(state.v[k])));
    nugget::add(moment_[k], -d * inertia * times(card.rotary_scale, vec(state.w[k])));
  };
  const auto whole_body = [&](const system::RigidBody& body) {
    const auto k = at(body.node);
    nugget::add(force_[k], -d * body.mass * times(card.scale, vec(state.v[k])));
    nugget::add(moment_[k], -d * times(card.rotary_scale, body.angular_momentum));
  };
  if (card.everything) {
    system_.for_each_node(nodes_per_range, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < std::min(end, system_.nodes); ++k) one(k, system_.mass[k], system_.inertia[k]);
    });
    for (const system::RigidBody& body : system_.bodies) whole_body(body);
    return;
  }
  for (const Member& m : damping.members) {
    if (m.body >= 0)
      whole_body(system_.bodies[m.body]);
    else if (system_.follows(m.node))
      one(m.node, m.mass, m.inertia);
  }
}

void Damping::add(ByRange& damping, const system::State& state, double dt) {
  const DampingFilters& filters = damping.filters;
  const DampingFilters::Step step = filters.over(dt);
  const std::size_t count = filters.corner.size();
  const model::Index body = damping.card->relative_to;
  const auto some = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Member& m = damping.members[i];
      if (!system_.follows(m.node)) continue;
      const Vec3d v = vec(state.v[m.node]) - carried(body, vec(state.x[m.node]), state);
      // Of a body its angular momentum: what it changes by is what moments do to it, however it tumbles.
      const Vec3d w = m.body < 0 ? vec(state.w[m.node]) : turned(m, vec(state.w[m.node]));
      Vec3d force{}, turning{};
      for (std::size_t f = 0; f < count; ++f) {
        Vec3d &slow_v = damping.v[i * count + f], &slow_w = damping.w[i * count + f];
        if (!damping.started) slow_v = v, slow_w = w;
        const double rate = filters.weight[f] * filters.corner[f];
        slow_v += step.nearer[f] * (v - slow_v);
        slow_w += step.nearer[f] * (w - slow_w);
        force -= (m.mass * rate) * (v - slow_v);
        turning -= rate * (w - slow_w);
      }
      push(m.node, body, force, state);
      nugget::add(moment_[m.node], m.body < 0 ? m.inertia * turning : turning);
    }
  };
  // A body to which the motion is relative feels every node's force.
  if (body == model::none)
    parallel_for(damping.members.size(), nodes_per_range, some);
  else
    some(0, damping.members.size());
  damping.started = true;
}

void Damping::add_deformation_damping(const model::FrequencyRangeDamping& card, std::vector<char>& taken) {
  const std::size_t filters = deform_.size();
  deform_.emplace_back(card.share, card.low, card.high, DampingFilters::Of::deformation);
  double growth = 0.0;
  for (const double w : deform_.back().weight) growth += w;
  for (std::size_t g = 0; g < system_.groups.size(); ++g) {
    system::ElementGroup& group = *system_.groups[g];
    if (taken[g] || std::find(card.parts.begin(), card.parts.end(), group.part) == card.parts.end()) continue;
    taken[g] = 1;
    // As if it were stiffened twice: the twist of some shells is at the limit of the step already (TSSFAC 0.9).
    group.damping_stiffness_ratio = (1.0 + growth) * (1.0 + growth) - 1.0;
    Deforming d;
    d.group = static_cast<int>(g);
    d.filters = filters;
    d.passed.resize(group.size() * 3 * group.rows_of_element() * (1 + deform_.back().corner.size()));
    if (group.nodes_per_element == 2) d.across.resize(group.size());
    deforming_of_[g] = static_cast<int>(deforming_.size());
    deforming_.push_back(std::move(d));
    system_.allocate_damping_slots();
  }
}

void Damping::add_deforming(const system::State& state, double dt) {
  std::vector<DampingFilters::Step> steps;
  for (const DampingFilters& filters : deform_) steps.push_back(filters.over(dt));
  system_.for_each_block([&](int g, std::size_t begin, std::size_t end) {
    if (deforming_of_[g] < 0) return;
    const system::ElementGroup& group = *system_.groups[g];
    Deforming& damping = deforming_[deforming_of_[g]];
    const std::size_t width = group.block_width();
    deform(damping, steps[damping.filters], begin * width, std::min(group.size(), end * width), state, dt);
  });
  for (Deforming& damping : deforming_) damping.started = true;
}

void Damping::deform(Deforming& damping, const DampingFilters::Step& step, std::size_t begin, std::size_t end,
                     const system::State& state, double dt) {
  const system::ElementGroup& group = *system_.groups[damping.group];
  const DampingFilters& filters = deform_[damping.filters];
  const std::size_t count = filters.corner.size(), rows = group.rows_of_element(),
                    corners = at(group.nodes_per_element);
  for (std::size_t e = begin; e < end; ++e) {
    double* last = &damping.passed[e * 3 * rows * (1 + count)];
    const auto slot = [&](std::size_t r) {
      const auto node = static_cast<int>(r % corners);
      return r < corners ? group.slot(e, node) : group.moment_slot(e, node);
    };
    for (std::size_t r = 0; r < rows && !group.damped(); ++r) system_.damping_slots.set(slot(r), {});
    if (!group.alive(e)) continue;
    const auto nodes = group.nodes(e);
    const Frame3d axes = damping.across.empty() ? axes_of(nodes, corners, state)
                                                : axes_along(nodes, state, dt, damping.started, damping.across[e]);
    const system::System::ElementLocation location{damping.group, static_cast<int>(e)};
    std::array<double, 3 * most_rows> change, sum{};
    for (std::size_t r = 0; r < rows; ++r) {
      const auto node = static_cast<int>(r % corners);
      const Vec3d force =
          axes.local(r < corners ? system_.nodal_force(location, node) : system_.nodal_moment(location, node));
      const std::array<double, 3> now{force.x, force.y, force.z};
      for (std::size_t c = 0; c < 3; ++c) {
        change[3 * r + c] = damping.started ? now[c] - last[3 * r + c] : 0.0;
        last[3 * r + c] = now[c];
      }
    }
    for (std::size_t f = 0; f < count; ++f) {
      double* passed = last + 3 * rows * (1 + f);
      for (std::size_t i = 0; i < 3 * rows; ++i) {
        // F - low-passed F of a force that grows evenly over the step.
        passed[i] = step.left[f] * passed[i] + step.gain[f] * change[i];
        sum[i] += filters.weight[f] * passed[i];
      }
    }
    for (std::size_t r = 0; r < rows; ++r)
      system_.damping_slots.set(
          slot(r), system_.damping_slots[slot(r)] + axes.global({sum[3 * r], sum[3 * r + 1], sum[3 * r + 2]}));
  }
}

void Damping::add(const Relative& damping, const system::State& state) {
  const model::RelativeDamping& card = *damping.card;
  const double factor = card.curve == model::none ? 1.0 : system_.model.curves[card.curve].zero_outside(state.time);
  const double linear = factor * 2.0 * card.share * 2.0 * std::numbers::pi * card.frequency;
  for (const Member& m : damping.members) {
    const Vec3d v = vec(state.v[m.node]) - carried(card.rigid_body, vec(state.x[m.node]), state);
    const double d = linear + factor * card.quadratic * norm(v);
    push(m.node, card.rigid_body, -m.mass * d * v, state);
    if (m.body < 0) continue;
    // The same at all points of a body amounts to a moment too, which the other body gets back.
    const auto other = at(system_.bodies[system_.body_of[card.rigid_body]].node);
    const Vec3d moment = turned(m, -d * (vec(state.w[m.node]) - vec(state.w[other])));
    nugget::add(moment_[m.node], moment);
    nugget::add(moment_[other], -moment);
  }
}

Vec3d Damping::turned(const Member& body, const Vec3d& spin) const {
  const system::RigidBody& rigid = system_.bodies[body.body];
  return rigid.momentum(spin, rigid.axes);
}

void Damping::carry(system::Carried what, const system::System::Computed& of, system::Parcel& parcel) {
  if (force_.empty() || what == system::Carried::histories) return;
  const Runs& nodes = of.share.reported_by(of.rank);
  for (const int k : nodes) parcel(&energy_of_node_[k], 1);
  if (what != system::Carried::restart) return;
  for (std::vector<Row>* rows : {&force_, &moment_})
    for (const int k : nodes) parcel(&(*rows)[k], 1);
  for (ByRange& d : range_)
    for (std::size_t i = 0; i < d.members.size(); ++i) {
      const auto node = static_cast<int>(d.members[i].node);
      if (of.share.everyone_follows(node) || of.share.answering(node) != of.rank) continue;
      const std::size_t count = d.filters.corner.size();
      parcel(&d.v[i * count], count);
      parcel(&d.w[i * count], count);
    }
  for (Deforming& d : deforming_) {
    const std::size_t elements = system_.groups[d.group]->size(),
                      numbers = d.passed.size() / std::max<std::size_t>(1, elements);
    for (std::size_t e = 0; e < elements; ++e) {
      if (!of(d.group, e)) continue;
      parcel(&d.passed[e * numbers], numbers);
      if (!d.across.empty()) parcel(&d.across[e], 1);
    }
  }
}

void Damping::ByRange::archive(Archive& a) {
  a(v, w, started);
  a.built(card, filters, members);
}

void Damping::Deforming::archive(Archive& a) {
  a(passed, across, started);
  a.built(group, filters);
}

void Damping::archive(Archive& a) {
  a(range_, deforming_, force_, moment_, energy_of_node_);
  a.built(last_force_, last_moment_, system_, mass_, deform_, relative_, deforming_of_);
}

}  // namespace nugget::impact
