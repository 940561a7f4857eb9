// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/clock.hpp"
#include "app/command.hpp"
#include "impact/simulation/options.hpp"
#include "nvh/matrices/factorization.hpp"
#include "nvh/matrices/matrices.hpp"
#include "output/ascii.hpp"
#include "output/summary.hpp"

namespace nugget::app {

/// A linear analysis (modes, responses over frequency, statics) of a prepared deck, into a folder whose old results are
/// gone: what comes before the first equation is solved, and what all of them leave behind.
class LinearJob {
 public:
  /// Ties, elements and matrices as linear analyses have them; no matrices after errors. Elements deleted in the run
  /// `after` take no part.
  LinearJob(const std::filesystem::path& directory, const RunArguments& arguments, PreparedDeck prepared,
            Findings& findings, const system::System* after = nullptr);
  LinearJob(const LinearJob&) = delete;
  LinearJob& operator=(const LinearJob&) = delete;

  PreparedDeck& deck() { return deck_; }
  bool assembled() const { return matrices_.has_value(); }
  nvh::Matrices& matrices() { return *matrices_; }

  /// Reports the findings, parts and ties. False: there were errors, and the deck is refused.
  bool accepted();
  /// Runs `work`; where the solver gives up, that is reported and ends the job.
  template <class Work>
  ExitCode attempt(Work work) {
    try {
      return work();
    } catch (const nvh::Factorization::SolverError& error) {
      return give_up(error.text);
    }
  }

  /// Wall time since the last call, or since the matrices were there.
  double seconds() { return clock_.seconds(); }
  output::Header header() const;
  /// What summary.json gets, also where the solver gives up: the keys that all analyses have, and what they add.
  output::Summary& summary();
  void write_summary();
  /// Findings about the solution, behind those that `accepted` has reported.
  void report_more(const Findings& more);
  void add_to_log(const std::string& text) { log_.add(text); }
  /// `done`: what was done, in words, for the terminal.
  ExitCode end(const impact::Outcome& outcome, const std::string& done = {});

 private:
  void report_findings();
  ExitCode give_up(const std::string& why);

  std::filesystem::path directory_;
  RunArguments arguments_;
  Findings& findings_;
  PreparedDeck deck_;
  Log log_;
  bool findings_reported_ = false;
  Clock clock_;
  weld::Ties ties_;
  std::optional<model::Model> model_;
  std::optional<system::System> system_;
  std::optional<nvh::Matrices> matrices_;
  std::optional<output::Summary> summary_;
  double setup_seconds_ = 0.0;
};

}  // namespace nugget::app
