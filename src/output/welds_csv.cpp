// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/append.hpp"
#include "output/result_file.hpp"
#include "output/summary.hpp"

namespace nugget::output {
namespace {

/// One line of comma-separated cells; text with commas, quotes or line ends is quoted (RFC 4180).
class CsvLine {
 public:
  explicit CsvLine(std::string& out) : out_(out) {}
  ~CsvLine() { out_ += '\n'; }
  CsvLine(const CsvLine&) = delete;
  CsvLine& operator=(const CsvLine&) = delete;

  void cell(std::string_view text) {
    separate();
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
      out_ += text;
      return;
    }
    out_ += '"';
    for (const char c : text) out_ += c == '"' ? std::string("\"\"") : std::string(1, c);
    out_ += '"';
  }
  void cell(int value) {
    separate();
    append(out_, "{}", value);
  }
  void cell(double value) {
    separate();
    if (std::isfinite(value)) append(out_, "{}", value);
  }
  void flag(bool value) { cell(std::string_view(value ? "yes" : "no")); }

 private:
  void separate() {
    if (!first_) out_ += ',';
    first_ = false;
  }
  std::string& out_;
  bool first_ = true;
};

void head(std::string& out, std::size_t projections, const std::vector<WeldReport>& welds) {
  CsvLine line(out);
  for (const char* name : {"id",
                           "kind",
                           "part",
                           "sheet1",
                           "sheet2",
                           "x",
                           "y",
                           "z",
                           "diameter",
                           "length",
                           "tied",
                           "failed",
                           "failure_time",
                           "failure_mode",
                           "peak_axial",
                           "peak_shear",
                           "peak_bending",
                           "peak_torsion",
                           "peak_force",
                           "peak_failure",
                           "peak_failure_time",
                           "last_axial",
                           "last_shear",
                           "last_bending",
                           "last_torsion",
                           "last_force",
                           "last_strain_rate",
                           "last_failure",
                           "last_terms",
                           "last_bending_1",
                           "last_bending_2",
                           "damage",
                           "energy",
                           "energy_passed",
                           "most_energy_passed",
                           "failure_interval",
                           "failure_course",
                           "added_mass"})
    line.cell(name);
  if (!welds.empty())
    for (const auto& [name, value] : welds.front().audit) line.cell(name);
  line.cell("remarks");
  for (std::size_t i = 1; i <= projections; ++i)
    for (const char* name : {"node", "case", "moved", "xi", "eta", "segment", "reason"})
      line.cell(fmt::format("{}{}", name, i));
}

void projection_cells(CsvLine& line, const WeldProjection& p) {
  line.cell(p.node);
  line.cell(p.case_number);
  line.cell(p.moved);
  line.cell(p.xi);
  line.cell(p.eta);
  line.cell(fmt::format("{}", fmt::join(p.segment, " ")));
  line.cell(p.reason);
}

void identity_cells(CsvLine& line, const WeldReport& weld) {
  const auto sheet = [&](std::size_t i) {
    return i < weld.sheets.size() ? fmt::format("{}", weld.sheets[i]) : std::string();
  };
  line.cell(weld.id);
  line.cell(weld.kind);
  line.cell(weld.part);
  line.cell(sheet(0));
  // A weld through three sheets keeps the rest of them in the last cell.
  line.cell(weld.sheets.size() > 2 ? fmt::format("{}", fmt::join(weld.sheets.begin() + 1, weld.sheets.end(), " "))
                                   : sheet(1));
  for (const double x : {weld.middle.x, weld.middle.y, weld.middle.z}) line.cell(x);
  line.cell(weld.diameter);
  line.cell(weld.length);
  line.flag(weld.tied);
}

void history_cells(CsvLine& line, const WeldReport& weld) {
  line.flag(weld.failed);
  line.cell(weld.failure_time ? fmt::format("{}", *weld.failure_time) : std::string());
  line.cell(weld.failure_mode);
  for (const double value :
       {weld.peak.axial, weld.peak.shear, weld.peak.bending, weld.peak.torsion, weld.peak.force, weld.peak_failure,
        weld.peak_failure_time, weld.last.axial, weld.last.shear, weld.last.bending, weld.last.torsion,
        weld.last.force(), weld.last.strain_rate, weld.last.failure})
    line.cell(value);
  line.cell(weld.last.terms);
  for (const double value : weld.last.bending_at) line.cell(value);
  line.cell(weld.damage);
  for (const double value : {weld.energy, weld.passed, weld.most_passed}) line.cell(value);
  line.cell(weld.failure_course.empty() ? std::numeric_limits<double>::quiet_NaN() : weld.course_interval);
  std::string course;
  for (const double value : weld.failure_course) course += fmt::format("{}{:.4g}", course.empty() ? "" : " ", value);
  line.cell(course);
}

void row(std::string& out, const WeldReport& weld, std::size_t projections) {
  CsvLine line(out);
  identity_cells(line, weld);
  history_cells(line, weld);
  line.cell(weld.added_mass);
  for (const auto& [name, value] : weld.audit) line.cell(value);
  line.cell(fmt::format("{}", fmt::join(weld.remarks, "; ")));
  for (std::size_t i = 0; i < projections; ++i) {
    if (i < weld.projections.size()) {
      projection_cells(line, weld.projections[i]);
    } else {
      for (int empty = 0; empty < 7; ++empty) line.cell("");
    }
  }
}

/// `after_row` may take what is there out of `out`.
template <class AfterRow>
void table(std::string& out, const std::vector<WeldReport>& welds, const AfterRow& after_row) {
  // Beams have two ends; brick welds and patches of them have more nodes, and none is left out.
  std::size_t projections = 2;
  for (const WeldReport& weld : welds) projections = std::max(projections, weld.projections.size());
  head(out, projections, welds);
  for (const WeldReport& weld : welds) {
    row(out, weld, projections);
    after_row();
  }
}

}  // namespace

std::string weld_table(const std::vector<WeldReport>& welds) {
  std::string out;
  table(out, welds, [] {});
  return out;
}

void write_welds(const std::filesystem::path& directory, const std::vector<WeldReport>& welds) {
  write_whole_file(directory / "welds.csv", [&](ResultFile& file) {
    table(file.buffer(), welds, [&file] {
      if (file.buffer().size() >= part_of_text) file.commit();
    });
    file.commit();
  });
}

}  // namespace nugget::output
