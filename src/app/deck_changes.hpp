// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/prepared_deck.hpp"
#include "deck/deck.hpp"
#include "deck/edited_text.hpp"
#include "deck/moved_nodes.hpp"
#include "deck/parameters.hpp"

namespace nugget::app {

/// A deck whose text is changed, value by value, and written as another one: every byte that was not changed stays as
/// it is. What cannot be changed is refused with std::invalid_argument, by name.
class DeckChanges {
 public:
  /// Reads the deck of `arguments` once more, as `prepared` was; which must outlive it.
  DeckChanges(const RunArguments& arguments, const PreparedDeck& prepared);
  DeckChanges(const DeckChanges&) = delete;
  DeckChanges& operator=(const DeckChanges&) = delete;

  /// The cards of one keyword that belong together: one material, one section.
  struct Cards {
    std::string keyword;  ///< as written, with its star
    Place place;          ///< of its first card
    std::vector<std::size_t> lines;
  };
  const std::vector<Cards>& cards() const { return cards_; }
  /// Those of a keyword, under any of its names and options, with or without its star.
  std::vector<std::size_t> cards_of(const std::string& keyword) const;
  /// Names of their fields, in order.
  std::vector<std::string> fields(std::size_t cards) const;

  struct Value {
    Kind kind = Kind::real;
    std::string text;      ///< as written, trimmed; empty: blank
    double number = 0.0;   ///< of a number, parameters replaced
    bool readable = true;  ///< it is one
  };
  Value value(std::size_t cards, const std::string& field) const;
  void set_number(std::size_t cards, const std::string& field, double number);
  void set_text(std::size_t cards, const std::string& field, const std::string& text);

  /// Of *PARAMETER: number or text of its last definition, by name.
  std::map<std::string, Value> parameters() const;
  void set_parameter_number(const std::string& name, double number);
  void set_parameter_text(const std::string& name, const std::string& text);

  /// Takes the elements of a weld out.
  void remove_weld(int id);
  /// Moves the nodes of a weld so that their mean stands at `x`, in the axes and units of the whole model.
  void move_weld(int id, const Vec3d& x);
  void move_node(int id, const Vec3d& x);

  bool empty() const { return text_.empty(); }
  /// The text of the deck as `master` with `remark` at its head, see deck::EditedText. Refused where it would take the
  /// place of a file that was read.
  std::vector<deck::EditedText::File> files(const std::filesystem::path& master, std::string_view remark = {}) const;
  /// Writes the deck as `master`, see deck::EditedText; gives the files. Throws output::WriteError.
  std::vector<std::string> write(const std::filesystem::path& master) const;

 private:
  struct ReadCard {
    const deck::Block* block = nullptr;
    std::size_t line = 0;  ///< in Block::lines
    Card card;             ///< by whose table it was read
  };
  struct Cell;
  Cell find(std::size_t cards, const std::string& field) const;
  void put(const Cell& cell, const std::string& text);
  const deck::Parameter& changeable_parameter(const std::string& name) const;
  void expect_changeable(std::string_view piece, const std::string& what) const;
  const weld::Weld& find_weld(int id) const;
  /// Numbers of the lines with which elements begin, by id, in a bulk block.
  const std::map<int, int>& rows_of(const deck::Block& block);
  void find_nodes();
  void remove_element(model::ElementKind kind, int id);

  const PreparedDeck& prepared_;
  deck::Deck deck_;
  std::vector<ReadCard> read_;
  std::vector<Cards> cards_;
  deck::EditedText text_;
  std::optional<deck::MovedNodes> nodes_;  ///< once one is moved
  std::vector<char> as_written_;           ///< by node: it stands where its line says
  std::map<const deck::Block*, std::map<int, int>> rows_;
};

}  // namespace nugget::app
