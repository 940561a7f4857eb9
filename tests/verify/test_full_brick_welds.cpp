// SPDX-License-Identifier: Apache-2.0
// Welds of fully integrated bricks (ELFORM 2, -1): stiffness and failure against the closed forms of the element
// itself, uniaxial stress state, failure strain, damage.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "brick_decks.hpp"
#include "experiment.hpp"

namespace nugget::verify {
namespace {

constexpr double side = 5.317361, length = 1.5, area = side * side;  // the section of a beam of 6 mm
constexpr double step = 1e-7;
constexpr double E = 210000.0, nu = 0.3, G = E / (2.0 * (1.0 + nu));
constexpr double confined = E * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));  // no lateral strain

/// A part of weld bricks; `law` are the material's keyword and cards.
std::string part(const std::string& law, int elform) {
  return "*PART\nweld\n" + fields({1, 1, 1}) + "*SECTION_SOLID\n" + fields({1, 1.0 * elform}) + law;
}
std::string spotweld(double yield, double hardening, std::initializer_list<double> second) {
  return "*MAT_SPOTWELD\n" + fields({1, 7.8e-9, E, nu, yield, hardening}) + fields(second);
}

struct Outcome {
  bool failed = false;
  double time_share = 0.0;  ///< of the path, at failure
  Vec3d force, moment;      ///< on the section at mid-length by the supports, in the last cycle that the weld holds
  weld::Resultants weld;
  double plastic_strain = 0.0;
};

/// One brick: the bottom face stands, the top moves; all in all three directions.
Outcome run(const std::string& law, const Motion& motion, int cycles = 2000, int elform = 2) {
  const Prism prism = square_prism(side, length);
  Experiment run("*KEYWORD\n" + termination(cycles * step, 0.9, 0.0, 90) + curve(90, {{0.0, step}, {1.0, step}}) +
                 part(law, elform) + prism.text() + held(prism.bottom(), {1, 1, 1}) +
                 moved(prism, prism.top(), {1, 1, 1}, motion, cycles * step, 1) + "*END\n");
  Outcome out;
  run.run([&](const impact::Snapshot& now) {
    const weld::History& h = *now.components.welds.history(0);
    out.failed = h.failed();
    if (out.failed) {
      out.time_share = h.failure_time() / (cycles * step);
      return;
    }
    out.weld = h.resultants();
    out.plastic_strain = h.last_load().plastic_strain;
    out.force = out.moment = {};
    for (const auto& r : now.components.supports.spc_reactions()) {
      out.force -= r.force;
      out.moment -= cross(vec(now.state.x[r.node]), r.force);
    }
    out.moment += Vec3d{0.5 * length * out.force.y, -0.5 * length * out.force.x, 0.0};
  });
  return out;
}

Motion pull(double u) {
  return [=](const Vec3d&, double s) { return Vec3d{0, 0, s * u}; };
}
Motion shear(double u) {
  return [=](const Vec3d&, double s) { return Vec3d{s * u, 0, 0}; };
}
Motion twist(double a) {
  return [=](const Vec3d& x, double s) { return Vec3d{-s * a * x.y, s * a * x.x, 0}; };
}
/// About y, without shear at mid-length.
Motion bend(double a) {
  return [=](const Vec3d& x, double s) { return Vec3d{s * 0.5 * length * a, 0, -s * a * x.x}; };
}

const std::string elastic = spotweld(1e6, 0, {0});

