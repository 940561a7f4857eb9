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

/// The text of a deck with other coordinates in its *NODE lines and nothing else changed.
class MovedNodes {
 public:
  /// `deck` must outlive it.
  explicit MovedNodes(const Deck& deck);

  /// Whether the coordinates of a node stand in a line of their own: not in a file that is included twice, not defined
  /// twice, no parameters or expressions in the line.
  bool can_move(int id) const;
  /// Gives a node that can be moved a new place, in the units and axes of the whole model [length].
  void move(int id, const Vec3d& x);

  struct File {
    std::filesystem::path path;
    std::string text;
  };
  /// The master file as `master`, with `remark` (lines that begin with $) at its head, and beside it each included file
  /// that holds a moved node, or includes one that does, as <stem of master>_<its name>. Other files are included where
  /// they are.
  std::vector<File> files(const std::filesystem::path& master, std::string_view remark) const;

 private:
  struct Line {
    int id = 0;
    const Block* block = nullptr;
    std::string_view text;
  };
  using Edits = std::map<std::size_t, std::pair<std::size_t, std::string>>;  ///< by offset: length and new text
  void add_lines(const Block& block);
  const Line* find(int id) const;
  std::string_view text_of(std::size_t file) const;
  std::vector<bool> changed_files() const;
  void replace_name(std::size_t file, int line, std::string name, Edits& edits) const;
  std::string with_edits(std::size_t file, const Edits& edits, std::string_view remark) const;

  const Deck& deck_;
  std::vector<Line> lines_;                  ///< ascending by id
  std::map<std::size_t, Edits> node_edits_;  ///< by file
};

}  // namespace nugget::deck
