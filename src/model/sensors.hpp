// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/finding.hpp"
#include "base/vec3.hpp"
#include "model/parts.hpp"

// *SENSOR_...: what is measured during a run, the switches on it, and what these turn on and off.
namespace nugget::model {

/// *SENSOR_DEFINE_NODE, _FORCE, _ELEMENT, _MISC, _CALC-MATH, _FUNCTION: a number that changes during the run.
struct Sensor {
  enum class Quantity {
    place,
    velocity,
    acceleration,
    time,
    curve,
    turning,          ///< RIGIDBODY RX, RY, RZ with V
    turning_rate,     ///< with A
    displacement,     ///< RIGIDBODY TX, TY, TZ with D
    work_of_motion,   ///< BNDOUT
    joint_stiffness,  ///< JNTSTG
    force,
    moment,
    element,
    belt,
    calculation,
    function
  };
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
  /// What pushes whose force is measured: the lists of Model that `sources` are places in.
  enum class Pushing { wall, support, motion, joint, contact };
  /// Of an element.
  enum class OfElement {
    stress,     ///< component 0..5: xx yy zz xy yz zx
    von_mises,  ///< of the stress
    hydrostatic,
    principal,  ///< component 0..2, the greatest first
    shear,      ///< greatest
    resultant,  ///< component of ElementGroup::resultants
    force,      ///< of a spring
    elongation,
    failed  ///< 1 once it is deleted
  };

  /// Of seat belts: `element` is the place of a belt, a slip ring or a retractor in Model::belts.
  enum class OfBelt { tension, elongation, slip, first_tension, second_tension, pull_out, pull_out_rate, reel_tension };

  int id = 0;
  Quantity quantity = Quantity::time;
  std::array<Index, 2> node{none, none};  ///< with a second one: of the first, seen from the second
  Index body = none;                      ///< in place of nodes: the centre of a rigid body
  Vec3d direction;                        ///< along which it counts, in the axes of `system`; zero: the amount
  Index system = none;                    ///< of `direction`; none: global axes
  Index curve = none;
  Calculation calculation = Calculation::sum;
  std::vector<Term> terms;  ///< of calculations; of a function its arguments
  Index function = none;
  Pushing pushing = Pushing::wall;
  std::vector<Index> sources;
  std::size_t axis = 0;  ///< JNTSTG: 0 phi, 1 theta, 2 psi
  bool rate = false;     ///< JNTSTG: their rates
  ElementKind kind = ElementKind::nothing;
  Index element = none;
  OfElement of_element = OfElement::stress;
  OfBelt of_belt = OfBelt::tension;
  std::size_t component = 0;
  int layer = 0;                    ///< from 1: as elout lists them; 0: the lowest; -1: the highest
  double scale = 1.0, power = 1.0;  ///< the value is (scale v)^power
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
  double delay = 0.0;       ///< TDELAY: it goes on and off so much later [time]
  std::vector<Term> terms;  ///< of a logic, from left to right
};

/// *SENSOR_CONTROL: on or off, and changed by one switch after the other. What it turns on and off names it.
struct SensorControl {
  int id = 0;
  std::string what;  ///< TYPE and TYPEID, for messages
  bool starts_on = true;
  std::vector<Index> switches;  ///< SWIT1 to SWIT7: each changes what the one before left
  bool repeats = false;         ///< NREP -1: after the last one the first one again
  Place place;
};

}  // namespace nugget::model
