// SPDX-License-Identifier: Apache-2.0
#include "report/channel_curves.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>

#include "base/append.hpp"
#include "model/units.hpp"
#include "output/column_units.hpp"
#include "output/history_reader.hpp"
#include "report/quantity.hpp"
#include "report/run_data.hpp"

namespace nugget::report {
namespace {

bool has_pattern(const std::string& pattern, const std::string& text) {
  return ::fnmatch(pattern.c_str(), text.c_str(), FNM_CASEFOLD) == 0;
}

bool is_entity(const std::string& pattern, const ChannelCurve& curve) {
  const std::string id = curve.entity.substr(curve.entity.rfind(' ') + 1);
  return has_pattern(pattern, curve.entity) || has_pattern(pattern, id) || has_pattern(pattern, curve.title);
}

std::vector<std::string> split_at_slashes(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == '/')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

void add_responses_of(const RunData& run, std::vector<ChannelCurve>& curves) {
  const std::string abscissa = fmt::format("frequency [{}]", frequency_unit(run.summary).substr(1));
  const std::pair<const char*, const std::vector<ResponseCurve>&> kinds[] = {
      {"frf", run.frf}, {"ssd", run.ssd}, {"erp", run.power}};
  for (const auto& [file, responses] : kinds)
    for (const ResponseCurve& r : responses) {
      if (r.frequency.empty()) continue;
      curves.push_back({file,
                        r.name,
                        {},
                        r.quantity,
                        unit_of(run.summary, output::dimension_of_response(r.quantity)),
                        abscissa,
                        true,
                        {},
                        r.frequency,
                        r.amplitude});
      if (!r.phase.empty())
        curves.push_back({file, r.name, {}, "phase", " deg", abscissa, true, {}, r.frequency, r.phase});
    }
}

/// What is named first comes first; nothing twice.
void add_name(std::vector<std::string>& names, std::string name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
}

std::string first_and_last(const std::vector<std::string>& names) {
  constexpr std::size_t most = 6;
  if (names.size() <= most) return fmt::format("{}", fmt::join(names, ", "));
  return fmt::format("{}, {}, … {} ({} in all)", names[0], names[1], names.back(), names.size());
}

bool goes_with(const Plot& plot, const ChannelCurve& before, const ChannelCurve& curve) {
  return plot.abscissa == curve.abscissa && before.unit == curve.unit &&
         before.over_frequency == curve.over_frequency && (!curve.unit.empty() || before.quantity == curve.quantity);
}

}  // namespace

std::string ChannelCurve::name() const {
  return entity.empty() ? fmt::format("{}/{}", file, quantity) : fmt::format("{}/{}/{}", file, entity, quantity);
}

std::vector<ChannelCurve> read_channel_curves(const std::filesystem::path& directory) {
  const RunData run = read_run(directory);
  std::vector<ChannelCurve> curves;
  const std::string time = "time" + in_units(run.summary, dimension::time);
  const auto units = model::units_named(run.summary.value("units", ""));
  const std::optional<double> second = units ? std::optional(1e6 * units->microsecond) : std::nullopt;
  for (output::HistoryRecord& record : output::read_histories(directory))
    for (output::Channel& c : record.channels)
      curves.push_back({record.file, c.entity, c.title, c.quantity, unit_of(run.summary, c.dimension), time, false,
                        second, record.times, std::move(c.values)});
  add_responses_of(run, curves);
  return curves;
}

std::vector<const ChannelCurve*> matching(const std::vector<ChannelCurve>& curves, const std::string& pattern) {
  const std::vector<std::string> parts = split_at_slashes(pattern);
  std::vector<const ChannelCurve*> found;
  for (const ChannelCurve& curve : curves) {
    if (!has_pattern(parts[0], curve.file)) continue;
    const bool fits = parts.size() == 1 ||
                      (parts.size() == 2 && (has_pattern(parts[1], curve.quantity) || is_entity(parts[1], curve))) ||
                      (parts.size() == 3 && is_entity(parts[1], curve) && has_pattern(parts[2], curve.quantity));
    if (fits) found.push_back(&curve);
  }
  return found;
}

std::string listed(const std::vector<ChannelCurve>& curves) {
  std::string text;
  for (auto begin = curves.begin(); begin != curves.end();) {
    const auto end = std::find_if(begin, curves.end(), [&](const ChannelCurve& c) { return c.file != begin->file; });
    std::vector<std::string> entities, quantities;
    for (auto c = begin; c != end; ++c) {
      if (!c->entity.empty()) add_name(entities, c->entity);
      add_name(quantities, c->unit.empty() ? c->quantity : fmt::format("{} [{}]", c->quantity, c->unit.substr(1)));
    }
    append(text, "{}: {} values over {}, {:.6g} to {:.6g}\n", begin->file, begin->x.size(), begin->abscissa,
           begin->x.front(), begin->x.back());
    if (!entities.empty()) append(text, "    of          {}\n", first_and_last(entities));
    append(text, "    quantities  {}\n", fmt::join(quantities, ", "));
    begin = end;
  }
  return text;
}

std::vector<Plot> plots_of(const std::vector<ChannelCurve>& curves) {
  std::vector<Plot> plots;
  std::vector<const ChannelCurve*> first;            // of each plot
  std::vector<std::vector<std::string>> quantities;  // of each plot
  for (const ChannelCurve& curve : curves) {
    std::size_t i = 0;
    while (i < plots.size() && !goes_with(plots[i], *first[i], curve)) ++i;
    if (i == plots.size()) {
      plots.push_back({.abscissa = curve.abscissa,
                       .ordinate = {},
                       .x = {},
                       .curves = {},
                       .log_x = curve.over_frequency,
                       .log_y = curve.over_frequency && curve.quantity != "phase"});
      first.push_back(&curve);
      quantities.emplace_back();
    }
    plots[i].traces.push_back({curve.name(), curve.x, curve.y});
    add_name(quantities[i], curve.quantity);
  }
  for (std::size_t i = 0; i < plots.size(); ++i) {
    constexpr std::size_t most_names = 3;
    std::string& words = plots[i].ordinate;
    if (quantities[i].size() <= most_names) words = fmt::format("{}", fmt::join(quantities[i], ", "));
    if (!first[i]->unit.empty()) words += fmt::format("{}[{}]", words.empty() ? "" : " ", first[i]->unit.substr(1));
  }
  return plots;
}

}  // namespace nugget::report
