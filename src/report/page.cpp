// SPDX-License-Identifier: Apache-2.0
#include "report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "output/history.hpp"
#include "output/result_file.hpp"
#include "output/summary.hpp"
#include "report/force_plots.hpp"
#include "report/model_picture.hpp"
#include "report/packed_arrays.hpp"
#include "report/page_data.hpp"
#include "report/plot.hpp"
#include "report/quantity.hpp"
#include "report/response_page.hpp"
#include "report/weld_page.hpp"

namespace nugget::report {
namespace {

using Json = nlohmann::json;

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --line: #8884; --bad: #c62828; --near: #b26a00; --good: #2e7d32; }
@media (prefers-color-scheme: dark) { :root { --bad: #ef5350; --near: #ffb74d; --good: #66bb6a; } }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 72rem; margin: 1.5rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; margin: 0; } h2 { font-size: 1.1rem; margin: 2rem 0 .5rem; }
.sub { opacity: .7; margin: 0 0 1rem; overflow-wrap: anywhere; }
.end { display: inline-block; padding: .1rem .6rem; border-radius: 1rem; color: #fff; }
@media (prefers-color-scheme: dark) { .end { color: #111; } }
.normal { background: var(--good); } .error { background: var(--bad); } .interrupted { background: var(--near); }
dl { display: grid; grid-template-columns: repeat(auto-fill, minmax(11rem, 1fr)); gap: .4rem 1.5rem; margin: 0; }
dl div { border-top: 1px solid var(--line); padding-top: .2rem; } dt { font-size: .8rem; opacity: .7; } dd { margin: 0; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; font-size: .87rem; }
th, td { text-align: right; padding: .15rem .5rem; border-bottom: 1px solid var(--line); }
th { font-weight: 600; white-space: nowrap; } .text { text-align: left; }
#welds .text { white-space: nowrap; }
.failed, .untied, .f-error { color: var(--bad); font-weight: 600; } .near, .f-warning { color: var(--near); }
.holds { color: var(--good); } .bar { display: inline-block; height: .5rem; border-radius: .25rem; background: currentColor; }
figure { margin: 0; } svg { width: 100%; height: auto; } svg text { fill: currentColor; font: 11px system-ui, sans-serif; }
.grid { stroke: currentColor; stroke-opacity: .15; } .legend span { margin-right: 1rem; white-space: nowrap; }
.legend i { display: inline-block; width: .9rem; height: .2rem; margin-right: .3rem; vertical-align: middle; }
ul { padding-left: 1.2rem; } li { overflow-wrap: anywhere; } .scroll { overflow-x: auto; }
#conclusions { font-size: 1.05rem; }
@media (max-width: 56rem) { table { display: block; overflow-x: auto; } }
@media print { body { max-width: none; margin: 0; font-size: 11px; } tr { break-inside: avoid; } }
)";

/// A value of summary.json as text: numbers in six digits.
std::string text_of(const Json& value) {
  if (value.is_number_float()) return number(value.get<double>());
  return value.is_string() ? escaped(value.get<std::string>()) : value.dump();
}

/// A list of named values; `prefix` makes ids that programs find: `energy-kinetic`.
std::string values(const Json& object, std::string_view prefix) {
  std::string s = "<dl>\n";
  for (const auto& [key, value] : object.items()) {
    std::string name = key;
    std::replace(name.begin(), name.end(), '_', ' ');
    if (key == "peak_memory_mb") name = "memory at most, MB";
    if (key == "ns_per_element_cycle") name = "nanoseconds of computing per element and cycle";
    s += fmt::format("<div><dt>{}</dt><dd id=\"{}-{}\">{}</dd></div>\n", escaped(name), prefix, escaped(key),
                     text_of(value));
  }
  return s + "</dl>\n";
}

/// Whether a key of the summary says something of this run: time, steps and energies are those of an impact.
bool has_value(const Json& summary, std::string_view key) {
  constexpr std::string_view of_impact[] = {"time", "cycles", "ns_per_element_cycle", "time_step", "energy"};
  return summary.contains(key) && !(of_linear_analysis(summary) &&
                                    std::find(std::begin(of_impact), std::end(of_impact), key) != std::end(of_impact));
}

std::string head(const Json& s) {
  const std::string title = s.value("title", ""), deck = s.value("deck", ""), end = s.value("termination", ""),
                    message = s.value("message", ""), units = s.value("units", "");
  std::string about = deck;
  if (const Json& files = s.value("files", Json::array()); !files.empty()) about = files.front().get<std::string>();
  return fmt::format(
      "<h1>{}</h1>\n<p class=\"sub\">{} · nugget {} · {} · units {}</p>\n<p><span class=\"end {}\" "
      "id=\"termination\">{} termination</span> {}</p>\n",
      escaped(title.empty() ? deck : title), escaped(about), escaped(s.value("version", "")),
      escaped(s.value("date", "")), escaped(units.empty() ? "not recognised: numbers are in the deck's own" : units),
      escaped(end), escaped(end), escaped(message));
}

/// Sizes, masses, steps and energies, for who wants to know them.
std::string facts(const Json& s) {
  std::string out = "<h2>The run</h2>\n";
  Json facts;
  for (const char* key :
       {"time", "cycles", "nodes", "parts", "welds", "threads", "precision", "ns_per_element_cycle", "peak_memory_mb"})
    if (has_value(s, key)) facts[key] = s[key];
  out += values(facts, "run");
  const std::tuple<const char*, const char*, Dimension> groups[] = {
      {"elements", "Elements", dimension::number},
      {"elements_by_precision", "Elements by precision", dimension::number},
      {"mass", "Mass", dimension::mass},
      {"time_step", "Time step", dimension::time},
      {"energy", "Energy at the end", dimension::energy}};
  for (const auto& [key, heading, dimension] : groups)
    if (has_value(s, key))
      out += fmt::format("<h2>{}{}</h2>\n{}", heading, escaped(in_units(s, dimension)), values(s[key], key));
  return out;
}

// ---- soundness

/// A number of summary.json; 0 where there is none, not a number where a run that diverged left null.
double number_of(const Json& object, std::string_view key) {
  const auto found = object.find(key);
  if (found == object.end()) return 0.0;
  return found->is_number() ? found->get<double>() : std::numeric_limits<double>::quiet_NaN();
}

/// The smallest and the largest value of an energy: over glstat's times, and at the end.
std::pair<double, double> range(const RunData& run, std::string_view curve, std::string_view key) {
  const double at_end = number_of(run.summary["energy"], key);
  std::pair<double, double> range{at_end, at_end};
  for (const auto& [name, values] : run.energies)
    if (name == curve)
      for (const double value : values) range = {std::min(range.first, value), std::max(range.second, value)};
  return range;
}

/// The largest internal energy, that of the elements that had been deleted by then included.
double largest_internal(const RunData& run) {
  double largest = number_of(run.summary["energy"], "internal");
  std::vector<double> sum(run.times.size(), 0.0);
  for (const auto& [name, values] : run.energies)
    if (name == "internal energy" || name == "eroded internal energy")
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += values[i];
  for (const double value : sum) largest = std::max(largest, value);
  return largest;
}

/// A share that an expert asks of a run before its results, beside the one up to which it passes unasked.
struct Check {
  std::string_view id, what;
  double share, limit;
  std::string remedy;
  bool trifle = false;  ///< next to nothing of what came into the model: where all flies, little is internal
  bool passes() const { return share <= limit || (trifle && std::isfinite(share)); }
};

constexpr const char* energy_remedy =
    "see in glstat when the total energy leaves its level, and in the view what happened then; a smaller TSSFAC shows "
    "whether the step is too long";
constexpr const char* contact_remedy =
    "sleout and run.log have each contact: move sheets that lie in each other at the start apart, or give IGNORE; "
    "finer "
    "elements where they meet, SOFT = 1 or 2";

/// What a run knows of its parts, or what holds for any.
std::string hourglass_remedy(const Json& summary) {
  const auto of_run = summary.find("hourglass");
  if (of_run == summary.end())
    return "matsum has the energy of each part: *HOURGLASS with IHQ 4 and QM 0.05 for shells, IHQ 6 and QM 1 for "
           "bricks, "
           "or elements without such modes (ELFORM 16 of shells, 2 of bricks)";
  return fmt::format("most of it is in part {} ({}): {}", of_run->value("part", 0), of_run->value("elements", ""),
                     of_run->value("remedy", ""));
}

/// None where summary.json does not say.
std::vector<Check> checks_of(const RunData& run) {
  if (!run.summary.contains("energy") || !run.summary.contains("mass")) return {};
  const Json &energy = run.summary["energy"], &mass = run.summary["mass"];
  std::vector<Check> checks{{"energy", "total energy made or lost, of what came in",
                             std::abs(number_of(energy, "ratio") - 1.0), 0.02, energy_remedy}};
  // As on the terminal (app/commands.cpp).
  const double input = std::abs(number_of(energy, "initial") + number_of(energy, "external"));
  if (const double internal = largest_internal(run); internal != 0.0) {
    const double hourglass = range(run, "hourglass energy", "hourglass").second,
                 error = std::abs(number_of(energy, "ratio") - 1.0) * input,
                 held = number_of(energy, "contact_springs") + number_of(energy, "contact_friction") +
                        number_of(energy, "contact_damping") + number_of(energy, "contact_lost"),
                 given = std::max({0.0, -range(run, "sliding interface energy", "contact").first,
                                   held - number_of(energy, "contact")});
    checks.push_back({"hourglass", "largest hourglass energy, of the largest internal energy", hourglass / internal,
                      output::EnergyLimits::hourglass, hourglass_remedy(run.summary), hourglass <= 1e-2 * input});
    checks.push_back({"energy-of-internal", "total energy made or lost, of the largest internal energy",
                      error / internal, output::EnergyLimits::error_of_internal, energy_remedy, error <= 1e-3 * input});
    checks.push_back({"contact", "energy that contact gave, of the largest internal energy", given / internal,
                      output::EnergyLimits::given_by_contact, contact_remedy, given <= 1e-3 * input});
  }
  // Where all is rigid nothing is internal, and what came in is the measure.
  if (const double lost = number_of(energy, "contact_lost"), internal = largest_internal(run);
      internal != 0.0 || (input != 0.0 && lost != 0.0))
    checks.push_back({"contact-lost", "energy that contact lost with springs, of the largest internal energy",
                      lost / (internal != 0.0 ? internal : input), output::EnergyLimits::lost_in_contact,
                      "run.log says where springs were dropped under load: look there in the view; stiffer with SFSA, "
                      "SFSB, SLSFAC or SOFT = 1 or 2, finer elements where bodies meet",
                      internal != 0.0 && lost <= 1e-3 * input});
  if (const double physical = number_of(mass, "physical"); physical > 0.0)
    checks.push_back(
        {"mass", "mass added for the time step, of the mass", number_of(mass, "added") / physical, 0.05,
         "run.log has the mass added by part; a smaller DT2MS, or larger elements where they are smallest"});
  return checks;
}

std::string soundness(const std::vector<Check>& checks) {
  if (checks.empty()) return "<p>summary.json does not say.</p>\n";
  std::string s =
      "<table id=\"checks\"><tr><th class=\"text\">looked at</th><th>found</th><th>passes up to</th><th "
      "class=\"text\"></th><th class=\"text\"></th></tr>\n";
  for (const Check& c : checks) {
    const bool good = c.passes();
    s += fmt::format(
        "<tr class=\"check\"><td class=\"text\">{}</td><td>{:.3g} %</td><td>{:g} %</td><td class=\"text {}\" "
        "id=\"check-{}\">{}</td><td class=\"text\">{}</td></tr>\n",
        c.what, 100.0 * c.share, 100.0 * c.limit, good ? "holds" : "near", c.id, good ? "in order" : "look at it",
        good ? std::string() : escaped(c.remedy));
  }
  return s + "</table>\n";
}

std::string energy_curves(const RunData& run) {
  std::string plot = to_svg({"time" + in_units(run.summary, dimension::time),
                             "energy" + in_units(run.summary, dimension::energy), run.times, run.energies});
  if (!plot.empty()) return plot;
  if (!run.times.empty()) return "<p>All energies of glstat are zero.</p>\n";
  return "<p>No glstat: *DATABASE_GLSTAT asks for it.</p>\n";
}

// ---- findings

std::string finding_list(const Json& findings) {
  constexpr std::size_t most = 200;
  std::size_t shown = 0;
  std::string s = "<ul id=\"findings\">\n";
  for (const char* severity : {"error", "warning", "note"})
    for (const Json& f : findings) {
      if (f.value("severity", "") != severity || ++shown > most) continue;
      const std::string remedy = f.value("remedy", "");
      s += fmt::format("<li><span class=\"f-{0}\">{0}</span> {1}{2} {3}{4} <small>{5}:{6}</small></li>\n", severity,
                       escaped(f.value("keyword", "")),
                       f.value("field", "").empty() ? "" : ' ' + escaped(f.value("field", "")),
                       escaped(f.value("text", "")), remedy.empty() ? "" : " <em>" + escaped(remedy) + "</em>",
                       escaped(f.value("file", "")), f.value("line", 0));
    }
  s += "</ul>\n";
  if (shown == 0) return "<p>None.</p>\n";
  if (shown > most) s += fmt::format("<p>and {} more; findings.json has all.</p>\n", shown - most);
  return s;
}

// ---- first screen

void conclude_checks(const RunData& run, std::vector<std::string>& lines) {
  const std::vector<Check> checks = checks_of(run);
  std::size_t passed = 0;
  for (const Check& c : checks)
    if (c.passes())
      ++passed;
    else
      lines.push_back(
          fmt::format("<span class=\"near\">Look at this first:</span> {}: {:.3g} %, passes up to {:g} "
                      "%. <em>{}.</em>",
                      c.what, 100.0 * c.share, 100.0 * c.limit, escaped(c.remedy)));
  if (!checks.empty() && passed == checks.size())
    lines.push_back(fmt::format("<span class=\"holds\">All {} checks of energy and mass are in order.</span>", passed));
}

void conclude_findings(const RunData& run, std::vector<std::string>& lines) {
  std::size_t errors = 0, warnings = 0;
  for (const Json& f : run.findings) {
    errors += f.value("severity", "") == "error";
    warnings += f.value("severity", "") == "warning";
  }
  if (errors + warnings > 0)
    lines.push_back(
        fmt::format("<a href=\"#findings\">{} errors and {} warnings</a> were found in the deck.", errors, warnings));
}

/// Did it run well, what failed first and where, what to look at.
std::string conclusions(const RunData& run) {
  std::vector<std::string> lines;
  if (of_linear_analysis(run.summary))
    conclude_modes(run, lines);
  else
    conclude_checks(run, lines);
  conclude_welds(run, lines);
  conclude_findings(run, lines);
  std::string s = "<ul id=\"conclusions\">\n";
  for (const std::string& line : lines) s += "<li>" + line + "</li>\n";
  return s + "</ul>\n";
}

/// Pictures of the model; in a page with a viewer they are seen only where its script does not run (mail programs block
/// it) or finds no WebGL.
std::string stills(const std::vector<std::string>& pictures, bool alive) {
  if (pictures.empty()) return {};
  std::string shown;
  for (const std::string& picture : pictures)
    shown += fmt::format("<img alt=\"the model\" style=\"width: 100%\" src=\"data:image/svg+xml;base64,{}\">\n",
                         base64(picture));
  return alive ? "<noscript>" + shown + "</noscript>\n" : shown + "\n";
}

/// From two sides; nothing where the run left no states.
std::vector<std::string> pictures_of(const std::filesystem::path& directory) {
  PictureOptions options;
  options.width = 1080, options.height = 720;
  const Vec3d from = options.towards, towards[] = {from, {-from.x, -from.y, from.z}};
  try {
    return model_pictures(directory, options, towards);
  } catch (const std::runtime_error&) {
    return {};
  }
}

}  // namespace

std::string html_page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n<style>{}</style>"
      "</head>\n<body>\n{}</body>\n</html>\n",
      escaped(title), style, body);
}

std::string page(const RunData& run, const std::string& packed, const std::vector<std::string>& pictures,
                 const std::string& forces) {
  const bool linear = of_linear_analysis(run.summary), alive = !packed.empty() && !viewer_script().empty();
  std::string s = head(run.summary) + conclusions(run) + stills(pictures, alive);
  if (alive) s += "<section id=\"view\"></section>\n<section id=\"weld-panel\" hidden></section>\n";
  if (linear) {
    if (alive && run.summary.contains("responses")) s += "<h2>Responses</h2>\n<section id=\"responses\"></section>\n";
    s += responses_part(run) + modes_part(run);
  } else {
    s += "<h2>Welds</h2>\n" + welds_part(run);
    if (alive) s += "<h2>Histories</h2>\n<section id=\"histories\"></section>\n";
    s += "<div class=\"only-static\"><h2>Energies over time</h2>\n" + energy_curves(run) + forces +
         "</div>\n<h2>Is the run sound?</h2>\n" + soundness(checks_of(run));
  }
  s += facts(run.summary) + "<h2>Findings</h2>\n" + finding_list(run.findings);
  if (alive)
    s += fmt::format("<script type=\"application/octet-stream\" id=\"run-data\">{}</script>\n<script>{}</script>\n",
                     packed, viewer_script());
  return html_page(run.summary.value("deck", "nugget"), s);
}

void write_report(const std::filesystem::path& directory) {
  const RunData run = read_run(directory);
  const std::string packed = viewer_script().empty() ? std::string() : page_data(directory, run).text();
  output::write_whole_file(directory / "report.html",
                           page(run, packed, pictures_of(directory), force_plots(directory, run.summary)));
}

}  // namespace nugget::report
