// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/complex_factorization.hpp"

#include <fmt/format.h>

#include "nvh/matrices/factorization.hpp"
#include "nvh/matrices/mumps.hpp"

namespace nugget::nvh {
namespace {

std::vector<const Symmetric*> terms(const Matrices& m, const Symmetric* damping) {
  std::vector<const Symmetric*> all{&m.stiffness, &m.mass};
  if (damping != nullptr) all.push_back(damping);
  return all;
}

}  // namespace

ComplexFactorization::ComplexFactorization(const Matrices& m, const Symmetric* damping)
    : damped_(damping != nullptr), mumps_(std::make_unique<Mumps<std::complex<double>>>(m, terms(m, damping))) {
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

void ComplexFactorization::factor(std::complex<double> of_stiffness, std::complex<double> of_mass,
                                  std::complex<double> of_damping) {
  std::vector<std::complex<double>> factors{of_stiffness, of_mass};
  if (damped_) factors.push_back(of_damping);
  mumps_->factor(factors);
  check();
}

void ComplexFactorization::solve(std::vector<std::complex<double>>& x, std::size_t columns) {
  mumps_->solve(x.data(), columns);
  check();
}

}  // namespace nugget::nvh
