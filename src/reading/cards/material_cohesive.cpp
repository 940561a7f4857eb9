// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/law/cohesive_bond.hpp"
#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/contact_glue.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_COHESIVE_..., the laws of adhesive between two faces.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

constexpr Dimension stiffness{1, -2, -2}, energy_per_area{1, 0, -2};

constexpr IntegerField roflg = integer("roflg", 0, between(0, 1), "density per volume (0), or per area (1)");
constexpr RealField intfail =
    real("intfail", dimension::number, 0, between(0, 4),
         "failed points that delete the brick, 1 to 4; 0: none do, and the points are the corners");
constexpr RealField density_per_area =
    real("ro", dimension::mass_per_area, required, above_zero(), "density, per area with ROFLG = 1");

/// All cards of these laws but those of the modes of MAT_240.
struct CohesiveCards : MaterialCard {
  int roflg = 0;
  double intfail = 0;
  double en = 0, et = 0;  ///< also EMOD, GMOD
  double gic = 0, giic = 0, xmu = 0, t = 0, s = 0, und = 0, utd = 0, gamma = 0, cts = 0;
  double fn_fail = 0, ft_fail = 0, thick = 0;
  double nls = 0, tls = 0, lamda1 = 0, lamda2 = 0, lamdaf = 0, stfsf = 0;
  int tes = 0, tslc = 0;
};

CardOf<CohesiveCards> mixed_card_of(const RealField& ro) {
  return {
      {&MaterialCard::mid, material_id},
      {&MaterialCard::ro, ro},
      {&CohesiveCards::roflg, roflg},
      {&CohesiveCards::intfail, intfail},
      {&CohesiveCards::en,
       real("en", stiffness, required, above_zero(), "stiffness normal to the surface, traction over separation")},
      {&CohesiveCards::et, real("et", stiffness, required, above_zero(), "stiffness along the surface")},
      {&CohesiveCards::gic,
       real("gic", energy_per_area, required, above_zero(), "energy per area that parts the faces by tension")},
      {&CohesiveCards::giic, real("giic", energy_per_area, required, above_zero(), "the same by shear")},
  };
}
const CardOf<CohesiveCards> mixed_card = mixed_card_of(density);
const CardOf<CohesiveCards> mixed_card_by_area = mixed_card_of(density_per_area);

const CardOf<CohesiveCards> mixed_limits_card{
    {&CohesiveCards::xmu,
     real("xmu", dimension::number, required, any_value,
          "exponent of mixed modes: above 0, power law; below 0, its size in the law of Benzeggagh and Kenane")},
    {&CohesiveCards::t, real("t", dimension::stress, 0, at_least(0), "highest normal traction; 0: from UND")},
    {&CohesiveCards::s, real("s", dimension::stress, 0, at_least(0), "highest tangential traction; 0: from UTD")},
    {&CohesiveCards::und, real("und", dimension::length, 0, at_least(0), "normal separation at failure, where T is 0")},
    {&CohesiveCards::utd,
     real("utd", dimension::length, 0, at_least(0), "tangential separation at failure, where S is 0")},
    {&CohesiveCards::gamma, real("gamma", dimension::number, 1, above_zero(),
                                 "exponent of the mean stiffness in Benzeggagh and Kenane's law")},
    {&CohesiveCards::cts,
     real("cts", dimension::number, 0, any_value, "tangent stiffness of nonlinear implicit runs, no effect")},
};

CardOf<CohesiveCards> elastic_card_of(const RealField& ro) {
  return {
      {&MaterialCard::mid, material_id},
      {&MaterialCard::ro, ro},
      {&CohesiveCards::roflg, roflg},
      {&CohesiveCards::intfail, intfail},
      {&CohesiveCards::et,
       real("et", stiffness, required, above_zero(), "stiffness along the surface, traction over separation")},
      {&CohesiveCards::en, real("en", stiffness, required, above_zero(), "stiffness normal to the surface")},
      {&CohesiveCards::fn_fail,
       real("fn_fail", dimension::stress, 0, at_least(0), "normal traction at which a point fails; 0: none")},
      {&CohesiveCards::ft_fail,
       real("ft_fail", dimension::stress, 0, at_least(0), "tangential traction at which a point fails; 0: none")},
  };
}
const CardOf<CohesiveCards> cohesive_elastic_card = elastic_card_of(density);
const CardOf<CohesiveCards> elastic_card_by_area = elastic_card_of(density_per_area);

