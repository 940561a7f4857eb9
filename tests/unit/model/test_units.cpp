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

}  // namespace
}  // namespace nugget::model
