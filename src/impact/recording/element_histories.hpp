// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "impact/recording/result_parcels.hpp"
#include "impact/simulation/snapshot.hpp"
#include "output/elout.hpp"

namespace nugget::impact {

/// Stresses, strains and resultants of the elements of *DATABASE_HISTORY_... Elements without a kernel (rigid parts)
/// are not in it; deleted ones stay, without stress.
output::EloutState elout_state(const Snapshot& now);

/// The same, some rows of a table at a time: `take` gets them on the process that writes, others give theirs to it.
/// Strains of shells are in the rows of either table.
void pass_elout(const Snapshot& now, output::EloutTable table, ResultParcels& parcels,
                const std::function<void(const output::EloutState&)>& take);
/// Its rows without what elements hold.
void blank_elout(const system::System& system, output::EloutTable table,
                 const std::function<void(const output::EloutState&)>& take);
/// What elout says besides elements.
output::EloutState elout_head(const Snapshot& now);
/// The tables that go from rank to rank, in their order: strains have to be printed in tables of their own.
std::vector<output::EloutTable> passed_tables(const model::Model& model);
/// On another rank than the first: its share of what that writes.
void give_elout(const Snapshot& now);

/// LS-DYNA's number of the laws that beams can have; 0 where it is not known.
int number_of_law(const model::Material& material);

}  // namespace nugget::impact
