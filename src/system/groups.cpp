// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "base/index.hpp"
#include "system/batch_group.hpp"
#include "system/brick_element.hpp"
#include "system/order.hpp"
#include "system/shell_elements.hpp"
#include "system/system.hpp"
#include "system/weld_beam_element.hpp"

// Which kernel runs which element: one group a part and formulation.
namespace nugget::system {
namespace {

template <class Element>
std::unique_ptr<ElementGroup> group_of(Element kernel, model::ElementKind kind, model::Index part,
                                       std::vector<model::Index> elements,
                                       const std::vector<std::array<int, 8>>& connectivity,
                                       const std::vector<Vec3d>& x) {
  return std::make_unique<BatchGroup<Element>>(kernel, kind, part, std::move(elements), connectivity, x);
}

/// Elements of a part, neighbours close together.
struct Members {
  std::vector<model::Index> element;
  std::vector<std::array<int, 8>> node;
};

kernel::ThicknessUpdate thickness_update(int istupd) {
  return istupd == 0   ? kernel::ThicknessUpdate::none
         : istupd == 4 ? kernel::ThicknessUpdate::plastic
                       : kernel::ThicknessUpdate::all;
}

kernel::LayerRule layers(const model::SectionShell& section, const model::Control& control) {
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

}  // namespace

std::array<double, 6> global_stress(const Frame3d& f, double xx, double yy, double xy, double xz, double yz) {
  // sigma = sum_ij s_ij e_i e_j, with s_zz = 0.
  const Vec3d a = xx * f.e1 + xy * f.e2 + xz * f.e3, b = xy * f.e1 + yy * f.e2 + yz * f.e3, c = xz * f.e1 + yz * f.e2;
  const auto component = [&](double Vec3d::*i, double Vec3d::*j) {
    return a.*i * f.e1.*j + b.*i * f.e2.*j + c.*i * f.e3.*j;
  };
  return {component(&Vec3d::x, &Vec3d::x), component(&Vec3d::y, &Vec3d::y), component(&Vec3d::z, &Vec3d::z),
          component(&Vec3d::x, &Vec3d::y), component(&Vec3d::y, &Vec3d::z), component(&Vec3d::z, &Vec3d::x)};
}

void System::make_groups(Findings& findings) {
  (void)findings;
  shell_seat.assign(model.shells.size(), {});
  solid_seat.assign(model.solids.size(), {});
  beam_seat.assign(model.beams.size(), {});
  std::vector<Vec3d> x(nodes);
  for (std::size_t i = 0; i < nodes; ++i) x[i] = ties.x[at(model_node[i])];
  const model::Control& control = model.control;

  // Elements of each part along a Morton curve.
  const auto sorted = [&](std::size_t count, auto&& part_of, auto&& nodes_of) {
    std::vector<Vec3d> centre(count);
    for (std::size_t e = 0; e < count; ++e) {
      const auto& n = nodes_of(e);
      for (model::Index k : n) centre[e] += (1.0 / static_cast<double>(n.size())) * ties.x[at(k)];
    }
    std::vector<std::vector<model::Index>> by_part(model.parts.size());
    for (int e : morton_order(centre)) by_part[at(part_of(at(e)))].push_back(e);
    return by_part;
  };
  const auto members = [&](const std::vector<model::Index>& elements, auto&& nodes_of) {
    Members m;
    m.element = elements;
    for (model::Index e : elements) {
      std::array<int, 8> node{};
      const auto& own = nodes_of(at(e));
      for (std::size_t a = 0; a < own.size(); ++a) node[a] = node_of[at(own[a])];
      m.node.push_back(node);
    }
    return m;
  };
  const auto seat = [&](std::vector<Seat>& seats) {
    const ElementGroup& g = *groups.back();
    for (std::size_t e = 0; e < g.size(); ++e)
      seats[at(g.element[e])] = {static_cast<int>(groups.size()) - 1, static_cast<int>(e)};
  };
  const auto hourglass_of = [&](const model::Part& part) -> const model::Hourglass& {
    return part.hourglass == model::none ? control.hourglass : model.hourglass[at(part.hourglass)];
  };

  // Shells.
  const auto shell_nodes = [&](std::size_t e) -> const std::array<model::Index, 4>& { return model.shells.node[e]; };
  const auto shells = sorted(
      model.shells.size(), [&](std::size_t e) { return model.shells.part[e]; }, shell_nodes);
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    if (shells[p].empty()) continue;
    const model::Part& part = model.parts[p];
    const model::SectionShell& section = model.shell_sections[at(part.section)];
    const model::Material& material = model.materials[at(part.material)];
    const model::Hourglass& hourglass = hourglass_of(part);
    kernel::ShellProperties shell;
    shell.density = material.density;
    shell.layers = layers(section, control);
    shell.shear_factor = section.shear_factor;
    shell.offset = section.nloc;
    shell.hourglass = hourglass.type == 0 ? 1 : hourglass.type;
    shell.membrane_hourglass = hourglass.membrane;
    shell.bending_hourglass = hourglass.bending;
    shell.warping_hourglass = hourglass.warping;
    shell.thickness_update = thickness_update(control.thickness_update);
    shell.warping_stiffness = control.warping_stiffness;
    shell.length = control.length_basis == 2   ? kernel::ShellLength::bar
                   : control.length_basis == 1 ? kernel::ShellLength::area_over_diagonal
                                               : kernel::ShellLength::area_over_side;
    if (control.bulk_viscosity_type < 0) {
      shell.bulk_quadratic = hourglass.bulk_quadratic;
      shell.bulk_linear = hourglass.bulk_linear;
    }
    std::vector<model::Index> quads, triangles;
    const bool all_triangles = section.elform == 4;
    for (model::Index e : shells[p])
      (model.shells.triangle(at(e)) && (all_triangles || control.sort_triangles) ? triangles : quads).push_back(e);

    const auto add = [&]<int Corners>(const std::vector<model::Index>& elements, std::integral_constant<int, Corners>) {
      if (elements.empty()) return;
      const Members m = members(elements, shell_nodes);
      const auto with = [&]<class Law>(const Law& law) {
        groups.push_back(
            group_of(ShellElement<Law, Corners>{shell, kernel::Prepared<Law>(law), model.shells, section.extra_mass},
                     model::ElementKind::shell, static_cast<model::Index>(p), m.element, m.node, x));
        seat(shell_seat);
      };
      if (const auto* elastic = std::get_if<kernel::Elastic>(&material.law))
        with(*elastic);
      else if (const auto* kinematic = std::get_if<kernel::PlasticKinematic>(&material.law))
        with(*kinematic);
      else if (const auto* piecewise = std::get_if<kernel::PiecewiseLinear>(&material.law))
        with(*piecewise);
      else
        for (std::size_t i = 0; i < elements.size(); ++i) {
          std::array<Vec3d, 4> place;
          for (std::size_t a = 0; a < 4; ++a) place[a] = x[at(m.node[i][a])];
          const double t = model.shells.thickness[at(elements[i])];
          const kernel::NodalMass own =
              Corners == 4 ? kernel::shell_nodal_mass(place, t, shell.density, shell.offset, section.extra_mass)
                           : kernel::triangle_nodal_mass({place[0], place[1], place[2]}, t, shell.density, shell.offset,
                                                         section.extra_mass);
          lumps_.push_back({static_cast<model::Index>(p), Corners, m.node[i], Corners * own.mass, own.inertia});
        }
    };
    add(quads, std::integral_constant<int, 4>{});
    add(triangles, std::integral_constant<int, 3>{});
  }

