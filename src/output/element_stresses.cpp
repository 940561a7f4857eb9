// SPDX-License-Identifier: Apache-2.0
#include "output/element_stresses.hpp"

#include <algorithm>

#include "base/index.hpp"
#include "base/parallel.hpp"

namespace nugget::output {
namespace {

using ElementLocation = system::System::ElementLocation;

StressRecord record(const system::System& system, const system::ElementGroup& group, const ElementLocation& location,
                    int point, const system::State& state) {
  const system::ElementGroup::Layer layer = shown_layer(system, group, at(location.element), point, state);
  return {by_cmpflg(system.model, group, at(location.element), point, state, layer.stress), layer.plastic_strain,
          layer.damage};
}

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

/// Calls `fill(element, group, location)` for those that have a kernel.
template <class Fill>
void each_element(const system::System& system, const std::vector<ElementLocation>& locations, const Fill& fill) {
  parallel_for(locations.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e)
      if (locations[e].group >= 0) fill(e, *system.groups[locations[e].group], locations[e]);
  });
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
  std::optional<Frame3d> axes = group.axes(e, state);
  if (!axes || system.model.control.invariant_shell_axes) return axes;
  const auto nodes = group.nodes(e);
  const Vec3d side = vec(state.x[nodes[1]]) - vec(state.x[nodes[0]]);
  const Vec3d in_plane = side - dot(side, axes->e3) * axes->e3;
  if (!(norm(in_plane) > 0.0)) return axes;
  const Vec3d x = unit(in_plane);
  return Frame3d{x, cross(axes->e3, x), axes->e3};
}

std::array<double, 6> by_cmpflg(const model::Model& model, const system::ElementGroup& group, std::size_t e, int layer,
                                const system::State& state, const std::array<double, 6>& tensor) {
  if (!model.requests.material_axes) return tensor;
  const auto axes = group.material_axes(e, layer, state);
  return axes ? along(*axes, tensor) : tensor;
}

void fill_stresses(const system::System& system, const system::State& state, D3plotState& s) {
  using Group = system::ElementGroup;
  const model::Model& model = system.model;
  s.solids.resize(model.solids.size());
  each_element(system, system.solid_location, [&](std::size_t e, const Group& group, const ElementLocation& location) {
    static_cast<StressRecord&>(s.solids[e]) = record(system, group, location, 0, state);
  });

  const auto points = at(model.requests.beam_points);
  s.beams.resize(model.beams.size());
  s.beam_points.resize(model.beams.size() * points);
  each_element(system, system.beam_location, [&](std::size_t e, const Group& group, const ElementLocation& location) {
    const std::array<double, 8> r = group.resultants(at(location.element));
    s.beams[e] = {r[0], r[1], r[2], r[4], r[5], r[3]};
    for (std::size_t k = 0; k < std::min(points, at(group.layers())); ++k) {
      const StressRecord p = record(system, group, location, static_cast<int>(k), state);
      s.beam_points[e * points + k] = {p.stress[3], p.stress[5], p.stress[0], p.plastic_strain, 0.0};
    }
  });

  const auto layers = at(model.requests.layers);
  s.shells.resize(model.shells.size());
  s.shell_layers.resize(model.shells.size() * layers);
  each_element(system, system.shell_location, [&](std::size_t e, const Group& group, const ElementLocation& location) {
    std::vector<StressRecord> through;
    for (int k = 0; k < group.layers(); ++k) through.push_back(record(system, group, location, k, state));
    shell_layers(through, std::span(s.shell_layers).subspan(e * layers, layers));
    std::array<double, 8> r = group.resultants(at(location.element));
    const auto own = group.axes(at(location.element), state),
               axes = shell_axes(system, group, at(location.element), state);
    if (own && axes) r = turned(r, dot(axes->e1, own->e1), dot(axes->e1, own->e2));
    ShellRecord& shell = s.shells[e];
    // LS-DYNA's are the integrals of -z times the stress (Theory Manual, Belytschko-Lin-Tsay shell).
    shell.mx = -r[0], shell.my = -r[1], shell.mxy = -r[2];
    shell.qx = r[3], shell.qy = r[4];
    shell.nx = r[5], shell.ny = r[6], shell.nxy = r[7];
  });
}

}  // namespace nugget::output
