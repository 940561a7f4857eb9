// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <map>
#include <span>
#include <vector>

#include "nvh/matrices/mumps_part.hpp"
#include "nvh/matrices/ranks.hpp"

namespace nugget::nvh {

/// An instance of MUMPS for a sum of matrices with real or complex factors, on all ranks: each call here is announced
/// to the others, which make it too. The order of `elimination_order` and the analysis serve all factors.
template <class Number>
class Mumps {
 public:
  /// `terms`: what is summed, K and M of `matrices` first; all must outlive this. Others have no entries where K and M
  /// have none.
  Mumps(const Matrices& matrices, std::vector<const Symmetric*> terms);
  ~Mumps();
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  /// One factor a term.
  void factor(std::span<const Number> factors);
  /// x := A^-1 x for columns one after the other.
  void solve(Number* x, std::size_t columns);
  /// Of the last call, INFOG(1): below 0 it failed.
  int error() const { return part_.error(); }
  const typename MumpsPart<Number>::Data& data() const { return part_.data(); }

  /// The others begin what all ranks do with their parts of this instance; `what` does it here. An exception other than
  /// a SolverError, which all of them meet, leaves them waiting.
  void together(SolverCall::Kind kind, int job, const std::function<void(MumpsPart<Number>&)>& what);

 private:
  int instance_;
  MumpsPart<Number> part_;
};

extern template class Mumps<double>;
extern template class Mumps<std::complex<double>>;

/// On the others: their parts of the instances that the first rank has.
class MumpsParts {
 public:
  explicit MumpsParts(Ranks& ranks) : ranks_(&ranks) {}
  /// A call of MUMPS.
  void answer(const SolverCall& call);
  MumpsPart<double>& real(int instance) { return real_.at(instance); }

 private:
  template <class Number>
  void answer(const SolverCall& call, std::map<int, MumpsPart<Number>>& parts);

  Ranks* ranks_;
  std::map<int, MumpsPart<double>> real_;
  std::map<int, MumpsPart<std::complex<double>>> complex_;
};

}  // namespace nugget::nvh
