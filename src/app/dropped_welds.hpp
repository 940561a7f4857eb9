// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/prepared_deck.hpp"

// --drop-weld: what a structure does without some of its welds.
namespace nugget::app {

/// Ids of welds, separated by commas; nothing and a complaint where a word is none.
std::optional<std::vector<int>> read_weld_ids(const std::string& text, std::string& error_text);

/// Whether a weld has elements that can be taken out: no rigid constraint, no discrete beam, not deleted by the deck.
bool has_weld_elements(const weld::Weld& weld);

/// Takes welds out of the run that follows: their elements are deleted before it begins. Findings: ids that no weld
/// has, and welds that have no elements.
void drop_welds(PreparedDeck& prepared, const std::string& ids, Findings& findings);

}  // namespace nugget::app
