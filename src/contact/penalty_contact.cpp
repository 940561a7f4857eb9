// SPDX-License-Identifier: Apache-2.0
#include "contact/penalty_contact.hpp"

#include <algorithm>
#include <utility>

namespace nugget::contact {

PenaltyContact::PenaltyContact(SurfaceContactSetup surface, std::optional<EdgeContactSetup> edges,
                               std::optional<GlueStrength> glue, std::span<const Row> x)
    : surface_(surface, x) {
  may_grow_ =
      std::any_of(surface.segments.begin(), surface.segments.end(), [](const Segment& s) { return s.covered_by >= 0; });
  if (edges) edges_.emplace(std::move(*edges), x);
  if (!glue) return;
  glue_ = std::make_unique<Glue>(surface, *glue, x);
  surface_.leave_out(glue_->glued());
}

void PenaltyContact::apply(double time, double dt, std::span<const Row> x, std::span<const Row> v,
                           std::span<const double> mass, std::span<const unsigned char> element_alive,
                           std::span<Row> force) {
  if (glue_) glue_->apply(time, dt, x, v, mass, element_alive, force);
  surface_.apply(time, dt, x, v, mass, element_alive, force);
  if (edges_) edges_->apply(time, dt, x, v, mass, element_alive, force);
}

void PenaltyContact::surface_changed() {
  if (may_grow_) surface_.surface_changed();
  if (edges_) edges_->surface_changed();
}

double PenaltyContact::energy() const {
  const std::array<double, 2> sides = energy_of_sides();
  return sides[0] + sides[1];
}

std::array<double, 2> PenaltyContact::energy_of_sides() const {
  std::array<double, 2> energy = surface_.energy_of_sides();
  if (edges_) energy[0] += edges_->energy();
  if (glue_)
    for (std::size_t side = 0; side < 2; ++side) energy[side] += glue_->energy_of_sides()[side];
  return energy;
}

Vec3d PenaltyContact::resultant() const {
  return surface_.resultant() + (glue_ ? glue_->resultant() : Vec3d{});
}

Vec3d PenaltyContact::force_on(std::span<const unsigned char> marked) const {
  Vec3d sum = surface_.force_on(marked);
  if (edges_) sum += edges_->force_on(marked);
  if (glue_) sum += glue_->force_on(marked);
  return sum;
}

}  // namespace nugget::contact
