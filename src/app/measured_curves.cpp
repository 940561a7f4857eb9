// SPDX-License-Identifier: Apache-2.0
#include "app/measured_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>

#include "app/table_lines.hpp"
#include "deck/numbers.hpp"

namespace nugget::app {
namespace {

std::optional<weld::CouponTest> test_of(const std::string& name) {
  for (const weld::CouponTest& test : weld::coupon_tests())
    if (test.name() == name) return test;
  double angle = 0.0;
  if (name.starts_with("ks2_") && deck::parse_real(name.substr(4), angle) && angle >= 0.0 && angle <= 90.0)
    return weld::CouponTest{weld::CouponKind::ks2, angle};
  return {};
}

/// Where the columns stand; -1: there is none.
struct CurveColumns {
  int test = -1, sample = -1, displacement = -1, force = -1;
};

CurveColumns columns_of(const std::vector<std::string>& names) {
  const auto place = [&](const char* name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
  };
  return {place("test"), place("sample"), place("displacement"), place("force")};
}

}  // namespace

std::vector<MeasuredCurve> read_curves(const std::string& file, Findings& findings) {
  std::ifstream in(file);
  if (!in)
    findings.error({file, 0, 0}, {}, "the measured curves cannot be read", "give a table of test, displacement, force");
  std::optional<CurveColumns> columns;
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  std::vector<MeasuredCurve> curves;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    const Place place{file, ++number, 0};
    if (is_remark(line)) continue;
    const std::vector<std::string> cells = cells_of(line);
    if (!columns) {
      columns = columns_of(cells);
      if (columns->test >= 0 && columns->displacement >= 0 && columns->force >= 0) continue;
      findings.error(place, {}, "the first line names the columns; expected test, displacement, force among them",
                     "begin the table with a line such as test,sample,displacement,force");
      return {};
    }
    const auto cell = [&](int column) {
      return column >= 0 && column < static_cast<int>(cells.size()) ? cells[column] : std::string();
    };
    const std::optional<weld::CouponTest> test = test_of(cell(columns->test));
    double displacement = 0.0, force = 0.0;
    if (!test) {
      findings.error(
          place, {},
          fmt::format("test = {}: expected lap_shear, coach_peel, cross_tension, or ks2_ and an angle from 0 to "
                      "90",
                      cell(columns->test)),
          "name the test so, or leave its lines out");
      return {};
    }
    if (!deck::parse_real(cell(columns->displacement), displacement) ||
        !deck::parse_real(cell(columns->force), force) || !std::isfinite(displacement) || !std::isfinite(force)) {
      findings.error(place, {},
                     fmt::format("displacement = {}, force = {}: expected two numbers", cell(columns->displacement),
                                 cell(columns->force)),
                     "correct the line");
      return {};
    }
    const auto [found, is_new] = known.try_emplace({test->name(), cell(columns->sample)}, curves.size());
    if (is_new) curves.push_back({*test, cell(columns->sample), {}, {}, 0.0, 0.0, place});
    MeasuredCurve& curve = curves[found->second];
    curve.displacement.push_back(displacement);
    curve.force.push_back(force);
    if (force > curve.peak) curve.peak = force, curve.at = displacement;
  }
  for (const MeasuredCurve& curve : curves)
    if (!(curve.peak > 0.0))
      findings.error(curve.place, {}, fmt::format("{} {}: no force above 0", curve.test.name(), curve.sample),
                     "forces that pull are positive");
  if (curves.empty() && findings.errors() == 0)
    findings.error({file, 0, 0}, {}, "there is no curve in it", "give a table of test, displacement, force");
  return curves;
}

}  // namespace nugget::app
