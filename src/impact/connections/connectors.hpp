// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "impact/connections/weld_work.hpp"
#include "system/system.hpp"
#include "weld/failure/resultants.hpp"

namespace nugget::impact {

/// The discrete beams that join sheets, while the model moves: largest forces, and when they failed. Their elements
/// decide on failure themselves. Indices are those of Ties::welds; other kinds of welds have no record.
class Connectors {
 public:
  struct Record {
    weld::Peaks peaks;
    bool failed = false;
    double failure_time = 0.0;
    // Of a joint between sheets (*CONSTRAINED_INTERPOLATION_SPOTWELD) only; of one that failed, just before.
    weld::Resultants last;
    double plastic = 0.0, damage = 0.0;                         ///< [length], [1]
    double failure = 0.0, peak_failure = 0.0, peak_time = 0.0;  ///< kernel::Spr3::failure_value
    double mode_mixity = 0.0;
  };

  /// The system must outlive it.
  explicit Connectors(const system::System& system);

  /// To be called once a cycle, after the forces of the elements.
  void update(const system::State& state);

  /// Distance of the ends of weld i now, which is a connector [length].
  double length(std::size_t i) const;
  /// Null where weld i is no connector, or was deleted before the run.
  const Record* record(std::size_t i) const { return records_[i].location.group < 0 ? nullptr : &records_[i].record; }
  /// The work of its forces on its sheets; nothing where weld i is no connector.
  const WeldWork& work(std::size_t i) const { return works_[i]; }
  void reset_work();
  int failed() const { return failed_; }
  const std::vector<std::string>& events() const { return events_; }  ///< failures, a line each, for run.log

  bool empty() const { return connectors_.empty(); }
  /// See Components::elements_read.
  template <class Visit>
  void elements_read(const Visit& visit) const {
    for (const Entry& entry : records_) visit(entry.location);
  }

  void archive(Archive& a);

 private:
  struct Entry {
    system::System::ElementLocation location;
    Record record;
  };
  template <class Joint>
  static void follow_joint(const Joint& joint, const std::array<double, 8>& resultants, double time, Record& record);
  std::string event(std::size_t i, const system::State& state) const;
  const system::System& system_;
  std::vector<Entry> records_;
  std::vector<std::size_t> connectors_;  ///< those that are connectors
  std::vector<WeldWork> works_;
  int failed_ = 0;
  std::vector<std::string> events_;
};

}  // namespace nugget::impact
