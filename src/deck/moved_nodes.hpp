// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "deck/deck.hpp"
#include "deck/edited_text.hpp"

namespace nugget::deck {

/// With as many digits as `width` columns hold; 0: without a limit.
std::string written_coordinate(double value, std::size_t width);

/// Other coordinates in the *NODE lines of a deck.
class MovedNodes {
 public:
  /// `deck` and `text`, which takes the changes, must outlive it.
  MovedNodes(const Deck& deck, EditedText& text);

  /// Whether the coordinates of a node stand in a line of their own: not in a file that is included twice, not defined
  /// twice, no parameters or expressions in the line.
  bool can_move(int id) const;
  /// Gives a node that can be moved a new place, in the units and axes of the whole model [length].
  void move(int id, const Vec3d& x);

 private:
  struct Line {
    int id = 0;
    const Block* block = nullptr;
    std::string_view text;
  };
  void add_lines(const Block& block);
  const Line* find(int id) const;

  EditedText& text_;
  std::vector<Line> lines_;  ///< ascending by id
};

}  // namespace nugget::deck
