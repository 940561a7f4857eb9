// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>

#include "base/index.hpp"
#include "kernel/law/composed_law_kernel.hpp"
#include "kernel/law/laminate_kernel.hpp"
#include "kernel/law/law_components.hpp"
#include "model/bond.hpp"
#include "model/lumped_mass.hpp"
#include "system/batch_group.hpp"
#include "system/beam_elements.hpp"
#include "system/brick_element.hpp"
#include "system/cohesive_brick_element.hpp"
#include "system/discrete_beam_element.hpp"
#include "system/order.hpp"
#include "system/quadratic_tetrahedron_element.hpp"
#include "system/rotational_tetrahedron_element.hpp"
#include "system/shell_elements.hpp"
#include "system/spring_group.hpp"
#include "system/system.hpp"
#include "system/tetrahedron_element.hpp"
#include "system/weld_beam_element.hpp"
#include "weld/failure/connection.hpp"
#include "weld/tie/welds.hpp"

// Which kernel runs which element: one group a part and formulation.
namespace nugget::system {
namespace {

kernel::ThicknessUpdate thickness_update(int istupd) {
  return istupd == 0   ? kernel::ThicknessUpdate::none
         : istupd == 4 ? kernel::ThicknessUpdate::plastic
                       : kernel::ThicknessUpdate::all;
}

}  // namespace

kernel::LayerRule layer_rule(const model::SectionShell& section, const model::Control& control) {
  if (!section.rule.empty()) {
    kernel::LayerRule rule;
    rule.count = static_cast<int>(section.rule.size());
    for (std::size_t k = 0; k < section.rule.size(); ++k)
      rule.zeta[k] = section.rule[k][0], rule.weight[k] = section.rule[k][1];
    return rule;
  }
  if (section.trapezoidal) {
    kernel::LayerRule rule;
    rule.count = section.layers;
    for (int k = 0; k < section.layers; ++k) {
      rule.zeta[at(k)] = section.layers == 1 ? 0.0 : -1.0 + 2.0 * k / (section.layers - 1);
      rule.weight[at(k)] =
          section.layers == 1 ? 1.0 : (k == 0 || k == section.layers - 1 ? 0.5 : 1.0) / (section.layers - 1);
    }
    return rule;
  }
  return control.lobatto ? kernel::lobatto_layers(section.layers) : kernel::gauss_layers(section.layers);
}

kernel::LayerRule layer_rule(const model::Model& model, model::Index part) {
  return layer_rule(model.shell_sections[at(model.parts[at(part)].section)], model.control);
}

std::array<double, 6> global_stress(const Frame3d& f, double xx, double yy, double xy, double xz, double yz) {
  // sigma = sum_ij s_ij e_i e_j, with s_zz = 0.
  const Vec3d a = xx * f.e1 + xy * f.e2 + xz * f.e3, b = xy * f.e1 + yy * f.e2 + yz * f.e3, c = xz * f.e1 + yz * f.e2;
  const auto component = [&](double Vec3d::*i, double Vec3d::*j) {
    return a.*i * f.e1.*j + b.*i * f.e2.*j + c.*i * f.e3.*j;
  };
  return {component(&Vec3d::x, &Vec3d::x), component(&Vec3d::y, &Vec3d::y), component(&Vec3d::z, &Vec3d::z),
          component(&Vec3d::x, &Vec3d::y), component(&Vec3d::y, &Vec3d::z), component(&Vec3d::z, &Vec3d::x)};
}

std::array<double, 5> local_stress(const Frame3d& f, const std::array<double, 6>& s) {
  const auto times = [&](const Vec3d& a) {
    return Vec3d{s[0] * a.x + s[3] * a.y + s[5] * a.z, s[3] * a.x + s[1] * a.y + s[4] * a.z,
                 s[5] * a.x + s[4] * a.y + s[2] * a.z};
  };
  return {dot(f.e1, times(f.e1)), dot(f.e2, times(f.e2)), dot(f.e1, times(f.e2)), dot(f.e1, times(f.e3)),
          dot(f.e2, times(f.e3))};
}

namespace {

/// Elements sorted by part, within a part along a Morton curve.
template <class Elements>
std::vector<std::vector<model::Index>> by_part(const Elements& elements, std::size_t parts,
                                               const std::vector<Vec3d>& x) {
  std::vector<Vec3d> centre(elements.size());
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (model::Index k : elements.node[e])
      centre[e] += (1.0 / static_cast<double>(elements.node[e].size())) * x[at(k)];
  std::vector<std::vector<model::Index>> sorted(parts);
  for (int e : morton_order(centre)) sorted[at(elements.part[at(e)])].push_back(e);
  return sorted;
}

/// Calls `with` for the laws that shells and bricks have kernels for; false for the others (rigid, null, welds).
template <class With>
bool with_law(const model::Law& law, const With& with) {
  return std::visit(
      [&]<class Law>(const Law& l) {
        constexpr bool computed =
            std::is_same_v<Law, kernel::Elastic> || std::is_same_v<Law, kernel::PlasticKinematic> ||
            std::is_same_v<Law, kernel::PiecewiseLinear> || std::is_same_v<Law, kernel::ComposedLaw>;
        if constexpr (computed) with(l);
        return computed;
      },
      law);
}

/// The same of shells, which may have layers.
template <class With>
bool with_shell_law(const model::Law& law, const With& with) {
  if (const auto* laminate = std::get_if<kernel::Laminate>(&law)) {
    with(*laminate);
    return true;
  }
  return with_law(law, with);
}

double bulk_modulus(const kernel::ElasticConstants& e) {
  return e.E / (3.0 * (1.0 - 2.0 * e.nu));
}

std::vector<std::array<int, 4>> first_four(const std::vector<ElementNodes>& nodes) {
  std::vector<std::array<int, 4>> four;
  for (const auto& n : nodes) four.push_back({n[0], n[1], n[2], n[3]});
  return four;
}

bool fully_integrated(const model::SectionShell& section) {
  return section.elform == 16;
}

bool bends_without_locking(int elform) {
  return elform == -1 || elform == -2 || elform == 3;
}
template <class Law>
FullBrickElement<Law> full_brick(const BrickElement<Law>& of, const model::SectionSolid& section) {
  return {of, bends_without_locking(section.elform) ? kernel::BrickStrains::assumed
                                                    : kernel::BrickStrains::shape_functions};
}

kernel::ShellProperties shell_properties(const model::Part& part, const model::SectionShell& section,
                                         const model::Material& material, const model::Hourglass& hourglass,
                                         const model::Control& control) {
  kernel::ShellProperties shell;
  shell.density = material.density;
  shell.layers = layer_rule(section, control);
  shell.shear_factor = section.shear_factor;
  shell.offset = section.nloc;
  shell.hourglass = hourglass.type == 0 ? 1 : hourglass.type;
  shell.membrane_hourglass = hourglass.membrane;
  shell.bending_hourglass = hourglass.bending;
  shell.warping_hourglass = hourglass.warping;
  shell.thickness_update = thickness_update(control.thickness_update);
  shell.warping_stiffness =
      fully_integrated(section) ? hourglass.type == 8 : control.warping_stiffness || section.warping_stiffness;
  shell.drilling = kernel::usual_drilling * part.drilling;
  shell.length = control.length_basis == 2   ? kernel::ShellLength::bar
                 : control.length_basis == 1 ? kernel::ShellLength::area_over_diagonal
                                             : kernel::ShellLength::area_over_side;
  if (const auto* laminate = std::get_if<kernel::Laminate>(&material.law)) {
    shell.profile = laminate->profile;
    if (laminate->shear_factor > 0.0) shell.shear_factor = laminate->shear_factor;
    if (shell.hourglass >= 4) shell.bending_hourglass *= shell.profile.stiffness_spread;
  }
  if (control.bulk_viscosity_type < 0) {
    shell.bulk_quadratic = hourglass.bulk_quadratic;
    shell.bulk_linear = hourglass.bulk_linear;
  }
  return shell;
}

kernel::WeldBeamProperties integrated_beam(const model::SectionBeam& section, double density) {
  kernel::WeldBeamProperties beam;
  beam.density = density;
  beam.shear_factor = section.shear_factor;
  beam.mass_per_length = section.extra_mass;
  const double first = 0.5 * (section.outer[0] + section.outer[1]),
               second = 0.5 * (section.inner[0] + section.inner[1]);
  if (section.cross_section == 1) {
    beam.fibres = kernel::disc_fibres(first, second, section.quadrature);
    return beam;
  }
  beam.fibres = kernel::rectangle_fibres(first, second, section.quadrature);
  beam.torsion_share = kernel::rectangle_torsion_share(first, second);
  beam.offset_s = -0.5 * section.location[0] * first;
  beam.offset_t = -0.5 * section.location[1] * second;
  for (std::size_t k = 0; k < static_cast<std::size_t>(beam.fibres.count); ++k) {
    beam.fibres.s[k] += beam.offset_s;
    beam.fibres.t[k] += beam.offset_t;
  }
  return beam;
}

/// A weld beam whose end is tied to deformable shells has nothing there to twist against, unless they have drilling
/// stiffness or the tie turns the twist into in-plane forces.
bool free_to_twist(const model::Model& model, const weld::Weld& w) {
  return std::any_of(w.ends.begin(), w.ends.end(), [&](const weld::Projection& e) {
    const bool drills = e.tie.shell != model::none && model.parts[at(e.tie.part)].drilling > 0.0;
    return e.tied && e.projection_case != 0 && e.tie.rigid_body == model::none && !e.tie.twist && !e.tie.couples &&
           !drills;
  });
}

/// The nodes of a weld's brick, so that zeta runs along the weld: the kernel's uniaxial stress state wants that.
std::array<model::Index, 8> laid_along(const weld::Weld& weld, const std::array<model::Index, 8>& brick,
                                       const std::vector<Vec3d>& x) {
  const Vec3d axis = weld::face_centre(weld, 1, x) - weld::face_centre(weld, 0, x);
  std::array<model::Index, 8> best = brick;
  double most = -1.0;
  for (const auto& [low, up] : weld::opposite_faces(brick)) {
    Vec3d along;
    for (std::size_t a = 0; a < 4; ++a) along += x[at(up[a])] - x[at(low[a])];
    const double cosine = std::abs(dot(along, axis)) / norm(along);
    if (!(cosine > most * (1.0 + 1e-9))) continue;
    most = cosine;
    best = {low[0], low[1], low[2], low[3], up[0], up[1], up[2], up[3]};
  }
  return best;
}

}  // namespace

template <class Elements>
System::Members System::members(const Elements& elements, const std::vector<model::Index>& chosen) const {
  Members m;
  m.element = chosen;
  for (model::Index e : chosen) {
    ElementNodes node{};
    for (std::size_t a = 0; a < elements.node[at(e)].size(); ++a) node[a] = node_of[at(elements.node[at(e)][a])];
    m.node.push_back(node);
  }
  return m;
}

template <class Element>
void System::add_group(Element element, model::ElementKind kind, std::size_t part, const Members& m,
                       std::vector<ElementLocation>& locations) {
  groups.push_back(std::make_unique<BatchGroup<Element>>(std::move(element), kind, static_cast<model::Index>(part),
                                                         m.element, m.node, start_));
  for (std::size_t e = 0; e < m.element.size(); ++e)
    locations[at(m.element[e])] = {static_cast<int>(groups.size()) - 1, static_cast<int>(e)};
}

const model::Hourglass& System::hourglass_of(const model::Part& part) const {
  return part.hourglass == model::none ? model.control.hourglass : model.hourglass[at(part.hourglass)];
}

void System::make_groups(Findings& findings) {
  start_.resize(nodes);
  for (std::size_t i = 0; i < nodes; ++i) start_[i] = ties.x[at(model_node[i])];
  make_shells();
  make_bricks();
  make_weld_beams(findings);
  make_springs();
  for (const auto& group : groups) {
    if (group->weld && group->step_share == 1.0) continue;
    group->step_share = model.control.step_scale;
    if (group->kind == model::ElementKind::discrete) continue;  // they have no mass to scale
    if (group->mass_step == 0.0) group->mass_step = std::abs(model.control.mass_step);
  }
}

template <ShellKind Kind>
void System::add_shells(std::size_t p, const std::vector<model::Index>& chosen) {
  if (chosen.empty()) return;
  const model::Part& part = model.parts[p];
  const model::SectionShell& section = model.shell_sections[at(part.section)];
  const model::Material& material = model.materials[at(part.material)];
  const kernel::ShellProperties shell = shell_properties(part, section, material, hourglass_of(part), model.control);
  const Members m = members(model.shells, chosen);
  constexpr int corners = ShellElement<kernel::Elastic, Kind>::corners;
  const bool computed = with_shell_law(material.law, [&]<class Law>(const Law& law) {
    add_group(ShellElement<Law, Kind>{shell, kernel::LawKernel<Law>(law), model.shells, section.extra_mass},
              model::ElementKind::shell, p, m, shell_location);
  });
  if (computed) return;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    std::array<Vec3d, corners> x;
    for (std::size_t a = 0; a < corners; ++a) x[a] = start_[at(m.node[i][a])];
    const double t = model.shells.thickness[at(chosen[i])];
    kernel::NodalMass own;
    if constexpr (corners == 4)
      own = kernel::shell_nodal_mass(x, t, shell.density, shell.offset, section.extra_mass);
    else
      own = kernel::triangle_nodal_mass(x, t, shell.density, shell.offset, section.extra_mass);
    mass_only_elements_.push_back({static_cast<model::Index>(p), corners, m.node[i], corners * own.mass, own.inertia});
  }
}

