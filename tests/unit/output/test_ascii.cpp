// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <limits>
#include <map>
#include <sstream>

#include "output/bndout.hpp"
#include "output/dcfail.hpp"
#include "output/glstat.hpp"
#include "output/matsum.hpp"
#include "output/nodout.hpp"
#include "output/rbdout.hpp"
#include "output/rcforc.hpp"
#include "output/rwforc.hpp"
#include "output/sleout.hpp"
#include "output/spcforc.hpp"
#include "output/swforc.hpp"
#include "unit/output/scratch.hpp"

namespace nugget::output {
namespace {

const Header header{"two plates", "nugget 0.1.0", "01/02/2026"};

const std::string head =
    " two plates                                                              \n"
    "                    ls-dyna nugget 0.1.0           date 01/02/2026\n";

TEST(Ascii, TitleIsCutAndFilledTo72Characters) {
  Header long_title = header;
  long_title.title = std::string(100, 'x');
  EXPECT_EQ(title_lines(header), head);
  EXPECT_EQ(title_lines(long_title).find('\n'), 73u);
}

TEST(Ascii, LegendNamesEntities) {
  const std::vector<LegendEntry> legend{{7, "door"}};
  EXPECT_EQ(legend_lines({}), "\n\n");
  EXPECT_EQ(legend_lines(legend), "\n{BEGIN LEGEND}\n Entity #        Title\n        7     door" +
                                      std::string(66, ' ') + "\n\n{END LEGEND}\n");
}

TEST(Ascii, TinyNumbersDoNotLetColumnsGrowTogether) {
  EXPECT_EQ(column(-1e-120), 0.0);
  EXPECT_EQ(column(-1e-98), -1e-98);
}

TEST(Dcfail, ARowHoldsTheTermsAndTheResultants) {
  Scratch scratch;
  AsciiHistory file(dcfail(), scratch / "dcfail", header);
  file.write({0.5, {{11, 7, 0.9, 0.4, 0.3, 0.2, 28.0, 25.0, 60.0, 1000.0, 200.0, 30.0, 4.0}}});
  const std::string text = content(scratch / "dcfail");
  EXPECT_NE(text.find("\n define connection failure, time=  5.00000E-01\n"), std::string::npos);
  EXPECT_NE(text.find("\n        11         7  9.00000E-01  4.00000E-01  3.00000E-01  2.00000E-01  2.80000E+01"
                      "  2.50000E+01  6.00000E+01  1.00000E+03  2.00000E+02  3.00000E+01  4.00000E+00\n"),
            std::string::npos);
}

// The line is of LS-DYNA R13.1.1, one weld beam (shared/decks/README.md).
TEST(Swforc, BeamLineIsLsDynasOwn) {
  Scratch scratch;
  AsciiHistory file(swforc(), scratch / "swforc", header);
  file.write(
      {4.87301e-3, {{1000000, WeldKind::beam, 1.40343e-1, 3.93039e-8, 12.5999, 1.96262e-17, 3.93459e-14, 0.0, 0.0}}});
  EXPECT_EQ(
      content(scratch / "swforc"),
      head +
          "\n constraint #      axial        shear         time  failure                                       length"
          "  rslt moment      torsion\n"
          "          1  1.40343E-01  3.93039E-08  4.87301E-03  0.00000    spotweld beam  ID    1000000  1.25999E+01"
          "  1.96262E-17  3.93459E-14\n");
}

TEST(Swforc, PeakOfOptMinus2StandsBehindTheMoments) {
  Scratch scratch;
  AsciiHistory file(swforc(), scratch / "swforc", header);
  file.write({2e-3, {{7, WeldKind::beam, 10.0, 0.0, 1.5, 2.0, 3.0, 0.5, 0.0, std::pair{1.29097, 1.25e-3}}}});
  EXPECT_THAT(content(scratch / "swforc"),
              testing::HasSubstr("  0.50000    spotweld beam  ID          7  1.50000E+00  2.00000E+00  3.00000E+00"
                                 " fcmx=1.29097 t=1.25E-03\n"));
}

TEST(Swforc, EachKindHasItsLabelAndTail) {
  Scratch scratch;
  AsciiHistory file(swforc(), scratch / "swforc", header);
  SwforcState state;
  state.time = 1e-3;
  state.rows = {{10002, WeldKind::beam, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 8.25e-4},
                {20001, WeldKind::assembly, 2345.6, 12.3, 1.2, 310.0, 15.0, 0.2345, 0.0},
                {20002, WeldKind::solid, 0.0, 0.0, 1.2, 0.0, 0.0, 1.5, 9e-4},
                {30001, WeldKind::constraint, 812.5, 55.5, 0.0, 0.0, 0.0, 0.031, 0.0},
                {30002, WeldKind::generalized, 1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0},
                {30003, WeldKind::nonnodal, 1.0, 2.0, 0.5, 3.0, 4.0, 0.0, 0.0}};
  file.write(state);
  const std::string text = content(scratch / "swforc");
  EXPECT_EQ(text.substr(text.find("torsion\n") + 8),
            "          1  0.00000E+00  0.00000E+00  1.00000E-03  failure    spotweld beam  ID      10002               "
            "failure "
            "time=  8.2500E-04\n"
            "          2  2.34560E+03  1.23000E+01  1.00000E-03   0.2345    spotweld assmy ID      20001  1.20000E+00"
            "  3.10000E+02  1.50000E+01\n"
            "          3  0.00000E+00  0.00000E+00  1.00000E-03   1.5000    spotweld solid ID      20002               "
            "failure "
            "time=  9.0000E-04\n"
            "          4  8.12500E+02  5.55000E+01  1.00000E-03  0.03100    constraint/weld  ID    30001  0.00000E+00\n"
            "          5  1.00000E+00  2.00000E+00  1.00000E-03  0.00000    generalized weld ID    30002\n"
            "          6  1.00000E+00  2.00000E+00  1.00000E-03  0.00000    nonnodal cnst  ID      30003  5.00000E-01"
            "  3.00000E+00  4.00000E+00\n");
}

// What every reader of numbers takes; Fortran's short form 2.24+00 is none to Python, R or a spreadsheet.
TEST(Swforc, FailureIsANumber) {
  for (double value = 1e-120; value < 1e120; value *= 1.7) {
    const std::string text = failure_column(value, false);
    EXPECT_EQ(text.size(), 7u);
    std::size_t used = 0;
    const double read = std::stod(text, &used);
    EXPECT_EQ(used, 7u) << text;
    const double gate = value >= 1e-3 && value < 1e6 ? 0.006 : 0.05;
    EXPECT_TRUE(value < 1e-98 || value > 9.9e99 || std::abs(read / value - 1.0) < gate) << text;
    EXPECT_EQ(read < 1.0, value < 1.0) << text;
  }
}

TEST(Swforc, ResultantForceWhereItIsAskedFor) {
  Scratch scratch;
  AsciiHistory file(swforc(), scratch / "swforc", header);
  SwforcState state{2e-3,
                    {{7, WeldKind::beam, 30.0, 40.0, 1.5, 2.0, 3.0, 0.5, 0.0}, {8, WeldKind::constraint, -3.0, 4.0}}};
  state.resultant_force = true;
  file.write(state);
  EXPECT_THAT(content(scratch / "swforc"), testing::HasSubstr("  3.00000E+00 fres=  5.00000E+01\n"));
  EXPECT_THAT(content(scratch / "swforc"), testing::HasSubstr("  0.00000E+00 fres=  5.00000E+00\n"));
}

TEST(Swforc, FailureFillsSevenColumns) {
  EXPECT_EQ(failure_column(0.0, false), "0.00000");
  EXPECT_EQ(failure_column(1e-200, false), "0.00000");
  EXPECT_EQ(failure_column(0.031, false), "0.03100");
  EXPECT_EQ(failure_column(0.9999999, false), "0.99999");
  EXPECT_EQ(failure_column(1.0, true), "failure");
  EXPECT_EQ(failure_column(1.29097, false), "1.29097");  // OPT -1: it is told, and the weld holds
  EXPECT_EQ(failure_column(9.9999999, false), "10.0000");
  EXPECT_EQ(failure_column(224.0, false), "224.000");
  EXPECT_EQ(failure_column(123456.0, false), " 123456");
  EXPECT_EQ(failure_column(2.5e7, false), "2.5E+07");
  EXPECT_EQ(failure_column(3.1e-5, false), "3.1E-05");
  EXPECT_EQ(failure_column(std::numeric_limits<double>::quiet_NaN(), false), "    nan");
}

/// The states of a glstat, each as the text from `dt of cycle` on.
std::vector<std::string> states_of(const std::string& text) {
  std::vector<std::string> states;
  for (std::size_t at = text.find("\n\n dt of cycle"); at != std::string::npos;) {
    const std::size_t next = text.find("\n\n dt of cycle", at + 1);
    states.push_back(text.substr(at, next == std::string::npos ? next : next - at));
    at = next;
  }
  return states;
}

/// Name and number of each ` name....  number` line.
std::map<std::string, double> quantities_of(const std::string& state) {
  std::map<std::string, double> quantities;
  std::istringstream lines(state);
  for (std::string line; std::getline(lines, line);) {
    if (line.size() != 46) continue;
    const std::string name = line.substr(1, 31);
    quantities[name.substr(0, name.find_last_not_of('.') + 1)] = std::stod(line.substr(32));
  }
  return quantities;
}

// Reads LS-DYNA R14's glstat, gives its numbers to our writer and wants its text back. The three lines that R14 has and
// we have not (dissipated and drilling energies) are taken out first.
TEST(Glstat, RewritesLsDynasFileByteForByte) {
  if (!std::filesystem::exists(shared("decks/single_hex/glstat"))) GTEST_SKIP() << "no ../shared/decks/single_hex here";
  const std::string real = content(shared("decks/single_hex/glstat"));
  const std::vector<std::string> states = states_of(real);
  ASSERT_EQ(states.size(), 101u);
  for (std::size_t i = 0; i + 1 < states.size(); ++i) {  // the last one has the legal notice behind it
    const std::string& text = states[i];
    std::map<std::string, double> q = quantities_of(text);
    GlstatState s;
    s.cycle = std::stol(text.substr(text.find("cycle") + 5));
    s.controlling = {ElementKind::solid, 1, 1};
    s.time = q.at("time"), s.time_step = q.at("time step");
    s.kinetic = q.at("kinetic energy"), s.internal = q.at("internal energy");
    s.spring_and_damper = q.at("spring and damper energy");
    s.system_damping = q.at("system damping energy"), s.sliding_interface = q.at("sliding interface energy");
    s.external_work = q.at("external work");
    s.eroded_kinetic = q.at("eroded kinetic energy"), s.eroded_internal = q.at("eroded internal energy");
    s.eroded_hourglass = q.at("eroded hourglass energy");
    s.total = q.at("total energy"), s.ratio = q.at("total energy / initial energy");
    s.ratio_without_eroded = q.at("energy ratio w/o eroded energy");
    s.velocity = {q.at("global x velocity"), q.at("global y velocity"), q.at("global z velocity")};

    std::string expected = text;
    const std::size_t extra = expected.find(" dissipated kinetic");
    expected.erase(extra, expected.find(" time per zone") - extra);
    const Header real_header{"Single hex element tension test", "smp s R14 R14.1_205_eb5348f", "10/16/2023"};
    Scratch scratch;
    AsciiHistory(glstat(), scratch / "glstat", real_header).write(s);
    EXPECT_EQ(content(scratch / "glstat"), real.substr(0, real.find("\n\n dt of cycle")) + expected);
  }
}

TEST(Glstat, WritesWallsMassAndLoadCurve) {
  Scratch scratch;
  GlstatState s;
  s.cycle = 12;
  s.walls = {1.0, -2.5};
  s.hourglass = 3.0;
  s.nodes = 8;
  s.added_mass = 0.25;
  s.percent_increase = 12.5;
  AsciiHistory(glstat(), scratch / "glstat", header).write(s);
  const std::string text = content(scratch / "glstat");
  EXPECT_THAT(text, testing::HasSubstr("\n\n dt of cycle      12 is controlled by load curve\n\n time....."));
  EXPECT_THAT(text, testing::HasSubstr("\n stonewall energy...............   1.00000E+00 wall# 1\n"
                                       " stonewall energy...............  -2.50000E+00 wall# 2\n"
                                       " hourglass energy ..............   3.00000E+00\n"));
  EXPECT_THAT(text, testing::HasSubstr("\n number of nodes................             8\n"
                                       " time per zone cycle.(nanosec)..             0\n"
                                       "\n\n added mass.....................   2.50000E-01\n"
                                       " percentage increase............   1.25000E+01\n"));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("eroded")));
}

