// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/added_law.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_... of the laws and rules of failure whose cards stand in their own files (kernel/law/law_cards.hpp).
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

template <class Rule>
concept FailureRuleWithCards = kernel::LawWithCards<Rule> && requires {
  Rule::needs_plastic_flow;
};

/// The first card of a law, with all parameters of the law, also those of later cards.
template <class Law>
struct FirstCard : MaterialCard {
  Law law{};
};

/// The cards of a law, or of a rule of failure, as the deck has them.
template <class Law>
const std::vector<CardOf<FirstCard<Law>>>& layout_of() {
  static const std::vector<CardOf<FirstCard<Law>>> layout = [] {
    using First = FirstCard<Law>;
    std::vector<CardOf<First>> all;
    for (const auto& own : Law::cards().cards) {
      CardOf<First>& card = all.emplace_back();
      if (all.size() == 1 && FailureRuleWithCards<Law>) {
        card.add({&First::mid, id("mid", IdSpace::material, required, "material to which the rule is added")});
      } else if (all.size() == 1) {
        card.add({&First::mid, material_id});
        card.add({&First::ro, density});
      }
      card.add(&First::law, own);
    }
    return all;
  }();
  return layout;
}

template <class Law>
struct CardsRead {
  RowOf<FirstCard<Law>> first;
  Law law;
  std::string title;
};

/// Takes the parameters off the cards and checks them.
template <class Law>
CardsRead<Law> read_cards(Builder& b, const Block& block, const Options& options) {
  static const kernel::LawCards<Law> form = Law::cards();
  Cursor cursor(b.deck, block, b.findings);
  CardsRead<Law> read;
  read.title = read_title(cursor, options);
  FirstCard<Law> values;
  std::vector<RowOf<FirstCard<Law>>> rows;
  for (const auto& card : layout_of<Law>()) rows.push_back(cursor.read(card, values));
  expect_end(b, cursor);
  read.law = values.law;
  read.first = rows.front();
  if (form.complete) form.complete(read.law);
  for (const auto& demand : form.demands)
    if (!demand.holds(read.law))
      for (const auto& row : rows)
        if (const auto parameter = within(&FirstCard<Law>::law, demand.parameter); row.has(parameter))
          refuse(b, row[parameter], demand.otherwise, demand.remedy);
  return read;
}

template <class Law>
void read_plain_law(Builder& b, const Block& block, const Options& options) {
  auto [first, law, title] = read_cards<Law>(b, block, options);
  add_material(b, first, std::move(title), Law::cards().name, composed_law(components_of(std::move(law))));
}

template <class Rule>
void read_failure_rule(Builder& b, const Block& block, const Options& options) {
  const auto read = read_cards<Rule>(b, block, options);
  // After the laws have their curves.
  b.defer(Phase::systems, [row = read.first, rule = read.law](Builder& later) {
    const Index index = later.find(later.materials, "material", row[&FirstCard<Rule>::mid]);
    if (index == none) return;
    Material& material = later.model.materials[index];
    std::optional<kernel::LawComponents> law = components_of(material.law);
    if (!law)
      return refuse(later, row[&FirstCard<Rule>::mid], fmt::format("failure cannot be added to *{}", material.keyword),
                    "welds, discrete beams and adhesive have failure criteria of their own");
    law->rules.push_back(rule);
    material.law = composed_law(std::move(*law));
  });
}

template <class Law>
void add_keyword(std::vector<Keyword>& list) {
  if constexpr (kernel::LawWithCards<Law>) {
    const kernel::LawCards<Law> form = Law::cards();
    Keyword& row = list.emplace_back();
    row.name = form.name;
    row.aliases = form.aliases;
    row.options = {"TITLE"};
    for (const Card& card : layout_of<Law>()) row.layout.push_back({"", &card});
    if constexpr (FailureRuleWithCards<Law>)
      row.read = read_failure_rule<Law>;
    else
      row.read = read_plain_law<Law>;
  }
}

template <class... Laws>
void add_keywords(std::vector<Keyword>& list, const std::variant<Laws...>*) {
  (add_keyword<Laws>(list), ...);
}

}  // namespace

std::vector<Keyword> plain_law_keywords() {
  std::vector<Keyword> list;
  add_keywords(list, static_cast<const kernel::Flow*>(nullptr));
  add_keywords(list, static_cast<const kernel::FailureRule*>(nullptr));
  return list;
}

}  // namespace nugget::reading
