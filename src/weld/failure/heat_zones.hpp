// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/finding.hpp"
#include "model/model.hpp"
#include "weld/tie/ties.hpp"

// Sheets softened by the heat of welding.
namespace nugget::weld {

/// Factors on the yield stress and on the plastic strain at failure of a shell.
struct Softening {
  double yield = 1.0, strain = 1.0;
  friend auto operator<=>(const Softening&, const Softening&) = default;
};

/// Of each shell, or empty where the deck has no heat-affected zones. For each kind of weld the factor at the distance
/// of the shell's centre from the closest weld of that kind that the shell's part carries: from where the weld's end
/// stands on the sheet, from a node of a rigid weld, or from the line through the nodes of a seam; of several kinds the
/// smallest. Factors are rounded to 1/256, so that shells with the same ones share a kernel (ours, as is the distance:
/// LS-DYNA's is not documented).
std::vector<Softening> softening(const model::Model& model, const Ties& ties);

/// The law with its yield stress, hardening included, and its strain at failure times these factors; unchanged where it
/// is none of MAT_003 and MAT_024.
model::Law softened(const model::Law& law, const Softening& by);

/// How many shells each zone softens, and how far.
void note_heat_zones(const model::Model& model, const Ties& ties, Findings& findings);

}  // namespace nugget::weld
