// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "kernel/law/composition.hpp"
#include "model/cards/families.hpp"
#include "model/cards/material.hpp"
#include "model/cards/reading.hpp"

// *MAT_... of rubber, foam and other soft solids.
namespace nugget::model {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

constexpr Field compressible =
    real("pr", dimension::number, required, between(0, 0.49999), "Poisson's ratio, below 0.5");
constexpr Field reference = real("ref", dimension::number, 0, only(0), "stress from a reference geometry");

Index add_solid_law(Builder& b, const Row& row, std::string title, std::string_view name, kernel::Composition law) {
  law.for_shells = false;
  return add_material(b, row, std::move(title), name, compound(std::move(law)));
}

// ---- 006

const Card viscoelastic_card{{
    material_id,
    density,
    real("bulk", dimension::stress, required, above_zero(), "bulk modulus"),
    real("g0", dimension::stress, required, above_zero(), "shear modulus at once"),
    real("gi", dimension::stress, 0, at_least(0), "shear modulus in the end"),
    real("beta", dimension::rate, 0, at_least(0), "decay: GI + (G0 - GI) exp(-BETA t)"),
}};

void read_viscoelastic(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(viscoelastic_card);
  expect_end(b, cursor);
  const double K = row.real("bulk"), G = row.real("g0");
  const kernel::Viscoelastic flow{
      9.0 * K * G / (3.0 * K + G), (3.0 * K - 2.0 * G) / (6.0 * K + 2.0 * G), K, G, row.real("gi"), row.real("beta")};
  if (flow.nu < 0.0) refuse(b, row, "bulk", "G0 and BULK make a negative Poisson's ratio", "3 BULK must be above 2 G0");
  add_solid_law(b, row, std::move(title), "MAT_VISCOELASTIC", {flow});
}

// ---- 027, 077_O

const Card mooney_rivlin_card{{
    material_id,
    density,
    compressible,
    real("a", dimension::stress, required, above_zero(), "constant A of the energy"),
    real("b", dimension::stress, 0, at_least(0), "constant B of the energy"),
    reference,
}};

const Card mooney_rivlin_fit_card{{
    real("sgl", dimension::length, 0, any_value, "specimen, for LCID only"),
    real("sw", dimension::length, 0, any_value, "specimen, for LCID only"),
    real("st", dimension::length, 0, any_value, "specimen, for LCID only"),
    integer("lcid", 0, only(0), "curve to which A and B would be fitted"),
}};

void read_mooney_rivlin(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(mooney_rivlin_card);
  cursor.read(mooney_rivlin_fit_card);
  expect_end(b, cursor);
  const double a = row.real("a"), bb = row.real("b"), nu = row.real("pr");
  add_solid_law(b, row, std::move(title), "MAT_MOONEY-RIVLIN_RUBBER",
                {kernel::MooneyRivlin{4.0 * (a + bb) * (1.0 + nu), nu, a, bb}});
}

const Card ogden_card{{
    material_id,
    density,
    compressible,
    integer("n", 0, only(0), "number of terms that would be fitted to a curve"),
    integer("nv", 0, any_value, "viscoelastic terms, for a fit only"),
    real("g", dimension::stress, 0, only(0), "shear modulus of frictional damping"),
    real("sigf", dimension::stress, 0, only(0), "limit of frictional damping"),
    reference,
}};

const Card ogden_moduli_card{{
    real("mu1", dimension::stress, required, any_value, "modulus of term 1"),
    real("mu2", dimension::stress, 0, any_value, "term 2"),
    real("mu3", dimension::stress, 0, any_value, "term 3"),
    real("mu4", dimension::stress, 0, any_value, "term 4"),
    real("mu5", dimension::stress, 0, any_value, "term 5"),
    real("mu6", dimension::stress, 0, any_value, "term 6"),
    real("mu7", dimension::stress, 0, any_value, "term 7"),
    real("mu8", dimension::stress, 0, any_value, "term 8"),
}};

const Card ogden_exponents_card{{
    real("alpha1", dimension::number, required, any_value, "exponent of term 1"),
    real("alpha2", dimension::number, 0, any_value, "term 2"),
    real("alpha3", dimension::number, 0, any_value, "term 3"),
    real("alpha4", dimension::number, 0, any_value, "term 4"),
    real("alpha5", dimension::number, 0, any_value, "term 5"),
    real("alpha6", dimension::number, 0, any_value, "term 6"),
    real("alpha7", dimension::number, 0, any_value, "term 7"),
    real("alpha8", dimension::number, 0, any_value, "term 8"),
}};

void read_ogden(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(ogden_card);
  const Row moduli = cursor.read(ogden_moduli_card);
  const Row exponents = cursor.read(ogden_exponents_card);
  expect_end(b, cursor);
  kernel::Ogden flow;
  double shear = 0.0;
  for (int i = 1; i <= 8; ++i) {
    const double mu = moduli.real(fmt::format("mu{}", i)), alpha = exponents.real(fmt::format("alpha{}", i));
    if (mu != 0.0 && alpha != 0.0) flow.terms.push_back({mu, alpha});
    shear += 0.5 * mu * alpha;
  }
  if (!(shear > 0.0)) refuse(b, moduli, "mu1", "the shear modulus, half the sum of MU ALPHA, must be above 0");
  flow.nu = row.real("pr");
  flow.E = 2.0 * shear * (1.0 + flow.nu);
  add_solid_law(b, row, std::move(title), "MAT_OGDEN_RUBBER", {flow});
}

// ---- 057, 063

const Card low_density_foam_card{{
    material_id,
    density,
    real("e", dimension::stress, required, above_zero(), "Young's modulus in tension"),
    id("lcid", IdSpace::function, required, "curve: nominal stress over nominal strain, positive in compression"),
    real("tc", dimension::stress, 1e20, at_least(0), "greatest nominal tensile stress"),
    real("hu", dimension::number, 1, between(0, 1), "share of the stress that unloading keeps; 1: no hysteresis"),
    real("beta", dimension::rate, 0, only(0), "creep in unloading"),
    real("damp", dimension::number, 0, only(0), "viscous coefficient; BVFLAG 1 with Q1, Q2 damps"),
}};

const Card low_density_foam_unloading_card{{
    real("shape", dimension::number, 1, above_zero(), "exponent of the energy in unloading"),
    real("fail", dimension::number, 0, between(0, 1), "at the cutoff 0: the stress stays there, 1: it falls to 0"),
    real("bvflag", dimension::number, 0, between(0, 1), "bulk viscosity: 0 none, 1 as in other solids"),
    real("ed", dimension::stress, 0, only(0), "modulus of relaxation"),
    real("beta1", dimension::rate, 0, any_value, "its decay, for ED only"),
    real("kcon", dimension::stress, 0, only(0), "stiffness for contacts; here that of E"),
    reference,
}};

void set_low_density_foam(Builder& b, Index material, const Row& row, const Row& unloading) {
  const Index curve = b.curve(row, "lcid");
  if (curve == none) return;
  kernel::LowDensityFoam flow;
  flow.E = row.real("e");
  flow.compression = b.model.curves[static_cast<std::size_t>(curve)];
  if (flow.compression.x.front() < 0.0 || flow.compression.y.front() < 0.0 || flow.compression.x.size() < 2)
    return refuse(b, row, "lcid", "the curve must begin at strain 0, positive in compression",
                  "give nominal stress over nominal strain of compression");
  flow.cutoff = row.real("tc");
  flow.tears = unloading.real("fail") == 1.0;
  flow.unloading = row.real("hu");
  flow.shape = unloading.real("shape");
  kernel::Composition law{flow};
  law.for_shells = false;
  law.bulk_viscosity = unloading.real("bvflag") == 1.0;
  b.model.materials[static_cast<std::size_t>(material)].law = compound(std::move(law));
}

void read_low_density_foam(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(low_density_foam_card);
  const Row unloading = cursor.read(low_density_foam_unloading_card);
  expect_end(b, cursor);
  const Index material =
      add_material(b, row, std::move(title), "MAT_LOW_DENSITY_FOAM", kernel::Elastic{row.real("e"), 0.0});
  b.later(Phase::parts, [=](Builder& later) { set_low_density_foam(later, material, row, unloading); });
}

const Card crushable_foam_card{{
    material_id,
    density,
    real("e", dimension::stress, 0, at_least(0), "no effect: the curve's last slope is the elastic stiffness"),
    real("pr", dimension::number, 0, between(0, 0.5), "no effect: the foam does not contract"),
    id("lcid", IdSpace::function, required, "curve: yield stress over volumetric strain, positive in compression"),
    real("tsc", dimension::stress, 0, at_least(0), "greatest tensile stress"),
    real("damp", dimension::number, 0, only(0), "rate sensitivity by damping"),
    integer("model", 0, only(0), "yield surface: 0, principal stresses one by one"),
}};

void set_crushable_foam(Builder& b, Index material, const Row& row) {
  const Index curve = b.curve(row, "lcid");
  if (curve == none) return;
  kernel::CrushableFoam flow;
  flow.yield = b.model.curves[static_cast<std::size_t>(curve)];
  flow.E = flow.yield.slope(flow.yield.x.back());
  if (!(flow.E > 0.0))
    return refuse(b, row, "lcid", "the curve's last slope is the elastic stiffness and must be above 0",
                  "end the curve with the steep rise of the compacted foam");
  if (*std::min_element(flow.yield.y.begin(), flow.yield.y.end()) < 0.0)
    return refuse(b, row, "lcid", "a yield stress is below 0", "give the curve positive in compression");
  flow.cutoff = row.real("tsc");
  kernel::Composition law{flow};
  law.for_shells = false;
  b.model.materials[static_cast<std::size_t>(material)].law = compound(std::move(law));
}

void read_crushable_foam(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(crushable_foam_card);
  expect_end(b, cursor);
  const Index material = add_material(b, row, std::move(title), "MAT_CRUSHABLE_FOAM",
                                      kernel::Elastic{std::max(row.real("e"), 1e-30), 0.0});
  b.later(Phase::parts, [=](Builder& later) { set_crushable_foam(later, material, row); });
}

}  // namespace

