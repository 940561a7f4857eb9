// SPDX-License-Identifier: Apache-2.0
#pragma once

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
  };

  /// The system must outlive it.
  explicit Connectors(const system::System& system);

  /// To be called once a cycle, after the forces of the elements.
  void update(const system::State& state);

  /// Null where weld i is no connector, or was deleted before the run.
  const Record* record(std::size_t i) const { return records_[i].location.group < 0 ? nullptr : &records_[i].record; }
  /// The work of its forces on its sheets; nothing where weld i is no connector.
  const WeldWork& work(std::size_t i) const { return works_[i]; }
  void reset_work();
  int failed() const { return failed_; }
  const std::vector<std::string>& events() const { return events_; }  ///< failures, a line each, for run.log

  void archive(Archive& a);

 private:
  struct Entry {
    system::System::ElementLocation location;
    Record record;
  };
  const system::System& system_;
  std::vector<Entry> records_;
  std::vector<WeldWork> works_;
  int failed_ = 0;
  std::vector<std::string> events_;
};

}  // namespace nugget::impact
