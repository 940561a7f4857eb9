// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/finding.hpp"

// The parameters of a deck and when each value holds.
namespace nugget::deck {

/// One definition of a parameter. It is visible from the moment `from` until the moment `to`.
struct Parameter {
  char type = 'R';      ///< R, I or C
  double number = 0.0;  ///< R and I
  std::string text;     ///< C: as written
  Place place;
  std::string_view cell{};  ///< with its value, in the text of its file; empty: an expression
  std::size_t width = 0;    ///< columns of that cell; 0: it ends with a comma
  bool changeable = false;  ///< may be defined again (_MUTABLE)
  int depth = 0;            ///< of _LOCAL: how deep its file lies in the includes (the master file: 1); else 0
  int hidden = -1;          ///< index in the history of what it hides until its file ends; -1: nothing
  std::size_t from = 0;
  std::size_t to = std::numeric_limits<std::size_t>::max();
};

/// All definitions with their history, so that a card read late still sees the values of its own place in the deck. A
/// moment is a count of changes; Block::scope is the moment at which the block was met.
class Parameters {
 public:
  std::size_t now() const { return now_; }
  /// What `name` (any case) means at a moment; null where it is not defined.
  const Parameter* find(std::string_view name, std::size_t moment) const;
  /// From now on `name` means this. A deeper _LOCAL one hides what was visible; any other takes its place, and its
  /// depth.
  void define(std::string_view name, Parameter parameter);
  /// Ends the _LOCAL parameters of the file at `depth`; what they hid is visible again.
  void leave_file(int depth);
  /// All of them by lower-case name, each with its definitions in their order.
  const std::map<std::string, std::vector<Parameter>, std::less<>>& histories() const { return histories_; }

 private:
  std::map<std::string, std::vector<Parameter>, std::less<>> histories_;  // by lower-case name, in the order of `from`
  std::size_t now_ = 0;
};

/// A numeric cell's meaning.
struct Value {
  enum class Fault { none, not_a_number, unknown_parameter, text_parameter };
  Fault fault = Fault::none;
  double number = 0.0;
  std::string parameter;  ///< the name, where the text is `&name` or `-&name`
};
/// Reads a trimmed, nonblank text: a number or a parameter with all its digits.
Value evaluate(std::string_view text, const Parameters& parameters, std::size_t moment);

/// `text` with every `&name` replaced by its value. Unknown names stay as they are and are listed in `unknown`.
std::string substituted(std::string_view text, const Parameters& parameters, std::size_t moment,
                        std::vector<std::string>* unknown = nullptr);

}  // namespace nugget::deck
