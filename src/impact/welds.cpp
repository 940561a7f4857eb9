// SPDX-License-Identifier: Apache-2.0
#include "impact/welds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/index.hpp"

namespace nugget::impact {

Welds::Bricks::Bricks(const system::System& system, const weld::Weld& weld) : section(weld, system.ties.x) {
  const std::vector<model::Index>& at_ends = section.nodes();
  for (model::Index n : at_ends) nodes.push_back(system.node_of[at(n)]);
  for (model::Index e : weld.elements)
    for (int a = 0; a < 8; ++a) {
      const auto n = std::find(at_ends.begin(), at_ends.end(), system.model.solids.node[at(e)][at(a)]);
      if (n == at_ends.end()) continue;
      corners.push_back({system.seat_of(weld, e), a, static_cast<std::size_t>(n - at_ends.begin())});
    }
  x.resize(nodes.size());
  force.resize(nodes.size());
}

void Welds::Bricks::gather(const system::System& system, const system::State& state) {
  for (std::size_t i = 0; i < nodes.size(); ++i) x[i] = vec(state.x[at(nodes[i])]);
  std::fill(force.begin(), force.end(), Vec3d{});
  for (const Corner& c : corners) force[c.node] += system.nodal_force(c.seat, c.corner);
}

Welds::Welds(system::System& system, Findings& findings) : system_(system) {
  for (const weld::Weld& w : system.ties.welds) {
    histories_.emplace_back();
    bricks_.emplace_back();
    if (w.kind == weld::Weld::Kind::rigid || w.deleted) continue;
    const model::Material& material = system.model.materials[at(system.model.parts[at(w.part)].material)];
    const model::WeldLaw& law = system.model.weld_laws[at(material.weld)];
    histories_.back() = std::make_unique<weld::History>(
        law, weld::failure::make_function(system.model, law, weld::failure::geometry_of(system.model, w), w.place,
                                          findings));
    if (w.of_bricks()) bricks_.back() = std::make_unique<Bricks>(system, w);
  }
}

void Welds::update(const system::State& state) {
  for (std::size_t i = 0; i < histories_.size(); ++i) {
    weld::History* history = histories_[i].get();
    if (history == nullptr || history->failed()) continue;
    if (!alive(i)) {
      history->fail(state.time, weld::FailureMode::plastic_strain);
      report(i, state);
      continue;
    }
    if (history->update({resultants(i, state), strain_rate(i), state.time})) {
      remove(i);
      report(i, state);
    }
  }
}

weld::Resultants Welds::resultants(std::size_t i, const system::State& state) {
  if (Bricks* bricks = bricks_[i].get()) {
    bricks->gather(system_, state);
    bricks->load = bricks->section.load(bricks->section.shape(bricks->x), bricks->x, bricks->force);
    return bricks->load.middle;
  }
  const weld::Weld& w = system_.ties.welds[i];
  const system::System::Seat seat = system_.seat_of(w, w.element);
  const std::array<double, 8> r = system_.groups[at(seat.group)]->resultants(at(seat.element));
  return {r[0], r[1], r[2], r[3], r[4], r[5]};
}

/// Mean over the elements of the weld that hold.
double Welds::strain_rate(std::size_t i) const {
  const weld::Weld& w = system_.ties.welds[i];
  double sum = 0.0;
  int holding = 0;
  for (model::Index e : w.elements) {
    const system::System::Seat seat = system_.seat_of(w, e);
    const system::ElementGroup& group = *system_.groups[at(seat.group)];
    if (!group.alive(at(seat.element))) continue;
    sum += group.strain_rate(at(seat.element));
    ++holding;
  }
  return holding > 0 ? sum / holding : 0.0;
}

const weld::BrickSection::Load* Welds::brick_load(std::size_t i) const {
  return bricks_[i] ? &bricks_[i]->load : nullptr;
}

double Welds::length(std::size_t i, const system::State& state) const {
  if (const Bricks* bricks = bricks_[i].get()) {
    std::vector<Vec3d> x;
    for (int n : bricks->nodes) x.push_back(vec(state.x[at(n)]));
    return bricks->section.shape(x).length;
  }
  const weld::Weld& w = system_.ties.welds[i];
  const system::System::Seat seat = system_.seat_of(w, w.element);
  return system_.groups[at(seat.group)]->thickness(at(seat.element));
}

/// A weld holds as long as one of its elements does.
bool Welds::alive(std::size_t i) const {
  const weld::Weld& w = system_.ties.welds[i];
  return std::any_of(w.elements.begin(), w.elements.end(), [&](model::Index e) {
    const system::System::Seat seat = system_.seat_of(w, e);
    return system_.groups[at(seat.group)]->alive(at(seat.element));
  });
}

void Welds::remove(std::size_t i) {
  const weld::Weld& w = system_.ties.welds[i];
  for (model::Index e : w.elements) {
    const system::System::Seat seat = system_.seat_of(w, e);
    system_.groups[at(seat.group)]->remove(at(seat.element));
  }
}

void Welds::lose_sheet(std::size_t i, const system::State& state) {
  weld::History* history = histories_[i].get();
  if (history == nullptr || history->failed()) return;
  remove(i);
  history->fail(state.time, weld::FailureMode::sheet_deleted);
  report(i, state);
}

void Welds::report(std::size_t i, const system::State& state) {
  ++failed_;
  const weld::Weld& w = system_.ties.welds[i];
  events_.push_back(fmt::format("spotweld {} failed  id={:8d} time={:12.5E} cycle={} by {}", weld::to_string(w.kind),
                                w.id, state.time, state.cycle, weld::to_string(histories_[i]->mode())));
}

}  // namespace nugget::impact
