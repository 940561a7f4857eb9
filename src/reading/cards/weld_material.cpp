// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"
#include "reading/cards/yield_curves.hpp"

// *MAT_SPOTWELD (MAT_100) in all its forms. The second card's form follows from OPT, which stands on the third.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

// ---- cards

constexpr RealField modulus =
    real("e", dimension::stress, required, any_value, "Young's modulus; negative: its value, bricks uniaxial");
constexpr RealField mass_step =
    real("dt", dimension::time, 0, at_least(0), "time step to which the weld's mass is scaled; 0: none");
constexpr RealField fail_time = real("tfail", dimension::time, 0, at_least(0), "time of failure; 0: none");
constexpr RealField fail_strain =
    real("efail", dimension::number, 0, at_least(0), "plastic strain at failure; 0: none");
constexpr IntegerField filter_length = integer("nf", 0, at_least(0), "force vectors averaged for the failure");

/// A strength, of which a negative value is the id of a curve.
constexpr RealField strength_or_curve(std::string_view name, Dimension d, double fallback, std::string_view meaning) {
  return or_negative(real(name, d, fallback, any_value, meaning), IdSpace::function);
}

/// All cards of *MAT_SPOTWELD. What the second one holds follows from OPT.
struct WeldCards : MaterialCard {
  double e = 0, pr = 0, sigy = 0, eh = 0, dt = 0, tfail = 0;
  double efail = 0;
  std::array<double, 6> strength{};  ///< NRR NRS NRT MRR MSS MTT
  double sigax = 0, sigtau = 0;
  double zd = 0, zt = 0, zt2 = 0, zrrad = 0;
  std::array<double, 3> zalp{};
  int lct = 0, lcc = 0, nf = 0;
  double rs = 0, opt = 0, fval = 0, true_t = 0, beta = 0, dmgopt = 0;
  int table = 0;     ///< FVAL of OPT 7 and 10
  int function = 0;  ///< FVAL of OPT -2 -1 0 2 12 22
  std::array<double, 22> usrv{};
  int asff = 0, ttopt = 0;
  double fmode = 0, ffcap = 0;
  double rfiltf = 0, jtol = 0;
  int con_id = 0, more = 0;
};

const CardOf<WeldCards> weld_material_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&WeldCards::e, modulus},
    {&WeldCards::pr, poisson},
    {&WeldCards::sigy,
     strength_or_curve("sigy", dimension::stress, required,
                       "yield stress; negative: curve over plastic strain, or table over the strain rate")},
    {&WeldCards::eh,
     real("eh", dimension::stress, 0, at_least(0), "hardening: slope of the yield stress over plastic strain")},
    {&WeldCards::dt, mass_step},
    {&WeldCards::tfail, fail_time},
};

const CardOf<WeldCards> weld_resultant_card{
    {&WeldCards::efail, fail_strain},
    {at(&WeldCards::strength, 0),
     strength_or_curve("nrr", dimension::force, 0,
                       "axial force at failure; 0: left out; negative: curve over the rate")},
    {at(&WeldCards::strength, 1),
     strength_or_curve("nrs", dimension::force, 0, "shear force s at failure; 0 and negative as NRR")},
    {at(&WeldCards::strength, 2),
     strength_or_curve("nrt", dimension::force, 0, "shear force t at failure; 0 and negative as NRR")},
    {at(&WeldCards::strength, 3),
     strength_or_curve("mrr", dimension::moment, 0, "torsion at failure; 0 and negative as NRR")},
    {at(&WeldCards::strength, 4),
     strength_or_curve("mss", dimension::moment, 0, "bending s at failure; 0 and negative as NRR")},
    {at(&WeldCards::strength, 5),
     strength_or_curve("mtt", dimension::moment, 0, "bending t at failure; 0 and negative as NRR")},
    {&WeldCards::nf, filter_length},
};

