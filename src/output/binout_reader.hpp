// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nugget::output {

/// A binout (LSDA) as Binout writes it, its variables by path: `/swforc/metadata/ids`, `/swforc/d000001/axial`. Only
/// whole states are known.
class BinoutReader {
 public:
  /// Reads `directory/binout0000`; nothing is known where it is missing or is no LSDA of 8-byte lengths.
  explicit BinoutReader(const std::filesystem::path& directory);
  BinoutReader(const BinoutReader&) = delete;  // its variables' names stand in its bytes
  BinoutReader& operator=(const BinoutReader&) = delete;

  struct Variable {
    std::string_view name;
    char type = 0;
    std::uint64_t offset = 0, count = 0;
  };
  /// `d000001`, ... of a branch in their order.
  std::vector<std::string> states(const std::string& branch) const;
  /// Names of the branches of a branch, `slave_000007` of ncforc, in alphabetical order.
  std::vector<std::string> branches(const std::string& branch) const;
  /// Those of a directory, by name.
  std::span<const Variable> variables(std::string_view directory) const;
  /// Whole or real numbers; empty where there is no such variable, or it is text.
  std::vector<double> numbers(std::string_view path) const;
  std::vector<double> numbers(const Variable& variable) const;
  std::string text(std::string_view path) const;

 private:
  template <class T>
  T at(std::uint64_t offset) const;
  std::uint64_t read_table(std::uint64_t begin);
  const Variable* find(std::string_view path) const;

  std::string bytes_;
  std::map<std::string, std::vector<Variable>, std::less<>> directories_;
};

}  // namespace nugget::output
