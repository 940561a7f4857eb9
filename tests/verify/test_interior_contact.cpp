// SPDX-License-Identifier: Apache-2.0
// *CONTACT_INTERIOR: the force against the documented stiffness, and what it is for: soft bricks that are not deleted.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "brick_decks.hpp"
#include "experiment.hpp"

namespace nugget::verify {
namespace {

/// Soft bricks, part 1 in part set 1 with the attributes PSF, Fa, ED.
std::string soft_part(double young, double psf, double activation, double modulus) {
  return "*PART\nfoam\n" + fields({1, 1, 1}) + "*SECTION_SOLID\n" + fields({1, 1}) + "*MAT_ELASTIC\n" +
         fields({1, 1e-9, young, 0.0}) + "*SET_PART_LIST\n" + fields({1, psf, activation, modulus}) + fields({1});
}
const std::string interior = "*CONTACT_INTERIOR\n" + fields({1});

constexpr double side = 2.0, activation = 0.3;

/// Energy of the contact in a cube that is pressed flat by `down` and sheared by `along`.
double energy_of_flat_cube(const std::string& part_and_contact, double down, double along) {
  const Prism cube = square_prism(side, side);
  // The stiffness asked for is borne at steps this short only.
  Experiment run("*KEYWORD\n" + termination(1e-3, 0.005) + part_and_contact + cube.text() +
                 held(cube.bottom(), {1, 1, 1}) +
                 moved(
                     cube, cube.top(), {1, 1, 1},
                     [=](const Vec3d&, double s) {
                       return Vec3d{along * s, 0.0, -down * s};
                     },
                     1e-3, 1) +
                 "*END\n");
  double energy = 0.0;
  run.run([&](const impact::Snapshot& now) { energy = now.energy.contact; });
  return energy;
}

double energy_of_flat_cube(double young, double psf, double modulus, double down, double along) {
  return energy_of_flat_cube(soft_part(young, psf, activation, modulus) + interior, down, along);
}

TEST(InteriorContact, ForceOfTheDocumentedStiffness) {
  // k = ED V^(2/3) / h over the way from Fa h to what is left of it; shear in place does not change the height.
  constexpr double left = 0.2, way = activation * side - left, k = 1000.0 * side * side / side;
  for (const double along : {0.0, 0.3})
    expect_reference("*CONTACT_INTERIOR", along > 0.0 ? "energy, ED given, sheared" : "energy, ED given",
                     energy_of_flat_cube(1.0, 0.0, 1000.0, side - left, along), 0.5 * k * way * way, 1e-3);
  // k = SLSFAC PSF E V^(2/3) / h, SLSFAC 0.1.
  expect_reference("*CONTACT_INTERIOR", "energy, of Young's modulus",
                   energy_of_flat_cube(50.0, 20.0, 0.0, side - left, 0.0), 0.5 * (0.1 * 20.0 * 50.0 * side) * way * way,
                   1e-3);
  EXPECT_EQ(energy_of_flat_cube(1.0, 0.0, 1000.0, side - activation * side - 0.01, 0.0), 0.0);
}

/// Attributes of the part go before those of its set, and a set of sets keeps those of each.
TEST(InteriorContact, AttributesOfThePart) {
  constexpr double left = 0.2, way = activation * side - left, k = 1000.0 * side * side / side;
  const std::string part = soft_part(1.0, 3.0, 0.05, 7.0);
  const std::string own = "*SET_PART_COLUMN\n" + fields({2, 0.0, activation, 5.0}) + fields({1, 0.0, 0.0, 1000.0}),
                    sum = "*SET_PART_ADD\n" + fields({3, 0.0, 0.04}) + fields({2});
  expect_reference("*CONTACT_INTERIOR", "energy, ED of the part in its set",
                   energy_of_flat_cube(part + own + "*CONTACT_INTERIOR\n" + fields({2}), side - left, 0.0),
                   0.5 * k * way * way, 1e-3);
  expect_reference("*CONTACT_INTERIOR", "energy, ED of the part in a set of sets",
                   energy_of_flat_cube(part + own + sum + "*CONTACT_INTERIOR\n" + fields({3}), side - left, 0.0),
                   0.5 * k * way * way, 1e-3);
}

struct Flight {
  impact::Outcome outcome;
  double momentum = 0.0, angular = 0.0, ratio = 0.0, contact = 0.0;  ///< greatest changes, greatest energy
};

/// Free bricks whose upper nodes fly at the lower ones, askew.
Flight thrown(const std::string& contact) {
  Prism block = square_prism(4.0, 2.0, 2);
  std::string velocities = "*INITIAL_VELOCITY_NODE\n";
  for (const int id : block.top()) {
    const Vec3d x = block.place(id);
    velocities += fields({static_cast<double>(id), 5e2 * x.y, 0.0, -3e4 - 5e2 * x.x});
  }
  // Viscosity would stop bricks as soft as these before they are flat.
  Experiment run("*KEYWORD\n*CONTROL_BULK_VISCOSITY\n" + fields({1e-12, 1e-12}) + termination(4e-4, 0.9, 0.0, 90) +
                 curve(90, {{0.0, 1e-7}, {1.0, 1e-7}}) + soft_part(1e-3, 0.0, activation, 20.0) + contact +
                 block.text() + velocities + "*END\n");
  Flight flight;
  std::optional<Vec3d> linear, angular;
  flight.outcome = run.run([&](const impact::Snapshot& now) {
    Vec3d l, a;
    for (std::size_t n = 0; n < now.system.nodes; ++n) {
      const Vec3d v = vec(now.state.v[n]), p = now.system.mass[n] * v;
      l += p;
      a += cross(vec(now.state.x[n]) + (0.5 * now.state.dt) * v, p);
    }
    if (!linear) linear = l, angular = a;
    flight.momentum = std::max(flight.momentum, norm(l - *linear) / norm(*linear));
    flight.angular = std::max(flight.angular, norm(a - *angular) / norm(*angular));
    flight.ratio = std::max(flight.ratio, std::abs(now.energy.ratio() - 1.0));
    flight.contact = std::max(flight.contact, now.energy.contact / now.energy.initial);
  });
  return flight;
}

TEST(InteriorContact, KeepsSoftBricksFromTurningInsideOut) {
  const Flight without = thrown("");
  EXPECT_EQ(without.outcome.termination, impact::Termination::error);
  const Flight with = thrown(interior);
  EXPECT_EQ(with.outcome.termination, impact::Termination::normal) << with.outcome.message;
  EXPECT_GT(with.contact, 0.1);
  EXPECT_LT(with.momentum, 1e-12);
  EXPECT_LT(with.angular, 1e-12);
  EXPECT_LT(with.ratio, 0.01);
}

}  // namespace
}  // namespace nugget::verify
