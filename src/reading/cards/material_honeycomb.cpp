// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "base/index.hpp"
#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_HONEYCOMB and *MAT_MODIFIED_HONEYCOMB.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;
using kernel::Honeycomb;

/// All cards of both keywords.
struct HoneycombCards : MaterialCard, Honeycomb, AxesCards {
  double mu = 0, tsef = 0, ssef = 0;
  int bulk = 0, lcs = 0, lcsr = 0, pru = 0;
  std::array<int, 6> curve{};  ///< LCA LCB LCC LCAB LCBC LCCA
};
const CardOf<HoneycombCards> dense_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&Honeycomb::E, real("e", dimension::stress, required, above_zero(), "Young's modulus of the compacted material")},
    {&Honeycomb::nu, real("pr", dimension::number, 0, between(0, 0.49), "its Poisson's ratio")},
    {&Honeycomb::yield, real("sigy", dimension::stress, required, above_zero(), "its yield stress")},
    {&Honeycomb::compacted_volume,
     real("vf", dimension::number, required, between(0, 1), "relative volume at which it is compacted")},
    {&HoneycombCards::mu,
     real("mu", dimension::number, 0.05, between(0, 1), "viscosity, as a share of critical damping; 0: 0.05")},
    {&HoneycombCards::bulk,
     integer("bulk", 0, between(0, 1), "0: viscosity MU; 1: bulk viscosity instead, by the compacted sound speed")},
};

constexpr IntegerField curve_bb = id("lcb", IdSpace::function, 0, "the same of bb; 0: LCA");
constexpr IntegerField curve_cc = id("lcc", IdSpace::function, 0, "the same of cc; 0: LCA");
constexpr IntegerField curve_ab = id("lcab", IdSpace::function, 0, "the same of ab; 0: LCS");
constexpr IntegerField curve_bc = id("lcbc", IdSpace::function, 0, "the same of bc; 0: LCS");
constexpr IntegerField curve_ca = id("lcca", IdSpace::function, 0, "the same of ca; 0: LCS");
constexpr IntegerField rate_curve =
    id("lcsr", IdSpace::function, 0, "curve: factor on the largest stresses over the rate");

const CardOf<HoneycombCards> honeycomb_curves_card{
    {at(&HoneycombCards::curve, 0),
     id("lca", IdSpace::function, required,
        "curve: largest stress aa over relative volume (begins above 0) or volumetric strain (at or below 0)")},
    {at(&HoneycombCards::curve, 1), curve_bb},
    {at(&HoneycombCards::curve, 2), curve_cc},
    {&HoneycombCards::lcs, id("lcs", IdSpace::function, 0, "the same of the shears; 0: LCA")},
    {at(&HoneycombCards::curve, 3), curve_ab},
    {at(&HoneycombCards::curve, 4), curve_bc},
    {at(&HoneycombCards::curve, 5), curve_ca},
    {&HoneycombCards::lcsr, rate_curve},
};

const CardOf<HoneycombCards> own_curves_card{
    {at(&HoneycombCards::curve, 0),
     or_negative(
         id("lca", IdSpace::function, required,
            "curve: largest stress aa over the strain aa, compression positive; below 0, another yield surface: "
            "not built"),
         IdSpace::function)},
    {at(&HoneycombCards::curve, 1), curve_bb},
    {at(&HoneycombCards::curve, 2), curve_cc},
    {&HoneycombCards::lcs,
     id("lcs", IdSpace::function, 0, "the same of the shears, over gamma of either sign; 0: LCA")},
    {at(&HoneycombCards::curve, 3), curve_ab},
    {at(&HoneycombCards::curve, 4), curve_bc},
    {at(&HoneycombCards::curve, 5), curve_ca},
    {&HoneycombCards::lcsr,
     or_negative(id("lcsr", IdSpace::function, 0, "curve: factor on the largest stresses over the rate; -1: not built"),
                 IdSpace::function)},
};

const CardOf<HoneycombCards> core_card{
    {at(&Honeycomb::modulus, 0),
     real("eaau", dimension::stress, required, above_zero(), "modulus along a of the uncrushed core")},
    {at(&Honeycomb::modulus, 1), real("ebbu", dimension::stress, required, above_zero(), "the same along b")},
    {at(&Honeycomb::modulus, 2), real("eccu", dimension::stress, required, above_zero(), "the same along c")},
    {at(&Honeycomb::modulus, 3),
     real("gabu", dimension::stress, required, above_zero(), "shear modulus ab of the uncrushed core")},
    {at(&Honeycomb::modulus, 4), real("gbcu", dimension::stress, required, above_zero(), "the same of bc")},
    {at(&Honeycomb::modulus, 5), real("gcau", dimension::stress, required, above_zero(), "the same of ca")},
    {&AxesCards::aopt, aopt::option},
    aopt::macf,
};

