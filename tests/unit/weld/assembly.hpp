// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/model.hpp"

namespace nugget::test {

using model::Index;
using model::none;

/// A model made by hand: flat sheets of square shells, weld beams and bricks, tie contacts. Ids count from 1, elements
/// of all kinds have ids of their own. Units mm, t, s; steel.
struct Assembly {
  model::Model model;

  Index node(const Vec3d& x) {
    model.nodes.id.push_back(static_cast<int>(model.nodes.size()) + 1);
    model.nodes.x.push_back(x);
    return static_cast<Index>(model.nodes.size()) - 1;
  }

  Index part(model::ElementKind kind, model::Law law) {
    model::Material material;
    material.id = static_cast<int>(model.materials.size()) + 1;
    material.density = 7.85e-9;
    material.law = law;
    model.materials.push_back(material);
    model::Part part;
    part.id = static_cast<int>(model.parts.size()) + 1;
    part.kind = kind;
    part.material = static_cast<Index>(model.materials.size()) - 1;
    model.parts.push_back(part);
    return static_cast<Index>(model.parts.size()) - 1;
  }

  Index sheet_part() { return part(model::ElementKind::shell, kernel::Elastic{210000.0, 0.3}); }

  Index shell(Index part, double thickness, const std::array<Index, 4>& nodes) {
    model.shells.id.push_back(static_cast<int>(model.shells.size()) + 1);
    model.shells.part.push_back(part);
    model.shells.node.push_back(nodes);
    model.shells.thickness.push_back(thickness);
    model.shells.place.push_back(0, 0);
    return static_cast<Index>(model.shells.size()) - 1;
  }

  /// A sheet of nx times ny shells of `size`, spanned by unit vectors e1 and e2 from `corner`; the normal is e1 x e2.
  Index sheet(double thickness, const Vec3d& corner, int nx = 3, int ny = 3, double size = 10.0,
              const Vec3d& e1 = {1, 0, 0}, const Vec3d& e2 = {0, 1, 0}) {
    const Index p = sheet_part();
    const Index first = static_cast<Index>(model.nodes.size());
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) node(corner + (i * size) * e1 + (j * size) * e2);
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const Index n = first + j * (nx + 1) + i;
        shell(p, thickness, {n, n + 1, n + nx + 2, n + nx + 1});
      }
    return p;
  }

  Index beam_part(double diameter) {
    const Index p = part(model::ElementKind::beam, weld_law());
    model::SectionBeam section;
    section.id = model.parts[p].id;
    section.elform = 9;
    section.outer = {diameter, diameter};
    model.beam_sections.push_back(section);
    model.parts[p].section = static_cast<Index>(model.beam_sections.size()) - 1;
    return p;
  }

  Index beam(Index part, Index n1, Index n2) {
    model.beams.id.push_back(1000 + static_cast<int>(model.beams.size()));
    model.beams.part.push_back(part);
    model.beams.node.push_back({n1, n2});
    model.beams.orientation.push_back(none);
    model.beams.direction.emplace_back();
    model.beams.tied_parts.push_back({none, none});
    model.beams.place.push_back(0, 0);
    return static_cast<Index>(model.beams.size()) - 1;
  }
  Index beam(Index part, const Vec3d& x1, const Vec3d& x2) {
    const Index n1 = node(x1);
    return beam(part, n1, node(x2));
  }

  Index solid_part() { return part(model::ElementKind::solid, weld_law()); }

  /// A brick with square faces of `side`, centres of its faces at (x, y, z1) and (x, y, z2).
  Index brick(Index part, double x, double y, double z1, double z2, double side) {
    const double h = 0.5 * side;
    std::array<Index, 8> n{};
    int k = 0;
    for (double z : {z1, z2})
      for (const auto& [u, v] : {std::pair{-h, -h}, {h, -h}, {h, h}, {-h, h}}) n[k++] = node({x + u, y + v, z});
    model.solids.id.push_back(2000 + static_cast<int>(model.solids.size()));
    model.solids.part.push_back(part);
    model.solids.node.push_back(n);
    model.solids.place.push_back(0, 0);
    return static_cast<Index>(model.solids.size()) - 1;
  }

  /// A contact that ties all nodes of `tracked` to the shells of `reference`.
  model::Contact& tie(std::vector<Index> tracked, std::vector<Index> reference) {
    model::Contact contact;
    contact.id = static_cast<int>(model.contacts.size()) + 1;
    contact.keyword = "CONTACT_SPOTWELD";
    contact.kind = model::Contact::Kind::spotweld;
    contact.a.parts = std::move(tracked);
    contact.b.parts = std::move(reference);
    model.contacts.push_back(contact);
    return model.contacts.back();
  }

  static kernel::Spotweld weld_law() {
    kernel::Spotweld law;
    law.E = 210000.0;
    law.nu = 0.3;
    law.yield = 400.0;
    return law;
  }
};

/// All findings, one a line.
inline std::string text(const Findings& findings) {
  std::string all;
  for (const Finding& f : findings.all()) all += to_string(f) + '\n';
  return all;
}

}  // namespace nugget::test
