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
  /// Force on the nodes of a transducer, by its place in the model. Those of areas are the first of their wall's.
  const Vec3d& force_of_transducer(std::size_t which) const {
    return walls_[transducers_[which].wall].force_apart(transducers_[which].place);
  }

  void add_energy(Energy& energy) const;
  void archive(Archive& a) {
    a(walls_);
    a.built(transducers_);
  }

 private:
  struct Transducer {
    model::Index wall;
    std::size_t place;  ///< in the sums of the wall
  };
  std::vector<contact::RigidWall> walls_;
  std::vector<Transducer> transducers_;
};

}  // namespace nugget::impact
