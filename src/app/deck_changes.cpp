// SPDX-License-Identifier: Apache-2.0
#include "app/deck_changes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <stdexcept>
#include <system_error>

#include "base/index.hpp"
#include "deck/bulk.hpp"
#include "deck/card_text.hpp"
#include "deck/cells.hpp"
#include "deck/impl.hpp"
#include "deck/text.hpp"
#include "output/result_file.hpp"
#include "reading/build.hpp"
#include "reading/builder/builder.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;
using deck::Block;

[[noreturn]] void refuse_change(const std::string& text) {
  throw std::invalid_argument(text);
}

bool same_table(const Card& a, const Card& b) {
  return std::ranges::equal(a.fields, b.fields, {}, &Field::name, &Field::name);
}

std::string with_columns(const std::string& text, std::size_t width) {
  return width == 0 ? text : fmt::format("{}, which has {} columns", text, width);
}

/// The number as text, or a refusal.
std::string number_for(double number, Kind kind, std::size_t width, const std::string& what) {
  if (std::string text = deck::fitted(number, kind, width); !text.empty()) return text;
  if (kind == Kind::integer)
    refuse_change(fmt::format("{} = {}: expected a whole number", with_columns(what, width), number));
  refuse_change(fmt::format("{} = {}: it does not fit with five digits; give the text that is to stand there",
                            with_columns(what, width), number));
}

}  // namespace

/// A field in its line.
struct DeckChanges::Cell {
  const ReadCard* read = nullptr;
  std::size_t field = 0;
  std::string name;  ///< with its keyword, for messages

  const Field& of() const { return read->card.fields[field]; }
  std::string_view line() const { return read->block->lines[read->line].text; }
};

DeckChanges::DeckChanges(const RunArguments& arguments, const PreparedDeck& prepared)
    : prepared_(prepared),
      deck_([&] {
        Findings told;
        return deck::read(arguments.deck, told, arguments.load_case);
      }()),
      text_(deck_) {
  Findings told;  // when the deck was prepared
  deck_.card_read = [this](const Block& block, std::size_t line, const Card& card) {
    read_.push_back({&block, line, card});
  };
  reading::build(deck_, told, arguments.skip_unsupported, prepared.model.weld_library);
  deck_.card_read = {};
  const auto is_of_deck = [&](const ReadCard& read) {
    const std::less<const Block*> before;
    const Block* const first = deck_.blocks.data();
    return !before(read.block, first) && before(read.block, first + deck_.blocks.size());
  };
  const Block* block = nullptr;
  for (std::size_t i = 0; i < read_.size(); ++i) {
    const ReadCard& read = read_[i];
    if (read.block != block && !is_of_deck(read)) continue;  // a line of a bulk table
    if (read.block != block || same_table(read.card, read_[cards_.back().lines.front()].card))
      cards_.push_back({read.block->starred(), {read.block->place.file, read.block->lines[read.line].number, 0}, {}});
    cards_.back().lines.push_back(i);
    block = read.block;
  }
}

std::vector<std::size_t> DeckChanges::cards_of(const std::string& keyword) const {
  const std::string asked = deck::upper(keyword.starts_with('*') ? keyword.substr(1) : keyword);
  reading::Options options;
  const reading::Keyword* row = reading::find_keyword(asked, options);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < cards_.size(); ++i) {
    const std::string written = cards_[i].keyword.substr(1);
    if (written == asked || (row != nullptr && reading::find_keyword(written, options) == row)) found.push_back(i);
  }
  return found;
}

std::vector<std::string> DeckChanges::fields(std::size_t cards) const {
  std::vector<std::string> names;
  for (const std::size_t i : cards_.at(cards).lines)
    for (const Field& field : read_[i].card.fields)
      if (!field.name.empty()) names.emplace_back(field.name);
  return names;
}

