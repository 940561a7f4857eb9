// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "base/vec3.hpp"

namespace nugget::output {

/// Numbers of the points or cells of a grid; `components` of each stand together. Not a number: has none.
struct VtuArray {
  std::string name;
  int components = 1;
  std::variant<std::vector<float>, std::vector<std::int32_t>> values;
};

/// An unstructured grid of VTK.
struct VtuGrid {
  std::vector<Vec3d> points;
  std::vector<std::int64_t> corners, ends;  ///< of the cells: points; how many of them up to the end of each cell
  std::vector<std::uint8_t> types;          ///< VTK's numbers: 3 line, 5 triangle, 9 quadrilateral, 10 tetrahedron, ...
  std::vector<VtuArray> of_points, of_cells;

  /// A cell between these points.
  template <class Points>
  void add_cell(std::uint8_t type, const Points& its_points) {
    for (const auto point : its_points) corners.push_back(static_cast<std::int64_t>(point));
    ends.push_back(static_cast<std::int64_t>(corners.size()));
    types.push_back(type);
  }
};

/// Writes a `.vtu` (VTK XML, version 1.0, raw appended data, little endian). Source: VTK File Formats, Kitware. Throws
/// WriteError.
void write_vtu(const std::filesystem::path& path, const VtuGrid& grid);

/// Writes a `.pvd`: which file holds which time. Throws WriteError.
void write_pvd(const std::filesystem::path& path, const std::vector<std::pair<double, std::string>>& files);

}  // namespace nugget::output
