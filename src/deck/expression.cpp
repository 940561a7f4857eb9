// SPDX-License-Identifier: Apache-2.0
#include "deck/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "deck/numbers.hpp"
#include "deck/text.hpp"

namespace nugget::deck {
namespace {

struct Operand {
  double value = 0.0;
  bool whole = false;  ///< of Fortran's type integer
};

using Operands = std::vector<Operand>;

/// What a function's result is: an integer always, an integer when all arguments are, or a real always.
enum class Result { integer, as_arguments, real };

struct Function {
  std::string_view name;
  std::size_t least, most;  ///< number of arguments
  Result result;
  double (*apply)(const Operands&);
};

double first(const Operands& a) {
  return a[0].value;
}

/// How far `x` is on its way from x0 to x1, within 0 and 1.
double way(const Operands& a) {
  const double x = a[0].value, x0 = a[1].value, x1 = a[3].value;
  return x1 > x0 ? std::clamp((x - x0) / (x1 - x0), 0.0, 1.0) : x < x0 ? 0.0 : 1.0;
}

double polynomial(const Operands& a) {
  double sum = 0.0;
  for (std::size_t i = a.size() - 1; i >= 2; --i) sum = sum * (a[0].value - a[1].value) + a[i].value;
  return sum;
}

double harmonic(const Operands& a) {
  const auto at = [&](std::size_t i) { return i < a.size() ? a[i].value : 0.0; };
  return at(2) * std::sin(at(3) * (at(0) - at(1)) - at(4)) + at(5);
}

constexpr std::size_t any_number = 1000;
/// Of functions of time only.
const std::array functions_of_time{
    Function{"if", 4, 4, Result::real,
             [](const Operands& a) {
               return a[first(a) < 0.0 ? 1 : first(a) > 0.0 ? 3 : 2].value;
             }},
    Function{"step", 5, 5, Result::real,
             [](const Operands& a) {
               const double d = way(a);
               return a[2].value + (a[4].value - a[2].value) * d * d * (3.0 - 2.0 * d);
             }},
    Function{"havsin", 5, 5, Result::real,
             [](const Operands& a) {
               return a[2].value + 0.5 * (a[4].value - a[2].value) * (1.0 - std::cos(std::numbers::pi * way(a)));
             }},
    Function{"poly", 3, any_number, Result::real, polynomial},
    Function{"shf", 4, 6, Result::real, harmonic},
};
const std::array functions{
    Function{"abs", 1, 1, Result::as_arguments, [](const Operands& a) { return std::abs(first(a)); }},
    Function{"aint", 1, 1, Result::real, [](const Operands& a) { return std::trunc(first(a)); }},
    Function{"anint", 1, 1, Result::real, [](const Operands& a) { return std::round(first(a)); }},
    Function{"nint", 1, 1, Result::integer, [](const Operands& a) { return std::round(first(a)); }},
    Function{"int", 1, 1, Result::integer, [](const Operands& a) { return std::trunc(first(a)); }},
    Function{"float", 1, 1, Result::real, [](const Operands& a) { return first(a); }},
    Function{"atan", 1, 1, Result::real, [](const Operands& a) { return std::atan(first(a)); }},
    Function{"atan2", 2, 2, Result::real, [](const Operands& a) { return std::atan2(a[0].value, a[1].value); }},
    Function{"acos", 1, 1, Result::real, [](const Operands& a) { return std::acos(first(a)); }},
    Function{"asin", 1, 1, Result::real, [](const Operands& a) { return std::asin(first(a)); }},
    Function{"cos", 1, 1, Result::real, [](const Operands& a) { return std::cos(first(a)); }},
    Function{"sin", 1, 1, Result::real, [](const Operands& a) { return std::sin(first(a)); }},
    Function{"tan", 1, 1, Result::real, [](const Operands& a) { return std::tan(first(a)); }},
    Function{"exp", 1, 1, Result::real, [](const Operands& a) { return std::exp(first(a)); }},
    Function{"log", 1, 1, Result::real, [](const Operands& a) { return std::log(first(a)); }},
    Function{"log10", 1, 1, Result::real, [](const Operands& a) { return std::log10(first(a)); }},
    Function{"sqrt", 1, 1, Result::real, [](const Operands& a) { return std::sqrt(first(a)); }},
    Function{"sinh", 1, 1, Result::real, [](const Operands& a) { return std::sinh(first(a)); }},
    Function{"cosh", 1, 1, Result::real, [](const Operands& a) { return std::cosh(first(a)); }},
    Function{"tanh", 1, 1, Result::real, [](const Operands& a) { return std::tanh(first(a)); }},
    Function{"mod", 2, 2, Result::as_arguments, [](const Operands& a) { return std::fmod(a[0].value, a[1].value); }},
    Function{"sign", 2, 2, Result::as_arguments,
             [](const Operands& a) { return std::copysign(a[0].value, a[1].value); }},
    Function{"max", 2, any_number, Result::as_arguments,
             [](const Operands& a) {
               double m = first(a);
               for (const Operand& x : a) m = std::max(m, x.value);
               return m;
             }},
    Function{"min", 2, any_number, Result::as_arguments,
             [](const Operands& a) {
               double m = first(a);
               for (const Operand& x : a) m = std::min(m, x.value);
               return m;
             }},
};

/// Recursive descent over the text. After the first fault all rules return at once.
class Parser {
 public:
  Parser(std::string_view text, const Parameters& parameters, std::size_t moment)
      : rest_(text), parameters_(&parameters), moment_(moment) {}

