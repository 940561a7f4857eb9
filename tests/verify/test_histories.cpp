// SPDX-License-Identifier: Apache-2.0
// Section forces against the momentum of what lies beyond the section, element histories against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "impact/recording/cross_sections.hpp"
#include "impact/recording/element_histories.hpp"
#include "impact/recording/histories.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double modulus = 210000.0, density = 7.85e-9;

/// Largest difference of two vectors, of a scale.
double difference(const Vec3d& a, const Vec3d& b, double scale) {
  return norm(a - b) / scale;
}

std::string solid_set(int id, const std::vector<int>& elements) {
  std::string text = fmt::format("*SET_SOLID\n{:10d}", id);
  for (std::size_t i = 0; i < elements.size(); ++i)
    text += fmt::format("{}{:10d}", i % 8 == 0 ? "\n" : "", elements[i]);
  return text + '\n';
}

/// A bar of 12 x 2 x 2 bricks, 120 x 20 x 10, held at x = 0 and loaded obliquely at its other end.
struct LoadedBar {
  static constexpr double load_x = 3600.0, load_z = 450.0;  // of 9 nodes each, to the digit
  Specimen specimen;
  Grid grid;
  std::vector<int> end;

  LoadedBar() {
    specimen.card("MAT_ELASTIC", {1, density, modulus, 0.3})
        .card("SECTION_SOLID", {1, 1})
        .card("CONTROL_TERMINATION", {2e-4})
        .part(1, 1, 1)
        .text(constant_curve(1));
    grid = specimen.bricks(1, {}, {120.0, 20.0, 10.0}, {12, 2, 2});
    end = grid.across(12);
    const double nodes = static_cast<double>(end.size());
    specimen.node_set(1, grid.across(0)).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1});
    specimen.node_set(2, end)
        .card("LOAD_NODE_SET", {2, 1, 1, load_x / nodes})
        .card("LOAD_NODE_SET", {2, 3, 1, load_z / nodes});
  }
};

// The force through a section is the load less the inertia of what lies beyond it; its moment likewise, about the
// centroid. Sabotage: the sum over all elements at the nodes; moments about the origin; a node counted twice.
TEST(SectionForces, BalanceLoadAndInertiaOfTheBarBeyond) {
  LoadedBar bar;
  // The set form at x = 50: the bricks with 40 < x < 50, on the near side, and their far nodes. Tension is positive.
  std::vector<int> bricks;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j) bricks.push_back(1 + 4 + 12 * j + 24 * k);
  bar.specimen.node_set(11, bar.grid.across(5)).text(solid_set(12, bricks));
  bar.specimen.text("*DATABASE_CROSS_SECTION_SET_ID\n         7by sets\n" + fields({11, 12}));
  // The plane form at x = 45 cuts the same bricks and finds the same nodes.
  bar.specimen.text("*DATABASE_CROSS_SECTION_PLANE_ID\n         8by a plane\n" + fields({0, 45, 0, 0, 46, 0, 0}) +
                    fields({0, 0, 0}));
  Experiment experiment(bar.specimen.deck());
  const impact::CrossSections sections(experiment.system());

  double force_error = 0.0, moment_error = 0.0, same = 0.0, area = 0.0, centroid = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.velocity_interval() <= 0.0) return;
    const output::SecforcState state = sections.state(now);
    ASSERT_EQ(state.rows.size(), 2u);
    const output::SecforcRow &by_sets = state.rows[0], &by_plane = state.rows[1];
    EXPECT_EQ(by_sets.id, 7);
    EXPECT_EQ(by_plane.id, 8);
    const Vec3d share = (1.0 / static_cast<double>(bar.end.size())) * Vec3d{LoadedBar::load_x, 0.0, LoadedBar::load_z};
    for (const output::SecforcRow& row : state.rows) {
      // All nodes from the section's on: the elements among them are in balance with themselves, so that what is left
      // of load less inertia is what the near bricks have at the section's nodes.
      Vec3d force{}, moment{};
      for (int i = 5; i <= 12; ++i)
        for (const int id : bar.grid.across(i)) {
          const std::size_t k = experiment.node(id);
          const Vec3d f = (i == 12 ? share : Vec3d{}) - experiment.system().mass[k] * now.acceleration(k);
          force += f;
          moment += cross(vec(now.state.x[k]) - row.centroid, f);
        }
      force_error = std::max(force_error, difference(row.force, force, LoadedBar::load_x));
      moment_error = std::max(moment_error, difference(row.moment, moment, 70.0 * LoadedBar::load_z));
    }
    same = std::max(same, difference(by_sets.force, by_plane.force, LoadedBar::load_x));
    if (now.state.cycle == 0) {
      area = std::abs(by_plane.area - 200.0) + std::abs(by_sets.area - 200.0);
      centroid = norm(by_plane.centroid - Vec3d{45, 10, 5}) + norm(by_sets.centroid - Vec3d{50, 10, 5});
    }
  });
  expect_reference("secforc", "bar: force through a section, of the load: largest error", force_error, 0.0, 1e-12, 1.0);
  expect_reference("secforc", "bar: moment through a section: largest error", moment_error, 0.0, 1e-11, 1.0);
  expect_reference("secforc", "bar: sets against a plane through the same bricks", same, 0.0, 1e-14, 1.0);
  expect_reference("secforc", "bar: area, of 200", area, 0.0, 1e-12, 200.0);
  expect_reference("secforc", "bar: centroid", centroid, 0.0, 1e-12, 50.0);
}

