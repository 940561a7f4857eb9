// SPDX-License-Identifier: Apache-2.0
#include "base/formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/index.hpp"

namespace nugget {
namespace {

struct NamedFunction {
  std::string_view name;
  double (*of_one)(double);
};
struct NamedFunctionOfTwo {
  std::string_view name;
  double (*of_two)(double, double);
};

constexpr std::array<NamedFunction, 17> functions{{
    {"abs", [](double x) { return std::abs(x); }},
    {"fabs", [](double x) { return std::abs(x); }},
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"exp", [](double x) { return std::exp(x); }},
    {"log", [](double x) { return std::log(x); }},
    {"log10", [](double x) { return std::log10(x); }},
    {"sin", [](double x) { return std::sin(x); }},
    {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},
    {"asin", [](double x) { return std::asin(x); }},
    {"acos", [](double x) { return std::acos(x); }},
    {"atan", [](double x) { return std::atan(x); }},
    {"sinh", [](double x) { return std::sinh(x); }},
    {"cosh", [](double x) { return std::cosh(x); }},
    {"tanh", [](double x) { return std::tanh(x); }},
    {"floor", [](double x) { return std::floor(x); }},
    {"ceil", [](double x) { return std::ceil(x); }},
}};
constexpr std::array<NamedFunctionOfTwo, 7> functions_of_two{{
    {"pow", [](double x, double y) { return std::pow(x, y); }},
    {"atan2", [](double x, double y) { return std::atan2(x, y); }},
    {"fmod", [](double x, double y) { return std::fmod(x, y); }},
    {"min", [](double x, double y) { return std::min(x, y); }},
    {"max", [](double x, double y) { return std::max(x, y); }},
    {"fmin", [](double x, double y) { return std::fmin(x, y); }},
    {"fmax", [](double x, double y) { return std::fmax(x, y); }},
}};

bool begins_name(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}
bool in_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

}  // namespace

/// Recursive descent from text to steps. After the first fault all rules return at once.
class FormulaReader {
 public:
  FormulaReader(std::string_view text, Formula::Fault& fault) : text_(text), fault_(fault) {}

  Formula run() {
    type();
    formula_.name_ = new_name("the name of the function");
    parameters();
    for (const Value& argument : values_) formula_.argument_names_.push_back(argument.name);
    if (take("=")) {
      expression();
      emit({Op::leave});
      take(";");
    } else if (!fault_.any() && !block()) {
      fail("not every way through the function ends in return");
    }
    skip_blanks();
    if (at_ < text_.size()) fail("the end of the function is expected here");
    return std::move(formula_);
  }

 private:
  using Op = Formula::Op;
  using Step = Formula::Step;
  static constexpr int nested_most = 100;  ///< parentheses, signs, blocks; bounds the stack of this program

  struct Value {
    std::string name;
    bool whole = false;
  };
  /// What an expression gives: a number of C's type int, or any.
  struct Type {
    bool whole = false;
  };

  // ---- text

  void fail(std::string text) {
    if (!fault_.any()) fault_ = {std::move(text), at_};
  }
  void skip_blanks() {
    while (at_ < text_.size()) {
      const std::string_view rest = text_.substr(at_);
      if (std::isspace(static_cast<unsigned char>(rest.front())))
        ++at_;
      else if (rest.starts_with("//"))
        at_ = std::min(text_.size(), text_.find('\n', at_));
      else if (rest.starts_with("/*"))
        at_ = std::min(text_.size(),
                       text_.find("*/", at_) == std::string_view::npos ? text_.size() : text_.find("*/", at_) + 2);
      else
        return;
    }
  }
  bool next_is(std::string_view token) {
    skip_blanks();
    if (fault_.any() || !text_.substr(at_).starts_with(token)) return false;
    const std::size_t end = at_ + token.size();
    if (begins_name(token.front())) return end >= text_.size() || !in_name(text_[end]);
    // `=` is not the beginning of `==`, nor `<` of `<=`.
    return token.size() > 1 || token == "(" || token == ")" || end >= text_.size() || text_[end] != '=' ||
           std::string_view("=<>!+-*/").find(token.front()) == std::string_view::npos;
  }
  bool take(std::string_view token) {
    if (!next_is(token)) return false;
    at_ += token.size();
    return true;
  }
  void expect(std::string_view token) {
    if (!take(token) && !fault_.any()) fail(fmt::format("'{}' is expected here", token));
  }
  std::string name() {
    skip_blanks();
    if (fault_.any() || at_ >= text_.size() || !begins_name(text_[at_])) return {};
    const std::size_t begin = at_;
    while (at_ < text_.size() && in_name(text_[at_])) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }
  std::string new_name(std::string_view what) {
    std::string found = name();
    if (found.empty()) fail(fmt::format("{} is expected here", what));
    return found;
  }
  /// `float`, `double` or `int`, or nothing; true: of whole numbers.
  bool type() {
    if (take("int")) return true;
    if (!take("float")) take("double");
    return false;
  }
  bool next_is_type() { return next_is("int") || next_is("float") || next_is("double"); }