  /// A function of time.
  Parser(std::string_view text, double time) : rest_(text), time_(time) {}

  ExpressionResult run() {
    const Operand result = sum();
    skip_blanks();
    if (!rest_.empty()) fail(fmt::format("'{}' is not expected here", rest_.substr(0, 12)));
    if (fault_.empty() && !std::isfinite(result.value)) fault_ = "the result is not a finite number";
    return {result.value, fault_, warning_};
  }

 private:
  static constexpr int deepest = 100;  ///< nested parentheses and signs; bounds the stack

  Operand sum() {
    Operand a = product();
    while (fault_.empty()) {
      if (take("+")) {
        a = combined(a, product(), [](double x, double y) { return x + y; });
      } else if (take("-")) {
        a = combined(a, product(), [](double x, double y) { return x - y; });
      } else {
        break;
      }
    }
    return a;
  }

  Operand product() {
    Operand a = signed_power();
    while (fault_.empty()) {
      if (next_is_power()) break;
      if (take("*")) {
        a = combined(a, signed_power(), [](double x, double y) { return x * y; });
      } else if (take("/")) {
        a = quotient(a, signed_power());
      } else {
        break;
      }
    }
    return a;
  }

  Operand signed_power() {
    const Nested nested(*this);
    if (take("-")) {
      const Operand a = signed_power();
      return {-a.value, a.whole};
    }
    if (take("+")) return signed_power();
    const Operand base = primary();
    if (!next_is_power()) return base;
    take("**");
    const Operand exponent = signed_power();  // right to left
    const double value = std::pow(base.value, exponent.value);
    const bool whole = base.whole && exponent.whole;
    return {whole ? std::trunc(value) : value, whole};
  }

  Operand primary() {
    skip_blanks();
    if (!fault_.empty()) return {};
    if (take("(")) return closed(sum());
    if (!rest_.empty() && (is_digit(rest_.front()) || rest_.front() == '.')) return literal();
    const bool reference = take("&");
    const std::string_view name = take_name();
    if (name.empty()) {
      fail(rest_.empty() ? "the expression ends too early"
                         : fmt::format("'{}' is not expected here", rest_.substr(0, 12)));
      return {};
    }
    if (!reference && take("(")) return call(name);
    return parameter(name);
  }

  Operand literal() {
    std::size_t n = 0;
    const auto digits = [&] {
      while (n < rest_.size() && is_digit(rest_[n])) ++n;
    };
    digits();
    bool whole = !time_;
    if (n < rest_.size() && rest_[n] == '.') {
      whole = false;
      ++n;
      digits();
    }
    if (n < rest_.size() && std::string_view("eEdD").find(rest_[n]) != std::string_view::npos) {
      whole = false;
      ++n;
      if (n < rest_.size() && (rest_[n] == '+' || rest_[n] == '-')) ++n;
      digits();
    }
    Operand a{0.0, whole};
    const std::string_view text = rest_.substr(0, n);
    rest_.remove_prefix(n);
    if (!parse_real(text, a.value)) fail(fmt::format("'{}' is not a number", text));
    return a;
  }

