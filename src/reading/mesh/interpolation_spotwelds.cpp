// SPDX-License-Identifier: Apache-2.0
#include "reading/mesh/interpolation_spotwelds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

#include "kernel/contact/closest_point.hpp"

namespace nugget::reading {
namespace {

const char* keyword_of_card(const InterpolationSpotweld& card) {
  return card.rivets() ? "CONSTRAINED_SPR2" : "CONSTRAINED_INTERPOLATION_SPOTWELD";
}

template <class Items>
int next_id(const Items& items) {
  int next = 1;
  for (const auto& item : items) next = std::max(next, item.id + 1);
  return next;
}

class Making {
 public:
  Making(Model& model, Findings& findings) : m_(model), findings_(findings) {}

  void run() {
    for (std::size_t c = 0; c < m_.interpolation_spotwelds.size(); ++c) {
      const InterpolationSpotweld& card = m_.interpolation_spotwelds[c];
      const Index part = add_part(card);
      std::vector<Index> nodes = card.nodes;
      std::sort(nodes.begin(), nodes.end());
      const bool ids_of_nodes = can_have_ids_of(nodes);
      const std::size_t first = m_.beams.size();
      for (const Index node : nodes) add_weld(card, part, node, ids_of_nodes);
      add_tie(card, part);
      add_to_sections(card, part);
      if (!nodes.empty()) report(card, m_.parts[part], first, ids_of_nodes);
    }
  }

 private:
  Index add_part(const InterpolationSpotweld& card);
  bool can_have_ids_of(const std::vector<Index>& nodes) const {
    return !nodes.empty() && (m_.beams.id.empty() || m_.beams.id.back() < m_.nodes.id[nodes.front()]);
  }
  void add_weld(const InterpolationSpotweld& card, Index part, Index location, bool id_of_node);
  Index add_node(Index location);
  Index closest_part(const std::vector<Index>& parts, const Vec3d& x) const;
  void add_tie(const InterpolationSpotweld& card, Index part);
  void add_to_sections(const InterpolationSpotweld& card, Index part);
  void report(const InterpolationSpotweld& card, const Part& part, std::size_t first, bool ids_of_nodes) const;

