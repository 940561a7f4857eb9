// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nugget {

/// A function of numbers that is written as text, as *DEFINE_FUNCTION has it:
///     f(x, y) = 2.0 * x + max(y, 0.0)
/// or in the manner of C, without loops and pointers:
///     float f(float x, float y) {
///       float s = x * x;
///       if (s > y && y > 0.0) return 1.0;
///       return s / 2.0;
///     }
/// Types are float, double and int (whose values are cut to whole numbers); + - * / += -= *= /= < <= > >= == != && || !
/// ?: and the functions of C: abs fabs sqrt exp log log10 pow sin cos tan asin acos atan atan2 sinh cosh tanh floor
/// ceil fmod min max fmin fmax. A division of whole numbers, which C would cut, is a fault. Angles in radians. Names
/// keep their case. A variable that nothing was given to is 0.
class Formula {
 public:
  struct Fault {
    std::string text;    ///< what is wrong; empty: nothing
    std::size_t at = 0;  ///< where in the text
    bool any() const { return !text.empty(); }
  };
  /// A formula of no use where there is a fault.
  static Formula read(std::string_view text, Fault& fault);

  const std::string& name() const { return name_; }
  int arguments() const { return static_cast<int>(argument_names_.size()); }
  const std::vector<std::string>& argument_names() const { return argument_names_; }
  /// Whether the value may depend on that argument.
  bool uses(std::size_t argument) const;
  /// As many as `arguments()`. Allocates nothing, ends in any case.
  double operator()(std::span<const double> arguments) const;

 private:
  friend class FormulaReader;
  static constexpr int most_values = 64;  ///< arguments and variables
  static constexpr int deepest = 64;      ///< values that wait while an expression is worked out

  enum class Op : unsigned char {
    number,
    load,
    store,
    add,
    subtract,
    multiply,
    divide,
    less,
    at_most,
    equal,
    negate,
    negate_truth,
    truncate,
    call,
    call_of_two,
    jump,
    jump_if_zero,
    leave
  };
  struct Step {
    Op op = Op::leave;
    int index = 0;  ///< of a value, or the step that is jumped to
    double number = 0.0;
    double (*function)(double) = nullptr;
    double (*function_of_two)(double, double) = nullptr;
  };
  std::string name_;
  std::vector<std::string> argument_names_;
  std::vector<Step> steps_;
};

}  // namespace nugget
