// SPDX-License-Identifier: Apache-2.0
#include "app/linear_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/audit_table.hpp"
#include "app/outcome.hpp"
#include "app/run_log.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"
#include "base/peak_memory.hpp"
#include "nvh/matrices/linear_model.hpp"
#include "nvh/matrices/ranks.hpp"
#include "output/column_units.hpp"
#include "weld/tie/disc.hpp"

namespace nugget::app {
namespace {

/// Removes the elements that are deleted in another system of the same deck.
void remove_deleted_elements(system::System& system, const system::System& run) {
  using Locations = std::vector<system::System::ElementLocation> system::System::*;
  for (const Locations locations : {&system::System::shell_location, &system::System::solid_location,
                                    &system::System::beam_location, &system::System::discrete_location})
    for (std::size_t i = 0; i < (run.*locations).size(); ++i) {
      const auto &there = (run.*locations)[i], &here = (system.*locations)[i];
      if (there.group < 0 || here.group < 0 || run.groups[there.group]->alive(at(there.element))) continue;
      system.groups[here.group]->remove(at(here.element));
    }
}

/// Removes what *DEFINE_ELEMENT_DEATH deletes before the run begins; what it deletes later is there.
void remove_absent_elements(system::System& system) {
  for (const model::ElementDeath& death : system.model.element_deaths) {
    const system::System::ElementLocation location = system.location_of(death.kind, death.element);
    if (death.time <= 0.0 && location.group >= 0) system.groups[location.group]->remove(at(location.element));
  }
}

/// By shell of the model: deleted before the run begins, or in the run `after` which the analysis comes.
std::vector<char> absent_shells(const model::Model& model, const system::System* after) {
  std::vector<char> absent(model.shells.size(), 0);
  for (const model::ElementDeath& death : model.element_deaths)
    if (death.kind == model::ElementKind::shell && death.time <= 0.0) absent[at(death.element)] = 1;
  if (after == nullptr) return absent;
  for (std::size_t e = 0; e < absent.size(); ++e) {
    const system::System::ElementLocation location = after->shell_location[e];
    if (location.group >= 0 && !after->groups[location.group]->alive(at(location.element))) absent[e] = 1;
  }
  return absent;
}

/// Whether the run has ended a tie, whatever became of its shell (DT).
bool ended(const weld::Tie& tie, const model::Model& model, const system::System& after) {
  if (tie.spring) return model.contacts[tie.contact].death <= model.control.end_time;
  return !after.map.dependent(after.node_of[tie.node]);
}

/// Ends the ties that a run would end, or has ended. Returns the nodes that lost theirs with a shell.
std::vector<model::Index> end_ties(const model::Model& model, const system::System* after, weld::Ties& ties,
                                   Findings& findings) {
  const std::vector<char> absent = absent_shells(model, after);
  const auto is_absent = [&](model::Index shell) { return absent[at(shell)] != 0; };
  std::vector<model::Index> lost;
  std::vector<char> gone(ties.ties.size(), 0);
  std::size_t by_time = 0;
  for (std::size_t t = 0; t < gone.size(); ++t) {
    weld::Tie& tie = ties.ties[t];
    const bool has_ended = after != nullptr && ended(after->ties.ties[t], model, *after);
    bool loses = tie.shell != model::none && is_absent(tie.shell);
    if (tie.by_area() && std::ranges::any_of(tie.disc.pieces, is_absent, &weld::Disc::Piece::shell)) {
      std::vector<double> weights = weld::weights_without(model, tie.disc, is_absent);
      loses = weights.empty();
      if (!loses) tie.disc.weights = std::move(weights);
    }
    if (loses)
      lost.push_back(tie.node);
    else
      by_time += has_ended;
    gone[t] = loses || has_ended;
  }
  std::size_t next = 0;
  std::erase_if(ties.ties, [&](const weld::Tie&) { return gone[next++] != 0; });
  if (!lost.empty())
    findings.note({model.deck, 0, 0}, "",
                  fmt::format("{} tied nodes are free, first node {}: the shells that would carry them are deleted",
                              lost.size(), model.nodes.id[lost.front()]));
  if (by_time > 0)
    findings.note({model.deck, 0, 0}, "", fmt::format("{} tied nodes are free: their ties ended in the run", by_time));
  return lost;
}

/// Rigid welds that the run has opened are as open: of one that holds nothing any more a single node is left, which
/// moves freely.
void open_failed_welds(model::Model& model, const system::System& after) {
  for (model::RigidBody& body : model.rigid_bodies) {
    if (body.origin != model::RigidBody::Origin::weld || body.nodes.empty()) continue;
    const model::Index first = body.nodes.front();
    std::erase_if(body.nodes, [&](model::Index n) { return !after.map.dependent(after.node_of[n]); });
    if (body.nodes.empty()) body.nodes.push_back(first);
  }
}

/// Nodes that have torn off each other in the run are as free; the one that leads stands first.
void part_torn_nodes(model::Model& model, const system::System& after) {
  for (model::TiedNodes& tied : model.tied_nodes) {
    std::vector<model::Index> still;
    for (const model::Index n : tied.nodes) {
      const int node = after.node_of[n];
      if (!after.map.dependent(node)) continue;
      if (still.empty()) still.push_back(after.model_node[at(after.map.terms(node).front().node)]);
      still.push_back(n);
    }
    tied.nodes = std::move(still);
  }
  std::erase_if(model.tied_nodes, [](const model::TiedNodes& tied) { return tied.nodes.empty(); });
}

/// SPOTDEL = 1: a weld goes with its ties to one of its sheets.
void remove_welds_of(const std::vector<model::Index>& lost, system::System& system) {
  if (system.model.control.weld_of_deleted_shell != 1) return;
  for (const weld::Weld& weld : system.ties.welds) {
    if (weld.kind == weld::Weld::Kind::rigid || weld.kind == weld::Weld::Kind::connector) continue;
    const auto without = [&](model::Index sheet) {
      int ties = 0, gone = 0;
      for (const weld::Projection& end : weld.ends) {
        if (!end.tied || end.projection_case == 0 || end.tie.part != sheet) continue;
        ++ties;
        gone += std::ranges::count(lost, end.node) > 0;
      }
      return ties > 0 && gone == ties;
    };
    if (!without(weld.sheets[0]) && !without(weld.sheets[1])) continue;
    for (const model::Index element : weld.elements)
      if (const auto location = system.location_of(weld, element); location.group >= 0)
        system.groups[location.group]->remove(at(location.element));
  }
}

}  // namespace

LinearJob::LinearJob(const std::filesystem::path& directory, const RunArguments& arguments, PreparedDeck prepared,
                     Findings& findings, const system::System* after)
    : directory_(directory),
      arguments_(arguments),
      findings_(findings),
      deck_(std::move(prepared)),
      log_(directory / "run.log"),
      ties_(nvh::linear_ties(deck_.ties, findings)) {
  if (findings.errors() == 0) model_.emplace(nvh::linear_model(deck_.model, findings));
  if (model_ && after != nullptr) open_failed_welds(*model_, *after);
  if (model_ && after != nullptr) part_torn_nodes(*model_, *after);
  std::vector<model::Index> lost;
  if (findings.errors() == 0) lost = end_ties(*model_, after, ties_, findings);
  if (findings.errors() == 0) system_.emplace(*model_, ties_, findings);
  if (system_) remove_absent_elements(*system_);
  if (system_ && !lost.empty()) remove_welds_of(lost, *system_);
  if (system_ && after != nullptr) remove_deleted_elements(*system_, *after);
  if (findings.errors() == 0) matrices_.emplace(*system_, findings);
  setup_seconds_ = deck_.penetration_seconds + deck_.tie_seconds + clock_.seconds();
}

void LinearJob::report_findings() {
  start_log(log_, arguments_, deck_, findings_);
  print_findings(findings_);
  output::write_findings(directory_, findings_.all());
  findings_reported_ = true;
}

bool LinearJob::accepted() {
  if (findings_.errors() > 0) {
    std::string welds = report_refused_welds(deck_, findings_);
    welds += audit_table(deck_.model, deck_.ties, deck_.audit);
    start_log(log_, arguments_, deck_, findings_);
    log_.add(welds);
    refuse(directory_, log_, findings_);
    if (!arguments_.quiet) fmt::print(stderr, "{}", welds);
    return false;
  }
  report_findings();
  log_.add(log_model(deck_.model));
  log_.add(log_ties(deck_.model, deck_.ties, no_limit) + log_tied_nodes(deck_.model, deck_.ties));
  setup_seconds_ += clock_.seconds();
  return true;
}

output::Header LinearJob::header() const {
  return {deck_.model.title, fmt::format("nugget {}", NUGGET_VERSION), today()};
}

output::Summary& LinearJob::summary() {
  if (summary_) return *summary_;
  output::Summary& s = summary_.emplace();
  s.version = NUGGET_VERSION;
  s.deck = arguments_.deck;
  s.load_case = arguments_.load_case;
  s.files = deck_.files;
  s.units = unit_name(deck_.model);
  s.title = deck_.model.title;
  s.date = today();
  s.count = counts(deck_.model, deck_.ties);
  s.seconds.read = deck_.read_seconds;
  s.seconds.setup = setup_seconds_;
  s.peak_memory = peak_memory();
  s.threads = threads();
  s.ranks = nvh::ranks();
  s.welds = deck_.welds;
  return s;
}

void LinearJob::write_summary() {
  output::write_welds(directory_, summary().welds);
  output::write_column_units(directory_, model::units_of(deck_.model));  // of the tables that are there by now
  output::write_summary(directory_, summary());
}

void LinearJob::report_more(const Findings& more) {
  if (more.all().empty()) return;
  for (const Finding& f : more.all()) {
    findings_.add(f);
    fmt::print(stderr, "{}\n", to_string(f));
    log_.add(fmt::format(" {}\n\n", to_string(f)));
  }
  output::write_findings(directory_, findings_.all());
}

ExitCode LinearJob::give_up(const std::string& why) {
  if (!findings_reported_) report_findings();
  summary().termination = "error";
  summary().message = why;
  write_summary();
  return end({impact::Termination::error, why});
}

ExitCode LinearJob::end(const impact::Outcome& outcome, const std::string& done) {
  log_.add(log_termination(outcome));
  if (!outcome.message.empty()) fmt::print(stderr, "{}\n", outcome.message);
  if (!done.empty() && !arguments_.quiet)
    fmt::print(stderr, "{}; results in {}, to begin with {}\n", done, directory_.string(),
               (directory_ / "report.html").string());
  fmt::print("{}", log_termination({outcome.termination, {}}));
  return outcome.termination == impact::Termination::normal ? ExitCode::normal : ExitCode::error_termination;
}

}  // namespace nugget::app
