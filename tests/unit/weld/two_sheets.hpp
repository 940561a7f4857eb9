// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <array>

#include "unit/weld/assembly.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::test {

/// Two sheets of 3 x 3 shells of 10 mm, 1 mm thick, touching (mid-surfaces at z = 0 and `height`); a part for weld
/// beams.
struct TwoSheets : Assembly {
  Index lower, upper, welds;
  Findings findings;
  explicit TwoSheets(double height = 1.0, double diameter = 5.0)
      : lower(sheet(1.0, {0, 0, 0})), upper(sheet(1.0, {0, 0, height})), welds(beam_part(diameter)) {
    tie({welds}, {lower, upper});
  }
  weld::Ties tied() { return weld::tie(model, findings); }
};

inline void expect_weights(const weld::Tie& tie, const std::array<double, 4>& expected) {
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(tie.weight[i], expected[i], 1e-12) << "corner " << i;
}

}  // namespace nugget::test
