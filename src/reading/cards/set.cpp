// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *SET_... in all their forms. Here they become recipes; resolve_sets() works out the members.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;
using Source = SetStep::Source;
using Action = SetStep::Action;

struct HeadCard {
  int sid = 0;
  std::array<double, 4> attributes{};
};
const CardOf<HeadCard> head_card{
    {&HeadCard::sid, id("sid", IdSpace::set, required, "id of the set")},
    {at(&HeadCard::attributes, 0),
     real("da1", dimension::number, 0, any_value, "default attribute; of parts: PSF of *CONTACT_INTERIOR")},
    {at(&HeadCard::attributes, 1),
     real("da2", dimension::number, 0, any_value, "default attribute; of parts: Fa of *CONTACT_INTERIOR")},
    {at(&HeadCard::attributes, 2),
     real("da3", dimension::number, 0, any_value, "default attribute; of parts: ED of *CONTACT_INTERIOR")},
    {at(&HeadCard::attributes, 3),
     real("da4", dimension::number, 0, any_value, "default attribute; of parts: TYPE of *CONTACT_INTERIOR")},
    text("solver", 10, "no effect"),
    text("its", 10, "no effect"),
    unused(),
};

const CardOf<HeadCard> short_head_card{
    {&HeadCard::sid, id("sid", IdSpace::set, required, "id of the set")},
    text("solver", 10, "no effect"),
};

/// A line of members, or of numbers that stand for some.
struct MembersCard {
  std::array<int, 8> id{};
  std::array<double, 4> attributes{};
};
constexpr std::string_view id_names[] = {"id1", "id2", "id3", "id4", "id5", "id6", "id7", "id8"};

CardOf<MembersCard> eight_ids(IdSpace space, std::string_view meaning) {
  CardOf<MembersCard> card;
  for (std::size_t i = 0; i < 8; ++i) card.add({at(&MembersCard::id, i), id(id_names[i], space, 0, meaning)});
  return card;
}

const CardOf<MembersCard> node_ids = eight_ids(IdSpace::node, "node");
const CardOf<MembersCard> part_ids = eight_ids(IdSpace::part, "part");
const CardOf<MembersCard> element_ids = eight_ids(IdSpace::element, "element");
const CardOf<MembersCard> set_ids = eight_ids(IdSpace::set, "set");

CardOf<MembersCard> with_attributes(CardOf<MembersCard> card, std::string_view meaning) {
  static constexpr std::string_view names[] = {"a1", "a2", "a3", "a4"};
  for (std::size_t i = 0; i < 4; ++i)
    card.add({at(&MembersCard::attributes, i), real(names[i], dimension::number, 0, any_value, meaning)});
  return card;
}
CardOf<MembersCard> one_with_attributes(IdSpace space, std::string_view meaning = "attribute, no effect") {
  return with_attributes({{at(&MembersCard::id, 0), id("id1", space, 0, "member")}}, meaning);
}

const CardOf<MembersCard> node_column = one_with_attributes(IdSpace::node);
const CardOf<MembersCard> part_column =
    one_with_attributes(IdSpace::part, "attribute of this part; 0: da1 to da4 of the set");
const CardOf<MembersCard> element_column = one_with_attributes(IdSpace::element);

const CardOf<MembersCard> segment_card = with_attributes(
    {
        {at(&MembersCard::id, 0), id("id1", IdSpace::node, required, "node 1")},
        {at(&MembersCard::id, 1), id("id2", IdSpace::node, required, "node 2")},
        {at(&MembersCard::id, 2), id("id3", IdSpace::node, required, "node 3")},
        {at(&MembersCard::id, 3), id("id4", IdSpace::node, 0, "node 4; 0 or n3: a triangle")},
    },
    "attribute, no effect");

