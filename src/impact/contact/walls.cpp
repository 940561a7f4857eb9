// SPDX-License-Identifier: Apache-2.0
#include "impact/contact/walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "impact/conditions/directions.hpp"
#include "system/parcel.hpp"
#include "system/share.hpp"

namespace nugget::impact {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A wall leaves alone what is tied, and what belongs to a rigid body unless RWPNAL has it stopped by penalty.
void report_constrained_nodes(const model::RigidWall& wall, const std::vector<int>& nodes, const system::System& system,
                              Findings& findings) {
  const bool by_penalty = system.model.control.wall_penalty > 0.0;
  const auto constrained = std::count_if(nodes.begin(), nodes.end(), [&](int n) {
    return system.map.dependent(n) && !(by_penalty && system.rigid_body_of_node(n) >= 0);
  });
  if (constrained > 0)
    findings.note(wall.place, "*RIGIDWALL",
                  fmt::format("{} of the nodes of wall {} are tied{}: the wall stops what they are tied to, not them",
                              constrained, wall.id, by_penalty ? "" : " or belong to nodal rigid bodies"));
}

struct HeldTranslations {
  std::vector<Vec3d> directions;  // at right angles
  bool driven = false;
};

/// What an SPC or a motion takes of a node's translations, by node; of those that a wall tracks.
std::map<model::Index, HeldTranslations> held_directions(const model::RigidWall& wall, const model::Model& model) {
  std::map<model::Index, HeldTranslations> held;
  const auto add = [&](model::Index node, const Vec3d& direction, bool driven) {
    if (!std::ranges::binary_search(wall.nodes, node)) return;
    held[node].driven = held[node].driven || driven;
    std::vector<Vec3d>& known = held[node].directions;
    Vec3d rest = direction;
    for (const Vec3d& a : known) rest -= dot(a, rest) * a;
    if (const double left = norm(rest); left > 1e-3) known.push_back((1.0 / left) * rest);
  };
  const Frame3d global{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const model::SinglePointConstraint& spc : model.spcs) {
    const Frame3d& axes = spc.system == model::none ? global : model.systems[spc.system].axes;
    if ((spc.fixed & 1u) != 0) add(spc.node, axes.e1, false);
    if ((spc.fixed & 2u) != 0) add(spc.node, axes.e2, false);
    if ((spc.fixed & 4u) != 0) add(spc.node, axes.e3, false);
  }
  for (const model::PrescribedMotion& motion : model.motions)
    if (motion.target == model::PrescribedMotion::Target::nodes && !motion.rotation && !motion.circular)
      for (const model::Index node : motion.nodes) {
        add(node, motion.direction, true);
        if (motion.only_direction) continue;
        for (const Vec3d& across : normals(motion.direction)) add(node, across, true);
      }
  return held;
}

/// A node that is held along the normal of a plane wall goes through it: of no concern where neither moves.
void report_nodes_held_along_the_normal(const model::RigidWall& wall, const model::Model& model, Findings& findings) {
  if (wall.shape != model::RigidWall::Shape::plane) return;
  const bool moves = wall.mass > 0.0 || wall.motion_curve != model::none;
  std::size_t count = 0;
  model::Index first = model::none;
  for (const auto& [node, found] : held_directions(wall, model)) {
    double share = 0.0;  // of the normal, squared
    for (const Vec3d& a : found.directions) share += dot(a, wall.normal) * dot(a, wall.normal);
    if (share <= 1.0 - contact::RigidWall::least_free || !(moves || found.driven)) continue;
    ++count;
    if (first == model::none) first = node;
  }
  if (count > 0)
    findings.warning(wall.place, "*RIGIDWALL",
                     fmt::format("{} of the nodes of wall {}, first node {}, are held or driven along its normal, so "
                                 "that it does not stop them",
                                 count, wall.id, model.nodes.id[first]),
                     "leave them out of the wall's nodes where they meet it");
}

/// Of any node, infinite where one is no number; the same on all ranks.
double largest_speed(const system::System& system, std::span<const Row> v) {
  std::atomic<double> found{0.0};
  system.for_each_node(4096, [&](std::size_t begin, std::size_t end) {
    double largest = 0.0;
    for (const Row& r : v.subspan(begin, end - begin)) {
      const double square = r.x * r.x + r.y * r.y + r.z * r.z;
      largest = square <= largest ? largest : square <= std::numeric_limits<double>::max() ? square : infinity;
    }
    for (double now = found; now < largest && !found.compare_exchange_weak(now, largest);) {
    }
  });
  double largest = found;
  if (const system::Share* share = system.share())
    for (const double of_rank : gather(share->ranks(), largest)) largest = std::max(largest, of_rank);
  return std::sqrt(largest);
}

}  // namespace

