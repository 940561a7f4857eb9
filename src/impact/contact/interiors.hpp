// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "contact/interior_contact.hpp"
#include "impact/energy/energy.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// The *CONTACT_INTERIOR of a run, in the order of the deck.
class Interiors {
 public:
  /// `x`: coordinates at the start [length]. A warning where a contact has no bricks.
  Interiors(const system::System& system, std::span<const Row> x, Findings& findings);

  /// Adds the forces of this step.
  void apply(const contact::Step& step, std::span<Row> force);

  const std::vector<contact::InteriorContact>& all() const { return interiors_; }

  void add_energy(Energy& energy) const;
  void archive(Archive& a) { a(interiors_); }

 private:
  std::vector<contact::InteriorContact> interiors_;
};

}  // namespace nugget::impact
