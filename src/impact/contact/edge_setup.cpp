// SPDX-License-Identifier: Apache-2.0
#include "impact/contact/edge_setup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "impact/contact/contact_setup.hpp"
#include "impact/contact/element_alive.hpp"
#include "impact/contact/friction_kinds.hpp"
#include "model/contact_form.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::impact {
namespace {

/// Diameter of the round bar that stands for a beam [length]: TS1, and of a section given by its area (ELFORM 2, 3) the
/// root of that ("How to model contact between beam elements?", Ansys Learning Forum).
double bar_diameter(const model::SectionBeam& section) {
  return section.area > 0.0 ? std::sqrt(section.area) : section.outer[0];
}

bool is_a_bar(const model::Model& model, std::size_t beam, bool with_welds) {
  const model::Part& part = model.parts[model.beams.part[beam]];
  if (weld::of_weld_material(model, model.beams.part[beam])) return with_welds;
  const int elform = model.beam_sections[part.section].elform;
  return elform != 6 && elform != 9;
}

}  // namespace

std::vector<contact::Edge> bars(const ContactMesh& mesh, const model::Contact& card, bool with_welds) {
  const model::Model& model = mesh.model;
  std::vector<char> in(model.parts.size(), card.a.everything ? 1 : 0);
  for (model::Index p : card.a.parts) in[p] = 1;
  const FrictionKinds rough(model, card);
  std::vector<contact::Edge> edges;
  for (std::size_t b = 0; b < model.beams.size(); ++b) {
    const model::Part& part = model.parts[model.beams.part[b]];
    if (!in[model.beams.part[b]] || !is_a_bar(model, b, with_welds)) continue;
    contact::Edge edge;
    for (std::size_t end = 0; end < 2; ++end) edge.node[end] = mesh.node_of[model.beams.node[b][end]];
    const double own = bar_diameter(model.beam_sections[part.section]);
    edge.thickness = contact_thickness(card, part, own, true);
    const double length = norm(mesh.x[model.beams.node[b][1]] - mesh.x[model.beams.node[b][0]]);
    // As a shell as wide as the bar is thick.
    edge.stiffness = card.stiffness_scale_a *
                     kernel::shell_penalty(bulk_modulus(model, part), own * length, std::hypot(own, length));
    edge.mass = model.materials[part.material].density * 0.25 * std::numbers::pi * own * own * length;
    edge.scale = card.stiffness_scale_a * part.stiffness_scale;
    edge.elements = {ElementAlive::place(model, model::ElementKind::beam, static_cast<model::Index>(b))};
    edge.kind = rough.of_part[model.beams.part[b]];
    if (card.parts_apart) edge.part = model.beams.part[b];
    edges.push_back(std::move(edge));
  }
  return edges;
}

std::optional<contact::EdgeContactSetup> edge_setup(const ContactMesh& mesh, const model::Contact& card,
                                                    const contact::SurfaceContactSetup& surface,
                                                    std::span<const Row> x) {
  if (!checks_edges(card)) return std::nullopt;
  contact::EdgeContactSetup setup;
  setup.edges = contact::edges_of(surface.segments, x, card.soft == 2 && card.depth >= 3);
  if (checks_beams(card))
    for (contact::Edge& bar : bars(mesh, card, card.takes_welds)) setup.edges.push_back(std::move(bar));
  setup.interior = checks_all_edges(card);
  setup.two_sides = card.kind == model::Contact::Kind::two_surfaces;
  setup.places = surface.places;
  setup.stiffness_scale = surface.stiffness_scale;
  setup.law = surface.law;
  setup.birth = surface.birth;
  setup.death = surface.death;
  return setup;
}

}  // namespace nugget::impact