Walls::Walls(const system::System& system, Findings& findings) {
  const model::Model& model = system.model;
  for (const model::RigidWall& wall : model.walls) {
    std::vector<int> nodes;
    for (model::Index n : wall.nodes) nodes.push_back(system.node_of[n]);
    report_constrained_nodes(wall, nodes, system, findings);
    report_nodes_held_along_the_normal(wall, model, findings);
    const Curve* curve = wall.motion_curve == model::none ? nullptr : &model.curves[wall.motion_curve];
    std::optional<contact::WallPenalty> bodies;
    if (const double scale = model.control.wall_penalty; scale > 0.0) bodies.emplace(system, wall, nodes, scale);
    if (bodies && !bodies->empty() && wall.friction >= 2.0)
      findings.warning(wall.place, "*RIGIDWALL",
                       fmt::format("FRIC {:g}: nodes of rigid bodies stay on wall {} only as long as they are pressed "
                                   "on it, {}",
                                   wall.friction, wall.id, wall.friction == 2.0 ? "without friction" : "and stick"),
                       "hold such bodies by a constraint if they are to stay there");
    walls_.emplace_back(wall, std::move(nodes), curve, std::move(bodies));
    if (wall.control != model::none) walls_.back().turn(model.sensor_controls[wall.control].starts_on);
    for (const model::Segment& area : wall.areas) {
      std::array<Vec3d, 4> corners;
      for (std::size_t i = 0; i < 4; ++i) corners[i] = model.nodes.x[area[i]];
      walls_.back().sum_apart(corners);
    }
  }
  for (const model::WallTransducer& transducer : model.wall_transducers) {
    std::vector<int> nodes;
    for (const model::Index n : transducer.nodes) nodes.push_back(system.node_of[n]);
    std::ranges::sort(nodes);
    transducers_.push_back({transducer.wall, walls_[transducer.wall].sum_apart(std::move(nodes))});
  }
}

void Walls::constrain(const system::System& system, system::State& state, std::span<const unsigned char> dependent,
                      contact::HeldNodes& supports, double& power_on_change) {
  const model::Model& model = system.model;
  // Worth while where walls look at most nodes.
  std::size_t tracked = 0;
  for (const contact::RigidWall& w : walls_) tracked += w.tracked();
  const double fastest = 2 * tracked > state.v.size() ? largest_speed(system, state.v) : infinity;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const model::RigidWall& card = model.walls[w];
    walls_[w].turn(state.acts(card.control));
    double time = state.time;
    // The step at the end of the run is not taken, but the wall's force then is that of half of it. A motion whose
    // curve ends there continues as in the step before.
    if (card.motion_curve != model::none && model.control.end_time > 0.0 && time >= model.control.end_time &&
        std::abs(model.curves[card.motion_curve].x.back() + card.birth - time) <= 1e-6 * state.dt)
      time -= state.dt;
    walls_[w].constrain(time, state.dt, state.dt_previous, state.x, state.v, state.f, system.mass, dependent, fastest,
                        system.share(), &supports);
    power_on_change += walls_[w].power_on_change();
    if (state.period > 1) walls_[w].average(system::time_of_mean(state), state.begins_period());
  }
}

void Walls::carry(system::Carried what, const system::System::Computed& of, system::Parcel& parcel) {
  if (what != system::Carried::restart) return;
  for (contact::RigidWall& w : walls_) w.carry(of.rank, of.share, parcel);
}

void Walls::press(const contact::Step& step, std::span<Row> force) {
  for (contact::RigidWall& w : walls_) w.press(step, force);
}

void Walls::add_energy(Energy& energy) const {
  for (const contact::RigidWall& w : walls_) energy.wall += w.energy_at_time();
}

}  // namespace nugget::impact
