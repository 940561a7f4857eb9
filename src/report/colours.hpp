// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/raster.hpp"

// The colours of pictures; those of the viewer (web/src/colours.js) are the same.
namespace nugget::report {

/// From the grey of a sheet that nothing happened to, over blue, green and yellow, to red: `share` from 0 to 1.
Colour ramp(double share);
/// Parts side by side are told apart by hues a golden angle from each other.
Colour colour_of_part(int index);
/// Of a weld by its failure value: 1 is failure, 0 none.
Colour colour_of_failure(double value);

}  // namespace nugget::report
