// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <span>
#include <string_view>

#include "base/vec3.hpp"
#include "deck/deck.hpp"
#include "deck/edited_text.hpp"

namespace nugget::deck {

/// Lines of *ELEMENT_SHELL in the text of a deck that become several, and lines of *NODE after others.
class DividedShells {
 public:
  /// `deck` and `text`, which takes the changes, must outlive it.
  DividedShells(const Deck& deck, EditedText& text);

  /// Whether a shell stands in a plain line of *ELEMENT_SHELL, without options, of its own: not in a file that is
  /// included twice or with a transformation or offsets, not defined twice, no parameters in the line.
  bool can_divide(int shell) const { return one_line(shells_, shell) != nullptr; }
  /// The same of a node's line, after which others may come.
  bool can_follow(int node) const { return one_line(nodes_, node) != nullptr; }
  /// Whether ids up to these fit into the columns of both.
  bool fits(int shell, int largest_shell, int node, int largest_node) const;

  struct Shell {
    int id = 0;
    std::array<int, 4> nodes{};
  };
  /// Puts `shells` in place of the shell's line, with its part.
  void divide(int shell, std::span<const Shell> shells);
  struct Node {
    int id = 0;
    Vec3d x;  ///< [length]
  };
  /// Puts new nodes after the line of another, as that is by now: to be called once for a node, when its own place has
  /// been changed.
  void follow(int node, std::span<const Node> nodes);

 private:
  struct Line {
    const Block* block = nullptr;
    std::string_view text;
    int count = 0;  ///< how often the id is defined
  };
  using Lines = std::map<int, Line>;
  static const Line* one_line(const Lines& lines, int id);
  void add_lines(const Block& block, Lines& lines) const;

  EditedText& text_;
  Lines shells_, nodes_;
};

}  // namespace nugget::deck
