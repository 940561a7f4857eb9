// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "nvh/response/steady_state.hpp"

namespace nugget::nvh {

/// Steady motion of the whole model under loads together at one frequency.
struct MotionAt {
  double frequency = 0.0;
  std::vector<std::array<std::complex<double>, 3>> u;  ///< displacement by model node, amplitude of exp(+i omega t)
};

/// Goes through frequencies in ascending order, under the loads of one case of a request. `modes`: the lowest ones; not
/// used where the request is direct. Throws Factorization::SolverError.
void each_motion(const Matrices& matrices, const Modes& modes, const model::SteadyState& request,
                 const model::SteadyState::Case& loads, const std::vector<double>& frequency,
                 const std::function<void(const MotionAt&)>& visit, const ProgressCallback& progress = {});

/// d3ssd, of _SUBCASE one family for each case: each frequency a state, the frequency as its time. Coordinates at rest
/// plus the displacement, velocities and accelerations: of each component the amplitude, or the real or imaginary part,
/// as the deck asks. Elements have no stresses. Returns the number of states of a family. Throws
/// Factorization::SolverError, output::WriteError.
std::size_t write_d3ssd(const std::filesystem::path& directory, const Matrices& matrices, const Modes& modes,
                        const model::SteadyState& request, const ProgressCallback& progress = {});

}  // namespace nugget::nvh
