// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deck/deck.hpp"

// Layers of shells as cards give them: *PART_COMPOSITE, *INTEGRATION_SHELL, ICOMP of *SECTION_SHELL.
namespace nugget::reading {

/// One layer, which is one integration point.
struct LayerCard {
  enum class Names { nothing, part, material };
  double place = 0.0, share = 1.0;  ///< from -1 (bottom) to 1 (top); share of the thickness
  deck::Entry id;                   ///< for findings too
  Names names = Names::nothing;     ///< what the id is one of; nothing: the layer has the material of the shells' part
  double angle = 0.0;               ///< B [rad]
  double shear_scale = 1.0;         ///< SHRFAC
  bool mirrored = false;            ///< of a file that is mirrored: `angle` has the other sign than B
  int number = 0;                   ///< from 0, in the order of the cards
};

struct LayerStack {
  std::vector<LayerCard> layers;          ///< from the bottom up
  bool kept_by_unfailing_layers = false;  ///< FAILOPT
};

}  // namespace nugget::reading
