// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_... of foam.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

using kernel::law_field::reference;

constexpr Field damping =
    real("damp", dimension::number, 0, between(0, 1), "viscous stress, as a share of critical damping in each element");

/// Gives a material its law, which only solids can have.
void set_foam(Builder& b, Index material, kernel::LawComponents law) {
  b.model.materials[static_cast<std::size_t>(material)].law = composed_law(std::move(law));
}

/// A foam's curve over the amount of compression: its yield stress, or with `from_zero` its stress.
void check_compression(Builder& b, const Row& row, std::string_view field, const Curve& curve, bool from_zero) {
  const auto warn = [&](std::string text, const char* remedy) {
    row.report(b.findings, Severity::warning, field, fmt::format("curve {}: {}", curve.id, text), remedy);
  };
  const double at_rest = curve.extrapolated(0.0), most = *std::max_element(curve.y.begin(), curve.y.end());
  if (from_zero && std::abs(at_rest) > 1e-9 * most)
    warn(fmt::format("the stress leaps to {:g} as soon as there is a strain", at_rest), "let the curve begin at 0, 0");
  for (std::size_t i = 0; i + 1 < curve.x.size(); ++i)
    if (curve.x[i + 1] > 0.0 && curve.y[i + 1] < curve.y[i]) {
      warn(fmt::format("it falls behind {:g}: elements give way one after the other, which depends on the mesh",
                       curve.x[i]),
           "give a curve that rises to its end");
      break;
    }
  if (curve.x.size() > 1 && curve.x.back() < 1.0 && curve.slope(curve.x.back()) < 0.0)
    refuse(b, row, field, fmt::format("curve {}: its last slope, which goes on, is below 0", curve.id),
           "end the curve with the steep rise of the compacted foam");
}

/// Whether a stress over the amount of compression is below 0 there.
bool pulls(const Curve& curve) {
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    if (curve.x[i] > 0.0 && curve.y[i] < 0.0) return true;
  return false;
}

// ---- 057

const Card low_density_foam_card{{
    material_id,
    density,
    real("e", dimension::stress, required, above_zero(), "Young's modulus in tension"),
    id("lcid", IdSpace::function, required, "curve: nominal stress over nominal strain, positive in compression"),
    real("tc", dimension::stress, 1e20, at_least(0), "greatest nominal tensile stress"),
    real("hu", dimension::number, 1, between(0, 1), "share of the stress that unloading keeps; 1: no hysteresis"),
    real("beta", dimension::rate, 0, at_least(0), "rate at which an unloaded foam comes back to its curve"),
    damping,
}};

const Card low_density_foam_unloading_card{{
    real("shape", dimension::number, 1, above_zero(), "exponent of the energy in unloading"),
    real("fail", dimension::number, 0, between(0, 1), "at the cutoff 0: the stress stays there, 1: it falls to 0"),
    real("bvflag", dimension::number, 0, between(0, 1), "bulk viscosity: 0 none, 1 as in other solids"),
    real("ed", dimension::stress, 0, at_least(0), "modulus of a stress that relaxes; 0: none"),
    real("beta1", dimension::rate, 0, at_least(0), "its decay"),
    real("kcon", dimension::stress, 0, only(0), "stiffness for contacts; here that of E"),
    reference,
}};

void set_low_density_foam(Builder& b, Index material, const Row& row, const Row& unloading) {
  const Index curve = b.curve(row, "lcid");
  if (curve == none) return;
  kernel::LowDensityFoam flow;
  flow.E = row.real("e");
  flow.compression = b.model.curves[static_cast<std::size_t>(curve)];
  if (flow.compression.x.size() < 2 || flow.compression.x.front() < 0.0 || flow.compression.y.front() < 0.0 ||
      pulls(flow.compression))
    return refuse(b, row, "lcid", "the curve must begin at strain 0, positive in compression",
                  "give nominal stress over nominal strain of compression");
  check_compression(b, row, "lcid", flow.compression, true);
  flow.cutoff = row.real("tc");
  flow.tension_failure = unloading.real("fail") == 1.0;
  flow.unloading = row.real("hu");
  flow.shape = unloading.real("shape");
  flow.recovery = row.real("beta");
  flow.damping = row.real("damp");
  flow.maxwell_modulus = unloading.real("ed");
  flow.decay = unloading.real("beta1");
  kernel::LawComponents law{flow};
  law.bulk_viscosity = unloading.real("bvflag") == 1.0;
  set_foam(b, material, std::move(law));
}

void read_low_density_foam(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(low_density_foam_card);
  const Row unloading = cursor.read(low_density_foam_unloading_card);
  expect_end(b, cursor);
  const Index material =
      add_material(b, row, std::move(title), "MAT_LOW_DENSITY_FOAM", kernel::Elastic{row.real("e"), 0.0});
  b.defer(Phase::parts, [=](Builder& later) { set_low_density_foam(later, material, row, unloading); });
}

