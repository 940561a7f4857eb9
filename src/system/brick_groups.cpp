// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>
#include <tuple>

#include "kernel/law/law_components.hpp"
#include "model/bond.hpp"
#include "system/brick_element.hpp"
#include "system/cohesive_brick_element.hpp"
#include "system/extruded_shell_element.hpp"
#include "system/groups.hpp"
#include "system/quadratic_tetrahedron_element.hpp"
#include "system/rotational_tetrahedron_element.hpp"
#include "system/tetrahedron_element.hpp"
#include "system/thick_shell_element.hpp"
#include "system/wedge_element.hpp"
#include "weld/failure/connection.hpp"
#include "weld/tie/welds.hpp"

// Which kernel runs which bricks.
namespace nugget::system {
namespace {

double bulk_modulus(const kernel::ElasticConstants& e) {
  return e.E / (3.0 * (1.0 - 2.0 * e.nu));
}

std::vector<std::array<int, 4>> first_four(const std::vector<ElementNodes>& nodes) {
  std::vector<std::array<int, 4>> four;
  for (const auto& n : nodes) four.push_back({n[0], n[1], n[2], n[3]});
  return four;
}

bool bends_without_locking(int elform) {
  return elform == -1 || elform == -2 || elform == 3 || elform == 18;
}

/// The nodes of a wedge as kernel::WedgeMotion has them; as they are written, where that is N1 N2 N3 N4 N5 N5 N6 N6.
/// None where no opposite edges of a face are points.
std::optional<std::array<model::Index, 6>> wedge_of(const std::array<model::Index, 8>& n) {
  // Each face opposite to the one that is an edge, and that one, corner above corner.
  constexpr int faces[6][2][4] = {{{0, 1, 2, 3}, {4, 5, 6, 7}}, {{4, 7, 6, 5}, {0, 3, 2, 1}},
                                  {{0, 3, 7, 4}, {1, 2, 6, 5}}, {{1, 5, 6, 2}, {0, 4, 7, 3}},
                                  {{0, 4, 5, 1}, {3, 7, 6, 2}}, {{3, 2, 6, 7}, {0, 1, 5, 4}}};
  for (const auto& face : faces)
    for (int first = 0; first < 2; ++first) {
      const auto at_low = [&](int i) { return n[face[0][(first + i) % 4]]; };
      const auto at_up = [&](int i) { return n[face[1][(first + i) % 4]]; };
      if (at_up(0) == at_up(1) && at_up(2) == at_up(3))
        return std::array<model::Index, 6>{at_low(0), at_low(1), at_low(2), at_low(3), at_up(0), at_up(2)};
    }
  return std::nullopt;
}

/// Whether the numbering of a solid's nodes says where the material's axes lie.
template <class Law>
bool has_axes_by_nodes(const kernel::LawKernel<Law>& law) {
  const kernel::MaterialAxes* axes = material_axes(law);
  return axes != nullptr && axes->by != kernel::MaterialAxes::By::vectors;
}

template <class Law>
FullBrickElement<Law> full_brick(const BrickElement<Law>& of, const model::SectionSolid& section) {
  using Strains = kernel::BrickStrains;
  return {of, section.elform == 18                    ? Strains::enhanced
              : bends_without_locking(section.elform) ? Strains::assumed
                                                      : Strains::shape_functions};
}

/// `brick`: of the section's part. Without hourglass control of type 6 it has the whole elastic stabilisation.
kernel::ThickShellProperties thick_shell(kernel::HexahedronProperties brick, const model::Hourglass& hourglass,
                                         const model::SectionSolid& section, const model::Control& control) {
  const model::SectionSolid::Thickness& through = *section.thickness;
  brick.hourglass = 6;
  if (hourglass.type != 6) brick.hourglass_coefficient = 1.0;
  kernel::ThickShellProperties shell{brick, layer_rule(through, control), {}, section.elform == 3};
  shell.shear = kernel::shear_by_layer(shell.layers, through.parabolic_shear,
                                       through.parabolic_shear ? 5.0 / 6.0 : through.shear_factor);
  return shell;
}

/// `brick`: of the section's part. Hourglass control is that of shells of ELFORM 2, as are its defaults.
kernel::ExtrudedShellProperties extruded_shell(const kernel::HexahedronProperties& brick,
                                               const model::Hourglass& hourglass, const model::SectionSolid& section,
                                               const model::Control& control) {
  kernel::ExtrudedShellProperties extruded;
  extruded.full = section.elform == 2;
  extruded.bulk_quadratic = brick.bulk_quadratic;
  extruded.bulk_linear = brick.bulk_linear;
  kernel::ShellProperties& shell = extruded.shell;
  shell.density = brick.density;
  shell.layers = layer_rule(*section.thickness, control);
  shell.shear_factor = section.thickness->shear_factor;
  shell.hourglass = hourglass.type == 0 || hourglass.type > 5 ? 1 : hourglass.type;
  shell.membrane_hourglass = hourglass.membrane;
  shell.bending_hourglass = hourglass.bending;
  shell.warping_hourglass = hourglass.warping;
  shell.warping_stiffness = extruded.full;
  return extruded;
}

/// The nodes of a weld's brick, so that zeta runs along the weld: the kernel's uniaxial stress state wants that.
std::array<model::Index, 8> laid_along(const weld::Weld& weld, const std::array<model::Index, 8>& brick,
                                       const std::vector<Vec3d>& x) {
  const Vec3d axis = weld::face_centre(weld, 1, x) - weld::face_centre(weld, 0, x);
  std::array<model::Index, 8> best = brick;
  double most = -1.0;
  for (const auto& [low, up] : weld::opposite_faces(brick)) {
    Vec3d along;
    for (std::size_t a = 0; a < 4; ++a) along += x[up[a]] - x[low[a]];
    const double cosine = std::abs(dot(along, axis)) / norm(along);
    if (!(cosine > most * (1.0 + 1e-9))) continue;
    most = cosine;
    best = {low[0], low[1], low[2], low[3], up[0], up[1], up[2], up[3]};
  }
  return best;
}

}  // namespace

kernel::LayerRule layer_rule(const model::SectionSolid::Thickness& through, const model::Control& control) {
  if (through.trapezoidal) return kernel::equally_spaced_layers(through.layers);
  return control.lobatto ? kernel::lobatto_layers(through.layers) : kernel::gauss_layers(through.layers);
}

void System::make_bricks() {
  solid_location.assign(model.solids.size(), {});
  const std::vector<bool> deleted = deleted_with_welds(true);
  auto sorted = by_part(model.solids, model.parts.size(), ties.x);
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    std::erase_if(sorted[p], [&](model::Index e) { return deleted[e]; });
    if (sorted[p].empty()) continue;
    const model::Part& part = model.parts[p];
    const model::Material& material = model.materials[part.material];
    const model::Hourglass& hourglass = hourglass_of(part);
    const auto* compound = std::get_if<kernel::ComposedLaw>(&material.law);
    if (compound != nullptr && compound->components->bond) {
      const Members m = members(model.solids, sorted[p]);
      if (model::is_between_shells(model.solid_sections[part.section].elform))
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
      const model::SectionSolid& section = model.solid_sections[part.section];
      if (section.has_laws_of_shells())
        return add_group(ExtrudedShellElement<Law>{extruded_shell(brick, hourglass, section, model.control),
                                                   kernel::LawKernel<Law>(law)},
                         model::ElementKind::solid, p, members(model.solids, sorted[p]), solid_location);
      if (section.thickness)
        return add_group(
            ThickShellElement<Law>{thick_shell(brick, hourglass, section, model.control), kernel::LawKernel<Law>(law)},
            model::ElementKind::solid, p, members(model.solids, sorted[p]), solid_location);
      const BrickElement<Law> element{brick, kernel::LawKernel<Law>(law)};
      const auto [quadratic, tetrahedra, full, others] =
          by_formulation(sorted[p], model.solid_sections[part.section].elform);
      if (!quadratic.empty())
        add_group(QuadraticTetrahedronElement<Law>{{brick, element.law}}, model::ElementKind::solid, p,
                  different_nodes(quadratic), solid_location);
      if (!tetrahedra.empty()) {
        const Members m = different_nodes(tetrahedra);
        const int elform = model.solid_sections[part.section].elform;
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
      Members wedges;
      std::vector<model::Index> bricks;
      for (const model::Index e : full) {
        const std::array<model::Index, 8>& n = model.solids.node[e];
        const bool wedge = model.solids.corners(at(e)).size() == 6 &&
                           (model.control.sort_solids || model.solid_sections[part.section].elform == 15);
        const auto six = wedge ? wedge_of(n) : std::nullopt;
        const bool as_written = six && kernel::brick_of_wedge(six->data()) == n;
        if (!six || (!as_written && has_axes_by_nodes(element.law))) {
          bricks.push_back(e);
          continue;
        }
        ElementNodes node{};
        for (std::size_t a = 0; a < 6; ++a) node[a] = node_of[(*six)[a]];
        wedges.element.push_back(e);
        wedges.node.push_back(node);
      }
      if (!wedges.element.empty())
        add_group(WedgeElement<Law>{{element, kernel::BrickStrains::wedge}}, model::ElementKind::solid, p, wedges,
                  solid_location);
      if (!bricks.empty())
        add_group(full_brick(element, model.solid_sections[part.section]), model::ElementKind::solid, p,
                  members(model.solids, bricks), solid_location);
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
    for (std::size_t a = 0; a < different.size(); ++a) node[a] = node_of[different[a]];
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
      for (model::Index e : w.elements) weld_of[e] = &w;
  // Connections have yield stresses of their own: a group for each law.
  std::map<std::tuple<double, double, bool>, std::pair<kernel::Spotweld, std::vector<model::Index>>> by_law;
  for (model::Index e : chosen) {
    const kernel::Spotweld own = weld_of[e] ? weld::points_of(model, *weld_of[e], law) : law;
    const bool free = weld_of[e] && !weld::scaled_to_the_step_of_the_run(model, *weld_of[e]);
    auto& [shared, bricks] = by_law[{own.yield, own.hardening, free}];
    shared = own;
    bricks.push_back(e);
  }
  for (const auto& [key, entry] : by_law) {
    const auto& [own, bricks] = entry;
    Members m = members(model.solids, bricks);
    for (std::size_t i = 0; i < bricks.size(); ++i) {
      if (weld_of[bricks[i]] == nullptr) continue;
      const auto laid = laid_along(*weld_of[bricks[i]], model.solids.node[bricks[i]], ties.x);
      for (std::size_t a = 0; a < 8; ++a) m.node[i][a] = node_of[laid[a]];
    }
    const std::size_t first = groups.size();
    const BrickElement<kernel::Spotweld> element{brick, kernel::LawKernel<kernel::Spotweld>(own)};
    const model::SectionSolid& section = model.solid_sections[model.parts[p].section];
    if (section.elform == 2 || bends_without_locking(section.elform))
      add_group(full_brick(element, section), model::ElementKind::solid, p, m, solid_location);
    else
      add_group(element, model::ElementKind::solid, p, m, solid_location);
    for (std::size_t g = first; g < groups.size(); ++g) scale_weld_mass(*groups[g], own, !std::get<2>(key));
  }
}

}  // namespace nugget::system
