// SPDX-License-Identifier: Apache-2.0
// Weld damage after EFAIL, and MAT_100 beyond its failure surface on single welds: node 1 held, node 2 driven, so
// that no inertia enters. Closed forms: docs/theory/failure.md#damage-of-the-whole-weld.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "brick_decks.hpp"
#include "experiment.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

constexpr double step = 2e-7;  // below the stable step of the welds here

Path along_x(double end) {
  return [=](double s) { return std::array<double, 6>{s * end}; };
}

/// Weld W1 along x with a material card of the test's own; node 2 moves along its path.
class Pulled {
 public:
  struct Sample {
    double u, axial, plastic_strain, work, eroded;
    weld::Resultants r;
    bool damaged;
  };

  Pulled(const std::string& material, double end, int cycles) : Pulled(material, along_x(end), cycles) {}
  Pulled(const std::string& material, const Path& path, int cycles) {
    const WeldData w;
    Experiment run("*KEYWORD\n" + termination(cycles * step, 0.9, 0.0, 90) + curve(90, {{0.0, step}, {1.0, step}}) +
                   "*PART\nwelds\n" + fields({1, 1, 1}) + "*SECTION_BEAM\n" + fields({1, 9, 1, 2, 1}) +
                   fields({w.diameter, w.diameter, 0, 0}) + material +
                   beam_between(1, 1, 1, {0, 0, 0}, 2, {w.length, 0, 0}) + fixed({1}) +
                   driven(2, path, cycles * step, 1, 100) + "*END\n");
    run.run([&](const impact::Snapshot& now) {
      const system::System::ElementLocation location = now.system.beam_location[0];
      const auto& group = *now.system.groups[location.group];
      samples.push_back({run.displacement(now, 2).x, run.weld(now, 1).axial,
                         group.layer(0, 0, now.state).plastic_strain, now.energy.internal + now.energy.eroded,
                         now.energy.eroded, run.weld(now, 1), run.history(now, 1).damage().begun()});
    });
  }

  /// A value at the moment when `of` first reaches `level`, interpolated.
  double at(double Sample::*of, double level, double Sample::*value) const {
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const double a = samples[i - 1].*of, b = samples[i].*of;
      if (a > level || b < level || a == b) continue;
      const double w = (level - a) / (b - a);
      return (1.0 - w) * samples[i - 1].*value + w * samples[i].*value;
    }
    ADD_FAILURE() << "the level " << level << " is never reached";
    return 0.0;
  }

  std::size_t onset() const {
    std::size_t i = 0;
    while (i + 1 < samples.size() && !samples[i].damaged) ++i;
    return i;
  }

  std::vector<Sample> samples;
};
using Sample = Pulled::Sample;

std::string damaging(double efail, double rs, int dmgopt, double beta = 0.0) {
  return "*MAT_SPOTWELD_DAMAGE-FAILURE\n" + fields({1, 7.8e-9, 210000, 0.3, 400, 1000}) + fields({efail}) +
         fields({rs, 0, 0, 0, 0, beta, 0, static_cast<double>(dmgopt)});
}

constexpr double area = 28.2743;

// Sabotage to be caught: the return on the damaged stress; EFAIL taken for the strain of rupture; work of the undamaged
// force booked.
TEST(WeldDamage, LinearDamageOverPlasticStrain) {
  const double end = 0.54;
  const Pulled pull(damaging(0.2, 0.3, 0), end, 6000);
  const double table[3][3] = {{0.225, 13253.6, 0.384083}, {0.25, 9189.2, 0.432009}, {0.275, 4771.3, 0.481154}};
  expect_reference("weld damage after EFAIL", "N at plastic strain 0.2, where the damage begins [N]",
                   pull.at(&Sample::plastic_strain, 0.2, &Sample::axial), 16964.6, 1e-2);
  for (const auto& [strain, n, u] : table) {
    expect_reference("weld damage after EFAIL", fmt::format("N at plastic strain {} [N]", strain),
                     pull.at(&Sample::plastic_strain, strain, &Sample::axial), n, 1e-2);
    expect_reference("weld damage after EFAIL", fmt::format("elongation at plastic strain {} [mm]", strain),
                     pull.at(&Sample::plastic_strain, strain, &Sample::u), u, 1e-2);
  }
  double jump = 0.0, broken = 0.0;
  for (std::size_t i = 1; i < pull.samples.size(); ++i) {
    const Sample &before = pull.samples[i - 1], &now = pull.samples[i];
    if (before.plastic_strain > 0.1) jump = std::max(jump, std::abs(now.axial - before.axial));
    if (before.axial > 0.0 && now.axial == 0.0) broken = now.u;
  }
  expect_reference("weld damage after EFAIL",
                   "largest jump of N from one cycle to the next beyond plastic strain 0.1, over N at the onset",
                   jump / 16964.6, 0.0, 2e-2, 1.0);
  expect_reference("weld damage after EFAIL", "elongation at rupture [mm]", broken, 0.531549, 1e-2);
  const double to_onset = pull.at(&Sample::plastic_strain, 0.2, &Sample::work);
  expect_reference("weld damage after EFAIL", "work to the onset [N mm]", to_onset, 4776.5, 2e-2);
  expect_reference("weld damage after EFAIL", "work in the damage branch [N mm]", pull.samples.back().eroded - to_onset,
                   1711.2, 2e-2);
}

