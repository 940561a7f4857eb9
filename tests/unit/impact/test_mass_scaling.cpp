// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "deck/deck.hpp"
#include "impact/conditions/body_load.hpp"
#include "reading/build.hpp"
#include "system/system.hpp"

// Masses that grow while a model runs: what is brought up to date node by node is what is found from all elements.
namespace nugget::impact {
namespace {

/// Two sheets of 6 x 6 shells, the last row of the upper one rigid, welded inside and beside the rigid row, under
/// gravity.
std::string deck() {
  std::string nodes, shells;
  const auto row = [](const char* form, auto... values) {
    char buffer[160];
    std::snprintf(buffer, sizeof buffer, form, values...);
    return std::string(buffer);
  };
  for (int s = 0; s < 2; ++s)
    for (int n = 0; n < 49; ++n)
      nodes += row("%d,%g,%g,%g\n", 100 * s + n + 1, 10.0 * (n % 7), 10.0 * (n / 7), double(s));
  for (int s = 0; s < 2; ++s)
    for (int e = 0; e < 36; ++e) {
      const int n = 100 * s + 7 * (e / 6) + e % 6 + 1;
      shells += row("%d,%d,%d,%d,%d,%d\n", 100 * s + e + 1, s == 1 && e >= 30 ? 3 : s + 1, n, n + 1, n + 8, n + 7);
    }
  nodes += "901,27.0,13.0,0.0\n902,27.0,13.0,1.0\n903,33.0,53.0,0.0\n904,33.0,53.0,1.0\n";
  return "*KEYWORD\n*CONTROL_TERMINATION\n1e-3\n*CONTROL_TIMESTEP\n0,0.9,0,0,-2.2e-6\n*DEFINE_CURVE\n7\n0,1\n1,1\n"
         "*LOAD_BODY_Z\n7,9810.0\n*PART\n\n1,1,1\n*PART\n\n2,1,1\n*PART\n\n3,1,3\n*PART\n\n4,4,4\n"
         "*SECTION_SHELL\n1,2\n1.0,1.0,1.0,1.0\n*MAT_ELASTIC\n1,7.85e-9,210000.0,0.3\n*MAT_RIGID\n3,7.85e-9,210000.0,"
         "0.3\n\n\n*SECTION_BEAM\n4,9,1.0,2,1\n6.0,6.0\n*MAT_SPOTWELD\n4,7.8e-9,210000.0,0.3,400.0,1000.0\n\n"
         "*CONTACT_SPOTWELD\n4,1,3,2\n0\n1.0,1.0\n*SET_PART_LIST\n1\n1,2,3\n*NODE\n" +
         nodes + "*ELEMENT_SHELL\n" + shells + "*ELEMENT_BEAM\n901,4,901,902\n902,4,903,904\n*END\n";
}

/// What the load puts on the nodes.
std::vector<double> forces(ActingLoad<model::BodyLoad>& load, system::State state) {
  std::fill(state.f.begin(), state.f.end(), Row{});
  double work = 0.0;
  load.apply(state, 0.0, work);
  std::vector<double> z;
  for (const Row& f : state.f) z.push_back(f.z);
  return z;
}

// Sabotage: nodes that welds are tied to are left as they are; the share without weight of the elements scaled last
// only.
TEST(MassScaling, BringsUpToDateWhatAllElementsGive) {
  Findings findings;
  model::Model model = reading::build(deck::read_text(deck(), findings), findings);
  weld::Ties ties = weld::tie(model, findings);
  system::System system(model, ties, findings);
  for (const Finding& f : findings.all()) ASSERT_NE(f.severity, Severity::error) << to_string(f);
  system::State state = system.initial_state();
  state.dt = 0.0;
  system.internal_force(state);
  ASSERT_TRUE(system.scale_mass(true));
  ActingLoad<model::BodyLoad> load(model.body_loads.front(), system);

  // Shells away from the welds, under one, and the welds themselves become smaller one after the other.
  const std::vector<std::vector<int>> moved{{9}, {18, 118}, {901, 903}, {9, 44, 902}};
  std::size_t changes = 0;
  for (const std::vector<int>& nodes : moved) {
    for (const int id : nodes) {
      Row& x = state.x[at(system.node_of[model.node_index(id)])];
      x = id < 900 ? Row{x.x + 4.0, x.y + 3.0, x.z, 0.0} : Row{x.x, x.y, x.z + (id % 2 == 1 ? 0.2 : -0.2), 0.0};
    }
    system.internal_force(state);
    const std::vector<double> mass = system.mass, inertia = system.inertia, own = system.own_mass;
    ASSERT_TRUE(system.scale_mass(false));
    const std::vector<int> changed(system.nodes_of_changed_mass().begin(), system.nodes_of_changed_mass().end());
    EXPECT_TRUE(std::is_sorted(changed.begin(), changed.end()));
    for (std::size_t k = 0; k < system.nodes; ++k) {
      const bool has = mass[k] != system.mass[k] || inertia[k] != system.inertia[k] || own[k] != system.own_mass[k];
      EXPECT_LE(has, std::binary_search(changed.begin(), changed.end(), static_cast<int>(k))) << system.node_id(int(k));
      changes += has;
    }
    load.update_masses(changed);
    ActingLoad<model::BodyLoad> anew(model.body_loads.front(), system);
    EXPECT_EQ(forces(load, state), forces(anew, state));

    const std::vector<double> new_mass = system.mass, new_inertia = system.inertia;
    system.transfer_dependent_mass();
    EXPECT_EQ(system.mass, new_mass);
    EXPECT_EQ(system.inertia, new_inertia);
  }
  EXPECT_GE(changes, 20u);
  EXPECT_FALSE(system.scale_mass(false));
}

}  // namespace
}  // namespace nugget::impact
