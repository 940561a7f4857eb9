// SPDX-License-Identifier: Apache-2.0
#include "nvh/stresses.hpp"

#include <algorithm>

#include "base/index.hpp"

namespace nugget::nvh {
namespace {

constexpr double step = 0x1p-100;  // a power of two: scaling by it is exact

const system::ElementGroup* group_of(const system::System& system, const system::System::Seat& seat) {
  return seat.group < 0 ? nullptr : system.groups[at(seat.group)].get();
}

}  // namespace

ElasticStresses::ElasticStresses(const system::System& at_rest, const std::vector<Six>& motion) {
  Findings findings;  // those of this model have been told
  system_ = std::make_unique<system::System>(at_rest.model, at_rest.ties, findings);
  state_ = system_->initial_state();
  for (std::size_t k = 0; k < motion.size(); ++k) {
    set(state_.v[k], {motion[k][0], motion[k][1], motion[k][2]});
    set(state_.w[k], {motion[k][3], motion[k][4], motion[k][5]});
  }
  state_.dt = step;
  system_->internal_force(state_);
}

std::array<double, 6> ElasticStresses::stress(const system::System::Seat& seat, int k) const {
  std::array<double, 6> s{};
  if (const system::ElementGroup* group = group_of(*system_, seat))
    s = group->layer(at(seat.element), k, state_).stress;
  for (double& component : s) component /= step;
  return s;
}

void ElasticStresses::fill(double share, output::D3plotState& state) const {
  const model::Model& model = system_->model;
  const auto record = [&](const system::System::Seat& seat, int k) {
    output::StressRecord r{stress(seat, k), 0.0};
    for (double& component : r.stress) component *= share;
    return r;
  };
  state.solids.resize(model.solids.size());
  for (std::size_t e = 0; e < model.solids.size(); ++e)
    static_cast<output::StressRecord&>(state.solids[e]) = record(system_->solid_seat[e], 0);

  const auto points = at(model.requests.beam_points);
  state.beams.resize(model.beams.size());
  state.beam_points.resize(model.beams.size() * points);
  for (std::size_t e = 0; e < model.beams.size(); ++e) {
    const system::System::Seat seat = system_->beam_seat[e];
    const system::ElementGroup* group = group_of(*system_, seat);
    if (group == nullptr) continue;
    std::array<double, 8> r = group->resultants(at(seat.element));
    for (double& v : r) v *= share / step;
    state.beams[e] = {r[0], r[1], r[2], r[4], r[5], r[3]};
    for (std::size_t k = 0; k < std::min(points, at(group->layers())); ++k) {
      const std::array<double, 6> s = record(seat, static_cast<int>(k)).stress;
      state.beam_points[e * points + k] = {s[3], s[5], s[0], 0.0, 0.0};
    }
  }

  const auto layers = at(model.requests.layers);
  state.shells.resize(model.shells.size());
  state.shell_layers.resize(model.shells.size() * layers);
  std::vector<output::StressRecord> through;
  for (std::size_t e = 0; e < model.shells.size(); ++e) {
    const system::System::Seat seat = system_->shell_seat[e];
    const system::ElementGroup* group = group_of(*system_, seat);
    output::ShellRecord& shell = state.shells[e];
    shell.thickness = model.shells.thickness[e];
    if (group == nullptr) continue;
    through.clear();
    for (int k = 0; k < group->layers(); ++k) through.push_back(record(seat, k));
    output::shell_layers(through, std::span(state.shell_layers).subspan(e * layers, layers));
    std::array<double, 8> r = group->resultants(at(seat.element));
    for (double& v : r) v *= share / step;
    shell.mx = r[0], shell.my = r[1], shell.mxy = r[2];
    shell.qx = r[3], shell.qy = r[4];
    shell.nx = r[5], shell.ny = r[6], shell.nxy = r[7];
  }
}

}  // namespace nugget::nvh
