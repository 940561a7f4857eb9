// SPDX-License-Identifier: Apache-2.0
#include "base/archive.hpp"

#include "contact/interior_contact.hpp"
#include "contact/penalty_contact.hpp"
#include "contact/rigid_wall.hpp"
#include "contact/wall_penalty.hpp"

// What of contacts and walls goes into restart files: their search lists too, since a pair remembers on which side it
// stands, and a search at another cycle would give other last digits.
namespace nugget::contact {

void Approach::archive(Archive& a) {
  a(nodes_, start_, last_, since_start_, travelled_);
}

void NodalForces::archive(Archive& a) {
  a(now_, before_, touched_now_, touched_before_, stamp_, cycle_);
  a.built(nodes_, index_, side_);
}

void SurfaceContact::Block::archive(Archive& a) {
  a(first, next_check_travel, pairs, hits);
  a.built(begin, end, old_first, old_pairs, candidates, resultant, deepest, lowest, highest);
}

void SurfaceContact::archive(Archive& a) {
  a.section("contact of surfaces");
  a(forces_, active_nodes_, searched_at_, searched_, searches_, seen_at_, searched_when_, travelled_, moved_,
    active_segments_, blocks_, active_blocks_, energy_, resultant_, touching_, deepest_, frictions_, friction_energy_);
  a.built(setup_, around_, segment_stiffness_, inner_, node_stiffness_, node_mass_, excluded_, stays_active_,
          thickest_segment_, pressing_, margin_, boxes_, tree_);
}

void EdgeContact::Block::archive(Archive& a) {
  a(pairs);
  a.built(begin, end, close);
}

void EdgeContact::archive(Archive& a) {
  a.section("contact of edges");
  a(approach_, searched_, searches_, active_, blocks_, touches_, touched_before_, forces_, energy_, resultant_,
    deepest_, frictions_, friction_energy_);
  a.built(setup_, first_at_, edge_at_, margin_, close_);
}

void Glue::archive(Archive& a) {
  a.section("glue");
  a(bonds_, bonded_, was_bonded_, forces_, energy_, resultant_, failed_, first_node_, first_time_, last_time_,
    frictions_, friction_energy_);
  a.built(setup_, card_, around_, around_listed_, segment_stiffness_, at_start_);
}

void PenaltyContact::archive(Archive& a) {
  a(surface_);
  if (edges_) a(*edges_);
  a(glue_);
  a.built(can_expose_faces_);
}

void InteriorContact::archive(Archive& a) {
  a.section("interior contact");
  a(forces_, energy_, pressed_);
  a.built(bricks_, threshold_, stiffness_, squeezed_);
}

void WallPenalty::archive(Archive& a) {
  a(touches_, force_, normal_force_, energy_, touching_);
  a.built(system_, scale_, friction_, inverse_wall_mass_, touching_of_);
}

void RigidWall::archive(Archive& a) {
  a.section("wall");
  a(origin_, velocity_, tracked_, started_, force_, impulse_, normal_force_, normal_impulse_, energy_, pending_energy_,
    power_on_change_, touching_, wall_velocity_);
  if (bodies_) a(*bodies_);
  a.built(shape_, normal_, friction_, weld_velocity_, mass_, motion_, motion_is_displacement_, motion_direction_,
          birth_, death_, sums_);
}

}  // namespace nugget::contact
