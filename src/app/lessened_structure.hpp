// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "nvh/eigen/weld_drop.hpp"

namespace nugget::app {

/// A structure without some of its welds: a system and matrices of its own.
class LessenedStructure {
 public:
  /// Null where it does not carry its preload without them. `whole` must outlive it.
  static std::unique_ptr<LessenedStructure> make(const nvh::Matrices& whole, const nvh::WeldGroup& without);
  const nvh::Matrices& matrices() const { return *matrices_; }

 private:
  explicit LessenedStructure(const nvh::Matrices& whole) : system_(whole.system.model, whole.system.ties, findings_) {}

  Findings findings_;  // those of the whole structure have been reported
  system::System system_;
  std::unique_ptr<nvh::Matrices> matrices_;
};

}  // namespace nugget::app
