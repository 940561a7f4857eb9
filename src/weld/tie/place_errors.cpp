// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/place_errors.hpp"

#include <algorithm>
#include <array>

namespace nugget::weld {
namespace {

struct Measured {
  double up_to;  ///< reach
  PlaceErrors errors;
};
/// None is smaller than at a smaller reach.
constexpr std::array<Measured, 5> measured{{
    {1.7, {0.05, 0.14, 0.02, 0.06, 0.14}},
    {2.1, {0.05, 0.18, 0.02, 0.06, 0.14}},
    {2.8, {0.05, 0.37, 0.13, 0.07, 0.14}},
    {3.3, {0.06, 0.37, 0.15, 0.08, 0.17}},
    {4.5, {0.10, 0.37, 0.24, 0.08, 0.31}},
}};

}  // namespace

const PlaceErrors* place_errors(double reach) {
  const auto found =
      std::find_if(measured.begin(), measured.end(), [reach](const Measured& m) { return reach <= m.up_to; });
  return found == measured.end() ? nullptr : &found->errors;
}

}  // namespace nugget::weld
