// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "impact/simulation/snapshot.hpp"
#include "output/abstat.hpp"
#include "output/bndout.hpp"
#include "output/deforc.hpp"
#include "output/glstat.hpp"
#include "output/jntforc.hpp"
#include "output/matsum.hpp"
#include "output/nodout.hpp"
#include "output/rbdout.hpp"
#include "output/rcforc.hpp"
#include "output/rwforc.hpp"
#include "output/sleout.hpp"
#include "output/spcforc.hpp"

// What the history files want to know of a moment, one function a file.
namespace nugget::impact {

output::GlstatState glstat_state(const Snapshot& now);
output::MatsumState matsum_state(const Snapshot& now);
output::NodoutState nodout_state(const Snapshot& now);
output::DeforcState deforc_state(const Snapshot& now);
output::JntforcState jntforc_state(const Snapshot& now);
output::AbstatState abstat_state(const Snapshot& now);
output::RwforcState rwforc_state(const Snapshot& now);
output::SpcforcState spcforc_state(const Snapshot& now);
output::BndoutState bndout_state(const Snapshot& now);
output::RbdoutState rbdout_state(const Snapshot& now);
output::RcforcState rcforc_state(const Snapshot& now);
output::SleoutState sleout_state(const Snapshot& now);

}  // namespace nugget::impact
