// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace nugget::output {

/// Does one job after the other in a thread of its own, so that a run goes on while the disk is written to.
class WriterThread {
 public:
  using Job = std::function<void()>;

  WriterThread() = default;
  /// Ends when all jobs are done. What they throw then is lost: call `finish` first.
  ~WriterThread();
  WriterThread(const WriterThread&) = delete;
  WriterThread& operator=(const WriterThread&) = delete;

  /// Hands over a job, after `finish`.
  void start(Job job);
  /// Hands over a job behind the others, which holds so many bytes of memory; waits until those that are not done hold,
  /// with this one, no more than `room`, or there are none. Throws as `finish`.
  void add(Job job, std::size_t bytes, std::size_t room);
  /// Waits until all jobs are done. Throws what one has thrown, once; those behind it are not done.
  void finish();

 private:
  struct Handed {
    Job job;
    std::size_t bytes = 0;
  };
  void work();
  void throw_failure();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Handed> jobs_;  ///< not done; the first one is being done
  std::size_t bytes_ = 0;    ///< of them all
  bool ending_ = false;
  std::exception_ptr failure_;
  std::thread thread_;  ///< begun with the first job
};

}  // namespace nugget::output
