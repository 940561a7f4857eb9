// SPDX-License-Identifier: Apache-2.0
#include "output/element_stresses.hpp"

#include <algorithm>
#include <numeric>

#include "base/index.hpp"
#include "base/parallel.hpp"

namespace nugget::output {
namespace {

using ElementLocation = system::System::ElementLocation;

/// Share of the transverse shear stress of a shell's kernel that carries its shear force; 1 of other elements, and of
/// layers of several materials, which have a shear of their own.
double shear_share(const model::Model& model, const system::ElementGroup& group) {
  const model::Part& part = model.parts[group.part];
  if (part.kind != model::ElementKind::shell || part.section == model::none || part.material == model::none) return 1.0;
  if (std::holds_alternative<kernel::Laminate>(model.materials[part.material].law)) return 1.0;
  return model.shell_sections[part.section].shear_factor;
}

/// Mx My Mxy Qx Qy Nx Ny Nxy along axes that lie by an angle, given by cosine and sine, from their own.
std::array<double, 8> turned(const std::array<double, 8>& r, double c, double s) {
  std::array<double, 8> t{};
  for (const std::size_t first : {std::size_t{0}, std::size_t{5}}) {
    const double x = r[first], y = r[first + 1], xy = r[first + 2];
    t[first] = c * c * x + s * s * y + 2.0 * c * s * xy;
    t[first + 1] = s * s * x + c * c * y - 2.0 * c * s * xy;
    t[first + 2] = c * s * (y - x) + (c * c - s * s) * xy;
  }
  t[3] = c * r[3] + s * r[4];
  t[4] = c * r[4] - s * r[3];
  return t;
}

/// The tensor with its shear along the planes across `n` scaled.
std::array<double, 6> shear_scaled(std::array<double, 6> s, const Vec3d& n, double factor) {
  const Vec3d traction{s[0] * n.x + s[3] * n.y + s[5] * n.z, s[3] * n.x + s[1] * n.y + s[4] * n.z,
                       s[5] * n.x + s[4] * n.y + s[2] * n.z};
  const Vec3d t = (factor - 1.0) * (traction - dot(traction, n) * n);
  s[0] += 2.0 * n.x * t.x;
  s[1] += 2.0 * n.y * t.y;
  s[2] += 2.0 * n.z * t.z;
  s[3] += n.x * t.y + n.y * t.x;
  s[4] += n.y * t.z + n.z * t.y;
  s[5] += n.z * t.x + n.x * t.z;
  return s;
}

/// See shell_axes. `own`: those of the element's kernel.
std::optional<Frame3d> shown_axes(const system::System& system, const system::ElementGroup& group, std::size_t e,
                                  const system::State& state, const std::optional<Frame3d>& own) {
  if (!own || system.model.control.invariant_shell_axes) return own;
  const auto nodes = group.nodes(e);
  const Vec3d side = vec(state.x[nodes[1]]) - vec(state.x[nodes[0]]);
  const Vec3d in_plane = side - dot(side, own->e3) * own->e3;
  if (!(norm(in_plane) > 0.0)) return own;
  const Vec3d x = unit(in_plane);
  return Frame3d{x, cross(own->e3, x), own->e3};
}

StressRecord record(const model::Model& model, const system::ElementGroup& group, std::size_t e, int layer,
                    const system::State& state, const system::ElementGroup::Layer& shown) {
  return {by_cmpflg(model, group, e, layer, state, shown.stress), shown.plastic_strain, shown.damage};
}

}  // namespace

std::array<double, 6> along(const Frame3d& axes, const std::array<double, 6>& t) {
  const auto times = [&](const Vec3d& a) {
    return Vec3d{t[0] * a.x + t[3] * a.y + t[5] * a.z, t[3] * a.x + t[1] * a.y + t[4] * a.z,
                 t[5] * a.x + t[4] * a.y + t[2] * a.z};
  };
  const Vec3d x = times(axes.e1), y = times(axes.e2), z = times(axes.e3);
  return {dot(axes.e1, x), dot(axes.e2, y), dot(axes.e3, z), dot(axes.e1, y), dot(axes.e2, z), dot(axes.e3, x)};
}

system::ElementGroup::Layer shown_layer(const system::System& system, const system::ElementGroup& group, std::size_t e,
                                        int layer, const system::State& state) {
  system::ElementGroup::Layer shown = group.layer(e, layer, state);
  const double share = shear_share(system.model, group);
  if (const auto axes = share == 1.0 ? std::nullopt : group.axes(e, state))
    shown.stress = shear_scaled(shown.stress, axes->e3, share);
  return shown;
}

std::array<double, 6> stress_of_kernel(const system::System& system, const system::ElementGroup& group, std::size_t e,
                                       const system::State& state, const std::array<double, 6>& shown) {
  const double share = shear_share(system.model, group);
  const auto axes = share == 1.0 ? std::nullopt : group.axes(e, state);
  return axes ? shear_scaled(shown, axes->e3, 1.0 / share) : shown;
}

std::optional<Frame3d> shell_axes(const system::System& system, const system::ElementGroup& group, std::size_t e,
                                  const system::State& state) {
  return shown_axes(system, group, e, state, group.axes(e, state));
}

std::optional<Frame3d> axes_in_elout(const system::System& system, const system::ElementGroup& group, std::size_t e,
                                     int layer, const system::State& state) {
  using enum model::Requests::ShellAxes;
  const model::Requests& ask = system.model.requests;
  if (ask.shell_axes == global) return {};
  if (ask.shell_axes == standard && ask.material_axes)
    if (const auto axes = group.material_axes(e, layer, state)) return axes;
  return shell_axes(system, group, e, state);
}

std::vector<int> layers_in_elout(const model::Model& model, const system::ElementGroup& group) {
  std::vector<int> order(at(group.layers()));
  std::iota(order.begin(), order.end(), 0);
  const model::Part& part = model.parts[group.part];
  if (order.size() % 2 == 0 || part.section == model::none) return order;
  const model::SectionShell& section = model.shell_sections[part.section];
  const bool is_gauss = !section.trapezoidal && section.rule.empty() &&
                        !std::holds_alternative<kernel::Laminate>(model.materials[part.material].law);
  const auto middle = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
  if (is_gauss) std::rotate(order.begin(), middle, middle + 1);
  return order;
}

std::array<double, 6> by_cmpflg(const model::Model& model, const system::ElementGroup& group, std::size_t e, int layer,
                                const system::State& state, const std::array<double, 6>& tensor) {
  if (!model.requests.material_axes) return tensor;
  const auto axes = group.material_axes(e, layer, state);
  return axes ? along(*axes, tensor) : tensor;
}

StressRecord solid_stress(const system::System& system, const system::State& state, const ElementLocation& location) {
  if (location.group < 0) return {};
  const system::ElementGroup& group = *system.groups[location.group];
  const std::size_t e = at(location.element);
  return record(system.model, group, e, 0, state, group.layer(e, 0, state));
}

BeamRecord beam_forces(const system::System& system, const system::State& state, const ElementLocation& location,
                       std::span<BeamPointRecord> points) {
  std::fill(points.begin(), points.end(), BeamPointRecord{});
  if (location.group < 0) return {};
  const system::ElementGroup& group = *system.groups[location.group];
  const std::size_t e = at(location.element);
  for (std::size_t k = 0; k < std::min(points.size(), at(group.layers())); ++k) {
    const auto layer = static_cast<int>(k);
    const StressRecord p = record(system.model, group, e, layer, state, group.layer(e, layer, state));
    points[k] = {p.stress[3], p.stress[5], p.stress[0], p.plastic_strain, 0.0};
  }
  const std::array<double, 8> r = group.resultants(e);
  return {r[0], r[1], r[2], r[4], r[5], r[3]};
}

ShellRecord shell_forces(const system::System& system, const system::State& state, const ElementLocation& location,
                         std::span<StressRecord> layers) {
  if (location.group < 0) {
    std::fill(layers.begin(), layers.end(), StressRecord{});
    return {};
  }
  const system::ElementGroup& group = *system.groups[location.group];
  const std::size_t e = at(location.element);
  thread_local std::vector<system::ElementGroup::Layer> through;
  thread_local std::vector<StressRecord> points;
  through.resize(at(group.layers()));
  points.resize(through.size());
  const auto own = group.axes(e, state), axes = shown_axes(system, group, e, state, own);
  group.through(e, state, own, through);
  const double share = shear_share(system.model, group);
  for (std::size_t k = 0; k < through.size(); ++k) {
    if (share != 1.0 && own) through[k].stress = shear_scaled(through[k].stress, own->e3, share);
    points[k] = record(system.model, group, e, static_cast<int>(k), state, through[k]);
  }
  shell_layers(points, layers);

  std::array<double, 8> r = group.resultants(e);
  if (own && axes) r = turned(r, dot(axes->e1, own->e1), dot(axes->e1, own->e2));
  ShellRecord shell;
  // LS-DYNA's are the integrals of -z times the stress (Theory Manual, Belytschko-Lin-Tsay shell).
  shell.mx = -r[0], shell.my = -r[1], shell.mxy = -r[2];
  shell.qx = r[3], shell.qy = r[4];
  shell.nx = r[5], shell.ny = r[6], shell.nxy = r[7];
  return shell;
}

void thick_shell_stresses(const system::System& system, const system::State& state, const ElementLocation& location,
                          std::span<StressRecord> layers) {
  std::fill(layers.begin(), layers.end(), StressRecord{});
  if (location.group < 0) return;
  const system::ElementGroup& group = *system.groups[location.group];
  const std::size_t e = at(location.element);
  thread_local std::vector<StressRecord> points;
  points.resize(at(group.layers()));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto layer = static_cast<int>(k);
    points[k] = record(system.model, group, e, layer, state, group.layer(e, layer, state));
  }
  shell_layers(points, layers);
}

