// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/belts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "system/mobility.hpp"
#include "system/spring_group.hpp"

namespace nugget::impact {
namespace {

constexpr double damping = 0.1, most_damping = 0.1;  // documented
constexpr double coming_out = 1.1;                   // of LMIN, documented
constexpr double fed_in_a_cycle = 0.01;              // of LFED, documented
constexpr double shortest = 0.5;                     // of LMIN: what a belt keeps that cannot pass
constexpr double stable_share = 0.85;                // of the undamped step: what the damping leaves of it

/// Where a function that falls with its argument becomes 0 or less, to the last bit; an end where it does not.
template <class Function>
double where_it_falls_to_zero(double low, double high, const Function& f) {
  if (!(f(low) > 0.0)) return low;
  if (f(high) > 0.0) return high;
  for (double middle = 0.5 * (low + high); middle > low && middle < high; middle = 0.5 * (low + high))
    (f(middle) > 0.0 ? low : high) = middle;
  return high;
}

Curve curve_of(const model::Model& model, model::Index curve) {
  return curve == model::none ? Curve{} : model.curves[curve];
}

}  // namespace

Belts::Belts(system::System& system, Findings& findings) : system_(system) {
  const model::Model& model = system.model;
  const model::Belts& given = model.belts;
  if (given.empty()) return;
  for (const model::BeltMaterial& m : given.materials)
    tensions_.emplace_back(curve_of(model, m.loading), curve_of(model, m.unloading), 0.0);
  for (const model::Belt& belt : given.elements) {
    Element e;
    const model::BeltMaterial& material = given.materials[belt.material];
    e.tension = &tensions_[belt.material];
    e.node = {system.node_of[belt.node[0]], system.node_of[belt.node[1]]};
    e.distance = norm(system.ties.x[at(belt.node[1])] - system.ties.x[at(belt.node[0])]);
    e.length = e.distance + belt.slack;
    e.mass = belt.mass;
    e.least = material.least_length;
    e.inside = belt.retractor != model::none;
    e.state = e.tension->start();
    elements_.push_back(e);
  }
  for (const model::SlipRing& ring : given.rings)
    rings_.push_back({&ring, system.node_of[ring.node], {ring.belt[0], ring.belt[1]}, 0.0, 0.0});
  for (const model::Retractor& retractor : given.retractors) {
    Reel reel;
    reel.source = &retractor;
    const Curve loading = curve_of(model, retractor.loading);
    reel.tension = Tension(loading, curve_of(model, retractor.unloading), loading.y.front());
    reel.state = reel.tension.start();
    reel.node = system.node_of[retractor.node];
    reel.mouth = retractor.belt;
    reel.inside.assign(retractor.inside.begin(), retractor.inside.end());
    for (const model::Index n : retractor.inside_nodes) reel.nodes.push_back(system.node_of[n]);
    reels_.push_back(std::move(reel));
  }
  sensors_.resize(given.sensors.size());
  for (const model::Pretensioner& pretensioner : given.pretensioners) {
    pretensioners_.emplace_back().source = &pretensioner;
    if (pretensioner.kind == model::Pretensioner::Kind::spring_acts) cancel_force(pretensioner, true);
  }

  mobility_.resize(system.all_nodes());
  stiffness_.resize(system.all_nodes());
  fixed_.resize(system.all_nodes());
  const auto fix = [&](int node) { fixed_[node] = 1; };
  for (const model::SinglePointConstraint& spc : model.spcs) fix(system.node_of[spc.node]);
  for (const model::PrescribedMotion& motion : model.motions)
    for (const model::Index n : motion.nodes) fix(system.node_of[n]);
  for (const Ring& ring : rings_) fix(ring.node);
  for (const Reel& reel : reels_) fix(reel.node);
  for (std::size_t i = 0; i < elements_.size(); ++i)
    for (const int node : elements_[i].node) {
      if (std::ranges::find(nodes_, node) != nodes_.end()) continue;
      nodes_.push_back(node);
      if (system.map.dependent(node)) fix(node);
      if (!(system.mass[node] > 0.0) && !system.map.dependent(node))
        findings.error(given.elements[i].place, "*ELEMENT_SEATBELT",
                       fmt::format("node {} has no mass, and nothing that it moves with", system.node_id(node)),
                       "give MPUL of its material, or fasten the node");
      mobility_[node] = system::Mobility::largest(system::mobility(system, node).translation);
    }
}

int Belts::far(int element, int node) const {
  const Element& e = elements_[element];
  return e.node[0] == node ? e.node[1] : e.node[0];
}

int Belts::next(int element, int node) const {
  if (fixed_[node] != 0) return -1;
  int found = -1;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const Element& e = elements_[i];
    if (e.inside || static_cast<int>(i) == element || (e.node[0] != node && e.node[1] != node)) continue;
    if (found >= 0) return -1;
    found = static_cast<int>(i);
  }
  return found;
}

