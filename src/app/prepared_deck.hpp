// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "base/finding.hpp"
#include "base/ranks.hpp"
#include "output/summary.hpp"
#include "weld/audit/audit.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::app {

/// What comes out of reading and checking a deck, resolving its initial penetrations, tying and auditing its welds.
struct PreparedDeck {
  PreparedDeck();
  PreparedDeck(const PreparedDeck&);
  PreparedDeck(PreparedDeck&&) noexcept;
  PreparedDeck& operator=(const PreparedDeck&);
  PreparedDeck& operator=(PreparedDeck&&) noexcept;
  ~PreparedDeck();

  bool has_text = false;  ///< the deck could be opened and is not empty
  std::uint64_t deck_checksum = 0;
  std::vector<std::string> files;  ///< that were read, by their whole paths, the master file first
  model::Model model;
  weld::Ties ties;
  bool is_tied = false;                   ///< ties, audit and welds are there
  std::vector<weld::Report> audit;        ///< one a weld
  std::vector<output::WeldReport> welds;  ///< one a weld, for welds.csv and summary.json
  double read_seconds = 0.0, penetration_seconds = 0.0, tie_seconds = 0.0, audit_seconds = 0.0;
};

/// Whether what is to be done with the deck goes up to its end time; modes and responses have none, whatever else the
/// deck asks for.
enum class EndTime { needed, not_needed };

/// Calls `work`, which ranks can do together, with them, or with null where there is but one, once the deck is read.
using WorkTogether = std::function<void(const PreparedDeck& read, const std::function<void(Ranks*)>& work)>;

/// Reads, checks, resolves initial penetrations, ties and audits, the same for a check, a run and linear analyses.
/// Findings hold what was wrong; after errors nothing is tied. `together`: null where there is one process.
PreparedDeck prepare(const RunArguments& arguments, Findings& findings, EndTime end_time = EndTime::needed,
                     const WorkTogether& together = nullptr);

/// Warns where the deck asks for a frequency response and for an explicit run, in which there is none; `nugget frf`
/// computes it all the same.
void warn_of_response_in_explicit_run(const model::Model& model, Findings& findings);

/// Ties and audits what there is of the welds of a deck that has errors, unless that was done before they came, for
/// `nugget check` and a run that is refused: the account of them, empty where there are none.
std::string report_refused_welds(PreparedDeck& prepared, Findings& findings);

}  // namespace nugget::app
