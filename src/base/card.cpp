// SPDX-License-Identifier: Apache-2.0
#include "base/card.hpp"

namespace nugget {

BoundField::BoundField(const Field& field, Store as, std::ptrdiff_t bytes) : Field(field) {
  store = as;
  offset = bytes;
}

void append(Card& card, const Field* fields, std::size_t count) {
  card.fields.insert(card.fields.end(), fields, fields + count);
}

}  // namespace nugget
