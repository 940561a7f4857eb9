// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reading/builder/builder.hpp"

namespace nugget::reading {

/// Yield stress over plastic strain: one curve, or one a strain rate.
struct YieldTable {
  std::vector<Curve> curves;  ///< none: refused
  std::vector<double> rates;  ///< plain rates, ascending [1/time]; empty: one curve
  bool log_rates = false;     ///< to be interpolated over the logarithm of the rate
};

/// Curve or table `id`, which `field` asks for. A table whose first value is negative holds the natural
/// logarithms of its rates. Yield stresses must be above 0.
YieldTable yield_table(Builder& builder, const deck::Entry& field, int id, bool log_rates);

/// The cards of MAT_024, from which its yield stress follows.
struct YieldCards {
  deck::Row main;          ///< mid ro e pr sigy etan ...
  deck::Row rate;          ///< c p lcss lcsr ...
  deck::Row strain;        ///< eps1..8
  deck::Row stress;        ///< es1..8
  bool log_rates = false;  ///< _LOG_INTERPOLATION
};

/// EPS1..8 and ES1..8, as in MAT_024.
extern const Card yield_strain_card, yield_stress_card;

/// An error where ETAN is not below E.
void check_tangent(Builder& builder, const deck::Row& row);
/// A warning where only one of the constants of Cowper and Symonds is given.
void warn_of_half_a_rate(Builder& builder, const deck::Entry& c, const deck::Entry& p);

/// A warning that the yield stress falls with the rate, `where`: the plastic rate, found together with the stress, then
/// has more than one value.
void warn_of_softening_by_rate(Builder& builder, const deck::Entry& field, const std::string& where);

/// Sets yield, rates and log_rates, from the first of these that is given: LCSS (curve or table), EPS and ES, SIGY and
/// ETAN with the plastic modulus E ETAN / (E - ETAN); and what the rate does to them.
void set_yield_curves(Builder& builder, const YieldCards& cards, kernel::PiecewiseLinear& law);

}  // namespace nugget::reading
