// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "impact/recording/histories.hpp"
#include "impact/recording/result_parcels.hpp"

namespace nugget::impact {

/// A history whose rows may be as many as the model has nodes or elements, as text and in binout: they come some at a
/// time, over several ranks from those that answer for them, and go to the disk; neither file is ever in memory whole.
/// `Rows` says how:
///   State, Table                            of the format, and of the text
///   format()
///   tables(model)                           those that go from rank to rank, in their order
///   text_only(table)                        whether binout has its rows from another one
///   set_head(state, snapshot)               what a state says besides rows
///   blank(system, take)                     all rows some at a time, without what is computed
///   pass(snapshot, table, parcels, take)    likewise, as they are now
///   archive(archive)                        what it keeps from one output to the next
/// beside which stand, with its table and state in `output`,
///   print_head(file, table, state), print_rows(file, table, state)
template <class Rows>
class HistoryByRows {
 public:
  using State = typename Rows::State;

  HistoryByRows(model::HistoryName name, const system::System& system, const HistoryTarget& to)
      : binout_(to.binout), shape_(Rows::format()), first_(Rows::format().branches.size()) {
    if (to.ascii) text_.emplace(Rows::format(), to.directory / name.text(), to.header, to.legend);
    if (!binout_) return;
    Rows::blank(system, [&](const State& piece) {
      shape_.add(Rows::format(), piece);
      for (std::size_t b = 0; b < first_.size(); ++b)
        if (const auto& branch = Rows::format().branches[b]; branch.is_in(piece) && !has_first_.contains(b)) {
          first_[b] = piece;
          has_first_.insert(b);
        }
    });
  }

  void write(const Snapshot& now) {
    ResultParcels parcels(now.system);
    if (binout_) {
      for (State& state : first_) Rows::set_head(state, now);
      binout_->begin_pieces(Rows::format(), shape_, first_);
    }
    if (text_)
      text_->write_by([&](output::AsciiFile& file) { write_tables(now, parcels, &file); });
    else
      write_tables(now, parcels, nullptr);
    if (binout_) binout_->end_pieces();
  }
  void archive(Archive& a) {
    if (text_) a(*text_);
    a(rows_);
    a.built(binout_, shape_, first_, has_first_);
  }

  static OpenHistory open(model::HistoryName name, const system::System& system, const HistoryTarget& to) {
    const auto files = std::make_shared<HistoryByRows>(name, system, to);
    return {[files](const Snapshot& now) { files->write(now); }, [files](Archive& a) { a(*files); }};
  }
  /// On another rank than the first, while that writes.
  static void give(const Snapshot& now) {
    ResultParcels parcels(now.system);
    Rows rows;
    for (const auto table : Rows::tables(now.system.model)) rows.pass(now, table, parcels, {});
    parcels.close();
  }

 private:
  void write_tables(const Snapshot& now, ResultParcels& parcels, output::AsciiFile* text) {
    for (const auto table : Rows::tables(now.system.model)) {
      bool has_head = false;
      rows_.pass(now, table, parcels, [&](const State& piece) {
        if (text != nullptr) {
          if (!has_head) print_head(*text, table, piece);
          has_head = true;
          print_rows(*text, table, piece);
          text->end_part();
        }
        if (binout_ && !Rows::text_only(table)) binout_->put_piece(Rows::format(), piece);
      });
    }
  }

  Rows rows_;
  std::shared_ptr<output::Binout> binout_;
  std::optional<output::AsciiHistory<State>> text_;
  output::HistoryShape<State> shape_;
  std::vector<State> first_;         ///< by branch of binout, some of its rows, blank
  std::set<std::size_t> has_first_;  ///< branches that have some
};

}  // namespace nugget::impact