CardOf<CohesiveCards> layer_card_of(const RealField& ro) {
  return {
      {&MaterialCard::mid, material_id},
      {&MaterialCard::ro, ro},
      {&CohesiveCards::roflg, roflg},
      {&CohesiveCards::intfail, intfail},
      {&CohesiveCards::en, real("emod", dimension::stress, required, above_zero(), "Young's modulus of the layer")},
      {&CohesiveCards::et, real("gmod", dimension::stress, required, above_zero(), "shear modulus of the layer")},
      {&CohesiveCards::thick,
       real("thick", dimension::length, 0, any_value, "thickness of the layer; 0 or less: that of each brick")},
      real("inicrt", dimension::number, 0, only(0), "criterion of yield: 0, an ellipse of the tractions"),
  };
}
const CardOf<CohesiveCards> layer_card = layer_card_of(density);
const CardOf<CohesiveCards> layer_card_by_area = layer_card_of(density_per_area);
const CardOf<ElastoplasticModeCard> tension_card =
    elastoplastic_mode_card({"g1c_0", "g1c_inf", "edot_g1", "t0", "t1", "edot_t", "fg1", "lcg1c"});
const CardOf<ElastoplasticModeCard> shear_card =
    elastoplastic_mode_card({"g2c_0", "g2c_inf", "edot_g2", "s0", "s1", "edot_s", "fg2", "lcg2c"});
const Card layer_options_card{{
    real("rfiltf", dimension::number, 0, only(0), "filter of the strain rate"),
    real("compy", dimension::number, 0, only(0), "1: yields under pressure"),
    real("smolim", dimension::number, 0, any_value, "smoother limits of the modes, no effect: they are smooth"),
    real("xmu", dimension::number, 1, only(1), "exponent of the energies at failure"),
    unused(),
    integer("usrfail", 0, only(0), "failure by the user's subroutine"),
}};

CardOf<CohesiveCards> scaled_card_of(const RealField& ro) {
  return {
      {&MaterialCard::mid, material_id},
      {&MaterialCard::ro, ro},
      {&CohesiveCards::roflg, roflg},
      {&CohesiveCards::intfail, intfail},
      {&CohesiveCards::t, real("sigmax", dimension::stress, required, above_zero(), "highest traction")},
      {&CohesiveCards::nls,
       real("nls", dimension::length, required, above_zero(), "separation at failure normal to the surface")},
      {&CohesiveCards::tls,
       real("tls", dimension::length, required, above_zero(), "separation at failure along the surface")},
      real("tls2", dimension::length, 0, any_value, "of cracks through shells, no effect on bricks"),
  };
}
const CardOf<CohesiveCards> scaled_card = scaled_card_of(density);
const CardOf<CohesiveCards> scaled_card_by_area = scaled_card_of(density_per_area);
const CardOf<CohesiveCards> scaled_shape_card{
    {&CohesiveCards::lamda1, real("lamda1", dimension::number, required, above_zero(),
                                  "where the traction is highest, on the scale on which LAMDAF is failure")},
    {&CohesiveCards::lamda2,
     real("lamda2", dimension::number, required, above_zero(), "where it begins to fall, on that scale")},
    {&CohesiveCards::lamdaf, real("lamdaf", dimension::number, required, above_zero(), "failure, on that scale")},
    {&CohesiveCards::stfsf,
     real("stfsf", dimension::number, required, above_zero(), "stiffness under pressure over the first in tension")},
    integer("isw", -1, any_value, "of cracks through shells, no effect on bricks"),
    real("alpha1", dimension::number, 0, any_value, "of cracks through shells, no effect on bricks"),
    real("alpha2", dimension::number, 0, any_value, "of cracks through shells, no effect on bricks"),
};
const Card crack_card{{
    real("dr", dimension::number, 0, any_value, "of cracks through shells, no effect on bricks"),
    real("alpha3", dimension::number, 0, any_value, "of cracks through shells, no effect on bricks"),
}};