// What the numbers are depends on the option, so their offsets are applied by `general_step`.
struct GeneralSetCard {
  std::string option;
  std::array<int, 3> id{};
  std::array<double, 4> more{};
};
const CardOf<GeneralSetCard> general_set_card{
    {&GeneralSetCard::option,
     text("option", 10, "ALL, NODE, ELEM, PART, SEG, BOX, BRANCH, SET_... to add; with a D in front to take away")},
    {at(&GeneralSetCard::id, 0), integer("id1", 0, any_value, "id")},
    {at(&GeneralSetCard::id, 1), integer("id2", 0, any_value, "id")},
    {at(&GeneralSetCard::id, 2), integer("id3", 0, any_value, "id")},
    {at(&GeneralSetCard::more, 0),
     real("id4", dimension::number, 0, any_value,
          "id; segments of parts, boxes, shells, sets of elements: attribute, no effect")},
    {at(&GeneralSetCard::more, 1), real("id5", dimension::number, 0, any_value, "id")},
    {at(&GeneralSetCard::more, 2), real("id6", dimension::number, 0, any_value, "id")},
    {at(&GeneralSetCard::more, 3), real("id7", dimension::number, 0, any_value, "id")},
};

struct AdvancedCard {
  std::array<int, 4> sid{}, type{};
};
const CardOf<AdvancedCard> advanced_card{
    {at(&AdvancedCard::sid, 0),
     id("sid1", IdSpace::set, 0, "set whose nodes are taken; up to four a line, any number of lines")},
    {at(&AdvancedCard::type, 0),
     integer("type1", 1, between(1, 7), "1 node, 2 shell, 3 beam, 4 solid, 5 segment set; 6, 7: not built")},
    {at(&AdvancedCard::sid, 1), id("sid2", IdSpace::set, 0, "the same")},
    {at(&AdvancedCard::type, 1), integer("type2", 1, between(1, 7), "the same")},
    {at(&AdvancedCard::sid, 2), id("sid3", IdSpace::set, 0, "the same")},
    {at(&AdvancedCard::type, 2), integer("type3", 1, between(1, 7), "the same")},
    {at(&AdvancedCard::sid, 3), id("sid4", IdSpace::set, 0, "the same")},
    {at(&AdvancedCard::type, 3), integer("type4", 1, between(1, 7), "the same")},
};

struct BranchCard {
  int brid = 0;
};
const CardOf<BranchCard> branch_card{
    {&BranchCard::brid, id("brid", IdSpace::set, required, "number of the branch")},
};
const Card branch_heading{{text("heading", 80, "its name")}};
// Parts and branches have offsets of their own, so these are applied by `read_branch`.
CardOf<MembersCard> branch_members() {
  CardOf<MembersCard> card;
  for (std::size_t i = 0; i < 8; ++i)
    card.add({at(&MembersCard::id, i),
              integer(id_names[i], 0, any_value, "more than 0: a branch; less: a part, by its number")});
  return card;
}
const CardOf<MembersCard> branch_ids = branch_members();

/// What differs between the kinds of sets.
struct KindCards {
  SetKind kind;
  IdSpace space;
  const CardOf<HeadCard>* head;
  const CardOf<MembersCard>* ids;
  const CardOf<MembersCard>* column;
};

const KindCards node_kind{SetKind::node, IdSpace::node, &head_card, &node_ids, &node_column};
const KindCards part_kind{SetKind::part, IdSpace::part, &head_card, &part_ids, &part_column};
const KindCards segment_kind{SetKind::segment, IdSpace::node, &head_card, &segment_card, &segment_card};
const KindCards shell_kind{SetKind::shell, IdSpace::element, &head_card, &element_ids, &element_column};
const KindCards solid_kind{SetKind::solid, IdSpace::element, &short_head_card, &element_ids, &element_column};
const KindCards beam_kind{SetKind::beam, IdSpace::element, &short_head_card, &element_ids, &element_column};

/// A line of *SET_..._GENERAL without its ids, and the name space that these are of; nothing for an unknown option.
struct GeneralOption {
  SetStep step;
  IdSpace space = IdSpace::none;
};

std::optional<GeneralOption> segment_option(std::string_view name) {
  GeneralOption o;
  o.step.kind = SetKind::segment;
  if (name == "SEG") return o.space = IdSpace::node, o;
  if (name == "SHELL") return o.step.kind = SetKind::shell, o.space = IdSpace::element, o;
  if (name == "BRANCH") return o.step.source = Source::sets, o.step.kind = SetKind::branch, o.space = IdSpace::set, o;
  if (name == "BOX" || name == "BOX_SHELL" || name == "BOX_SOLID") {
    o.step.source = Source::boxes;
    o.step.of_shells = name != "BOX_SOLID";
    o.step.of_solids = name != "BOX_SHELL";
    o.space = IdSpace::define;
    return o;
  }
  return std::nullopt;
}

