// SPDX-License-Identifier: Apache-2.0
#include "impact/recording/histories.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/index.hpp"
#include "impact/recording/node_motion.hpp"
#include "model/axes.hpp"
#include "system/spring_group.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::impact {
namespace {

int node_id(const Snapshot& now, int system_node) {
  return now.system.model.nodes.id[at(now.system.model_node[at(system_node)])];
}

output::ElementKind kind(model::ElementKind k) {
  switch (k) {
    case model::ElementKind::beam: return output::ElementKind::beam;
    case model::ElementKind::shell: return output::ElementKind::shell;
    case model::ElementKind::discrete: return output::ElementKind::discrete;
    default: return output::ElementKind::solid;
  }
}

}  // namespace

output::GlstatState glstat_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  const Energy& e = now.energy;
  output::GlstatState s;
  s.cycle = now.state.cycle + 1;  // LS-DYNA counts from 1
  if (now.controlling.group >= 0) {
    const system::ElementGroup& group = *now.system.groups[at(now.controlling.group)];
    const model::Index element = now.controlling.element >= 0 ? group.element[at(now.controlling.element)] : 0;
    s.controlling = output::ControllingElement{kind(group.kind), now.system.element_id(group, element),
                                               model.parts[at(group.part)].id};
  }
  s.time = now.state.time;
  s.time_step = now.state.dt;
  s.kinetic = e.kinetic;
  s.internal = e.internal;
  for (const contact::RigidWall& wall : now.components.walls.all()) s.walls.push_back(wall.energy_at_time());
  if (!model.discretes.empty()) {
    s.spring_and_damper = 0.0;  // part of the internal energy, as in LS-DYNA
    for (std::size_t p = 0; p < now.parts.size(); ++p)
      if (model.parts[p].kind == model::ElementKind::discrete) *s.spring_and_damper += now.parts[p].internal;
  }
  if (!now.components.joints.empty()) s.joint = now.components.joints.energy();  // also part of it
  if (model.control.hourglass_energy) s.hourglass = e.hourglass;
  s.system_damping = e.damping;
  s.sliding_interface = e.contact;
  s.external_work = e.external;
  s.eroded_kinetic = e.eroded_kinetic;
  s.eroded_internal = e.eroded;
  s.eroded_hourglass = 0.0;
  s.total = e.total();
  s.ratio = e.ratio();
  const double base = e.initial + e.external;
  s.ratio_without_eroded = base != 0.0 ? (e.total() - e.eroded - e.eroded_kinetic) / base : 1.0;
  s.velocity = mean_velocity(e, now.parts);
  if (now.masses.added != 0.0) {
    s.added_mass = now.masses.added;
    s.percent_increase = 100.0 * now.masses.added / now.masses.physical;
  }
  return s;
}

output::MatsumState matsum_state(const Snapshot& now) {
  output::MatsumState s;
  s.time = now.state.time;
  const model::Model& model = now.system.model;
  const bool given_nodal =
      std::ranges::any_of(model.rigid_bodies, [](const model::RigidBody& b) { return b.given && b.parts.empty(); });
  if (!model.masses.empty() || !model.inertias.empty() || given_nodal) s.lumped_kinetic = now.energy.lumped.kinetic;
  for (std::size_t p = 0; p < now.parts.size(); ++p) {
    const PartEnergy& part = now.parts[p];
    output::MatsumRow row;
    row.part = now.system.model.parts[p].id;
    row.internal = part.internal;
    row.kinetic = part.kinetic;
    row.hourglass = part.hourglass;
    row.eroded_internal = part.eroded;
    row.eroded_kinetic = part.eroded_kinetic;
    row.added_mass = now.masses.added_by_part[p];
    row.momentum = part.momentum;
    if (part.mass > 0.0) row.velocity = (1.0 / part.mass) * part.momentum;
    s.rows.push_back(row);
  }
  return s;
}

/// Acceleration that body loads on all parts give every node.
static Vec3d gravity(const Snapshot& now) {
  const model::Model& model = now.system.model;
  Vec3d sum;
  for (const model::BodyLoad& load : model.body_loads) {
    if (!load.parts.empty() || !load.nodes.empty() || load.centrifugal) continue;
    const Curve& curve = model.curves[at(load.curve)];
    if (curve.in_run) sum -= load.scale * curve.zero_outside(now.state.time) * load.direction;
  }
  return sum;
}

/// Bits of the global accelerations of body loads that an accelerometer leaves out now.
static unsigned without_gravity(const Snapshot& now, const model::Accelerometer& a) {
  if (a.gravity_curve == model::none) return a.without_gravity;
  const double flag = now.system.model.curves[at(a.gravity_curve)].clamped(now.state.time);
  return model::gravity_left_out(static_cast<int>(std::lround(flag)));
}

