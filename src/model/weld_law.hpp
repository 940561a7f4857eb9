// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "base/curve.hpp"
#include "base/finding.hpp"
#include "model/parts.hpp"

// What MAT_100 and the *DEFINE_ cards that belong to it say of a weld as a whole. What a point of its material needs
// (elasticity, hardening, EFAIL) is kernel::Spotweld. Formulas: docs/theory/failure.md.
namespace nugget::model {

/// Arguments that a *DEFINE_FUNCTION of a weld's failure value may have: six resultants, strain rate, diameter, two
/// thicknesses, plastic strain, time, USRV1 to USRV22.
inline constexpr int weld_function_arguments = 34;

/// A strength or factor that may depend on the effective strain rate: value times factor(rate).
struct RateValue {
  double value = 0.0;                        ///< 0: not given, its term is left out
  Curve factor;                              ///< over the strain rate [1/time], end values hold; empty: 1
  std::function<double(double)> function{};  ///< the strength over the rate, in place of both; may be empty
  bool given() const { return value > 0.0; }
  double at(double rate) const {
    if (function) return std::max(function(rate), std::numeric_limits<double>::min());
    if (factor.empty()) return value;
    return value * factor.clamped(log_rate() ? std::log(std::max(rate, std::numeric_limits<double>::min())) : rate);
  }
  /// A curve that begins below zero is over the natural logarithm of the rate.
  bool log_rate() const { return factor.x.front() < 0.0; }
};

/// Data of _DAMAGE-FAILURE and of the damage of _DA.
struct WeldDamage {
  double rupture = 0.0;         ///< RS: plastic strain (DMGOPT 2, 12: time after onset) at rupture; 0: no damage
  double failure_strain = 0.0;  ///< EFAIL, where it begins the damage of the weld as a whole; 0: it does not
  double true_thickness = 0.0;  ///< TRUE_T: of single brick welds [length]; 0: as modelled
  bool whole = false;           ///< ASFF = 1: the first brick to fail takes its assembly with it
  double beta = 0.0;            ///< BETA: decay of the damaged stress; 0: linear
  int option = 0;               ///< DMGOPT 0, 1, 2, 10, 11, 12
  double mode = 0.0;            ///< FMODE: ratio that parts failure from damage; 0: damage
  double cap = 0.0;             ///< FFCAP: failure value at which a damaged weld is deleted; 0: none
};

/// MAT_100 but for the law of its points.
struct WeldLaw {
  int option = 0;                         ///< OPT: -2 -1 0 1 2 3 4 5 6 7 10 11 12 22; what computes the failure value
  std::array<RateValue, 6> strength{};    ///< OPT -2 -1 0: NRR NRS NRT [force], MRR MSS MTT [moment]
  RateValue normal_stress, shear_stress;  ///< OPT 1: SIGAX, SIGTAU [stress]
  double diameter = 0.0;                  ///< OPT 3 4 5: ZD; 0: the weld's own [length]
  std::array<double, 2> thickness{};      ///< OPT 3 4: ZT; OPT 5: ZT, ZT2; 0: the sheets' [length]
  std::array<double, 3> alpha{1, 1, 1};   ///< OPT 3 4: ZALP1..3
  double notch_radius = 0.0;              ///< OPT 3: ZRRAD [length]
  CurveTable tension, compression;        ///< OPT 11: LCT, LCC: force allowed over strain rate and direction [degrees]
  double limit = 0.0;                     ///< FVAL of OPT 3 4 5: the stress (4: stress intensity) at failure
  int cycles = 0;                         ///< FVAL of OPT 6: consecutive cycles at or beyond the surface before failure
  Index table = none;                     ///< OPT 7: in Model::pair_strengths; OPT 10: in Model::load_rate_strengths
  Index function = none;                  ///< FVAL of OPT -2 -1 0 2 12 22: in Model::functions
  std::array<double, 22> user_values{};   ///< USRV1 to USRV22 of OPT 2, 12, 22
  int filter = 0;                         ///< NF: resultant vectors averaged for the failure function
  double failure_time = 0.0;              ///< TFAIL [time]; 0: none
  WeldDamage damage;
  /// The user's own failure value by OPT: of a function of the deck or of a library.
  bool user() const { return option == 2 || option == 12 || option == 22; }
  bool connection = false;       ///< _DA: strengths and damage come from `properties`
  Index properties = none;       ///< CON_ID: in Model::connections; none (_DA with CON_ID < 0): failure is off
  double rate_filter = 0.0;      ///< RFILTF of _DA: share of the last strain rate that is kept
  double jacobian_limit = 0.01;  ///< JTOL of _DA
};

/// *DEFINE_SPOTWELD_RUPTURE_STRESS: a line (OPT 6).
struct RuptureStress {
  Index part = none;                 ///< sheet
  double normal = 0.0, shear = 0.0;  ///< SRSIG, SIGTAU [stress]; 0: left out
};

/// *DEFINE_SPOTWELD_FAILURE_RESULTANTS (OPT 7): stresses at failure by the pair of parts that are welded.
struct PairStrengths {
  int id = 0;
  struct Pair {
    std::array<Index, 2> parts{none, none};
    RateValue normal, shear;  ///< [stress]
  };
  Pair standard;  ///< DSN, DSS: of pairs that are not listed
  std::vector<Pair> pairs;
  Place place;
};

/// *DEFINE_SPOTWELD_FAILURE (OPT 10): nominal stresses at failure of sheet materials, raised by the load rate.
struct LoadRateStrengths {
  int id = 0;
  int thickness_rule = 0;                              ///< TFLAG: 0 thinner sheet, 1 mean, 2 thicker sheet, 3 sum
  std::array<double, 4> dynamic{};                     ///< DC1..DC4
  double normal_exponent = 2.0, shear_exponent = 2.0;  ///< EXN, EXS
  int averaged = 0;                                    ///< NAVG: load rates averaged
  double normal = 0.0, shear = 0.0;                    ///< D_SN, D_SS: of materials that are not listed [stress]
  double reference = 0.0;                              ///< R_SULT [stress]
  double thickness_scale = 1.0;                        ///< TSCALE
  struct Entry {
    Index material = none;                   ///< of a sheet
    std::array<Index, 2> parts{none, none};  ///< or, with _PID, the pair of sheets
    double normal = 0.0, shear = 0.0;        ///< SN, SS [stress]
  };
  std::vector<Entry> entries;
  Place place;
};

/// *DEFINE_CONNECTION_PROPERTIES with its _ADD records (_DA).
struct ConnectionProperties {
  int id = 0;
  int area_rule = 0;    ///< AREAEQ: 0 as modelled, 1 and -1 by 5 sqrt(t_min) in mm and m
  int damage_type = 0;  ///< DGTYP 0..5
  int area_change = 0;  ///< MOARFL: 0 the area falls with shear, 1 it does not
  struct Record {
    Index material = none;                      ///< of a sheet; none: the defaults
    double yield = 0.0, tangent_modulus = 0.0;  ///< SIGY, ETAN [stress]
    double damage_parameter = 1e10;             ///< DG_PR
    double rank = 0.0;                          ///< RANK
    RateValue normal, bending, shear;           ///< SN, SB, SS [stress] with LCSN, LCSB, LCSS; 0: left out
    double normal_exponent = 1.0, bending_exponent = 1.0, shear_exponent = 1.0;  ///< EXSN, EXSB, EXSS
    double fading_energy = 0.0;                                                  ///< GFAD [force length]
    double torsion_factor = 1.0;                                                 ///< SCLMRR
  };
  Record standard;
  std::vector<Record> records;
  /// PROPRUL 2: functions of both sheets (Model::functions) in place of the numbers of `standard`; none: not given.
  struct Functions {
    Index yield = none, tangent_modulus = none, normal = none, bending = none, shear = none, normal_exponent = none,
          bending_exponent = none, shear_exponent = none, fading_energy = none;
  };
  std::optional<Functions> functions;
  Place place;
};

}  // namespace nugget::model
