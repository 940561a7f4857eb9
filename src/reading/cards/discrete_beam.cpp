// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "base/index.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *MAT_... of discrete beams (ELFORM 6): each law becomes six springs and a rule of failure (kernel::DiscreteBeam).
// Layouts: public keyword tables (PyDYNA); those of MAT_068, 121, 196 from the public LS-DYNA input interface of Altair
// Radioss.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;
using deck::RowOf;

constexpr IntegerField beam_material_id = id("mid", IdSpace::material, required, "material id");
constexpr RealField beam_density = real("ro", dimension::density, required, above_zero(), "density; mass = ro VOL");
constexpr Dimension angular_viscosity{1, 2, -1};

constexpr IntegerField curve_field(std::string_view name, std::string_view meaning) {
  return id(name, IdSpace::function, 0, meaning);
}

struct DiscreteLawCard {
  int mid = 0;
  double ro = 0;
};
/// Six numbers, or six curves; on the first card of a law behind its id and density.
struct ValuesCard : DiscreteLawCard {
  std::array<double, 6> value{};
};
struct CurvesCard : DiscreteLawCard {
  std::array<int, 6> curve{};
};
// The tables of six fields all run over the translations r, s, t and the rotations about them.
const CardOf<ValuesCard> linear_card{
    {&DiscreteLawCard::mid, beam_material_id},
    {&DiscreteLawCard::ro, beam_density},
    {at(&ValuesCard::value, 0), real("tkr", dimension::force_per_length, 0, at_least(0), "stiffness along r")},
    {at(&ValuesCard::value, 1), real("tks", dimension::force_per_length, 0, at_least(0), "along s")},
    {at(&ValuesCard::value, 2), real("tkt", dimension::force_per_length, 0, at_least(0), "along t")},
    {at(&ValuesCard::value, 3), real("rkr", dimension::moment, 0, at_least(0), "stiffness about r")},
    {at(&ValuesCard::value, 4), real("rks", dimension::moment, 0, at_least(0), "about s")},
    {at(&ValuesCard::value, 5), real("rkt", dimension::moment, 0, at_least(0), "about t")},
};
const CardOf<ValuesCard> linear_damping_card{
    {at(&ValuesCard::value, 0), real("tdr", dimension::damping_constant, 0, at_least(0), "viscous damper along r")},
    {at(&ValuesCard::value, 1), real("tds", dimension::damping_constant, 0, at_least(0), "along s")},
    {at(&ValuesCard::value, 2), real("tdt", dimension::damping_constant, 0, at_least(0), "along t")},
    {at(&ValuesCard::value, 3), real("rdr", angular_viscosity, 0, at_least(0), "viscous damper about r")},
    {at(&ValuesCard::value, 4), real("rds", angular_viscosity, 0, at_least(0), "about s")},
    {at(&ValuesCard::value, 5), real("rdt", angular_viscosity, 0, at_least(0), "about t")},
};
const CardOf<ValuesCard> preload_card{
    {at(&ValuesCard::value, 0), real("for", dimension::force, 0, any_value, "preload along r")},
    {at(&ValuesCard::value, 1), real("fos", dimension::force, 0, any_value, "along s")},
    {at(&ValuesCard::value, 2), real("fot", dimension::force, 0, any_value, "along t")},
    {at(&ValuesCard::value, 3), real("mor", dimension::moment, 0, any_value, "preload about r")},
    {at(&ValuesCard::value, 4), real("mos", dimension::moment, 0, any_value, "about s")},
    {at(&ValuesCard::value, 5), real("mot", dimension::moment, 0, any_value, "about t")},
};
const CardOf<CurvesCard> beam_curves_card{
    {&DiscreteLawCard::mid, beam_material_id},
    {&DiscreteLawCard::ro, beam_density},
    {at(&CurvesCard::curve, 0),
     curve_field("lcidtr", "force over displacement along r; one that starts at 0 holds for both signs")},
    {at(&CurvesCard::curve, 1), curve_field("lcidts", "along s")},
    {at(&CurvesCard::curve, 2), curve_field("lcidtt", "along t")},
    {at(&CurvesCard::curve, 3), curve_field("lcidrr", "moment over angle about r")},
    {at(&CurvesCard::curve, 4), curve_field("lcidrs", "about s")},
    {at(&CurvesCard::curve, 5), curve_field("lcidrt", "about t")},
};
const CardOf<CurvesCard> damper_curves_card{
    {at(&CurvesCard::curve, 0), curve_field("lcidtdr", "damping force over velocity along r")},
    {at(&CurvesCard::curve, 1), curve_field("lcidtds", "along s")},
    {at(&CurvesCard::curve, 2), curve_field("lcidtdt", "along t")},
    {at(&CurvesCard::curve, 3), curve_field("lcidrdr", "damping moment over rate of the angle about r")},
    {at(&CurvesCard::curve, 4), curve_field("lcidrds", "about s")},
    {at(&CurvesCard::curve, 5), curve_field("lcidrdt", "about t")},
};
const CardOf<CurvesCard> yield_curves_card{
    {at(&CurvesCard::curve, 0), curve_field("lcpdr", "yield force over plastic displacement along r; 0: elastic")},
    {at(&CurvesCard::curve, 1), curve_field("lcpds", "along s")},
    {at(&CurvesCard::curve, 2), curve_field("lcpdt", "along t")},
    {at(&CurvesCard::curve, 3), curve_field("lcpmr", "yield moment over plastic angle about r")},
    {at(&CurvesCard::curve, 4), curve_field("lcpms", "about s")},
    {at(&CurvesCard::curve, 5), curve_field("lcpmt", "about t")},
};
const CardOf<ValuesCard> force_failure_card{
    {at(&ValuesCard::value, 0),
     real("ffailr", dimension::force, 0, at_least(0), "force at failure along r; 0: left out")},
    {at(&ValuesCard::value, 1), real("ffails", dimension::force, 0, at_least(0), "along s")},
    {at(&ValuesCard::value, 2), real("ffailt", dimension::force, 0, at_least(0), "along t")},
    {at(&ValuesCard::value, 3), real("mfailr", dimension::moment, 0, at_least(0), "moment at failure about r")},
    {at(&ValuesCard::value, 4), real("mfails", dimension::moment, 0, at_least(0), "about s")},
    {at(&ValuesCard::value, 5), real("mfailt", dimension::moment, 0, at_least(0), "about t")},
};
const CardOf<ValuesCard> displacement_failure_card{
    {at(&ValuesCard::value, 0),
     real("ufailr", dimension::length, 0, at_least(0), "displacement at failure along r; 0: left out")},
    {at(&ValuesCard::value, 1), real("ufails", dimension::length, 0, at_least(0), "along s")},
    {at(&ValuesCard::value, 2), real("ufailt", dimension::length, 0, at_least(0), "along t")},
    {at(&ValuesCard::value, 3), real("tfailr", dimension::number, 0, at_least(0), "angle at failure about r")},
    {at(&ValuesCard::value, 4), real("tfails", dimension::number, 0, at_least(0), "about s")},
    {at(&ValuesCard::value, 5), real("tfailt", dimension::number, 0, at_least(0), "about t")},
};

