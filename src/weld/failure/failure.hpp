// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "base/archive.hpp"
#include "weld/failure/damage.hpp"
#include "weld/failure/failure_course.hpp"
#include "weld/failure/function.hpp"

namespace nugget::weld {

/// Mean of the last `length` loads (NF of MAT_100), resultants and strain rate; of fewer at the start.
class Filter {
 public:
  explicit Filter(int length = 0) : length_(length) {}
  failure::Load operator()(const failure::Load& load);
  void archive(Archive& a);

 private:
  int length_;
  std::size_t next_ = 0;
  std::vector<failure::Load> kept_;
};

/// What happened to one weld: its filtered resultants now, its peaks, and its end.
class History {
 public:
  /// `law` must outlive it.
  History(const model::WeldLaw& law, std::unique_ptr<failure::Function> function, const DamageLaw& damage = {})
      : law_(&law), function_(std::move(function)), filter_(law.filter), damage_(damage) {}

  /// Takes the load of a cycle. True if the weld fails now: by its failure function, by time, or because its damage is
  /// complete.
  bool update(const failure::Load& load);
  /// Records that the weld was removed for a reason of its element (all section points failed).
  void fail(double time, FailureMode mode);

  const Resultants& resultants() const { return now_.resultants; }
  double strain_rate() const { return now_.rate; }  ///< effective, filtered as the resultants are
  /// What the failure function has begun, if the material lets the weld fade.
  const Damage& damage() const { return damage_; }
  double failure_value() const { return value_.value; }  ///< of the failure function; 1 is failure
  bool failed() const { return mode_ != FailureMode::intact; }
  double failure_time() const { return failure_time_; }
  FailureMode mode() const { return mode_; }

  const Peaks& peaks() const { return peaks_; }
  double peak_failure_value() const { return peak_value_; }
  double peak_failure_time() const { return peak_time_; }
  /// The failure value over time, up to failure.
  const FailureCourse& course() const { return course_; }
  void restart_course() { course_.restart(); }
  /// Load and failure value with its terms in the last cycle of a weld that has failed; of one that holds: now.
  const failure::Load& last_load() const { return last_; }
  const failure::Value& last_value() const { return value_; }

  void archive(Archive& a);

 private:
  bool surface_reached();
  Damage::State advance_damage(const failure::Load& load);
  const model::WeldLaw* law_;
  std::unique_ptr<failure::Function> function_;
  Filter filter_;
  failure::Load now_, last_;
  failure::Value value_;
  double peak_value_ = 0.0, peak_time_ = 0.0;
  FailureCourse course_;
  int beyond_ = 0;  // consecutive cycles at or beyond the failure surface
  Damage damage_;
  FailureMode onset_mode_ = FailureMode::intact;  // what began the damage
  double failure_time_ = 0.0;
  FailureMode mode_ = FailureMode::intact;
  Peaks peaks_;
};

}  // namespace nugget::weld
