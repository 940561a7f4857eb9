// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "reading/cards/material.hpp"

namespace nugget::reading {

/// Yield stress over plastic strain: one curve, or one a strain rate.
struct YieldTable {
  std::vector<Curve> curves;  ///< none: refused
  std::vector<double> rates;  ///< plain rates, ascending [1/time]; empty: one curve
  bool log_rates = false;     ///< to be interpolated over the logarithm of the rate
};

/// Curve or table `id`, which `field` asks for. A table whose first value is negative holds the natural
/// logarithms of its rates. Yield stresses must be above 0. `elastic_modulus`: strains of the curves are elastic and
/// plastic ones, and the elastic ones, stress over `elastic_modulus`, are taken off; 0: plastic strains.
YieldTable yield_table(Builder& builder, const deck::Entry& field, int id, bool log_rates,
                       double elastic_modulus = 0.0);

/// The four cards of MAT_024 and its relatives.
struct YieldCards : MaterialCard {
  double e = 0, pr = 0, sigy = 0, etan = 0;  // first
  double c = 0, p = 0, vp = 0;               // second
  int lcss = 0, lcsr = 0;
  std::array<double, 8> eps{}, es{};  // third, fourth
  // Of some of the laws.
  double fail = 0, tdel = 0, eppf = 0, eppfr = 0, epsthin = 0, epsmaj = 0, numint = 0;
  double epsd = 0, s = 0, dc = 0;
  int lcdm = 0;
};
struct YieldRows {
  deck::RowOf<YieldCards> main, rate, strain, stress;
  bool log_rates = false;  ///< _LOG_INTERPOLATION
  /// Values of all four.
  const YieldCards& cards() const { return *stress; }
};
/// The first card, with two fields of the law's own behind ETAN; of the second C to LCSR, with four behind them.
CardOf<YieldCards> yield_card(std::initializer_list<FieldOf<YieldCards>> own);
CardOf<YieldCards> yield_rate_card(std::initializer_list<FieldOf<YieldCards>> own);

/// Reads the two cards, `third` where there is one, EPS1..8 and ES1..8.
YieldRows read_yield_cards(deck::Cursor& cursor, const CardOf<YieldCards>& main, const CardOf<YieldCards>& rate,
                           bool log_rates, const CardOf<YieldCards>* third = nullptr);
extern const CardOf<YieldCards> yield_strain_card, yield_stress_card;

/// An error where ETAN is not below E.
void check_tangent(Builder& builder, double e, const deck::Entry& etan);
/// A warning where only one of the constants of Cowper and Symonds is given.
void warn_of_half_a_rate(Builder& builder, const deck::Entry& c, const deck::Entry& p);

/// A warning that the yield stress falls with the rate, `where`: the plastic rate, found together with the stress, then
/// has more than one value.
void warn_of_softening_by_rate(Builder& builder, const deck::Entry& field, const std::string& where);

/// Sets yield, rates and log_rates, from the first of these that is given: LCSS (curve or table), EPS and ES, SIGY and
/// ETAN with the plastic modulus E ETAN / (E - ETAN); and what the rate does to them.
void set_yield_curves(Builder& builder, const YieldRows& rows, kernel::PiecewiseLinear& law);

}  // namespace nugget::reading