  // ---- steps

  int emit(Step step, int change = 0) {
    depth_ += change;
    if (depth_ > Formula::deepest) fail("the expression is too long");
    formula_.steps_.push_back(step);
    return static_cast<int>(formula_.steps_.size()) - 1;
  }
  int here() const { return static_cast<int>(formula_.steps_.size()); }
  void land(int jump) { formula_.steps_[jump].index = here(); }

  // ---- values

  int add_value(const std::string& of, bool whole) {
    if (find(of) >= 0) fail(fmt::format("'{}' is there already", of));
    if (values_.size() >= Formula::most_values) fail("too many variables");
    values_.push_back({of, whole});
    return static_cast<int>(values_.size()) - 1;
  }
  int find(std::string_view of) const {
    const auto found = std::ranges::find(values_, of, &Value::name);
    return found == values_.end() ? -1 : static_cast<int>(found - values_.begin());
  }
  void parameters() {
    expect("(");
    if (take(")")) return;
    do {
      const bool whole = type();
      add_value(new_name("the name of an argument"), whole);
    } while (take(","));
    expect(")");
  }
  /// What stands on the stack into a value.
  void store(int value, Type from) {
    if (values_[value].whole && !from.whole) emit({Op::truncate});
    emit({Op::store, value}, -1);
  }

  // ---- statements; true: the function always returns in them

  bool block() {
    const Nested nested(*this);
    expect("{");
    bool returns = false;
    while (!fault_.any() && !take("}")) returns = statement() || returns;
    return returns;
  }
  bool statement() {
    const Nested nested(*this);
    if (next_is("{")) return block();
    if (take(";")) return false;
    if (take("if")) return choice();
    if (take("return")) {
      expression();
      emit({Op::leave}, -1);
      expect(";");
      return true;
    }
    if (next_is_type())
      declarations();
    else
      assignment();
    expect(";");
    return false;
  }
  bool choice() {
    expect("(");
    expression();
    expect(")");
    const int past = emit({Op::jump_if_zero}, -1);
    const bool then = statement();
    if (!take("else")) {
      land(past);
      return false;
    }
    const int end = emit({Op::jump});
    land(past);
    const bool otherwise = statement();
    land(end);
    return then && otherwise;
  }
  void declarations() {
    const bool whole = type();
    do {
      const int value = add_value(new_name("the name of a variable"), whole);
      if (fault_.any()) return;
      if (take("=")) store(value, expression());
    } while (take(","));
  }
  void assignment() {
    const std::size_t begin = at_;
    const std::string to = new_name("a statement");
    const int value = find(to);
    if (value < 0) {
      at_ = fault_.any() ? at_ : begin;
      return fail(fmt::format("'{}' is no variable", to));
    }
    for (const auto& [token, op] : {std::pair{"+=", Op::add}, std::pair{"-=", Op::subtract},
                                    std::pair{"*=", Op::multiply}, std::pair{"/=", Op::divide}})
      if (take(token)) {
        emit({Op::load, value}, 1);
        const Type right = expression();
        return store(value, combined(op, {values_[value].whole}, right));
      }
    expect("=");
    store(value, expression());
  }

