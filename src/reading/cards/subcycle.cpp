// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *CONTROL_SUBCYCLE.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;

struct SubcycleCard {
  int k = Subcycling::usual, l = 1;
};
const CardOf<SubcycleCard> subcycle_card{
    {&SubcycleCard::k,
     integer("k", Subcycling::usual, between(1, Subcycling::most),
             "1, 2, 4 ... 64: elements with a long stable step have their forces at most every so many "
             "cycles")},
    {&SubcycleCard::l, integer("l", 1, between(1, Subcycling::most),
                               "1, 2, 4 ... K: contacts have their forces every so many cycles; loads act in each")},
};

/// K and L of *CONTROL_SUBCYCLE_K_L.
std::vector<int> numbers_behind(std::string_view keyword) {
  constexpr std::string_view name = "CONTROL_SUBCYCLE";
  std::vector<int> numbers;
  for (std::string_view rest = keyword.substr(std::min(name.size(), keyword.size())); rest.size() > 1;) {
    rest.remove_prefix(1);
    const std::string one(rest.substr(0, rest.find('_')));
    numbers.push_back(std::atoi(one.c_str()));
    rest.remove_prefix(one.size());
  }
  return numbers;
}

/// The numbers stand in the name; where it has none, on a card, which may be left out.
void read_subcycle(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  SubcycleCard card;
  const std::vector<int> named = numbers_behind(block.keyword);
  if (!named.empty()) card.k = named[0];
  if (named.size() > 1) card.l = named[1];
  if (named.empty() && !at_end(cursor)) cursor.read(subcycle_card, card);
  expect_end(b, cursor);
  const auto power_of_two = [](int n) { return n > 0 && (n & (n - 1)) == 0; };
  if (named.size() > 2 || !power_of_two(card.k) || !power_of_two(card.l) || card.l > card.k)
    b.findings.error(block.place, block.starred(),
                     fmt::format("K {} and L {}, expected powers of two from 1 to {}, L not above K", card.k, card.l,
                                 Subcycling::most),
                     "write *CONTROL_SUBCYCLE_16_1");
  b.model.control.subcycling = {card.k, card.l, block.place};
}

}  // namespace

std::vector<Keyword> subcycle_keywords() {
  return {{.name = "CONTROL_SUBCYCLE",
           .options = {"1", "2", "4", "8", "16", "32", "64"},
           .layout = {{"without _K_L", &subcycle_card}},
           .read = read_subcycle}};
}

}  // namespace nugget::reading
