// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_SIMPLIFIED_RUBBER/FOAM (181): rubber by one test curve.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

struct TestCards : MaterialCard {
  int lcunld = 0;
  double km = 0, mu = 0, g = 0, sigf = 0, sgl = 0, sw = 0, st = 0, hu = 1, shape = 1;
  int lcid = 0;
};
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
     or_negative(id("lc/tbid", IdSpace::function, required,
                    "curve: force over the change of length, pulled positive; with SGL, SW and ST of 1 nominal stress "
                    "over nominal strain"),
                 IdSpace::function)},
    real("tension", dimension::number, -1, any_value, "of strain rates: no effect with one curve"),
    real("rtype", dimension::number, 0, any_value, "of strain rates: no effect with one curve"),
    real("avgopt", dimension::number, 0, any_value, "of strain rates: no effect with one curve"),
    real("pr/beta", dimension::number, 0, only(0), "0: rubber; above 0 foam with this Poisson's ratio: not built"),
};
const CardOf<TestCards> unloading_card{
    {&TestCards::lcunld, id("lcunld", IdSpace::function, 0, "curve of unloading: not built")},
    {&TestCards::hu, real("hu", dimension::number, 1, between(0, 1),
                          "share of the deviatoric stress that unloading keeps in the end: 1, all")},
    {&TestCards::shape, real("shape", dimension::number, 1, above_zero(),
                             "power of the share of the energy by which unloading goes there")},
    real("stol", dimension::number, 0, any_value, "tolerance of a check of the curve: no effect"),
    real("visco", dimension::number, 0, only(0), "viscous terms: not built"),
    real("hisout", dimension::number, 0, any_value, "of extra history variables: no effect"),
};

/// False (and a finding) where the curve is no test of a rubber.
bool check_test(Builder& b, const deck::Entry& lcid, const Curve& test) {
  const auto refuse_curve = [&](std::string_view text, std::string_view remedy) {
    refuse(b, lcid, fmt::format("curve {}: {}", test.id, text), remedy);
    return false;
  };
  if (test.x.size() < 2) return refuse_curve("one point is no test", "give at least two");
  if (test.x.front() <= -1.0)
    return refuse_curve("a nominal strain of -1 leaves no length", "end the curve before the specimen is gone");
  if (test.x.back() <= 0.0) return refuse_curve("it has no tension", "give forces of tension at positive strains");
  for (std::size_t i = 0; i + 1 < test.x.size(); ++i)
    if (!((1.0 + test.x[i + 1]) * test.y[i + 1] > (1.0 + test.x[i]) * test.y[i]))
      return refuse_curve(fmt::format("the true stress falls after the strain {:g}", test.x[i]),
                          "give a curve of which force times length rises everywhere");
  const double at_rest = test.x.front() > 0.0 ? test.y.front() : test.extrapolated(0.0);
  if (std::abs(at_rest) > 1e-6 * std::max(std::abs(test.y.front()), std::abs(test.y.back())))
    return refuse_curve("it does not go through 0, 0", "let the stress be 0 without strain");
  if (test.x.front() >= 0.0)
    lcid.report(b.findings, Severity::warning,
                fmt::format("curve {} has no compression, which the energy needs for every lateral stretch: its first "
                            "slope, {:.4g}, goes on below 0",
                            test.id, test.slope(test.x.front())),
                "give the test below 0 too, as far as the square root of 1 over the greatest stretch");
  return true;
}

void set_simplified_rubber(Builder& b, Index material, const TestCards& cards, const deck::Entry& km,
                           const deck::Entry& lcid) {
  const Index found = b.curve(lcid);
  if (found == none) return;
  kernel::TabulatedRubber flow;
  flow.test = b.model.curves[found];
  for (double& x : flow.test.x) x /= cards.sgl;
  for (double& y : flow.test.y) y /= cards.sw * cards.st;
  if (!check_test(b, lcid, flow.test)) return;
  const double shear = flow.test.slope(0.0) / 3.0;
  flow.bulk = cards.km;
  flow.nu = (3.0 * cards.km - 2.0 * shear) / (2.0 * (3.0 * cards.km + shear));
  flow.E = 2.0 * shear * (1.0 + flow.nu);
  if (!(flow.nu > 0.0))
    return refuse(b, km,
                  fmt::format("the bulk modulus is below two thirds of the shear modulus of the test, {:.4g}", shear),
                  "give some hundred times the shear modulus");
  flow.damping = cards.mu;
  flow.kept = cards.hu;
  flow.shape = cards.shape;
  if (cards.g > 0.0 && cards.sigf > 0.0) {
    flow.overstress.friction_shear = cards.g;
    flow.overstress.friction_limit = cards.sigf;
  }
  b.model.materials[material].law = kernel::composed_law({flow});
}

void read_simplified_rubber(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  TestCards cards;
  const auto row = cursor.read(rubber_card, cards);
  const auto test = cursor.read(test_card, cards);
  if (!at_end(cursor)) {
    const auto unloading = cursor.read(unloading_card, cards);
    refuse_nonzero(b, unloading[&TestCards::lcunld], "unloading by a curve of its own is not built",
                   "leave it 0: the rubber unloads as it loads");
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
    if (later.tables.find(cards.lcid) != none)
      return refuse(later, lcid, "a table of curves over the strain rate is not built", "give the curve of one rate");
    set_simplified_rubber(later, material, cards, km, lcid);
  });
}

}  // namespace

std::vector<Keyword> simplified_rubber_keywords() {
  return {
      {.name = "MAT_SIMPLIFIED_RUBBER/FOAM",
       .aliases = {"MAT_181", "MAT_SIMPLIFIED_RUBBER"},
       .options = {"TITLE"},
       .layout = {{"", &rubber_card}, {"", &test_card}, {"may be left out", &unloading_card}},
       .read = read_simplified_rubber},
  };
}

}  // namespace nugget::reading
