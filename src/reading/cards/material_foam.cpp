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
using deck::RowOf;
using kernel::CrushableFoam;
using kernel::LowDensityFoam;
using kernel::RateFoam;

using kernel::law_field::reference;

constexpr RealField damping_share =
    real("damp", dimension::number, 0, between(0, 1), "viscous stress, as a share of critical damping in each element");

/// Gives a material its law, which only solids can have.
void set_foam(Builder& b, Index material, kernel::LawComponents law) {
  b.model.materials[material].law = composed_law(std::move(law));
}

/// A foam's curve over the amount of compression: its yield stress, or with `from_zero` its stress.
void check_compression(Builder& b, const deck::Entry& field, const Curve& curve, bool from_zero) {
  const auto warn = [&](std::string text, const char* remedy) {
    field.report(b.findings, Severity::warning, fmt::format("curve {}: {}", curve.id, text), remedy);
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
    refuse(b, field, fmt::format("curve {}: its last slope, which goes on, is below 0", curve.id),
           "end the curve with the steep rise of the compacted foam");
}

/// Whether a stress over the amount of compression is below 0 there.
bool pulls(const Curve& curve) {
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    if (curve.x[i] > 0.0 && curve.y[i] < 0.0) return true;
  return false;
}

// ---- 057

/// Both cards of *MAT_LOW_DENSITY_FOAM.
struct LowDensityFoamCards : MaterialCard, LowDensityFoam {
  int lcid = 0;
  double fail = 0, bvflag = 0, kcon = 0;
};
const CardOf<LowDensityFoamCards> low_density_foam_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&LowDensityFoam::E, real("e", dimension::stress, required, above_zero(), "Young's modulus in tension")},
    {&LowDensityFoamCards::lcid,
     id("lcid", IdSpace::function, required, "curve: nominal stress over nominal strain, positive in compression")},
    {&LowDensityFoam::cutoff, real("tc", dimension::stress, 1e20, at_least(0), "greatest nominal tensile stress")},
    {&LowDensityFoam::unloading,
     real("hu", dimension::number, 1, between(0, 1), "share of the stress that unloading keeps; 1: no hysteresis")},
    {&LowDensityFoam::recovery,
     real("beta", dimension::rate, 0, at_least(0), "rate at which an unloaded foam comes back to its curve")},
    {&LowDensityFoam::damping, damping_share},
};

const CardOf<LowDensityFoamCards> low_density_foam_unloading_card{
    {&LowDensityFoam::shape, real("shape", dimension::number, 1, above_zero(), "exponent of the energy in unloading")},
    {&LowDensityFoamCards::fail,
     real("fail", dimension::number, 0, between(0, 1), "at the cutoff 0: the stress stays there, 1: it falls to 0")},
    {&LowDensityFoamCards::bvflag,
     real("bvflag", dimension::number, 0, between(0, 1), "bulk viscosity: 0 none, 1 as in other solids")},
    {&LowDensityFoam::maxwell_modulus,
     real("ed", dimension::stress, 0, at_least(0), "modulus of a stress that relaxes; 0: none")},
    {&LowDensityFoam::decay, real("beta1", dimension::rate, 0, at_least(0), "its decay")},
    {&LowDensityFoamCards::kcon,
     real("kcon", dimension::stress, 0, at_least(0), "modulus for the stiffness of contacts; 0: E")},
    reference,
};

/// `lcid`: the field of the curve.
void set_low_density_foam(Builder& b, Index material, const LowDensityFoamCards& cards, const deck::Entry& lcid) {
  const Index curve = b.curve(lcid);
  if (curve == none) return;
  LowDensityFoam flow = cards;
  flow.compression = b.model.curves[curve];
  if (flow.compression.x.size() < 2 || flow.compression.x.front() < 0.0 || flow.compression.y.front() < 0.0 ||
      pulls(flow.compression))
    return refuse(b, lcid, "the curve must begin at strain 0, positive in compression",
                  "give nominal stress over nominal strain of compression");
  check_compression(b, lcid, flow.compression, true);
  flow.tension_failure = cards.fail == 1.0;
  kernel::LawComponents law{flow};
  law.bulk_viscosity = cards.bvflag == 1.0;
  law.contact_modulus = cards.kcon;
  set_foam(b, material, std::move(law));
}

void read_low_density_foam(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  LowDensityFoamCards cards;
  const auto row = cursor.read(low_density_foam_card, cards);
  cursor.read(low_density_foam_unloading_card, cards);
  expect_end(b, cursor);
  const Index material = add_material(b, row, std::move(title), "MAT_LOW_DENSITY_FOAM", kernel::Elastic{cards.E, 0.0});
  b.defer(Phase::parts, [=, lcid = row[&LowDensityFoamCards::lcid]](Builder& later) {
    set_low_density_foam(later, material, cards, lcid);
  });
}

