// SPDX-License-Identifier: Apache-2.0
#include "report/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "model/units.hpp"
#include "output/column_units.hpp"
#include "output/history.hpp"
#include "output/history_reader.hpp"
#include "output/summary.hpp"
#include "report/quantity.hpp"
#include "report/response_page.hpp"
#include "report/view.hpp"
#include "report/weld_page.hpp"

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
  about["units"]["frequency"] = frequency_unit(run.summary).substr(1);
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
          {{"kind", kind},
           {"name", curve.name},
           {"quantity", curve.quantity},
           {"unit", unit_of(run.summary, output::dimension_of_response(curve.quantity))},
           {"array", array}});
      std::vector<float> values;
      for (const auto* column : {&curve.frequency, &curve.amplitude, &curve.phase})
        for (std::size_t i = 0; i < curve.frequency.size(); ++i)
          values.push_back(i < column->size() ? static_cast<float>((*column)[i])
                                              : std::numeric_limits<float>::quiet_NaN());
      packed.add(array, values);
    }
}

/// Most numbers of one file in the page.
constexpr std::size_t most_of_file = 250'000;
/// Times to which a file is thinned before channels are left out.
constexpr std::size_t fewest_times = 200;

/// Channels of welds in the order of their verdicts, so that what is left out are those far from failure.
void order_by_welds(const RunData& run, output::HistoryRecord& record) {
  std::map<std::string, std::size_t, std::less<>> rank;
  for (const WeldRow* weld : worst_first(run.welds)) rank.emplace("weld " + cell(*weld, "id"), rank.size());
  const auto rank_of = [&](const output::Channel& channel) {
    const auto found = rank.find(channel.entity);
    return found == rank.end() ? rank.size() : found->second;
  };
  std::stable_sort(record.channels.begin(), record.channels.end(),
                   [&](const auto& a, const auto& b) { return rank_of(a) < rank_of(b); });
}

/// Times and then channel by channel; as many as the page has room for, with a word where that is not all.
void add_history(PackedArrays& packed, const output::HistoryRecord& record, const Json& summary) {
  const std::size_t times = record.times.size(), channels = record.channels.size();
  const std::size_t room = std::max(fewest_times, most_of_file / std::max<std::size_t>(1, channels));
  const std::size_t stride = (times + room - 1) / room;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < times; i += stride) kept.push_back(i);
  if (kept.back() + 1 != times) kept.push_back(times - 1);
  const std::size_t shown = std::min(channels, most_of_file / kept.size());
  const std::string array = "history_" + record.file;
  Json list = Json::array();
  std::vector<float> values;
  values.reserve(kept.size() * (1 + shown));
  for (const std::size_t i : kept) values.push_back(static_cast<float>(record.times[i]));
  for (std::size_t c = 0; c < shown; ++c) {
    const output::Channel& channel = record.channels[c];
    list.push_back({channel.entity, channel.title, channel.quantity, unit_of(summary, channel.dimension)});
    for (const std::size_t i : kept) values.push_back(static_cast<float>(channel.values[i]));
  }
  packed.add(array, values);
  packed.about["histories"].push_back(
      {{"file", record.file}, {"array", array}, {"times", kept.size()}, {"channels", std::move(list)}});
  if (stride > 1)
    packed.about["notes"].push_back(fmt::format("{}: every {}. of {} times is shown.", record.file, stride, times));
  if (shown < channels)
    packed.about["notes"].push_back(
        fmt::format("{}: {} of {} curves are shown, first those of the welds that failed or came nearest to it.",
                    record.file, shown, channels));
}

}  // namespace

PackedArrays page_data(const std::filesystem::path& directory, const RunData& run) {
  const bool modes = run.summary.contains("modes") && !run.summary["modes"].empty();
  PackedArrays packed = packed_view(directory, modes);
  add_units(packed.about, run);
  add_welds(packed.about, run);
  add_shares(packed, run);
  add_responses(packed, run);
  if (of_linear_analysis(run.summary)) return packed;
  for (output::HistoryRecord& record : output::read_histories(directory)) {
    if (record.file == "swforc") order_by_welds(run, record);
    add_history(packed, record, run.summary);
  }
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
