// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "deck/deck.hpp"

namespace nugget::deck {

/// The text of a deck with pieces of it replaced and every other byte as it was.
class EditedText {
 public:
  /// `deck` must outlive it.
  explicit EditedText(const Deck& deck) : deck_(deck) {}

  /// Which file of the deck holds a piece of its text, by its address.
  std::size_t file_of(std::string_view piece) const;
  /// True where the file is included more than once, so that a change in it is one in several places.
  bool is_read_twice(std::size_t file) const;
  std::string_view text_of(std::size_t file) const;
  /// A line by its number, from 1, without its end.
  std::string_view line(std::size_t file, int number) const;

  /// What stands in place of a piece of the text now. Nothing where the piece is in one that was replaced.
  const std::string* current(std::string_view piece) const;
  /// Puts `text` in place of a piece; what was replaced inside of it is gone. False where the piece lies in one that
  /// was replaced, or across the end of one.
  bool replace(std::string_view piece, std::string text);
  bool empty() const { return edits_.empty(); }

  struct File {
    std::filesystem::path path;
    std::string text;
  };
  /// The master file as `master`, with `remark` (lines that begin with $) at its head, and beside it each included file
  /// that was changed, or includes one that was, as <stem of master>_<its name>. Other files are included where they
  /// are.
  std::vector<File> files(const std::filesystem::path& master, std::string_view remark) const;

 private:
  using Edits = std::map<std::size_t, std::pair<std::size_t, std::string>>;  ///< by offset: length and new text
  std::vector<bool> changed_files() const;
  void replace_name(std::size_t file, int line, std::string name, Edits& edits) const;
  std::string with_edits(std::size_t file, const Edits& edits, std::string_view remark) const;

  const Deck& deck_;
  std::map<std::size_t, Edits> edits_;  ///< by file
};

}  // namespace nugget::deck
