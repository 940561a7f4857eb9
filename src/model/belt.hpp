// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "base/vec3.hpp"
#include "model/parts.hpp"

// Seat belts: *ELEMENT_SEATBELT..., *MAT_SEATBELT.
namespace nugget::model {

/// *MAT_SEATBELT of belts with two nodes.
struct BeltMaterial {
  int id = 0;
  Index loading = none, unloading = none;  ///< curves: tension over engineering strain; none: as loading
  double line_density = 0.0;               ///< MPUL [mass/length]
  double least_length = 0.0;               ///< LMIN: below it a belt passes its ring, or goes into its retractor
  Place place;
};

/// *ELEMENT_SEATBELT.
struct Belt {
  int id = 0;
  Index part = none;
  Index material = none;                  ///< in Model::belt_materials
  std::array<Index, 2> node{none, none};  ///< those of rings and retractors themselves stand for the nodes there
  double slack = 0.0;                     ///< SLEN: unstretched length beyond the distance of the nodes [length]
  Index retractor = none;                 ///< in which it is wound up at the start
  double mass = 0.0;
  Place place;
};

/// *ELEMENT_SEATBELT_SLIPRING: where a belt changes its direction and slides.
struct SlipRing {
  int id = 0;
  std::array<Index, 2> belt{none, none};
  Index node = none;
  double friction = 0.0, static_friction = 0.0;      ///< FC, FCS; 0 of the latter: as the former
  Index friction_curve = none, static_curve = none;  ///< over time, in their place
  double decay = 0.0;                                ///< DC [time/length]
  double lock_time = 1e20;                           ///< LTIME: nothing slides from then on
  bool to_first = true, to_second = true;            ///< ways that material may go, DIRECT
  Place place;
};

/// *ELEMENT_SEATBELT_SENSOR.
struct BeltSensor {
  enum class Kind { acceleration, pull_out_rate, time, distance, pull_out };
  int id = 0;
  Kind kind = Kind::time;
  std::array<Index, 2> node{none, none};
  Vec3d direction;  ///< of an acceleration
  Index retractor = none;
  double above = 1e20;         ///< it responds above this
  double below = -1e20;        ///< and below this
  double duration = 0.0;       ///< for so long [time]
  bool in_relaxation = false;  ///< SBSFL 1
  Place place;
};

/// *ELEMENT_SEATBELT_RETRACTOR.
struct Retractor {
  int id = 0;
  Index node = none;
  Index belt = none;                       ///< the one that comes out of it
  std::vector<Index> inside;               ///< those that are wound up, the first to come out first
  std::vector<Index> inside_nodes;         ///< between them: that of `belt` first
  std::vector<Index> sensors;              ///< SID1 to SID4, in Model::belt_sensors
  Index control = none;                    ///< *SENSOR_CONTROL with BELTRETRA: as one more sensor
  double delay = 0.0;                      ///< TDEL [time]
  double pull = 0.0;                       ///< PULL: what can still be pulled out after that [length]
  Index loading = none, unloading = none;  ///< curves: tension over pull-out once it is locked
  double fed_length = 0.0;                 ///< LFED
  Place place;
};

/// *ELEMENT_SEATBELT_PRETENSIONER.
struct Pretensioner {
  enum class Kind {
    limited_pull_in,  ///< SBPRTY 1: turns the retractor's spool; its tension is that of the locked retractor
    spring_acts,      ///< 2: a spring has its force from then on
    spring_ends,      ///< 3: a spring has no force from then on
    pull_in           ///< 5: reels in what the curve says, whatever the tension, but for `most_tension`
  };
  int id = 0;
  Kind kind = Kind::pull_in;
  std::vector<Index> sensors;               ///< SBSID1 to SBSID4, in Model::belts
  Index control = none;                     ///< *SENSOR_CONTROL with BELTPRET: as one more sensor
  double delay = 0.0;                       ///< TIME [time]
  Index retractor = none, discrete = none;  ///< SBRID
  Index curve = none;                       ///< PTLCID: pull-in over the time since it acts
  double most_tension = 0.0;                ///< LMTFRC: at which pull-in ends; 0: none
  Place place;
};

/// Seat belts of a model.
struct Belts {
  std::vector<BeltMaterial> materials;
  std::vector<Belt> elements;
  std::vector<SlipRing> rings;
  std::vector<BeltSensor> sensors;
  std::vector<Retractor> retractors;
  std::vector<Pretensioner> pretensioners;
  bool empty() const { return elements.empty() && pretensioners.empty(); }
};

}  // namespace nugget::model