/// Histories of accelerometers are in axes that turn with the nodes.
static void turn_into_accelerometer(const Snapshot& now, model::Index node, output::NodoutRow& row) {
  const model::Model& model = now.system.model;
  const auto found = std::find_if(model.accelerometers.begin(), model.accelerometers.end(),
                                  [&](const model::Accelerometer& a) { return a.node[0] == node; });
  if (found == model.accelerometers.end()) return;
  const Frame3d axes = accelerometer_axes(now.system, now.state, *found);
  const unsigned without = without_gravity(now, *found);
  const Vec3d g = without != 0 ? gravity(now) : Vec3d{};
  const auto left_out = [&](unsigned i, double value) { return without >> i & 1u ? value : 0.0; };
  row.acceleration -= Vec3d{left_out(0, g.x), left_out(1, g.y), left_out(2, g.z)};
  for (Vec3d* v : {&row.displacement, &row.velocity, &row.acceleration, &row.rotation, &row.rotational_velocity,
                   &row.rotational_acceleration})
    *v = axes.local(*v);
  if (!found->sums_local) return;
  const auto k = at(now.system.node_of[at(node)]);
  const Vec3d change = vec(now.state.v[k]) - vec(now.v_before[k]);
  row.velocity =
      now.components.accelerometers.velocity(static_cast<std::size_t>(found - model.accelerometers.begin())) +
      share_before_now(now.state) * axes.local(change);
}

/// The motion of a node in the axes that its history asks for; coordinates stay global.
static void turn_into_local_axes(const Snapshot& now, const model::NamedEntity& entity, output::NodoutRow& row) {
  if (entity.system == model::none) return;
  const model::CoordinateSystem& system = now.system.model.systems[at(entity.system)];
  Frame3d axes = system.axes;
  const auto index = [&](model::Index n) { return at(now.system.node_of[at(n)]); };
  const auto place = [&](model::Index n) { return vec(now.state.x[index(n)]); };
  if (entity.turning)
    model::frame_of_points(place(system.nodes->origin), place(system.nodes->on_axis), place(system.nodes->in_plane),
                           system.nodes->axis, axes);
  if (entity.relative) {
    const model::Index origin = system.nodes->origin;
    const NodeMotion of_origin = node_motion(now, index(origin));
    row.velocity -= of_origin.velocity;
    row.acceleration -= of_origin.acceleration;
    const auto start = [&](model::Index n) { return now.system.model.nodes.x[at(n)]; };
    row.displacement =
        row.coordinate - place(origin) - axes.global(system.axes.local(start(entity.index) - start(origin)));
  }
  for (Vec3d* vector : {&row.displacement, &row.velocity, &row.acceleration, &row.rotation, &row.rotational_velocity,
                        &row.rotational_acceleration})
    *vector = axes.local(*vector);
}

output::NodoutState nodout_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  output::NodoutState s;
  s.cycle = now.state.cycle + 1;
  s.time = now.state.time;
  s.rotations = model.shells.size() > 0 || model.beams.size() > 0;
  for (std::size_t i = 0; i < model.requests.history_nodes.size(); ++i) {
    const model::NamedEntity& entity = model.requests.history_nodes[i];
    const auto k = at(now.system.node_of[at(entity.index)]);
    output::NodoutRow row;
    row.node = model.nodes.id[at(entity.index)];
    row.coordinate = vec(now.state.x[k]);
    row.displacement = row.coordinate - model.nodes.x[at(entity.index)];
    const NodeMotion motion = node_motion(now, k);
    row.velocity = motion.velocity;
    row.acceleration = motion.acceleration;
    row.rotational_velocity = motion.rotational_velocity;
    row.rotational_acceleration = motion.rotational_acceleration;
    row.rotation = now.history_rotation[i];
    turn_into_local_axes(now, entity, row);
    turn_into_accelerometer(now, entity.index, row);
    s.rows.push_back(row);
  }
  return s;
}

output::DeforcState deforc_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  output::DeforcState s;
  s.time = now.state.time;
  for (std::size_t e = 0; e < model.discretes.size(); ++e) {
    if (!model.discretes[e].in_deforc) continue;
    const system::System::ElementLocation location = now.system.discrete_location[e];
    const auto& group = static_cast<const system::SpringGroup&>(*now.system.groups[at(location.group)]);
    const std::size_t i = at(location.element);
    const double force = group.force(i);
    s.rows.push_back({model.discretes[e].id, group.torsional(), force * group.line(i), force, group.elongation(i)});
  }
  return s;
}

