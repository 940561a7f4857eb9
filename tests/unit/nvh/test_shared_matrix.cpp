// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/shared_matrix.hpp"

#include <gtest/gtest.h>

#include <random>

#include "thread_ranks.hpp"

namespace nugget::nvh {
namespace {

constexpr std::size_t size = 23;

/// Full enough that each rank of seven needs rows of all behind it.
Symmetric some_matrix() {
  std::mt19937 draw(3);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<std::vector<int>> rows(size);
  for (std::size_t j = 0; j < size; ++j)
    for (std::size_t i = j; i < size; ++i)
      if (i == j || number(draw) > 0.3) rows[j].push_back(static_cast<int>(i));
  Symmetric m(rows);
  for (std::size_t j = 0; j < size; ++j)
    for (const int i : rows[j]) m.add(i, static_cast<int>(j), number(draw));
  return m;
}

Columns some_columns(std::size_t count) {
  std::mt19937 draw(5);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  Columns x(size, count);
  for (double& v : x.value) v = number(draw);
  return x;
}

Symmetric columns_of(const Symmetric& m, std::size_t begin, std::size_t end) {
  std::vector<int> length;
  for (std::size_t j = begin; j < end; ++j) length.push_back(static_cast<int>(m.rows(j).size()));
  const auto row = m.rows(begin, end);
  const auto value = m.values(begin, end);
  return {length, {row.begin(), row.end()}, {value.begin(), value.end()}};
}

Columns rows_of(const Columns& x, std::size_t begin, std::size_t rows) {
  Columns part(rows, x.count);
  for (std::size_t j = 0; j < x.count; ++j)
    for (std::size_t i = 0; i < rows; ++i) part[j][i] = x[j][begin + i];
  return part;
}

TEST(SharedMatrix, MultipliesAsTheWhole) {
  const Symmetric m = some_matrix();
  const Columns x = some_columns(3);
  Columns expected(size, 3);
  multiply(m, x, expected);
  for (const int count : {1, 2, 3, 7, 30}) {  // with 30 some have no row
    on_thread_ranks(count, [&](Ranks& ranks) {
      const RowShares shares(size, ranks);
      const SharedMatrix own(ranks, shares, columns_of(m, shares.own_begin(), shares.own_begin() + shares.own()));
      Columns y(shares.own(), x.count);
      own.multiply(rows_of(x, shares.own_begin(), shares.own()), y);
      const Columns whole = gather_rows(ranks, shares, std::move(y));
      if (ranks.rank() > 0) return;
      for (std::size_t i = 0; i < expected.value.size(); ++i)
        EXPECT_NEAR(whole.value[i], expected.value[i], 1e-14) << count << " ranks, " << i;
    });
  }
}

TEST(RowExchange, PutsWhatAnyRankHasIntoItsRow) {
  on_thread_ranks(4, [](Ranks& ranks) {
    const RowShares shares(size, ranks);
    std::vector<int> rows;  // dealt out like cards
    for (std::size_t i = static_cast<std::size_t>(ranks.rank()); i < size; i += 4)
      rows.insert(rows.begin(), static_cast<int>(i));
    const RowExchange exchange(ranks, shares, rows);
    Columns dealt(rows.size(), 1), own(shares.own(), 1), back(rows.size(), 1);
    for (std::size_t k = 0; k < rows.size(); ++k) dealt[0][k] = 100.0 + rows[k];
    exchange.put(dealt, own);
    for (std::size_t i = 0; i < own.rows; ++i)
      EXPECT_EQ(own[0][i], 100.0 + static_cast<double>(shares.own_begin() + i));
    exchange.fetch(own, back);
    EXPECT_EQ(back.value, dealt.value);
    exchange.add(dealt, own);
    for (std::size_t i = 0; i < own.rows; ++i)
      EXPECT_EQ(own[0][i], 200.0 + 2.0 * static_cast<double>(shares.own_begin() + i));
  });
}

}  // namespace
}  // namespace nugget::nvh