const CardOf<HoneycombCards> honeycomb_point_card{
    aopt::xp, aopt::yp, aopt::zp, {&AxesCards::a1, aopt::a1}, {&AxesCards::a2, aopt::a2}, {&AxesCards::a3, aopt::a3},
};

const CardOf<HoneycombCards> own_point_card{
    aopt::xp,
    aopt::yp,
    aopt::zp,
    {&AxesCards::a1, aopt::a1},
    {&AxesCards::a2, aopt::a2},
    {&AxesCards::a3, aopt::a3},
    real("rfac", dimension::number, 0, only(0), "filter of the strain rate"),
    {&HoneycombCards::pru, integer("pru", 0, only(0), "Poisson effect before compaction")},
};

constexpr RealField tensile =
    real("tsef", dimension::number, 0, at_least(0), "strain along a, b or c that deletes; 0: none");
constexpr RealField shearing =
    real("ssef", dimension::number, 0, at_least(0), "gamma ab, bc or ca that deletes; 0: none");

const CardOf<HoneycombCards> honeycomb_vectors_card{
    {&AxesCards::d1, aopt::d1},       {&AxesCards::d2, aopt::d2},        {&AxesCards::d3, aopt::d3},
    {&HoneycombCards::tsef, tensile}, {&HoneycombCards::ssef, shearing}, {&AxesCards::v1, aopt::v1},
    {&AxesCards::v2, aopt::v2},       {&AxesCards::v3, aopt::v3},
};

const CardOf<HoneycombCards> own_vectors_card{
    {&AxesCards::d1, aopt::d1},
    {&AxesCards::d2, aopt::d2},
    {&AxesCards::d3, aopt::d3},
    {&HoneycombCards::tsef, tensile},
    {&HoneycombCards::ssef, shearing},
    real("vref", dimension::number, 0, only(0), "relative volume from which the element is a spring"),
    real("tref", dimension::time, 0, only(0), "step from which the element is a spring"),
    real("shdflg", dimension::number, 0, any_value, "damage of LCA below 0: no effect"),
};

const CardOf<HoneycombCards> cross_card{
    {&AxesCards::v1, aopt::v1},
    {&AxesCards::v2, aopt::v2},
    {&AxesCards::v3, aopt::v3},
};

/// The field that names the curve of component i: where it is 0, LCA stands for normal stresses, and LCS, then LCA, for
/// shears.
deck::Entry field_of_limit(const RowOf<HoneycombCards>& curves, std::size_t i) {
  if (curves->curve[i] != 0) return curves[at(&HoneycombCards::curve, i)];
  return i >= 3 && curves->lcs != 0 ? curves[&HoneycombCards::lcs] : curves[at(&HoneycombCards::curve, 0)];
}

/// A curve over the relative volume as one over 1 - V.
Curve over_strain(const Curve& over_volume) {
  Curve c = over_volume;
  std::reverse(c.x.begin(), c.x.end());
  std::reverse(c.y.begin(), c.y.end());
  for (double& x : c.x) x = 1.0 - x;
  return c;
}

/// The curve of MAT_026 in a field, over 1 - V; empty where it is refused.
Curve limit_over_volume(Builder& b, const deck::Entry& field, const Curve& curve, double compacted) {
  if (curve.x.front() <= 0.0) return curve;
  if (curve.x.front() < 1.0 && curve.x.back() >= 1.0) {
    if (curve.x.front() > compacted)
      field.report(b.findings, Severity::warning,
                   fmt::format("curve {} begins at the relative volume {:g}, but VF is {:g}: its first slope goes on",
                               curve.id, curve.x.front(), compacted),
                   "let it begin a little below VF");
    return over_strain(curve);
  }
  refuse(b, field,
         fmt::format("curve {} goes from {:g} to {:g}: neither over the relative volume, from below VF to 1, nor over "
                     "the volumetric strain, from 0 or below",
                     curve.id, curve.x.front(), curve.x.back()),
         "begin a curve over the volumetric strain 1 - V at 0; end one over the relative volume V at 1 or above");
  return {};
}