TEST(Matsum, WritesAPart) {
  Scratch scratch;
  const std::vector<LegendEntry> legend{{4, "hat"}};
  MatsumRow row;
  row.part = 4;
  row.internal = 1.0, row.kinetic = 2.0, row.hourglass = 3.0, row.added_mass = 4.0;
  row.eroded_internal = 5.0, row.eroded_kinetic = 6.0;
  row.momentum = {7.0, 8.0, 9.0};
  row.velocity = {-1.0, -2.0, -3.0};
  AsciiHistory(matsum(), scratch / "matsum", header, legend).write({0.5, {row}, 0.25});
  EXPECT_EQ(content(scratch / "matsum"),
            head + legend_lines(legend) +
                "\n\n time =   5.0000E-01\n"
                " mat.#=    0             inten=   0.0000E+00     kinen=   2.5000E-01     eroded_ie=   0.0000E+00     "
                "eroded_ke=   0.0000E+00\n"
                " mat.#=    4             inten=   1.0000E+00     kinen=   2.0000E+00     eroded_ie=   5.0000E+00     "
                "eroded_ke=   6.0000E+00\n"
                " x-mom=   7.0000E+00     y-mom=   8.0000E+00     z-mom=   9.0000E+00\n"
                " x-rbv=  -1.0000E+00     y-rbv=  -2.0000E+00     z-rbv=  -3.0000E+00\n"
                "                         hgeng=   3.0000E+00     +mass=   4.0000E+00\n\n\n");
}

