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
constexpr std::array<Measured, 3> measured{{
    {2.0, {0.04, 0.17, 0.02, 0.10}},
    {3.0, {0.04, 0.37, 0.13, 0.14}},
    {4.0, {0.07, 0.23, 0.22, 0.20}},
}};

}  // namespace

const PlaceErrors* place_errors(double reach) {
  const auto found =
      std::find_if(measured.begin(), measured.end(), [reach](const Measured& m) { return reach <= m.up_to; });
  return found == measured.end() ? nullptr : &found->errors;
}

}  // namespace nugget::weld