// A plane at 45 degrees through a bar 20 x 10 has sqrt(2) times its area; bounded planes leave out what reaches over
// their edges. Sabotage: the corners of a cut brick in any order; the bound forgotten.
TEST(SectionForces, AreasOfObliqueAndBoundedPlanes) {
  LoadedBar bar;
  bar.specimen.text("*DATABASE_CROSS_SECTION_PLANE\n" + fields({0, 61, 0, 0, 62, 0, 1}) + fields({0, 0, 0}));
  // Bounded: M = normal x L along z from the origin (45, 0, 0), 5 high: the lower row of bricks only.
  bar.specimen.text("*DATABASE_CROSS_SECTION_PLANE\n" + fields({0, 45, 0, 0, 46, 0, 0}) + fields({45, 1, 0, 20, 5}));
  bar.specimen.text("*DATABASE_CROSS_SECTION_PLANE\n" + fields({0, 45, 0, 0, 46, 0, 0, 15}) + fields({0, 0, 0}));
  Experiment experiment(bar.specimen.deck());
  const impact::CrossSections sections(experiment.system());
  experiment.run(
      [&](const impact::Snapshot& now) {
        if (now.state.cycle > 0) return;
        const auto rows = sections.state(now).rows;
        ASSERT_EQ(rows.size(), 3u);
        expect_reference("secforc", "plane at 45 degrees: area", rows[0].area, 200.0 * std::sqrt(2.0), 1e-12);
        expect_reference("secforc", "plane bounded by its edges: area", rows[1].area, 100.0, 1e-12);
        // Circle of 15 about (45, 0, 0): corners (10, 0), (10, 5), (10, 10) lie in it, (20, ..) do not.
        expect_reference("secforc", "plane bounded by a circle: area", rows[2].area, 100.0, 1e-12);
      },
      1e-6);
}

// A strip of shells bent by a force at its end: shear, bending moment and normal force in the section's own axes.
TEST(SectionForces, OfShellsHaveMomentsInLocalAxes) {
  Specimen specimen;
  specimen.card("MAT_ELASTIC", {1, density, modulus, 0.3})
      .card("SECTION_SHELL", {1, 2, 0.8333, 3})
      .text(fields({2, 2, 2, 2}))
      .card("CONTROL_TERMINATION", {2e-4})
      .part(1, 1, 1)
      .text(constant_curve(1));
  const Grid grid = specimen.shells(1, {}, {80.0, 20.0, 0.0}, 8, 2);
  specimen.node_set(1, grid.across(0)).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
  specimen.node_set(2, grid.across(8)).card("LOAD_NODE_SET", {2, 3, 1, 5.0});
  // Local x along global z, local y along global x.
  specimen.text("*DEFINE_COORDINATE_SYSTEM\n" + fields({5, 0, 0, 0, 0, 0, 1}) + fields({1, 0, 0}));
  specimen.text("*DATABASE_CROSS_SECTION_PLANE\n" + fields({0, 35, 0, 0, 36, 0, 0}) + fields({0, 0, 0, 0, 0, 5, 2}));
  Experiment experiment(specimen.deck());
  const impact::CrossSections sections(experiment.system());
  double worst = 0.0, area = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.velocity_interval() <= 0.0) return;
    const output::SecforcRow row = sections.state(now).rows.at(0);
    Vec3d force{}, moment{};
    for (int i = 4; i <= 8; ++i)
      for (const int id : grid.across(i)) {
        const std::size_t k = experiment.node(id);
        const system::System& s = experiment.system();
        const Vec3d f = Vec3d{0, 0, i == 8 ? 5.0 : 0.0} - s.mass[k] * now.acceleration(k);
        force += f;
        moment += cross(vec(now.state.x[k]) - row.centroid, f) - s.inertia[k] * now.rotary_acceleration(k);
      }
    worst = std::max(worst, difference(row.force, {force.z, force.x, force.y}, 15.0));
    worst = std::max(worst, difference(row.moment, {moment.z, moment.x, moment.y}, 15.0 * 45.0));
    EXPECT_EQ(row.axes, output::SectionAxes::system);
    if (now.state.cycle == 0) area = row.area;
  });
  expect_reference("secforc", "strip: force and moment in local axes, of load and moment: largest error", worst, 0.0,
                   1e-10, 1.0);
  expect_reference("secforc", "strip: area 20 x 2", area, 40.0, 1e-12);
}

