// SPDX-License-Identifier: Apache-2.0
#include "impact/simulation/strains.hpp"

#include <algorithm>
#include <utility>

#include "base/batch.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"
#include "impact/conditions/preloads.hpp"
#include "kernel/element/belytschko_tsay.hpp"
#include "kernel/element/c0_triangle.hpp"
#include "kernel/element/kirchhoff_triangle.hpp"
#include "kernel/element/quadratic_tetrahedron.hpp"
#include "kernel/element/quadrilateral.hpp"
#include "model/axes.hpp"
#include "model/bond.hpp"
#include "system/shell_elements.hpp"
#include "system/thick_shell_element.hpp"

namespace nugget::impact {
namespace {

constexpr auto at_a_time = static_cast<std::size_t>(lanes<NativeBatch>);

Frame3d frame_of(const std::array<Vec3d, 4>& x, int corners) {
  return corners == 4 ? kernel::shell_frame(x) : kernel::triangle_frame({x[0], x[1], x[2]});
}

std::array<Vec3d, 8> first_eight(const std::array<Vec3d, 10>& x) {
  std::array<Vec3d, 8> eight;
  std::copy_n(x.begin(), 8, eight.begin());
  return eight;
}

/// Velocity gradient of a brick amid the surface of its natural coordinate zeta = `height` (0: its centre): rows are
/// the gradients of the velocity's components.
template <class R>
std::array<Vec3<R>, 3> velocity_gradient(const std::array<Vec3<R>, 8>& x, const std::array<Vec3<R>, 8>& v,
                                         double height = 0.0) {
  static constexpr double xi[8] = {-1, 1, 1, -1, -1, 1, 1, -1}, eta[8] = {-1, -1, 1, 1, -1, -1, 1, 1},
                          zeta[8] = {-1, -1, -1, -1, 1, 1, 1, 1};
  std::array<Vec3<R>, 3> along{}, rate{};  // derivatives of place and velocity by xi, eta, zeta
  for (std::size_t a = 0; a < 8; ++a) {
    const double near = 0.125 * (1.0 + zeta[a] * height);
    const double d[3] = {near * xi[a], near * eta[a], 0.125 * zeta[a]};
    for (std::size_t i = 0; i < 3; ++i) {
      along[i] += R(d[i]) * x[a];
      rate[i] += R(d[i]) * v[a];
    }
  }
  const R volume = dot(along[0], cross(along[1], along[2])), over = 1.0 / volume;
  const R scale = select(volume > 0.0, over, R(0.0));
  const std::array<Vec3<R>, 3> dual{scale * cross(along[1], along[2]), scale * cross(along[2], along[0]),
                                    scale * cross(along[0], along[1])};
  std::array<Vec3<R>, 3> gradient{};
  for (std::size_t i = 0; i < 3; ++i) {
    gradient[0] += rate[i].x * dual[i];
    gradient[1] += rate[i].y * dual[i];
    gradient[2] += rate[i].z * dual[i];
  }
  return gradient;
}

/// Adds a step with the velocity gradient `g` to a strain.
template <class R>
void add(std::array<R, 6>& s, const std::array<Vec3<R>, 3>& g, double step) {
  // Half the curl; the strain so far turns with the element (Jaumann).
  const R dt(step), half(0.5 * step);
  const R wz = half * (g[1].x - g[0].y), wx = half * (g[2].y - g[1].z), wy = half * (g[0].z - g[2].x);
  const auto [xx, yy, zz, xy, yz, zx] = s;
  s[0] += dt * g[0].x + 2.0 * (wy * zx - wz * xy);
  s[1] += dt * g[1].y + 2.0 * (wz * xy - wx * yz);
  s[2] += dt * g[2].z + 2.0 * (wx * yz - wy * zx);
  s[3] += half * (g[0].y + g[1].x) + wz * (xx - yy) + wy * yz - wx * zx;
  s[4] += half * (g[1].z + g[2].y) + wx * (yy - zz) + wz * zx - wy * xy;
  s[5] += half * (g[2].x + g[0].z) + wy * (zz - xx) + wx * xy - wz * yz;
}

}  // namespace

/// Elements that are looked at together, a lane each.
template <std::size_t corners>
struct Strains::Chunk {
  std::array<std::size_t, at_a_time> element{};
  std::array<std::array<int, at_a_time>, corners> node{};
  std::size_t count = 0;
};

/// Collects elements into chunks. The rows of the nodes of one are on their way while that before it is looked at.
template <std::size_t corners>
class Strains::Chunks {
 public:
  Chunks(Strains& strains, const system::State& state) : strains_(strains), state_(state) {}
  void add(std::size_t e, const system::ElementNodes& nodes) {
    for (std::size_t a = 0; a < corners; ++a) {
      const auto k = at(nodes[a]);
      __builtin_prefetch(&state_.x[k]);
      __builtin_prefetch(&state_.v[k]);
      if (corners == 4) __builtin_prefetch(&state_.w[k]);
      // Lanes that stay empty repeat the first.
      if (next_.count == 0) next_.node[a].fill(nodes[a]);
      next_.node[a][next_.count] = nodes[a];
    }
    if (next_.count == 0) next_.element.fill(e);
    next_.element[next_.count] = e;
    if (++next_.count == at_a_time) look_at_last();
  }
  void finish() {
    look_at_last();
    look_at_last();
  }

