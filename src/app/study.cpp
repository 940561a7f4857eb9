// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "app/child_runs.hpp"
#include "app/command.hpp"
#include "app/commands.hpp"
#include "app/deck_changes.hpp"
#include "app/status.hpp"
#include "app/study_plan.hpp"
#include "app/study_results.hpp"
#include "base/parallel.hpp"
#include "deck/text.hpp"
#include "model/history_files.hpp"
#include "output/result_file.hpp"
#include "report/run_data.hpp"
#include "report/study_page.hpp"

// `nugget study`: a deck with other values of its parameters, line by line of a table.
namespace nugget::app {
namespace {

namespace fs = std::filesystem;
using DeckFiles = std::vector<deck::EditedText::File>;

std::optional<std::string> text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  return std::string(std::istreambuf_iterator<char>(file), {});
}

class StudyRuns {
 public:
  StudyRuns(const fs::path& directory, const StudyArguments& arguments)
      : directory_(directory), arguments_(arguments) {}

  ExitCode run() {
    use_threads(arguments_.threads);
    Findings findings;
    plan_ = read_study_plan(arguments_.plan, findings);
    if (findings.errors() > 0) return refused(findings);
    RunArguments deck;
    deck.deck = plan_.deck;
    deck.skip_unsupported = arguments_.skip_unsupported;
    const PreparedDeck prepared = prepare(deck, findings);
    if (!prepared.has_text) return refuse_missing(findings);
    inputs_ = prepared.files;
    DeckChanges changes(deck, prepared);
    table_ = read_study_table(plan_, changes, findings);
    if (findings.errors() == 0) make_decks(changes, findings);
    look_for_histories(prepared.model, findings);
    if (findings.errors() > 0) return refused(findings);
    choose_runs();
    if (arguments_.only_decks) return list_runs();
    if (const ExitCode code = run_planned(); code != ExitCode::normal) return code;
    return gather();
  }

 private:
  static ExitCode refused(const Findings& findings) {
    print_findings(findings);
    fmt::print(stderr, "the study is refused; nothing was run\n");
    return ExitCode::refused;
  }

  fs::path folder_of(const Variant& variant) const { return directory_ / variant.name; }
  fs::path deck_of(const Variant& variant) const { return folder_of(variant) / fs::path(plan_.deck).filename(); }

  /// The decks of all runs, so that what is wrong with one is known before any is run.
  void make_decks(DeckChanges& changes, Findings& findings) {
    // So that runs with other options are not taken for these.
    const std::string remark =
        plan_.options.empty() ? std::string() : fmt::format("$ nugget run {}\n", fmt::join(plan_.options, " "));
    for (const Variant& variant : table_.variants) {
      try {
        set_parameters(table_, variant, changes);
        decks_.push_back(changes.files(deck_of(variant), remark));
      } catch (const std::invalid_argument& fault) {
        findings.error(variant.place, {}, fault.what(), "correct the table or the deck");
      }
    }
  }

  /// A result of a history that the deck does not write would be missed after all runs.
  void look_for_histories(const model::Model& model, Findings& findings) const {
    for (const ResultRequest& request : plan_.results) {
      const std::string file = request.channel.substr(0, request.channel.find('/'));
      for (std::size_t i = 0; i < model::history_files.size(); ++i)
        if (model::history_files[i] == file && !model.requests[model::HistoryName(i)].asked())
          findings.error({arguments_.plan, 0, 0}, {},
                         fmt::format("result: {}: the deck writes no {}", request.channel, file),
                         fmt::format("give *DATABASE_{}", deck::upper(file)));
    }
  }

  /// Whether the folder holds the deck as it is now, and no input is younger than `file` in it.
  bool is_of_this_deck(std::size_t i, const fs::path& file) const {
    std::error_code none;
    const auto written = fs::last_write_time(file, none);
    if (none) return false;
    for (const deck::EditedText::File& part : decks_[i])
      if (text_of(part.path) != part.text) return false;
    return std::all_of(inputs_.begin(), inputs_.end(), [&](const std::string& input) {
      const auto changed = fs::last_write_time(input, none);
      return !none && changed <= written;
    });
  }

  bool is_done(std::size_t i) const {
    const fs::path folder = folder_of(table_.variants[i]);
    if (!is_of_this_deck(i, folder / "summary.json")) return false;
    try {
      const nlohmann::json summary = report::read_run(folder).summary;
      return summary.value("termination", "") == "normal" && summary.value("version", "") == NUGGET_VERSION;
    } catch (const std::runtime_error&) {
      return false;
    }
  }

