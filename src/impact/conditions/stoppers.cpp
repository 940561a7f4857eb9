// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/stoppers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/index.hpp"
#include "impact/conditions/directions.hpp"

namespace nugget::impact {
namespace {

/// What a body's velocity, or spin, becomes where it is to have given values in some directions.
class Together {
 public:
  Together(system::RigidBody& body, bool rotation, system::State& state)
      : body_(body),
        rotation_(rotation),
        state_(state),
        free_(vec((rotation ? state.w : state.v)[at(body.node)])),
        momentum_(body.angular_momentum) {}

  Directions directions;

  /// Sets the velocity; afterwards the directions have their impulses as they were given.
  void solve() {
    leave();
    if (rotation_) {
      directions.drive_spin(body_, state_);
    } else {
      Vec3d v = free_;
      for (int k = 0; k < directions.size(); ++k) {
        const double change = directions.speed(k) - dot(directions.unit(k), v);
        v += change * directions.unit(k);
        directions.set_impulse(k, body_.mass * change);
      }
      set(state_.v[at(body_.node)], v);
    }
    directions.share_out();
  }
  void leave() {
    body_.angular_momentum = momentum_;
    set((rotation_ ? state_.w : state_.v)[at(body_.node)], free_);
  }

  Vec3d velocity() const { return vec((rotation_ ? state_.w : state_.v)[at(body_.node)]); }
  const Vec3d& free() const { return free_; }

