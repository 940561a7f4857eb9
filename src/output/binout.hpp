// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "output/history.hpp"

namespace nugget::output {

/// `binout0000`, LS-DYNA's binary history file (LSDA), with a branch for each kind of state that is written to it. Ids
/// are 4-byte integers, reals 8-byte. A state and its symbol table reach the disk before the link that makes them
/// known, so a killed run leaves a readable file. The rows of a branch must be the same entities in every state
/// (std::logic_error). Source: the LSDA layout of LSTC's own library; its translator `l2a` and lasso-python read every
/// branch.
class Binout {
 public:
  /// Creates `directory/binout0000`, or continues the file that is there. Throws WriteError.
  Binout(const std::filesystem::path& directory, Header header);

  /// Headings for a branch (`matsum`, `nodout`, `sleout`, `elout/shell`); to be given before its first state.
  void set_legend(const std::string& branch, std::vector<LegendEntry> legend);

  /// The next state of a history.
  template <class State>
  void write(const HistoryFormat<State>& format, const std::type_identity_t<State>& state) {
    for (const Branch<State>& branch : format.branches) {
      if (!branch.is_in(state)) continue;
      if (begin_state(branch.path, branch.ids_in(state), branch.lists_ids))
        for (const Column<State>& column : branch.once) put(column.name, column.values(state));
      begin_data(branch.path);
      for (const Column<State>& column : branch.columns) put(column.name, column.values(state));
      if (format.tables_apart) end_state();
    }
    end_state();
  }
  /// Between two states. Reading, states of later are taken away.
  void archive(Archive& a);

 private:
  /// Where a variable stands in the file, for the symbol table.
  struct Variable {
    char type = 0;
    std::uint64_t offset = 0, count = 0;
  };
  struct Series {
    int states = 0;
    std::vector<int> ids;
    void archive(Archive& a) { a(states, ids); }
  };

  /// Opens the next state of a branch, before the first one its metadata; true: the caller may add metadata of its own.
  bool begin_state(const std::string& path, std::vector<int> ids, bool lists_ids);
  void metadata(const std::string& path, const std::vector<int>& ids);
  void begin_data(const std::string& path);
  void end_state();

  void directory(const std::string& path);
  void put(const std::string& name, const Values& values);
  void text(const std::string& name, const std::string& value);
  void integers(const std::string& name, const std::vector<int>& values);
  void reals(const std::string& name, const std::vector<double>& values);
  void data(const std::string& name, char type, std::uint64_t count, std::string_view bytes);
  std::string symbol_table() const;

  ResultFile file_;
  Header header_;
  std::map<std::string, std::vector<LegendEntry>> legends_;
  std::map<std::string, Series> branches_;
  std::string directory_;  ///< of the data being written
  std::map<std::string, std::map<std::string, Variable>>
      variables_;           ///< since the last symbol table, by directory and name
  std::uint64_t link_ = 0;  ///< where the position of the next table goes
};

}  // namespace nugget::output
