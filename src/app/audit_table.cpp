// SPDX-License-Identifier: Apache-2.0
#include "app/audit_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "model/lumped_mass.hpp"
#include "model/units.hpp"

namespace nugget::app {
namespace {

constexpr std::size_t most_rows = 25, shown_of_many = 15;

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.3g}", value) : std::string("-");
}

std::string percent_of(double part, double whole) {
  return whole > 0.0 ? fmt::format(" ({:.3g} % of the model)", 100.0 * part / whole) : std::string();
}

}  // namespace

std::string weld_kinds(const weld::Ties& ties) {
  using Kind = std::pair<weld::Weld::Kind, bool>;  // and whether it is an interpolation
  static const std::map<Kind, std::pair<const char*, const char*>> names{
      {{weld::Weld::Kind::beam, false}, {"beam", "beams"}},
      {{weld::Weld::Kind::solid, false}, {"brick", "bricks"}},
      {{weld::Weld::Kind::assembly, false}, {"assembly of bricks", "assemblies of bricks"}},
      {{weld::Weld::Kind::rigid, false}, {"rigid weld", "rigid welds"}},
      {{weld::Weld::Kind::connector, false}, {"discrete beam", "discrete beams"}},
      {{weld::Weld::Kind::connector, true}, {"interpolation spot weld", "interpolation spot welds"}}};
  std::map<Kind, int> count;
  for (const weld::Weld& w : ties.welds) ++count[{w.kind, w.interpolated}];
  std::string text;
  for (const auto& [kind, n] : count) {
    const auto& [one, many] = names.at(kind);
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", n, n == 1 ? one : many);
  }
  return text;
}

namespace {

/// How many spots go through how many sheets.
std::string spots(const std::vector<weld::Report>& reports) {
  std::map<std::size_t, int> by_sheets;
  for (std::size_t w = 0; w < reports.size(); ++w)
    if (reports[w].spot == w && !reports[w].stack.empty()) ++by_sheets[reports[w].stack.size()];
  std::string text;
  for (const auto& [sheets, n] : by_sheets)
    text += fmt::format("{}{} through {} sheet{}", text.empty() ? "" : ", ", n, sheets, sheets == 1 ? "" : "s");
  return text.empty() ? "none attached" : text;
}

std::string check_line(const weld::CheckSummary& found, const weld::Ties& ties,
                       const std::vector<weld::Report>& reports, const std::optional<model::Units>& units) {
  const weld::Check& check = *found.check;
  const auto c = static_cast<std::size_t>(&check - weld::checks().data());
  std::string worst;
  for (const std::size_t w : found.worst)
    worst += std::isfinite(reports[w].values[c]) ? fmt::format("  {}: {:.3g}", ties.welds[w].id, reports[w].values[c])
                                                 : fmt::format("  {}", ties.welds[w].id);
  if (found.remarks > found.worst.size()) worst += "  ...";
  const auto is_attached = [](const weld::Report& r) { return !r.stack.empty(); };
  const bool by_number = !check.measure.empty(), of_sheets = check.name == "sheets";
  const bool looked =
      by_number ? std::isfinite(found.least) : !of_sheets || std::any_of(reports.begin(), reports.end(), is_attached);
  const char* const mark = found.remarks > 0 ? (check.severity == Severity::warning ? "!" : "note")
                           : looked          ? "ok"
                                             : "-";
  return fmt::format(" {:<10}{:<22}{:>9}{:>10}{:>6}{:>8} {}\n", check.name,
                     std::string(check.measure) + model::in_units(units, check.dimension), number(found.least),
                     number(found.most), mark, found.remarks, worst);
}

std::string cost(const model::Model& model, const std::vector<weld::Report>& reports,
                 const std::optional<model::Units>& units) {
  double shortest = std::numeric_limits<double>::infinity(), mass = 0.0, by_dt = 0.0, by_dt2ms = 0.0;
  for (const weld::Report& r : reports) {
    shortest = std::min(shortest, r.cost.time_step);
    mass += r.cost.mass;
    by_dt += r.cost.mass_by_dt;
    by_dt2ms += r.cost.mass_by_dt2ms;
  }
  const double whole = model::mass_of_elements(model);
  const std::string unit = model::unit_of(units, dimension::mass);
  return fmt::format(
      " smallest time step of a weld, as given  {}{}\n mass of the welds, as given             {:.4g}{}{}\n"
      " mass that DT adds to welds              {:.4g}{}{}\n mass that DT2MS adds to welds           {:.4g}{}{}\n",
      number(shortest), model::unit_of(units, dimension::time), mass, unit, percent_of(mass, whole), by_dt, unit,
      percent_of(by_dt, whole), by_dt2ms, unit, percent_of(by_dt2ms, whole));
}

/// Of the warnings; 0 where there is none.
double worst_excess(const weld::Report& report) {
  double worst = 0.0;
  for (const weld::Remark& remark : report.remarks)
    if (remark.check->severity == Severity::warning) worst = std::max(worst, remark.excess);
  return worst;
}

}  // namespace

