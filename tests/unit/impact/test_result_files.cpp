// SPDX-License-Identifier: Apache-2.0
#include "impact/recording/result_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "base/parallel.hpp"
#include "deck/deck.hpp"
#include "impact/simulation/simulation.hpp"
#include "reading/build.hpp"
#include "unit/output/scratch.hpp"

namespace nugget::impact {
namespace {

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

int count(const std::string& text, const std::string& what) {
  int n = 0;
  for (std::size_t i = text.find(what); i != std::string::npos; i = text.find(what, i + what.size())) ++n;
  return n;
}

/// Reads, ties, runs, writes into `folder`.
void run(const std::string& text, const std::filesystem::path& folder) {
  Findings findings;
  const model::Model model = reading::build(deck::read_text(text, findings), findings);
  const weld::Ties ties = weld::tie(model, findings);
  system::System system(model, ties, findings);
  Simulation simulation(system, findings);
  for (const Finding& f : findings.all()) ASSERT_NE(f.severity, Severity::error) << to_string(f);
  ResultFiles files(system, folder, {"rhythm", "nugget test", "01/01/2000"});
  const Outcome outcome = simulation.run({}, files, {});
  EXPECT_EQ(outcome.termination, Termination::normal) << outcome.message;
}

// A step of 3e-3 and marks every 1e-2: written at the last step that is not beyond a mark, and once at the end.
// Sabotage to be caught: a mark that slides by what the step overshot; the last state written twice or not at all.
TEST(ResultFiles, WriteAtTheirOwnRhythm) {
  const output::Scratch scratch;
  run("*KEYWORD\n*CONTROL_TERMINATION\n0.1\n*CONTROL_TIMESTEP\n0,0.9,0,0,0,90\n*DEFINE_CURVE\n90\n0.0,3e-3\n1.0,3e-3\n"
      "*NODE\n1,0.0,0.0,0.0\n*ELEMENT_MASS\n1,1,2.0\n*INITIAL_VELOCITY_NODE\n1,1.0\n"
      "*DATABASE_GLSTAT\n0.01\n*DATABASE_NODOUT\n0.05\n*DATABASE_HISTORY_NODE\n1\n*END\n",
      scratch.path());
  const std::string glstat = read_file(scratch.path() / "glstat"), nodout = read_file(scratch.path() / "nodout");
  EXPECT_EQ(count(glstat, "total energy....."), 11) << glstat.substr(0, 2000);
  EXPECT_EQ(count(nodout, "( at time"), 3);
  for (const char* time : {"9.0000", "1.8000", "3.0000", "1.0000"})
    EXPECT_NE(glstat.find(time), std::string::npos) << time;
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "swforc"));
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "d3plot"));
}

/// Two hats, flange to flange, eight welds, thrown onto a rigid wall; contact among all.
std::string two_hats() {
  constexpr int rows = 24, columns = 12;
  const double across[columns + 1][2] = {{-45, 0}, {-37, 0}, {-30, 0}, {-30, 10}, {-30, 20}, {-15, 20}, {0, 20},
                                         {15, 20}, {30, 20}, {30, 10}, {30, 0},   {37, 0},   {45, 0}};
  std::string nodes, shells;
  char line[160];
  for (int side = 0; side < 2; ++side)
    for (int j = 0; j <= rows; ++j)
      for (int i = 0; i <= columns; ++i) {
        const double sign = side == 0 ? 1.0 : -1.0;
        std::snprintf(line, sizeof line, "%8d%16g%16g%16g\n", 1000 * side + 13 * j + i + 1,
                      across[i][0] + 0.01 * ((i * j) % 3), sign * (across[i][1] + 0.65), 0.5 + 8.0 * j);
        nodes += line;
      }
  for (int side = 0; side < 2; ++side)
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        const int n = 1000 * side + 13 * j + i + 1;
        std::snprintf(line, sizeof line, "%8d%8d%8d%8d%8d%8d\n", 1000 * side + 12 * j + i + 1, side + 1, n, n + 1,
                      n + 14, n + 13);
        shells += line;
      }
  std::string beams;
  for (int w = 0; w < 8; ++w) {
    const double x = w % 2 == 0 ? -37.5 : 37.5, z = 15.0 + 40.0 * (w / 2);
    std::snprintf(line, sizeof line, "%8d%16g%16g%16g\n%8d%16g%16g%16g\n", 5001 + 2 * w, x, 0.65, z, 5002 + 2 * w, x,
                  -0.65, z);
    nodes += line;
    std::snprintf(line, sizeof line, "%8d%8d%8d%8d\n", 9001 + w, 4, 5001 + 2 * w, 5002 + 2 * w);
    beams += line;
  }
  return "*KEYWORD\n*CONTROL_TERMINATION\n3e-4\n*CONTROL_TIMESTEP\n0,0.9,0,0,-9e-7\n*PART\nupper\n1,1,1\n*"
         "PART\nlower\n2,1,1\n*PART\nwelds\n4,4,4\n"
         "*SECTION_SHELL\n1,2,0.8333,3\n1.2,1.2,1.2,1.2\n*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.85e-9,210000.0,0.3,300."
         "0,1000.0\n\n\n\n"
         "*SECTION_BEAM\n4,9,1.0,2,1\n5.0,5.0\n*MAT_SPOTWELD\n4,7.85e-9,210000.0,0.3,400.0,1000.0\n0.0,500.0,300.0,300."
         "0\n"
         "*CONTACT_SPOTWELD\n4,1,3,2\n0\n1.0,1.0\n*SET_PART_LIST\n1\n1,2\n"
         "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n1,0,2,0\n0\n1.0,1.0\n*RIGIDWALL_PLANAR\n0\n0.0,0.0,0.0,0.0,0.0,1.0\n"
         "*INITIAL_VELOCITY_GENERATION\n0,0,0.0,0.0,0.0,-15000.0\n0.0\n"
         "*DATABASE_SWFORC\n1e-5\n*DATABASE_GLSTAT\n1e-5\n*DATABASE_RWFORC\n1e-5\n*DATABASE_RCFORC\n1e-5\n*DATABASE_"
         "BINARY_D3PLOT\n1e-4\n*NODE\n" +
         nodes + "*ELEMENT_SHELL\n" + shells + "*ELEMENT_BEAM\n" + beams + "*END\n";
}

// Plasticity, contact, wall, ties, failing welds, mass scaling: the same bytes with one, two and three threads.
// Sabotage to be caught: any sum in the order in which threads finish.
TEST(ResultFiles, DoNotDependOnTheNumberOfThreads) {
  const std::string deck = two_hats();
  const char* names[] = {"d3plot", "d3plot01", "swforc", "glstat", "rwforc", "rcforc"};
  std::string reference[6];
  for (int number : {1, 2, 3}) {
    set_threads(number);
    const output::Scratch scratch;
    run(deck, scratch.path());
    for (std::size_t i = 0; i < 6; ++i) {
      const std::string bytes = read_file(scratch.path() / names[i]);
      EXPECT_GT(bytes.size(), 500u) << names[i];
      if (number == 1) reference[i] = bytes;
      EXPECT_TRUE(bytes == reference[i]) << names[i] << " with " << number << " threads";
    }
  }
  set_threads(1);
  EXPECT_NE(reference[2].find("failure time"), std::string::npos);  // some weld failed
}

}  // namespace
}  // namespace nugget::impact
