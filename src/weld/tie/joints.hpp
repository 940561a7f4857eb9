// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "kernel/element/weld_joint.hpp"
#include "weld/tie/ties.hpp"

// The joints that welds get with --weld-tie joint: what the sheet around each end lacks on its mesh
// (docs/theory/ties.md#joint).
namespace nugget::weld {

/// Yield stress of a sheet's law over its plastic strain, at rest [stress]: what the law itself gives under shear in
/// small steps. Empty where it does not flow, or has no effective plastic strain.
Curve yield_at_rest(const model::Material& material);
/// Factor on it over the plastic strain rate, at 2 % of plastic strain, by the same test at other speeds; empty where
/// the rate does not count.
Curve rate_factor(const model::Material& material);

/// What is known of the sheets of a weld: one an end that is tied by area to shells that deform.
std::vector<kernel::JointEnd> joint_ends(const model::Model& model, const Ties& ties, const Weld& weld);

/// The joint of a weld; nothing where Control::weld_tie asks for none, for welds that are no beam of spot-weld
/// material, and where no end is tied by area to shells that deform.
std::optional<kernel::WeldJoint> joint_of(const model::Model& model, const Ties& ties, const Weld& weld);

/// A note of what the joints of all welds come to, a warning of welds of bricks, which get none.
void report_joints(const model::Model& model, const Ties& ties, Findings& findings);

}  // namespace nugget::weld
