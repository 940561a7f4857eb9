// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/rivets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"

namespace nugget::impact {
namespace {

using Matrix = std::array<Vec3d, 3>;

constexpr Matrix identity{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};

Vec3d times(const Matrix& m, const Vec3d& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}

/// Takes a direction out of what the matrix lets through: a projection before and after, whether or not it is at right
/// angles to those that are out already.
void remove_direction(Matrix& m, const Vec3d& axis) {
  const Vec3d left = times(m, axis);
  if (norm(left) < 1e-6) return;
  const Vec3d n = unit(left);
  for (Vec3d& row : m) row = row - dot(row, n) * n;
}

}  // namespace

Rivets::Rivets(const system::System& system, Findings& findings) : system_(system) {
  for (const model::RigidWeld& source : system.model.rigid_welds) {
    if (source.kind != model::RigidWeld::Kind::rivet) continue;
    Rivet rivet{};
    rivet.source = &source;
    for (std::size_t end = 0; end < 2; ++end) {
      rivet.node[end] = at(system.node_of[source.nodes[end]]);
      rivet.mobility[end] = identity;
      const auto refuse = [&](const std::string& why) {
        findings.error(
            source.place, "*CONSTRAINED_RIVET",
            fmt::format("node {} {}, and a rivet cannot pull it", system.model.nodes.id[source.nodes[end]], why),
            "rivet free nodes of sheets");
      };
      if (system.map.dependent(static_cast<int>(rivet.node[end])))
        refuse("moves with " + system.constraint_name(static_cast<int>(rivet.node[end])));
      else if (!(system.mass[rivet.node[end]] > 0.0))
        refuse("has no mass");
    }
    const auto place = [&](std::size_t end) { return system.ties.x[source.nodes[end]]; };
    rivet.length = norm(place(1) - place(0));
    rivets_.push_back(rivet);
  }
  find_constrained_directions(findings);
}

void Rivets::find_constrained_directions(Findings& findings) {
  const model::Model& model = system_.model;
  const auto refuse = [&](const Rivet& rivet, model::Index node, std::string_view why) {
    findings.error(rivet.source->place, "*CONSTRAINED_RIVET",
                   fmt::format("node {} {}: not built for a node of a rivet", model.nodes.id[node], why),
                   "rivet other nodes");
  };
  for (Rivet& rivet : rivets_)
    for (std::size_t end = 0; end < 2; ++end) {
      const model::Index node = rivet.source->nodes[end];
      for (const model::SinglePointConstraint& spc : model.spcs) {
        if (spc.node != node || (spc.fixed & 7u) == 0) continue;
        if (!spc.holds_until(model::forever)) refuse(rivet, node, "is held for a time");
        const Frame3d axes =
            spc.system == model::none ? Frame3d{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}} : model.systems[spc.system].axes;
        const std::array<Vec3d, 3> axis{axes.e1, axes.e2, axes.e3};
        for (unsigned i = 0; i < 3; ++i)
          if (spc.fixed >> i & 1u) remove_direction(rivet.mobility[end], axis[i]);
      }
      for (const model::PrescribedMotion& motion : model.motions)
        if (motion.target == model::PrescribedMotion::Target::nodes && !motion.rotation &&
            std::find(motion.nodes.begin(), motion.nodes.end(), node) != motion.nodes.end())
          refuse(rivet, node, "is driven");
    }
}

void Rivets::apply(system::State& state, double velocity_interval, std::span<const double> inverse_mass) {
  constexpr double accuracy = 1e-13;  // of the length
  constexpr int most = 200;
  for (Rivet& rivet : rivets_) {
    rivet.force = 0.0;
    if (!rivet.failed && rivet.source->failure_time > 0.0 && state.time >= rivet.source->failure_time)
      end(rivet, state);
  }
  for (int i = 0; i < most; ++i) {
    bool all_hold = true;
    for (Rivet& rivet : rivets_) {
      if (rivet.failed || length_error(rivet, state, velocity_interval, inverse_mass) <= accuracy * rivet.length)
        continue;
      all_hold = false;
      pull(rivet, state, velocity_interval, inverse_mass);
    }
    if (all_hold) break;
  }
  for (Rivet& rivet : rivets_) rivet.peak = std::max(rivet.peak, std::abs(rivet.force));
}

/// The line from node 1 to node 2 when the step is over.
static Vec3d line_after(const std::array<std::size_t, 2>& node, const std::array<Matrix, 2>& mobility,
                        const system::State& state, double velocity_interval, std::span<const double> inverse_mass) {
  const auto step = [&](std::size_t end) {
    const std::size_t k = node[end];
    return state.dt * times(mobility[end], vec(state.v[k]) + velocity_interval * inverse_mass[k] * vec(state.f[k]));
  };
  // Differences first: far from the origin a sum of coordinates would be too coarse for the accuracy asked for.
  return (vec(state.x[node[1]]) - vec(state.x[node[0]])) + (step(1) - step(0));
}

double Rivets::length_error(const Rivet& rivet, const system::State& state, double velocity_interval,
                            std::span<const double> inverse_mass) const {
  return std::abs(norm(line_after(rivet.node, rivet.mobility, state, velocity_interval, inverse_mass)) - rivet.length);
}

/// Solves |r + F b| = L for the smaller |F|: r the line after the step, b how it moves with a unit of tension.
void Rivets::pull(Rivet& rivet, system::State& state, double velocity_interval, std::span<const double> inverse_mass) {
  const Vec3d now = vec(state.x[rivet.node[1]]) - vec(state.x[rivet.node[0]]);
  const Vec3d n = unit(now);
  const Vec3d r = line_after(rivet.node, rivet.mobility, state, velocity_interval, inverse_mass);
  Vec3d b{};
  for (std::size_t end = 0; end < 2; ++end)
    b += (-state.dt * velocity_interval * inverse_mass[rivet.node[end]]) * times(rivet.mobility[end], n);
  // |r|^2 - L^2 + 2 F (r.b) + F^2 b.b = 0
  const double c = dot(r, r) - rivet.length * rivet.length, half = dot(r, b), a = dot(b, b);
  const double root = half * half - a * c;
  if (a == 0.0 || root < 0.0) return;  // both ends held, or turned by more than the truss can follow in one step
  const double force = -c / (half + std::copysign(std::sqrt(root), half));
  add(state.f[rivet.node[0]], force * n);
  add(state.f[rivet.node[1]], -force * n);
  rivet.force += force;
}

void Rivets::end(Rivet& rivet, const system::State& state) {
  rivet.failed = true;
  rivet.failure_time = state.time;
  ++failed_;
  events_.push_back(
      fmt::format("rivet failed  id={:8d} time={:12.5E} cycle={} by time", rivet.source->id, state.time, state.cycle));
}

std::size_t Rivets::find(int id) const {
  const auto has = [id](const Rivet& rivet) { return rivet.source->id == id; };
  return static_cast<std::size_t>(std::find_if(rivets_.begin(), rivets_.end(), has) - rivets_.begin());
}

double Rivets::length(std::size_t i, const system::State& state) const {
  const std::array<std::size_t, 2>& node = rivets_[i].node;
  return norm(vec(state.x[node[1]]) - vec(state.x[node[0]]));
}

void Rivets::Rivet::archive(Archive& a) {
  a(force, peak, failed, failure_time);
  a.built(source, node, mobility, length);
}

void Rivets::archive(Archive& a) {
  a(rivets_, failed_, events_);
  a.built(system_);
}

}  // namespace nugget::impact
