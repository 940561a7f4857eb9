// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/tie_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "base/index.hpp"
#include "kernel/contact/penalty.hpp"
#include "model/segments.hpp"
#include "system/share.hpp"
#include "weld/tie/tie_findings.hpp"

namespace nugget::impact {
namespace {

using Matrix3 = system::Mobility::Matrix;
using Block = system::ConstraintMap::Block;

/// How a node moves with independent ones; itself where it is independent.
std::vector<Block> motion_of(const system::System& system, int node) {
  if (system.map.dependent(node)) {
    std::vector<Block> blocks = system.map.blocks(node);
    return blocks;
  }
  Block own{node, {}};
  for (std::size_t i = 0; i < 6; ++i) own.of[i][i] = 1.0;
  return {own};
}

/// Of a spring's node less its anchor.
std::map<int, Block> relative_motion(const system::System& system, int node, int anchor) {
  std::map<int, Block> sum;
  const auto add = [&](int of, double sign) {
    for (const Block& b : motion_of(system, of)) {
      Block& s = sum.try_emplace(b.node, Block{b.node, {}}).first->second;
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) s.of[i][j] += sign * b.of[i][j];
    }
  };
  add(node, 1.0);
  add(anchor, -1.0);
  return sum;
}

double volume(const std::array<Vec3d, 8>& x) {
  constexpr int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  double v = 0.0;
  for (const auto& f : faces) {
    const Vec3d &a = x[f[0]], &b = x[f[1]], &c = x[f[2]], &d = x[f[3]];
    v += dot(0.25 * (a + b + c + d) - x[0], 0.5 * cross(c - a, d - b)) / 3.0;
  }
  return std::abs(v);
}

/// Nodes that do not move freely, whatever pulls them.
std::set<int> supported_nodes(const system::System& system) {
  std::set<int> supported;
  for (const model::SinglePointConstraint& spc : system.model.spcs)
    if ((spc.fixed & 7u) != 0) supported.insert(system.node_of[spc.node]);
  for (const model::PrescribedMotion& motion : system.model.motions)
    if (motion.target == model::PrescribedMotion::Target::nodes)
      for (const model::Index n : motion.nodes) supported.insert(system.node_of[n]);
  return supported;
}

/// Volume of the brick behind a face; 0 if there is none.
double volume_behind(const model::Model& model, const std::vector<Vec3d>& x, const model::Segment& face,
                     model::Index part) {
  for (std::size_t e = 0; e < model.solids.size(); ++e) {
    if (model.solids.part[e] != part) continue;
    const auto& n = model.solids.node[e];
    const std::span<const model::Index> all = model.solids.nodes(e);
    const auto has = [&](model::Index k) { return std::ranges::find(all, k) != all.end(); };
    if (!std::all_of(face.begin(), face.end(), has)) continue;
    std::array<Vec3d, 8> place;
    for (std::size_t a = 0; a < 8; ++a) place[a] = x[n[a]];
    return volume(place);
  }
  return 0.0;
}

}  // namespace

TieForces::TieForces(const system::System& system) : system_(system) {
  for (const system::System::TieSpring& s : system.springs) {
    const weld::Tie& tie = system.ties.ties[s.tie];
    Spring spring;
    spring.tie = s.tie;
    spring.node = s.node;
    spring.anchor = s.anchor;
    spring.rotary = tie.rotations;
    if (!tie.lever) spring.gap = system.ties.x[tie.node] - tie.point;
    set_stiffness(spring);
    springs_.push_back(spring);
  }
  for (std::size_t t = 0; t < system.ties.ties.size(); ++t) {
    const weld::Tie& tie = system.ties.ties[t];
    if (!tie.spring && system.model.contacts[tie.contact].tie_by_springs())
      stand_ins_.push_back({t, system.node_of[tie.node], {}});
  }
}

void TieForces::store_loads(const system::State& state) {
  for (StandIn& s : stand_ins_) s.force = system_.map.dependent(s.node) ? -vec(state.f[s.node]) : Vec3d{};
}

