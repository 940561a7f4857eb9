// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <iterator>
#include <vector>

namespace nugget {

/// Rising numbers that mostly follow each other, kept as runs of numbers in a row: those of nodes that stand along a
/// curve through space take some kilobytes in place of megabytes.
class Runs {
  struct Run {
    int begin, end;
  };

 public:
  /// `n`: above all that are there.
  void add(int n) {
    if (!runs_.empty() && runs_.back().end == n)
      ++runs_.back().end;
    else
      runs_.push_back({n, n + 1});
    ++size_;
  }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  class Iterator {
   public:
    using value_type = int;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::input_iterator_tag;
    using pointer = const int*;
    using reference = int;
    Iterator() = default;
    int operator*() const { return now_; }
    Iterator& operator++() {
      if (++now_ == run_->end) {
        ++run_;
        now_ = run_ == end_ ? 0 : run_->begin;
      }
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    bool operator==(const Iterator& other) const { return run_ == other.run_ && now_ == other.now_; }

   private:
    friend class Runs;
    Iterator(const Run* run, const Run* end) : run_(run), end_(end), now_(run == end ? 0 : run->begin) {}
    const Run *run_ = nullptr, *end_ = nullptr;
    int now_ = 0;
  };
  Iterator begin() const { return {runs_.data(), runs_.data() + runs_.size()}; }
  Iterator end() const { return {runs_.data() + runs_.size(), runs_.data() + runs_.size()}; }

 private:
  std::vector<Run> runs_;
  std::size_t size_ = 0;
};

}  // namespace nugget
