// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "output/history.hpp"

namespace nugget::output {

/// Energies [force length], momentum and mass of one part.
struct MatsumRow {
  int part = 0;  ///< user id
  double internal = 0.0, kinetic = 0.0, hourglass = 0.0;
  double eroded_internal = 0.0, eroded_kinetic = 0.0;
  double added_mass = 0.0;  ///< by mass scaling [mass]
  Vec3d momentum;           ///< [mass length/time]
  Vec3d velocity;           ///< rigid body velocity: momentum / mass [length/time]
};

struct MatsumState {
  double time = 0.0;
  std::vector<MatsumRow> rows;           ///< the same parts in the same order in every state
  std::optional<double> lumped_kinetic;  ///< of masses that belong to no part; in the ASCII file as part 0
};

/// The file `matsum`; the legend holds the parts' titles.
const HistoryFormat<MatsumState>& matsum();

}  // namespace nugget::output
