// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "kernel/element/fibre_rule.hpp"

namespace nugget::kernel {

inline constexpr int section_shapes = 22;

/// A standard cross-section: ICST of *INTEGRATION_BEAM, STYPE SECTION_01 to SECTION_22 of *SECTION_BEAM. What D1 to D6
/// mean: docs/manual/cross_sections_of_beams.md.
struct SectionShape {
  int type = 1;               ///< 1 to section_shapes
  std::array<double, 6> d{};  ///< D1 to D6 [length]
};

/// With its article: "a channel".
std::string_view shape_name(int type);
/// How many of D1 to D6 the shape has.
int shape_dimensions(int type);

/// Why there is no such cross-section: which of D1 to D6 (0 to 5) is wrong, and what with it.
struct ShapeFault {
  int dimension = 0;
  std::string text;
};
std::optional<ShapeFault> shape_fault(const SectionShape& shape);

/// Exact for the shape's rectangles, trapezoids and rings; second moments about the centroid.
struct ShapeConstants {
  double area = 0.0;                      ///< [length^2]
  double extent_s = 0.0, extent_t = 0.0;  ///< of the rectangle around it [length]
  double centre_s = 0.0, centre_t = 0.0;  ///< centroid, seen from that rectangle's middle [length]
  double moment_s = 0.0, moment_t = 0.0;  ///< of t^2 (ISS) and of s^2 (ITT) over the area [length^4]
  double product = 0.0;                   ///< of s t [length^4]
  double torsion = 0.0;                   ///< Saint-Venant's constant, docs/theory/beam.md#cross-sections [length^4]
};
ShapeConstants shape_constants(const SectionShape& shape);

/// Points of the shape, seen from the middle of the rectangle around it, with its exact area and second moments. A
/// plate has 4 (1 + K) points along its length and 2 across it, a solid shape 4 (1 + K) both ways, a ring or disc 2 + K
/// radii times 8 (1 + K) angles. Empty (count 0) where that would be more than most_fibres.
FibreRule shape_fibres(const SectionShape& shape, int refinement);

/// The points of a standard cross-section whose nodes stand at (s, t), -1 to 1 over the rectangle around it.
SectionPoints shape_points(const SectionShape& shape, int refinement, double node_s, double node_t);

/// The middle of the points given from the nodes; they say nothing of warping, so that their polar moment is the
/// torsion constant.
SectionPoints user_points(const FibreRule& fibres);

}  // namespace nugget::kernel
