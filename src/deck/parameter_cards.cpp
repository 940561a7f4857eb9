// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck/expression.hpp"
#include "deck/numbers.hpp"
#include "deck/reader.hpp"
#include "deck/text.hpp"

// *PARAMETER with its options.
namespace nugget::deck {
namespace {

constexpr std::size_t pairs_per_line = 4;

bool has_option(std::string_view keyword, std::string_view option) {
  const std::size_t at = keyword.find(option);
  return at != std::string_view::npos && keyword[at - 1] == '_';
}

std::size_t cell_width(const Block& block) {
  return block.format == Format::long_format ? 20 : 10;
}

int column_of(const Line& line, std::string_view text) {
  return static_cast<int>(text.data() - line.text.data()) + 1;
}

struct DuplicationCard {
  int dflag = 1;
};
const CardOf<DuplicationCard> duplication_card{
    {&DuplicationCard::dflag, integer("dflag", 1, between(1, 5), "treatment of parameters that are defined twice")},
};

}  // namespace

void Reader::parameters(const Block& block, const Visit& visit) {
  std::string_view options = std::string_view(block.keyword).substr(std::string_view("PARAMETER").size());
  while (!options.empty()) {
    const std::string_view option = options.substr(1, options.find('_', 1) - 1);
    options.remove_prefix(1 + option.size());
    const bool known = option == "EXPRESSION" || option == "LOCAL" || option == "GLOBAL" || option == "MUTABLE" ||
                       option == "NOECHO" || option == "DUPLICATION";
    if (known) continue;
    findings_.error(block.place, block.starred(), fmt::format("the option _{} is not supported", option),
                    "use *PARAMETER with EXPRESSION, LOCAL, GLOBAL, MUTABLE, NOECHO or DUPLICATION");
    return;
  }
  const int depth = has_option(block.keyword, "LOCAL") ? visit.depth : 0;
  if (has_option(block.keyword, "DUPLICATION")) {
    duplication(block);
  } else if (has_option(block.keyword, "EXPRESSION")) {
    parameter_expressions(block, depth);
  } else {
    for (const Line& line : block.lines) parameter_pairs(block, line, depth);
  }
}

void Reader::duplication(const Block& block) {
  Cursor cursor(deck_, block, findings_);
  duplication_ = cursor.read(duplication_card)->dflag;
}

void Reader::parameter_pairs(const Block& block, const Line& line, int depth) {
  const bool free = line.text.find(',') != std::string_view::npos;
  std::size_t from = 0;
  std::string_view cell;
  const auto next = [&] {
    const std::size_t comma = free ? columns(line.text, from, line.text.size()).find(',') : std::string_view::npos;
    const std::size_t width = free ? std::min(comma, line.text.size()) : cell_width(block);
    cell = columns(line.text, from, width);
    from = std::min(from + width + (free ? 1 : 0), line.text.size() + 1);
    return trimmed(cell);
  };
  for (std::size_t pair = 0; free ? from < line.text.size() : pair < pairs_per_line; ++pair) {
    const int start = static_cast<int>(from) + 1;
    const std::string_view head = next();
    const int column = head.empty() ? start : column_of(line, head);
    const std::string_view value = next();
    if (!head.empty() || !value.empty())
      define(block, line, head, column, value, {cell, free ? 0 : cell_width(block), depth});
  }
}

void Reader::parameter_expressions(const Block& block, int depth) {
  const std::size_t width = cell_width(block);
  for (std::size_t i = 0; i < block.lines.size();) {
    const Line& line = block.lines[i++];
    if (trimmed(line.text).empty()) continue;
    // An expression may hold commas of its own, so the comma form shows in the name's columns only.
    const std::size_t comma = line.text.substr(0, width).find(',');
    const bool free = comma != std::string_view::npos;
    const std::string_view head = trimmed(line.text.substr(0, free ? comma : width));
    std::string expression(columns(line.text, free ? comma + 1 : width, line.text.size()));
    while (!free && i < block.lines.size() && trimmed(columns(block.lines[i].text, 0, width)).empty() &&
           !trimmed(block.lines[i].text).empty()) {
      expression += columns(block.lines[i++].text, width, line.text.size() + 160);
    }
    define(block, line, head, head.empty() ? 1 : column_of(line, head), trimmed(expression), {{}, 0, depth});
  }
}

/// One parameter: `head` is its type and name, `value` a number, a text or an expression.
void Reader::define(const Block& block, const Line& line, std::string_view head, int column, std::string_view value,
                    const ParameterCell& at) {
  const Place place{block.place.file, line.number, column};
  const auto refuse = [&](std::string text, std::string remedy) {
    findings_.add(
        {Severity::error, place, block.starred(), readable(head), readable(value), std::move(text), std::move(remedy)});
  };
  Parameter parameter;
  parameter.type = head.empty() ? ' ' : upper(head.substr(0, 1)).front();
  parameter.place = place;
  parameter.depth = at.depth;
  parameter.cell = at.cell;
  parameter.width = at.width;
  parameter.changeable = has_option(block.keyword, "MUTABLE");
  const std::string_view name = trimmed(head.substr(head.empty() ? 0 : 1));
  if (parameter.type != 'R' && parameter.type != 'I' && parameter.type != 'C') {
    return refuse("a parameter starts with its type: R, I or C",
                  "write e.g. 'R thick' in columns 1-10, or 'Rthick,1.5' with commas");
  }
  if (name.empty() || !std::all_of(name.begin(), name.end(), is_name_character)) {
    return refuse(
        "the name of a parameter has letters, digits and underscores only",
        "keep type and name in columns 1-10, 21-30, ..., values in columns 11-20, 31-40, ...; or separate by commas");
  }
  if (value.empty()) return refuse("the value is missing", "write it into the ten columns behind the name");

  const Parameters& known = deck_.impl->parameters;
  if (parameter.type == 'C') {
    parameter.text = substituted(value, known, known.now());
  } else if (has_option(block.keyword, "EXPRESSION")) {
    const ExpressionResult result = evaluate_expression(value, known, known.now());
    if (!result.fault.empty()) return refuse(result.fault, "correct the expression");
    if (!result.warning.empty()) {
      findings_.warning(place, block.starred(), fmt::format("{}: {}", name, result.warning),
                        "write 1.0 for 1 if a real is meant");
    }
    parameter.number = parameter.type == 'I' ? std::trunc(result.value) : result.value;
  } else {
    const Value read = evaluate(value, known, known.now());
    if (read.fault == Value::Fault::unknown_parameter) {
      return refuse(fmt::format("the parameter '{}' is not defined before this line", read.parameter),
                    "define it above");
    }
    if (read.fault != Value::Fault::none) {
      return refuse("is not a number", "an expression needs *PARAMETER_EXPRESSION, a text the type C");
    }
    parameter.number = read.number;
    if (parameter.type == 'I' && read.number != std::trunc(read.number)) {
      return refuse("expected a whole number", "use the type R");
    }
  }
  if (parameter.type == 'I' && std::abs(parameter.number) > 2147483647.0) {
    return refuse("expected at most 2147483647", "use the type R");
  }
  if (may_define(block, name, parameter)) deck_.impl->parameters.define(name, std::move(parameter));
}

/// Whether a definition is to take effect, given what is visible under its name.
bool Reader::may_define(const Block& block, std::string_view name, const Parameter& parameter) {
  const Parameters& known = deck_.impl->parameters;
  const Parameter* const before = known.find(name, known.now());
  if (before == nullptr || before->changeable) return true;
  if (parameter.depth > before->depth) return true;  // a _LOCAL one hides an outer one
  constexpr int warn_and_keep = 1, warn_and_change = 2, change = 4, keep = 5;
  if (duplication_ == change) return true;
  if (duplication_ == keep) return false;
  const std::string text = fmt::format("the parameter '{}' is defined a second time; first at {}:{}", name,
                                       before->place.file, before->place.line);
  if (duplication_ == warn_and_keep || duplication_ == warn_and_change) {
    findings_.warning(
        parameter.place, block.starred(),
        text + (duplication_ == warn_and_keep ? "; the first value stays" : "; the new value holds from here"));
    return duplication_ == warn_and_change;
  }
  findings_.error(parameter.place, block.starred(), text,
                  "rename it, or use *PARAMETER_MUTABLE, *PARAMETER_LOCAL or *PARAMETER_DUPLICATION");
  return false;
}

}  // namespace nugget::deck
