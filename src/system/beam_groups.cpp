// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "base/index.hpp"
#include "model/discrete_beam_section.hpp"
#include "system/beam_elements.hpp"
#include "system/discrete_beam_element.hpp"
#include "system/groups.hpp"
#include "system/spring_group.hpp"
#include "system/weld_beam_element.hpp"
#include "weld/tie/joints.hpp"
#include "weld/tie/welds.hpp"

// Which kernel runs which beams and springs.
namespace nugget::system {
namespace {

kernel::WeldBeamProperties integrated_beam(const model::SectionBeam& section, double density) {
  kernel::WeldBeamProperties beam;
  beam.density = density;
  beam.shear_factor = section.shear_factor;
  beam.mass_per_length = section.extra_mass;
  const double first = 0.5 * (section.outer[0] + section.outer[1]),
               second = 0.5 * (section.inner[0] + section.inner[1]);
  if (section.points) {
    beam.fibres = section.points->fibres;
    beam.torsion_share = section.points->torsion_share;
    beam.offset_s = section.points->offset_s;
    beam.offset_t = section.points->offset_t;
    return beam;
  }
  if (section.cross_section == 1) {
    beam.fibres = kernel::disc_fibres(first, second, section.quadrature);
    return beam;
  }
  beam.fibres = kernel::rectangle_fibres(first, second, section.quadrature);
  beam.torsion_share = kernel::rectangle_torsion_share(first, second);
  beam.offset_s = -0.5 * section.location[0] * first;
  beam.offset_t = -0.5 * section.location[1] * second;
  for (std::size_t k = 0; k < at(beam.fibres.count); ++k) {
    beam.fibres.s[k] += beam.offset_s;
    beam.fibres.t[k] += beam.offset_t;
  }
  return beam;
}

/// A weld beam whose end is tied to deformable shells has nothing there to twist against, unless they have drilling
/// stiffness or the tie turns the twist into in-plane forces, as it does by area.
bool free_to_twist(const model::Model& model, const weld::Weld& w) {
  return std::any_of(w.ends.begin(), w.ends.end(), [&](const weld::Projection& e) {
    const bool drills = e.tie.shell != model::none && model.parts[e.tie.part].drilling > 0.0;
    return e.tied && e.projection_case != 0 && e.tie.rigid_body == model::none && !e.tie.twist && !e.tie.couples &&
           !e.tie.by_area() && !drills;
  });
}

}  // namespace

void System::make_weld_beams(Findings& findings) {
  beam_location.assign(model.beams.size(), {});
  const std::vector<bool> deleted = deleted_with_welds(false);
  std::vector<bool> untwistable(model.beams.size(), false), held(model.beams.size(), true);
  std::vector<std::optional<kernel::WeldJoint>> joints(model.beams.size());
  const std::vector<std::optional<weld::Joint>> joint_of_weld = weld::joints_of(model, ties);
  weld_stacks = weld::stacks_of(model, ties, joint_of_weld).stacks;
  std::vector<bool> stacked(ties.welds.size(), false);
  for (const weld::Stack& stack : weld_stacks)
    for (const weld::Stack::Member& member : stack.welds) stacked[member.weld] = true;
  for (std::size_t i = 0; i < ties.welds.size(); ++i) {
    const weld::Weld& w = ties.welds[i];
    if (w.kind != weld::Weld::Kind::beam) continue;
    if (joint_of_weld[i]) joints[w.element] = joint_of_weld[i]->law;
    if (stacked[i]) joints[w.element]->flow_from_outside();
    untwistable[w.element] = free_to_twist(model, w);
    held[w.element] = weld::scaled_to_the_step_of_the_run(model, w);
  }
  std::size_t untwisted = 0;
  const auto sorted = by_part(model.beams, model.parts.size(), ties.x);
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    if (sorted[p].empty()) continue;
    if (model.beam_sections[model.parts[p].section].elform == 6) {
      std::vector<model::Index> kept;
      for (model::Index e : sorted[p])
        if (!deleted[e]) kept.push_back(e);
      add_discrete_beams(p, kept, findings);
      continue;
    }
    if (!std::holds_alternative<kernel::Spotweld>(model.materials[model.parts[p].material].law)) {
      add_beams(p, sorted[p]);
      continue;
    }
    const bool wants_torsion = model.beam_sections[model.parts[p].section].torsion;
    std::array<std::vector<model::Index>, 4> chosen;  // held or not, each with torsion and without
    for (model::Index e : sorted[p]) {
      if (deleted[e]) continue;
      untwisted += wants_torsion && untwistable[e];
      chosen[(held[e] ? 0 : 2) + (wants_torsion && !untwistable[e] ? 0 : 1)].push_back(e);
    }
    for (int i = 0; i < 4; ++i) {
      const auto joined = [&](model::Index e) { return joints[e].has_value(); };
      const auto first = std::stable_partition(chosen[i].begin(), chosen[i].end(), std::not_fn(joined));
      const std::vector<model::Index> with(first, chosen[i].end());
      chosen[i].erase(first, chosen[i].end());
      add_weld_beams(p, chosen[i], i % 2 == 0, i < 2, {});
      add_weld_beams(p, with, i % 2 == 0, i < 2, joints);
    }
  }
  weld::report_joints(model, ties, findings);
  if (untwisted > 0)
    findings.note(
        {model.deck, 0, 0}, "*CONTACT_SPOTWELD",
        fmt::format("no torsion in {} weld beam{}: the shells have no stiffness about their normal to hold it",
                    untwisted, untwisted == 1 ? "" : "s"),
        "*CONTACT_SPOTWELD_WITH_TORSION turns it into in-plane forces");
}

