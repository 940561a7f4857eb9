// SPDX-License-Identifier: Apache-2.0
#include "app/weld_ranking.hpp"
#include "output/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace nugget::app {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

std::string text_of_row(const report::WeldRow& row, std::string_view column) {
  const auto cell = row.find(column);
  return cell == row.end() ? std::string() : cell->second;
}

double number_of_row(const report::WeldRow& row, std::string_view column) {
  const std::string text = text_of_row(row, column);
  return text.empty() ? not_known : std::strtod(text.c_str(), nullptr);
}

RankedWeld read_ranked(const report::WeldRow& row) {
  RankedWeld w;
  w.id = text_of_row(row, "id");
  w.kind = text_of_row(row, "kind");
  w.sheets = text_of_row(row, "sheet1");
  if (const std::string other = text_of_row(row, "sheet2"); !other.empty()) w.sheets += '+' + other;
  std::replace(w.sheets.begin(), w.sheets.end(), ' ', '+');
  w.failure_mode = text_of_row(row, "failure_mode");
  w.passed = number_of_row(row, "most_energy_passed");
  w.taken = number_of_row(row, "energy");
  w.failure_value = number_of_row(row, "peak_failure");
  w.at_time = number_of_row(row, "peak_failure_time");
  w.failure_time = text_of_row(row, "failed") == "yes" ? number_of_row(row, "failure_time") : not_known;
  w.interval = number_of_row(row, "failure_interval");
  std::istringstream course(text_of_row(row, "failure_course"));
  for (std::string value; course >> value;) w.course.push_back(std::strtod(value.c_str(), nullptr));
  return w;
}

/// Ascending; what is not known comes last.
bool known_first(double a, double b) {
  return std::isnan(b) ? !std::isnan(a) : a < b;
}

/// What stands first has the smallest number.
double rank_of(const RankedWeld& w, WeldOrder order) {
  return order == WeldOrder::energy ? -std::abs(w.passed) : order == WeldOrder::margin ? w.margin() : w.failure_time;
}

std::string ranking_cell(double value, int digits = 4) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : std::string("-");
}

/// A character for each interval: the failure value in tenths, `.` below 0.1, `X` from 1 on.
std::string course_digits(const std::vector<double>& course) {
  std::string s;
  for (const double value : course)
    s += value >= 1.0 ? 'X' : value < 0.1 ? '.' : static_cast<char>('0' + static_cast<int>(10.0 * value));
  return s;
}

std::string_view order_words(WeldOrder order) {
  switch (order) {
    case WeldOrder::energy: return "most energy through it first";
    case WeldOrder::margin: return "smallest margin first";
    case WeldOrder::failure: return "first to fail first";
  }
  return "";
}

std::string and_more(std::size_t all, std::size_t shown) {
  return shown < all ? fmt::format(" and {} more (-n 0 shows all)\n", all - shown) : std::string();
}

std::size_t lines_shown(std::size_t all, std::size_t most) {
  return most == 0 ? all : std::min(all, most);
}

}  // namespace

double RankedWeld::margin() const {
  return failure_value > 0.0 ? 1.0 - failure_value : not_known;
}

std::vector<RankedWeld> rank_welds(const report::RunData& run, WeldOrder order) {
  std::vector<RankedWeld> welds;
  for (const report::WeldRow& row : run.welds) welds.push_back(read_ranked(row));
  std::stable_sort(welds.begin(), welds.end(), [order](const RankedWeld& a, const RankedWeld& b) {
    const double x = rank_of(a, order), y = rank_of(b, order);
    if (order == WeldOrder::failure && std::isnan(x) && std::isnan(y)) return known_first(a.margin(), b.margin());
    return known_first(x, y);
  });
  return welds;
}

