// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/prestress.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/index.hpp"
#include "kernel/element/quadratic_tetrahedron.hpp"
#include "nvh/matrices/assembly.hpp"
#include "nvh/matrices/nodal.hpp"
#include "nvh/matrices/stresses.hpp"
#include "system/shell_elements.hpp"
#include "system/thick_shell_element.hpp"

namespace nugget::nvh {
namespace {

using Tensor = std::array<double, 6>;  // xx yy zz xy yz zx
using ElementLocation = system::System::ElementLocation;
using Gradient = std::array<double, 3>;  ///< of a shape function in up to three natural coordinates

void add_to(Tensor& sum, double factor, const Tensor& t) {
  for (std::size_t c = 0; c < 6; ++c) sum[c] += factor * t[c];
}

Tensor along(const Vec3d& n) {
  return {n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
}

Vec3d product(const Tensor& s, const Vec3d& v) {
  return {s[0] * v.x + s[3] * v.y + s[5] * v.z, s[3] * v.x + s[1] * v.y + s[4] * v.z,
          s[5] * v.x + s[4] * v.y + s[2] * v.z};
}

/// Mean through the thickness of stresses given at places -1 .. 1, on straight lines between them; beyond the outermost
/// they are theirs. The points of one place count as their mean.
Tensor mean_through(const std::vector<model::InitialPoint>& points) {
  std::map<double, std::pair<Tensor, int>> at_place;
  for (const model::InitialPoint& p : points) {
    auto& [sum, count] = at_place[p.zeta];
    add_to(sum, 1.0, p.stress);
    ++count;
  }
  Tensor mean{};
  double from = -1.0;
  for (auto it = at_place.begin(); it != at_place.end(); ++it) {
    const auto next = std::next(it);
    const double to = next == at_place.end() ? 1.0 : 0.5 * (it->first + next->first);
    add_to(mean, 0.5 * (to - from) / it->second.second, it->second.first);
    from = to;
  }
  return mean;
}

/// Points of integration of an element by its number of natural coordinates: shape gradients and weight.
struct Point {
  std::vector<Gradient> gradient;
  double weight;
};

/// Those of kernel::quadratic_tetrahedron_cycle, by the area coordinates of nodes 2 to 4.
std::vector<Point> points_of_quadratic_tetrahedron() {
  constexpr double near = 0.58541019662496845446, far = 0.13819660112501051518;
  constexpr std::array<Gradient, 4> slope{{{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::vector<Point> points;
  for (std::size_t p = 0; p < 4; ++p) {
    std::array<double, 4> l{far, far, far, far};
    l[p] = near;
    Point point{{}, 1.0 / 24.0};
    for (std::size_t a = 0; a < 4; ++a) {
      const double f = 4.0 * l[a] - 1.0;
      point.gradient.push_back({f * slope[a][0], f * slope[a][1], f * slope[a][2]});
    }
    for (const auto& edge : kernel::quadratic_tetrahedron_edge) {
      const std::size_t i = at(edge[0]), j = at(edge[1]);
      Gradient g{};
      for (std::size_t c = 0; c < 3; ++c) g[c] = 4.0 * (l[i] * slope[j][c] + l[j] * slope[i][c]);
      point.gradient.push_back(g);
    }
    points.push_back(std::move(point));
  }
  return points;
}

std::vector<Point> points_of(std::size_t corners, int dimension) {
  if (dimension == 1) return {{{{-0.5}, {0.5}}, 2.0}};
  if (corners == 3) return {{{{-1, -1}, {1, 0}, {0, 1}}, 0.5}};
  if (dimension == 3 && corners == 4) return {{{{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 1.0 / 6.0}};
  if (corners == 10) return points_of_quadratic_tetrahedron();
  constexpr std::array<Gradient, 8> corner{
      {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
  const double g = 1.0 / std::sqrt(3.0);
  std::vector<Point> points;
  for (std::size_t p = 0; p < corners; ++p) {
    Point point{{}, 1.0};
    for (std::size_t a = 0; a < corners; ++a) {
      Gradient d{};
      for (std::size_t i = 0; i < at(dimension); ++i) {
        d[i] = corner[a][i] / std::pow(2.0, dimension);
        for (std::size_t j = 0; j < at(dimension); ++j)
          if (j != i) d[i] *= 1.0 + g * corner[p][j] * corner[a][j];
      }
      point.gradient.push_back(d);
    }
    points.push_back(std::move(point));
  }
  return points;
}

/// Gradients of the shape functions on a line, a surface or a body in space, and the measure; 0 where it is degenerate.
double gradients(const Point& point, int dimension, const std::vector<Vec3d>& x, std::vector<Vec3d>& gradient) {
  Vec3d t[3]{};
  for (std::size_t a = 0; a < x.size(); ++a)
    for (std::size_t i = 0; i < at(dimension); ++i) t[i] += point.gradient[a][i] * x[a];
  // Completed by unit normals, three vectors whose reciprocal base carries the gradients.
  if (dimension == 1) {
    const Vec3d least = std::abs(t[0].x) < 0.6 * norm(t[0]) ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d across = cross(t[0], least);
    if (!(norm(across) > 0.0)) return 0.0;
    t[1] = unit(across);
  }
  if (dimension < 3) {
    const Vec3d normal = cross(t[0], t[1]);
    if (!(norm(normal) > 0.0)) return 0.0;
    t[2] = unit(normal);
  }
  const double measure = dot(t[0], cross(t[1], t[2]));
  if (!(measure > 0.0)) return 0.0;
  const Vec3d reciprocal[3] = {(1.0 / measure) * cross(t[1], t[2]), (1.0 / measure) * cross(t[2], t[0]),
                               (1.0 / measure) * cross(t[0], t[1])};
  gradient.assign(x.size(), {});
  for (std::size_t a = 0; a < x.size(); ++a)
    for (std::size_t i = 0; i < at(dimension); ++i) gradient[a] += point.gradient[a][i] * reciprocal[i];
  return measure;
}

int dimension_of(const system::ElementGroup& group) {
  return group.nodes_per_element == 2 ? 1 : group.kind == model::ElementKind::shell ? 2 : 3;
}

/// K_s of an element in its freedoms, row-major. Along a line only motions across it count: the element's own law says
/// what a stretch does to its force, and the force may be large beside its stiffness.
std::vector<double> element_stiffness(const system::ElementGroup& group, const std::vector<Vec3d>& x,
                                      const std::vector<Point>& points, const Tensor& s) {
  const std::size_t per_node = at(group.freedoms()), n = x.size() * per_node;
  double share[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (dimension_of(group) == 1) {
    const Vec3d r = unit(x[1] - x[0]);
    const double component[3] = {r.x, r.y, r.z};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) share[i][j] -= component[i] * component[j];
  }
  std::vector<double> k(n * n, 0.0);
  std::vector<Vec3d> gradient;
  for (const Point& p : points) {
    const double measure = p.weight * gradients(p, dimension_of(group), x, gradient);
    if (measure == 0.0) continue;
    for (std::size_t a = 0; a < x.size(); ++a)
      for (std::size_t b = 0; b < x.size(); ++b) {
        const double work = measure * dot(gradient[a], product(s, gradient[b]));
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) k[(a * per_node + i) * n + b * per_node + j] += work * share[i][j];
      }
  }
  return k;
}

std::vector<Vec3d> places_of(const system::ElementGroup& group, std::size_t e, const system::State& rest) {
  const system::ElementNodes nodes = group.nodes(e);
  std::vector<Vec3d> x;
  for (const int node : element_nodes(group, nodes)) x.push_back(vec(rest.x[node]));
  return x;
}

/// The layers' shares of a thick shell; empty of other elements.
kernel::LayerRule layers_of_thick(const model::Model& model, const system::ElementGroup& group) {
  if (!model.has_thick_shells(group.part)) return {};
  return system::layer_rule(*model.solid_sections[model.parts[group.part].section].thickness, model.control);
}

bool any(const Tensor& t) {
  return std::any_of(t.begin(), t.end(), [](double c) { return c != 0.0; });
}

/// Adds the stiffness that a force has at an arm, 1/2 (f r + r f) - (f . r) 1, row-major.
void add_arm(const Vec3d& f, const Vec3d& r, std::array<double, 9>& k) {
  const double force[3] = {f.x, f.y, f.z}, arm[3] = {r.x, r.y, r.z};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      k[3 * i + j] += 0.5 * (force[i] * arm[j] + arm[i] * force[j]) - (i == j ? dot(f, r) : 0.0);
}

}  // namespace

Prestress::Prestress(const Matrices& m)
    : matrices_(m), system_(m.system), rest_(m.rest), force_(m.system.nodes), joint_arms_(m.system.bodies.size()) {
  for (const auto& group : m.system.groups) tensor_.emplace_back(group->size(), Tensor{});
}

Tensor& Prestress::of(const ElementLocation& location) {
  return tensor_[location.group][location.element];
}

void Prestress::add_along(const ElementLocation& location, const Vec3d& force) {
  const system::ElementGroup& group = *system_.groups[location.group];
  if (group.kind == model::ElementKind::discrete) {
    const model::Index o = system_.model.discretes[group.element[at(location.element)]].orientation;
    if (o != model::none && !system_.model.spring_orientations[o].in_plane) return;
  }
  const system::ElementNodes node = group.nodes(at(location.element));
  const Vec3d line = vec(rest_.x[node[1]]) - vec(rest_.x[node[0]]);
  if (norm(line) > 0.0) add_to(of(location), dot(unit(line), force), along(unit(line)));
}

bool Prestress::at_body(const system::ElementGroup& group, std::size_t e) const {
  const system::ElementNodes nodes = group.nodes(e);
  return std::ranges::any_of(element_nodes(group, nodes), [&](int k) { return system_.rigid_body_of_node(k) >= 0; });
}

void Prestress::add_forces_of_stresses() {
  std::vector<Vec3d> gradient;
  for (std::size_t g = 0; g < tensor_.size(); ++g) {
    const system::ElementGroup& group = *system_.groups[g];
    const std::vector<Point> points = points_of(at(group.nodes_per_element), dimension_of(group));
    for (std::size_t e = 0; e < group.size(); ++e) {
      if (!group.alive(e) || !any(tensor_[g][e]) || !at_body(group, e)) continue;
      const system::ElementNodes node = group.nodes(e);
      const std::vector<Vec3d> x = places_of(group, e, rest_);
      for (const Point& p : points) {
        const double measure = p.weight * gradients(p, dimension_of(group), x, gradient);
        if (measure == 0.0) continue;
        for (std::size_t a = 0; a < x.size(); ++a) force_[node[a]] += measure * product(tensor_[g][e], gradient[a]);
      }
    }
  }
}

void Prestress::add_loads(const std::vector<SixDof>& loads) {
  for (std::size_t k = 0; k < force_.size(); ++k) force_[k] -= Vec3d{loads[k][0], loads[k][1], loads[k][2]};
}

std::vector<std::array<double, 9>> Prestress::arms() const {
  std::vector<std::array<double, 9>> all = joint_arms_;
  for (std::size_t k = 0; k < force_.size(); ++k)
    if (const int body = system_.rigid_body_of_node(static_cast<int>(k)); body >= 0 && norm(force_[k]) > 0.0)
      add_arm(force_[k], vec(rest_.x[k]) - system_.bodies[body].center0, all[at(body)]);
  return all;
}

void Prestress::add_arm_forces(const std::vector<SixDof>& motion, std::vector<SixDof>& force) const {
  const std::vector<std::array<double, 9>> all = arms();
  for (std::size_t b = 0; b < all.size(); ++b) {
    const std::size_t node = at(system_.bodies[b].node);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) force[node][3 + i] += all[b][3 * i + j] * motion[node][3 + j];
  }
}

void Prestress::add_initial() {
  const system::System& system = system_;
  const model::InitialState& initial = system.model.initial_state;
  for (const model::InitialStress& s : initial.shells) {
    const ElementLocation location = system.shell_location[s.element];
    if (location.group >= 0)
      add_to(of(location), system.groups[location.group]->thickness(at(location.element)), mean_through(s.points));
  }
  for (const model::InitialStress& s : initial.solids)
    if (const ElementLocation location = system.solid_location[s.element]; location.group >= 0)
      for (const model::InitialPoint& p : s.points)
        add_to(of(location), 1.0 / static_cast<double>(s.points.size()), p.stress);
  for (const model::SectionStress& s : initial.section_stresses)
    for (const model::Index solid : s.solids)
      if (const ElementLocation location = system.solid_location[solid]; location.group >= 0)
        add_to(of(location), system.model.curves[s.curve].clamped(0.0), along(s.normal));
  for (const model::AxialForce& f : initial.axial_forces)
    for (const model::Index beam : f.beams) {
      const ElementLocation location = system.beam_location[beam];
      if (location.group < 0) continue;
      const system::ElementNodes node = system.groups[location.group]->nodes(at(location.element));
      const Vec3d line = vec(rest_.x[node[1]]) - vec(rest_.x[node[0]]);
      if (norm(line) > 0.0)
        add_to(of(location), f.scale * system.model.curves[f.curve].clamped(0.0), along(unit(line)));
    }
  add_forces_of_stresses();
  const Nodal start = forces_at_start(matrices_);
  for (std::size_t k = 0; k < force_.size(); ++k) force_[k] += part_of(start[k], false);
  add_joints(nullptr);
  for (std::size_t g = 0; g < tensor_.size(); ++g) {
    const system::ElementGroup& group = *system.groups[g];
    if (dimension_of(group) != 1) continue;
    const std::size_t per_node = at(group.freedoms());
    std::vector<double> force(2 * per_node);
    for (std::size_t e = 0; e < group.size(); ++e)
      if (group.alive(e) && group.force_at_start(e, rest_, force))
        add_along({static_cast<int>(g), static_cast<int>(e)},
                  {force[per_node], force[per_node + 1], force[per_node + 2]});
  }
}

void Prestress::add(const std::vector<SixDof>& motion) {
  const ElasticStresses elastic(system_, motion);
  for (std::size_t g = 0; g < tensor_.size(); ++g) {
    const system::ElementGroup& group = *system_.groups[g];
    const int layers = group.layers();
    const kernel::LayerRule rule = dimension_of(group) == 2 ? system::layer_rule(system_.model, group.part)
                                                            : layers_of_thick(system_.model, group);
    for (std::size_t e = 0; e < group.size(); ++e) {
      if (!group.alive(e)) continue;
      const ElementLocation location{static_cast<int>(g), static_cast<int>(e)};
      if (dimension_of(group) == 3 && rule.count == 0) add_to(of(location), 1.0, elastic.stress(location, 0));
      if (dimension_of(group) == 3)
        for (int k = 0; k < rule.count; ++k) add_to(of(location), rule.weight[k], elastic.stress(location, k));
      if (dimension_of(group) == 2)
        for (int k = 0; k < layers; ++k)
          add_to(of(location), group.thickness(e) * rule.weight[k], elastic.stress(location, k));
      if (at_body(group, e)) {
        const std::vector<double> f = element_force(matrices_, group, e, motion);
        const system::ElementNodes node = group.nodes(e);
        const std::size_t freedoms = at(group.freedoms());
        for (std::size_t a = 0; a < at(group.nodes_per_element); ++a)
          force_[node[a]] += Vec3d{f[a * freedoms], f[a * freedoms + 1], f[a * freedoms + 2]};
      }
      if (dimension_of(group) > 1) continue;
      // Along a line: the force at its second end.
      const std::size_t per_node = at(group.freedoms()), n = 2 * per_node;
      std::vector<double> k(n * n);
      group.stiffness(e, rest_, k);
      const system::ElementNodes node = group.nodes(e);
      double force[3] = {0.0, 0.0, 0.0};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < n; ++j)
          force[i] += k[(per_node + i) * n + j] * motion[node[j / per_node]][j % per_node];
      add_along(location, {force[0], force[1], force[2]});
    }
  }
  add_joints(&motion);
}

/// Forces of joints on their bodies, by a motion; without one those with which the stiffnesses of joints begin.
void Prestress::add_joints(const std::vector<SixDof>* motion) {
  for (const BodyLink& link : matrices_.links) {
    const ConstrainedMotion::Row moved = motion != nullptr ? motion_of(link, *motion) : ConstrainedMotion::Row{};
    Vec3d force{};
    for (const ConstrainedMotion& h : link.constrained) {
      if (h.rotation) continue;
      double way = 0.0;
      for (std::size_t i = 0; i < 12; ++i) way += h.row[i] * moved[i];
      force += (motion != nullptr ? h.spring * way : h.start) * h.direction;
    }
    if (!(norm(force) > 0.0)) continue;
    for (std::size_t side = 0; side < 2; ++side)
      add_arm(side == 0 ? -force : force, link.arm[side], joint_arms_[at(link.node[side]) - system_.nodes]);
  }
}

void Prestress::add(const system::System& run, const system::State& now) {
  const auto carry = [&](const std::vector<ElementLocation>& from, const std::vector<ElementLocation>& to) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (from[i].group < 0 || to[i].group < 0) continue;
      const system::ElementGroup& group = *run.groups[from[i].group];
      const std::size_t e = at(from[i].element);
      if (!group.alive(e)) continue;
      if (dimension_of(group) == 1) {
        add_along(to[i], run.nodal_force(from[i], 1));
        const system::ElementNodes node = system_.groups[to[i].group]->nodes(at(to[i].element));
        for (const int a : {0, 1}) force_[node[a]] += run.nodal_force(from[i], a);
        continue;
      }
      const int layers = group.layers();
      const kernel::LayerRule rule =
          dimension_of(group) == 2 ? system::layer_rule(run.model, group.part) : layers_of_thick(run.model, group);
      for (int k = 0; k < layers; ++k)
        add_to(of(to[i]),
               dimension_of(group) == 2 ? group.thickness(e) * rule.weight[k]
               : rule.count > 0         ? rule.weight[k]
                                        : 1.0 / layers,
               group.layer(e, k, now).stress);
    }
  };
  carry(run.shell_location, system_.shell_location);
  carry(run.solid_location, system_.solid_location);
  add_forces_of_stresses();
  carry(run.beam_location, system_.beam_location);
  carry(run.discrete_location, system_.discrete_location);
}

std::size_t Prestress::elements() const {
  std::size_t count = 0;
  for (const std::vector<Tensor>& group : tensor_)
    count += static_cast<std::size_t>(std::count_if(group.begin(), group.end(), any));
  return count;
}

Symmetric Prestress::stiffness(const Equations& equations) const {
  struct Piece {
    DofMap dof_map;
    std::vector<double> k;
  };
  std::vector<Piece> pieces;
  std::vector<std::vector<int>> lists;
  for (std::size_t g = 0; g < tensor_.size(); ++g) {
    const system::ElementGroup& group = *system_.groups[g];
    const std::vector<Point> points = points_of(at(group.nodes_per_element), dimension_of(group));
    for (std::size_t e = 0; e < group.size(); ++e) {
      if (!group.alive(e) || !any(tensor_[g][e])) continue;
      const system::ElementNodes node = group.nodes(e);
      pieces.push_back({DofMap(equations, element_nodes(group, node), group.freedoms()),
                        element_stiffness(group, places_of(group, e, rest_), points, tensor_[g][e])});
      lists.push_back(pieces.back().dof_map.equations());
    }
  }
  const std::vector<std::array<double, 9>> of_arms = arms();
  for (std::size_t b = 0; b < of_arms.size(); ++b) {
    if (std::ranges::all_of(of_arms[b], [](double v) { return v == 0.0; })) continue;
    std::vector<double> own(36, 0.0);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) own[6 * (3 + i) + 3 + j] = of_arms[b][3 * i + j];
    const int node = system_.bodies[b].node;
    pieces.push_back({DofMap(equations, {&node, 1}, 6), std::move(own)});
    lists.push_back(pieces.back().dof_map.equations());
  }
  Symmetric k(pattern(at(equations.size()), lists));
  for (const Piece& p : pieces) scatter(p.dof_map, p.k, k);
  return k;
}

void Prestress::add_element_stiffness(const system::ElementGroup& group, std::size_t e, std::span<double> k) const {
  const auto own =
      std::find_if(system_.groups.begin(), system_.groups.end(), [&](const auto& g) { return g.get() == &group; });
  const Tensor& tensor = tensor_[own - system_.groups.begin()][e];
  if (!any(tensor)) return;
  const std::vector<double> more = element_stiffness(
      group, places_of(group, e, rest_), points_of(at(group.nodes_per_element), dimension_of(group)), tensor);
  for (std::size_t i = 0; i < more.size(); ++i) k[i] += more[i];
}

}  // namespace nugget::nvh
