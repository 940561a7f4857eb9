// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dmumps_c.h>
#include <zmumps_c.h>

#include <complex>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "base/ranks.hpp"
#include "nvh/matrices/matrices.hpp"
#include "nvh/matrices/row_exchange.hpp"

namespace nugget::nvh {

/// What one rank has of an instance of MUMPS, of a sum of symmetric matrices (SYM = 2: pivots may be negative), and its
/// part in each call. Alone it has everything. With others it has the columns of the matrices that go with its rows
/// (RowShares), and all ranks make each call together; the first one brings what the calls are about. Each process
/// computes on one thread, so that results do not depend on the machine.
template <class Number>
class MumpsPart {
 public:
  using Data = std::conditional_t<std::is_same_v<Number, double>, DMUMPS_STRUC_C, ZMUMPS_STRUC_C>;

  /// `ranks`: null alone.
  explicit MumpsPart(Ranks* ranks);
  ~MumpsPart();
  MumpsPart(const MumpsPart&) = delete;
  MumpsPart& operator=(const MumpsPart&) = delete;

  /// On the first rank: orders and analyses the sum of `terms`, K and M of `matrices` first, which must outlive this,
  /// and sends the others their columns.
  void analyse(const Matrices& matrices, std::vector<const Symmetric*> terms);
  /// On the others.
  void analyse();
  /// One factor a term, of the first rank.
  void factor(std::span<const Number> factors);
  /// On the first rank x := A^-1 x for columns one after the other; the others help.
  void solve(Number* x, std::size_t columns);
  /// x := A^-1 x, where each rank has its rows. With other ranks and real numbers only.
  void solve_rows(Columns& x);

  /// The others wait in a call that this rank could not finish: there will be no more calls.
  void leave() { left_ = ranks_ != nullptr; }

  /// Of the last call, INFOG(1): below 0 it failed, on all ranks.
  int error() const { return data_.infog[0]; }
  const Data& data() const { return data_; }

  Ranks& with_ranks() const { return *ranks_; }
  const RowShares& shares() const { return *shares_; }
  /// Of the last factorization, on each rank.
  std::span<const Number> factors() const { return factors_; }
  /// The own columns of term t, the first `shares().own()` of this matrix.
  const Symmetric& columns(std::size_t t) const { return *terms_[t]; }

 private:
  struct Entries;
  void call(int job);
  void send_columns();
  void receive_columns();
  MUMPS_INT& option(int i) { return data_.icntl[i - 1]; }  // numbers as in the user's guide

  Ranks* ranks_;
  bool left_ = false;
  std::optional<RowShares> shares_;  ///< with others
  std::vector<const Symmetric*> terms_;
  std::vector<Symmetric> received_;
  std::vector<Number> factors_;
  std::optional<RowExchange> solution_;  ///< from where MUMPS leaves it to its rows; of this factorization
  Data data_{};
};

extern template class MumpsPart<double>;
extern template class MumpsPart<std::complex<double>>;

}  // namespace nugget::nvh
