// SPDX-License-Identifier: Apache-2.0
#include "statics.hpp"

#include <Eigen/Sparse>
#include <algorithm>
#include <stdexcept>

#include "element_stiffness.hpp"
#include "kernel/element/belytschko_tsay.hpp"
#include "kernel/element/full_shell.hpp"
#include "kernel/law/elastic_kernel.hpp"
#include "one_element.hpp"
#include "system/shell_elements.hpp"

namespace nugget::verify {

Eigen::Matrix<double, 24, 24> shell_stiffness(ShellKind kind, const kernel::ShellProperties& shell,
                                              const kernel::Elastic& elastic, double thickness,
                                              const std::array<Vec3d, 4>& x) {
  const kernel::LawKernel<kernel::Elastic> law(elastic);
  const kernel::ShellLayout layout =
      kind == ShellKind::full ? kernel::full_shell_layout(shell, law) : kernel::shell_layout(shell, law);
  kernel::NodalMotion<double, 4> rest;
  std::copy(x.begin(), x.end(), rest.x);
  const std::vector<double> k = element_stiffness(rest, [&](const kernel::NodalMotion<double, 4>& motion, double step) {
    std::vector<double> state(static_cast<std::size_t>(layout.size()));
    kernel::start_shell(layout, thickness, state.data(), 1, 0);
    return one_element(motion, state, [&](const auto& all, double* store) {
      return kind == ShellKind::full ? kernel::full_shell_cycle(shell, law, all, step, store)
                                     : kernel::shell_cycle(shell, law, all, step, store);
    });
  });
  return Eigen::Map<const Eigen::Matrix<double, 24, 24, Eigen::RowMajor>>(k.data());
}

Statics::Statics(const kernel::Elastic& elastic, double t) : law(elastic), thickness(t) {
  shell.density = 1.0;
  shell.layers = kernel::gauss_layers(2);
  shell.shear_factor = 5.0 / 6.0;
  shell.warping_stiffness = true;
  shell.drilling = kernel::usual_drilling;
}

void Statics::add(const std::vector<Vec3d>& nodes, const std::vector<std::array<int, 4>>& elements) {
  x = nodes;
  shells = elements;
  force = Eigen::VectorXd::Zero(6 * static_cast<Eigen::Index>(x.size()));
}

void Statics::grid(int nu, int nv, const std::function<Vec3d(double, double)>& surface) {
  std::vector<Vec3d> nodes;
  std::vector<std::array<int, 4>> elements;
  for (int j = 0; j <= nv; ++j)
    for (int i = 0; i <= nu; ++i) nodes.push_back(surface(static_cast<double>(i) / nu, static_cast<double>(j) / nv));
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i) {
      const int a = i + j * (nu + 1), b = a + nu + 1;
      elements.push_back({a, a + 1, b + 1, b});
    }
  add(nodes, elements);
}

std::array<Vec3d, 4> Statics::places(std::size_t e) const {
  std::array<Vec3d, 4> place;
  for (std::size_t a = 0; a < 4; ++a) place[a] = x[shells[e][a]];
  return place;
}

void Statics::distribute(const Vec3d& pressure) {
  for (std::size_t e = 0; e < shells.size(); ++e) {
    const double quarter = 0.25 * kernel::shell_area(places(e));
    for (int node : shells[e]) {
      load(node, 0, quarter * pressure.x);
      load(node, 1, quarter * pressure.y);
      load(node, 2, quarter * pressure.z);
    }
  }
}

std::vector<std::array<double, 6>> Statics::stresses(const Eigen::VectorXd& u, std::size_t e) const {
  // A step so small that it moves nothing.
  constexpr double small = 0x1p-60;
  const kernel::LawKernel<kernel::Elastic> prepared(law);
  const kernel::ShellLayout layout =
      kind == ShellKind::full ? kernel::full_shell_layout(shell, prepared) : kernel::shell_layout(shell, prepared);
  std::vector<double> state(static_cast<std::size_t>(layout.size()));
  kernel::start_shell(layout, thickness, state.data(), 1, 0);
  kernel::NodalMotion<double, 4> nodes;
  const std::array<Vec3d, 4> place = places(e);
  for (int a = 0; a < 4; ++a) {
    const auto first = 6 * shells[e][a];
    nodes.x[a] = place[a];
    nodes.v[a] = {u(first), u(first + 1), u(first + 2)};
    nodes.w[a] = {u(first + 3), u(first + 4), u(first + 5)};
  }
  one_element(nodes, state, [&](const auto& all, double* store) {
    return kind == ShellKind::full ? kernel::full_shell_cycle(shell, prepared, all, small, store)
                                   : kernel::shell_cycle(shell, prepared, all, small, store);
  });
  std::vector<std::array<double, 6>> all;
  for (int column = 0; column < layout.columns; ++column)
    for (int k = 0; k < layout.layers; ++k) {
      const double* s = &state[layout.layer(k, column)];
      all.push_back(system::global_stress(kernel::shell_frame(place), s[0] / small, s[1] / small, s[2] / small,
                                          s[3] / small, s[4] / small));
    }
  return all;
}

void Statics::hold(int node, std::initializer_list<int> dofs, double value) {
  for (int dof : dofs) held_.emplace_back(6 * node + dof, value);
}

Eigen::VectorXd Statics::solve() const {
  const Eigen::Index all = force.size();
  Eigen::VectorXd u = Eigen::VectorXd::Zero(all);
  std::vector<int> free(static_cast<std::size_t>(all), 0);
  for (const auto& [dof, value] : held_) {
    free[dof] = -1;
    u(dof) = value;
  }
  int count = 0;
  for (int& f : free)
    if (f == 0) f = count++;
  Eigen::VectorXd right(count);
  for (std::size_t i = 0; i < free.size(); ++i)
    if (free[i] >= 0) right(free[i]) = force(static_cast<Eigen::Index>(i));

  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t e = 0; e < shells.size(); ++e) {
    const auto& nodes = shells[e];
    auto k = shell_stiffness(kind, shell, law, thickness, places(e));
    if (kind == ShellKind::one_point)
      for (int r = 0; r < 24; ++r)
        if (r % 6 > 2) k(r, r) += 1e-6 * k.block<3, 3>(3, 3).trace();
    for (int r = 0; r < 24; ++r) {
      const int i = 6 * nodes[r / 6] + r % 6, row = free[i];
      if (row < 0) continue;
      for (int c = 0; c < 24; ++c) {
        const int j = 6 * nodes[c / 6] + c % 6, column = free[j];
        if (column < 0)
          right(row) -= k(r, c) * u(j);
        else
          entries.emplace_back(row, column, k(r, c));
      }
    }
  }
  Eigen::SparseMatrix<double> k(count, count);
  k.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(k);
  if (factors.info() != Eigen::Success) throw std::runtime_error("singular stiffness: the model is not held");
  const Eigen::VectorXd solution = factors.solve(right);
  for (std::size_t i = 0; i < free.size(); ++i)
    if (free[i] >= 0) u(static_cast<Eigen::Index>(i)) = solution(free[i]);
  return u;
}

}  // namespace nugget::verify
