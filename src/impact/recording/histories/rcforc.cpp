// SPDX-License-Identifier: Apache-2.0
#include "output/rcforc.hpp"

#include <algorithm>

#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

/// Marks the system's nodes of a surface.
std::vector<unsigned char> nodes_of(const system::System& system, const model::Surface& surface) {
  const model::Model& model = system.model;
  std::vector<unsigned char> marked(system.nodes, surface.everything ? 1 : 0), in(model.parts.size(), 0);
  const auto mark = [&](model::Index n) { marked[system.node_of[n]] = 1; };
  for (model::Index p : surface.parts) in[p] = 1;
  for (std::size_t e = 0; e < model.shells.size(); ++e)
    if (in[model.shells.part[e]]) std::for_each(model.shells.node[e].begin(), model.shells.node[e].end(), mark);
  for (std::size_t e = 0; e < model.solids.size(); ++e)
    if (in[model.solids.part[e]]) std::ranges::for_each(model.solids.nodes(e), mark);
  for (std::size_t e = 0; e < model.beams.size(); ++e)
    if (in[model.beams.part[e]]) std::for_each(model.beams.node[e].begin(), model.beams.node[e].begin() + 2, mark);
  for (const model::Segment& s : surface.segments) std::for_each(s.begin(), s.end(), mark);
  std::for_each(surface.nodes.begin(), surface.nodes.end(), mark);
  return marked;
}

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
