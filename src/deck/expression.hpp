// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "deck/parameters.hpp"

// The expressions of *PARAMETER_EXPRESSION and *DEFINE_CURVE_FUNCTION.
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

/// The same without integers and parameters, at a time: names are TIME, PI, DTOR (PI / 180) and RTOD, in capitals or
/// not; functions besides are
///   IF(x: a, b, c)             a, b, c where x is below, at, above 0
///   STEP(x, x0, h0, x1, h1)    from h0 to h1 by a cubic without slope at x0 and x1
///   HAVSIN(x, x0, h0, x1, h1)  the same by half a wave of a sine
///   POLY(x, x0, a0, a1, ...)   sum of a_i (x - x0)^i
///   SHF(x, x0, a, w, phi, b)   a sin(w (x - x0) - phi) + b; phi and b may be left out
ExpressionResult evaluate_function_of_time(std::string_view text, double time);

}  // namespace nugget::deck
