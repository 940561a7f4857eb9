// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "output/history.hpp"

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

/// The file `secforc`; the legend holds the titles of *DATABASE_CROSS_SECTION_..._ID.
const HistoryFormat<SecforcState>& secforc();

}  // namespace nugget::output
