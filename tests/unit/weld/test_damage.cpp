// SPDX-License-Identifier: Apache-2.0
// Damage of a weld as a whole, and what *DEFINE_CONNECTION_PROPERTIES says of one, by given loads
// (docs/theory/failure.md#damage-of-the-whole-weld and docs/theory/failure.md#connections).
#include "weld/failure/damage.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "assembly.hpp"
#include "weld/failure/connection.hpp"
#include "weld/failure/function.hpp"

namespace nugget::weld {
namespace {

using State = Damage::State;

model::WeldDamage option(int dmgopt, double rupture = 0.3) {
  model::WeldDamage d;
  d.option = dmgopt;
  d.rupture = rupture;
  return d;
}
Damage::WeldState seen(double value, double strain = 0.0, double time = 0.0) {
  Damage::WeldState s;
  s.value = value;
  s.at_surface = value >= 1.0;
  s.plastic_strain = strain;
  s.time = time;
  return s;
}

TEST(WeldDamage, WithoutALawTheWeldIsGoneAtTheSurface) {
  Damage damage{damage_law(option(0))};
  EXPECT_EQ(damage.update(seen(0.999)), State::intact);
  EXPECT_EQ(damage.update(seen(1.0)), State::failed);
}

TEST(WeldDamage, GrowsOverThePlasticStrainFromTheOnsetOn) {
  Damage damage{damage_law(option(10))};
  EXPECT_EQ(damage.update(seen(0.9, 0.1)), State::intact);
  EXPECT_EQ(damage.update(seen(1.0, 0.1)), State::damaged);
  EXPECT_DOUBLE_EQ(damage.integrity(), 1.0);
  damage.update(seen(0.7, 0.15));
  EXPECT_DOUBLE_EQ(damage.integrity(), 0.75);
  damage.update(seen(0.7, 0.15, 1.0));
  EXPECT_DOUBLE_EQ(damage.integrity(), 0.75);
  EXPECT_EQ(damage.update(seen(0.1, 0.3)), State::failed);
}

TEST(WeldDamage, BeginsByEfailToo) {
  model::WeldDamage d = option(10);
  d.failure_strain = 0.2;
  Damage damage{damage_law(d)};
  EXPECT_EQ(damage.update(seen(0.5, 0.2)), State::intact);
  EXPECT_EQ(damage.update(seen(0.5, 0.2001)), State::damaged);
}

TEST(WeldDamage, GrowsOverTimeAndDecaysWithBeta) {
  model::WeldDamage d = option(12, 4.0);
  d.beta = 2.0;
  Damage damage{damage_law(d)};
  damage.update(seen(1.2, 0.0, 10.0));
  damage.update(seen(0.0, 0.0, 11.0));
  EXPECT_DOUBLE_EQ(damage.damage(), 0.25);
  EXPECT_DOUBLE_EQ(damage.integrity(), std::exp(-0.5));
  EXPECT_EQ(damage.update(seen(0.0, 0.0, 14.0)), State::failed);
  EXPECT_TRUE(damage.law().freezes_yield);
}

TEST(WeldDamage, ShearBeyondFmodeFailsAtOnce) {
  model::WeldDamage d = option(10);
  d.mode = 0.8;
  Damage pulled{damage_law(d)}, sheared{damage_law(d)};
  Damage::WeldState s = seen(1.0);
  s.sliding = 0.63;  // sqrt 0.7937
  EXPECT_EQ(pulled.update(s), State::damaged);
  s.sliding = 0.65;  // sqrt 0.806
  EXPECT_EQ(sheared.update(s), State::failed);
}

TEST(WeldDamage, FfcapEndsADamagedWeld) {
  model::WeldDamage d = option(10);
  d.cap = 1.5;
  Damage damage{damage_law(d)};
  EXPECT_EQ(damage.update(seen(1.6)), State::damaged);  // the onset itself
  EXPECT_EQ(damage.update(seen(1.4)), State::damaged);
  EXPECT_EQ(damage.update(seen(1.5)), State::failed);
}

/// A spring of stiffness k beyond a load of 1000, stretched on: the load fades linearly and the work is GFAD.
TEST(WeldDamage, FadingEnergyIsDissipated) {
  model::ConnectionProperties properties;
  properties.damage_type = 3;
  properties.standard.fading_energy = 50.0;
  Damage damage{damage_law(properties, properties.standard, {})};
  const double onset = 1000.0, k = 1e5, du = 1e-5, u_max = 2.0 * 50.0 / onset;
  double force = onset, work = 0.0, u = 0.0;
  Damage::WeldState s = seen(1.0);
  s.load = 1.0;
  ASSERT_EQ(damage.update(s), State::damaged);
  while (u < 0.2) {
    u += du;
    const double next = damage.integrity() * (onset + k * u);
    work += 0.5 * (force + next) * du;
    force = next;
    s = seen(force / onset);
    s.load = (onset + k * u) / onset;
    s.energy = work;
    if (damage.update(s) == State::failed) break;
    if (u < 0.95 * u_max) {
      ASSERT_NEAR(force, onset * (1.0 - u / u_max), 0.01 * onset) << u;
    }
  }
  EXPECT_NEAR(u, u_max, 0.03 * u_max);
  EXPECT_NEAR(work, 50.0, 0.1);
}

TEST(WeldDamage, LoadStaysOnTheSurface) {
  model::ConnectionProperties properties;
  properties.damage_type = 2;
  Damage damage{damage_law(properties, properties.standard, option(0, 0.3))};
  Damage::WeldState s = seen(1.0);
  s.load = 1.0;
  damage.update(s);
  s.load = 1.25;
  damage.update(s);
  EXPECT_DOUBLE_EQ(damage.integrity(), 0.8);
  s.load = 1.1;
  damage.update(s);
  EXPECT_DOUBLE_EQ(damage.integrity(), 0.8);  // it does not heal
  s.plastic_strain = 0.31;
  EXPECT_EQ(damage.update(s), State::failed);
}

// ---- connections

TEST(Connection, TheLowerRankCounts) {
  model::ConnectionProperties p;
  p.standard.rank = 5.0;
  p.records = {{}, {}};
  p.records[0].material = 3;
  p.records[0].rank = 2.0;
  p.records[1].material = 4;
  p.records[1].rank = 9.0;
  EXPECT_EQ(&connection_record(p, {3, 4}), &p.records[0]);
  EXPECT_EQ(&connection_record(p, {4, 3}), &p.records[0]);
  EXPECT_EQ(&connection_record(p, {4, 7}), &p.standard);  // 7 has no record
  EXPECT_EQ(&connection_record(p, {model::none, 3}), &p.records[0]);
}

// Sabotage: the record of the first sheet.
TEST(Connection, OfEqualRanksTheWeakerCounts) {
  model::ConnectionProperties p;
  p.records = {{}, {}};
  p.records[0].material = 3;
  p.records[1].material = 4;
  const auto weaker = [&](std::size_t i) {
    EXPECT_EQ(&connection_record(p, {3, 4}), &p.records[i]);
    EXPECT_EQ(&connection_record(p, {4, 3}), &p.records[i]);
  };
  p.records[0].normal.value = 200.0;
  p.records[1].normal.value = 300.0;
  weaker(0);
  p.records[1].shear.value = 100.0;  // that of the other is left out
  weaker(1);
  p.records[0].shear.value = 90.0;
  weaker(0);
}

// Layers with laws of their own and *DEFORMABLE_TO_RIGID give a part a material of its own, with the id of that of the
// deck, which is the one that the records name. Sabotage: the part's own material.
TEST(Connection, ARecordHoldsForTheSheetsWhoseMaterialItNames) {
  test::Assembly a;
  const model::Index sheet = a.sheet(1.0, {0, 0, 0}), other = a.sheet(1.0, {0, 0, 1});
  model::ConnectionProperties p;
  p.records = {{}};
  p.records[0].material = a.model.parts[sheet].material;
  p.records[0].rank = -1.0;
  p.records[0].yield = 410.0;
  p.standard.yield = 400.0;
  a.model.materials.push_back(a.model.materials[a.model.parts[sheet].material]);
  a.model.parts[sheet].material = static_cast<model::Index>(a.model.materials.size()) - 1;
  EXPECT_EQ(material_of_sheet(a.model, sheet), p.records[0].material);
  failure::Geometry weld = failure::disc(6.0);
  weld.sheet = {other, sheet};
  EXPECT_EQ(connection_record(a.model, p, weld).rank, -1.0);
  EXPECT_EQ(connection_record(a.model, p, weld).yield, 410.0);
  weld.sheet = {other, other};
  EXPECT_EQ(connection_record(a.model, p, weld).rank, 0.0);
  EXPECT_EQ(connection_record(a.model, p, weld).yield, 400.0);
}

/// A weld between a sheet of 1 that yields at 300 and one of 2 that yields at 500, both without hardening.
struct WeldedByFunctions {
  test::Assembly a;
  model::ConnectionProperties properties;
  failure::Geometry weld = failure::disc(6.0);
  Findings findings;

