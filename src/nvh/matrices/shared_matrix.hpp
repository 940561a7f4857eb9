// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nvh/matrices/row_exchange.hpp"

namespace nugget::nvh {

/// A symmetric matrix whose columns, and the vectors that it multiplies, are shared out among ranks (RowShares).
class SharedMatrix {
 public:
  /// Of `columns` the first ones, as many as this rank has rows, are its own; their rows are those of the whole matrix.
  SharedMatrix(Ranks& ranks, const RowShares& shares, const Symmetric& columns);

  /// y := this x, by all ranks together: each has its rows of both.
  void multiply(const Columns& x, Columns& y) const;

 private:
  SharedMatrix(Ranks& ranks, const RowShares& shares, const Symmetric& columns, const std::vector<int>& elsewhere);

  Symmetric own_;          ///< rows count from the first own one; those of other ranks follow behind the own ones
  RowExchange elsewhere_;  ///< those of other ranks
};

}  // namespace nugget::nvh