void TieForces::set_stiffness(Spring& spring) const {
  const model::Model& model = system_.model;
  const weld::Tie& tie = system_.ties.ties[spring.tie];
  const std::vector<Vec3d>& x = system_.ties.x;
  const auto corner = [&](std::size_t i) { return x[tie.segment[i]]; };
  const Vec3d d1 = corner(2) - corner(0), d2 = corner(3) - corner(1);
  const double area = 0.5 * norm(cross(d1, d2));
  double bulk_modulus = 0.0;
  if (tie.part != model::none) {
    const model::Material& material = model.materials[model.parts[tie.part].material];
    bulk_modulus = material.young() / (3.0 * (1.0 - 2.0 * std::min(material.poisson(), 0.49)));
  }
  const double behind = tie.shell == model::none ? volume_behind(model, x, tie.segment, tie.part) : 0.0;
  double diagonal = std::max(norm(d1), norm(d2));
  if (tie.segment[3] == tie.segment[2])  // of a triangle: its longest side
    diagonal = std::max({norm(d1), norm(d2), norm(corner(1) - corner(0))});
  const double k = behind > 0.0 ? kernel::solid_penalty(bulk_modulus, area, behind)
                                : kernel::shell_penalty(bulk_modulus, area, diagonal);
  spring.stiffness = model.contacts[tie.contact].stiffness_scale_a * k;
  spring.rotary_stiffness = spring.stiffness * area;
}

void TieForces::find_bounds() {
  if (springs_.empty()) return;
  std::vector<std::map<int, Block>> motion;
  std::vector<int> springs_at(system_.all_nodes(), 0);
  for (const Spring& s : springs_) {
    motion.push_back(relative_motion(system_, s.node, s.anchor));
    for (const auto& [node, block] : motion.back()) ++springs_at[node];
  }
  const double scale = system_.model.control.step_scale;
  const double stability_limit = std::min(0.5, 3.0 * std::max(1.0 - scale * scale, 0.02));
  for (std::size_t i = 0; i < springs_.size(); ++i) {
    Matrix3 g{}, rotary{};
    for (const auto& [node, block] : motion[i]) {
      const double share = springs_at[node];
      double inverse_mass = 0.0;
      Matrix3 inverse_inertia{};
      if (at(node) < system_.nodes) {
        const double m = system_.mass[node], j = system_.inertia[node];
        if (m > 0.0) inverse_mass = share / m;
        for (std::size_t k = 0; k < 3; ++k)
          if (j > 0.0) inverse_inertia[k][k] = share / j;
      } else {
        const system::RigidBody& body = system_.bodies[at(node) - system_.nodes];
        if (body.mass > 0.0) inverse_mass = share / body.mass;
        inverse_inertia = system::inverse_inertia(body);
        for (auto& row : inverse_inertia)
          for (double& c : row) c *= share;
      }
      system::add_inverse_mass(g, block, 0, inverse_mass, inverse_inertia);
      system::add_inverse_mass(rotary, block, 3, inverse_mass, inverse_inertia);
    }
    Spring& s = springs_[i];
    const double part = s.rotary ? 0.5 * stability_limit : stability_limit;
    s.bound = system::Mobility::largest(g) > 0.0 ? part / system::Mobility::largest(g) : 0.0;
    s.rotary_bound =
        s.rotary && system::Mobility::largest(rotary) > 0.0 ? part / system::Mobility::largest(rotary) : 0.0;
  }
}

double TieForces::longest_next_step() const {
  constexpr double growth = 1.15;  // its square is less than the 4/3 between `stability_limit` and what elements leave
  const auto holds = [](const Spring& s) { return !s.released; };
  return longest_step_ > 0.0 && std::ranges::any_of(springs_, holds) ? growth * longest_step_
                                                                     : std::numeric_limits<double>::infinity();
}

void TieForces::apply(system::State& state) {
  const double dt = state.dt;
  longest_step_ = std::max(longest_step_, dt);
  for (Spring& s : springs_) {
    if (s.ended) continue;
    const std::size_t n = at(s.node), a = at(s.anchor);
    const Vec3d rate = vec(state.v[n]) - vec(state.v[a]), turning = vec(state.w[n]) - vec(state.w[a]);
    if (s.released) {  // its last force acted in the step that ends now
      energy_ -= 0.5 * dt * (dot(s.force, rate) + dot(s.moment, turning));
      s.force = s.moment = {};
      s.ended = true;
      continue;
    }
    const Vec3d force_before = s.force, moment_before = s.moment;
    const auto limited = [&](double stiffness, double bound) {
      return longest_step_ > 0.0 ? std::min(stiffness, bound / (longest_step_ * longest_step_)) : stiffness;
    };
    s.force = -limited(s.stiffness, s.bound) * (vec(state.x[n]) - vec(state.x[a]) - s.gap);
    if (s.rotary) {
      s.angle = system::turned(s.angle, (0.5 * dt) * (vec(state.w[n]) + vec(state.w[a]))) + dt * turning;
      s.moment = -limited(s.rotary_stiffness, s.rotary_bound) * s.angle;
      add(state.m[n], s.moment);
      add(state.m[a], -s.moment);
    }
    add(state.f[n], s.force);
    add(state.f[a], -s.force);
    energy_ -= 0.5 * dt * (dot(force_before + s.force, rate) + dot(moment_before + s.moment, turning));
  }
}

