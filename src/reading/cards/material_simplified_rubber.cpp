// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_SIMPLIFIED_RUBBER/FOAM (181): rubber and foam by test curves.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

using kernel::TabulatedRubber;

struct TestCards : MaterialCard {
  int lcunld = 0, lcid = 0;
  double km = 0, mu = 0, g = 0, sigf = 0, sgl = 0, sw = 0, st = 0, hu = 1, shape = 1;
  double tension = -1, rtype = 0, avgopt = 0, pr = 0, visco = 0;
};
/// The same field, of which a written 0 is a value of its own.
constexpr RealField with_zero(RealField f) {
  f.zero_is_default = false;
  return f;
}

const CardOf<TestCards> rubber_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&TestCards::km, real("km", dimension::stress, required, above_zero(), "bulk modulus")},
    {&TestCards::mu,
     real("mu", dimension::number, 0.1, between(0, 0.5), "viscous stress, as a share of critical damping")},
    {&TestCards::g, real("g", dimension::stress, 0, at_least(0), "shear modulus of frictional damping; 0: none")},
    {&TestCards::sigf,
     real("sigf", dimension::stress, 0, at_least(0), "greatest effective stress of frictional damping")},
    kernel::law_field::reference,
    real("prten", dimension::number, 0, only(0), "Poisson's ratio in tension, of foams"),
};
const CardOf<TestCards> test_card{
    {&TestCards::sgl, real("sgl", dimension::length, required, above_zero(), "length of the specimen")},
    {&TestCards::sw, real("sw", dimension::length, required, above_zero(), "width of the specimen")},
    {&TestCards::st, real("st", dimension::length, required, above_zero(), "thickness of the specimen")},
    {&TestCards::lcid,
     or_negative(
         id("lc/tbid", IdSpace::function, required,
            "curve, or a table of them over the strain rate: force over the change of length, pulled positive; with "
            "SGL, SW and ST of 1 nominal stress over nominal strain"),
         IdSpace::function)},
    {&TestCards::tension,
     with_zero(real("tension", dimension::number, -1, between(-1, 1),
                    "the rate counts -1: while the material is loaded; 0: while it is compressed further; 1: always"))},
    {&TestCards::rtype, real("rtype", dimension::number, 0, between(0, 1),
                             "rates of the table 0: over the length now, 1: over the length at first")},
    {&TestCards::avgopt,
     real("avgopt", dimension::time, 0, any_value, "rates are means, below 0 over this time, else over twelve steps")},
    {&TestCards::pr,
     real("pr/beta", dimension::number, 0, between(0, 0.49), "0: rubber; above 0: foam with this Poisson's ratio")},
};
const CardOf<TestCards> unloading_card{
    {&TestCards::lcunld,
     id("lcunld", IdSpace::function, 0, "curve of unloading, over the range of the (first) curve of loading")},
    {&TestCards::hu, real("hu", dimension::number, 1, between(0, 1),
                          "share of the stress (of rubber: its deviator) that unloading keeps in the end: 1, all")},
    {&TestCards::shape, real("shape", dimension::number, 1, above_zero(),
                             "power of the share of the energy by which unloading goes there")},
    real("stol", dimension::number, 0, any_value, "tolerance of a check of the curve: no effect"),
    {&TestCards::visco, real("visco", dimension::number, 0, between(0, 1),
                             "1: of solids, stresses that relax, a line each behind this card; of rubber only")},
    real("hisout", dimension::number, 0, any_value, "of extra history variables: no effect"),
};

/// A line for each stress that relaxes.
using RelaxingTerm = kernel::Overstress::MaxwellBranch;
const CardOf<RelaxingTerm> relaxing_term_card{
    {&RelaxingTerm::shear, real("gi", dimension::stress, 0, at_least(0), "shear modulus of a stress that relaxes")},
    {&RelaxingTerm::decay, real("betai", dimension::rate, 0, at_least(0), "its decay")},
    integer("vflag", 0, only(0), "form of the viscous stress: 0, added to that of the tests"),
};