std::optional<GeneralOption> set_option(SetKind own, std::string_view name) {
  static constexpr std::pair<std::string_view, SetKind> kinds[] = {
      {"SET_NODE", SetKind::node},   {"SET_PART", SetKind::part},   {"SET_SEGMENT", SetKind::segment},
      {"SET_SHELL", SetKind::shell}, {"SET_SOLID", SetKind::solid}, {"SET_BEAM", SetKind::beam}};
  GeneralOption o;
  o.space = IdSpace::set;
  o.step.source = Source::sets;
  o.step.kind = own;
  if (name == "SET" && own != SetKind::node) return o;
  for (const auto& [option, kind] : kinds) {
    if (name != option) continue;
    o.step.kind = kind;
    if (own == SetKind::node) return o;
    if (own == SetKind::segment && (kind == SetKind::shell || kind == SetKind::solid)) return o;
  }
  return std::nullopt;
}

std::optional<GeneralOption> general_option(const KindCards& cards, std::string_view name) {
  GeneralOption o;
  o.step.kind = cards.kind;
  const bool is_element = cards.space == IdSpace::element;
  if (name == "ALL") return o.step.source = Source::all, o;
  if (name == "PART") return o.step.kind = SetKind::part, o.space = IdSpace::part, o;
  if (name == "NODE" && cards.kind == SetKind::node) return o.space = IdSpace::node, o;
  if (name == "ELEM" && is_element) return o.space = IdSpace::element, o;
  if (name == "BOX" && (is_element || cards.kind == SetKind::node))
    return o.step.source = Source::boxes, o.space = IdSpace::define, o;
  if (const auto set = set_option(cards.kind, name)) return set;
  return cards.kind == SetKind::segment ? segment_option(name) : std::nullopt;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::optional<SetStep> general_step(Builder& b, const Block& block, const KindCards& cards,
                                    const RowOf<GeneralSetCard>& row) {
  const std::string name = upper(row->option);
  auto option = general_option(cards, name);
  const bool takes_away = !option && name.starts_with('D');
  if (takes_away) option = general_option(cards, std::string_view(name).substr(1));
  if (!option) {
    refuse(b, row[&GeneralSetCard::option], "this option is not supported",
           "use ALL, NODE, ELEM, PART, SEG, BOX, SET or SET_..., or list the members");
    return std::nullopt;
  }
  SetStep step = std::move(option->step);
  if (takes_away) step.action = Action::remove;
  step.place = row.place();
  // E4 to E7 are attributes where segments are made of other things; where they are taken away, all are ids.
  const bool has_attributes =
      cards.kind == SetKind::segment && !takes_away && (step.source == Source::boxes || step.kind != SetKind::segment);
  const bool is_face =
      cards.kind == SetKind::segment && step.source == Source::members && step.kind == SetKind::segment;
  const std::size_t most = has_attributes ? 3 : is_face ? 4 : 7;
  const long offset = block.transform ? block.transform->id_offset[static_cast<std::size_t>(option->space)] : 0;
  constexpr double largest = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < most; ++i) {
    const double id = i < 3 ? row->id[i] : row->more[i - 3];  // which may be attributes, and are read as reals
    if (id == 0.0) continue;
    if (id != std::trunc(id) || std::abs(id + static_cast<double>(offset)) > largest)
      refuse(b, i < 3 ? row[at(&GeneralSetCard::id, i)] : row[at(&GeneralSetCard::more, i - 3)],
             fmt::format("expected an id: a whole number, with the offset of its file at most {:.0f}", largest));
    else
      step.ids.push_back(static_cast<int>(id + static_cast<double>(offset)));
  }
  return step;
}

