// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "deck/deck.hpp"

namespace nugget::deck {

/// Checksum of the texts of all files of a deck.
std::uint64_t checksum(const Deck& deck);

}  // namespace nugget::deck
