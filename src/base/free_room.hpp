// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget {

/// Empties a list so that it takes no room either: `list = {}` keeps the room of a vector.
template <class List>
void free_room(List& list) {
  List().swap(list);
}

}  // namespace nugget