  // Bricks.
  const auto solid_nodes = [&](std::size_t e) -> const std::array<model::Index, 8>& { return model.solids.node[e]; };
  const auto solids = sorted(
      model.solids.size(), [&](std::size_t e) { return model.solids.part[e]; }, solid_nodes);
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    if (solids[p].empty()) continue;
    const model::Part& part = model.parts[p];
    const model::Material& material = model.materials[at(part.material)];
    const Members m = members(solids[p], solid_nodes);
    const model::Hourglass& hourglass = hourglass_of(part);
    // Without a card: viscous on the patterns orthogonal to linear fields; it is what fits LS-DYNA's single_hex run
    // best.
    const kernel::HexahedronProperties brick{material.density, hourglass.type == 0 ? 2 : hourglass.type,
                                             hourglass.membrane, hourglass.bulk_quadratic, hourglass.bulk_linear};
    const auto with = [&]<class Law>(const Law& law) {
      groups.push_back(group_of(BrickElement<Law>{brick, kernel::Prepared<Law>(law)}, model::ElementKind::solid,
                                static_cast<model::Index>(p), m.element, m.node, x));
      seat(solid_seat);
    };
    if (const auto* elastic = std::get_if<kernel::Elastic>(&material.law))
      with(*elastic);
    else if (const auto* kinematic = std::get_if<kernel::PlasticKinematic>(&material.law))
      with(*kinematic);
    else if (const auto* piecewise = std::get_if<kernel::PiecewiseLinear>(&material.law))
      with(*piecewise);
    else
      for (std::size_t i = 0; i < m.element.size(); ++i) {
        std::array<Vec3d, 8> place;
        for (std::size_t a = 0; a < 8; ++a) place[a] = x[at(m.node[i][a])];
        lumps_.push_back({static_cast<model::Index>(p), 8, m.node[i],
                          8.0 * kernel::hexahedron_nodal_mass(place, material.density), 0.0});
      }
  }

