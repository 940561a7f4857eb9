// SPDX-License-Identifier: Apache-2.0
#include "app/weld_drop_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "app/child_runs.hpp"
#include "app/command.hpp"
#include "app/dropped_welds.hpp"
#include "app/node_histories.hpp"
#include "app/status.hpp"
#include "base/parallel.hpp"
#include "model/history_files.hpp"
#include "model/units.hpp"
#include "output/column_units.hpp"
#include "output/history.hpp"
#include "report/run_data.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* each_of = "each:";
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct NodePair {
  int a = 0, b = 0;
  std::string name() const { return fmt::format("{}-{}", a, b); }
};

std::optional<NodePair> read_pair(const std::string& text) {
  NodePair pair;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, pair.a);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != ',') return {};
  const auto second = std::from_chars(first.ptr + 1, end, pair.b);
  if (second.ec != std::errc{} || second.ptr != end) return {};
  return pair;
}

/// Largest change of the distance of two nodes [length]; not a number where nodout does not have both.
double intrusion(const std::map<int, NodeHistory>& nodes, const NodePair& pair) {
  const auto first = nodes.find(pair.a), second = nodes.find(pair.b);
  if (first == nodes.end() || second == nodes.end()) return unknown;
  const std::vector<Vec3d>&a = first->second.place, &b = second->second.place;
  if (a.size() != b.size()) return unknown;
  const double before = norm(a.front() - b.front());
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double change = norm(a[i] - b[i]) - before;
    if (std::abs(change) > std::abs(largest)) largest = change;
  }
  return largest;
}

/// What a run came to.
struct Result {
  std::string weld;  ///< that was taken out; empty: none
  int exit_code = 0;
  double internal = unknown;  ///< energy at the end
  int failed = 0;             ///< welds, beside the one that was taken out
  std::vector<double> intrusions;
};

Result read_result(const ChildRun& run, const std::string& weld, const std::vector<NodePair>& pairs) {
  Result r{weld, run.exit_code, unknown, 0, std::vector<double>(pairs.size(), unknown)};
  if (run.exit_code != 0) return r;
  const report::RunData data = report::read_run(run.folder);
  r.internal = data.summary.at("energy").at("internal").get<double>();
  for (const report::WeldRow& row : data.welds) r.failed += row.at("failed") == "yes" && row.at("id") != weld;
  if (pairs.empty()) return r;
  const std::map<int, NodeHistory> nodes = read_node_histories(run.folder);
  for (std::size_t i = 0; i < pairs.size(); ++i) r.intrusions[i] = intrusion(nodes, pairs[i]);
  return r;
}

double change_in_percent(double now, double before) {
  return before != 0.0 ? 100.0 * (now / before - 1.0) : unknown;
}

/// By how much the weld matters: the change of the first intrusion, or of the energy; a run that did not end, most.
double worth(const Result& r, const Result& whole) {
  if (r.exit_code != 0) return std::numeric_limits<double>::infinity();
  const double change = r.intrusions.empty() ? change_in_percent(r.internal, whole.internal)
                                             : change_in_percent(r.intrusions.front(), whole.intrusions.front());
  return std::isnan(change) ? -1.0 : std::abs(change);
}

void write_results(const fs::path& directory, const std::vector<NodePair>& pairs, const std::vector<Result>& results) {
  std::string text = "without,exit_code,internal_energy,other_welds_failed";
  for (const NodePair& p : pairs) text += ",intrusion " + p.name();
  text += '\n';
  const auto number = [](double v) { return std::isnan(v) ? std::string() : fmt::format("{:.9g}", v); };
  for (const Result& r : results) {
    text += fmt::format("{},{},{},{}", r.weld.empty() ? "none" : r.weld, r.exit_code, number(r.internal), r.failed);
    for (const double v : r.intrusions) text += ',' + number(v);
    text += '\n';
  }
  output::write_whole_file(directory / "weld_drop.csv", text);
}

