// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/loads.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/index.hpp"
#include "impact/conditions/in_force.hpp"

namespace nugget::impact {
namespace {

const Curve& curve(const system::System& s, model::Index c) {
  return s.model.curves[static_cast<std::size_t>(c)];
}

/// The curve's value at `time`, zero in a phase that it is not for. A time that round-off puts behind the last point
/// (an end time by an expression) is there: the last row of a run has its loads.
double value(const Curve& c, double time, const system::State& state) {
  if (!in_force(c, state)) return 0.0;
  const double end = c.x.back();
  return c.zero_outside(time > end && time - end <= 1e-9 * time ? end : time);
}

/// Area vector of a segment, along its right-hand normal.
Vec3d area(const std::array<Vec3d, 4>& x, bool triangle) {
  return triangle ? 0.5 * cross(x[1] - x[0], x[2] - x[0]) : 0.5 * cross(x[2] - x[0], x[3] - x[1]);
}

}  // namespace

Loads::Loads(const system::System& system) : system_(system) {
  const model::Model& model = system.model;
  for (const model::NodalLoad& load : model.nodal_loads) {
    Nodal n{&load, {}, {}};
    for (model::Index i : load.nodes) n.nodes.push_back(system.node_of[static_cast<std::size_t>(i)]);
    if (load.rigid_body != model::none)
      n.nodes.push_back(
          system.bodies[static_cast<std::size_t>(system.body_of[static_cast<std::size_t>(load.rigid_body)])].node);
    nodal_.push_back(std::move(n));
  }
  for (const model::PressureLoad& load : model.pressure_loads)
    pressure_.push_back({&load, std::vector<Vec3d>(4 * load.segments.size())});
  for (const model::ControlVolume& volume : model.control_volumes) {
    const double v = volume.volume_scale * enclosed_volume(volume.segments, volume.openings,
                                                           [&](model::Index n) { return model.nodes.x[at(n)]; });
    volumes_.push_back({&volume, v, v, 0.0, 1.0, 0.0, false, {}, std::vector<Vec3d>(4 * volume.segments.size())});
    if (volume.gas == model::ControlVolume::Gas::flowing) volumes_.back().bag = bag_at_start(volume, v);
  }
  for (const model::BodyLoad& load : model.body_loads)
    body_.push_back({&load, {}, {}, 0.0, std::vector<Vec3d>(load.centrifugal ? system.all_nodes() : 0)});
  update_load_masses();
}

/// By node as its elements have it: what mass scaling added and EMSCL leaves without weight [mass].
std::vector<double> Loads::nodes_without_weight() const {
  const double share = 1.0 - system_.model.control.weight_of_added_mass;
  std::vector<double> without(system_.nodes, 0.0);
  for (const auto& group : system_.groups) {
    if (group->added_mass_is_physical) continue;
    for (std::size_t e = 0; e < group->size(); ++e) {
      const double added = group->mass_scale(e) - 1.0;
      if (!(added > 0.0)) continue;
      const auto nodes = group->nodes(e);
      for (int a = 0; a < group->nodes_per_element; ++a)
        without[at(nodes[at(a)])] += share * added * group->nodal_mass(e, a);
    }
  }
  return without;
}

void Loads::update_load_masses() {
  for (Body& body : body_) {
    body.nodes.clear();
    body.mass.clear();
    if (!body.load->nodes.empty())
      load_nodes(body);
    else if (body.load->parts.empty())
      load_everything(body);
    else
      load_parts(body);
  }
}

void Loads::load_everything(Body& body) const {
  const std::vector<double> own = nodes_without_weight();
  std::vector<double> without(system_.nodes + system_.bodies.size(), 0.0);
  for (std::size_t k = 0; k < system_.nodes; ++k) {
    if (!system_.map.dependent(static_cast<int>(k)))
      without[k] += own[k];
    else
      for (const system::ConstraintMap::Term& t : system_.map.terms(static_cast<int>(k)))
        without[at(t.node)] += t.weight * own[k];
  }
  for (std::size_t k = 0; k < without.size(); ++k) {
    const bool rigid = k >= system_.nodes;
    // The mass that a deck gives a body is not that of its elements, scaled or not.
    if (rigid && system_.model.rigid_bodies[at(system_.bodies[k - system_.nodes].source)].given) without[k] = 0.0;
    const double m = (rigid ? system_.bodies[k - system_.nodes].mass : system_.mass[k]) - without[k];
    if (m <= 0.0) continue;
    body.nodes.push_back(static_cast<int>(k));
    body.mass.push_back(m);
  }
}

/// The parts' own nodal masses; what they put on dependent nodes reaches the independent ones through `collect`.
void Loads::load_parts(Body& body) const {
  const std::vector<model::Index>& parts = body.load->parts;
  const auto wanted = [&](model::Index part) { return std::find(parts.begin(), parts.end(), part) != parts.end(); };
  std::map<int, double> mass;
  for (const auto& group : system_.groups) {
    if (!wanted(group->part)) continue;
    for (std::size_t e = 0; e < group->size(); ++e) {
      const auto nodes = group->nodes(e);
      const double added = group->mass_scale(e) - 1.0;
      const double weight =
          1.0 + (group->added_mass_is_physical ? added : system_.model.control.weight_of_added_mass * added);
      for (int a = 0; a < group->nodes_per_element; ++a)
        mass[nodes[static_cast<std::size_t>(a)]] += weight * group->nodal_mass(e, a);
    }
  }
  // Rigid parts, and what else has mass without a kernel. A body of given mass weighs that, not what its mesh would.
  struct Mesh {
    double wanted = 0.0, all = 0.0;
  };
  std::map<model::Index, Mesh> meshes;
  for (const system::System::MassOnlyElement& mass_only : system_.mass_only_elements()) {
    const model::Index source = system_.model.parts[at(mass_only.part)].rigid_body;
    const bool given = source != model::none && system_.model.rigid_bodies[at(source)].given;
    if (given) {
      meshes[source].all += mass_only.mass;
      if (wanted(mass_only.part)) meshes[source].wanted += mass_only.mass;
    } else if (wanted(mass_only.part)) {
      for (int a = 0; a < mass_only.corners; ++a)
        mass[mass_only.node[static_cast<std::size_t>(a)]] += mass_only.nodal_mass(a);
    }
  }
  for (const auto& [source, mesh] : meshes) {
    const system::RigidBody& rigid = system_.bodies[at(system_.body_of[at(source)])];
    if (mesh.wanted > 0.0) mass[rigid.node] += mesh.wanted / mesh.all * rigid.mass;
  }
  for (const auto& [node, m] : mass) {
    body.nodes.push_back(node);
    body.mass.push_back(m);
  }
}

/// The nodes of a set with their own masses. A rigid body that is in the set as a whole weighs what it weighs: its
/// given mass is not that of its nodes.
void Loads::load_nodes(Body& body) const {
  const model::Model& model = system_.model;
  std::vector<char> wanted(system_.nodes, 0);
  const auto place = [&](model::Index n) { return at(system_.node_of[at(n)]); };
  for (const model::Index n : body.load->nodes) wanted[place(n)] = 1;
  const auto take = [&](int node, double mass) {
    if (!(mass > 0.0)) return;
    body.nodes.push_back(node);
    body.mass.push_back(mass);
  };
  for (const system::RigidBody& rigid : system_.bodies) {
    const std::vector<model::Index>& nodes = model.rigid_bodies[at(rigid.source)].nodes;
    if (!std::all_of(nodes.begin(), nodes.end(), [&](model::Index n) { return wanted[place(n)] != 0; })) continue;
    for (const model::Index n : nodes) wanted[place(n)] = 0;
    take(rigid.node, rigid.mass);
  }
  const std::vector<double> without = nodes_without_weight();
  for (std::size_t k = 0; k < system_.nodes; ++k)
    if (wanted[k]) take(static_cast<int>(k), system_.own_mass[k] - without[k]);
}

void Loads::apply(system::State& state, double dt) {
  for (Nodal& n : nodal_) apply(n, state, dt);
  for (Pressure& p : pressure_) apply(p, state, dt);
  for (Volume& v : volumes_) apply(v, state, dt);
  for (Body& b : body_) apply(b, state, dt);
}

void Loads::apply(Nodal& nodal, system::State& state, double dt) {
  const model::NodalLoad& load = *nodal.load;
  Vec3d direction = load.direction;
  if (load.follower_nodes[0] != model::none) {
    std::array<Vec3d, 3> x;
    for (std::size_t i = 0; i < 3; ++i)
      x[i] = vec(state.x[static_cast<std::size_t>(system_.node_of[static_cast<std::size_t>(load.follower_nodes[i])])]);
    direction = unit(cross(x[1] - x[0], x[2] - x[0]));
  }
  const Vec3d force = load.scale * value(curve(system_, load.curve), state.time, state) * direction;
  for (int node : nodal.nodes) {
    const auto k = static_cast<std::size_t>(node);
    const Vec3d velocity = vec(load.moment ? state.w[k] : state.v[k]);
    work_ += 0.5 * dt * dot(nodal.last + force, velocity);
    add(load.moment ? state.m[k] : state.f[k], force);
  }
  nodal.last = force;
}

void Loads::apply(Pressure& pressure, system::State& state, double dt) {
  const model::PressureLoad& load = *pressure.load;
  const double time = state.time - load.arrival;
  const double p = time >= 0.0 ? load.scale * value(curve(system_, load.curve), time, state) : 0.0;
  press(load.segments, load.share, p, pressure.last, state, dt);
}

void Loads::press(const std::vector<model::Segment>& segments, const std::vector<model::CornerShares>& shares,
                  double pressure, std::vector<Vec3d>& lasts, system::State& state, double dt) {
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const model::Segment& segment = segments[s];
    const bool triangle = segment[3] == segment[2];
    const std::size_t corners = triangle ? 3 : 4;
    std::array<std::size_t, 4> k{};
    std::array<Vec3d, 4> x;
    for (std::size_t a = 0; a < 4; ++a) {
      k[a] = static_cast<std::size_t>(system_.node_of[static_cast<std::size_t>(segment[a])]);
      x[a] = vec(state.x[k[a]]);
    }
    const Vec3d force = -pressure * area(x, triangle);
    for (std::size_t a = 0; a < corners; ++a) {
      const Vec3d share = shares[s][a] * force;
      Vec3d& last = lasts[4 * s + a];
      work_ += 0.5 * dt * dot(last + share, vec(state.v[k[a]]));
      add(state.f[k[a]], share);
      last = share;
    }
  }
}

