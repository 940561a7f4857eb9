// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "system/system.hpp"

// Which kernel runs which element: one group a part and formulation.
namespace nugget::system {

const model::Hourglass& System::hourglass_of(const model::Part& part) const {
  return part.hourglass == model::none ? model.control.hourglass : model.hourglass[part.hourglass];
}

void System::make_groups(Findings& findings) {
  start_.resize(nodes);
  for (std::size_t i = 0; i < nodes; ++i) start_[i] = ties.x[model_node[i]];
  make_shells();
  make_bricks();
  make_weld_beams(findings);
  make_brick_joints();
  make_springs();
  for (const auto& group : groups) {
    if (group->weld && group->step_share == 1.0) continue;
    group->step_share = model.control.step_scale;
    if (group->kind == model::ElementKind::discrete) continue;  // they have no mass to scale
    if (group->mass_step == 0.0) group->mass_step = std::abs(model.control.mass_step);
  }
}

std::vector<bool> System::deleted_with_welds(bool bricks) const {
  std::vector<bool> deleted(bricks ? model.solids.size() : model.beams.size(), false);
  for (const weld::Weld& w : ties.welds)
    if (w.deleted && w.kind != weld::Weld::Kind::rigid && w.of_bricks() == bricks)
      for (model::Index e : w.elements) deleted[e] = true;
  return deleted;
}

void System::scale_weld_mass(ElementGroup& group, const kernel::Spotweld& law, bool held) const {
  group.weld = true;
  group.physical_mass_step = law.mass_step;
  if (model.control.mass_step == 0.0 || !held) return;
  // S. Bala's talk: welds are scaled to |DT2MS TSSFAC|, which is the step that will be run with.
  group.mass_step = std::abs(model.control.mass_step) * model.control.step_scale;
  group.step_share = 1.0;
}

}  // namespace nugget::system