  Model& m_;
  Findings& findings_;
};

Index Making::add_part(const InterpolationSpotweld& card) {
  const double area = std::numbers::pi * card.radius * card.radius, mass = card.density * area * card.thickness;
  SectionBeam section;
  section.id = next_id(m_.beam_sections);
  section.elform = 6;
  section.outer = {2.0 * card.radius, 2.0 * card.radius};
  section.volume = area * card.thickness;
  // Of a cylinder about an axis across it.
  section.inertia = mass * (3.0 * card.radius * card.radius + card.thickness * card.thickness) / 12.0;
  section.place = card.place;
  kernel::DiscreteBeam law;
  law.joint = card.law;
  const auto stiffness = std::visit([](const auto& joint) { return joint.stiffness(); }, card.law);
  for (std::size_t i = 0; i < 6; ++i) {
    law.dof[i].kind = kernel::DiscreteSpring::Kind::linear;
    law.dof[i].stiffness = stiffness[i];
  }
  Part part;
  part.id = card.part != 0 ? card.part : next_id(m_.parts);
  part.title = !card.title.empty() ? card.title : card.rivets() ? "self-piercing rivets" : "interpolation spot welds";
  part.kind = ElementKind::beam;
  part.section = static_cast<Index>(m_.beam_sections.size());
  part.material = static_cast<Index>(m_.materials.size());
  part.place = card.place;
  m_.beam_sections.push_back(section);
  m_.materials.push_back({next_id(m_.materials), part.title, keyword_of_card(card), card.density, law, card.place});
  m_.parts.push_back(part);
  return static_cast<Index>(m_.parts.size()) - 1;
}

Index Making::add_node(Index location) {
  m_.nodes.id.push_back(m_.nodes.id.back() + 1);
  m_.nodes.x.push_back(Vec3d(m_.nodes.x[location]));
  if (!m_.initial_velocity.empty()) m_.initial_velocity.push_back({});
  if (!m_.initial_spin.empty()) m_.initial_spin.push_back({});
  return static_cast<Index>(m_.nodes.size()) - 1;
}

Index Making::closest_part(const std::vector<Index>& parts, const Vec3d& x) const {
  if (parts.size() == 1) return parts.front();
  Index closest = none;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < m_.shells.size(); ++e) {
    const Index part = m_.shells.part[e];
    if (std::find(parts.begin(), parts.end(), part) == parts.end()) continue;
    const auto& n = m_.shells.node[e];
    const kernel::Corners corners{m_.nodes.x[n[0]], m_.nodes.x[n[1]], m_.nodes.x[n[2]], m_.nodes.x[n[3]]};
    const double distance = kernel::closest_point(corners, m_.shells.triangle(e), x).distance;
    if (!(distance < least)) continue;
    least = distance;
    closest = part;
  }
  return closest;
}

void Making::add_weld(const InterpolationSpotweld& card, Index part, Index location, bool id_of_node) {
  const Vec3d x = m_.nodes.x[location];
  const int next = m_.beams.id.empty() ? 1 : m_.beams.id.back() + 1;
  const Index first = add_node(location), second = add_node(location);
  m_.beams.id.push_back(id_of_node ? m_.nodes.id[location] : next);
  m_.beams.part.push_back(part);
  m_.beams.node.push_back({first, second});
  m_.beams.orientation.push_back(none);
  m_.beams.direction.push_back({});
  m_.beams.tied_parts.push_back({closest_part(card.sheet[0], x), closest_part(card.sheet[1], x)});
  m_.beams.place.push_back(card.place);
}

void Making::add_tie(const InterpolationSpotweld& card, Index part) {
  constexpr double share_of_tolerance = 0.6;  // of |SAST| + |SBST|: the reach of weld::tie
  Contact tie;
  tie.keyword = keyword_of_card(card);
  tie.title = card.title;
  tie.kind = Contact::Kind::spotweld;
  tie.a.parts = {part};
  for (const std::vector<Index>& sheet : card.sheet) tie.b.parts.insert(tie.b.parts.end(), sheet.begin(), sheet.end());
  tie.thickness_a = -card.thickness / share_of_tolerance;
  tie.place = card.place;
  m_.contacts.push_back(std::move(tie));
}

/// A plane that cuts parts of both sheets cuts the welds between them, whose part no PSID can name.
void Making::add_to_sections(const InterpolationSpotweld& card, Index part) {
  for (CrossSection& section : m_.requests.cross_sections) {
    const auto cuts = [&section](const std::vector<Index>& sheet) {
      return std::ranges::find_first_of(section.parts, sheet) != section.parts.end();
    };
    if (section.plane && cuts(card.sheet[0]) && cuts(card.sheet[1])) section.parts.push_back(part);
  }
}

void Making::report(const InterpolationSpotweld& card, const Part& part, std::size_t first, bool ids_of_nodes) const {
  const std::size_t count = m_.beams.size() - first;
  const std::string beams = count == 1 ? fmt::format("beam {}", m_.beams.id[first])
                                       : fmt::format("beams {} to {}", m_.beams.id[first], m_.beams.id.back());
  findings_.note(card.place, fmt::format("*{}", keyword_of_card(card)),
                 fmt::format("{} {}{}, {}: {} of part {}, with nodes {} to {}, made for {}", count,
                             card.rivets() ? "rivet" : "weld", count == 1 ? "" : "s",
                             ids_of_nodes ? "with the ids of the location nodes" : "in the order of the location nodes",
                             beams, part.id, m_.nodes.id.back() - 2 * static_cast<int>(count) + 1, m_.nodes.id.back(),
                             count == 1 ? "it" : "them"));
}

}  // namespace

Model with_interpolation_spotwelds(Model model, Findings& findings) {
  if (findings.errors() == 0) Making(model, findings).run();
  return model;
}

}  // namespace nugget::reading