void fill_stresses(const system::System& system, const system::State& state, D3plotState& s) {
  const auto each = [](std::size_t count, const auto& fill) {
    parallel_for(count, 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e) fill(e);
    });
  };
  const model::Model& model = system.model;
  s.solids.resize(model.solids.size());
  const auto points = at(model.requests.beam_points), layers = at(model.requests.layers);
  each(s.solids.size(), [&](std::size_t e) {
    static_cast<StressRecord&>(s.solids[e]) = solid_stress(system, state, system.solid_location[e]);
  });
  std::vector<std::size_t> thick;
  for (std::size_t e = 0; e < s.solids.size(); ++e)
    if (model.has_thick_shells(model.solids.part[e])) thick.push_back(e);
  s.thick_shells.resize(thick.size());
  s.thick_layers.resize(thick.size() * layers);
  each(thick.size(), [&](std::size_t i) {
    const auto own = std::span(s.thick_layers).subspan(i * layers, layers);
    thick_shell_stresses(system, state, system.solid_location[thick[i]], own);
    static_cast<StressRecord&>(s.solids[thick[i]]) = own.front();
  });
  s.beams.resize(model.beams.size());
  s.beam_points.resize(model.beams.size() * points);
  each(s.beams.size(), [&](std::size_t e) {
    const auto own = std::span(s.beam_points).subspan(e * points, points);
    s.beams[e] = beam_forces(system, state, system.beam_location[e], own);
  });
  s.shells.resize(model.shells.size());
  s.shell_layers.resize(model.shells.size() * layers);
  each(s.shells.size(), [&](std::size_t e) {
    const auto own = std::span(s.shell_layers).subspan(e * layers, layers);
    s.shells[e] = shell_forces(system, state, system.shell_location[e], own);
  });
}

}  // namespace nugget::output