void TieForces::release(std::size_t tie) {
  for (Spring& s : springs_) s.released |= s.tie == tie;
}

Vec3d TieForces::resultant(model::Index contact) const {
  Vec3d sum{};
  for (const Spring& s : springs_)
    if (system_.ties.ties[s.tie].contact == contact && !s.released) sum += s.force;
  for (const StandIn& s : stand_ins_)
    if (system_.ties.ties[s.tie].contact == contact) sum += s.force;
  return sum;
}

std::map<int, Matrix3> TieForces::stiffness_of_surroundings(const system::State& start) const {
  std::map<int, Matrix3> sum;
  for (const Spring& s : springs_) {
    sum[s.node];
    for (const model::Index n : system_.ties.ties[s.tie].segment) sum[system_.node_of[n]];
  }
  std::vector<double> k;
  for (const auto& group : system_.groups)
    for (std::size_t e = 0; e < group->size(); ++e) {
      const system::ElementNodes nodes = group->nodes(e);
      const std::size_t freedoms = at(group->freedoms()), size = at(group->nodes_per_element) * freedoms;
      const auto asked = [&](int node) { return sum.contains(node); };
      if (std::none_of(nodes.begin(), nodes.begin() + group->nodes_per_element, asked)) continue;
      k.assign(size * size, 0.0);
      group->stiffness(e, start, k);
      for (int a = 0; a < group->nodes_per_element; ++a) {
        if (!asked(nodes[a])) continue;
        Matrix3& of_node = sum[nodes[a]];
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) of_node[i][j] += k[(at(a) * freedoms + i) * size + at(a) * freedoms + j];
      }
    }
  return sum;
}

void TieForces::report_weak(const system::State& start, double step, Findings& findings) const {
  constexpr double enough = 0.95;
  const model::Model& model = system_.model;
  const std::map<int, Matrix3> surroundings = stiffness_of_surroundings(start);
  const std::set<int> supported = supported_nodes(system_);
  const auto give = [&](int node) {  // of what holds a node, 1 / its stiffness; bodies and supports give nothing
    const double k = system::Mobility::largest(surroundings.at(node));
    return k > 0.0 && system_.rigid_body_of_node(node) < 0 && !supported.contains(node) ? 1.0 / k : 0.0;
  };
  struct Weak {
    int springs = 0, weak = 0;
    double least = 1.0, spring = 0.0, tied = 0.0;
    model::Index node = model::none;
    bool limited = false;  // by the step
  };
  std::vector<Weak> of_contact(model.contacts.size());
  for (const Spring& s : springs_) {
    const weld::Tie& tie = system_.ties.ties[s.tie];
    double rest = give(s.node);
    for (std::size_t i = 0; i < 4; ++i) rest += tie.weight[i] * tie.weight[i] * give(system_.node_of[tie.segment[i]]);
    const double spring = step > 0.0 ? std::min(s.stiffness, s.bound / (step * step)) : s.stiffness;
    Weak& w = of_contact[tie.contact];
    ++w.springs;
    if (!(rest > 0.0)) continue;
    const double share = 1.0 / (1.0 + 1.0 / (rest * spring));
    w.weak += share < enough;
    if (share < w.least) w = {w.springs, w.weak, share, spring, 1.0 / rest, tie.node, spring < s.stiffness};
  }
  for (std::size_t c = 0; c < of_contact.size(); ++c) {
    const Weak& w = of_contact[c];
    if (w.weak == 0) continue;
    findings.warning(
        model.contacts[c].place, weld::name_contact(model.contacts[c]),
        fmt::format(
            "{} of {} nodes tied by springs carry less than 95 % of what a constraint would, as little as {:.2g} "
            "%: at node {} a spring of {:.3g} holds elements of {:.3g}{}",
            w.weak, w.springs, 100.0 * w.least, model.nodes.id[w.node], w.spring, w.tied,
            w.limited ? fmt::format("; its mass and a step of {:.3g} bear no stiffer one", step) : ""),
        w.limited ? "free the node and its segment of bodies, supports and other ties, so that a constraint holds it"
                  : "a larger SFSA; 1 and more tie by constraint where nothing else holds the node");
  }
}

void TieForces::carry(system::Carried, const system::System::Computed& of, system::Parcel& parcel) {
  for (StandIn& s : stand_ins_)
    if (!of.share.everyone_follows(s.node) && of.share.answering(s.node) == of.rank) parcel(&s.force, 1);
}

void TieForces::archive(Archive& a) {
  a(springs_, stand_ins_, longest_step_, energy_);
  a.built(system_);
}

}  // namespace nugget::impact