const CardOf<WeldCards> stress_card{
    {&WeldCards::efail, fail_strain},
    {&WeldCards::sigax, strength_or_curve("sigax", dimension::stress, 0,
                                          "axial stress at failure; 0: left out; negative: curve over the rate")},
    {&WeldCards::sigtau,
     strength_or_curve("sigtau", dimension::stress, 0, "shear stress at failure; 0 and negative as SIGAX")},
    unused(),
    unused(),
    unused(),
    unused(),
    {&WeldCards::nf, filter_length},
};

const CardOf<WeldCards> notch_card{
    {&WeldCards::efail, fail_strain},
    {&WeldCards::zd, real("zd", dimension::length, 0, at_least(0), "diameter; 0: the weld's own")},
    {&WeldCards::zt, real("zt", dimension::length, 0, at_least(0), "sheet thickness; 0: of the thinner sheet")},
    {at(&WeldCards::zalp, 0), real("zalp1", dimension::number, 1, at_least(0), "factor on the term of shear")},
    {at(&WeldCards::zalp, 1), real("zalp2", dimension::number, 1, at_least(0), "factor on the term of bending")},
    {at(&WeldCards::zalp, 2), real("zalp3", dimension::number, 1, at_least(0), "factor on the term of tension")},
    {&WeldCards::zrrad, real("zrrad", dimension::length, 0, at_least(0), "radius of the notch, for OPT 3")},
    {&WeldCards::nf, filter_length},
};

const CardOf<WeldCards> weld_structural_card{
    {&WeldCards::efail, fail_strain},
    {&WeldCards::zd, real("zd", dimension::length, 0, at_least(0), "diameter; 0: the weld's own")},
    {&WeldCards::zt, real("zt", dimension::length, 0, at_least(0), "thickness of sheet 1; 0: the sheet's own")},
    {&WeldCards::zt2, real("zt2", dimension::length, 0, at_least(0), "thickness of sheet 2; 0: the sheet's own")},
    unused(),
    unused(),
    unused(),
    unused(),
};

const CardOf<WeldCards> weld_table_card{
    {&WeldCards::efail, fail_strain}, unused(), unused(), unused(), unused(), unused(), unused(),
    {&WeldCards::nf, filter_length},
};

const CardOf<WeldCards> direction_card{
    {&WeldCards::efail, fail_strain},
    {&WeldCards::lct, id("lct", IdSpace::function, 0,
                         "tension: curve of allowed force over angle, or table over the rate; 0: no limit")},
    {&WeldCards::lcc, id("lcc", IdSpace::function, 0, "compression: the same")},
    unused(),
    unused(),
    unused(),
    unused(),
    {&WeldCards::nf, filter_length},
};

constexpr std::array<std::string_view, 22> user_value_names{
    "usrv1",  "usrv2",  "usrv3",  "usrv4",  "usrv5",  "usrv6",  "usrv7",  "usrv8",  "usrv9",  "usrv10", "usrv11",
    "usrv12", "usrv13", "usrv14", "usrv15", "usrv16", "usrv17", "usrv18", "usrv19", "usrv20", "usrv21", "usrv22"};
FieldOf<WeldCards> user_value(std::size_t i) {
  return {at(&WeldCards::usrv, i),
          real(user_value_names[i], dimension::number, 0, any_value, "of the user's own failure function")};
}

const CardOf<WeldCards> user_card{
    {&WeldCards::efail, fail_strain},
    user_value(0),
    user_value(1),
    user_value(2),
    user_value(3),
    user_value(4),
    user_value(5),
    {&WeldCards::nf, filter_length},
};
const CardOf<WeldCards> more_user_card{user_value(6),  user_value(7),  user_value(8),  user_value(9),
                                       user_value(10), user_value(11), user_value(12), user_value(13)};
const CardOf<WeldCards> last_user_card{user_value(14), user_value(15), user_value(16), user_value(17),
                                       user_value(18), user_value(19), user_value(20), user_value(21)};

constexpr RealField rupture = real("rs", dimension::number, 0, at_least(0),
                                   "plastic strain (DMGOPT 2, 12: time after onset) at rupture; 0: none");
constexpr RealField true_thickness =
    real("true_t", dimension::length, 0, at_least(0), "true thickness of single brick welds; 0: as modelled");
