// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "contact/nodal_forces.hpp"
#include "contact/step.hpp"

namespace nugget::contact {

/// A brick that pushes back when it is squeezed.
struct SqueezedBrick {
  std::array<int, 8> node{};  ///< system nodes; wedges and tetrahedra repeat theirs
  int element = 0;            ///< place in Step::element_alive
  double activation = 0.0;    ///< Fa: share of its smallest height at the start below which it pushes back
  double modulus = 0.0;       ///< [stress], all scales included
};

/// *CONTACT_INTERIOR: presses the opposite faces of soft bricks apart when they have come too near to each other,
/// before the brick turns inside out.
///
/// *Documented*: it acts where the smallest thickness of a brick falls below Fa times its smallest thickness at the
/// start, with the stiffness k = SLSFAC PSF E V^(2/3) / thickness, or ED V^(2/3) / thickness. *Ours*: the thickness is
/// kernel::BrickHeights, each pair of faces is looked at, V and the thickness in k are those at the start; the force is
/// k (Fa h0 - h) dh/dx, so that it has a potential and no resultant. k is bounded, so that it does not set the step.
class InteriorContact {
 public:
  /// `x`: initial positions [length].
  InteriorContact(std::vector<SqueezedBrick> bricks, std::span<const Row> x);

  /// Adds the forces at the end of a step to `force`.
  void apply(const Step& step, std::span<Row> force);

  /// Work done against the forces so far [energy].
  double energy() const { return forces_.energy_of_sides()[0]; }
  const std::vector<int>& nodes() const { return forces_.nodes(); }  ///< all that it can press
  std::size_t size() const { return bricks_.size(); }
  int pressed() const { return pressed_; }  ///< bricks that push back now

  void archive(Archive& a);

 private:
  std::vector<SqueezedBrick> bricks_;
  std::vector<double> threshold_;  // by brick: its Fa times its smallest height at the start [length]
  std::vector<double> stiffness_;  // [force/length]
  NodalForces forces_;
  std::vector<unsigned char> squeezed_;  // by brick, in this cycle
  int pressed_ = 0;
};

}  // namespace nugget::contact
