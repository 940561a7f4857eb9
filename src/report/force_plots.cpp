// SPDX-License-Identifier: Apache-2.0
#include "report/force_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "output/history_reader.hpp"
#include "report/plot.hpp"
#include "report/quantity.hpp"

namespace nugget::report {
namespace {

/// The size of an entity's force over time.
struct ForceCurve {
  std::string name;
  std::vector<double> size;
  double largest = 0.0, at = 0.0;
};

ForceCurve force_curve(const std::string& entity, const std::vector<const output::Channel*>& components,
                       const std::vector<double>& times) {
  ForceCurve curve{entity, std::vector<double>(times.size(), 0.0)};
  if (!components.front()->title.empty()) curve.name += ' ' + components.front()->title;
  for (std::size_t i = 0; i < times.size(); ++i) {
    for (const output::Channel* c : components) curve.size[i] = std::hypot(curve.size[i], c->values[i]);
    if (curve.size[i] > curve.largest) curve.largest = curve.size[i], curve.at = times[i];
  }
  return curve;
}

/// Of each entity that had a force, the largest first.
std::vector<ForceCurve> forces_of(const output::HistoryRecord& record) {
  std::map<std::string, std::vector<const output::Channel*>> of;
  for (const output::Channel& c : record.channels)
    if (c.quantity == "x_force" || c.quantity == "y_force" || c.quantity == "z_force") of[c.entity].push_back(&c);
  std::vector<ForceCurve> curves;
  for (const auto& [entity, components] : of) {
    curves.push_back(force_curve(entity, components, record.times));
    if (curves.back().largest == 0.0) curves.pop_back();
  }
  std::stable_sort(curves.begin(), curves.end(),
                   [](const ForceCurve& a, const ForceCurve& b) { return a.largest > b.largest; });
  return curves;
}

}  // namespace

std::string force_plots(const std::filesystem::path& directory, const nlohmann::json& summary) {
  constexpr std::size_t most_curves = 8, most_lines = 50;
  constexpr std::pair<std::string_view, std::string_view> files[] = {{"rwforc", "Forces on walls"},
                                                                     {"rcforc", "Forces of contacts"}};
  std::string s;
  for (const auto& [file, heading] : files) {
    for (const output::HistoryRecord& record : output::read_histories(directory, {&file, 1})) {
      const std::vector<ForceCurve> curves = forces_of(record);
      s += fmt::format("<h2>{} over time</h2>\n", heading);
      if (curves.empty()) {
        s += fmt::format("<p>All forces of {} are zero.</p>\n", file);
        continue;
      }
      Plot plot{
          "time" + in_units(summary, dimension::time), "force" + in_units(summary, dimension::force), record.times, {}};
      for (std::size_t i = 0; i < std::min(curves.size(), most_curves); ++i)
        plot.curves.emplace_back(curves[i].name, curves[i].size);
      s += to_svg(plot) + fmt::format("<ul class=\"forces\" id=\"forces-{}\">\n", file);
      for (std::size_t i = 0; i < std::min(curves.size(), most_lines); ++i)
        s += fmt::format("<li>{}: largest {}{} at {}{}</li>\n", escaped(curves[i].name), number(curves[i].largest),
                         escaped(unit_of(summary, dimension::force)), number(curves[i].at),
                         escaped(unit_of(summary, dimension::time)));
      s += "</ul>\n";
      if (curves.size() > most_lines)
        s += fmt::format("<p>and {} more; {} has all.</p>\n", curves.size() - most_lines, file);
    }
  }
  return s;
}

}  // namespace nugget::report