struct GeneralBeamCard : DiscreteLawCard {
  double kt = 0, kr = 0, dampf = 0;
  int iunld = 0;
};
const CardOf<GeneralBeamCard> general_beam_card{
    {&GeneralBeamCard::mid, beam_material_id},
    {&GeneralBeamCard::ro, beam_density},
    {&GeneralBeamCard::kt,
     real("kt", dimension::force_per_length, 0, at_least(0), "stiffness of unloading, displacements")},
    {&GeneralBeamCard::kr, real("kr", dimension::moment, 0, at_least(0), "stiffness of unloading, angles")},
    {&GeneralBeamCard::iunld,
     integer("iunld", 0, between(0, 2), "unloading: 0 as loading, 1 on the unloading curve, 2 by KT, KR down to it")},
    real("offset", dimension::number, 0, any_value, "for IUNLD 3 only"),
    {&GeneralBeamCard::dampf, real("dampf", dimension::number, 0, any_value,
                                   "damping factor for stability, of KT and KR only: its scaling is not documented")},
    integer("iflag", 0, only(0), "1: force formulation"),
};
const CardOf<CurvesCard> general_load_card{
    {at(&CurvesCard::curve, 0),
     curve_field("lcidtr", "force over displacement along r; one that starts at 0 holds for both signs")},
    {at(&CurvesCard::curve, 1), curve_field("lcidts", "along s")},
    {at(&CurvesCard::curve, 2), curve_field("lcidtt", "along t")},
    {at(&CurvesCard::curve, 3), curve_field("lcidrr", "moment over angle about r")},
    {at(&CurvesCard::curve, 4), curve_field("lcidrs", "about s")},
    {at(&CurvesCard::curve, 5), curve_field("lcidrt", "about t")},
};
const CardOf<CurvesCard> general_unload_card{
    {at(&CurvesCard::curve, 0), curve_field("lcidtur", "unloading curve along r; 0: the loading curve")},
    {at(&CurvesCard::curve, 1), curve_field("lcidtus", "along s")},
    {at(&CurvesCard::curve, 2), curve_field("lcidtut", "along t")},
    {at(&CurvesCard::curve, 3), curve_field("lcidrur", "about r")},
    {at(&CurvesCard::curve, 4), curve_field("lcidrus", "about s")},
    {at(&CurvesCard::curve, 5), curve_field("lcidrut", "about t")},
};
const CardOf<CurvesCard> general_scale_card{
    {at(&CurvesCard::curve, 0), curve_field("lcidter", "factor on the damping force over displacement along r; 0: 1")},
    {at(&CurvesCard::curve, 1), curve_field("lcidtes", "along s")},
    {at(&CurvesCard::curve, 2), curve_field("lcidtet", "along t")},
    {at(&CurvesCard::curve, 3), curve_field("lcidrer", "about r")},
    {at(&CurvesCard::curve, 4), curve_field("lcidres", "about s")},
    {at(&CurvesCard::curve, 5), curve_field("lcidret", "about t")},
};
struct TensionCard : ValuesCard {
  double fcrit = 0;
};
const CardOf<TensionCard> general_tension_card{
    {at(&TensionCard::value, 0),
     real("utfailr", dimension::length, 0, at_least(0), "positive displacement at failure along r; 0: left out")},
    {at(&TensionCard::value, 1), real("utfails", dimension::length, 0, at_least(0), "along s")},
    {at(&TensionCard::value, 2), real("utfailt", dimension::length, 0, at_least(0), "along t")},
    {at(&TensionCard::value, 3),
     real("wtfailr", dimension::number, 0, at_least(0), "positive angle at failure about r")},
    {at(&TensionCard::value, 4), real("wtfails", dimension::number, 0, at_least(0), "about s")},
    {at(&TensionCard::value, 5), real("wtfailt", dimension::number, 0, at_least(0), "about t")},
    {&TensionCard::fcrit,
     real("fcrit", dimension::number, 0, between(0, 1), "0: positive and negative displacements apart, 1: together")},
};
const CardOf<ValuesCard> general_compression_card{
    {at(&ValuesCard::value, 0), real("ucfailr", dimension::length, 0, at_least(0),
                                     "negative displacement at failure along r, as a positive value")},
    {at(&ValuesCard::value, 1), real("ucfails", dimension::length, 0, at_least(0), "along s")},
    {at(&ValuesCard::value, 2), real("ucfailt", dimension::length, 0, at_least(0), "along t")},
    {at(&ValuesCard::value, 3),
     real("wcfailr", dimension::number, 0, at_least(0), "negative angle at failure about r")},
    {at(&ValuesCard::value, 4), real("wcfails", dimension::number, 0, at_least(0), "about s")},
    {at(&ValuesCard::value, 5), real("wcfailt", dimension::number, 0, at_least(0), "about t")},
};
const CardOf<ValuesCard> general_start_card{
    {at(&ValuesCard::value, 0), real("iur", dimension::length, 0, any_value, "displacement at time 0 along r")},
    {at(&ValuesCard::value, 1), real("ius", dimension::length, 0, any_value, "along s")},
    {at(&ValuesCard::value, 2), real("iut", dimension::length, 0, any_value, "along t")},
    {at(&ValuesCard::value, 3), real("iwr", dimension::number, 0, any_value, "angle at time 0 about r")},
    {at(&ValuesCard::value, 4), real("iws", dimension::number, 0, any_value, "about s")},
    {at(&ValuesCard::value, 5), real("iwt", dimension::number, 0, any_value, "about t")},
};