constexpr IntegerField whole =
    integer("asff", 0, between(0, 1), "1: the first brick to fail takes its assembly with it");
constexpr IntegerField correction =
    integer("ttopt", 0, between(0, 2), "form of the TRUE_T correction; here as 2, free of the numbering");

/// What FVAL is depends on OPT, so does its unit and how it moves with an include.
CardOf<WeldCards> failure_card_of(const FieldOf<WeldCards>& fval) {
  return {
      {&WeldCards::rs, rupture},
      {&WeldCards::opt,
       real("opt", dimension::number, 0, any_value, "failure function: -2 -1 0 1 2 3 4 5 6 7 10 11 12 22")},
      fval,
      {&WeldCards::true_t, true_thickness},
      {&WeldCards::asff, whole},
      {&WeldCards::beta, real("beta", dimension::number, 0, at_least(0), "decay of the damaged stress; 0: linear")},
      unused(),
      {&WeldCards::dmgopt,
       real("dmgopt", dimension::number, 0, any_value, "damage: 0 1 2 10 11 12; -1: given on the next card")},
  };
}
const CardOf<WeldCards> weld_failure_card = failure_card_of(
    {&WeldCards::fval,
     real("fval", dimension::number, 0, any_value,
          "OPT -2 -1 0 2 12 22: *DEFINE_FUNCTION of the failure value; 3 4 5: stress at failure; 6: cycles; 7 10: "
          "*DEFINE_SPOTWELD_FAILURE_RESULTANTS, _FAILURE")});
const CardOf<WeldCards> failure_by_stress =
    failure_card_of({&WeldCards::fval, real("fval", dimension::stress, 0, any_value, "stress at failure")});
const CardOf<WeldCards> failure_by_function =
    failure_card_of({&WeldCards::function, id("fval", IdSpace::function, 0, "*DEFINE_FUNCTION of the failure value")});
const CardOf<WeldCards> failure_by_table =
    failure_card_of({&WeldCards::table, id("fval", IdSpace::define, 0, "table of strengths")});

/// The options that call a subroutine of the user's own in LS-DYNA.
bool is_user(int option) {
  return option == 2 || option == 12 || option == 22;
}

const CardOf<WeldCards>& failure_card_for(int option) {
  if (option <= 0 || is_user(option)) return failure_by_function;
  if (option >= 3 && option <= 5) return failure_by_stress;
  return option == 7 || option == 10 ? failure_by_table : weld_failure_card;
}

const CardOf<WeldCards> weld_damage_card{
    {&WeldCards::dmgopt, real("dmgopt", dimension::number, 0, any_value, "damage: 0 1 2 10 11 12")},
    {&WeldCards::fmode,
     real("fmode", dimension::number, 0, between(0, 1), "ratio of the failure surface that parts failure from damage")},
    {&WeldCards::ffcap,
     real("ffcap", dimension::number, 0, at_least(0), "failure value at which a damaged weld is deleted; 0: none")},
    {&WeldCards::ttopt, correction},
};

const CardOf<WeldCards> connection_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&WeldCards::e, modulus},
    {&WeldCards::pr, poisson},
    unused(),
    unused(),
    {&WeldCards::dt, mass_step},
    {&WeldCards::tfail, fail_time},
};

const CardOf<WeldCards> connection_failure_card{
    {&WeldCards::rs, rupture},
    {&WeldCards::asff, whole},
    unused(),
    {&WeldCards::true_t, true_thickness},
    {&WeldCards::con_id,
     or_negative(id("con_id", IdSpace::define, required, "*DEFINE_CONNECTION_PROPERTIES; negative: failure is off"),
                 IdSpace::define)},
    {&WeldCards::rfiltf,
     real("rfiltf", dimension::number, 0, between(0, 1), "share of the last strain rate that is kept")},
    {&WeldCards::jtol,
     real("jtol", dimension::number, 0.01, at_least(0), "relative Jacobian below which a brick is deleted")},
    {&WeldCards::more, integer("dmgopt", 0, between(-1, 0), "-1: one more card")},
};

