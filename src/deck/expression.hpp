// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "deck/parameters.hpp"

// The expressions of *PARAMETER_EXPRESSION.
namespace nugget::deck {

struct ExpressionResult {
  double value = 0.0;
  std::string fault;    ///< why there is no value; empty: there is one
  std::string warning;  ///< what the writer may not have meant; empty: nothing
};

/// Numbers, names of parameters with or without `&`, + - * / **, parentheses, and the functions abs aint anint atan
/// atan2 acos asin cos sin tan exp log log10 max min mod nint sign sqrt sinh cosh tanh int float. As in Fortran: **
/// binds tightest and to the right, -a**b is -(a**b), an integer by an integer divides to an integer; angles in
/// radians.
ExpressionResult evaluate_expression(std::string_view text, const Parameters& parameters, std::size_t moment);

}  // namespace nugget::deck