void Belts::measure(Element& e, const system::State& state) const {
  e.distance = norm(vec(state.x[e.node[1]]) - vec(state.x[e.node[0]]));
}

/// The half of the work of the forces that is done with the velocities of the step that has ended.
void Belts::book(const system::State& state) {
  for (const Element& e : elements_)
    if (!e.inside) energy_ -= 0.5 * state.dt * dot(e.pull, vec(state.v[e.node[0]]) - vec(state.v[e.node[1]]));
}

/// A node comes to stand, and move, between two others, at a share of their distance; what that adds to its kinetic
/// energy is taken from the belts.
void Belts::put(int node, int from, int to, double share, system::State& state) {
  const Vec3d before = vec(state.v[node]);
  set(state.x[node], vec(state.x[from]) + share * (vec(state.x[to]) - vec(state.x[from])));
  set(state.v[node], vec(state.v[from]) + share * (vec(state.v[to]) - vec(state.v[from])));
  const Vec3d after = vec(state.v[node]);
  energy_ -= 0.5 * system_.mass[node] * (dot(after, after) - dot(before, before));
}

// ---- slip rings

/// Belt `short_one` of the ring goes through it.
void Belts::pass(Ring& ring, int short_one, system::State& state) {
  const std::size_t side = ring.element[0] == short_one ? 0 : 1;
  Element& passing = elements_[short_one];
  Element& longer = elements_[ring.element[1 - side]];
  const int node = far(short_one, ring.node), behind = next(short_one, node),
            end = far(ring.element[1 - side], ring.node);
  Element& follower = elements_[behind];
  // The belt behind keeps its strain over the longer way to the ring.
  for (int& n : follower.node)
    if (n == node) n = ring.node;
  const double stretch = follower.distance / follower.length;
  measure(follower, state);
  follower.length = follower.distance / stretch;
  // The short one begins at the ring, and the longer one where it ends, with the strain of that.
  const double of_longer = longer.distance / longer.length, way = longer.distance;
  passing.length = coming_out * passing.least;
  for (int& n : longer.node)
    if (n == ring.node) n = node;
  put(node, ring.node, end, std::min(0.5, passing.length * of_longer / way), state);
  measure(passing, state);
  measure(longer, state);
  passing.length = passing.distance / of_longer;
  longer.length = longer.distance / of_longer;
  passing.state = longer.state;
  passing.strain = longer.strain;
  ring.element[side] = behind;
  ring.element[1 - side] = short_one;
  events_.push_back(fmt::format("time {:.6g}: belt {} has passed slip ring {}", state.time,
                                system_.model.belts.elements[at(short_one)].id, ring.source->id));
}

double Belts::friction(const Ring& ring, const system::State& state) const {
  const model::SlipRing& card = *ring.source;
  const auto value = [&](double constant, model::Index curve) {
    return curve == model::none ? constant : system_.model.curves[curve].clamped(state.time);
  };
  const double sliding = value(card.friction, card.friction_curve),
               sticking = value(card.static_friction, card.static_curve);
  if (!(sticking > 0.0)) return sliding;
  if (card.decay > 0.0) return sliding + (sticking - sliding) * std::exp(-card.decay * std::abs(ring.speed));
  return ring.speed == 0.0 ? sticking : sliding;
}

