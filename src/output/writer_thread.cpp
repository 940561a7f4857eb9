// SPDX-License-Identifier: Apache-2.0
#include "output/writer_thread.hpp"

#include <utility>

namespace nugget::output {

WriterThread::~WriterThread() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void WriterThread::start(Job job) {
  finish();
  add(std::move(job), 0, 0);
}

void WriterThread::add(Job job, std::size_t bytes, std::size_t room) {
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return jobs_.empty() || bytes_ + bytes <= room; });
    throw_failure();
    jobs_.push_back({std::move(job), bytes});
    bytes_ += bytes;
  }
  changed_.notify_all();
  if (!thread_.joinable()) thread_ = std::thread([this] { work(); });
}

void WriterThread::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return jobs_.empty(); });
  throw_failure();
}

void WriterThread::throw_failure() {
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void WriterThread::work() {
  for (std::unique_lock lock(mutex_);;) {
    changed_.wait(lock, [this] { return !jobs_.empty() || ending_; });
    if (jobs_.empty()) return;
    Handed first = std::move(jobs_.front());  // its place says that it is not done
    lock.unlock();
    std::exception_ptr thrown;
    try {
      first.job();
    } catch (...) {
      thrown = std::current_exception();
    }
    first.job = nullptr;
    lock.lock();
    bytes_ -= first.bytes;
    jobs_.pop_front();
    if (thrown) {
      failure_ = thrown;
      jobs_.clear();
      bytes_ = 0;
    }
    changed_.notify_all();
  }
}

}  // namespace nugget::output
