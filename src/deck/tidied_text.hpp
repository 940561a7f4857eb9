// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/finding.hpp"
#include "deck/deck.hpp"
#include "deck/edited_text.hpp"

namespace nugget::deck {

/// The text of a deck as it was understood: each line that was read by a card's table with its values between commas,
/// below a comment that names its fields. Every value keeps its text: parameters stay parameters. What no table read
/// (titles, parameters, keywords that are not supported) stays as it is. Comments begin with `$#`, as pre-processors
/// write them; those that stand above such a line already are replaced.
class TidiedText {
 public:
  /// `deck` must outlive it.
  explicit TidiedText(const Deck& deck) : deck_(deck), edited_(deck) {}

  /// A line as it is read; see Deck::card_read.
  void add(const Block& block, std::size_t line, const Card& card);
  /// Writes all lines that were read, and below the comments of a line what was found to be wrong with it: that line
  /// stays as it is.
  void write(const Findings& findings);
  const EditedText& text() const { return edited_; }
  std::size_t tidied() const { return tidied_; }  ///< lines
  std::size_t kept() const { return kept_; }      ///< lines that were read and stay as they are

 private:
  struct ReadLine {
    std::string_view text;
    std::size_t file = 0, scope = 0;
    int number = 0;
    const Card* card = nullptr;
    Format format = Format::standard;
    bool is_doubtful = false;  ///< read by different tables
    bool names_fields = false;
  };
  const Card* kept_card(const Card& card);
  std::vector<std::string> parameters_in(const ReadLine& read) const;
  void write_line(const ReadLine& read, const std::vector<std::string>& faults);
  /// `text` with the machine's comments above it.
  std::string_view with_comments_above(std::string_view text, std::size_t file, std::string_view beginning) const;

  const Deck& deck_;
  EditedText edited_;
  std::deque<Card> cards_;
  std::vector<ReadLine> lines_;
  std::unordered_map<const char*, std::size_t> index_;  ///< into `lines_`, by where the line begins
  std::pair<std::size_t, int> last_keyword_{};          ///< file and line of the keyword of the line before
  std::vector<const Card*> named_;                      ///< below it: tables of which the fields have been named
  std::size_t tidied_ = 0, kept_ = 0;
};

}  // namespace nugget::deck
