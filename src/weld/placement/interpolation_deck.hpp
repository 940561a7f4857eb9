// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "weld/placement/placement_deck.hpp"

namespace nugget::weld {

/// Interpolation spot welds of one class and diameter between the same two parts: one card.
struct InterpolationWelds {
  std::string spot_class, diameter;  ///< the diameter as it will stand in the card
  int first_part = 0, second_part = 0;
  double reach = 0.0;      ///< largest distance of the two sheets at a weld [length]
  std::vector<int> nodes;  ///< where the welds are, amid the sheets
};

/// *CONSTRAINED_INTERPOLATION_SPOTWELD (SPR3) with its curves, from the fields of `weld_fields(interpolation)`. Elastic
/// as a round bar of the diameter through both sheets. It flows at NRR in tension, NRS in shear, MSS in bending, MRR in
/// torsion (0: the moment does not count), or, where these are not given, as the bar's section does at SIGY, with EH
/// over the bar's length. Damage begins at the plastic displacement UPF and ends at UPR; never where both are 0.
/// `curve` is the id before the first of its curves, and that of the last one afterwards.
std::string interpolation_card(const InterpolationWelds& welds, int node_set, const WeldFields& fields, int& curve);

/// Says what is wrong with the fields; empty: nothing.
std::string interpolation_fault(const WeldFields& fields);

}  // namespace nugget::weld
