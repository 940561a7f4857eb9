// SPDX-License-Identifier: Apache-2.0
#include "app/study_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "app/table_lines.hpp"
#include "deck/numbers.hpp"
#include "deck/text.hpp"

namespace nugget::app {
namespace {

bool names_a_folder(const std::string& name) {
  const auto fits = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' || c == '+';
  };
  return !name.empty() && name.front() != '.' && name.front() != '-' && std::all_of(name.begin(), name.end(), fits);
}

/// `deck: car.k` as its two words; nothing of a line of the table.
std::optional<std::pair<std::string, std::string>> setting_of(const std::string& line) {
  const std::size_t colon = line.find(':');
  if (colon == line.npos) return {};
  const std::string name(deck::trimmed(std::string_view(line).substr(0, colon)));
  if (name != "deck" && name != "result" && name != "cfc" && name != "options") return {};
  return std::pair(name, std::string(deck::trimmed(std::string_view(line).substr(colon + 1))));
}

void take_setting(const std::string& name, const std::string& value, const Place& place, StudyPlan& plan,
                  Findings& findings) {
  constexpr std::array<int, 4> classes{60, 180, 600, 1000};
  std::string why;
  double number = 0.0;
  if (name == "deck") {
    const std::filesystem::path folder = std::filesystem::path(place.file).parent_path();
    plan.deck = (folder / value).string();
  } else if (name == "result") {
    if (const auto request = read_result_request(value, why))
      plan.results.push_back(*request);
    else
      findings.error(place, {}, "result: " + why, "correct the line");
  } else if (name == "options") {
    std::istringstream words(value);
    std::copy(std::istream_iterator<std::string>(words), {}, std::back_inserter(plan.options));
    for (const char* const taken : {"-o", "--output", "-j", "--threads", "--resume", "--drop-weld"})
      if (std::find(plan.options.begin(), plan.options.end(), taken) != plan.options.end())
        findings.error(place, {}, fmt::format("options: {} cannot be given here", taken),
                       "folder and threads of a run are the study's");
  } else if (deck::parse_real(value, number) && std::find(classes.begin(), classes.end(), number) != classes.end()) {
    plan.channel_class = static_cast<int>(number);
  } else {
    findings.error(place, {}, fmt::format("cfc: '{}', expected 60, 180, 600 or 1000", value), "see nugget plot --cfc");
  }
}

/// Reads the lines of the table one after the other.
class TableReader {
 public:
  TableReader(const StudyPlan& plan, const DeckChanges& deck, Findings& findings)
      : known_(deck.parameters()), findings_(findings) {
    for (std::size_t i = 0; i < plan.table.size(); ++i)
      i == 0 ? read_head(plan.table[i].cells, plan.table[i].place)
             : add_variant(plan.table[i].cells, plan.table[i].place);
  }

  StudyTable read() { return std::move(table_); }

 private:
  void read_head(const std::vector<std::string>& cells, const Place& place) {
    for (const std::string& cell : cells) {
      const std::string name = deck::lower(cell);
      columns_.push_back(name == "run" && !known_.contains(name) ? run_column
                                                                 : static_cast<int>(table_.parameters.size()));
      if (columns_.back() == run_column) continue;
      if (!known_.contains(name)) {
        std::vector<std::string> names;
        for (const auto& [known, value] : known_) names.push_back(known);
        findings_.error(place, {}, fmt::format("'{}': the deck has no such *PARAMETER", cell),
                        names.empty() ? "write *PARAMETER into the deck, and &NAME in its place in the cards"
                                      : fmt::format("name one of these: {}", fmt::join(names, ", ")));
      } else if (std::find(table_.parameters.begin(), table_.parameters.end(), name) != table_.parameters.end()) {
        findings_.error(place, {}, fmt::format("'{}' is named twice", cell), "leave one of both columns out");
      }
      table_.parameters.push_back(name);
    }
  }

  void add_variant(const std::vector<std::string>& cells, const Place& place) {
    Variant variant{fmt::format("{:03}", table_.variants.size() + 1),
                    std::vector<std::string>(table_.parameters.size()), place};
    if (cells.size() > columns_.size())
      findings_.error(place, {}, fmt::format("{} values, expected {}", cells.size(), columns_.size()),
                      "give each parameter one value");
    for (std::size_t i = 0; i < std::min(cells.size(), columns_.size()); ++i) {
      if (columns_[i] == run_column)
        variant.name = cells[i];
      else
        variant.values[static_cast<std::size_t>(columns_[i])] = value_of(columns_[i], cells[i], place);
    }
    if (!names_a_folder(variant.name))
      findings_.error(place, {},
                      fmt::format("run = '{}': expected a name of letters, digits, '.', '_', '-', '+'", variant.name),
                      "it is the name of the run's folder");
    else if (!names_.insert(variant.name).second)
      findings_.error(place, {}, fmt::format("a second run '{}'", variant.name), "give each run a name of its own");
    table_.variants.push_back(std::move(variant));
  }

  /// The cell, or the deck's value where it is empty.
  std::string value_of(int column, const std::string& cell, const Place& place) {
    const std::string& name = table_.parameters[static_cast<std::size_t>(column)];
    const auto known = known_.find(name);
    if (known == known_.end()) return cell;
    if (cell.empty()) return known->second.text;
    double number = 0.0;
    if (known->second.kind == Kind::text) return cell;
    if (!deck::parse_real(cell, number) || !std::isfinite(number))
      findings_.error(place, {}, fmt::format("{} = {}: expected a number", name, cell), "correct the line");
    else if (known->second.kind == Kind::integer && number != std::trunc(number))
      findings_.error(place, {}, fmt::format("{} = {}: expected a whole number", name, cell),
                      "the deck has it as one (type I)");
    return cell;
  }

  static constexpr int run_column = -1;
  std::map<std::string, DeckChanges::Value> known_;
  Findings& findings_;
  StudyTable table_;
  std::vector<int> columns_;  ///< of the table: which parameter, or run_column
  std::set<std::string> names_;
};

}  // namespace

StudyPlan read_study_plan(const std::string& file, Findings& findings) {
  StudyPlan plan;
  std::ifstream in(file);
  if (!in)
    findings.error({file, 0, 0}, {}, "the plan of the study cannot be read",
                   "write a line 'deck: MODEL.k', then a table whose first line names parameters of the deck");
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    const Place place{file, ++number, 0};
    if (is_remark(line)) continue;
    if (const auto setting = setting_of(line))
      take_setting(setting->first, setting->second, place, plan, findings);
    else
      plan.table.push_back({cells_of(line), place});
  }
  if (!in.is_open()) return plan;
  if (plan.deck.empty()) findings.error({file, 0, 0}, {}, "the plan names no deck", "write a line 'deck: MODEL.k'");
  if (plan.table.size() < 2)
    findings.error({file, 0, 0}, {}, "there is no run in it",
                   "write a line with the names of parameters, then a line of values for each run");
  return plan;
}

StudyTable read_study_table(const StudyPlan& plan, const DeckChanges& deck, Findings& findings) {
  return TableReader(plan, deck, findings).read();
}

void set_parameters(const StudyTable& table, const Variant& variant, DeckChanges& deck) {
  const std::map<std::string, DeckChanges::Value> known = deck.parameters();
  for (std::size_t i = 0; i < table.parameters.size(); ++i) {
    double number = 0.0;
    if (known.at(table.parameters[i]).kind == Kind::text)
      deck.set_parameter_text(table.parameters[i], variant.values[i]);
    else if (deck::parse_real(variant.values[i], number))
      deck.set_parameter_number(table.parameters[i], number);
  }
}

}  // namespace nugget::app
