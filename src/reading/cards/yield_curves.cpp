// SPDX-License-Identifier: Apache-2.0
#include "reading/cards/yield_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nugget::reading {

namespace {

Curve bilinear(const YieldCards& cards) {
  const double slope = cards.etan < cards.e ? cards.e * cards.etan / (cards.e - cards.etan) : 0.0;
  return {0, {0.0, 1.0}, {cards.sigy, cards.sigy + slope}};
}

/// The points EPS, ES: as many as are given. A first strain of 0 counts if it has a stress; from one above 0 the line
/// goes back to strain 0 (LS-DYNA Manual vol. II, MAT_024, EPS1).
Curve points(const YieldCards& cards) {
  Curve curve;
  for (std::size_t i = 0; i < cards.eps.size(); ++i) {
    if (cards.es[i] == 0.0 && cards.eps[i] == 0.0) break;
    curve.x.push_back(cards.eps[i]);
    curve.y.push_back(cards.es[i]);
  }
  if (curve.x.size() > 1 && curve.x.front() > 0.0) {
    curve.y.insert(curve.y.begin(), curve.y.front() - curve.slope(curve.x.front()) * curve.x.front());
    curve.x.insert(curve.x.begin(), 0.0);
  }
  return curve;
}

void set_points(Builder& b, const YieldRows& rows, kernel::PiecewiseLinear& law, Curve curve) {
  if (!std::is_sorted(curve.x.begin(), curve.x.end(), std::less_equal<>{}))
    return refuse(b, rows.strain[at(&YieldCards::eps, 0)], "plastic strains must ascend", "sort the points");
  if (*std::min_element(curve.y.begin(), curve.y.end()) <= 0.0)
    return refuse(b, rows.stress[at(&YieldCards::es, 0)], "the points make a yield stress that is not above 0",
                  "give a yield stress above 0 at each point, from plastic strain 0 on");
  law.yield = {std::move(curve)};
}

/// Points behind one that is empty: they would not count, nor say so.
void refuse_gap(Builder& b, const YieldRows& rows) {
  const YieldCards& cards = rows.cards();
  const auto is_empty = [&](std::size_t i) { return cards.eps[i] == 0.0 && cards.es[i] == 0.0; };
  std::size_t end = 0;
  while (end < cards.eps.size() && !is_empty(end)) ++end;
  for (std::size_t i = end + 1; i < cards.eps.size(); ++i) {
    if (is_empty(i)) continue;
    return refuse(b, cards.es[i] == 0.0 ? rows.strain[at(&YieldCards::eps, i)] : rows.stress[at(&YieldCards::es, i)],
                  fmt::format("point {} stands behind point {}, which is empty", i + 1, end + 1),
                  "give the points one after the other, from the first on");
  }
}

void set_curve_or_table(Builder& b, const YieldRows& rows, kernel::PiecewiseLinear& law) {
  const deck::Entry lcss = rows.rate[&YieldCards::lcss];
  const int id = lcss.integer();
  if (id < 0) return refuse(b, lcss, "a negative id is not supported", "give the curve's id");
  YieldTable table = yield_table(b, lcss, id, rows.log_rates);
  if (table.curves.empty()) return;
  law.yield = std::move(table.curves);
  law.rates = std::move(table.rates);
  law.log_rates = table.log_rates;
}

/// What of the rate effects counts: those of a table, else LCSR, else C and P (documented for the table, the rest is
/// of S. Bala's notes); how the rate is measured.
void set_rates(Builder& b, const YieldRows& rows, kernel::PiecewiseLinear& law) {
  const YieldCards& cards = rows.cards();
  const deck::Entry lcsr = rows.rate[&YieldCards::lcsr],
                    vp = rows.rate.has(&YieldCards::vp) ? rows.rate[&YieldCards::vp] : lcsr;
  const bool table = !law.rates.empty(), scaled = cards.lcsr != 0;
  const auto not_obeyed = [&](const deck::Entry& field) {
    field.report(b.findings, Severity::warning,
                 table ? "not obeyed: the rates are those of the table in LCSS" : "C and P are not obeyed with LCSR",
                 "leave it empty");
  };
  if (cards.c > 0.0 && (table || scaled)) not_obeyed(rows.rate[&YieldCards::c]);
  if (scaled && table) not_obeyed(lcsr);
  if (const Index scale = b.curve(lcsr); scale != none && !table) law.rate_scale = b.model.curves[scale];
  if (!std::is_sorted(law.rate_scale.y.begin(), law.rate_scale.y.end()))
    warn_of_softening_by_rate(b, lcsr, fmt::format("curve {}", law.rate_scale.id));
  if (!table && !scaled && cards.c > 0.0 && cards.p > 0.0) {
    law.rate_c = cards.c;
    law.rate_p = cards.p;
  }
  if (cards.vp != -1.0 && cards.vp != 0.0 && cards.vp != 1.0 && cards.vp != 3.0 && cards.vp != 4.0)
    return refuse(b, vp, "expected -1, 0, 1, 3 or 4");
  if (cards.vp != 0.0 && cards.vp != 1.0)
    vp.report(b.findings, Severity::warning,
              "computed as 0: the rate of the plastic strain, found together with the stress, without a filter",
              "write 0, or 1");
  if (cards.vp == 1.0 && law.rate_c > 0.0) law.rate_yield = cards.sigy;
}

/// Takes the elastic strains off a curve of total ones: what is left before it leaves the elastic line is its yield
/// stress without plastic strain, at least a thousandth of the greatest stress. Refused where the curve is steeper than
/// the elastic line after it left it.
void take_off_elastic_strains(Builder& b, const deck::Entry& field, double elastic_modulus, Curve& curve) {
  if (curve.x.size() < 2) return;
  const double greatest = *std::max_element(curve.y.begin(), curve.y.end());
  Curve plastic = curve;
  plastic.x.assign(1, 0.0);
  plastic.y.assign(1, std::max(curve.y.front(), 1e-3 * greatest));
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    const double strain = curve.x[i] - curve.y[i] / elastic_modulus;
    if (strain > plastic.x.back() && curve.y[i] > 0.0) {
      plastic.x.push_back(strain);
      plastic.y.push_back(curve.y[i]);
    } else if (plastic.x.size() == 1 && strain > -0.01 * curve.x[i]) {
      plastic.y.front() = std::max(plastic.y.front(), curve.y[i]);
    } else if (curve.y[i] > 0.0) {
      return refuse(b, field,
                    fmt::format("curve {} is steeper than Young's modulus {:g} before the strain {:g}", curve.id,
                                elastic_modulus, curve.x[i]),
                    "give true stress over true total strain, its elastic part included, or a higher E");
    }
  }
  if (plastic.x.size() == 1) {
    plastic.x.push_back(1.0);
    plastic.y.push_back(plastic.y.front());
  }
  curve = std::move(plastic);
}

}  // namespace

