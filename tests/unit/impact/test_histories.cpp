// SPDX-License-Identifier: Apache-2.0
// The list of history files, and the table of columns of each.
#include "impact/recording/histories.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <utility>

#include "deck/deck.hpp"
#include "output/results.hpp"
#include "reading/build.hpp"
#include "reading/builder/builder.hpp"
#include "unit/output/scratch.hpp"

namespace nugget::impact {
namespace {

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

TEST(Histories, EachColumnSaysWhatItIs) {
  for (const HistoryFile& history : histories()) {
    const std::string file(history.name.text());
    EXPECT_FALSE(history.columns.empty()) << file;
    std::set<std::pair<std::string, std::string>> seen;
    for (const output::ColumnMeaning& column : history.columns) {
      const std::string what = file + ": " + column.branch + "/" + column.name;
      EXPECT_TRUE(seen.emplace(column.branch, column.name).second) << what << " is there twice";
      EXPECT_EQ(column.branch.substr(0, column.branch.find('/')), file) << what;
      EXPECT_EQ(column.name.find_first_of("*#"), std::string::npos) << what;
      EXPECT_FALSE(column.name.empty()) << what;
      EXPECT_FALSE(column.meaning.empty()) << what;
    }
  }
}

// Sabotage to be caught: a force given as a stress, an energy as a number.
TEST(Histories, QuantitiesOfOneNameHaveOneDimension) {
  int checked = 0;
  const auto expect = [&](const output::ColumnMeaning& column, const Dimension& dimension) {
    EXPECT_EQ(column.dimension, dimension) << column.branch << "/" << column.name;
    ++checked;
  };
  for (const HistoryFile& history : histories())
    for (const output::ColumnMeaning& column : history.columns) {
      if (column.name == "time" || column.name.ends_with("_time")) expect(column, dimension::time);
      if (column.name.ends_with("force")) expect(column, dimension::force);
      if (column.name.ends_with("energy")) expect(column, dimension::energy);
      if (column.name.ends_with("_acceleration") && column.name[0] != 'r') expect(column, dimension::acceleration);
      if (column.name.starts_with("sig")) expect(column, dimension::stress);
    }
  EXPECT_GT(checked, 70);
}

TEST(Histories, EachIsAskedForWrittenAndRemoved) {
  Findings findings;
  const model::Model model = reading::build(
      deck::read_text("*KEYWORD\n*CONTROL_TERMINATION\n0.1\n*NODE\n1,0.0,0.0,0.0\n*ELEMENT_MASS\n1,1,2.0\n*END\n",
                      findings),
      findings);
  const weld::Ties ties = weld::tie(model, findings);
  const system::System system(model, ties, findings);
  const output::Scratch scratch;
  const output::Header header{"list", "nugget test", "01/01/2000"};
  std::set<std::string> expected;
  for (const HistoryFile& history : histories()) {
    const std::string name(history.name.text());
    expected.insert(name);
    history.open(history.name, system, {scratch.path(), header, {}, true, nullptr});

    std::string keyword = "DATABASE_" + name;
    std::ranges::transform(keyword, keyword.begin(), [](unsigned char c) { return std::toupper(c); });
    reading::Options options;
    const reading::Keyword* row = reading::find_keyword(keyword, options);
    ASSERT_NE(row, nullptr) << keyword;
    EXPECT_EQ(row->name, keyword);
    EXPECT_EQ(row->status, model::KeywordStatus::used) << keyword;
  }
  EXPECT_EQ(names_in(scratch.path()), expected);
  output::put(scratch / "glstat.txt", "not ours");
  EXPECT_EQ(output::remove_old_results(scratch.path()).size(), expected.size());
  EXPECT_THAT(names_in(scratch.path()), testing::ElementsAre("glstat.txt"));
}

}  // namespace
}  // namespace nugget::impact