output::JntforcState jntforc_state(const Snapshot& now) {
  output::JntforcState s;
  s.time = now.state.time;
  for (std::size_t i = 0; i < now.components.joints.size(); ++i) {
    const model::Joint& source = now.system.model.joints[i];
    output::JntforcRow row{source.id, now.components.joints.force(i), now.components.joints.moment(i),
                           now.components.joints.energy(i)};
    if (source.output) {
      const Frame3d& turned = now.system.bodies[at(now.system.body_of[at(source.output->body)])].axes;
      row.local = true;
      for (Vec3d* load : {&row.force, &row.moment}) *load = source.output->axes.local(turned.local(*load));
    }
    s.rows.push_back(row);
  }
  const JointSprings& springs = now.components.joints.springs();
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const model::JointStiffness& source = now.system.model.joint_stiffnesses[i];
    const double unit = source.rotational ? 180.0 / std::numbers::pi : 1.0;
    output::JntforcStiffness row{source.id, {}, springs.energy(i)};
    for (std::size_t k = 0; k < 3; ++k) {
      const JointSprings::Reading& r = springs.reading(i, k);
      row.axis[k] = {unit * r.place, unit * r.rate, r.stiffness, r.damping};
    }
    (source.rotational ? s.rotations : s.displacements).push_back(row);
  }
  return s;
}

output::AbstatState abstat_state(const Snapshot& now) {
  output::AbstatState s;
  s.time = now.state.time;
  int number = 0;
  for (const Loads::Volume& volume : now.components.loads.volumes()) {
    const model::ControlVolume& source = *volume.source;
    output::AbstatRow row;
    row.id = source.id > 0 ? source.id : number + 1;
    ++number;
    row.volume = volume.volume;
    row.pressure = volume.pressure;
    using Gas = model::ControlVolume::Gas;
    if (source.gas == Gas::flowing) {
      const Bag& bag = volume.bag;
      row.internal_energy = bag.energy;
      row.inflow = bag.inflow;
      row.outflow = bag.outflow;
      row.density = bag.mass / bag.volume;
      row.total_mass = bag.mass;
      row.temperature = bag.temperature;
    } else if (source.gas == Gas::adiabatic) {
      const double absolute = source.pressure_scale * source.beta * source.absolute * volume.relative_pressure;
      row.internal_energy = absolute * volume.volume / (source.gamma - 1.0);
      row.total_mass = source.density * volume.at_start;
      row.density = volume.volume > 0.0 ? row.total_mass / volume.volume : 0.0;
    } else {
      row.internal_energy = -volume.work;
    }
    row.surface_area = model::surface_area(
        source.segments, [&](model::Index n) { return vec(now.state.x[at(now.system.node_of[at(n)])]); });
    s.rows.push_back(row);
  }
  return s;
}

output::RwforcState rwforc_state(const Snapshot& now) {
  output::RwforcState s;
  s.time = now.state.time;
  for (std::size_t w = 0; w < now.components.walls.all().size(); ++w)
    s.rows.push_back({now.system.model.walls[w].id, now.components.walls.all()[w].normal_force(),
                      now.components.walls.all()[w].force()});
  return s;
}

output::SpcforcState spcforc_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  output::SpcforcState s;
  s.time = now.state.time;
  for (const Supports::Reaction& r : now.components.supports.spc_reactions()) {
    const model::SinglePointConstraint& spc = model.spcs[at(r.source)];
    const Frame3d axes =
        spc.system == model::none ? Frame3d{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}} : model.systems[at(spc.system)].axes;
    if (spc.fixed & 7u) {
      s.forces.push_back({node_id(now, r.node), axes.local(r.force), spc.id});
      s.resultant += r.force;
    }
    if (spc.fixed >> 3) s.moments.push_back({node_id(now, r.node), axes.local(r.moment), spc.id});
  }
  const auto ascending = [](const output::SpcforcRow& a, const output::SpcforcRow& b) { return a.node < b.node; };
  std::stable_sort(s.forces.begin(), s.forces.end(), ascending);
  std::stable_sort(s.moments.begin(), s.moments.end(), ascending);
  return s;
}

output::BndoutState bndout_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  output::BndoutState s;
  s.time = now.state.time;
  for (const Supports::Reaction& r : now.components.supports.motion_reactions()) {
    const model::PrescribedMotion& motion = model.motions[at(r.source)];
    if (motion.target == model::PrescribedMotion::Target::nodes)
      s.nodes.push_back({node_id(now, r.node), r.force, r.energy, motion.id});
    else
      s.bodies.push_back({model.rigid_bodies[at(motion.rigid_body)].id, r.force, r.moment, r.energy});
  }
  return s;
}