const CardOf<YieldCards> yield_strain_card{
    {at(&YieldCards::eps, 0), real("eps1", dimension::number, 0, at_least(0), "plastic strain of point 1")},
    {at(&YieldCards::eps, 1), real("eps2", dimension::number, 0, at_least(0), "point 2")},
    {at(&YieldCards::eps, 2), real("eps3", dimension::number, 0, at_least(0), "point 3")},
    {at(&YieldCards::eps, 3), real("eps4", dimension::number, 0, at_least(0), "point 4")},
    {at(&YieldCards::eps, 4), real("eps5", dimension::number, 0, at_least(0), "point 5")},
    {at(&YieldCards::eps, 5), real("eps6", dimension::number, 0, at_least(0), "point 6")},
    {at(&YieldCards::eps, 6), real("eps7", dimension::number, 0, at_least(0), "point 7")},
    {at(&YieldCards::eps, 7), real("eps8", dimension::number, 0, at_least(0), "point 8")},
};

const CardOf<YieldCards> yield_stress_card{
    {at(&YieldCards::es, 0), real("es1", dimension::stress, 0, at_least(0), "yield stress of point 1")},
    {at(&YieldCards::es, 1), real("es2", dimension::stress, 0, at_least(0), "point 2")},
    {at(&YieldCards::es, 2), real("es3", dimension::stress, 0, at_least(0), "point 3")},
    {at(&YieldCards::es, 3), real("es4", dimension::stress, 0, at_least(0), "point 4")},
    {at(&YieldCards::es, 4), real("es5", dimension::stress, 0, at_least(0), "point 5")},
    {at(&YieldCards::es, 5), real("es6", dimension::stress, 0, at_least(0), "point 6")},
    {at(&YieldCards::es, 6), real("es7", dimension::stress, 0, at_least(0), "point 7")},
    {at(&YieldCards::es, 7), real("es8", dimension::stress, 0, at_least(0), "point 8")},
};

