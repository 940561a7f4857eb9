// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace nugget::nvh {

/// Columns of length n side by side, in one array.
struct Columns {
  std::size_t rows = 0, count = 0;
  std::vector<double> value;

  Columns() = default;
  Columns(std::size_t n, std::size_t columns) : rows(n), count(columns), value(n * columns, 0.0) {}
  /// Keeps its memory; what is in it is not defined.
  void reshape(std::size_t n, std::size_t columns) {
    rows = n, count = columns;
    value.resize(n * columns);
  }
  std::span<double> operator[](std::size_t j) { return {value.data() + j * rows, rows}; }
  std::span<const double> operator[](std::size_t j) const { return {value.data() + j * rows, rows}; }
};

/// A symmetric matrix of which the lower triangle is kept, column by column with ascending rows; the diagonal entry of
/// a column, the first, is always there.
class Symmetric {
 public:
  Symmetric() = default;
  /// Rows of each column, ascending, the diagonal first; all values zero.
  explicit Symmetric(const std::vector<std::vector<int>>& rows);
  /// How many entries each column has, their rows and values.
  Symmetric(const std::vector<int>& lengths, std::vector<int> row, std::vector<double> value);

  std::size_t size() const { return start_.empty() ? 0 : start_.size() - 1; }
  std::size_t entries() const { return row_.size(); }
  std::span<const int> rows(std::size_t column) const {
    return {row_.data() + start_[column], start_[column + 1] - start_[column]};
  }
  std::span<const double> values(std::size_t column) const {
    return {value_.data() + start_[column], start_[column + 1] - start_[column]};
  }
  /// Of columns begin to end, one behind the other.
  std::span<const int> rows(std::size_t begin, std::size_t end) const {
    return {row_.data() + start_[begin], start_[end] - start_[begin]};
  }
  std::span<const double> values(std::size_t begin, std::size_t end) const {
    return {value_.data() + start_[begin], start_[end] - start_[begin]};
  }
  /// Adds to entry (i, j) or (j, i), which must be in the pattern.
  void add(int i, int j, double value);
  double diagonal(std::size_t i) const { return value_[start_[i]]; }
  /// Forgets entries that are next to nothing beside the diagonal, |a_ij| <= share sqrt(|a_ii a_jj|).
  void drop_small(double share);

  /// y := this x, for one column.
  void multiply(std::span<const double> x, std::span<double> y) const;
  /// x^t this x.
  double quadratic(std::span<const double> x) const;

 private:
  std::vector<std::size_t> start_;
  std::vector<int> row_;
  std::vector<double> value_;
};

/// y := m x, columns in parallel.
void multiply(const Symmetric& m, const Columns& x, Columns& y);

}  // namespace nugget::nvh