struct SingleCard : DiscreteLawCard {
  double k = 0, dampf = 0;
  int iunld = 0;
};
const CardOf<SingleCard> single_card{
    {&SingleCard::mid, beam_material_id},
    {&SingleCard::ro, beam_density},
    {&SingleCard::k, real("k", dimension::force_per_length, 0, at_least(0), "stiffness of unloading")},
    {&SingleCard::iunld,
     integer("iunld", 0, between(0, 2), "unloading: 0 as loading, 1 on the unloading curve, 2 by K down to it")},
    real("offset", dimension::number, 0, any_value, "for IUNLD 3 only"),
    {&SingleCard::dampf, real("dampf", dimension::number, 0, any_value,
                              "damping factor for stability, of K only: its scaling is not documented")},
};
struct SingleCurvesCard {
  int lcidt = 0, lcidtu = 0, lcidtd = 0, lcidte = 0;
};
const CardOf<SingleCurvesCard> single_curves_card{
    {&SingleCurvesCard::lcidt,
     curve_field("lcidt", "force over elongation; one that starts at 0 holds for both signs")},
    {&SingleCurvesCard::lcidtu, curve_field("lcidtu", "unloading curve; 0: the loading curve")},
    {&SingleCurvesCard::lcidtd, curve_field("lcidtd", "damping force over velocity")},
    {&SingleCurvesCard::lcidte, curve_field("lcidte", "factor on the damping force over displacement; 0: 1")},
};
struct SingleFailureCard {
  double utfail = 0, ucfail = 0, iu = 0;
};
const CardOf<SingleFailureCard> single_failure_card{
    {&SingleFailureCard::utfail,
     real("utfail", dimension::length, 0, at_least(0), "positive displacement at failure; 0: left out")},
    {&SingleFailureCard::ucfail,
     real("ucfail", dimension::length, 0, at_least(0), "negative displacement at failure, as a positive value")},
    {&SingleFailureCard::iu, real("iu", dimension::length, 0, any_value, "displacement at time 0")},
};

