// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_HONEYCOMB and *MAT_MODIFIED_HONEYCOMB.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;
using kernel::Honeycomb;

const Card dense_card{{
    material_id,
    density,
    real("e", dimension::stress, required, above_zero(), "Young's modulus of the compacted material"),
    real("pr", dimension::number, 0, between(0, 0.49), "its Poisson's ratio"),
    real("sigy", dimension::stress, required, above_zero(), "its yield stress"),
    real("vf", dimension::number, required, between(0, 1), "relative volume at which it is compacted"),
    real("mu", dimension::number, 0.05, between(0, 1), "viscosity, as a share of critical damping; 0: 0.05"),
    integer("bulk", 0, between(0, 1), "0: viscosity MU; 1: bulk viscosity instead, by the compacted sound speed"),
}};

constexpr Field curve_bb = id("lcb", IdSpace::function, 0, "the same of bb; 0: LCA");
constexpr Field curve_cc = id("lcc", IdSpace::function, 0, "the same of cc; 0: LCA");
constexpr Field curve_ab = id("lcab", IdSpace::function, 0, "the same of ab; 0: LCS");
constexpr Field curve_bc = id("lcbc", IdSpace::function, 0, "the same of bc; 0: LCS");
constexpr Field curve_ca = id("lcca", IdSpace::function, 0, "the same of ca; 0: LCS");
constexpr Field rate_curve = id("lcsr", IdSpace::function, 0, "curve: factor on the largest stresses over the rate");

const Card curves_card{{
    id("lca", IdSpace::function, required,
       "curve: largest stress aa over relative volume (begins above 0) or volumetric strain (at or below 0)"),
    curve_bb,
    curve_cc,
    id("lcs", IdSpace::function, 0, "the same of the shears; 0: LCA"),
    curve_ab,
    curve_bc,
    curve_ca,
    rate_curve,
}};

const Card own_curves_card{{
    or_negative(id("lca", IdSpace::function, required,
                   "curve: largest stress aa over the strain aa, compression positive; below 0, another yield surface: "
                   "not built"),
                IdSpace::function),
    curve_bb,
    curve_cc,
    id("lcs", IdSpace::function, 0, "the same of the shears, over gamma of either sign; 0: LCA"),
    curve_ab,
    curve_bc,
    curve_ca,
    or_negative(id("lcsr", IdSpace::function, 0, "curve: factor on the largest stresses over the rate; -1: not built"),
                IdSpace::function),
}};

const Card core_card{{
    real("eaau", dimension::stress, required, above_zero(), "modulus along a of the uncrushed core"),
    real("ebbu", dimension::stress, required, above_zero(), "the same along b"),
    real("eccu", dimension::stress, required, above_zero(), "the same along c"),
    real("gabu", dimension::stress, required, above_zero(), "shear modulus ab of the uncrushed core"),
    real("gbcu", dimension::stress, required, above_zero(), "the same of bc"),
    real("gcau", dimension::stress, required, above_zero(), "the same of ca"),
    aopt::option,
    aopt::macf,
}};

const Card point_card{{
    aopt::xp,
    aopt::yp,
    aopt::zp,
    aopt::a1,
    aopt::a2,
    aopt::a3,
}};

const Card own_point_card{{
    aopt::xp,
    aopt::yp,
    aopt::zp,
    aopt::a1,
    aopt::a2,
    aopt::a3,
    real("rfac", dimension::number, 0, only(0), "filter of the strain rate"),
    integer("pru", 0, only(0), "Poisson effect before compaction"),
}};

constexpr Field tensile =
    real("tsef", dimension::number, 0, at_least(0), "strain along a, b or c that deletes; 0: none");
constexpr Field shearing = real("ssef", dimension::number, 0, at_least(0), "gamma ab, bc or ca that deletes; 0: none");

const Card vectors_card{{
    aopt::d1,
    aopt::d2,
    aopt::d3,
    tensile,
    shearing,
    aopt::v1,
    aopt::v2,
    aopt::v3,
}};

const Card own_vectors_card{{
    aopt::d1,
    aopt::d2,
    aopt::d3,
    tensile,
    shearing,
    real("vref", dimension::number, 0, only(0), "relative volume from which the element is a spring"),
    real("tref", dimension::time, 0, only(0), "step from which the element is a spring"),
    real("shdflg", dimension::number, 0, any_value, "damage of LCA below 0: no effect"),
}};