void Belts::slide(Ring& ring, const system::State& state) {
  const double before = ring.slip;
  Element &first = elements_[ring.element[0]], &second = elements_[ring.element[1]];
  if (state.dt <= 0.0 || (state.time >= ring.source->lock_time && !state.relaxing)) {
    ring.speed = 0.0;
    return;
  }
  const auto towards = [&](int element) { return vec(state.x[far(element, ring.node)]) - vec(state.x[ring.node]); };
  const Vec3d one = towards(ring.element[0]), other = -towards(ring.element[1]);
  const double wrap = std::atan2(norm(cross(one, other)), dot(one, other));
  const double ratio = std::exp(friction(ring, state) * wrap);
  const auto slides = [&](Element& to, Element& from, int giving) {
    const bool passes = next(giving, far(giving, ring.node)) >= 0;
    const double most = from.length - (passes ? shortest : 1.0) * from.least;
    if (!(most > 0.0) || !(tension_at(to, to.length) > ratio * tension_at(from, from.length))) return 0.0;
    const double moved = where_it_falls_to_zero(
        0.0, most, [&](double d) { return tension_at(to, to.length + d) - ratio * tension_at(from, from.length - d); });
    to.length += moved;
    from.length -= moved;
    return moved;
  };
  if (ring.source->to_first) ring.slip += slides(first, second, ring.element[1]);
  if (ring.source->to_second && ring.slip == before) ring.slip -= slides(second, first, ring.element[0]);
  ring.speed = (ring.slip - before) / state.dt;
}

// ---- retractors

void Belts::come_out(Reel& reel, system::State& state) {
  Element& mouth = elements_[reel.mouth];
  if (reel.inside.empty() || mouth.length <= reel.source->fed_length + mouth.least) return;
  const int out = reel.inside.front(), node = reel.nodes.front(), end = far(reel.mouth, reel.node);
  Element& element = elements_[out];
  const double stretch = mouth.distance / mouth.length, way = mouth.distance;
  for (int& n : mouth.node)
    if (n == reel.node) n = node;
  element.node = {reel.node, node};
  element.inside = false;
  put(node, reel.node, end, coming_out * element.least * stretch / way, state);
  measure(mouth, state);
  measure(element, state);
  mouth.length = mouth.distance / stretch;
  element.length = element.distance / stretch;
  element.state = mouth.state;
  element.strain = mouth.strain;
  element.pull = {};
  reel.inside.erase(reel.inside.begin());
  reel.nodes.erase(reel.nodes.begin());
  reel.mouth = out;
  events_.push_back(fmt::format("time {:.6g}: belt {} has come out of retractor {}", state.time,
                                system_.model.belts.elements[at(out)].id, reel.source->id));
}

void Belts::go_in(Reel& reel, system::State& state) {
  Element& mouth = elements_[reel.mouth];
  const int node = far(reel.mouth, reel.node), behind = next(reel.mouth, node);
  if (mouth.length >= mouth.least || behind < 0) return;
  Element& follower = elements_[behind];
  const double stretch = follower.distance / follower.length;
  for (int& n : follower.node)
    if (n == node) n = reel.node;
  measure(follower, state);
  follower.length = follower.distance / stretch;
  mouth.inside = true;
  mouth.force = 0.0;
  mouth.pull = {};
  reel.inside.insert(reel.inside.begin(), reel.mouth);
  reel.nodes.insert(reel.nodes.begin(), node);
  reel.mouth = behind;
  events_.push_back(fmt::format("time {:.6g}: belt {} has gone into retractor {}", state.time,
                                system_.model.belts.elements[at(reel.inside.front())].id, reel.source->id));
}

/// How much can be reeled in at once: what is left of a belt that cannot go in.
double Belts::longest_change(const Reel& reel) const {
  const Element& mouth = elements_[reel.mouth];
  const bool goes_in = next(reel.mouth, far(reel.mouth, reel.node)) >= 0;
  return std::max(0.0, mouth.length - (goes_in ? shortest : 1.0) * mouth.least);
}

bool Belts::any_on(const std::vector<model::Index>& sensors, model::Index control, const system::State& state) const {
  return (control != model::none && state.acts(control)) ||
         std::ranges::any_of(sensors, [&](model::Index s) { return sensors_[s].on; });
}

void Belts::lock_now(Reel& reel, const system::State& state) {
  if (reel.locked) return;
  reel.locked = true;
  events_.push_back(
      fmt::format("time {:.6g}: retractor {} has locked, {:.6g} pulled out", state.time, reel.source->id, reel.paid));
}

void Belts::lock(Reel& reel, const system::State& state) {
  const model::Retractor& card = *reel.source;
  if (reel.responded < 0.0) {
    if (!any_on(card.sensors, card.control, state)) return;
    reel.responded = state.time;
  }
  if (reel.armed < 0.0) {
    if (state.time - reel.responded < card.delay) return;
    reel.armed = state.time;
    reel.paid_then = reel.paid;
  }
  if (reel.locked || reel.paid - reel.paid_then < card.pull) return;
  lock_now(reel, state);
}

