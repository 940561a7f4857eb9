// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "deck/bulk.hpp"

namespace nugget::deck {
namespace {

struct NodeRow {
  int id = 0;
  Vec3d x;  ///< transformed
  int tc = 0, rc = 0;
};

/// False where the line has to be read carefully.
bool read_plain(std::string_view line, const Block& block, const IdOffset& offset, NodeRow& node) {
  PlainColumns cells(line);
  const std::size_t narrow = id_width(block.format), wide = real_width(block.format);
  node.id = cells.integer(narrow);
  node.x.x = cells.real(wide);
  node.x.y = cells.real(wide);
  node.x.z = cells.real(wide);
  node.tc = cells.integer(narrow);
  node.rc = cells.integer(narrow);
  const bool constraints = node.tc >= 0 && node.tc <= 7 && node.rc >= 0 && node.rc <= 7;
  if (!cells.good() || node.id <= 0 || !constraints || !offset.apply(node.id)) return false;
  if (block.transform != nullptr) node.x = block.transform->point(node.x);
  return true;
}

const CardOf<NodeRow>& node_row_card() {
  using dimension::length;
  const auto coordinate = [](double Vec3d::*axis, const RealField& field) {
    return FieldOf<NodeRow>(within(&NodeRow::x, axis), wide(field, 16));
  };
  const auto code = [](int NodeRow::*member, std::string_view name, std::string_view meaning) {
    return FieldOf<NodeRow>(member, wide(integer(name, 0, between(0, 7), meaning), 8));
  };
  static const CardOf<NodeRow> card{
      {&NodeRow::id, wide(within_range(nugget::id("nid", IdSpace::node, required, "node id"), at_least(1)), 8)},
      coordinate(&Vec3d::x, real("x", length, 0.0, any_value, "coordinate x")),
      coordinate(&Vec3d::y, real("y", length, 0.0, any_value, "coordinate y")),
      coordinate(&Vec3d::z, real("z", length, 0.0, any_value, "coordinate z")),
      code(&NodeRow::tc, "tc", "constrained translations: 1 x, 2 y, 3 z, 4 xy, 5 yz, 6 zx, 7 xyz"),
      code(&NodeRow::rc, "rc", "constrained rotations: 1 x, 2 y, 3 z, 4 xy, 5 yz, 6 zx, 7 xyz"),
  };
  return card;
}

/// A line that has to be read carefully; id 0 where a finding says what is wrong with it.
NodeRow read_carefully(CarefulLines& careful, std::string_view line, int number, const Block& block) {
  NodeRow node = *careful.read(node_row_card(), line, number);
  if (block.transform != nullptr) node.x = block.transform->moved(node.x);
  return node;
}

}  // namespace

const Card& node_card() {
  return node_row_card();
}

std::size_t estimated_rows(const Block& block, std::size_t lines_per_row) {
  const std::string_view sample = block.bulk.substr(0, 65536);
  const auto lines = static_cast<std::size_t>(std::count(sample.begin(), sample.end(), '\n')) + 1;
  return block.bulk.size() / std::max<std::size_t>(sample.size() / lines, 1) / lines_per_row + 1;
}

void read_nodes(const Deck& deck, const Block& block, NodeTable& out, Findings& findings) {
  const std::size_t rows = estimated_rows(block, 1);
  make_room(out.id, rows);
  make_room(out.x, rows);
  make_room(out.tc, rows);
  make_room(out.rc, rows);
  make_room(out.line, rows);
  make_room(out.file, rows);

  BulkLines lines(block);
  CarefulLines careful(deck, block, findings);
  const IdOffset offset(block, IdSpace::node);
  std::string_view line;
  while (lines.next(line)) {
    NodeRow node;
    if (careful.reads_every_line() || !read_plain(line, block, offset, node)) {
      if (trimmed(line).empty()) continue;
      node = read_carefully(careful, line, lines.number(), block);
      if (node.id == 0) continue;
    }
    out.id.push_back(node.id);
    out.x.push_back(node.x);
    out.tc.push_back(static_cast<signed char>(node.tc));
    out.rc.push_back(static_cast<signed char>(node.rc));
    out.line.push_back(lines.number());
  }
  out.file.resize(out.id.size(), static_cast<int>(block.file));
}

}  // namespace nugget::deck
