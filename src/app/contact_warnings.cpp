// SPDX-License-Identifier: Apache-2.0
#include "app/contact_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "impact/simulation/simulation.hpp"
#include "output/summary.hpp"

namespace nugget::app {

std::string dropped_spring_warning(const impact::Simulation& run, const output::Summary& summary) {
  const output::Summary::Energies& e = summary.energy;
  const contact::Drops drops = run.components().contacts.energies().drops;
  const double internal = std::abs(e.internal) + std::abs(e.eroded);
  if (summary.termination == "error" || drops.energy <= output::EnergyLimits::lost_in_contact * internal ||
      drops.energy <= 1e-3 * std::abs(e.initial + e.external))
    return {};
  const system::System& system = run.system();
  return fmt::format(
      "warning: contact dropped {} springs under load, and with them {:.3g} of energy, beside an internal energy of "
      "{:.3g}; the largest, of {:.3g}, at node {} against node {} at time {:.4g}: bodies went too deep into each "
      "other, "
      "or off an edge [run.log has each contact; look there in d3plot; stiffer with SFSA, SFSB, SLSFAC or SOFT = 1 or "
      "2, or with finer elements where they meet]",
      drops.count, drops.energy, e.internal, drops.largest, system.node_id(drops.node), system.node_id(drops.other),
      drops.time);
}

std::string giving_contact_warning(const impact::Simulation& run, const output::Summary& summary) {
  const output::Summary::Energies& e = summary.energy;
  const double held = e.contact_springs + e.contact_friction + e.contact_damping + e.contact_lost,
               given = held - e.contact, internal = std::abs(e.internal) + std::abs(e.eroded);
  if (summary.termination == "error" || given <= output::EnergyLimits::given_by_contact * internal ||
      given <= 1e-3 * std::abs(e.initial + e.external))
    return {};
  const auto& contacts = run.system().model.contacts;
  const bool has_levers =
      std::any_of(contacts.begin(), contacts.end(), [](const model::Contact& c) { return c.glue && !c.glue->moments; });
  return fmt::format(
      "warning: contacts gave {:.3g} of energy that they never got, beside an internal energy of {:.3g}, most of it {} "
      "[sleout has each contact: move sheets that lie in each other at the start apart, or give IGNORE; finer elements "
      "where they meet, SOFT = 1 or 2{}]",
      given, e.internal, run.components().contacts.giving_most(run.system()),
      has_levers
          ? "; glue between sheets that turn: OPTION -1, -2 or -3 of _TIEBREAK hands over the moment of its shear"
          : "");
}

}  // namespace nugget::app
