// SPDX-License-Identifier: Apache-2.0
#include "deck/divided_shells.hpp"

#include <fmt/format.h>

#include <map>

#include "deck/bulk.hpp"
#include "deck/moved_nodes.hpp"
#include "deck/numbers.hpp"

namespace nugget::deck {
namespace {

bool has_commas(std::string_view line) {
  return line.find(',') != std::string_view::npos;
}

/// The id that a line begins with; 0 where none can be read.
int first_id(std::string_view line, Format format) {
  int id = 0;
  const std::string_view cell = has_commas(line) ? line.substr(0, line.find(',')) : columns(line, 0, id_width(format));
  const bool good = line.find_first_of("&<") == std::string_view::npos &&
                    parse_integer(trimmed(cell), id) == WholeNumber::good && id > 0;
  return good ? id : 0;
}

/// The part of a line of *ELEMENT_SHELL, as it is written.
std::string_view part_cell(std::string_view line, Format format) {
  if (!has_commas(line)) return trimmed(columns(line, id_width(format), id_width(format)));
  const std::size_t first = line.find(',') + 1;
  return trimmed(line.substr(first, line.find(',', first) - first));
}

}  // namespace

DividedShells::DividedShells(const Deck& deck, EditedText& text) : text_(text) {
  std::map<const char*, int> read;  // a text that is read twice has lines that change together
  for (const Block& block : deck.blocks) ++read[block.bulk.data()];
  for (const Block& block : deck.blocks) {
    if (block.transform != nullptr || read[block.bulk.data()] != 1) continue;
    if (block.keyword == "ELEMENT_SHELL") add_lines(block, shells_);
    if (block.keyword == "NODE") add_lines(block, nodes_);
  }
}

void DividedShells::add_lines(const Block& block, Lines& lines) const {
  BulkLines all(block);
  std::string_view line;
  while (all.next(line)) {
    const int id = first_id(line, block.format);
    if (id == 0) continue;
    Line& known = lines[id];
    known = {&block, line, known.count + 1};
  }
}

const DividedShells::Line* DividedShells::one_line(const Lines& lines, int id) {
  const auto found = lines.find(id);
  return found != lines.end() && found->second.count == 1 ? &found->second : nullptr;
}

bool DividedShells::fits(int shell, int largest_shell, int node, int largest_node) const {
  const auto digits = [](int id) { return fmt::to_string(id).size(); };
  const Line &of_shell = *one_line(shells_, shell), &of_node = *one_line(nodes_, node);
  const std::size_t wide = id_width(of_shell.block->format);
  const bool in_shell = has_commas(of_shell.text) || (digits(largest_shell) < wide && digits(largest_node) < wide);
  return in_shell && (has_commas(of_node.text) || digits(largest_node) < id_width(of_node.block->format));
}

void DividedShells::divide(int shell, std::span<const Shell> shells) {
  const Line& line = *one_line(shells_, shell);
  const std::string_view part = part_cell(line.text, line.block->format);
  std::string text;
  for (const Shell& s : shells) {
    if (!text.empty()) text += '\n';
    if (has_commas(line.text)) {
      text += fmt::format("{},{},{},{},{},{}", s.id, part, s.nodes[0], s.nodes[1], s.nodes[2], s.nodes[3]);
      continue;
    }
    const std::size_t wide = id_width(line.block->format);
    text += fmt::format("{:>{}}{:>{}}", s.id, wide, part, wide);
    for (const int n : s.nodes) text += fmt::format("{:>{}}", n, wide);
  }
  text_.replace(line.text, std::move(text));
}

void DividedShells::follow(int node, std::span<const Node> nodes) {
  const Line& line = *one_line(nodes_, node);
  const std::string* now = text_.current(line.text);
  std::string text = now == nullptr ? std::string(line.text) : *now;
  for (const Node& n : nodes) {
    if (has_commas(line.text)) {
      text += fmt::format("\n{},{},{},{}", n.id, written_coordinate(n.x.x, 0), written_coordinate(n.x.y, 0),
                          written_coordinate(n.x.z, 0));
      continue;
    }
    const std::size_t wide = real_width(line.block->format);
    text += fmt::format("\n{:>{}}", n.id, id_width(line.block->format));
    for (const double c : {n.x.x, n.x.y, n.x.z}) text += fmt::format("{:>{}}", written_coordinate(c, wide - 1), wide);
  }
  text_.replace(line.text, std::move(text));
}

}  // namespace nugget::deck
