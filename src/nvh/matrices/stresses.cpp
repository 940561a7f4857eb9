// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/stresses.hpp"

#include "base/index.hpp"
#include "output/element_stresses.hpp"

namespace nugget::nvh {
namespace {

constexpr double step = 0x1p-100;  // a power of two: scaling by it is exact

const system::ElementGroup* group_of(const system::System& system, const system::System::ElementLocation& location) {
  return location.group < 0 ? nullptr : system.groups[location.group].get();
}

}  // namespace

ElasticStresses::ElasticStresses(const system::System& at_rest, const std::vector<SixDof>& motion) {
  Findings findings;  // those of this model have been reported
  system_ = std::make_unique<system::System>(at_rest.model, at_rest.ties, findings);
  state_ = system_->initial_state();
  for (std::size_t k = 0; k < motion.size(); ++k) {
    set(state_.v[k], {motion[k][0], motion[k][1], motion[k][2]});
    set(state_.w[k], {motion[k][3], motion[k][4], motion[k][5]});
  }
  system_->slide_brick_faces(state_.v);
  state_.dt = step;
  system_->internal_force(state_);
}

std::array<double, 6> ElasticStresses::stress(const system::System::ElementLocation& location, int k) const {
  std::array<double, 6> s{};
  if (const system::ElementGroup* group = group_of(*system_, location))
    s = output::shown_layer(*system_, *group, at(location.element), k, state_).stress;
  for (double& component : s) component /= step;
  return s;
}

void ElasticStresses::fill(double share, output::D3plotState& state) const {
  output::fill_stresses(*system_, state_, state);
  const double factor = share / step;
  const auto scale = [&](auto&... value) { ((value *= factor), ...); };
  const auto scale_stress = [&](output::StressRecord& r) {
    for (double& component : r.stress) scale(component);
  };
  for (output::SolidRecord& r : state.solids) scale_stress(r);
  for (output::StressRecord& r : state.thick_layers) scale_stress(r);
  for (output::StressRecord& r : state.shell_layers) scale_stress(r);
  for (output::BeamRecord& b : state.beams) scale(b.axial, b.shear_s, b.shear_t, b.moment_s, b.moment_t, b.torsion);
  for (output::BeamPointRecord& p : state.beam_points) scale(p.stress_rs, p.stress_tr, p.stress_axial);
  const std::vector<double>& thickness = system_->model.shells.thickness;
  for (std::size_t e = 0; e < state.shells.size(); ++e) {
    output::ShellRecord& r = state.shells[e];
    scale(r.mx, r.my, r.mxy, r.qx, r.qy, r.nx, r.ny, r.nxy);
    r.thickness = thickness[e];
  }
}

}  // namespace nugget::nvh
