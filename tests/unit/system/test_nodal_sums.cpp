// SPDX-License-Identifier: Apache-2.0
#include "system/nodal_sums.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "deck/deck.hpp"
#include "reading/build.hpp"
#include "system/system.hpp"

namespace nugget::system {
namespace {

/// A sheet of `side` x `side` shells, on which as many bricks stand, with its nodes.
std::string text_of_sheet_with_bricks(int side) {
  std::string nodes, shells, bricks;
  char line[200];
  const int row = side + 1, layer = row * row;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < row; ++j)
      for (int i = 0; i < row; ++i) {
        std::snprintf(line, sizeof line, "%d,%d,%d,%g\n", k * layer + row * j + i + 1, 10 * i, 10 * j,
                      0.01 * i * i + 8 * k);
        nodes += line;
      }
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const int n = row * j + i + 1, e = side * j + i + 1, u = n + layer;
      std::snprintf(line, sizeof line, "%d,1,%d,%d,%d,%d\n", e, n, n + 1, n + row + 1, n + row);
      shells += line;
      std::snprintf(line, sizeof line, "%d,2,%d,%d,%d,%d,%d,%d,%d,%d\n", e, n, n + 1, n + row + 1, n + row, u, u + 1,
                    u + row + 1, u + row);
      bricks += line;
    }
  return "*KEYWORD\n*CONTROL_TERMINATION\n1e-3\n*PART\nsheet\n1,1,1\n*PART\nbricks\n2,2,1\n*SECTION_SHELL\n1,2\n"
         "1.0,1.0,1.0,1.0\n*SECTION_SOLID\n2,1\n*MAT_ELASTIC\n1,7.85e-9,210000.0,0.3\n*NODE\n" +
         nodes + "*ELEMENT_SHELL\n" + shells + "*ELEMENT_SOLID\n" + bricks + "*END\n";
}

class ThreadsUntilTheEnd {
 public:
  explicit ThreadsUntilTheEnd(int count) : before_(threads()) { set_threads(count); }
  ~ThreadsUntilTheEnd() { set_threads(before_); }
  ThreadsUntilTheEnd(const ThreadsUntilTheEnd&) = delete;
  ThreadsUntilTheEnd& operator=(const ThreadsUntilTheEnd&) = delete;

 private:
  int before_;
};

// Sabotage to be caught: a node between two stretches taken for one within, the stretch's last node left out, a moment
// looked for one slot behind its force.
TEST(NodalSums, AreThoseOfTheSlotsInTheOrderOfElements) {
  Findings findings;
  const model::Model model = reading::build(deck::read_text(text_of_sheet_with_bricks(40), findings), findings);
  const weld::Ties ties = weld::tie(model, findings);
  ASSERT_EQ(findings.errors(), 0);
  for (const int count : {1, 3, 16}) {  // as many lengths of a stretch
    const ThreadsUntilTheEnd these(count);
    System system(model, ties, findings);
    State state = system.initial_state();
    std::mt19937 draw(7);
    std::uniform_real_distribution<double> speed(-1e3, 1e3);
    for (Row& v : state.v) v = {speed(draw), speed(draw), speed(draw), 0.0};
    state.dt = 1e-7;
    for (std::size_t k = 0; k < state.x.size(); ++k) add(state.x[k], state.dt * vec(state.v[k]));
    for (Row& f : state.f) f = {1.0, 2.0, 3.0, 0.0};  // of the cycle before
    system.internal_force(state);

    std::vector<Vec3d> force(system.nodes), moment(system.nodes);
    for (std::size_t g = 0; g < system.groups.size(); ++g) {
      const ElementGroup& group = *system.groups[g];
      for (std::size_t e = 0; e < group.size(); ++e)
        for (int a = 0; a < group.nodes_per_element; ++a) {
          const System::ElementLocation location{static_cast<int>(g), static_cast<int>(e)};
          force[at(group.nodes(e)[a])] -= system.nodal_force(location, a);
          moment[at(group.nodes(e)[a])] -= system.nodal_moment(location, a);
        }
    }
    double largest_moment = 0.0;
    for (std::size_t k = 0; k < system.nodes; ++k) {
      EXPECT_EQ(state.f[k].x, force[k].x) << count << " threads, node " << k;
      EXPECT_EQ(state.f[k].y, force[k].y);
      EXPECT_EQ(state.f[k].z, force[k].z);
      EXPECT_EQ(state.m[k].x, moment[k].x);
      EXPECT_EQ(state.m[k].y, moment[k].y);
      EXPECT_EQ(state.m[k].z, moment[k].z);
      largest_moment = std::max(largest_moment, norm(moment[k]));
    }
    EXPECT_GT(largest_moment, 0.0);
  }
}

}  // namespace
}  // namespace nugget::system
