// SPDX-License-Identifier: Apache-2.0
#include "base/archive.hpp"

#include "impact/simulation/simulation.hpp"

// What of a run goes into restart files.
namespace nugget::impact {

void Supports::ConstrainedDof::archive(Archive& a) {
  a(axis, force, before, velocity, active);
  a.built(reaction, node, rotation, birth, death);
}

void Supports::PrescribedDof::archive(Archive& a) {
  ConstrainedDof::archive(a);
  a(left, rate);
  a.built(motion, body, constrain_others, at_start, oblique_to);
}

void Supports::archive(Archive& a) {
  a(constrained_dofs_, prescribed_dofs_, spc_, motion_, work_, dt_previous_, power_on_change_);
  a.built(system_);
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

void Connectors::archive(Archive& a) {
  a(records_, failed_, events_);
  a.built(system_);
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
  a(range_, deforming_, force_, moment_, last_force_, last_moment_, energy_);
  a.built(system_, mass_, deform_, relative_, deforming_of_);
}

void ElementAlive::archive(Archive& a) {
  a(alive_, deletions_, shell_deletions_);
}

void Erosion::archive(Archive& a) {
  a(deleted_, events_, stop_);
  a.built(system_);
}

void JointSprings::Freedom::archive(Archive& a) {
  a(friction, now.place, now.rate, now.stiffness, now.damping);
  a.built(load, damper, stiffness, friction_limit, low, high);
}

void JointSprings::Spring::archive(Archive& a) {
  for (Freedom& f : freedom) a(f);
  a(force, moment, energy);
  a.built(rotational, body, arm, axes);
}

void JointSprings::archive(Archive& a) {
  a(springs_);
  a.built(stable_step_);
}

void Joints::Joint::archive(Archive& a) {
  a(force, moment, load, slip, energy, opening, largest_opening, failed, failure_time);
  a.built(source, body, arm, axis, other, constrained, directions, bound, rotary_bound, damping, rotary_damping);
}

void Joints::archive(Archive& a) {
  a(joints_, springs_, longest_step_);
  a.built(system_);
}

void NodalForceGroups::Node::archive(Archive& a) {
  a(force, work);
  a.built(node, corners);
}

void NodalForceGroups::Group::archive(Archive& a) {
  a(nodes);
  a.built(card);
}

void NodalForceGroups::archive(Archive& a) {
  a(groups_);
  a.built(system_);
}

void Preloads::archive(Archive& a) {
  a.built(system_, prescribed_, groups_);
}

void Relaxation::archive(Archive& a) {
  a(recent_, largest_, kinetic_energy_ratio_, time_, cycles_, at_rest_);
  a.built(control_);
}

void RigidWelds::Weld::archive(Archive& a) {
  a(nodes, loads, around, axis);
  // A weld of many nodes that has lost some has one joint in place of two.
  std::size_t count = joints.size();
  a(count);
  joints.resize(count, joints.front());
  a(joints);
  a.built(source, body);
}

void RigidWelds::archive(Archive& a) {
  a(welds_, failed_, events_);
  a.built(system_);
}

void Rivets::Rivet::archive(Archive& a) {
  a(force, peak, failed, failure_time);
  a.built(source, node, mobility, length);
}

void Rivets::archive(Archive& a) {
  a(rivets_, failed_, events_);
  a.built(system_);
}

void Strains::archive(Archive& a) {
  a(shells_, solids_);
  a.built(system_, zeta_);
}

void TieReleases::archive(Archive& a) {
  a(ended_, lost_, death_times_, events_);
  a.built(system_, welds_, springs_, nodes_released_);
}

void TieForces::archive(Archive& a) {
  a(springs_, longest_step_, energy_);
  a.built(system_);
}

void Welds::Bricks::archive(Archive& a) {
  a(load, area);
  a.built(section, corners, nodes, x, force, jacobian, locations);
}

void Welds::archive(Archive& a) {
  a(histories_, bricks_, failed_, events_);
  a.built(system_);
}

void Simulation::archive(Archive& a) {
  a(system_);
  a.section("nodes");
  a(state_, history_rotation_);
  a.section("conditions");
  a(supports_, loads_, damping_, preloads_);
  a.section("contacts");
  a(contacts_, interiors_, walls_, element_alive_, erosion_);
  a.section("welds");
  a(welds_, rigid_welds_, rivets_, connectors_, tie_forces_, tie_releases_, joints_);
  a.section("results");
  a(strains_, nodal_forces_, accelerometers_, energy_, parts_, controlling_);
  a(masses_.physical, masses_.added, masses_.added_to_welds, masses_.added_by_part);
  a(inverse_mass_, inverse_inertia_, contact_mass_, dependent_);
  a(diverged_, relaxation_, step_change_, power_on_change_, first_step_, smallest_step_, stable_step_, longest_step_,
    smallest_by_, seconds_, solve_seconds_);
  a.built(stopped_springs_, v_before_, w_before_, momentum_before_, block_power_, stop_requested_, checkpoint_cycle_,
          checkpoint_time_, checkpoint_seconds_, begin_, timed_until_);
}

}  // namespace nugget::impact
