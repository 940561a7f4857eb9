// SPDX-License-Identifier: Apache-2.0
#include "output/sleout.hpp"

#include <algorithm>
#include <array>

#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

output::SleoutState sleout_state(const Snapshot& now) {
  output::SleoutState s;
  s.time = now.state.time;
  s.cycle = now.state.cycle + 1;
  std::size_t c = 0;
  for (const model::Contact& card : now.system.model.contacts) {
    if (!card.slides()) continue;
    const contact::PenaltyContact& contact = now.components.contacts.all()[c++];
    const std::array<double, 2> energy = contact.energy_of_sides();
    const bool single = card.kind == model::Contact::Kind::single_surface;
    s.rows.push_back({card.id, energy[0], energy[1], single, contact.energies().friction});
  }
  for (std::size_t i = 0; i < now.components.interiors.all().size(); ++i)
    s.rows.push_back({now.system.model.interiors[i].id, now.components.interiors.all()[i].energy(), 0.0, true, 0.0});
  return s;
}

}  // namespace

template <>
HistoryFile history<"sleout">() {
  return make_history(output::sleout(), sleout_state,
                      {.concerns =
                           [](const system::System& system) {
                             return !system.model.interiors.empty() ||
                                    std::ranges::any_of(system.model.contacts,
                                                        [](const auto& c) { return c.slides(); });
                           },
                       .legends =
                           [](const model::Model& model) {
                             return std::vector<Legend>{{"sleout", titles_of_contacts(model)}};
                           }});
}

}  // namespace nugget::impact
