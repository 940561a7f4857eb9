// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "weld/failure/connection.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld::failure {
namespace {

using model::Index;
using model::none;

const std::string keyword = "*MAT_SPOTWELD";

/// Cowper-Symonds constants of a sheet's material, where its law has them.
void take_rate_constants(const model::Model& model, Index part, SheetStrength& sheet) {
  const Index material = material_of_sheet(model, part);
  if (material == none) return;
  const auto take = [&](const auto& law) {
    if constexpr (requires { law.rate_c; }) {
      sheet.rate_c = law.rate_c;
      sheet.rate_p = law.rate_p;
    }
  };
  std::visit(take, model.materials[material].law);
}

std::unique_ptr<Function> by_sheet(const model::Model& model, const Geometry& weld, const Place& place,
                                   Findings& findings) {
  std::array<SheetStrength, 2> sheets;
  bool is_any = false;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto entry = std::find_if(model.rupture_stresses.begin(), model.rupture_stresses.end(),
                                    [&](const model::RuptureStress& r) { return r.part == weld.sheet[k]; });
    if (entry == model.rupture_stresses.end()) continue;
    is_any = true;
    sheets[k].normal = entry->normal;
    sheets[k].shear = entry->shear;
    take_rate_constants(model, entry->part, sheets[k]);
  }
  if (!is_any)
    findings.warning(place, keyword, "OPT 6, but neither sheet of the weld has a *DEFINE_SPOTWELD_RUPTURE_STRESS",
                     "define it for a sheet's part; until then stresses do not fail this weld");
  return sheet_stress(sheets, weld);
}

/// `part 7`, or `no part` of an end on no sheet.
std::string sheet_name(const model::Model& model, Index part) {
  return part == none ? "no part" : fmt::format("part {}", model.parts[part].id);
}

/// A criterion without a strength fails nothing: that is hardly meant.
void warn_of_no_strength(const model::Model& model, const Geometry& weld, const Place& place, std::string_view rule,
                         std::string_view remedy, Findings& findings) {
  findings.warning(place, keyword,
                   fmt::format("{} has no strength for a weld of {} to {}", rule, sheet_name(model, weld.sheet[0]),
                               sheet_name(model, weld.sheet[1])),
                   fmt::format("{}; until then stresses do not fail this weld", remedy));
}

std::unique_ptr<Function> by_pair(const model::Model& model, const model::PairStrengths& table, const Geometry& weld,
                                  const Place& place, Findings& findings) {
  const auto same = [&](const model::PairStrengths::Pair& p) {
    const auto& [i, j] = p.parts;
    return (i == weld.sheet[0] && j == weld.sheet[1]) || (i == weld.sheet[1] && j == weld.sheet[0]);
  };
  const auto pair = std::find_if(table.pairs.begin(), table.pairs.end(), same);
  const model::PairStrengths::Pair& found = pair == table.pairs.end() ? table.standard : *pair;
  if (!found.normal.given() && !found.shear.given())
    warn_of_no_strength(model, weld, place, "OPT 7: *DEFINE_SPOTWELD_FAILURE_RESULTANTS",
                        "list the pair, or give DSN and DSS", findings);
  return beam_stress(found.normal, found.shear, weld);
}

double sheet_thickness(const model::LoadRateStrengths& table, const Geometry& weld) {
  const auto [a, b] = weld.thickness;
  switch (table.thickness_rule) {
    case 1: return 0.5 * (a + b);
    case 2: return std::max(a, b);
    case 3: return a + b;
    default: return weld.thinner();
  }
}

