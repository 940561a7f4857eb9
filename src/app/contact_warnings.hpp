// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace nugget::impact {
class Simulation;
}
namespace nugget::output {
struct Summary;
}

// What the end of a run says of its contacts; empty where there is nothing to say.
namespace nugget::app {

/// Springs of contact that were dropped under load stopped nothing any more: bodies went into or through each other.
std::string dropped_spring_warning(const impact::Simulation& run, const output::Summary& summary);

/// A contact takes energy and gives some of it back. What it gave beyond that drives the model; the energy ratio, which
/// counts the work of contact, stays at 1.
std::string giving_contact_warning(const impact::Simulation& run, const output::Summary& summary);

}  // namespace nugget::app
