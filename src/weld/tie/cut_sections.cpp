// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/cut_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace nugget::weld {
namespace {

/// Where the ends of welds are held, and all other nodes where they stand.
std::vector<Vec3d> places_of_holds(const Ties& ties) {
  std::vector<Vec3d> x = ties.x;
  for (const Weld& weld : ties.welds) {
    if (weld.kind == Weld::Kind::rigid || weld.deleted) continue;
    for (const Projection& end : weld.ends)
      if (end.tied && end.projection_case != 0) x[end.node] = end.tie.point;
  }
  return x;
}

}  // namespace

void cut_sections(model::Model& model, const Ties& ties, Findings& findings) {
  model::Requests& requests = model.requests;
  const auto by_plane = [](const model::CrossSection& section) { return section.plane.has_value(); };
  if (std::ranges::none_of(requests.cross_sections, by_plane)) return;
  const std::vector<Vec3d> x = places_of_holds(ties);
  for (model::CrossSection& section : requests.cross_sections) {
    if (!section.plane) continue;
    model::cut(model, x, section);
    if (!section.facets.empty()) continue;
    Finding finding;
    finding.severity = Severity::warning;
    finding.place = section.place;
    finding.keyword = "*DATABASE_CROSS_SECTION_PLANE";
    finding.field = "xct";
    finding.value = fmt::format("{:g}", section.plane->origin.x);
    finding.text = fmt::format("cross section {} has no elements: its forces are 0", section.id);
    finding.remedy = "check PSID, and where the plane lies";
    findings.add(std::move(finding));
  }
  for (model::SectionStress& stress : model.initial_state.section_stresses) {
    const model::CrossSection& section = requests.cross_sections[stress.section];
    if (section.plane) stress.solids = bricks_of(model, section, stress.parts);
  }
}

}  // namespace nugget::weld
