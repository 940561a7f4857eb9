// SPDX-License-Identifier: Apache-2.0
#include "app/linear_job.hpp"

#include <utility>

#include "app/outcome.hpp"
#include "app/run_log.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"
#include "base/peak_memory.hpp"
#include "nvh/matrices/linear_model.hpp"
#include "nvh/matrices/ranks.hpp"
#include "output/column_units.hpp"

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
  if (findings.errors() == 0) system_.emplace(*model_, ties_, findings);
  if (system_) remove_absent_elements(*system_);
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
    start_log(log_, arguments_, deck_, findings_);
    refuse(directory_, log_, findings_);
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

output::Summary LinearJob::summary() const {
  output::Summary s;
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

void LinearJob::write(const output::Summary& summary) const {
  output::write_welds(directory_, summary.welds);
  output::write_column_units(directory_, model::units_of(deck_.model));  // of the tables that are there by now
  output::write_summary(directory_, summary);
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