  // Weld beams. A beam that SPOTSTP = 2 took out has no mass and no group.
  std::vector<bool> deleted(model.beams.size(), false);
  std::vector<bool> tied(model.beams.size(), false);
  for (const weld::Weld& w : ties.welds) {
    if (w.kind != weld::Weld::Kind::beam) continue;
    deleted[at(w.element)] = w.deleted;
    tied[at(w.element)] =
        std::any_of(w.ends.begin(), w.ends.end(), [](const weld::Projection& e) { return e.tied && e.kase != 0; });
  }
  const auto beam_nodes = [&](std::size_t e) -> const std::array<model::Index, 2>& { return model.beams.node[e]; };
  const auto beams = sorted(
      model.beams.size(), [&](std::size_t e) { return model.beams.part[e]; }, beam_nodes);
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    if (beams[p].empty()) continue;
    const model::Part& part = model.parts[p];
    const model::Material& material = model.materials[at(part.material)];
    const auto* law = std::get_if<kernel::Spotweld>(&material.law);
    if (law == nullptr) continue;  // refused by the model
    const model::SectionBeam& section = model.beam_sections[at(part.section)];
    const auto add = [&](bool torsion) {
      std::vector<model::Index> elements;
      for (model::Index e : beams[p])
        if (!deleted[at(e)] && (section.torsion && !tied[at(e)]) == torsion) elements.push_back(e);
      if (elements.empty()) return;
      const Members m = members(elements, beam_nodes);
      kernel::WeldBeamProperties beam;
      beam.density = material.density;
      beam.fibres = kernel::disc_fibres(0.5 * (section.outer[0] + section.outer[1]),
                                        0.5 * (section.inner[0] + section.inner[1]), section.quadrature);
      beam.shear_factor = section.shear_factor;
      beam.no_torsion = !torsion;
      groups.push_back(
          group_of(WeldBeamElement{beam, kernel::Prepared<kernel::Spotweld>(*law), law->nu, model.beams, ties.x},
                   model::ElementKind::beam, static_cast<model::Index>(p), m.element, m.node, x));
      seat(beam_seat);
      ElementGroup& group = *groups.back();
      if (law->mass_step > 0.0) {
        group.mass_step = law->mass_step;
        group.added_mass_is_physical = true;
      } else if (control.mass_step != 0.0) {
        // S. Bala's talk: with DT = 0 welds are scaled to |DT2MS TSSFAC|, which is the step that will be run with.
        group.mass_step = std::abs(control.mass_step) * control.step_scale;
        group.step_share = 1.0;
      }
    };
    add(true);
    add(false);
  }

  for (const auto& group : groups) {
    if (group->kind == model::ElementKind::beam && group->step_share == 1.0) continue;
    group->step_share = control.step_scale;
    if (group->mass_step == 0.0) group->mass_step = std::abs(control.mass_step);
  }
}

}  // namespace nugget::system
