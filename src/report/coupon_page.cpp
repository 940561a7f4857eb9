// SPDX-License-Identifier: Apache-2.0
#include "report/coupon_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "output/column_units.hpp"
#include "output/result_file.hpp"
#include "report/page.hpp"
#include "report/plot.hpp"

namespace nugget::report {
namespace {

std::string csv_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : std::string();
}

/// In a table to read: a dash where the function sets no limit.
std::string table_cell(double value, int digits = 4) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : std::string("-");
}

std::string ending(const CouponResult& r) {
  return r.failed ? r.failure_mode : "holds to the end";
}

Plot force_over_angle(const CouponStudy& study) {
  Plot plot{"angle between load and sheets [degrees]", "force", study.angle, {}, false, false, {}};
  plot.curves.emplace_back("the card's own failure function, forces only", study.surface);
  Plot::Trace ks2{"KS-2 runs", {}, {}, true}, others{"lap shear, coach peel, cross tension", {}, {}, true},
      held{"the weld held to the end", {}, {}, true};
  for (const CouponResult& r : study.results) {
    Plot::Trace& trace = !r.failed ? held : r.name.starts_with("ks2") ? ks2 : others;
    trace.x.push_back(r.angle);
    trace.y.push_back(r.peak);
  }
  for (Plot::Trace* trace : {&ks2, &others, &held})
    if (!trace->x.empty()) plot.traces.push_back(*trace);
  return plot;
}

Plot force_over_displacement(const CouponStudy& study) {
  Plot plot{"displacement of the grip", "force", {}, {}, false, false, {}};
  for (const CouponResult& r : study.results) plot.traces.push_back({r.title, r.displacement, r.force, false});
  return plot;
}

std::string result_rows(const CouponStudy& study) {
  std::string s =
      "<table id=\"coupons\"><tr><th class=\"text\">coupon</th><th>angle</th><th>peak "
      "force</th><th>at</th><th>work</th>"
      "<th>surface</th><th>peak / surface</th><th class=\"text\">weld</th><th>axial</th><th>shear</th><th>bending</th>"
      "<th>torsion</th><th>its angle</th><th>its force / surface</th></tr>\n";
  for (const CouponResult& r : study.results) {
    s += fmt::format("<tr class=\"coupon\" id=\"{}\"><td class=\"text\">{}</td><td>{:g}</td>", r.name, escaped(r.title),
                     r.angle);
    for (const double value : {r.peak, r.at, r.work, r.surface}) s += fmt::format("<td>{}</td>", table_cell(value));
    s += fmt::format("<td>{}</td><td class=\"text\">{}</td>", table_cell(r.peak / r.surface, 3), escaped(ending(r)));
    for (const double value : {r.axial, r.shear, r.bending, r.torsion})
      s += fmt::format("<td>{}</td>", table_cell(value));
    s += fmt::format("<td>{}</td><td>{}</td></tr>\n", table_cell(r.load_angle(), 3),
                     table_cell(r.load() / r.surface_at_load, 3));
  }
  return s + "</table>\n";
}

std::string coupon_html(const CouponStudy& study) {
  std::string body = fmt::format("<h1>Coupons of {}</h1>\n<p class=\"sub\">units {}</p>\n<ul>", escaped(study.card),
                                 escaped(std::string(study.units.description)));
  for (const std::string& note : study.notes) body += fmt::format("<li>{}</li>\n", escaped(note));
  body +=
      "</ul>\n<h2>Force over angle</h2>\n" + to_svg(force_over_angle(study)) +
      "<p>Line: the force at which the failure function of the card reaches 1, without moments and at a strain rate "
      "of 0. Points: largest force of the grip in a run. A point below the line: moments in the weld, or a force "
      "that is not along the pull; above it: strain rates, or a weld that yields or fades before it fails.</p>\n";
  body += "<h2>Force over displacement</h2>\n" + to_svg(force_over_displacement(study));
  body +=
      "<h2>Runs</h2>\n" + result_rows(study) +
      "<p>Weld: its resultants when it failed, or at the end; surface: the line above at the angle of the pull, and "
      "at that of the weld's own force.</p>\n";
  return html_page(fmt::format("Coupons of {}", study.card), body);
}

