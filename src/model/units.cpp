// SPDX-License-Identifier: Apache-2.0
#include "model/units.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace nugget::model {
namespace {

constexpr std::array<Units, 8> systems{{
    {"mm, t, s", 1.0, 7.85e-9, 2.1e5, 1.0, 1e-6},
    {"mm, kg, ms", 1.0, 7.85e-6, 2.1e2, 1e-3, 1e-3},
    {"mm, g, ms", 1.0, 7.85e-3, 2.1e5, 1.0, 1e-3},
    {"mm, kg, s", 1.0, 7.85e-6, 2.1e8, 1e3, 1e-6},
    {"m, kg, s", 1e-3, 7.85e3, 2.1e11, 1.0, 1e-6},
    {"cm, g, us", 0.1, 7.85, 2.1, 1e-7, 1.0},
    {"cm, g, s", 0.1, 7.85, 2.1e12, 1e5, 1e-6},
    {"in, lbf s2/in, s", 1.0 / 25.4, 7.35e-4, 3.05e7, 1.0 / 4.4482216, 1e-6},
}};

bool is_metal(const Units& units, double density, double young) {
  return density > 0.2 * units.density && density < 2.5 * units.density && young > 0.15 * units.young &&
         young < 2.0 * units.young;
}

}  // namespace

std::optional<Units> recognise_units(const Model& model) {
  std::vector<std::size_t> shells(model.parts.size(), 0);
  for (const Index part : model.shells.part) ++shells[part];
  std::array<std::size_t, systems.size()> votes{};
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    if (shells[p] == 0 || model.parts[p].material == none) continue;
    const Material& material = model.materials[model.parts[p].material];
    for (std::size_t s = 0; s < systems.size(); ++s)
      if (is_metal(systems[s], material.density, material.young())) votes[s] += shells[p];
  }
  // Without a sheet whose material is known, whatever metal there is decides, each material once.
  if (std::count(votes.begin(), votes.end(), std::size_t{0}) == static_cast<std::ptrdiff_t>(votes.size()))
    for (const Material& material : model.materials)
      for (std::size_t s = 0; s < systems.size(); ++s)
        votes[s] += is_metal(systems[s], material.density, material.young());
  const auto most = std::max_element(votes.begin(), votes.end());
  if (*most == 0) return std::nullopt;
  return systems[static_cast<std::size_t>(most - votes.begin())];
}

}  // namespace nugget::model
