// SPDX-License-Identifier: Apache-2.0
#include "system/system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/parallel.hpp"
#include "deck/deck.hpp"
#include "reading/build.hpp"

namespace nugget::system {
namespace {

/// Two sheets of 6 x 6 shells, one weld, a rigid plate on one edge, a point mass.
std::string text(const std::string& more = {}) {
  std::string nodes, shells;
  const auto line = [](const char* format, auto... values) {
    char buffer[160];
    std::snprintf(buffer, sizeof buffer, format, values...);
    return std::string(buffer);
  };
  for (int s = 0; s < 2; ++s)
    for (int j = 0; j <= 6; ++j)
      for (int i = 0; i <= 6; ++i)
        nodes += line("%8d%16g%16g%16g\n", 100 * s + 7 * j + i + 1, 10.0 * i, 10.0 * j, double(s));
  for (int s = 0; s < 2; ++s)
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 6; ++i) {
        const int n = 100 * s + 7 * j + i + 1;
        shells +=
            line("%8d%8d%8d%8d%8d%8d\n", 100 * s + 6 * j + i + 1, s == 1 && j == 5 ? 3 : s + 1, n, n + 1, n + 8, n + 7);
      }
  nodes +=
      "     901              27              13               0\n     902              27              13              "
      " 1\n";
  return "*KEYWORD\n*CONTROL_TERMINATION\n1e-3\n*PART\nlower\n1,1,1\n*PART\nupper\n2,1,1\n*PART\nrigid\n3,1,3\n*"
         "PART\nwelds\n4,4,4\n"
         "*SECTION_SHELL\n1,2\n1.0,1.0,1.0,1.0\n*MAT_ELASTIC\n1,7.85e-9,210000.0,0.3\n*MAT_RIGID\n3,7.85e-9,210000.0,0."
         "3\n\n\n"
         "*SECTION_BEAM\n4,9,1.0,2,1\n6.0,6.0\n*MAT_SPOTWELD\n4,7.8e-9,210000.0,0.3,400.0,1000.0\n\n*CONTACT_"
         "SPOTWELD\n4,1,3,2\n0\n1.0,1.0\n"
         "*SET_PART_LIST\n1\n1,2\n*NODE\n" +
         nodes + "*ELEMENT_SHELL\n" + shells +
         "*ELEMENT_BEAM\n     901       4     901     902\n*ELEMENT_MASS\n       1      25          1.0e-6\n" + more +
         "*END\n";
}

struct Assembled {
  Findings findings;
  model::Model model;
  weld::Ties ties;
  System system;
  Assembled()
      : model(reading::build(deck::read_text(text(), findings), findings)),
        ties(weld::tie(model, findings)),
        system(model, ties, findings) {
    for (const Finding& f : findings.all()) EXPECT_NE(f.severity, Severity::error) << to_string(f);
  }
};

/// What is wrong with the model and more keywords.
std::string errors(const std::string& more) {
  Findings findings;
  const model::Model model = reading::build(deck::read_text(text(more), findings), findings);
  weld::Ties ties = weld::tie(model, findings);
  const System system(model, ties, findings);
  std::string all;
  for (const Finding& f : findings.all())
    if (f.severity == Severity::error) all += to_string(f) + "\n";
  return all;
}

// A run sets free what only the state at time 0 needs: whoever asks for that again must not get zeros.
TEST(System, TheStartIsNotAskedForTwice) {
  Assembled one;
  one.model.initial_velocity.assign(one.model.nodes.size(), {1.0, 2.0, 3.0});
  EXPECT_EQ(one.system.initial_state().v[0].y, 2.0);
  const std::vector<double> mass = one.system.mass, inertia = one.system.inertia;
  one.system.forget_start(one.model);
  EXPECT_EQ(one.model.initial_velocity.capacity() + one.model.initial_spin.capacity(), 0u);
  EXPECT_THROW(one.system.initial_state(), std::logic_error);
  one.system.transfer_dependent_mass();
  EXPECT_EQ(one.system.mass, mass);
  EXPECT_EQ(one.system.inertia, inertia);
}

// The side of a shell of a rigid part moves its node as the part does. The other end of the second side deforms.
TEST(System, ANodeHangsOnTheSideOfARigidShell) {
  EXPECT_EQ(errors("*CONSTRAINED_ADAPTIVITY\n144,143,145\n"), "");
  EXPECT_NE(errors("*CONSTRAINED_ADAPTIVITY\n137,144,130\n").find("node 137 is made dependent twice: by rigid part 3"),
            std::string::npos);
}

// Sabotage to be caught: mass left on tied nodes, or not handed over; a body's nodes counted twice.
TEST(System, HandingOverKeepsTheTotalMass) {
  const Assembled a;
  const double sheets = 2.0 * 3600.0 * 7.85e-9, weld = 7.8e-9 * 9.0 * 3.14159265358979, total = sheets + weld + 1e-6;
  double own = 0.0, after = 0.0;
  for (double m : a.system.own_mass) own += m;
  for (double m : a.system.mass) after += m;
  ASSERT_EQ(a.system.bodies.size(), 1u);
  after += a.system.bodies[0].mass;
  EXPECT_NEAR(own, total, 1e-12 * total);
  EXPECT_NEAR(after, total, 1e-12 * total);
  EXPECT_NEAR(a.system.masses().physical, total, 1e-12 * total);
  for (std::size_t k = 0; k < a.system.nodes; ++k)
    if (a.system.map.dependent(static_cast<int>(k))) {
      EXPECT_EQ(a.system.mass[k], 0.0);
    }
  // Of the shells on the rigid edge, 60 x 10; half of the neighbouring row's mass goes with the shared nodes.
  EXPECT_NEAR(a.system.bodies[0].mass, 900.0 * 7.85e-9, 1e-12);
  EXPECT_NEAR(a.system.bodies[0].center0.x, 30.0, 1e-12);
}

TEST(System, NodesAreRenumberedBothWays) {
  const Assembled a;
  for (std::size_t k = 0; k < a.system.nodes; ++k)
    EXPECT_EQ(a.system.node_of[a.system.model_node[k]], static_cast<int>(k));
  EXPECT_EQ(a.system.all_nodes(), a.system.nodes + 1);
  EXPECT_EQ(a.system.shell_location[0].group >= 0, true);
  EXPECT_EQ(a.system.shell_location.back().group, -1);  // rigid
}

// Sabotage to be caught: forces added up in the order in which threads finish.
TEST(System, ForcesDoNotDependOnThreads) {
  Rows reference;
  for (int count : {1, 2, 3}) {
    set_threads(count);
    Assembled a;
    State state = a.system.initial_state();
    state.dt = 1e-7;
    for (std::size_t k = 0; k < a.system.all_nodes(); ++k) {
      const Vec3d x = vec(state.x[k]);
      set(state.v[k], 1e3 * Vec3d{std::sin(x.x), std::cos(x.y), std::sin(x.x + x.y)});
      set(state.x[k], x + state.dt * vec(state.v[k]));
    }
    a.system.internal_force(state);
    Vec3d sum;
    for (const Row& f : state.f) sum += vec(f);
    EXPECT_LT(norm(sum), 1e-9);
    EXPECT_GT(norm(vec(state.f[10])), 1e-3);
    if (reference.empty()) reference = state.f;
    for (std::size_t k = 0; k < state.f.size(); ++k) ASSERT_EQ(norm(vec(state.f[k]) - vec(reference[k])), 0.0);
  }
  set_threads(1);
}

}  // namespace
}  // namespace nugget::system
