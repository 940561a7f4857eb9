// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <string_view>
#include <vector>

#include "deck/deck.hpp"
#include "deck/numbers.hpp"
#include "deck/text.hpp"

// What the readers of bulk tables share: a walk over the lines of a block, plain columns read straight from the text,
// and the careful path (a Cursor over the same lines) for every line that is not plain.
namespace nugget::deck {

/// Data lines of a bulk block, comments left out.
class BulkLines {
 public:
  explicit BulkLines(const Block& block) : rest_(block.bulk), number_(block.bulk_line - 1) {}

  bool next(std::string_view& line) {
    while (!rest_.empty()) {
      const auto* const end = static_cast<const char*>(std::memchr(rest_.data(), '\n', rest_.size()));
      const std::size_t length = end == nullptr ? rest_.size() : static_cast<std::size_t>(end - rest_.data());
      line = rest_.substr(0, length);
      rest_.remove_prefix(end == nullptr ? length : length + 1);
      ++number_;
      if (line.empty()) return true;
      if (line.front() == '$') continue;
      if (line.back() == '\r') line.remove_suffix(1);
      return true;
    }
    return false;
  }

  int number() const { return number_; }  ///< of the last line given out

 private:
  std::string_view rest_;
  int number_;
};

/// About how many rows the block will give, from its first lines.
std::size_t estimated_rows(const Block& block, std::size_t lines_per_row);

/// Makes room for `more` rows without giving up the growth by factors that makes appending cheap.
template <class T>
void make_room(std::vector<T>& v, std::size_t more) {
  const std::size_t wanted = v.size() + more;
  if (wanted > v.capacity()) v.reserve(wanted > 2 * v.size() ? wanted : 2 * v.size());
}

/// Plain columns of one line, from left to right. After a cell that is not plain, `good()` is false and the line has to
/// be read carefully. Cells behind the end of the line are 0.
class PlainColumns {
 public:
  explicit PlainColumns(std::string_view line) : line_(line) {}

  int integer(std::size_t width) {
    const std::size_t w = available(width);
    int value = 0;
    good_ = good_ && (w == 8 ? parse_plain_integer8(line_.data() + at_, value) ||
                                   parse_plain_integer(line_.data() + at_, w, value)
                             : parse_plain_integer(line_.data() + at_, w, value));
    at_ += w;
    return value;
  }

  double real(std::size_t width) {
    const std::size_t w = available(width);
    double value = 0.0;
    const char* const cell = line_.data() + at_;
    good_ = good_ && ((w == 16 && parse_fixed_point16(cell, value)) || parse_plain_real(cell, w, value));
    at_ += w;
    return value;
  }

  /// True if all cells were plain and nothing stands behind them.
  bool good() const { return good_ && (at_ == line_.size() || trimmed(line_.substr(at_)).empty()); }

 private:
  std::size_t available(std::size_t width) const { return at_ + width <= line_.size() ? width : line_.size() - at_; }

  std::string_view line_;
  std::size_t at_ = 0;
  bool good_ = true;
};

/// Reads single lines of a bulk block by card, with all checks, parameters and transforms of a Cursor.
class CarefulLines {
 public:
  CarefulLines(const Deck& deck, const Block& bulk, Findings& findings)
      : block_{bulk.keyword, bulk.place, bulk.format, bulk.transform, bulk.file, bulk.scope, {}, {}, 0},
        cursor_(deck, block_, findings),
        reads_every_line_(deck.reports_bulk_lines) {}
  CarefulLines(const CarefulLines&) = delete;
  CarefulLines& operator=(const CarefulLines&) = delete;

  template <class T>
  RowOf<T> read(const CardOf<T>& card, std::string_view line, int number) {
    block_.lines.push_back({line, number});
    return cursor_.read(card);
  }
  /// Every line is to be read here, since each is reported (Deck::card_read).
  bool reads_every_line() const { return reads_every_line_; }

 private:
  Block block_;
  Cursor cursor_;
  bool reads_every_line_;
};

/// Ids of a bulk block moved by its transform.
class IdOffset {
 public:
  IdOffset(const Block& block, IdSpace space)
      : offset_(block.transform == nullptr ? 0 : block.transform->id_offset[static_cast<std::size_t>(space)]) {}
  /// `id` moved away from 0; 0 stays. False if it no longer is an int.
  bool apply(int& id) const {
    if (offset_ == 0 || id == 0) return true;
    const long moved = id > 0 ? id + offset_ : id - offset_;
    id = static_cast<int>(moved);
    return id == moved;
  }

 private:
  long offset_;
};

/// Columns of an integer of the tables that have eight in standard format.
inline std::size_t id_width(Format format) {
  return format == Format::standard ? 8 : format == Format::i10 ? 10 : 20;
}
/// Columns of a real that has sixteen in standard format.
inline std::size_t real_width(Format format) {
  return format == Format::long_format ? 20 : 16;
}

}  // namespace nugget::deck
