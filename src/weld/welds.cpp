// SPDX-License-Identifier: Apache-2.0
#include "weld/welds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <variant>

namespace nugget::weld {
namespace {

/// A projection for each node, each once.
std::vector<Projection> projections(std::span<const Index> nodes) {
  std::vector<Projection> ends;
  for (Index node : nodes) {
    const auto same = [node](const Projection& p) { return p.node == node; };
    if (std::any_of(ends.begin(), ends.end(), same)) continue;
    ends.emplace_back().node = node;
  }
  return ends;
}

Weld beam_weld(const model::Model& model, Index beam) {
  Weld weld;
  weld.kind = Weld::Kind::beam;
  weld.id = model.beams.id[beam];
  weld.part = model.beams.part[beam];
  weld.element = beam;
  const Index section = model.parts[weld.part].section;
  if (section != none)
    weld.diameter = 0.5 * (model.beam_sections[section].outer[0] + model.beam_sections[section].outer[1]);
  const std::array<Index, 2>& nodes = model.beams.node[beam];
  weld.face[0][0] = nodes[0];
  weld.face[1][0] = nodes[1];
  weld.ends = {Projection{}, Projection{}};
  for (int end = 0; end < 2; ++end) weld.ends[end].node = nodes[end];
  weld.place = model.beams.place[beam];
  return weld;
}

Weld solid_weld(const model::Model& model, Index solid) {
  Weld weld;
  weld.kind = Weld::Kind::solid;
  weld.id = model.solids.id[solid];
  weld.part = model.solids.part[solid];
  weld.element = solid;
  weld.face = opposite_faces(model.solids.node[solid])[0];
  weld.ends = projections(model.solids.node[solid]);
  weld.place = model.solids.place[solid];
  return weld;
}

Weld rigid_weld(const model::Model& model, Index body) {
  const model::RigidBody& rigid = model.rigid_bodies[body];
  Weld weld;
  weld.kind = Weld::Kind::rigid;
  weld.id = rigid.id;
  weld.element = body;
  weld.ends = projections(rigid.nodes);
  if (!rigid.nodes.empty()) {
    weld.face[0][0] = rigid.nodes.front();
    weld.face[1][0] = rigid.nodes.back();
  }
  weld.place = rigid.place;
  return weld;
}

/// Area vector of a face.
Vec3d area(const std::array<Index, 4>& face, const std::vector<Vec3d>& x) {
  return 0.5 * cross(x[face[2]] - x[face[0]], x[face[3]] - x[face[1]]);
}

WeldSize measure_brick(const Weld& weld, const std::vector<Vec3d>& x) {
  const Vec3d axis = face_centre(weld, 1, x) - face_centre(weld, 0, x);
  const Vec3d faces = area(weld.face[0], x) + area(weld.face[1], x);
  const double size = norm(faces);
  if (size == 0.0) return {norm(axis), 0.0};
  // Mean of the end faces' areas, seen along the mean of their normals: a sheared brick keeps its length and its
  // section.
  return {dot(axis, (1.0 / size) * faces), std::sqrt(4.0 * 0.5 * size / std::numbers::pi)};
}

}  // namespace

bool of_weld_material(const model::Model& model, Index part) {
  const Index material = model.parts[part].material;
  return material != none && std::holds_alternative<kernel::Spotweld>(model.materials[material].law);
}

std::string name_weld(const Weld& weld) {
  return fmt::format("{} weld {}", to_string(weld.kind), weld.id);
}

std::string keyword_of(const Weld& weld) {
  switch (weld.kind) {
    case Weld::Kind::beam: return "*ELEMENT_BEAM";
    case Weld::Kind::rigid: return "*CONSTRAINED_GENERALIZED_WELD_SPOT";
    case Weld::Kind::solid:
    case Weld::Kind::assembly: return "*ELEMENT_SOLID";
  }
  return {};
}

std::vector<Weld> find_welds(const model::Model& model) {
  std::vector<Weld> welds;
  for (Index e = 0; e < static_cast<Index>(model.beams.size()); ++e)
    if (of_weld_material(model, model.beams.part[e])) welds.push_back(beam_weld(model, e));
  for (Index e = 0; e < static_cast<Index>(model.solids.size()); ++e)
    if (of_weld_material(model, model.solids.part[e])) welds.push_back(solid_weld(model, e));
  for (Index b = 0; b < static_cast<Index>(model.rigid_bodies.size()); ++b)
    if (model.rigid_bodies[b].origin == model::RigidBody::Origin::weld) welds.push_back(rigid_weld(model, b));
  return welds;
}

Vec3d face_centre(const Weld& weld, int end, const std::vector<Vec3d>& x) {
  Vec3d sum;
  int count = 0;
  for (Index node : weld.face[end]) {
    if (node == none) continue;
    sum += x[node];
    ++count;
  }
  return count > 0 ? (1.0 / count) * sum : sum;
}

WeldSize measure(const Weld& weld, const std::vector<Vec3d>& x) {
  if (weld.kind == Weld::Kind::solid) return measure_brick(weld, x);
  return {norm(face_centre(weld, 1, x) - face_centre(weld, 0, x)), weld.diameter};
}

std::array<std::array<std::array<Index, 4>, 2>, 3> opposite_faces(const std::array<Index, 8>& n) {
  return {{{{{n[0], n[1], n[2], n[3]}, {n[4], n[5], n[6], n[7]}}},
           {{{n[0], n[4], n[5], n[1]}, {n[3], n[7], n[6], n[2]}}},
           {{{n[0], n[3], n[7], n[4]}, {n[1], n[2], n[6], n[5]}}}}};
}

std::string_view to_string(Weld::Kind kind) {
  switch (kind) {
    case Weld::Kind::beam: return "beam";
    case Weld::Kind::solid: return "solid";
    case Weld::Kind::assembly: return "assembly";
    case Weld::Kind::rigid: return "rigid";
  }
  return "beam";
}

}  // namespace nugget::weld