CardOf<CohesiveCards> general_card_of(const RealField& ro) {
  return {
      {&MaterialCard::mid, material_id},
      {&MaterialCard::ro, ro},
      {&CohesiveCards::roflg, roflg},
      {&CohesiveCards::intfail, intfail},
      {&CohesiveCards::tes,
       integer("tes", 0, between(0, 2), "mixed modes: 0 power law, 1 law of Benzeggagh and Kenane; 2 is not built")},
      {&CohesiveCards::tslc, id("tslc", IdSpace::function, required,
                                "curve: traction over its peak by the separation over that at failure, 0 to 1")},
      {&CohesiveCards::gic,
       real("gic", energy_per_area, required, above_zero(), "energy per area that parts the faces by tension")},
      {&CohesiveCards::giic, real("giic", energy_per_area, required, above_zero(), "the same by shear")},
  };
}
const CardOf<CohesiveCards> general_card = general_card_of(density);
const CardOf<CohesiveCards> general_card_by_area = general_card_of(density_per_area);
const CardOf<CohesiveCards> general_modes_card{
    {&CohesiveCards::xmu, real("xmu", dimension::number, required, above_zero(), "exponent of mixed modes")},
    {&CohesiveCards::t, real("t", dimension::stress, required, above_zero(), "highest normal traction")},
    {&CohesiveCards::s, real("s", dimension::stress, required, above_zero(), "highest tangential traction")},
    {&CohesiveCards::stfsf, real("stfsf", dimension::number, 0, at_least(0),
                                 "what pressure adds to the stiffness, over the first in tension")},
    integer("tslc2", 0, only(0), "curve of its own for shear"),
};