struct SpringCard : DiscreteLawCard {
  double k = 0, f0 = 0, d = 0, cdf = 0, tdf = 0;
};
const CardOf<SpringCard> spring_card{
    {&SpringCard::mid, beam_material_id},
    {&SpringCard::ro, beam_density},
    {&SpringCard::k,
     real("k", dimension::force_per_length, 0, at_least(0), "stiffness; with FLCID a factor on its ordinates")},
    {&SpringCard::f0, real("f0", dimension::force, 0, any_value, "preload")},
    {&SpringCard::d, real("d", dimension::damping_constant, 0, at_least(0), "viscous damper")},
    {&SpringCard::cdf, real("cdf", dimension::length, 0, at_least(0), "compression at failure; 0: none")},
    {&SpringCard::tdf, real("tdf", dimension::length, 0, at_least(0), "elongation at failure; 0: none")},
};
struct CableCard : DiscreteLawCard {
  double e = 0;
  int lcid = 0;
  double f0 = 0, iread = 0;
};
const CardOf<CableCard> cable_card{
    {&CableCard::mid, beam_material_id},
    {&CableCard::ro, beam_density},
    {&CableCard::e, real("e", dimension::stress, 0, any_value,
                         "Young's modulus, times CA over the unstretched length; below 0: the stiffness itself")},
    {&CableCard::lcid, curve_field("lcid", "nominal stress over strain, in place of E")},
    {&CableCard::f0, real("f0", dimension::force, 0, any_value, "force at the unstretched length")},
    real("tmaxf0", dimension::time, 0, only(0), "time until which the force is kept at F0: not built"),
    real("tramp", dimension::time, 0, only(0), "time in which F0 comes up: not built"),
    {&CableCard::iread, real("iread", dimension::number, 0, at_least(0), "1: another card follows")},
};
struct CableLimitsCard {
  double mxeps = 1e20, mxfrc = 1e20;
};
const CardOf<CableLimitsCard> cable_limits_card{
    integer("output", 0, any_value, "what is written as stress and strain: no effect here"),
    real("tstart", dimension::time, 0, only(0), "time at which F0 begins to come up: not built"),
    real("fracl0", dimension::number, 0, only(0), "share of its length that the cable is drawn to: not built"),
    {&CableLimitsCard::mxeps,
     real("mxeps", dimension::number, 1e20, at_least(0), "strain at which the cable breaks; 0 and 1e20: never")},
    {&CableLimitsCard::mxfrc,
     real("mxfrc", dimension::force, 1e20, at_least(0), "force at which it breaks; 0 and 1e20: never")},
};
struct RateCard {
  int flcid = 0, hlcid = 0;
  double c1 = 0, c2 = 0, dle = 0;
  int glcid = 0;
};
const CardOf<RateCard> rate_card{
    {&RateCard::flcid,
     curve_field("flcid", "force over displacement; elastoplastic: yield force over plastic displacement")},
    {&RateCard::hlcid, curve_field("hlcid", "force over velocity")},
    {&RateCard::c1, real("c1", {0, -1, 1}, 0, at_least(0), "factor 1 + C1 v on the force")},
    {&RateCard::c2, real("c2", dimension::number, 0, at_least(0), "factor 1 + C2 ln max(1, |v|/DLE) on the force")},
    {&RateCard::dle, real("dle", dimension::velocity, 1, above_zero(), "velocity that C2 refers to")},
    {&RateCard::glcid, curve_field("glcid", "factor on HLCID over displacement; 0: 1")},
};
const CardOf<DiscreteLawCard> spring_beam_card{
    {&DiscreteLawCard::mid, beam_material_id},
    {&DiscreteLawCard::ro, beam_density},
    unused(),
    unused(),
    unused(),
    unused(),
    unused(),
    integer("dospot", 0, only(0), "thinning of shells by SPOTHIN at these beams"),
};
struct DegreeCard {
  int dof = 0, type = 0;
  double k = 0, d = 0, cdf = 0, tdf = 0;
};
const CardOf<DegreeCard> degree_card{
    {&DegreeCard::dof,
     integer("dof", required, between(1, 6), "degree of freedom: 1 2 3 along r s t, 4 5 6 about them")},
    {&DegreeCard::type, integer("type", 0, between(0, 1), "0 elastic, 1 elastoplastic")},
    {&DegreeCard::k, real("k", dimension::force_per_length, 0, at_least(0), "stiffness")},
    {&DegreeCard::d, real("d", dimension::damping_constant, 0, at_least(0), "viscous damper")},
    {&DegreeCard::cdf,
     real("cdf", dimension::length, 0, at_least(0), "negative displacement at failure, as a positive value; 0: none")},
    {&DegreeCard::tdf, real("tdf", dimension::length, 0, at_least(0), "positive displacement at failure; 0: none")},
};

