// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/orthotropic_fields.hpp"

// *MAT_LAMINATED_COMPOSITE_FABRIC.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;
using kernel::LaminatedFabric;
using kernel::Orthotropic;

/// All cards of *MAT_LAMINATED_COMPOSITE_FABRIC.
struct LaminateCards : MaterialCard, LaminatedFabric, AxesCards {
  double beta = 0, tsize = 0, fs = 0;
  double slimt1 = 1e-8, slimc1 = 1e-8, slimt2 = 1e-8, slimc2 = 1e-8, slims = 1e-8;
  double e11c = 0, e11t = 0, e22c = 0, e22t = 0, gms = 0;
  double xc = 0, xt = 0, yc = 0, yt = 0, sc = 0;
};

constexpr RealField laminate_limit(std::string_view name, std::string_view meaning) {
  return real(name, dimension::number, 1e-8, between(0, 1), meaning);
}
constexpr RealField laminate_strain(std::string_view name, std::string_view meaning) {
  return real(name, dimension::number, required, above_zero(), meaning);
}
constexpr RealField laminate_strength(std::string_view name, std::string_view meaning) {
  return real(name, dimension::stress, required, above_zero(), meaning);
}
constexpr IntegerField laminate_rate_curve(std::string_view name, std::string_view meaning) {
  return integer(name, 0, only(0), meaning);
}

const CardOf<LaminateCards> laminate_moduli_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&Orthotropic::young_a, real("ea", dimension::stress, required, above_zero(), "Young's modulus along a")},
    {&Orthotropic::young_b, real("eb", dimension::stress, required, above_zero(), "Young's modulus along b")},
    {&Orthotropic::young_c, real("ec", dimension::stress, 0, at_least(0), "Young's modulus along c; 0: EB")},
    {&Orthotropic::poisson_ba, orthotropy::ratio_ba},
    {&LaminatedFabric::first_shear_stress,
     real("tau1", dimension::stress, 0, at_least(0), "stress at the end of the first part of shear, with FS -1")},
    {&LaminatedFabric::first_shear_strain,
     real("gamma1", dimension::number, 0, at_least(0), "engineering shear strain there")},
};

const CardOf<LaminateCards> laminate_shears_card{
    {&Orthotropic::shear_ab, orthotropy::shear_ab},
    {&Orthotropic::shear_bc, orthotropy::shear_bc},
    {&Orthotropic::shear_ca, orthotropy::shear_ca},
    {&LaminateCards::slimt1, laminate_limit("slimt1", "least share of XT that is left beyond it")},
    {&LaminateCards::slimc1, laminate_limit("slimc1", "the same of XC")},
    {&LaminateCards::slimt2, laminate_limit("slimt2", "the same of YT")},
    {&LaminateCards::slimc2, laminate_limit("slimc2", "the same of YC")},
    {&LaminateCards::slims, laminate_limit("slims", "the same of SC")},
};

const CardOf<LaminateCards> laminate_failure_card{
    {&AxesCards::aopt, aopt::option},
    {&LaminateCards::tsize,
     real("tsize", dimension::time, 0, at_least(0), "smallest time step of an element before it is deleted; 0: none")},
    {&LaminatedFabric::failure_strain,
     real("erods", dimension::number, 0, any_value,
          "effective strain at which a layer fails, with a thickness that keeps the volume; below 0: with its own; 0: "
          "none")},
    {&LaminatedFabric::soft,
     real("soft", dimension::number, 1, above_zero(), "factor on the strengths beside deleted elements, with TSIZE")},
    {&LaminateCards::fs, real("fs", dimension::number, 0, between(-1, 1),
                              "damage: -1 each stress alone, 0 fibres along a, 1 laminates and fabrics")},
    real("epsf", dimension::number, 0, only(0), "transverse shear strain at which damage begins"),
    real("epsr", dimension::number, 0, any_value, "the same where it ends, no effect without EPSF"),
    real("tsmd", dimension::number, 0.9, any_value, "most of this damage, no effect without EPSF"),
};

const CardOf<LaminateCards> laminate_vector_card{
    aopt::xp,
    aopt::yp,
    aopt::zp,
    {&AxesCards::a1, aopt::a1},
    {&AxesCards::a2, aopt::a2},
    {&AxesCards::a3, aopt::a3},
    {&Orthotropic::poisson_ca, real("prca", dimension::number, 0, any_value,
                                    "strain along a over that along c, negative, under stress along c; "
                                    "0: PRBA")},
    {&Orthotropic::poisson_cb, real("prcb", dimension::number, 0, any_value, "the same along b; 0: PRBA")},
};

