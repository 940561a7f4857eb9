// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "nvh/matrices/equations.hpp"
#include "output/d3plot.hpp"

namespace nugget::nvh {

/// Stresses, resultants and strain energies of all elements in a linear solution, out of the kernels of impact: a
/// system of its own goes a vanishing step with the solution's displacements as velocities, and what comes out is
/// scaled up. Nothing yields in such a step (docs/decisions/0017).
class ElasticStresses {
 public:
  /// `motion`: by system node, see Statics::motion.
  ElasticStresses(const system::System& at_rest, const std::vector<SixDof>& motion);

  /// Element records of a d3plot state, `share` of the solution.
  void fill(double share, output::D3plotState& state) const;

  /// Stress of point k of an element, global axes.
  std::array<double, 6> stress(const system::System::ElementLocation& location, int k) const;
  const system::System& system() const { return *system_; }

 private:
  std::unique_ptr<system::System> system_;
  system::State state_;
};

}  // namespace nugget::nvh
