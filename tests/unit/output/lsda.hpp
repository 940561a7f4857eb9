// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace nugget::output {

/// A reader of LSDA files for the tests: follows the chain of symbol tables from the head, as LSTC's library does.
class Lsda {
 public:
  explicit Lsda(std::string bytes) : bytes_(std::move(bytes)) {
    EXPECT_EQ(bytes_.substr(0, 8), std::string("\x08\x08\x08\x01\x01\x01\x00\x00", 8));
    EXPECT_EQ(at<std::uint64_t>(8), 17u);
    EXPECT_EQ(bytes_[16], 7);
    for (std::uint64_t table = at<std::uint64_t>(17); table != 0;) table = read_table(table);
  }

  bool has(const std::string& path) const { return variables_.count(path) == 1; }
  const std::vector<std::string>& paths() const { return paths_; }  ///< in the order of the tables
  std::string text(const std::string& path) const { return raw(path, 1, 1); }
  std::vector<int> integers(const std::string& path) const { return values<int>(path, 3); }
  std::vector<double> reals(const std::string& path) const { return values<double>(path, 10); }

 private:
  struct Variable {
    int type = 0;
    std::uint64_t offset = 0, count = 0;
  };

  template <class T>
  T at(std::uint64_t offset) const {
    T value{};
    if (offset + sizeof(T) > bytes_.size()) throw std::runtime_error("LSDA: read past the end");
    std::memcpy(&value, bytes_.data() + offset, sizeof(T));
    return value;
  }

  /// Returns the place of the next table, 0 at the end.
  std::uint64_t read_table(std::uint64_t begin) {
    EXPECT_EQ(bytes_.at(begin + 8), 5);
    const std::uint64_t end = begin + at<std::uint64_t>(begin);
    std::string directory;
    for (std::uint64_t record = begin + 9; record < end;) {
      const auto length = at<std::uint64_t>(record);
      const char command = bytes_.at(record + 8);
      if (command == 2) directory = bytes_.substr(record + 9, length - 9);
      if (command == 4) {
        const std::string path = directory + "/" + bytes_.substr(record + 9, length - 26);
        const std::uint64_t type = record + length - 17;
        variables_[path] = {bytes_.at(type), at<std::uint64_t>(type + 1), at<std::uint64_t>(type + 9)};
        paths_.push_back(path);
      }
      if (command == 6) {
        EXPECT_EQ(record + length, end);
        return at<std::uint64_t>(record + 9);
      }
      record += length;
    }
    ADD_FAILURE() << "symbol table without an end";
    return 0;
  }

  /// The bytes of a variable, after the data record's own head has confirmed the table.
  std::string raw(const std::string& path, int type, std::size_t size) const {
    const Variable& v = variables_.at(path);
    const std::string name = path.substr(path.rfind('/') + 1);
    EXPECT_EQ(v.type, type) << path;
    EXPECT_EQ(at<std::uint64_t>(v.offset), 11 + name.size() + v.count * size) << path;
    EXPECT_EQ(bytes_.at(v.offset + 8), 3) << path;
    EXPECT_EQ(bytes_.at(v.offset + 9), type) << path;
    EXPECT_EQ(bytes_.at(v.offset + 10), static_cast<char>(name.size())) << path;
    EXPECT_EQ(bytes_.substr(v.offset + 11, name.size()), name);
    return bytes_.substr(v.offset + 11 + name.size(), v.count * size);
  }

  template <class T>
  std::vector<T> values(const std::string& path, int type) const {
    const std::string bytes = raw(path, type, sizeof(T));
    std::vector<T> result(bytes.size() / sizeof(T));
    std::memcpy(result.data(), bytes.data(), bytes.size());
    return result;
  }

  std::string bytes_;
  std::map<std::string, Variable> variables_;
  std::vector<std::string> paths_;
};

}  // namespace nugget::output
