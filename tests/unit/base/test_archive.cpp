// SPDX-License-Identifier: Apache-2.0
#include "base/archive.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cstring>
#include <optional>
#include <variant>

#include "base/vec3.hpp"

namespace nugget {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class IntoMemory final : public Archive {
 public:
  IntoMemory() : Archive(false) {}
  std::string kept;

 private:
  void bytes(void* data, std::size_t size) override { kept.append(static_cast<const char*>(data), size); }
};

class FromMemory final : public Archive {
 public:
  explicit FromMemory(std::string kept) : Archive(true), kept_(std::move(kept)) {}
  bool at_end() const { return next_ == kept_.size(); }

 private:
  void bytes(void* data, std::size_t size) override {
    ASSERT_LE(next_ + size, kept_.size());
    std::memcpy(data, kept_.data() + next_, size);
    next_ += size;
  }
  std::string kept_;
  std::size_t next_ = 0;
};

/// What `written` becomes in an object that was built otherwise.
template <class T>
T through(T written, T built) {
  IntoMemory out;
  out(written);
  FromMemory in(out.kept);
  in(built);
  EXPECT_TRUE(in.at_end());
  return built;
}

struct Law {
  int number = 0;
};

struct Pair {
  int segment = 0;
  Vec3d force;
};

struct Bond {
  explicit Bond(const Law* law) : law_(law) {}
  void archive(Archive& a) {
    a(pairs_, name_);
    a.built(law_);
  }
  const Law* law_;
  std::vector<Pair> pairs_;
  std::string name_;
};

struct Memory {
  virtual ~Memory() = default;
  virtual void archive(Archive& a) = 0;
};
struct Counter : Memory {
  explicit Counter(int n) : count(n) {}
  void archive(Archive& a) override { a(count); }
  int count;
};

TEST(Archive, PlainValuesComeBackBitByBit) {
  EXPECT_EQ(through(1.0 / 3.0, 0.0), 1.0 / 3.0);
  EXPECT_EQ(through(true, false), true);
  EXPECT_EQ(through(std::array{1, 2, 3}, {}), (std::array{1, 2, 3}));
  EXPECT_EQ(through(std::optional(7L), {}), 7L);
  using Either = std::variant<int, double>;
  EXPECT_EQ(std::get<double>(through(Either(2.5), Either(1))), 2.5);
  std::atomic<int> deletions{3}, others{0};
  IntoMemory out;
  out(deletions);
  FromMemory in(out.kept);
  in(others);
  EXPECT_EQ(others, 3);
}

TEST(Archive, ListsOfValuesTakeTheLengthThatIsRead) {
  EXPECT_THAT(through(std::vector{1.0, 2.0, 3.0}, {9.0}), ElementsAre(1.0, 2.0, 3.0));
  EXPECT_THAT(through(std::vector<int>{}, {1, 2}), ElementsAre());
  EXPECT_THAT(through(std::vector<std::string>{"weld 7 failed", ""}, {}), ElementsAre("weld 7 failed", ""));
  EXPECT_THAT(through(std::vector<std::vector<int>>{{1}, {2, 3}}, {}), ElementsAre(ElementsAre(1), ElementsAre(2, 3)));
  EXPECT_THAT(through(std::deque{4, 5}, {}), ElementsAre(4, 5));
  const std::map<std::string, std::vector<int>> entries{{"a", {1}}, {"b", {}}};
  EXPECT_EQ(through(entries, {{"c", {7}}}), entries);
}

TEST(Archive, ObjectsKeepWhatTheyWereBuiltWith) {
  const Law old{1}, law{2};
  Bond written(&old), built(&law);
  written.pairs_ = {{3, {1.0, 2.0, 3.0}}, {4, {}}};
  written.name_ = "glue";
  const Bond read = through(written, built);
  EXPECT_EQ(read.law_, &law);
  EXPECT_EQ(read.name_, "glue");
  ASSERT_EQ(read.pairs_.size(), 2u);
  EXPECT_EQ(read.pairs_[0].segment, 3);
  EXPECT_EQ(read.pairs_[0].force.z, 3.0);
}

TEST(Archive, AnObjectBehindAPointerArchivesItself) {
  std::unique_ptr<Memory> written = std::make_unique<Counter>(5), built = std::make_unique<Counter>(0), none;
  IntoMemory out;
  out(written);
  FromMemory in(out.kept);
  in(built);
  EXPECT_EQ(static_cast<Counter&>(*built).count, 5);
  FromMemory again(out.kept);
  EXPECT_THROW(again(none), ArchiveError);
}

TEST(Archive, ListsOfObjectsMustHaveBeenBuiltAsLong) {
  const Law law;
  std::vector<Bond> written(3, Bond(&law)), built(2, Bond(&law));
  IntoMemory out;
  out(written);
  FromMemory in(out.kept);
  try {
    in(built);
    FAIL() << "two bonds took the state of three";
  } catch (const ArchiveError& error) {
    EXPECT_THAT(error.what(), HasSubstr("3 objects where 2 were built"));
  }
}

TEST(Archive, ASectionThatIsAnotherIsAnError) {
  IntoMemory out;
  out.section("contact");
  FromMemory right(out.kept), wrong(out.kept);
  EXPECT_NO_THROW(right.section("contact"));
  EXPECT_THROW(wrong.section("welds"), ArchiveError);
}

}  // namespace
}  // namespace nugget
