// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "weld/tie/segment.hpp"
#include "weld/tie/sheet_mesh.hpp"

// The nugget's disc on its sheet: what the end of a weld is tied to where it is tied by area
// (docs/theory/ties.md#tie-by-area).
namespace nugget::weld {

/// The disc is at least this share of the size of the elements under it, so that its nodes never stand on a line.
inline constexpr double least_disc_over_element = 0.5;

/// Integrals of the shape functions of a flat convex segment, its corners in the plane z = 0, over its part in the disc
/// of `radius` about the origin [length^2]. Exact to round-off: by Green's theorem along the segment's sides and the
/// disc's arcs, on which Gauss' rule converges like a power of its points. Corners may run either way round. Nothing
/// where the segment is not convex.
std::optional<std::array<double, 4>> integrals_over_disc(const Corners& corner, bool triangle, double radius);

/// A place on a sheet.
struct PlaceOnSheet {
  Index shell = none;  ///< under it
  Vec3d point;         ///< [length]
};

/// The disc of `diameter` about a place on a sheet, made as large as `least_disc_over_element` wants it. It lies in the
/// plane of the shell there and goes on over sides of shells, whatever their parts, that one other shell within 30
/// degrees of that plane has; at free edges, folds and seams it is cut off. Empty where a shell under it is not convex
/// or there is no area, and `why_not` says so.
Disc disc_on_sheet(const model::Model& model, const std::vector<Vec3d>& x, const SheetMesh& mesh,
                   const PlaceOnSheet& place, double diameter, std::string& why_not);

/// Weights of the disc's nodes where some of its shells are not there, of what it covers on the others; adding up to 1.
/// Empty where these are less than half of it: the tie ends.
std::vector<double> weights_without(const model::Model& model, const Disc& disc,
                                    const std::function<bool(Index shell)>& absent);

/// a_eff = sqrt(2 sum w r^2), r from `point`: the radius of the disc whose forces reach as far from the middle as those
/// of a tie with these weights [length].
double effective_radius(std::span<const Index> nodes, std::span<const double> weights, const std::vector<Vec3d>& x,
                        const Vec3d& point);

/// Hangs the ends of all welds that are to hang so and are tied to sheets on discs there: beams and bricks where
/// Control::weld_tie says it, those of *CONSTRAINED_INTERPOLATION_SPOTWELD always; all nodes of an end face of bricks
/// on one. A warning names each reason why ends stay with their segments, a note what it comes to.
void hang_on_discs(const model::Model& model, const std::vector<Weld>& welds, const std::vector<Vec3d>& x,
                   std::vector<Tie>& ties, Findings& findings);

/// Forces that reach more than so many radii of the nugget far hold the sheet too stiffly: the elements are too large.
inline constexpr double most_hold = 3.0;

/// How far the forces of a weld's ends reach, over the nugget's radius: a_eff / a of the worse end by each form of tie;
/// NaN where there is nothing of the kind.
struct WeldReach {
  double by_segment, by_area;
};
/// One a weld.
std::vector<WeldReach> reaches(const model::Model& model, const Ties& ties);

}  // namespace nugget::weld
