// SPDX-License-Identifier: Apache-2.0
#include "output/binout_reader.hpp"

#include <cstring>
#include <fstream>
#include <iterator>
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

}  // namespace

template <class T>
T BinoutReader::at(std::uint64_t offset) const {
  if (offset + sizeof(T) > bytes_.size()) throw std::out_of_range("binout: cut off");
  T value{};
  std::memcpy(&value, bytes_.data() + offset, sizeof(T));
  return value;
}

BinoutReader::BinoutReader(const std::filesystem::path& directory) {
  std::ifstream file(directory / "binout0000", std::ios::binary);
  bytes_.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  if (bytes_.size() < 25 || bytes_.substr(0, 8) != lsda_head || bytes_[16] != lsda_table_offset) return;
  try {
    std::set<std::uint64_t> seen;  // a chain that bites its tail ends
    for (auto table = at<std::uint64_t>(17); table != 0 && seen.insert(table).second;) table = read_table(table);
  } catch (const std::out_of_range&) {  // what was linked before it is whole
  }
}

/// Gives the place of the next table, 0 at the end.
std::uint64_t BinoutReader::read_table(std::uint64_t begin) {
  if (at<char>(begin + 8) != lsda_begin_table) return 0;
  const std::uint64_t end = begin + at<std::uint64_t>(begin);
  std::string directory;
  for (std::uint64_t record = begin + 9; record < end;) {
    const auto length = at<std::uint64_t>(record);
    const char command = at<char>(record + 8);
    if (length < 9 || record + length > bytes_.size()) throw std::out_of_range("binout: cut off");
    if (command == lsda_cd) directory = bytes_.substr(record + 9, length - 9);
    if (command == lsda_variable && length > 26) {
      const std::uint64_t type = record + length - 17;
      variables_[directory + "/" + bytes_.substr(record + 9, length - 26)] = {bytes_[type], at<std::uint64_t>(type + 1),
                                                                              at<std::uint64_t>(type + 9)};
    }
    if (command == lsda_end_table) return at<std::uint64_t>(record + 9);
    record += length;
  }
  return 0;
}

std::vector<std::string> BinoutReader::states(const std::string& branch) const {
  const std::string prefix = "/" + branch + "/d";
  std::vector<std::string> found;
  for (auto at = variables_.lower_bound(prefix);
       at != variables_.end() && at->first.compare(0, prefix.size(), prefix) == 0; ++at) {
    const std::size_t begin = prefix.size() - 1, end = at->first.find('/', begin);
    const std::string state = at->first.substr(begin, end - begin);
    if (found.empty() || found.back() != state) found.push_back(state);
  }
  return found;
}

std::vector<std::string> BinoutReader::names(const std::string& directory) const {
  const std::string prefix = directory + "/";
  std::vector<std::string> found;
  for (auto at = variables_.lower_bound(prefix);
       at != variables_.end() && at->first.compare(0, prefix.size(), prefix) == 0; ++at)
    found.push_back(at->first.substr(prefix.size()));
  return found;
}

/// Behind the record's length, command, type, length of the name and name.
std::uint64_t BinoutReader::begin_of_data(const std::string& path, const Variable& variable) const {
  return variable.offset + 11 + (path.size() - path.rfind('/') - 1);
}

std::vector<double> BinoutReader::numbers(const std::string& path) const {
  const auto found = variables_.find(path);
  if (found == variables_.end() || found->second.type == lsda_text) return {};
  const Variable& v = found->second;
  const std::uint64_t begin = begin_of_data(path, v);
  if (begin + v.count * size_of(v.type) > bytes_.size()) return {};
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

std::string BinoutReader::text(const std::string& path) const {
  const auto found = variables_.find(path);
  if (found == variables_.end() || found->second.type != lsda_text) return {};
  const std::uint64_t begin = begin_of_data(path, found->second);
  return begin + found->second.count > bytes_.size() ? std::string() : bytes_.substr(begin, found->second.count);
}

}  // namespace nugget::output