/// The lines behind the third card, which count with VISCO 1.
std::vector<RelaxingTerm> read_relaxing_terms(Builder& b, Cursor& cursor, const TestCards& cards,
                                              const deck::Entry& visco) {
  constexpr std::size_t most_terms = 12;
  std::vector<RelaxingTerm> terms;
  while (cursor.more()) {
    const auto term = cursor.read(relaxing_term_card);
    if (!(term->shear > 0.0)) continue;
    if (terms.size() == most_terms) {
      refuse(b, term[&RelaxingTerm::shear], "more than twelve viscous terms are not supported");
      break;
    }
    terms.push_back(*term);
  }
  if (cards.visco == 1.0 && terms.empty())
    visco.report(b.findings, Severity::warning, "there is no term that relaxes", "give GI and BETAI behind this card");
  if (cards.visco == 0.0 && !terms.empty()) {
    visco.report(b.findings, Severity::warning, "the terms behind this card are not obeyed", "write VISCO 1");
    terms.clear();
  }
  if (cards.visco != 0.0 && cards.visco != 1.0) refuse(b, visco, "expected 0 or 1");
  if (!terms.empty() && cards.pr > 0.0)
    refuse(b, visco, "stresses that relax are built for rubber, PR/BETA 0",
           "leave out VISCO, or use *MAT_FU_CHANG_FOAM");
  return terms;
}

/// VISCO has no effect in shells: a material that only shells have loses its terms.
void check_relaxing_part(Builder& b, const Part& part, const deck::Entry& visco) {
  auto* composed = std::get_if<kernel::ComposedLaw>(&b.model.materials[part.material].law);
  if (part.kind != ElementKind::shell || composed == nullptr) return;
  const auto* flow = std::get_if<TabulatedRubber>(&composed->components->flow);
  if (flow == nullptr || flow->overstress.maxwell_branches.empty()) return;
  for (const Part& other : b.model.parts)
    if (other.material == part.material && other.kind != ElementKind::shell)
      return refuse(
          b, visco,
          fmt::format("parts {} and {} share the material, and VISCO has no effect in shells", part.id, other.id),
          "give the shells a material of their own, without VISCO");
  visco.report(b.findings, Severity::warning, "not obeyed: VISCO has no effect in shells", "write VISCO 0");
  kernel::LawComponents made = *composed->components;
  std::get<TabulatedRubber>(made.flow).overstress.maxwell_branches.clear();
  *composed = kernel::composed_law(std::move(made));
}

/// A test as nominal stress over nominal strain.
Curve nominal(const TestCards& cards, Curve test) {
  for (double& x : test.x) x /= cards.sgl;
  for (double& y : test.y) y /= cards.sw * cards.st;
  return test;
}

/// False (and a finding) where the curve is no test.
bool check_test(Builder& b, const deck::Entry& field, const Curve& test, bool foam) {
  const auto refuse_curve = [&](std::string_view text, std::string_view remedy) {
    refuse(b, field, fmt::format("curve {}: {}", test.id, text), remedy);
    return false;
  };
  if (test.x.size() < 2) return refuse_curve("one point is no test", "give at least two");
  if (test.x.front() <= -1.0)
    return refuse_curve("a nominal strain of -1 leaves no length", "end the curve before the specimen is gone");
  if (test.x.back() <= 0.0) return refuse_curve("it has no tension", "give forces of tension at positive strains");
  for (std::size_t i = 0; i + 1 < test.x.size(); ++i) {
    if (foam && !(test.y[i + 1] > test.y[i]))
      return refuse_curve(fmt::format("the force does not rise after the strain {:g}", test.x[i]),
                          "give a curve that rises everywhere");
    if (!foam && !((1.0 + test.x[i + 1]) * test.y[i + 1] > (1.0 + test.x[i]) * test.y[i]))
      return refuse_curve(fmt::format("the true stress falls after the strain {:g}", test.x[i]),
                          "give a curve of which force times length rises everywhere");
  }
  const double at_rest = test.x.front() > 0.0 ? test.y.front() : test.extrapolated(0.0);
  if (std::abs(at_rest) > 1e-6 * std::max(std::abs(test.y.front()), std::abs(test.y.back())))
    return refuse_curve("it does not go through 0, 0", "let the stress be 0 without strain");
  if (test.x.front() >= 0.0)
    field.report(b.findings, Severity::warning,
                 fmt::format("curve {} has no compression, which the energy needs for every lateral stretch: its first "
                             "slope, {:.4g}, goes on below 0",
                             test.id, test.slope(test.x.front())),
                 "give the test below 0 too, as far as the square root of 1 over the greatest stretch");
  return true;
}