TEST(WeldDamage, StressLimitAfterTheOnset) {
  const Pulled pull(damaging(0.05, 0.1, 1), 0.2, 4000);
  expect_reference("weld damage options", "N at half damage with the yield stress held (DMGOPT 1) [N]",
                   pull.at(&Sample::plastic_strain, 0.075, &Sample::axial), 0.5 * 450.0 * area, 1e-2);
}

TEST(WeldDamage, ExponentialDamage) {
  const Pulled pull(damaging(0.05, 0.1, 0, 3.0), 0.2, 4000);
  expect_reference("weld damage options", "N at w = 0.5 with BETA = 3 [N]",
                   pull.at(&Sample::plastic_strain, 0.075, &Sample::axial), std::exp(-1.5) * 475.0 * area, 1e-2);
}

TEST(WeldDamage, DamageOverTime) {
  const int cycles = 4000, fading = 1000;
  const Pulled pull(damaging(0.05, fading * step, 2), 0.2, cycles);
  std::size_t onset = 0;
  while (pull.samples[onset].plastic_strain <= 0.05) ++onset;
  expect_reference("weld damage options", "N a quarter of RS after the onset (DMGOPT 2) [N]",
                   pull.samples[onset + fading / 4].axial, 0.75 * 450.0 * area, 1e-2);
  EXPECT_GT(pull.samples[onset + fading - 3].axial, 0.0);
  EXPECT_EQ(pull.samples[onset + fading + 2].axial, 0.0);
}

// One weld, three rates of a yield table (SIGY < 0): the stress of each rate's own curve.
TEST(WeldDamage, YieldTableOverStrainRate) {
  const std::string table = "*MAT_SPOTWELD\n" + fields({1, 7.8e-9, 210000, 0.3, -5}) + fields({0}) + "*DEFINE_TABLE\n" +
                            fields({5}) + fields({1.0}) + fields({100.0}) + fields({10000.0}) +
                            curve(6, {{0.0, 400.0}, {0.5, 600.0}}) + curve(7, {{0.0, 500.0}, {0.5, 700.0}}) +
                            curve(8, {{0.0, 700.0}, {0.5, 800.0}});
  // Plastic strain 0.05 is reached at about u = 0.08 of 1.5 mm; the path is straight, so that the rate is u' / L.
  const double rate[3] = {30.0, 100.0, 300.0};
  for (int i = 0; i < 3; ++i) {
    const double end = 0.1, time = end / (1.555 * rate[i]);
    const double expected = i == 0   ? 420.0 + 100.0 * (30.0 - 1.0) / 99.0
                            : i == 1 ? 520.0
                                     : 520.0 + 190.0 * 200.0 / 9900.0;
    const Pulled pull(table, end, static_cast<int>(time / step));
    expect_reference("yield curves over the strain rate",
                     fmt::format("N at plastic strain 0.05 and rate {:g}, table of yield curves [N]", rate[i]),
                     pull.at(&Sample::plastic_strain, 0.05, &Sample::axial), expected * area, 5e-3);
  }
}

// ---- damage of the weld as a whole (DMGOPT 10 to 12)