void System::make_shells() {
  shell_location.assign(model.shells.size(), {});
  const auto sorted = by_part(model.shells, model.parts.size(), ties.x);
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    if (sorted[p].empty()) continue;
    const model::SectionShell& section = model.shell_sections[at(model.parts[p].section)];
    const int formulation = triangle_formulation(section, model.control);
    std::vector<model::Index> quads, triangles;
    for (model::Index e : sorted[p])
      (formulation != 0 && model.shells.triangle(at(e)) ? triangles : quads).push_back(e);
    if (fully_integrated(section))
      add_shells<ShellKind::full>(p, quads);
    else
      add_shells<ShellKind::one_point>(p, quads);
    if (formulation == 17)
      add_shells<ShellKind::kirchhoff>(p, triangles);
    else
      add_shells<ShellKind::triangle>(p, triangles);
  }
}

std::vector<bool> System::deleted_with_welds(bool bricks) const {
  std::vector<bool> deleted(bricks ? model.solids.size() : model.beams.size(), false);
  for (const weld::Weld& w : ties.welds)
    if (w.deleted && w.kind != weld::Weld::Kind::rigid && w.of_bricks() == bricks)
      for (model::Index e : w.elements) deleted[at(e)] = true;
  return deleted;
}

void System::make_bricks() {
  solid_location.assign(model.solids.size(), {});
  const std::vector<bool> deleted = deleted_with_welds(true);
  auto sorted = by_part(model.solids, model.parts.size(), ties.x);
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    std::erase_if(sorted[p], [&](model::Index e) { return deleted[at(e)]; });
    if (sorted[p].empty()) continue;
    const model::Part& part = model.parts[p];
    const model::Material& material = model.materials[at(part.material)];
    const model::Hourglass& hourglass = hourglass_of(part);
    const auto* compound = std::get_if<kernel::ComposedLaw>(&material.law);
    if (compound != nullptr && compound->components->bond) {
      const Members m = members(model.solids, sorted[p]);
      if (model::is_between_shells(model.solid_sections[at(part.section)].elform))
        add_group(CohesiveBrickElement<true>{material.density, compound->components->bond}, model::ElementKind::solid,
                  p, m, solid_location);
      else
        add_group(CohesiveBrickElement<false>{material.density, compound->components->bond}, model::ElementKind::solid,
                  p, m, solid_location);
      continue;
    }
    const bool viscous = compound == nullptr || compound->components->bulk_viscosity;
    // Without a card: viscous on the patterns orthogonal to linear fields (docs/decisions/0007).
    const kernel::HexahedronProperties brick{material.density, hourglass.type == 0 ? 2 : hourglass.type,
                                             hourglass.membrane, viscous ? hourglass.bulk_quadratic : 0.0,
                                             viscous ? hourglass.bulk_linear : 0.0};
    if (const auto* law = std::get_if<kernel::Spotweld>(&material.law)) {
      add_weld_bricks(p, sorted[p], brick, *law);
      continue;
    }
    const bool computed = with_law(material.law, [&]<class Law>(const Law& law) {
      const BrickElement<Law> element{brick, kernel::LawKernel<Law>(law)};
      const auto [quadratic, tetrahedra, full, others] =
          by_formulation(sorted[p], model.solid_sections[at(part.section)].elform);
      if (!quadratic.empty())
        add_group(QuadraticTetrahedronElement<Law>{{brick, element.law}}, model::ElementKind::solid, p,
                  different_nodes(quadratic), solid_location);
      if (!tetrahedra.empty()) {
        const Members m = different_nodes(tetrahedra);
        const int elform = model.solid_sections[at(part.section)].elform;
        std::shared_ptr<NodalPressure> shared;
        if (!std::is_same_v<Law, kernel::ComposedLaw> && elform == 13)
          shared = std::make_shared<NodalPressure>(first_four(m.node), start_, bulk_modulus(element.law.elastic()));
        if (elform == 4)
          add_group(RotationalTetrahedronElement<Law>{{brick, element.law}}, model::ElementKind::solid, p, m,
                    solid_location);
        else
          add_group(TetrahedronElement<Law>{brick, element.law, shared}, model::ElementKind::solid, p, m,
                    solid_location);
      }
      if (!full.empty())
        add_group(full_brick(element, model.solid_sections[at(part.section)]), model::ElementKind::solid, p,
                  members(model.solids, full), solid_location);
      if (!others.empty())
        add_group(element, model::ElementKind::solid, p, members(model.solids, others), solid_location);
    });
    if (computed) continue;
    const Members m = different_nodes(sorted[p]);
    for (std::size_t i = 0; i < sorted[p].size(); ++i) {
      const double whole = material.density * model::solid_volume(model, at(sorted[p][i]));
      const int count = static_cast<int>(model.solids.different_nodes(at(sorted[p][i])).size());
      mass_only_elements_.push_back({static_cast<model::Index>(p), count, m.node[i], whole, 0.0});
    }
  }
}

