// SPDX-License-Identifier: Apache-2.0
#include "base/archive.hpp"

#include "system/spring_group.hpp"
#include "system/system.hpp"

// What of a system goes into restart files.
namespace nugget::system {

void State::archive(Archive& a) {
  a(time, dt, dt_previous, cycle, relaxing, x, v, w, f, m);
}

void RigidBody::archive(Archive& a) {
  a(mass, inertia, axes, center0, angular_momentum);
  a.built(source, id, title, node, fixed, fixed_axes);
}

void ConstraintMap::archive(Archive& a) {
  a(rows_, terms_, corners_, row_of_);
  a.built(levels_);
}

void ElementGroup::archive(Archive& a) {
  a(deletions, inverted, block_step, step_share);
  a.built(kind, part, element, nodes_per_element, weld, rotational, first_slot, damping_share, damping_time,
          damping_stiffness_ratio, mass_step, added_mass_is_physical);
}

void SpringGroup::Entry::archive(Archive& a) {
  a(state, elongation, pressed, force, energy, step, line, alive, started, inverse_mass, stiffness_rate,
    viscosity_rate);
  a.built(source, node, direction, ground, length);
}

void SpringGroup::archive(Archive& a) {
  ElementGroup::archive(a);
  a(springs_);
  a.built(section_, law_, model_);
}

void System::archive(Archive& a) {
  a.section("system");
  a(mass, inertia, own_mass, own_inertia_, carried_mass_, carried_inertia_, map, bodies, slots_);
  a.built(model, ties, nodes, node_of, model_node, body_of, springs, shell_location, solid_location, beam_location,
          discrete_location, start_, mass_only_elements_, constraint_source_, damping_slots, gather_start_, gather_,
          blocks_);
  a.section("elements");
  a(groups);
}

}  // namespace nugget::system