/// All cards of *MAT_ARUP_ADHESIVE.
struct ArupCards : MaterialCard {
  double e = 0, pr = 0, tenmax = 0, gcten = 0, shrmax = 0, gcshr = 0;
  double pwrt = 0, pwrs = 0, shrp = 0, sht_sl = 0, edot0 = 0, edot2 = 0;
  int thkdir = 0, extra = 0;
  double sdfac = 1, sgfac = 1, bthk = 0;
};
const CardOf<ArupCards> arup_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&ArupCards::e, real("e", dimension::stress, required, above_zero(), "Young's modulus")},
    {&ArupCards::pr, real("pr", dimension::number, 0, between(0, 0.499), "Poisson's ratio")},
    {&ArupCards::tenmax,
     real("tenmax", dimension::stress, 1e20, above_zero(), "normal stress at which it yields; 1e20: it does not")},
    {&ArupCards::gcten,
     real("gcten", energy_per_area, 1e20, above_zero(), "energy per area that parts the faces by tension")},
    {&ArupCards::shrmax,
     real("shrmax", dimension::stress, 1e20, above_zero(), "shear stress at which it yields; 1e20: it does not")},
    {&ArupCards::gcshr, real("gcshr", energy_per_area, 1e20, above_zero(), "the same energy by shear")},
};
const CardOf<ArupCards> arup_surface_card{
    {&ArupCards::pwrt, real("pwrt", dimension::number, 2, above_zero(), "exponent of the normal stress")},
    {&ArupCards::pwrs, real("pwrs", dimension::number, 2, above_zero(), "exponent of the shear stress")},
    {&ArupCards::shrp,
     real("shrp", dimension::number, 0, between(0, 0.99), "plateau in shear, of the separation at failure")},
    {&ArupCards::sht_sl,
     real("sht_sl", dimension::number, 0, at_least(0), "what tension takes off the shear strength, and pressure adds")},
    {&ArupCards::edot0, real("edot0", dimension::rate, 1, above_zero(), "strain rate from which on it gets stronger")},
    {&ArupCards::edot2, real("edot2", dimension::rate, 0, at_least(0),
                             "strain rate of the factors on card 5; 0: no such card, and no rates")},
    {&ArupCards::thkdir,
     integer("thkdir", 0, between(0, 1), "1: N1-N4 and N5-N8 are the faces; 0: the closest ones, which must be these")},
    {&ArupCards::extra, integer("extra", 0, between(0, 3), "2: card 6 follows; 1, 3 (interfaces) are not built")},
};
/// Of interfaces, which are refused on the card before.
const Card arup_interface_card{{
    real("tmaxe", dimension::stress, 0, any_value, "of interfaces, which are not built"),
    real("gcte", energy_per_area, 0, any_value, "of interfaces, which are not built"),
    real("smaxe", dimension::stress, 0, any_value, "of interfaces, which are not built"),
    real("gcse", energy_per_area, 0, any_value, "of interfaces, which are not built"),
    real("pwrte", dimension::number, 0, any_value, "of interfaces, which are not built"),
    real("pwrse", dimension::number, 0, any_value, "of interfaces, which are not built"),
}};
const CardOf<ArupCards> arup_rate_card{
    {&ArupCards::sdfac, real("sdfac", dimension::number, 1, at_least(1), "factor on TENMAX and SHRMAX at EDOT2")},
    {&ArupCards::sgfac, real("sgfac", dimension::number, 1, above_zero(), "factor on GCTEN and GCSHR at EDOT2")},
    real("sdefac", dimension::number, 1, any_value, "of interfaces, which are not built"),
    real("sgefac", dimension::number, 1, any_value, "of interfaces, which are not built"),
};
const CardOf<ArupCards> arup_thickness_card{
    {&ArupCards::bthk,
     real("bthk", dimension::length, 0, at_least(0), "thickness of the layer; 0: that of each brick")},
    real("outfail", dimension::number, 0, any_value, "messages about failure, no effect"),
    real("fsip", dimension::number, 0, only(0), "strain in the plane at which it fails"),
    real("fbr713", dimension::number, 0, any_value, "older releases, no effect"),
    real("ele2ns", dimension::number, 0, only(0), "softening by the neighbours' failure"),
};

bool by_area(const Cursor& cursor) {
  return cursor.peek_number(2) == 1.0;
}

/// What the first card of each law has.
kernel::CohesiveBond bond_of_row(Builder& b, const RowOf<CohesiveCards>& row) {
  kernel::CohesiveBond bond;
  bond.stiffness = {row->en, row->et};
  bond.density_by_area = row->roflg == 1;
  const double points = row->intfail;
  if (points != std::floor(points))
    refuse(b, row[&CohesiveCards::intfail], "expected a whole number of points", "write 1");
  bond.points_to_delete = static_cast<int>(points);
  return bond;
}

Index add_bond(Builder& b, const RowOf<CohesiveCards>& row, std::string title, std::string_view name,
               kernel::CohesiveBond bond) {
  kernel::LawComponents law{kernel::Elastic{}};
  law.bond = std::make_shared<const kernel::CohesiveBond>(std::move(bond));
  return add_material(b, row, std::move(title), name, kernel::composed_law(std::move(law)));
}

/// T or S, given or by the separation at failure: their triangle has the energy G.
double peak(Builder& b, const deck::Entry& traction, const deck::Entry& ultimate, double energy) {
  const double given = traction.value, u = ultimate.value;
  if (given == 0.0 && u == 0.0) {
    refuse(b, traction, "either the highest traction or the separation at failure must be given",
           "give the traction; the separation at failure follows from the energy");
    return 0.0;
  }
  if (given == 0.0) return 2.0 * energy / u;
  if (u > 0.0 && std::abs(u - 2.0 * energy / given) > 0.01 * u)
    ultimate.report(b.findings, Severity::warning,
                    fmt::format("is not looked at where the traction is given: with the energy it makes {:.4g}",
                                2.0 * energy / given),
                    "leave it 0");
  return given;
}