/// Gas presses outwards, along the normals.
void Loads::apply(Volume& volume, system::State& state, double dt) {
  const model::ControlVolume& source = *volume.source;
  volume.volume = source.volume_scale * enclosed_volume(source.segments, source.openings, [&](model::Index n) {
                    return vec(state.x[at(system_.node_of[at(n)])]);
                  });
  volume.pressure = source.pressure_scale * pressure(volume, state, dt);
  const double before = work_;
  press(source.segments, source.share, -volume.pressure, volume.last, state, dt);
  volume.work += work_ - before;
}

double Loads::pressure(Volume& volume, const system::State& state, double dt) const {
  using Gas = model::ControlVolume::Gas;
  const model::ControlVolume& gas = *volume.source;
  const double relative = volume.volume / volume.at_start;
  if (!(relative > 0.0)) return 0.0;
  if (gas.gas == Gas::flowing) {
    const model::Index c = gas.flowing.inflow_curve;
    const Curve* inflow = c != model::none && in_force(curve(system_, c), state) ? &curve(system_, c) : nullptr;
    advance(volume.bag, gas, system_.model.curves, volume.volume, inflow, !state.relaxing, state.time, dt);
    return volume.bag.pressure - gas.ambient;
  }
  if (gas.gas == Gas::adiabatic) {
    if (gas.preload_curve != model::none && !volume.preload_over) {
      volume.preload_over = curve(system_, gas.preload_curve).clamped(state.time) != 0.0;
      if (!volume.preload_over) return gas.beta * (gas.absolute - gas.ambient);
    }
    volume.relative_pressure = std::pow(relative, -gas.gamma);
    return gas.beta * (gas.absolute * volume.relative_pressure - gas.ambient);
  }
  if (state.relaxing && gas.relaxation_curve != model::none)
    return gas.beta * curve(system_, gas.relaxation_curve).zero_outside(state.time) / relative;
  if (gas.gas == Gas::curve) return curve(system_, gas.curve).clamped(relative);
  if (gas.coefficient_curve != model::none)
    return gas.beta * value(curve(system_, gas.coefficient_curve), state.time, state) / relative;
  return gas.coefficient / relative;
}

