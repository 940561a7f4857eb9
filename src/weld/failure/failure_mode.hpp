// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace nugget::weld {

/// What a weld failed by: a term of its failure function, or something else.
enum class FailureMode {
  intact,
  // terms of failure functions
  axial,
  shear,
  torsion,
  bending,
  normal_stress,
  shear_stress,
  sheet_1,
  sheet_2,
  nugget,
  tension,
  compression,
  user,  ///< the value of a function of the user's own
  // other ends
  time,
  plastic_strain,
  sheet_deleted,
  element_deleted,  ///< by *DEFINE_ELEMENT_DEATH
  distortion,
};
std::string_view to_string(FailureMode mode);

}  // namespace nugget::weld