const CardOf<WeldCards> connection_more_card{unused(), unused(), unused(), {&WeldCards::ttopt, correction}};

// ---- reading

/// The second card's table for a failure function that is built; null for others.
const CardOf<WeldCards>* strength_card(int option) {
  switch (option) {
    case -2:
    case -1:
    case 0: return &weld_resultant_card;
    case 1: return &stress_card;
    case 3:
    case 4: return &notch_card;
    case 5: return &weld_structural_card;
    case 6:
    case 7:
    case 10: return &weld_table_card;
    case 11: return &direction_card;
    case 2:
    case 12:
    case 22: return &user_card;
    default: return nullptr;
  }
}

void refuse_option(Builder& b, const deck::Entry& opt, int option) {
  constexpr std::string_view built = "built are -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 10, 11, 12 and 22";
  const auto say = [&](std::string_view why) { refuse(b, opt, fmt::format("OPT {} {}", option, why), built); };
  if (option == 9 || option == -9)
    return say("(*DEFINE_SPOTWELD_RUPTURE_PARAMETER): the formula of its constants is not public");
  say("is not a failure function of MAT_100");
}

/// The failure card without a finding: the cursor reads it once more in its turn.
RowOf<WeldCards> peek_option(const Builder& b, const Block& block, const Options& options) {
  Findings unheard;
  Cursor ahead(b.deck, block, unheard);
  read_title(ahead, options);
  for (int line = 0; line < 2 && ahead.more(); ++line) ahead.skip();
  return ahead.read(weld_failure_card);
}

/// The curve that the negative value of a field for numbers names.
Index weld_curve(Builder& b, const deck::Entry& field) {
  const int id = static_cast<int>(std::lround(-field.value));
  const Index curve = b.curves.find(id);
  if (curve == none) refuse(b, field, fmt::format("curve {} is not defined", id), "define it, or give a number");
  return curve;
}

/// A strength: 0 and 1e20 leave it out, a negative value is a curve over the strain rate.
RateValue strength(Builder& b, const deck::Entry& field) {
  if (field.value >= 0.0) return {failure_value(field.value), {}};
  const Index curve = weld_curve(b, field);
  if (curve == none) return {};
  return {1.0, b.model.curves[curve]};
}

/// A curve, or a table over the strain rate.
CurveTable direction_strength(Builder& b, const deck::Entry& field) {
  const int id = field.integer();
  if (id == 0) return {};
  if (const Index t = b.tables.find(id); t != none) return b.table_with_curves(t);
  const Index c = b.find(b.curves, "curve or table", field);
  return c == none ? CurveTable{} : CurveTable{id, {0.0}, {b.model.curves[c]}};
}

void expect_positive(Builder& b, const deck::Entry& field, std::string_view what) {
  if (!(field.value > 0.0)) refuse(b, field, fmt::format("{} must be given", what));
}

/// The strengths of the second card, as `law.option` has them.
void set_strengths(Builder& b, WeldLaw& law, const RowOf<WeldCards>& row) {
  switch (law.option) {
    case -2:
    case -1:
    case 0:
      for (std::size_t i = 0; i < law.strength.size(); ++i)
        law.strength[i] = strength(b, row[at(&WeldCards::strength, i)]);
      break;
    case 1:
      law.normal_stress = strength(b, row[&WeldCards::sigax]);
      law.shear_stress = strength(b, row[&WeldCards::sigtau]);
      break;
    case 3:
      expect_positive(b, row[&WeldCards::zrrad], "the radius of the notch");
      law.notch_radius = row->zrrad;
      [[fallthrough]];
    case 4:
      law.alpha = row->zalp;
      law.diameter = row->zd;
      law.thickness[0] = row->zt;
      break;
    case 5:
      law.diameter = row->zd;
      law.thickness = {row->zt, row->zt2};
      break;
    case 11:
      law.tension = direction_strength(b, row[&WeldCards::lct]);
      law.compression = direction_strength(b, row[&WeldCards::lcc]);
      break;
    default: break;
  }
}