DeckChanges::Cell DeckChanges::find(std::size_t cards, const std::string& field) const {
  const Cards& all = cards_.at(cards);
  const std::string name = deck::lower(field);
  std::vector<Cell> found;
  for (const std::size_t i : all.lines)
    for (std::size_t k = 0; k < read_[i].card.fields.size(); ++k)
      if (read_[i].card.fields[k].name == name)
        found.push_back({&read_[i], k, fmt::format("{} {}", all.keyword, name)});
  if (found.size() == 1) return found[0];
  const std::string where = fmt::format("{}:{}: {}", all.place.file, all.place.line, all.keyword);
  if (found.empty())
    refuse_change(
        fmt::format("{} has no field '{}' in its lines; there are: {}", where, name, fmt::join(fields(cards), ", ")));
  refuse_change(fmt::format("{} has {} fields '{}', which are not told apart by name", where, found.size(), name));
}

DeckChanges::Value DeckChanges::value(std::size_t cards, const std::string& field) const {
  const Cell cell = find(cards, field);
  const std::string* now = text_.current(cell.line());
  std::vector<deck::CellText> cells;
  deck::split(cell.read->card, cell.read->block->format, now == nullptr ? cell.line() : std::string_view(*now), cells);
  Value out{cell.of().kind, deck::readable(cells[cell.field].text), 0.0, true};
  if (out.kind == Kind::text || out.text.empty()) return out;
  const deck::Value read = deck::evaluate(cells[cell.field].text, deck_.impl->parameters, cell.read->block->scope);
  out.number = read.number;
  out.readable = read.fault == deck::Value::Fault::none;
  return out;
}

void DeckChanges::expect_changeable(std::string_view piece, const std::string& what) const {
  const std::size_t file = text_.file_of(piece);
  if (text_.is_read_twice(file))
    refuse_change(fmt::format("{} stands in {}, which is included more than once: a change would be one in each place",
                              what, deck_.files[file]));
}

void DeckChanges::put(const Cell& cell, const std::string& text) {
  expect_changeable(cell.line(), cell.name);
  if (const deck::Transform* t = cell.read->block->transform;
      t != nullptr && (cell.of().id != IdSpace::none || t->factor(cell.of().dimension) != 1.0))
    refuse_change(fmt::format("{} stands in {}, which *INCLUDE_TRANSFORM gives other ids or units: change it there",
                              cell.name, cell.read->block->place.file));
  const std::string* now = text_.current(cell.line());
  text_.replace(cell.line(), deck::with_cell(cell.read->card, cell.read->block->format,
                                             now == nullptr ? cell.line() : std::string_view(*now), cell.field, text));
}

void DeckChanges::set_number(std::size_t cards, const std::string& field, double number) {
  const Cell cell = find(cards, field);
  const Kind kind = cell.of().kind;
  const bool free = deck::is_free(cell.read->card, cell.read->block->format, cell.line());
  const std::size_t width = free ? 0 : deck::width_of(cell.of(), cell.read->block->format);
  put(cell, number_for(number, kind == Kind::text ? Kind::real : kind, width, cell.name));
}

void DeckChanges::set_text(std::size_t cards, const std::string& field, const std::string& text) {
  put(find(cards, field), text);
}

// ---- parameters

std::map<std::string, DeckChanges::Value> DeckChanges::parameters() const {
  std::map<std::string, Value> out;
  for (const auto& [name, definitions] : deck_.impl->parameters.histories()) {
    const deck::Parameter& last = definitions.back();
    Value value{last.type == 'C'   ? Kind::text
                : last.type == 'I' ? Kind::integer
                                   : Kind::real,
                last.type == 'C' ? last.text : fmt::format("{}", last.number), last.number, true};
    if (const std::string* now = last.cell.empty() ? nullptr : text_.current(last.cell)) {
      value.text = deck::trimmed(*now);
      value.number = deck::evaluate(value.text, deck_.impl->parameters, last.from).number;
    }
    out.emplace(name, std::move(value));
  }
  return out;
}

