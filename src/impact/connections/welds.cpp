// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/welds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <variant>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "system/share.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::impact {
namespace {

/// Triple products of the edges at the corners of a brick.
std::array<double, 8> corner_jacobians(const std::array<Vec3d, 8>& x) {
  constexpr std::size_t along[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                       {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
  std::array<double, 8> j;
  for (std::size_t a = 0; a < 8; ++a)
    j[a] = dot(x[along[a][0]] - x[a], cross(x[along[a][1]] - x[a], x[along[a][2]] - x[a]));
  return j;
}

/// When *DEFINE_ELEMENT_DEATH deletes the first element of each weld; infinite where it deletes none [time].
std::vector<double> first_deaths(const system::System& system) {
  std::map<std::pair<model::ElementKind, model::Index>, double> deaths;
  for (const model::ElementDeath& death : system.model.element_deaths) {
    double& first = deaths.try_emplace({death.kind, death.element}, death.time).first->second;
    first = std::min(first, death.time);
  }
  std::vector<double> first_of(system.ties.welds.size(), std::numeric_limits<double>::infinity());
  if (deaths.empty()) return first_of;
  for (std::size_t i = 0; i < first_of.size(); ++i)
    for (const model::Index element : system.ties.welds[i].elements)
      if (const auto death = deaths.find({system.ties.welds[i].element_kind(), element}); death != deaths.end())
        first_of[i] = std::min(first_of[i], death->second);
  return first_of;
}

}  // namespace

Welds::Bricks::Bricks(const system::System& system, const weld::Weld& weld) : section(weld, system.ties.x) {
  const std::vector<model::Index>& at_ends = section.nodes();
  for (model::Index n : at_ends) nodes.push_back(system.node_of[n]);
  for (model::Index e : weld.elements) {
    const system::System::ElementLocation location = system.location_of(weld, e);
    const system::ElementNodes of_brick = system.groups[location.group]->nodes(at(location.element));
    std::array<Vec3d, 8> place;
    for (std::size_t a = 0; a < 8; ++a) {
      place[a] = system.ties.x[system.model_node[of_brick[a]]];
      const auto n = std::find(nodes.begin(), nodes.end(), of_brick[a]);
      if (n != nodes.end())
        corners.push_back({location, static_cast<int>(a), static_cast<std::size_t>(n - nodes.begin())});
    }
    locations.push_back(location);
    jacobian.push_back(corner_jacobians(place));
  }
  x.resize(nodes.size());
  force.resize(nodes.size());
}

double Welds::Bricks::least_jacobian(const system::System& system, const system::State& state) const {
  double least = 1.0;
  for (std::size_t b = 0; b < locations.size(); ++b) {
    const system::ElementNodes node = system.groups[locations[b].group]->nodes(at(locations[b].element));
    std::array<Vec3d, 8> place;
    for (std::size_t a = 0; a < 8; ++a) place[a] = vec(state.x[node[a]]);
    const std::array<double, 8> now = corner_jacobians(place);
    // Corners of wedges that were flat from the start say nothing.
    for (std::size_t a = 0; a < 8; ++a)
      if (jacobian[b][a] > 0.0) least = std::min(least, now[a] / jacobian[b][a]);
  }
  return least;
}

void Welds::Bricks::gather(const system::System& system, const system::State& state) {
  for (std::size_t i = 0; i < nodes.size(); ++i) x[i] = vec(state.x[nodes[i]]);
  std::fill(force.begin(), force.end(), Vec3d{});
  for (const Corner& c : corners) force[c.node] += system.nodal_force(c.location, c.corner);
}

Welds::Welds(system::System& system, Findings& findings)
    : system_(system), joints_(system), stacks_(system, joints_), death_time_(first_deaths(system)) {
  for (const weld::Weld& w : system.ties.welds) {
    histories_.emplace_back();
    bricks_.emplace_back();
    works_.emplace_back();
    if (w.kind == weld::Weld::Kind::rigid || w.kind == weld::Weld::Kind::connector || w.deleted) continue;
    const model::Material& material = system.model.materials[system.model.parts[w.part].material];
    const model::WeldLaw& law = system.model.weld_laws[material.weld];
    histories_.back() = std::make_unique<weld::History>(
        law,
        weld::failure::make_function(system.model, law, weld::failure::geometry_of(system.model, w), w.place, findings),
        weld::damage_law(system.model, w));
    works_.back() = WeldWork(system, w);
    if (w.of_bricks()) bricks_.back() = std::make_unique<Bricks>(system, w);
  }
  length_.assign(histories_.size(), std::numeric_limits<double>::quiet_NaN());
  list_own();
}

void Welds::list_own() {
  share_ = system_.share();
  looked_at_.clear();
  for (std::size_t i = 0; i < histories_.size(); ++i)
    if (histories_[i] != nullptr && looks_at(i)) looked_at_.push_back(i);
}

std::vector<std::size_t> Welds::with_joints_of_each_cycle() const {
  std::vector<std::size_t> welds;
  for (const system::BrickJoint& joint : system_.brick_joints) welds.push_back(joint.weld);
  for (const weld::Stack& stack : system_.weld_stacks)
    for (const weld::Stack::Member& member : stack.welds) welds.push_back(member.weld);
  return welds;
}

std::vector<system::System::ElementLocation> Welds::locations(std::size_t i) const {
  const weld::Weld& w = system_.ties.welds[i];
  std::vector<system::System::ElementLocation> all;
  for (const model::Index e : w.elements) all.push_back(system_.location_of(w, e));
  return all;
}

system::System::ElementLocation Welds::first_location(std::size_t i) const {
  const weld::Weld& w = system_.ties.welds[i];
  return system_.location_of(w, w.elements.front());
}

bool Welds::looks_at(std::size_t i) const {
  return system_.computes(first_location(i));
}

void Welds::update(const system::State& state) {
  for (const BrickJoints::Work& joint : joints_.book()) works_[joint.weld].add(joint.at_end);
  if (share_ != system_.share()) list_own();
  for (const News& n : of_all_ranks(look_at_own(state))) {
    const weld::Weld& w = system_.ties.welds[n.weld];
    if (n.mode == weld::FailureMode::intact) {
      events_.push_back(fmt::format("spotweld {} begins to be damaged  id={:8d} time={:12.5E} cycle={}",
                                    weld::to_string(w.kind), w.id, state.time, state.cycle));
      continue;
    }
    if (!histories_[n.weld]->failed()) histories_[n.weld]->fail(state.time, n.mode);
    remove(n.weld);
    report(n.weld, state);
  }
}

std::vector<Welds::News> Welds::look_at_own(const system::State& state) {
  constexpr std::size_t together = 64;
  std::vector<std::vector<News>> of_stretch((looked_at_.size() + together - 1) / together);
  const auto look_at_stretches = [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s)
      for (std::size_t k = s * together; k < std::min(looked_at_.size(), (s + 1) * together); ++k)
        if (const std::size_t i = looked_at_[k]; !histories_[i]->failed()) look_at(i, state, of_stretch[s]);
  };
  // A user's library need not stand being called by several threads.
  if (system_.model.weld_library)
    look_at_stretches(0, of_stretch.size());
  else
    parallel_for(of_stretch.size(), 1, look_at_stretches);
  std::vector<News> news;
  for (const std::vector<News>& some : of_stretch) news.insert(news.end(), some.begin(), some.end());
  return news;
}

void Welds::look_at(std::size_t i, const system::State& state, std::vector<News>& news) {
  weld::History& history = *histories_[i];
  works_[i].add_step(system_, state);
  if (const weld::FailureMode end = element_failure_mode(i, state); end != weld::FailureMode::intact) {
    history.fail(state.time, end);
    news.push_back({i, end});
    return;
  }
  const bool was_undamaged = !history.damage().begun();
  if (history.update(load(i, state))) {
    news.push_back({i, history.mode()});
  } else if (history.damage().begun()) {
    apply_damage(i, was_undamaged);
    if (was_undamaged) news.push_back({i});
  }
}

std::vector<Welds::News> Welds::of_all_ranks(std::vector<News> own) const {
  if (share_ == nullptr || histories_.empty()) return own;
  // Of a weld that every rank looks at the first one speaks.
  std::erase_if(own, [&](const News& n) {
    const system::System::ElementLocation one = first_location(n.weld);
    return !share_->answers_for(one.group, at(one.element));
  });
  std::vector<News> all = gather_lists(share_->ranks(), own);
  std::ranges::sort(all, {}, &News::weld);
  return all;
}

template <class With>
void Welds::each_element(std::size_t i, const With& with) const {
  const weld::Weld& w = system_.ties.welds[i];
  for (model::Index e : w.elements) {
    const system::System::ElementLocation location = system_.location_of(w, e);
    with(*system_.groups[location.group], at(location.element));
  }
}

weld::failure::Load Welds::load(std::size_t i, const system::State& state) {
  weld::failure::Load load{resultants(i, state), 0.0, state.time};
  if (bricks_[i]) load.area = bricks_[i]->area;
  int elements = 0, points = 0;
  each_element(i, [&](const system::ElementGroup& group, std::size_t e) {
    load.energy += group.internal_energy(e) + group.hourglass_energy(e);
    if (!group.alive(e)) return;
    load.rate += group.strain_rate(e);
    ++elements;
    for (int k = 0; k < group.layers(); ++k) load.plastic_strain += group.plastic_strain(e, k);
    points += group.layers();
  });
  if (elements > 0) load.rate /= elements;
  if (points > 0) load.plastic_strain /= points;
  return load;
}

void Welds::apply_damage(std::size_t i, bool begins) {
  const weld::Damage& damage = histories_[i]->damage();
  each_element(i, [&](system::ElementGroup& group, std::size_t e) {
    if (begins && damage.law().freezes_yield) group.freeze_yield(e);
    group.set_integrity(e, damage.integrity());
  });
}

weld::FailureMode Welds::element_failure_mode(std::size_t i, const system::State& state) const {
  const model::WeldLaw& law = weld::law_of(system_.model, system_.ties.welds[i]);
  const std::size_t count = system_.ties.welds[i].elements.size();
  std::size_t active = 0;
  each_element(i, [&](const system::ElementGroup& group, std::size_t e) { active += group.alive(e); });
  // ASFF = 1: the first brick to fail takes its assembly with it.
  if (active == 0 || (law.damage.whole && active < count)) {
    if (state.time >= death_time_[i]) return weld::FailureMode::element_deleted;
    // What erosion took (ERODE, PSFAIL) has not reached the strain at which its points fail or their damage begins.
    const model::Part& part = system_.model.parts[system_.ties.welds[i].part];
    const auto* points = std::get_if<kernel::Spotweld>(&system_.model.materials[part.material].law);
    bool strained = points == nullptr;
    each_element(i, [&](const system::ElementGroup& group, std::size_t e) {
      for (int k = 0; points != nullptr && k < group.layers(); ++k)
        strained |= (points->failure_strain > 0.0 || points->damage.rupture > 0.0) &&
                    group.plastic_strain(e, k) >= points->failure_strain;
    });
    return strained ? weld::FailureMode::plastic_strain : weld::FailureMode::distortion;
  }
  if (law.connection && bricks_[i] && bricks_[i]->least_jacobian(system_, state) < law.jacobian_limit)
    return weld::FailureMode::distortion;
  return weld::FailureMode::intact;
}

weld::Resultants Welds::resultants(std::size_t i, const system::State& state) {
  if (Bricks* bricks = bricks_[i].get()) {
    bricks->gather(system_, state);
    const weld::BrickSection::Shape shape = bricks->section.shape(bricks->x);
    bricks->load = bricks->section.load(shape, bricks->x, bricks->force);
    // A sheared weld is longer along the line of its centres than along r, and has the same volume.
    bricks->area = shape.area * shape.length / norm(shape.centre[1] - shape.centre[0]);
    return bricks->load.middle;
  }
  const weld::Weld& w = system_.ties.welds[i];
  const system::System::ElementLocation location = system_.location_of(w, w.element);
  const std::array<double, 8> r = system_.groups[location.group]->resultants(at(location.element));
  return {r[0], r[1], r[2], r[3], r[4], r[5]};
}

void Welds::measure(const system::State& state) {
  if (share_ != system_.share()) list_own();
  for (const std::size_t i : looked_at_) length_[i] = length(i, state);
}

double Welds::length(std::size_t i, const system::State& state) const {
  if (!looks_at(i) && std::isfinite(length_[i])) return length_[i];
  if (const Bricks* bricks = bricks_[i].get()) {
    std::vector<Vec3d> x;
    for (int n : bricks->nodes) x.push_back(vec(state.x[n]));
    return bricks->section.shape(x).length;
  }
  const weld::Weld& w = system_.ties.welds[i];
  const system::System::ElementLocation location = system_.location_of(w, w.element);
  return system_.groups[location.group]->thickness(at(location.element));
}

void Welds::reset_work() {
  for (WeldWork& work : works_) work.reset();
  for (const auto& history : histories_)
    if (history) history->restart_course();
}

void Welds::remove(std::size_t i) {
  each_element(i, [](system::ElementGroup& group, std::size_t e) { group.remove(e); });
}

void Welds::delete_without_sheet(std::size_t i, const system::State& state) {
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

void Welds::carry(system::Carried, const system::System::Computed& of, system::Parcel& parcel) {
  system::ParcelArchive archive(parcel);
  for (std::size_t i = 0; i < histories_.size(); ++i) {
    if (histories_[i] == nullptr) continue;
    const system::System::ElementLocation one = first_location(i);
    if (of(one.group, at(one.element))) archive(*histories_[i], bricks_[i], works_[i], length_[i]);
  }
}

void Welds::Bricks::archive(Archive& a) {
  a(load, area);
  a.built(section, corners, nodes, x, force, jacobian, locations);
}

void Welds::archive(Archive& a) {
  a(histories_, bricks_, works_, joints_, stacks_, failed_, events_);
  a.built(system_, death_time_, looked_at_, share_, length_);
}

}  // namespace nugget::impact