/// The peak must come before the failure: 2 G > T^2/EN (the check of the manual's remarks).
void check_energy(Builder& b, const deck::Entry& field, double energy, double strength, double stiffness_of_mode) {
  const double least = strength * strength / (2.0 * stiffness_of_mode);
  if (!(strength > 0.0 && energy > 0.0 && stiffness_of_mode > 0.0) || energy > least) return;
  refuse(b, field,
         fmt::format("{:.4g} is too small: up to its highest traction {:.4g} at the stiffness {:.4g} the bond takes "
                     "{:.4g} of energy per area already",
                     energy, strength, stiffness_of_mode, least),
         "raise the stiffness, lower the traction, or correct the energy");
}

void read_mixed_mode(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(by_area(cursor) ? mixed_card_by_area : mixed_card);
  const auto limits = cursor.read(mixed_limits_card);
  expect_end(b, cursor);
  kernel::CohesiveBond bond = bond_of_row(b, row);
  kernel::Cohesion& glue = bond.glue;
  glue.softening = kernel::Cohesion::Softening::by_energy;
  glue.normal_energy = row->gic;
  glue.shear_energy = row->giic;
  glue.exponent = limits->xmu;
  bond.stiffness_exponent = limits->gamma;
  glue.normal_strength = peak(b, limits[&CohesiveCards::t], limits[&CohesiveCards::und], glue.normal_energy);
  glue.shear_strength = peak(b, limits[&CohesiveCards::s], limits[&CohesiveCards::utd], glue.shear_energy);
  check_energy(b, row[&CohesiveCards::gic], glue.normal_energy, glue.normal_strength, bond.stiffness.tension);
  check_energy(b, row[&CohesiveCards::giic], glue.shear_energy, glue.shear_strength, bond.stiffness.shear);
  if (limits->cts >= 2.0)
    limits[&CohesiveCards::cts].report(b.findings, Severity::warning,
                                       "the law of Ortiz and Pandolfi is not built; the bilinear one "
                                       "is computed",
                                       "leave it 0");
  add_bond(b, row, std::move(title), "MAT_COHESIVE_MIXED_MODE", std::move(bond));
}

void read_elastic_bond(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(by_area(cursor) ? elastic_card_by_area : cohesive_elastic_card);
  expect_end(b, cursor);
  kernel::CohesiveBond bond = bond_of_row(b, row);
  bond.glue.normal_strength = row->fn_fail;
  bond.glue.shear_strength = row->ft_fail;
  add_bond(b, row, std::move(title), "MAT_COHESIVE_ELASTIC", std::move(bond));
}

/// A bond of one shape, with the stiffness that follows from it.
void shape_bond(kernel::CohesiveBond& bond, const kernel::ShapedCohesion& shaped) {
  bond.shaped = shaped;
  bond.stiffness = shaped.first_stiffness();
  bond.stiffest = shaped.stiffest();
}

/// A line up to the peak, a plateau, a line down to failure; of these what has a length.
Curve trapezoid(double peak, double fall) {
  Curve shape;
  shape.x = {0.0, peak};
  shape.y = {0.0, 1.0};
  if (fall > peak) shape.x.push_back(fall), shape.y.push_back(1.0);
  if (fall < 1.0) shape.x.push_back(1.0), shape.y.push_back(0.0);
  return shape;
}

void read_scaled_bond(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(by_area(cursor) ? scaled_card_by_area : scaled_card);
  const auto shape = cursor.read(scaled_shape_card);
  if (!at_end(cursor)) cursor.read(crack_card);
  expect_end(b, cursor);
  kernel::CohesiveBond bond = bond_of_row(b, row);
  if (shape->lamda2 < shape->lamda1)
    refuse(b, shape[&CohesiveCards::lamda2], "lies before LAMDA1, where the traction only gets to its peak",
           "give LAMDA1 <= LAMDA2 <= LAMDAF");
  else if (shape->lamdaf < shape->lamda2)
    refuse(b, shape[&CohesiveCards::lamdaf], "lies before LAMDA2, where the traction begins to fall",
           "give LAMDA1 <= LAMDA2 <= LAMDAF");
  else if (shape->lamda1 > 0.0)
    shape_bond(bond, {.mixing = kernel::ShapedCohesion::Mixing::potential,
                      .shape = trapezoid(shape->lamda1 / shape->lamdaf, shape->lamda2 / shape->lamdaf),
                      .normal_strength = row->t,
                      .normal_end = row->nls,
                      .shear_end = row->tls,
                      .pressure_factor = shape->stfsf});
  add_bond(b, row, std::move(title), "MAT_COHESIVE_TH", std::move(bond));
}