  WeldedByFunctions() {
    properties.functions = model::ConnectionProperties::Functions{};
    weld.thickness = {1.0, 2.0};
    for (std::size_t k = 0; k < 2; ++k) {
      weld.sheet[k] = a.sheet(weld.thickness[k], {0, 0, 1.5 * static_cast<double>(k)});
      kernel::PlasticKinematic law;
      law.E = 210000.0;
      law.nu = 0.3;
      law.yield = k == 0 ? 300.0 : 500.0;
      law.beta = 1.0;
      a.model.parts[weld.sheet[k]].material = static_cast<model::Index>(a.model.materials.size());
      a.model.materials.push_back({static_cast<int>(10 + k), "", "", 7.85e-9, law, {}});
    }
  }
  model::Index add(const std::string& value) {
    Formula::Fault fault;
    model::UserFunction function;
    function.id = 1 + static_cast<int>(a.model.functions.size());
    function.formula = Formula::read("f(t1,t2,sy1,sy2,sm1,sm2,r,a,e1,e2)=" + value, fault);
    EXPECT_FALSE(fault.any()) << fault.text;
    a.model.functions.push_back(std::move(function));
    return static_cast<model::Index>(a.model.functions.size()) - 1;
  }
  void check() { check_functions(a.model, properties, weld, {}, findings); }
};

// Without hardening a sheet necks when it begins to yield: at S exp(-S / E). What the program finds there is one step
// of plastic strain on.
TEST(Connection, FunctionsOfBothSheets) {
  WeldedByFunctions w;
  w.properties.functions->yield = w.add("0.5*(sy1+sy2)");
  w.properties.functions->normal = w.add("sm2*t2/t1*(1.0+0.01*r)");
  w.properties.functions->shear = w.add("sm1+sm2");
  w.properties.functions->normal_exponent = w.add("1.0+e1/e2");
  w.properties.functions->fading_energy = w.add("a*t1");
  w.properties.standard.torsion_factor = 0.5;
  const ConnectionRecord record = connection_record(w.a.model, w.properties, w.weld);
  EXPECT_NEAR(record.yield, 400.0, 1e-6);
  EXPECT_NEAR(record.normal.at(0.0), 1000.0 * std::exp(-500.0 / 210000.0), 1.0);
  EXPECT_NEAR(record.normal.at(20.0) / record.normal.at(0.0), 1.2, 1e-12);
  EXPECT_NEAR(record.shear.at(1e6), 800.0, 3.0);
  EXPECT_EQ(record.normal_exponent, 2.0);
  EXPECT_EQ(record.bending_exponent, 1.0);
  EXPECT_FALSE(record.bending.given());
  EXPECT_NEAR(record.fading_energy, 9.0 * std::numbers::pi, 1e-9);
  EXPECT_EQ(record.torsion_factor, 0.5);
  w.check();
  EXPECT_EQ(w.findings.errors(), 0);
  ASSERT_EQ(w.findings.all().size(), 2u);  // a sheet's thickness at one place, and GFAD by that of the first
  EXPECT_NE(w.findings.all()[0].text.find("SN by function 2"), std::string::npos) << w.findings.all()[0].text;
}

TEST(Connection, FunctionsThatGiveNoNumber) {
  for (const auto& [value, said] : {std::pair{"log(t1-t2)", "it gives"}, {"-1.0", "it gives -1"}}) {
    WeldedByFunctions w;
    w.properties.functions->bending = w.add(value);
    w.check();
    EXPECT_EQ(w.findings.errors(), 1) << value;
    EXPECT_NE(w.findings.all()[0].text.find(said), std::string::npos) << w.findings.all()[0].text;
  }
  WeldedByFunctions w;
  w.a.model.materials.back().law = kernel::Elastic{210000.0, 0.3};
  w.properties.functions->yield = w.add("min(sy1,sy2)");
  w.properties.functions->bending = w.add("t1+t2");
  w.check();
  EXPECT_EQ(w.findings.errors(), 1);
  EXPECT_NE(w.findings.all()[0].text.find("one of which has none"), std::string::npos) << w.findings.all()[0].text;
}

TEST(Connection, Area) {
  EXPECT_DOUBLE_EQ(connection_area(0, 25.0, 1.0), 25.0);
  EXPECT_NEAR(connection_area(1, 25.0, 1.2), 19.635 * 1.2, 1e-3);
  EXPECT_NEAR(connection_area(-1, 25e-6, 1.2e-3), 19.635e-6 * 1.2, 1e-9);
  EXPECT_DOUBLE_EQ(connection_area(1, 25.0, 0.0), 25.0);
}

struct Connected {
  model::ConnectionProperties properties;
  failure::Geometry weld = failure::disc(6.0);
  double rate_filter = 0.0;
  std::unique_ptr<failure::Function> function;

