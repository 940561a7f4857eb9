// SPDX-License-Identifier: Apache-2.0
#include "model/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

namespace nugget::model {
namespace {

constexpr double inch = 25.4, foot = 304.8, pound_force = 4.4482216;  // in millimetres and newtons

constexpr std::array<Units, 10> systems{{
    {"mm, t, s", "N", "MPa", "mm t s (N, MPa)", 1.0, 1e-6, 1.0, 1e3, 1e-12, 7.85e-9, 2.1e5},
    {"m, kg, s", "N", "Pa", "m kg s (N, Pa)", 1e-3, 1e-6, 1.0, 1.0, 1.0, 7.85e3, 2.1e11},
    {"mm, kg, ms", "kN", "GPa", "mm kg ms (kN, GPa)", 1.0, 1e-3, 1e-3, 1.0, 1e-9, 7.85e-6, 2.1e2},
    {"mm, g, ms", "N", "MPa", "mm g ms (N, MPa)", 1.0, 1e-3, 1.0, 1.0, 1e-6, 7.85e-3, 2.1e5},
    {"mm, kg, s", "mN", "kPa", "mm kg s (mN, kPa)", 1.0, 1e-6, 1e3, 1e3, 1e-9, 7.85e-6, 2.1e8},
    {"cm, g, us", "1e7 N", "Mbar", "cm g us (Mbar)", 0.1, 1.0, 1e-7, 1e-4, 1e-3, 7.85, 2.1},
    {"mm, mg, us", "kN", "GPa", "mm mg us (kN, GPa)", 1.0, 1.0, 1e-3, 1e-3, 1e-3, 7.85, 2.1e2},
    {"cm, g, s", "dyn", "dyn/cm2", "cm g s (dyn)", 0.1, 1e-6, 1e5, 1e2, 1e-3, 7.85, 2.1e12},
    {"in, lbf s2/in, s", "lbf", "psi", "in lbf s (psi)", 1.0 / inch, 1e-6, 1.0 / pound_force, 39.3701, 9.3572e-8,
     7.35e-4, 3.05e7},
    {"ft, slug, s", "lbf", "psf", "ft slug s (psf)", 1.0 / foot, 1e-6, 1.0 / pound_force, 3.28084, 1.9403e-3, 15.2,
     4.39e9},
}};

/// Factors of one word: `mm`, `s2`; empty for the power 0.
std::string power(std::string_view unit, int exponent) {
  if (exponent == 0) return {};
  return exponent == 1 ? std::string(unit) : fmt::format("{}{}", unit, exponent);
}

/// Those above the stroke, those below it: `N mm`, `mm/s2`, `1/ms`.
std::string product(std::initializer_list<std::pair<std::string_view, int>> factors) {
  std::string above, below;
  for (const auto& [unit, exponent] : factors) {
    std::string& side = exponent > 0 ? above : below;
    const std::string factor = power(unit, std::abs(exponent));
    if (!factor.empty()) side += (side.empty() ? "" : " ") + factor;
  }
  if (below.empty()) return above;
  return (above.empty() ? "1" : above) + "/" + below;
}

bool is_metal(const Units& units, double density, double young) {
  return density > 0.2 * units.steel_density && density < 2.5 * units.steel_density &&
         young > 0.15 * units.steel_young && young < 2.0 * units.steel_young;
}

}  // namespace

std::span<const Units> unit_systems() {
  return systems;
}

std::optional<Units> units_named(std::string_view name) {
  for (const Units& units : systems)
    if (units.name == name) return units;
  return std::nullopt;
}

std::string symbol(const Units& units, const Dimension& d) {
  const std::size_t first = units.name.find(','), last = units.name.rfind(',');
  const std::string_view length = units.name.substr(0, first), mass = units.name.substr(first + 2, last - first - 2),
                         time = units.name.substr(last + 2);
  if (d == dimension::stress) return std::string(units.stress);
  // What is a force times something is told in forces: moments, energies, stiffnesses.
  if (d.mass == 1 && d.time == -2) return product({{units.force, 1}, {length, d.length - 1}});
  if (d.mass == -1 && d.time == 2) return product({{length, d.length + 1}, {units.force, -1}});  // flexibilities
  return product({{mass, d.mass}, {length, d.length}, {time, d.time}});
}

std::string frequency_symbol(const Units& units) {
  if (units.microsecond == 1e-6) return "Hz";
  return units.microsecond == 1e-3 ? "kHz" : symbol(units, dimension::rate);
}

std::string unit_of(const std::optional<Units>& units, const Dimension& dimension) {
  return units && dimension != dimension::number ? ' ' + symbol(*units, dimension) : std::string();
}

std::string unit_of_frequency(const std::optional<Units>& units) {
  return units ? ' ' + frequency_symbol(*units) : std::string();
}

std::string in_units(const std::optional<Units>& units, const Dimension& dimension) {
  return units && dimension != dimension::number ? fmt::format(" [{}]", symbol(*units, dimension)) : std::string();
}

std::string in_frequency(const std::optional<Units>& units) {
  return units ? fmt::format(" [{}]", frequency_symbol(*units)) : std::string();
}

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
  return systems[most - votes.begin()];
}

std::optional<Units> units_of(const Model& model) {
  return model.units.empty() ? recognise_units(model) : units_named(model.units);
}

}  // namespace nugget::model