  /// Which runs are to be made, begun anew or resumed; writes their decks.
  void choose_runs() {
    for (std::size_t i = 0; i < table_.variants.size(); ++i) {
      const Variant& variant = table_.variants[i];
      study_.runs.push_back({variant.name, variant.values, is_done(i) ? 0 : -1});
      if (study_.runs.back().exit_code == 0) continue;
      ChildRun run{fs::absolute(deck_of(variant)), fs::absolute(folder_of(variant))};
      run.threads = arguments_.threads_of_each;
      run.resumed = is_of_this_deck(i, folder_of(variant) / "restart");
      if (arguments_.skip_unsupported && !run.resumed) run.options.emplace_back("--skip-unsupported");
      if (!run.resumed) run.options.insert(run.options.end(), plan_.options.begin(), plan_.options.end());
      if (!run.resumed) {
        fs::create_directories(folder_of(variant));
        for (const deck::EditedText::File& part : decks_[i]) output::write_whole_file(part.path, part.text);
      }
      planned_.push_back(i);
      children_.push_back(std::move(run));
    }
    study_.deck = plan_.deck;
    study_.parameters = table_.parameters;
  }

  /// The commands for another launcher.
  ExitCode list_runs() const {
    std::string text;
    for (const ChildRun& run : children_)
      text += run.resumed ? fmt::format("nugget run --resume {}\n", run.folder.string())
                          : fmt::format("nugget run {} -o {} {}\n", run.deck.string(), run.folder.string(),
                                        fmt::join(run.options, " "));
    output::write_whole_file(directory_ / "runs.txt", text);
    fmt::print("{} of {} runs are to be made: {} has a command for each; then nugget study once more gathers them\n",
               children_.size(), table_.variants.size(), (directory_ / "runs.txt").string());
    return ExitCode::normal;
  }

  ExitCode run_planned() {
    const std::size_t kept = table_.variants.size() - children_.size();
    if (kept > 0) fmt::print("{} of {} runs are there already\n", kept, table_.variants.size());
    std::size_t ended = 0;
    Status status(arguments_.quiet);
    const int at_once = std::max(1, threads() / arguments_.threads_of_each);
    const ChildrenEnd end = run_children(children_, at_once, [&](const ChildRun& run) {
      status(fmt::format("{} of {} runs: {} has ended", ++ended, children_.size(), run.folder.filename().string()));
    });
    status.clear();
    for (std::size_t i = 0; i < children_.size(); ++i) study_.runs[planned_[i]].exit_code = children_[i].exit_code;
    if (end == ChildrenEnd::not_started) {
      fmt::print(stderr, "nugget: no process could be started\n");
      return ExitCode::error_termination;
    }
    if (end == ChildrenEnd::all_ended) return ExitCode::normal;
    fmt::print(stderr, "nugget: interrupted; the same command goes on with what is left\n");
    return ExitCode::interrupted;
  }

  ExitCode gather() {
    const std::vector<std::string> faults =
        gather_results(directory_.string(), plan_.results, plan_.channel_class, study_);
    report::write_study(directory_, study_);
    fmt::print("{}\n{}\n", report::study_lines(study_), (directory_ / "study.html").string());
    for (const std::string& fault : faults) fmt::print(stderr, "nugget: {}\n", fault);
    bool all = true;
    for (const report::Study::Run& run : study_.runs) {
      if (run.exit_code == 0) continue;
      all = false;
      fmt::print(stderr, "nugget: run {} ended with exit code {}: {}\n", run.name, run.exit_code,
                 (directory_ / run.name / "terminal.log").string());
    }
    if (!faults.empty()) return ExitCode::wrong_command;
    return all ? ExitCode::normal : ExitCode::error_termination;
  }

  fs::path directory_;
  const StudyArguments& arguments_;
  StudyPlan plan_;
  std::vector<std::string> inputs_;  ///< files of the deck
  StudyTable table_;
  std::vector<DeckFiles> decks_;      ///< by variant
  std::vector<std::size_t> planned_;  ///< variants that are to be run
  std::vector<ChildRun> children_;    ///< their processes
  report::Study study_;
};

}  // namespace

ExitCode study(const StudyArguments& arguments) {
  return guarded(arguments.directory, [&](const fs::path& directory) { return StudyRuns(directory, arguments).run(); });
}

}  // namespace nugget::app
