// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nvh/matrices/matrices.hpp"

namespace nugget::nvh {

/// C = T^t C_e T of what damps by itself: dashpots (*MAT_DAMPER_VISCOUS and other laws of springs and discrete beams,
/// with their slope at rest), alpha M of *DAMPING_PART_MASS, beta K of *DAMPING_PART_STIFFNESS with a negative COEF.
/// The parts must have passed check_part_damping.
Symmetric part_damping(const Matrices& matrices);

/// Errors for damping of parts that is no matrix: constants that change over time, scales by direction, shares of
/// critical damping at the highest frequency of an element; a warning where nothing damps.
void check_part_damping(const Matrices& matrices, const Place& place, const char* keyword, Findings& findings);

/// Whether elements have dashpots.
bool has_dashpots(const Matrices& matrices);

/// A warning that names the *DAMPING_ cards that take no part in a response over frequency. `of_parts`: whether those
/// of parts do (DMPFLG 1).
void warn_of_idle_damping(const model::Model& model, bool of_parts, const Place& place, const char* keyword,
                          const char* remedy, Findings& findings);

}  // namespace nugget::nvh
