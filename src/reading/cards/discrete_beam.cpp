// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

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

constexpr Field material_id = id("mid", IdSpace::material, required, "material id");
constexpr Field density = real("ro", dimension::density, required, above_zero(), "density; mass = ro VOL");
constexpr Dimension force_per_length{1, 0, -2}, viscosity{1, 0, -1}, angular_viscosity{1, 2, -1};

constexpr Field curve_field(std::string_view name, std::string_view meaning) {
  return id(name, IdSpace::function, 0, meaning);
}

// The tables of six fields all run over the translations r, s, t and the rotations about them.
const Card linear_card{{
    material_id,
    density,
    real("tkr", force_per_length, 0, at_least(0), "stiffness along r"),
    real("tks", force_per_length, 0, at_least(0), "along s"),
    real("tkt", force_per_length, 0, at_least(0), "along t"),
    real("rkr", dimension::moment, 0, at_least(0), "stiffness about r"),
    real("rks", dimension::moment, 0, at_least(0), "about s"),
    real("rkt", dimension::moment, 0, at_least(0), "about t"),
}};
const Card linear_damping_card{{
    real("tdr", viscosity, 0, at_least(0), "viscous damper along r"),
    real("tds", viscosity, 0, at_least(0), "along s"),
    real("tdt", viscosity, 0, at_least(0), "along t"),
    real("rdr", angular_viscosity, 0, at_least(0), "viscous damper about r"),
    real("rds", angular_viscosity, 0, at_least(0), "about s"),
    real("rdt", angular_viscosity, 0, at_least(0), "about t"),
}};
const Card preload_card{{
    real("for", dimension::force, 0, any_value, "preload along r"),
    real("fos", dimension::force, 0, any_value, "along s"),
    real("fot", dimension::force, 0, any_value, "along t"),
    real("mor", dimension::moment, 0, any_value, "preload about r"),
    real("mos", dimension::moment, 0, any_value, "about s"),
    real("mot", dimension::moment, 0, any_value, "about t"),
}};
const Card curves_card{{
    material_id,
    density,
    curve_field("lcidtr", "force over displacement along r; one that starts at 0 holds for both signs"),
    curve_field("lcidts", "along s"),
    curve_field("lcidtt", "along t"),
    curve_field("lcidrr", "moment over angle about r"),
    curve_field("lcidrs", "about s"),
    curve_field("lcidrt", "about t"),
}};
const Card damper_curves_card{{
    curve_field("lcidtdr", "damping force over velocity along r"),
    curve_field("lcidtds", "along s"),
    curve_field("lcidtdt", "along t"),
    curve_field("lcidrdr", "damping moment over rate of the angle about r"),
    curve_field("lcidrds", "about s"),
    curve_field("lcidrdt", "about t"),
}};
const Card yield_curves_card{{
    curve_field("lcpdr", "yield force over plastic displacement along r; 0: elastic"),
    curve_field("lcpds", "along s"),
    curve_field("lcpdt", "along t"),
    curve_field("lcpmr", "yield moment over plastic angle about r"),
    curve_field("lcpms", "about s"),
    curve_field("lcpmt", "about t"),
}};
const Card force_failure_card{{
    real("ffailr", dimension::force, 0, at_least(0), "force at failure along r; 0: left out"),
    real("ffails", dimension::force, 0, at_least(0), "along s"),
    real("ffailt", dimension::force, 0, at_least(0), "along t"),
    real("mfailr", dimension::moment, 0, at_least(0), "moment at failure about r"),
    real("mfails", dimension::moment, 0, at_least(0), "about s"),
    real("mfailt", dimension::moment, 0, at_least(0), "about t"),
}};
const Card displacement_failure_card{{
    real("ufailr", dimension::length, 0, at_least(0), "displacement at failure along r; 0: left out"),
    real("ufails", dimension::length, 0, at_least(0), "along s"),
    real("ufailt", dimension::length, 0, at_least(0), "along t"),
    real("tfailr", dimension::number, 0, at_least(0), "angle at failure about r"),
    real("tfails", dimension::number, 0, at_least(0), "about s"),
    real("tfailt", dimension::number, 0, at_least(0), "about t"),
}};

