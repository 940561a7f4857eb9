// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/sparse.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.hpp"
#include "base/parallel.hpp"

namespace nugget::nvh {

Symmetric::Symmetric(const std::vector<std::vector<int>>& rows) {
  start_.reserve(rows.size() + 1);
  start_.push_back(0);
  for (const std::vector<int>& r : rows) start_.push_back(start_.back() + r.size());
  row_.reserve(start_.back());
  for (const std::vector<int>& r : rows) row_.insert(row_.end(), r.begin(), r.end());
  value_.assign(row_.size(), 0.0);
}

Symmetric::Symmetric(const std::vector<int>& lengths, std::vector<int> row, std::vector<double> value)
    : row_(std::move(row)), value_(std::move(value)) {
  start_.reserve(lengths.size() + 1);
  start_.push_back(0);
  for (const int length : lengths) start_.push_back(start_.back() + at(length));
}

void Symmetric::add(int i, int j, double value) {
  if (i < j) std::swap(i, j);
  const auto first = row_.begin() + static_cast<std::ptrdiff_t>(start_[j]);
  const auto last = row_.begin() + static_cast<std::ptrdiff_t>(start_[at(j) + 1]);
  value_[std::lower_bound(first, last, i) - row_.begin()] += value;
}

void Symmetric::drop_small(double share) {
  std::vector<double> size(this->size());
  for (std::size_t j = 0; j < size.size(); ++j) size[j] = std::sqrt(std::abs(diagonal(j)));
  std::size_t kept = 0;
  for (std::size_t j = 0; j < size.size(); ++j) {
    const std::size_t first = std::exchange(start_[j], kept);
    for (std::size_t k = first; k < start_[j + 1]; ++k) {
      if (k > first && std::abs(value_[k]) <= share * size[j] * size[row_[k]]) continue;
      row_[kept] = row_[k];
      value_[kept++] = value_[k];
    }
  }
  start_.back() = kept;
  row_ = std::vector<int>(row_.begin(), row_.begin() + static_cast<std::ptrdiff_t>(kept));
  value_ = std::vector<double>(value_.begin(), value_.begin() + static_cast<std::ptrdiff_t>(kept));
}

void Symmetric::multiply(std::span<const double> x, std::span<double> y) const {
  std::fill(y.begin(), y.end(), 0.0);
  for (std::size_t j = 0; j < size(); ++j) {
    double sum = value_[start_[j]] * x[j];
    for (std::size_t k = start_[j] + 1; k < start_[j + 1]; ++k) {
      sum += value_[k] * x[row_[k]];
      y[row_[k]] += value_[k] * x[j];
    }
    y[j] += sum;
  }
}

double Symmetric::quadratic(std::span<const double> x) const {
  double sum = 0.0;
  for (std::size_t j = 0; j < size(); ++j) {
    double column = 0.5 * value_[start_[j]] * x[j];
    for (std::size_t k = start_[j] + 1; k < start_[j + 1]; ++k) column += value_[k] * x[row_[k]];
    sum += 2.0 * column * x[j];
  }
  return sum;
}

void multiply(const Symmetric& m, const Columns& x, Columns& y) {
  parallel_for(x.count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) m.multiply(x[j], y[j]);
  });
}

}  // namespace nugget::nvh