System::Members System::different_nodes(const std::vector<model::Index>& solids) const {
  Members m;
  m.element = solids;
  for (const model::Index e : solids) {
    ElementNodes node{};
    const std::vector<model::Index> different = model.solids.different_nodes(at(e));
    for (std::size_t a = 0; a < different.size(); ++a) node[a] = node_of[at(different[a])];
    m.node.push_back(node);
  }
  return m;
}

System::Formulations System::by_formulation(const std::vector<model::Index>& solids, int elform) const {
  const bool sorts = model.control.sort_solids;
  Formulations f;
  for (const model::Index e : solids) {
    const std::size_t corners = model.solids.corners(at(e)).size();
    const bool tetrahedron = corners == 4 && (sorts || elform == 4 || elform == 10 || elform == 13),
               wedge = corners == 6 && sorts;
    const bool full = wedge || elform == 2 || elform == 15 || bends_without_locking(elform);
    (model.solids.quadratic(at(e)) ? f.quadratic : tetrahedron ? f.tetrahedra : full ? f.full : f.others).push_back(e);
  }
  return f;
}

void System::add_weld_bricks(std::size_t p, const std::vector<model::Index>& chosen,
                             const kernel::HexahedronProperties& brick, const kernel::Spotweld& law) {
  std::vector<const weld::Weld*> weld_of(model.solids.size(), nullptr);
  for (const weld::Weld& w : ties.welds)
    if (w.kind != weld::Weld::Kind::rigid && w.of_bricks())
      for (model::Index e : w.elements) weld_of[at(e)] = &w;
  // Connections have yield stresses of their own: a group for each law.
  std::map<std::pair<double, double>, std::pair<kernel::Spotweld, std::vector<model::Index>>> by_law;
  for (model::Index e : chosen) {
    const kernel::Spotweld own = weld_of[at(e)] ? weld::points_of(model, *weld_of[at(e)], law) : law;
    auto& [shared, bricks] = by_law[{own.yield, own.hardening}];
    shared = own;
    bricks.push_back(e);
  }
  for (const auto& [key, entry] : by_law) {
    const auto& [own, bricks] = entry;
    Members m = members(model.solids, bricks);
    for (std::size_t i = 0; i < bricks.size(); ++i) {
      if (weld_of[at(bricks[i])] == nullptr) continue;
      const auto laid = laid_along(*weld_of[at(bricks[i])], model.solids.node[at(bricks[i])], ties.x);
      for (std::size_t a = 0; a < 8; ++a) m.node[i][a] = node_of[at(laid[a])];
    }
    const BrickElement<kernel::Spotweld> element{brick, kernel::LawKernel<kernel::Spotweld>(own)};
    const model::SectionSolid& section = model.solid_sections[at(model.parts[p].section)];
    if (section.elform == 2 || bends_without_locking(section.elform))
      add_group(full_brick(element, section), model::ElementKind::solid, p, m, solid_location);
    else
      add_group(element, model::ElementKind::solid, p, m, solid_location);
    scale_weld_mass(*groups.back(), own);
  }
}