/// Whether a curve of a largest stress over strains can be used; warns of one steeper than the modulus it meets.
bool check_limit(Builder& b, const deck::Entry& field, const Curve& curve, const Honeycomb& law,
                 std::size_t component) {
  if (*std::min_element(curve.y.begin(), curve.y.end()) < 0.0) {
    refuse(b, field, fmt::format("curve {}: a largest stress is below 0", curve.id),
           "give magnitudes, positive in compression and in tension");
    return false;
  }
  const double end = 1.0 - law.compacted_volume;
  if (law.over == Honeycomb::Over::volume && curve.extrapolated(end) < 0.0) {
    refuse(
        b, field,
        fmt::format("curve {}: its last slope goes on to a stress below 0 before the material is compacted", curve.id),
        "let it reach to VF");
    return false;
  }
  const double dense = component < 3 ? law.E : law.E / (2.0 * (1.0 + law.nu));
  for (std::size_t k = 0; k + 1 < curve.x.size(); ++k) {
    if (curve.x[k] < 0.0 || curve.x[k] >= end) continue;
    const double slope = (curve.y[k + 1] - curve.y[k]) / (curve.x[k + 1] - curve.x[k]), beta = curve.x[k] / end;
    const double modulus = law.modulus[component] + beta * (dense - law.modulus[component]);
    if (law.over == Honeycomb::Over::volume && slope * (1.0 - curve.x[k]) > modulus) {
      field.report(b.findings, Severity::warning,
                   fmt::format("curve {} rises by {:g} behind {:g}, more than the modulus {:g} there: the stress lags "
                               "behind it",
                               curve.id, slope, curve.x[k], modulus),
                   "unloading must be steeper than the curve: raise the modulus of the core");
      break;
    }
  }
  return true;
}

/// The brick of formulation 0 has curves over engineering strains; of bending formulations the law makes no sense.
void check_honeycomb(Builder& b, const Part& part, const deck::RowOf<PartCard>& row) {
  Model& m = b.model;
  if (part.kind != ElementKind::solid || part.section == none) return;
  const auto section = at(part.section);
  if (m.solid_sections[section].elform < 0)
    refuse(b, row[&PartCard::secid],
           "honeycomb has no Poisson effect, which bricks of ELFORM -1 and -2 count on in bending",
           "write ELFORM 1 or 2");
  const auto* made = std::get_if<kernel::ComposedLaw>(&m.materials[part.material].law);
  if (made == nullptr) return;  // refused
  kernel::LawComponents law = *made->components;
  auto& flow = std::get<Honeycomb>(law.flow);
  if (flow.over == Honeycomb::Over::volume) return;
  // 0 is computed as 1 by now; the card still counts.
  const auto is_formulation_0 = [&](const Part& p) { return b.solid_section_rows[p.section]->elform == 0; };
  const bool engineering = is_formulation_0(part);
  for (const Part& other : m.parts)
    if (other.material == part.material && other.kind == ElementKind::solid && other.section != none &&
        is_formulation_0(other) != engineering)
      return refuse(b, row[&PartCard::mid],
                    "the material is in bricks of ELFORM 0, whose curves are over engineering strains, and in others, "
                    "whose curves are over logarithmic ones",
                    "give each its own material");
  if (!engineering || flow.over == Honeycomb::Over::engineering_strain) return;
  flow.over = Honeycomb::Over::engineering_strain;
  m.materials[part.material].law = kernel::composed_law(std::move(law));
}

/// `curves`: the second card.
void set_honeycomb(Builder& b, Index material, const HoneycombCards& cards, const RowOf<HoneycombCards>& curves) {
  Honeycomb flow = cards;
  const bool is_bulk = cards.bulk == 1;
  flow.viscosity = is_bulk ? 0.0 : cards.mu > 0.0 ? cards.mu : 0.05;
  flow.tensile_failure = failure_value(cards.tsef);
  flow.shear_failure = failure_value(cards.ssef);
  for (std::size_t i = 0; i < 6; ++i) {
    const deck::Entry field = field_of_limit(curves, i);
    const Index found = b.curve(field);
    if (found == none) return;
    const Curve& curve = b.model.curves[found];
    if (curve.empty()) return;  // reported where it is defined
    flow.limit[i] =
        flow.over == Honeycomb::Over::volume ? limit_over_volume(b, field, curve, flow.compacted_volume) : curve;
    if (flow.limit[i].empty() || !check_limit(b, field, flow.limit[i], flow, i)) return;
  }
  if (cards.lcsr != 0) {
    const Index found = b.curve(curves[&HoneycombCards::lcsr]);
    if (found == none) return;
    flow.rate_factor = b.model.curves[found];
  }
  kernel::LawComponents law{std::move(flow)};
  law.bulk_viscosity = is_bulk;
  b.model.materials[material].law = composed_law(std::move(law));
  b.part_checks[material] = check_honeycomb;
}

