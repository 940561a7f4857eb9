// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "weld/ties.hpp"

// Is a weld modelled as it should be? Looked at once, after tying. Limits follow S. Bala, "Deformable Spotwelds in
// LS-DYNA".
namespace nugget::weld {

class Inspection;

/// One thing to look for. `look` returns what is wrong with a weld, or an empty text.
struct Check {
  std::string_view name;  ///< short and stable, for welds.csv: `diameter`
  std::string_view rule;  ///< what a sound weld keeps to
  std::string_view remedy;
  std::string (*look)(const Inspection&, const Weld&);
};

/// All checks, in the order in which they are made.
std::span<const Check> checks();

struct Remark {
  std::string_view check;  ///< its name
  std::string text;
};

/// What the audit says of one weld.
struct Report {
  double time_step = 0.0;  ///< of the weld as the deck gives it; infinite for a rigid weld, which limits nothing [time]
  double mass = 0.0;       ///< of the weld as the deck gives it [mass]
  double mass_by_dt = 0.0;     ///< that DT of the weld material will add [mass]
  double mass_by_dt2ms = 0.0;  ///< that DT2MS will add on top, up to a step of |DT2MS TSSFAC| [mass]
  std::vector<Remark> remarks;
};

/// Makes all checks on all welds that are not deleted; one report a weld, in the order of Ties::welds. Remarks are
/// warnings too, at most 20 of a kind. Time steps: L/sqrt(E/rho) of a beam; of a brick volume over largest face over
/// the speed of a plane wave.
std::vector<Report> audit(const model::Model& model, const Ties& ties, Findings& findings);

}  // namespace nugget::weld
