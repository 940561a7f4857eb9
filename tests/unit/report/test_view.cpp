// SPDX-License-Identifier: Apache-2.0
#include "report/view.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "base/index.hpp"
#include "unit/output/scratch.hpp"

namespace nugget::report {
namespace {

using output::Scratch;
using testing::HasSubstr;

/// A square of shells that shakes at random, so that its states do not pack well.
void write_shaking_sheet(const std::filesystem::path& folder, int side, int states,
                         output::D3plotGeometry::Family family = {}) {
  output::D3plotGeometry g;
  g.family = family;
  g.parts = {{1, "sheet"}};
  for (int j = 0; j <= side; ++j)
    for (int i = 0; i <= side; ++i) {
      g.node_ids.push_back(static_cast<int>(g.node_ids.size()) + 1);
      g.x.push_back({static_cast<double>(i), static_cast<double>(j), 0.0});
    }
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const int a = j * (side + 1) + i;
      g.shells.push_back({j * side + i + 1, {a, a + 1, a + side + 2, a + side + 1}, 0});
    }
  output::D3plot file(folder, g);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shake(-0.3, 0.3);
  for (int k = 0; k < states; ++k) {
    output::D3plotState s;
    s.time = k + 1.0;
    s.parts.resize(1);
    for (const Vec3d& x : g.x) s.x.push_back(x + Vec3d{shake(random), shake(random), shake(random)});
    if (family == output::D3plotGeometry::Family::d3plot) s.v = s.a = std::vector<Vec3d>(g.x.size());
    s.shells.resize(g.shells.size());
    s.shell_layers.resize(3 * g.shells.size());
    for (auto& layer : s.shell_layers) layer.plastic_strain = 0.1 * k;
    for (auto& shell : s.shells) shell.thickness = 1.0;
    file.write(s);
  }
}

TEST(View, AllStatesWhereTheyFit) {
  Scratch scratch;
  write_shaking_sheet(scratch.path(), 10, 9);
  const PackedArrays arrays = packed_view(scratch.path(), false);
  EXPECT_EQ(arrays.about["view"]["times"].size(), 9u);
  EXPECT_FALSE(arrays.about["view"].contains("note"));
  EXPECT_EQ(arrays.about["view"]["facets"], 100);
  ASSERT_EQ(arrays.about["view"]["fields"].size(), 1u);  // neither stress nor thickness changes
  EXPECT_EQ(arrays.about["view"]["fields"][0]["name"], "plastic strain");
  EXPECT_NEAR(arrays.about["view"]["fields"][0]["high"].get<double>(), 0.8, 1e-6);
}

TEST(View, FewerStatesWhereTheyDoNotFitTheFirstAndTheLastAmongThem) {
  Scratch scratch;
  write_shaking_sheet(scratch.path(), 20, 30);
  const std::size_t whole = packed_view(scratch.path(), false).text().size();
  const ViewLimits limits{.text = whole / 3};
  const PackedArrays arrays = packed_view(scratch.path(), false, limits);
  EXPECT_LE(arrays.text().size(), limits.text);
  const auto& view = arrays.about["view"];
  EXPECT_GT(view["times"].size(), 4u);
  EXPECT_LT(view["times"].size(), 16u);
  EXPECT_EQ(view["times"].front(), 1.0);
  EXPECT_EQ(view["times"].back(), 30.0);
  EXPECT_THAT(view["note"].get<std::string>(), HasSubstr("of 30 states are shown"));
}

TEST(View, AModelTooLargeIsTold) {
  Scratch scratch;
  write_shaking_sheet(scratch.path(), 10, 1);
  const PackedArrays arrays = packed_view(scratch.path(), false, {.points = 200});
  EXPECT_THAT(arrays.about["view"]["note"].get<std::string>(), HasSubstr("121 nodes and 100 elements"));
  EXPECT_FALSE(arrays.about["view"].contains("times"));
}

/// Whatever the size of a mode, it is shown with 6 % of the diagonal.
TEST(View, ModesAreBroughtToOneSize) {
  Scratch scratch;
  write_shaking_sheet(scratch.path(), 10, 3, output::D3plotGeometry::Family::d3eigv);
  const auto view = packed_view(scratch.path(), true).about["view"];
  ASSERT_EQ(view["factors"].size(), 3u);
  for (const auto& factor : view["factors"]) {
    EXPECT_GT(factor.get<double>() * 0.3 * std::sqrt(3.0), 0.06 * std::hypot(10.0, 10.0));
    EXPECT_LT(factor.get<double>() * 0.3, 0.06 * std::hypot(10.0, 10.0));
  }
}

}  // namespace
}  // namespace nugget::report