std::string fading(const std::array<double, 6>& strength, double rs, int dmgopt, double fmode = 0.0, double ffcap = 0.0,
                   double yield = 400.0) {
  const auto& f = strength;
  return "*MAT_SPOTWELD_DAMAGE-FAILURE\n" + fields({1, 7.8e-9, 210000, 0.3, yield, 1000}) +
         fields({0, f[0], f[1], f[2], f[3], f[4], f[5]}) + fields({rs, 0, 0, 0, 0, 0, 0, -1}) +
         fields({static_cast<double>(dmgopt), fmode, ffcap});
}

// The failure function is reached at plastic strain 0.05 (N = 12723.5).
TEST(WeldDamage, FailureFunctionBeginsTheDamage) {
  const Pulled grows(fading({12723.43}, 0.1, 10), 0.2, 4000), held(fading({12723.43}, 0.1, 11), 0.2, 4000);
  expect_reference("weld damage options", "N at half damage, begun by the failure function (DMGOPT 10) [N]",
                   grows.at(&Sample::plastic_strain, 0.075, &Sample::axial), 0.5 * 475.0 * area, 1e-2);
  expect_reference("weld damage options", "N at half damage, stress held from the onset on (DMGOPT 11) [N]",
                   held.at(&Sample::plastic_strain, 0.075, &Sample::axial), 0.5 * 450.0 * area, 1e-2);
  EXPECT_GT(grows.samples.back().eroded, 0.0);
}

// Reached before first yield: with the stress frozen the weld yields where it stands, and the damage continues.
TEST(WeldDamage, ElasticOnsetWithTheStressHeld) {
  const Pulled held(fading({8000}, 0.05, 11), 0.1, 4000);
  expect_reference("weld damage options", "N at half damage after an elastic onset (DMGOPT 11) [N]",
                   held.at(&Sample::plastic_strain, 0.025, &Sample::axial), 0.5 * 8000.0, 1e-2);
}

// Each resultant by itself, a quarter of RS after the onset: three quarters of its strength are left.
TEST(WeldDamage, EachResultantFades) {
  const WeldData w;
  const std::array<double, 6> strength{8000, 4000, 4000, 6000, 5000, 5000};
  const auto value = [](const weld::Resultants& r) {
    return std::array<double, 6>{r.axial, r.shear_s, r.shear_t, r.torsion, r.moment_s, r.moment_t};
  };
  constexpr const char* name[6] = {"N_rr", "N_rs", "N_rt", "M_rr", "M_ss", "M_tt"};
  for (std::size_t i = 0; i < 6; ++i) {
    std::array<double, 6> end{};
    const double k[6] = {w.axial_stiffness(),   w.shear_stiffness(),   w.shear_stiffness(),
                         w.torsion_stiffness(), w.bending_stiffness(), w.bending_stiffness()};
    end[i] = 2.0 * strength[i] / k[i];
    if (i == 4) end[2] = -0.5 * w.length * end[4];
    if (i == 5) end[1] = 0.5 * w.length * end[5];
    const Pulled run(
        fading(strength, 1000 * step, 12),
        [&](double s) {
          std::array<double, 6> u = end;
          for (double& c : u) c *= s;
          return u;
        },
        4000);
    expect_reference("weld damage options",
                     fmt::format("{} a quarter of RS after the onset (DMGOPT 12), over its strength", name[i]),
                     value(run.samples[run.onset() + 250].r)[i] / strength[i], 0.75, 1e-2);
    EXPECT_NEAR(value(run.samples[run.onset()].r)[i], strength[i], 5e-3 * strength[i]) << name[i];
    EXPECT_EQ(value(run.samples[run.onset() + 1003].r)[i], 0.0) << name[i];
  }
}

TEST(WeldDamage, FmodeAndFfcap) {
  const WeldData w;
  const Path shear = [&](double s) { return std::array<double, 6>{0, s * 8000.0 / w.shear_stiffness()}; };
  const std::array<double, 6> strength{8000, 4000};
  const Pulled at_once(fading(strength, 1.0, 12, 0.8), shear, 2000),
      pulled(fading(strength, 1.0, 12, 0.8), 0.004, 2000);
  EXPECT_EQ(at_once.samples.back().r.shear_s, 0.0);
  EXPECT_FALSE(at_once.samples.back().damaged);
  EXPECT_TRUE(pulled.samples.back().damaged);
  EXPECT_GT(pulled.samples.back().axial, 7900.0);
  // Without a frozen stress the force keeps growing, until the failure value reaches FFCAP = 1.44: N = 1.2 NRR.
  const Pulled capped(fading({8000}, 0.9, 10, 0.0, 1.44), 0.004, 2000);
  double most = 0.0;
  for (const Sample& sample : capped.samples) most = std::max(most, sample.axial);
  expect_reference("weld damage options", "largest N with FFCAP = 1.44 over NRR", most / 8000.0, 1.2, 5e-3);
  EXPECT_EQ(capped.samples.back().axial, 0.0);
}

