// SPDX-License-Identifier: Apache-2.0
#include "report/comparison.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

#include "output/result_file.hpp"
#include "report/page.hpp"
#include "report/page_data.hpp"
#include "report/plot.hpp"
#include "report/quantity.hpp"
#include "report/response_page.hpp"
#include "report/weld_page.hpp"

namespace nugget::report {
namespace {

using Json = nlohmann::json;

struct ComparedRun {
  std::filesystem::path folder;
  RunData data;
};

/// A number of summary.json under two keys, or under one; not a number where there is none.
double number_under(const Json& summary, const char* group, const char* key) {
  const Json found = (group ? summary.value(group, Json::object()) : summary).value(key, Json());
  return found.is_number() ? found.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

/// The difference in percent of the first; nothing where the first is zero or not known.
std::string percent(double a, double b) {
  return std::isfinite(a) && std::isfinite(b) && a != 0.0 ? fmt::format("{:+.3g} %", 100.0 * (b - a) / std::abs(a))
                                                          : "";
}

std::string heads(const ComparedRun& a, const ComparedRun& b) {
  std::string s = "<h1>Two runs</h1>\n";
  for (const auto& [name, run] : {std::pair{'A', &a}, std::pair{'B', &b}}) {
    const Json& summary = run->data.summary;
    const std::string end = summary.value("termination", "");
    s += fmt::format(
        "<p><b>{}</b> {} <span class=\"end {}\" id=\"termination-{}\">{} termination</span> <small "
        "class=\"sub\">{}</small></p>\n",
        name, escaped(summary.value("title", "")), escaped(end), name, escaped(end), escaped(run->folder.string()));
  }
  return s;
}

/// What stands against comparing them: other units, another end.
std::string doubts(const Json& a, const Json& b) {
  std::string s;
  const std::string units_a = a.value("units", ""), units_b = b.value("units", "");
  if (units_a != units_b)
    s += fmt::format(
        "<p class=\"f-warning\" id=\"units-differ\">The decks have different units, A {}, B {}: numbers and curves are "
        "compared as they are.</p>\n",
        escaped(units_a.empty() ? "not known" : units_a), escaped(units_b.empty() ? "not known" : units_b));
  const double end_a = number_under(a, nullptr, "time"), end_b = number_under(b, nullptr, "time");
  if (!of_linear_analysis(a) && std::abs(end_a - end_b) > 1e-3 * std::max(end_a, end_b))
    s += fmt::format(
        "<p class=\"f-warning\" id=\"ends-differ\">A ends at {0}{2}, B at {1}{3}: verdicts of welds and numbers are of "
        "these times.</p>\n",
        number(end_a), number(end_b), unit_of(a, dimension::time), unit_of(b, dimension::time));
  return s;
}

std::string numbers(const Json& a, const Json& b) {
  struct Row {
    const char *words, *group, *key;
    Dimension dimension;
  };
  const Row rows[] = {{"end time", nullptr, "time", dimension::time},
                      {"mass", "mass", "physical", dimension::mass},
                      {"mass added for the time step", "mass", "added", dimension::mass},
                      {"first time step", "time_step", "first", dimension::time},
                      {"kinetic energy at the end", "energy", "kinetic", dimension::energy},
                      {"internal energy", "energy", "internal", dimension::energy},
                      {"hourglass energy", "energy", "hourglass", dimension::energy},
                      {"energy of contacts", "energy", "contact", dimension::energy},
                      {"external work", "energy", "external", dimension::energy},
                      {"energy ratio", "energy", "ratio", dimension::number}};
  std::string s =
      "<h2>Numbers</h2>\n<table id=\"numbers\"><tr><th class=\"text\"></th><th>A</th><th>B</th><th>difference</th>"
      "</tr>\n";
  for (const Row& row : rows) {
    const double of_a = number_under(a, row.group, row.key), of_b = number_under(b, row.group, row.key);
    if (of_linear_analysis(a) && row.dimension != dimension::mass) continue;
    s += fmt::format("<tr class=\"number\"><td class=\"text\">{}{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                     row.words, escaped(in_units(a, row.dimension)), number(of_a), number(of_b), percent(of_a, of_b));
  }
  return s + "</table>\n";
}

std::string failure_value(const WeldRow& weld) {
  const std::string text = cell(weld, "peak_failure");
  return text.empty() ? text : number(std::strtod(text.c_str(), nullptr));
}

/// Welds that both runs have, by id, where the verdicts differ; and how many only one has.
std::string changed_welds(const ComparedRun& a, const ComparedRun& b) {
  std::map<std::string, const WeldRow*> of_b;
  for (const WeldRow& weld : b.data.welds) of_b[cell(weld, "id")] = &weld;
  std::string rows;
  std::size_t both = 0, changed = 0;
  for (const WeldRow* weld : worst_first(a.data.welds)) {
    const auto other = of_b.find(cell(*weld, "id"));
    if (other == of_b.end()) continue;
    ++both;
    if (!verdicts_differ(*weld, *other->second)) continue;
    ++changed;
    rows += fmt::format(
        "<tr class=\"weld\"><td>{}</td><td class=\"text\">{}</td><td class=\"text\">{}</td><td>{}</td>"
        "<td>{}</td></tr>\n",
        escaped(cell(*weld, "id")), escaped(verdict(*weld, a.data.summary)),
        escaped(verdict(*other->second, b.data.summary)), failure_value(*weld), failure_value(*other->second));
  }
  std::string s = "<h2>Welds whose verdict changed</h2>\n";
  s += fmt::format("<p id=\"weld-changes\">{} of {} welds that both runs have.", changed, both);
  if (a.data.welds.size() > both) s += fmt::format(" Only A has {} more.", a.data.welds.size() - both);
  if (b.data.welds.size() > both) s += fmt::format(" Only B has {} more.", b.data.welds.size() - both);
  s += "</p>\n";
  if (changed == 0) return s;
  return s +
         "<table id=\"welds\"><tr><th>weld</th><th class=\"text\">A</th><th class=\"text\">B</th><th>largest failure "
         "value, A</th><th>B</th></tr>\n" +
         rows + "</table>\n";
}

/// Frequencies side by side, in their order; the viewer pairs them by their shapes.
std::string frequencies(const Json& a, const Json& b) {
  if (!of_linear_analysis(a) || !of_linear_analysis(b)) return {};
  const Json modes_a = a.value("modes", Json::array()), modes_b = b.value("modes", Json::array());
  std::string s = fmt::format(
      "<h2>Modes</h2>\n<section id=\"mode-pairs\"></section>\n<div class=\"only-static\"><table "
      "id=\"modes\"><tr><th>mode</th><th>A{}</th><th>B{}</th><th>difference</th></tr>\n",
      in_frequency(a), in_frequency(b));
  for (std::size_t i = 0; i < std::min(modes_a.size(), modes_b.size()); ++i) {
    const double of_a = modes_a[i].value("frequency_hz", 0.0), of_b = modes_b[i].value("frequency_hz", 0.0);
    s += fmt::format("<tr class=\"mode\"><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", i + 1, number(of_a),
                     number(of_b), percent(of_a, of_b));
  }
  return s + "</table></div>\n";
}

}  // namespace

void write_comparison(const std::filesystem::path& first, const std::filesystem::path& second,
                      const std::filesystem::path& target) {
  const ComparedRun a{first, read_run(first)}, b{second, read_run(second)};
  const bool alive = !viewer_script().empty();
  std::string s = heads(a, b) + doubts(a.data.summary, b.data.summary);
  if (alive) s += "<section id=\"views\"></section>\n";
  s += changed_welds(a, b) + frequencies(a.data.summary, b.data.summary);
  if (alive && !of_linear_analysis(a.data.summary)) s += "<h2>Histories</h2>\n<section id=\"histories\"></section>\n";
  s += numbers(a.data.summary, b.data.summary);
  if (alive)
    s += fmt::format(
        "<script type=\"application/octet-stream\" id=\"run-data\">{}</script>\n<script "
        "type=\"application/octet-stream\" id=\"run-data-b\">{}</script>\n<script>{}</script>\n",
        page_data(first, a.data).text(), page_data(second, b.data).text(), viewer_script());
  output::write_whole_file(target / "compare.html", html_page("two runs", s));
}

}  // namespace nugget::report
