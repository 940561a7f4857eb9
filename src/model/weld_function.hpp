// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "base/formula.hpp"
#include "model/parts.hpp"

// Numbers of a weld that a *DEFINE_FUNCTION makes of both its sheets: PROPRUL 2 of *DEFINE_CONNECTION_PROPERTIES and
// MODEL 11 of *CONSTRAINED_INTERPOLATION_SPOTWELD (docs/theory/failure.md#functions-of-both-sheets).
namespace nugget::model {

struct WeldedSheet {
  double thickness = 0.0;  ///< [length]
  double yield = 0.0;      ///< at a plastic strain of 0.002, at rest [stress]; 0: it does not yield
  double strength = 0.0;   ///< largest engineering stress, where it necks [stress]
  double young = 0.0;      ///< [stress]

  bool operator==(const WeldedSheet&) const = default;
};
WeldedSheet welded_sheet(const Material& material, double thickness);

struct WeldFunctionInput {
  std::array<WeldedSheet, 2> sheet;
  double rate = 0.0;  ///< effective strain rate of the weld [1/time]
  double area = 0.0;  ///< of its cross-section [area]
};

/// The names of a function's arguments, in their order. The last ones may be missing.
inline constexpr std::array<std::string_view, 10> weld_function_names{"t1",  "t2", "sy1", "sy2", "sm1",
                                                                      "sm2", "r",  "a",   "e1",  "e2"};
inline constexpr std::size_t rate_argument = 6;

/// What is wrong with a function's arguments; empty: nothing.
std::string wrong_arguments(const Formula& function);
/// Whether it asks for the yield stress or the strength of a sheet.
bool asks_for_yield(const Formula& function);
double value_of(const Formula& function, const WeldFunctionInput& input);

}  // namespace nugget::model