const deck::Parameter& DeckChanges::changeable_parameter(const std::string& name) const {
  const auto& all = deck_.impl->parameters.histories();
  const auto found = all.find(deck::lower(name));
  if (found == all.end()) {
    std::vector<std::string> names;
    names.reserve(all.size());
    for (const auto& [known, definitions] : all) names.push_back(known);
    refuse_change(fmt::format("there is no parameter '{}'; there are: {}", name,
                              names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
  }
  if (found->second.size() > 1)
    refuse_change(fmt::format("the parameter '{}' is defined {} times, first at {}:{}: it has no one value", name,
                              found->second.size(), found->second[0].place.file, found->second[0].place.line));
  const deck::Parameter& parameter = found->second[0];
  if (parameter.cell.empty())
    refuse_change(fmt::format("the parameter '{}' is computed by an expression ({}:{}): change what it is made of",
                              name, parameter.place.file, parameter.place.line));
  expect_changeable(parameter.cell, fmt::format("the parameter '{}'", name));
  return parameter;
}

void DeckChanges::set_parameter_number(const std::string& name, double number) {
  const deck::Parameter& parameter = changeable_parameter(name);
  const std::string what = fmt::format("the parameter '{}'", name);
  if (parameter.type == 'C') refuse_change(what + " is a text (type C): give one");
  const Kind kind = parameter.type == 'I' ? Kind::integer : Kind::real;
  text_.replace(parameter.cell,
                deck::filled_cell(number_for(number, kind, parameter.width, what), parameter.width, kind));
}

void DeckChanges::set_parameter_text(const std::string& name, const std::string& text) {
  const deck::Parameter& parameter = changeable_parameter(name);
  text_.replace(parameter.cell,
                deck::filled_cell(text, parameter.width, parameter.type == 'C' ? Kind::text : Kind::real));
}

// ---- welds

const weld::Weld& DeckChanges::find_weld(int id) const {
  std::vector<const weld::Weld*> found;
  for (const weld::Weld& w : prepared_.ties.welds)
    if (w.id == id) found.push_back(&w);
  if (found.empty()) refuse_change(fmt::format("there is no weld {}", id));
  if (found.size() > 1) refuse_change(fmt::format("{} welds have the id {}", found.size(), id));
  const weld::Weld& w = *found[0];
  if (w.kind == weld::Weld::Kind::rigid || w.kind == weld::Weld::Kind::connector)
    refuse_change(fmt::format("{} is one of {}, not of elements of spot-weld material: change its card in the text",
                              weld::name_weld(w), weld::keyword_of(w)));
  return w;
}

const std::map<int, int>& DeckChanges::rows_of(const Block& block) {
  const auto [place, is_new] = rows_.try_emplace(&block);
  if (!is_new) return place->second;
  deck::ElementTable table;
  Findings told;
  if (block.keyword.starts_with("ELEMENT_BEAM"))
    deck::read_beams(deck_, block, table, told);
  else
    deck::read_solids(deck_, block, table, told);
  for (std::size_t i = 0; i < table.id.size(); ++i) place->second[table.id[i]] = table.line[i];
  return place->second;
}

void DeckChanges::remove_element(model::ElementKind kind, int id) {
  const std::string family = kind == model::ElementKind::beam ? "ELEMENT_BEAM" : "ELEMENT_SOLID";
  for (const Block& block : deck_.blocks) {
    if (!block.keyword.starts_with(family)) continue;
    const std::map<int, int>& rows = rows_of(block);
    const auto row = rows.find(id);
    if (row == rows.end()) continue;
    expect_changeable(block.bulk, fmt::format("*{} {}", family, id));
    int end = std::numeric_limits<int>::max();  // of the lines of this element
    for (const auto& [other, line] : rows)
      if (line > row->second) end = std::min(end, line);
    deck::BulkLines lines(block);
    std::string_view line;
    while (lines.next(line)) {
      if (lines.number() < row->second || lines.number() >= end || deck::trimmed(line).empty()) continue;
      const std::string_view text = text_.text_of(block.file);
      const std::size_t begin = static_cast<std::size_t>(line.data() - text.data());
      const std::size_t next = std::min(text.find('\n', begin), text.size() - 1) + 1;
      text_.replace(text.substr(begin, next - begin), {});
    }
    return;
  }
  refuse_change(fmt::format("element {} stands in no *{} of the text: another keyword makes it", id, family));
}

void DeckChanges::remove_weld(int id) {
  const weld::Weld& w = find_weld(id);
  const model::Model& m = prepared_.model;
  for (const model::HexAssembly& assembly : m.hex_assemblies)
    if (w.of_bricks() && std::ranges::find(assembly.solids, w.element) != assembly.solids.end())
      refuse_change(fmt::format("weld {} is named by *DEFINE_HEX_SPOTWELD_ASSEMBLY at {}:{}: take that out of the text",
                                id, assembly.place.file, assembly.place.line));
  for (const model::Index e : w.elements)
    remove_element(w.element_kind(), w.of_bricks() ? m.solids.id[e] : m.beams.id[e]);
}

void DeckChanges::find_nodes() {
  nodes_.emplace(deck_, text_);
  const model::Model& m = prepared_.model;
  as_written_.assign(m.nodes.size(), 0);
  deck::NodeTable table;
  Findings told;
  for (const Block& block : deck_.blocks)
    if (block.keyword == "NODE") deck::read_nodes(deck_, block, table, told);
  for (std::size_t i = 0; i < table.id.size(); ++i)
    if (const model::Index n = m.node_index(table.id[i]); n != model::none)
      as_written_[at(n)] = norm(m.nodes.x[at(n)] - table.x[i]) == 0.0;
}

void DeckChanges::move_node(int id, const Vec3d& x) {
  const model::Model& m = prepared_.model;
  const model::Index n = m.node_index(id);
  if (n == model::none) refuse_change(fmt::format("there is no node {}", id));
  if (!nodes_) find_nodes();
  if (as_written_[at(n)] == 0)
    refuse_change(
        fmt::format("node {} is moved by a keyword, or defined by one: its line does not say where it stands", id));
  deck::NodeTable table;
  if (!nodes_->can_move(id))
    refuse_change(fmt::format(
        "node {} stands in no line of *NODE of its own: its file is included twice, or its line has parameters", id));
  nodes_->move(id, x);
}

void DeckChanges::move_weld(int id, const Vec3d& x) {
  const weld::Weld& w = find_weld(id);
  const model::Model& m = prepared_.model;
  std::vector<model::Index> nodes;
  for (const model::Index e : w.elements)
    for (const model::Index n : w.of_bricks() ? m.solids.nodes(e) : m.beams.nodes(e)) nodes.push_back(n);
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  const auto expect_own = [&](const auto& elements, std::string_view kind, bool of_weld) {
    for (std::size_t e = 0; e < elements.size(); ++e) {
      if (of_weld && std::ranges::find(w.elements, static_cast<model::Index>(e)) != w.elements.end()) continue;
      for (const model::Index n : elements.nodes(e))
        if (std::ranges::binary_search(nodes, n))
          refuse_change(fmt::format("node {} of weld {} is one of {} {} too, which would move with it", m.nodes.id[n],
                                    id, kind, elements.id[e]));
    }
  };
  expect_own(m.shells, "shell", false);
  expect_own(m.solids, "solid", w.of_bricks());
  expect_own(m.beams, "beam", !w.of_bricks());
  Vec3d middle;
  for (const model::Index n : nodes) middle += (1.0 / static_cast<double>(nodes.size())) * m.nodes.x[at(n)];
  for (const model::Index n : nodes) move_node(m.nodes.id[n], m.nodes.x[at(n)] + x - middle);
}

// ---- files

std::vector<deck::EditedText::File> DeckChanges::files(const fs::path& master, std::string_view remark) const {
  std::vector<deck::EditedText::File> files = text_.files(master, remark);
  std::error_code none;
  for (const auto& file : files)
    for (const std::string& input : deck_.files)
      if (fs::equivalent(file.path, input, none))
        refuse_change(fmt::format("{} would be overwritten; give another name", input));
  return files;
}

std::vector<std::string> DeckChanges::write(const fs::path& master) const {
  std::vector<std::string> names;
  for (const auto& file : files(master)) {
    output::write_whole_file(file.path, file.text);
    names.push_back(file.path.string());
  }
  return names;
}

}  // namespace nugget::app