std::string column_of(double value, double before, bool whole) {
  if (std::isnan(value)) return fmt::format(" {:>14} {:>9}", "-", "");
  if (whole || before == 0.0) return fmt::format(" {:>14.6g} {:>9}", value, "");
  return fmt::format(" {:>14.6g} {:>+8.2f}%", value, change_in_percent(value, before));
}

std::string drop_table(const std::vector<NodePair>& pairs, const std::vector<Result>& results,
                       const std::optional<model::Units>& units) {
  std::string s = fmt::format("\n{:>10} {:>24} {:>16}", "without",
                              "internal energy" + model::in_units(units, dimension::energy), "others failed");
  for (const NodePair& p : pairs)
    s += fmt::format(" {:>24}", "intrusion " + p.name() + model::in_units(units, dimension::length));
  s += '\n';
  const Result& whole = results.front();
  for (const Result& r : results) {
    s += fmt::format("{:>10}", r.weld.empty() ? "none" : r.weld);
    if (r.exit_code != 0) {
      s += fmt::format("   ended with code {}\n", r.exit_code);
      continue;
    }
    s += column_of(r.internal, whole.internal, &r == &whole) + fmt::format(" {:>15}", r.failed);
    for (std::size_t i = 0; i < pairs.size(); ++i) s += column_of(r.intrusions[i], whole.intrusions[i], &r == &whole);
    s += '\n';
  }
  return s;
}

