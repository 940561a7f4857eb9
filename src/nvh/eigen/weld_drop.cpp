// SPDX-License-Identifier: Apache-2.0
#include "nvh/eigen/weld_drop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "nvh/matrices/dense.hpp"
#include "nvh/matrices/dof_map.hpp"
#include "nvh/matrices/nodal.hpp"

namespace nugget::nvh {
namespace {

/// Stiffness and mass of some welds, in the unknowns that they reach.
class Taken {
 public:
  Taken(const Matrices& m, const WeldGroup& group) : m_(m) {
    each_element(group, [&](const system::ElementGroup& elements, std::size_t e) {
      const system::ElementNodes node = elements.nodes(e);
      const DofMap dof_map(m_.equations, {node.data(), at(elements.nodes_per_element)}, 6);
      equation_.insert(equation_.end(), dof_map.equations().begin(), dof_map.equations().end());
    });
    std::sort(equation_.begin(), equation_.end());
    equation_.erase(std::unique(equation_.begin(), equation_.end()), equation_.end());
    stiffness_ = mass_ = Columns(equation_.size(), equation_.size());
    each_element(group, [&](const system::ElementGroup& elements, std::size_t e) { add(elements, e); });
    load_ = Columns(equation_.size(), 0);
    if (equation_.empty()) return;
    Columns vector = stiffness_;
    const std::vector<double> value = diagonalize(vector);
    const double most = std::max(std::abs(value.front()), std::abs(value.back()));
    for (std::size_t i = 0; i < value.size(); ++i)
      if (std::abs(value[i]) > 1e-10 * most) {  // negative where a weld is pressed
        load_.value.insert(load_.value.end(), vector[i].begin(), vector[i].end());
        ++load_.count;
      }
  }

  /// How many independent loads the welds can transmit, the directions in which K_w resists; and they.
  std::size_t loads() const { return load_.count; }
  void put_loads(Columns& b, std::size_t first) const {
    for (std::size_t j = 0; j < load_.count; ++j)
      for (std::size_t i = 0; i < equation_.size(); ++i) b[first + j][equation_[i]] = load_[j][i];
  }
  Columns rows(const Columns& v) const {
    Columns r(equation_.size(), v.count);
    for (std::size_t j = 0; j < v.count; ++j)
      for (std::size_t i = 0; i < equation_.size(); ++i) r[j][i] = v[j][equation_[i]];
    return r;
  }
  const Columns& stiffness() const { return stiffness_; }
  const Columns& mass() const { return mass_; }

 private:
  template <class Visit>
  void each_element(const WeldGroup& group, const Visit& visit) const {
    for (const std::size_t w : group) {
      const weld::Weld& weld = m_.system.ties.welds[w];
      for (const model::Index element : weld.elements) {
        const system::System::ElementLocation location = m_.system.location_of(weld, element);
        if (location.group >= 0) visit(*m_.system.groups[location.group], at(location.element));
      }
    }
  }
  void add(const system::ElementGroup& elements, std::size_t e) {
    const system::ElementNodes all = elements.nodes(e);
    const std::span<const int> nodes(all.data(), at(elements.nodes_per_element));
    add(DofMap(m_.equations, nodes, elements.freedoms()), tangent_stiffness(m_, elements, e), stiffness_);
    for (std::size_t a = 0; a < nodes.size(); ++a)
      if (!m_.nodal_mass[nodes[a]].none())  // else a rigid body with a given mass has swallowed it
        add(DofMap(m_.equations, {&nodes[a], 1}, 6), mass_matrix(nodal_share(m_.system, elements, e, a, m_.rest)),
            mass_);
  }
  void add(const DofMap& dof_map, std::span<const double> k, Columns& into) const {
    const std::vector<double> q = dof_map.reduced(k);
    const std::size_t n = dof_map.equations().size();
    std::vector<std::size_t> place;
    for (const int eq : dof_map.equations())
      place.push_back(
          static_cast<std::size_t>(std::lower_bound(equation_.begin(), equation_.end(), eq) - equation_.begin()));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) into[place[j]][place[i]] += 0.5 * (q[i * n + j] + q[j * n + i]);
  }

  const Matrices& m_;
  std::vector<int> equation_;
  Columns stiffness_, mass_, load_;
};

Columns product(const Columns& a, const Columns& b) {
  Columns c(a.rows, b.count);
  add_product(1.0, a, a.count, b, 0.0, c);
  return c;
}

/// v^t a v.
Columns projected(const Columns& a, const Columns& v) {
  return inner(v, v.count, product(a, v));
}

/// Columns that make G the unit matrix, turn^t G turn = 1, without the directions in which G is next to nothing.
Columns whitening(Columns g, double least) {
  if (g.count == 0) return g;
  const std::vector<double> d = diagonalize(g);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < d.size(); ++i)
    if (d[i] > least * d.back()) kept.push_back(i);
  Columns turn(g.rows, kept.size());
  for (std::size_t j = 0; j < kept.size(); ++j)
    for (std::size_t i = 0; i < g.rows; ++i) turn[j][i] = g[kept[j]][i] / std::sqrt(d[kept[j]]);
  return turn;
}

Columns side_by_side(const Columns& a, const Columns& b) {
  Columns c(a.rows, a.count + b.count);
  std::copy(a.value.begin(), a.value.end(), c.value.begin());
  std::copy(b.value.begin(), b.value.end(), c.value.begin() + static_cast<std::ptrdiff_t>(a.value.size()));
  return c;
}

