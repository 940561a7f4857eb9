// SPDX-License-Identifier: Apache-2.0
#pragma once

// What is known of the errors that the mesh around a weld leaves with its joint (--weld-tie joint).
namespace nugget::weld {

/// Largest errors of three coupons (two thicknesses and diameters, three steels; square, unlike and skewed meshes, the
/// weld at three places) against solids, shares of these: stiffness of lap, peel and cross tension, of stacks of three
/// sheets, and force of all of these beyond yield. docs/evidence/weld_place.md#how-far-the-joint-reaches.
struct PlaceErrors {
  double lap, peel, cross, stack, force;
};
/// Of welds whose forces reach so many nugget radii far (WeldReach::by_area); null beyond what was measured.
const PlaceErrors* place_errors(double reach);

}  // namespace nugget::weld
