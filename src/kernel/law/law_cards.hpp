// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "base/card.hpp"

// The cards of a plain law, one whose parameters are numbers on its cards: they stand in the law's own file, as
// `static LawCards<Law> cards()` of its parameters, and reading/cards/plain_laws.cpp reads them all in the same way.
// Laws with curves, tables or axes have a card file of their own in reading/cards.
namespace nugget::kernel {

/// What the parameters of a law must fulfil beyond the range of each.
template <class Law>
struct LawDemand {
  bool (*holds)(const Law&);
  double Law::*parameter;              ///< whose field the error names where it does not hold
  std::string_view otherwise, remedy;  ///< of that error
};

template <class Law>
struct LawCards {
  std::string_view name;                    ///< of the keyword: MAT_...
  std::vector<std::string_view> aliases{};  ///< MAT_024
  /// Card by card. The first begins with the material's id, and of a law its density, which are not listed here. A
  /// field that is bound to no parameter is read and checked, and has no effect.
  std::vector<CardOf<Law>> cards;
  void (*complete)(Law&) = nullptr;  ///< sets the parameters that follow from those on the cards
  std::vector<LawDemand<Law>> demands{};
};

/// Laws that have such cards.
template <class Law>
concept LawWithCards = requires {
  Law::cards();
};

// Fields that many laws have.
namespace law_field {
inline constexpr RealField young = real("e", dimension::stress, required, above_zero(), "Young's modulus");
inline constexpr RealField poisson = real("pr", dimension::number, 0, between(0, 0.5), "Poisson's ratio");
inline constexpr RealField compressible =
    real("pr", dimension::number, required, between(0, 0.499999), "Poisson's ratio, below 0.5");
inline constexpr RealField reference = real("ref", dimension::number, 0, only(0), "stress from a reference geometry");
}  // namespace law_field

}  // namespace nugget::kernel
