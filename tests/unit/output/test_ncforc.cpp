// SPDX-License-Identifier: Apache-2.0
#include "output/ncforc.hpp"

#include <gmock/gmock.h>

#include "output/binout.hpp"
#include "unit/output/lsda.hpp"
#include "unit/output/scratch.hpp"

// ncforc: lines as LSTC's translator l2a writes them, branches as it reads them.
namespace nugget::output {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Header header{"a sheet on a floor", "nugget 0.1.0", "01/02/2026"};

NcforcState two_sides() {
  return {0.5,
          {{7, ContactSide::tracked, {{12, {1, 2, 3}, 40.0, {10, 20, 30}}, {101, {-1, 0, 0.5}, 0.0, {0, 0, 1}}}},
           {7, ContactSide::reference, {{55, {0, -2, -3.5}, 8.0, {1, 1, 1}}}}}};
}

TEST(Ncforc, HasTwoLinesForEachNodeOfASide) {
  Scratch scratch;
  const HistoryFormat<NcforcState> format = ncforc(two_sides().sides);
  const std::vector<LegendEntry> legend{{7, "floor"}};
  AsciiHistory(format, scratch / "ncforc", header, legend).write(two_sides());
  const std::string text = content(scratch / "ncforc");
  EXPECT_THAT(text, HasSubstr("        7     floor"));
  EXPECT_THAT(text, HasSubstr("\n\n\n forces (t=5.00000E-01) for interface         7 slave  side\n\n"
                              "     node           x-force/      y-force/      z-force/     pressure/\n"
                              "                   coordinate    coordinate    coordinate\n"
                              "        12         1.00000E+00   2.00000E+00   3.00000E+00   4.00000E+01\n"
                              "                   1.00000E+01   2.00000E+01   3.00000E+01\n"
                              "       101        -1.00000E+00   0.00000E+00   5.00000E-01   0.00000E+00\n"));
  EXPECT_THAT(text, HasSubstr(" for interface         7 master side\n"));
}

TEST(Ncforc, HasABranchOfBinoutForEachSide) {
  Scratch scratch;
  const HistoryFormat<NcforcState> format = ncforc(two_sides().sides);
  Binout binout(scratch.path(), header);
  binout.set_legend("ncforc/slave_000007", {{7, "floor"}});
  binout.write(format, two_sides());
  const Lsda lsda(content(scratch / "binout0000"));
  EXPECT_THAT(lsda.integers("/ncforc/slave_000007/metadata/ids"), ElementsAre(12, 101));
  EXPECT_THAT(lsda.integers("/ncforc/master_000007/metadata/ids"), ElementsAre(55));
  EXPECT_THAT(lsda.reals("/ncforc/slave_000007/d000001/time"), ElementsAre(0.5));
  EXPECT_THAT(lsda.reals("/ncforc/slave_000007/d000001/z_force"), ElementsAre(3.0, 0.5));
  EXPECT_THAT(lsda.reals("/ncforc/slave_000007/d000001/pressure"), ElementsAre(40.0, 0.0));
  EXPECT_THAT(lsda.reals("/ncforc/slave_000007/d000001/y"), ElementsAre(20.0, 0.0));
  EXPECT_THAT(lsda.reals("/ncforc/master_000007/d000001/y_force"), ElementsAre(-2.0));
}

}  // namespace
}  // namespace nugget::output
