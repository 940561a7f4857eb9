// SPDX-License-Identifier: Apache-2.0
#include "weld/placement/divided_text.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "base/index.hpp"

namespace nugget::weld {

NewIds first_new_ids(const model::Model& model) {
  NewIds first;
  first.node = model.nodes.id.empty() ? 0 : model.nodes.id.back();
  for (const auto* ids : {&model.shells.id, &model.solids.id, &model.beams.id})
    for (const int id : *ids) first.shell = std::max(first.shell, id);
  for (const model::Discrete& d : model.discretes) first.shell = std::max(first.shell, d.id);
  return {first.node + 1, first.shell + 1};
}

void write_divided(deck::DividedShells& text, const model::Model& model, const Adapted& adapted) {
  const NewIds first = first_new_ids(model);
  std::map<Index, std::vector<deck::DividedShells::Node>> behind;  // of a node of the old deck
  for (std::size_t d = 0; d < adapted.divided.size(); ++d) {
    const DividedShell& divided = adapted.divided[d];
    const std::array<Index, 4>& outer = model.shells.node[divided.shell];
    const int new_node = first.node + 4 * static_cast<int>(d), new_shell = first.shell + 4 * static_cast<int>(d);
    std::vector<deck::DividedShells::Shell> five;
    for (int k = 0; k < 5; ++k) {
      deck::DividedShells::Shell& s = five.emplace_back();
      s.id = k == 0 ? model.shells.id[divided.shell] : new_shell + k - 1;
      for (std::size_t i = 0; i < 4; ++i) {
        const int c = pieces[at(k)][i];
        s.nodes[i] = c < 4 ? model.nodes.id[outer[at(c)]] : new_node + c - 4;
      }
    }
    text.divide(model.shells.id[divided.shell], five);
    for (int k = 0; k < 4; ++k) behind[outer[0]].push_back({new_node + k, divided.square[at(k)]});
  }
  for (const auto& [node, added] : behind) text.follow(model.nodes.id[node], added);
}

}  // namespace nugget::weld
