// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <atomic>
#include <barrier>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/index.hpp"
#include "system/gathered_lists.hpp"

namespace nugget::system {
namespace {

/// Ranks that are threads, and gather only.
class ThreadRanks final : public Ranks {
 public:
  struct Meeting {
    explicit Meeting(int ranks) : data(at(ranks)), all_are_here(ranks) {}
    std::vector<std::span<const std::byte>> data;
    std::barrier<> all_are_here;
  };
  ThreadRanks(Meeting& meeting, int rank) : meeting_(meeting), rank_(rank) {}
  int count() const override { return static_cast<int>(meeting_.data.size()); }
  int rank() const override { return rank_; }
  void gather(std::span<const std::byte> own, std::span<std::byte> all) override {
    ++calls;
    meeting_.data[at(rank_)] = own;
    meeting_.all_are_here.arrive_and_wait();
    std::size_t end = 0;
    for (const auto& one : meeting_.data) {
      if (one.size() != own.size()) throw std::logic_error("ranks gather different sizes");
      std::memcpy(all.data() + end, one.data(), one.size());
      end += one.size();
    }
    meeting_.all_are_here.arrive_and_wait();
  }
  void send(int, std::span<const std::byte>) override {}
  void receive(int, std::span<std::byte>) override {}
  void finish() override {}
  void broadcast(std::span<std::byte>) override {}
  Traffic traffic() const override { return {}; }
  int calls = 0;

 private:
  Meeting& meeting_;
  int rank_;
};

// Sabotage: a list cut off where it has outgrown its room; room that ranks find different.
TEST(GatheredLists, ComeInOneMessageWhileTheyAreAboutAsLong) {
  constexpr int count = 3;
  // By time and rank: how long the lists are; and how many messages that takes.
  const std::vector<std::vector<int>> lengths{{0, 0, 0}, {4, 0, 1}, {5, 2, 5}, {1, 6, 0},
                                              {0, 0, 0}, {0, 0, 9}, {9, 9, 9}};
  const std::vector<int> messages{1, 2, 1, 1, 1, 2, 1};
  ThreadRanks::Meeting meeting(count);
  std::vector<std::thread> threads;
  std::atomic<int> wrong{0};
  for (int rank = 0; rank < count; ++rank)
    threads.emplace_back([&, rank] {
      ThreadRanks ranks(meeting, rank);
      GatheredLists<double> lists;
      for (std::size_t time = 0; time < lengths.size(); ++time) {
        std::vector<double> own, expected;
        std::vector<int> values{10 * rank, static_cast<int>(time)}, of_all, expected_values;
        for (int r = 0; r < count; ++r) {
          for (int i = 0; i < lengths[time][at(r)]; ++i) expected.push_back(100 * r + i);
          expected_values.insert(expected_values.end(), {10 * r, static_cast<int>(time)});
        }
        for (int i = 0; i < lengths[time][at(rank)]; ++i) own.push_back(100 * rank + i);
        const int before = ranks.calls;
        if (lists.gather(ranks, own, values, of_all) != expected) ++wrong;
        if (of_all != expected_values) ++wrong;
        if (ranks.calls - before != messages[time]) ++wrong;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace nugget::system
