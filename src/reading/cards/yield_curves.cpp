// SPDX-License-Identifier: Apache-2.0
#include "reading/cards/yield_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nugget::reading {

namespace {

using deck::Row;

Curve bilinear(const Row& row) {
  const double E = row.real("e"), tangent = row.real("etan"), yield = row.real("sigy");
  const double slope = tangent < E ? E * tangent / (E - tangent) : 0.0;
  return {0, {0.0, 1.0}, {yield, yield + slope}};
}

/// The points EPS, ES: as many as are given. A first strain of 0 counts if it has a stress; from one above 0 the line
/// goes back to strain 0 (LS-DYNA Manual vol. II, MAT_024, EPS1).
Curve points(const Row& strain, const Row& stress) {
  Curve curve;
  for (int i = 1; i <= 8; ++i) {
    const double e = strain.real(fmt::format("eps{}", i)), s = stress.real(fmt::format("es{}", i));
    if (s == 0.0 && e == 0.0) break;
    curve.x.push_back(e);
    curve.y.push_back(s);
  }
  if (curve.x.size() > 1 && curve.x.front() > 0.0) {
    curve.y.insert(curve.y.begin(), curve.y.front() - curve.slope(curve.x.front()) * curve.x.front());
    curve.x.insert(curve.x.begin(), 0.0);
  }
  return curve;
}

void set_points(Builder& b, const YieldCards& cards, kernel::PiecewiseLinear& law, Curve curve) {
  if (!std::is_sorted(curve.x.begin(), curve.x.end(), std::less_equal<>{}))
    return refuse(b, cards.strain, "eps1", "plastic strains must ascend", "sort the points");
  if (*std::min_element(curve.y.begin(), curve.y.end()) <= 0.0)
    return refuse(b, cards.stress, "es1", "the points make a yield stress that is not above 0",
                  "give a yield stress above 0 at each point, from plastic strain 0 on");
  law.yield = {std::move(curve)};
}

void set_curve_or_table(Builder& b, const YieldCards& cards, kernel::PiecewiseLinear& law) {
  const int id = cards.rate.integer("lcss");
  if (id < 0) return refuse(b, cards.rate, "lcss", "a negative id is not supported", "give the curve's id");
  YieldTable table = yield_table(b, cards.rate.entry("lcss"), id, cards.log_rates);
  if (table.curves.empty()) return;
  law.yield = std::move(table.curves);
  law.rates = std::move(table.rates);
  law.log_rates = table.log_rates;
}

/// What of the rate effects counts: those of a table, else LCSR, else C and P (documented for the table, the rest is
/// of S. Bala's notes); how the rate is measured.
void set_rates(Builder& b, const YieldCards& cards, kernel::PiecewiseLinear& law) {
  const Row& row = cards.rate;
  const bool table = !law.rates.empty(), scaled = row.integer("lcsr") != 0;
  for (const auto* field : {"c", "lcsr"})
    if ((field[0] == 'c' ? row.real("c") > 0.0 : scaled) && (table || (field[0] == 'c' && scaled)))
      row.report(b.findings, Severity::warning, field,
                 table ? "not obeyed: the rates are those of the table in LCSS" : "C and P are not obeyed with LCSR",
                 "leave it empty");
  if (const Index scale = b.curve(row, "lcsr"); scale != none && !table)
    law.rate_scale = b.model.curves[static_cast<std::size_t>(scale)];
  if (!std::is_sorted(law.rate_scale.y.begin(), law.rate_scale.y.end()))
    warn_of_softening_by_rate(b, row.entry("lcsr"), fmt::format("curve {}", law.rate_scale.id));
  if (!table && !scaled && row.real("c") > 0.0 && row.real("p") > 0.0) {
    law.rate_c = row.real("c");
    law.rate_p = row.real("p");
  }
  const double vp = row.real("vp");
  if (vp != -1.0 && vp != 0.0 && vp != 1.0 && vp != 3.0 && vp != 4.0)
    return refuse(b, row, "vp", "expected -1, 0, 1, 3 or 4");
  if (vp != 0.0 && vp != 1.0)
    row.report(b.findings, Severity::warning, "vp",
               "computed as 0: the rate of the plastic strain, found together with the stress, without a filter",
               "write 0, or 1");
  if (vp == 1.0 && law.rate_c > 0.0) law.rate_yield = cards.main.real("sigy");
}

}  // namespace

const Card yield_strain_card{{
    real("eps1", dimension::number, 0, at_least(0), "plastic strain of point 1"),
    real("eps2", dimension::number, 0, at_least(0), "point 2"),
    real("eps3", dimension::number, 0, at_least(0), "point 3"),
    real("eps4", dimension::number, 0, at_least(0), "point 4"),
    real("eps5", dimension::number, 0, at_least(0), "point 5"),
    real("eps6", dimension::number, 0, at_least(0), "point 6"),
    real("eps7", dimension::number, 0, at_least(0), "point 7"),
    real("eps8", dimension::number, 0, at_least(0), "point 8"),
}};

