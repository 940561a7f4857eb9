// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "model/model.hpp"

namespace nugget::model {

/// A consistent set of units, known by what steel weighs and how stiff it is in it.
struct Units {
  std::string_view name;     ///< length, mass, time: `mm, t, s`
  double millimetre = 1.0;   ///< one millimetre [length]
  double density = 0.0;      ///< of steel [mass/length^3]
  double young = 0.0;        ///< of steel [stress]
  double newton = 1.0;       ///< one newton [force]
  double microsecond = 1.0;  ///< [time]
};

/// The units of a deck, from density and Young's modulus of most of its sheets: those in which they are a metal between
/// magnesium (0.23 and 0.21 of steel's) and lead or tungsten (1.5 and 2 of steel's). Nothing where none fits or there
/// are no sheets: a deck does not say its units.
std::optional<Units> recognise_units(const Model& model);

}  // namespace nugget::model