  Operand variable(std::string_view name) {
    const std::string known = lower(name);
    if (known == "time") return {*time_, false};
    if (known == "pi") return {std::numbers::pi, false};
    if (known == "dtor") return {std::numbers::pi / 180.0, false};
    if (known == "rtod") return {180.0 / std::numbers::pi, false};
    fail(fmt::format("'{}' is not known: a function of TIME is built", name));
    return {};
  }

  Operand parameter(std::string_view name) {
    if (time_) return variable(name);
    const Parameter* p = parameters_->find(name, moment_);
    if (p == nullptr) {
      fail(fmt::format("the parameter '{}' is not defined before this line", name));
    } else if (p->type == 'C') {
      fail(fmt::format("the parameter '{}' is a text, not a number", name));
    } else {
      return {p->number, p->type == 'I'};
    }
    return {};
  }

  template <class List>
  static const Function* find(const List& list, std::string_view name) {
    const auto f = std::find_if(list.begin(), list.end(), [&](const Function& g) { return g.name == lower(name); });
    return f == list.end() ? nullptr : &*f;
  }

  Operand call(std::string_view name) {
    const Nested nested(*this);
    Operands arguments;
    do {
      arguments.push_back(sum());
    } while (fault_.empty() && (take(",") || (time_ && arguments.size() == 1 && take(":"))));
    closed({});
    if (!fault_.empty()) return {};
    const Function* f = find(functions, name);
    if (f == nullptr && time_) f = find(functions_of_time, name);
    if (f == nullptr) {
      fail(fmt::format("the function '{}' is not known", name));
      return {};
    }
    if (arguments.size() < f->least || arguments.size() > f->most) {
      fail(fmt::format("{} takes {} argument(s), not {}", f->name, f->least, arguments.size()));
      return {};
    }
    const bool all_whole = std::all_of(arguments.begin(), arguments.end(), [](const Operand& a) { return a.whole; });
    const Operand a{f->apply(arguments),
                    f->result == Result::integer || (f->result == Result::as_arguments && all_whole)};
    if (!std::isfinite(a.value)) fail(fmt::format("{} has no value for these arguments", f->name));
    return a;
  }

  Operand quotient(const Operand& a, const Operand& b) {
    if (!fault_.empty()) return {};
    if (b.value == 0.0) {
      fail("division by zero");
      return {};
    }
    const double q = a.value / b.value;
    if (!a.whole || !b.whole) return {q, false};
    if (q != std::trunc(q)) {
      warning_ =
          fmt::format("integers divide to an integer: {:.0f}/{:.0f} gives {:.0f}", a.value, b.value, std::trunc(q));
    }
    return {std::trunc(q), true};
  }

  template <class Operation>
  static Operand combined(const Operand& a, const Operand& b, Operation operation) {
    return {operation(a.value, b.value), a.whole && b.whole};
  }

  Operand closed(const Operand& inner) {
    if (fault_.empty() && !take(")")) fail("a closing parenthesis is missing");
    return inner;
  }

  void skip_blanks() { rest_ = trimmed(rest_); }

  bool take(std::string_view token) {
    skip_blanks();
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }

  bool next_is_power() {
    skip_blanks();
    return rest_.starts_with("**");
  }

  std::string_view take_name() {
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_name_character);
    const std::string_view name = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
    rest_.remove_prefix(name.size());
    return name;
  }

  void fail(std::string text) {
    if (fault_.empty()) fault_ = std::move(text);
    rest_ = {};
  }

  struct Nested {
    explicit Nested(Parser& p) : parser(p) {
      if (++parser.depth_ > deepest) parser.fail("the expression is nested too deeply");
    }
    ~Nested() { --parser.depth_; }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;
    Parser& parser;
  };

  std::string_view rest_;
  const Parameters* parameters_ = nullptr;
  std::size_t moment_ = 0;
  std::optional<double> time_;
  std::string fault_, warning_;
  int depth_ = 0;
};

}  // namespace

ExpressionResult evaluate_expression(std::string_view text, const Parameters& parameters, std::size_t moment) {
  return Parser(text, parameters, moment).run();
}

ExpressionResult evaluate_function_of_time(std::string_view text, double time) {
  return Parser(text, time).run();
}

}  // namespace nugget::deck
