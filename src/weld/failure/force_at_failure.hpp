// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/spr2.hpp"
#include "kernel/law/spr3.hpp"
#include "weld/failure/function.hpp"

namespace nugget::weld::failure {

/// The force that a weld carries in one direction, by its own failure function, without moments at mid-length and at a
/// strain rate of 0: f(F sin angle along the weld, F cos angle across it) = 1 [force]. `angle` in degrees: 0 shear, 90
/// tension. Infinite where the function limits no force in that direction.
double force_at_failure(const model::Model& model, const model::WeldLaw& law, const Geometry& weld, double angle);

/// The largest force that an interpolation spot weld carries in one direction that does not change, without moments:
/// its surface times the largest of F0(u) [1 - d(u)], since the mode mixity and the normal of the surface stay.
double force_at_failure(const kernel::Spr3& joint, double angle);

/// The same of a rivet: at each damage h the displacement that such a force asks for has an effective size of h.
double force_at_failure(const kernel::Spr2& rivet, double angle);

}  // namespace nugget::weld::failure
