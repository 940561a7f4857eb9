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

}  // namespace
}  // namespace nugget::output