/// Takes the modes out of static answers, and scales them to unit mass.
void make_orthogonal(const Matrices& m, const Modes& modes, Columns& x) {
  Columns momentum(x.rows, x.count);
  for (int pass = 0; pass < 2; ++pass) {  // once more against round-off
    multiply(m.mass, x, momentum);
    add_product(-1.0, modes.shape, modes.shape.count, inner(modes.shape, modes.shape.count, momentum), 1.0, x);
  }
  for (std::size_t j = 0; j < x.count; ++j) {
    const double mass = m.mass.quadratic(x[j]);
    for (double& v : x[j]) v *= mass > 0.0 ? 1.0 / std::sqrt(mass) : 0.0;
  }
}

/// `x`: answers to the loads that the welds can transmit, without their share in the modes.
WeldDrop without(const Matrices& m, const Modes& modes, const Taken& taken, const Columns& x) {
  const std::size_t known = modes.eigenvalue.size();
  Columns product_of(x.rows, x.count);
  multiply(m.mass, x, product_of);
  const Columns turn = whitening(inner(x, x.count, product_of), 1e-12);
  multiply(m.stiffness, x, product_of);
  const Columns stiff = projected(inner(x, x.count, product_of), turn);

  // K and M in the basis of modes and answers, before and after.
  const Columns basis = side_by_side(taken.rows(modes.shape), product(taken.rows(x), turn));
  Columns k = projected(taken.stiffness(), basis), less = projected(taken.mass(), basis);
  WeldDrop drop;
  for (std::size_t i = 0; i < known; ++i)
    drop.first_order.push_back(modes.eigenvalue[i] * (1.0 + less[i][i]) - k[i][i]);
  for (double& v : k.value) v = -v;
  for (double& v : less.value) v = -v;
  for (std::size_t i = 0; i < basis.count; ++i) less[i][i] += 1.0;
  for (std::size_t i = 0; i < known; ++i) k[i][i] += modes.eigenvalue[i];
  for (std::size_t i = 0; i < stiff.count; ++i)
    for (std::size_t j = 0; j < stiff.count; ++j) k[known + i][known + j] += stiff[i][j];

  const Columns white = whitening(less, 1e-10);
  Columns y = projected(k, white);
  const std::vector<double> value = diagonalize(y);
  const Columns c = product(white, y);
  Columns mac(c.count, known);
  for (std::size_t j = 0; j < c.count; ++j) {
    double length = 0.0;
    for (const double v : c[j]) length += v * v;
    for (std::size_t i = 0; i < known; ++i) mac[i][j] = c[j][i] * c[j][i] / length;
  }
  const std::vector<int> partner = partners(mac);
  std::vector<char> known_shape(value.size(), 0);
  for (std::size_t i = 0; i < known; ++i) {
    const std::size_t j = at(partner[i]);
    drop.eigenvalue.push_back(value[j]);
    drop.mac.push_back(mac[i][j]);
    known_shape[j] = mac[i][j] >= same_mode_mac;
  }
  for (std::size_t j = 0; j < value.size(); ++j)
    if (!known_shape[j] && value[j] < modes.eigenvalue.back()) drop.new_modes.push_back(value[j]);
  return drop;
}

}  // namespace

bool can_drop(const system::System& system, std::size_t weld) {
  const weld::Weld& w = system.ties.welds[weld];
  return w.kind != weld::Weld::Kind::rigid && !w.deleted && system.location_of(w, w.element).group >= 0;
}

std::vector<WeldDrop> drop_welds(const Matrices& m, const Modes& modes, const std::vector<WeldGroup>& groups,
                                 const ProgressCallback& progress) {
  constexpr std::size_t columns_per_solve = 48;  // right-hand sides, about
  std::vector<WeldDrop> drops;
  if (groups.empty() || modes.eigenvalue.empty()) return drops;
  if (progress) progress(fmt::format("factorization for {} welds", groups.size()));
  const Factorization factor(m, small_shift(m));
  while (drops.size() < groups.size()) {
    std::vector<Taken> taken;
    std::vector<std::size_t> first{0};
    while (first.back() < columns_per_solve && drops.size() + taken.size() < groups.size()) {
      taken.emplace_back(m, groups[drops.size() + taken.size()]);
      first.push_back(first.back() + taken.back().loads());
    }
    Columns all(m.size(), first.back());
    for (std::size_t g = 0; g < taken.size(); ++g) taken[g].put_loads(all, first[g]);
    // Static answers to those loads, and to the inertia of these answers: two terms of the series in omega^2.
    Columns again(m.size(), all.count);
    if (all.count > 0) {
      factor.solve(all);
      make_orthogonal(m, modes, all);
      multiply(m.mass, all, again);
      factor.solve(again);
      make_orthogonal(m, modes, again);
    }
    for (std::size_t g = 0; g < taken.size(); ++g) {
      const auto part = [&](const Columns& whole) {
        Columns c(whole.rows, taken[g].loads());
        std::copy_n(whole.value.data() + first[g] * whole.rows, c.value.size(), c.value.data());
        return c;
      };
      drops.push_back(without(m, modes, taken[g], side_by_side(part(all), part(again))));
    }
    if (progress) progress(fmt::format("{} of {} welds", drops.size(), groups.size()));
  }
  return drops;
}

}  // namespace nugget::nvh
