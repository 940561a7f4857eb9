// SPDX-License-Identifier: Apache-2.0
#include "model/cards/yield_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nugget::model {

namespace {

using deck::Row;

Curve bilinear(const Row& row) {
  const double E = row.real("e"), tangent = row.real("etan"), yield = row.real("sigy");
  const double slope = tangent < E ? E * tangent / (E - tangent) : 0.0;
  return {0, {0.0, 1.0}, {yield, yield + slope}};
}

/// The points EPS, ES: as many as are given. A first strain of 0 counts if it has a stress.
Curve points(const Row& strain, const Row& stress) {
  Curve curve;
  for (int i = 1; i <= 8; ++i) {
    const double e = strain.real(fmt::format("eps{}", i)), s = stress.real(fmt::format("es{}", i));
    if (s == 0.0 && e == 0.0) break;
    curve.x.push_back(e);
    curve.y.push_back(s);
  }
  return curve;
}

void set_points(Builder& b, const YieldCards& cards, kernel::PiecewiseLinear& law, Curve curve) {
  if (!std::is_sorted(curve.x.begin(), curve.x.end(), std::less_equal<>{}))
    refuse(b, cards.strain, "eps1", "plastic strains must ascend", "sort the points");
  law.yield = {std::move(curve)};
}

void set_curve_or_table(Builder& b, const YieldCards& cards, kernel::PiecewiseLinear& law) {
  const int id = cards.rate.integer("lcss");
  if (id < 0) return refuse(b, cards.rate, "lcss", "a negative id is not supported", "give the curve's id");
  YieldTable table = yield_table(b, cards.rate, "lcss", id, cards.log_rates);
  if (table.curves.empty()) return;
  law.yield = std::move(table.curves);
  law.rates = std::move(table.rates);
  law.log_rates = table.log_rates;
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

void warn_of_half_a_rate(Builder& b, const Row& row, std::string_view c, std::string_view p) {
  if ((row.real(c) > 0.0) == (row.real(p) > 0.0)) return;
  const bool has_c = row.real(c) > 0.0;
  row.complain(b.findings, Severity::warning, has_c ? p : c, "Cowper-Symonds needs both constants: no rate effect",
               "give both, or neither");
}

YieldTable yield_table(Builder& b, const Row& row, std::string_view field, int id, bool log_rates) {
  YieldTable y;
  y.log_rates = log_rates;
  std::vector<Index> curves;
  if (const Index t = b.tables.find(id); t != none) {
    const Table& table = b.model.tables[static_cast<std::size_t>(t)];
    if (table.curve.size() != table.value.size() || table.value.empty()) return {};  // told where it is defined
    curves = table.curve;
    y.rates = table.value;
    if (y.rates.front() < 0.0) {
      y.log_rates = true;
      for (double& rate : y.rates) rate = std::exp(rate);
    } else if (log_rates && y.rates.front() == 0.0) {
      refuse(b, row, field, "a rate of 0 has no logarithm", "start the table at the lowest rate of the tests");
    }
  } else if (const Index c = b.curves.find(id); c != none) {
    curves = {c};
  } else {
    refuse(b, row, field, fmt::format("curve or table {} is not defined", id), "define it");
  }
  for (const Index c : curves) {
    y.curves.push_back(b.model.curves[static_cast<std::size_t>(c)]);
    const Curve& curve = y.curves.back();
    if (!curve.empty() && *std::min_element(curve.y.begin(), curve.y.end()) <= 0.0)
      refuse(b, row, field, fmt::format("curve {} has a yield stress that is not above 0", curve.id),
             "give the true yield stress over plastic strain, from strain 0 on");
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
  if (const Index scale = b.curve(cards.rate, "lcsr"); scale != none)
    law.rate_scale = b.model.curves[static_cast<std::size_t>(scale)];
}

}  // namespace nugget::model
