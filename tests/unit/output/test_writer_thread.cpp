// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "output/writer_thread.hpp"

namespace nugget::output {
namespace {

TEST(WriterThread, TheCallerGoesOnMeanwhile) {
  WriterThread writer;
  std::atomic<bool> go{false};
  std::thread::id of_job;
  writer.start([&] {
    while (!go) std::this_thread::yield();
    of_job = std::this_thread::get_id();
  });
  go = true;  // never reached if `start` waited
  writer.finish();
  EXPECT_NE(of_job, std::thread::id{});
  EXPECT_NE(of_job, std::this_thread::get_id());
}

TEST(WriterThread, ANewJobBeginsAfterTheLast) {
  std::vector<int> order;
  {
    WriterThread writer;
    for (int i = 0; i < 5; ++i)
      writer.start([&order, i] {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        order.push_back(i);
      });
  }
  EXPECT_THAT(order, testing::ElementsAre(0, 1, 2, 3, 4));
}

TEST(WriterThread, WhatAJobThrowsReachesTheCallerOnce) {
  WriterThread writer;
  const auto fail = [] { throw std::runtime_error("disk full"); };
  writer.start(fail);
  EXPECT_THROW(writer.finish(), std::runtime_error);
  writer.finish();
  writer.start(fail);
  bool ran = false;
  EXPECT_THROW(writer.start([&] { ran = true; }), std::runtime_error);
  EXPECT_FALSE(ran);
}

TEST(WriterThread, JobsWaitWhileThereIsRoomForWhatTheyHold) {
  WriterThread writer;
  std::atomic<int> done{0};
  std::atomic<bool> go{false};
  const auto job = [&] {
    while (!go) std::this_thread::yield();
    ++done;
  };
  writer.add(job, 100, 10);  // more than there is room for: nothing else waits
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    go = true;
  });
  writer.add(job, 1, 10);  // waits for the first one
  EXPECT_GE(done, 1);
  other.join();
  writer.finish();
  EXPECT_EQ(done, 2);

  go = false;
  for (int i = 0; i < 10; ++i) writer.add(job, 1, 10);  // never reached the end if one of them waited
  go = true;
  writer.finish();
  EXPECT_EQ(done, 12);
}

TEST(WriterThread, JobsBehindOneThatFailsAreNotDone) {
  WriterThread writer;
  std::atomic<bool> go{false}, ran{false};
  writer.add(
      [&] {
        while (!go) std::this_thread::yield();
        throw std::runtime_error("disk full");
      },
      1, 10);
  writer.add([&] { ran = true; }, 1, 10);
  go = true;
  EXPECT_THROW(writer.finish(), std::runtime_error);
  EXPECT_FALSE(ran);
  writer.add([&] { ran = true; }, 1, 10);
  writer.finish();
  EXPECT_TRUE(ran);
}

}  // namespace
}  // namespace nugget::output
