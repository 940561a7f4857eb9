// SPDX-License-Identifier: Apache-2.0
#include "contact/penalty_contact.hpp"

#include <algorithm>
#include <utility>

namespace nugget::contact {

PenaltyContact::PenaltyContact(SurfaceContactSetup surface, std::optional<EdgeContactSetup> edges,
                               std::optional<model::Glue> glue, std::span<const Row> x)
    : can_expose_faces_(surface.whole ? surface.whole->covers
                                      : std::any_of(surface.segments.begin(), surface.segments.end(),
                                                    [](const Segment& s) { return s.covered_by >= 0; })),
      surface_(glue ? SurfaceContact(surface, x) : SurfaceContact(std::move(surface), x)) {
  if (edges) edges_.emplace(std::move(*edges), x);
  if (edges_ || glue) surface_.look_everywhere();
  if (!glue) return;
  glue_ = std::make_unique<Glue>(surface, std::move(*glue), x);
  surface_.exclude(glue_->bonded());
}

void PenaltyContact::apply(const Step& step, std::span<Row> force) {
  Step of_faces = step;
  if (step.faces_are_whole) of_faces.element_alive = {};
  if (glue_) glue_->apply(of_faces, force);
  surface_.apply(of_faces, force);
  if (glue_) glue_->bond_touching(surface_, of_faces);
  if (edges_) edges_->apply(step, force);
}

void PenaltyContact::elements_deleted(bool faces) {
  if (faces && can_expose_faces_) surface_.surface_changed();
  if (edges_) edges_->surface_changed();
}

double PenaltyContact::energy() const {
  const std::array<double, 2> sides = energy_of_sides();
  return sides[0] + sides[1];
}

std::array<double, 2> PenaltyContact::energy_of_sides() const {
  std::array<double, 2> energy = surface_.energy_of_sides();
  for (std::size_t side = 0; side < 2; ++side) {
    if (edges_) energy[side] += edges_->energy_of_sides()[side];
    if (glue_) energy[side] += glue_->energy_of_sides()[side];
  }
  return energy;
}

ContactEnergies PenaltyContact::energies() const {
  ContactEnergies all = surface_.energies();
  if (edges_) all.add(edges_->energies());
  if (glue_) all.friction += glue_->friction_energy();
  return all;
}

Vec3d PenaltyContact::resultant() const {
  return with_edges_and_glue(surface_.resultant());
}

Vec3d PenaltyContact::resultant_of_all_ranks() const {
  return with_edges_and_glue(surface_.resultant_of_all_ranks());
}

Vec3d PenaltyContact::with_edges_and_glue(Vec3d sum) const {
  if (edges_) sum += edges_->resultant();
  if (glue_) sum += glue_->resultant();
  return sum;
}

bool PenaltyContact::presses(int node) const {
  return surface_.presses(node) || (edges_ && edges_->presses(node)) || (glue_ && glue_->presses(node));
}

Vec3d PenaltyContact::force_on(std::span<const unsigned char> marked) const {
  Vec3d sum = surface_.force_on(marked);
  if (edges_) sum += edges_->force_on(marked);
  if (glue_) sum += glue_->force_on(marked);
  return sum;
}

Vec3d PenaltyContact::force_on(int node) const {
  Vec3d sum = surface_.force_on(node);
  if (edges_) sum += edges_->force_on(node);
  if (glue_) sum += glue_->force_on(node);
  return sum;
}

Vec3d PenaltyContact::force_between(const TwoBodies& bodies) const {
  Vec3d sum = surface_.force_between(bodies);
  if (edges_) sum += edges_->force_between(bodies);
  if (glue_) sum += glue_->force_between(bodies);
  return sum;
}

void PenaltyContact::archive(Archive& a) {
  a(surface_);
  if (edges_) a(*edges_);
  a(glue_);
  a.built(can_expose_faces_);
}

}  // namespace nugget::contact
