// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "system/system.hpp"

namespace nugget::impact {

struct Components;

/// What *SENSOR_DEFINE_... measures, the *SENSOR_SWITCH_... on it, and what *SENSOR_CONTROL makes of these. Only what
/// an end of the run or a control asks for is looked at. Forces are those of the cycle before; velocities are those
/// half a step before the places.
class Sensors {
 public:
  explicit Sensors(const system::System& system);

  /// To be called once a cycle, before velocities are updated: looks at sensors and switches, and leaves what is turned
  /// on and off in `state.controls`. Over several ranks all call it, and all find the same.
  void update(system::State& state, const Components& components);
  /// Whether a switch that something asks for is on, by the last update.
  bool on(model::Index of_switch) const { return switches_[of_switch].on; }
  /// What a sensor that something asks for has measured in the last update.
  double value(model::Index sensor) const { return values_[sensor]; }
  /// What was turned on or off, and when, for run.log.
  const std::vector<std::string>& events() const { return events_; }

  /// Elements that all of several ranks must compute.
  void elements_read(const std::function<void(system::System::ElementLocation)>& visit) const;
  void archive(Archive& a);

 private:
  /// A switch, or what is known of one.
  struct Switch {
    double since = -1.0;              ///< from when its condition has held without a break; below 0: it does not
    bool now = false;                 ///< on, but for the delay
    bool on = false;                  ///< on, with it
    std::vector<double> turns_later;  ///< times of changes that the delay holds back
    void archive(Archive& a) { a(since, now, on, turns_later); }
  };
  /// Acceleration of a sensor's node, by the velocities of two cycles.
  struct Motion {
    Vec3d velocity, acceleration;
    double step = 0.0;   ///< that ended where it was looked at
    bool known = false;  ///< the velocity of the cycle before
    void archive(Archive& a) { a(velocity, acceleration, step, known); }
  };
  void ask_for_switch(model::Index of_switch);
  void ask_for_sensor(model::Index sensor);
  double measure(std::size_t sensor, const system::State& state, const Components& components);
  double along(const model::Sensor& sensor, const Vec3d& vector, const system::State& state) const;
  Vec3d velocity_of(const model::Sensor& sensor, const system::State& state, bool turning) const;
  Vec3d acceleration_of(std::size_t sensor, const system::State& state, bool turning);
  Vec3d load_of(const model::Sensor& sensor, const Components& components) const;
  double of_element(const model::Sensor& sensor, const system::State& state) const;
  void look_at(std::size_t of_switch, const system::State& state);
  void turn(std::size_t control, system::State& state);

  const system::System& system_;
  // Those that something asks for, such that what others need comes before them.
  std::vector<model::Index> asked_sensors_, asked_switches_;
  std::vector<double> values_;     ///< by sensor
  std::vector<Motion> motions_;    ///< by sensor
  std::vector<Switch> switches_;   ///< by switch
  std::vector<std::size_t> next_;  ///< by control: how many of its switches have changed it
  std::vector<std::string> events_;
};

}  // namespace nugget::impact
