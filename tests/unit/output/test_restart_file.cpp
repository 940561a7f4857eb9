// SPDX-License-Identifier: Apache-2.0
#include "output/restart_file.hpp"

#include <gmock/gmock.h>

#include "base/index.hpp"
#include "thread_ranks.hpp"
#include "unit/output/scratch.hpp"

namespace nugget::output {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

RestartHead head(long cycle) {
  return {.version = "9.9",
          .program = checksum_of_program(),
          .deck = "a \"b\".k",
          .folder = "somewhere",
          .deck_checksum = 0xfedcba9876543210,
          .date = "11/21/2026",
          .skip_unsupported = true,
          .until = 0.1,
          .max_cycles = 12,
          .checkpoint = "5min",
          .weld_law = "law.so",
          .weld_tie = "area",
          .units = "mm, t, s",
          .drop_weld = "7,12",
          .time = 1.0 / 3.0,
          .cycle = cycle};
}

void write(const fs::path& folder, long cycle, std::vector<double> values) {
  RestartWriter file(folder, head(cycle));
  file(values);
  file.finish();
}

std::string reason(const fs::path& folder) {
  std::string warning;
  try {
    open_restart(folder, warning);
  } catch (const ArchiveError& error) {
    return error.what();
  }
  return "none";
}

TEST(RestartFile, HeadAndStateComeBack) {
  const Scratch scratch;
  write(scratch.path(), 7, {1.0, 2.0});
  std::string warning;
  const auto file = open_restart(scratch.path(), warning);
  EXPECT_EQ(warning, "");
  EXPECT_EQ(file->head().deck, "a \"b\".k");
  EXPECT_EQ(file->head().deck_checksum, 0xfedcba9876543210);
  EXPECT_EQ(file->head().time, 1.0 / 3.0);
  EXPECT_EQ(file->head().cycle, 7);
  EXPECT_TRUE(file->head().skip_unsupported);
  EXPECT_EQ(file->head().checkpoint, "5min");
  EXPECT_EQ(file->head().weld_law, "law.so");
  EXPECT_EQ(file->head().weld_tie, "area");
  EXPECT_EQ(file->head().units, "mm, t, s");
  EXPECT_EQ(file->head().drop_weld, "7,12");
  std::vector<double> values;
  (*file)(values);
  EXPECT_THAT(values, testing::ElementsAre(1.0, 2.0));
  double more = 0.0;
  EXPECT_THROW((*file)(more), ArchiveError) << "there is no more state";
}

TEST(RestartFile, TwoGenerationsAreKept) {
  const Scratch scratch;
  for (const long cycle : {1L, 2L, 3L}) write(scratch.path(), cycle, {});
  EXPECT_EQ(RestartReader(scratch / "restart").head().cycle, 3);
  EXPECT_EQ(RestartReader(scratch / "restart.previous").head().cycle, 2);
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), fs::directory_iterator()), 2);
}

TEST(RestartFile, OneThatIsNotFinishedLeavesTheOthers) {
  const Scratch scratch;
  write(scratch.path(), 1, {1.0});
  {
    RestartWriter file(scratch.path(), head(2));
    double value = 2.0;
    file(value);
  }
  EXPECT_EQ(RestartReader(scratch / "restart").head().cycle, 1);
  EXPECT_FALSE(fs::exists(scratch / "restart.part"));
}

TEST(RestartFile, ATornFileIsNamedAndTheOneBeforeIsTaken) {
  const Scratch scratch;
  write(scratch.path(), 1, {1.0});
  write(scratch.path(), 2, {2.0});
  const std::string whole = content(scratch / "restart");
  for (std::size_t size : {std::size_t{0}, std::size_t{4}, std::size_t{20}, whole.size() / 2, whole.size() - 1}) {
    put(scratch / "restart", whole.substr(0, size));
    std::string warning;
    EXPECT_EQ(open_restart(scratch.path(), warning)->head().cycle, 1) << size;
    EXPECT_THAT(warning, HasSubstr("restart: "));
  }
  std::string flipped = whole;
  flipped[whole.size() / 2] ^= 1;
  put(scratch / "restart", flipped);
  std::string warning;
  EXPECT_EQ(open_restart(scratch.path(), warning)->head().cycle, 1);
  EXPECT_THAT(warning, HasSubstr("checksum"));
  put(scratch / "restart", whole);
  EXPECT_EQ(open_restart(scratch.path(), warning)->head().cycle, 2);
}

TEST(RestartFile, WithoutASoundOneTheReasonIsGiven) {
  const Scratch scratch;
  EXPECT_THAT(reason(scratch.path()), HasSubstr("there is no restart file in"));
  put(scratch / "restart", "*KEYWORD\n");
  EXPECT_THAT(reason(scratch.path()), HasSubstr("no restart file of nugget"));
  put(scratch / "restart.previous", "");
  EXPECT_THAT(reason(scratch.path()), HasSubstr("restart.previous"));
}

