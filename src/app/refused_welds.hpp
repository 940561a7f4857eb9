// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/finding.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::app {

/// Tie contacts of a refused deck that lack a side, as what names it was refused or is not there, are taken out: they
/// would tie nothing and say so of every weld. The names of those taken out.
std::vector<std::string> leave_out_broken_ties(model::Model& model);

/// The contact that the findings refuse by its name, with its star; empty: none. What no contact tracks may follow from
/// that.
std::string refused_contact(const Findings& findings);

/// What a check can report on the welds of a deck that is refused: how many of which kind, on how many sheets, with
/// which diameters, and for what is missing why. Empty without welds. `left_out`: of leave_out_broken_ties. The
/// sentence that matters most becomes a finding too.
std::string summarize_refused_welds(const model::Model& model, const weld::Ties& ties,
                                    const std::vector<std::string>& left_out, Findings& findings);

}  // namespace nugget::app
