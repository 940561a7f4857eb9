// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/preloads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "base/index.hpp"
#include "impact/conditions/in_force.hpp"
#include "model/bond.hpp"
#include "model/lumped_mass.hpp"
#include "output/element_stresses.hpp"
#include "system/shell_elements.hpp"

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

bool takes_stress(const system::ElementGroup& group) {
  const auto* takes = dynamic_cast<const system::TakesStress*>(&group);
  return takes && takes->takes_stress();
}

bool is_weld(const model::Model& model, model::Index solid) {
  return model.materials[model.parts[model.solids.part[solid]].material].weld != model::none;
}

std::string why_no_stress(const model::Model& model, model::Index solid) {
  if (is_weld(model, solid))
    return fmt::format(
        "solid {} takes no imposed stress: it is a weld with the stresses of its cross-section only "
        "(E below 0, _UNIAXIAL)",
        model.solids.id[solid]);
  const bool bond = model::bond_of(model, model.parts[model.solids.part[solid]]) != nullptr;
  return fmt::format("solid {} takes no stress: {}", model.solids.id[solid],
                     bond ? "it is adhesive, which begins without tractions"
                     : model.has_thick_shells(model.solids.part[solid])
                         ? "thick shells begin without stress here"
                         : "in tetrahedra of ELFORM 13 the nodes have the pressure");
}

/// Where the size of the curve's values falls for the first time, or its end.
double end_of_rise(const Curve& curve) {
  for (std::size_t i = 1; i < curve.x.size(); ++i)
    if (std::abs(curve.y[i]) < std::abs(curve.y[i - 1])) return curve.x[i - 1];
  return curve.x.back();
}

}  // namespace

std::vector<double> layer_places(const model::Model& model, const system::ElementGroup& group) {
  const kernel::LayerRule rule = system::layer_rule(model, group.part);
  return {rule.zeta.begin(), rule.zeta.begin() + rule.count};
}

double beam_area(const model::Model& model, model::Index beam) {
  const model::Part& part = model.parts[model.beams.part[beam]];
  const model::SectionBeam& section = model.beam_sections[part.section];
  if (section.volume > 0.0) {
    const auto& n = model.beams.node[beam];
    const double length = norm(model.nodes.x[n[1]] - model.nodes.x[n[0]]);
    return length > 0.0 ? section.volume / length : 0.0;
  }
  return model::beam_area(section);
}

bool Preloads::empty() const {
  const model::InitialState& given = system_.model.initial_state;
  return given.shells.empty() && given.solids.empty() && given.axial_forces.empty() && given.section_stresses.empty();
}

Preloads::Preloads(system::System& system, Findings& findings) : system_(system) {
  using Others = system::ImposedStress::Others;
  const model::Model& model = system.model;
  const auto begun = [&](model::Index curve) {
    Prescribed p;
    p.curve = &model.curves[curve];
    p.begin = p.curve->x.front();
    p.end = end_of_rise(*p.curve);
    return p;
  };
  for (const model::AxialForce& card : model.initial_state.axial_forces) {
    Prescribed p = begun(card.curve);
    for (const model::Index beam : card.beams) {
      const double area = beam_area(model, beam);
      const system::ImposedStress stress{
          0, {1, 0, 0}, card.scale / area, card.bends ? Others::bending : Others::kept, area};
      if (!(area > 0.0) || !prescribe(p, system.beam_location[beam], stress))
        findings.error(card.place, "*INITIAL_AXIAL_FORCE_BEAM",
                       fmt::format("beam {} has no section with stresses; weld beams (ELFORM 9), integrated beams "
                                   "(ELFORM 1) and trusses (ELFORM 3) take an axial force",
                                   model.beams.id[beam]),
                       "take it out of the set");
    }
    prescribed_.push_back(std::move(p));
  }
  for (const model::SectionStress& card : model.initial_state.section_stresses) {
    Prescribed p = begun(card.curve);
    const Others others = card.bends ? Others::bending : card.keep_shear ? Others::kept : Others::none;
    for (const model::Index solid : card.solids) {
      const system::System::ElementLocation location = system.solid_location[solid];
      if (location.group >= 0 && !prescribe(p, location, {0, card.normal, 1.0, others}))
        findings.error(card.place, "*INITIAL_STRESS_SECTION", why_no_stress(model, solid),
                       "use tetrahedra of ELFORM 10, or cut through bricks");
    }
    if (p.elements.empty())
      findings.error(card.place, "*INITIAL_STRESS_SECTION", "the cross section has no deformable bricks",
                     "cut it through bricks; beams take *INITIAL_AXIAL_FORCE_BEAM");
    prescribed_.push_back(std::move(p));
  }
  for (const model::InitialStress& s : model.initial_state.solids) {
    const system::System::ElementLocation location = system.solid_location[s.element];
    if (location.group < 0 || is_weld(model, s.element) || takes_stress(*system.groups[location.group])) continue;
    findings.error(s.place, "*INITIAL_STRESS_SOLID", why_no_stress(model, s.element),
                   "take it out, or use bricks, or tetrahedra of ELFORM 10");
  }
  for (const Prescribed& p : prescribed_)
    for (const auto& [group, stress] : p.elements) groups_.push_back(group);
  std::sort(groups_.begin(), groups_.end());
  groups_.erase(std::unique(groups_.begin(), groups_.end()), groups_.end());
}

bool Preloads::prescribe(Prescribed& p, const system::System::ElementLocation& location,
                         system::ImposedStress stress) const {
  if (location.group < 0 || !takes_stress(*system_.groups[location.group])) return false;
  stress.element = at(location.element);
  p.elements.emplace_back(location.group, stress);
  return true;
}

void Preloads::start(const system::State& state) {
  const model::InitialState& initial = system_.model.initial_state;
  for (const model::InitialStress& s : initial.shells) start(s, system_.shell_location[s.element], true, state);
  for (const model::InitialStress& s : initial.solids) start(s, system_.solid_location[s.element], false, state);
}

void Preloads::start(const model::InitialStress& stress, const system::System::ElementLocation& location, bool shell,
                     const system::State& state) {
  if (location.group < 0 || stress.points.empty() || !system_.computes(location)) return;
  system::ElementGroup& group = *system_.groups[location.group];
  const std::map<double, Layer> given = by_place(stress.points);
  const std::vector<double> places = shell ? layer_places(system_.model, group) : std::vector<double>{0.0};
  for (std::size_t k = 0; k < places.size(); ++k) {
    Layer layer = between(given, places[k]);
    layer.stress = output::stress_of_kernel(system_, group, at(location.element), state, layer.stress);
    group.set_layer(at(location.element), static_cast<int>(k), layer, state);
  }
}

void Preloads::apply(const system::State& state) {
  for (const int group : groups_) {
    std::vector<system::ImposedStress> stresses;
    for (const Prescribed& p : prescribed_) {
      if (!in_force(*p.curve, state) || state.time < p.begin || state.time > p.end) continue;
      const double value = p.curve->clamped(state.time);
      for (const auto& [g, stress] : p.elements) {
        if (g != group) continue;
        stresses.push_back(stress);
        stresses.back().stress *= value;
      }
    }
    std::stable_sort(
        stresses.begin(), stresses.end(),
        [](const system::ImposedStress& a, const system::ImposedStress& b) { return a.element < b.element; });
    dynamic_cast<system::TakesStress&>(*system_.groups[group]).impose(std::move(stresses));
  }
}

void Preloads::archive(Archive& a) {
  a.built(system_, prescribed_, groups_);
}

}  // namespace nugget::impact