/// `drawn`: what a pretensioner reels in over the step, whatever the tension.
void Belts::wind(Reel& reel, std::optional<double> drawn, const system::State& state) {
  reel.rate = 0.0;
  if (state.dt <= 0.0) return;
  lock(reel, state);
  Element& mouth = elements_[reel.mouth];
  const double most = fed_in_a_cycle * reel.source->fed_length, in = std::min(most, longest_change(reel));
  double change = 0.0;
  if (drawn) {
    change = -std::min(*drawn, longest_change(reel));
  } else if (reel.locked) {
    change = where_it_falls_to_zero(-in, mouth.distance, [&](double d) {
      return tension_at(mouth, mouth.length + d) - reel.tension(reel.pulled + d, reel.state);
    });
    reel.pulled += change;
    reel.tension.advance(reel.pulled, reel.state);
  } else {
    const double wanted = reel.tension(0.0, reel.tension.start());
    change = where_it_falls_to_zero(-in, most, [&](double d) { return tension_at(mouth, mouth.length + d) - wanted; });
  }
  const double before = tension_at(mouth, mouth.length), after = tension_at(mouth, mouth.length + change);
  reeled_ += 0.5 * (before + after) * std::max(0.0, -change);
  mouth.length += change;
  reel.paid += change;
  reel.rate = change / state.dt;
}

// ---- pretensioners

void Belts::cancel_force(const model::Pretensioner& of, bool cancelled) {
  const system::System::ElementLocation location = system_.discrete_location[of.discrete];
  static_cast<system::SpringGroup&>(*system_.groups[location.group]).cancel_force(at(location.element), cancelled);
}

/// What a pretensioner of type 5 reels in over the step; nothing where it does not rule its retractor.
std::optional<double> Belts::act(Tightening& pretensioner, const system::State& state) {
  using enum model::Pretensioner::Kind;
  const model::Pretensioner& card = *pretensioner.source;
  if (pretensioner.ended || state.dt <= 0.0) return {};
  if (pretensioner.responded < 0.0) {
    if (!any_on(card.sensors, card.control, state)) return {};
    pretensioner.responded = state.time;
  }
  if (pretensioner.acting < 0.0) {
    if (state.time - pretensioner.responded < card.delay) return {};
    pretensioner.acting = state.time;
    events_.push_back(fmt::format("time {:.6g}: pretensioner {} acts", state.time, card.id));
  }
  if (card.retractor == model::none) {
    cancel_force(card, card.kind == spring_ends);
    pretensioner.ended = true;
    return {};
  }
  Reel& reel = reels_[card.retractor];
  const Curve& curve = system_.model.curves[card.curve];
  const double time = state.time - pretensioner.acting, drawn = curve.clamped(time);
  const double more = std::max(0.0, drawn - pretensioner.drawn);
  pretensioner.drawn = std::max(pretensioner.drawn, drawn);
  pretensioner.ended =
      time >= curve.x.back() || (card.most_tension > 0.0 && tension(at(card.retractor)) >= card.most_tension);
  if (card.kind == limited_pull_in) {
    lock_now(reel, state);
    reel.pulled += more;
    return {};
  }
  if (pretensioner.ended && !reel.locked) {
    // The spool holds what it has drawn: it goes on where its loading curve has the tension of the belt.
    const double now = tension(at(card.retractor));
    reel.pulled = where_it_falls_to_zero(0.0, system_.model.curves[reel.source->loading].x.back(),
                                         [&](double x) { return now - reel.tension(x, reel.state); });
    reel.tension.advance(reel.pulled, reel.state);
    lock_now(reel, state);
  }
  return more;
}

// ---- sensors

double Belts::sensed(const model::BeltSensor& sensor, Sensing& sensing, const system::State& state) const {
  using enum model::BeltSensor::Kind;
  const auto row = [&](const system::Rows& of, std::size_t i) { return vec(of[system_.node_of[sensor.node[i]]]); };
  switch (sensor.kind) {
    case time: return state.time;
    case distance: return norm(row(state.x, 1) - row(state.x, 0));
    case pull_out: return reels_[sensor.retractor].paid;
    case pull_out_rate: return reels_[sensor.retractor].rate;
    case acceleration: break;
  }
  // The mean over the time between the middles of two steps.
  const Vec3d now = row(state.v, 0);
  const double between = 0.5 * (state.dt + sensing.step);
  const double found = sensing.known && between > 0.0 ? dot(now - sensing.velocity, sensor.direction) / between : 0.0;
  sensing.velocity = now;
  sensing.step = state.dt;
  sensing.known = true;
  return found;
}