/// The welds of the word that have elements to be taken out; nothing and a complaint where it names others.
std::optional<std::vector<int>> welds_to_drop(const PreparedDeck& p, const std::string& word, std::string& error_text) {
  std::vector<int> ids;
  if (word != "all") {
    const auto listed = read_weld_ids(word.substr(std::string_view(each_of).size()), error_text);
    if (!listed) return {};
    ids = *listed;
  } else {
    for (const weld::Weld& w : p.ties.welds)
      if (has_weld_elements(w)) ids.push_back(w.id);
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  for (const int id : ids)
    if (std::none_of(p.ties.welds.begin(), p.ties.welds.end(), [id](const weld::Weld& w) { return w.id == id; })) {
      error_text = fmt::format("there is no weld {}; welds.csv of `nugget check` lists them", id);
      return {};
    }
  if (ids.empty()) error_text = "the deck has no weld of beams or bricks";
  return ids.empty() ? std::nullopt : std::optional(ids);
}

/// Why the distance of a pair cannot be followed; empty: all can.
std::string missing_history(const model::Model& model, const std::vector<NodePair>& pairs) {
  const auto& asked = model.requests.history_nodes;
  for (const NodePair& pair : pairs)
    for (const int id : {pair.a, pair.b})
      if (std::none_of(asked.begin(), asked.end(), [&](const model::NamedEntity& node) {
            return node.system == model::none && model.nodes.id[node.index] == id;
          }))
        return fmt::format("node {} has no history in global axes [name it in *DATABASE_HISTORY_NODE]", id);
  if (!pairs.empty() && !model.requests["nodout"].ascii())
    return "the deck writes no nodout as text [*DATABASE_NODOUT with BINARY 0, 1 or 3]";
  return {};
}

/// Options that each of the runs takes over.
std::vector<std::string> options_of_each(const RunArguments& a) {
  std::vector<std::string> words;
  if (a.until > 0.0) words.insert(words.end(), {"--until", fmt::format("{:.17g}", a.until)});
  if (a.max_cycles > 0) words.insert(words.end(), {"--max-cycles", fmt::format("{}", a.max_cycles)});
  if (!a.weld_law.empty()) words.insert(words.end(), {"--weld-law", a.weld_law});
  if (!a.units.empty()) words.insert(words.end(), {"--units", a.units});
  if (!a.weld_tie.empty()) words.insert(words.end(), {"--weld-tie", a.weld_tie});
  if (!a.precision.empty()) words.insert(words.end(), {"--precision", a.precision});
  if (a.subcycle) words.emplace_back("--subcycle");
  if (a.load_case > 0) words.insert(words.end(), {"--case", fmt::format("{}", a.load_case)});
  if (a.skip_unsupported) words.emplace_back("--skip-unsupported");
  if (a.vtk) words.emplace_back("--vtk");
  return words;
}

ExitCode compare_runs(const fs::path& directory, const RunArguments& arguments) {
  use_threads(arguments.threads);
  Findings findings;
  const PreparedDeck p = prepare(arguments, findings);
  if (!p.has_text) return refuse_missing(findings);
  if (findings.errors() > 0) {
    print_findings(findings);
    fmt::print(stderr, "the deck is refused; nothing was run\n");
    return ExitCode::refused;
  }
  std::string error_text;
  const auto ids = welds_to_drop(p, arguments.drop_weld, error_text);
  if (!ids) {
    fmt::print(stderr, "nugget: --drop-weld: {}\n", error_text);
    return ExitCode::wrong_command;
  }
  std::vector<NodePair> pairs;
  for (const std::string& text : arguments.intrusion) pairs.push_back(*read_pair(text));
  if (const std::string why = missing_history(p.model, pairs); !why.empty()) {
    fmt::print(stderr, "nugget: --intrusion: {}; nothing was run\n", why);
    return ExitCode::wrong_command;
  }

  const std::vector<std::string> options = options_of_each(arguments);
  std::vector<ChildRun> runs{{arguments.deck, directory / "whole", options}};
  for (const int id : *ids) {
    runs.push_back({arguments.deck, directory / fmt::format("without_{}", id), options});
    runs.back().options.insert(runs.back().options.end(), {"--drop-weld", fmt::format("{}", id)});
  }
  std::size_t ended = 0;
  Status status(arguments.quiet);
  const ChildrenEnd end = run_children(runs, threads(), [&](const ChildRun& run) {
    status(fmt::format("{} of {} runs: {} has ended", ++ended, runs.size(), run.folder.filename().string()));
  });
  status.clear();
  if (end == ChildrenEnd::not_started) {
    fmt::print(stderr, "nugget: no process could be started\n");
    return ExitCode::error_termination;
  }
  if (end == ChildrenEnd::interrupted) {
    fmt::print(stderr, "nugget: interrupted, {} of {} runs had ended\n", ended, runs.size());
    return ExitCode::interrupted;
  }
  std::vector<Result> results{read_result(runs.front(), {}, pairs)};
  for (std::size_t i = 0; i < ids->size(); ++i)
    results.push_back(read_result(runs[i + 1], fmt::format("{}", (*ids)[i]), pairs));
  const Result whole = results.front();
  std::stable_sort(results.begin() + 1, results.end(),
                   [&](const Result& a, const Result& b) { return worth(a, whole) > worth(b, whole); });
  write_results(directory, pairs, results);
  output::write_column_units(directory, model::units_of(p.model));
  fmt::print("{}\n{}\n", drop_table(pairs, results, model::units_of(p.model)), (directory / "weld_drop.csv").string());
  if (whole.exit_code != 0) return static_cast<ExitCode>(whole.exit_code);
  return std::all_of(runs.begin(), runs.end(), [](const ChildRun& r) { return r.exit_code == 0; })
             ? ExitCode::normal
             : ExitCode::error_termination;
}

}  // namespace

bool drops_each(const std::string& word) {
  return word == "all" || word.starts_with(each_of);
}

std::string wrong_intrusion(const std::string& text) {
  return read_pair(text) ? std::string() : fmt::format("'{}', expected two nodes, e.g. 1201,3404", text);
}

ExitCode run_without_each(const RunArguments& arguments) {
  return guarded(arguments.directory, [&](const fs::path& directory) { return compare_runs(directory, arguments); });
}

}  // namespace nugget::app