// The reaction of a driven node is what its elements ask of it, and its own inertia.
TEST(NodalForceGroups, AreTheReactionsOfDrivenNodes) {
  Specimen specimen;
  specimen.card("MAT_ELASTIC", {1, density, modulus, 0.3})
      .card("SECTION_SOLID", {1, 1})
      .card("CONTROL_TERMINATION", {1e-4})
      .card("CONTROL_TIMESTEP", {0, 0.5})
      .part(1, 1, 1)
      .text(smooth_ramp(1, 1e-4, 0.1));
  const Grid grid = specimen.bricks(1, {}, {50.0, 10.0, 10.0}, {5, 1, 1});
  specimen.node_set(1, grid.across(0)).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1});
  specimen.node_set(2, grid.across(5)).card("BOUNDARY_PRESCRIBED_MOTION_SET", {2, 1, 2, 1});
  specimen.card("DATABASE_NODAL_FORCE_GROUP", {2});
  Experiment experiment(specimen.deck());
  double worst = 0.0, work = 0.0, reaction_work = 0.0, largest = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.velocity_interval() <= 0.0) return;
    const output::NodforState state = now.components.nodal_forces.state(now.state);
    std::map<int, Vec3d> inner;
    work = reaction_work = 0.0;
    for (const output::NodforRow& row : state.groups.at(0).rows) {
      inner[row.node] = row.force;
      work += row.energy;
    }
    for (const impact::Supports::Reaction& r : now.components.supports.motion_reactions()) {
      const auto k = at(r.node);
      const int id = experiment.model().nodes.id[experiment.system().model_node[k]];
      const double expected = r.force.x - experiment.system().mass[k] * now.acceleration(k).x;
      worst = std::max(worst, std::abs(inner.at(id).x - expected));
      largest = std::max(largest, std::abs(inner.at(id).x));
      reaction_work += r.energy;
    }
  });
  ASSERT_GT(largest, 100.0);
  expect_reference("nodfor", "driven nodes: reaction less inertia, largest error of the largest force", worst / largest,
                   0.0, 1e-12, 1.0);
  // The nodes come to rest at the end, so that their own inertia has taken no work.
  expect_reference("nodfor", "driven nodes: work, of that of the reactions", work / reaction_work, 1.0, 2e-3);
}

/// Two shells, 10 x 10 each, stretched along x at a rate that brings them to `stretch` times their length; lateral
/// motion and rotations held.
std::string stretched_shells(double stretch, const std::string& more) {
  Specimen specimen;
  specimen.card("MAT_ELASTIC", {1, density, modulus, 0.3})
      .card("SECTION_SHELL", {1, 2, 1, 3})
      .text(fields({1, 1, 1, 1}))
      .card("CONTROL_TERMINATION", {1e-4})
      .card("DATABASE_EXTENT_BINARY", {0, 0, 3, 1})
      .part(1, 1, 1)
      .text(constant_curve(1));
  const Grid grid = specimen.shells(1, {}, {20.0, 10.0, 0.0}, 2, 1);
  const double speed = (stretch - 1.0) * 20.0 / 1e-4;
  for (int i = 0; i <= 2; ++i)
    specimen.node_set(1 + i, grid.across(i))
        .card("BOUNDARY_SPC_SET", {1.0 + i, 0, 0, 1, 1, 1, 1, 1})
        .card("BOUNDARY_PRESCRIBED_MOTION_SET", {1.0 + i, 1, 0, 1, 0.5 * i * speed});
  specimen.text("*DATABASE_HISTORY_SHELL_ID\n         2the right one\n").text(more);
  return specimen.deck();
}