  // ---- expressions; each leaves one value on the stack

  Type expression() {
    const Nested nested(*this);
    const Type condition = alternatives();
    if (!take("?")) return condition;
    const int past = emit({Op::jump_if_zero}, -1);
    const Type then = expression();
    const int end = emit({Op::jump}, -1);  // the other way has its own value
    expect(":");
    land(past);
    const Type otherwise = expression();
    land(end);
    return {then.whole && otherwise.whole};
  }
  /// `a || b` is 1 or 0, and b is not worked out where a says it all.
  Type alternatives() {
    Type a = conditions();
    while (take("||")) {
      emit({Op::negate_truth});
      const int past = emit({Op::jump_if_zero}, -1);
      conditions();
      emit({Op::negate_truth});
      emit({Op::negate_truth});
      const int end = emit({Op::jump}, -1);
      land(past);
      number(1.0);
      land(end);
      a = {true};
    }
    return a;
  }
  Type conditions() {
    Type a = comparison();
    while (take("&&")) {
      const int past = emit({Op::jump_if_zero}, -1);
      comparison();
      emit({Op::negate_truth});
      emit({Op::negate_truth});
      const int end = emit({Op::jump}, -1);
      land(past);
      number(0.0);
      land(end);
      a = {true};
    }
    return a;
  }
  Type comparison() {
    Type a = sum();
    for (;;) {
      // a > b is not (a <= b) of numbers; of what is none both are false, so it is b < a that is asked.
      if (take("<=")) {
        sum();
        emit({Op::at_most}, -1);
      } else if (take(">=")) {
        sum();
        emit({Op::at_most, 1}, -1);
      } else if (take("==")) {
        sum();
        emit({Op::equal}, -1);
      } else if (take("!=")) {
        sum();
        emit({Op::equal}, -1);
        emit({Op::negate_truth});
      } else if (take("<")) {
        sum();
        emit({Op::less}, -1);
      } else if (take(">")) {
        sum();
        emit({Op::less, 1}, -1);
      } else {
        return a;
      }
      a = {true};
    }
  }
  Type sum() {
    Type a = product();
    for (;;) {
      if (take("+"))
        a = combined(Op::add, a, product());
      else if (take("-"))
        a = combined(Op::subtract, a, product());
      else
        return a;
    }
  }
  Type product() {
    Type a = sign();
    for (;;) {
      if (next_is("**")) fail("'**' is no operator here; write pow(a, b)");
      if (take("*"))
        a = combined(Op::multiply, a, sign());
      else if (take("/"))
        a = combined(Op::divide, a, sign());
      else
        return a;
    }
  }
  Type combined(Op op, Type a, Type b) {
    if (op == Op::divide && a.whole && b.whole) fail("whole numbers are divided, which C cuts; write 1.0 instead of 1");
    emit({op}, -1);
    return {a.whole && b.whole};
  }
  Type sign() {
    const Nested nested(*this);
    if (take("+")) return sign();
    if (take("-")) {
      const Type a = sign();
      emit({Op::negate});
      return a;
    }
    if (take("!")) {
      sign();
      emit({Op::negate_truth});
      return {true};
    }
    return primary();
  }
  Type primary() {
    if (take("(")) {
      const Type a = expression();
      expect(")");
      return a;
    }
    skip_blanks();
    if (at_ < text_.size() && (std::isdigit(static_cast<unsigned char>(text_[at_])) || text_[at_] == '.'))
      return literal();
    const std::size_t begin = at_;
    const std::string of = name();
    if (of.empty()) {
      fail(at_ < text_.size() ? "a number, a name or '(' is expected here" : "the function ends too early");
      return {};
    }
    if (take("(")) return call(of, begin);
    const int value = find(of);
    if (value < 0) {
      at_ = begin;
      fail(fmt::format("'{}' is no argument and no variable", of));
      return {};
    }
    emit({Op::load, value}, 1);
    return {values_[value].whole};
  }
  Type literal() {
    double value = 0.0;
    const char *begin = text_.data() + at_, *end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc{}) fail("this is no number");
    const std::string_view written(begin, static_cast<std::size_t>(stop - begin));
    at_ += written.size();
    if (at_ < text_.size() && (text_[at_] == 'f' || text_[at_] == 'F')) ++at_;
    number(value);
    return {written.find_first_of(".eE") == std::string_view::npos};
  }
  void number(double value) { emit({Op::number, 0, value}, 1); }
  Type call(const std::string& of, std::size_t begin) {
    int count = 0;
    Type whole{true};
    do {
      whole = {expression().whole && whole.whole};
      ++count;
    } while (take(","));
    expect(")");
    const auto f = std::ranges::find(functions, of, &NamedFunction::name);
    if (f != functions.end() && count == 1) {
      emit({Op::call, 0, 0.0, f->of_one});
      return {of == "abs" && whole.whole};
    }
    const auto g = std::ranges::find(functions_of_two, of, &NamedFunctionOfTwo::name);
    if (g != functions_of_two.end() && count == 2) {
      emit({Op::call_of_two, 0, 0.0, nullptr, g->of_two}, -1);
      return {(of == "min" || of == "max") && whole.whole};
    }
    at_ = begin;
    fail(f != functions.end() || g != functions_of_two.end() ? fmt::format("'{}' does not take {} numbers", of, count)
                                                             : fmt::format("'{}' is no function that is known", of));
    return {};
  }

  /// Counts what is open; too deep is a fault.
  struct Nested {
    explicit Nested(FormulaReader& r) : reader(r) {
      if (++reader.nested_ > nested_most) reader.fail("it is nested too deeply");
    }
    ~Nested() { --reader.nested_; }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;
    FormulaReader& reader;
  };

  std::string_view text_;
  Formula::Fault& fault_;
  std::size_t at_ = 0;
  Formula formula_;
  std::vector<Value> values_;
  int depth_ = 0, nested_ = 0;
};