using DiscreteKind = kernel::DiscreteSpring::Kind;

double beam_failure_value(double written) {
  return written >= 1e20 ? 0.0 : written;
}

std::array<double, 6> failure_values(std::array<double, 6> value) {
  for (double& v : value) v = beam_failure_value(v);
  return value;
}

void add_law(Builder& b, const Row& row, const DiscreteLawCard& card, std::string title, std::string_view keyword,
             std::function<void(Builder&, kernel::DiscreteBeam&)> fill) {
  const auto index = static_cast<Index>(b.model.materials.size());
  Material m{card.mid, std::move(title), std::string(keyword), card.ro, kernel::DiscreteBeam{}, row.place()};
  b.materials.add(m.id, index, m.place, row.keyword(), "material", b.findings);
  b.model.materials.push_back(std::move(m));
  // Curves may be defined later in the deck.
  b.defer(Phase::parts, [index, fill = std::move(fill)](Builder& later) {
    auto& material = later.model.materials[index];
    fill(later, std::get<kernel::DiscreteBeam>(material.law));
  });
}

kernel::ForceCurve beam_force_curve(Builder& b, const deck::Entry& field) {
  const Index c = b.curve(field);
  return c == none ? kernel::ForceCurve{} : kernel::ForceCurve(b.model.curves[c]);
}

/// The six curves of a card.
std::array<kernel::ForceCurve, 6> six_curves(Builder& b, const RowOf<CurvesCard>& row) {
  std::array<kernel::ForceCurve, 6> curves;
  for (std::size_t i = 0; i < 6; ++i) curves[i] = beam_force_curve(b, row[at(&CurvesCard::curve, i)]);
  return curves;
}

/// Up to the yield force elastic with K; without a curve elastic for ever. K is raised to twice the steepest hardening
/// (LS-DYNA's rule for these laws); a fall steeper than K has no solution.
void make_elastoplastic(Builder& b, const deck::Entry& field, const kernel::ForceCurve& yield,
                        kernel::DiscreteSpring& spring) {
  spring.kind = DiscreteKind::linear;
  if (yield.empty()) return;
  spring.kind = DiscreteKind::elastoplastic;
  spring.load = yield.tension_side();
  spring.unload = yield.compression_side();
  if (spring.load.empty() || spring.unload.empty())
    return refuse(b, field, "the yield curve has points on one side only, and not on that of tension",
                  "give points at positive abscissae as well");
  for (const kernel::ForceCurve* side : {&spring.load, &spring.unload}) {
    spring.stiffness = std::max(spring.stiffness, 2.0 * side->steepest_rise());
    if (side->lowest() < 0.0)
      refuse(b, field, "a yield force has the sign of its displacement", "leave no negative ones in tension");
    if (!(spring.stiffness > side->steepest_fall()))
      refuse(b, field, "the yield force falls faster than the elastic force, so it cannot be followed",
             "give a larger stiffness, or a curve that falls less steeply");
  }
}

void read_linear(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(linear_card);
  const auto damping = cursor.read(linear_damping_card);
  const auto preload = cursor.read(preload_card);
  expect_end(b, cursor);
  add_law(b, row, *row, std::move(title), "MAT_LINEAR_ELASTIC_DISCRETE_BEAM",
          [row, damping, preload](Builder&, kernel::DiscreteBeam& law) {
            for (std::size_t i = 0; i < 6; ++i) {
              law.dof[i].kind = DiscreteKind::linear;
              law.dof[i].stiffness = row->value[i];
              law.dof[i].damping = damping->value[i];
              law.dof[i].preload = preload->value[i];
            }
          });
}