TEST(RestartFile, AnotherBuildOfTheProgramIsRefused) {
  const Scratch scratch;
  RestartHead other = head(1);
  other.program += 1;
  {
    RestartWriter file(scratch.path(), other);
    file.finish();
  }
  EXPECT_THAT(reason(scratch.path()), HasSubstr("another build of the program (nugget 9.9)"));
}

TEST(RestartFile, AResultFileIsCutBack) {
  const Scratch scratch;
  {
    ResultFile file(scratch / "glstat");
    file.buffer() = "head, state 1, ";
    file.commit();
    RestartWriter kept(scratch.path(), head(1));
    kept(file);
    kept.finish();
    file.buffer() = "the last state of an interrupted run";
    file.commit();
  }
  std::string warning;
  {
    ResultFile file(scratch / "glstat", OpenMode::append);
    (*open_restart(scratch.path(), warning))(file);
    file.buffer() = "state 2";
    file.commit();
  }
  EXPECT_EQ(content(scratch / "glstat"), "head, state 1, state 2");

  fs::resize_file(scratch / "glstat", 3);
  ResultFile file(scratch / "glstat", OpenMode::append);
  EXPECT_THROW((*open_restart(scratch.path(), warning))(file), ArchiveError) << "it is shorter than it was";
  EXPECT_THROW(ResultFile(scratch / "gone", OpenMode::append), ArchiveError);
}

/// Numbers by place, and as many at each place as it says; of three ranks each has those of a third of the places, in
/// rows of five, and of some all have them.
struct Places {
  static constexpr std::size_t count = 30000;
  static int giver(std::size_t place) {
    const int of_row = static_cast<int>(place / 5 % 4);
    return of_row == 3 ? Archive::everyone : of_row;
  }
  std::vector<double> numbers;
  std::vector<std::vector<double>> lists;

  /// What rank `rank` has, or, of `Archive::everyone`, all of it; what it has not is `otherwise`.
  explicit Places(int rank, double otherwise = -1.0) : numbers(count, otherwise), lists(count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (rank != Archive::everyone && giver(i) != Archive::everyone && giver(i) != rank) continue;
      numbers[i] = 0.5 * static_cast<double>(i);
      lists[i].assign(i % 3, numbers[i]);
    }
  }
  void archive(Archive& a, const Archive::Holders& holders) {
    std::string name = "numbers";
    a(name);
    a.parts(numbers, holders);
    a.each_part(count, 7, holders, [&](std::size_t i, bool here) {
      std::vector<double> of_others;
      a(here ? lists[i] : of_others);
    });
  }
};

void write(const fs::path& folder, Ranks* ranks) {
  Places places(ranks != nullptr ? ranks->rank() : Archive::everyone);
  Archive::Holders holders;
  if (ranks != nullptr) holders.giver = Places::giver;
  if (ranks != nullptr && ranks->rank() != 0) {
    RestartSender file(*ranks);
    places.archive(file, holders);
    file.finish();
    return;
  }
  RestartWriter file(folder, head(1), ranks);
  places.archive(file, holders);
  file.finish();
}

// Sabotage to be caught: a rank's own values in place of those that another one gives; pieces in the order of ranks.
TEST(RestartFile, RanksWriteTheFileOfOneProcess) {
  const Scratch one, three;
  write(one.path(), nullptr);
  on_thread_ranks(3, [&](Ranks& ranks) { write(three.path(), &ranks); });
  EXPECT_TRUE(content(one / "restart") == content(three / "restart"));
}

TEST(RestartFile, AFileOfOneProcessIsNotWrittenOfWhatOthersHave) {
  const Scratch scratch;
  RestartWriter file(scratch.path(), head(1));
  Places places(0);
  EXPECT_THROW(places.archive(file, {Places::giver, {}}), std::logic_error);
}

// Sabotage to be caught: a reader that puts what others want into the lists, or does not pass it by.
TEST(RestartFile, ARankTakesWhatItWants) {
  const Scratch scratch;
  write(scratch.path(), nullptr);
  for (const int rank : {0, 1, 2}) {
    std::string warning;
    const auto file = open_restart(scratch.path(), warning);
    Places read(-2, 7.0);  // a rank that is not there has what everyone has
    const Places wanted(rank, 7.0);
    read.archive(*file, {Places::giver, [rank](std::size_t i) {
                           return Places::giver(i) == Archive::everyone || Places::giver(i) == rank;
                         }});
    EXPECT_TRUE(read.numbers == wanted.numbers);
    EXPECT_TRUE(read.lists == wanted.lists);
    char more = 0;
    EXPECT_THROW((*file)(more), ArchiveError) << "all was read or passed by";
  }
}

}  // namespace
}  // namespace nugget::output
