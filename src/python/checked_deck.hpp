// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/prepared_deck.hpp"

namespace nugget::python {

/// A deck as Deck of the package holds it.
struct CheckedDeck {
  app::RunArguments arguments;
  Findings findings;
  app::PreparedDeck prepared;

  const model::Model& model() const { return prepared.model; }
};

}  // namespace nugget::python
