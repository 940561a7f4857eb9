// SPDX-License-Identifier: Apache-2.0
#include "nvh/complex_factorization.hpp"

#include <fmt/format.h>

#include "nvh/factorization.hpp"
#include "nvh/mumps.hpp"

namespace nugget::nvh {

ComplexFactorization::ComplexFactorization(const Matrices& m)
    : mumps_(std::make_unique<Mumps<std::complex<double>>>(m)) {
  check();
}

ComplexFactorization::~ComplexFactorization() = default;

void ComplexFactorization::check() const {
  const int code = mumps_->error();
  if (code < 0)
    throw Factorization::SolverError{
        code == -10   ? "the dynamic stiffness is singular: an undamped natural frequency, or something moves freely"
        : code == -13 ? "not enough memory to factor the dynamic stiffness"
                      : fmt::format("MUMPS gave up with INFOG(1) = {}", code)};
}

void ComplexFactorization::factor(std::complex<double> of_stiffness, std::complex<double> of_mass) {
  mumps_->factor(of_stiffness, of_mass);
  check();
}

void ComplexFactorization::solve(std::vector<std::complex<double>>& x, std::size_t columns) {
  mumps_->solve(x.data(), columns);
  check();
}

}  // namespace nugget::nvh
