// SPDX-License-Identifier: Apache-2.0
#include "deck/moved_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "deck/bulk.hpp"
#include "deck/numbers.hpp"

namespace nugget::deck {
namespace {

/// Where the n-th comma stands, from 1; at the end where there are fewer.
std::size_t nth_comma(std::string_view line, int n) {
  std::size_t at = line.find(',');
  while (--n > 0 && at != std::string_view::npos) at = line.find(',', at + 1);
  return std::min(at, line.size());
}

bool is_separated(std::string_view line) {
  return line.find(',') != std::string_view::npos;
}

/// The id that a line of *NODE begins with, as the model has it; 0 where none can be read.
int id_of_node(std::string_view line, const Block& block, const IdOffset& offset) {
  int id = 0;
  const std::string_view cell =
      is_separated(line) ? line.substr(0, nth_comma(line, 1)) : columns(line, 0, id_width(block.format));
  const bool good = line.find_first_of("&<") == std::string_view::npos &&
                    parse_integer(trimmed(cell), id) == WholeNumber::good && offset.apply(id);
  return good ? id : 0;
}

std::string with_coordinates(std::string_view line, Format format, const Vec3d& x) {
  if (is_separated(line))
    return fmt::format("{},{},{},{}{}", line.substr(0, nth_comma(line, 1)), written_coordinate(x.x, 0),
                       written_coordinate(x.y, 0), written_coordinate(x.z, 0), line.substr(nth_comma(line, 4)));
  const std::size_t narrow = id_width(format), wide = real_width(format);
  std::string text(columns(line, 0, narrow));
  text.resize(narrow, ' ');
  for (const double c : {x.x, x.y, x.z}) text += fmt::format("{:>{}}", written_coordinate(c, wide - 1), wide);
  return text + std::string(columns(line, narrow + 3 * wide, line.size()));
}

}  // namespace

std::string written_coordinate(double value, std::size_t width) {
  std::string text = fmt::format("{}", value);
  for (int digits = 17; width > 0 && text.size() > width && digits > 1; --digits)
    text = fmt::format("{:.{}g}", value, digits);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

Vec3d Transform::written(const Vec3d& x) const {
  const Vec3d r{x.x - matrix[3], x.y - matrix[7], x.z - matrix[11]};
  const Vec3d a{matrix[0], matrix[4], matrix[8]}, b{matrix[1], matrix[5], matrix[9]},
      c{matrix[2], matrix[6], matrix[10]};
  const double scale = 1.0 / (dot(a, cross(b, c)) * length);
  return scale * Vec3d{dot(r, cross(b, c)), dot(r, cross(c, a)), dot(r, cross(a, b))};
}

MovedNodes::MovedNodes(const Deck& deck, EditedText& text) : text_(text) {
  std::map<const char*, int> read;  // a text that is read twice has nodes that move together
  for (const Block& block : deck.blocks)
    if (block.keyword == "NODE") ++read[block.bulk.data()];
  for (const Block& block : deck.blocks)
    if (block.keyword == "NODE" && read[block.bulk.data()] == 1) add_lines(block);
  std::stable_sort(lines_.begin(), lines_.end(), [](const Line& a, const Line& b) { return a.id < b.id; });
}

void MovedNodes::add_lines(const Block& block) {
  BulkLines lines(block);
  const IdOffset offset(block, IdSpace::node);
  std::string_view line;
  while (lines.next(line))
    if (const int id = id_of_node(line, block, offset); id > 0) lines_.push_back({id, &block, line});
}

const MovedNodes::Line* MovedNodes::find(int id) const {
  const auto [first, last] = std::equal_range(lines_.begin(), lines_.end(), Line{id, nullptr, {}},
                                              [](const Line& a, const Line& b) { return a.id < b.id; });
  return last - first == 1 ? &*first : nullptr;
}

bool MovedNodes::can_move(int id) const {
  return find(id) != nullptr;
}

void MovedNodes::move(int id, const Vec3d& x) {
  const Line& line = *find(id);
  const Block& block = *line.block;
  const Vec3d place = block.transform == nullptr ? x : block.transform->written(x);
  text_.replace(line.text, with_coordinates(line.text, block.format, place));
}

}  // namespace nugget::deck
