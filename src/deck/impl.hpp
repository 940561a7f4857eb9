// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <map>
#include <memory>

#include "deck/deck.hpp"
#include "deck/file_text.hpp"
#include "deck/parameters.hpp"

namespace nugget::deck {

struct Deck::Impl {
  std::deque<FileText> texts;  ///< by index into Deck::files
  Parameters parameters;
  std::deque<Transform> transforms;          ///< one an *INCLUDE_TRANSFORM; blocks point here
  std::map<int, Transform> transformations;  ///< *DEFINE_TRANSFORMATION
};

/// The transform that applies `inner` first. `inner` has ids, units and matrix of its own include only.
Transform composed(const Transform& outer, const Transform& inner);

/// +1, -1 or 0 as the matrix keeps, mirrors or flattens space.
int handedness(const Transform& transform);

}  // namespace nugget::deck