std::string result_csv(const CouponStudy& study) {
  std::string s =
      "test,angle,peak_force,displacement,work,surface_force,failed,failure_mode,axial,shear,bending,torsion,"
      "failure_value,load,load_angle,surface_at_load\n";
  for (const CouponResult& r : study.results)
    s += fmt::format("{},{:g},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", r.name, r.angle, csv_number(r.peak),
                     csv_number(r.at), csv_number(r.work), csv_number(r.surface), r.failed ? "yes" : "no",
                     r.failure_mode, csv_number(r.axial), csv_number(r.shear), csv_number(r.bending),
                     csv_number(r.torsion), csv_number(r.failure_value), csv_number(r.load()),
                     csv_number(r.load_angle()), csv_number(r.surface_at_load));
  return s;
}

std::string curve_csv(const CouponStudy& study) {
  std::string s = "test,angle,displacement,force\n";
  for (const CouponResult& r : study.results)
    for (std::size_t i = 0; i < r.force.size(); ++i)
      s += fmt::format("{},{:g},{},{}\n", r.name, r.angle, csv_number(r.displacement[i]), csv_number(r.force[i]));
  return s;
}

std::string surface_csv(const CouponStudy& study) {
  std::string s = "angle,force,axial,shear\n";
  for (std::size_t i = 0; i < study.angle.size(); ++i) {
    const double radians = study.angle[i] * std::numbers::pi / 180.0;
    s +=
        fmt::format("{:g},{},{},{}\n", study.angle[i], csv_number(study.surface[i]),
                    csv_number(study.surface[i] * std::sin(radians)), csv_number(study.surface[i] * std::cos(radians)));
  }
  return s;
}

}  // namespace

double CouponResult::load() const {
  return std::hypot(axial, shear);
}

double CouponResult::load_angle() const {
  return std::atan2(axial, shear) * 180.0 / std::numbers::pi;
}

std::string coupon_table(const CouponStudy& study) {
  std::string s =
      fmt::format(" {:<18} {:>6} {:>11} {:>11} {:>11} {:>8}  {:<17} {:>10} {:>10} {:>10}\n", "coupon", "angle",
                  "peak force", "at", "surface", "ratio", "weld failed by", "axial", "shear", "bending");
  for (const CouponResult& r : study.results)
    s += fmt::format(" {:<18} {:>6g} {:>11} {:>11} {:>11} {:>8}  {:<17} {:>10} {:>10} {:>10}\n", r.title, r.angle,
                     table_cell(r.peak), table_cell(r.at), table_cell(r.surface), table_cell(r.peak / r.surface, 3),
                     ending(r), table_cell(r.axial), table_cell(r.shear), table_cell(r.bending));
  const auto unit = [&](const Dimension& d) { return model::symbol(study.units, d); };
  return s + fmt::format(" forces in {}, lengths in {}, moments in {}\n", unit(dimension::force),
                         unit(dimension::length), unit(dimension::moment));
}

void write_coupon_study(const std::filesystem::path& directory, const CouponStudy& study) {
  output::write_whole_file(directory / "coupon.csv", result_csv(study));
  output::write_whole_file(directory / "curves.csv", curve_csv(study));
  output::write_whole_file(directory / "surface.csv", surface_csv(study));
  output::write_column_units(directory, study.units);
  output::write_whole_file(directory / "coupon.svg", to_svg_file({{force_over_angle(study)}}));
  output::write_whole_file(directory / "curves.svg", to_svg_file({{force_over_displacement(study)}}));
  output::write_whole_file(directory / "coupon.html", coupon_html(study));
}

}  // namespace nugget::report
