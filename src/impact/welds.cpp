// SPDX-License-Identifier: Apache-2.0
#include "impact/welds.hpp"

#include <fmt/format.h>

#include "base/index.hpp"

namespace nugget::impact {

Welds::Welds(system::System& system) : system_(system) {
  for (const weld::Weld& w : system.ties.welds) {
    histories_.emplace_back();
    if (w.kind != weld::Weld::Kind::beam || w.deleted) continue;
    const model::Material& material = system.model.materials[at(system.model.parts[at(w.part)].material)];
    histories_.back() = std::make_unique<weld::History>(system.model.weld_laws[at(material.weld)]);
  }
}

void Welds::update(const system::State& state) {
  for (std::size_t i = 0; i < histories_.size(); ++i) {
    weld::History* history = histories_[i].get();
    if (history == nullptr || history->failed()) continue;
    const system::System::Seat seat = system_.beam_seat[at(system_.ties.welds[i].element)];
    system::ElementGroup& group = *system_.groups[at(seat.group)];
    const auto e = at(seat.element);
    if (!group.alive(e)) {
      history->fail(state.time, weld::FailureMode::plastic_strain);
      report(i, state);
      continue;
    }
    const std::array<double, 8> r = group.resultants(e);
    if (history->update(state.time, {r[0], r[1], r[2], r[3], r[4], r[5]})) {
      group.remove(e);
      report(i, state);
    }
  }
}

void Welds::report(std::size_t i, const system::State& state) {
  ++failed_;
  events_.push_back(fmt::format("spotweld beam failed  id={:8d} time={:12.5E} cycle={} by {}", system_.ties.welds[i].id,
                                state.time, state.cycle, weld::to_string(histories_[i]->mode())));
}

}  // namespace nugget::impact
