// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/command.hpp"
#include "deck/deck.hpp"
#include "deck/numbers.hpp"
#include "model/units.hpp"
#include "reading/build.hpp"
#include "weld/placement/placement_deck.hpp"
#include "weld/placement/stack_card.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

/// `[CLASS:]FIELD=VALUE,FIELD=VALUE`; a sentence on what is wrong, or nothing.
std::string read_fields(const std::string& text, weld::WeldForm form, std::map<std::string, weld::WeldFields>& fields) {
  const std::size_t colon = text.find(':');
  weld::WeldFields& own = fields[colon == std::string::npos ? std::string() : text.substr(0, colon)];
  std::size_t begin = colon == std::string::npos ? 0 : colon + 1;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string piece = text.substr(begin, end - begin);
    const std::size_t equals = piece.find('=');
    const std::string name = piece.substr(0, equals);
    const std::vector<std::string>& known = weld::weld_fields(form);
    if (std::find(known.begin(), known.end(), name) == known.end())
      return fmt::format("'{}' is no field of {} that can be given here; these can: {}", name,
                         form == weld::WeldForm::interpolation ? "--as interpolation" : "*MAT_SPOTWELD",
                         fmt::join(known, ", "));
    double value = 0.0;
    if (equals == std::string::npos || !deck::parse_real(piece.substr(equals + 1), value))
      return fmt::format("'{}', expected {}=NUMBER", piece, name);
    own[name] = value;
    begin = end + 1;
  }
  return {};
}

bool has_strengths(const std::map<std::string, weld::WeldFields>& fields) {
  for (const auto& [spot_class, own] : fields)
    for (const auto& [field, value] : own)
      if (weld::strength_power(field) > 0) return true;
  return false;
}

ExitCode refuse(const Findings& findings) {
  print_findings(findings);
  fmt::print(stderr, "no welds were placed; no file was changed\n");
  return ExitCode::refused;
}

ExitCode place_welds(const WeldArguments& arguments, const weld::GivenMaterial& given) {
  use_threads(arguments.threads);
  Findings findings;
  const deck::Deck deck = deck::read(arguments.deck, findings);
  if (findings.errors() > 0) return refuse(findings);
  const model::Model model = reading::build(deck, findings, arguments.skip_unsupported);
  if (findings.errors() > 0) return refuse(findings);
  Findings own;  // `nugget check` lists the model's findings
  const std::vector<weld::SpotPoint> points = weld::read_spots(arguments.points, model, own);
  if (own.errors() > 0) return refuse(own);
  const weld::Sheets sheets(model);
  const std::vector<weld::Spot> spots =
      weld::place(model, sheets, points, {arguments.search_distance, arguments.diameter}, own);
  if (own.errors() > 0) return refuse(own);
  const fs::path folder = fs::absolute(arguments.output).parent_path();
  const std::string included = fs::proximate(fs::absolute(arguments.deck), folder).generic_string();
  const weld::PlacementDeck placed = weld::write_placement(model, sheets, spots, arguments.form, given, included, own);
  if (own.errors() > 0 || placed.spots == 0) return refuse(own);
  output::write_whole_file(arguments.output, placed.text);
  print_findings(own);
  const char* const what = arguments.form == weld::WeldForm::beam            ? "beam"
                           : arguments.form == weld::WeldForm::interpolation ? "interpolation spot weld"
                                                                             : "brick";
  fmt::print("{} of {} spots placed as {} {}{}; {}\n", placed.spots, points.size(), placed.elements, what,
             placed.elements == 1 ? "" : "s", arguments.output);
  return ExitCode::normal;
}

/// `T:RM` of each sheet; a sentence on what is wrong, or nothing.
std::string read_stack(const std::vector<std::string>& words, std::vector<weld::StackSheet>& stack) {
  for (const std::string& word : words) {
    const std::size_t colon = word.find(':');
    weld::StackSheet sheet;
    if (colon == std::string::npos || !deck::parse_real(word.substr(0, colon), sheet.thickness) ||
        !deck::parse_real(word.substr(colon + 1), sheet.tensile_strength))
      return fmt::format("'{}', expected THICKNESS:STRENGTH in mm and MPa, e.g. 1.5:440", word);
    if (!(sheet.thickness >= 0.3 && sheet.thickness <= 6.0 && sheet.tensile_strength >= 100.0 &&
          sheet.tensile_strength <= 2500.0))
      return fmt::format("'{}', expected 0.3 to 6 mm and 100 to 2500 MPa", word);
    stack.push_back(sheet);
  }
  if (stack.size() < 2 || stack.size() > 4) return fmt::format("{} sheets, expected two to four", stack.size());
  return {};
}

ExitCode weld_a_stack(const WeldArguments& arguments) {
  std::vector<weld::StackSheet> stack;
  if (const std::string wrong = read_stack(arguments.stack, stack); !wrong.empty()) {
    fmt::print(stderr, "nugget: --stack: {}\n", wrong);
    return ExitCode::wrong_command;
  }
  const std::span<const model::Units> all = model::unit_systems();
  const auto units =
      std::find_if(all.begin(), all.end(), [&](const model::Units& u) { return u.name == arguments.units; });
  const double diameter = arguments.diameter / units->millimetre;
  output::write_whole_file(arguments.output, weld::write_stack_card(stack, arguments.rule, diameter, *units));
  const weld::StackWeld weld = weld::weld_of_stack(stack, arguments.rule, diameter);
  fmt::print("diameter {:.4g} mm; NRS = NRT {:.5g} N by {} between sheets {} and {}; NRR {:.5g} N; {}\n", weld.diameter,
             weld.shear, weld.governed, weld.pair + 1, weld.pair + 2, weld.tension, arguments.output);
  return ExitCode::normal;
}

}  // namespace

const std::vector<std::string>& unit_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const model::Units& units : model::unit_systems()) all.emplace_back(units.name);
    return all;
  }();
  return names;
}

ExitCode weld(const WeldArguments& arguments) {
  weld::GivenMaterial given;
  given.strength_diameter = arguments.strength_diameter;
  for (const std::string& text : arguments.material)
    if (const std::string wrong = read_fields(text, arguments.form, given.fields); !wrong.empty()) {
      fmt::print(stderr, "nugget: --material {}: {}\n", text, wrong);
      return ExitCode::wrong_command;
    }
  if (given.strength_diameter > 0.0 && !has_strengths(given.fields)) {
    fmt::print(stderr,
               "nugget: --scale-strength: no strength is given; give some, e.g. --material nrr=8000,nrs=6000\n");
    return ExitCode::wrong_command;
  }
  std::error_code error;
  for (const std::string& input : {arguments.deck, arguments.points})
    if (fs::equivalent(arguments.output, input, error)) {
      fmt::print(stderr, "nugget: {} would be overwritten; give another name after -o\n", input);
      return ExitCode::wrong_command;
    }
  try {
    if (arguments.adapt) return adapt_welds(arguments);
    return arguments.stack.empty() ? place_welds(arguments, given) : weld_a_stack(arguments);
  } catch (const output::WriteError& e) {
    fmt::print(stderr, "nugget: {}\n", e.what());
    return ExitCode::cannot_write;
  }
}

}  // namespace nugget::app
