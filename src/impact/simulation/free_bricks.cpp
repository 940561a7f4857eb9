// SPDX-License-Identifier: Apache-2.0
#include "impact/simulation/free_bricks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "kernel/element/hexahedron.hpp"
#include "kernel/law/elastic_kernel.hpp"
#include "model/bond.hpp"

namespace nugget::impact {
namespace {

struct Brick {
  model::Index part, element;
  system::ElementNodes node;
  std::array<Vec3d, 8> x;
  double E, nu, density;
  double viscosity;  ///< Q2, linear
};

std::span<const int, 8> corners_of(const system::ElementNodes& node) {
  return std::span(node).first<8>();
}

/// By system node: its mass, or 0 where it cannot move by itself.
std::vector<double> free_masses(const system::System& system) {
  std::vector<double> mass(system.mass.begin(), system.mass.begin() + static_cast<std::ptrdiff_t>(system.nodes));
  const auto hold = [&](model::Index node) { mass[system.node_of[node]] = 0.0; };
  for (const model::SinglePointConstraint& spc : system.model.spcs)
    if ((spc.fixed & 0b111u) != 0) hold(spc.node);
  for (const model::PrescribedMotion& motion : system.model.motions)
    for (const model::Index node : motion.nodes) hold(node);
  for (std::size_t n = 0; n < mass.size(); ++n)
    if (system.map.dependent(static_cast<int>(n))) mass[n] = 0.0;
  return mass;
}

std::vector<Brick> bricks_of_rows(const system::System& system, const std::vector<double>& mass) {
  const auto each_brick = [&](const auto& with) {
    for (const auto& group : system.groups)
      if (group->kind == model::ElementKind::solid && group->nodes_per_element == 8 &&
          !model::bond_of(system.model, system.model.parts[group->part]))
        for (std::size_t e = 0; e < group->size(); ++e) with(*group, e, group->nodes(e));
  };
  std::vector<int> users(system.all_nodes(), 0);
  each_brick([&](const system::ElementGroup&, std::size_t, const system::ElementNodes& node) {
    for (const int n : corners_of(node)) ++users[n];
  });
  std::vector<Brick> rows;
  each_brick([&](const system::ElementGroup& group, std::size_t e, const system::ElementNodes& node) {
    if (std::ranges::any_of(corners_of(node), [&](int n) { return users[n] > 2; })) return;
    if (std::ranges::none_of(corners_of(node), [&](int n) { return mass[n] > 0.0; })) return;
    const model::Material& material = system.model.materials[system.model.parts[group.part].material];
    const model::Index card = system.model.parts[group.part].hourglass;
    const model::Hourglass& control =
        card == model::none ? system.model.control.hourglass : system.model.hourglass[card];
    Brick brick{group.part,       group.element[e],   node, {}, material.young(), material.poisson(),
                material.density, control.bulk_linear};
    for (std::size_t a = 0; a < 8; ++a) brick.x[a] = system.ties.x[system.model_node[node[a]]];
    rows.push_back(brick);
  });
  return rows;
}

constexpr double step = 0x1p-100;  // moves nothing, and is a power of two: the exact derivative

/// Forces of a brick that moves for so long a step with velocities u of its corners: of its uniform strains, and of the
/// bulk viscosity where it is compressed.
std::array<Vec3d, 8> forces(const Brick& brick, const std::array<Vec3d, 8>& u, double viscosity) {
  const kernel::LawKernel<kernel::Elastic> law(kernel::Elastic{brick.E, brick.nu});
  const kernel::HexahedronProperties no_hourglass{brick.density, 6, 0.0, 0.0, viscosity};
  const kernel::HexahedronLayout layout = kernel::hexahedron_layout(law);
  std::vector<double> state(static_cast<std::size_t>(layout.size()));
  kernel::start_hexahedron(layout, brick.x, state.data(), 1, 0);
  kernel::SolidMotion<double> motion;
  for (std::size_t a = 0; a < 8; ++a) {
    motion.x[a] = brick.x[a];
    motion.v[a] = u[a];
  }
  return std::to_array(kernel::hexahedron_cycle<double>(no_hourglass, law, motion, step, state.data()).f);
}

std::array<Vec3d, 8> at_corners(const Brick& brick, const std::vector<Vec3d>& u, double scale = 1.0) {
  std::array<Vec3d, 8> d;
  for (std::size_t a = 0; a < 8; ++a) d[a] = scale * u[brick.node[a]];
  return d;
}
double power(const std::array<Vec3d, 8>& f, const std::array<Vec3d, 8>& u) {
  double sum = 0.0;
  for (std::size_t a = 0; a < 8; ++a) sum += dot(f[a], u[a]);
  return sum;
}

/// u C u: the power of the linear bulk viscosity in a vibration u, in its phase of compression.
double viscous_power(const std::vector<Brick>& rows, const std::vector<Vec3d>& u) {
  double sum = 0.0;
  for (const Brick& b : rows)
    for (const double sign : {1.0, -1.0}) {
      const std::array<Vec3d, 8> d = at_corners(b, u, sign);
      sum += power(forces(b, d, b.viscosity), d) - power(forces(b, d, 0.0), d);
    }
  return sum;
}

}  // namespace

std::optional<FreeBricks> free_brick_step(const system::System& system) {
  const std::vector<double> mass = free_masses(system);
  const std::vector<Brick> rows = bricks_of_rows(system, mass);
  if (rows.empty()) return {};
  std::vector<Vec3d> u(mass.size()), f(mass.size());
  for (const Brick& b : rows)  // without a symmetry that the fastest vibration could lack
    for (const int n : b.node)
      if (const double k = n + 1.0; mass[n] > 0.0) u[n] = {std::sin(k), std::sin(1.7 * k), std::sin(2.3 * k)};

  FreeBricks result;
  double omega2 = 0.0, heavy = 0.0;
  for (int i = 0; i < 500; ++i) {
    std::fill(f.begin(), f.end(), Vec3d{});
    double stiff = 0.0, most = 0.0;
    heavy = 0.0;
    for (const Brick& b : rows) {
      const std::array<Vec3d, 8> d = at_corners(b, u), force = forces(b, d, 0.0);
      const double own = power(force, d) / step;
      for (std::size_t a = 0; a < 8; ++a) f[b.node[a]] += (1.0 / step) * force[a];
      stiff += own;
      if (own > most) {
        most = own;
        result.element = b.element;
        result.part = b.part;
      }
    }
    for (std::size_t n = 0; n < mass.size(); ++n) heavy += mass[n] * dot(u[n], u[n]);
    if (!(stiff > 0.0)) return {};
    const double before = omega2;
    omega2 = stiff / heavy;
    if (std::abs(omega2 - before) <= 1e-7 * omega2) break;
    for (std::size_t n = 0; n < mass.size(); ++n) u[n] = mass[n] > 0.0 ? (1.0 / (omega2 * mass[n])) * f[n] : Vec3d{};
  }
  const double omega = std::sqrt(omega2), damping = viscous_power(rows, u) / (2.0 * omega * heavy);
  result.step = 2.0 / omega * (std::sqrt(1.0 + damping * damping) - damping);
  return result;
}

}  // namespace nugget::impact
