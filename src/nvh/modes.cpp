// SPDX-License-Identifier: Apache-2.0
#include "nvh/modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/index.hpp"
#include "base/parallel.hpp"

namespace nugget::nvh {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

double squared(double frequency) {
  return two_pi * frequency * two_pi * frequency;
}

class Search {
 public:
  Search(const Matrices& m, const Tell& tell, Modes& modes) : m_(m), tell_(tell), modes_(modes) {}

  /// K - lambda M.
  Factorization factor(double lambda) {
    tell(fmt::format("factorization {} of {} equations", modes_.cost.factorizations + 1, m_.size()));
    for (double nudge = 1e-7;; nudge *= 10.0) {
      try {
        Factorization f(m_, -lambda);
        ++modes_.cost.factorizations;
        modes_.cost.factor_seconds += f.cost().seconds;
        modes_.cost.factor_entries = f.cost().entries;
        return f;
      } catch (const Factorization::SolverError&) {
        if (lambda <= 0.0 || nudge > 1e-4) throw;
        lambda *= 1.0 + nudge;  // an eigenvalue was hit
      }
    }
  }
  Eigenpairs nearest(const Factorization& f, int count) {
    const auto begin = std::chrono::steady_clock::now();
    Eigenpairs p = nvh::nearest(m_, f, count, [&](int done) { tell(fmt::format("{} of {} modes", done, count)); });
    modes_.cost.lanczos_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    modes_.cost.solves += p.solves;
    return p;
  }
  int below(double lambda) { return factor(lambda).negative(); }
  void tell(const std::string& text) const {
    if (tell_) tell_(text);
  }

