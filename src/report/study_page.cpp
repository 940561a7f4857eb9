// SPDX-License-Identifier: Apache-2.0
#include "report/study_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "output/result_file.hpp"
#include "report/page.hpp"
#include "report/plot.hpp"

namespace nugget::report {
namespace {

std::string result_heading(const Study::Result& result) {
  return result.unit.empty() ? result.name : fmt::format("{} [{}]", result.name, result.unit.substr(1));
}

std::string study_ending(int exit_code) {
  switch (exit_code) {
    case -1: return "not run";
    case 0: return "normal";
    case 1: return "refused";
    case 130: return "interrupted";
    default: return fmt::format("exit code {}", exit_code);
  }
}

/// The numbers of a parameter; empty unless each run has one and they differ.
std::vector<double> numbers_of(const Study& study, std::size_t parameter) {
  std::vector<double> numbers;
  for (const Study::Run& run : study.runs) {
    const std::string& text = run.values[parameter];
    char* end = nullptr;
    numbers.push_back(std::strtod(text.c_str(), &end));
    if (text.empty() || *end != '\0') return {};
  }
  return std::set<double>(numbers.begin(), numbers.end()).size() > 1 ? numbers : std::vector<double>();
}

/// Each result over each parameter that takes several numbers.
std::vector<Plot> study_plots(const Study& study) {
  std::vector<Plot> plots;
  for (std::size_t p = 0; p < study.parameters.size(); ++p) {
    const std::vector<double> x = numbers_of(study, p);
    if (x.empty()) continue;
    for (const Study::Result& result : study.results) {
      Plot::Trace points{result.name, {}, {}, true};
      for (std::size_t i = 0; i < x.size(); ++i) {
        if (!std::isfinite(result.values[i])) continue;
        points.x.push_back(x[i]);
        points.y.push_back(result.values[i]);
      }
      if (points.x.empty()) continue;
      Plot plot{.abscissa = study.parameters[p], .ordinate = result_heading(result), .x = {}, .curves = {}};
      plot.traces.push_back(std::move(points));
      plots.push_back(std::move(plot));
    }
  }
  return plots;
}

std::string result_cell(double value) {
  return std::isfinite(value) ? number(value) : "-";
}

std::string study_html(const Study& study, const std::vector<Plot>& plots) {
  std::string body = fmt::format("<h1>Study of {}</h1>\n<p class=\"sub\">{}, {} runs, units {}</p>\n",
                                 escaped(study.title.empty() ? study.deck : study.title), escaped(study.deck),
                                 study.runs.size(), escaped(study.units.empty() ? "not known" : study.units));
  body += "<div class=\"scroll\"><table id=\"study\"><tr><th class=\"text\">run</th>";
  for (const std::string& name : study.parameters) body += fmt::format("<th>{}</th>", escaped(name));
  body += "<th class=\"text\">ended</th>";
  for (const Study::Result& result : study.results)
    body += fmt::format("<th title=\"{}\">{}</th>", escaped(result.quantity), escaped(result_heading(result)));
  body += "</tr>\n";
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const Study::Run& run = study.runs[i];
    body += run.exit_code == -1 || run.exit_code == 1
                ? fmt::format("<tr class=\"run\"><td class=\"text\">{}</td>", escaped(run.name))
                : fmt::format("<tr class=\"run\"><td class=\"text\"><a href=\"{0}/report.html\">{0}</a></td>",
                              escaped(run.name));
    for (const std::string& value : run.values) body += fmt::format("<td>{}</td>", escaped(value));
    body +=
        fmt::format("<td class=\"text{}\">{}</td>", run.exit_code == 0 ? "" : " failed", study_ending(run.exit_code));
    for (const Study::Result& result : study.results) body += fmt::format("<td>{}</td>", result_cell(result.values[i]));
    body += "</tr>\n";
  }
  body += "</table></div>\n";
  body += "<div style=\"display:grid;grid-template-columns:repeat(auto-fill,minmax(26rem,1fr));gap:1rem\">\n";
  for (const Plot& plot : plots) body += fmt::format("<div>{}</div>\n", to_svg(plot));
  body += "</div>\n";
  return html_page("study of " + study.deck, body);
}

/// The names of columns hold no commas (see the command).
std::string study_csv(const Study& study) {
  std::string s = "run";
  for (const std::string& name : study.parameters) s += ',' + name;
  s += ",exit_code";
  for (const Study::Result& result : study.results) s += ',' + result.name;
  s += '\n';
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const Study::Run& run = study.runs[i];
    s += run.name;
    for (const std::string& value : run.values) s += ',' + value;
    s += fmt::format(",{}", run.exit_code == -1 ? std::string() : fmt::to_string(run.exit_code));
    for (const Study::Result& result : study.results)
      s += std::isfinite(result.values[i]) ? fmt::format(",{:.9g}", result.values[i]) : std::string(",");
    s += '\n';
  }
  return s;
}

std::string units_csv(const Study& study) {
  std::string s = "file,column,quantity,unit\n";
  for (const Study::Result& result : study.results)
    s += fmt::format("study.csv,{},\"{}\",{}\n", result.name, result.quantity,
                     !result.unit.empty()  ? result.unit.substr(1)
                     : study.units.empty() ? ""
                                           : "-");
  return s;
}

}  // namespace

std::string study_lines(const Study& study) {
  std::vector<std::vector<std::string>> rows(study.runs.size() + 1);
  const auto column = [&](std::string head, auto text_of_run) {
    rows[0].push_back(std::move(head));
    for (std::size_t i = 0; i < study.runs.size(); ++i) rows[i + 1].push_back(text_of_run(i));
  };
  column("run", [&](std::size_t i) { return study.runs[i].name; });
  for (std::size_t p = 0; p < study.parameters.size(); ++p)
    column(study.parameters[p], [&](std::size_t i) { return study.runs[i].values[p]; });
  column("ended", [&](std::size_t i) { return study_ending(study.runs[i].exit_code); });
  for (const Study::Result& result : study.results)
    column(result_heading(result), [&](std::size_t i) { return result_cell(result.values[i]); });
  std::string s;
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      std::size_t width = 0;
      for (const std::vector<std::string>& other : rows) width = std::max(width, other[c].size());
      s += fmt::format("  {:>{}}", row[c], width);
    }
    s += '\n';
  }
  return s;
}

void write_study(const std::filesystem::path& directory, const Study& study) {
  const std::vector<Plot> drawn = study_plots(study);
  output::write_whole_file(directory / "study.csv", study_csv(study));
  output::write_whole_file(directory / "units.csv", units_csv(study));
  if (!drawn.empty()) output::write_whole_file(directory / "study.svg", to_svg_file(drawn));
  output::write_whole_file(directory / "study.html", study_html(study, drawn));
}

}  // namespace nugget::report
