// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/prepared_deck.hpp"
#include "base/finding.hpp"
#include "impact/simulation/simulation.hpp"
#include "output/summary.hpp"
#include "system/system.hpp"

namespace nugget::app {

/// The system of a deck for a run: with sub-cycling, where the deck or --subcycle asks for it. Leaves `system` empty
/// where its nodes are not tied.
void make_system(const PreparedDeck& deck, std::optional<system::System>& system, Findings& findings,
                 system::System::ElementsStart start = system::System::ElementsStart::at_once);

/// With sub-cycling: an error for each thing of the deck whose forces or failure it would change, all at once; a note
/// where all elements have the same period.
void check_subcycling(const impact::Simulation& simulation, Findings& findings);

/// Elements by period; empty without sub-cycling.
std::vector<output::Summary::Period> element_periods(const system::System& system);
/// The same in lines, for run.log.
std::string log_subcycling(const system::System& system);

}  // namespace nugget::app
