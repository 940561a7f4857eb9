// SPDX-License-Identifier: Apache-2.0
#include "deck/checksum.hpp"

#include "base/checksum.hpp"
#include "deck/impl.hpp"

namespace nugget::deck {

std::uint64_t checksum(const Deck& deck) {
  std::uint64_t sum = checksum_of_nothing;
  for (const FileText& file : deck.impl->texts) sum = nugget::checksum(file.view(), sum);
  return sum;
}

}  // namespace nugget::deck