void take_failure(const RowOf<ValuesCard>& force, const RowOf<ValuesCard>& displacement, kernel::DiscreteBeam& law) {
  law.rule = kernel::DiscreteBeam::Rule::together;
  law.force_limit = failure_values(force->value);
  law.tension_limit = law.compression_limit = failure_values(displacement->value);
}

void read_nonlinear(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(beam_curves_card);
  const auto damper = cursor.read(damper_curves_card);
  const auto preload = cursor.read(preload_card);
  const auto force = cursor.read(force_failure_card);
  const auto displacement = cursor.read(displacement_failure_card);
  expect_end(b, cursor);
  add_law(b, row, *row, std::move(title), "MAT_NONLINEAR_ELASTIC_DISCRETE_BEAM",
          [row, damper, preload, force, displacement](Builder& later, kernel::DiscreteBeam& law) {
            auto load = six_curves(later, row), over_rate = six_curves(later, damper);
            for (std::size_t i = 0; i < 6; ++i) {
              law.dof[i].kind = DiscreteKind::elastic;
              law.dof[i].load = std::move(load[i]);
              law.dof[i].damper = std::move(over_rate[i]);
              law.dof[i].preload = preload->value[i];
            }
            take_failure(force, displacement, law);
          });
}

void read_plastic_beam(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(linear_card);
  const auto damping = cursor.read(linear_damping_card);
  const auto yield = cursor.read(yield_curves_card);
  const auto force = cursor.read(force_failure_card);
  const auto displacement = cursor.read(displacement_failure_card);
  const auto preload = cursor.read(preload_card);
  expect_end(b, cursor);
  add_law(b, row, *row, std::move(title), "MAT_NONLINEAR_PLASTIC_DISCRETE_BEAM",
          [row, damping, yield, force, displacement, preload](Builder& later, kernel::DiscreteBeam& law) {
            auto curves = six_curves(later, yield);
            for (std::size_t i = 0; i < 6; ++i) {
              law.dof[i].stiffness = row->value[i];
              law.dof[i].damping = damping->value[i];
              law.dof[i].preload = preload->value[i];
              make_elastoplastic(later, yield[at(&CurvesCard::curve, i)], curves[i], law.dof[i]);
            }
            take_failure(force, displacement, law);
          });
}

/// How loading and unloading of MAT_119 and MAT_121 go together.
void set_unloading(Builder& b, int iunld, const deck::Entry& k, const deck::Entry& unload_field,
                   kernel::ForceCurve unload, kernel::DiscreteSpring& spring) {
  spring.kind = DiscreteKind::elastic;
  if (iunld == 0 || spring.load.empty()) return;
  if (iunld == 2) {
    spring.kind = DiscreteKind::hysteresis;
    spring.stiffness = k.value;
    if (!(k.value > 0.0)) refuse(b, k, "unloading by IUNLD 2 needs this stiffness", "give the slope of unloading");
    if (unload.empty())
      refuse(b, unload_field, "unloading by IUNLD 2 needs an unloading curve", "give one, e.g. of zero force");
  } else if (!unload.empty()) {
    spring.kind = DiscreteKind::two_curves;
  }
  spring.unload = std::move(unload);
}

/// DAMPF acts only where the local stiffness, KT, KR or K, is given (manual, vol. II).
void refuse_damping(Builder& b, const deck::Entry& dampf, double stiffness) {
  if (stiffness > 0.0)
    refuse_nonzero(b, dampf, "damping of the local stiffness is not built: how it is scaled is not documented",
                   "write 0 and damp by LCIDTDR and so on");
}

void read_general_beam(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(general_beam_card);
  refuse_damping(b, row[&GeneralBeamCard::dampf], row->kt + row->kr);
  const auto load = cursor.read(general_load_card);
  const auto unload = cursor.read(general_unload_card);
  const auto damper = cursor.read(damper_curves_card);
  const auto scale = cursor.read(general_scale_card);
  const auto tension = cursor.read(general_tension_card);
  const auto compression = cursor.read(general_compression_card);
  const auto start = cursor.read(general_start_card);
  expect_end(b, cursor);
  add_law(b, row, *row, std::move(title), "MAT_GENERAL_NONLINEAR_6DOF_DISCRETE_BEAM",
          [row, load, unload, damper, scale, tension, compression, start](Builder& later, kernel::DiscreteBeam& law) {
            auto loading = six_curves(later, load), unloading = six_curves(later, unload),
                 over_rate = six_curves(later, damper), factor = six_curves(later, scale);
            for (std::size_t i = 0; i < 6; ++i) {
              kernel::DiscreteSpring& spring = law.dof[i];
              spring.load = std::move(loading[i]);
              set_unloading(later, row->iunld, i < 3 ? row[&GeneralBeamCard::kt] : row[&GeneralBeamCard::kr],
                            unload[at(&CurvesCard::curve, i)], std::move(unloading[i]), spring);
              spring.damper = std::move(over_rate[i]);
              spring.damper_scale = std::move(factor[i]);
              spring.start = start->value[i];
            }
            law.rule = tension->fcrit == 1.0 ? kernel::DiscreteBeam::Rule::together : kernel::DiscreteBeam::Rule::sides;
            law.tension_limit = failure_values(tension->value);
            law.compression_limit = failure_values(compression->value);
          });
}