// ---- 063

const Card crushable_foam_card{{
    material_id,
    density,
    real("e", dimension::stress, 0, at_least(0), "no effect: the curve's last slope is the elastic stiffness"),
    real("pr", dimension::number, 0, between(0, 0.5), "no effect: the foam does not contract"),
    id("lcid", IdSpace::function, required, "curve: yield stress over volumetric strain, positive in compression"),
    real("tsc", dimension::stress, 0, at_least(0), "greatest tensile stress"),
    damping,
    integer("model", 0, only(0), "yield surface: 0, principal stresses one by one"),
}};

void set_crushable_foam(Builder& b, Index material, const Row& row) {
  const Index curve = b.curve(row, "lcid");
  if (curve == none) return;
  kernel::CrushableFoam flow;
  flow.yield = b.model.curves[static_cast<std::size_t>(curve)];
  if (flow.yield.empty()) return;  // reported where it is defined
  flow.E = flow.yield.slope(flow.yield.x.back());
  if (!(flow.E > 0.0))
    return refuse(b, row, "lcid", "the curve's last slope is the elastic stiffness and must be above 0",
                  "end the curve with the steep rise of the compacted foam");
  if (*std::min_element(flow.yield.y.begin(), flow.yield.y.end()) < 0.0)
    return refuse(b, row, "lcid", "a yield stress is below 0", "give the curve positive in compression");
  check_compression(b, row, "lcid", flow.yield, false);
  flow.cutoff = row.real("tsc");
  if (flow.cutoff == 0.0)
    row.report(b.findings, Severity::warning, "tsc", "it carries no tension at all", "give the tensile strength");
  flow.damping = row.real("damp");
  set_foam(b, material, {flow});
}

void read_crushable_foam(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(crushable_foam_card);
  expect_end(b, cursor);
  const Index material = add_material(b, row, std::move(title), "MAT_CRUSHABLE_FOAM",
                                      kernel::Elastic{std::max(row.real("e"), 1e-30), 0.0});
  b.defer(Phase::parts, [=](Builder& later) { set_crushable_foam(later, material, row); });
}

// ---- 083

const Card rate_foam_card{{
    material_id,
    density,
    real("e", dimension::stress, required, above_zero(), "Young's modulus in tension"),
    real("kcon", dimension::stress, 0, only(0), "stiffness for step and contacts; here that of the table and of E"),
    real("tc", dimension::stress, 1e20, at_least(0), "greatest nominal tensile stress"),
    real("fail", dimension::number, 0, between(0, 2),
         "at the cutoff 0: the stress stays there, 1: it falls to 0, 2: the element is deleted"),
    real("damp", dimension::number, 0.05, between(0, 1),
         "viscous stress, as a share of critical damping in each element"),
    id("tbid", IdSpace::function, required, "table: nominal stress over nominal strain, by rate, pressed positive"),
}};

const Card rate_foam_flags_card{{
    real("bvflag", dimension::number, 0, any_value, "bulk viscosity: below 1 none, from 1 as in other solids"),
    real("sflag", dimension::number, 0, between(0, 1), "rate over the length 0: of the moment, 1: at first"),
    real("rflag", dimension::number, 0, between(0, 2),
         "rate of 0: the most strained direction, 1: each direction, 2: the volume"),
    real("tflag", dimension::number, 0, between(0, 1), "tension 0: linear by E, 1: by the curves' negative strains"),
    integer("pvid", 0, only(0), "curve: pressure over volumetric strain"),
    real("sraf", dimension::number, 0, only(0), "averaging of rates: 0, a running mean"),
    reference,
    real("hu", dimension::number, 0, between(0, 1), "share of the stress that unloading keeps; 0: lowest curve"),
}};

const Card rate_foam_constants_card{{unused(), unused(), unused(), unused(), unused(), unused(), unused(), unused()}};

const Card rate_foam_shape_card{{
    unused(),
    unused(),
    unused(),
    unused(),
    unused(),
    real("minr", dimension::rate, 0, at_least(0), "lowest rate of interest; here the table's"),
    real("maxr", dimension::rate, 0, at_least(0), "highest rate of interest; here the table's"),
    real("shape", dimension::number, 1, above_zero(), "exponent of the energy in unloading"),
}};

const Card rate_foam_exponent_card{{
    real("expon", dimension::number, 1, above_zero(), "exponent of what unloading loses"),
    real("riuld", dimension::number, 0, between(0, 1), "no effect: unloading never depends on the rate"),
    integer("pdopt", 0, only(0), "for PATH_DEPENDENT only"),
}};

