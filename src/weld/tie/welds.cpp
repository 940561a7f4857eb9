// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/welds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <variant>

#include "weld/tie/connectors.hpp"
#include "weld/tie/inferred_welds.hpp"

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
  weld.elements = {beam};
  weld.tied_parts = model.beams.tied_parts[beam];
  const Index section = model.parts[weld.part].section;
  if (section != none)
    weld.diameter = 0.5 * (model.beam_sections[section].outer[0] + model.beam_sections[section].outer[1]);
  const std::array<Index, 2>& nodes = model.beams.node[beam];
  weld.face = {{{nodes[0]}, {nodes[1]}}};
  weld.ends = {Projection{}, Projection{}};
  for (int end = 0; end < 2; ++end) weld.ends[end].node = nodes[end];
  weld.place = model.beams.place[beam];
  return weld;
}

/// A weld of bricks; its faces and ends are laid when it is known what it is tied to.
Weld brick_weld(const model::Model& model, std::vector<Index> solids) {
  Weld weld;
  weld.kind = Weld::Kind::solid;
  weld.element = solids.front();
  weld.elements = std::move(solids);
  weld.id = model.solids.id[weld.element];
  weld.part = model.solids.part[weld.element];
  weld.place = model.solids.place[weld.element];
  return weld;
}

Weld defined_assembly(const model::Model& model, const model::HexAssembly& assembly) {
  Weld weld = brick_weld(model, assembly.solids);
  if (assembly.solids.size() > 1) weld.kind = Weld::Kind::assembly;
  weld.id = assembly.id;
  weld.orientation = assembly.orientation;
  weld.tied_parts = assembly.tied_parts;
  weld.place = assembly.place;
  return weld;
}

/// Assemblies as the deck defines them and single bricks, in the order of their first bricks.
void find_brick_welds(const model::Model& model, std::vector<Weld>& welds) {
  const std::vector<Index> inferred = inferred_bricks(model);
  std::vector<Index> first(model.solids.size(), none), taken(model.solids.size(), none);
  for (Index a = 0; a < static_cast<Index>(model.hex_assemblies.size()); ++a) {
    const std::vector<Index>& solids = model.hex_assemblies[a].solids;
    first[*std::min_element(solids.begin(), solids.end())] = a;
    for (Index e : solids) taken[e] = a;
  }
  for (Index e = 0; e < static_cast<Index>(model.solids.size()); ++e) {
    if (first[e] != none)
      welds.push_back(defined_assembly(model, model.hex_assemblies[first[e]]));
    else if (taken[e] == none &&
             (of_weld_material(model, model.solids.part[e]) || std::binary_search(inferred.begin(), inferred.end(), e)))
      welds.push_back(brick_weld(model, {e}));
  }
}

Weld::Rigid written_as(model::RigidWeld::Kind kind) {
  switch (kind) {
    case model::RigidWeld::Kind::spotweld: return Weld::Rigid::spotweld;
    case model::RigidWeld::Kind::generalized: return Weld::Rigid::generalized;
    case model::RigidWeld::Kind::nodal_body: return Weld::Rigid::nodal_body;
    case model::RigidWeld::Kind::rivet: return Weld::Rigid::rivet;
    case model::RigidWeld::Kind::fillet: return Weld::Rigid::fillet;
    case model::RigidWeld::Kind::butt: return Weld::Rigid::butt;
    case model::RigidWeld::Kind::cross_fillet: return Weld::Rigid::cross_fillet;
    case model::RigidWeld::Kind::combined: return Weld::Rigid::combined;
  }
  return Weld::Rigid::spotweld;
}

std::string keyword_of_rigid(Weld::Rigid rigid) {
  switch (rigid) {
    case Weld::Rigid::spotweld: return "*CONSTRAINED_SPOTWELD";
    case Weld::Rigid::generalized: return "*CONSTRAINED_GENERALIZED_WELD_SPOT";
    case Weld::Rigid::nodal_body: return "*CONSTRAINED_NODAL_RIGID_BODY";
    case Weld::Rigid::rivet: return "*CONSTRAINED_RIVET";
    case Weld::Rigid::fillet: return "*CONSTRAINED_GENERALIZED_WELD_FILLET";
    case Weld::Rigid::butt: return "*CONSTRAINED_GENERALIZED_WELD_BUTT";
    case Weld::Rigid::cross_fillet: return "*CONSTRAINED_GENERALIZED_WELD_CROSS_FILLET";
    case Weld::Rigid::combined: return "*CONSTRAINED_GENERALIZED_WELD_COMBINED";
  }
  return {};
}

Weld rigid_weld(const model::RigidWeld& rigid) {
  Weld weld;
  weld.kind = Weld::Kind::rigid;
  weld.rigid = written_as(rigid.kind);
  weld.id = rigid.id;
  weld.element = rigid.body;
  weld.elements = {rigid.body};
  weld.ends = projections(rigid.nodes);
  weld.face = {{{rigid.nodes.front()}, {rigid.nodes.back()}}};
  weld.place = rigid.place;
  return weld;
}