void System::make_weld_beams(Findings& findings) {
  beam_location.assign(model.beams.size(), {});
  const std::vector<bool> deleted = deleted_with_welds(false);
  std::vector<bool> untwistable(model.beams.size(), false);
  for (const weld::Weld& w : ties.welds)
    if (w.kind == weld::Weld::Kind::beam) untwistable[at(w.element)] = free_to_twist(model, w);
  std::size_t untwisted = 0;
  const auto sorted = by_part(model.beams, model.parts.size(), ties.x);
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    if (sorted[p].empty()) continue;
    if (model.beam_sections[at(model.parts[p].section)].elform == 6) {
      std::vector<model::Index> kept;
      for (model::Index e : sorted[p])
        if (!deleted[at(e)]) kept.push_back(e);
      add_discrete_beams(p, kept, findings);
      continue;
    }
    if (!std::holds_alternative<kernel::Spotweld>(model.materials[at(model.parts[p].material)].law)) {
      add_beams(p, sorted[p]);
      continue;
    }
    const bool wants_torsion = model.beam_sections[at(model.parts[p].section)].torsion;
    std::vector<model::Index> with, without;
    for (model::Index e : sorted[p]) {
      if (deleted[at(e)]) continue;
      untwisted += wants_torsion && untwistable[at(e)];
      (wants_torsion && !untwistable[at(e)] ? with : without).push_back(e);
    }
    add_weld_beams(p, with, true);
    add_weld_beams(p, without, false);
  }
  if (untwisted > 0)
    findings.note(
        {model.deck, 0, 0}, "*CONTACT_SPOTWELD",
        fmt::format("no torsion in {} weld beam{}: the shells have no stiffness about their normal to hold it",
                    untwisted, untwisted == 1 ? "" : "s"),
        "*CONTACT_SPOTWELD_WITH_TORSION turns it into in-plane forces");
}

