// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/vec3.hpp"
#include "output/ascii.hpp"

namespace nugget::output {

/// What the components of a cross section's force stand in.
enum class SectionAxes { global, rigid_body, accelerometer, system };

/// Resultant of one cross section.
struct SecforcRow {
  int id = 0;         ///< user id of the section
  Vec3d force;        ///< [force]
  Vec3d moment;       ///< about the centroid [force length]
  Vec3d centroid;     ///< in global axes [length]
  double area = 0.0;  ///< [length^2]
  SectionAxes axes = SectionAxes::global;
  int axes_id = 0;  ///< user id of the rigid body or coordinate system
};

struct SecforcState {
  double time = 0.0;
  std::vector<SecforcRow> rows;  ///< the same sections in the same order in every state
};

/// The ASCII file `secforc`; the legend holds the titles of *DATABASE_CROSS_SECTION_..._ID.
class Secforc {
 public:
  Secforc(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend = {});
  void write(const SecforcState& state);
  void archive(Archive& a) { a(file_); }

 private:
  AsciiFile file_;
};

}  // namespace nugget::output