std::vector<Keyword> soft_material_keywords() {
  return {
      {.name = "MAT_VISCOELASTIC",
       .aliases = {"MAT_006"},
       .options = {"TITLE"},
       .layout = {{"", &viscoelastic_card}},
       .read = read_viscoelastic},
      {.name = "MAT_MOONEY-RIVLIN_RUBBER",
       .aliases = {"MAT_027"},
       .options = {"TITLE"},
       .layout = {{"", &mooney_rivlin_card}, {"", &mooney_rivlin_fit_card}},
       .read = read_mooney_rivlin},
      {.name = "MAT_LOW_DENSITY_FOAM",
       .aliases = {"MAT_057"},
       .options = {"TITLE"},
       .layout = {{"", &low_density_foam_card}, {"", &low_density_foam_unloading_card}},
       .read = read_low_density_foam},
      {.name = "MAT_CRUSHABLE_FOAM",
       .aliases = {"MAT_063"},
       .options = {"TITLE"},
       .layout = {{"", &crushable_foam_card}},
       .read = read_crushable_foam},
      {.name = "MAT_OGDEN_RUBBER",
       .aliases = {"MAT_077_O"},
       .options = {"TITLE"},
       .layout = {{"", &ogden_card}, {"", &ogden_moduli_card}, {"", &ogden_exponents_card}},
       .read = read_ogden},
      {.name = "MAT_HYPERELASTIC_RUBBER",
       .aliases = {"MAT_077_H"},
       .options = {"TITLE"},
       .verdict = Verdict::refused,
       .why = "this rubber is not built; *MAT_OGDEN_RUBBER and *MAT_MOONEY-RIVLIN_RUBBER are"},
      {.name = "MAT_FU_CHANG_FOAM",
       .aliases = {"MAT_083"},
       .options = {"TITLE", "DAMAGE_DECAY", "LOG_LOG_INTERPOLATION"},
       .verdict = Verdict::refused,
       .why = "foam with curves over the strain rate is not built; *MAT_LOW_DENSITY_FOAM with one curve comes nearest"},
  };
}

}  // namespace nugget::model
