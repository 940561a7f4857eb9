// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "nvh/response/frequency_response.hpp"

namespace nugget::nvh {

/// Steady motion of one node in one direction under all loads of a deck together: displacement, velocity and
/// acceleration, as amplitudes of exp(+i omega t).
struct SteadyCurve {
  int load_case = 0;                                       ///< of _SUBCASE, counted from 1; else 0
  int node = 0;                                            ///< user id
  Vec3d direction;                                         ///< unit vector
  std::array<std::vector<std::complex<double>>, 3> value;  ///< by frequency; in the order of `steady_quantities`
};
inline constexpr std::array steady_quantities{model::FrequencyResponse::Quantity::displacement,
                                              model::FrequencyResponse::Quantity::velocity,
                                              model::FrequencyResponse::Quantity::acceleration};

struct SteadyResult {
  std::vector<double> frequency;
  std::vector<SteadyCurve> curve;  ///< three directions a node
  SolutionMethod method;
};

/// Findings for what the equations cannot answer.
void check_steady_state(const Matrices& matrices, const model::SteadyState& request, Findings& findings);

/// Steady motion of the nodes of *DATABASE_HISTORY_NODE, along the axes of the model or of their own system. `modes`:
/// the lowest ones; not used where the request is direct. Throws Factorization::SolverError.
SteadyResult steady_state(const Matrices& matrices, const Modes& modes, const model::SteadyState& request,
                          const ProgressCallback& progress = {});

/// Amplitude of a load at a frequency.
std::complex<double> amplitude(const model::Model& model, const model::SteadyState& request,
                               const model::SteadyState::Load& load, double frequency);

/// ssd.csv: a line for each frequency of each response; and nodout_ssd, of _SUBCASE one for each case. Throws
/// output::WriteError.
void write_steady_state(const std::filesystem::path& directory, const output::Header& header,
                        const model::SteadyState& request, const SteadyResult& result);

/// The name of a file of a case: of _SUBCASE with the name of the case behind it.
std::string file_of_case(const char* name, const model::SteadyState::Case& loads);

}  // namespace nugget::nvh