/// A law that asks for failure but names nothing that fails the weld is hardly meant.
void warn_of_no_failure(Builder& b, const WeldLaw& law, const kernel::Spotweld& points,
                        const RowOf<WeldCards>& second) {
  const auto given = [](const RateValue& strength) { return strength.given(); };
  const bool ends_otherwise =
      law.failure_time > 0.0 || points.failure_strain > 0.0 || law.damage.failure_strain > 0.0 || law.option < 0;
  std::string_view what;
  if (law.function != none) return;
  if (law.option == 0 && std::none_of(law.strength.begin(), law.strength.end(), given))
    what = "none of NRR to MTT is";
  else if (law.option == 1 && !law.normal_stress.given() && !law.shear_stress.given())
    what = "neither SIGAX nor SIGTAU is";
  else if (law.option == 11 && law.tension.curve.empty() && law.compression.curve.empty())
    what = "neither LCT nor LCC is";
  if (what.empty() || ends_otherwise) return;
  b.findings.warning(second.place(), second.keyword(),
                     fmt::format("{} given, and no EFAIL or TFAIL: nothing fails this weld (OPT {})", what, law.option),
                     "give the strengths, or use *MAT_SPOTWELD if the weld is not to fail");
}

/// The only one of some tables, or the one with the id in FVAL.
template <class Tables>
Index table_of(Builder& b, const deck::Entry& fval, const Ids& ids, const Tables& tables, std::string_view keyword) {
  const int id = fval.integer();
  if (id == 0 && tables.size() == 1) return 0;
  const Index table = ids.find(id);
  if (table == none)
    refuse(b, fval,
           id == 0 ? fmt::format("{} is defined {} times, and FVAL does not say which to take", keyword, tables.size())
                   : fmt::format("{} {} is not defined", keyword, id),
           fmt::format("define {} and give its id", keyword));
  return table;
}

/// FVAL of OPT -2 -1 0, which then takes the place of the resultant surface, and of the user's own OPT.
void set_function(Builder& b, WeldLaw& law, const deck::Entry& fval) {
  const int id = fval.integer();
  if (id == 0 && law.user() && !b.model.weld_library)
    return refuse(b, fval, fmt::format("OPT {} is a failure function of the user's own, and none is given", law.option),
                  "give FVAL, the id of a *DEFINE_FUNCTION, or a library: --weld-law FILE.so");
  if (id == 0) return;
  law.function = b.functions.find(id);
  if (law.function == none)
    return refuse(b, fval, fmt::format("*DEFINE_FUNCTION {} is not in the deck", id),
                  law.user() ? "define it" : "define it, or leave FVAL blank: NRR to MTT then fail the weld");
  const int most = weld_function_arguments, given = b.model.functions[law.function].formula.arguments();
  if (given < 1 || given > most)
    refuse(b, fval, fmt::format("function {} has {} arguments, expected 1 to {}", id, given, most),
           "N_rr N_rs N_rt M_rr M_ss M_tt, strain rate, diameter, both thicknesses, plastic strain, time, USRV1 ...");
}

/// What FVAL is depends on OPT. `length`: unit factor, for the stress intensity of OPT 4 (stress times root of length).
void set_limit(Builder& b, WeldLaw& law, const RowOf<WeldCards>& row, double length) {
  switch (law.option) {
    case -2:
    case -1:
    case 0:
    case 2:
    case 12:
    case 22: set_function(b, law, row[&WeldCards::function]); break;
    case 3:
    case 4:
    case 5:
      expect_positive(b, row[&WeldCards::fval],
                      law.option == 4 ? "the stress intensity at failure" : "the stress at failure");
      law.limit = row->fval * (law.option == 4 ? std::sqrt(length) : 1.0);
      break;
    case 6:
      law.cycles = std::max(1, static_cast<int>(row->fval));
      if (b.model.rupture_stresses.empty())
        refuse(b, row[&WeldCards::opt], "*DEFINE_SPOTWELD_RUPTURE_STRESS is not in the deck",
               "define it for the sheets' parts");
      break;
    case 7:
      law.table = table_of(b, row[&WeldCards::table], b.pair_strengths, b.model.pair_strengths,
                           "*DEFINE_SPOTWELD_FAILURE_RESULTANTS");
      break;
    case 10:
      law.table = table_of(b, row[&WeldCards::table], b.load_rate_strengths, b.model.load_rate_strengths,
                           "*DEFINE_SPOTWELD_FAILURE");
      break;
    default: break;
  }
}