double Loads::curve_value(const model::BodyLoad& load, const system::State& state) const {
  if (state.relaxing && load.relaxation_curve != model::none)
    return curve(system_, load.relaxation_curve).zero_outside(state.time);
  return load.curve == model::none ? 1.0 : value(curve(system_, load.curve), state.time, state);
}

void Loads::apply(Body& body, system::State& state, double dt) {
  const model::BodyLoad& load = *body.load;
  const double motion = load.scale * curve_value(load, state);
  if (load.centrifugal) return apply_centrifugal(body, state, dt, motion);
  // Base acceleration: the structure feels -m a.
  const double a = -motion;
  double momentum = 0.0;
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const auto k = static_cast<std::size_t>(body.nodes[i]);
    momentum += body.mass[i] * dot(load.direction, vec(state.v[k]));
    add(state.f[k], (a * body.mass[i]) * load.direction);
  }
  work_ += 0.5 * dt * (body.last + a) * momentum;
  body.last = a;
}

void Loads::apply_centrifugal(Body& body, system::State& state, double dt, double omega) {
  const model::BodyLoad& load = *body.load;
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const auto k = static_cast<std::size_t>(body.nodes[i]);
    const Vec3d arm = vec(state.x[k]) - load.center;
    const Vec3d outwards = arm - dot(arm, load.direction) * load.direction;
    const Vec3d force = (body.mass[i] * omega * omega) * outwards;
    work_ += 0.5 * dt * dot(body.last_force[k] + force, vec(state.v[k]));
    add(state.f[k], force);
    body.last_force[k] = force;
  }
}

void Loads::Nodal::archive(Archive& a) {
  a(last);
  a.built(load, nodes);
}

void Loads::Pressure::archive(Archive& a) {
  a(last);
  a.built(load);
}

void Loads::Volume::archive(Archive& a) {
  a(at_start, volume, pressure, relative_pressure, work, preload_over, bag, last);
  a.built(source);
}

void Loads::Body::archive(Archive& a) {
  a(last, last_force, nodes, mass);
  a.built(load);
}

void Loads::archive(Archive& a) {
  a(nodal_, pressure_, volumes_, body_, work_);
  a.built(system_);
}

}  // namespace nugget::impact
