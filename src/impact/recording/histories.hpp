// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "impact/simulation/snapshot.hpp"
#include "model/history_files.hpp"
#include "output/binout.hpp"
#include "output/history.hpp"
#include "output/jntforc.hpp"
#include "output/nodout.hpp"

// The history files of a run. The list of them is model::history_files; each stands in histories/NAME.cpp.
// Rows and columns that others write as well (linear statics, tests of the formats) stand in src/output.
namespace nugget::impact {

/// Headings of the entities of one branch of binout.
struct Legend {
  std::string branch;
  std::vector<output::LegendEntry> entries;
};

/// What is particular about a history file; most have nothing of it.
struct HistoryRules {
  /// Whether a model has something to record; else there is no file even if the deck asks for one.
  bool (*concerns)(const system::System&) = nullptr;
  /// The ASCII file has all, one after the other.
  std::vector<Legend> (*legends)(const model::Model&) = nullptr;
  /// What is written in place of what the deck asks for.
  model::Request (*request)(const model::Request& asked, const model::Model&) = nullptr;
};

/// Where a history goes.
struct HistoryTarget {
  const std::filesystem::path& directory;
  const output::Header& header;
  std::vector<output::LegendEntry> legend;
  bool ascii = false;
  std::shared_ptr<output::Binout> binout;  ///< null: not there
};

/// A history file that is open.
struct OpenHistory {
  std::function<void(const Snapshot&)> write;
  std::function<void(Archive&)> archive;
};

/// A history file: its table of columns, its rules, and how it is opened.
struct HistoryFile {
  std::vector<output::ColumnMeaning> columns;
  HistoryRules rules;
  std::function<OpenHistory(model::HistoryName, const system::System&, const HistoryTarget&)> open;
  model::HistoryName name{std::size_t{0}};  ///< from its place in the list
};

/// The history file of that name, from histories/NAME.cpp: `template <> HistoryFile history<"abstat">()`.
template <model::HistoryName name>
HistoryFile history();

/// All of model::history_files, in its order.
std::vector<HistoryFile> histories();

/// What makes the state of a history at each time, from the system once.
template <class State>
using Recording = std::function<State(const Snapshot&)>;

/// An open history of `format`, which it keeps.
template <class State>
OpenHistory open_history(std::shared_ptr<const output::HistoryFormat<State>> format, Recording<State> state_at,
                         model::HistoryName name, const HistoryTarget& to) {
  std::shared_ptr<output::AsciiHistory<State>> ascii;
  if (to.ascii)
    ascii = std::make_shared<output::AsciiHistory<State>>(*format, to.directory / name.text(), to.header, to.legend);
  const auto write = [ascii, binout = to.binout, format, state_at = std::move(state_at)](const Snapshot& now) {
    const State state = state_at(now);
    if (ascii) ascii->write(state);
    if (binout) binout->write(*format, state);
  };
  const auto archive = [ascii](Archive& a) {
    if (ascii) a(*ascii);
  };
  return OpenHistory{write, archive};
}

template <class State>
HistoryFile make_history(const output::HistoryFormat<State>& format,
                         std::function<Recording<State>(const system::System&)> begin, HistoryRules rules = {}) {
  const auto open = [&format, begin](model::HistoryName name, const system::System& system, const HistoryTarget& to) {
    // A format that stands for all of the run.
    return open_history<State>({std::shared_ptr<const void>(), &format}, begin(system), name, to);
  };
  return {output::meanings(format), rules, open};
}
template <class State>
HistoryFile make_history(const output::HistoryFormat<State>& format, State (*state_at)(const Snapshot&),
                         HistoryRules rules = {}) {
  return make_history<State>(
      format, [state_at](const system::System&) { return Recording<State>(state_at); }, rules);
}

/// Titles of contacts, interior contacts included.
std::vector<output::LegendEntry> titles_of_contacts(const model::Model& model);

/// States that whole runs are tested with.
output::NodoutState nodout_state(const Snapshot& now);
output::JntforcState jntforc_state(const Snapshot& now);

}  // namespace nugget::impact
