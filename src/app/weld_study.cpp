// SPDX-License-Identifier: Apache-2.0
#include "app/weld_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "app/dropped_welds.hpp"
#include "app/lessened_structure.hpp"
#include "base/index.hpp"
#include "nvh/eigen/mode_files.hpp"
#include "output/result_file.hpp"

namespace nugget::app {
namespace {

double frequency(double eigenvalue) {
  return std::sqrt(std::max(0.0, eigenvalue)) / (2.0 * std::numbers::pi);
}

/// A group of welds with what was found of it; frequencies by mode of the whole structure.
struct Row {
  std::vector<int> ids;
  std::vector<double> first_order, estimate, mac;
  std::vector<double> new_modes;           ///< of shapes that the whole structure has not
  std::vector<double> solved, solved_mac;  ///< solved anew; empty: that was not done
  std::vector<double> solved_new_modes;

  bool holds(std::size_t i) const { return mac[i] >= nvh::same_mode_mac; }
  bool holds_solved(std::size_t i) const { return !solved.empty() && solved_mac[i] >= nvh::same_mode_mac; }

  std::string name() const { return fmt::format("{}", fmt::join(ids, "+")); }
};

double percent(double now, double before) {
  return before > 0.0 ? 100.0 * (now / before - 1.0) : 0.0;
}

/// Shift of a mode without the welds; 0 where it is not there any more.
double shift(const nvh::Modes& modes, const Row& row, std::size_t i) {
  return modes.elastic(i) && row.holds(i) ? percent(row.estimate[i], modes.frequency(i)) : 0.0;
}

/// The mode whose frequency falls most, among those that are still there.
std::size_t worst_mode(const nvh::Modes& modes, const Row& row) {
  std::size_t worst = 0;
  for (std::size_t i = 1; i < row.estimate.size(); ++i)
    if (!modes.elastic(worst) || shift(modes, row, i) < shift(modes, row, worst)) worst = i;
  return worst;
}

/// A number in its column, or a dash.
std::string cell(bool there, double value, const char* format, int width) {
  return fmt::format(" {:>{}}", there ? fmt::format(fmt::runtime(format), value) : "-", width);
}

/// Nodal shapes times the root of the mass of each node in the whole structure: their MAC is that in M.
nvh::Columns weighted_shapes(const nvh::Matrices& whole, const nvh::Matrices& m, const nvh::Modes& modes) {
  nvh::Columns shapes = nvh::nodal_shapes(m, modes);
  for (std::size_t j = 0; j < shapes.count; ++j)
    for (std::size_t i = 0; i < shapes.rows; ++i)
      shapes[j][i] *= std::sqrt(whole.nodal_mass[whole.system.node_of[i / 3]].mass);
  return shapes;
}

/// Modes of the structure without the welds, as many as were asked for, and their partners.
void solve_anew(const nvh::Matrices& m, const nvh::Modes& modes, const nvh::WeldGroup& group, Row& row,
                const nvh::ProgressCallback& progress) {
  const auto less = LessenedStructure::make(m, group);
  if (less == nullptr) return;
  nvh::ModeRequest request;
  request.count = static_cast<int>(modes.eigenvalue.size());
  const nvh::Modes now = nvh::find_modes(less->matrices(), request, progress);
  const nvh::Columns mac = nvh::compute_mac(weighted_shapes(m, m, modes), weighted_shapes(m, less->matrices(), now));
  const std::vector<int> partner = nvh::partners(mac);
  for (std::size_t i = 0; i < partner.size(); ++i) {
    row.solved.push_back(partner[i] < 0 ? 0.0 : now.frequency(at(partner[i])));
    row.solved_mac.push_back(partner[i] < 0 ? 0.0 : mac[i][partner[i]]);
  }
  for (std::size_t j = 0; j < now.eigenvalue.size(); ++j) {
    const auto of = std::find(partner.begin(), partner.end(), static_cast<int>(j));
    if (of == partner.end() || !row.holds_solved(static_cast<std::size_t>(of - partner.begin())))
      row.solved_new_modes.push_back(now.frequency(j));
  }
}

void write_rows(const std::filesystem::path& directory, const nvh::Modes& modes, const std::vector<Row>& rows) {
  std::string text = "weld,mode,frequency,first_order,without,likeness,solved\n";
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.estimate.size(); ++i) {
      if (!modes.elastic(i)) continue;
      text += fmt::format("{},{},{:.9g},{:.9g},{:.9g},{:.4f},{}\n", row.name(), i + 1, modes.frequency(i),
                          row.first_order[i], row.estimate[i], row.mac[i],
                          !row.holds_solved(i) ? "" : fmt::format("{:.9g}", row.solved[i]));
    }
  output::write_whole_file(directory / "weld_drop.csv", text);
}

/// A group: every mode.
std::string table_of_modes(const nvh::Modes& modes, const Row& row, const std::optional<model::Units>& units) {
  std::string s =
      fmt::format("Without weld{} {}\n\n {:>6} {:>14} {:>16} {:>14} {:>9} {:>14} {:>9} {:>8}\n",
                  row.ids.size() > 1 ? "s" : "", row.name(), "mode", "frequency" + model::in_frequency(units),
                  "first order [%]", "without", "[%]", "solved anew", "[%]", "likeness");
  for (std::size_t i = 0; i < row.estimate.size(); ++i) {
    if (!modes.elastic(i)) continue;
    const double f = modes.frequency(i);
    s += fmt::format(" {:>6} {:>14.6g} {:>16.4f}", i + 1, f, percent(row.first_order[i], f));
    s += cell(row.holds(i), row.estimate[i], "{:.6g}", 14) +
         cell(row.holds(i), percent(row.estimate[i], f), "{:.3f}", 9);
    s += cell(row.holds_solved(i), row.solved[i], "{:.6g}", 14);
    s += cell(row.holds_solved(i), percent(row.solved[i], f), "{:.3f}", 9);
    s += fmt::format(" {:>8.3f}\n", row.solved_mac[i]);
  }
  const auto list = [&](const char* kind, const std::vector<double>& new_modes) {
    if (!new_modes.empty()) s += fmt::format(" new shapes, {}: {:.6g}\n", kind, fmt::join(new_modes, " "));
  };
  list("estimated", row.new_modes);
  list("solved anew", row.solved_new_modes);
  return s + '\n';
}

/// Every weld, those first that matter most; and of each mode the welds that it needs most.
std::string ranking(const nvh::Modes& modes, const std::vector<Row>& rows, const std::vector<std::size_t>& order,
                    const std::optional<model::Units>& units) {
  constexpr std::size_t most = 30;
  std::string s = fmt::format(
      "Welds by the mode that falls most when one is taken out (all of it in weld_drop.csv)\n\n"
      " {:>6} {:>10} {:>6} {:>14} {:>16} {:>14} {:>9} {:>16}\n",
      "rank", "weld", "mode", "frequency" + model::in_frequency(units), "first order [%]", "without", "[%]",
      "solved anew [%]");
  for (std::size_t r = 0; r < std::min(most, order.size()); ++r) {
    const Row& row = rows[order[r]];
    const std::size_t i = worst_mode(modes, row);
    const double f = modes.frequency(i);
    s += fmt::format(" {:>6} {:>10} {:>6} {:>14.6g} {:>16.4f} {:>14.6g} {:>9.3f}", r + 1, row.name(), i + 1, f,
                     percent(row.first_order[i], f), row.estimate[i], percent(row.estimate[i], f));
    s += cell(row.holds_solved(i), row.solved.empty() ? 0.0 : percent(row.solved[i], f), "{:.3f}", 16) + '\n';
  }
  s += "\n Of each mode the five welds that it needs most, with its shift in percent without each\n";
  for (std::size_t i = 0; i < modes.eigenvalue.size(); ++i) {
    if (!modes.elastic(i)) continue;
    std::vector<std::size_t> by_mode(rows.size());
    std::iota(by_mode.begin(), by_mode.end(), std::size_t{0});
    const double f = modes.frequency(i);
    std::stable_sort(by_mode.begin(), by_mode.end(),
                     [&](auto a, auto b) { return shift(modes, rows[a], i) < shift(modes, rows[b], i); });
    s += fmt::format("  mode {:>4} {:>12.6g} ", i + 1, f);
    for (std::size_t w = 0; w < std::min<std::size_t>(5, by_mode.size()); ++w)
      s += fmt::format("  {}: {:.3f}", rows[by_mode[w]].name(), shift(modes, rows[by_mode[w]], i));
    s += '\n';
  }
  return s + '\n';
}

output::WeldDropReport report(const nvh::Modes& modes, const Row& row) {
  const std::size_t i = worst_mode(modes, row);
  output::WeldDropReport r{row.ids, static_cast<int>(i) + 1, modes.frequency(i), row.first_order[i], row.estimate[i],
                           {}};
  if (row.holds_solved(i)) r.solved = row.solved[i];
  return r;
}

}  // namespace

