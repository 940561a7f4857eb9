// SPDX-License-Identifier: Apache-2.0
#include <functional>
#include <map>
#include <variant>

#include "kernel/law/laminate_kernel.hpp"
#include "system/groups.hpp"
#include "system/shell_elements.hpp"
#include "weld/failure/heat_zones.hpp"

// Which kernel runs which shells.
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
  if (section.trapezoidal) return kernel::equally_spaced_layers(section.layers);
  return control.lobatto ? kernel::lobatto_layers(section.layers) : kernel::gauss_layers(section.layers);
}

kernel::LayerRule layer_rule(const model::Model& model, model::Index part) {
  return layer_rule(model.shell_sections[model.parts[part].section], model.control);
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

/// The same of shells, which may have layers, but for membranes.
template <ShellKind Kind, class With>
bool with_shell_law(const model::Law& law, const With& with) {
  if constexpr (!is_membrane(Kind))
    if (const auto* laminate = std::get_if<kernel::Laminate>(&law)) {
      with(*laminate);
      return true;
    }
  return with_law(law, with);
}

bool fully_integrated(const model::SectionShell& section) {
  return section.elform == 16;
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
  shell.rates_at_end = !control.second_order_stress;
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

}  // namespace

template <ShellKind Kind>
void System::add_shells(std::size_t p, const std::vector<model::Index>& chosen,
                        const std::vector<weld::Softening>& softening) {
  if (softening.empty()) return add_shells<Kind>(p, chosen, weld::Softening{});
  std::map<weld::Softening, std::vector<model::Index>, std::greater<>> alike;  // the sound ones first
  for (const model::Index e : chosen) alike[softening[e]].push_back(e);
  for (const auto& [factors, shells] : alike) add_shells<Kind>(p, shells, factors);
}

template <ShellKind Kind>
void System::add_shells(std::size_t p, const std::vector<model::Index>& chosen, const weld::Softening& softening) {
  if (chosen.empty()) return;
  const model::Part& part = model.parts[p];
  const model::SectionShell& section = model.shell_sections[part.section];
  const model::Material& material = model.materials[part.material];
  const kernel::ShellProperties shell = shell_properties(part, section, material, hourglass_of(part), model.control);
  const Members m = members(model.shells, chosen);
  constexpr int corners = ShellElement<kernel::Elastic, Kind>::corners;
  const model::Law shell_law = softening == weld::Softening{} ? material.law : weld::softened(material.law, softening);
  const bool computed = with_shell_law<Kind>(shell_law, [&]<class Law>(const Law& law) {
    add_group(ShellElement<Law, Kind>{shell, kernel::LawKernel<Law>(law), model.shells, section.extra_mass},
              model::ElementKind::shell, p, m, shell_location);
  });
  if (computed) return;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    std::array<Vec3d, corners> x;
    for (std::size_t a = 0; a < corners; ++a) x[a] = start_[m.node[i][a]];
    const double t = model.shells.thickness[chosen[i]];
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
  const std::vector<weld::Softening> softening = weld::softening(model, ties);
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    if (sorted[p].empty()) continue;
    const model::SectionShell& section = model.shell_sections[model.parts[p].section];
    const int formulation = triangle_formulation(section, model.control);
    std::vector<model::Index> quads, triangles;
    for (model::Index e : sorted[p])
      ((formulation != 0 || model::is_membrane(section.elform)) && model.shells.triangle(at(e)) ? triangles : quads)
          .push_back(e);
    if (model::is_membrane(section.elform)) {
      if (section.elform == 5)
        add_shells<ShellKind::membrane>(p, quads, softening);
      else
        add_shells<ShellKind::full_membrane>(p, quads, softening);
      add_shells<ShellKind::membrane_triangle>(p, triangles, softening);
      continue;
    }
    if (fully_integrated(section))
      add_shells<ShellKind::full>(p, quads, softening);
    else
      add_shells<ShellKind::one_point>(p, quads, softening);
    if (formulation == 17)
      add_shells<ShellKind::kirchhoff>(p, triangles, softening);
    else
      add_shells<ShellKind::triangle>(p, triangles, softening);
  }
}

}  // namespace nugget::system
