// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace nugget::output {

/// Does one job at a time in a thread of its own, so that a run goes on while the disk is written to.
class WriterThread {
 public:
  using Job = std::function<void()>;

  WriterThread() = default;
  /// Ends when the job is done. What it throws then is lost: call `finish` first.
  ~WriterThread();
  WriterThread(const WriterThread&) = delete;
  WriterThread& operator=(const WriterThread&) = delete;

  /// Hands over a job, after `finish`.
  void start(Job job);
  /// Waits until the job is done. Throws what it has thrown, once.
  void finish();

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  Job job_;  ///< empty: there is none
  bool ending_ = false;
  std::exception_ptr failure_;
  std::thread thread_;  ///< begun with the first job
};

}  // namespace nugget::output