/// The lines GENERATE (pairs) and GENERATE_INCREMENT (begin, end, increment).
void read_ranges(Builder& b, Cursor& cursor, const KindCards& cards, bool has_increment, std::vector<SetStep>& steps) {
  const CardOf<MembersCard> increments{
      {at(&MembersCard::id, 0), id("id1", cards.space, 0, "begin")},
      {at(&MembersCard::id, 1), id("id2", cards.space, 0, "end")},
      {at(&MembersCard::id, 2), integer("id3", 1, at_least(1), "increment")},
  };
  while (!at_end(cursor)) {
    const auto row = cursor.read(has_increment ? increments : *cards.ids);
    for (std::size_t i = 0; i < (has_increment ? 2 : 8); i += 2) {
      const int begin = row->id[i], end = row->id[i + 1];
      if (begin == 0 && end == 0) continue;
      if (end < begin)
        row[at(&MembersCard::id, i + 1)].report(
            b.findings, Severity::warning,
            fmt::format("the range from {} to {} ends before it begins: it has no members", begin, end),
            "write begin and end in pairs");
      SetStep step;
      step.source = Source::range;
      step.kind = cards.kind;
      step.ids = {begin, end, has_increment ? row->id[2] : 1};
      step.place = row.place();
      steps.push_back(std::move(step));
    }
  }
}

/// The numbers of a line, zeros left out.
std::vector<int> ids_of(const MembersCard& line) {
  std::vector<int> ids;
  std::copy_if(line.id.begin(), line.id.end(), std::back_inserter(ids), [](int id) { return id != 0; });
  return ids;
}

/// A1..A4 of a line of _COLUMN; where they are 0, DA1..DA4 of the set.
std::array<double, 4> own_attributes(std::array<double, 4> own, const std::array<double, 4>& of_set) {
  if (own == std::array<double, 4>{}) return own;
  for (std::size_t i = 0; i < 4; ++i)
    if (own[i] == 0.0) own[i] = of_set[i];
  return own;
}

/// Lines of members (LIST, COLUMN) or of sets (ADD, INTERSECT).
void read_members(Cursor& cursor, const KindCards& cards, const CardOf<MembersCard>& card, Source source, Action action,
                  SetRecipe& recipe) {
  std::vector<SetStep>& steps = recipe.steps;
  while (!at_end(cursor)) {
    const auto row = cursor.read(card);
    SetStep step;
    step.source = source;
    step.action = steps.empty() ? Action::add : action;
    step.kind = cards.kind;
    step.ids = ids_of(*row);
    step.place = row.place();
    if (step.ids.empty()) continue;
    if (&card == cards.column) step.attributes = own_attributes(row->attributes, recipe.attributes);
    steps.push_back(std::move(step));
  }
}

/// INTERSECT: what is in all of the sets, so each set is a step of its own.
void split_intersection(std::vector<SetStep>& steps) {
  std::vector<SetStep> single;
  for (const SetStep& step : steps)
    for (const int id : step.ids) {
      single.push_back(step);
      single.back().ids = {id};
      single.back().action = single.size() == 1 ? Action::add : Action::intersect;
    }
  steps = std::move(single);
}

void read_set(Builder& b, const Block& block, const Options& options, const KindCards& cards) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto head = cursor.read(*cards.head);
  SetRecipe recipe{cards.kind, head->sid, options.contains("COLLECT"), block.starred(), head.place(), {}, {}};
  recipe.attributes = head->attributes;
  auto& steps = recipe.steps;
  if (options.contains("GENERAL")) {
    while (!at_end(cursor))
      if (auto step = general_step(b, block, cards, cursor.read(general_set_card))) steps.push_back(std::move(*step));
  } else if (options.contains("GENERATE")) {
    read_ranges(b, cursor, cards, options.contains("INCREMENT"), steps);
  } else if (options.contains("ADD") || options.contains("INTERSECT")) {
    read_members(cursor, cards, set_ids, Source::sets, Action::add, recipe);
    if (options.contains("INTERSECT")) split_intersection(steps);
  } else {
    read_members(cursor, cards, options.contains("COLUMN") ? *cards.column : *cards.ids, Source::members, Action::add,
                 recipe);
    // Attributes of single nodes, shells and segments are reported where they would count, never used: one stands for
    // all.
    if (cards.kind != SetKind::part)
      for (SetStep& step : steps)
        for (std::size_t i = 0; i < 4; ++i)
          if (double& of_set = recipe.attributes[i]; of_set == 0.0) of_set = step.attributes[i];
  }
  if (cards.kind == SetKind::segment)
    for (SetStep& step : steps) step.turned_over = is_mirrored(block);
  b.set_recipes.push_back(std::move(recipe));
}

