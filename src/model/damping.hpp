// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/parts.hpp"

// *DAMPING_...
namespace nugget::model {

/// *DAMPING_GLOBAL, *DAMPING_PART_MASS: force -D m v on each node, moment -D I w.
struct MassDamping {
  bool everything = false;  ///< all nodes and bodies; else the masses of `part`
  Index part = none;
  Index curve = none;           ///< D over time [1/time], or none
  double factor = 0.0;          ///< D itself, or the scale of the curve
  Vec3d scale{1, 1, 1};         ///< STX STY STZ, on the components of the force
  Vec3d rotary_scale{1, 1, 1};  ///< SRX SRY SRZ, on those of the moment
};

/// *DAMPING_PART_STIFFNESS: forces beta K v out of the elastic stiffness of the part's elements.
struct StiffnessDamping {
  Index part = none;
  double share = 0.0;  ///< COEF > 0: of critical damping at each element's highest frequency
  double time = 0.0;   ///< COEF < 0: beta itself [time]
};

/// *DAMPING_FREQUENCY_RANGE, _DEFORM: about the same share of critical damping at all frequencies of a range.
struct FrequencyRangeDamping {
  double share = 0.0;            ///< CDAMP
  double low = 0.0, high = 0.0;  ///< FLOW, FHIGH [cycles/time]
  bool everything = false;       ///< all nodes and bodies; else the masses of `parts`
  std::vector<Index> parts;
  Index relative_to = none;  ///< PIDREL: a rigid body; velocities relative to its motion
  /// _DEFORM: against the changes of the forces in the elements of `parts` instead of the motion of nodes.
  /// `everything`: these are all parts, but what another such card names is that card's.
  bool deform = false;
};

/// *DAMPING_RELATIVE: damping of the motion relative to a rigid body.
struct RelativeDamping {
  double share = 0.0;      ///< CDAMP, of critical at `frequency`
  double frequency = 0.0;  ///< FREQ [cycles/time]
  Index rigid_body = none;
  std::vector<Index> parts;
  double quadratic = 0.0;  ///< DV2: a further force m DV2 |v| v [1/length]
  Index curve = none;      ///< factor on both over time, or none
};

struct Damping {
  std::vector<MassDamping> mass;
  std::vector<StiffnessDamping> stiffness;
  std::vector<FrequencyRangeDamping> range;
  std::vector<RelativeDamping> relative;
};

}  // namespace nugget::model