 private:
  system::RigidBody& body_;
  bool rotation_;
  system::State& state_;
  Vec3d free_, momentum_;
};

}  // namespace

Stoppers::Stoppers(const system::System& system, Findings& findings) : system_(system) {
  for (const model::BodyStopper& card : system.model.body_stoppers) {
    Stop stop;
    stop.card = &card;
    stop.body = system.body_of[at(card.body)];
    const auto same = [&](const Group& g) { return g.body == stop.body && g.rotation == card.rotation; };
    auto group = std::ranges::find_if(groups_, same);
    if (group == groups_.end()) group = groups_.insert(group, {stop.body, card.rotation, {}, {}});
    group->stops.push_back(stops_.size());
    stops_.push_back(stop);
    if (card.birth > 0.0) continue;
    const system::RigidBody& body = system.bodies[at(stop.body)];
    const double here = place(stop, body.center0);
    const auto warn = [&](const model::BodyStopper::Bound& bound, std::string_view field, double sign) {
      if (bound.curve == model::none) return;
      const double limit = system.model.curves[at(bound.curve)].clamped(0.0) + origin(stop, bound);
      const double beyond = sign * (here - limit);
      if (beyond > 1e-9 * std::max(std::abs(here), std::abs(limit)))
        findings.warning(card.place, "*CONSTRAINED_RIGID_BODY_STOPPERS",
                         fmt::format("body {} starts {:.4g}{} beyond the bound of {}: it goes no farther, and is not "
                                     "carried back",
                                     body.id, beyond, card.rotation ? " rad" : "", field),
                         "correct the curve, or the place of the body; below 0 its number means displacements");
    };
    warn(card.most, "LCMAX", 1.0);
    warn(card.least, "LCMIN", -1.0);
  }
}

double Stoppers::place(const Stop& stop, const Vec3d& center) const {
  return stop.card->rotation ? stop.angle : dot(stop.card->direction, center);
}

double Stoppers::origin(const Stop& stop, const model::BodyStopper::Bound& bound) const {
  if (!bound.of_displacement || stop.card->rotation) return 0.0;
  return dot(stop.card->direction, system_.bodies[at(stop.body)].center0);
}

Stoppers::Limits Stoppers::limits(const Stop& stop, const system::State& state) const {
  const model::BodyStopper& card = *stop.card;
  constexpr double none = std::numeric_limits<double>::infinity();
  Limits allowed{-none, none};
  if (!(state.dt > 0.0) || state.time < card.birth || state.time >= card.death) return allowed;
  const double here = place(stop, vec(state.x[at(system_.bodies[at(stop.body)].node)]));
  const auto value = [&](model::Index curve, double time) { return system_.model.curves[at(curve)].clamped(time); };
  if (card.fastest != model::none) {
    const double most = std::abs(value(card.fastest, state.time + state.dt));
    allowed = {-most, most};
  }
  // A body beyond the bound keeps the distance to it, or comes nearer: carried back in one step it would fly on.
  const auto to_bound = [&](const model::BodyStopper::Bound& bound, double sign) {
    const double now = value(bound.curve, state.time), then = value(bound.curve, state.time + state.dt);
    const double from = sign * (here - (now + origin(stop, bound))) > 0.0 ? now + origin(stop, bound) : here;
    return (then + origin(stop, bound) - from) / state.dt;
  };
  if (card.most.curve != model::none) {
    allowed.high = std::min(allowed.high, to_bound(card.most, 1.0));
    allowed.low = std::min(allowed.low, allowed.high);
  }
  if (card.least.curve != model::none) {
    allowed.low = std::max(allowed.low, to_bound(card.least, -1.0));
    allowed.high = std::max(allowed.high, allowed.low);
  }
  return allowed;
}

double Stoppers::velocity(const Stop& stop, const system::State& state) const {
  const auto node = at(system_.bodies[at(stop.body)].node);
  return dot(stop.card->direction, vec((stop.card->rotation ? state.w : state.v)[node]));
}

void Stoppers::start(const system::State& state) {
  for (Stop& stop : stops_) stop.velocity = velocity(stop, state);
}

void Stoppers::apply(system::State& state, double velocity_interval, std::span<system::RigidBody> bodies,
                     Supports& supports) {
  power_on_change_ = 0.0;
  dt_previous_ = state.dt_previous;
  if (!motions_known_)
    for (Group& group : groups_) group.driven = supports.motions_of_body(group.body, group.rotation);
  motions_known_ = true;
  for (const Group& group : groups_) {
    if (bodies[at(group.body)].mass > 0.0) meet(group, state, velocity_interval, bodies[at(group.body)], supports);
  }
}

/// Those stops act that push: what is beyond its limits is taken in, the farthest first, and what would pull is let go,
/// until neither is left.
void Stoppers::meet(const Group& group, system::State& state, double velocity_interval, system::RigidBody& body,
                    Supports& supports) {
  struct Trial {
    Limits limits;
    double target = 0.0, side = 0.0;  ///< side: 1 pushed upwards, -1 downwards, 0 does not act
    bool blocked = false;             ///< what holds the body leaves it no way along this direction
    int number = -1;
  };
  Together met(body, group.rotation, state);
  const auto direction = [&](std::size_t i) -> const Vec3d& { return stops_[group.stops[i]].card->direction; };
  std::vector<Trial> trials(group.stops.size());
  for (std::size_t i = 0; i < trials.size(); ++i) trials[i].limits = limits(stops_[group.stops[i]], state);
  const std::array<Vec3d, 3> own{body.fixed_axes.e1, body.fixed_axes.e2, body.fixed_axes.e3};
  std::vector<int> of_motion(group.driven.size(), -1);
  bool acts = false;
  const std::size_t most = 2 * trials.size() + 8;
  for (std::size_t pass = 0; pass < most; ++pass) {
    const Vec3d velocity = met.velocity();
    double pushes = 0.0;
    Trial* worst = nullptr;
    double farthest = 1e-14 * norm(velocity);
    for (std::size_t i = 0; i < trials.size(); ++i) {
      Trial& trial = trials[i];
      if (trial.side != 0.0 || trial.blocked) continue;
      const double v = dot(direction(i), velocity);
      trial.target = std::clamp(v, trial.limits.low, trial.limits.high);
      if (!(std::abs(trial.target - v) > farthest)) continue;
      farthest = std::abs(trial.target - v);
      worst = &trial;
      pushes = trial.target > v ? 1.0 : -1.0;
    }
    if (worst == nullptr) break;
    worst->side = pushes;
    for (bool pulls = true; pulls;) {
      met.directions.clear();
      for (unsigned i = 0; i < 3; ++i)
        if (body.fixed >> (group.rotation ? 3 + i : i) & 1u) met.directions.add(own[i], 0.0);
      for (std::size_t i = 0; i < trials.size(); ++i) {
        Trial& trial = trials[i];
        trial.number = -1;
        if (trial.side == 0.0) continue;
        if (met.directions.add(direction(i), trial.target))
          trial.number = met.directions.size() - 1;
        else
          trial.blocked = true;
        if (trial.blocked) trial.side = 0.0;
      }
      for (std::size_t d = 0; d < group.driven.size(); ++d) {
        const Vec3d& axis = supports.axis_of(group.driven[d]);
        of_motion[d] = supports.drives(group.driven[d]) && met.directions.add(axis, dot(axis, met.free()))
                           ? met.directions.size() - 1
                           : -1;
      }
      acts = std::ranges::any_of(trials, [](const Trial& t) { return t.number >= 0; });
      if (!acts) {
        met.leave();
        break;
      }
      met.solve();
      pulls = false;
      for (Trial& trial : trials)
        if (trial.number >= 0 && trial.side * met.directions.impulse(trial.number) < 0.0) {
          trial.side = 0.0;
          pulls = true;
          break;
        }
    }
  }

  const Vec3d velocity = met.velocity();
  for (std::size_t i = 0; i < trials.size(); ++i) {
    Stop& stop = stops_[group.stops[i]];
    stop.before = stop.velocity;
    const bool pushes = acts && trials[i].number >= 0 && velocity_interval > 0.0;
    stop.force = pushes ? met.directions.impulse(trials[i].number) / velocity_interval : 0.0;
    work_ += 0.5 * stop.force * stop.before * state.dt_previous;
    stop.velocity = Stoppers::velocity(stop, state);
  }
  if (!acts) return;
  power_on_change_ += dot(velocity - met.free(), vec((group.rotation ? state.m : state.f)[at(body.node)]));
  for (std::size_t d = 0; d < group.driven.size(); ++d)
    supports.meet_stop(group.driven[d], of_motion[d] >= 0 ? met.directions.impulse(of_motion[d]) : 0.0,
                       velocity_interval, state);
}

void Stoppers::book_opening_work(double dt) {
  // Both halves together are the impulse times the mean of the velocities before and after, whatever the two steps.
  for (Stop& stop : stops_) {
    work_ += 0.25 * stop.force * ((dt + dt_previous_) * stop.velocity + (dt - dt_previous_) * stop.before);
    if (stop.card->rotation) stop.angle += stop.velocity * dt;
  }
}

void Stoppers::Stop::archive(Archive& a) {
  a(force, before, velocity, angle);
  a.built(card, body);
}

void Stoppers::archive(Archive& a) {
  a(stops_, work_, dt_previous_);
  a.built(system_, groups_, motions_known_, power_on_change_);
}

}  // namespace nugget::impact