// ---- bricks: uniaxial points, damage, connections (MAT_100_DA)

constexpr double side = 5.317361;  // the section of weld W1

struct BrickSample {
  double s, axial, value, work, eroded, plastic_strain;
  bool failed;
};

/// A single brick of 1.5 along z; both faces move as prescribed.
std::vector<BrickSample> brick_run(const std::string& material, const Motion& top, const Motion& bottom, int cycles,
                                   double dt = 1e-7, int points = 1) {
  const Prism prism = square_prism(side, 1.5);
  Experiment run("*KEYWORD\n" + termination(cycles * dt, 0.9, 0.0, 90) + curve(90, {{0.0, dt}, {1.0, dt}}) +
                 "*PART\nbrick welds\n" + fields({1, 1, 1, 0, 1}) + "*SECTION_SOLID\n" + fields({1, 1}) +
                 "*HOURGLASS\n" + fields({1, 6, 1.0, 0, 1e-6, 1e-6}) + material + prism.text() +
                 moved(prism, prism.bottom(), {1, 1, 1}, bottom, cycles * dt, points, 100) +
                 moved(prism, prism.top(), {1, 1, 1}, top, cycles * dt, points, 200) + "*END\n");
  std::vector<BrickSample> samples;
  run.run([&](const impact::Snapshot& now) {
    const weld::History& h = *now.components.welds.history(0);
    const system::System::ElementLocation location = now.system.solid_location[0];
    const auto& group = *now.system.groups[location.group];
    samples.push_back({now.state.time / (cycles * dt), h.resultants().axial, h.failure_value(),
                       now.energy.internal + now.energy.hourglass + now.energy.eroded, now.energy.eroded,
                       group.plastic_strain(0, 0), h.failed()});
  });
  return samples;
}
Vec3d nowhere(const Vec3d&, double) {
  return {};
}
Motion up(double end) {
  return [=](const Vec3d&, double s) { return Vec3d{0, 0, s * end}; };
}

TEST(WeldDamage, DamageOfAUniaxialBrick) {
  const std::string material = "*MAT_SPOTWELD_DAMAGE-FAILURE_UNIAXIAL\n" + fields({1, 7.8e-9, 210000, 0.3, 400, 1000}) +
                               fields({0.2}) + fields({0.3});
  const auto samples = brick_run(material, up(0.54), nowhere, 6000);
  for (const double strain : {0.1, 0.2, 0.225, 0.25, 0.275}) {
    std::size_t i = 0;
    while (samples[i].plastic_strain < strain) ++i;
    const double w = std::max(0.0, (strain - 0.2) / 0.1);
    expect_reference("weld damage after EFAIL", fmt::format("N of a uniaxial brick at plastic strain {} [N]", strain),
                     samples[i].axial, (1.0 - w) * (400.0 + 1000.0 * strain) * area, 1e-2);
  }
  EXPECT_TRUE(samples.back().failed);
  expect_reference("weld damage after EFAIL", "work on a uniaxial brick [N mm]", samples.back().eroded, 6487.7, 2e-2);
}

/// MAT_100_DA without sheets: the defaults of the connection hold. TRUE_T is next to nothing, so that the couple of a
/// shear force over the weld's length is no bending (docs/theory/failure.md#worse-end).
std::string connection(int dgtyp, double gfad, const std::string& options = "", double dlcsn = 0.0) {
  return "*MAT_SPOTWELD_DAIMLERCHRYSLER_UNIAXIAL\n" + fields({1, 7.8e-9, 210000, 0.3}) + fields({0}) +
         fields({0, 0, 0, 1e-3, 7}) + "*DEFINE_CONNECTION_PROPERTIES\n" +
         fields({7, 0, 0, 0, static_cast<double>(dgtyp), 1}) + fields({0, 0, 0, 0, 0, 400.0, 500.0, 300.0}) +
         fields({1, 1, 1, dlcsn, 0, 0, gfad}) + options;
}