void System::add_beams(std::size_t p, const std::vector<model::Index>& chosen) {
  const model::Part& part = model.parts[p];
  const model::SectionBeam& section = model.beam_sections[at(part.section)];
  const model::Material& material = model.materials[at(part.material)];
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
    if constexpr (!std::is_same_v<Law, kernel::ComposedLaw>) {  // refused by the model
      if (section.elform == 3)
        add_group(TrussElement<Law>{section.area, material.density, section.extra_mass, kernel::LawKernel<Law>(law)},
                  kind, p, m, beam_location);
      else if (section.elform == 1)
        add_group(IntegratedBeamElement<Law>{integrated_beam(section, material.density), kernel::LawKernel<Law>(law),
                                             law.nu, model.beams, ties.x},
                  kind, p, m, beam_location);
    }
  });
  if (computed) return;
  for (const ElementNodes& node : m.node) {
    const double length = norm(start_[at(node[1])] - start_[at(node[0])]);
    const double whole = (material.density * model::beam_area(section) + section.extra_mass) * length;
    mass_only_elements_.push_back({static_cast<model::Index>(p), 2, node, whole, whole * length * length / 24.0});
  }
}

void System::add_discrete_beams(std::size_t p, const std::vector<model::Index>& chosen, Findings& findings) {
  if (chosen.empty()) return;
  const model::Part& part = model.parts[p];
  const model::SectionBeam& section = model.beam_sections[at(part.section)];
  const model::Material& material = model.materials[at(part.material)];
  const auto* law = std::get_if<kernel::DiscreteBeam>(&material.law);
  if (law == nullptr) return;  // refused by the model
  const kernel::DiscreteBeamProperties beam{material.density * section.volume, section.inertia, section.scoor,
                                            law->between_points};
  std::optional<Frame3d> axes;
  if (section.system != model::none) axes = model.systems[at(section.system)].axes;
  for (const model::Index e : chosen) {
    const auto& n = model.beams.node[at(e)];
    const Vec3d line = ties.x[at(n[1])] - ties.x[at(n[0])], side = model.beams.side(at(e), ties.x);
    const bool has_length = norm(line) > 0.0, between_points = beam.between_points && has_length;
    const auto report = [&](Severity severity, const std::string& what, const char* remedy) {
      findings.add({severity,
                    model.beams.place[at(e)],
                    "*ELEMENT_BEAM",
                    {},
                    {},
                    fmt::format("discrete beam {} {}", model.beams.id[at(e)], what),
                    remedy});
    };
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
      discrete_location[at(chosen[i])] = {static_cast<int>(groups.size()), static_cast<int>(i)};
    groups.push_back(std::make_unique<SpringGroup>(model, key.first, chosen, node_of, start_));
  }
}

