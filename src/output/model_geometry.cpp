// SPDX-License-Identifier: Apache-2.0
#include "output/model_geometry.hpp"

#include "base/index.hpp"
#include "output/d3plot_layout.hpp"

namespace nugget::output {

D3plotGeometry d3plot_geometry(const system::System& system) {
  const model::Model& model = system.model;
  D3plotGeometry g;
  g.title = model.title;
  g.node_ids = model.nodes.id;
  g.x = system.ties.x;
  for (std::size_t e = 0; e < model.solids.size(); ++e)
    g.solids.push_back({model.solids.id[e], model.solids.node[e], model.solids.part[e]});
  g.thick = thick_shells(model);
  for (std::size_t e = 0; e < model.beams.size(); ++e)
    g.beams.push_back({model.beams.id[e], model.beams.node[e], model.beams.part[e]});
  for (std::size_t e = 0; e < model.shells.size(); ++e)
    g.shells.push_back({model.shells.id[e], model.shells.node[e], model.shells.part[e]});
  for (const model::Part& p : model.parts) g.parts.push_back({p.id, p.title});
  g.rigid_walls = static_cast<int>(model.walls.size());
  g.layers = model.requests.layers;
  g.beam_points = model.requests.beam_points;
  g.one_state_a_file = model.requests.one_state_a_file;
  return g;
}

std::vector<char> thick_shells(const model::Model& model) {
  std::vector<char> thick;
  for (std::size_t e = 0; e < model.solids.size(); ++e) {
    if (!model.has_thick_shells(model.solids.part[e])) continue;
    thick.resize(model.solids.size(), char{0});
    thick[e] = 1;
  }
  return thick;
}

D3plotState unstressed_state(const system::System& system, const D3plotGeometry& geometry) {
  const model::Model& model = system.model;
  D3plotState state;
  state.x = system.ties.x;
  state.parts.resize(model.parts.size());
  state.solids.resize(model.solids.size());
  state.thick_shells.resize(count_thick_shells(geometry));
  state.thick_layers.resize(state.thick_shells.size() * at(geometry.layers));
  state.beams.resize(model.beams.size());
  state.beam_points.resize(model.beams.size() * at(geometry.beam_points));
  state.shells.resize(model.shells.size());
  state.shell_layers.resize(model.shells.size() * at(geometry.layers_of_shells()));
  for (std::size_t e = 0; e < model.shells.size(); ++e) state.shells[e].thickness = model.shells.thickness[e];
  return state;
}

}  // namespace nugget::output
