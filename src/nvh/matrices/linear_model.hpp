// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/finding.hpp"
#include "model/model.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::nvh {

/// The model as a linear analysis sees it: formulations without zero-energy patterns, no viscosity, no scaled masses.
/// One-point bricks (ELFORM 1) get the physical stabilisation of Belytschko and Bindeman with QM = 1 unless their
/// hourglass card already says type 6. Shells run as ELFORM 16 with drilling stiffness (DRCPRM 1) and warping stiffness
/// (IHQ 8), triangles as ELFORM 4, or 17 where the deck says so, with drilling stiffness. Changes of formulation are
/// notes. Nodes whose motion a response over frequency enforces are held.
model::Model linear_model(const model::Model& model, Findings& findings);

/// The ties as a linear analysis sees them: springs of ties by penalty become constraints that keep the gap as a lever,
/// which is their limit of large stiffness. A note says so.
weld::Ties linear_ties(const weld::Ties& ties, Findings& findings);

}  // namespace nugget::nvh