 private:
  void look_at_last() {
    if (last_.count > 0) strains_.advance(last_, state_);
    last_ = next_;
    next_.count = 0;
  }

  Strains& strains_;
  const system::State& state_;
  Chunk<corners> last_, next_;
};

Strains::Strains(const system::System& system, bool wanted) : system_(system) {
  if (!wanted) return;
  const model::Model& model = system.model;
  shells_.resize(model.shells.size());
  solids_.resize(model.solids.size());
  find_thick_shells();
  for (const model::Part& part : model.parts) has_separations_.push_back(model::bond_of(model, part) ? 1 : 0);
  zeta_.resize(model.shells.size());
  for (std::size_t e = 0; e < zeta_.size(); ++e) {
    const system::System::ElementLocation location = system.shell_location[e];
    if (location.group < 0) continue;
    const std::vector<double> places = layer_places(model, *system.groups[location.group]);
    zeta_[e] = {places.front(), places.back()};
  }
}

void Strains::find_thick_shells() {
  const model::Model& model = system_.model;
  for (std::size_t e = 0; e < model.solids.size(); ++e) {
    if (!model.has_thick_shells(model.solids.part[e])) continue;
    const auto& section = model.solid_sections[model.parts[model.solids.part[e]].section];
    thick_rank_.resize(model.solids.size(), model::none);
    thick_rank_[e] = static_cast<model::Index>(thick_zeta_.size());
    const kernel::LayerRule rule = system::layer_rule(*section.thickness, model.control);
    thick_zeta_.push_back(rule.zeta[at(rule.count - 1)]);
  }
  thick_.resize(thick_zeta_.size());
}

void Strains::start(const system::State& state) {
  if (shells_.empty()) return;
  for (const model::InitialStrain& initial : system_.model.initial_state.shell_strains) {
    const system::System::ElementLocation location = system_.shell_location[initial.shell];
    if (location.group < 0) continue;
    const system::ElementGroup& group = *system_.groups[location.group];
    const auto nodes = group.nodes(at(location.element));
    std::array<Vec3d, 4> x{};
    for (std::size_t a = 0; a < at(group.nodes_per_element); ++a) x[a] = vec(state.x[nodes[a]]);
    const Frame3d frame = frame_of(x, group.nodes_per_element);
    const auto local = [&](const Tensor& t) -> InPlane {
      const auto [xx, yy, xy, xz, yz] = system::local_stress(frame, t);
      return {xx, yy, xy, yz, xz};
    };
    shells_[initial.shell] = {local(initial.lower), local(initial.upper)};
  }
}

void Strains::update(const system::State& state) {
  // Calls `visit` with the group of each element that this process computes.
  const auto each = [this](const std::vector<system::System::ElementLocation>& locations, std::size_t begin,
                           std::size_t end, const auto& visit) {
    for (std::size_t e = begin; e < end; ++e) {
      const system::System::ElementLocation location = locations[e];
      if (location.group < 0 || !system_.computes(location)) continue;
      const system::ElementGroup& group = *system_.groups[location.group];
      if (group.alive(at(location.element))) visit(e, group, at(location.element));
    }
  };
  parallel_for(shells_.size(), 256, [&](std::size_t begin, std::size_t end) {
    Chunks<4> quadrilaterals(*this, state);
    each(system_.shell_location, begin, end, [&](std::size_t e, const system::ElementGroup& group, std::size_t place) {
      if (group.nodes_per_element == 3) return advance_triangle(e, state);
      quadrilaterals.add(e, group.nodes(place));
    });
    quadrilaterals.finish();
  });
  parallel_for(solids_.size(), 256, [&](std::size_t begin, std::size_t end) {
    Chunks<8> hexahedra(*this, state);
    each(system_.solid_location, begin, end, [&](std::size_t e, const system::ElementGroup& group, std::size_t place) {
      if (has_separations_[at(group.part)]) return;
      if (group.nodes_per_element != 8 || is_thick_shell(e)) return advance_solid(e, state);
      hexahedra.add(e, group.nodes(place));
    });
    hexahedra.finish();
  });
}

void Strains::advance(const Chunk<4>& shells, const system::State& state) {
  using R = NativeBatch;
  std::array<double, at_a_time> offset, half_thickness, low, high;
  for (std::size_t l = 0; l < at_a_time; ++l) {
    const std::size_t e = shells.element[l];
    const system::System::ElementLocation location = system_.shell_location[e];
    const system::ElementGroup& group = *system_.groups[location.group];
    offset[l] = system_.model.shells.offset(static_cast<model::Index>(e));
    half_thickness[l] = 0.5 * group.thickness(at(location.element));
    low[l] = zeta_[e][0];
    high[l] = zeta_[e][1];
  }
  const R dt(state.dt), half_step(0.5 * state.dt);
  Vec3<R> x[4], v[4], w[4];
  for (std::size_t a = 0; a < 4; ++a) {
    v[a] = gather<R>(state.v.data(), shells.node[a].data());
    w[a] = gather<R>(state.w.data(), shells.node[a].data());
    x[a] = gather<R>(state.x.data(), shells.node[a].data()) - half_step * v[a];
  }
  const kernel::Quadrilateral<R> mid(x);
  const Vec3<R> v13 = mid.frame.local(v[0] - v[2]), v24 = mid.frame.local(v[1] - v[3]);
  const Vec3<R> w13 = mid.frame.local(w[0] - w[2]), w24 = mid.frame.local(w[1] - w[3]);
  const Vec3<R> spin = 0.25 * mid.frame.local((w[0] + w[1]) + (w[2] + w[3]));
  const R xx = dt * mid.dx(v13.x, v24.x), yy = dt * mid.dy(v13.y, v24.y);
  const R xy = 0.5 * dt * (mid.dx(v13.y, v24.y) + mid.dy(v13.x, v24.x));
  const R bent_xx = dt * mid.dx(w13.y, w24.y), bent_yy = -dt * mid.dy(w13.x, w24.x);
  const R bent_xy = 0.5 * dt * (mid.dy(w13.y, w24.y) - mid.dx(w13.x, w24.x));
  const R yz = 0.5 * dt * (mid.dy(v13.z, v24.z) - spin.x), zx = 0.5 * dt * (mid.dx(v13.z, v24.z) + spin.y);
  const auto add = [&](InPlane ShellStrain::*face, const std::array<double, at_a_time>& zeta) {
    const R z = real_load<R>(offset.data()) + real_load<R>(half_thickness.data()) * real_load<R>(zeta.data());
    const std::array<R, 5> more{xx + z * bent_xx, yy + z * bent_yy, xy + z * bent_xy, yz, zx};
    for (std::size_t l = 0; l < shells.count; ++l)
      for (std::size_t c = 0; c < more.size(); ++c)
        (shells_[shells.element[l]].*face)[c] += lane(more[c], static_cast<int>(l));
  };
  add(&ShellStrain::lower, low);
  add(&ShellStrain::upper, high);
}

void Strains::advance_triangle(std::size_t e, const system::State& state) {
  const system::System::ElementLocation location = system_.shell_location[e];
  const system::ElementGroup& group = *system_.groups[location.group];
  const auto nodes = group.nodes(at(location.element));
  std::array<Vec3d, 3> x{}, v{}, w{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto k = at(nodes[a]);
    x[a] = vec(state.x[k]) - 0.5 * state.dt * vec(state.v[k]);
  }
  const Frame3d frame = kernel::triangle_frame(x);
  for (std::size_t a = 0; a < 3; ++a) {
    const auto k = at(nodes[a]);
    x[a] = frame.local(x[a]);
    v[a] = frame.local(vec(state.v[k]));
    w[a] = frame.local(vec(state.w[k]));
  }
  // Gradients, b_x = (y(next) - y(before)) / 2A.
  double twice_area = 0.0;
  Vec3d v_x{}, v_y{}, w_x{}, w_y{}, spin{};
  for (std::size_t a = 0; a < 3; ++a) {
    const Vec3d &next = x[(a + 1) % 3], &before = x[(a + 2) % 3];
    const double bx = next.y - before.y, by = before.x - next.x;
    twice_area += x[a].x * bx;
    v_x += bx * v[a];
    v_y += by * v[a];
    w_x += bx * w[a];
    w_y += by * w[a];
    spin += (1.0 / 3.0) * w[a];
  }
  const double scale = state.dt / twice_area;
  std::array<double, 3> bent{scale * w_x.y, -scale * w_y.x, scale * (w_y.y - w_x.x)};
  std::array<double, 2> shear{scale * v_y.z - state.dt * spin.x, scale * v_x.z + state.dt * spin.y};
  const model::Model& model = system_.model;
  const model::SectionShell& section = model.shell_sections[model.parts[group.part].section];
  if (system::triangle_formulation(section, model.control) == 17) {
    const auto more = kernel::kirchhoff_mean_bending(x, v, w);
    for (std::size_t c = 0; c < 3; ++c) bent[c] += state.dt * more[c];
    shear = {};
  }
  const auto add = [&](InPlane& strain, double zeta) {
    const double z =
        system_.model.shells.offset(static_cast<model::Index>(e)) + 0.5 * zeta * group.thickness(at(location.element));
    strain[0] += scale * v_x.x + z * bent[0];
    strain[1] += scale * v_y.y + z * bent[1];
    strain[2] += 0.5 * (scale * (v_y.x + v_x.y) + z * bent[2]);
    strain[3] += 0.5 * shear[0];
    strain[4] += 0.5 * shear[1];
  };
  add(shells_[e].lower, zeta_[e][0]);
  add(shells_[e].upper, zeta_[e][1]);
}

void Strains::advance(const Chunk<8>& solids, const system::State& state) {
  using R = NativeBatch;
  const R half_step(0.5 * state.dt);
  std::array<Vec3<R>, 8> x, v;
  for (std::size_t a = 0; a < 8; ++a) {
    v[a] = gather<R>(state.v.data(), solids.node[a].data());
    x[a] = gather<R>(state.x.data(), solids.node[a].data()) - half_step * v[a];
  }
  std::array<R, 6> strain;
  for (std::size_t c = 0; c < 6; ++c)
    strain[c] = each_lane<R>([&](int l) { return solids_[solids.element[at(l)]][c]; });
  add(strain, velocity_gradient(x, v), state.dt);
  for (std::size_t l = 0; l < solids.count; ++l)
    for (std::size_t c = 0; c < 6; ++c) solids_[solids.element[l]][c] = lane(strain[c], static_cast<int>(l));
}

void Strains::advance_solid(std::size_t e, const system::State& state) {
  const system::System::ElementLocation location = system_.solid_location[e];
  const system::ElementGroup& group = *system_.groups[location.group];
  const auto nodes = group.nodes(at(location.element));
  std::array<Vec3d, 10> x, v;
  const std::size_t last = at(group.nodes_per_element) - 1;  // a tetrahedron repeats its fourth node
  for (std::size_t a = 0; a < 10; ++a) {
    const auto k = at(nodes[std::min(a, last)]);
    v[a] = vec(state.v[k]);
    x[a] = vec(state.x[k]) - 0.5 * state.dt * v[a];
  }
  add(solids_[e],
      group.nodes_per_element == 10 ? kernel::quadratic_tetrahedron_gradient(x, v)
                                    : velocity_gradient(first_eight(x), first_eight(v)),
      state.dt);
  if (!is_thick_shell(e)) return;
  const auto rank = at(thick_rank_[e]);
  add(thick_[rank].lower, velocity_gradient(first_eight(x), first_eight(v), -thick_zeta_[rank]), state.dt);
  add(thick_[rank].upper, velocity_gradient(first_eight(x), first_eight(v), thick_zeta_[rank]), state.dt);
}

Strains::Tensor Strains::global(const InPlane& strain, std::size_t e, int layer, const system::State& now) const {
  const system::System::ElementLocation location = system_.shell_location[e];
  const system::ElementGroup& group = *system_.groups[location.group];
  const auto nodes = group.nodes(at(location.element));
  std::array<Vec3d, 4> x{};
  for (std::size_t a = 0; a < at(group.nodes_per_element); ++a) x[a] = vec(now.x[nodes[a]]);
  const model::Material& material = system_.model.materials[system_.model.parts[group.part].material];
  const auto stress = group.layer(at(location.element), layer, now).stress;
  const double in_plane = stress[0] + stress[1] + stress[2];
  const auto* layers = std::get_if<kernel::Laminate>(&material.law);
  const double E = layers ? (*layers->layers)[layer].law.E : material.young(),
               nu = layers ? (*layers->layers)[layer].law.nu : material.poisson();
  const double zz = -(strain[0] + strain[1]) + (E > 0.0 ? (1.0 - 2.0 * nu) / E * in_plane : 0.0);
  const auto [g0, g1, g2, g3, g4, g5] = model::to_global({strain[0], strain[2], strain[4], strain[1], strain[3], zz},
                                                         frame_of(x, group.nodes_per_element));
  return {g0, g3, g5, g1, g4, g2};
}

Strains::Faces Strains::shell(std::size_t e, const system::State& now) const {
  const system::System::ElementLocation location = system_.shell_location[e];
  if (shells_.empty() || location.group < 0) return {};
  const int layers = system_.groups[location.group]->layers();
  return {global(shells_[e].lower, e, 0, now), global(shells_[e].upper, e, layers - 1, now)};
}

Strains::Tensor Strains::solid(std::size_t e) const {
  return solids_.empty() ? Tensor{} : solids_[e];
}

Strains::Faces Strains::thick_shell(std::size_t e) const {
  return is_thick_shell(e) ? thick_[at(thick_rank_[e])] : Faces{};
}

void Strains::carry(system::Carried what, const system::System::Computed& of, system::Parcel& parcel) {
  if (what != system::Carried::results && what != system::Carried::restart) return;
  const auto some = [&](auto& strains, const std::vector<system::System::ElementLocation>& locations) {
    for (std::size_t e = 0; e < strains.size(); ++e)
      if (const auto& l = locations[e]; l.group >= 0 && of(l.group, at(l.element))) parcel(&strains[e], 1);
  };
  some(shells_, system_.shell_location);
  some(solids_, system_.solid_location);
  for (std::size_t e = 0; e < thick_rank_.size(); ++e)
    if (const auto& l = system_.solid_location[e];
        thick_rank_[e] != model::none && l.group >= 0 && of(l.group, at(l.element)))
      parcel(&thick_[at(thick_rank_[e])], 1);
}

void Strains::archive(Archive& a) {
  a(shells_, solids_, thick_);
  a.built(system_, zeta_, thick_rank_, thick_zeta_, has_separations_);
}

}  // namespace nugget::impact