std::string ranking_table(const std::vector<RankedWeld>& welds, WeldOrder order, std::size_t most,
                          const std::optional<model::Units>& units) {
  const std::string energy = model::in_units(units, dimension::energy), time = model::in_units(units, dimension::time);
  const auto failed =
      std::count_if(welds.begin(), welds.end(), [](const RankedWeld& w) { return !std::isnan(w.failure_time); });
  std::string s = fmt::format(
      "{} welds, {} failed; {}\n\n {:>5} {:>10} {:>9} {:>11} {:>17} {:>14} {:>9} {:>11} {:>8} "
      "{:>13}  {:<20} {}\n",
      welds.size(), failed, order_words(order), "", "weld", "kind", "sheets", "through it" + energy, "into it" + energy,
      "largest f", "at time" + time, "margin", "failed at" + time, "by", "f over time");
  const std::size_t shown = lines_shown(welds.size(), most);
  for (std::size_t i = 0; i < shown; ++i) {
    const RankedWeld& w = welds[i];
    const bool has_function = w.failure_value > 0.0;
    s += fmt::format(
        " {:>5} {:>10} {:>9} {:>11} {:>17} {:>14} {:>9} {:>11} {:>8} {:>13}  {:<20} {}\n", i + 1, w.id, w.kind,
        w.sheets, ranking_cell(w.passed), ranking_cell(w.taken), has_function ? ranking_cell(w.failure_value, 3) : "-",
        has_function ? ranking_cell(w.at_time) : "-", ranking_cell(w.margin(), 3), ranking_cell(w.failure_time),
        w.failure_mode.empty() ? "-" : w.failure_mode, course_digits(w.course));
  }
  s += and_more(welds.size(), shown);
  const auto timed = std::find_if(welds.begin(), welds.end(), [](const RankedWeld& w) { return w.interval > 0.0; });
  s += "\n through it: energy that passed from its first sheet to its second (below 0: the other way), the largest of "
       "the run\n into it: work done on the weld itself; f: failure value, 1 is failure; margin: 1 - largest f\n";
  if (timed != welds.end())
    s += fmt::format(
        " f over time: the largest of each interval in tenths (. below 0.1, X from 1 on); of weld {} an "
        "interval is {:.4g}{}\n",
        timed->id, timed->interval, model::unit_of(units, dimension::time));
  return s;
}

std::string ranking_csv(const std::vector<RankedWeld>& welds) {
  std::string s =
      "rank,weld,kind,sheets,energy_through,energy_into,largest_failure,at_time,margin,failure_time,failure_mode,"
      "failure_interval,failure_course\n";
  const auto exact = [](double value) { return std::isfinite(value) ? fmt::format("{}", value) : std::string(); };
  for (std::size_t i = 0; i < welds.size(); ++i) {
    const RankedWeld& w = welds[i];
    s += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", i + 1, w.id, w.kind, w.sheets, exact(w.passed),
                     exact(w.taken), exact(w.failure_value), exact(w.at_time), exact(w.margin()), exact(w.failure_time),
                     w.failure_mode, exact(w.interval), fmt::join(w.course, " "));
  }
  return s;
}

std::vector<WeldShare> rank_shares(const report::RunData& run) {
  std::vector<WeldShare> welds;
  const std::size_t modes = run.summary.contains("modes") ? run.summary["modes"].size() : 0;
  for (const report::WeldRow& row : run.shares) {
    if (text_of_row(row, "kind") != "weld") continue;
    WeldShare w{text_of_row(row, "id"), 0.0, 0};
    for (std::size_t mode = 1; mode <= modes; ++mode)
      if (const double share = number_of_row(row, fmt::format("mode {}", mode)); share > w.largest)
        w = {w.id, share, static_cast<int>(mode)};
    welds.push_back(w);
  }
  std::stable_sort(welds.begin(), welds.end(),
                   [](const WeldShare& a, const WeldShare& b) { return a.largest > b.largest; });
  return welds;
}

std::string share_table(const std::vector<WeldShare>& welds, std::size_t most) {
  std::string s = fmt::format(
      "{} welds; largest share of the strain energy of a mode first\n\n {:>5} {:>10} {:>10} "
      "{:>8}\n",
      welds.size(), "", "weld", "share [%]", "of mode");
  const std::size_t shown = lines_shown(welds.size(), most);
  for (std::size_t i = 0; i < shown; ++i)
    s += fmt::format(" {:>5} {:>10} {:>10.3f} {:>8}\n", i + 1, welds[i].id, 100.0 * welds[i].largest, welds[i].mode);
  return s + and_more(welds.size(), shown) +
         "\n a stiff weld stores little: what modes are without it says `nugget modes --drop-weld`\n";
}

std::string share_csv(const std::vector<WeldShare>& welds) {
  std::string s = "rank,weld,largest_share,mode\n";
  for (std::size_t i = 0; i < welds.size(); ++i)
    s += fmt::format("{},{},{},{}\n", i + 1, welds[i].id, welds[i].largest, welds[i].mode);
  return s;
}

}  // namespace nugget::app
