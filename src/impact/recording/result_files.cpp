// SPDX-License-Identifier: Apache-2.0
#include "impact/recording/result_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/index.hpp"
#include "impact/recording/d3plot_states.hpp"
#include "impact/recording/element_histories.hpp"
#include "impact/recording/history_by_rows.hpp"
#include "impact/recording/nodout_rows.hpp"
#include "output/model_geometry.hpp"
#include "system/share.hpp"

namespace nugget::impact {

namespace {

/// The next mark by a curve of the interval, from the mark `last` at or after which the state at `time` stands. One
/// that a long step has jumped over is not made up for. Infinite where the curve has none.
double next_on_curve(const model::Request& request, const Curve& curve, double last, double time) {
  using Rule = model::Request::Rule;
  const double from = std::max(last, time);
  if (request.rule == Rule::at_points) {
    const auto later = std::upper_bound(curve.x.begin(), curve.x.end(), from + 1e-12 * std::abs(from));
    return later == curve.x.end() ? std::numeric_limits<double>::infinity() : *later;
  }
  if (request.rule == Rule::from_last) return last + std::max(curve.clamped(last), from - last);
  // T - last = y(T): the first root, between two points of the curve or beyond them all.
  const auto excess = [&](double t) { return t - last - curve.clamped(t); };
  double low = last;
  for (const double x : curve.x) {
    if (x <= low) continue;
    if (excess(x) < 0.0) {
      low = x;
      continue;
    }
    double high = x;
    for (int i = 0; i < 200 && low < high; ++i) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      (excess(middle) < 0.0 ? low : high) = middle;
    }
    return std::max(high, from);
  }
  return std::max(last + curve.clamped(low), from);
}

/// Histories that take energies, forces on nodes and motions, and nothing from elements but those that every rank
/// computes: welds, springs and belts, and what nodal force groups look at.
bool of_sums_and_nodes(std::string_view name) {
  constexpr std::array<std::string_view, 17> names{"glstat", "matsum", "nodout", "spcforc", "rwforc", "rcforc",
                                                   "bndout", "rbdout", "swforc", "dcfail",  "deforc", "jntforc",
                                                   "sleout", "abstat", "nodfor", "sbtout",  "ncforc"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool of_energies(std::string_view name) {
  return name == "glstat" || name == "matsum" || name == "sleout";
}

/// That of the first rank, to all of them.
output::D3plotLayout layout_for_all(const system::System& system, std::optional<output::D3plotLayout> of_first) {
  output::D3plotLayout layout = of_first ? *of_first : output::D3plotLayout(output::D3plotGeometry());
  if (system.share() != nullptr) broadcast(system.share()->ranks(), layout);
  return layout;
}

/// The first mark: the start, but with IOOPT 3 the curve's first abscissa that is not before it.
double first_mark(const model::Request& request, const std::vector<Curve>& curves) {
  if (request.curve == model::none || request.rule != model::Request::Rule::at_points) return 0.0;
  const std::vector<double>& x = curves[request.curve].x;
  const auto first = std::lower_bound(x.begin(), x.end(), 0.0);
  return first == x.end() ? std::numeric_limits<double>::infinity() : *first;
}

}  // namespace

ResultFiles::ResultFiles(const system::System& system, const std::filesystem::path& directory,
                         const output::Header& header)
    : model_(system.model), directory_(directory), header_(header) {
  for (const HistoryFile& history : histories()) add(history, system);
  const model::Requests& ask = model_.requests;
  if (!ask.d3plot.asked()) return;
  output::D3plotGeometry geometry = output::d3plot_geometry(system);
  geometry.strains = ask.strains;
  geometry.solid_histories = ask.solid_histories;
  geometry.shell_histories = ask.shell_histories;
  states_ = std::make_shared<StateFile>(directory, std::move(geometry), header.mode);
  channels_.push_back({ask.d3plot, [states = states_](const Snapshot& now) { states->write(now); },
                       [states = states_](Archive& a) { a(*states); }, first_mark(ask.d3plot, model_.curves), true});
}

void ResultFiles::StateFile::write(const Snapshot& now) {
  ResultParcels parcels(now.system);
  const output::D3plotLayout layout = layout_for_all(now.system, file.layout());
  const system::Share* share = now.system.share();
  const auto ranks = at(share == nullptr ? 1 : share->ranks().count());
  const std::size_t room = layout.all_words() * sizeof(float) / ranks;
  writer.add([this] { file.begin_state(); }, 0, room);
  put_state(now, layout, parcels, [&](std::string piece) {
    const std::size_t size = piece.size();
    writer.add([this, piece = std::move(piece)] { file.put_piece(piece); }, size, room);
  });
  writer.add([this] { file.end_state(); }, 0, room);
}

void ResultFiles::StateFile::archive(Archive& a) {
  writer.finish();
  a(file);
  a.built(writer);
}

void ResultShares::give(const Snapshot& now, Shared what) {
  // In the order in which the first rank writes its files.
  if (what.nodes) HistoryByRows<NodoutRows>::give(now);
  if (what.rows) HistoryByRows<EloutRows>::give(now);
  if (!what.states) return;
  ResultParcels parcels(now.system);
  put_state(now, layout_for_all(now.system, std::nullopt), parcels, {});
  parcels.close();
}

void ResultFiles::finish() {
  if (states_) states_->writer.finish();
}

void ResultFiles::add(const HistoryFile& history, const system::System& system) {
  const HistoryRules& rules = history.rules;
  model::Request request = model_.requests[history.name];
  if (rules.request) request = rules.request(request, model_);
  if (!request.asked() || (rules.concerns && !rules.concerns(system))) return;
  HistoryTarget to{directory_, header_, {}, request.ascii(), request.binout() ? binout() : nullptr};
  if (rules.legends)
    for (const Legend& legend : rules.legends(model_)) {
      to.legend.insert(to.legend.end(), legend.entries.begin(), legend.entries.end());
      if (to.binout && !legend.entries.empty()) to.binout->set_legend(legend.branch, legend.entries);
    }
  // In binout a branch that has no headings of its own shows those of the whole file.
  if (to.binout && !to.legend.empty()) to.binout->set_legend(std::string(history.name.text()), to.legend);
  const OpenHistory file = history.open(history.name, system, to);
  channels_.push_back({request,
                       file.write,
                       file.archive,
                       first_mark(request, model_.curves),
                       false,
                       !of_sums_and_nodes(history.name.text()),
                       of_energies(history.name.text()),
                       {.rows = history.name.text() == "elout",
                        .nodes = history.name.text() == "nodout" && history_nodes_are_shared_out(system.model)}});
}

std::shared_ptr<output::Binout> ResultFiles::binout() {
  if (!binout_) binout_ = std::make_shared<output::Binout>(directory_, header_);
  return binout_;
}

/// Due at the last time that is not beyond the mark, as LS-DYNA does: the next step would pass it.
bool ResultFiles::due(const Channel& channel, const system::State& state) const {
  return state.time + state.interval() > channel.next + 1e-9 * state.interval();
}

bool ResultFiles::due(const system::State& state) {
  for (const Channel& c : channels_)
    if (due(c, state) || (state_asked_ && c.of_states)) return true;
  return false;
}

Recorder::Shared ResultFiles::shared_due(const system::State& state, bool last) {
  Shared shared;
  for (const Channel& c : channels_) {
    if (!writes(c, state, last)) continue;
    shared.states |= c.of_states;
    shared.rows |= c.of_ranks.rows;
    shared.nodes |= c.of_ranks.nodes;
  }
  return shared;
}

bool ResultFiles::energies_due(const system::State& state) {
  return std::any_of(channels_.begin(), channels_.end(), [&](const Channel& c) {
    return c.of_energies && (due(c, state) || (state_asked_ && c.of_states));
  });
}

Recorder::Marks ResultFiles::next_marks() const {
  Marks marks;
  for (const Channel& c : channels_) {
    marks.any = std::min(marks.any, c.next);
    if (c.of_elements) marks.of_elements = std::min(marks.of_elements, c.next);
    marks.elements |= c.of_elements;
    if (c.of_energies) marks.of_energies = std::min(marks.of_energies, c.next);
  }
  return marks;
}

void ResultFiles::Channel::archive(Archive& a) {
  archive_file(a);
  a(next);
  a.built(request, write, of_states, of_elements, of_energies, of_ranks);
}

void ResultFiles::archive(Archive& a) {
  a.section("result files");
  a(channels_);
  if (binout_) a(*binout_);
  a.built(model_, directory_, header_, states_, state_asked_);
}

void ResultFiles::write(const Snapshot& now, bool last) {
  for (Channel& c : channels_) {
    const bool is_due = last || due(c, now.state);
    if (!writes(c, now.state, last)) continue;
    c.write(now);
    if (!is_due) continue;
    if (c.request.curve != model::none) {
      c.next = next_on_curve(c.request, model_.curves[c.request.curve], c.next, now.state.time);
      continue;
    }
    const double interval = c.request.interval;
    // Marks are multiples of the interval; one that a long step has jumped over is not made up for.
    if (const double missed = std::floor((now.state.time - c.next) / interval); missed > 64.0)
      c.next += missed * interval;
    // An interval far below the step asks for every cycle: it changes nothing in the mark.
    do c.next += interval;
    while (c.next <= now.state.time && c.next + interval > c.next);
  }
  state_asked_ = false;
}

}  // namespace nugget::impact
