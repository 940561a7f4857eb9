// SPDX-License-Identifier: Apache-2.0
#include "model/units.hpp"

#include <gtest/gtest.h>

namespace nugget::model {
namespace {

/// The columns of the table follow from three of them: lengths, times and the mass in a volume.
TEST(Units, ColumnsOfATableAgree) {
  ASSERT_EQ(unit_systems().size(), 10u);
  for (const Units& u : unit_systems()) {
    SCOPED_TRACE(u.description);
    const double metre = 1e3 * u.millimetre, second = 1e6 * u.microsecond;
    const double kilogram = u.kilogram_per_cubic_metre * metre * metre * metre;
    const double newton = kilogram * metre / (second * second), pascal = newton / (metre * metre);
    EXPECT_NEAR(u.metre_per_second / (metre / second), 1.0, 1e-5);
    EXPECT_NEAR(u.newton / newton, 1.0, 1e-4);
    EXPECT_NEAR(u.steel_density / (7850.0 * u.kilogram_per_cubic_metre), 1.0, 3e-3);
    EXPECT_NEAR(u.steel_young / (2.1e11 * pascal), 1.0, 3e-3);
  }
}

TEST(Units, SteelTellsThem) {
  for (const Units& u : unit_systems()) {
    Model model;
    Material steel;
    steel.law = kernel::Rigid{u.steel_young, 0.3};
    steel.density = u.steel_density;
    model.materials.push_back(steel);
    const auto found = recognise_units(model);
    ASSERT_TRUE(found) << u.description;
    EXPECT_EQ(found->description, u.description);
  }
}

/// The words of the field, for sets that decks are written in.
TEST(Units, SymbolsOfQuantities) {
  const auto symbol_in = [](std::string_view name, const Dimension& d) { return symbol(units_named(name).value(), d); };
  EXPECT_EQ(symbol_in("mm, t, s", dimension::force), "N");
  EXPECT_EQ(symbol_in("mm, t, s", dimension::moment), "N mm");
  EXPECT_EQ(symbol_in("mm, t, s", dimension::stress), "MPa");
  EXPECT_EQ(symbol_in("mm, t, s", dimension::velocity), "mm/s");
  EXPECT_EQ(symbol_in("mm, t, s", dimension::acceleration), "mm/s2");
  EXPECT_EQ(symbol_in("mm, t, s", dimension::density), "t/mm3");
  EXPECT_EQ(symbol_in("mm, t, s", dimension::force_per_length), "N/mm");
  EXPECT_EQ(symbol_in("mm, t, s", dimension::number), "");
  EXPECT_EQ(symbol_in("mm, kg, ms", dimension::force), "kN");
  EXPECT_EQ(symbol_in("mm, kg, ms", dimension::stress), "GPa");
  EXPECT_EQ(symbol_in("mm, kg, ms", dimension::rate), "1/ms");
  EXPECT_EQ(symbol_in("m, kg, s", dimension::moment), "N m");
  EXPECT_FALSE(units_named("miles, tons, years"));
}

}  // namespace
}  // namespace nugget::model
