// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/cut_welds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/bvh.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

/// The plane of a section, and the room that its pieces take up: it may end somewhere.
struct SectionPlane {
  Vec3d point, normal;
  Box box;

  double height(const Vec3d& x) const { return dot(x - point, normal); }
  bool parts(const Vec3d& a, const Vec3d& b) const { return (height(a) >= 0.0) != (height(b) >= 0.0); }
  Vec3d crossing(const Vec3d& a, const Vec3d& b) const { return a + (height(a) / (height(a) - height(b))) * (b - a); }
};

/// Without a piece there is nothing to go by; a section that has none is warned of where it is read.
SectionPlane plane_of_section(const model::Model& model, const model::CrossSection& section) {
  SectionPlane plane;
  plane.normal = section.normal;
  for (const model::CrossSection::Facet& facet : section.facets)
    for (const model::CrossSection::Corner& c : facet.corners) {
      const Vec3d &a = model.nodes.x[c.from], &b = model.nodes.x[c.to];
      plane.point = a + c.share * (b - a);
      plane.box.add(plane.point);
    }
  return plane;
}

bool has_elements(const Weld& weld) {
  return weld.kind != Weld::Kind::rigid && !weld.deleted;
}

bool is_in(const model::CrossSection& section, const Weld& weld) {
  return std::any_of(section.facets.begin(), section.facets.end(), [&](const model::CrossSection::Facet& f) {
    return f.kind == weld.element_kind() &&
           std::find(weld.elements.begin(), weld.elements.end(), f.element) != weld.elements.end();
  });
}

}  // namespace

void report_cut_welds(const model::Model& model, const Ties& ties, Findings& findings) {
  constexpr double beside = 10.0;  // diameters from the pieces of a section that may end there
  for (const model::CrossSection& section : model.requests.cross_sections) {
    if (norm(section.normal) == 0.0 || section.facets.empty()) continue;
    const SectionPlane plane = plane_of_section(model, section);
    std::size_t count = 0;
    const Weld* first = nullptr;
    for (const Weld& weld : ties.welds) {
      if (!has_elements(weld)) continue;
      const auto drawn = [&](int end) { return face_centre(weld, end, model.nodes.x); };
      const auto placed = [&](int end) { return face_centre(weld, end, ties.x); };
      if (!plane.parts(placed(0), placed(1)) || plane.parts(drawn(0), drawn(1))) continue;
      if (plane.box.grown(beside * weld.diameter).distance_squared(plane.crossing(placed(0), placed(1))) > 0.0)
        continue;
      if (is_in(section, weld)) continue;
      if (count++ == 0) first = &weld;
    }
    if (count == 0) continue;
    findings.warning(section.place, "*DATABASE_CROSS_SECTION_PLANE",
                     fmt::format("cross section {}: its plane runs between the ends of {} weld{} once these stand on "
                                 "their sheets, not where the deck has them, first {}: secforc lacks their forces",
                                 section.id, count, count == 1 ? "" : "s", name_weld(*first)),
                     "let the plane pass between the ends as drawn; swforc has the forces of welds in any case");
  }
}

}  // namespace nugget::weld