// ---- 073

const CardOf<LowDensityFoamCards> viscous_foam_unloading_card{
    {&LowDensityFoam::shape, real("shape", dimension::number, 1, above_zero(), "exponent of the energy in unloading")},
    {&LowDensityFoamCards::fail,
     real("fail", dimension::number, 0, between(0, 1), "at the cutoff 0: the stress stays there, 1: it falls to 0")},
    {&LowDensityFoamCards::bvflag,
     real("bvflag", dimension::number, 0, between(0, 1), "bulk viscosity: 0 none, 1 as in other solids")},
    {&LowDensityFoamCards::kcon,
     real("kcon", dimension::stress, 0, at_least(0), "modulus for the stiffness of contacts; 0: E")},
    integer("lcid2", 0, only(0), "relaxation curve that a series would be fitted to"),
    real("bstart", dimension::number, 0, any_value, "of that fit"),
    real("tramp", dimension::number, 0, any_value, "of that fit"),
    integer("nv", 6, any_value, "of that fit"),
};

struct ViscousFoamTerm : kernel::Overstress::MaxwellBranch {};
const CardOf<ViscousFoamTerm> viscous_foam_term_card{
    {&ViscousFoamTerm::shear, real("gi", dimension::stress, 0, at_least(0), "modulus of a stress that relaxes")},
    {&ViscousFoamTerm::decay, real("betai", dimension::rate, 0, at_least(0), "its decay; 0: the term stays")},
    reference,
};

void read_viscous_foam(Builder& b, const Block& block, const Options& options) {
  constexpr std::size_t most_terms = 6;
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  LowDensityFoamCards cards;
  const auto row = cursor.read(low_density_foam_card, cards);
  cursor.read(viscous_foam_unloading_card, cards);
  while (cursor.more()) {
    const auto term = cursor.read(viscous_foam_term_card);
    if (!(term->shear > 0.0)) continue;
    if (cards.terms.size() == most_terms) {
      refuse(b, term[&ViscousFoamTerm::shear], "more than six terms are not supported");
      break;
    }
    cards.terms.push_back(*term);
  }
  if (cards.terms.empty())
    row[&LowDensityFoamCards::lcid].report(b.findings, Severity::note, "without GI and BETAI no stress relaxes",
                                           "*MAT_LOW_DENSITY_FOAM is the same");
  const Index material =
      add_material(b, row, std::move(title), "MAT_LOW_DENSITY_VISCOUS_FOAM", kernel::Elastic{cards.E, 0.0});
  b.defer(Phase::parts, [=, lcid = row[&LowDensityFoamCards::lcid]](Builder& later) {
    set_low_density_foam(later, material, cards, lcid);
  });
}

// ---- 063

struct CrushableFoamCard : MaterialCard, CrushableFoam {
  double e = 0;
  int lcid = 0;
};
const CardOf<CrushableFoamCard> crushable_foam_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&CrushableFoamCard::e,
     real("e", dimension::stress, 0, at_least(0), "no effect: the curve's last slope is the elastic stiffness")},
    real("pr", dimension::number, 0, between(0, 0.5), "no effect: the foam does not contract"),
    {&CrushableFoamCard::lcid,
     id("lcid", IdSpace::function, required, "curve: yield stress over volumetric strain, positive in compression")},
    {&CrushableFoam::cutoff, real("tsc", dimension::stress, 0, at_least(0), "greatest tensile stress")},
    {&CrushableFoam::damping, damping_share},
    integer("model", 0, only(0), "yield surface: 0, principal stresses one by one"),
};

void set_crushable_foam(Builder& b, Index material, const RowOf<CrushableFoamCard>& row) {
  const deck::Entry lcid = row[&CrushableFoamCard::lcid];
  const Index curve = b.curve(lcid);
  if (curve == none) return;
  CrushableFoam flow = *row;
  flow.yield = b.model.curves[curve];
  if (flow.yield.empty()) return;  // reported where it is defined
  flow.E = flow.yield.slope(flow.yield.x.back());
  if (!(flow.E > 0.0))
    return refuse(b, lcid, "the curve's last slope is the elastic stiffness and must be above 0",
                  "end the curve with the steep rise of the compacted foam");
  if (*std::min_element(flow.yield.y.begin(), flow.yield.y.end()) < 0.0)
    return refuse(b, lcid, "a yield stress is below 0", "give the curve positive in compression");
  check_compression(b, lcid, flow.yield, false);
  if (flow.cutoff == 0.0)
    row[&CrushableFoam::cutoff].report(b.findings, Severity::warning, "it carries no tension at all",
                                       "give the tensile strength");
  set_foam(b, material, {flow});
}

