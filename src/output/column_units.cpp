// SPDX-License-Identifier: Apache-2.0
#include "output/column_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "output/history.hpp"
#include "output/result_file.hpp"

namespace nugget::output {
namespace {

struct KnownColumn {
  std::string_view files;  ///< with a space after each
  std::string_view name;   ///< with `*` at the end: all that begin so
  ColumnQuantity of;
};

constexpr Dimension of_power{1, 2, -3};
constexpr std::string_view by_response = "by response";

std::span<const KnownColumn> known_columns() {
  static constexpr Dimension flexibility{-1, 0, 2}, turn_per_moment{-1, -2, 2};
  static constexpr ColumnQuantity length{"length", dimension::length, {}}, time{"time", dimension::time, {}},
      force{"force", dimension::force, {}}, moment{"moment", dimension::moment, {}},
      energy{"energy", dimension::energy, {}}, mass{"mass", dimension::mass, {}},
      failure{"failure value, 1 is failure", dimension::number, {}}, count{"number", dimension::number, {}},
      ratio{"ratio", dimension::number, {}}, angle{"angle", dimension::number, "degree"},
      frequency{"frequency", dimension::rate, {}, true}, share{"share of the strain energy", dimension::number, {}},
      response{"response: displacement, velocity, acceleration as `response` says; of frf.csv per unit of the load",
               dimension::number, by_response};

  static constexpr auto known = std::to_array<KnownColumn>({
      {"welds.csv ", "x", length},
      {"welds.csv ", "y", length},
      {"welds.csv ", "z", length},
      {"welds.csv ", "diameter", length},
      {"welds.csv ", "length", length},
      {"welds.csv ", "failure_time", time},
      {"welds.csv ", "peak_axial", force},
      {"welds.csv ", "peak_shear", force},
      {"welds.csv ", "peak_bending", moment},
      {"welds.csv ", "peak_torsion", moment},
      {"welds.csv ", "peak_force", force},
      {"welds.csv ", "peak_failure", failure},
      {"welds.csv ", "peak_failure_time", time},
      {"welds.csv ", "last_axial", force},
      {"welds.csv ", "last_shear", force},
      {"welds.csv ", "last_bending", moment},
      {"welds.csv ", "last_torsion", moment},
      {"welds.csv ", "last_force", force},
      {"welds.csv ", "last_strain_rate", {"strain rate", dimension::rate, {}}},
      {"welds.csv ", "last_failure", failure},
      {"welds.csv ", "last_bending_1", moment},
      {"welds.csv ", "last_bending_2", moment},
      {"welds.csv ", "damage", {"damage, 1 is failed", dimension::number, {}}},
      {"welds.csv ", "energy", energy},
      {"welds.csv ", "energy_passed", energy},
      {"welds.csv ", "most_energy_passed", energy},
      {"welds.csv ", "failure_interval", time},
      {"welds.csv ", "failure_course", failure},
      {"welds.csv ", "added_mass", mass},
      {"welds.csv ", "stack_sheets", count},
      {"welds.csv ", "length_ratio", ratio},
      {"welds.csv ", "stretch", ratio},
      {"welds.csv ", "diameter_ratio", ratio},
      {"welds.csv ", "angle", angle},
      {"welds.csv ", "edge_distance", length},
      {"welds.csv ", "flange_elements", count},
      {"welds.csv ", "pitch_ratio", ratio},
      {"welds.csv ", "element_ratio", ratio},
      {"welds.csv ", "aspect_ratio", ratio},
      {"welds.csv ", "added_mass_ratio", ratio},
      {"welds.csv ", "time_step", time},
      {"welds.csv ", "mass", mass},
      {"welds.csv ", "mass_by_dt", mass},
      {"welds.csv ", "mass_by_dt2ms", mass},
      {"welds.csv ", "target_mass", mass},
      {"welds.csv ", "target_young", {"stress", dimension::stress, {}}},
      {"welds.csv ", "hold_by_segment", ratio},
      {"welds.csv ", "hold_by_area", ratio},
      {"welds.csv ", "joint_in_plane", {"flexibility", flexibility, {}}},
      {"welds.csv ", "joint_bending", {"turn per moment", turn_per_moment, {}}},
      {"welds.csv ", "joint_normal_yield", force},
      {"welds.csv ", "joint_shear_yield", force},
      {"welds.csv ", "joint_moment_yield", moment},
      {"welds.csv ", "error_*", ratio},
      {"welds.csv ", "moved*", length},
      {"welds.csv ", "xi*", {"place on the segment, -1 to 1", dimension::number, {}}},
      {"welds.csv ", "eta*", {"place on the segment, -1 to 1", dimension::number, {}}},
      {"frf.csv ssd.csv erp.csv mac.csv weld_drop.csv ", "frequency", frequency},
      {"frf.csv ssd.csv ", "amplitude", response},
      {"frf.csv ssd.csv ", "real", response},
      {"frf.csv ssd.csv ", "imaginary", response},
      {"frf.csv ssd.csv ", "phase", angle},
      {"erp.csv ", "power", {"power", of_power, {}}},
      {"erp.csv ", "decibels", {"level", dimension::number, "dB"}},
      {"mode_energy.csv ", "mode *", share},
      {"mac.csv ", "other *", {"modal assurance criterion", dimension::number, {}}},
      {"weld_drop.csv ", "first_order", frequency},
      {"weld_drop.csv ", "without", frequency},
      {"weld_drop.csv ", "solved", frequency},
      {"weld_drop.csv ", "likeness", {"modal assurance criterion", dimension::number, {}}},
      {"weld_drop.csv ", "internal_energy", energy},
      {"weld_drop.csv ", "other_welds_failed", count},
      {"weld_drop.csv ", "intrusion *", length},
      {"least_welds.csv ", "first_frequency", frequency},
      {"coupon.csv surface.csv curves.csv ", "angle", angle},
      {"coupon.csv ", "peak_force", force},
      {"coupon.csv curves.csv ", "displacement", length},
      {"coupon.csv ", "work", energy},
      {"coupon.csv ", "surface_force", force},
      {"coupon.csv surface.csv ", "axial", force},
      {"coupon.csv surface.csv ", "shear", force},
      {"coupon.csv ", "bending", moment},
      {"coupon.csv ", "torsion", moment},
      {"coupon.csv ", "failure_value", failure},
      {"coupon.csv ", "load", force},
      {"coupon.csv ", "load_angle", angle},
      {"coupon.csv ", "surface_at_load", force},
      {"curves.csv surface.csv ", "force", force},
      {"fit.csv ", "measured_force", force},
      {"fit.csv ", "measured_displacement", length},
      {"fit.csv ", "force_by_strengths", force},
      {"fit.csv ", "simulated_force", force},
      {"fit.csv ", "simulated_displacement", length},
  });
  return known;
}

constexpr auto csv_tables = std::to_array<std::string_view>(
    {"welds.csv", "frf.csv", "ssd.csv", "erp.csv", "mode_energy.csv", "mac.csv", "weld_drop.csv", "least_welds.csv",
     "coupon.csv", "curves.csv", "surface.csv", "fit.csv"});

/// The responses of a table, each once, in its third column.
std::vector<std::string> responses_in(std::istream& table) {
  std::vector<std::string> responses;
  for (std::string line; std::getline(table, line);) {
    std::size_t begin = line.find(',');
    begin = begin == line.npos ? begin : line.find(',', begin + 1);
    if (begin == line.npos) continue;
    std::string response = line.substr(begin + 1, line.find(',', begin + 1) - begin - 1);
    if (std::ranges::find(responses, response) == responses.end()) responses.push_back(std::move(response));
  }
  return responses;
}

bool is_column_named(std::string_view pattern, std::string_view name) {
  return pattern.ends_with('*') ? name.starts_with(pattern.substr(0, pattern.size() - 1)) : name == pattern;
}

}  // namespace

std::optional<ColumnQuantity> column_quantity(std::string_view file, std::string_view name) {
  const std::string of_file = std::string(file) + ' ';
  const auto found = std::ranges::find_if(known_columns(), [&](const KnownColumn& column) {
    return column.files.find(of_file) != column.files.npos && is_column_named(column.name, name);
  });
  if (found == known_columns().end()) return std::nullopt;
  return found->of;
}

Dimension dimension_of_response(std::string_view response) {
  static constexpr std::pair<std::string_view, Dimension> known[] = {
      {"displacement", dimension::length},
      {"rotation", dimension::angle},
      {"velocity", dimension::velocity},
      {"angular velocity", dimension::rate},
      {"acceleration", dimension::acceleration},
      {"angular acceleration", dimension::angular_acceleration},
      {"force", dimension::force},
      {"moment", dimension::moment},
      {"radiated power", of_power}};
  const auto found = std::ranges::find(known, response, &std::pair<std::string_view, Dimension>::first);
  return found == std::end(known) ? dimension::number : found->second;
}

std::string unit_of_column(const ColumnQuantity& column, const std::optional<model::Units>& units) {
  if (!column.unit.empty()) return std::string(column.unit);
  if (column.dimension == dimension::number) return "-";
  if (!units) return {};
  if (column.a_frequency) return model::frequency_symbol(*units);
  return model::symbol(*units, column.dimension);
}

void write_column_units(const std::filesystem::path& directory, const std::optional<model::Units>& units) {
  std::string text = "file,column,quantity,unit\n";
  for (const std::string_view table : csv_tables) {
    std::ifstream file(directory / table);
    std::string head;
    if (!std::getline(file, head)) continue;
    const bool of_responses = head.starts_with("node,direction,response,");
    const std::vector<std::string> responses = of_responses ? responses_in(file) : std::vector<std::string>();
    for (std::size_t begin = 0; begin <= head.size();) {  // none of our columns has a comma in its name
      const std::size_t end = std::min(head.find(',', begin), head.size());
      const std::string_view name = std::string_view(head).substr(begin, end - begin);
      const bool an_id = begin == 0 && name == "without";  // of a study of runs; of one of modes it is a frequency
      const auto column = an_id ? std::nullopt : column_quantity(table, name);
      if (column && column->unit == by_response)
        for (const std::string& response : responses)
          text += fmt::format("{},{},\"{}\",{}\n", table, name, response,
                              unit_of_column({response, dimension_of_response(response), {}}, units));
      else if (column)
        text += fmt::format("{},{},\"{}\",{}\n", table, name, column->quantity, unit_of_column(*column, units));
      begin = end + 1;
    }
  }
  write_whole_file(directory / "units.csv", text);
}

}  // namespace nugget::output
