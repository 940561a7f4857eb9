// SPDX-License-Identifier: Apache-2.0
#include "system/element_group.hpp"

#include <algorithm>

#include "base/batch.hpp"

namespace nugget::system {

void ElementGroup::take_physical_mass_scale(std::size_t e, double physical) {
  if (physical_mass_scale_.empty()) {
    if (physical == 1.0) return;
    physical_mass_scale_.assign(size(), 1.0);
  }
  physical_mass_scale_[e] = physical;
}

double ElementGroup::wanted_mass_scale(std::size_t e) {
  const double step = stable_step(e), now = mass_scale(e);
  const auto raised = [&](double scale, double target) {
    const double own = scale == now ? step : step * std::sqrt(scale / now);
    return own < target * (1.0 - 1e-9) ? scale * (target / own) * (target / own) : scale;
  };
  double wanted = now;
  if (physical_mass_step > 0.0) {
    if (physical_mass_scale_.empty()) physical_mass_scale_.assign(size(), 1.0);
    double& physical = physical_mass_scale_[e];
    physical = raised(physical, physical_mass_step);
    wanted = std::max(now, physical);
  }
  return raised(wanted, mass_step);
}

void ElementGroup::stiffness(std::size_t e, const State& start, std::span<double> k) const {
  own_stiffness(e, start, k);
  const auto change = softening_.find(e);
  if (change == softening_.end()) return;
  for (std::size_t i = 0; i < k.size(); ++i) k[i] += change->second[i];
}

void ElementGroup::vibrate(std::size_t b, const State& now, std::span<const Row> v, std::span<const Row> w, double dt,
                           std::span<Row> forces) const {
  const std::size_t nodes_of_one = at(nodes_per_element), per_node = at(freedoms()),
                    size_of_one = nodes_of_one * per_node;
  std::vector<double> k(size_of_one * size_of_one), c(k.size()), u(size_of_one);
  std::fill(forces.begin(), forces.end(), Row{});
  const std::size_t first = b * block_width();
  for (std::size_t e = first; e < std::min(size(), first + block_width()); ++e) {
    if (!alive(e)) continue;
    stiffness(e, now, k);
    const bool viscous = viscosity(e, now, c);
    const ElementNodes node = nodes(e);
    for (std::size_t a = 0; a < nodes_of_one; ++a) {
      const Vec3d velocity = node[a] >= 0 ? vec(v[node[a]]) : Vec3d{};
      const Vec3d spin = rotational && node[a] >= 0 ? vec(w[node[a]]) : Vec3d{};
      const std::array<double, 6> all{velocity.x, velocity.y, velocity.z, spin.x, spin.y, spin.z};
      std::copy_n(all.begin(), per_node, u.begin() + static_cast<std::ptrdiff_t>(a * per_node));
    }
    for (std::size_t a = 0; a < nodes_of_one; ++a) {
      std::array<double, 6> f{};
      for (std::size_t i = 0; i < per_node; ++i)
        for (std::size_t j = 0; j < size_of_one; ++j) {
          const std::size_t place = (a * per_node + i) * size_of_one + j;
          f[i] += (0.5 * dt * k[place] + (viscous ? c[place] : 0.0)) * u[j];
        }
      Row* row = &forces[row_in_block(e, a)];
      set(row[0], {f[0], f[1], f[2]});
      if (rotational) set(row[1], {f[3], f[4], f[5]});
    }
  }
}

int elements_at_a_time() {
  return native_width;
}

void ElementGroup::archive(Archive& a) {
  a(deletions, inverted, step_share, period, physical_mass_scale_);
  a.built(block_step, kind, part, element, nodes_per_element, weld, rotational, first_slot, single_slots, damping_share,
          damping_time, damping_stiffness_ratio, mass_step, physical_mass_step, softening_, holders);
}

}  // namespace nugget::system
