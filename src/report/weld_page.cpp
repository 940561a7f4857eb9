// SPDX-License-Identifier: Apache-2.0
#include "report/weld_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "report/plot.hpp"
#include "report/quantity.hpp"
#include "report/response_page.hpp"

namespace nugget::report {
namespace {

using Json = nlohmann::json;

double real(const WeldRow& weld, std::string_view column) {
  const auto cell = weld.find(column);
  return cell == weld.end() ? 0.0 : std::strtod(cell->second.c_str(), nullptr);
}

/// What became of a weld: its class on the page and the word for it.
struct WeldVerdict {
  std::string_view kind, word;
  int rank = 0;  ///< the worse ones first
};

WeldVerdict status(const WeldRow& weld) {
  constexpr double near = 0.8;
  if (cell(weld, "failed") == "yes") return {"failed", "failed", 0};
  if (cell(weld, "tied") != "yes") return {"untied", "not tied", 1};
  const double value = real(weld, "peak_failure");
  if (value >= near) return {"near", "near failure", 2};
  return value > 0.0 ? WeldVerdict{"holds", "holds", 3} : WeldVerdict{"plain", "no failure value", 4};
}

std::string weld_line(const WeldRow& weld, const Json& summary) {
  const WeldVerdict v = status(weld);
  const double value = real(weld, "peak_failure");
  const std::string what = verdict(weld, summary);
  const std::string bar = value > 0.0 ? fmt::format("<span class=\"bar\" style=\"width:{:.1f}rem\"></span> {}",
                                                    3.0 * std::min(value, 1.0), fmt::format("{:.3g}", value))
                                      : "";
  std::string sheets = cell(weld, "sheet1");
  if (const std::string other = cell(weld, "sheet2"); !other.empty()) sheets += '+' + other;
  std::string s = fmt::format("<tr class=\"weld\"><td>{}</td><td class=\"text\">{}</td><td>{}</td><td>{}</td>",
                              escaped(cell(weld, "id")), escaped(cell(weld, "kind")), escaped(sheets),
                              number(real(weld, "diameter")));
  s += fmt::format("<td class=\"text {}\">{}</td><td class=\"text {}\">{}</td>", v.kind, escaped(what), v.kind, bar);
  for (const char* column : {"peak_axial", "peak_shear", "peak_force", "peak_bending", "peak_torsion", "energy"})
    s += fmt::format("<td>{}</td>", number(real(weld, column)));
  return s + fmt::format("<td>{}, {}, {}</td></tr>\n", number(real(weld, "x")), number(real(weld, "y")),
                         number(real(weld, "z")));
}

std::string place_of(const WeldRow& weld, const Json& summary) {
  std::string parts;  // of a weld that is not tied, the one that it is tied to
  for (const char* column : {"sheet1", "sheet2"})
    if (const std::string part = cell(weld, column); !part.empty()) parts += (parts.empty() ? "" : " and ") + part;
  const char* const words = parts.empty() ? "" : parts.find(' ') == parts.npos ? "on part " : "between parts ";
  return fmt::format("{}{}{}at ({}, {}, {}){}", words, parts, parts.empty() ? "" : " ", number(real(weld, "x")),
                     number(real(weld, "y")), number(real(weld, "z")), unit_of(summary, dimension::length));
}

/// The weld as a link that the viewer follows.
std::string weld_link(const WeldRow& weld) {
  return fmt::format("<a href=\"#weld={0}\">weld {0}</a>", escaped(cell(weld, "id")));
}

}  // namespace

std::string verdict(const WeldRow& weld, const Json& summary) {
  const WeldVerdict v = status(weld);
  std::string words(v.word);
  if (v.kind == "failed")
    words += fmt::format(" at {}{} by {}", number(real(weld, "failure_time")), unit_of(summary, dimension::time),
                         cell(weld, "failure_mode"));
  return words;
}

bool verdicts_differ(const WeldRow& a, const WeldRow& b) {
  return status(a).kind != status(b).kind ||
         (status(a).kind == "failed" && cell(a, "failure_mode") != cell(b, "failure_mode"));
}

std::string cell(const WeldRow& weld, std::string_view column) {
  const auto found = weld.find(column);
  return found == weld.end() ? std::string() : found->second;
}

std::vector<const WeldRow*> worst_first(const std::vector<WeldRow>& welds) {
  std::vector<const WeldRow*> order;
  order.reserve(welds.size());
  for (const WeldRow& weld : welds) order.push_back(&weld);
  std::stable_sort(order.begin(), order.end(), [](const WeldRow* a, const WeldRow* b) {
    const WeldVerdict va = status(*a), vb = status(*b);
    if (va.rank != vb.rank) return va.rank < vb.rank;
    if (va.rank == 0) return real(*a, "failure_time") < real(*b, "failure_time");
    return real(*a, "peak_failure") > real(*b, "peak_failure");
  });
  return order;
}

std::string welds_part(const RunData& run) {
  constexpr std::size_t most = 2000;
  if (run.welds.empty()) return "<p>The model has no welds.</p>\n";
  const std::vector<const WeldRow*> order = worst_first(run.welds);
  std::map<int, std::pair<std::string_view, std::size_t>> counts;
  for (const WeldRow* weld : order) {
    const WeldVerdict v = status(*weld);
    counts[v.rank].first = v.word;
    ++counts[v.rank].second;
  }
  std::string tally;
  for (const auto& [rank, count] : counts)
    tally += fmt::format("{}{} {}", tally.empty() ? "" : ", ", count.second, count.first);
  const auto unit = [&](const Dimension& d) { return escaped(in_units(run.summary, d)); };
  const std::string force = unit(dimension::force), moment = unit(dimension::moment), length = unit(dimension::length);
  std::string s = fmt::format(
      "<p id=\"weld-tally\">{} welds: {}</p>\n<div class=\"scroll\"><table id=\"welds\"><tr><th>weld</th><th "
      "class=\"text\">kind</th><th>sheets</th><th>diameter{}</th><th class=\"text\">verdict</th><th "
      "class=\"text\">largest failure value</th><th>axial{}</th><th>shear{}</th><th>resultant{}</th><th>bending{}</th>"
      "<th>torsion{}</th><th>energy{}</th><th>place{}</th></tr>\n",
      run.welds.size(), tally, length, force, force, force, moment, moment, unit(dimension::energy), length);
  for (std::size_t i = 0; i < order.size() && i < most; ++i) s += weld_line(*order[i], run.summary);
  s += "</table></div>\n";
  if (order.size() > most) s += fmt::format("<p>and {} more; welds.csv has all.</p>\n", order.size() - most);
  return s;
}

void conclude_welds(const RunData& run, std::vector<std::string>& lines) {
  if (run.welds.empty()) return;
  std::size_t failed = 0, loose = 0;
  for (const WeldRow& weld : run.welds) {
    failed += status(weld).kind == "failed";
    loose += cell(weld, "tied") != "yes";
  }
  if (loose > 0)
    lines.push_back(
        fmt::format("<span class=\"untied\">{} of {} welds are not tied: the sheets are not held together "
                    "there.</span>",
                    loose, run.welds.size()));
  if (of_linear_analysis(run.summary)) return;
  const WeldRow& worst = *worst_first(run.welds).front();
  if (failed > 0)
    lines.push_back(fmt::format("<span class=\"failed\">{} of {} welds failed.</span> The first: {} at {}{} by {}, {}.",
                                failed, run.welds.size(), weld_link(worst), number(real(worst, "failure_time")),
                                escaped(unit_of(run.summary, dimension::time)), escaped(cell(worst, "failure_mode")),
                                escaped(place_of(worst, run.summary))));
  else if (real(worst, "peak_failure") > 0.0)
    lines.push_back(fmt::format("No weld failed. The nearest to it: {}, failure value {:.3g}, {}.", weld_link(worst),
                                real(worst, "peak_failure"), escaped(place_of(worst, run.summary))));
}

}  // namespace nugget::report
