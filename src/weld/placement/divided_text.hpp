// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deck/divided_shells.hpp"
#include "weld/placement/adapt.hpp"

namespace nugget::weld {

/// Numbers of the first new node and shell: behind those of all nodes and of elements of every kind.
struct NewIds {
  int node = 0, shell = 0;
};
NewIds first_new_ids(const model::Model& model);

/// Writes the pieces of divided shells into the text of the deck, four new nodes and shells each, by
/// Adapted::divided. The square keeps the id of its shell. To be called when nodes have been moved in the text.
void write_divided(deck::DividedShells& text, const model::Model& model, const Adapted& adapted);

}  // namespace nugget::weld
