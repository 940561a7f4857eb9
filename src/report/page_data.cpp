// SPDX-License-Identifier: Apache-2.0
#include "report/page_data.hpp"

#include <fmt/format.h>

#include "model/units.hpp"
#include "output/history.hpp"
#include "output/summary.hpp"
#include "report/response_page.hpp"
#include "report/view.hpp"

#ifdef NUGGET_VIEWER
extern "C" const char nugget_viewer_begin[], nugget_viewer_end[];
#endif

namespace nugget::report {
namespace {

using Json = nlohmann::json;

/// Symbols of the quantities that the viewer names; nothing where the deck's units are not known.
void add_units(Json& about, const RunData& run) {
  const auto units = model::units_named(run.summary.value("units", ""));
  if (!units) return;
  constexpr std::pair<const char*, Dimension> named[] = {
      {"length", dimension::length}, {"time", dimension::time},        {"mass", dimension::mass},
      {"force", dimension::force},   {"moment", dimension::moment},    {"energy", dimension::energy},
      {"stress", dimension::stress}, {"velocity", dimension::velocity}};
  for (const auto& [name, dimension] : named) about["units"][name] = model::symbol(*units, dimension);
  about["units"]["frequency"] = units->microsecond == 1e-6   ? "Hz"
                                : units->microsecond == 1e-3 ? "kHz"
                                                             : model::symbol(*units, dimension::rate);
  about["second"] = 1e6 * units->microsecond;
}

/// welds.csv without the long courses, which histories show better.
void add_welds(Json& about, const RunData& run) {
  if (run.welds.empty()) return;
  Json& table = about["welds"];
  for (const auto& [column, value] : run.welds.front())
    if (column != "failure_course") table["columns"].push_back(column);
  for (const WeldRow& weld : run.welds) {
    Json row = Json::array();
    for (const auto& column : table["columns"]) {
      const auto cell = weld.find(column.get_ref<const std::string&>());
      row.push_back(cell == weld.end() ? std::string() : cell->second);
    }
    table["rows"].push_back(std::move(row));
  }
}

/// Share of each weld in the strain energy of each mode.
void add_shares(PackedArrays& packed, const RunData& run) {
  if (!run.summary.contains("modes") || run.summary["modes"].empty()) return;
  const std::size_t modes = run.summary["modes"].size();
  Json ids = Json::array();
  std::vector<float> shares;
  for (const WeldRow& row : run.shares) {
    if (row.at("kind") != "weld") continue;
    ids.push_back(row.at("id"));
    for (std::size_t i = 0; i < modes; ++i) shares.push_back(static_cast<float>(share_of_mode(row, i)));
  }
  if (ids.empty()) return;
  packed.about["shares"] = {{"ids", ids}, {"modes", modes}};
  packed.add("shares", shares);
}

void add_responses(PackedArrays& packed, const RunData& run) {
  const std::pair<const char*, const std::vector<ResponseCurve>&> kinds[] = {
      {"frf", run.frf}, {"ssd", run.ssd}, {"erp", run.power}};
  int number = 0;
  for (const auto& [kind, curves] : kinds)
    for (const ResponseCurve& curve : curves) {
      const std::string array = fmt::format("response{}", number++);
      packed.about["responses"].push_back(
          {{"kind", kind}, {"name", curve.name}, {"quantity", curve.quantity}, {"array", array}});
      std::vector<float> values;
      for (const auto* column : {&curve.frequency, &curve.amplitude, &curve.phase})
        for (std::size_t i = 0; i < curve.frequency.size(); ++i)
          values.push_back(i < column->size() ? static_cast<float>((*column)[i])
                                              : std::numeric_limits<float>::quiet_NaN());
      packed.add(array, values);
    }
}

}  // namespace

PackedArrays page_data(const std::filesystem::path& directory, const RunData& run) {
  const bool modes = run.summary.contains("modes") && !run.summary["modes"].empty();
  PackedArrays packed = packed_view(directory, modes);
  add_units(packed.about, run);
  add_welds(packed.about, run);
  add_shares(packed, run);
  add_responses(packed, run);
  return packed;
}

std::string_view viewer_script() {
#ifdef NUGGET_VIEWER
  return {nugget_viewer_begin, static_cast<std::size_t>(nugget_viewer_end - nugget_viewer_begin)};
#else
  return {};
#endif
}

}  // namespace nugget::report
