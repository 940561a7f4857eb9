// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace nugget {

/// Where in the deck something stands. `line` and `column` count from 1; 0 means "not known" (the whole file, the whole
/// line).
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

enum class Severity { note, warning, error };

/// One remark on the input. Errors refuse the deck (exit code 1); warnings and notes do not.
/// Printed as `FILE:LINE:COLUMN: severity: KEYWORD field = value: text [remedy]`.
struct Finding {
  Severity severity = Severity::error;
  Place place;
  std::string keyword;  ///< with its star, e.g. `*MAT_024`; empty where none applies
  std::string field;    ///< the card's own field name, lower case (`pr`); may be empty
  std::string value;    ///< the text that stands in the field, trimmed; may be empty
  std::string text;     ///< what is wrong and what was expected
  std::string remedy;   ///< what to do; may be empty
};

std::string_view to_string(Severity severity);
std::string to_string(const Finding& finding);

/// All findings of a run, in the order they were made. Nothing throws for bad input: it is written down here.
class Findings {
 public:
  void add(Finding finding);
  /// Shorthands; `keyword` with its star.
  void error(Place place, std::string keyword, std::string text, std::string remedy = {});
  void warning(Place place, std::string keyword, std::string text, std::string remedy = {});
  void note(Place place, std::string keyword, std::string text, std::string remedy = {});

  const std::vector<Finding>& all() const { return findings_; }
  int errors() const { return errors_; }
  int warnings() const { return warnings_; }

 private:
  std::vector<Finding> findings_;
  int errors_ = 0;
  int warnings_ = 0;
};

/// "1 error, 2 warnings"
std::string totals(const Findings& findings);

}  // namespace nugget