const CardOf<LaminateCards> laminate_angle_card = axes_vectors_card<LaminateCards>({
    {&LaminateCards::beta, real("beta", dimension::number, 0, any_value, "angle of AOPT 0 and 3 [degrees]")},
    integer("lcdfail", 0, only(0), "criteria of failure of solids, over the rate"),
});

const CardOf<LaminateCards> laminate_strains_card{
    {&LaminateCards::e11c, laminate_strain("e11c", "strain at XC, positive")},
    {&LaminateCards::e11t, laminate_strain("e11t", "strain at XT")},
    {&LaminateCards::e22c, laminate_strain("e22c", "strain at YC, positive")},
    {&LaminateCards::e22t, laminate_strain("e22t", "strain at YT")},
    {&LaminateCards::gms, laminate_strain("gms", "engineering shear strain at SC")},
};

const CardOf<LaminateCards> laminate_strengths_card{
    {&LaminateCards::xc, laminate_strength("xc", "compressive strength along a, positive")},
    {&LaminateCards::xt, laminate_strength("xt", "tensile strength along a")},
    {&LaminateCards::yc, laminate_strength("yc", "compressive strength along b, positive")},
    {&LaminateCards::yt, laminate_strength("yt", "tensile strength along b")},
    {&LaminateCards::sc, laminate_strength("sc", "shear strength ab")},
};

const CardOf<LaminateCards> laminate_rates_card{
    laminate_rate_curve("lcxc", "XC over the strain rate"),
    laminate_rate_curve("lcxt", "XT over it"),
    laminate_rate_curve("lcyc", "YC over it"),
    laminate_rate_curve("lcyt", "YT over it"),
    laminate_rate_curve("lcsc", "SC over it"),
    laminate_rate_curve("lctau", "TAU1 over it"),
    laminate_rate_curve("lcgam", "GAMMA1 over it"),
    real("dt", dimension::time, 0, any_value, "averaging of the strain rate, no effect without these curves"),
};

const CardOf<LaminateCards> laminate_strain_rates_card{
    laminate_rate_curve("lce11c", "E11C over the strain rate"),
    laminate_rate_curve("lce11t", "E11T over it"),
    laminate_rate_curve("lce22c", "E22C over it"),
    laminate_rate_curve("lce22t", "E22T over it"),
    laminate_rate_curve("lcgms", "GMS over it"),
    laminate_rate_curve("lcefs", "ERODS over it"),
};

/// The curve of shear of FS -1: up to TAU1 at GAMMA1, then straight to SC at GMS; each part must soften.
void check_laminate_shear(Builder& b, const RowOf<LaminateCards>& moduli, const LaminateCards& cards) {
  const double tau = cards.first_shear_stress, gamma = cards.first_shear_strain;
  const deck::Entry stress = moduli[&LaminatedFabric::first_shear_stress],
                    strain = moduli[&LaminatedFabric::first_shear_strain];
  if (tau == 0.0 && gamma == 0.0) return;
  if (cards.fs != -1.0) {
    stress.report(b.findings, Severity::warning, "TAU1 and GAMMA1 have no effect but with FS -1",
                  "write FS -1, or leave them 0");
  } else if (tau == 0.0 || gamma == 0.0) {
    refuse(b, tau == 0.0 ? stress : strain, "the curve of shear needs both TAU1 and GAMMA1", "give both, or neither");
  } else if (!(gamma < cards.gms)) {
    refuse(b, strain, "GAMMA1 must lie below GMS", "give the strain at the end of the first part");
  } else if (tau > cards.shear_ab * gamma * (1.0 + 1e-9)) {
    refuse(b, stress, fmt::format("TAU1 lies above the elastic stress GAB GAMMA1 = {:g}", cards.shear_ab * gamma),
           "give a higher GAB, or a lower TAU1");
  } else if ((cards.sc - tau) * gamma > tau * (cards.gms - gamma) * (1.0 + 1e-9)) {
    refuse(b, stress, "the second part of shear, from TAU1 to SC, is stiffer than TAU1/GAMMA1",
           "the curve must bend downwards");
  }
}

