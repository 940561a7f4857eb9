// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "system/system.hpp"
#include "weld/failure.hpp"

namespace nugget::impact {

/// The welds while the model moves: takes their resultants in every cycle, asks their histories whether they fail, and
/// removes the elements of those that did. Indices are those of Ties::welds.
class Welds {
 public:
  /// The system must outlive it.
  explicit Welds(system::System& system);

  /// To be called once a cycle, after the forces of the elements.
  void update(const system::State& state);

  std::size_t size() const { return histories_.size(); }
  /// What happened to weld i; null where a weld has no history (deleted by SPOTSTP, rigid).
  const weld::History* history(std::size_t i) const { return histories_[i].get(); }
  int failed() const { return failed_; }
  const std::vector<std::string>& events() const { return events_; }  ///< failures, a line each, for run.log

 private:
  void report(std::size_t i, const system::State& state);

  system::System& system_;
  std::vector<std::unique_ptr<weld::History>> histories_;
  int failed_ = 0;
  std::vector<std::string> events_;
};

}  // namespace nugget::impact
