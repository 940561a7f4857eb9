// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <memory>
#include <vector>

#include "nvh/matrices/matrices.hpp"

namespace nugget::nvh {

template <class Number>
class Mumps;

/// A = a K + b M + c C with complex factors, symmetric but not Hermitian, as L D L^t by MUMPS; the order of elimination
/// and the analysis serve all factors. Deterministic like Factorization.
class ComplexFactorization {
 public:
  /// `damping`: C, null where there is none. All must outlive this.
  ComplexFactorization(const Matrices& matrices, const Symmetric* damping);
  ~ComplexFactorization();
  ComplexFactorization(const ComplexFactorization&) = delete;
  ComplexFactorization& operator=(const ComplexFactorization&) = delete;

  /// Throws Factorization::SolverError if A is singular or memory runs out.
  void factor(std::complex<double> of_stiffness, std::complex<double> of_mass, std::complex<double> of_damping);
  /// x := A^-1 x for columns one after the other.
  void solve(std::vector<std::complex<double>>& x, std::size_t columns);

 private:
  void check() const;
  bool damped_;
  std::unique_ptr<Mumps<std::complex<double>>> mumps_;
};

}  // namespace nugget::nvh