 private:
  const Matrices& m_;
  const Tell& tell_;
  Modes& modes_;
};

/// Drops the last pairs of a cluster that the count would cut in two, and those beyond `keep`.
void cut(Eigenpairs& p, std::size_t keep) {
  keep = std::min(keep, p.value.size());
  p.value.resize(keep);
  p.vector.count = keep;
  p.vector.value.resize(keep * p.vector.rows);
}

/// A place between the last mode kept and the first one left out where counting is safe.
double between(const std::vector<double>& value, std::size_t keep, double scale) {
  const double last = keep > 0 ? value[keep - 1] : 0.0;
  const double next = keep < value.size() ? value[keep] : last + 1e-3 * std::abs(last) + scale;
  return 0.5 * (last + next);
}

/// Pairs that are wanted plus one, so that the place to count at lies in a gap; where the next one belongs to the
/// cluster of the last (double modes of square plates) the cluster is completed.
Eigenpairs lowest(Search& search, const Factorization& f, std::size_t want, std::size_t n) {
  for (std::size_t more = 1;; more += 3) {
    Eigenpairs p = search.nearest(f, static_cast<int>(std::min(want + more, n)));
    const std::size_t have = p.value.size();
    if (have <= want || have == n) return p;
    const double gap = 1e-6 * (std::abs(p.value.back()) + f.shift());
    if (more > 12 || p.value.back() - p.value[want - 1] > gap) return p;
  }
}

void find_lowest(Search& search, const Matrices& m, const ModeRequest& r, Modes& modes, Eigenpairs& p) {
  const double shift = small_shift(m);
  std::optional<Factorization> f = search.factor(-shift);
  std::size_t want = r.count > 0 ? at(r.count) : m.size();
  if (std::isfinite(r.high)) want = std::min(want, at(search.below(squared(r.high))));
  want = std::min(want, m.size());
  if (want == 0) return;
  p = lowest(search, *f, want, m.size());
  const int below_zero = f->negative();
  f.reset();  // counting needs a factor of its own; both at once would be the peak of memory
  // The mode after the wanted ones may be their twin: count behind the last that lies apart.
  std::size_t end = std::min(want, p.value.size());
  const double gap = 1e-6;
  while (end < p.value.size() && p.value[end] - p.value[end - 1] < gap * (std::abs(p.value[end]) + shift)) ++end;
  const double place = between(p.value, end, shift);
  modes.proof = {0.0, std::sqrt(std::max(0.0, place)) / two_pi, search.below(place) + below_zero,
                 static_cast<int>(end)};
  cut(p, want);
}

void find_inside(Search& search, const Matrices& m, const ModeRequest& r, Modes& modes, Eigenpairs& p) {
  const double low = squared(r.low), high = squared(r.high);
  const int first = search.below(low), last = search.below(high);
  modes.proof = {r.low, r.high, last - first, 0};
  if (last == first) return;
  // The nearest ones to the middle are exactly those inside.
  p = search.nearest(search.factor(0.5 * (low + high)), last - first);
  modes.proof.found =
      static_cast<int>(std::count_if(p.value.begin(), p.value.end(), [&](double v) { return v >= low && v <= high; }));
  if (r.count > 0) cut(p, at(r.count));
  static_cast<void>(m);
}

void find_above(Search& search, const Matrices& m, const ModeRequest& r, Modes& modes, Eigenpairs& p) {
  const double low = squared(r.low);
  const Factorization f = search.factor(low);
  const int before = f.negative();
  for (int take = r.count + 4;; take *= 2) {
    p = search.nearest(f, std::min(take, static_cast<int>(m.size())));
    const auto first = std::lower_bound(p.value.begin(), p.value.end(), -f.shift());
    const auto left_out = static_cast<std::size_t>(first - p.value.begin());
    if (p.value.size() - left_out <= at(r.count) && at(take) < m.size()) continue;
    p.vector.value.erase(p.vector.value.begin(),
                         p.vector.value.begin() + static_cast<std::ptrdiff_t>(left_out * p.vector.rows));
    p.value.erase(p.value.begin(), first);
    p.vector.count = p.value.size();
    break;
  }
  const std::size_t keep = std::min(at(r.count), p.value.size());
  const double place = between(p.value, keep, 1e-3 * low);
  cut(p, keep);
  modes.proof = {r.low, std::sqrt(place) / two_pi, search.below(place) - before, static_cast<int>(keep)};
}

void find_around(Search& search, const Matrices& m, const ModeRequest& r, Modes& modes, Eigenpairs& p) {
  const Factorization f = search.factor(squared(r.centre));
  p = search.nearest(f, std::min(r.count, static_cast<int>(m.size())));
  if (p.value.empty()) return;
  const double reach = std::max(std::abs(p.value.front() + f.shift()), std::abs(p.value.back() + f.shift()));
  const double low = -f.shift() - reach * (1.0 + 1e-6), high = -f.shift() + reach * (1.0 + 1e-6);
  modes.proof = {std::sqrt(std::max(0.0, low)) / two_pi, std::sqrt(high) / two_pi,
                 search.below(high) - search.below(low), static_cast<int>(p.value.size())};
}

void find_participation(const Matrices& m, Modes& modes) {
  double mass = 0.0;
  Vec3d moment{};
  const auto place = [&](std::size_t k) {
    return k < m.system.nodes ? vec(m.rest.x[k]) : m.system.bodies[k - m.system.nodes].center0;
  };
  for (std::size_t k = 0; k < m.nodal_mass.size(); ++k) {
    mass += m.nodal_mass[k].mass;
    moment += m.nodal_mass[k].mass * place(k);
  }
  if (mass > 0.0) modes.centre = (1.0 / mass) * moment;
  const auto momentum = [&](std::size_t k, const Six& u) {  // of a node's motion: linear, and about the centre
    const Six own = m.nodal_mass[k].momentum(u);
    const Vec3d p{own[0], own[1], own[2]};
    const Vec3d l = cross(place(k) - modes.centre, p) + Vec3d{own[3], own[4], own[5]};
    return Six{p.x, p.y, p.z, l.x, l.y, l.z};
  };
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < m.nodal_mass.size(); ++k) {
      Vec3d spin{i == 3 ? 1.0 : 0.0, i == 4 ? 1.0 : 0.0, i == 5 ? 1.0 : 0.0};
      const Vec3d v = i < 3 ? Vec3d{i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0}
                            : cross(spin, place(k) - modes.centre);
      modes.total[i] += momentum(k, {v.x, v.y, v.z, spin.x, spin.y, spin.z})[i];
    }
  modes.participation.assign(modes.eigenvalue.size(), Six{});
  parallel_for(modes.eigenvalue.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t mode = begin; mode < end; ++mode)
      for (std::size_t k = 0; k < m.nodal_mass.size(); ++k) {
        if (m.nodal_mass[k].none()) continue;
        const Six p = momentum(k, m.equations.motion(static_cast<int>(k), modes.shape[mode]));
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
    const model::Material& material = m.system.model.materials[at(m.system.model.parts[at(group->part)].material)];
    if (material.density > 0.0) speed2 = std::max(speed2, material.young() / material.density);
    if (group->kind != model::ElementKind::shell) continue;
    for (std::size_t e = 0; e < group->size(); ++e) thickness = std::min(thickness, group->thickness(e));
  }
  if (!(size > 0.0) || !(speed2 > 0.0)) return 1.0;
  for (const double side : {high.x - low.x, high.y - low.y, high.z - low.z})
    if (side > 1e-6 * size) thickness = std::min(thickness, side);
  const double slenderness = std::max(thickness / size, 1e-4);
  return speed2 / (size * size) * slenderness * slenderness;
}

