// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "nvh/matrices.hpp"

namespace nugget::nvh {

/// A = K + shift M as L D L^t, by MUMPS (SYM = 2: A may be indefinite) in an order by METIS that keeps the unknowns of
/// a node together. Deterministic: one thread, whatever the machine has. Throws SolverError if A is singular or memory
/// runs out.
class Factorization {
 public:
  struct SolverError;
  Factorization(const Matrices& matrices, double shift);
  ~Factorization();
  Factorization(Factorization&&) noexcept;

  double shift() const { return shift_; }
  /// Number of negative eigenvalues of A: the eigenvalues of (K, M) below -shift (Sylvester's law of inertia).
  int negative() const;
  /// x := A^-1 x, all columns at once.
  void solve(Columns& x) const;

  struct Cost {
    double seconds = 0.0;  ///< ordering, analysis and factorization
    double entries = 0.0;  ///< of L
    double gflop = 0.0;
  };
  const Cost& cost() const { return cost_; }

 private:
  struct Mumps;
  std::unique_ptr<Mumps> mumps_;
  double shift_;
  Cost cost_;
};

/// Order of elimination: nested dissection of the graph of nodes, whose unknowns follow each other. Position by
/// equation, counted from 1 as MUMPS wants it.
std::vector<int> elimination_order(const Matrices& matrices);

struct Factorization::SolverError {
  std::string text;
};

}  // namespace nugget::nvh