/// The tests of LC/TBID by their rates; false where it is refused.
bool set_tests(Builder& b, const TestCards& cards, const deck::Entry& field, TabulatedRubber& flow) {
  const Index found = b.tables.find(cards.lcid);
  if (found == none) {
    const Index curve = b.curve(field);
    if (curve == none) return false;
    flow.tests = {nominal(cards, b.model.curves[curve])};
    flow.rates = {0.0};
  } else {
    const Table& table = b.model.tables[found];
    if (table.curve.size() != table.value.size() || table.value.empty()) return false;  // reported where it is defined
    for (const Index one : table.curve) flow.tests.push_back(nominal(cards, b.model.curves[one]));
    flow.rates = table.value;
    if (flow.rates.front() < 0.0) {
      refuse(b, field, "a rate of the table is below 0", "give the rates themselves, not their logarithms");
      return false;
    }
  }
  return std::all_of(flow.tests.begin(), flow.tests.end(),
                     [&](const Curve& test) { return check_test(b, field, test, flow.is_foam()); });
}

/// LCUNLD, a test back from the ends of the first one; nothing where it is refused.
Curve unloading_curve(Builder& b, const TestCards& cards, const deck::Entry& lcunld, const Curve& loading) {
  const Index found = b.curve(lcunld);
  if (found == none) return {};
  const Curve back = nominal(cards, b.model.curves[found]);
  const auto refuse_curve = [&](std::string_view text, std::string_view remedy) {
    refuse(b, lcunld, fmt::format("curve {}: {}", back.id, text), remedy);
    return Curve{};
  };
  const double length = loading.x.back() - loading.x.front(), height = loading.y.back() - loading.y.front();
  const auto apart = [&](double x, double x0, double y, double y0) {
    return std::abs(x - x0) > 1e-3 * length || std::abs(y - y0) > 1e-3 * height;
  };
  if (back.x.size() < 2 || apart(back.x.front(), loading.x.front(), back.y.front(), loading.y.front()) ||
      apart(back.x.back(), loading.x.back(), back.y.back(), loading.y.back()))
    return refuse_curve(fmt::format("its ends are not those of curve {}", loading.id),
                        "let loading and unloading begin and end at the same points: together they are a cycle");
  const auto over = [&](double x) {
    const double up = loading.extrapolated(x), down = back.extrapolated(x);
    return x * down < -1e-9 * length * height || std::abs(down) > std::abs(up) + 1e-3 * height;
  };
  for (const Curve* one : {&loading, &back})
    for (const double x : one->x)
      if (over(x))
        return refuse_curve(fmt::format("at the strain {:g} it is not between 0 and curve {}", x, loading.id),
                            "let unloading lie below loading, on the same side of 0");
  return back;
}

void set_friction(const TestCards& cards, TabulatedRubber& flow) {
  if (!(cards.g > 0.0 && cards.sigf > 0.0)) return;
  flow.overstress.friction_shear = cards.g;
  flow.overstress.friction_limit = cards.sigf;
}

