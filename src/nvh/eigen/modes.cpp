// SPDX-License-Identifier: Apache-2.0
#include "nvh/eigen/modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "nvh/eigen/mode_search.hpp"

namespace nugget::nvh {
namespace {

void find_participation(const Matrices& m, Modes& modes) {
  double mass = 0.0;
  Vec3d moment{};
  const auto place = [&](std::size_t k) { return m.place(k); };
  for (std::size_t k = 0; k < m.nodal_mass.size(); ++k) {
    mass += m.nodal_mass[k].mass;
    moment += m.nodal_mass[k].mass * place(k);
  }
  if (mass > 0.0) modes.centre = (1.0 / mass) * moment;
  const auto momentum = [&](std::size_t k, const SixDof& u) {  // of a node's motion: linear, and about the centre
    const SixDof own = m.nodal_mass[k].momentum(u);
    const Vec3d p{own[0], own[1], own[2]};
    const Vec3d l = cross(place(k) - modes.centre, p) + Vec3d{own[3], own[4], own[5]};
    return SixDof{p.x, p.y, p.z, l.x, l.y, l.z};
  };
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < m.nodal_mass.size(); ++k) {
      Vec3d spin{i == 3 ? 1.0 : 0.0, i == 4 ? 1.0 : 0.0, i == 5 ? 1.0 : 0.0};
      const Vec3d v = i < 3 ? Vec3d{i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0}
                            : cross(spin, place(k) - modes.centre);
      modes.total[i] += momentum(k, {v.x, v.y, v.z, spin.x, spin.y, spin.z})[i];
    }
  modes.participation.assign(modes.eigenvalue.size(), SixDof{});
  parallel_for(modes.eigenvalue.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t mode = begin; mode < end; ++mode)
      for (std::size_t k = 0; k < m.nodal_mass.size(); ++k) {
        if (m.nodal_mass[k].none()) continue;
        const SixDof p = momentum(k, m.equations.motion(static_cast<int>(k), modes.shape[mode]));
        for (std::size_t i = 0; i < 6; ++i) modes.participation[mode][i] += p[i];
      }
  });
}

/// The largest entry of each shape is positive, so that equal decks give equal signs.
void fix_signs(Columns& shape) {
  for (std::size_t j = 0; j < shape.count; ++j) {
    const std::span<double> x = shape[j];
    double largest = 0.0;
    for (const double v : x)
      if (std::abs(v) > std::abs(largest) * (1.0 + 1e-6)) largest = v;
    if (largest < 0.0)
      for (double& v : x) v = -v;
  }
}

/// By group and element the weld that it is, or is a part of; the number of welds: none. Rigid welds have no elements.
std::vector<std::vector<std::size_t>> welds_of_elements(const system::System& system) {
  const std::vector<weld::Weld>& welds = system.ties.welds;
  std::vector<std::vector<std::size_t>> weld_of;
  for (const auto& group : system.groups) weld_of.emplace_back(group->size(), welds.size());
  for (std::size_t w = 0; w < welds.size(); ++w) {
    if (welds[w].kind == weld::Weld::Kind::rigid) continue;
    for (const model::Index element : welds[w].elements)
      if (const auto location = system.location_of(welds[w], element); location.group >= 0)
        weld_of[at(location.group)][at(location.element)] = w;
  }
  return weld_of;
}

}  // namespace

