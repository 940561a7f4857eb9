// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/card.hpp"
#include "weld/audit/mass_scaling_cost.hpp"
#include "weld/tie/ties.hpp"

// Is a weld modelled as it should be? Looked at once, after tying. Limits follow S. Bala, "Deformable Spotwelds in
// LS-DYNA for Impact and NVH Applications", where it gives them; docs/manual/audit.md says where each comes from.
namespace nugget::weld {

class Inspection;

/// What a check saw at one weld.
struct CheckResult {
  double value = std::numeric_limits<double>::quiet_NaN();  ///< measured; NaN: there is nothing to measure here
  double excess = 0.0;  ///< by what factor the value is beyond its limit; above 1 is a remark
  std::string text;     ///< what is wrong; only of a remark
  bool remark() const { return !text.empty(); }
};

/// One thing to look for at a weld.
struct Check {
  std::string_view name;     ///< short and stable: `diameter`
  std::string_view measure;  ///< what `value` is, for tables: `d / 5 sqrt(t)`; empty: no number
  std::string_view column;   ///< of welds.csv; empty: none
  std::string_view rule;     ///< what a weld without remark keeps to
  std::string_view remedy;
  Severity severity = Severity::warning;  ///< of a remark; notes are no findings
  CheckResult (*evaluate)(const Inspection&, const Weld&);
  Dimension dimension{};  ///< of `value`
};

/// All checks, in the order in which they are made.
std::span<const Check> checks();

struct Remark {
  const Check* check = nullptr;
  double excess = 0.0;
  std::string text;
};

/// What the audit says of one weld.
struct Report {
  std::vector<double> values;  ///< one a check, in the order of checks(); NaN where there is none
  std::size_t spot = 0;        ///< the first weld of the stack that it belongs to: welds above each other are one spot
  std::vector<Index> stack;    ///< parts of the sheets that its stack of welds joins, ascending, once a layer
  MassScalingCost cost;
  std::vector<Remark> remarks;
};

/// What one check found at all welds.
struct CheckSummary {
  const Check* check = nullptr;
  std::size_t remarks = 0;
  double least = std::numeric_limits<double>::quiet_NaN(), most = least;  ///< of the values
  std::vector<std::size_t> worst;  ///< welds with remarks, the worst first, at most `worst_shown`
};
inline constexpr std::size_t worst_shown = 5;
std::vector<CheckSummary> summarise(const std::vector<Report>& reports);

/// Makes all checks on all welds that are not deleted; one report a weld, in the order of Ties::welds. The worst welds
/// of each check that warns are findings, with one more that counts the rest; so are the things that concern contacts:
/// welds in a sliding contact, and more tie contacts than it takes.
std::vector<Report> audit(const model::Model& model, const Ties& ties, Findings& findings);

}  // namespace nugget::weld