/// Area vector of an end face.
Vec3d area(const std::vector<Facet>& facets, const std::vector<Vec3d>& x) {
  Vec3d sum;
  for (const Facet& f : facets) sum += 0.5 * cross(x[f[2]] - x[f[0]], x[f[3]] - x[f[1]]);
  return sum;
}

WeldSize measure_bricks(const Weld& weld, const std::vector<Vec3d>& x) {
  const Vec3d axis = face_centre(weld, 1, x) - face_centre(weld, 0, x);
  const Vec3d faces = area(weld.facets[0], x) + area(weld.facets[1], x);
  const double size = norm(faces);
  if (size == 0.0) return {norm(axis), 0.0};
  // Mean of the end faces' areas, seen along the mean of their normals: a sheared brick keeps its length and its
  // section.
  return {dot(axis, (1.0 / size) * faces), std::sqrt(4.0 * 0.5 * size / std::numbers::pi)};
}

}  // namespace

bool scaled_to_the_step_of_the_run(const model::Model& model, const Weld& weld) {
  return weld.tied || model.control.mass_step == 0.0;
}

bool of_weld_material(const model::Model& model, Index part) {
  const Index material = model.parts[part].material;
  return material != none && std::holds_alternative<kernel::Spotweld>(model.materials[material].law);
}

const model::WeldLaw& law_of(const model::Model& model, const Weld& weld) {
  const model::Material& material = model.materials[model.parts[weld.part].material];
  return model.weld_laws[material.weld];
}

std::string name_weld(const Weld& weld) {
  if (weld.kind == Weld::Kind::rigid && weld.rigid == Weld::Rigid::rivet) return fmt::format("rivet {}", weld.id);
  if (weld.interpolated)
    return fmt::format("{} {}", weld.self_piercing ? "self-piercing rivet" : "interpolation spot weld", weld.id);
  return fmt::format("{} weld {}", to_string(weld.kind), weld.id);
}

std::string keyword_of(const Weld& weld) {
  if (weld.interpolated) return weld.self_piercing ? "*CONSTRAINED_SPR2" : "*CONSTRAINED_INTERPOLATION_SPOTWELD";
  switch (weld.kind) {
    case Weld::Kind::beam:
    case Weld::Kind::connector: return "*ELEMENT_BEAM";
    case Weld::Kind::rigid: return keyword_of_rigid(weld.rigid);
    case Weld::Kind::solid: return "*ELEMENT_SOLID";
    case Weld::Kind::assembly: return "*DEFINE_HEX_SPOTWELD_ASSEMBLY";
  }
  return {};
}

std::vector<Weld> find_welds(const model::Model& model) {
  std::vector<Weld> welds;
  for (Index e = 0; e < static_cast<Index>(model.beams.size()); ++e)
    if (of_weld_material(model, model.beams.part[e])) welds.push_back(beam_weld(model, e));
  for (const Index e : inferred_beams(model)) welds.push_back(beam_weld(model, e));
  for (const Index e : find_connectors(model)) {
    welds.push_back(beam_weld(model, e));
    welds.back().kind = Weld::Kind::connector;
    welds.back().interpolated = joins_sheets(model, welds.back().part);
    welds.back().self_piercing = has_rivets(model, welds.back().part);
  }
  find_brick_welds(model, welds);
  for (const model::RigidWeld& rigid : model.rigid_welds) welds.push_back(rigid_weld(rigid));
  return welds;
}

std::vector<Index> nodes_as_numbered(const model::Model& model, const Weld& weld, std::size_t end) {
  if (!weld.of_bricks()) return weld.face[end];
  std::vector<Index> nodes;
  for (Index e : weld.elements)
    for (std::size_t i = 0; i < 4; ++i) nodes.push_back(model.solids.node[e][4 * end + i]);
  return nodes;
}

Vec3d face_centre(const Weld& weld, int end, const std::vector<Vec3d>& x) {
  Vec3d sum;
  for (Index node : weld.face[end]) sum += x[node];
  const auto count = static_cast<double>(weld.face[end].size());
  return count > 0.0 ? (1.0 / count) * sum : sum;
}

WeldSize measure(const Weld& weld, const std::vector<Vec3d>& x) {
  if (weld.of_bricks()) return measure_bricks(weld, x);
  return {norm(face_centre(weld, 1, x) - face_centre(weld, 0, x)), weld.diameter};
}

std::array<std::array<Facet, 2>, 3> opposite_faces(const std::array<Index, 8>& n) {
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
    case Weld::Kind::connector: return "beam";
  }
  return "beam";
}

}  // namespace nugget::weld
