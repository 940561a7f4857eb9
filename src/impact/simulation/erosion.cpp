// SPDX-License-Identifier: Apache-2.0
#include "impact/simulation/erosion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/index.hpp"

namespace nugget::impact {
namespace {

using model::ElementKind;

/// Whether the quadrilateral has a negative Jacobian at a corner: its normal there points to the other side.
bool inside_out(const std::array<Vec3d, 4>& x) {
  const Vec3d normal = cross(x[2] - x[0], x[3] - x[1]);
  for (std::size_t i = 0; i < 4; ++i)
    if (dot(cross(x[(i + 1) % 4] - x[i], x[(i + 3) % 4] - x[i]), normal) < 0.0) return true;
  return false;
}

/// Share of the first step that stands for DTMIN where elements are to be deleted and the deck gives none. A solid that
/// is squeezed flat takes the step to nothing, and time to a standstill, before its volume turns negative.
constexpr double smallest_share = 1e-6;

/// NFAIL1, NFAIL4 above 2: so many failed shells end the run, whatever made them fail (keyword manual). Why it is to
/// end, or empty.
std::string too_many_failed(const system::System& system, double time) {
  const model::Control& control = system.model.control;
  for (const auto& [field, limit] :
       {std::pair{"NFAIL1", control.distorted_shells}, std::pair{"NFAIL4", control.distorted_full_shells}}) {
    if (limit <= 2) continue;
    int failed = 0;
    for (const auto& group : system.groups)
      for (std::size_t e = 0; group->kind == ElementKind::shell && e < group->size(); ++e) failed += !group->alive(e);
    if (failed >= limit)
      return fmt::format("{} shells have failed by time {:.6g}: {} = {} ends the run there", failed, time, field,
                         limit);
  }
  return {};
}

}  // namespace

Erosion::Erosion(system::System& system) : system_(system) {
  for (const model::ElementDeath& death : system.model.element_deaths)
    (death.control == model::none ? deaths_ : switched_).push_back(death);
  std::stable_sort(deaths_.begin(), deaths_.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
}

bool Erosion::wants_small_steps(ElementKind kind) const {
  const model::Control& control = system_.model.control;
  if (kind == ElementKind::discrete) return false;
  // PSFAIL is about negative volumes; small steps it lets all solids be deleted for (keyword manual).
  if (kind == ElementKind::solid && !control.eroding_parts.empty()) return true;
  const int place = kind == ElementKind::solid ? 1 : kind == ElementKind::shell ? 10 : 100;
  return control.erode_small_steps / place % 10 == 1;
}

bool Erosion::wants_negative_volume(const system::ElementGroup& group) const {
  const model::Control& control = system_.model.control;
  const auto& parts = control.eroding_parts;
  if (!parts.empty()) return std::find(parts.begin(), parts.end(), group.part) != parts.end();
  return control.erode_small_steps % 10 == 1;
}

/// NFAIL1 or NFAIL4 for quadrilaterals of the parts of PSNFAIL, else 0.
int Erosion::distortion_rule(const system::ElementGroup& group) const {
  if (group.kind != ElementKind::shell || group.nodes_per_element != 4) return 0;
  const model::Model& model = system_.model;
  const auto& parts = model.control.parts_of_distorted;
  if (!parts.empty() && std::find(parts.begin(), parts.end(), group.part) == parts.end()) return 0;
  const int elform = model.shell_sections[model.parts[group.part].section].elform;
  return elform == 16 || elform == 9 ? model.control.distorted_full_shells : model.control.distorted_shells;
}

double Erosion::smallest_step(double first_step) const {
  const auto small = [this](const auto& group) { return wants_small_steps(group->kind); };
  if (std::none_of(system_.groups.begin(), system_.groups.end(), small)) return 0.0;
  const double dtmin = system_.model.control.smallest_step;
  return (dtmin > 0.0 ? dtmin : smallest_share) * first_step;
}

void Erosion::update(const system::State& state, double first_step) {
  delete_by_time(state.time);
  delete_by_switch(state);
  const double limit = smallest_step(first_step);
  for (const auto& group : system_.groups) {
    if (group->inverted >= 0 && wants_negative_volume(*group)) delete_negative_volumes(*group, state.time);
    if (wants_small_steps(group->kind)) delete_small_steps(*group, limit, state.time);
    if (const int rule = distortion_rule(*group); rule > 0) check_distortion(*group, rule, state);
  }
  if (stop_.empty()) stop_ = too_many_failed(system_, state.time);
}

void Erosion::delete_by_time(double time) {
  for (; next_death_ < deaths_.size() && deaths_[next_death_].time <= time; ++next_death_)
    delete_one(deaths_[next_death_], time, "as *DEFINE_ELEMENT_DEATH says");
}

void Erosion::delete_by_switch(const system::State& state) {
  std::erase_if(switched_, [&](const model::ElementDeath& death) {
    if (state.acts(death.control)) return false;
    delete_one(death, state.time,
               fmt::format("as *SENSOR_CONTROL {} says", system_.model.sensor_controls[death.control].id));
    return true;
  });
}

void Erosion::delete_one(const model::ElementDeath& death, double time, std::string_view why) {
  const system::System::ElementLocation location = system_.location_of(death.kind, death.element);
  if (location.group < 0) return;
  system::ElementGroup& group = *system_.groups[location.group];
  const std::size_t e = at(location.element);
  if (!group.alive(e)) return;
  remove(group, e, time, why);
  group.release_step(e);
}

void Erosion::remove(system::ElementGroup& group, std::size_t e, double time, std::string_view why) {
  const model::Model& model = system_.model;
  const auto element = at(group.element[e]);
  const bool shell = group.kind == ElementKind::shell, solid = group.kind == ElementKind::solid;
  const std::vector<int>& ids = shell ? model.shells.id : solid ? model.solids.id : model.beams.id;
  events_.push_back(fmt::format("time {:.6g}: {} {} of part {} is deleted, {}", time,
                                shell   ? "shell"
                                : solid ? "solid"
                                        : "beam",
                                ids[element], model.parts[group.part].id, why));
  group.remove(e);
}

void Erosion::delete_negative_volumes(system::ElementGroup& group, double time) {
  for (std::size_t e = 0; e < group.size(); ++e) {
    // The step of a brick goes with its volume, and is no number where that is 0.
    if (!group.alive(e) || group.stable_step(e) > 0.0) continue;
    remove(group, e, time, "its volume is negative");
    group.release_step(e);
    ++deleted_.negative_volume;
  }
  group.inverted = -1;
}

void Erosion::delete_small_steps(system::ElementGroup& group, double limit, double time) {
  const double share = group.step_share;
  for (std::size_t b = 0; b < group.blocks(); ++b) {
    if (!(share * group.block_step[b] < limit)) continue;
    const std::size_t end = std::min(group.size(), (b + 1) * group.block_width());
    for (std::size_t e = b * group.block_width(); e < end; ++e) {
      if (!group.alive(e) || !(share * group.stable_step(e) < limit)) continue;
      remove(group, e, time,
             system_.model.control.smallest_step > 0.0 ? "its step fell below DTMIN" : "its step fell to nothing");
      group.release_step(e);
      ++deleted_.small_step;
    }
  }
}

void Erosion::check_distortion(system::ElementGroup& group, int rule, const system::State& state) {
  for (std::size_t e = 0; e < group.size(); ++e) {
    if (!group.alive(e)) continue;
    const auto nodes = group.nodes(e);
    std::array<Vec3d, 4> x;
    for (std::size_t a = 0; a < 4; ++a) x[a] = vec(state.x[nodes[a]]);
    if (!inside_out(x)) continue;
    if (rule == 2) {
      stop_ = fmt::format(
          "shell {} of part {} is distorted: a corner of it has turned inside out at time {:.6g} (NFAIL1, NFAIL4 = 2)",
          system_.model.shells.id[group.element[e]], system_.model.parts[group.part].id, state.time);
      return;
    }
    remove(group, e, state.time, "a corner of it has turned inside out");
    ++deleted_.distorted;
  }
}

void Erosion::archive(Archive& a) {
  a(deleted_, events_, stop_, next_death_, switched_);
  a.built(system_, deaths_);
}

}  // namespace nugget::impact
