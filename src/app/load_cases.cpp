// SPDX-License-Identifier: Apache-2.0
#include "app/load_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "deck/deck.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

/// A JOBID may hold what no folder can be called, or be that of another case.
std::string folder_of(const deck::Case& c, const std::vector<deck::Case>& cases) {
  const auto allowed = [](unsigned char letter) { return std::isalnum(letter) != 0 || letter == '_' || letter == '-'; };
  const bool is_name = !c.job.empty() && std::ranges::all_of(c.job, allowed);
  const bool is_own = std::ranges::count(cases, c.job, &deck::Case::job) == 1;
  return is_name && is_own ? c.job : fmt::format("case{}", c.id);
}

}  // namespace

bool has_cases(const RunArguments& arguments) {
  if (arguments.load_case != 0 || !arguments.resume.empty()) return false;
  const std::vector<deck::Case> cases = deck::cases(arguments.deck);
  // One without a number cannot be asked for: reading the deck says so.
  return !cases.empty() && std::ranges::none_of(cases, [](const deck::Case& c) { return c.id <= 0; });
}

ExitCode each_case(const RunArguments& arguments, const std::function<ExitCode(const RunArguments&)>& work) {
  const std::vector<deck::Case> cases = deck::cases(arguments.deck);
  ExitCode worst = ExitCode::normal;
  for (const deck::Case& c : cases) {
    RunArguments one = arguments;
    one.load_case = c.id;
    one.directory = (fs::path(arguments.directory) / folder_of(c, cases)).string();
    fmt::print(stderr, "case {}{}, into {}\n", c.id, c.job.empty() ? "" : " " + c.job, one.directory);
    const ExitCode code = work(one);
    if (worst == ExitCode::normal) worst = code;
    if (code == ExitCode::interrupted || code == ExitCode::wrong_command) return code;
  }
  return worst;
}

std::string deck_and_case(const RunArguments& arguments) {
  return arguments.load_case == 0 ? arguments.deck : fmt::format("{}, case {}", arguments.deck, arguments.load_case);
}

}  // namespace nugget::app
