// SPDX-License-Identifier: Apache-2.0
#include "deck/moved_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "deck/bulk.hpp"
#include "deck/impl.hpp"
#include "deck/numbers.hpp"

namespace nugget::deck {
namespace {

namespace fs = std::filesystem;

/// With as many digits as `width` columns hold; 0: without a limit.
std::string written_coordinate(double value, std::size_t width) {
  std::string text = fmt::format("{}", value);
  for (int digits = 17; width > 0 && text.size() > width && digits > 1; --digits)
    text = fmt::format("{:.{}g}", value, digits);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

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

/// The line after that at `offset`.
std::size_t next_line(std::string_view text, std::size_t offset) {
  const std::size_t end = text.find('\n', offset);
  return end == std::string_view::npos ? text.size() : end + 1;
}

}  // namespace

Vec3d Transform::written(const Vec3d& x) const {
  const Vec3d r{x.x - matrix[3], x.y - matrix[7], x.z - matrix[11]};
  const Vec3d a{matrix[0], matrix[4], matrix[8]}, b{matrix[1], matrix[5], matrix[9]},
      c{matrix[2], matrix[6], matrix[10]};
  const double scale = 1.0 / (dot(a, cross(b, c)) * length);
  return scale * Vec3d{dot(r, cross(b, c)), dot(r, cross(c, a)), dot(r, cross(a, b))};
}

MovedNodes::MovedNodes(const Deck& deck) : deck_(deck) {
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
  const auto offset = static_cast<std::size_t>(line.text.data() - text_of(block.file).data());
  node_edits_[block.file][offset] = {line.text.size(), with_coordinates(line.text, block.format, place)};
}

std::string_view MovedNodes::text_of(std::size_t file) const {
  return deck_.impl->texts[file].view();
}

std::vector<bool> MovedNodes::changed_files() const {
  std::vector<bool> changed(deck_.files.size(), false);
  for (const auto& [file, edits] : node_edits_) changed[file] = true;
  // A file is included by one that was opened before it, so that one walk from the last on reaches the master; a file
  // opened twice may stand before: once more until nothing changes.
  for (bool more = true; more;) {
    more = false;
    for (const Deck::Inclusion& i : deck_.inclusions)
      if (changed[i.file] && !changed[i.from]) changed[i.from] = more = true;
  }
  changed[0] = true;
  return changed;
}

void MovedNodes::replace_name(std::size_t file, int line, std::string name, Edits& edits) const {
  const std::string_view text = text_of(file);
  std::size_t begin = 0;
  for (int i = 1; i < line; ++i) begin = next_line(text, begin);
  std::size_t end = begin;
  bool continued = true;
  while (continued && end < text.size()) {
    const std::size_t next = next_line(text, end);
    const std::string_view piece = text.substr(end, next - end);
    const bool remark = piece.starts_with('$');
    continued = remark || trimmed(piece.substr(0, piece.find('\n'))).ends_with(" +");
    end = next;
  }
  edits[begin] = {end - begin, name_lines(std::move(name))};
}

std::string MovedNodes::with_edits(std::size_t file, const Edits& edits, std::string_view remark) const {
  const std::string_view text = text_of(file);
  std::string out;
  std::size_t done = 0;
  if (const std::size_t keyword = text.find("*KEYWORD"); file == 0) {
    done = keyword == std::string_view::npos ? 0 : next_line(text, keyword);
    out.append(text.substr(0, done)).append(remark);
  }
  for (const auto& [offset, edit] : edits) {
    out.append(text.substr(done, offset - done)).append(edit.second);
    done = offset + edit.first;
  }
  return out.append(text.substr(done));
}

std::vector<MovedNodes::File> MovedNodes::files(const fs::path& master, std::string_view remark) const {
  const std::vector<bool> changed = changed_files();
  const fs::path folder = fs::absolute(master).parent_path();
  std::vector<std::string> names(deck_.files.size());
  std::set<std::string> taken{master.filename().string()};
  for (std::size_t f = 0; f < names.size(); ++f) {
    const fs::path old(deck_.files[f]);
    if (!changed[f] || f == 0) {
      names[f] = f == 0 ? master.filename().string() : fs::proximate(fs::absolute(old), folder).generic_string();
      continue;
    }
    const std::string stem = master.stem().string() + '_' + old.stem().string();
    names[f] = stem + old.extension().string();
    for (int k = 2; !taken.insert(names[f]).second; ++k)
      names[f] = fmt::format("{}_{}{}", stem, k, old.extension().string());
  }
  std::vector<File> out;
  for (std::size_t f = 0; f < names.size(); ++f) {
    if (!changed[f]) continue;
    const auto own = node_edits_.find(f);
    Edits edits = own == node_edits_.end() ? Edits{} : own->second;
    for (const Deck::Inclusion& i : deck_.inclusions)
      if (i.from == f) replace_name(f, i.line, names[i.file], edits);
    out.push_back({f == 0 ? master : master.parent_path() / names[f], with_edits(f, edits, remark)});
  }
  return out;
}

}  // namespace nugget::deck