void read_crushable_foam(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(crushable_foam_card);
  expect_end(b, cursor);
  const Index material =
      add_material(b, row, std::move(title), "MAT_CRUSHABLE_FOAM", kernel::Elastic{std::max(row->e, 1e-30), 0.0});
  b.defer(Phase::parts, [=](Builder& later) { set_crushable_foam(later, material, row); });
}

// ---- 083

/// All cards of *MAT_FU_CHANG_FOAM.
struct RateFoamCards : MaterialCard, RateFoam {
  double tc = 0, fail = 0, bvflag = 0, sflag = 0, rflag = 0, tflag = 0;
  int tbid = 0;
};
const CardOf<RateFoamCards> rate_foam_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&RateFoam::E, real("e", dimension::stress, required, above_zero(), "Young's modulus in tension")},
    {&RateFoam::step_modulus,
     real("kcon", dimension::stress, 0, at_least(0), "least modulus for step, contacts, hourglass stiffness and DAMP")},
    {&RateFoamCards::tc, real("tc", dimension::stress, 1e20, at_least(0), "greatest nominal tensile stress")},
    {&RateFoamCards::fail,
     real("fail", dimension::number, 0, between(0, 2),
          "at the cutoff 0: the stress stays there, 1: it falls to 0, 2: the element is deleted")},
    {&RateFoam::damping, real("damp", dimension::number, 0.05, between(0, 1),
                              "viscous stress, as a share of critical damping in each element")},
    {&RateFoamCards::tbid,
     id("tbid", IdSpace::function, required, "table: nominal stress over nominal strain, by rate, pressed positive")},
};

const CardOf<RateFoamCards> rate_foam_flags_card{
    {&RateFoamCards::bvflag,
     real("bvflag", dimension::number, 0, any_value, "bulk viscosity: below 1 none, from 1 as in other solids")},
    {&RateFoamCards::sflag,
     real("sflag", dimension::number, 0, between(0, 1), "rate over the length 0: of the moment, 1: at first")},
    {&RateFoamCards::rflag, real("rflag", dimension::number, 0, between(0, 2),
                                 "rate of 0: the most strained direction, 1: each direction, 2: the volume")},
    {&RateFoamCards::tflag,
     real("tflag", dimension::number, 0, between(0, 1), "tension 0: linear by E, 1: by the curves' negative strains")},
    integer("pvid", 0, only(0), "curve: pressure over volumetric strain"),
    real("sraf", dimension::number, 0, only(0), "averaging of rates: 0, a running mean"),
    reference,
    {&RateFoam::unloading,
     real("hu", dimension::number, 0, between(0, 1), "share of the stress that unloading keeps; 0: lowest curve")},
};

const Card rate_foam_constants_card{{unused(), unused(), unused(), unused(), unused(), unused(), unused(), unused()}};

const CardOf<RateFoamCards> rate_foam_shape_card{
    unused(),
    unused(),
    unused(),
    unused(),
    unused(),
    real("minr", dimension::rate, 0, at_least(0), "lowest rate of interest; here the table's"),
    real("maxr", dimension::rate, 0, at_least(0), "highest rate of interest; here the table's"),
    {&RateFoam::shape, real("shape", dimension::number, 1, above_zero(), "exponent of the energy in unloading")},
};

const CardOf<RateFoamCards> rate_foam_exponent_card{
    {&RateFoam::exponent, real("expon", dimension::number, 1, above_zero(), "exponent of what unloading loses")},
    real("riuld", dimension::number, 0, between(0, 1), "no effect: unloading never depends on the rate"),
    integer("pdopt", 0, only(0), "for PATH_DEPENDENT only"),
};

/// The curves of a table, by rate.
bool set_table(Builder& b, const deck::Entry& tbid, RateFoam& flow) {
  const int id = tbid.integer();
  if (const Index c = b.curves.find(id); b.tables.find(id) == none && c != none) {
    flow.curves = {b.model.curves[c]};
    flow.rates = {0.0};
  } else {
    const Index t = b.find(b.tables, "table", tbid);
    if (t == none) return false;
    const Table& table = b.model.tables[t];
    if (table.curve.size() != table.value.size() || table.value.empty()) return false;  // reported where it is defined
    for (const Index one : table.curve) flow.curves.push_back(b.model.curves[one]);
    flow.rates = table.value;
  }
  for (const Curve& curve : flow.curves) {
    if (curve.x.size() < 2 || (!flow.tension_by_curves && (curve.x.front() < 0.0 || curve.y.front() < 0.0))) {
      refuse(b, tbid, fmt::format("curve {} must begin at strain 0, positive in compression", curve.id),
             "give nominal stress over nominal strain of compression; with TFLAG 1 negative strains are tension");
      return false;
    }
    if (pulls(curve)) {
      refuse(b, tbid, fmt::format("curve {} pulls while it is compressed", curve.id),
             "give nominal stress over nominal strain, both positive in compression");
      return false;
    }
    check_compression(b, tbid, curve, true);
  }
  if (flow.log_log && flow.rates.size() > 1 && flow.rates.front() == 0.0) {
    refuse(b, tbid, "a rate of 0 has no logarithm", "start the table at the lowest rate of the tests");
    return false;
  }
  if (flow.rates.front() < 0.0) {
    refuse(b, tbid, "a rate of the table is below 0", "give the rates themselves, not their logarithms");
    return false;
  }
  return true;
}

