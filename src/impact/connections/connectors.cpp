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
    if (entry.location.group < 0) continue;
    works_.back() = WeldWork(system, w);
    connectors_.push_back(records_.size() - 1);
  }
}

namespace {

double failure_value(const kernel::Spr3& joint, const kernel::Spr3::Freedoms& force, const Connectors::Record& record) {
  return joint.failure_value(force, record.plastic);
}
double failure_value(const kernel::Spr2&, const kernel::Spr2::Freedoms&, const Connectors::Record& record) {
  return record.damage;
}

}  // namespace

template <class Joint>
void Connectors::follow_joint(const Joint& joint, const std::array<double, 8>& r, double time, Record& record) {
  const kernel::Spr3::Freedoms force{r[0], r[1], r[2], r[3], r[4], r[5]};
  record.last = {r[0], r[1], r[2], r[3], r[4], r[5]};
  record.plastic = r[6];
  record.damage = r[7];
  record.mode_mixity = kernel::Spr3::mode_mixity(force);
  record.failure = failure_value(joint, force, record);
  if (record.failure > record.peak_failure) {
    record.peak_failure = record.failure;
    record.peak_time = time;
  }
}

void Connectors::update(const system::State& state) {
  for (const std::size_t i : connectors_) {
    const system::System::ElementLocation location = records_[i].location;
    Record& record = records_[i].record;
    if (record.failed) continue;
    works_[i].add_step(system_, state);
    const system::ElementGroup& group = *system_.groups[location.group];
    if (!group.alive(at(location.element))) {
      record.failed = true;
      record.failure_time = state.time;
      ++failed_;
      if (system_.ties.welds[i].interpolated) {
        record.damage = record.failure = record.peak_failure = 1.0;
        record.peak_time = state.time;
      }
      events_.push_back(event(i, state));
      continue;
    }
    const std::array<double, 8> r = group.resultants(at(location.element));
    record.peaks.add(r[0], std::hypot(r[1], r[2]), std::hypot(r[4], r[5]), r[3]);
    const model::Law& law = system_.model.materials[system_.model.parts[system_.ties.welds[i].part].material].law;
    if (const auto& joint = std::get<kernel::DiscreteBeam>(law).joint)
      std::visit([&](const auto& own) { follow_joint(own, r, state.time, record); }, *joint);
  }
}

std::string Connectors::event(std::size_t i, const system::State& state) const {
  const weld::Weld& weld = system_.ties.welds[i];
  const std::string when = fmt::format("failed  id={:8d} time={:12.5E} cycle={}", weld.id, state.time, state.cycle);
  if (!weld.interpolated) return "discrete beam " + when;
  return fmt::format("{} {} at a mode mixity of {:.3f}",
                     weld.self_piercing ? "self-piercing rivet" : "interpolation spot weld", when,
                     records_[i].record.mode_mixity);
}

double Connectors::length(std::size_t i) const {
  const system::System::ElementLocation location = records_[i].location;
  return system_.groups[location.group]->thickness(at(location.element));
}

void Connectors::reset_work() {
  for (WeldWork& work : works_) work.reset();
}

void Connectors::archive(Archive& a) {
  a(records_, works_, failed_, events_);
  a.built(system_, connectors_);
}

}  // namespace nugget::impact