const Card general_card{{
    material_id,
    density,
    real("kt", force_per_length, 0, at_least(0), "stiffness of unloading, displacements"),
    real("kr", dimension::moment, 0, at_least(0), "stiffness of unloading, angles"),
    integer("iunld", 0, between(0, 2), "unloading: 0 as loading, 1 on the unloading curve, 2 by KT, KR down to it"),
    real("offset", dimension::number, 0, any_value, "for IUNLD 3 only"),
    real("dampf", dimension::number, 0, only(0), "damping factor for stability: its scaling is not documented"),
    integer("iflag", 0, only(0), "1: force formulation"),
}};
const Card general_load_card{{
    curve_field("lcidtr", "force over displacement along r; one that starts at 0 holds for both signs"),
    curve_field("lcidts", "along s"),
    curve_field("lcidtt", "along t"),
    curve_field("lcidrr", "moment over angle about r"),
    curve_field("lcidrs", "about s"),
    curve_field("lcidrt", "about t"),
}};
const Card general_unload_card{{
    curve_field("lcidtur", "unloading curve along r; 0: the loading curve"),
    curve_field("lcidtus", "along s"),
    curve_field("lcidtut", "along t"),
    curve_field("lcidrur", "about r"),
    curve_field("lcidrus", "about s"),
    curve_field("lcidrut", "about t"),
}};
const Card general_scale_card{{
    curve_field("lcidter", "factor on the damping force over displacement along r; 0: 1"),
    curve_field("lcidtes", "along s"),
    curve_field("lcidtet", "along t"),
    curve_field("lcidrer", "about r"),
    curve_field("lcidres", "about s"),
    curve_field("lcidret", "about t"),
}};
const Card general_tension_card{{
    real("utfailr", dimension::length, 0, at_least(0), "positive displacement at failure along r; 0: left out"),
    real("utfails", dimension::length, 0, at_least(0), "along s"),
    real("utfailt", dimension::length, 0, at_least(0), "along t"),
    real("wtfailr", dimension::number, 0, at_least(0), "positive angle at failure about r"),
    real("wtfails", dimension::number, 0, at_least(0), "about s"),
    real("wtfailt", dimension::number, 0, at_least(0), "about t"),
    real("fcrit", dimension::number, 0, between(0, 1), "0: positive and negative displacements apart, 1: together"),
}};
const Card general_compression_card{{
    real("ucfailr", dimension::length, 0, at_least(0), "negative displacement at failure along r, as a positive value"),
    real("ucfails", dimension::length, 0, at_least(0), "along s"),
    real("ucfailt", dimension::length, 0, at_least(0), "along t"),
    real("wcfailr", dimension::number, 0, at_least(0), "negative angle at failure about r"),
    real("wcfails", dimension::number, 0, at_least(0), "about s"),
    real("wcfailt", dimension::number, 0, at_least(0), "about t"),
}};
const Card general_start_card{{
    real("iur", dimension::length, 0, any_value, "displacement at time 0 along r"),
    real("ius", dimension::length, 0, any_value, "along s"),
    real("iut", dimension::length, 0, any_value, "along t"),
    real("iwr", dimension::number, 0, any_value, "angle at time 0 about r"),
    real("iws", dimension::number, 0, any_value, "about s"),
    real("iwt", dimension::number, 0, any_value, "about t"),
}};

const Card single_card{{
    material_id,
    density,
    real("k", force_per_length, 0, at_least(0), "stiffness of unloading"),
    integer("iunld", 0, between(0, 2), "unloading: 0 as loading, 1 on the unloading curve, 2 by K down to it"),
    real("offset", dimension::number, 0, any_value, "for IUNLD 3 only"),
    real("dampf", dimension::number, 0, only(0), "damping factor for stability: its scaling is not documented"),
}};
const Card single_curves_card{{
    curve_field("lcidt", "force over elongation; one that starts at 0 holds for both signs"),
    curve_field("lcidtu", "unloading curve; 0: the loading curve"),
    curve_field("lcidtd", "damping force over velocity"),
    curve_field("lcidte", "factor on the damping force over displacement; 0: 1"),
}};
const Card single_failure_card{{
    real("utfail", dimension::length, 0, at_least(0), "positive displacement at failure; 0: left out"),
    real("ucfail", dimension::length, 0, at_least(0), "negative displacement at failure, as a positive value"),
    real("iu", dimension::length, 0, any_value, "displacement at time 0"),
}};

