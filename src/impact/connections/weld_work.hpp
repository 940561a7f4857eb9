// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "base/archive.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// The work of a weld's forces and moments at its two ends. The weld takes W_1 from the first sheet and W_2 from the
/// second, each a sum over the cycles and the nodes of the end of
///     1/2 (f before + f now) . v dt + 1/2 (m before + m now) . w dt
/// with the internal forces f and moments m of the weld's elements there. W_1 + W_2 is the work done on the weld,
/// (W_1 - W_2) / 2 the energy that passed its middle from the first sheet to the second, as seen in the axes of the
/// model (docs/theory/weld.md#energy-through-a-weld).
class WeldWork {
 public:
  WeldWork() = default;
  WeldWork(const system::System& system, const weld::Weld& weld);

  /// To be called once a cycle, after the forces of the elements, while the weld holds.
  void add_step(const system::System& system, const system::State& state);
  /// Work that a joint between an end and its sheet took from there in the last cycle.
  void add(const std::array<double, 2>& at_end);
  void reset();

  double passed() const {
    return 0.5 * (taken_[0] - taken_[1]);
  }                                                              ///< from the first sheet to the second so far [energy]
  double most_passed() const { return most_; }                   ///< that of largest magnitude so far [energy]
  const std::array<double, 2>& taken() const { return taken_; }  ///< W_1 and W_2 [energy]

  void archive(Archive& a);

 private:
  struct Corner {
    system::System::ElementLocation location;
    int corner = 0;  ///< of the element
    int node = 0;    ///< of the system
    int end = 0;
    Vec3d force, moment;  ///< of the last cycle
  };
  std::vector<Corner> corners_;
  std::array<double, 2> taken_{};
  double most_ = 0.0;
};

}  // namespace nugget::impact
