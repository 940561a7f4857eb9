// SPDX-License-Identifier: Apache-2.0
#include "impact/preloads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "base/index.hpp"
#include "impact/conditions.hpp"
#include "kernel/element/shell.hpp"

namespace nugget::impact {
namespace {

using Layer = system::ElementGroup::Layer;

/// The stress at `zeta` on straight lines between the places that are given; beyond the outermost it is theirs.
Layer between(const std::map<double, Layer>& given, double zeta) {
  const auto above = given.lower_bound(zeta);
  if (above == given.end()) return given.rbegin()->second;
  if (above == given.begin()) return above->second;
  const auto below = std::prev(above);
  const double share = (zeta - below->first) / (above->first - below->first);
  Layer l;
  for (std::size_t c = 0; c < 6; ++c)
    l.stress[c] = (1.0 - share) * below->second.stress[c] + share * above->second.stress[c];
  l.plastic_strain = (1.0 - share) * below->second.plastic_strain + share * above->second.plastic_strain;
  return l;
}

/// The points by their place, those of one place as their mean.
std::map<double, Layer> by_place(const std::vector<model::InitialPoint>& points) {
  std::map<double, std::pair<Layer, int>> sums;
  for (const model::InitialPoint& p : points) {
    auto& [sum, count] = sums[p.zeta];
    for (std::size_t c = 0; c < 6; ++c) sum.stress[c] += p.stress[c];
    sum.plastic_strain += p.plastic_strain;
    ++count;
  }
  std::map<double, Layer> means;
  for (auto& [zeta, entry] : sums) {
    for (double& c : entry.first.stress) c /= entry.second;
    entry.first.plastic_strain /= entry.second;
    means[zeta] = entry.first;
  }
  return means;
}

}  // namespace

std::vector<double> layer_places(const model::Model& model, int layers) {
  const kernel::LayerRule rule = model.control.lobatto ? kernel::lobatto_layers(layers) : kernel::gauss_layers(layers);
  return {rule.zeta.begin(), rule.zeta.begin() + layers};
}

double beam_area(const model::Model& model, model::Index beam) {
  const model::Part& part = model.parts[at(model.beams.part[at(beam)])];
  const model::SectionBeam& section = model.beam_sections[at(part.section)];
  if (section.volume > 0.0) {
    const auto& n = model.beams.node[at(beam)];
    const double length = norm(model.nodes.x[at(n[1])] - model.nodes.x[at(n[0])]);
    return length > 0.0 ? section.volume / length : 0.0;
  }
  const double outer = 0.5 * (section.outer[0] + section.outer[1]), inner = 0.5 * (section.inner[0] + section.inner[1]);
  return 0.25 * std::numbers::pi * (outer * outer - inner * inner);
}

Preloads::Preloads(system::System& system, Findings& findings) : system_(system) {
  const model::Model& model = system.model;
  for (const model::AxialForce& card : model.initial_state.axial_forces) {
    Prescribed p{{}, {}, &model.curves[at(card.curve)], true, {}, true, false};
    for (const model::Index beam : card.beams) {
      const system::System::Seat seat = system.beam_seat[at(beam)];
      const double area = beam_area(model, beam);
      if (seat.group < 0 || system.groups[at(seat.group)]->layers() == 0 || !(area > 0.0)) {
        findings.error(card.place, "*INITIAL_AXIAL_FORCE_BEAM",
                       fmt::format("beam {} has no section with stresses; weld beams (ELFORM 9) take an axial force",
                                   model.beams.id[at(beam)]),
                       "take it out of the set");
        continue;
      }
      p.seats.push_back(seat);
      p.scale.push_back(card.scale / area);
    }
    prescribed_.push_back(std::move(p));
  }
  for (const model::SectionStress& card : model.initial_state.section_stresses) {
    Prescribed p{{}, {}, &model.curves[at(card.curve)], false, card.normal, card.keep_shear, false};
    for (const model::Index solid : card.solids) {
      const system::System::Seat seat = system.solid_seat[at(solid)];
      if (seat.group < 0) continue;
      p.seats.push_back(seat);
      p.scale.push_back(1.0);
    }
    if (p.seats.empty())
      findings.error(card.place, "*INITIAL_STRESS_SECTION", "the cross section has no deformable bricks",
                     "cut it through bricks; beams take *INITIAL_AXIAL_FORCE_BEAM");
    prescribed_.push_back(std::move(p));
  }
}

void Preloads::start(const system::State& state) {
  const model::InitialState& initial = system_.model.initial_state;
  for (const model::InitialStress& s : initial.shells) start(s, system_.shell_seat[at(s.element)], true, state);
  for (const model::InitialStress& s : initial.solids) start(s, system_.solid_seat[at(s.element)], false, state);
}

void Preloads::start(const model::InitialStress& stress, const system::System::Seat& seat, bool shell,
                     const system::State& state) {
  if (seat.group < 0 || stress.points.empty()) return;
  system::ElementGroup& group = *system_.groups[at(seat.group)];
  const std::map<double, Layer> given = by_place(stress.points);
  const std::vector<double> places = shell ? layer_places(system_.model, group.layers()) : std::vector<double>{0.0};
  for (std::size_t k = 0; k < places.size(); ++k)
    group.set_layer(at(seat.element), static_cast<int>(k), between(given, places[k]), state);
}

void Preloads::set_active(Prescribed& p, bool active) {
  if (p.active == active) return;
  p.active = active;
  std::vector<int> groups;
  for (const system::System::Seat& seat : p.seats) groups.push_back(seat.group);
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  for (const int g : groups) system_.groups[at(g)]->step_share *= active ? 0.5 : 2.0;
}

void Preloads::apply(const system::State& state) {
  for (Prescribed& p : prescribed_) {
    set_active(p, in_force(*p.curve, state) && state.time <= p.curve->x.back());
    if (!p.active) continue;
    const double value = p.curve->clamped(state.time);
    for (std::size_t i = 0; i < p.seats.size(); ++i) {
      system::ElementGroup& group = *system_.groups[at(p.seats[i].group)];
      const std::size_t e = at(p.seats[i].element);
      if (!group.alive(e)) continue;
      const double stress = p.scale[i] * value;
      for (int k = 0; k < group.layers(); ++k) {
        Layer l = group.layer(e, k, state);
        if (p.beams) {
          l.stress[0] = stress;
        } else {
          const Vec3d& n = p.normal;
          const std::array<double, 6> nn{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
          double normal = 0.0;
          for (std::size_t c = 0; c < 6; ++c) normal += (c < 3 ? 1.0 : 2.0) * nn[c] * l.stress[c];
          for (std::size_t c = 0; c < 6; ++c)
            l.stress[c] = p.keep_others ? l.stress[c] + (stress - normal) * nn[c] : stress * nn[c];
        }
        group.set_layer(e, k, l, state);
      }
    }
  }
}

}  // namespace nugget::impact