const Card spring_card{{
    material_id,
    density,
    real("k", force_per_length, 0, at_least(0), "stiffness; with FLCID a factor on its ordinates"),
    real("f0", dimension::force, 0, any_value, "preload"),
    real("d", viscosity, 0, at_least(0), "viscous damper"),
    real("cdf", dimension::length, 0, at_least(0), "compression at failure; 0: none"),
    real("tdf", dimension::length, 0, at_least(0), "elongation at failure; 0: none"),
}};
const Card rate_card{{
    curve_field("flcid", "force over displacement; elastoplastic: yield force over plastic displacement"),
    curve_field("hlcid", "force over velocity"),
    real("c1", {0, -1, 1}, 0, at_least(0), "factor 1 + C1 v on the force"),
    real("c2", dimension::number, 0, at_least(0), "factor 1 + C2 ln max(1, |v|/DLE) on the force"),
    real("dle", dimension::velocity, 1, above_zero(), "velocity that C2 refers to"),
    curve_field("glcid", "factor on HLCID over displacement; 0: 1"),
}};
const Card spring_beam_card{{
    material_id,
    density,
    unused(),
    unused(),
    unused(),
    unused(),
    unused(),
    integer("dospot", 0, only(0), "thinning of shells by SPOTHIN at these beams"),
}};
const Card degree_card{{
    integer("dof", required, between(1, 6), "degree of freedom: 1 2 3 along r s t, 4 5 6 about them"),
    integer("type", 0, between(0, 1), "0 elastic, 1 elastoplastic"),
    real("k", force_per_length, 0, at_least(0), "stiffness"),
    real("d", viscosity, 0, at_least(0), "viscous damper"),
    real("cdf", dimension::length, 0, at_least(0), "negative displacement at failure, as a positive value; 0: none"),
    real("tdf", dimension::length, 0, at_least(0), "positive displacement at failure; 0: none"),
}};

using Kind = kernel::DiscreteSpring::Kind;

double failure_value(double written) {
  return written >= 1e20 ? 0.0 : written;
}

/// The name of field `first + i` of a card whose six fields follow each other.
std::string_view name(const Card& card, std::size_t first, std::size_t i) {
  return card.fields[first + i].name;
}

std::array<double, 6> six_values(const Row& row, const Card& card) {
  std::array<double, 6> value{};
  for (std::size_t i = 0; i < 6; ++i) value[i] = failure_value(row.real(name(card, 0, i)));
  return value;
}

void add_law(Builder& b, const Row& row, std::string title, std::string_view keyword,
             std::function<void(Builder&, kernel::DiscreteBeam&)> fill) {
  const auto index = static_cast<Index>(b.model.materials.size());
  Material m{row.integer("mid"), std::move(title),       std::string(keyword),
             row.real("ro"),     kernel::DiscreteBeam{}, row.place()};
  b.materials.add(m.id, index, m.place, row.keyword(), "material", b.findings);
  b.model.materials.push_back(std::move(m));
  // Curves may be defined later in the deck.
  b.defer(Phase::parts, [index, fill = std::move(fill)](Builder& later) {
    auto& material = later.model.materials[static_cast<std::size_t>(index)];
    fill(later, std::get<kernel::DiscreteBeam>(material.law));
  });
}

kernel::ForceCurve force_curve(Builder& b, const Row& row, std::string_view field) {
  const Index c = b.curve(row, field);
  return c == none ? kernel::ForceCurve{} : kernel::ForceCurve(b.model.curves[static_cast<std::size_t>(c)]);
}

/// The six curves of a card.
std::array<kernel::ForceCurve, 6> six_curves(Builder& b, const Row& row, const Card& card, std::size_t first = 0) {
  std::array<kernel::ForceCurve, 6> curves;
  for (std::size_t i = 0; i < 6; ++i) curves[i] = force_curve(b, row, name(card, first, i));
  return curves;
}

