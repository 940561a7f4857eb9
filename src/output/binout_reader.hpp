// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace nugget::output {

/// A binout (LSDA) as Binout writes it, its variables by path: `/swforc/metadata/ids`, `/swforc/d000001/axial`. Only
/// whole states are known.
class BinoutReader {
 public:
  /// Reads `directory/binout0000`; nothing is known where it is missing or is no LSDA of 8-byte lengths.
  explicit BinoutReader(const std::filesystem::path& directory);

  /// `d000001`, ... of a branch in their order.
  std::vector<std::string> states(const std::string& branch) const;
  /// Variables of a directory, without its path.
  std::vector<std::string> names(const std::string& directory) const;
  /// Whole or real numbers; empty where there is no such variable, or it is text.
  std::vector<double> numbers(const std::string& path) const;
  std::string text(const std::string& path) const;

 private:
  struct Variable {
    char type = 0;
    std::uint64_t offset = 0, count = 0;
  };
  template <class T>
  T at(std::uint64_t offset) const;
  std::uint64_t read_table(std::uint64_t begin);
  std::uint64_t begin_of_data(const std::string& path, const Variable& variable) const;

  std::string bytes_;
  std::map<std::string, Variable> variables_;
};

}  // namespace nugget::output