/// The strengths of a pair of parts, or of a material; the lower of both sheets'.
std::unique_ptr<Function> by_load_rate(const model::Model& model, const model::LoadRateStrengths& table,
                                       const Geometry& weld, const Place& place, Findings& findings) {
  const double thickness = table.thickness_scale * sheet_thickness(table, weld);
  if (!(thickness > 0.0))
    findings.warning(place, keyword, "OPT 10 needs the thickness of the sheets, but the weld is tied to no shell",
                     "tie the weld to its sheets; until then stresses do not fail it");
  double normal = 0.0, shear = 0.0;
  const auto lower = [](double& strength, double other) {
    if (other > 0.0 && (strength == 0.0 || other < strength)) strength = other;
  };
  for (std::size_t k = 0; k < 2; ++k) {
    const Index part = weld.sheet[k];
    const Index material = material_of_sheet(model, part);
    const auto fits = [&](const model::LoadRateStrengths::Entry& e) {
      if (e.parts[0] == none) return material != none && e.material == material;
      return (e.parts[0] == part && e.parts[1] == weld.sheet[1 - k]) ||
             (e.parts[1] == part && e.parts[0] == weld.sheet[1 - k]);
    };
    const auto entry = std::find_if(table.entries.begin(), table.entries.end(), fits);
    lower(normal, entry == table.entries.end() ? table.normal : entry->normal);
    lower(shear, entry == table.entries.end() ? table.shear : entry->shear);
  }
  if (normal == 0.0 && shear == 0.0)
    warn_of_no_strength(model, weld, place, "OPT 10: *DEFINE_SPOTWELD_FAILURE",
                        "give SN and SS of the sheets' materials, or D_SN and D_SS", findings);
  return load_rate_stress(table, normal, shear, weld.diameter, thickness);
}

/// The value of the law, or the weld's own where that is 0.
double own_or(double given, double own) {
  return given > 0.0 ? given : own;
}

/// A warning if a sheet's thickness is known neither from the law nor from the weld.
bool has_thickness(double thickness, const model::WeldLaw& law, const Place& place, Findings& findings) {
  if (thickness > 0.0) return true;
  findings.warning(
      place, keyword,
      fmt::format("OPT {} needs a sheet's thickness, but ZT is not given and the weld is tied to no shell", law.option),
      "give ZT; until then stresses do not fail this weld");
  return false;
}

std::unique_ptr<Function> without_terms() {
  return resultant_surface({});
}

std::unique_ptr<Function> by_connection(const model::Model& model, const model::WeldLaw& law, const Geometry& weld,
                                        const Place& place, Findings& findings) {
  if (law.properties == none) return without_terms();
  const model::ConnectionProperties& properties = model.connections[law.properties];
  if (properties.area_rule != 0 && !(weld.thinner() > 0.0))
    findings.warning(place, keyword, "AREAEQ needs the thickness of the sheets, but the weld is tied to no shell",
                     "tie the weld to its sheets; until then its area is that of its bricks");
  if (properties.functions) check_functions(model, properties, weld, place, findings);
  const ConnectionRecord record = connection_record(model, properties, weld);
  if (!record.normal.given() && !record.bending.given() && !record.shear.given())
    warn_of_no_strength(model, weld, place, "*DEFINE_CONNECTION_PROPERTIES",
                        "give SN, SB and SS of the sheets' materials, or D_SN, D_SB and D_SS", findings);
  return connection_stress(properties, record, law.rate_filter, weld);
}

}  // namespace

double Geometry::thinner() const {
  const auto [a, b] = thickness;
  return a > 0.0 && b > 0.0 ? std::min(a, b) : std::max(a, b);
}

Geometry disc(double diameter) {
  const double area = 0.25 * std::numbers::pi * diameter * diameter;
  return {diameter, area, 0.125 * area * diameter, {}, {none, none}};
}

Geometry geometry_of(const model::Model& model, const Weld& weld) {
  Geometry g = disc(weld.diameter);
  const Index section = weld.part == none ? none : model.parts[weld.part].section;
  if (weld.kind == Weld::Kind::beam && section != none) {
    const model::SectionBeam& s = model.beam_sections[section];
    const double d = g.diameter, inner = 0.5 * (s.inner[0] + s.inner[1]), pi = std::numbers::pi;
    g.area = 0.25 * pi * (d * d - inner * inner);
    if (d > 0.0) g.section_modulus = pi / 32.0 * (d * d * d * d - inner * inner * inner * inner) / d;
  }
  g.id = weld.id;
  g.part = weld.part;
  g.length = weld.length;
  g.sheet = weld.sheets;
  g.shell = shell_factors(model, weld);
  if (weld.of_bricks()) {
    // TRUE_T is documented for single bricks.
    const double true_thickness = law_of(model, weld).damage.true_thickness;
    g.height = weld.kind == Weld::Kind::solid && true_thickness > 0.0 ? true_thickness : weld.length;
  }
  std::array<int, 2> shells{};
  for (const Projection& end : weld.ends) {
    // An end that is a sheet's own node has no tie, and its sheet is as thick.
    const Index of_end = end.projection_case == 0 ? end.closest_shell : end.tie.shell;
    if (!end.tied || of_end == none) continue;
    const auto shell = at(of_end);
    for (std::size_t k = 0; k < 2; ++k) {
      if (model.shells.part[shell] != g.sheet[k]) continue;
      g.thickness[k] += model.shells.thickness[shell];
      ++shells[k];
    }
  }
  for (std::size_t k = 0; k < 2; ++k)
    if (shells[k] > 0) g.thickness[k] /= shells[k];
  return g;
}

