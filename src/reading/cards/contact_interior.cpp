// SPDX-License-Identifier: Apache-2.0
#include "reading/cards/contact_interior.hpp"

#include <fmt/format.h>

#include "reading/builder/common_cards.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;

struct InteriorCard {
  int psid = 0;
};
const CardOf<InteriorCard> interior_card{
    {&InteriorCard::psid, id("psid", IdSpace::set, required,
                             "set of parts; attributes DA1 = PSF (1), DA2 = Fa (0.1), DA3 = ED, DA4 = TYPE (1, 2: the "
                             "same here), by part in "
                             "*SET_PART_COLUMN")},
};

void read_interior(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  const Heading heading = read_heading(cursor, options.contains("ID") || options.contains("TITLE"));
  const auto row = cursor.read(interior_card);
  expect_end(builder, cursor);
  builder.defer(Phase::conditions, [row, heading, place = block.place](Builder& b) {
    const auto* set = b.part_set(row[&InteriorCard::psid]);
    if (!set) return;
    InteriorContact contact;
    for (const Index index : set->members) {
      const auto [scale, activation, modulus, type] = set->attributes_of(index);
      if (scale < 0.0 || activation < 0.0 || activation >= 1.0 || modulus < 0.0 || type < 0.0 || type > 2.0)
        return refuse(b, row[&InteriorCard::psid],
                      fmt::format("attributes {:g}, {:g}, {:g}, {:g} of part {} in part set {}: expected PSF and ED of "
                                  "0 or more, Fa below 1, TYPE 0 to 2",
                                  scale, activation, modulus, type, b.model.parts[index].id, set->id),
                      "set DA1 to DA4 of the set, or A1 to A4 of the part");
      InteriorPart part{.part = index, .modulus = modulus};
      if (scale > 0.0) part.scale = scale;
      if (activation > 0.0) part.activation = activation;
      contact.parts.push_back(part);
    }
    contact.id =
        heading.id != 0 ? heading.id : static_cast<int>(b.model.contacts.size() + b.model.interiors.size()) + 1;
    contact.title = heading.text;
    contact.place = place;
    b.model.interiors.push_back(std::move(contact));
  });
}

}  // namespace

Keyword interior_keyword() {
  return {.name = "CONTACT_INTERIOR",
          .options = {"ID", "TITLE"},
          .layout = {{"with _ID or _TITLE", &heading_card}, {{}, &interior_card}},
          .read = read_interior};
}

}  // namespace nugget::reading