/// *SET_NODE_ADD_ADVANCED: the nodes of sets of several kinds.
void read_advanced(Builder& b, const Block& block, const Options& options) {
  static constexpr SetKind kinds[] = {SetKind::node, SetKind::shell, SetKind::beam, SetKind::solid, SetKind::segment};
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto head = cursor.read(head_card);
  SetRecipe recipe{SetKind::node, head->sid, options.contains("COLLECT"), block.starred(), head.place(), {}, {}};
  while (!at_end(cursor)) {
    const auto row = cursor.read(advanced_card);
    for (std::size_t i = 0; i < 4; ++i) {
      if (row->sid[i] == 0) continue;
      const int type = row->type[i];
      if (type > 5) {
        refuse(b, row[at(&AdvancedCard::type, i)], "sets of discrete elements and of thick shells are not built",
               "list their nodes in a *SET_NODE");
        continue;
      }
      SetStep step;
      step.source = Source::sets;
      step.kind = kinds[type - 1];
      step.ids = {row->sid[i]};
      step.place = row.place();
      recipe.steps.push_back(std::move(step));
    }
  }
  b.set_recipes.push_back(std::move(recipe));
}

/// *SET_PART_TREE: a branch of the tree of parts, of other branches and of parts.
void read_branch(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto head = cursor.read(branch_card);
  cursor.read_text();  // the heading
  SetRecipe recipe{SetKind::branch, head->brid, false, block.starred(), head.place(), {}, {}};
  const auto offset = [&](IdSpace space) {
    return block.transform ? static_cast<int>(block.transform->id_offset[static_cast<std::size_t>(space)]) : 0;
  };
  while (!at_end(cursor)) {
    const auto row = cursor.read(branch_ids);
    for (const int id : ids_of(*row)) {
      SetStep step;
      step.source = id > 0 ? Source::sets : Source::members;
      step.kind = id > 0 ? SetKind::branch : SetKind::part;
      step.ids = {id > 0 ? id + offset(IdSpace::set) : -id + offset(IdSpace::part)};
      step.place = row.place();
      recipe.steps.push_back(std::move(step));
    }
  }
  b.set_recipes.push_back(std::move(recipe));
}

template <const KindCards& cards>
void read(Builder& b, const Block& block, const Options& options) {
  read_set(b, block, options, cards);
}

template <const KindCards& cards>
Keyword set_keyword(std::string_view name) {
  const bool is_segment = cards.kind == SetKind::segment;
  Keyword k{.name = name,
            .options = {"TITLE", "COLLECT", "GENERAL", "ADD", "INTERSECT"},
            .layout = {{"", cards.head},
                       {is_segment ? "repeated" : "as LIST (or nothing), repeated; as GENERATE: pairs of begin and end",
                        cards.ids},
                       {"with _GENERAL, repeated", &general_set_card},
                       {"with _ADD or _INTERSECT, repeated", &set_ids}},
            .read = read<cards>};
  if (is_segment) return k;
  k.options.insert(k.options.end(), {"LIST", "COLUMN", "GENERATE", "INCREMENT"});
  k.layout.push_back({"with _COLUMN, repeated", cards.column});
  return k;
}

}  // namespace

std::vector<Keyword> set_keywords() {
  return {
      set_keyword<node_kind>("SET_NODE"),
      set_keyword<part_kind>("SET_PART"),
      set_keyword<segment_kind>("SET_SEGMENT"),
      set_keyword<shell_kind>("SET_SHELL"),
      set_keyword<solid_kind>("SET_SOLID"),
      set_keyword<beam_kind>("SET_BEAM"),
      {.name = "SET_NODE_ADD_ADVANCED",
       .options = {"TITLE", "COLLECT"},
       .layout = {{"", &head_card}, {"repeated", &advanced_card}},
       .read = read_advanced},
      {.name = "SET_PART_TREE",
       .options = {"TITLE"},
       .layout = {{"", &branch_card}, {"", &branch_heading}, {"repeated", &branch_ids}},
       .read = read_branch},
  };
}

}  // namespace nugget::reading