/// Up to the yield force elastic with K; without a curve elastic for ever. K is raised to twice the steepest hardening
/// (LS-DYNA's rule for these laws); a fall steeper than K has no solution.
void make_elastoplastic(Builder& b, const Row& row, std::string_view field, const kernel::ForceCurve& yield,
                        kernel::DiscreteSpring& spring) {
  spring.kind = Kind::linear;
  if (yield.empty()) return;
  spring.kind = Kind::elastoplastic;
  spring.load = yield.tension_side();
  spring.unload = yield.compression_side();
  if (spring.load.empty() || spring.unload.empty())
    return refuse(b, row, field, "the yield curve has points on one side only, and not on that of tension",
                  "give points at positive abscissae as well");
  for (const kernel::ForceCurve* side : {&spring.load, &spring.unload}) {
    spring.stiffness = std::max(spring.stiffness, 2.0 * side->steepest_rise());
    if (side->lowest() < 0.0)
      refuse(b, row, field, "a yield force has the sign of its displacement", "leave no negative ones in tension");
    if (!(spring.stiffness > side->steepest_fall()))
      refuse(b, row, field, "the yield force falls faster than the elastic force, so it cannot be followed",
             "give a larger stiffness, or a curve that falls less steeply");
  }
}

void read_linear(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(linear_card), damping = cursor.read(linear_damping_card),
            preload = cursor.read(preload_card);
  expect_end(b, cursor);
  add_law(b, row, std::move(title), "MAT_LINEAR_ELASTIC_DISCRETE_BEAM",
          [row, damping, preload](Builder&, kernel::DiscreteBeam& law) {
            for (std::size_t i = 0; i < 6; ++i) {
              law.dof[i].kind = Kind::linear;
              law.dof[i].stiffness = row.real(name(linear_card, 2, i));
              law.dof[i].damping = damping.real(name(linear_damping_card, 0, i));
              law.dof[i].preload = preload.real(name(preload_card, 0, i));
            }
          });
}

void take_failure(const Row& force, const Row& displacement, kernel::DiscreteBeam& law) {
  law.rule = kernel::DiscreteBeam::Rule::together;
  law.force_limit = six_values(force, force_failure_card);
  law.tension_limit = law.compression_limit = six_values(displacement, displacement_failure_card);
}

void read_nonlinear(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(curves_card), damper = cursor.read(damper_curves_card),
            preload = cursor.read(preload_card), force = cursor.read(force_failure_card),
            displacement = cursor.read(displacement_failure_card);
  expect_end(b, cursor);
  add_law(b, row, std::move(title), "MAT_NONLINEAR_ELASTIC_DISCRETE_BEAM",
          [row, damper, preload, force, displacement](Builder& later, kernel::DiscreteBeam& law) {
            auto load = six_curves(later, row, curves_card, 2),
                 over_rate = six_curves(later, damper, damper_curves_card);
            for (std::size_t i = 0; i < 6; ++i) {
              law.dof[i].kind = Kind::elastic;
              law.dof[i].load = std::move(load[i]);
              law.dof[i].damper = std::move(over_rate[i]);
              law.dof[i].preload = preload.real(name(preload_card, 0, i));
            }
            take_failure(force, displacement, law);
          });
}

void read_plastic(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(linear_card), damping = cursor.read(linear_damping_card),
            yield = cursor.read(yield_curves_card), force = cursor.read(force_failure_card),
            displacement = cursor.read(displacement_failure_card), preload = cursor.read(preload_card);
  expect_end(b, cursor);
  add_law(b, row, std::move(title), "MAT_NONLINEAR_PLASTIC_DISCRETE_BEAM",
          [row, damping, yield, force, displacement, preload](Builder& later, kernel::DiscreteBeam& law) {
            auto curves = six_curves(later, yield, yield_curves_card);
            for (std::size_t i = 0; i < 6; ++i) {
              law.dof[i].stiffness = row.real(name(linear_card, 2, i));
              law.dof[i].damping = damping.real(name(linear_damping_card, 0, i));
              law.dof[i].preload = preload.real(name(preload_card, 0, i));
              make_elastoplastic(later, yield, name(yield_curves_card, 0, i), curves[i], law.dof[i]);
            }
            take_failure(force, displacement, law);
          });
}

