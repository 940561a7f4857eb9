// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <condition_variable>
#include <cstring>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "base/index.hpp"
#include "base/ranks.hpp"

namespace nugget {

/// Ranks that are threads of one process.
struct ThreadMessages {
  std::mutex mutex;
  std::condition_variable news;
  std::map<std::pair<int, int>, std::deque<std::vector<std::byte>>> queues;
};

class ThreadRanks final : public Ranks {
 public:
  ThreadRanks(ThreadMessages& messages, int count, int rank) : messages_(messages), count_(count), rank_(rank) {}
  int count() const override { return count_; }
  int rank() const override { return rank_; }
  void send(int to, std::span<const std::byte> data) override {
    const std::scoped_lock lock(messages_.mutex);
    messages_.queues[{rank_, to}].emplace_back(data.begin(), data.end());
    messages_.news.notify_all();
  }
  void receive(int from, std::span<std::byte> data) override { expected_.emplace_back(from, data); }
  void finish() override {
    for (auto& [from, data] : expected_) {
      std::unique_lock lock(messages_.mutex);
      auto& queue = messages_.queues[{from, rank_}];
      messages_.news.wait(lock, [&] { return !queue.empty(); });
      ASSERT_EQ(queue.front().size(), data.size());
      std::memcpy(data.data(), queue.front().data(), data.size());
      queue.pop_front();
    }
    expected_.clear();
  }
  void gather(std::span<const std::byte> own, std::span<std::byte> all) override {
    for (int r = 0; r < count_; ++r) {
      const auto place = all.subspan(at(r) * own.size(), own.size());
      if (r == rank_) {
        std::memcpy(place.data(), own.data(), own.size());
        continue;
      }
      send(r, own);
      receive(r, place);
    }
    finish();
  }
  void broadcast(std::span<std::byte> data) override {
    for (int r = 1; rank_ == 0 && r < count_; ++r) send(r, data);
    if (rank_ == 0) return;
    receive(0, data);
    finish();
  }
  Traffic traffic() const override { return {}; }

 private:
  ThreadMessages& messages_;
  int count_, rank_;
  std::vector<std::pair<int, std::span<std::byte>>> expected_;
};

/// Does something on each of so many ranks, all at once.
inline void on_thread_ranks(int count, const std::function<void(Ranks&)>& what) {
  ThreadMessages messages;
  std::vector<std::jthread> threads;
  for (int r = 0; r < count; ++r)
    threads.emplace_back([&messages, &what, count, r] {
      ThreadRanks ranks(messages, count, r);
      what(ranks);
    });
}

}  // namespace nugget
