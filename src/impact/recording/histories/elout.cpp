// SPDX-License-Identifier: Apache-2.0
#include "output/elout.hpp"

#include <memory>
#include <optional>
#include <vector>

#include "impact/recording/element_histories.hpp"
#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

Legend headings(const char* branch, const std::vector<model::NamedEntity>& entities, const std::vector<int>& ids) {
  Legend legend{branch, {}};
  for (const model::NamedEntity& e : entities)
    if (!e.heading.empty()) legend.entries.push_back({ids[e.index], e.heading});
  return legend;
}

/// elout as text and in binout, of which neither is ever in memory whole.
class EloutFiles {
 public:
  EloutFiles(const system::System& system, const HistoryTarget& to)
      : binout_(to.binout), shape_(output::elout()), first_(output::elout().branches.size()) {
    if (to.ascii) text_.emplace(output::elout(), to.directory / "elout", to.header, to.legend);
    if (binout_) find_shape(system);
  }

  void write(const Snapshot& now) {
    ResultParcels parcels(now.system);
    if (binout_) {
      const output::EloutState head = elout_head(now);
      for (output::EloutState& state : first_) {
        state.cycle = head.cycle;
        state.time = head.time;
        state.local_shells = head.local_shells;
      }
      binout_->begin_pieces(output::elout(), shape_, first_);
    }
    if (text_)
      text_->write_by([&](output::AsciiFile& file) { write_tables(now, parcels, &file); });
    else
      write_tables(now, parcels, nullptr);
    if (binout_) binout_->end_pieces();
  }
  void archive(Archive& a) {
    if (text_) a(*text_);
    a.built(binout_, shape_, first_);
  }

 private:
  void write_tables(const Snapshot& now, ResultParcels& parcels, output::AsciiFile* text) {
    for (const output::EloutTable table : passed_tables(now.system.model)) {
      bool has_head = false;
      pass_elout(now, table, parcels, [&](const output::EloutState& piece) {
        if (text != nullptr) {
          if (!has_head) print_elout_head(*text, table, piece);
          has_head = true;
          print_elout_rows(*text, table, piece);
          text->end_part();
        }
        if (binout_ && !output::shows_strains(table)) binout_->put_piece(output::elout(), piece);
      });
    }
  }
  void find_shape(const system::System& system) {
    const output::HistoryFormat<output::EloutState>& format = output::elout();
    for (const output::EloutTable table : output::elout_tables) {
      if (output::shows_strains(table)) continue;
      blank_elout(system, table, [&](const output::EloutState& piece) {
        shape_.add(format, piece);
        for (std::size_t b = 0; b < first_.size(); ++b)
          if (format.branches[b].is_in(piece) && !format.branches[b].is_in(first_[b])) first_[b] = piece;
      });
    }
  }

  std::shared_ptr<output::Binout> binout_;
  std::optional<output::AsciiHistory<output::EloutState>> text_;
  output::HistoryShape<output::EloutState> shape_;
  std::vector<output::EloutState> first_;  ///< by branch of binout, some of its rows, blank
};

OpenHistory open_elout(model::HistoryName, const system::System& system, const HistoryTarget& to) {
  const auto files = std::make_shared<EloutFiles>(system, to);
  return {[files](const Snapshot& now) { files->write(now); }, [files](Archive& a) { a(*files); }};
}

}  // namespace

template <>
HistoryFile history<"elout">() {
  HistoryFile file =
      make_history(output::elout(), elout_state,
                   {.concerns =
                        [](const system::System& system) {
                          const model::Requests& ask = system.model.requests;
                          return !ask.history_shells.empty() || !ask.history_solids.empty() ||
                                 !ask.history_beams.empty() || !ask.history_thick_shells.empty();
                        },
                    .legends =
                        [](const model::Model& model) {
                          return std::vector<Legend>{
                              headings("elout/solid", model.requests.history_solids, model.solids.id),
                              headings("elout/beam", model.requests.history_beams, model.beams.id),
                              headings("elout/shell", model.requests.history_shells, model.shells.id),
                              headings("elout/thickshell", model.requests.history_thick_shells, model.solids.id)};
                        }});
  file.open = open_elout;
  return file;
}

}  // namespace nugget::impact