/// How loading and unloading of MAT_119 and MAT_121 go together.
void set_unloading(Builder& b, const Row& row, int iunld, double k, std::string_view k_field, const Row& curves,
                   std::string_view unload_field, kernel::ForceCurve unload, kernel::DiscreteSpring& spring) {
  spring.kind = Kind::elastic;
  if (iunld == 0 || spring.load.empty()) return;
  if (iunld == 2) {
    spring.kind = Kind::hysteresis;
    spring.stiffness = k;
    if (!(k > 0.0)) refuse(b, row, k_field, "unloading by IUNLD 2 needs this stiffness", "give the slope of unloading");
    if (unload.empty())
      refuse(b, curves, unload_field, "unloading by IUNLD 2 needs an unloading curve", "give one, e.g. of zero force");
  } else if (!unload.empty()) {
    spring.kind = Kind::two_curves;
  }
  spring.unload = std::move(unload);
}

void read_general(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(general_card), load = cursor.read(general_load_card),
            unload = cursor.read(general_unload_card), damper = cursor.read(damper_curves_card),
            scale = cursor.read(general_scale_card), tension = cursor.read(general_tension_card),
            compression = cursor.read(general_compression_card), start = cursor.read(general_start_card);
  expect_end(b, cursor);
  add_law(b, row, std::move(title), "MAT_GENERAL_NONLINEAR_6DOF_DISCRETE_BEAM",
          [row, load, unload, damper, scale, tension, compression, start](Builder& later, kernel::DiscreteBeam& law) {
            auto loading = six_curves(later, load, general_load_card),
                 unloading = six_curves(later, unload, general_unload_card),
                 over_rate = six_curves(later, damper, damper_curves_card),
                 factor = six_curves(later, scale, general_scale_card);
            for (std::size_t i = 0; i < 6; ++i) {
              kernel::DiscreteSpring& spring = law.dof[i];
              const std::string_view k = i < 3 ? "kt" : "kr";
              spring.load = std::move(loading[i]);
              set_unloading(later, row, row.integer("iunld"), row.real(k), k, unload, name(general_unload_card, 0, i),
                            std::move(unloading[i]), spring);
              spring.damper = std::move(over_rate[i]);
              spring.damper_scale = std::move(factor[i]);
              spring.start = start.real(name(general_start_card, 0, i));
            }
            law.rule =
                tension.real("fcrit") == 1.0 ? kernel::DiscreteBeam::Rule::together : kernel::DiscreteBeam::Rule::sides;
            law.tension_limit = six_values(tension, general_tension_card);
            law.compression_limit = six_values(compression, general_compression_card);
          });
}

void read_single(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(single_card), curves = cursor.read(single_curves_card),
            failure = cursor.read(single_failure_card);
  expect_end(b, cursor);
  add_law(b, row, std::move(title), "MAT_GENERAL_NONLINEAR_1DOF_DISCRETE_BEAM",
          [row, curves, failure](Builder& later, kernel::DiscreteBeam& law) {
            law.between_points = true;
            kernel::DiscreteSpring& spring = law.dof[0];
            spring.load = force_curve(later, curves, "lcidt");
            set_unloading(later, row, row.integer("iunld"), row.real("k"), "k", curves, "lcidtu",
                          force_curve(later, curves, "lcidtu"), spring);
            spring.damper = force_curve(later, curves, "lcidtd");
            spring.damper_scale = force_curve(later, curves, "lcidte");
            spring.start = failure.real("iu");
            law.tension_limit[0] = failure_value(failure.real("utfail"));
            law.compression_limit[0] = failure_value(failure.real("ucfail"));
          });
}

void take_rates(Builder& b, const Row& rates, kernel::DiscreteSpring& spring) {
  spring.damper = force_curve(b, rates, "hlcid");
  spring.damper_scale = force_curve(b, rates, "glcid");
  spring.linear_rate = rates.real("c1");
  spring.log_rate = rates.real("c2");
  spring.rate = rates.real("dle");
}