TEST(Nodout, WritesTranslationsThenRotations) {
  Scratch scratch;
  NodoutRow row;
  row.node = 605;
  row.displacement = {-641.87, 2.0, 3.0};
  row.velocity = {4.0, 5.0, 6.0};
  row.acceleration = {7.0, 8.0, 9.0};
  row.coordinate = {10.0, 11.0, 12.0};
  row.rotation = {0.1, 0.2, 0.3};
  AsciiHistory(nodout(), scratch / "nodout", header).write({77, 0.25, true, {row}});
  EXPECT_EQ(
      content(scratch / "nodout"),
      head + "\n\n" +
          "\n\n\n n o d a l   p r i n t   o u t   f o r   t i m e  s t e p      77                              ( at "
          "time "
          "2.5000000E-01 )\n"
          "\n nodal point  x-disp     y-disp      z-disp      x-vel       y-vel       z-vel      x-accl      y-accl    "
          "  "
          "z-accl      x-coor      y-coor      z-coor\n"
          "      605  -6.4187E+02  2.0000E+00  3.0000E+00  4.0000E+00  5.0000E+00  6.0000E+00  7.0000E+00  8.0000E+00"
          "  9.0000E+00  1.0000E+01  1.1000E+01  1.2000E+01\n"
          "\n\n\n n o d a l   p r i n t   o u t   f o r   t i m e  s t e p      77                              ( at "
          "time "
          "2.5000000E-01 )\n"
          "\n nodal point  x-rot      y-rot       z-rot       x-rot vel   y-rot vel   z-rot vel   x-rot acc   y-rot "
          "acc   "
          "z-rot acc\n"
          "      605   1.0000E-01  2.0000E-01  3.0000E-01  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00"
          "  0.0000E+00\n");
}

