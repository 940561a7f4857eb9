// SPDX-License-Identifier: Apache-2.0
#include "output/binout.hpp"

#include <bit>
#include <cstring>
#include <stdexcept>

namespace nugget::output {
namespace {

static_assert(std::endian::native == std::endian::little, "LSDA files are written in the machine's byte order");

// Commands and types of LSDA.
constexpr char cd = 2, data_record = 3, variable_record = 4, begin_table = 5, end_table = 6, table_offset = 7;
constexpr char type_text = 1, type_int = 3, type_real = 10;
constexpr std::size_t record_head = 9;  // length, command

template <class T>
void append(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

void append_record_head(std::string& bytes, std::size_t body, char command) {
  append<std::uint64_t>(bytes, record_head + body);
  bytes += command;
}

template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

}  // namespace

Binout::Binout(const std::filesystem::path& directory, Header header)
    : file_(directory / "binout0000", header.mode), header_(std::move(header)) {
  if (header_.mode == OpenMode::append) return;
  std::string& out = file_.buffer();
  out.append({8, 8, 8, 1, 1, 1, 0, 0});  // head; bytes of length, offset, command, type; little endian; IEEE; spare
  append_record_head(out, 8, table_offset);
  link_ = out.size();
  append<std::uint64_t>(out, 0);
  file_.commit();
}

void Binout::set_legend(const std::string& branch, std::vector<LegendEntry> legend) {
  legends_[branch] = std::move(legend);
}

bool Binout::begin_state(const std::string& path, std::vector<int> ids, bool lists_ids) {
  Series& branch = branches_[path];
  if (++branch.states > 1) {
    if (ids != branch.ids) throw std::logic_error("binout: the entities of " + path + " changed between two states");
    return false;
  }
  branch.ids = std::move(ids);
  metadata(path, lists_ids ? branch.ids : std::vector<int>{});
  return true;
}

void Binout::metadata(const std::string& path, const std::vector<int>& ids) {
  directory("/" + path + "/metadata");
  text("title", fixed_width(header_.title, 80));
  text("version", fixed_width(header_.version, 12));
  text("revision", fixed_width("0", 10));
  text("date", fixed_width(header_.date, 10));
  if (!ids.empty()) integers("ids", ids);

  // A branch of several kinds (elout/shell, elout/solid) has a legend for each.
  auto legend = legends_.find(path);
  if (legend == legends_.end()) legend = legends_.find(path.substr(0, path.find('/')));
  if (legend == legends_.end() || legend->second.empty()) return;
  std::string headings;
  for (const LegendEntry& entry : legend->second) headings += fixed_width(entry.heading, 70);
  text("legend", headings);
  std::vector<int> entities;
  for (const LegendEntry& entry : legend->second) entities.push_back(entry.id);
  integers("legend_ids", entities);
}

void Binout::begin_data(const std::string& path) {
  const int state = branches_.at(path).states;
  directory(state <= 999999 ? fmt::format("/{}/d{:06}", path, state) : fmt::format("/{}/d{:08}", path, state));
}

void Binout::end_state() {
  if (variables_.empty()) return;
  const std::uint64_t position = file_.end();
  file_.buffer() += symbol_table();
  file_.commit();
  std::string link;
  append<std::uint64_t>(link, position);
  file_.write_at(link_, link);  // only now does a reader see the state
  link_ = file_.size() - sizeof(std::uint64_t);
  variables_.clear();
}

void Binout::archive(Archive& a) {
  a(file_, branches_, directory_, link_);
  a.built(header_, legends_, variables_, pieces_);
  if (a.reading()) file_.write_at(link_, std::string(sizeof(std::uint64_t), '\0'));
}

void Binout::directory(const std::string& path) {
  append_record_head(file_.buffer(), path.size(), cd);
  file_.buffer() += path;
  directory_ = path;
}

void Binout::text(const std::string& name, const std::string& value) {
  data(name, type_text, value.size(), value);
}

void Binout::integers(const std::string& name, const std::vector<int>& values) {
  data(name, type_int, values.size(), bytes_of(values));
}

void Binout::reals(const std::string& name, const std::vector<double>& values) {
  data(name, type_real, values.size(), bytes_of(values));
}

void Binout::put(const std::string& name, const Values& values) {
  if (const auto* all = std::get_if<std::vector<double>>(&values)) reals(name, *all);
  if (const auto* all = std::get_if<std::vector<int>>(&values)) integers(name, *all);
  if (const auto* all = std::get_if<std::string>(&values)) text(name, *all);
}

void Binout::head(const std::string& name, char type, std::uint64_t count, std::uint64_t bytes) {
  std::string& out = file_.buffer();
  variables_[directory_][name] = {type, file_.end(), count};
  append_record_head(out, 2 + name.size() + bytes, data_record);
  out += type;
  out += static_cast<char>(name.size());
  out += name;
}

void Binout::data(const std::string& name, char type, std::uint64_t count, std::string_view bytes) {
  head(name, type, count, bytes.size());
  file_.buffer() += bytes;
}

Binout::Room Binout::leave_room(const std::string& name, std::size_t type, std::size_t count) {
  if (type == 0) return {};
  const bool reals = type == Values(std::vector<double>{}).index();
  const std::uint64_t bytes = count * (reals ? sizeof(double) : sizeof(int));
  head(name, reals ? type_real : type_int, count, bytes);
  const std::uint64_t begin = file_.leave_room(bytes);
  return {begin, begin + bytes};
}

void Binout::put_ahead(Room& room, const Values& values) {
  const auto write = [&](const auto& numbers) {
    const std::string_view bytes = bytes_of(numbers);
    if (room.next + bytes.size() > room.end) throw std::logic_error("binout: more rows than there is room for");
    file_.write_ahead(room.next, bytes);
    room.next += bytes.size();
  };
  if (const auto* all = std::get_if<std::vector<double>>(&values)) write(*all);
  if (const auto* all = std::get_if<std::vector<int>>(&values)) write(*all);
}

void Binout::end_pieces() {
  for (const std::vector<Room>& branch : pieces_)
    for (const Room& room : branch)
      if (room.next != room.end) throw std::logic_error("binout: rows of a state are missing");
  pieces_.clear();
  end_state();
}

/// The table of all data since the last one, in alphabetical order as LSTC's library writes it; its last word is the
/// link to the next table.
std::string Binout::symbol_table() const {
  std::string body;
  for (const auto& [path, names] : variables_) {
    append_record_head(body, path.size(), cd);
    body += path;
    for (const auto& [name, variable] : names) {
      append_record_head(body, name.size() + 1 + 8 + 8, variable_record);
      body += name;
      body += variable.type;
      append(body, variable.offset);
      append(body, variable.count);
    }
  }
  append_record_head(body, 8, end_table);
  append<std::uint64_t>(body, 0);
  std::string table;
  append_record_head(table, body.size(), begin_table);
  return table + body;
}

}  // namespace nugget::output
