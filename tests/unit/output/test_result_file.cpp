// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <string>

#include "output/binout.hpp"
#include "output/d3plot.hpp"
#include "output/result_file.hpp"
#include "output/results.hpp"
#include "output/summary.hpp"
#include "output/swforc.hpp"
#include "unit/output/scratch.hpp"

namespace nugget::output {
namespace {

TEST(ResultFile, ReachesTheDiskAtCommit) {
  Scratch scratch;
  ResultFile file(scratch / "a");
  file.buffer() = "one";
  EXPECT_EQ(content(scratch / "a"), "");
  file.commit();
  EXPECT_EQ(content(scratch / "a"), "one");
  file.buffer() += "two";
  file.commit();
  file.write_at(1, "NE");
  EXPECT_EQ(content(scratch / "a"), "oNEtwo");
  EXPECT_EQ(file.size(), 6u);
}

TEST(ResultFile, EmptiesAnEarlierFile) {
  Scratch scratch;
  put(scratch / "a", "old");
  ResultFile file(scratch / "a");
  EXPECT_EQ(content(scratch / "a"), "");
}

TEST(ResultFile, SaysWhyItCannotBeOpened) {
  Scratch scratch;
  try {
    ResultFile file(scratch / "nowhere/a");
    FAIL() << "opened a file in a folder that is not there";
  } catch (const WriteError& error) {
    EXPECT_EQ(error.path, scratch / "nowhere/a");
    EXPECT_THAT(error.reason, testing::HasSubstr("No such file"));
    EXPECT_THAT(error.what(), testing::StartsWith("cannot write "));
  }
}

template <class Action>
void expect_disk_full(Action action) {
  try {
    action();
    FAIL() << "wrote to a full disk";
  } catch (const WriteError& error) {
    EXPECT_THAT(error.reason, testing::HasSubstr("No space left"));
  }
}

// /dev/full answers every write as a full disk does.
TEST(ResultFile, FullDiskIsAWriteErrorForEachKindOfFile) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this machine";
  Scratch scratch;
  for (const char* name : {"swforc", "binout0000", "d3plot"})
    std::filesystem::create_symlink("/dev/full", scratch / name);
  expect_disk_full([&] { AsciiHistory(swforc(), scratch / "swforc", {}); });
  expect_disk_full([&] { Binout(scratch.path(), {}); });
  expect_disk_full([&] { D3plot(scratch.path(), {}); });
}

/// Lets files of this process grow to so many bytes, as a quota does.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_DFL);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

TEST(ResultFile, AFailedCommitIsCutBack) {
  Scratch scratch;
  ResultFile file(scratch / "a");
  file.buffer() = "whole state";
  file.commit();
  {
    FileSizeLimit limit(20);  // room for a part of the next one
    file.buffer() = std::string(100, 'x');
    EXPECT_THROW(file.commit(), WriteError);
  }
  EXPECT_EQ(content(scratch / "a"), "whole state");
}

TEST(ResultFile, PartsOfAStateCountAtItsCommit) {
  Scratch scratch;
  ResultFile file(scratch / "a");
  file.buffer() = "one ";
  file.commit();
  file.buffer() = "two ";
  file.flush();
  file.buffer() = "three ";
  const std::uint64_t room = file.leave_room(5);
  EXPECT_EQ(room, 14u);
  file.buffer() = "five";
  EXPECT_EQ(file.end(), 23u);
  EXPECT_EQ(file.size(), 4u);
  file.write_ahead(room, "four ");
  file.commit();
  EXPECT_EQ(content(scratch / "a"), "one two three four five");
  EXPECT_EQ(file.size(), 23u);
}

TEST(ResultFile, PartsOfAStateAreCutOffWhereOneDoesNotFit) {
  Scratch scratch;
  ResultFile file(scratch / "a");
  file.buffer() = "whole state";
  file.commit();
  file.buffer() = "part";
  file.flush();
  {
    FileSizeLimit limit(20);
    file.buffer() = std::string(100, 'x');
    EXPECT_THROW(file.flush(), WriteError);
  }
  EXPECT_EQ(content(scratch / "a"), "whole state");
}

TEST(ResultFile, WholeFilesThatDoNotFitAreNotThere) {
  Scratch scratch;
  {
    FileSizeLimit limit(20);
    EXPECT_THROW(write_summary(scratch.path(), {}), WriteError);
    EXPECT_THROW(write_welds(scratch.path(), {}), WriteError);
  }
  EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
}

// Sabotage: the draft opened like any other file.
TEST(ResultFile, ADraftIsNotWrittenThroughALink) {
  Scratch scratch;
  put(scratch / "precious", "mine");
  std::filesystem::create_symlink(scratch / "precious", scratch / "a.part");
  write_whole_file(scratch / "a", "new");
  EXPECT_EQ(content(scratch / "a"), "new");
  EXPECT_EQ(content(scratch / "precious"), "mine");
}

TEST(ResultFile, AFileThatIsRemovedIsAWriteError) {
  Scratch scratch;
  ResultFile file(scratch / "a");
  std::filesystem::remove(scratch / "a");
  file.buffer() = "state";
  EXPECT_THROW(file.commit(), WriteError);
}

/// A d3plot of one state; what `more` writes does not fit, and leaves that state as it was.
void expect_a_state_is_kept(const std::function<void(D3plot&, const D3plotState&)>& more) {
  Scratch scratch;
  D3plotGeometry g;
  for (int id = 1; id <= 100; ++id) g.node_ids.push_back(id);
  g.x.resize(100);
  D3plotState s;
  s.x.resize(100), s.v.resize(100), s.a.resize(100);
  D3plot file(scratch.path(), g);
  file.write(s);
  const std::string good = content(scratch / "d3plot01");
  {
    FileSizeLimit limit(good.size() + 512);
    EXPECT_THROW(more(file, s), WriteError);
  }
  const std::string left = content(scratch / "d3plot01");
  const std::size_t state_and_mark = 4 * (1 + 6 + 900 + 1);
  EXPECT_EQ(left.substr(0, state_and_mark), good.substr(0, state_and_mark));
  EXPECT_EQ(left.size(), good.size());
}

TEST(ResultFile, D3plotKeepsItsStatesWhenTheDiskFillsUp) {
  expect_a_state_is_kept([](D3plot& file, const D3plotState& s) { file.write(s); });
}

TEST(ResultFile, D3plotKeepsItsStatesWhenAPieceDoesNotFit) {
  expect_a_state_is_kept([](D3plot& file, const D3plotState&) {
    EXPECT_NO_THROW({
      file.begin_state();
      file.put_piece(std::string(600, 'x'));  // fits
    });
    file.put_piece(std::string(2000, 'x'));
  });
}

TEST(ResultFile, NoPermissionIsAWriteError) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  Scratch scratch;
  std::filesystem::permissions(scratch.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_THROW(write_summary(scratch.path(), {}), WriteError);
  std::filesystem::permissions(scratch.path(), std::filesystem::perms::owner_all);
}

TEST(WholeFile, IsReplacedAtOnce) {
  Scratch scratch;
  put(scratch / "a", "a longer old text");
  write_whole_file(scratch / "a", "new");
  EXPECT_EQ(content(scratch / "a"), "new");
  EXPECT_FALSE(std::filesystem::exists(scratch / "a.part"));
}

TEST(OldResults, OnlyOursAreRemoved) {
  Scratch scratch;
  const std::vector<std::string> ours{"binout0000", "d3eigv01", "d3plot",       "d3plot01", "d3plot100",
                                      "glstat",     "run.log",  "summary.json", "swforc",   "welds.csv"};
  const std::vector<std::string> theirs{"model.k",  "d3plot1",   "d3plot01.bak", "d3plotxy",
                                        "d3dump01", "my_swforc", "binout0001"};
  for (const std::string& name : ours) put(scratch / name, "x");
  for (const std::string& name : theirs) put(scratch / name, "x");
  std::filesystem::create_directory(scratch / "nodout");

  std::vector<std::string> removed;
  for (const auto& path : remove_old_results(scratch.path())) removed.push_back(path.filename().string());
  EXPECT_EQ(removed, ours);
  for (const std::string& name : ours) EXPECT_FALSE(std::filesystem::exists(scratch / name)) << name;
  for (const std::string& name : theirs) EXPECT_TRUE(std::filesystem::exists(scratch / name)) << name;
  EXPECT_TRUE(std::filesystem::is_directory(scratch / "nodout"));
}

TEST(OldResults, AFolderThatIsNotThereHasNone) {
  Scratch scratch;
  EXPECT_TRUE(remove_old_results(scratch / "nowhere").empty());
}

}  // namespace
}  // namespace nugget::output
