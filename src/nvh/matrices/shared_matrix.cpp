// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/shared_matrix.hpp"

#include <algorithm>
#include <utility>

namespace nugget::nvh {
namespace {

/// Rows of the own columns that other ranks have, ascending: only those behind, since the lower triangle is kept.
std::vector<int> rows_elsewhere(const RowShares& shares, const Symmetric& columns) {
  const int end = static_cast<int>(shares.own_begin() + shares.own());
  std::vector<int> rows;
  for (const int i : columns.rows(0, shares.own()))
    if (i >= end) rows.push_back(i);
  std::ranges::sort(rows);
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

Symmetric own_columns(const RowShares& shares, const Symmetric& columns, const std::vector<int>& elsewhere) {
  const int begin = static_cast<int>(shares.own_begin()), own = static_cast<int>(shares.own());
  std::vector<int> length, row;
  for (std::size_t j = 0; j < shares.own(); ++j) {
    length.push_back(static_cast<int>(columns.rows(j).size()));
    for (const int i : columns.rows(j))
      row.push_back(i < begin + own
                        ? i - begin
                        : own + static_cast<int>(std::ranges::lower_bound(elsewhere, i) - elsewhere.begin()));
  }
  const std::span<const double> value = columns.values(0, shares.own());
  return {length, std::move(row), {value.begin(), value.end()}};
}

}  // namespace

SharedMatrix::SharedMatrix(Ranks& ranks, const RowShares& shares, const Symmetric& columns)
    : SharedMatrix(ranks, shares, columns, rows_elsewhere(shares, columns)) {}

SharedMatrix::SharedMatrix(Ranks& ranks, const RowShares& shares, const Symmetric& columns,
                           const std::vector<int>& elsewhere)
    : own_(own_columns(shares, columns, elsewhere)), elsewhere_(ranks, shares, elsewhere) {}

void SharedMatrix::multiply(const Columns& x, Columns& y) const {
  const std::size_t own = x.rows, copies = elsewhere_.copies();
  Columns there(copies, x.count), all(own + copies, x.count), product(own + copies, x.count);
  elsewhere_.fetch(x, there);
  for (std::size_t j = 0; j < x.count; ++j) {
    std::ranges::copy(x[j], all[j].begin());
    std::ranges::copy(there[j], all[j].begin() + static_cast<std::ptrdiff_t>(own));
  }
  nvh::multiply(own_, all, product);
  for (std::size_t j = 0; j < x.count; ++j) {
    std::ranges::copy(product[j].first(own), y[j].begin());
    std::ranges::copy(product[j].subspan(own), there[j].begin());
  }
  elsewhere_.add(there, y);
}

}  // namespace nugget::nvh
