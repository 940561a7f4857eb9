// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "impact/simulation/snapshot.hpp"
#include "output/dcfail.hpp"
#include "output/summary.hpp"
#include "output/swforc.hpp"

// What results say of welds: the one place that asks a weld whether it is a beam, bricks, rigid, a rivet or a
// connector.
namespace nugget::impact {

/// Forces and failure values of all welds at this time: deformable ones, rigid ones, rivets.
output::SwforcState swforc_state(const Snapshot& now);
/// Failure of welds by *DEFINE_CONNECTION_PROPERTIES at this time.
output::DcfailState dcfail_state(const Snapshot& now);

/// Adds to the reports what happened to the welds during the run: failure, peaks, last load, damage, energy. One report
/// a weld, in the order of `system.ties.welds`.
void add_weld_results(const system::System& system, const Components& components,
                      std::vector<output::WeldReport>& reports);

}  // namespace nugget::impact