/// `row`: the card on which DMGOPT stands.
void check_damage(Builder& b, const RowOf<WeldCards>& failure, const RowOf<WeldCards>& row, const WeldDamage& damage,
                  double failure_strain) {
  const int option = damage.option, kind = option % 10;
  if (option < 0 || option > 12 || kind > 2)
    return refuse(b, row[&WeldCards::dmgopt], fmt::format("DMGOPT {} is not a damage option of MAT_100", option),
                  "built are 0, 1, 2, 10, 11 and 12");
  if (damage.rupture <= 0.0 && (option != 0 || damage.beta > 0.0))
    failure[&WeldCards::rs].report(b.findings, Severity::warning,
                                   "without RS there is no damage: the weld fails at once", "give RS");
  if (option < 2 && damage.rupture > 0.0 && damage.rupture <= failure_strain)
    refuse(b, failure[&WeldCards::rs],
           fmt::format("the plastic strain at rupture must be above EFAIL = {:g}", failure_strain),
           "give a larger RS, or leave it blank: points then fail at EFAIL at once");
}

void check_correction(Builder& b, const RowOf<WeldCards>& row) {
  if (row->ttopt == 1)
    row[&WeldCards::ttopt].report(
        b.findings, Severity::warning,
        "the correction of release 8 is not public: it is made free of the numbering, as with 2", "write 0 or 2");
}

/// RS is a time with DMGOPT 2 and 12, so its card cannot say its unit.
void scale_rupture(const Block& block, WeldDamage& damage) {
  if (block.transform && damage.option % 10 == 2) damage.rupture *= block.transform->factor(dimension::time);
}

/// What the third card and the one after it say; `failure_strain`: EFAIL.
void read_weld_damage(Builder& b, Cursor& cursor, WeldLaw& law, const RowOf<WeldCards>& row, double failure_strain) {
  WeldDamage& damage = law.damage;
  damage.rupture = failure_value(row->rs);
  damage.true_thickness = row->true_t;
  damage.whole = row->asff == 1;
  damage.beta = row->beta;
  damage.option = static_cast<int>(row->dmgopt);
  if (damage.option != -1) {
    scale_rupture(cursor.block(), damage);
    return check_damage(b, row, row, damage, failure_strain);
  }
  if (!cursor.more())
    row[&WeldCards::dmgopt].report(b.findings, Severity::warning,
                                   "the next card, which is to give DMGOPT, is missing or blank: damage as with 0",
                                   "write DMGOPT there, or here in place of -1");
  const auto more = cursor.read(weld_damage_card);
  damage.option = static_cast<int>(more->dmgopt);
  scale_rupture(cursor.block(), damage);
  damage.mode = more->fmode;
  damage.cap = more->ffcap;
  check_correction(b, more);
  check_damage(b, row, more, damage, failure_strain);
  for (const auto field : {&WeldCards::fmode, &WeldCards::ffcap})
    if (damage.option < 10 && (*more).*field != 0.0)
      more[field].report(b.findings, Severity::warning, "counts for DMGOPT 10, 11 and 12 only", "leave it blank");
}

/// DMGOPT 0 to 2: every point is damaged by itself.
kernel::PointDamage point_damage(const WeldDamage& damage) {
  using Growth = kernel::PointDamage::Growth;
  if (damage.rupture <= 0.0 || damage.option > 2) return {};
  return {damage.option == 2 ? Growth::time : Growth::strain, damage.rupture, damage.beta, damage.option > 0};
}

