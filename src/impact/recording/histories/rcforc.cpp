// SPDX-License-Identifier: Apache-2.0
#include "output/rcforc.hpp"

#include "impact/recording/contact_sides.hpp"
#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

output::RcforcState rcforc_state(const Snapshot& now) {
  output::RcforcState s;
  s.time = now.state.time;
  std::size_t c = 0;
  for (std::size_t i = 0; i < now.system.model.contacts.size(); ++i) {
    const model::Contact& card = now.system.model.contacts[i];
    const auto add = [&](output::ContactSide side, const Vec3d& force) {
      s.rows.push_back({card.id, side, force, 0.0});
    };
    if (card.slides()) {
      const Vec3d force = now.components.contacts.all()[c++].resultant();
      add(output::ContactSide::tracked, force);
      if (card.kind != model::Contact::Kind::single_surface) add(output::ContactSide::reference, -force);
    } else if (card.kind == model::Contact::Kind::transducer) {
      const contact::TwoBodies bodies{nodes_of(now.system, card.a), nodes_of(now.system, card.b)};
      const bool of_two = !card.b.empty();
      Vec3d sum;
      for (const contact::PenaltyContact& contact : now.components.contacts.all())
        sum += of_two ? contact.force_between(bodies) : contact.force_on(bodies.in_a);
      add(output::ContactSide::tracked, sum);
      if (of_two) add(output::ContactSide::reference, -sum);
    } else if (card.tie_by_springs() || card.penalty_fallback) {
      const Vec3d force = now.components.tie_forces.resultant(static_cast<model::Index>(i));
      add(output::ContactSide::tracked, force);
      add(output::ContactSide::reference, -force);
    }
  }
  return s;
}

}  // namespace

template <>
HistoryFile history<"rcforc">() {
  return make_history(output::rcforc(), rcforc_state, {.legends = [](const model::Model& model) {
                        return std::vector<Legend>{{"rcforc", titles_of_contacts(model)}};
                      }});
}

}  // namespace nugget::impact
