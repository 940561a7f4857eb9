// SPDX-License-Identifier: Apache-2.0
#include "deck/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/numbers.hpp"
#include "deck/text.hpp"

namespace nugget::deck {
namespace {

constexpr std::size_t still_open = std::numeric_limits<std::size_t>::max();

/// Length of the name at the start of `text`.
std::size_t name_length(std::string_view text) {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_name_character) - text.begin());
}

std::string written(const Parameter& p) {
  if (p.type == 'C') return p.text;
  return p.type == 'I' ? fmt::format("{:.0f}", p.number) : fmt::format("{}", p.number);
}

}  // namespace

const Parameter* Parameters::find(std::string_view name, std::size_t moment) const {
  const auto entry = histories_.find(lower(name));
  if (entry == histories_.end()) return nullptr;
  const std::vector<Parameter>& history = entry->second;
  const auto later = std::upper_bound(history.begin(), history.end(), moment,
                                      [](std::size_t m, const Parameter& p) { return m < p.from; });
  if (later == history.begin()) return nullptr;
  const Parameter& last = *std::prev(later);
  return moment < last.to ? &last : nullptr;
}

void Parameters::define(std::string_view name, Parameter parameter) {
  std::vector<Parameter>& history = histories_[lower(name)];
  parameter.from = ++now_;
  if (!history.empty() && history.back().to == still_open) {
    Parameter& before = history.back();
    before.to = now_;
    if (parameter.depth > before.depth) {
      parameter.hidden = static_cast<int>(history.size()) - 1;
    } else {
      parameter.depth = before.depth;
      parameter.hidden = before.hidden;
    }
  }
  history.push_back(std::move(parameter));
}

void Parameters::leave_file(int depth) {
  ++now_;
  for (auto& [name, history] : histories_) {
    Parameter& last = history.back();
    if (last.depth != depth || last.to != still_open) continue;
    last.to = now_;
    if (last.hidden < 0) continue;
    Parameter again = history[last.hidden];
    again.from = now_;
    again.to = still_open;
    history.push_back(std::move(again));
  }
}

Value evaluate(std::string_view text, const Parameters& parameters, std::size_t moment) {
  Value value;
  std::string_view rest = text;
  double sign = 1.0;
  if (!rest.empty() && (rest.front() == '-' || rest.front() == '+')) {
    sign = rest.front() == '-' ? -1.0 : 1.0;
    rest = trimmed(rest.substr(1));
  }
  if (rest.empty() || rest.front() != '&') {
    if (!parse_real(text, value.number)) value.fault = Value::Fault::not_a_number;
    return value;
  }
  rest.remove_prefix(1);
  if (rest.empty() || name_length(rest) != rest.size()) {
    value.fault = Value::Fault::not_a_number;
    return value;
  }
  value.parameter = rest;
  const Parameter* p = parameters.find(rest, moment);
  if (p == nullptr) {
    value.fault = Value::Fault::unknown_parameter;
  } else if (p->type != 'C') {
    value.number = sign * p->number;
  } else if (parse_real(trimmed(p->text), value.number)) {
    value.number *= sign;
  } else {
    value.fault = Value::Fault::text_parameter;
  }
  return value;
}

std::string substituted(std::string_view text, const Parameters& parameters, std::size_t moment,
                        std::vector<std::string>* unknown) {
  std::string result;
  for (std::size_t at = text.find('&'); at != std::string_view::npos; at = text.find('&')) {
    const std::string_view name = text.substr(at + 1, name_length(text.substr(at + 1)));
    result += text.substr(0, at);
    const Parameter* p = name.empty() ? nullptr : parameters.find(name, moment);
    if (p != nullptr) {
      result += written(*p);
    } else {
      result += text.substr(at, 1 + name.size());
      if (unknown != nullptr && !name.empty()) unknown->emplace_back(name);
    }
    text.remove_prefix(at + 1 + name.size());
  }
  result += text;
  return result;
}

}  // namespace nugget::deck
