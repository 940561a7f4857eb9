// SPDX-License-Identifier: Apache-2.0
#include "output/binout_reader.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <set>
#include <stdexcept>

namespace nugget::output {
namespace {

constexpr std::string_view lsda_head("\x08\x08\x08\x01\x01\x01\x00\x00", 8);
constexpr char lsda_cd = 2, lsda_variable = 4, lsda_begin_table = 5, lsda_end_table = 6, lsda_table_offset = 7;
constexpr char lsda_text = 1, lsda_int = 3, lsda_long = 4, lsda_float = 9, lsda_real = 10;

std::size_t size_of(char type) {
  switch (type) {
    case lsda_int:
    case lsda_float: return 4;
    case lsda_long:
    case lsda_real: return 8;
    default: return 1;
  }
}

/// Where its numbers begin: behind the record's length, command, type, length of the name and name.
std::uint64_t begin_of_data(const BinoutReader::Variable& variable) {
  return variable.offset + 11 + variable.name.size();
}

}  // namespace

template <class T>
T BinoutReader::at(std::uint64_t offset) const {
  if (offset + sizeof(T) > bytes_.size()) throw std::out_of_range("binout: cut off");
  T value{};
  std::memcpy(&value, bytes_.data() + offset, sizeof(T));
  return value;
}

BinoutReader::BinoutReader(const std::filesystem::path& directory) {
  const std::filesystem::path path = directory / "binout0000";
  std::error_code none;
  const auto size = std::filesystem::file_size(path, none);
  std::ifstream file(path, std::ios::binary);
  if (none || !file) return;
  bytes_.resize(size);
  file.read(bytes_.data(), static_cast<std::streamsize>(size));
  bytes_.resize(static_cast<std::size_t>(file.gcount()));
  if (bytes_.size() < 25 || bytes_.substr(0, 8) != lsda_head || bytes_[16] != lsda_table_offset) return;
  try {
    std::set<std::uint64_t> seen;  // a chain that bites its tail ends
    for (auto table = at<std::uint64_t>(17); table != 0 && seen.insert(table).second;) table = read_table(table);
  } catch (const std::out_of_range&) {  // what was linked before it is whole
  }
  for (auto& [path_of_all, variables] : directories_) {
    // Of one that is there twice the last counts.
    std::ranges::reverse(variables);
    std::ranges::stable_sort(variables, {}, &Variable::name);
    const auto same = [](const Variable& a, const Variable& b) { return a.name == b.name; };
    variables.erase(std::unique(variables.begin(), variables.end(), same), variables.end());
  }
}

/// Gives the place of the next table, 0 at the end.
std::uint64_t BinoutReader::read_table(std::uint64_t begin) {
  if (at<char>(begin + 8) != lsda_begin_table) return 0;
  const std::uint64_t end = begin + at<std::uint64_t>(begin);
  const std::string_view bytes = bytes_;
  std::vector<Variable>* directory = &directories_[""];
  for (std::uint64_t record = begin + 9; record < end;) {
    const auto length = at<std::uint64_t>(record);
    const char command = at<char>(record + 8);
    if (length < 9 || record + length > bytes.size()) throw std::out_of_range("binout: cut off");
    if (command == lsda_cd) directory = &directories_[std::string(bytes.substr(record + 9, length - 9))];
    if (command == lsda_variable && length > 26) {
      const std::uint64_t type = record + length - 17;
      directory->push_back({bytes.substr(record + 9, length - 26), bytes[type], at<std::uint64_t>(type + 1),
                            at<std::uint64_t>(type + 9)});
    }
    if (command == lsda_end_table) return at<std::uint64_t>(record + 9);
    record += length;
  }
  return 0;
}

std::vector<std::string> BinoutReader::states(const std::string& branch) const {
  const std::string prefix = "/" + branch + "/d";
  std::vector<std::string> found;
  for (auto at = directories_.lower_bound(prefix); at != directories_.end() && at->first.starts_with(prefix); ++at) {
    const std::size_t begin = prefix.size() - 1, end = at->first.find('/', begin);
    const std::string state = at->first.substr(begin, end - begin);
    if (found.empty() || found.back() != state) found.push_back(state);
  }
  return found;
}

std::vector<std::string> BinoutReader::branches(const std::string& branch) const {
  const std::string prefix = "/" + branch + "/";
  std::vector<std::string> found;
  for (auto at = directories_.lower_bound(prefix); at != directories_.end() && at->first.starts_with(prefix); ++at) {
    const std::size_t end = at->first.find('/', prefix.size());
    if (end == std::string::npos) continue;
    std::string name = at->first.substr(prefix.size(), end - prefix.size());
    if (found.empty() || found.back() != name) found.push_back(std::move(name));
  }
  return found;
}

std::span<const BinoutReader::Variable> BinoutReader::variables(std::string_view directory) const {
  const auto found = directories_.find(directory);
  return found != directories_.end() ? std::span<const Variable>(found->second) : std::span<const Variable>();
}

const BinoutReader::Variable* BinoutReader::find(std::string_view path) const {
  const std::size_t slash = path.rfind('/');
  const std::span<const Variable> all = variables(path.substr(0, slash));
  const std::string_view name = path.substr(slash + 1);
  const auto found = std::ranges::lower_bound(all, name, {}, &Variable::name);
  return found != all.end() && found->name == name ? &*found : nullptr;
}

std::vector<double> BinoutReader::numbers(std::string_view path) const {
  const Variable* found = find(path);
  return found != nullptr ? numbers(*found) : std::vector<double>();
}

std::vector<double> BinoutReader::numbers(const Variable& v) const {
  const std::uint64_t begin = begin_of_data(v);
  if (v.type == lsda_text || begin + v.count * size_of(v.type) > bytes_.size()) return {};
  std::vector<double> values;
  values.reserve(v.count);
  for (std::uint64_t i = 0; i < v.count; ++i) {
    const std::uint64_t place = begin + i * size_of(v.type);
    switch (v.type) {
      case lsda_int: values.push_back(at<std::int32_t>(place)); break;
      case lsda_long: values.push_back(static_cast<double>(at<std::int64_t>(place))); break;
      case lsda_float: values.push_back(static_cast<double>(at<float>(place))); break;
      case lsda_real: values.push_back(at<double>(place)); break;
      default: return {};
    }
  }
  return values;
}

std::string BinoutReader::text(std::string_view path) const {
  const Variable* found = find(path);
  if (found == nullptr || found->type != lsda_text) return {};
  const std::uint64_t begin = begin_of_data(*found);
  return begin + found->count > bytes_.size() ? std::string() : bytes_.substr(begin, found->count);
}

}  // namespace nugget::output
