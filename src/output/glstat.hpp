// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "output/history.hpp"

namespace nugget::output {

enum class ElementKind { solid, beam, shell, thick_shell, discrete };

/// The element whose time step the run follows.
struct ControllingElement {
  ElementKind kind = ElementKind::solid;
  int element = 0, part = 0;  ///< user ids
};

/// The model at one time: energies [force length], velocities [length/time].
struct GlstatState {
  long cycle = 0;
  std::optional<ControllingElement> controlling;  ///< none: the step comes from a load curve
  double time = 0.0, time_step = 0.0;
  double kinetic = 0.0, internal = 0.0;
  std::vector<double> walls;  ///< stonewall energy of each rigid wall
  std::optional<double> spring_and_damper, joint, hourglass;
  double system_damping = 0.0, sliding_interface = 0.0, external_work = 0.0;
  std::optional<double> eroded_kinetic, eroded_internal, eroded_hourglass;
  double total = 0.0;
  double ratio = 1.0;  ///< total / (initial + external work)
  std::optional<double> ratio_without_eroded;
  Vec3d velocity;  ///< of the centre of mass
  std::optional<int> nodes, elements;
  int nanoseconds_per_element_cycle = 0;
  std::optional<double> added_mass;        ///< by mass scaling [mass]
  std::optional<double> percent_increase;  ///< added mass in percent of the physical mass
};

/// The file `glstat`. Lines of absent quantities are left out, as LS-DYNA does.
const HistoryFormat<GlstatState>& glstat();

}  // namespace nugget::output