// The energy of the trilinear brick with one pressure, sides held: bending strain e = theta x / L is resisted by its
// deviator, 4/3 G, and the shear theta z / L by G, so M L / theta = 4/3 G I + G A L^2 / 12; twist has no pressure and
// no hourglass mode, T L / theta = G a^4 / 6. Sabotage to be caught: a pressure of each point (1.35 E I); moments of
// hourglass forces, of which this brick has none.
TEST(FullBrickWeld, StiffnessOfTheElement) {
  const double I = area * area / 12.0, u = 1e-5;
  const auto compare = [&](const char* what, const Outcome& out, double weld, double support, double reference) {
    expect_reference("ELFORM 2", std::string(what) + ", the weld's resultant", weld, reference, 1e-3);
    expect_reference("ELFORM 2", std::string(what) + ", the support's", support, reference, 1e-3);
    EXPECT_FALSE(out.failed);
  };
  const Outcome n = run(elastic, pull(u)), v = run(elastic, shear(u)), t = run(elastic, twist(u)),
                m = run(elastic, bend(u));
  compare("N L / u", n, n.weld.axial * length / u, n.force.z * length / u, confined * area);
  compare("V L / u", v, v.weld.shear_s * length / u, v.force.x * length / u, G * area);
  compare("T L / theta", t, t.weld.torsion * length / u, t.moment.z * length / u, G * area * area / 6.0);
  compare("M L / theta", m, m.weld.moment_t * length / u, m.moment.y * length / u,
          4.0 / 3.0 * G * I + G * area * length * length / 12.0);
  const Outcome free = run("*MAT_SPOTWELD_UNIAXIAL\n" + fields({1, 7.8e-9, E, nu, 1e6}) + fields({0}), pull(u));
  expect_reference("ELFORM 2", "N L / u, uniaxial", free.force.z * length / u, E * area, 1e-3);
  const Outcome bent = run("*MAT_SPOTWELD_UNIAXIAL\n" + fields({1, 7.8e-9, E, nu, 1e6}) + fields({0}), bend(u));
  expect_reference("ELFORM 2", "M L / theta, uniaxial", bent.moment.y * length / u,
                   E * I + G * area * length * length / 12.0, 1e-3);
}

// With assumed strains bending is that of a wide plate, E I/(1 - nu^2), as the sides are held, without parasitic shear.
// Sabotage to be caught: no thinning; the deviator of a uniaxial stress state's strains.
TEST(FullBrickWeld, StiffnessOfAssumedStrains) {
  const double I = area * area / 12.0, u = 1e-5;
  const auto compare = [&](const char* what, double weld, double support, double reference) {
    expect_reference("ELFORM -1", std::string(what) + ", the weld's resultant", weld, reference, 1e-3);
    expect_reference("ELFORM -1", std::string(what) + ", the support's", support, reference, 1e-3);
  };
  const auto ran = [](const std::string& law, const Motion& motion) { return run(law, motion, 2000, -1); };
  const Outcome n = ran(elastic, pull(u)), v = ran(elastic, shear(u)), t = ran(elastic, twist(u)),
                m = ran(elastic, bend(u));
  compare("N L / u", n.weld.axial * length / u, n.force.z * length / u, confined * area);
  compare("V L / u", v.weld.shear_s * length / u, v.force.x * length / u, G * area);
  compare("T L / theta", t.weld.torsion * length / u, t.moment.z * length / u, G * area * area / 6.0);
  compare("M L / theta", m.weld.moment_t * length / u, m.moment.y * length / u, E * I / (1.0 - nu * nu));
  const Outcome bent = ran("*MAT_SPOTWELD_UNIAXIAL\n" + fields({1, 7.8e-9, E, nu, 1e6}) + fields({0}), bend(u));
  expect_reference("ELFORM -1", "M L / theta, uniaxial", bent.moment.y * length / u, E * I, 1e-3);
}