void System::add_beams(std::size_t p, const std::vector<model::Index>& chosen) {
  const model::Part& part = model.parts[p];
  const model::SectionBeam& section = model.beam_sections[part.section];
  const model::Material& material = model.materials[part.material];
  const Members m = members(model.beams, chosen);
  const auto kind = model::ElementKind::beam;
  if (section.elform == 2) {
    if (const auto* law = std::get_if<kernel::Elastic>(&material.law))
      return add_group(ResultantBeamElement{{material.density, section.area, section.moment_s, section.moment_t,
                                             section.torsion_constant, section.shear_area, section.extra_mass},
                                            {law->E, law->nu},
                                            model.beams,
                                            ties.x},
                       kind, p, m, beam_location);
  }
  const bool computed = with_law(material.law, [&]<class Law>(const Law& law) {
    if (section.elform == 3)
      add_group(TrussElement<Law>{section.area, material.density, section.extra_mass, kernel::LawKernel<Law>(law)},
                kind, p, m, beam_location);
    else if (section.elform == 1)
      add_group(IntegratedBeamElement<Law>{integrated_beam(section, material.density), kernel::LawKernel<Law>(law),
                                           law.nu, model.beams, ties.x},
                kind, p, m, beam_location);
  });
  if (computed) return;
  for (const ElementNodes& node : m.node) {
    const double length = norm(start_[node[1]] - start_[node[0]]);
    const double whole = (material.density * model::beam_area(section) + section.extra_mass) * length;
    mass_only_elements_.push_back({static_cast<model::Index>(p), 2, node, whole, whole * length * length / 24.0});
  }
}