/// TSLC, from (0, 0) by a peak of 1 to (1, 0), at no point steeper from the origin than before; nothing but findings
/// where it is another one.
std::optional<Curve> shape_of(Builder& b, const deck::Entry& field) {
  const Index c = b.curve(field);
  if (c == none || b.model.curves[c].empty()) return std::nullopt;  // reported
  Curve shape = b.model.curves[c];
  const auto near = [](double value, double expected) { return std::abs(value - expected) <= 1e-6; };
  const double peak = *std::max_element(shape.y.begin(), shape.y.end());
  const auto wrong = [&](const std::string& what, const char* remedy) {
    refuse(b, field, what, remedy);
    return std::nullopt;
  };
  if (shape.x.size() < 3 || !near(shape.x.front(), 0.0) || !near(shape.y.front(), 0.0) || !near(shape.x.back(), 1.0) ||
      !near(shape.y.back(), 0.0))
    return wrong(fmt::format("the curve leads from ({:g}, {:g}) to ({:g}, {:g}); expected three points or more, from "
                             "(0, 0) to (1, 0)",
                             shape.x.front(), shape.y.front(), shape.x.back(), shape.y.back()),
                 "divide its abscissae by the separation at failure");
  if (!near(peak, 1.0))
    return wrong(fmt::format("the curve's highest ordinate is {:g}, expected 1", peak),
                 "divide its ordinates by the highest; T and S say how high it is");
  for (std::size_t i = 1; i < shape.x.size(); ++i) {
    if (shape.y[i] < 0.0) return wrong("the curve has negative ordinates", "end it with 0");
    if (i > 1 && shape.y[i] * shape.x[i - 1] > shape.y[i - 1] * shape.x[i] * (1.0 + 1e-9))
      return wrong(fmt::format("the curve gets steeper from the origin at its point {}, ({:g}, {:g}): a bond that is "
                               "damaged does not become stiffer again",
                               i + 1, shape.x[i], shape.y[i]),
                   "begin with the steepest line, and end it with 0");
  }
  shape.x.front() = shape.y.front() = shape.y.back() = 0.0;
  shape.x.back() = 1.0;
  return shape;
}

void set_general_bond(Builder& b, Index material, kernel::CohesiveBond bond, const RowOf<CohesiveCards>& row,
                      const RowOf<CohesiveCards>& modes) {
  const auto shape = shape_of(b, row[&CohesiveCards::tslc]);
  if (!shape || b.findings.errors() > 0) return;
  using Mixing = kernel::ShapedCohesion::Mixing;
  kernel::ShapedCohesion shaped{.mixing = row->tes == 1 ? Mixing::benzeggagh : Mixing::power,
                                .shape = *shape,
                                .normal_strength = modes->t,
                                .shear_strength = modes->s,
                                .normal_energy = row->gic,
                                .shear_energy = row->giic,
                                .exponent = modes->xmu,
                                .pressure_factor = 1.0 + modes->stfsf};
  shaped.normal_end = row->gic / (shaped.area() * modes->t);
  shaped.shear_end = row->giic / (shaped.area() * modes->s);
  shape_bond(bond, shaped);
  kernel::LawComponents law{kernel::Elastic{}};
  law.bond = std::make_shared<const kernel::CohesiveBond>(std::move(bond));
  b.model.materials[material].law = kernel::composed_law(std::move(law));
}