/// DMGOPT 10 to 12: EFAIL begins the damage of the weld as a whole, and no point fails by itself.
void set_weld_damage(WeldDamage& damage, kernel::Spotweld& law) {
  if (damage.rupture <= 0.0 || damage.option < 10) return;
  damage.failure_strain = law.failure_strain;
  law.failure_strain = 0.0;
  law.yield_can_be_frozen = damage.option > 10;
}

/// SIGY < 0: a yield curve over plastic strain, or a table of them over the strain rate.
void set_yield_curve(Builder& b, const deck::Entry& sigy, kernel::Spotweld& law) {
  if (sigy.value >= 0.0) return;
  YieldTable table = yield_table(b, sigy, static_cast<int>(std::lround(-sigy.value)), false);
  law.yield_curves = std::move(table.curves);
  law.rates = std::move(table.rates);
  law.log_rates = table.log_rates;
}

/// Adds the material and what it says of welds as a whole.
Index add_weld(Builder& b, const RowOf<WeldCards>& row, std::string title, std::string_view keyword,
               kernel::Spotweld law, WeldLaw weld) {
  const Index material = add_material(b, row, std::move(title), keyword, law);
  b.model.materials[material].weld = static_cast<Index>(b.model.weld_laws.size());
  b.model.weld_laws.push_back(std::move(weld));
  return b.model.materials[material].weld;
}

kernel::Spotweld point_law(const WeldCards& cards) {
  kernel::Spotweld law;
  law.E = std::abs(cards.e);
  law.nu = cards.pr;
  law.mass_step = cards.dt;
  return law;
}

/// Young's modulus and its sign, which with _UNIAXIAL is the stress state of bricks.
bool is_uniaxial(Builder& b, const RowOf<WeldCards>& row, const Options& options) {
  if (row->e == 0.0) refuse(b, row[&WeldCards::e], "Young's modulus must not be 0");
  return row->e < 0.0 || options.contains("UNIAXIAL");
}

/// USRV1 to USRV6 stand on the second card; of OPT 12 and 22 sixteen more may stand on the last two.
void read_user_values(Cursor& cursor, WeldLaw& weld, WeldCards cards) {
  if (weld.option != 2)
    for (const auto* more : {&more_user_card, &last_user_card})
      if (cursor.more()) cursor.read(*more, cards);
  weld.user_values = cards.usrv;
}

/// *MAT_SPOTWELD, with the failure card if `with_failure`.
void read_weld(Builder& b, const Block& block, const Options& options, bool with_failure) {
  int option = 0;
  if (with_failure) {
    const auto failure = peek_option(b, block, options);
    option = static_cast<int>(failure->opt);
    if (!strength_card(option)) {
      b.mark_ignored(block);
      return refuse_option(b, failure[&WeldCards::opt], option);
    }
  }
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(weld_material_card);
  const auto second = cursor.read(*strength_card(option));
  kernel::Spotweld law = point_law(*row);
  law.yield = row->sigy;
  law.hardening = row->eh;
  law.failure_strain = failure_value(second->efail);
  WeldLaw weld;
  weld.option = option;
  law.uniaxial = is_uniaxial(b, row, options);
  weld.failure_time = failure_value(row->tfail);
  weld.filter = option == 5 ? 0 : second->nf;
  std::optional<RowOf<WeldCards>> failure;
  if (with_failure) {
    failure = cursor.read(failure_card_for(option));
    read_weld_damage(b, cursor, weld, *failure, law.failure_strain);
    law.damage = point_damage(weld.damage);
    set_weld_damage(weld.damage, law);
  }
  if (weld.user()) read_user_values(cursor, weld, *second);
  expect_end(b, cursor);
  const Index index = add_weld(b, row, std::move(title), with_failure ? "MAT_SPOTWELD_DAMAGE-FAILURE" : "MAT_SPOTWELD",
                               law, std::move(weld));
  // Curves and tables may be defined later in the deck.
  const std::size_t material = b.model.materials.size() - 1;
  b.defer(Phase::parts, [material, index, sigy = row[&WeldCards::sigy], second, failure,
                         length = block.transform ? block.transform->length : 1.0](Builder& later) {
    WeldLaw& built = later.model.weld_laws[index];
    set_yield_curve(later, sigy, std::get<kernel::Spotweld>(later.model.materials[material].law));
    set_strengths(later, built, second);
    if (!failure) return;
    set_limit(later, built, *failure, length);
    warn_of_no_failure(later, built, std::get<kernel::Spotweld>(later.model.materials[material].law), second);
  });
}

