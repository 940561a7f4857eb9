// SPDX-License-Identifier: Apache-2.0
#include "impact/recording/contact_sides.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "impact/contact/contact_setup.hpp"

namespace nugget::impact {

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

ContactSides::ContactSides(const system::System& system) : alive_(system.model) {
  using output::ContactSide;
  int place = 0;
  for (const model::Contact& card : system.model.contacts) {
    const int here = card.slides() ? place++ : -1;
    const bool transducer = card.kind == model::Contact::Kind::transducer && card.b.empty();
    if (!card.slides() && !transducer) continue;
    const bool single = transducer || card.kind == model::Contact::Kind::single_surface;
    if (card.prints_a || (single && card.prints_b)) add(system, card, here, ContactSide::tracked);
    if (card.prints_b && !single) add(system, card, here, ContactSide::reference);
  }
  std::ranges::stable_sort(sides_, {}, [](const Side& s) { return std::pair{s.card->id, s.side}; });
  // Of contacts with one id, which are warned of, the first: a branch of binout has one list of nodes.
  const auto same = [](const Side& s, const Side& t) { return s.card->id == t.card->id && s.side == t.side; };
  sides_.erase(std::unique(sides_.begin(), sides_.end(), same), sides_.end());
}

void ContactSides::add(const system::System& system, const model::Contact& card, int place, output::ContactSide side) {
  Side& added = sides_.emplace_back(Side{&card, place, side, {}, {}, {}});
  // A transducer has the faces that a contact of its surface with itself would have.
  model::Contact surface = card;
  if (place < 0) surface.kind = model::Contact::Kind::single_surface;
  const bool single = surface.kind == model::Contact::Kind::single_surface;
  const unsigned of_side = side == output::ContactSide::tracked ? 1 : 2;
  for (const contact::Segment& s : contact_setup(system, surface).segments)
    if (single || (s.side & of_side) != 0) added.faces.push_back({{s.node}, s.element, s.covered_by});
  std::vector<int> all(added.faces.size());
  std::iota(all.begin(), all.end(), 0);
  added.around = contact::NodeSegments(added.faces, all);
}

std::vector<output::NcforcSide> ContactSides::sides() const {
  std::vector<output::NcforcSide> sides;
  for (const Side& s : sides_) sides.push_back({s.card->id, s.side, {}});
  return sides;
}

void ContactSides::list_nodes(const Snapshot& now, Side& side) const {
  const std::vector<contact::PenaltyContact>& contacts = now.components.contacts.all();
  std::vector<char> listed(now.system.nodes, 0);
  if (side.place < 0) {
    const std::vector<unsigned char> marked = nodes_of(now.system, side.card->a);
    for (const contact::PenaltyContact& contact : contacts)
      contact.each_node([&](int n) {
        if (static_cast<std::size_t>(n) < marked.size() && marked[n] != 0) listed[n] = 1;
      });
  } else {
    const unsigned char of_side = side.side == output::ContactSide::tracked ? 0 : 1;
    contacts[static_cast<std::size_t>(side.place)].each_node_of_sides([&](int n, unsigned char on) {
      if (on == of_side) listed[n] = 1;
    });
  }
  for (std::size_t n = 0; n < listed.size(); ++n)
    if (listed[n] != 0) side.nodes.push_back(static_cast<int>(n));
  std::ranges::sort(side.nodes, {}, [&](int n) { return now.system.node_id(n); });
}

Vec3d ContactSides::force(const Snapshot& now, const Side& side, int node) const {
  const std::vector<contact::PenaltyContact>& contacts = now.components.contacts.all();
  if (side.place >= 0) return contacts[static_cast<std::size_t>(side.place)].force_on(node);
  Vec3d sum;
  for (const contact::PenaltyContact& contact : contacts) sum += contact.force_on(node);
  return sum;
}

double ContactSides::pressure(const Snapshot& now, const Side& side, int node, const Vec3d& force) const {
  if (dot(force, force) == 0.0) return 0.0;
  Vec3d normal;
  double area = 0.0;
  for (const int f : side.around.at(node)) {
    const Face& face = side.faces[f];
    if (!contact::is_exposed(face, alive_.all())) continue;
    const auto corner = [&](std::size_t c) { return vec(now.state.x[face.node[c]]); };
    const Vec3d whole = 0.5 * cross(corner(2) - corner(0), corner(3) - corner(1));
    const Vec3d share = (1.0 / face.corners()) * whole;
    // Shells of one sheet may be numbered either way round.
    normal += dot(normal, share) < 0.0 ? -share : share;
    area += norm(share);
  }
  const double length = norm(normal);
  return area > 0.0 && length > 0.0 ? std::abs(dot(force, normal)) / (length * area) : 0.0;
}

output::NcforcState ContactSides::state(const Snapshot& now) {
  if (!listed_)
    for (Side& side : sides_) list_nodes(now, side);
  listed_ = true;
  alive_.update(now.system);
  output::NcforcState state{now.state.time, sides()};
  for (std::size_t i = 0; i < sides_.size(); ++i)
    for (const int node : sides_[i].nodes) {
      const Vec3d on_node = force(now, sides_[i], node);
      state.sides[i].rows.push_back(
          {now.system.node_id(node), on_node, pressure(now, sides_[i], node, on_node), vec(now.state.x[node])});
    }
  return state;
}

}  // namespace nugget::impact