  Connected() {
    properties.standard.normal.value = 400.0;
    properties.standard.bending.value = 500.0;
    properties.standard.shear.value = 300.0;
  }
  failure::Value at(const Resultants& r, double rate = 0.0) {
    if (!function) function = failure::connection_stress(properties, properties.standard, rate_filter, weld);
    failure::Load load;
    load.resultants = r;
    load.rate = rate;
    return (*function)(load);
  }
};
const double area = std::numbers::pi * 9.0, modulus = std::numbers::pi * 216.0 / 32.0;

TEST(Connection, EachTermIsOneAtItsStrength) {
  Connected c;
  EXPECT_NEAR(c.at({400.0 * area}).value, 1.0, 1e-12);
  EXPECT_EQ(c.at({-400.0 * area}).value, 0.0);
  EXPECT_NEAR(c.at({0, 0, 0, 0, 300.0 * modulus, -400.0 * modulus}).value, 1.0, 1e-12);
  EXPECT_NEAR(c.at({0, 180.0 * area, 240.0 * area}).value, 1.0, 1e-12);
  EXPECT_NEAR(c.at({0, 0, 0, -300.0 * 2.0 * modulus}).value, 1.0, 1e-12);
  EXPECT_NEAR(c.at({0, 150.0 * area, 0, 150.0 * 2.0 * modulus}).value, 1.0, 1e-12);
  EXPECT_NEAR(c.at({100.0 * area, 100.0 * area, 0, 0, 100.0 * modulus}).value, 0.25 + 0.2 + 1.0 / 3.0, 1e-12);
}

TEST(Connection, ExponentsAndTheLoadOverTheSurface) {
  Connected c;
  c.properties.standard.normal_exponent = 2.0;
  c.properties.standard.shear_exponent = 1.5;
  const Resultants r{300.0 * area, 200.0 * area, 0, 0, 100.0 * modulus};
  const failure::Value v = c.at(r);
  EXPECT_NEAR(v.value, std::pow(0.75, 2.0) + 0.2 + std::pow(2.0 / 3.0, 1.5), 1e-12);
  const double s = v.load;
  EXPECT_GT(s, 1.0);
  EXPECT_NEAR(c.at({r.axial / s, r.shear_s / s, 0, 0, r.moment_s / s}).value, 1.0, 1e-9);
  EXPECT_EQ(c.at({}).load, 0.0);
}

TEST(Connection, StrengthsOverTheStrainRate) {
  Connected c;
  c.properties.standard.normal.factor = {0, {0.0, 100.0, 1000.0}, {1.0, 1.2, 1.5}};
  const double factor[3][2] = {{0.0, 1.0}, {100.0, 1.2}, {550.0, 1.35}};
  for (const auto& [rate, f] : factor) EXPECT_NEAR(c.at({400.0 * area}, rate).value, 1.0 / f, 1e-12);
  Connected logarithmic;
  logarithmic.properties.standard.normal.factor = {0, {-4.0, 0.0, 4.0}, {1.0, 1.2, 1.6}};
  EXPECT_NEAR(logarithmic.at({400.0 * area}, std::exp(2.0)).value, 1.0 / 1.4, 1e-12);
  EXPECT_NEAR(logarithmic.at({400.0 * area}, 0.0).value, 1.0, 1e-12);
}

TEST(Connection, RateIsSmoothed) {
  Connected c;
  c.rate_filter = 0.75;
  EXPECT_DOUBLE_EQ(c.at({}, 100.0).rate, 25.0);
  EXPECT_DOUBLE_EQ(c.at({}, 100.0).rate, 43.75);
}

TEST(Connection, PointsYieldForTheRealArea) {
  kernel::Spotweld law;
  law.E = 210000.0;
  law.failure_strain = 0.2;
  ConnectionRecord record;
  record.yield = 400.0;
  record.tangent_modulus = 1000.0;
  const kernel::Spotweld own = connection_points(law, record, 30.0, 25.0);
  EXPECT_DOUBLE_EQ(own.yield, 480.0);
  EXPECT_NEAR(own.hardening, 1.2 * 210000.0 * 1000.0 / 209000.0, 1e-9);
  EXPECT_EQ(own.failure_strain, 0.0);
}

}  // namespace
}  // namespace nugget::weld
