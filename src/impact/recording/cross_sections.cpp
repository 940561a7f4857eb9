// SPDX-License-Identifier: Apache-2.0
#include "impact/recording/cross_sections.hpp"

#include "base/index.hpp"
#include "impact/conditions/axes_now.hpp"
#include "impact/conditions/preloads.hpp"

namespace nugget::impact {
namespace {

using model::ElementKind;

}  // namespace

CrossSections::CrossSections(const system::System& system) : system_(system) {
  for (const model::CrossSection& card : system.model.requests.cross_sections) {
    Section section{&card, {}};
    std::vector<char> marked(system.all_nodes(), 0);
    for (const model::Index n : card.nodes) marked[system.node_of[n]] = 1;
    for (const model::CrossSection::Facet& facet : card.facets) {
      const system::System::ElementLocation s = system_.location_of(facet.kind, facet.element);
      if (s.group < 0) continue;
      const system::ElementGroup& group = *system.groups[s.group];
      const auto nodes = group.nodes(at(s.element));
      for (int a = 0; a < group.nodes_per_element; ++a)
        if (marked[nodes[a]]) section.corners.push_back({s, a, at(nodes[a])});
    }
    sections_.push_back(std::move(section));
  }
}

CrossSections::Area CrossSections::area(const Section& section, const Snapshot& now) const {
  const auto place = [&](const model::CrossSection::Corner& c) {
    const Vec3d a = vec(now.state.x[system_.node_of[c.from]]), b = vec(now.state.x[system_.node_of[c.to]]);
    return a + c.share * (b - a);
  };
  Area sum;
  const auto add = [&](double size, const Vec3d& centre) {
    sum.size += size;
    sum.centroid += size * centre;
  };
  for (const model::CrossSection::Facet& facet : section.card->facets) {
    const system::System::ElementLocation s = system_.location_of(facet.kind, facet.element);
    if (facet.corners.empty() || s.group < 0) continue;
    const system::ElementGroup& group = *system_.groups[s.group];
    if (!group.alive(at(s.element))) continue;
    const Vec3d first = place(facet.corners[0]);
    if (facet.kind == ElementKind::beam) {
      add(beam_area(system_.model, facet.element), first);
    } else if (facet.kind == ElementKind::shell) {
      const Vec3d second = place(facet.corners[1]);
      add(group.thickness(at(s.element)) * norm(second - first), 0.5 * (first + second));
    } else {
      for (std::size_t i = 1; i + 1 < facet.corners.size(); ++i) {
        const Vec3d b = place(facet.corners[i]), c = place(facet.corners[i + 1]);
        add(0.5 * norm(cross(b - first, c - first)), (1.0 / 3.0) * (first + b + c));
      }
    }
  }
  if (sum.size > 0.0) {
    sum.centroid = (1.0 / sum.size) * sum.centroid;
  } else {
    const auto& nodes = section.card->nodes;
    for (const model::Index n : nodes)
      sum.centroid += (1.0 / static_cast<double>(nodes.size())) * vec(now.state.x[system_.node_of[n]]);
  }
  return sum;
}

Frame3d CrossSections::axes(const model::CrossSection& card, const Snapshot& now) const {
  if (card.system != model::none) return axes_now(system_, now.state, card.system);
  if (card.accelerometer != model::none)
    return accelerometer_axes(system_, now.state, system_.model.accelerometers[card.accelerometer]);
  if (card.rigid_body == model::none) return card.axes;
  // The body's own axes were the global ones at time 0.
  const Frame3d& turned = system_.bodies[system_.body_of[card.rigid_body]].axes;
  return {turned.global(card.axes.e1), turned.global(card.axes.e2), turned.global(card.axes.e3)};
}

output::SecforcState CrossSections::state(const Snapshot& now) const {
  output::SecforcState state;
  state.time = now.state.time;
  for (const Section& section : sections_) {
    const model::CrossSection& card = *section.card;
    const Area where = area(section, now);
    Vec3d force{}, moment{};
    for (const Corner& c : section.corners) {
      const Vec3d f = system_.nodal_force(c.location, c.corner);
      force += f;
      moment += system_.nodal_moment(c.location, c.corner) + cross(vec(now.state.x[c.node]) - where.centroid, f);
    }
    const Frame3d frame = axes(card, now);
    output::SecforcRow row{
        card.id, frame.local(force), frame.local(moment), where.centroid, where.size, output::SectionAxes::global, 0};
    if (card.system != model::none) {
      row.axes = output::SectionAxes::system;
      row.axes_id = system_.model.systems[card.system].id;
    } else if (card.accelerometer != model::none) {
      row.axes = output::SectionAxes::accelerometer;
      row.axes_id = system_.model.accelerometers[card.accelerometer].id;
    } else if (card.rigid_body != model::none) {
      row.axes = output::SectionAxes::rigid_body;
      row.axes_id = system_.model.rigid_bodies[card.rigid_body].id;
    }
    state.rows.push_back(row);
  }
  return state;
}

}  // namespace nugget::impact
