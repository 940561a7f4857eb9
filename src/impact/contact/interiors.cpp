// SPDX-License-Identifier: Apache-2.0
#include "impact/contact/interiors.hpp"

#include "impact/contact/contact_setup.hpp"

namespace nugget::impact {

Interiors::Interiors(const system::System& system, std::span<const Row> x, Findings& findings) {
  for (const model::InteriorContact& card : system.model.interiors) {
    auto bricks = bricks_of(system, card);
    if (bricks.empty())
      findings.warning(card.place, "*CONTACT_INTERIOR", "none of its parts has deformable bricks: it does nothing");
    interiors_.emplace_back(std::move(bricks), x);
  }
}

void Interiors::apply(const contact::Step& step, std::span<Row> force) {
  for (contact::InteriorContact& c : interiors_) c.apply(step, force);
}

void Interiors::add_energy(Energy& energy) const {
  for (const contact::InteriorContact& c : interiors_) energy.contact += c.energy();
}

}  // namespace nugget::impact
