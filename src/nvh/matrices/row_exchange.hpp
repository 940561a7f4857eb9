// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "base/ranks.hpp"
#include "nvh/matrices/sparse.hpp"

namespace nugget::nvh {

/// Rows of vectors shared out among ranks: the same number for each, one rank behind the other.
class RowShares {
 public:
  RowShares(std::size_t rows, const Ranks& ranks);

  std::size_t rows() const { return rows_; }
  std::size_t begin(int rank) const;
  std::size_t end(int rank) const { return begin(rank + 1); }
  int owner(std::size_t row) const;
  std::size_t own_begin() const { return begin(rank_); }
  std::size_t own() const { return end(rank_) - begin(rank_); }

 private:
  std::size_t rows_;
  int count_, rank_;
};

/// Entries of vectors with shared rows that this rank needs or has besides its own rows: copies, named by their rows.
/// Each function is called by all ranks together.
class RowExchange {
 public:
  /// `row`: of each copy; may be among the own ones.
  RowExchange(Ranks& ranks, const RowShares& shares, const std::vector<int>& row);

  std::size_t copies() const { return copies_; }
  /// copies := x, rows as given to the constructor.
  void fetch(const Columns& x, Columns& copies) const;
  /// x := copies; each row has one copy, on one rank.
  void put(const Columns& copies, Columns& x) const;
  /// x += copies, in the order of ranks.
  void add(const Columns& copies, Columns& x) const;

 private:
  enum class To { owners, copies };
  /// Packs `from` by rank, sends it, and gives what arrived, by rank.
  std::vector<std::vector<double>> exchange(To to, const Columns& from) const;

  Ranks* ranks_;
  std::size_t copies_;
  std::vector<std::vector<std::size_t>> mine_;  ///< by owner: which copies
  std::vector<std::vector<int>> theirs_;        ///< by rank that has copies: which of the own rows
};

/// The rows of a matrix with rows shared out, on the first rank; empty on the others. The parameter is lost.
Columns gather_rows(Ranks& ranks, const RowShares& shares, Columns own);

}  // namespace nugget::nvh
