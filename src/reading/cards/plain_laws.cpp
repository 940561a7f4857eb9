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
using deck::Row;

template <class Rule>
concept FailureRuleWithCards = kernel::LawWithCards<Rule> && requires {
  Rule::needs_plastic_flow;
};

constexpr Field ruled_material = id("mid", IdSpace::material, required, "material to which the rule is added");

/// The cards of a law, or of a rule of failure, as the deck has them.
template <class Law>
const std::vector<Card>& layout_of() {
  static const std::vector<Card> layout = [] {
    std::vector<Card> all;
    for (const auto& fields : Law::cards().cards) {
      Card& card = all.emplace_back();
      if (all.size() == 1 && FailureRuleWithCards<Law>)
        card.fields = {ruled_material};
      else if (all.size() == 1)
        card.fields = {material_id, density};
      for (const auto& f : fields) card.fields.push_back(f.field);
    }
    return all;
  }();
  return layout;
}

bool has_field(const Card& card, std::string_view name) {
  return std::any_of(card.fields.begin(), card.fields.end(), [&](const Field& f) { return f.name == name; });
}

template <class Law>
struct CardsRead {
  Law law;
  Row first;
  std::string title;
};

/// Takes the parameters off the cards and checks them.
template <class Law>
CardsRead<Law> read_cards(Builder& b, const Block& block, const Options& options) {
  static const kernel::LawCards<Law> form = Law::cards();
  const std::vector<Card>& layout = layout_of<Law>();
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  std::vector<Row> rows;
  for (const Card& card : layout) rows.push_back(cursor.read(card));
  expect_end(b, cursor);
  Law law;
  for (std::size_t c = 0; c < rows.size(); ++c)
    for (const auto& [field, parameter] : form.cards[c])
      if (parameter) law.*parameter = rows[c].real(field.name);
  if (form.complete) form.complete(law);
  for (const auto& demand : form.demands)
    for (std::size_t c = 0; c < rows.size(); ++c)
      if (has_field(layout[c], demand.field) && !demand.holds(law))
        refuse(b, rows[c], demand.field, std::string(demand.otherwise), std::string(demand.remedy));
  return {std::move(law), std::move(rows.front()), std::move(title)};
}

template <class Law>
void read_law(Builder& b, const Block& block, const Options& options) {
  auto [law, first, title] = read_cards<Law>(b, block, options);
  add_material(b, first, std::move(title), Law::cards().name, composed_law(components_of(std::move(law))));
}

template <class Rule>
void read_rule(Builder& b, const Block& block, const Options& options) {
  const auto read = read_cards<Rule>(b, block, options);
  // After the laws have their curves.
  b.defer(Phase::systems, [row = read.first, rule = read.law](Builder& later) {
    const Index index = later.find(later.materials, "material", row, "mid");
    if (index == none) return;
    Material& material = later.model.materials[static_cast<std::size_t>(index)];
    std::optional<kernel::LawComponents> law = components_of(material.law);
    if (!law)
      return refuse(later, row, "mid", fmt::format("failure cannot be added to *{}", material.keyword),
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
      row.read = read_rule<Law>;
    else
      row.read = read_law<Law>;
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
