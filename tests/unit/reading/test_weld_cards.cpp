// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/index.hpp"
#include "small_model.hpp"

// *MAT_SPOTWELD in all its forms, and the *DEFINE_ tables that belong to it.
namespace nugget::reading {
namespace {

using ::testing::ElementsAre;

Built built(const std::string& more) {
  return Built(small_deck(more));
}
/// The weld material is the third: small_deck has two.
const kernel::Spotweld& point(const Built& b) {
  return std::get<kernel::Spotweld>(b.model.materials.at(2).law);
}
const WeldLaw& weld(const Built& b) {
  return b.model.weld_laws.at(at(b.model.materials.at(2).weld));
}

const std::string first = "9,7.85e-9,210000.0,0.3,400.0,1000.0,1.0e-6,2.0\n";

TEST(WeldCards, Plain) {
  const auto b = built("*MAT_SPOTWELD\n" + first + "0.25,8000.0,6000.0,6000.0,20000.0,12000.0,13000.0,5\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_DOUBLE_EQ(point(b).yield, 400.0);
  EXPECT_DOUBLE_EQ(point(b).hardening, 1000.0);
  EXPECT_DOUBLE_EQ(point(b).mass_step, 1e-6);
  EXPECT_DOUBLE_EQ(point(b).failure_strain, 0.25);
  EXPECT_EQ(weld(b).option, 0);
  EXPECT_DOUBLE_EQ(weld(b).failure_time, 2.0);
  std::vector<double> strengths;
  for (const RateValue& s : weld(b).strength) strengths.push_back(s.value);
  EXPECT_THAT(strengths, ElementsAre(8000.0, 6000.0, 6000.0, 20000.0, 12000.0, 13000.0));
  EXPECT_EQ(weld(b).filter, 5);
  const auto blank = built("*MAT_100\n9,7.85e-9,210000.0,0.3,400.0,1000.0,,1.0e20\n\n");
  EXPECT_EQ(blank.findings.errors(), 0) << blank.all_findings();
  EXPECT_DOUBLE_EQ(weld(blank).failure_time, 0.0);
  EXPECT_FALSE(weld(blank).strength[0].given());
}

TEST(WeldCards, DamageFailureWithNothingButResultants) {
  const auto b = built("*MAT_SPOTWELD_DAMAGE-FAILURE_TITLE\nx\n" + first + ",8000.0\n,0,,0.3,1\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_DOUBLE_EQ(weld(b).strength[0].value, 8000.0);
  EXPECT_DOUBLE_EQ(weld(b).damage.true_thickness, 0.3);
  EXPECT_TRUE(weld(b).damage.whole);
}

TEST(WeldCards, RefusedFailureFunctionsSayWhy) {
  const auto with = [](const std::string& opt) {
    return built("*MAT_100_DAMAGE-FAILURE\n" + first + "\n," + opt + "\n");
  };
  for (const auto* opt : {"2", "12", "22"}) EXPECT_TRUE(with(opt).error("of the user's own", "fval")) << opt;
  for (const auto* opt : {"9", "-9"}) EXPECT_TRUE(with(opt).error("is not public", "opt")) << opt;
  EXPECT_TRUE(with("8").error("OPT 8 is not a failure function", "opt"));
  EXPECT_TRUE(built("*MAT_100_DAMAGE-FAILURE\n" + first + "\n,0,7\n").error("*DEFINE_FUNCTION", "fval"));
}

TEST(WeldCards, FunctionsOfTheUsersOwn) {
  const std::string function = "*DEFINE_FUNCTION\n7\nf(n,s)=n/800.0+s/600.0\n";
  for (const auto* opt : {"-2", "-1", "0", "2", "12", "22"}) {
    const auto b = built("*MAT_100_DAMAGE-FAILURE\n" + first + ",11,12,13,14,15,16,3\n," + opt + ",7\n" + function);
    EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
    ASSERT_EQ(weld(b).function, 0);
    EXPECT_EQ(weld(b).filter, 3);
    EXPECT_EQ(b.model.functions[0].formula(std::vector{80.0, 60.0}), 0.2);
    EXPECT_EQ(weld(b).user_values[5], weld(b).user() ? 16.0 : 0.0);
  }
  const auto more =
      built("*MAT_100_DAMAGE-FAILURE\n" + first + ",1,2,3,4,5,6\n,22,7\n7,8,9,10,11,12,13,14\n15,16\n" + function);
  EXPECT_EQ(more.findings.errors(), 0) << more.all_findings();
  EXPECT_EQ(weld(more).user_values[13], 14.0);
  EXPECT_EQ(weld(more).user_values[15], 16.0);
  EXPECT_TRUE(built("*MAT_100_DAMAGE-FAILURE\n" + first + "\n,2,7\n*DEFINE_FUNCTION\n7\nf()=1.0\n")
                  .error("has 0 arguments, expected 1 to 34", "fval"));
}

TEST(WeldCards, DamageOfTheWholeWeld) {
  const auto b = built("*MAT_100_DAMAGE-FAILURE\n" + first + "0.2,8000.0\n0.3,,,,,,,-1\n11,0.7,1.5\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_EQ(weld(b).damage.option, 11);
  EXPECT_DOUBLE_EQ(weld(b).damage.failure_strain, 0.2);
  EXPECT_DOUBLE_EQ(weld(b).damage.mode, 0.7);
  EXPECT_DOUBLE_EQ(weld(b).damage.cap, 1.5);
  EXPECT_EQ(point(b).failure_strain, 0.0);  // no point fails by itself
  EXPECT_EQ(point(b).damage.growth, kernel::PointDamage::Growth::none);
  EXPECT_TRUE(point(b).yield_can_be_frozen);
}

TEST(WeldCards, ConnectionOfAWeld) {
  const auto b = built(
      "*MAT_100_DA\n9,7.85e-9,210000.0,0.3\n0.1\n0.3,,,,4,0.9,0.05\n"
      "*DEFINE_CONNECTION_PROPERTIES\n4,,1,,3\n,400.0,1000.0,,1.0,400.0,500.0,300.0\n,,,,,,50.0\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_TRUE(weld(b).connection);
  EXPECT_EQ(weld(b).properties, 0);
  EXPECT_DOUBLE_EQ(weld(b).damage.failure_strain, 0.1);
  EXPECT_DOUBLE_EQ(weld(b).rate_filter, 0.9);
  EXPECT_DOUBLE_EQ(weld(b).jacobian_limit, 0.05);
  EXPECT_EQ(weld(built("*MAT_100_DA\n9,7.85e-9,210000.0,0.3\n\n,,,,-1\n")).properties, none);
}

TEST(WeldCards, YieldCurves) {
  const std::string curve = "*DEFINE_CURVE\n4\n0.0,400.0\n0.5,600.0\n";
  const auto b = built("*MAT_100\n9,7.85e-9,210000.0,0.3,-4\n\n" + curve);
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  ASSERT_EQ(point(b).yield_curves.size(), 1u);
  EXPECT_THAT(point(b).yield_curves[0].y, ElementsAre(400.0, 600.0));
  EXPECT_TRUE(point(b).rates.empty());
  const auto table = built("*MAT_100\n9,7.85e-9,210000.0,0.3,-5\n\n*DEFINE_TABLE\n5\n0.1\n100.0\n" + curve +
                           "*DEFINE_CURVE\n6\n0.0,500.0\n0.5,700.0\n");
  EXPECT_EQ(table.findings.errors(), 0) << table.all_findings();
  EXPECT_EQ(point(table).yield_curves.size(), 2u);
  EXPECT_THAT(point(table).rates, ElementsAre(0.1, 100.0));
  EXPECT_TRUE(built("*MAT_100\n9,7.85e-9,210000.0,0.3,-77\n\n").error("curve or table 77 is not defined", "sigy"));
  EXPECT_TRUE(built("*MAT_100\n9,7.85e-9,210000.0,0.3,-4\n\n*DEFINE_CURVE\n4\n0.0,0.0\n0.5,600.0\n")
                  .error("a yield stress that is not above 0", "sigy"));
}

TEST(WeldCards, UniaxialState) {
  const auto b = built("*MAT_100\n9,7.85e-9,-210000.0,0.3,400.0\n\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_TRUE(point(b).uniaxial);
  EXPECT_DOUBLE_EQ(point(b).E, 210000.0);
  EXPECT_TRUE(point(built("*MAT_100_DAMAGE-FAILURE_UNIAXIAL\n" + first + "\n\n")).uniaxial);
  EXPECT_FALSE(point(built("*MAT_100\n" + first + "\n")).uniaxial);
}

TEST(WeldCards, DamageOfPoints) {
  using Growth = kernel::PointDamage::Growth;
  const auto with = [](const std::string& failure) {
    return built("*MAT_100_DAMAGE-FAILURE\n" + first + "0.2\n" + failure);
  };
  const auto plain = with("0.3\n");
  EXPECT_EQ(plain.findings.errors(), 0) << plain.all_findings();
  EXPECT_EQ(point(plain).damage.growth, Growth::strain);
  EXPECT_DOUBLE_EQ(point(plain).damage.rupture, 0.3);
  EXPECT_DOUBLE_EQ(point(plain).failure_strain, 0.2);
  EXPECT_FALSE(point(plain).damage.freezes_yield);
  const auto in_time = with("1.0e-4,,,,,2.5,,-1\n2\n");  // DMGOPT on the card of its own
  EXPECT_EQ(in_time.findings.errors(), 0) << in_time.all_findings();
  EXPECT_EQ(point(in_time).damage.growth, Growth::time);
  EXPECT_DOUBLE_EQ(point(in_time).damage.beta, 2.5);
  EXPECT_TRUE(point(in_time).damage.freezes_yield);
  EXPECT_EQ(point(with("\n")).damage.growth, Growth::none);
  EXPECT_EQ(point(with("1.0e20\n")).damage.growth, Growth::none);
  EXPECT_TRUE(with("0.2\n").error("must be above EFAIL = 0.2", "rs"));
  EXPECT_TRUE(with("0.3,,,,,,,5\n").error("DMGOPT 5 is not", "dmgopt"));
  EXPECT_TRUE(with(",,,,,,,1\n").warning("without RS", "rs"));
  EXPECT_TRUE(with("0.3,,,,,,,-1\n1,0.5\n").warning("counts for DMGOPT 10", "fmode"));
  EXPECT_TRUE(with("0.3,,,,,,,-1\n").warning("the next card, which is to give DMGOPT, is missing", "dmgopt"));
}

TEST(WeldCards, TablesOfStrengths) {
  const auto b = built(
      "*DEFINE_SPOTWELD_RUPTURE_STRESS\n1,300.0,200.0\n2,310.0\n"
      "*DEFINE_SPOTWELD_FAILURE_RESULTANTS\n4,300.0,200.0,70\n1,2,310.0,210.0,,70\n"
      "*DEFINE_SPOTWELD_FAILURE_ADD\n6\n2,450.0,350.0\n"
      "*DEFINE_SPOTWELD_FAILURE\n6,1\n3,400.0,300.0,,0.5\n1,410.0,310.0\n"
      "*DEFINE_CURVE\n70\n0.0,1.0\n100.0,1.5\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  ASSERT_EQ(b.model.rupture_stresses.size(), 2u);
  EXPECT_EQ(b.model.rupture_stresses[1].part, 1);
  EXPECT_DOUBLE_EQ(b.model.rupture_stresses[0].shear, 200.0);
  ASSERT_EQ(b.model.pair_strengths.size(), 1u);
  const PairStrengths& pairs = b.model.pair_strengths[0];
  EXPECT_DOUBLE_EQ(pairs.standard.normal.at(50.0), 375.0);
  ASSERT_EQ(pairs.pairs.size(), 1u);
  EXPECT_THAT(pairs.pairs[0].parts, ElementsAre(0, 1));
  EXPECT_DOUBLE_EQ(pairs.pairs[0].normal.at(1e6), 310.0);
  EXPECT_DOUBLE_EQ(pairs.pairs[0].shear.at(1e6), 315.0);
  ASSERT_EQ(b.model.load_rate_strengths.size(), 1u);
  const LoadRateStrengths& rated = b.model.load_rate_strengths[0];
  EXPECT_EQ(rated.thickness_rule, 1);
  EXPECT_THAT(rated.dynamic, ElementsAre(1.183, 0.002963, 0.0458, 0.1));
  EXPECT_EQ(rated.averaged, 3);
  EXPECT_DOUBLE_EQ(rated.thickness_scale, 0.5);
  ASSERT_EQ(rated.entries.size(), 2u);
  EXPECT_EQ(rated.entries[1].material, 1);
  EXPECT_DOUBLE_EQ(rated.entries[1].shear, 350.0);
}

TEST(WeldCards, ConnectionProperties) {
  const auto b = built(
      "*DEFINE_CONNECTION_PROPERTIES\n5,1,1,,3\n,400.0,1000.0,,2.0,300.0,320.0,200.0\n2.0,,,70,,,5000.0\n"
      "1,410.0,,,1.0,310.0\n,,,,,,,0.5\n"
      "*DEFINE_CONNECTION_PROPERTIES_ADD\n5\n2,420.0,,,3.0,320.0\n\n"
      "*DEFINE_CURVE\n70\n0.0,1.0\n100.0,1.5\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  ASSERT_EQ(b.model.connections.size(), 1u);
  const ConnectionProperties& c = b.model.connections[0];
  EXPECT_EQ(c.area_rule, 1);
  EXPECT_EQ(c.damage_type, 3);
  EXPECT_DOUBLE_EQ(c.standard.yield, 400.0);
  EXPECT_DOUBLE_EQ(c.standard.normal.at(100.0), 450.0);
  EXPECT_DOUBLE_EQ(c.standard.normal_exponent, 2.0);
  EXPECT_DOUBLE_EQ(c.standard.bending_exponent, 1.0);
  EXPECT_DOUBLE_EQ(c.standard.fading_energy, 5000.0);
  EXPECT_DOUBLE_EQ(c.standard.damage_parameter, 1e10);
  ASSERT_EQ(c.records.size(), 2u);
  EXPECT_EQ(c.records[0].material, 0);
  EXPECT_DOUBLE_EQ(c.records[0].torsion_factor, 0.5);
  EXPECT_EQ(c.records[1].material, 1);
  EXPECT_DOUBLE_EQ(c.records[1].rank, 3.0);
}

// PROPRUL 2: ids of functions of both sheets stand in place of numbers.
TEST(WeldCards, ConnectionByFunctions) {
  const std::string functions =
      "*DEFINE_FUNCTION\n11\nyield(t1,t2,sy1,sy2,sm1,sm2,r,a,e1,e2)=min(sy1,sy2)\n"
      "*DEFINE_FUNCTION\n12\nstrength(t1,t2,sy1,sy2,sm1,sm2,r)=(sm1+sm2)*(1.0+r)\n"
      "*DEFINE_FUNCTION\n13\nother(t2,t1)=t1\n";
  const auto connection = [&](const std::string& rest) {
    return built("*DEFINE_CONNECTION_PROPERTIES\n5,2\n" + rest + functions);
  };
  const auto b = connection(",11,,,,12,,12\n,11\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  ASSERT_TRUE(b.model.connections.at(0).functions);
  const ConnectionProperties::Functions& f = *b.model.connections[0].functions;
  EXPECT_THAT((std::array{f.yield, f.tangent_modulus, f.normal, f.bending, f.shear, f.normal_exponent,
                          f.bending_exponent, f.shear_exponent, f.fading_energy}),
              ElementsAre(0, none, 1, none, 1, none, 0, none, none));
  EXPECT_TRUE(connection(",,,,,77\n\n").error("*DEFINE_FUNCTION 77 is not in the deck", "dsn"));
  EXPECT_TRUE(connection(",,,,,13\n\n").error("its arguments are (t2, t1); expected (t1, t2, sy1", "dsn"));
  EXPECT_TRUE(connection(",12\n\n").error("it depends on the strain rate r", "dsigy"));
  EXPECT_TRUE(connection(",11\n,,,1\n").error("with PROPRUL 2 the strain rate is an argument", "dlcsn"));
  EXPECT_TRUE(connection(",11\n\n1,410.0\n\n").error("records of materials are not read", "mid"));
}

TEST(WeldCards, TablesNameWhatIsMissing) {
  EXPECT_TRUE(built("*DEFINE_SPOTWELD_RUPTURE_STRESS\n77,300.0\n").error("part 77 is not defined", "pid"));
  EXPECT_TRUE(built("*DEFINE_CONNECTION_PROPERTIES_ADD\n5\n").error("5 is not defined", "con_id"));
  EXPECT_TRUE(built("*DEFINE_CONNECTION_PROPERTIES\n5,3\n\n\n").error("expected 0, 1 or 2", "proprul"));
  EXPECT_TRUE(built("*DEFINE_CONNECTION_PROPERTIES\n5,-1\n\n\n").error("expected 0 or more", "proprul"));
  EXPECT_TRUE(built("*DEFINE_SPOTWELD_RUPTURE_PARAMETER\n1\n").error("OPT 9"));
  EXPECT_TRUE(built("*DEFINE_SPOTWELD_MULTISCALE\n1\n").error("this table of weld strengths is not built"));
}

}  // namespace
}  // namespace nugget::reading