std::string audit_table(const model::Model& model, const weld::Ties& ties, const std::vector<weld::Report>& reports) {
  if (ties.welds.empty()) return {};
  const auto units = model::units_of(model);
  std::string s = fmt::format("Audit: {}; spots: {}; units {}\n\n", weld_kinds(ties), spots(reports),
                              units ? units->name : "not recognised, so limits in millimetres are not looked at");
  s += fmt::format(" {:<10}{:<22}{:>9}{:>10}{:>14}  {}\n", "check", "measured", "least", "most", "remarks",
                   "worst welds");
  const std::vector<weld::CheckSummary> summary = weld::summarise(reports);
  for (const weld::CheckSummary& found : summary) s += check_line(found, ties, reports, units);
  s += '\n';
  for (const weld::CheckSummary& found : summary)
    if (found.remarks > 0)
      s += fmt::format(" {:<10}expected: {}; {}\n", found.check->name, found.check->rule, found.check->remedy);
  return s + '\n' + cost(model, reports, units) + '\n';
}

std::string weld_table(const model::Model& model, const weld::Ties& ties, const std::vector<weld::Report>& reports) {
  if (ties.welds.empty()) return {};
  std::vector<std::size_t> order(ties.welds.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const bool all = order.size() <= most_rows;
  if (!all) {
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return worst_excess(reports[a]) > worst_excess(reports[b]); });
    order.resize(shown_of_many);
    std::erase_if(order, [&](std::size_t w) { return worst_excess(reports[w]) == 0.0; });
  }
  if (order.empty()) {
    const auto alone = std::count_if(ties.welds.begin(), ties.welds.end(), [](const weld::Weld& w) {
      return std::all_of(w.sheets.begin(), w.sheets.end(), [](model::Index sheet) { return sheet == model::none; });
    });
    return fmt::format("{} welds without a warning{}; welds.csv has a row for each\n", ties.welds.size(),
                       alone == 0 ? "" : fmt::format(", but {} have no sheet: most checks could not be made", alone));
  }
  const std::string length = model::in_units(model::units_of(model), dimension::length);
  std::string s = fmt::format("{:>10} {:>9} {:>8} {:>13} {:>13} {:>5}  {:<9} {}\n", "weld", "kind", "part",
                              "diameter" + length, "length" + length, "tied", "sheets", "remarks");
  for (const std::size_t i : order) {
    const weld::Weld& w = ties.welds[i];
    std::vector<int> sheets;
    for (const model::Index sheet : w.sheets)
      if (sheet != model::none) sheets.push_back(model.parts[sheet].id);
    std::string remarks;
    for (const weld::Remark& r : reports[i].remarks)
      remarks += fmt::format("{}{}: {}", remarks.empty() ? "" : "; ", r.check->name, r.text);
    s += fmt::format("{:>10} {:>9} {:>8} {:>13.4g} {:>13.4g} {:>5}  {:<9} {}\n", w.id, weld::to_string(w.kind),
                     w.part == model::none ? 0 : model.parts[w.part].id, w.diameter, w.length, w.tied ? "yes" : "no",
                     fmt::format("{}", fmt::join(sheets, "+")), remarks);
  }
  if (!all)
    s += fmt::format("the welds with the worst warnings, {} of {}; welds.csv has a row for each\n", order.size(),
                     ties.welds.size());
  return s;
}

std::string target_table(const model::Model& model, const weld::Ties& ties, const std::vector<weld::Report>& reports,
                         double step) {
  const auto units = model::units_of(model);
  std::vector<std::size_t> below;
  double total = 0.0;
  for (std::size_t w = 0; w < reports.size(); ++w) {
    if (reports[w].values.empty() || reports[w].cost.time_step >= step) continue;
    below.push_back(w);
    total += weld::cost_of_step(reports[w].cost, step).mass;
  }
  std::string s = fmt::format("Time step {:.4g}{}: {} of {} welds have a smaller one\n\n", step,
                              model::unit_of(units, dimension::time), below.size(), ties.welds.size());
  if (below.empty()) return s;
  s += fmt::format(" by mass (DT = {:.4g} in *MAT_SPOTWELD): {:.4g}{} more{}\n by stiffness: E as below, no mass\n\n",
                   step, total, model::unit_of(units, dimension::mass),
                   percent_of(total, model::mass_of_elements(model)));
  std::stable_sort(below.begin(), below.end(),
                   [&](std::size_t a, std::size_t b) { return reports[a].cost.time_step < reports[b].cost.time_step; });
  const std::string mass = model::in_units(units, dimension::mass);
  s += fmt::format("{:>10} {:>14} {:>11} {:>15} {:>8}  {:>11} {:>11}\n", "weld",
                   "time step" + model::in_units(units, dimension::time), "mass" + mass, "mass added" + mass, "factor",
                   "or E" + model::in_units(units, dimension::stress), "instead of");
  const std::size_t shown = below.size() <= most_rows ? below.size() : shown_of_many;
  for (std::size_t i = 0; i < shown; ++i) {
    const weld::MassScalingCost& cost = reports[below[i]].cost;
    const weld::StepCost target = weld::cost_of_step(cost, step);
    s += fmt::format("{:>10} {:>14.4g} {:>11.4g} {:>15.4g} {:>8.4g}  {:>11.4g} {:>11.4g}\n", ties.welds[below[i]].id,
                     cost.time_step, cost.mass, target.mass, std::pow(step / cost.time_step, 2.0), target.young,
                     cost.young);
  }
  if (shown < below.size())
    s += fmt::format("the smallest steps, {} of {}; welds.csv has all (target_mass, target_young)\n", shown,
                     below.size());
  return s + '\n';
}

}  // namespace nugget::app
