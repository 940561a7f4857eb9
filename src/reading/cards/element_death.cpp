// SPDX-License-Identifier: Apache-2.0
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *DEFINE_ELEMENT_DEATH_...: elements that are deleted at a time.
namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;

struct DeathCard {
  int target = 0, boxid = 0, inout = 0, idgrp = 0, cid = 0;
  double time = 0, percent = 0;
};
CardOf<DeathCard> death_card_of(const FieldOf<DeathCard>& target) {
  return {
      target,
      {&DeathCard::time, real("time", dimension::time, 0, at_least(0), "when it is deleted; 0: before the run begins")},
      {&DeathCard::boxid, id("boxid", IdSpace::define, 0, "only 0: deletion by place is not built")},
      {&DeathCard::inout, integer("inout", 0, between(0, 1), "with BOXID only")},
      {&DeathCard::idgrp, integer("idgrp", 0, any_value, "only 0: groups that die together are not built")},
      {&DeathCard::cid, id("cid", IdSpace::define, 0, "with BOXID only")},
      {&DeathCard::percent, real("percent", dimension::number, 0, any_value, "with IDGRP only")},
  };
}
const CardOf<DeathCard> death_of_element =
                            death_card_of({&DeathCard::target, id("eid", IdSpace::element, required, "element")}),
                        death_of_set =
                            death_card_of({&DeathCard::target, id("sid", IdSpace::set, required, "element set")});

/// Where the elements of one kind and their sets are found.
struct Elements {
  ElementKind kind;
  std::string_view what, what_set;
  Ids Builder::*ids;
  Ids Builder::*set_ids;
  std::vector<Set<Index>> Sets::*sets;
};
constexpr Elements dying_shells{ElementKind::shell,   "shell",      "shell set", &Builder::shells,
                                &Builder::shell_sets, &Sets::shells};
constexpr Elements dying_solids{ElementKind::solid,   "solid",      "solid set", &Builder::solids,
                                &Builder::solid_sets, &Sets::solids};
constexpr Elements dying_beams{ElementKind::beam,   "beam",      "beam set", &Builder::beams,
                               &Builder::beam_sets, &Sets::beams};

void add_deaths(Builder& b, const Elements& of, const deck::RowOf<DeathCard>& row, bool set) {
  const Index found = b.find(b.*(set ? of.set_ids : of.ids), set ? of.what_set : of.what, row[&DeathCard::target]);
  if (found == none) return;
  const std::vector<Index> members = set ? (b.model.sets.*of.sets)[found].members : std::vector<Index>{found};
  for (const Index element : members) b.model.element_deaths.push_back({of.kind, element, row->time});
}

template <const Elements& of, bool set>
void read_death(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  read_title(cursor, options);
  while (cursor.more()) {
    const auto row = cursor.read(set ? death_of_set : death_of_element);
    refuse_nonzero(builder, row[&DeathCard::boxid], "deletion by place is not built", "give TIME, and no BOXID");
    refuse_nonzero(builder, row[&DeathCard::idgrp], "groups of elements that are deleted together are not built",
                   "leave IDGRP 0");
    builder.defer(Phase::conditions, [row](Builder& b) { add_deaths(b, of, row, set); });
  }
}

template <const Elements& of, bool set>
Keyword death_keyword(std::string_view name) {
  return {.name = name,
          .options = {"TITLE"},
          .layout = {{"repeated", set ? &death_of_set : &death_of_element}},
          .read = read_death<of, set>};
}

}  // namespace

std::vector<Keyword> element_death_keywords() {
  return {
      death_keyword<dying_shells, false>("DEFINE_ELEMENT_DEATH_SHELL"),
      death_keyword<dying_shells, true>("DEFINE_ELEMENT_DEATH_SHELL_SET"),
      death_keyword<dying_solids, false>("DEFINE_ELEMENT_DEATH_SOLID"),
      death_keyword<dying_solids, true>("DEFINE_ELEMENT_DEATH_SOLID_SET"),
      death_keyword<dying_beams, false>("DEFINE_ELEMENT_DEATH_BEAM"),
      death_keyword<dying_beams, true>("DEFINE_ELEMENT_DEATH_BEAM_SET"),
  };
}

}  // namespace nugget::reading
