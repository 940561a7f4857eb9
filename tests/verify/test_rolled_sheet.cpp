// SPDX-License-Identifier: Apache-2.0
// Rolled sheets (MAT_036, MAT_037, MAT_122): shells pulled along, at 45 degrees to and across the rolling direction,
// against the Lankford ratios that were given and the strengths of R. Hill (Proc. R. Soc. A 193, 1948).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double E = 210000.0, nu = 0.3, yield = 300.0, side = 10.0;
constexpr double r00 = 1.8, r45 = 1.3, r90 = 2.2;

struct Pulled {
  double ratio;   ///< plastic strain across the pull over that through the thickness
  double stress;  ///< along the pull
};

/// One shell pulled along x by 3 %, free to contract and to shear.
Pulled pulled(const std::string& material, double elform) {
  Specimen s;
  s.text(material);
  s.card("SECTION_SHELL", {1, elform, 5.0 / 6.0, 3}).text(fields({1.0, 1.0, 1.0, 1.0}));
  s.part(1, 1, 1);
  const Grid sheet = s.shells(1, {0, 0, 0}, {side, side, 0}, 1, 1);
  s.text(smooth_ramp(1, 2e-3, 0.03 * side));
  for (const int j : {0, 1}) {
    s.card("BOUNDARY_SPC_NODE", {1.0 * sheet(0, j), 0, 1, j == 0 ? 1.0 : 0.0, 1, 1, 1, 1});
    s.card("BOUNDARY_SPC_NODE", {1.0 * sheet(1, j), 0, 0, 0, 1, 1, 1, 1});
    s.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {1.0 * sheet(1, j), 1, 2, 1});
  }
  s.card("CONTROL_TERMINATION", {2e-3});
  Experiment run(s.deck());
  Pulled now{};
  run_to_end(run, [&](const impact::Snapshot& at) {
    const Vec3d along = run.position(at, sheet(1, 0)) - run.position(at, sheet(0, 0)),
                across = run.position(at, sheet(0, 1)) - run.position(at, sheet(0, 0));
    now.stress = shell_layer(run, at, 1, 0).stress[0];
    const double length = std::log(along.x / side) - now.stress / E,
                 width = std::log(across.y / side) + nu * now.stress / E;
    now.ratio = width / -(length + width);
  });
  return now;
}

std::string barlat(double m, double angle) {
  const double a = angle * std::numbers::pi / 180.0;
  return "*MAT_3-PARAMETER_BARLAT\n" + fields({1, 7.85e-9, E, nu, 1, 0.0, yield}) + fields({m, r00, r45, r90}) +
         fields({2}) + fields({0, 0, 0, std::cos(a), std::sin(a), 0}) + fields({0, 0, 0, -std::sin(a), std::cos(a)});
}

TEST(RolledSheet, StretchesByTheRatiosOfItsCard) {
  const double ratios[] = {r00, r45, r90};
  for (const double elform : {2.0, 16.0})
    for (const double m : {2.0, 8.0})
      for (int i = 0; i < 3; ++i)
        expect_reference("rolled sheet",
                         fmt::format("MAT_036, ELFORM {}, M {}: Lankford ratio at {} degrees", elform, m, 45 * i),
                         pulled(barlat(m, 45.0 * i), elform).ratio, ratios[i], 0.01);
  const std::string transverse =
      "*MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC\n" + fields({1, 7.85e-9, E, nu, yield, 0, 1.6});
  expect_reference("rolled sheet", "MAT_037: Lankford ratio", pulled(transverse, 2.0).ratio, 1.6, 0.01);
}

TEST(RolledSheet, HasTheStrengthsOfHill) {
  const auto hill = [](double angle) {
    const double a = angle * std::numbers::pi / 180.0;
    return "*MAT_HILL_3R\n" + fields({1, 7.85e-9, E, nu, 1, 0.0, yield}) + fields({r00, r45, r90}) + fields({2}) +
           fields({0, 0, 0, std::cos(a), std::sin(a), 0}) + fields({0, 0, 0, -std::sin(a), std::cos(a)});
  };
  const double f = r00 / (r90 * (1.0 + r00)), g = 1.0 / (1.0 + r00),
               n = (r00 + r90) * (1.0 + 2.0 * r45) / (2.0 * r90 * (1.0 + r00));
  expect_reference("rolled sheet", "MAT_122: strength along", pulled(hill(0.0), 2.0).stress, yield, 0.001);
  expect_reference("rolled sheet", "MAT_122: strength at 45 degrees", pulled(hill(45.0), 2.0).stress,
                   yield * std::sqrt(4.0 / (f + g + 2.0 * n)), 0.002);
  expect_reference("rolled sheet", "MAT_122: strength across", pulled(hill(90.0), 2.0).stress,
                   yield * std::sqrt(r90 * (1.0 + r00) / (r00 * (1.0 + r90))), 0.001);
}

}  // namespace
}  // namespace nugget::verify
