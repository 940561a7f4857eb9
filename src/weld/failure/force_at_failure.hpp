// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "weld/failure/function.hpp"

namespace nugget::weld::failure {

/// The force that a weld carries in one direction, by its own failure function, without moments at mid-length and at a
/// strain rate of 0: f(F sin angle along the weld, F cos angle across it) = 1 [force]. `angle` in degrees: 0 shear, 90
/// tension. Infinite where the function limits no force in that direction.
double force_at_failure(const model::Model& model, const model::WeldLaw& law, const Geometry& weld, double angle);

}  // namespace nugget::weld::failure