double Modes::frequency(std::size_t i) const {
  return std::sqrt(std::max(0.0, eigenvalue[i])) / two_pi;
}

bool Modes::elastic(std::size_t i) const {
  return eigenvalue[i] > 1e-9 * eigenvalue.back();
}

void tell_held_motions(const Equations& equations, const model::Model& model, Findings& findings) {
  const auto held =
      std::count_if(equations.supports().begin(), equations.supports().end(), [](const Equations::Support& s) {
        return s.source == Equations::Support::Source::motion && dot(s.taken, s.taken) > 0.0;
      });
  if (held > 0)
    findings.note(
        {model.deck, 0, 0}, "*BOUNDARY_PRESCRIBED_MOTION",
        fmt::format("{} directions of nodes are prescribed; modes are those of the structure held there", held));
}

Modes find_modes(const Matrices& m, const ModeRequest& r, const Tell& tell) {
  Modes modes;
  Eigenpairs p;
  Search search(m, tell, modes);
  if (m.size() > 0) {
    if (r.centre > 0.0)
      find_around(search, m, r, modes, p);
    else if (r.low > 0.0 && std::isfinite(r.high))
      find_inside(search, m, r, modes, p);
    else if (r.low > 0.0)
      find_above(search, m, r, modes, p);
    else
      find_lowest(search, m, r, modes, p);
  }
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
  std::vector<std::size_t> weld_of(system.model.beams.size(), system.ties.welds.size());
  for (std::size_t w = 0; w < system.ties.welds.size(); ++w)
    if (system.ties.welds[w].kind == weld::Weld::Kind::beam) weld_of[at(system.ties.welds[w].element)] = w;
  for (const auto& group : system.groups) {
    std::vector<std::vector<double>> energies(group->size());
    parallel_for(group->size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e)
        if (group->alive(e)) energies[e] = m.element_energies(*group, e, modes.shape);
    });
    for (std::size_t e = 0; e < group->size(); ++e) {
      if (!group->alive(e)) continue;
      for (std::size_t mode = 0; mode < count; ++mode) {
        if (!modes.elastic(mode)) continue;
        // The strain energy of a mode is omega^2 / 2.
        const double share = energies[e][mode] / (0.5 * modes.eigenvalue[mode]);
        shares.part[mode][at(group->part)] += share;
        if (group->kind != model::ElementKind::beam) continue;
        const std::size_t w = weld_of[at(group->element[e])];
        if (w < system.ties.welds.size()) shares.weld[mode][w] += share;
      }
    }
  }
  return shares;
}

Columns assurance(const Columns& a, const Columns& b) {
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

std::vector<int> partners(const Columns& likeness) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  // column, row
  for (std::size_t i = 0; i < likeness.count; ++i)
    for (std::size_t j = 0; j < likeness.rows; ++j) pairs.emplace_back(i, j);
  std::stable_sort(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) {
    return likeness[a.first][a.second] > likeness[b.first][b.second];
  });
  std::vector<int> partner(likeness.count, -1);
  std::vector<char> taken(likeness.rows, 0);
  for (const auto& [i, j] : pairs) {
    if (partner[i] >= 0 || taken[j]) continue;
    partner[i] = static_cast<int>(j);
    taken[j] = 1;
  }
  return partner;
}

}  // namespace nugget::nvh
