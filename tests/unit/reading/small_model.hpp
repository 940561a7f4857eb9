// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "reading/build.hpp"
#include "reading/builder/builder.hpp"

// Decks of a few nodes, made into models.
namespace nugget::reading {

struct Built {
  Findings findings;
  Model model;

  explicit Built(const std::string& deck_text, bool skip_unsupported = false) {
    const deck::Deck deck = deck::read_text(deck_text, findings);
    model = build(deck, findings, skip_unsupported);
  }

  /// A finding of this severity whose text or remedy holds `part`, on a field of that name (any where empty).
  const Finding* find(Severity severity, std::string_view part, std::string_view field = {}) const {
    for (const Finding& f : findings.all())
      if (f.severity == severity && (f.text + f.remedy).find(part) != std::string::npos &&
          (field.empty() || f.field == field))
        return &f;
    return nullptr;
  }
  bool error(std::string_view part, std::string_view field = {}) const { return find(Severity::error, part, field); }
  bool warning(std::string_view part, std::string_view field = {}) const {
    return find(Severity::warning, part, field);
  }
  std::string all_findings() const {
    std::string text;
    for (const Finding& f : findings.all()) text += to_string(f) + '\n';
    return text;
  }
};

/// Three unit squares in the plane z = 0, side by side along x and not joined: nodes 1..4 of elastic part 1, 5..8 of
/// rigid part 2, 9..12 of rigid part 3; node 20 stands free at (0, 0, 5), kept busy by a point mass. Square k begins at
/// x = 2 (k - 1). `more` comes behind it; `rigid` is the second card of the *MAT_RIGID.
inline std::string small_deck(std::string_view more, std::string_view rigid = "       0.0         0         0") {
  return std::string(R"(*KEYWORD
*CONTROL_TERMINATION
       1.0
*PART
sheet
         1         1         1
*PART
block
         2         1         2
*PART
lid
         3         1         2
*SECTION_SHELL
         1         2       1.0         3
       1.0
*MAT_ELASTIC
         1   7.85E-9  210000.0       0.3
*MAT_RIGID
         2   7.85E-9  210000.0       0.3
)") + std::string(rigid) +
         R"(

*NODE
       1             0.0             0.0             0.0
       2             1.0             0.0             0.0
       3             1.0             1.0             0.0
       4             0.0             1.0             0.0
       5             2.0             0.0             0.0
       6             3.0             0.0             0.0
       7             3.0             1.0             0.0
       8             2.0             1.0             0.0
       9             4.0             0.0             0.0
      10             5.0             0.0             0.0
      11             5.0             1.0             0.0
      12             4.0             1.0             0.0
      20             0.0             0.0             5.0
*ELEMENT_SHELL
       1       1       1       2       3       4
       2       2       5       6       7       8
       3       3       9      10      11      12
*ELEMENT_MASS
       1      20          1.0e-3
*DEFINE_CURVE
         7
                 0.0                 2.0
                 1.0                 4.0
*SET_NODE_LIST
         1
         1         2         3
*SET_PART_LIST
         1
         1
)" + std::string(more) +
         "*END\n";
}

/// The small deck with sheet 4 (nodes 31 to 34) above its sheet 1 by 1.2, location nodes 51 and 52 between them in set
/// 7, and `more`: joints without elements.
inline std::string deck_of_two_sheets(std::string_view more) {
  return small_deck(std::string(R"(*PART
above
         4         1         1
*NODE
      31             0.0             0.0             1.2
      32             1.0             0.0             1.2
      33             1.0             1.0             1.2
      34             0.0             1.0             1.2
      51             0.4             0.5             0.6
      52             0.6             0.5             0.6
*ELEMENT_SHELL
       4       4      31      32      33      34
*SET_NODE_LIST
         7
        52        51
)") + std::string(more));
}

}  // namespace nugget::reading