double small_shift(const Matrices& m) {
  Vec3d low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (std::size_t k = 0; k < m.system.nodes; ++k) {
    const Vec3d x = vec(m.rest.x[k]);
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
  const double size = norm(high - low);
  double speed2 = 0.0, thickness = size;
  for (const auto& group : m.system.groups) {
    const model::Material& material = m.system.model.materials[m.system.model.parts[group->part].material];
    if (material.density > 0.0) speed2 = std::max(speed2, material.young() / material.density);
    if (group->kind != model::ElementKind::shell) continue;
    for (std::size_t e = 0; e < group->size(); ++e) thickness = std::min(thickness, group->thickness(e));
  }
  if (!(size > 0.0) || !(speed2 > 0.0)) {  // springs or adhesive alone
    double highest = 0.0;
    for (std::size_t i = 0; i < m.size(); ++i)
      if (m.mass.diagonal(i) > 0.0) highest = std::max(highest, m.stiffness.diagonal(i) / m.mass.diagonal(i));
    return highest > 0.0 ? 1e-6 * highest : 1.0;
  }
  for (const double side : {high.x - low.x, high.y - low.y, high.z - low.z})
    if (side > 1e-6 * size) thickness = std::min(thickness, side);
  const double slenderness = std::max(thickness / size, 1e-4);
  return speed2 / (size * size) * slenderness * slenderness;
}

double Modes::frequency(std::size_t i) const {
  return frequency_of(eigenvalue[i]);
}

bool Modes::elastic(std::size_t i) const {
  return eigenvalue[i] > 1e-9 * eigenvalue.back();
}

void report_fixed_motions(const Equations& equations, const model::Model& model, Findings& findings) {
  const auto held =
      std::count_if(equations.supports().begin(), equations.supports().end(), [](const Equations::Support& s) {
        return s.source == Equations::Support::Source::motion && dot(s.taken, s.taken) > 0.0;
      });
  if (held > 0)
    findings.note(
        {model.deck, 0, 0}, "*BOUNDARY_PRESCRIBED_MOTION",
        fmt::format("{} directions of nodes are prescribed; modes are those of the structure held there", held));
}

Modes find_modes(const Matrices& m, const ModeRequest& r, const ProgressCallback& progress) {
  Modes modes;
  Eigenpairs p;
  if (m.size() > 0) p = search_modes(m, r, progress, modes);
  modes.eigenvalue = std::move(p.value);
  modes.shape = std::move(p.vector);
  fix_signs(modes.shape);
  find_participation(m, modes);
  return modes;
}

EnergyShares energy_shares(const Matrices& m, const Modes& modes) {
  const system::System& system = m.system;
  const std::size_t count = modes.eigenvalue.size();
  EnergyShares shares{Columns(system.model.parts.size(), count), Columns(system.ties.welds.size(), count)};
  std::vector<double> whole(count, 0.0);  // omega^2 / 2, but for the work of preloads
  const std::vector<std::vector<std::size_t>> weld_of = welds_of_elements(system);
  for (std::size_t g = 0; g < system.groups.size(); ++g) {
    const auto& group = system.groups[g];
    std::vector<std::vector<double>> energies(group->size());
    parallel_for(group->size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e)
        if (group->alive(e)) energies[e] = m.element_energies(*group, e, modes.shape);
    });
    for (std::size_t e = 0; e < group->size(); ++e) {
      if (!group->alive(e)) continue;
      for (std::size_t mode = 0; mode < count; ++mode) {
        if (!modes.elastic(mode)) continue;
        whole[mode] += energies[e][mode];
        shares.part[mode][group->part] += energies[e][mode];
        if (const std::size_t w = weld_of[g][e]; w < system.ties.welds.size())
          shares.weld[mode][w] += energies[e][mode];
      }
    }
  }
  for (const BodyLink& link : m.links)  // what joints hold is no part's
    for (std::size_t mode = 0; mode < count; ++mode) {
      if (!modes.elastic(mode)) continue;
      ConstrainedMotion::Row motion;
      for (std::size_t i = 0; i < 12; ++i) motion[i] = m.equations.motion(link.node[i / 6], modes.shape[mode])[i % 6];
      whole[mode] += link.energy(motion);
    }
  for (Columns* share : {&shares.part, &shares.weld})
    for (std::size_t mode = 0; mode < count; ++mode)
      for (double& v : (*share)[mode]) v *= whole[mode] > 0.0 ? 1.0 / whole[mode] : 0.0;
  return shares;
}

Columns compute_mac(const Columns& a, const Columns& b) {
  const auto product = [](std::span<const double> x, std::span<const double> y) {
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
    return sum;
  };
  Columns mac(b.count, a.count);
  for (std::size_t i = 0; i < a.count; ++i)
    for (std::size_t j = 0; j < b.count; ++j) {
      const double ab = product(a[i], b[j]), aa = product(a[i], a[i]), bb = product(b[j], b[j]);
      mac[i][j] = aa > 0.0 && bb > 0.0 ? ab * ab / (aa * bb) : 0.0;
    }
  return mac;
}

std::vector<int> partners(const Columns& mac) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  // column, row
  for (std::size_t i = 0; i < mac.count; ++i)
    for (std::size_t j = 0; j < mac.rows; ++j) pairs.emplace_back(i, j);
  std::stable_sort(pairs.begin(), pairs.end(),
                   [&](const auto& a, const auto& b) { return mac[a.first][a.second] > mac[b.first][b.second]; });
  std::vector<int> partner(mac.count, -1);
  std::vector<char> taken(mac.rows, 0);
  for (const auto& [i, j] : pairs) {
    if (partner[i] >= 0 || taken[j]) continue;
    partner[i] = static_cast<int>(j);
    taken[j] = 1;
  }
  return partner;
}

}  // namespace nugget::nvh