void Belts::sense(const system::State& state) {
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const model::BeltSensor& sensor = system_.model.belts.sensors[i];
    Sensing& sensing = sensors_[i];
    const double now = sensed(sensor, sensing, state);
    if (sensing.on || (state.relaxing && !sensor.in_relaxation)) continue;
    if (!(now > sensor.above) && !(now < sensor.below))
      sensing.since = -1.0;
    else if (sensing.since < 0.0)
      sensing.since = state.time;
    sensing.on = sensing.since >= 0.0 && state.time - sensing.since >= sensor.duration;
  }
}

// ---- all

void Belts::move(system::State& state) {
  if (empty()) return;
  book(state);
  for (Element& e : elements_)
    if (!e.inside) measure(e, state);
  for (Reel& reel : reels_) {
    for (const int node : reel.nodes) put(node, reel.node, reel.node, 0.0, state);
    come_out(reel, state);
    go_in(reel, state);
  }
  for (Ring& ring : rings_)
    for (const int e : {ring.element[0], ring.element[1]})
      if (elements_[e].length < elements_[e].least && next(e, far(e, ring.node)) >= 0) {
        pass(ring, e, state);
        break;
      }
}

void Belts::pull(Element& e, system::State& state) {
  const double strain = e.distance / e.length - 1.0;
  e.tension->advance(strain, e.state);
  const double elastic = (*e.tension)(strain, e.state);
  double force = elastic;
  if (state.dt > 0.0) {
    const double rate = e.length * (strain - e.strain) / state.dt;
    force += std::clamp(damping * e.mass / state.dt * rate, -most_damping * elastic, most_damping * elastic);
  }
  e.strain = strain;
  e.force = force;
  const Vec3d span = vec(state.x[e.node[1]]) - vec(state.x[e.node[0]]);
  e.pull = e.distance > 0.0 ? (force / e.distance) * span : Vec3d{};
  add(state.f[e.node[0]], e.pull);
  add(state.f[e.node[1]], -e.pull);
}

void Belts::apply(system::State& state) {
  if (empty()) return;
  for (Element& e : elements_)
    if (!e.inside) measure(e, state);
  sense(state);
  std::vector<std::optional<double>> drawn(reels_.size());
  for (Tightening& pretensioner : pretensioners_)
    if (const auto length = act(pretensioner, state)) drawn[at(pretensioner.source->retractor)] = length;
  for (std::size_t i = 0; i < reels_.size(); ++i) wind(reels_[i], drawn[i], state);
  for (Ring& ring : rings_) slide(ring, state);
  for (Element& e : elements_)
    if (!e.inside) pull(e, state);
  book(state);
  find_step();
}

/// Row sums of M^-1 K bound the square of the highest frequency.
void Belts::find_step() {
  for (const int node : nodes_) stiffness_[node] = 0.0;
  for (const Element& e : elements_)
    if (!e.inside)
      for (const int node : e.node) stiffness_[node] += e.tension->steepest(e.state) / e.length;
  double squared = 0.0;
  for (const int node : nodes_) squared = std::max(squared, 2.0 * stiffness_[node] * mobility_[node]);
  stable_step_ = squared > 0.0 ? stable_share * 2.0 / std::sqrt(squared) : std::numeric_limits<double>::infinity();
}

void Belts::Element::archive(Archive& a) {
  a(node, length, distance, strain, force, inside, state, pull);
  a.built(tension, mass, least);
}

void Belts::Ring::archive(Archive& a) {
  a(element, slip, speed);
  a.built(source, node);
}

void Belts::Reel::archive(Archive& a) {
  a(mouth, inside, nodes, paid, rate, responded, armed, paid_then, locked, pulled, state);
  a.built(source, tension, node);
}

void Belts::Tightening::archive(Archive& a) {
  a(responded, acting, drawn, ended);
  a.built(source);
}

void Belts::archive(Archive& a) {
  a(elements_, rings_, reels_, sensors_, pretensioners_, energy_, reeled_, stable_step_, events_);
  a.built(system_, tensions_, mobility_, stiffness_, nodes_, fixed_);
}

}  // namespace nugget::impact
