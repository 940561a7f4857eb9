// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/child_runs.hpp"
#include "app/command.hpp"
#include "app/status.hpp"
#include "base/parallel.hpp"
#include "deck/deck.hpp"
#include "deck/text.hpp"

// `nugget coverage FOLDER`: which of the decks of a folder run, and what stands in the way of the others.
namespace nugget::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct CoveredDeck {
  fs::path path;  ///< from the folder on
  int exit_code = -1;
  int warnings = 0;
  Json errors = Json::array();     ///< findings that refuse it
  std::set<std::string> keywords;  ///< in which they stand; of the whole deck: an empty one

  bool is_fragment = false;  ///< it says no end time: part of a model

  bool accepted() const { return exit_code == static_cast<int>(ExitCode::normal); }
  bool refused() const { return exit_code == static_cast<int>(ExitCode::refused); }
};

/// What stands between decks and a run.
struct Obstacle {
  std::string keyword;
  std::vector<std::string> decks, alone;  ///< that have it; that have nothing but it
};

/// A keyword deck begins with *KEYWORD; comments and blank lines may stand before it.
bool begins_with_keyword(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 65536> start;
  file.read(start.data(), start.size());
  std::string_view text(start.data(), static_cast<std::size_t>(file.gcount()));
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  while (!text.empty()) {
    const std::string_view line = text.substr(0, std::min(text.find('\n'), text.size()));
    if (!deck::trimmed(line).empty() && line.front() != '$') return deck::upper(line.substr(0, 8)) == "*KEYWORD";
    text.remove_prefix(std::min(text.size(), line.size() + 1));
  }
  return false;
}

/// The master files below a folder, in the order of their names: those that no other one includes.
std::vector<fs::path> master_files(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code unreadable;
  for (fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, unreadable), end;
       !unreadable && entry != end; entry.increment(unreadable))
    if (entry->is_regular_file(unreadable) && begins_with_keyword(entry->path())) found.push_back(entry->path());
  std::sort(found.begin(), found.end());
  std::set<fs::path> included;
  for (const fs::path& path : found) {
    Findings said_by_its_check;
    const deck::Deck deck = deck::read(path, said_by_its_check);
    for (const deck::Deck::Inclusion& i : deck.inclusions)
      included.insert(fs::weakly_canonical(deck.files[i.file], unreadable));
  }
  std::erase_if(found, [&](const fs::path& path) { return included.contains(fs::weakly_canonical(path, unreadable)); });
  return found;
}

/// Those of a check; a deck with several cases has a file for each.
void add_findings(CoveredDeck& deck, const fs::path& results) {
  std::error_code missing;
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator entry(results, missing), end; !missing && entry != end;
       entry.increment(missing))
    if (entry->path().filename() == "findings.json") files.push_back(entry->path());
  std::sort(files.begin(), files.end());
  for (const fs::path& path : files) {
    std::ifstream file(path);
    const Json findings = Json::parse(file, nullptr, false);
    if (findings.is_discarded()) continue;
    for (const Json& finding : findings) {
      if (finding.at("severity") == "warning") ++deck.warnings;
      if (finding.at("severity") != "error") continue;
      deck.errors.push_back(finding);
      deck.is_fragment |=
          finding.at("keyword") == "*CONTROL_TERMINATION" && finding.at("field").get_ref<const std::string&>().empty();
      deck.keywords.insert(finding.at("keyword").get<std::string>());
    }
  }
}

/// Those that stand alone before most decks first.
std::vector<Obstacle> obstacles_of(const std::vector<CoveredDeck>& decks) {
  std::map<std::string, Obstacle> by_keyword;
  for (const CoveredDeck& deck : decks)
    for (const std::string& keyword : deck.is_fragment ? std::set<std::string>() : deck.keywords) {
      Obstacle& obstacle = by_keyword[keyword];
      obstacle.keyword = keyword;
      obstacle.decks.push_back(deck.path.string());
      if (deck.keywords.size() == 1) obstacle.alone.push_back(deck.path.string());
    }
  std::vector<Obstacle> obstacles;
  obstacles.reserve(by_keyword.size());
  for (auto& [keyword, obstacle] : by_keyword) obstacles.push_back(std::move(obstacle));
  std::stable_sort(obstacles.begin(), obstacles.end(), [](const Obstacle& a, const Obstacle& b) {
    return std::pair(a.alone.size(), a.decks.size()) > std::pair(b.alone.size(), b.decks.size());
  });
  return obstacles;
}

std::string shown(const std::string& keyword) {
  return keyword.empty() ? "(the deck)" : keyword;
}