TEST(Rwforc, WritesEachWall) {
  Scratch scratch;
  AsciiHistory(rwforc(), scratch / "rwforc", header)
      .write({1e-5, {{1, 5.0, {3.0, 4.0, 0.0}}, {2, 772837.0, {772837.0, 0.0, 0.0}}}});
  EXPECT_EQ(content(scratch / "rwforc"),
            head +
                "\n\n\n\n    time       wall#   normal-force    x-force        y-force        z-force\n"
                " 1.00000E-05       1   5.000000E+00   3.000000E+00   4.000000E+00   0.000000E+00\n"
                " 1.00000E-05       2   7.728370E+05   7.728370E+05   0.000000E+00   0.000000E+00\n");
}

// The formats of LSTC's l2a.
TEST(Rwforc, WritesAreasAndTransducers) {
  Scratch scratch;
  AsciiHistory(rwforc(), scratch / "rwforc", header)
      .write({0.0,
              {{1, 5.0, {3.0, 4.0, 0.0}}},
              12,
              {{31, 7, 1, {1.0, 2.0, -3.0}}},
              {{0, {{3.0, 0.0, 0.0}, {0.0, 4.0, 0.0}}}}});
  EXPECT_EQ(content(scratch / "rwforc"),
            head +
                "\n\n\n\n    time       wall#   normal-force    x-force        y-force        z-force\n"
                " 0.00000E+00       1   5.000000E+00   3.000000E+00   4.000000E+00   0.000000E+00\n"
                "                seg#    \n"
                "                   1                  3.000000E+00   0.000000E+00   0.000000E+00\n"
                "                   2                  0.000000E+00   4.000000E+00   0.000000E+00\n"
                "  total force                         3.000000E+00   4.000000E+00   0.000000E+00\n"
                "\n\n\nr i g i d   w a l l   n o d e   s e t   f o r c e   s u m m a t i o n s\n"
                "f o r   t i m e   s t e p        12   ( at time  0.00000E+00 )\n\n"
                "    time       wall #   transducer node set #    x-force      y-force      z-force\n"
                " 0.00000E+00          1         31          7  1.00000E+00  2.00000E+00 -3.00000E+00\n\n\n");
}

