// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "kernel/element/weld_joint.hpp"
#include "kernel/law/yield_curve.hpp"

namespace nugget::kernel {

/// The flow of the sheets of a stack that several welds hold together on one axis: n welds between n + 1 sheets. The
/// nugget of a sheet between two welds carries the forces of both, so it flows by both, and its flow moves both. Each
/// sheet has a yield surface of its own with hardening by its own plastic work w; of an outer sheet that of
/// WeldJoint, of a sheet between with F the force of the weld below it and G of that above
///     ((<N_F> - <N_G>)/N0)^2 + (V_F^2 - 2 rho V_F V_G + V_G^2)/V0^2 + ((M_F - M_G)/M0)^2 <= 1,
///     rho = 2 (V0/U0)^2 - 1,
/// U0 the shear that it carries unbent (`unbent_shear_over_work`). With one weld only that is the outer sheet's
/// surface; with two that pull the same way (V_G = -V_F) their sum is U0; with two that pull it apart it is bent by
/// both. Source: docs/theory/ties.md#joints-of-stacks.
class StackJoint {
 public:
  static constexpr std::size_t most_welds = 6;
  using Freedoms = WeldJoint::Freedoms;
  struct SheetState {
    double work = 0.0;  ///< plastic, over the factor of the rate [energy]
    double rate = 0.0;  ///< plastic strain rate of the ring around the nugget, smoothed [1/time]
  };
  /// A weld in a step: what would be its forces without flow. Freedoms and signs are those of one frame for all welds
  /// of the stack, along which they follow each other from the first sheet to the last.
  struct Weld {
    WeldJoint::Trial trial;
    bool holds = true;  ///< it has not failed
  };

  /// The sheets in their order, one more than welds; nothing where an end is no sheet that deforms.
  explicit StackJoint(std::span<const std::optional<JointEnd>> sheets);

  std::size_t welds() const { return sheets_.size() - 1; }
  std::size_t sheets() const { return sheets_.size(); }
  /// Advances the sheets and gives the plastic motion of each weld's ends together. Implicit: after it each force lies
  /// on or within the surfaces at both its ends, to round-off.
  void advance(std::span<SheetState> state, std::span<const Weld> welds, double dt, std::span<Freedoms> flow) const;

 private:
  struct Sheet {
    bool flows = false;
    YieldCurve normal, shear, moment, unbent;  ///< N0, V0, M0, U0 over the plastic work
    Curve rate_factor;
    double work_of_strain = 0.0;
  };
  struct Step;
  std::vector<Sheet> sheets_;
};

}  // namespace nugget::kernel
