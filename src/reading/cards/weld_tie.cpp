// SPDX-License-Identifier: Apache-2.0
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *NUGGET_WELD_TIE, a card of this program: how welds are tied to their sheets.
namespace nugget::reading {

namespace {

struct WeldTieCard {
  int form = 0;
};
const CardOf<WeldTieCard> weld_tie_card{
    {&WeldTieCard::form,
     integer(
         "form", 0, between(0, 2),
         "how welds are tied to their sheets: 0 by the element under them, 1 by the area of the nugget, 2 so with a "
         "joint that carries what a coarse mesh lacks")},
};

void read_weld_tie(Builder& b, const deck::Block& block, const Options&) {
  deck::Cursor cursor(b.deck, block, b.findings);
  const auto row = cursor.read(weld_tie_card);
  expect_end(b, cursor);
  b.model.control.weld_tie = static_cast<WeldTie>(row->form);
}

}  // namespace

std::vector<Keyword> weld_tie_keywords() {
  return {{.name = "NUGGET_WELD_TIE", .layout = {{"", &weld_tie_card}}, .read = read_weld_tie}};
}

}  // namespace nugget::reading