TEST(WeldConnection, FailsAtItsStrengths) {
  const auto peak = [](const Motion& top) {
    double most = 0.0, share = 0.0;
    for (const BrickSample& s : brick_run(connection(0, 0.0), top, nowhere, 4000)) {
      if (!s.failed && s.value > most) most = s.value, share = s.s;
    }
    return share;
  };
  // Strain to SN / E, shear to SS / G.
  const double u = 1.5 * (std::exp(400.0 / 210000.0) - 1.0), v = 1.5 * 300.0 / (210000.0 / 2.6);
  expect_reference("weld strengths by sheet", "tension over SN at failure of a brick (DGTYP 0)",
                   1.25 * peak(up(1.25 * u)), 1.0, 5e-3);
  expect_reference("weld strengths by sheet", "shear over SS at failure of a brick (DGTYP 0)",
                   1.25 * peak([=](const Vec3d&, double s) {
                     return Vec3d{1.25 * s * v, 0, 0};
                   }),
                   1.0, 5e-3);
}

// F = F0 (1 - u / u_max), u_max = 2 GFAD / F0; what the weld takes up is the elastic energy to the onset and GFAD.
void fades_with_its_energy(const Motion& top, const Motion& bottom, double end, const std::string& how, int points) {
  const double onset = 400.0 * area, gfad = 60.0, u_max = 2.0 * gfad / onset, stiffness = 210000.0 * area / 1.5;
  const auto samples = brick_run(connection(3, gfad), top, bottom, 8000, 1e-7, points);
  std::size_t begun = 0;
  while (samples[begun].value < 1.0) ++begun;
  const double at = samples[begun].s * end;
  expect_reference("weld strengths by sheet", "N at the onset of fading" + how + " [N]", samples[begun].axial, onset,
                   5e-3);
  std::size_t half = begun;
  while (samples[half].s * end < at + 0.5 * u_max) ++half;
  expect_reference("weld strengths by sheet", "N half way to u_max (DGTYP 3)" + how + ", over that at the onset",
                   samples[half].axial / onset, 0.5, 2e-2);
  std::size_t broken = half;
  while (broken + 1 < samples.size() && !samples[broken].failed) ++broken;
  expect_reference("weld strengths by sheet", "displacement from the onset to rupture" + how + ", over 2 GFAD / F0",
                   (samples[broken].s * end - at) / u_max, 1.0, 2e-2);
  expect_reference("weld strengths by sheet",
                   "energy taken up" + how + ", over the elastic energy to the onset and GFAD",
                   samples.back().eroded / (0.5 * onset * onset / stiffness + gfad), 1.0, 1e-2);
}

TEST(WeldConnection, FadingDissipatesGfad) {
  const double end = 0.015;
  fades_with_its_energy(up(end), nowhere, end, "", 1);
}

// The same while the whole weld turns by 70 degrees about an oblique axis.
TEST(WeldConnection, FadingTurnsWithTheWeld) {
  const double end = 0.015;
  const Vec3d axis = unit(Vec3d{1, 2, 1});
  const auto turned = [=](const Vec3d& place, const Vec3d& x, double s) {
    const double a = 1.2 * s;
    const Vec3d y = std::cos(a) * x + std::sin(a) * cross(axis, x) + (1.0 - std::cos(a)) * dot(axis, x) * axis;
    return y - place;
  };
  fades_with_its_energy(
      [=](const Vec3d& x, double s) {
        return turned(x, x + Vec3d{0, 0, s * end}, s);
      },
      [=](const Vec3d& x, double s) { return turned(x, x, s); }, end, " of a turning weld", 400);
}

// Three rates, each on the factor of its own: SN 1.0, 1.2, 1.5 at 0, 10 and 100 1/s.
TEST(WeldConnection, StrengthOverTheStrainRate) {
  const std::string factor = curve(9, {{0.0, 1.0}, {10.0, 1.2}, {100.0, 1.5}});
  const double rate[3] = {0.5, 10.0, 55.0}, expected[3] = {1.01, 1.2, 1.35};
  for (int i = 0; i < 3; ++i) {
    // sqrt(2/3 e:e) of the deviator is 2/3 of the axial strain rate where the sides are held.
    const double strain = 0.004, dt = i == 0 ? 2e-7 : 1e-7, time = strain / (1.5 * rate[i]);
    const auto samples =
        brick_run(connection(0, 0.0, factor, 9), up(1.5 * strain), nowhere, static_cast<int>(time / dt), dt);
    double most = 0.0;
    for (const BrickSample& s : samples) most = std::max(most, s.axial);
    expect_reference("weld strengths by sheet", fmt::format("N at failure over SN A at rate {:g}", rate[i]),
                     most / (400.0 * area), expected[i], 1e-2);
  }
}