/// The curves of a table, by rate.
bool set_table(Builder& b, const Row& row, kernel::RateFoam& flow) {
  const int id = row.integer("tbid");
  if (const Index c = b.curves.find(id); b.tables.find(id) == none && c != none) {
    flow.curves = {b.model.curves[static_cast<std::size_t>(c)]};
    flow.rates = {0.0};
  } else {
    const Index t = b.find(b.tables, "table", row, "tbid");
    if (t == none) return false;
    const Table& table = b.model.tables[static_cast<std::size_t>(t)];
    if (table.curve.size() != table.value.size() || table.value.empty()) return false;  // reported where it is defined
    for (const Index one : table.curve) flow.curves.push_back(b.model.curves[static_cast<std::size_t>(one)]);
    flow.rates = table.value;
  }
  for (const Curve& curve : flow.curves) {
    if (curve.x.size() < 2 || (!flow.tension_by_curves && (curve.x.front() < 0.0 || curve.y.front() < 0.0))) {
      refuse(b, row, "tbid", fmt::format("curve {} must begin at strain 0, positive in compression", curve.id),
             "give nominal stress over nominal strain of compression; with TFLAG 1 negative strains are tension");
      return false;
    }
    if (pulls(curve)) {
      refuse(b, row, "tbid", fmt::format("curve {} pulls while it is compressed", curve.id),
             "give nominal stress over nominal strain, both positive in compression");
      return false;
    }
    check_compression(b, row, "tbid", curve, true);
  }
  if (flow.rates.front() < 0.0) {
    refuse(b, row, "tbid", "a rate of the table is below 0", "give the rates themselves, not their logarithms");
    return false;
  }
  return true;
}

struct RateFoamCards {
  Row main, flags, shape, exponent;
};

void set_rate_foam(Builder& b, Index material, const RateFoamCards& cards) {
  kernel::RateFoam flow;
  flow.E = cards.main.real("e");
  flow.tension_by_curves = cards.flags.real("tflag") == 1.0;
  if (!set_table(b, cards.main, flow)) return;
  flow.engineering_rate = cards.flags.real("sflag") == 1.0;
  flow.rate_of = static_cast<kernel::RateFoam::RateOf>(static_cast<int>(cards.flags.real("rflag")));
  flow.tension_failure = cards.main.real("fail") == 1.0;
  flow.unloading = cards.flags.real("hu");
  flow.shape = cards.shape.real("shape");
  flow.exponent = cards.exponent.real("expon");
  flow.damping = cards.main.real("damp");
  const double cutoff = cards.main.real("tc");
  const bool erodes = cards.main.real("fail") == 2.0;
  if (!erodes) flow.cutoff = cutoff;
  kernel::LawComponents law{flow};
  law.bulk_viscosity = cards.flags.real("bvflag") >= 1.0;
  if (erodes) {
    law.erosion = kernel::Erosion{};
    law.erosion->most_stress = cutoff;
    law.points_to_delete = 1.0;
  }
  set_foam(b, material, std::move(law));
}

void read_rate_foam(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  RateFoamCards cards;
  cards.main = cursor.read(rate_foam_card);
  cards.flags = cursor.read(rate_foam_flags_card);
  cursor.read(rate_foam_constants_card);
  cards.shape = cursor.read(rate_foam_shape_card);
  cards.exponent = cursor.read(rate_foam_exponent_card);
  expect_end(b, cursor);
  const Index material =
      add_material(b, cards.main, std::move(title), "MAT_FU_CHANG_FOAM", kernel::Elastic{cards.main.real("e"), 0.0});
  b.defer(Phase::parts, [=](Builder& later) { set_rate_foam(later, material, cards); });
}

}  // namespace

std::vector<Keyword> foam_material_keywords() {
  return {
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
      {.name = "MAT_FU_CHANG_FOAM",
       .aliases = {"MAT_083"},
       .options = {"TITLE"},
       .layout = {{"", &rate_foam_card},
                  {"", &rate_foam_flags_card},
                  {"", &rate_foam_constants_card},
                  {"", &rate_foam_shape_card},
                  {"", &rate_foam_exponent_card}},
       .read = read_rate_foam},
      {.name = "MAT_FU_CHANG_FOAM_DAMAGE_DECAY",
       .aliases = {"MAT_083_1"},
       .options = {"TITLE"},
       .status = KeywordStatus::refused,
       .why = "damage that decays is not built; *MAT_FU_CHANG_FOAM without the option is"},
      {.name = "MAT_FU_CHANG_FOAM_LOG_LOG_INTERPOLATION",
       .aliases = {"MAT_083_2"},
       .options = {"TITLE"},
       .status = KeywordStatus::refused,
       .why = "interpolation between the logarithms is not built; *MAT_FU_CHANG_FOAM without the option is"},
      {.name = "MAT_FU_CHANG_FOAM_PATH_DEPENDENT",
       .aliases = {"MAT_083_3"},
       .options = {"TITLE"},
       .status = KeywordStatus::refused,
       .why = "tables over the volume are not built; *MAT_FU_CHANG_FOAM without the option is"},
  };
}

}  // namespace nugget::reading