std::optional<DropRequest> drop_request(const std::string& word, const system::System& system,
                                        std::string& error_text) {
  const std::vector<weld::Weld>& welds = system.ties.welds;
  DropRequest request;
  if (word == "all") {
    request.each = true;
    for (std::size_t w = 0; w < welds.size(); ++w)
      if (nvh::can_drop(system, w)) request.groups.push_back({w});
    if (!request.groups.empty()) return request;
    error_text = "the deck has no weld of beams or bricks";
    return {};
  }
  const auto ids = read_weld_ids(word, error_text);
  if (!ids) return {};
  nvh::WeldGroup group;
  for (const int id : *ids) {
    const std::size_t before = group.size();
    for (std::size_t w = 0; w < welds.size(); ++w) {
      if (welds[w].id != id) continue;
      if (!nvh::can_drop(system, w)) {
        error_text = fmt::format(
            "weld {} is a rigid constraint or was deleted: it has no stiffness to be taken out; "
            "take its keyword out of the deck and compare with --compare",
            id);
        return {};
      }
      group.push_back(w);
    }
    if (group.size() == before) {
      error_text = fmt::format("there is no weld {}; welds.csv of `nugget check` lists them", id);
      return {};
    }
  }
  std::sort(group.begin(), group.end());
  group.erase(std::unique(group.begin(), group.end()), group.end());
  request.groups.push_back(group);
  return request;
}

