// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace nugget::app {

/// One line on the terminal that says what is going on.
class Status {
 public:
  explicit Status(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO)) {}
  ~Status() { clear(); }
  Status(const Status&) = delete;
  Status& operator=(const Status&) = delete;
  void operator()(const std::string& text) {
    if (shown_) fmt::print(stderr, "\r\033[K{}", text);
  }
  void clear() {
    if (shown_) fmt::print(stderr, "\r\033[K");
  }

 private:
  bool shown_;
};

}  // namespace nugget::app