void read_single_beam(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(single_card);
  refuse_damping(b, row[&SingleCard::dampf], row->k);
  const auto curves = cursor.read(single_curves_card);
  const auto failure = cursor.read(single_failure_card);
  expect_end(b, cursor);
  add_law(b, row, *row, std::move(title), "MAT_GENERAL_NONLINEAR_1DOF_DISCRETE_BEAM",
          [row, curves, failure](Builder& later, kernel::DiscreteBeam& law) {
            law.between_points = true;
            kernel::DiscreteSpring& spring = law.dof[0];
            spring.load = beam_force_curve(later, curves[&SingleCurvesCard::lcidt]);
            set_unloading(later, row->iunld, row[&SingleCard::k], curves[&SingleCurvesCard::lcidtu],
                          beam_force_curve(later, curves[&SingleCurvesCard::lcidtu]), spring);
            spring.damper = beam_force_curve(later, curves[&SingleCurvesCard::lcidtd]);
            spring.damper_scale = beam_force_curve(later, curves[&SingleCurvesCard::lcidte]);
            spring.start = failure->iu;
            law.tension_limit[0] = beam_failure_value(failure->utfail);
            law.compression_limit[0] = beam_failure_value(failure->ucfail);
          });
}

void take_rates(Builder& b, const RowOf<RateCard>& rates, kernel::DiscreteSpring& spring) {
  spring.damper = beam_force_curve(b, rates[&RateCard::hlcid]);
  spring.damper_scale = beam_force_curve(b, rates[&RateCard::glcid]);
  spring.linear_rate = rates->c1;
  spring.log_rate = rates->c2;
  spring.rate = rates->dle;
}

void read_spring(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(spring_card);
  const auto rates = cursor.read(rate_card);
  expect_end(b, cursor);
  add_law(b, row, *row, std::move(title), "MAT_ELASTIC_SPRING_DISCRETE_BEAM",
          [row, rates](Builder& later, kernel::DiscreteBeam& law) {
            law.between_points = true;
            kernel::DiscreteSpring& spring = law.dof[0];
            spring.load = beam_force_curve(later, rates[&RateCard::flcid]);
            spring.kind = spring.load.empty() ? DiscreteKind::linear : DiscreteKind::elastic;
            spring.stiffness = row->k;
            if (!spring.load.empty() && row->k != 0.0 && row->k != 1.0)
              refuse(later, row[&SpringCard::k],
                     "with FLCID, sources differ whether K multiplies its ordinates; only 0 and 1 leave no doubt",
                     "write 1 and scale the curve by SFO");
            spring.preload = row->f0;
            spring.damping = row->d;
            take_rates(later, rates, spring);
            law.tension_limit[0] = beam_failure_value(row->tdf);
            law.compression_limit[0] = beam_failure_value(row->cdf);
          });
}

void read_cable(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(cable_card);
  if (row->e < 0.0 && block.transform != nullptr && block.transform->changes_units())
    refuse(b, row[&CableCard::e], "a stiffness in the place of a modulus takes no unit factor of *INCLUDE_TRANSFORM",
           "write the material in the main deck");
  const auto limits = row->iread >= 1.0 ? cursor.read(cable_limits_card) : RowOf<CableLimitsCard>{};
  expect_end(b, cursor);
  add_law(b, row, *row, std::move(title), "MAT_CABLE_DISCRETE_BEAM",
          [row, limits](Builder& later, kernel::DiscreteBeam& law) {
            law.between_points = true;
            kernel::Cable cable;
            cable.modulus = std::max(row->e, 0.0);
            cable.stiffness = std::max(-row->e, 0.0);
            cable.preload = row->f0;
            if (const Index c = later.curve(row[&CableCard::lcid]); c != none) cable.set_curve(later.model.curves[c]);
            cable.most_strain = beam_failure_value(limits->mxeps);
            cable.most_force = beam_failure_value(limits->mxfrc);
            if (cable.stress.empty() && row->e == 0.0 && row->f0 == 0.0)
              refuse(later, row[&CableCard::e], "a cable without stiffness and without force does nothing",
                     "give E, its stiffness with a minus, LCID or F0");
            law.cable = std::move(cable);
          });
}

