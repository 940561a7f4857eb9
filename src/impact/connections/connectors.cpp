// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/connectors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"

namespace nugget::impact {

Connectors::Connectors(const system::System& system) : system_(system) {
  for (const weld::Weld& w : system.ties.welds) {
    Entry& entry = records_.emplace_back();
    works_.emplace_back();
    if (w.kind != weld::Weld::Kind::connector) continue;
    entry.location = system.beam_location[w.element];
    if (entry.location.group >= 0) works_.back() = WeldWork(system, w);
  }
}

void Connectors::update(const system::State& state) {
  for (std::size_t i = 0; i < records_.size(); ++i) {
    auto& [location, record] = records_[i];
    if (location.group < 0 || record.failed) continue;
    works_[i].add_step(system_, state);
    const system::ElementGroup& group = *system_.groups[location.group];
    if (!group.alive(at(location.element))) {
      record.failed = true;
      record.failure_time = state.time;
      ++failed_;
      events_.push_back(fmt::format("discrete beam failed  id={:8d} time={:12.5E} cycle={}", system_.ties.welds[i].id,
                                    state.time, state.cycle));
      continue;
    }
    const std::array<double, 8> r = group.resultants(at(location.element));
    record.peaks.add(r[0], std::hypot(r[1], r[2]), std::hypot(r[4], r[5]), r[3]);
  }
}

void Connectors::reset_work() {
  for (WeldWork& work : works_) work.reset();
}

void Connectors::archive(Archive& a) {
  a(records_, works_, failed_, events_);
  a.built(system_);
}

}  // namespace nugget::impact
