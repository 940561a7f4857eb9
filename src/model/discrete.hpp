// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/parts.hpp"

// Springs and dampers between two nodes, or between a node and the ground.
namespace nugget::model {

/// *SECTION_DISCRETE: what holds for every law of a spring.
struct SectionDiscrete {
  int id = 0;
  bool torsional = false;      ///< DRO = 1: twist and moment instead of elongation and force
  double magnification = 0.0;  ///< KD / V0: the force is multiplied by 1 + magnification |v| [time/length]
  double clearance = 0.0;      ///< CL: compression without force; then there is none in tension
  double failure = 0.0;        ///< FD: fails at this elongation, or compression where negative; 0: never
  double most_compression = 0.0, most_elongation = 0.0;  ///< CDL, TDL: stops, both positive; 0: none
  Place place;
};

/// *DEFINE_SD_ORIENTATION: along which line a spring acts.
struct SpringOrientation {
  int id = 0;
  Vec3d direction;                        ///< unit vector, IOP 0 and 1
  std::array<Index, 2> node{none, none};  ///< from the first to the second as they move, IOP 2 and 3
  bool in_plane = false;  ///< IOP 1, 3: along the line of the spring's nodes, seen in the plane normal to it
  Place place;
};

/// *ELEMENT_DISCRETE.
struct Discrete {
  int id = 0;
  Index part = none;
  std::array<Index, 2> node{none, none};  ///< without a second one: to the place where the first one was at time 0
  Index orientation = none;               ///< in Model::spring_orientations; none: along the line of the nodes
  double scale = 1.0;                     ///< S: factor on its forces
  double offset = 0.0;                    ///< OFFSET: elongation at time 0
  bool in_deforc = true;                  ///< PF = 0
  Place place;
  bool grounded() const { return node[1] == none; }
};

}  // namespace nugget::model
