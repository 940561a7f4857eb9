// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "base/finding.hpp"
#include "impact/simulation/simulation.hpp"
#include "output/restart_file.hpp"
#include "output/summary.hpp"
#include "system/system.hpp"
#include "weld/tie/ties.hpp"

// The parts of run.log, each a text. What a person wants to read after a run, in the order of the run.
namespace nugget::app {

/// As many as there are.
inline constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

/// What several ranks compute whole, each for itself, and how many nodes all of them move.
std::string log_computed_by_all(const impact::Simulation& run, const system::Partition& partition);
std::string log_head(const std::string& version, const std::string& deck, int threads, int ranks);
std::string log_findings(const Findings& findings);
/// Parts with their sections, materials, element counts and masses.
std::string log_model(const model::Model& model);
/// How many welds are tied, by projection case; the first `most` weld nodes that are not, with their reasons.
std::string log_ties(const model::Model& model, const weld::Ties& ties, std::size_t most);
/// OUTSEG's list of the tied nodes, where asked for.
std::string log_tied_nodes(const model::Model& model, const weld::Ties& ties);
/// Which elements are computed in which precision, where single is asked for.
std::string log_precision(const system::System& system);
std::string log_mass(const system::System& system);
std::string log_run(const impact::Simulation& simulation, const output::Summary& summary);
/// What matters of a run in a few lines: energies, mass, which weld failed first and where, which is nearest to it.
std::string in_short(const output::Summary& summary);
/// Where a run begins again.
std::string log_resumption(const output::RestartHead& head, const std::string& date);
/// LS-DYNA's words, which tools look for: ` N o r m a l    t e r m i n a t i o n`.
std::string log_termination(const impact::Outcome& outcome);

}  // namespace nugget::app