/// A warning where a strain at strength lies below the elastic one.
void check_laminate_strains(Builder& b, const RowOf<LaminateCards>& strains, const LaminateCards& cards) {
  const auto check = [&](double LaminateCards::*strain, double modulus, double strength, std::string_view of) {
    if (cards.*strain * modulus < strength * (1.0 - 1e-6))
      strains[strain].report(
          b.findings, Severity::warning,
          fmt::format("lies below the elastic strain at {}, {:g}: that counts, and the stress falls at once", of,
                      strength / modulus),
          "give the strain at the strength, at least strength over modulus");
  };
  check(&LaminateCards::e11c, cards.young_a, cards.xc, "XC");
  check(&LaminateCards::e11t, cards.young_a, cards.xt, "XT");
  check(&LaminateCards::e22c, cards.young_b, cards.yc, "YC");
  check(&LaminateCards::e22t, cards.young_b, cards.yt, "YT");
  check(&LaminateCards::gms, cards.shear_ab, cards.sc, "SC");
}

void read_laminated_fabric(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  LaminateCards cards;
  const auto moduli = cursor.read(laminate_moduli_card, cards);
  cursor.read(laminate_shears_card, cards);
  const auto failure = cursor.read(laminate_failure_card, cards);
  const auto first = cursor.read(laminate_vector_card, cards);
  const auto second = cursor.read(laminate_angle_card, cards);
  const auto strains = cursor.read(laminate_strains_card, cards);
  cursor.read(laminate_strengths_card, cards);
  if (cursor.more()) cursor.read(laminate_rates_card, cards);
  if (cursor.more()) cursor.read(laminate_strain_rates_card, cards);
  expect_end(b, cursor);

  if (cards.fs != -1.0 && cards.fs != 0.0 && cards.fs != 1.0)
    refuse(b, failure[&LaminateCards::fs], "the failure surface is -1, 0 or 1", "write one of them");
  if (cards.tsize == 0.0 && cards.soft != 1.0)
    failure[&LaminatedFabric::soft].report(b.findings, Severity::warning, "has no effect without TSIZE",
                                           "give TSIZE, a small time step, or write SOFT 1");
  check_laminate_shear(b, moduli, cards);
  check_laminate_strains(b, strains, cards);

  LaminatedFabric law = cards;
  using Surface = LaminatedFabric::Surface;
  law.surface = cards.fs < 0.0 ? Surface::faceted : cards.fs > 0.0 ? Surface::quadratic : Surface::fibre_alone;
  law.tension_a = {cards.xt, cards.e11t, cards.slimt1};
  law.compression_a = {cards.xc, cards.e11c, cards.slimc1};
  law.tension_b = {cards.yt, cards.e22t, cards.slimt2};
  law.compression_b = {cards.yc, cards.e22c, cards.slimc2};
  law.shear = {cards.sc, cards.gms, cards.slims};
  if (cards.tsize == 0.0) law.soft = 1.0;
  if (law.poisson_ca == 0.0) law.poisson_ca = law.poisson_ba;
  if (law.poisson_cb == 0.0) law.poisson_cb = law.poisson_ba;
  const deck::Entry option = failure[&AxesCards::aopt];
  complete_orthotropic(b, block, law, cards, cards.beta,
                       {moduli[&Orthotropic::poisson_ba], option, first[&AxesCards::a1], second[&AxesCards::v1]});
  kernel::LawComponents components{law};
  components.for_layers_only = true;
  components.deletion_step = cards.tsize;
  const Index material = add_material(b, moduli, std::move(title), "MAT_LAMINATED_COMPOSITE_FABRIC",
                                      kernel::composed_law(std::move(components)));
  take_axes_of_system(b, option, material);
}

}  // namespace

std::vector<Keyword> laminated_fabric_keywords() {
  return {{.name = "MAT_LAMINATED_COMPOSITE_FABRIC",
           .aliases = {"MAT_058"},
           .options = {"TITLE"},
           .layout = {{"", &laminate_moduli_card},
                      {"", &laminate_shears_card},
                      {"", &laminate_failure_card},
                      {"", &laminate_vector_card},
                      {"", &laminate_angle_card},
                      {"", &laminate_strains_card},
                      {"", &laminate_strengths_card},
                      {"optional", &laminate_rates_card},
                      {"optional", &laminate_strain_rates_card}},
           .read = read_laminated_fabric}};
}

}  // namespace nugget::reading