void read_general_bond(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(by_area(cursor) ? general_card_by_area : general_card);
  const auto modes = cursor.read(general_modes_card);
  expect_end(b, cursor);
  if (row->tes == 2)
    refuse(b, row[&CohesiveCards::tes],
           "a separation without dimension (2) is not built: whether its shear takes GIC or GIIC is not documented",
           "write 0 with XMU 1, or *MAT_COHESIVE_TH, whose curve is a trapezoid");
  const kernel::CohesiveBond bond = bond_of_row(b, row);
  const Index material = add_bond(b, row, std::move(title), "MAT_COHESIVE_GENERAL", bond);
  b.defer(Phase::parts, [=](Builder& later) { set_general_bond(later, material, bond, row, modes); });
}

void read_layer(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(by_area(cursor) ? layer_card_by_area : layer_card);
  const auto tension = cursor.read(tension_card), shear = cursor.read(shear_card);
  if (!at_end(cursor)) cursor.read(layer_options_card);
  expect_end(b, cursor);
  kernel::CohesiveBond bond = bond_of_row(b, row);
  kernel::Cohesion& glue = bond.glue;
  glue.softening = kernel::Cohesion::Softening::elastoplastic;
  glue.thickness = std::max(0.0, row->thick);
  glue.tension = elastoplastic_mode(b, tension);
  glue.shear = elastoplastic_mode(b, shear);
  if (glue.thickness > 0.0) {
    const kernel::CohesiveStiffness k = bond.stiffness_in(0.0);
    const auto beyond_plateau = [](const kernel::ElastoplasticMode& m) {
      return m.energy * (1.0 - std::max(0.0, m.plateau));
    };
    check_energy(b, tension[&ElastoplasticModeCard::energy], beyond_plateau(glue.tension), glue.tension.yield,
                 k.tension);
    check_energy(b, shear[&ElastoplasticModeCard::energy], beyond_plateau(glue.shear), glue.shear.yield, k.shear);
  }
  add_bond(b, row, std::move(title), "MAT_COHESIVE_MIXED_MODE_ELASTOPLASTIC_RATE", std::move(bond));
}

/// One mode of *MAT_ARUP_ADHESIVE. Its plateau, SHRP of the separation at failure, is 2 SHRP/(1 + SHRP) of the energy:
/// (1 + SHRP)/2 of strength times separation are the energy.
kernel::ElastoplasticMode arup_mode(double strength, double energy, double plateau, const RowOf<ArupCards>& surface,
                                    const ArupCards& rates) {
  kernel::ElastoplasticMode mode;
  mode.yield = strength;
  mode.energy = energy;
  mode.plateau = 2.0 * plateau / (1.0 + plateau);
  if (surface->edot2 == 0.0) return mode;
  const double decades = std::log(surface->edot2 / surface->edot0);
  mode.yield_rate = surface->edot0;
  mode.top_rate = surface->edot2;
  mode.yield_growth = -strength * (rates.sdfac - 1.0) / decades;
  mode.energy_growth = energy * (rates.sgfac - 1.0) / decades;
  return mode;
}

void check_surface(Builder& b, const RowOf<ArupCards>& row, const RowOf<ArupCards>& surface) {
  if (surface->sht_sl > 0.0 && surface->sht_sl * row->tenmax >= row->shrmax)
    refuse(b, surface[&ArupCards::sht_sl],
           fmt::format("leaves no shear strength at the tension TENMAX: {:g} times {:g} are not below SHRMAX = {:g}",
                       surface->sht_sl, row->tenmax, row->shrmax),
           "give a slope below SHRMAX/TENMAX");
  if (surface->edot2 != 0.0 && surface->edot2 <= surface->edot0)
    refuse(b, surface[&ArupCards::edot2], fmt::format("is not above EDOT0 = {:g}", surface->edot0),
           "give the rate of the factors on card 5");
  if (surface->extra == 1 || surface->extra == 3)
    refuse(b, surface[&ArupCards::extra], "failure of the interfaces (cards 3 and 4) is not built",
           "give the lower of both strengths and energies on card 1, and EXTRA 0 or 2");
}