std::string weld_study(const std::filesystem::path& directory, const nvh::Matrices& m, const nvh::Modes& modes,
                       const DropRequest& request, const std::optional<model::Units>& units, output::Summary& summary,
                       const nvh::ProgressCallback& progress) {
  const std::vector<nvh::WeldDrop> drops = nvh::drop_welds(m, modes, request.groups, progress);
  std::vector<Row> rows;
  for (std::size_t g = 0; g < drops.size(); ++g) {
    Row row;
    for (const std::size_t w : request.groups[g]) row.ids.push_back(m.system.ties.welds[w].id);
    for (const double v : drops[g].first_order) row.first_order.push_back(frequency(v));
    for (const double v : drops[g].eigenvalue) row.estimate.push_back(frequency(v));
    for (const double v : drops[g].new_modes) row.new_modes.push_back(frequency(v));
    row.mac = drops[g].mac;
    rows.push_back(std::move(row));
  }
  if (rows.empty()) return {};
  std::vector<double> fall;
  for (const Row& row : rows) fall.push_back(shift(modes, row, worst_mode(modes, row)));
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return fall[a] < fall[b]; });

  constexpr std::size_t checked = 3;
  for (std::size_t r = 0; r < std::min(checked, order.size()); ++r)
    solve_anew(m, modes, request.groups[order[r]], rows[order[r]], progress);
  write_rows(directory, modes, rows);
  for (const std::size_t g : order) summary.weld_drops.push_back(report(modes, rows[g]));
  return request.each ? ranking(modes, rows, order, units) : table_of_modes(modes, rows.front(), units);
}

}  // namespace nugget::app
