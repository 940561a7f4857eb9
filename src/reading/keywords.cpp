// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>

#include "reading/builder/builder.hpp"
#include "reading/cards/equation_of_state.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {

namespace {

std::vector<Keyword> all_families() {
  std::vector<Keyword> all;
  for (const auto family : {
           text_keywords,
           mesh_keywords,
           move_keywords,
           node_merge_keywords,
           belt_keywords,
           sensor_define_keywords,
           sensor_keywords,
           sensor_control_keywords,
           stopper_keywords,
           linear_constraint_keywords,
           tied_node_keywords,
           part_keywords,
           section_keywords,
           material_keywords,
           plastic_material_keywords,
           johnson_cook_keywords,
           modified_johnson_cook_keywords,
           tabulated_johnson_cook_keywords,
           laminated_fabric_keywords,
           yld2000_keywords,
           viscoplastic_material_keywords,
           equation_of_state_keywords,
           erosion_keywords,
           element_death_keywords,
           gissmo_keywords,
           friction_keywords,
           orthotropic_material_keywords,
           fabric_material_keywords,
           composite_material_keywords,
           sheet_material_keywords,
           plain_law_keywords,
           rubber_material_keywords,
           viscoelastic_keywords,
           polymer_material_keywords,
           laminated_glass_keywords,
           simplified_rubber_keywords,
           foam_material_keywords,
           honeycomb_material_keywords,
           cohesive_material_keywords,
           weld_material_keywords,
           weld_table_keywords,
           heat_zone_keywords,
           weld_brick_keywords,
           weld_tie_keywords,
           interpolation_spotweld_keywords,
           discrete_beam_keywords,
           spring_keywords,
           curve_keywords,
           frame_keywords,
           set_keywords,
           control_keywords,
           subcycle_keywords,
           implicit_keywords,
           frequency_keywords,
           steady_state_keywords,
           database_keywords,
           cross_section_keywords,
           boundary_keywords,
           initial_keywords,
           initial_state_keywords,
           damping_keywords,
           load_keywords,
           blast_keywords,
           generalized_body_load_keywords,
           airbag_keywords,
           rigidwall_keywords,
           seam_weld_keywords,
           constrained_keywords,
           coarsening_keywords,
           joint_stiffness_keywords,
           joint_keywords,
           contact_keywords,
           other_keywords,
       }) {
    auto rows = family();
    std::move(rows.begin(), rows.end(), std::back_inserter(all));
  }
  return all;
}

/// LS-DYNA writes both MAT_SPOTWELD_DAMAGE-FAILURE and MAT_SPOTWELD_DAMAGE_FAILURE.
std::string normalized(std::string_view written) {
  std::string name(written);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// Rows by name and alias; those that end in `*` by what stands before it.
struct Directory {
  std::unordered_map<std::string, const Keyword*> names, beginnings;

  Directory() {
    for (const Keyword& row : keywords()) {
      add(row.name, row);
      for (const auto alias : row.aliases) add(alias, row);
    }
  }
  void add(std::string_view name, const Keyword& row) {
    if (name.ends_with('*'))
      beginnings.emplace(normalized(name.substr(0, name.size() - 1)), &row);
    else
      names.emplace(normalized(name), &row);
  }
};

const Directory& directory() {
  static const Directory instance;
  return instance;
}

/// Takes options off the front of `rest` ("_LIST_TITLE"), the longest that fits first; nothing where one is not known.
std::optional<Options> split_options(std::string_view rest, const Keyword& row) {
  Options found;
  while (!rest.empty()) {
    rest.remove_prefix(1);
    std::string_view best;
    for (const auto option : row.options) {
      const std::string name = normalized(option);
      const bool fits = rest.starts_with(name) && (rest.size() == name.size() || rest[name.size()] == '_');
      if (fits && option.size() > best.size()) best = option;
    }
    if (best.empty()) return std::nullopt;
    found.emplace(best);
    rest.remove_prefix(best.size());
  }
  return found;
}

/// Calls `visit(beginning)` for the name and its beginnings at underscores, longest first, until it returns true.
template <class Visit>
void each_beginning(std::string_view name, Visit visit) {
  for (auto end = name.size(); end != name.npos && end > 0; end = name.rfind('_', end - 1))
    if (visit(name.substr(0, end))) return;
}

}  // namespace

std::span<const Keyword> keywords() {
  static const std::vector<Keyword> list = all_families();
  return list;
}

const Keyword* find_keyword(std::string_view written, Options& options) {
  const std::string name = normalized(written);
  const Keyword* found = nullptr;
  std::size_t nearest = 0;  // length of the longest beginning that is a keyword
  each_beginning(name, [&](std::string_view beginning) {
    const auto at = directory().names.find(std::string(beginning));
    if (at == directory().names.end()) return false;
    nearest = std::max(nearest, beginning.size());
    auto split = split_options(std::string_view(name).substr(beginning.size()), *at->second);
    if (!split) return false;
    options = std::move(*split);
    found = at->second;
    return true;
  });
  if (found) return found;
  options.clear();
  // MAT_024_FOO is rather an unknown form of MAT_024 than one of MAT_*.
  for (auto length = name.size(); length > nearest; --length) {
    const auto at = directory().beginnings.find(name.substr(0, length));
    if (at != directory().beginnings.end()) return at->second;
  }
  return nullptr;
}

const Keyword* nearest_keyword(std::string_view written) {
  const std::string name = normalized(written);
  const Keyword* found = nullptr;
  each_beginning(name, [&](std::string_view beginning) {
    const auto at = directory().names.find(std::string(beginning));
    if (at != directory().names.end()) found = at->second;
    return found != nullptr;
  });
  return found;
}

}  // namespace nugget::reading