output::RbdoutState rbdout_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  output::RbdoutState s;
  s.cycle = now.state.cycle + 1;
  s.time = now.state.time;
  for (std::size_t b = 0; b < now.system.bodies.size(); ++b) {
    const system::RigidBody& body = now.system.bodies[b];
    const model::RigidBody::Origin origin = model.rigid_bodies[at(body.source)].origin;
    if (origin == model::RigidBody::Origin::weld) continue;
    const auto k = at(body.node);
    output::RbdoutRow row;
    row.id = body.id;
    row.coordinate = vec(now.state.x[k]);
    row.displacement = row.coordinate - body.center0;
    row.rotation = now.history_rotation[model.requests.history_nodes.size() + b];
    row.velocity = now.velocity(k);
    row.angular_velocity = now.spin(k);
    row.acceleration = now.acceleration(k);
    row.angular_acceleration = now.rotary_acceleration(k);
    const Frame3d& own = model.rigid_bodies[at(body.source)].own_axes;
    row.axes = {body.axes.global(own.e1), body.axes.global(own.e2), body.axes.global(own.e3)};
    (origin == model::RigidBody::Origin::part ? s.parts : s.nodal).push_back(row);
  }
  return s;
}

/// Marks the system's nodes of a surface.
static std::vector<unsigned char> nodes_of(const system::System& system, const model::Surface& surface) {
  const model::Model& model = system.model;
  std::vector<unsigned char> marked(system.nodes, surface.everything ? 1 : 0), in(model.parts.size(), 0);
  const auto mark = [&](model::Index n) { marked[at(system.node_of[at(n)])] = 1; };
  for (model::Index p : surface.parts) in[at(p)] = 1;
  for (std::size_t e = 0; e < model.shells.size(); ++e)
    if (in[at(model.shells.part[e])]) std::for_each(model.shells.node[e].begin(), model.shells.node[e].end(), mark);
  for (std::size_t e = 0; e < model.solids.size(); ++e)
    if (in[at(model.solids.part[e])]) std::ranges::for_each(model.solids.nodes(e), mark);
  for (std::size_t e = 0; e < model.beams.size(); ++e)
    if (in[at(model.beams.part[e])]) std::for_each(model.beams.node[e].begin(), model.beams.node[e].begin() + 2, mark);
  for (const model::Segment& s : surface.segments) std::for_each(s.begin(), s.end(), mark);
  std::for_each(surface.nodes.begin(), surface.nodes.end(), mark);
  return marked;
}

output::RcforcState rcforc_state(const Snapshot& now) {
  output::RcforcState s;
  s.time = now.state.time;
  std::size_t c = 0;
  for (std::size_t i = 0; i < now.system.model.contacts.size(); ++i) {
    const model::Contact& card = now.system.model.contacts[i];
    const auto add = [&](output::ContactSide side, const Vec3d& force) {
      s.rows.push_back({card.id, side, force, 0.0});
    };
    if (card.slides()) {
      const Vec3d force = now.components.contacts.all()[c++].resultant();
      add(output::ContactSide::tracked, force);
      if (card.kind != model::Contact::Kind::single_surface) add(output::ContactSide::reference, -force);
    } else if (card.kind == model::Contact::Kind::transducer) {
      const contact::TwoBodies bodies{nodes_of(now.system, card.a), nodes_of(now.system, card.b)};
      const bool of_two = !card.b.empty();
      Vec3d sum;
      for (const contact::PenaltyContact& contact : now.components.contacts.all())
        sum += of_two ? contact.force_between(bodies) : contact.force_on(bodies.in_a);
      add(output::ContactSide::tracked, sum);
      if (of_two) add(output::ContactSide::reference, -sum);
    } else if (card.tie_by_springs() || card.penalty_fallback) {
      const Vec3d force = now.components.tie_forces.resultant(static_cast<model::Index>(i));
      add(output::ContactSide::tracked, force);
      add(output::ContactSide::reference, -force);
    }
  }
  return s;
}

output::SleoutState sleout_state(const Snapshot& now) {
  output::SleoutState s;
  s.time = now.state.time;
  s.cycle = now.state.cycle + 1;
  std::size_t c = 0;
  for (const model::Contact& card : now.system.model.contacts) {
    if (!card.slides()) continue;
    const contact::PenaltyContact& contact = now.components.contacts.all()[c++];
    const std::array<double, 2> energy = contact.energy_of_sides();
    const bool single = card.kind == model::Contact::Kind::single_surface;
    s.rows.push_back({card.id, energy[0], energy[1], single, contact.friction_energy()});
  }
  for (std::size_t i = 0; i < now.components.interiors.all().size(); ++i)
    s.rows.push_back({now.system.model.interiors[i].id, now.components.interiors.all()[i].energy(), 0.0, true, 0.0});
  return s;
}

}  // namespace nugget::impact