// Sabotage to be caught: the resultants of the first point alone.
TEST(FullBrickWeld, ResultantSurface) {
  const auto law = [](std::initializer_list<double> strengths) { return spotweld(1e6, 0, strengths); };
  const Outcome n = run(law({0, 8000}), pull(3e-3)), v = run(law({0, 0, 6000}), shear(6e-3)),
                t = run(law({0, 0, 0, 0, 9000}), twist(4e-3)), m = run(law({0, 0, 0, 0, 0, 0, 7000}), bend(3e-3));
  for (const Outcome* out : {&n, &v, &t, &m}) EXPECT_TRUE(out->failed);
  expect_reference("ELFORM 2", "tension at failure, NRR = 8000 [N]", n.force.z, 8000, 5e-3);
  expect_reference("ELFORM 2", "shear at failure, NRS = 6000 [N]", v.force.x, 6000, 5e-3);
  expect_reference("ELFORM 2", "torsion at failure, MRR = 9000 [N mm]", t.moment.z, 9000, 5e-3);
  expect_reference("ELFORM 2", "bending at failure, MTT = 7000 [N mm]", m.moment.y, 7000, 5e-3);
}

// Strain e in one direction: plastic strain (2 G e - Y) / (3 G + H), the same at all points. In bending the points fail
// when theirs does, at x = a / (2 sqrt 3); all four pairs at once. Sabotage to be caught: deletion by the mean; a point
// that has failed and still carries.
TEST(FullBrickWeld, FailureStrain) {
  const double Y = 400, H = 1000, limit = 0.02, u = 0.3;
  const std::string law = spotweld(Y, H, {limit});
  const double strain = (Y + (3.0 * G + H) * limit) / (2.0 * G);
  const Outcome n = run(law, pull(u), 4000);
  EXPECT_TRUE(n.failed);
  expect_reference("ELFORM 2", "elongation at EFAIL", std::log(1.0 + u * n.time_share / length), strain, 5e-3);
  expect_reference("ELFORM 2", "plastic strain before EFAIL", n.plastic_strain, limit, 5e-3);
}

// Damage of the points, RS = 0.05: what is left of the undamaged stress at mean plastic strain p is (RS - p)/(RS -
// EFAIL).
TEST(FullBrickWeld, PointDamage) {
  const double Y = 400, H = 0, onset = 0.02, rupture = 0.05, u = 0.09;
  const Outcome v =
      run("*MAT_SPOTWELD_DAMAGE-FAILURE\n" + fields({1, 7.8e-9, E, nu, Y, H}) + fields({onset}) + fields({rupture, 0}),
          shear(u), 4000);
  EXPECT_FALSE(v.failed);
  // gamma = u / L; plastic strain (gamma - Y / (sqrt 3 G)) / sqrt 3.
  const double p = (u / length - Y / (std::sqrt(3.0) * G)) / std::sqrt(3.0);
  expect_reference("ELFORM 2", "plastic strain in shear", v.plastic_strain, p, 1e-2);
  expect_reference("ELFORM 2", "shear stress of the damaged weld [MPa]", v.force.x / area,
                   Y / std::sqrt(3.0) * (rupture - p) / (rupture - onset), 2e-2);
}

// DMGOPT 11: the failure function begins the damage, and the points are frozen at the stress of that moment. In shear
// V = V0 (1 - p / RS) with p = (gamma - gamma0) / sqrt 3. Sabotage to be caught: one point held, seven that go on
// elastically; the share that is left not applied to the points.
TEST(FullBrickWeld, DamageOfTheWholeHoldsAllPoints) {
  const double V0 = 6000, rupture = 0.05, u = 0.07;
  const Outcome v = run("*MAT_SPOTWELD_DAMAGE-FAILURE\n" + fields({1, 7.8e-9, E, nu, 1e6, 0}) + fields({0, 0, V0}) +
                            fields({rupture, 0, 0, 0, 0, 0, 0, 11}),
                        shear(u), 4000);
  EXPECT_FALSE(v.failed);
  const double p = (u - V0 * length / (G * area)) / length / std::sqrt(3.0);
  expect_reference("ELFORM 2", "shear force of a weld with DMGOPT 11 [N]", v.force.x, V0 * (1.0 - p / rupture), 1e-2);
}

}  // namespace
}  // namespace nugget::verify
