// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/finding.hpp"
#include "base/vec3.hpp"
#include "model/parts.hpp"

// *SENSOR_..., *TERMINATION_...: what may end a run before its time.
namespace nugget::model {

/// *SENSOR_DEFINE_NODE, _MISC, _CALC-MATH: a number that changes during the run.
struct Sensor {
  enum class Quantity { place, velocity, time, curve, calculation };
  /// Of the values s of other sensors: sum; sum of |s|; least and greatest of s, of |s|; product; sum of s^2, its root;
  /// sum of the roots.
  enum class Calculation {
    sum,
    sum_of_amounts,
    least,
    greatest,
    least_amount,
    greatest_amount,
    product,
    squares,
    root_of_squares,
    roots
  };
  struct Term {
    Index sensor = none;
    bool inverse = false;  ///< taken away from a sum, divided by in a product
  };

  int id = 0;
  Quantity quantity = Quantity::time;
  std::array<Index, 2> node{none, none};  ///< with a second one: of the first, seen from the second
  Vec3d direction;                        ///< unit vector along which it counts; zero: the amount
  Index curve = none;
  Calculation calculation = Calculation::sum;
  std::vector<Term> terms;
};

/// *SENSOR_SWITCH and _SWITCH_CALC-LOGIC: on while its condition has held for some time.
struct SensorSwitch {
  enum class Kind { sensor, time, logic };
  struct Term {
    Index of = none;
    bool any = false;  ///< or; else and
  };

  int id = 0;
  Kind kind = Kind::sensor;
  Index sensor = none;
  bool above = true;        ///< on above `value`; else below
  double value = 0.0;       ///< in the sensor's unit
  double window = 0.0;      ///< TIMWIN [time]
  std::vector<Term> terms;  ///< of a logic, from left to right
};

/// *TERMINATION_NODE, _BODY, _SENSOR: the run ends when a number leaves its bounds, or a switch is on.
struct RunEnd {
  enum class Kind { node, body, sensor };
  Kind kind = Kind::node;
  Index node = none, body = none, of_switch = none;
  int axis = 0;  ///< 0 to 2: x, y, z; 3: the amount
  double least = -1e20, most = 1e20;
  Place place;
};

struct RunEnds {
  std::vector<Sensor> sensors;
  std::vector<SensorSwitch> switches;
  std::vector<RunEnd> ends;
};

}  // namespace nugget::model
