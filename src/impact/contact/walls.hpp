// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "contact/rigid_wall.hpp"
#include "impact/energy/energy.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// The *RIGIDWALL_... of a run, in the order of the deck.
class Walls {
 public:
  Walls(const system::System& system, Findings& findings);

  /// Takes the velocity into a wall from the nodes that touch it, dependent ones excepted (`dependent`, by node), where
  /// `supports` leave them free; adds RigidWall::power_on_change of each wall.
  void constrain(const system::System& system, system::State& state, std::span<const unsigned char> dependent,
                 contact::HeldNodes& supports, double& power_on_change);
  /// Adds the penalty forces on rigid bodies.
  void press(const contact::Step& step, std::span<Row> force);

  /// Over several ranks: see contact::RigidWall::carry.
  void carry(system::Carried what, const system::System::Computed& of, system::Parcel& parcel);
  const std::vector<contact::RigidWall>& all() const { return walls_; }

  void add_energy(Energy& energy) const;
  void archive(Archive& a) { a(walls_); }

 private:
  std::vector<contact::RigidWall> walls_;
};

}  // namespace nugget::impact
