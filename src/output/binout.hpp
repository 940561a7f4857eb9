// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "output/history.hpp"

namespace nugget::output {

/// How many values of which type each column of a history holds whose rows come some at a time: the same in each state.
template <class State>
class HistoryShape {
 public:
  struct OfColumn {
    std::size_t count = 0;
    std::size_t type = 0;  ///< in Values; 0: the column is left out
  };

  explicit HistoryShape(const HistoryFormat<State>& format) : ids_(format.branches.size()) {
    for (const Branch<State>& branch : format.branches) columns_.emplace_back(branch.columns.size());
  }
  /// The rows of a piece, whatever they hold.
  void add(const HistoryFormat<State>& format, const State& piece) {
    for (std::size_t b = 0; b < columns_.size(); ++b) {
      const Branch<State>& branch = format.branches[b];
      if (!branch.is_in(piece)) continue;
      const std::vector<int> more = branch.ids_in(piece);
      ids_[b].insert(ids_[b].end(), more.begin(), more.end());
      for (std::size_t c = 0; c < branch.columns.size(); ++c) {
        const Values values = branch.columns[c].values(piece);
        if (values.index() != 0) columns_[b][c].type = values.index();
        if (const auto* integers = std::get_if<std::vector<int>>(&values)) columns_[b][c].count += integers->size();
        if (const auto* reals = std::get_if<std::vector<double>>(&values)) columns_[b][c].count += reals->size();
      }
    }
  }
  const std::vector<int>& ids(std::size_t branch) const { return ids_[branch]; }
  const OfColumn& column(std::size_t branch, std::size_t column) const { return columns_[branch][column]; }
  bool has_rows(std::size_t branch) const {
    return std::ranges::any_of(columns_[branch], [](const OfColumn& column) { return column.count > 0; });
  }

 private:
  std::vector<std::vector<OfColumn>> columns_;  ///< by branch
  std::vector<std::vector<int>> ids_;           ///< likewise
};

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
  /// The next state of a history whose rows come some at a time, of its branches in any order; of a branch in theirs.
  /// `first`: by branch some rows of it, for what the columns say of the whole state.
  template <class State>
  void begin_pieces(const HistoryFormat<State>& format, const HistoryShape<State>& shape,
                    const std::vector<State>& first) {
    pieces_.assign(format.branches.size(), {});
    for (std::size_t b = 0; b < format.branches.size(); ++b) {
      if (!shape.has_rows(b)) continue;
      const Branch<State>& branch = format.branches[b];
      if (format.tables_apart) throw std::logic_error("binout: " + branch.path + " has no pieces");
      if (begin_state(branch.path, shape.ids(b), branch.lists_ids))
        for (const Column<State>& column : branch.once) put(column.name, column.values(first[b]));
      begin_data(branch.path);
      for (std::size_t c = 0; c < branch.columns.size(); ++c) {
        const Column<State>& column = branch.columns[c];
        if (column.of_rows)
          pieces_[b].push_back(leave_room(column.name, shape.column(b, c).type, shape.column(b, c).count));
        else
          put(column.name, column.values(first[b]));
      }
    }
  }
  template <class State>
  void put_piece(const HistoryFormat<State>& format, const State& piece) {
    for (std::size_t b = 0; b < format.branches.size(); ++b) {
      if (!format.branches[b].is_in(piece)) continue;
      auto place = pieces_[b].begin();
      for (const Column<State>& column : format.branches[b].columns)
        if (column.of_rows) put_ahead(*place++, column.values(piece));
    }
  }
  /// Throws std::logic_error where rows are missing.
  void end_pieces();
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
  void head(const std::string& name, char type, std::uint64_t count, std::uint64_t bytes);
  /// Values of a column that come piece by piece.
  struct Room {
    std::uint64_t next = 0, end = 0;
  };
  /// For `count` values of a type of Values.
  Room leave_room(const std::string& name, std::size_t type, std::size_t count);
  void put_ahead(Room& room, const Values& values);
  std::string symbol_table() const;

  ResultFile file_;
  Header header_;
  std::map<std::string, std::vector<LegendEntry>> legends_;
  std::map<std::string, Series> branches_;
  std::string directory_;  ///< of the data being written
  std::map<std::string, std::map<std::string, Variable>>
      variables_;                          ///< since the last symbol table, by directory and name
  std::vector<std::vector<Room>> pieces_;  ///< of the state that comes in pieces, by branch and column of rows
  std::uint64_t link_ = 0;                 ///< where the position of the next table goes
};

}  // namespace nugget::output
