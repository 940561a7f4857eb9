// SPDX-License-Identifier: Apache-2.0
#include "base/card.hpp"

namespace nugget {

void append(Card& card, const Field* fields, std::size_t count) {
  card.fields.insert(card.fields.end(), fields, fields + count);
}

}  // namespace nugget
