// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "app/commands.hpp"
#include "app/prepared_deck.hpp"
#include "nvh/eigen/modes.hpp"
#include "output/ascii.hpp"
#include "output/summary.hpp"

namespace nugget::app {

/// Computes the responses over frequency that the deck asks for (*FREQUENCY_DOMAIN_FRF, _SSD), writes their files, adds
/// them to the summary and returns what run.log says of them. `doubts`: frequencies that the modes do not reach. Throws
/// nvh::Factorization::SolverError, output::WriteError.
std::string responses_of(const std::filesystem::path& directory, const output::Header& header,
                         const nvh::Matrices& matrices, const nvh::Modes& modes, const model::Model& model,
                         output::Summary& summary, Findings& doubts, const nvh::ProgressCallback& progress);

/// Findings for what the equations cannot answer.
void check_responses(const nvh::Matrices& matrices, const model::Model& model, Findings& findings);

/// Whether all responses that a deck asks for are solved directly, without modes.
bool all_direct(const model::Model& model);

/// What the deck asks for (*CONTROL_IMPLICIT_GENERAL, _EIGENVALUE, *FREQUENCY_DOMAIN_...).
enum class Analysis { explicit_dynamics, direct_response, modes_and_responses, statics };
Analysis analysis_of(const model::Model& model);

/// Responses over frequency by direct solution, into a folder whose old results are gone.
ExitCode direct_responses(const std::filesystem::path& directory, const RunArguments& arguments, PreparedDeck prepared,
                          Findings& findings);

}  // namespace nugget::app
