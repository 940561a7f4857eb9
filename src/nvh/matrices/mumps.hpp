// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dmumps_c.h>
#include <zmumps_c.h>

#include <complex>
#include <span>
#include <type_traits>
#include <vector>

#include "nvh/matrices/matrices.hpp"

namespace nugget::nvh {

/// An instance of MUMPS for a sum of matrices with real or complex factors, symmetric (SYM = 2: pivots may be
/// negative), on all ranks. The order of `elimination_order` and the analysis serve all factors. Each process computes
/// on one thread, so that results do not depend on the machine.
template <class Number>
class Mumps {
 public:
  using Data = std::conditional_t<std::is_same_v<Number, double>, DMUMPS_STRUC_C, ZMUMPS_STRUC_C>;

  /// `terms`: what is summed, K and M of `matrices` first; all must outlive this. Others have no entries where K and M
  /// have none.
  Mumps(const Matrices& matrices, std::vector<const Symmetric*> terms);
  ~Mumps() { call(-2); }
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  /// One factor a term.
  void factor(std::span<const Number> factors);
  /// x := A^-1 x for columns one after the other.
  void solve(Number* x, std::size_t columns);
  /// Of the last call, INFOG(1): below 0 it failed.
  int error() const { return data_.infog[0]; }
  const Data& data() const { return data_; }

 private:
  void call(int job);
  MUMPS_INT& option(int i) { return data_.icntl[i - 1]; }  // numbers as in the user's guide

  std::vector<const Symmetric*> terms_;
  int instance_;
  Data data_{};
};

extern template class Mumps<double>;
extern template class Mumps<std::complex<double>>;

}  // namespace nugget::nvh