void set_simplified_rubber(Builder& b, Index material, const TestCards& cards, const deck::Entry& km,
                           const deck::Entry& lcid, const deck::Entry& lcunld,
                           const std::vector<RelaxingTerm>& relaxing) {
  TabulatedRubber flow;
  if (cards.pr > 0.0) flow.contraction = cards.pr;
  if (!set_tests(b, cards, lcid, flow)) return;
  const double slope = flow.tests.front().slope(0.0);
  flow.bulk = cards.km;
  if (flow.is_foam()) {
    flow.E = slope;
    flow.nu = cards.pr;
  } else {
    const double shear = slope / 3.0;
    flow.nu = (3.0 * cards.km - 2.0 * shear) / (2.0 * (3.0 * cards.km + shear));
    flow.E = 2.0 * shear * (1.0 + flow.nu);
    if (!(flow.nu > 0.0))
      return refuse(b, km,
                    fmt::format("the bulk modulus is below two thirds of the shear modulus of the test, {:.4g}", shear),
                    "give some hundred times the shear modulus");
  }
  flow.damping = cards.mu;
  flow.kept = cards.hu;
  flow.shape = cards.shape;
  flow.rate_counts = static_cast<TabulatedRubber::RateCounts>(static_cast<int>(cards.tension));
  flow.engineering_rate = cards.rtype == 1.0;
  flow.window = std::max(-cards.avgopt, 0.0);
  set_friction(cards, flow);
  flow.overstress.maxwell_branches = relaxing;
  if (cards.lcunld != 0) {
    flow.unloading = unloading_curve(b, cards, lcunld, flow.tests.front());
    if (flow.unloading.empty()) return;
  }
  b.model.materials[material].law = kernel::composed_law({flow});
}

void read_simplified_rubber(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  TestCards cards;
  const auto row = cursor.read(rubber_card, cards);
  const auto test = cursor.read(test_card, cards);
  deck::Entry lcunld, visco;
  std::vector<RelaxingTerm> relaxing;
  if (!at_end(cursor)) {
    const auto third = cursor.read(unloading_card, cards);
    lcunld = third[&TestCards::lcunld];
    visco = third[&TestCards::visco];
    relaxing = read_relaxing_terms(b, cursor, cards, visco);
  }
  expect_end(b, cursor);
  if (cards.lcid < 0) return refuse(b, test[&TestCards::lcid], "a table of damage is not built", "give one curve");
  if ((cards.g > 0.0) != (cards.sigf > 0.0))
    row[cards.g > 0.0 ? &TestCards::sigf : &TestCards::g].report(
        b.findings, Severity::warning, "frictional damping needs both G and SIGF: there is none",
        "give both, or neither");
  const Index material =
      add_material(b, row, std::move(title), "MAT_SIMPLIFIED_RUBBER/FOAM", kernel::Elastic{1.0, 0.49});
  b.defer(Phase::parts, [=, km = row[&TestCards::km], lcid = test[&TestCards::lcid]](Builder& later) {
    set_simplified_rubber(later, material, cards, km, lcid, lcunld, relaxing);
  });
  if (!relaxing.empty())
    b.part_checks[material] = [visco](Builder& later, const Part& part, const auto&) {
      check_relaxing_part(later, part, visco);
    };
}

}  // namespace

std::vector<Keyword> simplified_rubber_keywords() {
  return {
      {.name = "MAT_SIMPLIFIED_RUBBER/FOAM",
       .aliases = {"MAT_181", "MAT_SIMPLIFIED_RUBBER"},
       .options = {"TITLE"},
       .layout = {{"", &rubber_card},
                  {"", &test_card},
                  {"may be left out", &unloading_card},
                  {"with VISCO 1, up to twelve", &relaxing_term_card}},
       .read = read_simplified_rubber},
  };
}

}  // namespace nugget::reading