TEST(Spcforc, ForceStandsBeforeMomentOfTheSameNode) {
  Scratch scratch;
  SpcforcState s;
  s.time = 0.5;
  s.forces = {{2, {1.0, 2.0, 3.0}, 9}};
  s.moments = {{1, {0.0, 0.0, 4.0}, 0}, {2, {5.0, 0.0, 0.0}, 9}};
  s.resultant = {1.0, 2.0, 3.0};
  AsciiHistory(spcforc(), scratch / "spcforc", header).write(s);
  EXPECT_EQ(content(scratch / "spcforc"),
            head +
                "\n\n single point constraint forces\n\n output at time =   5.00000E-01\n"
                " node=       1 local x,y,z moments=    0.0000E+00    0.0000E+00    4.0000E+00  setid=       0\n"
                " node=       2 local x,y,z forces =    1.0000E+00    2.0000E+00    3.0000E+00  setid=       9\n"
                " node=       2 local x,y,z moments=    5.0000E+00    0.0000E+00    0.0000E+00  setid=       9\n"
                "             force resultants   =    1.0000E+00    2.0000E+00    3.0000E+00\n");
}

TEST(Bndout, SumsNodesAndBodies) {
  Scratch scratch;
  BndoutState s;
  s.time = 0.5;
  s.nodes = {{11, {1.0, 2.0, 3.0}, 4.0, 5}};
  s.bodies = {{7, {10.0, 20.0, 30.0}, {1.0, 0.0, 0.0}, 40.0}};
  AsciiHistory(bndout(), scratch / "bndout", header).write(s);
  EXPECT_EQ(
      content(scratch / "bndout"),
      head + "\n\n" +
          "\n\n\n\n\n n o d a l   f o r c e/e n e r g y    o u t p u t   t=5.000E-01\n"
          "\n\n\n\n\n velocity boundary condition forces/rigid body moments \n\n"
          " nd#      11  xforce=   1.0000E+00   yforce=   2.0000E+00  zforce=   3.0000E+00   energy=   4.0000E+00   "
          "setid "
          "=       5\n"
          "mat#       7  xforce=   1.0000E+01   yforce=   2.0000E+01  zforce=   3.0000E+01   energy=   4.0000E+01\n"
          "             xmoment=   1.0000E+00  ymoment=   0.0000E+00 zmoment=   0.0000E+00\n"
          "              xtotal=   1.1000E+01   ytotal=   2.2000E+01  ztotal=   3.3000E+01   etotal=   4.4000E+01\n");
}

