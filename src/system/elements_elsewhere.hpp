// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

#include "base/archive.hpp"

namespace nugget::system {

/// What is known of those elements of a group whose states are not here: in a run over several ranks those that others
/// compute (docs/decisions/0133), and before ElementGroup::start all of them.
class ElementsElsewhere {
 public:
  /// What the energies of a body are summed up from.
  using Energies = std::array<double, 4>;  // alive, density scale, hourglass energy, work against bulk viscosity

  /// `e`: may be one of the places that fill up the last block.
  bool has(std::size_t e) const {
    const char* const is = is_.data();
    return is != nullptr && is[e] != here;
  }
  std::size_t count() const { return is_.size() - static_cast<std::size_t>(std::count(is_.begin(), is_.end(), here)); }

  /// Of `elements` in all, element e is elsewhere from now on.
  void put(std::size_t e, std::size_t elements, bool is_alive, double density_scale) {
    is_.resize(elements + most_padding, here);
    is_[e] = is_alive ? active : deleted;
    scale(e, density_scale);
  }
  /// States of elements [begin, end) have come.
  void take_out(std::size_t begin, std::size_t end) {
    if (is_.empty()) return;
    std::fill(is_.begin() + difference(std::min(begin, is_.size())),
              is_.begin() + difference(std::min(end, is_.size())), here);
    steps_.erase(steps_.lower_bound(begin), steps_.lower_bound(end));
  }

  bool alive(std::size_t e) const { return is_[e] == active; }
  void remove(std::size_t e) { is_[e] = deleted; }
  double scale(std::size_t e) const { return scale_.empty() ? 1.0 : scale_[e]; }
  void scale(std::size_t e, double factor) {
    if (scale_.empty() && factor == 1.0) return;
    scale_.resize(is_.size(), 1.0);
    scale_[e] = factor;
  }
  /// Infinite but of elements whose step others have to know.
  double step(std::size_t e) const {
    const auto known = steps_.find(e);
    return known != steps_.end() ? known->second : std::numeric_limits<double>::infinity();
  }
  void take_step(std::size_t e, double step) { steps_[e] = step; }
  void release_step(std::size_t e) { steps_.erase(e); }

  /// 0 before they were carried.
  double hourglass_energy(std::size_t e) const { return hourglass_.empty() ? 0.0 : hourglass_[e]; }
  double bulk_viscosity_work(std::size_t e) const { return bulk_.empty() ? 0.0 : bulk_[e]; }
  void take(std::size_t e, const Energies& energies) {
    is_[e] = energies[0] != 0.0 ? active : deleted;
    scale(e, energies[1]);
    const auto keep = [&](std::vector<double>& list, double value) {
      if (list.empty() && value == 0.0) return;
      list.resize(is_.size(), 0.0);
      list[e] = value;
    };
    keep(hourglass_, energies[2]);
    keep(bulk_, energies[3]);
  }

 private:
  enum Where : char { here, active, deleted };
  static constexpr std::size_t most_padding = 64;
  static std::ptrdiff_t difference(std::size_t n) { return static_cast<std::ptrdiff_t>(n); }

  std::vector<char> is_;       ///< Where, by element; never filled: all are here
  std::vector<double> scale_;  ///< factor on the density by mass scaling; empty: 1
  std::map<std::size_t, double> steps_;
  std::vector<double> hourglass_, bulk_;  ///< empty: 0
};

/// What is known of elements of a group whose states are elsewhere: all ranks know it of all.
template <class Group>
void archive_known(Archive& a, const Group& group, ElementsElsewhere& elsewhere) {
  std::vector<char> active(group.size());
  std::vector<double> scale;
  for (std::size_t e = 0; e < active.size(); ++e) {
    active[e] = group.alive(e);
    if (group.mass_scale(e) != 1.0) scale.resize(active.size(), 1.0);
    if (!scale.empty()) scale[e] = group.mass_scale(e);
  }
  a(active, scale);
  for (std::size_t e = 0; a.reading() && e < active.size(); ++e)
    if (elsewhere.has(e)) elsewhere.put(e, active.size(), active[e] != 0, scale.empty() ? 1.0 : scale[e]);
}

}  // namespace nugget::system
