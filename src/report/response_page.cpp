// SPDX-License-Identifier: Apache-2.0
#include "report/response_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>

#include "output/column_units.hpp"
#include "report/plot.hpp"
#include "report/quantity.hpp"

namespace nugget::report {
namespace {

using Json = nlohmann::json;

double value_or_zero(const Json& value) {
  return value.is_number() ? value.get<double>() : 0.0;
}

/// The largest shares of one kind in a mode: `3: 71.2 %, 1: 20.1 %`.
std::string holders(const RunData& run, std::string_view kind, std::size_t mode) {
  constexpr std::size_t most = 3;
  std::vector<std::pair<double, std::string>> found;
  for (const WeldRow& row : run.shares)
    if (row.at("kind") == kind && share_of_mode(row, mode) >= 0.0005)
      found.emplace_back(share_of_mode(row, mode), row.at("id"));
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string s;
  for (std::size_t i = 0; i < std::min(most, found.size()); ++i)
    s += fmt::format("{}{}: {:.1f} %", s.empty() ? "" : ", ", found[i].second, 100.0 * found[i].first);
  return s;
}

std::string mode_table(const RunData& run) {
  const Json& modes = run.summary["modes"];
  const std::size_t rigid = rigid_modes(modes);
  const double mass = run.summary.contains("mass") ? value_or_zero(run.summary["mass"]["physical"]) : 0.0;
  std::string s = fmt::format(
      "<div class=\"scroll\"><table id=\"modes\"><tr><th>mode</th><th>frequency{}</th><th>share of mass x</th>"
      "<th>y</th><th>z</th><th class=\"text\">strain energy of parts</th><th class=\"text\">of welds</th></tr>\n",
      in_frequency(run.summary));
  for (std::size_t i = 0; i < modes.size(); ++i) {
    s += fmt::format("<tr class=\"mode\"><td>{}</td><td>{}</td>", i + 1,
                     number(value_or_zero(modes[i]["frequency_hz"])));
    for (std::size_t k = 0; k < 3; ++k)
      s += fmt::format("<td>{:.4f}</td>", mass > 0.0 ? value_or_zero(modes[i]["effective_mass"][k]) / mass : 0.0);
    s += fmt::format("<td class=\"text\">{}</td><td class=\"text\">{}</td></tr>\n",
                     i < rigid ? "rigid motion" : escaped(holders(run, "part", i)), escaped(holders(run, "weld", i)));
  }
  return s + "</table></div>\n";
}

/// Welds by the largest share of the strain energy of any mode.
std::string weld_ranking(const RunData& run) {
  constexpr std::size_t most = 100;
  struct Rank {
    const WeldRow* weld;
    std::size_t mode;
    double largest, sum;
  };
  std::vector<Rank> ranks;
  for (const WeldRow& row : run.shares) {
    if (row.at("kind") != "weld") continue;
    Rank rank{&row, 0, 0.0, 0.0};
    for (std::size_t i = 0; i < run.summary["modes"].size(); ++i) {
      rank.sum += share_of_mode(row, i);
      if (share_of_mode(row, i) <= rank.largest) continue;
      rank.largest = share_of_mode(row, i);
      rank.mode = i;
    }
    ranks.push_back(rank);
  }
  if (ranks.empty()) return {};
  std::stable_sort(ranks.begin(), ranks.end(), [](const Rank& a, const Rank& b) { return a.largest > b.largest; });
  std::string s =
      "<h2>Welds by strain energy</h2>\n<table id=\"weld-ranking\"><tr><th>weld</th><th>largest share</th><th>in "
      "mode</th>"
      "<th>all modes together</th></tr>\n";
  for (std::size_t i = 0; i < std::min(most, ranks.size()); ++i)
    s += fmt::format("<tr class=\"weld\"><td>{}</td><td>{:.3f} %</td><td>{}</td><td>{:.3f} %</td></tr>\n",
                     escaped(ranks[i].weld->at("id")), 100.0 * ranks[i].largest, ranks[i].mode + 1,
                     100.0 * ranks[i].sum);
  s += "</table>\n";
  if (ranks.size() > most) s += fmt::format("<p>and {} more; mode_energy.csv has all.</p>\n", ranks.size() - most);
  return s;
}

/// What the frequencies lose without welds (`nugget modes --drop-weld`).
std::string drop_ranking(const Json& summary) {
  if (!summary.contains("drop_weld")) return {};
  std::string s = fmt::format(
      "<h2>Frequencies without welds</h2>\n<table id=\"weld-drops\"><tr><th class=\"text\">without</th>"
      "<th>mode</th><th>frequency{0}</th><th>first order{0}</th><th>estimate{0}</th><th>solved anew{0}</th></tr>\n",
      in_frequency(summary));
  for (const Json& drop : summary["drop_weld"]) {
    std::string welds;
    for (const Json& weld : drop["welds"]) welds += fmt::format("{}{}", welds.empty() ? "" : " ", weld.dump());
    s += fmt::format("<tr><td class=\"text\">{}</td><td>{}</td>", escaped(welds), drop.value("mode", 0));
    for (const char* key : {"frequency_hz", "first_order_hz", "without_hz", "solved_hz"})
      s += fmt::format("<td>{}</td>", drop[key].is_number() ? number(value_or_zero(drop[key])) : "");
    s += "</tr>\n";
  }
  return s + "</table>\n";
}

/// Plots of the responses of one quantity, amplitude over phase.
std::string plots(const RunData& run, const std::vector<ResponseCurve>& curves, const std::string& quantity,
                  const char* file) {
  constexpr std::size_t most = 8;
  const std::string frequency = "frequency" + in_frequency(run.summary);
  Plot amplitude{frequency, quantity + in_units(run.summary, output::dimension_of_response(quantity)), {}, {}, true,
                 true},
      phase{frequency, "phase [degree]", {}, {}, true, false};
  std::size_t left_out = 0;
  for (const ResponseCurve& curve : curves) {
    if (curve.quantity != quantity) continue;
    if (amplitude.curves.size() == most) {
      ++left_out;
      continue;
    }
    amplitude.x = phase.x = curve.frequency;
    amplitude.curves.emplace_back(curve.name, curve.amplitude);
    phase.curves.emplace_back(curve.name, curve.phase);
  }
  std::string s = to_svg(amplitude);
  if (s.empty()) return "<p>" + escaped(quantity) + ": zero at all frequencies.</p>\n";
  s += to_svg(phase);
  if (left_out > 0) s += fmt::format("<p>and {} more; {} has all.</p>\n", left_out, file);
  return s;
}

std::string section(const RunData& run, const std::vector<ResponseCurve>& curves, const char* kind, const char* title,
                    const char* file) {
  if (curves.empty()) return {};
  std::string s = fmt::format("<h2>{}</h2>\n", title);
  std::vector<std::string> quantities;
  for (const ResponseCurve& curve : curves)
    if (std::find(quantities.begin(), quantities.end(), curve.quantity) == quantities.end())
      quantities.push_back(curve.quantity);
  s += "<div class=\"only-static\">";
  for (const std::string& quantity : quantities) s += plots(run, curves, quantity, file);
  s += "</div>\n";
  s += fmt::format(
      "<table id=\"{}-peaks\"><tr><th>node</th><th class=\"text\">direction</th><th class=\"text\">response</th>"
      "<th>largest amplitude</th><th>at frequency{}</th><th>phase [degree]</th></tr>\n",
      kind, in_frequency(run.summary));
  constexpr std::size_t most = 200;
  std::size_t shown = 0;
  for (const Json& r : run.summary["responses"]) {
    if (r.value("kind", "") != kind || ++shown > most) continue;
    const Json& peak = r["peak"];
    s += fmt::format(
        "<tr class=\"{}\"><td>{}{}</td><td class=\"text\">{}</td><td class=\"text\">{}</td><td>{}</td><td>{}</td>"
        "<td>{:.2f}</td></tr>\n",
        kind, r.contains("case") ? fmt::format("case {}, ", r.value("case", 0)) : "", r.value("node", 0),
        escaped(r.value("direction", "")),
        escaped(r.value("response", "") +
                in_units(run.summary, output::dimension_of_response(r.value("response", "")))),
        number(value_or_zero(peak["amplitude"])), number(value_or_zero(peak["frequency"])),
        value_or_zero(peak["phase"]));
  }
  s += "</table>\n";
  if (shown > most) s += fmt::format("<p>and {} more; {} has all.</p>\n", shown - most, file);
  return s;
}

std::string power_section(const RunData& run) {
  if (run.power.empty()) return {};
  const Dimension power = output::dimension_of_response("radiated power");
  const std::string in_power = in_units(run.summary, power), in_cycles = in_frequency(run.summary);
  Plot plot{"frequency" + in_cycles, "radiated power" + in_power, {}, {}, true, true};
  constexpr std::size_t most = 8;
  for (std::size_t i = 0; i < std::min(most, run.power.size()); ++i) {
    plot.x = run.power[i].frequency;
    plot.curves.emplace_back(run.power[i].name, run.power[i].amplitude);
  }
  std::string s = "<h2>Equivalent radiated power</h2>\n<div class=\"only-static\">" + to_svg(plot) + "</div>" +
                  fmt::format(
                      "<table id=\"erp-peaks\"><tr><th class=\"text\">panel</th><th>largest power{}</th>"
                      "<th>at frequency{}</th></tr>\n",
                      escaped(in_power), in_cycles);
  for (const Json& r : run.summary["responses"])
    if (r.value("kind", "") == "erp")
      s += fmt::format("<tr class=\"erp\"><td class=\"text\">{}</td><td>{}</td><td>{}</td></tr>\n",
                       escaped(r.value("direction", "")), number(value_or_zero(r["peak"]["amplitude"])),
                       number(value_or_zero(r["peak"]["frequency"])));
  return s + "</table>\n";
}

}  // namespace

std::size_t rigid_modes(const Json& modes) {
  const double highest = value_or_zero(modes.back()["frequency_hz"]);
  std::size_t rigid = 0;
  while (rigid < modes.size() && value_or_zero(modes[rigid]["frequency_hz"]) < 1e-3 * highest) ++rigid;
  return rigid;
}

double share_of_mode(const WeldRow& row, std::size_t i) {
  const auto cell = row.find(fmt::format("mode {}", i + 1));
  return cell == row.end() ? 0.0 : std::strtod(cell->second.c_str(), nullptr);
}

void conclude_modes(const RunData& run, std::vector<std::string>& lines) {
  if (!run.summary.contains("modes") || run.summary["modes"].empty()) return;
  const Json& modes = run.summary["modes"];
  const double highest = value_or_zero(modes.back()["frequency_hz"]);
  const std::size_t rigid = rigid_modes(modes);
  const std::string unit = frequency_unit(run.summary);
  std::string line = fmt::format("{} modes up to {}{}", modes.size(), number(highest), unit);
  if (rigid > 0) line += fmt::format(", {} of them motions of rigid bodies", rigid);
  if (rigid < modes.size())
    line += fmt::format("; the first elastic one, mode {}: {}", rigid + 1,
                        number(value_or_zero(modes[rigid]["frequency_hz"]))) +
            unit;
  lines.push_back(line + '.');
  const WeldRow* weld = nullptr;
  std::size_t mode = 0;
  double largest = 0.0;
  for (const WeldRow& row : run.shares)
    for (std::size_t i = rigid; i < modes.size() && row.at("kind") == "weld"; ++i)
      if (const double share = share_of_mode(row, i); share > largest) largest = share, mode = i, weld = &row;
  if (weld)
    lines.push_back(
        fmt::format("Most strain energy of a weld: <a href=\"#weld={0}\">weld {0}</a>, {1:.2f} % in mode {2}.",
                    escaped(weld->at("id")), 100.0 * largest, mode + 1));
}

bool of_linear_analysis(const Json& summary) {
  return summary.contains("responses") || (summary.contains("modes") && !summary["modes"].empty());
}

std::string modes_part(const RunData& run) {
  if (!run.summary.contains("modes") || run.summary["modes"].empty()) return {};
  return "<h2>Natural modes</h2>\n" + mode_table(run) + drop_ranking(run.summary) + weld_ranking(run);
}

std::string responses_part(const RunData& run) {
  if (!run.summary.contains("responses")) return {};
  return section(run, run.frf, "frf", "Frequency response", "frf.csv") +
         section(run, run.ssd, "ssd", "Steady state", "ssd.csv") + power_section(run);
}

}  // namespace nugget::report