/// `tbid`: the field of the table.
void set_rate_foam(Builder& b, Index material, const RateFoamCards& cards, const deck::Entry& tbid) {
  RateFoam flow = cards;
  flow.tension_by_curves = cards.tflag == 1.0;
  if (!set_table(b, tbid, flow)) return;
  flow.engineering_rate = cards.sflag == 1.0;
  flow.rate_of = static_cast<RateFoam::RateOf>(static_cast<int>(cards.rflag));
  flow.tension_failure = cards.fail == 1.0;
  const bool erodes = cards.fail == 2.0;
  if (!erodes) flow.cutoff = cards.tc;
  kernel::LawComponents law{flow};
  law.bulk_viscosity = cards.bvflag >= 1.0;
  if (cards.step_modulus > cards.E) law.contact_modulus = cards.step_modulus;
  if (erodes) {
    law.erosion = kernel::Erosion{};
    law.erosion->most_stress = cards.tc;
    law.points_to_delete = 1.0;
  }
  set_foam(b, material, std::move(law));
}

template <bool log_log>
void read_rate_foam(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  RateFoamCards cards;
  cards.log_log = log_log;
  const auto row = cursor.read(rate_foam_card, cards);
  cursor.read(rate_foam_flags_card, cards);
  cursor.read(rate_foam_constants_card);
  cursor.read(rate_foam_shape_card, cards);
  cursor.read(rate_foam_exponent_card, cards);
  expect_end(b, cursor);
  const Index material = add_material(b, row, std::move(title), "MAT_FU_CHANG_FOAM", kernel::Elastic{cards.E, 0.0});
  b.defer(Phase::parts,
          [=, tbid = row[&RateFoamCards::tbid]](Builder& later) { set_rate_foam(later, material, cards, tbid); });
}

}  // namespace

std::vector<Keyword> foam_material_keywords() {
  const std::vector<LayoutCard> rate_foam_layout{{"", &rate_foam_card},
                                                 {"", &rate_foam_flags_card},
                                                 {"", &rate_foam_constants_card},
                                                 {"", &rate_foam_shape_card},
                                                 {"", &rate_foam_exponent_card}};
  return {
      {.name = "MAT_LOW_DENSITY_FOAM",
       .aliases = {"MAT_057"},
       .options = {"TITLE"},
       .layout = {{"", &low_density_foam_card}, {"", &low_density_foam_unloading_card}},
       .read = read_low_density_foam},
      {.name = "MAT_LOW_DENSITY_VISCOUS_FOAM",
       .aliases = {"MAT_073"},
       .options = {"TITLE"},
       .layout = {{"", &low_density_foam_card},
                  {"", &viscous_foam_unloading_card},
                  {"one a term, up to six", &viscous_foam_term_card}},
       .read = read_viscous_foam},
      {.name = "MAT_CRUSHABLE_FOAM",
       .aliases = {"MAT_063"},
       .options = {"TITLE"},
       .layout = {{"", &crushable_foam_card}},
       .read = read_crushable_foam},
      {.name = "MAT_FU_CHANG_FOAM",
       .aliases = {"MAT_083"},
       .options = {"TITLE"},
       .layout = rate_foam_layout,
       .read = read_rate_foam<false>},
      {.name = "MAT_FU_CHANG_FOAM_DAMAGE_DECAY",
       .aliases = {"MAT_083_1"},
       .options = {"TITLE"},
       .status = KeywordStatus::refused,
       .why = "damage that decays is not built; *MAT_FU_CHANG_FOAM without the option is"},
      {.name = "MAT_FU_CHANG_FOAM_LOG_LOG_INTERPOLATION",
       .aliases = {"MAT_083_2"},
       .options = {"TITLE"},
       .layout = rate_foam_layout,
       .read = read_rate_foam<true>},
      {.name = "MAT_FU_CHANG_FOAM_PATH_DEPENDENT",
       .aliases = {"MAT_083_3"},
       .options = {"TITLE"},
       .status = KeywordStatus::refused,
       .why = "tables over the volume are not built; *MAT_FU_CHANG_FOAM without the option is"},
  };
}

}  // namespace nugget::reading