void System::add_discrete_beams(std::size_t p, const std::vector<model::Index>& chosen, Findings& findings) {
  if (chosen.empty()) return;
  const model::Part& part = model.parts[p];
  const model::SectionBeam& section = model.beam_sections[part.section];
  const model::Material& material = model.materials[part.material];
  const auto* law = std::get_if<kernel::DiscreteBeam>(&material.law);
  if (law == nullptr) return;  // refused by the model
  const kernel::DiscreteBeamProperties beam = model::discrete_beam_properties(section, material, *law);
  std::optional<Frame3d> axes;
  if (section.system != model::none) axes = model.systems[section.system].axes;
  for (const model::Index e : chosen) {
    const auto& n = model.beams.node[e];
    const Vec3d line = ties.x[n[1]] - ties.x[n[0]], side = model.beams.side(at(e), ties.x);
    const bool has_length = norm(line) > 0.0, between_points = beam.between_points && has_length;
    const auto report = [&](Severity severity, const std::string& what, const char* remedy) {
      findings.add({severity,
                    model.beams.place[e],
                    "*ELEMENT_BEAM",
                    {},
                    {},
                    fmt::format("discrete beam {} {}", model.beams.id[e], what),
                    remedy});
    };
    if (law->cable && !(norm(line) > std::max(beam.cable_offset, 0.0)))
      report(Severity::error,
             fmt::format("is a cable of length {:.6g}, of which OFFSET {:.6g} leaves no unstretched length", norm(line),
                         beam.cable_offset),
             "put its nodes apart, farther than OFFSET");
    if (beam.follows_line() && !has_length)
      report(Severity::error, fmt::format("has no length, so its r axis cannot follow it (SCOOR = {})", section.scoor),
             "write SCOOR 0 for beams of no length");
    if (between_points && axes && norm(cross(unit(line), axes->e1)) > 1e-6)
      report(Severity::warning, "acts along the line of its nodes, as its law says, not along the r axis of CID",
             "put both nodes at one place, or take *MAT_GENERAL_SPRING_DISCRETE_BEAM");
    if (!between_points && !axes && norm(side) > 0.0 && !(norm(cross(line, side)) > 1e-9 * norm(side) * norm(line)))
      report(Severity::warning,
             "has a third node that gives it no axes, for want of length or of direction: it has the global ones",
             "give the section a CID");
  }
  add_group(DiscreteBeamElement{beam, *law, axes, model.beams, ties.x}, model::ElementKind::beam, p,
            members(model.beams, chosen), beam_location);
}

void System::make_springs() {
  discrete_location.assign(model.discretes.size(), {});
  std::map<std::pair<model::Index, bool>, std::vector<model::Index>> sorted;
  for (std::size_t e = 0; e < model.discretes.size(); ++e)
    sorted[{model.discretes[e].part, model.discretes[e].grounded()}].push_back(static_cast<model::Index>(e));
  for (const auto& [key, chosen] : sorted) {
    for (std::size_t i = 0; i < chosen.size(); ++i)
      discrete_location[chosen[i]] = {static_cast<int>(groups.size()), static_cast<int>(i)};
    groups.push_back(std::make_unique<SpringGroup>(model, key.first, chosen, node_of, start_));
  }
}

void System::add_weld_beams(std::size_t p, const std::vector<model::Index>& chosen, bool torsion, bool held,
                            const std::vector<std::optional<kernel::WeldJoint>>& joints) {
  if (chosen.empty()) return;
  const model::Part& part = model.parts[p];
  const model::Material& material = model.materials[part.material];
  const auto* law = std::get_if<kernel::Spotweld>(&material.law);
  if (law == nullptr) return;  // refused by the model
  const model::SectionBeam& section = model.beam_sections[part.section];
  kernel::WeldBeamProperties beam;
  beam.density = material.density;
  beam.fibres = kernel::disc_fibres(0.5 * (section.outer[0] + section.outer[1]),
                                    0.5 * (section.inner[0] + section.inner[1]), section.quadrature);
  beam.shear_factor = section.shear_factor;
  beam.no_torsion = !torsion;
  std::map<model::Index, std::size_t> joint_of;
  if (!joints.empty())
    for (const model::Index e : chosen) {
      joint_of[e] = beam.joints.size();
      beam.joints.push_back(*joints[e]);
    }
  const std::size_t first = groups.size();
  add_group(WeldBeamElement{{beam, kernel::LawKernel<kernel::Spotweld>(*law), law->nu, model.beams, ties.x}, joint_of},
            model::ElementKind::beam, p, members(model.beams, chosen), beam_location);
  for (std::size_t g = first; g < groups.size(); ++g) scale_weld_mass(*groups[g], *law, held);
}

}  // namespace nugget::system