const Card cross_card{{
    aopt::v1,
    aopt::v2,
    aopt::v3,
}};

constexpr std::string_view limit_fields[] = {"lca", "lcb", "lcc", "lcab", "lcbc", "lcca"};
constexpr std::string_view modulus_fields[] = {"eaau", "ebbu", "eccu", "gabu", "gbcu", "gcau"};

/// The field that names the curve of component i: where it is 0, LCA stands for normal stresses, and LCS, then LCA, for
/// shears.
std::string_view field_of_limit(const Row& curves, std::size_t i) {
  if (curves.integer(limit_fields[i]) != 0) return limit_fields[i];
  return i >= 3 && curves.integer("lcs") != 0 ? "lcs" : "lca";
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
Curve limit_over_volume(Builder& b, const Row& row, std::string_view field, const Curve& curve, double compacted) {
  if (curve.x.front() <= 0.0) return curve;
  if (curve.x.front() < 1.0 && curve.x.back() >= 1.0) {
    if (curve.x.front() > compacted)
      row.report(b.findings, Severity::warning, field,
                 fmt::format("curve {} begins at the relative volume {:g}, but VF is {:g}: its first slope goes on",
                             curve.id, curve.x.front(), compacted),
                 "let it begin a little below VF");
    return over_strain(curve);
  }
  refuse(b, row, field,
         fmt::format("curve {} goes from {:g} to {:g}: neither over the relative volume, from below VF to 1, nor over "
                     "the volumetric strain, from 0 or below",
                     curve.id, curve.x.front(), curve.x.back()),
         "begin a curve over the volumetric strain 1 - V at 0; end one over the relative volume V at 1 or above");
  return {};
}

/// Whether a curve of a largest stress over strains can be used; warns of one steeper than the modulus it meets.
bool check_limit(Builder& b, const Row& row, std::string_view field, const Curve& curve, const Honeycomb& law,
                 std::size_t component) {
  if (*std::min_element(curve.y.begin(), curve.y.end()) < 0.0) {
    refuse(b, row, field, fmt::format("curve {}: a largest stress is below 0", curve.id),
           "give magnitudes, positive in compression and in tension");
    return false;
  }
  const double end = 1.0 - law.compacted_volume;
  if (law.over == Honeycomb::Over::volume && curve.extrapolated(end) < 0.0) {
    refuse(
        b, row, field,
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
      row.report(b.findings, Severity::warning, field,
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
  const auto section = static_cast<std::size_t>(part.section);
  if (m.solid_sections[section].elform < 0)
    refuse(b, row[&PartCard::secid], "honeycomb has no Poisson effect, which bricks of ELFORM -1 and -2 count on in bending",
           "write ELFORM 1 or 2");
  const auto* made = std::get_if<kernel::ComposedLaw>(&m.materials[static_cast<std::size_t>(part.material)].law);
  if (made == nullptr) return;  // refused
  kernel::LawComponents law = *made->components;
  auto& flow = std::get<Honeycomb>(law.flow);
  if (flow.over == Honeycomb::Over::volume) return;
  // 0 is computed as 1 by now; the card still counts.
  const auto is_formulation_0 = [&](const Part& p) {
    return b.solid_section_rows[static_cast<std::size_t>(p.section)]->elform == 0;
  };
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
  m.materials[static_cast<std::size_t>(part.material)].law = kernel::composed_law(std::move(law));
}

struct HoneycombCards {
  Row dense, curves, core, vectors;
  Honeycomb::Over over = Honeycomb::Over::volume;
  kernel::MaterialAxes axes;
};

void set_honeycomb(Builder& b, Index material, const HoneycombCards& cards) {
  Honeycomb flow;
  flow.E = cards.dense.real("e");
  flow.nu = cards.dense.real("pr");
  flow.yield = cards.dense.real("sigy");
  flow.compacted_volume = cards.dense.real("vf");
  flow.over = cards.over;
  flow.axes = cards.axes;
  for (std::size_t i = 0; i < 6; ++i) flow.modulus[i] = cards.core.real(modulus_fields[i]);
  const bool is_bulk = cards.dense.integer("bulk") == 1;
  flow.viscosity = is_bulk ? 0.0 : cards.dense.real("mu") > 0.0 ? cards.dense.real("mu") : 0.05;
  flow.tensile_failure = failure_value(cards.vectors.real("tsef"));
  flow.shear_failure = failure_value(cards.vectors.real("ssef"));
  for (std::size_t i = 0; i < 6; ++i) {
    const std::string_view field = field_of_limit(cards.curves, i);
    const Index found = b.curve(cards.curves, field);
    if (found == none) return;
    const Curve& curve = b.model.curves[static_cast<std::size_t>(found)];
    if (curve.empty()) return;  // reported where it is defined
    flow.limit[i] = flow.over == Honeycomb::Over::volume
                        ? limit_over_volume(b, cards.curves, field, curve, flow.compacted_volume)
                        : curve;
    if (flow.limit[i].empty() || !check_limit(b, cards.curves, field, flow.limit[i], flow, i)) return;
  }
  if (cards.curves.integer("lcsr") != 0) {
    const Index found = b.curve(cards.curves, "lcsr");
    if (found == none) return;
    flow.rate_factor = b.model.curves[static_cast<std::size_t>(found)];
  }
  kernel::LawComponents law{std::move(flow)};
  law.bulk_viscosity = is_bulk;
  b.model.materials[static_cast<std::size_t>(material)].law = composed_law(std::move(law));
  b.part_checks[material] = check_honeycomb;
}

void add_honeycomb(Builder& b, HoneycombCards cards, std::string title, std::string_view name) {
  const double vf = cards.dense.real("vf");
  if (!(vf > 0.0 && vf < 1.0))
    refuse(b, cards.dense, "vf", "the relative volume of the compacted material lies between 0 and 1", "e.g. 0.2");
  const Index material = add_material(b, cards.dense, std::move(title), name,
                                      kernel::Elastic{cards.dense.real("e"), cards.dense.real("pr")});
  if (!(vf > 0.0 && vf < 1.0)) return;
  b.defer(Phase::parts, [=](Builder& later) { set_honeycomb(later, material, cards); });
  take_axes_of_system(b, cards.core, material);
}

void read_honeycomb(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  HoneycombCards cards;
  cards.dense = cursor.read(dense_card);
  cards.curves = cursor.read(curves_card);
  cards.core = cursor.read(core_card);
  const Row point = cursor.read(point_card);
  cards.vectors = cursor.read(vectors_card);
  expect_end(b, cursor);
  cards.axes = read_axes(b, block, cards.core, point, cards.vectors, cards.vectors);
  add_honeycomb(b, std::move(cards), std::move(title), "MAT_HONEYCOMB");
}

void read_modified_honeycomb(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  HoneycombCards cards;
  cards.dense = cursor.read(dense_card);
  cards.curves = cursor.read(own_curves_card);
  cards.core = cursor.read(core_card);
  const Row point = cursor.read(own_point_card);
  cards.vectors = cursor.read(own_vectors_card);
  cards.over = Honeycomb::Over::strain;
  if (cards.curves.integer("lca") < 0)
    return refuse(b, cards.curves, "lca", "LCA below 0, a yield surface by the angle off the strong axis, is not built",
                  "give six curves over the strains (LCA to LCCA), or use *MAT_HONEYCOMB");
  if (cards.curves.integer("lcsr") < 0)
    return refuse(b, cards.curves, "lcsr", "rates of each direction by itself (LCSR -1) are not built",
                  "give one curve over the norm of the deviatoric rate");
  if (point.integer("pru") != 0) return;  // refused; further cards would follow
  const double aopt = cards.core.real("aopt");
  const Row v = aopt == 3.0 || aopt == 4.0 ? cursor.read(cross_card) : Row();
  expect_end(b, cursor);
  cards.axes = read_axes(b, block, cards.core, point, v, cards.vectors);
  add_honeycomb(b, std::move(cards), std::move(title), "MAT_MODIFIED_HONEYCOMB");
}

}  // namespace

std::vector<Keyword> honeycomb_material_keywords() {
  return {{.name = "MAT_HONEYCOMB",
           .aliases = {"MAT_026"},
           .options = {"TITLE"},
           .layout = {{"", &dense_card}, {"", &curves_card}, {"", &core_card}, {"", &point_card}, {"", &vectors_card}},
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
