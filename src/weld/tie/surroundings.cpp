// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/surroundings.hpp"

#include <algorithm>

#include "model/bond.hpp"
#include "weld/tie/inferred_welds.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

double contact_thickness(const model::Part& part, double own) {
  return part.contact_thickness > 0.0 ? part.contact_thickness : own * part.contact_scale;
}

}  // namespace

Surroundings::Surroundings(const model::Model& model)
    : thickness(model.nodes.size(), 0.0),
      rotates(model.nodes.size(), 0),
      of_weld(model.nodes.size(), 0),
      shell(model.nodes.size(), none),
      rigid_body(model.nodes.size(), none) {
  for (std::size_t e = 0; e < model.shells.size(); ++e) {
    const double t = contact_thickness(model.parts[model.shells.part[e]], model.shells.thickness[e]);
    const bool membrane = model.has_membranes(model.shells.part[e]);
    for (Index n : model.shells.node[e]) {
      thickness[n] = std::max(thickness[n], t);
      if (!membrane) rotates[n] = 1;
      if (shell[n] == none) shell[n] = static_cast<Index>(e);
    }
  }
  for (std::size_t e = 0; e < model.beams.size(); ++e) {
    const model::Part& part = model.parts[model.beams.part[e]];
    for (int end = 0; end < 2; ++end) {
      const Index n = model.beams.node[e][end];
      const double diameter = part.section == none ? 0.0 : model.beam_sections[part.section].outer[end];
      thickness[n] = std::max(thickness[n], contact_thickness(part, diameter));
      rotates[n] = 1;
      if (of_weld_material(model, model.beams.part[e])) of_weld[n] = 1;
    }
  }
  for (std::size_t e = 0; e < model.solids.size(); ++e)
    if (of_weld_material(model, model.solids.part[e]))
      for (Index n : model.solids.node[e]) of_weld[n] = 1;
  for (std::size_t e = 0; e < model.solids.size(); ++e)
    if (model::bond_between_shells(model, e))
      for (Index n : model.solids.node[e]) rotates[n] = 1;
  for (Index e : inferred_beams(model))
    for (Index n : model.beams.node[e]) of_weld[n] = 1;
  for (Index e : inferred_bricks(model))
    for (Index n : model.solids.node[e]) of_weld[n] = 1;
  for (std::size_t b = 0; b < model.rigid_bodies.size(); ++b)
    for (Index n : model.rigid_bodies[b].nodes)
      if (rigid_body[n] == none) rigid_body[n] = static_cast<Index>(b);
}

}  // namespace nugget::weld