// Sabotage: strains as displacement over length; the middle layer left out; stress of a rigid rotation.
TEST(ElementHistories, StretchedShellHasLogarithmicStrainsAndHookesStress) {
  constexpr double stretch = 1.05, nu = 0.3;
  Experiment experiment(stretched_shells(stretch, "*CONTROL_ACCURACY\n" + fields({1})));
  output::EloutState last;
  run_to_end(experiment, [&](const impact::Snapshot& now) { last = impact::elout_state(now); });
  ASSERT_EQ(last.shells.size(), 1u);
  ASSERT_TRUE(last.strains);
  const output::EloutShell& shell = last.shells[0];
  EXPECT_EQ(shell.id, 2);
  EXPECT_EQ(shell.part, 1);
  ASSERT_EQ(shell.layers.size(), 3u);
  const double strain = std::log(stretch), stress = modulus / (1.0 - nu * nu) * strain;
  for (int k = 0; k < 3; ++k) {
    const auto& s = shell.layers[k].stress;
    expect_reference("elout", fmt::format("stretched shell, layer {}: sig-xx = E/(1-nu^2) ln 1.05", k + 1), s[0],
                     stress, 1e-4);
    expect_reference("elout", fmt::format("stretched shell, layer {}: sig-yy", k + 1), s[1], nu * stress, 1e-4);
  }
  for (const auto* e : {&shell.lower_strain, &shell.upper_strain}) {
    expect_reference("elout", "stretched shell: eps-xx = ln 1.05", (*e)[0], strain, 1e-4);
    expect_reference("elout", "stretched shell: eps-zz = -nu/(1-nu) eps-xx", (*e)[2], -nu / (1.0 - nu) * strain, 1e-4);
    expect_reference("elout", "stretched shell: eps-yy and shear strains", std::abs((*e)[1]) + std::abs((*e)[3]), 0.0,
                     1e-9, 1.0);
  }
}

// A strip of shells and a brick turn by 90 degrees as rigid bodies with a stress in them: it turns with them, and there
// are no strains. Sabotage: strains added up in global axes.
TEST(ElementHistories, StrainsTurnWithTheElement) {
  Specimen specimen;
  specimen.card("MAT_ELASTIC", {1, density, modulus, 0.3})
      .card("SECTION_SHELL", {1, 2, 1, 3})
      .text(fields({1, 1, 1, 1}))
      .card("SECTION_SOLID", {2, 1})
      .card("DATABASE_EXTENT_BINARY", {0, 0, 3, 1})
      .card("CONTROL_TIMESTEP", {0, 0.5})
      .card("CONTROL_ACCURACY", {1})
      .part(1, 1, 1)
      .part(2, 2, 1);
  const Grid shells = specimen.shells(1, {}, {20.0, 10.0, 0.0}, 2, 1);
  specimen.bricks(2, {0, 0, 20}, {10.0, 10.0, 10.0}, {1, 1, 1});
  constexpr double omega = 500.0, time = 1.5707963267948966 / omega;
  specimen.card("CONTROL_TERMINATION", {time});
  specimen.text("*INITIAL_VELOCITY_GENERATION\n" + fields({0, 0, omega}) + fields({10, 5, 0, 0, 1, 0}));
  specimen.card("DATABASE_HISTORY_SHELL", {1}).card("DATABASE_HISTORY_SOLID", {1});
  Experiment experiment(specimen.deck());
  double shell = 0.0, brick = 0.0, turned = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const output::EloutState state = impact::elout_state(now);
    for (std::size_t c = 0; c < 6; ++c) {
      shell = std::max(shell, std::abs(state.shells.at(0).lower_strain[c]));
      brick = std::max(brick, std::abs(state.solids.at(0).strain[c]));
    }
    turned = experiment.displacement(now, shells(0, 0)).z;
  });
  EXPECT_GT(std::abs(turned), 9.0) << "it did turn";
  // What is there is the strain of the centrifugal force, rho omega^2 r^2 / E.
  const double centrifugal = density * omega * omega * 100.0 / modulus;
  EXPECT_LT(shell, 5.0 * centrifugal);
  EXPECT_LT(brick, 50.0 * centrifugal) << "its centre is 25 away from the axis";
}

}  // namespace
}  // namespace nugget::verify
