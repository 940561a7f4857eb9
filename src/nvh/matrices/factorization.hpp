// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "nvh/matrices/matrices.hpp"

namespace nugget::nvh {

template <class Number>
class Mumps;

/// A = K + shift M as L D L^t, by MUMPS (SYM = 2: A may be indefinite) in the order of `elimination_order`.
/// Deterministic with one rank: one thread, whatever the machine has. Throws SolverError if A is singular or memory
/// runs out.
class Factorization {
 public:
  struct SolverError;
  /// The matrices must outlive it.
  Factorization(const Matrices& matrices, double shift);
  ~Factorization();
  Factorization(Factorization&&) noexcept;

  double shift() const { return shift_; }
  /// Another shift in its place: only numbers are computed anew. After a SolverError another one may be tried.
  void shift_to(double shift);
  /// Number of negative eigenvalues of A: the eigenvalues of (K, M) below -shift (Sylvester's law of inertia).
  int negative() const;
  /// x := A^-1 x, all columns at once.
  void solve(Columns& x) const;
  /// Of all ranks.
  Mumps<double>& mumps() const { return *mumps_; }

  struct Cost {
    double seconds = 0.0;                    ///< of the last shift; ordering and analysis count with the first
    double entries = 0.0;                    ///< of L
    double most_memory = 0.0, memory = 0.0;  ///< of the solver, on the rank with the most and on all of them [MB]
  };
  const Cost& cost() const { return cost_; }

 private:
  void check() const;
  std::unique_ptr<Mumps<double>> mumps_;
  double shift_;
  Cost cost_;
};

struct Factorization::SolverError {
  std::string text;
  bool singular = false;

  /// Of a solution for which MUMPS gave INFOG(1) = code.
  static SolverError of_solution(int code);
};

}  // namespace nugget::nvh