CardOf<YieldCards> yield_card(std::initializer_list<FieldOf<YieldCards>> own) {
  CardOf<YieldCards> card{
      {&MaterialCard::mid, material_id},
      {&MaterialCard::ro, density},
      {&YieldCards::e, young},
      {&YieldCards::pr, poisson},
      {&YieldCards::sigy,
       real("sigy", dimension::stress, 0, at_least(0), "yield stress, unless LCSS or EPS and ES are given")},
      {&YieldCards::etan, real("etan", dimension::stress, 0, at_least(0), "tangent modulus, below E")},
  };
  for (const FieldOf<YieldCards>& field : own) card.add(field);
  return card;
}

CardOf<YieldCards> yield_rate_card(std::initializer_list<FieldOf<YieldCards>> own) {
  CardOf<YieldCards> card{
      {&YieldCards::c, real("c", dimension::rate, 0, at_least(0), "Cowper-Symonds C; 0: no rate effect")},
      {&YieldCards::p, real("p", dimension::number, 0, at_least(0), "Cowper-Symonds P")},
      {&YieldCards::lcss,
       id("lcss", IdSpace::function, 0, "yield stress over plastic strain: curve, or table over the strain rate")},
      {&YieldCards::lcsr, id("lcsr", IdSpace::function, 0, "curve: factor on the yield stress over the strain rate")},
  };
  for (const FieldOf<YieldCards>& field : own) card.add(field);
  return card;
}

YieldRows read_yield_cards(deck::Cursor& cursor, const CardOf<YieldCards>& main, const CardOf<YieldCards>& rate,
                           bool log_rates, const CardOf<YieldCards>* third) {
  YieldCards cards;
  YieldRows rows;
  rows.main = cursor.read(main, cards);
  rows.rate = cursor.read(rate, cards);
  if (third != nullptr) cursor.read(*third, cards);
  rows.strain = cursor.read(yield_strain_card, cards);
  rows.stress = cursor.read(yield_stress_card, cards);
  rows.log_rates = log_rates;
  return rows;
}

void check_tangent(Builder& b, double e, const deck::Entry& etan) {
  if (etan.value >= e && e > 0.0)
    refuse(b, etan, fmt::format("the tangent modulus must be below Young's modulus {:g}", e));
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

YieldTable yield_table(Builder& b, const deck::Entry& field, int id, bool log_rates, double elastic_modulus) {
  YieldTable y;
  y.log_rates = log_rates;
  std::vector<Index> curves;
  if (const Index t = b.tables.find(id); t != none) {
    const Table& table = b.model.tables[t];
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
    Curve& curve = y.curves.emplace_back(b.model.curves[c]);
    if (elastic_modulus > 0.0) take_off_elastic_strains(b, field, elastic_modulus, curve);
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

void set_yield_curves(Builder& b, const YieldRows& rows, kernel::PiecewiseLinear& law) {
  const YieldCards& cards = rows.cards();
  law.yield = {bilinear(cards)};
  if (cards.lcss == 0) refuse_gap(b, rows);
  if (cards.lcss != 0)
    set_curve_or_table(b, rows, law);
  else if (Curve curve = points(cards); !curve.empty())
    set_points(b, rows, law, std::move(curve));
  else if (!(cards.sigy > 0.0))
    refuse(b, rows.main[&YieldCards::sigy], "the yield stress must be given",
           "give SIGY and ETAN, EPS and ES, or LCSS");
  warn_of_half_a_rate(b, rows.rate[&YieldCards::c], rows.rate[&YieldCards::p]);
  set_rates(b, rows, law);
}

}  // namespace nugget::reading