const Card yield_stress_card{{
    real("es1", dimension::stress, 0, at_least(0), "yield stress of point 1"),
    real("es2", dimension::stress, 0, at_least(0), "point 2"),
    real("es3", dimension::stress, 0, at_least(0), "point 3"),
    real("es4", dimension::stress, 0, at_least(0), "point 4"),
    real("es5", dimension::stress, 0, at_least(0), "point 5"),
    real("es6", dimension::stress, 0, at_least(0), "point 6"),
    real("es7", dimension::stress, 0, at_least(0), "point 7"),
    real("es8", dimension::stress, 0, at_least(0), "point 8"),
}};

void check_tangent(Builder& b, const Row& row) {
  if (row.real("etan") >= row.real("e") && row.real("e") > 0.0)
    refuse(b, row, "etan", fmt::format("the tangent modulus must be below Young's modulus {:g}", row.real("e")));
}

void warn_of_half_a_rate(Builder& b, const deck::Entry& c, const deck::Entry& p) {
  if ((c.value > 0.0) == (p.value > 0.0)) return;
  (c.value > 0.0 ? p : c)
      .report(b.findings, Severity::warning, "Cowper-Symonds needs both constants: no rate effect",
              "give both, or neither");
}

void warn_of_softening_by_rate(Builder& b, const deck::Entry& field, const std::string& where) {
  field.report(
      b.findings, Severity::warning,
      fmt::format("the yield stress falls with the rate ({}): the rate of a point then leaps from step to step", where),
      "let it rise with the rate, or stay");
}

YieldTable yield_table(Builder& b, const deck::Entry& field, int id, bool log_rates) {
  YieldTable y;
  y.log_rates = log_rates;
  std::vector<Index> curves;
  if (const Index t = b.tables.find(id); t != none) {
    const Table& table = b.model.tables[static_cast<std::size_t>(t)];
    if (table.curve.size() != table.value.size() || table.value.empty()) return {};  // reported where it is defined
    curves = table.curve;
    y.rates = table.value;
    if (y.rates.front() < 0.0) {
      y.log_rates = true;
      for (double& rate : y.rates) rate = std::exp(rate);
    } else if (log_rates && y.rates.front() == 0.0) {
      refuse(b, field, "a rate of 0 has no logarithm", "start the table at the lowest rate of the tests");
    }
  } else if (const Index c = b.curves.find(id); c != none) {
    curves = {c};
  } else {
    refuse(b, field, fmt::format("curve or table {} is not defined", id), "define it");
  }
  for (const Index c : curves) {
    y.curves.push_back(b.model.curves[static_cast<std::size_t>(c)]);
    const Curve& curve = y.curves.back();
    if (!curve.empty() && *std::min_element(curve.y.begin(), curve.y.end()) <= 0.0)
      refuse(b, field, fmt::format("curve {} has a yield stress that is not above 0", curve.id),
             "give the true yield stress over plastic strain, from strain 0 on");
    if (curve.x.size() < 2) continue;
    if (curve.x.front() != 0.0)
      field.report(b.findings, Severity::warning,
                   fmt::format("curve {} begins at a plastic strain of {:g}: {}", curve.id, curve.x.front(),
                               curve.x.front() > 0.0 ? "before it the yield stress is its first"
                                                     : "what lies below 0 has no effect"),
                   "begin it at plastic strain 0");
    if (!std::is_sorted(curve.y.begin(), curve.y.end()))
      field.report(b.findings, Severity::warning,
                   fmt::format("curve {} falls: results depend on the size of the elements there", curve.id),
                   "let it rise, and say by a failure strain or damage where the sheet ends");
  }
  for (std::size_t k = 1; k < y.curves.size(); ++k) {
    const Curve &slow = y.curves[k - 1], &fast = y.curves[k];
    if (slow.empty() || fast.empty()) continue;
    std::vector<double> strains = slow.x;
    strains.insert(strains.end(), fast.x.begin(), fast.x.end());
    for (const double e : strains)
      if (e >= 0.0 && fast.extrapolated(e) < (1.0 - 1e-6) * slow.extrapolated(e)) {
        warn_of_softening_by_rate(b, field,
                                  fmt::format("at a plastic strain of {:g} from curve {} to {}", e, slow.id, fast.id));
        break;
      }
  }
  return y;
}

void set_yield_curves(Builder& b, const YieldCards& cards, kernel::PiecewiseLinear& law) {
  law.yield = {bilinear(cards.main)};
  if (cards.rate.integer("lcss") != 0)
    set_curve_or_table(b, cards, law);
  else if (Curve curve = points(cards.strain, cards.stress); !curve.empty())
    set_points(b, cards, law, std::move(curve));
  else if (!(cards.main.real("sigy") > 0.0))
    refuse(b, cards.main, "sigy", "the yield stress must be given", "give SIGY and ETAN, EPS and ES, or LCSS");
  warn_of_half_a_rate(b, cards.rate.entry("c"), cards.rate.entry("p"));
  set_rates(b, cards, law);
}

}  // namespace nugget::reading