void read_spring_beam(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(spring_beam_card);
  std::vector<std::pair<RowOf<DegreeCard>, RowOf<RateCard>>> degrees;
  while (!at_end(cursor)) {
    auto degree = cursor.read(degree_card);
    degrees.emplace_back(std::move(degree), cursor.read(rate_card));
  }
  add_law(b, row, *row, std::move(title), "MAT_GENERAL_SPRING_DISCRETE_BEAM",
          [degrees](Builder& later, kernel::DiscreteBeam& law) {
            for (const auto& [degree, rates] : degrees) {
              const int dof = degree->dof;
              if (dof < 1 || dof > 6) continue;  // reported already
              const auto i = at(dof - 1);
              kernel::DiscreteSpring& spring = law.dof[i];
              if (spring.kind != DiscreteKind::none)
                refuse(later, degree[&DegreeCard::dof], "this degree of freedom is given twice");
              spring.stiffness = degree->k;
              spring.damping = degree->d;
              kernel::ForceCurve curve = beam_force_curve(later, rates[&RateCard::flcid]);
              if (degree->type == 1) {
                make_elastoplastic(later, rates[&RateCard::flcid], curve, spring);
              } else {
                spring.kind = curve.empty() ? DiscreteKind::linear : DiscreteKind::elastic;
                spring.load = std::move(curve);
              }
              take_rates(later, rates, spring);
              law.tension_limit[i] = beam_failure_value(degree->tdf);
              law.compression_limit[i] = beam_failure_value(degree->cdf);
            }
          });
}

}  // namespace

std::vector<Keyword> discrete_beam_keywords() {
  return {
      {.name = "MAT_LINEAR_ELASTIC_DISCRETE_BEAM",
       .aliases = {"MAT_066"},
       .options = {"TITLE"},
       .layout = {{"", &linear_card}, {"", &linear_damping_card}, {"", &preload_card}},
       .read = read_linear},
      {.name = "MAT_NONLINEAR_ELASTIC_DISCRETE_BEAM",
       .aliases = {"MAT_067"},
       .options = {"TITLE"},
       .layout = {{"", &beam_curves_card},
                  {"", &damper_curves_card},
                  {"", &preload_card},
                  {"", &force_failure_card},
                  {"", &displacement_failure_card}},
       .read = read_nonlinear},
      {.name = "MAT_NONLINEAR_PLASTIC_DISCRETE_BEAM",
       .aliases = {"MAT_068"},
       .options = {"TITLE"},
       .layout = {{"", &linear_card},
                  {"", &linear_damping_card},
                  {"", &yield_curves_card},
                  {"", &force_failure_card},
                  {"", &displacement_failure_card},
                  {"", &preload_card}},
       .read = read_plastic_beam},
      {.name = "MAT_CABLE_DISCRETE_BEAM",
       .aliases = {"MAT_071"},
       .options = {"TITLE"},
       .layout = {{"", &cable_card}, {"if IREAD is 1 or more", &cable_limits_card}},
       .read = read_cable},
      {.name = "MAT_ELASTIC_SPRING_DISCRETE_BEAM",
       .aliases = {"MAT_074"},
       .options = {"TITLE"},
       .layout = {{"", &spring_card}, {"", &rate_card}},
       .read = read_spring},
      {.name = "MAT_GENERAL_NONLINEAR_6DOF_DISCRETE_BEAM",
       .aliases = {"MAT_119"},
       .options = {"TITLE"},
       .layout = {{"", &general_beam_card},
                  {"", &general_load_card},
                  {"", &general_unload_card},
                  {"", &damper_curves_card},
                  {"", &general_scale_card},
                  {"", &general_tension_card},
                  {"", &general_compression_card},
                  {"", &general_start_card}},
       .read = read_general_beam},
      {.name = "MAT_GENERAL_NONLINEAR_1DOF_DISCRETE_BEAM",
       .aliases = {"MAT_121"},
       .options = {"TITLE"},
       .layout = {{"", &single_card}, {"", &single_curves_card}, {"", &single_failure_card}},
       .read = read_single_beam},
      {.name = "MAT_GENERAL_SPRING_DISCRETE_BEAM",
       .aliases = {"MAT_196"},
       .options = {"TITLE"},
       .layout = {{"", &spring_beam_card}, {"for each degree of freedom", &degree_card}, {"and", &rate_card}},
       .read = read_spring_beam},
  };
}

}  // namespace nugget::reading