void read_plain(Builder& b, const Block& block, const Options& options) {
  read_weld(b, block, options, false);
}
void read_failure(Builder& b, const Block& block, const Options& options) {
  read_weld(b, block, options, true);
}

/// *MAT_SPOTWELD_DAIMLERCHRYSLER: yield stress, strengths and damage come from *DEFINE_CONNECTION_PROPERTIES.
void read_connection(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(connection_card);
  const auto second = cursor.read(weld_table_card);
  const auto third = cursor.read(connection_failure_card);
  kernel::Spotweld law = point_law(*row);
  law.yield = std::numeric_limits<double>::max();  // until the connection is known; it stays if CON_ID < 0
  WeldLaw weld;
  weld.damage.failure_strain = failure_value(second->efail);
  weld.connection = true;
  law.uniaxial = is_uniaxial(b, row, options);
  weld.failure_time = failure_value(row->tfail);
  weld.filter = second->nf;
  weld.rate_filter = third->rfiltf;
  weld.jacobian_limit = third->jtol;
  weld.damage.rupture = third->rs;
  weld.damage.true_thickness = third->true_t;
  weld.damage.whole = third->asff == 1;
  if (third->more == -1) check_correction(b, cursor.read(connection_more_card));
  expect_end(b, cursor);
  const Index index = add_weld(b, row, std::move(title), "MAT_SPOTWELD_DAIMLERCHRYSLER", law, std::move(weld));
  b.defer(Phase::parts, [index, con_id = third[&WeldCards::con_id]](Builder& later) {
    if (con_id.integer() > 0)
      later.model.weld_laws[index].properties = later.find(later.connections, "connection", con_id);
  });
}

}  // namespace

std::vector<Keyword> weld_material_keywords() {
  constexpr std::string_view by_resultants = "OPT -2, -1, 0", by_stress = "OPT 1", by_notch = "OPT 3, 4",
                             by_structure = "OPT 5", by_table = "OPT 6, 7, 10", by_direction = "OPT 11",
                             by_user = "OPT 2, 12, 22", more = "if DMGOPT = -1";
  return {
      {.name = "MAT_SPOTWELD",
       .aliases = {"MAT_100"},
       .options = {"TITLE", "UNIAXIAL"},
       .layout = {{"", &weld_material_card}, {"", &weld_resultant_card}},
       .read = read_plain},
      {.name = "MAT_SPOTWELD_DAMAGE-FAILURE",
       .aliases = {"MAT_100_DAMAGE-FAILURE"},
       .options = {"TITLE", "UNIAXIAL"},
       .layout = {{"", &weld_material_card},
                  {by_resultants, &weld_resultant_card},
                  {by_stress, &stress_card},
                  {by_notch, &notch_card},
                  {by_structure, &weld_structural_card},
                  {by_table, &weld_table_card},
                  {by_direction, &direction_card},
                  {by_user, &user_card},
                  {"", &weld_failure_card},
                  {more, &weld_damage_card},
                  {"OPT 12, 22", &more_user_card},
                  {"OPT 12, 22", &last_user_card}},
       .read = read_failure},
      {.name = "MAT_SPOTWELD_DAIMLERCHRYSLER",
       .aliases = {"MAT_SPOTWELD_DAIMLER", "MAT_100_DAIMLERCHRYSLER", "MAT_100_DAIMLER", "MAT_100_DA"},
       .options = {"TITLE", "UNIAXIAL"},
       .layout = {{"", &connection_card},
                  {"", &weld_table_card},
                  {"", &connection_failure_card},
                  {more, &connection_more_card}},
       .read = read_connection},
  };
}

}  // namespace nugget::reading
