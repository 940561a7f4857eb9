// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/archive.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Deletes elements at the time that *DEFINE_ELEMENT_DEATH gives, or when *SENSOR_CONTROL turns them off, and those
/// that would stop the run: bricks of negative volume and elements whose step falls below DTMIN (or a millionth) times
/// the first one, where ERODE (1 bricks, 10 shells, 100 beams, or their sums) or PSFAIL says so, and shells that turn
/// inside out, where NFAIL1 and NFAIL4 do. What the deck does not name stays: the run stops there.
class Erosion {
 public:
  explicit Erosion(system::System& system);

  /// Before the first forces: deletes what is not there from the start.
  void start(const system::State& state) { delete_by_time(state.time); }
  /// After the internal forces at the end of a step; `first_step` is the run's. Rows of deleted elements act for the
  /// last time.
  void update(const system::State& state, double first_step);

  struct Count {
    int small_step = 0, negative_volume = 0, distorted = 0;
  };
  const Count& deleted() const { return deleted_; }
  /// What was deleted, when and why, for run.log.
  const std::vector<std::string>& events() const { return events_; }
  /// NFAIL1 or NFAIL4 = 2, or as many failed shells as they say: why the run is to stop; else empty.
  const std::string& reason_to_stop() const { return stop_; }

  /// Share of the stable step (TSSFAC included) below which elements are deleted; 0: none are.
  double smallest_step(double first_step) const;
  void archive(Archive& a);

 private:
  bool wants_small_steps(model::ElementKind kind) const;
  bool wants_negative_volume(const system::ElementGroup& group) const;
  int distortion_rule(const system::ElementGroup& group) const;
  void delete_by_time(double time);
  void delete_by_switch(const system::State& state);
  void delete_one(const model::ElementDeath& death, double time, std::string_view why);
  void remove(system::ElementGroup& group, std::size_t e, double time, std::string_view why);
  void delete_small_steps(system::ElementGroup& group, double limit, double time);
  void delete_negative_volumes(system::ElementGroup& group, double time);
  void check_distortion(system::ElementGroup& group, int rule, const system::State& state);

  system::System& system_;
  Count deleted_;
  std::vector<model::ElementDeath> deaths_;  ///< by time
  std::size_t next_death_ = 0;
  std::vector<model::ElementDeath> switched_;  ///< of *SENSOR_CONTROL, those that are still there
  std::vector<std::string> events_;
  std::string stop_;
};

}  // namespace nugget::impact
