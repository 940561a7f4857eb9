// SPDX-License-Identifier: Apache-2.0
#include "output/element_stresses.hpp"

#include <algorithm>

#include "base/index.hpp"
#include "base/parallel.hpp"

namespace nugget::output {
namespace {

using Seat = system::System::Seat;

StressRecord record(const system::ElementGroup& group, const Seat& seat, int point, const system::State& state) {
  const system::ElementGroup::Layer layer = group.layer(at(seat.element), point, state);
  return {layer.stress, layer.plastic_strain};
}

/// Calls `fill(element, group, seat)` for those that have a kernel.
template <class Fill>
void each_element(const system::System& system, const std::vector<Seat>& seats, const Fill& fill) {
  parallel_for(seats.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e)
      if (seats[e].group >= 0) fill(e, *system.groups[at(seats[e].group)], seats[e]);
  });
}

}  // namespace

void fill_stresses(const system::System& system, const system::State& state, D3plotState& s) {
  using Group = system::ElementGroup;
  const model::Model& model = system.model;
  s.solids.resize(model.solids.size());
  each_element(system, system.solid_seat, [&](std::size_t e, const Group& group, const Seat& seat) {
    static_cast<StressRecord&>(s.solids[e]) = record(group, seat, 0, state);
  });

  const auto points = at(model.requests.beam_points);
  s.beams.resize(model.beams.size());
  s.beam_points.resize(model.beams.size() * points);
  each_element(system, system.beam_seat, [&](std::size_t e, const Group& group, const Seat& seat) {
    const std::array<double, 8> r = group.resultants(at(seat.element));
    s.beams[e] = {r[0], r[1], r[2], r[4], r[5], r[3]};
    for (std::size_t k = 0; k < std::min(points, at(group.layers())); ++k) {
      const StressRecord p = record(group, seat, static_cast<int>(k), state);
      s.beam_points[e * points + k] = {p.stress[3], p.stress[5], p.stress[0], p.plastic_strain, 0.0};
    }
  });

  const auto layers = at(model.requests.layers);
  s.shells.resize(model.shells.size());
  s.shell_layers.resize(model.shells.size() * layers);
  each_element(system, system.shell_seat, [&](std::size_t e, const Group& group, const Seat& seat) {
    std::vector<StressRecord> through;
    for (int k = 0; k < group.layers(); ++k) through.push_back(record(group, seat, k, state));
    shell_layers(through, std::span(s.shell_layers).subspan(e * layers, layers));
    const std::array<double, 8> r = group.resultants(at(seat.element));
    ShellRecord& shell = s.shells[e];
    shell.mx = r[0], shell.my = r[1], shell.mxy = r[2];
    shell.qx = r[3], shell.qy = r[4];
    shell.nx = r[5], shell.ny = r[6], shell.nxy = r[7];
  });
}

}  // namespace nugget::output
