// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/finding.hpp"
#include "base/vec3.hpp"
#include "model/model.hpp"

// Lists of spots to be welded, as design offices hand them over.
namespace nugget::weld {

/// One spot of a list.
struct SpotPoint {
  Vec3d x;                 ///< [length of the model]
  double diameter = 0.0;   ///< 0: by the rule of the sheets [length of the model]
  std::vector<int> parts;  ///< user ids of the sheets that it joins; empty: those that are found
  std::string spot_class;  ///< of welds with one material; may be empty
  Place place;             ///< line of the list
};

/// Reads a list: xMCF where the file begins with `<`, else a table. Lengths of an xMCF file are brought to the model's
/// unit. Errors name file and line. `model` gives units and part titles.
///
/// A table has a point a line: x, y, z, then diameter, parts, class, or these in any order under a line of names.
/// Separators are commas, semicolons or tabs; part ids in their cell are separated by blanks or `+`. Lines that begin
/// with
/// `#` or `$` are remarks.
std::vector<SpotPoint> read_spots(const std::filesystem::path& path, const model::Model& model, Findings& findings);

/// xMCF (extended master connection file) 3.0 and 3.1: connection_0d with spotweld, and connection_1d with a sequence
/// of them. What else it connects is ignored with a warning. Source: FAT-Schriftenreihe 286 (2016), ISO/PAS 8329 and
/// its schema xmcf_3_1_1.xsd.
std::vector<SpotPoint> read_xmcf(const std::string& text, const std::string& file, const model::Model& model,
                                 Findings& findings);

}  // namespace nugget::weld
