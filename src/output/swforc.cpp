// SPDX-License-Identifier: Apache-2.0
#include "output/swforc.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::output {
namespace {

const char* label(WeldKind kind) {
  switch (kind) {
    case WeldKind::constraint: return "constraint/weld  ID ";
    case WeldKind::generalized: return "generalized weld ID ";
    case WeldKind::beam: return "spotweld beam  ID   ";
    case WeldKind::solid: return "spotweld solid ID   ";
    case WeldKind::nonnodal: return "nonnodal cnst  ID   ";
    case WeldKind::assembly: return "spotweld assmy ID   ";
  }
  return "";
}

/// A number of 0 and more in seven columns, with as many digits as fit.
std::string number_in_seven(double value) {
  constexpr double below_failure = 0.99999;  // what is below 1 is not rounded to it
  constexpr double least_fixed = 1e-3, most_fixed = 999999.0;
  if (std::isnan(value)) return "    nan";
  if (value < 1e-99) return "0.00000";
  if (value < 1.0) value = std::min(value, below_failure);
  if (value < least_fixed || value > most_fixed) return fmt::format("{:.1E}", std::min(value, 9.9e99));
  for (int digits = 5;; --digits)
    if (const std::string text = fmt::format("{:.{}f}", value, digits); text.size() <= 7 || digits == 0)
      return fmt::format("{:>7}", text);
}

bool is_brick(WeldKind kind) {
  return kind == WeldKind::solid || kind == WeldKind::assembly;
}

/// ` fcmx=1.29+00 t=1.25E-03`, of OPT -2.
std::string peak(const SwforcRow& row) {
  if (!row.peak) return "";
  return fmt::format(" fcmx={} t={:8.2E}", number_in_seven(row.peak->first), row.peak->second);
}

/// ` fres=  1.23450E+03`, where it is asked for.
std::string resultant(const SwforcRow& row, const SwforcState& state) {
  return state.resultant_force ? fmt::format(" fres={:13.5E}", column(row.force())) : "";
}

/// What stands behind the label: length, moment and torsion where the kind has them, or when the weld failed.
std::string tail(const SwforcRow& row) {
  switch (row.kind) {
    case WeldKind::generalized: return "";
    case WeldKind::constraint:
      return (row.length > 0.0 ? fmt::format("{:13.5E}", column(row.length)) : "") +
             fmt::format("{:13.5E}", column(row.resultant_moment));
    default: break;
  }
  if (row.failure_time > 0.0) return fmt::format("               failure time={:12.4E}", row.failure_time);
  return fmt::format("{:13.5E}{:13.5E}{:13.5E}{}", column(row.length), column(row.resultant_moment),
                     column(row.torsion), peak(row));
}

void print(AsciiFile& file, const SwforcState& state) {
  file.print(
      "\n constraint #      axial        shear         time  failure                                       length  "
      "rslt "
      "moment      torsion\n");
  int number = 0;
  for (const SwforcRow& row : state.rows) {
    file.print("      {:5}{:13.5E}{:13.5E}{:13.5E}", ++number, column(row.axial), column(row.shear),
               column(state.time));
    if (is_brick(row.kind))
      file.print(" {:8.4f}    ", row.failure);
    else
      file.print("  {}    ", failure_column(row.failure, row.failure_time > 0.0));
    file.print("{}{:8}{}{}\n", label(row.kind), row.id, tail(row), resultant(row, state));
  }
}

}  // namespace

std::string failure_column(double failure, bool has_failed) {
  if (has_failed) return "failure";
  return number_in_seven(failure);
}

const HistoryFormat<SwforcState>& swforc() {
  static const HistoryFormat<SwforcState> format{
      .branches = {{
          .path = "swforc",
          .ids = ids(&SwforcState::rows, &SwforcRow::id),
          .once =
              columns(&SwforcState::rows,
                      {
                          {"typenames",
                           [](const SwforcState&) { return "constraint,weld,beam,solid,non nodal, ,solid assembly"; },
                           dimension::number, "names of the types, from 0"},
                          {"types", &SwforcRow::kind, dimension::number, "what kind of weld it is"},
                      }),
          .columns = columns(&SwforcState::rows,
                             {
                                 {"time", &SwforcState::time, dimension::time, "time"},
                                 {"axial", &SwforcRow::axial, dimension::force, "axial force of a weld"},
                                 {"shear", &SwforcRow::shear, dimension::force, "resultant shear force"},
                                 {"failure", &SwforcRow::failure, dimension::number,
                                  "value of the failure function; 1 is failure"},
                                 {"failure_time", &SwforcRow::failure_time, dimension::time,
                                  "when the weld failed; 0: it has not"},
                                 {"length", &SwforcRow::length, dimension::length, "length now"},
                                 {"resultant_moment", &SwforcRow::resultant_moment, dimension::moment,
                                  "resultant bending moment"},
                                 {"torsion", &SwforcRow::torsion, dimension::moment, "torsional moment"},
                             }) +
                     columns(&SwforcState::rows, {{"resultant_force", &SwforcRow::force, dimension::force,
                                                   "resultant of axial and shear force; with OPTION1 = 1 only"}})
                         .where([](const SwforcState& s) { return s.resultant_force; }) +
                     columns(&SwforcState::rows,
                             {
                                 {"max_failure", [](const SwforcRow& r) { return r.peak ? r.peak->first : 0.0; },
                                  dimension::number, "largest failure value so far, of OPT -2"},
                                 {"max_failure_time", [](const SwforcRow& r) { return r.peak ? r.peak->second : 0.0; },
                                  dimension::time, "its time"},
                             })
                         .where([](const SwforcState& s) {
                           return std::any_of(s.rows.begin(), s.rows.end(),
                                              [](const SwforcRow& r) { return r.peak.has_value(); });
                         }),
      }},
      .print = print,
  };
  return format;
}

}  // namespace nugget::output
