// SPDX-License-Identifier: Apache-2.0
// *CONTACT_..._TIEBREAK: the work that parts two plates is what the law's card says, in tension, shear and both.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double area = 400.0, strength = 1.0, shear_strength = 1.5;

/// Work [N mm] to part a rigid plate of 20 x 20 from a fixed one, moved along x and z at these speeds by a
/// millimetre; `card`: that of the glue.
double work_of_parting(std::initializer_list<double> card, double along, double up) {
  Specimen s;
  s.card("MAT_ELASTIC", {1, 7.85e-9, 210000.0, 0.3});
  s.card("MAT_RIGID", {2, 7.85e-9, 210000.0, 0.3}).text(fields({1, 5, 7}) + fields({}));
  s.text("*SECTION_SHELL\n" + fields({1, 2, 1, 2}) + fields({1, 1, 1, 1})).part(1, 1, 1).part(2, 1, 2);
  const Grid lower = s.shells(1, {-10.0, -10.0, 0.0}, {40.0, 40.0, 0.0}, 1, 1);
  s.shells(2, {0.0, 0.0, 1.0}, {20.0, 20.0, 0.0}, 2, 2);
  s.node_set(1, lower.all()).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
  s.card("BOUNDARY_PRESCRIBED_MOTION_RIGID", {2, 1, 0, 1, along});
  s.card("BOUNDARY_PRESCRIBED_MOTION_RIGID", {2, 3, 0, 1, up}).text(constant_curve(1));
  s.text("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n" + fields({2, 1, 3, 3}) + fields({}) + fields({}) +
         fields(card));
  s.card("CONTROL_ENERGY", {2, 2, 2, 2}).card("CONTROL_TERMINATION", {1.0 / std::hypot(along, up)});
  Experiment experiment(s.deck());
  double work = 0.0;
  int holding = 0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    work = now.energy.contact;
    const auto& glue = *now.contacts[0].glue();
    holding = static_cast<int>(glue.size()) - glue.failed();
  });
  EXPECT_EQ(holding, 0);
  return work;
}

// The triangle under the stress: strength up to the distance. Sabotage: damage that begins at an opening of 0.
TEST(Glue, StressFallsToNothingAtTheDistance) {
  const auto work = [](double along, double up) {
    return work_of_parting({6, strength, shear_strength, 0.4}, along, up);
  };
  expect_reference("glue", "OPTION 6, tension, work to part [N mm]", work(0.0, 500.0), 0.5 * strength * 0.4 * area,
                   0.01);
  expect_reference("glue", "OPTION 6, shear, work to part [N mm]", work(500.0, 0.0), 0.5 * shear_strength * 0.4 * area,
                   0.01);
}

// Sabotage: ERATES for ERATEN; the sign of PARAM not looked at; an end that does not depend on the mix.
TEST(Glue, ModesMixAsThePowerLawOrAsBenzeggaghAndKenaneSay) {
  constexpr double tension = 0.2, shear = 0.6;
  const auto work = [](double exponent, double along, double up) {
    return work_of_parting({9, strength, shear_strength, exponent, tension, shear, 1.0, 10.0}, along, up);
  };
  expect_reference("glue", "OPTION 9, tension, work to part [N mm]", work(1.0, 0.0, 500.0), tension * area, 0.01);
  expect_reference("glue", "OPTION 9, shear, work to part [N mm]", work(1.0, 500.0, 0.0), shear * area, 0.01);
  // As stiff in shear as in tension: at 45 degrees each mode has half of the energy.
  expect_reference("glue", "OPTION 9, 45 degrees, power law of 1, work to part [N mm]", work(1.0, 400.0, 400.0),
                   area / (0.5 / tension + 0.5 / shear), 0.01);
  expect_reference("glue", "OPTION 9, 45 degrees, power law of 2, work to part [N mm]", work(2.0, 400.0, 400.0),
                   area / std::hypot(0.5 / tension, 0.5 / shear), 0.01);
  expect_reference("glue", "OPTION 9, 45 degrees, Benzeggagh and Kenane 1.5, work to part [N mm]",
                   work(-1.5, 400.0, 400.0), area * (tension + (shear - tension) * std::pow(0.5, 1.5)), 0.01);
}

}  // namespace
}  // namespace nugget::verify