std::string verdict(const CoveredDeck& deck, long cycles) {
  std::vector<std::string> names;
  for (const std::string& keyword : deck.keywords) names.push_back(shown(keyword));
  if (deck.is_fragment) return "no model: it has no end time";
  if (deck.refused()) return fmt::format("refused   {}", fmt::join(names, ", "));
  if (!deck.accepted()) return fmt::format("ended with exit code {}", deck.exit_code);
  const std::string warnings = deck.warnings > 0 ? fmt::format(", {} warnings", deck.warnings) : "";
  return (cycles > 0 ? "runs" : "accepted") + warnings;
}

std::string table(const std::vector<CoveredDeck>& decks, const std::vector<Obstacle>& obstacles, long cycles) {
  const auto accepted = std::ranges::count_if(decks, &CoveredDeck::accepted),
             fragments = std::ranges::count_if(decks, &CoveredDeck::is_fragment),
             refused = std::ranges::count_if(decks, &CoveredDeck::refused) - fragments;
  std::size_t width = 4;
  for (const CoveredDeck& deck : decks) width = std::max(width, deck.path.string().size());
  std::string s;
  for (const CoveredDeck& deck : decks)
    s += fmt::format("{:<{}}  {}\n", deck.path.string(), width, verdict(deck, cycles));
  s += fmt::format("\n{} decks: {} {}, {} refused", decks.size(), accepted, cycles > 0 ? "run" : "accepted", refused);
  if (fragments > 0) s += fmt::format(", {} are no model", fragments);
  const auto others = std::ssize(decks) - accepted - refused - fragments;
  s += others > 0 ? fmt::format(", {} ended otherwise\n", others) : "\n";
  if (!obstacles.empty()) s += fmt::format("\n{:<44} {:>6} {:>6}\n", "what refuses them", "decks", "alone");
  for (const Obstacle& o : obstacles)
    s += fmt::format("{:<44} {:>6} {:>6}\n", shown(o.keyword), o.decks.size(), o.alone.size());
  return s;
}

Json to_json(const std::vector<CoveredDeck>& decks, const std::vector<Obstacle>& obstacles) {
  Json json = {{"decks", Json::array()}, {"keywords", Json::array()}};
  for (const CoveredDeck& deck : decks)
    json["decks"].push_back({{"deck", deck.path.string()},
                             {"accepted", deck.accepted()},
                             {"model", !deck.is_fragment},
                             {"exit_code", deck.exit_code},
                             {"warnings", deck.warnings},
                             {"keywords", deck.keywords},
                             {"errors", deck.errors}});
  for (const Obstacle& o : obstacles)
    json["keywords"].push_back({{"keyword", o.keyword}, {"decks", o.decks}, {"alone", o.alone}});
  return json;
}

ExitCode cover(const fs::path& directory, const CoverageArguments& arguments) {
  use_threads(arguments.threads);
  const fs::path folder = arguments.folder;
  std::error_code missing;
  if (!fs::is_directory(folder, missing)) {
    fmt::print(stderr, "nugget: {} is no folder; name one that holds decks\n", folder.string());
    return ExitCode::wrong_command;
  }
  std::vector<CoveredDeck> decks;
  std::vector<ChildRun> runs;
  for (const fs::path& path : master_files(folder)) {
    decks.emplace_back().path = fs::relative(path, folder);
    ChildRun run{.deck = path, .folder = directory / fs::path(decks.back().path).replace_extension()};
    if (arguments.cycles > 0)
      run.options = {"--max-cycles", fmt::format("{}", arguments.cycles)};
    else
      run.verb = "check";
    runs.push_back(std::move(run));
  }
  if (decks.empty()) {
    fmt::print(stderr, "nugget: no file below {} begins with *KEYWORD\n", folder.string());
    return ExitCode::wrong_command;
  }
  std::size_t ended = 0;
  Status status(false);
  const ChildrenEnd end = run_children(runs, threads(), [&](const ChildRun& run) {
    status(fmt::format("{} of {} decks: {}", ++ended, runs.size(), run.deck.string()));
  });
  status.clear();
  if (end == ChildrenEnd::not_started) {
    fmt::print(stderr, "nugget: no process could be started\n");
    return ExitCode::error_termination;
  }
  if (end == ChildrenEnd::interrupted) {
    fmt::print(stderr, "nugget: interrupted, {} of {} decks had ended\n", ended, runs.size());
    return ExitCode::interrupted;
  }
  for (std::size_t i = 0; i < decks.size(); ++i) {
    decks[i].exit_code = runs[i].exit_code;
    add_findings(decks[i], runs[i].folder);
  }
  const std::vector<Obstacle> obstacles = obstacles_of(decks);
  fmt::print("{}", table(decks, obstacles, arguments.cycles));
  output::write_whole_file(directory / "coverage.json", to_json(decks, obstacles).dump(2) + '\n');
  return ExitCode::normal;
}

}  // namespace

ExitCode coverage(const CoverageArguments& arguments) {
  return guarded(arguments.directory, [&](const fs::path& directory) { return cover(directory, arguments); });
}

}  // namespace nugget::app
