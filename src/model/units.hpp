// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/card.hpp"
#include "model/model.hpp"

namespace nugget::model {

/// A consistent set of units.
struct Units {
  std::string_view name;           ///< length, mass, time: `mm, t, s`
  std::string_view force, stress;  ///< `N`, `MPa`
  std::string_view description;    ///< with force and stress: `mm t s (N, MPa)`
  double millimetre = 1.0;         ///< one millimetre [length]
  double microsecond = 1.0;        ///< [time]
  double newton = 1.0;             ///< [force]
  double metre_per_second = 1.0;
  double kilogram_per_cubic_metre = 1.0;
  double steel_density = 0.0;  ///< [mass/length^3]
  double steel_young = 0.0;    ///< [stress]
};

/// The sets that decks are written in, the commonest first.
std::span<const Units> unit_systems();

/// The set of that name; nothing where there is none.
std::optional<Units> units_named(std::string_view name);

/// A quantity's unit in that set, in the words of the field: `MPa`, `N mm`, `mm/s2`. Empty for a number.
std::string symbol(const Units& units, const Dimension& dimension);

/// Of frequencies, in cycles a unit of time: `Hz`, `kHz`.
std::string frequency_symbol(const Units& units);

/// Behind a number: ` N mm`. Empty where the units are not known, and of a number.
std::string unit_of(const std::optional<Units>& units, const Dimension& dimension);
/// The same of a frequency: ` Hz`.
std::string unit_of_frequency(const std::optional<Units>& units);
/// In a heading: ` [N mm]`, ` [Hz]`.
std::string in_units(const std::optional<Units>& units, const Dimension& dimension);
std::string in_frequency(const std::optional<Units>& units);

/// The units of a deck, from density and Young's modulus of most of its sheets: those in which they are a metal between
/// magnesium (0.23 and 0.21 of steel's) and lead or tungsten (1.5 and 2 of steel's). Nothing where none fits or there
/// are no sheets: a deck does not say its units.
std::optional<Units> recognise_units(const Model& model);

/// Those that the user gave (Model::units), else those recognised.
std::optional<Units> units_of(const Model& model);

}  // namespace nugget::model