void read_arup(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(arup_card);
  const auto surface = cursor.read(arup_surface_card);
  check_surface(b, row, surface);
  for (int i = 0; i < (surface->extra % 2 == 1 ? 2 : 0); ++i) cursor.read(arup_interface_card);
  ArupCards more;
  if (surface->edot2 != 0.0) cursor.read(arup_rate_card, more);
  if (surface->extra >= 2) cursor.read(arup_thickness_card, more);
  expect_end(b, cursor);
  kernel::CohesiveBond bond;
  bond.points_to_delete = 4;
  bond.in_plain_bricks = true;
  bond.between_closest_faces = surface->thkdir == 0;
  bond.stiffness = {row->e * (1.0 - row->pr) / ((1.0 + row->pr) * (1.0 - 2.0 * row->pr)),
                    row->e / (2.0 * (1.0 + row->pr))};
  kernel::Cohesion& glue = bond.glue;
  glue.softening = kernel::Cohesion::Softening::elastoplastic;
  glue.thickness = more.bthk;
  glue.tension = arup_mode(row->tenmax, row->gcten, 0.0, surface, more);
  glue.shear = arup_mode(row->shrmax, row->gcshr, surface->shrp, surface, more);
  glue.normal_exponent = surface->pwrt;
  glue.shear_exponent = surface->pwrs;
  glue.shear_slope = surface->sht_sl;
  if (glue.thickness > 0.0) {
    const kernel::CohesiveStiffness k = bond.stiffness_in(0.0);
    constexpr double none_from = 1e19;
    if (row->tenmax < none_from) check_energy(b, row[&ArupCards::gcten], row->gcten, row->tenmax, k.tension);
    if (row->shrmax < none_from)
      check_energy(b, row[&ArupCards::gcshr], row->gcshr * (1.0 - glue.shear.plateau), row->shrmax, k.shear);
  }
  kernel::LawComponents law{kernel::Elastic{}};
  law.bond = std::make_shared<const kernel::CohesiveBond>(std::move(bond));
  add_material(b, row, std::move(title), "MAT_ARUP_ADHESIVE", kernel::composed_law(std::move(law)));
}

}  // namespace

std::vector<Keyword> cohesive_material_keywords() {
  return {{.name = "MAT_COHESIVE_MIXED_MODE",
           .aliases = {"MAT_138"},
           .options = {"TITLE"},
           .layout = {{"", &mixed_card}, {"", &mixed_limits_card}},
           .read = read_mixed_mode},
          {.name = "MAT_COHESIVE_ELASTIC",
           .aliases = {"MAT_184"},
           .options = {"TITLE"},
           .layout = {{"", &cohesive_elastic_card}},
           .read = read_elastic_bond},
          {.name = "MAT_COHESIVE_TH",
           .aliases = {"MAT_185"},
           .options = {"TITLE"},
           .layout = {{"", &scaled_card}, {"", &scaled_shape_card}, {"", &crack_card}},
           .read = read_scaled_bond},
          {.name = "MAT_COHESIVE_GENERAL",
           .aliases = {"MAT_186"},
           .options = {"TITLE"},
           .layout = {{"", &general_card}, {"", &general_modes_card}},
           .read = read_general_bond},
          {.name = "MAT_ARUP_ADHESIVE",
           .aliases = {"MAT_169"},
           .options = {"TITLE"},
           .layout = {{"", &arup_card},
                      {"", &arup_surface_card},
                      {"if EDOT2 is not 0", &arup_rate_card},
                      {"with EXTRA 2", &arup_thickness_card}},
           .read = read_arup},
          {.name = "MAT_COHESIVE_MIXED_MODE_ELASTOPLASTIC_RATE",
           .aliases = {"MAT_240"},
           .options = {"TITLE"},
           .layout = {{"", &layer_card}, {"", &tension_card}, {"", &shear_card}, {"", &layer_options_card}},
           .read = read_layer}};
}

}  // namespace nugget::reading