TEST(Rbdout, LocalMotionIsInTheBodysAxes) {
  Scratch scratch;
  RbdoutState s;
  s.cycle = 3;
  s.time = 0.5;
  RbdoutRow row;
  row.id = 9;
  row.velocity = {1.0, 2.0, 3.0};
  row.axes = {{0.0, 1.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};  // a quarter turn about z
  s.nodal = {row};
  AsciiHistory(rbdout(), scratch / "rbdout", header).write(s);
  const std::string text = content(scratch / "rbdout");
  EXPECT_THAT(text,
              testing::StartsWith(head + "1\n\n  r i g i d   b o d y   m o t i o n   a t  cycle=       3    time=   "
                                         "5.000000E-01\n\n nodal rigid body       9\n"
                                         "   global             x           y           z          x-rot       y-rot"
                                         "       z-rot\n   coordinates:    0.0000E+00"));
  EXPECT_THAT(text, testing::HasSubstr("    velocities:    1.0000E+00  2.0000E+00  3.0000E+00  0.0000E+00"));
  EXPECT_THAT(text, testing::HasSubstr("    velocities:    2.0000E+00 -1.0000E+00  3.0000E+00  0.0000E+00"));
  EXPECT_THAT(text, testing::HasSubstr("     row 1     0.0000E+00    -1.0000E+00     0.0000E+00\n"
                                       "     row 2     1.0000E+00     0.0000E+00     0.0000E+00\n"));
}

TEST(Rcforc, NamesBothSides) {
  Scratch scratch;
  AsciiHistory(rcforc(), scratch / "rcforc", header)
      .write({0.5,
              {{3, ContactSide::tracked, {1.0, 2.0, 3.0}, 4.0}, {3, ContactSide::reference, {-1.0, -2.0, -3.0}, 5.0}}});
  EXPECT_EQ(
      content(scratch / "rcforc"),
      head + "\n\n" +
          "  slave           3 time 5.00000E-01  x  1.00000E+00  y  2.00000E+00  z  3.00000E+00 mass  4.00000E+00\n"
          "  master          3 time 5.00000E-01  x -1.00000E+00  y -2.00000E+00  z -3.00000E+00 mass  5.00000E+00\n");
}

TEST(Sleout, AddsUpTheSidesAndFriction) {
  Scratch scratch;
  AsciiHistory(sleout(), scratch / "sleout", header)
      .write({0.5, 7, {{3, 2.0, 0.0, true, 1.5}, {4, 5.0, -1.0, false, 0.25}}});
  EXPECT_EQ(content(scratch / "sleout"),
            head +
                "\n\n\n"
                " contact interface energy file, time= 5.0000000E-01\n"
                "    #             slave       master       cycle=             7    frictional\n\n"
                "         3   2.0000E+00   0.0000E+00                               1.5000E+00\n"
                "         4   5.0000E+00  -1.0000E+00                               2.5000E-01\n\n"
                " summary   total slave side= 7.0000000E+00\n"
                "           total mastr side=-1.0000000E+00\n"
                "           total energy    = 6.0000000E+00\n"
                "           friction energy = 1.7500000E+00\n\n");
}

}  // namespace
}  // namespace nugget::output