void System::add_weld_beams(std::size_t p, const std::vector<model::Index>& chosen, bool torsion) {
  if (chosen.empty()) return;
  const model::Part& part = model.parts[p];
  const model::Material& material = model.materials[at(part.material)];
  const auto* law = std::get_if<kernel::Spotweld>(&material.law);
  if (law == nullptr) return;  // refused by the model
  const model::SectionBeam& section = model.beam_sections[at(part.section)];
  kernel::WeldBeamProperties beam;
  beam.density = material.density;
  beam.fibres = kernel::disc_fibres(0.5 * (section.outer[0] + section.outer[1]),
                                    0.5 * (section.inner[0] + section.inner[1]), section.quadrature);
  beam.shear_factor = section.shear_factor;
  beam.no_torsion = !torsion;
  add_group(WeldBeamElement{{beam, kernel::LawKernel<kernel::Spotweld>(*law), law->nu, model.beams, ties.x}},
            model::ElementKind::beam, p, members(model.beams, chosen), beam_location);
  scale_weld_mass(*groups.back(), *law);
}

void System::scale_weld_mass(ElementGroup& group, const kernel::Spotweld& law) const {
  group.weld = true;
  if (law.mass_step > 0.0) {
    group.mass_step = law.mass_step;
    group.added_mass_is_physical = true;
  } else if (model.control.mass_step != 0.0) {
    // S. Bala's talk: with DT = 0 welds are scaled to |DT2MS TSSFAC|, which is the step that will be run with.
    group.mass_step = std::abs(model.control.mass_step) * model.control.step_scale;
    group.step_share = 1.0;
  }
}

}  // namespace nugget::system