FailureMode Value::largest() const {
  const auto end = term.begin() + terms;
  return std::max_element(term.begin(), end, [](const Term& a, const Term& b) { return a.value < b.value; })->mode;
}

namespace {

/// The failure function of a weld as it is loaded at mid-length.
std::unique_ptr<Function> plain_function(const model::Model& model, const model::WeldLaw& law, const Geometry& weld,
                                         const Place& place, Findings& findings) {
  if (law.connection) return by_connection(model, law, weld, place, findings);
  if (law.function != none) return user_formula(model.functions[law.function].formula, law, weld);
  if (law.user()) return model.weld_library ? user_library(model, law, weld) : without_terms();  // reported where read
  switch (law.option) {
    case 1: return beam_stress(law.normal_stress, law.shear_stress, weld);
    case 3:
    case 4: {
      const double t = own_or(law.thickness[0], weld.thinner());
      if (!has_thickness(t, law, place, findings)) return without_terms();
      return notch_stress(law, own_or(law.diameter, weld.diameter), t);
    }
    case 5: {
      const std::array<double, 2> t{own_or(law.thickness[0], weld.thickness[0]),
                                    own_or(law.thickness[1], weld.thickness[1])};
      has_thickness(std::max(t[0], t[1]), law, place, findings);
      return structural_stress(own_or(law.diameter, weld.diameter), t, law.limit);
    }
    case 6: return by_sheet(model, weld, place, findings);
    case 7: return by_pair(model, model.pair_strengths[law.table], weld, place, findings);
    case 10: return by_load_rate(model, model.load_rate_strengths[law.table], weld, place, findings);
    case 11: return direction(law);
    default: return resultant_surface(law);
  }
}

/// Those that ask for bending moments at the ends: OPT -2 to 2, 7, 12, 22 and _DA.
bool has_moments(const model::WeldLaw& law) {
  return law.connection || law.option <= 1 || law.option == 7 || law.user();
}

/// Those that remember earlier loads, and can be asked once a cycle only.
bool remembers(const model::WeldLaw& law) {
  return law.connection || (law.user() && law.function == none);
}

/// Those whose terms add up to the value.
bool is_sum(const model::WeldLaw& law) {
  return !law.connection && law.function == none &&
         (law.option <= 1 || law.option == 6 || law.option == 7 || law.option == 10);
}

bool is_scaled(const Geometry& weld) {
  return std::any_of(weld.shell.begin(), weld.shell.end(),
                     [](const Geometry::ShellFactor& f) { return f.tension != 1.0 || f.shear != 1.0; });
}

}  // namespace

std::unique_ptr<Function> make_function(const model::Model& model, const model::WeldLaw& law, const Geometry& weld,
                                        const Place& place, Findings& findings) {
  auto function = plain_function(model, law, weld, place, findings);
  if (weld.height > 0.0 && has_moments(law)) function = worse_end(std::move(function), weld.height, remembers(law));
  if (!is_scaled(weld)) return function;
  if (is_sum(law)) return by_shell_size(std::move(function), weld.shell);
  findings.warning(
      place, "*CONTROL_SPOTWELD_BEAM",
      fmt::format("LCT, LCS, T_ORT and T_ORS do not act on OPT {}, whose value is no sum of tension and shear",
                  law.option),
      "use OPT 0, 1, 6, 7 or 10, or leave them 0");
  return function;
}

}  // namespace nugget::weld::failure
