// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/vec3.hpp"

namespace nugget::report {

/// What of a run is drawn, and from where.
struct PictureOptions {
  int state = 0;  ///< of its file, or the natural mode; from 1. 0: by time, of modes the first elastic one
  double time = std::numeric_limits<double>::infinity();  ///< the state nearest to it, the last at infinity
  std::string field;  ///< see picture_fields(); empty: plastic strain where there is some, else parts
  std::pair<double, double> range{0, 0};  ///< of the field's colours; both 0: as the values are
  Vec3d towards{0.6, -0.7, 0.45};         ///< from the model to the eye
  Vec3d up{0.0, 0.0, 1.0};
  double scale = 1.0;      ///< of displacements
  std::vector<int> parts;  ///< ids of those shown; empty: all
  int weld = 0;            ///< in the middle, with what is within six diameters; 0: the whole model
  bool edges = true;       ///< of elements, where they are wide enough to be told apart
  bool shapes = false;     ///< facets as shapes that can be scaled, instead of pixels
  int width = 1440, height = 960;
};

/// plastic_strain, von_mises_stress, thickness, damage, displacement, part.
const std::vector<std::string>& picture_fields();

/// The model of a run at a state of d3plot, or a natural mode of d3eigv, as an SVG document: shells and the skin of
/// bricks; above them beams, welds coloured by the largest failure value by then (hollow where sheets
/// hide them), a legend and what is seen. Parallel projection. Throws std::runtime_error where there is nothing to draw
/// or an option names what is not there.
std::string model_picture(const std::filesystem::path& directory, const PictureOptions& options);

/// The same from several directions, in place of that of the options; the run is read once.
std::vector<std::string> model_pictures(const std::filesystem::path& directory, const PictureOptions& options,
                                        std::span<const Vec3d> towards);

}  // namespace nugget::report