bool Formula::uses(std::size_t argument) const {
  return std::any_of(steps_.begin(), steps_.end(), [argument](const Step& step) {
    return step.op == Op::load && static_cast<std::size_t>(step.index) == argument;
  });
}

Formula Formula::read(std::string_view text, Fault& fault) {
  fault = {};
  return FormulaReader(text, fault).run();
}

double Formula::operator()(std::span<const double> arguments) const {
  std::array<double, most_values> value{};
  std::copy(arguments.begin(), arguments.end(), value.begin());
  std::array<double, deepest + 1> stack;
  int top = -1;
  for (int i = 0;; ++i) {
    const Step& s = steps_[i];
    switch (s.op) {
      case Op::number: stack[++top] = s.number; break;
      case Op::load: stack[++top] = value[s.index]; break;
      case Op::store: value[s.index] = stack[top--]; break;
      case Op::add: --top, stack[top] += stack[top + 1]; break;
      case Op::subtract: --top, stack[top] -= stack[top + 1]; break;
      case Op::multiply: --top, stack[top] *= stack[top + 1]; break;
      case Op::divide: --top, stack[top] /= stack[top + 1]; break;
      case Op::less:
        --top;
        stack[top] = s.index == 0 ? stack[top] < stack[top + 1] : stack[top + 1] < stack[top];
        break;
      case Op::at_most:
        --top;
        stack[top] = s.index == 0 ? stack[top] <= stack[top + 1] : stack[top + 1] <= stack[top];
        break;
      case Op::equal: --top, stack[top] = stack[top] == stack[top + 1]; break;
      case Op::negate: stack[top] = -stack[top]; break;
      case Op::negate_truth: stack[top] = stack[top] == 0.0; break;
      case Op::truncate: stack[top] = std::trunc(stack[top]); break;
      case Op::call: stack[top] = s.function(stack[top]); break;
      case Op::call_of_two: --top, stack[top] = s.function_of_two(stack[top], stack[top + 1]); break;
      case Op::jump: i = s.index - 1; break;
      case Op::jump_if_zero:
        if (stack[top--] == 0.0) i = s.index - 1;
        break;
      case Op::leave: return stack[top];
    }
  }
}

}  // namespace nugget