/// The rows of the cards that findings are about.
struct HoneycombRows {
  RowOf<HoneycombCards> dense, curves, core;
};

void add_honeycomb(Builder& b, const HoneycombCards& cards, const HoneycombRows& rows, std::string title,
                   std::string_view name) {
  const double vf = cards.compacted_volume;
  if (!(vf > 0.0 && vf < 1.0))
    refuse(b, rows.dense[&Honeycomb::compacted_volume],
           "the relative volume of the compacted material lies between 0 and 1", "e.g. 0.2");
  const Index material = add_material(b, rows.dense, std::move(title), name, kernel::Elastic{cards.E, cards.nu});
  if (!(vf > 0.0 && vf < 1.0)) return;
  b.defer(Phase::parts, [=, curves = rows.curves](Builder& later) { set_honeycomb(later, material, cards, curves); });
  take_axes_of_system(b, rows.core[&AxesCards::aopt], material);
}

void read_honeycomb(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  HoneycombCards cards;
  HoneycombRows rows;
  rows.dense = cursor.read(dense_card, cards);
  rows.curves = cursor.read(honeycomb_curves_card, cards);
  rows.core = cursor.read(core_card, cards);
  const auto point = cursor.read(honeycomb_point_card, cards);
  const auto vectors = cursor.read(honeycomb_vectors_card, cards);
  expect_end(b, cursor);
  cards.axes =
      material_axes(b, block, cards, rows.core[&AxesCards::aopt], point[&AxesCards::a1], vectors[&AxesCards::v1]);
  add_honeycomb(b, cards, rows, std::move(title), "MAT_HONEYCOMB");
}

void read_modified_honeycomb(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  HoneycombCards cards;
  HoneycombRows rows;
  rows.dense = cursor.read(dense_card, cards);
  rows.curves = cursor.read(own_curves_card, cards);
  rows.core = cursor.read(core_card, cards);
  const auto point = cursor.read(own_point_card, cards);
  cursor.read(own_vectors_card, cards);
  cards.over = Honeycomb::Over::strain;
  if (cards.curve[0] < 0)
    return refuse(b, rows.curves[at(&HoneycombCards::curve, 0)],
                  "LCA below 0, a yield surface by the angle off the strong axis, is not built",
                  "give six curves over the strains (LCA to LCCA), or use *MAT_HONEYCOMB");
  if (cards.lcsr < 0)
    return refuse(b, rows.curves[&HoneycombCards::lcsr], "rates of each direction by itself (LCSR -1) are not built",
                  "give one curve over the norm of the deviatoric rate");
  if (cards.pru != 0) return;  // refused; further cards would follow
  deck::Entry v1;
  if (cards.aopt == 3.0 || cards.aopt == 4.0) v1 = cursor.read(cross_card, cards)[&AxesCards::v1];
  expect_end(b, cursor);
  cards.axes = material_axes(b, block, cards, rows.core[&AxesCards::aopt], point[&AxesCards::a1], v1);
  add_honeycomb(b, cards, rows, std::move(title), "MAT_MODIFIED_HONEYCOMB");
}

}  // namespace

std::vector<Keyword> honeycomb_material_keywords() {
  return {{.name = "MAT_HONEYCOMB",
           .aliases = {"MAT_026"},
           .options = {"TITLE"},
           .layout = {{"", &dense_card},
                      {"", &honeycomb_curves_card},
                      {"", &core_card},
                      {"", &honeycomb_point_card},
                      {"", &honeycomb_vectors_card}},
           .read = read_honeycomb},
          {.name = "MAT_MODIFIED_HONEYCOMB",
           .aliases = {"MAT_126"},
           .options = {"TITLE"},
           .layout = {{"", &dense_card},
                      {"", &own_curves_card},
                      {"", &core_card},
                      {"", &own_point_card},
                      {"", &own_vectors_card},
                      {"AOPT 3", &cross_card}},
           .read = read_modified_honeycomb}};
}

}  // namespace nugget::reading