/// Two sheets of one shell each, of materials 3 (t = 1.2, SN = 400) and 4 (t = 0.8, SN = 300), 1 mm apart, the upper
/// one lifted; between them a weld of 5 x 5 in n x n bricks. Materials without a record have SN = 100.
std::string two_sheets(double rank_3, double rank_4, int area_rule, int n) {
  const double duration = 4e-5, lift = 0.002;
  std::string deck = "*KEYWORD\n" + termination(duration, 0.9, 0.0, 90) + curve(90, {{0.0, 2e-8}, {1.0, 2e-8}}) +
                     "*PART\nbrick welds\n" + fields({1, 1, 1, 0, 1}) + "*SECTION_SOLID\n" + fields({1, 1}) +
                     "*HOURGLASS\n" + fields({1, 6, 1.0}) + "*MAT_SPOTWELD_DAIMLERCHRYSLER\n" +
                     fields({1, 7.8e-9, 210000, 0.3}) + fields({0}) + fields({0, 0, 0, 0, 7}) +
                     "*DEFINE_CONNECTION_PROPERTIES\n" + fields({7, 0, static_cast<double>(area_rule), 0, 0, 1}) +
                     fields({0, 0, 0, 0, 50, 100}) + fields({1, 1, 1}) + fields({3, 0, 0, 0, rank_3, 400}) +
                     fields({1, 1, 1}) + "*DEFINE_CONNECTION_PROPERTIES_ADD\n" + fields({7}) +
                     fields({4, 0, 0, 0, rank_4, 300}) + fields({1, 1, 1}) + sheet_part(3, 1.2) + sheet_part(4, 0.8) +
                     weld_contact_to_set(1, {3, 4}) + square_prism(5.0, 1.0, n).text();
  const SheetMesh low{1001, 3, {-6, -6, 0}, 1, 1, {12, 0, 0}, {0, 12, 0}};
  const SheetMesh up{2001, 4, {-6, -6, 1}, 1, 1, {12, 0, 0}, {0, 12, 0}};
  deck += low.text() + up.text() + fixed({low.node(0, 0), low.node(1, 0), low.node(0, 1), low.node(1, 1)});
  int first_curve = 100;
  for (const int node : {up.node(0, 0), up.node(1, 0), up.node(0, 1), up.node(1, 1)}) {
    deck += driven(
        node,
        [=](double s) {
          return std::array<double, 6>{0, 0, s * lift};
        },
        duration, 1, first_curve);
    first_curve += 6;
  }
  return deck + "*END\n";
}

// Sabotage to be caught: the higher rank, the defaults although a sheet has a record, the area of the bricks where
// AREAEQ wants that of 5 sqrt(t).
TEST(WeldConnection, SheetsChooseTheStrength) {
  const auto stress = [](double rank_3, double rank_4, int area_rule, int n, double real_area) {
    Experiment run(two_sheets(rank_3, rank_4, area_rule, n));
    double most = 0.0;
    run.run([&](const impact::Snapshot& now) {
      most = std::max(most, now.components.welds.history(0)->resultants().axial);
    });
    EXPECT_EQ(run.ties().welds.size(), 1u);
    EXPECT_TRUE(run.simulation().components().welds.history(0)->failed());
    return most / real_area;
  };
  expect_reference("weld strengths by sheet", "stress at failure, sheet 1 of lower RANK [MPa]",
                   stress(1, 2, 0, 1, 25.0), 400.0, 1e-2);
  expect_reference("weld strengths by sheet", "stress at failure, sheet 2 of lower RANK [MPa]",
                   stress(90, 80, 0, 1, 25.0), 300.0, 1e-2);
  expect_reference("weld strengths by sheet", "stress at failure on 19.635 t_min (AREAEQ 1) [MPa]",
                   stress(1, 2, 1, 1, 15.708), 400.0, 1e-2);
  expect_reference("weld strengths by sheet", "stress at failure of an assembly of 4 bricks [MPa]",
                   stress(3, 2, 0, 2, 25.0), 300.0, 1e-2);
}

}  // namespace
}  // namespace nugget::verify