void read_spring(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(spring_card), rates = cursor.read(rate_card);
  expect_end(b, cursor);
  add_law(b, row, std::move(title), "MAT_ELASTIC_SPRING_DISCRETE_BEAM",
          [row, rates](Builder& later, kernel::DiscreteBeam& law) {
            law.between_points = true;
            kernel::DiscreteSpring& spring = law.dof[0];
            spring.load = force_curve(later, rates, "flcid");
            spring.kind = spring.load.empty() ? Kind::linear : Kind::elastic;
            spring.stiffness = row.real("k");
            if (!spring.load.empty() && row.real("k") != 0.0 && row.real("k") != 1.0)
              refuse(later, row, "k",
                     "with FLCID, sources differ whether K multiplies its ordinates; only 0 and 1 leave no doubt",
                     "write 1 and scale the curve by SFO");
            spring.preload = row.real("f0");
            spring.damping = row.real("d");
            take_rates(later, rates, spring);
            law.tension_limit[0] = failure_value(row.real("tdf"));
            law.compression_limit[0] = failure_value(row.real("cdf"));
          });
}

void read_spring_beam(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(spring_beam_card);
  std::vector<std::pair<Row, Row>> degrees;
  while (!at_end(cursor)) {
    Row degree = cursor.read(degree_card);
    degrees.emplace_back(std::move(degree), cursor.read(rate_card));
  }
  add_law(b, row, std::move(title), "MAT_GENERAL_SPRING_DISCRETE_BEAM",
          [degrees](Builder& later, kernel::DiscreteBeam& law) {
            for (const auto& [degree, rates] : degrees) {
              const int dof = degree.integer("dof");
              if (dof < 1 || dof > 6) continue;  // told
              const auto i = static_cast<std::size_t>(dof - 1);
              kernel::DiscreteSpring& spring = law.dof[i];
              if (spring.kind != Kind::none) refuse(later, degree, "dof", "this degree of freedom is given twice");
              spring.stiffness = degree.real("k");
              spring.damping = degree.real("d");
              kernel::ForceCurve curve = force_curve(later, rates, "flcid");
              if (degree.integer("type") == 1) {
                make_elastoplastic(later, rates, "flcid", curve, spring);
              } else {
                spring.kind = curve.empty() ? Kind::linear : Kind::elastic;
                spring.load = std::move(curve);
              }
              take_rates(later, rates, spring);
              law.tension_limit[i] = failure_value(degree.real("tdf"));
              law.compression_limit[i] = failure_value(degree.real("cdf"));
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
       .layout = {{"", &curves_card},
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
       .read = read_plastic},
      {.name = "MAT_ELASTIC_SPRING_DISCRETE_BEAM",
       .aliases = {"MAT_074"},
       .options = {"TITLE"},
       .layout = {{"", &spring_card}, {"", &rate_card}},
       .read = read_spring},
      {.name = "MAT_GENERAL_NONLINEAR_6DOF_DISCRETE_BEAM",
       .aliases = {"MAT_119"},
       .options = {"TITLE"},
       .layout = {{"", &general_card},
                  {"", &general_load_card},
                  {"", &general_unload_card},
                  {"", &damper_curves_card},
                  {"", &general_scale_card},
                  {"", &general_tension_card},
                  {"", &general_compression_card},
                  {"", &general_start_card}},
       .read = read_general},
      {.name = "MAT_GENERAL_NONLINEAR_1DOF_DISCRETE_BEAM",
       .aliases = {"MAT_121"},
       .options = {"TITLE"},
       .layout = {{"", &single_card}, {"", &single_curves_card}, {"", &single_failure_card}},
       .read = read_single},
      {.name = "MAT_GENERAL_SPRING_DISCRETE_BEAM",
       .aliases = {"MAT_196"},
       .options = {"TITLE"},
       .layout = {{"", &spring_beam_card}, {"for each degree of freedom", &degree_card}, {"and", &rate_card}},
       .read = read_spring_beam},
  };
}

}  // namespace nugget::reading
