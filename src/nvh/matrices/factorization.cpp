// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/factorization.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>

#include "nvh/matrices/mumps.hpp"

namespace nugget::nvh {

Factorization::Factorization(const Matrices& m, double shift) : shift_(shift) {
  const auto begin = std::chrono::steady_clock::now();
  mumps_ = std::make_unique<Mumps<double>>(m, std::vector{&m.stiffness, &m.mass});
  check();
  shift_to(shift);
  cost_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void Factorization::shift_to(double shift) {
  const auto begin = std::chrono::steady_clock::now();
  shift_ = shift;
  mumps_->factor(std::array{1.0, shift});
  check();
  const DMUMPS_STRUC_C& d = mumps_->data();
  cost_ = {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
           d.infog[8] < 0 ? -1e6 * d.infog[8] : d.infog[8], static_cast<double>(d.infog[20]),
           static_cast<double>(d.infog[21])};
}

void Factorization::check() const {
  const int code = mumps_->error();
  if (code < 0)
    throw SolverError{code == -10   ? "the matrix is singular: something can move without any stiffness"
                      : code == -13 ? "not enough memory to factor the matrix"
                                    : fmt::format("MUMPS gave up with INFOG(1) = {}", code),
                      code == -10};
}

Factorization::Factorization(Factorization&&) noexcept = default;
Factorization::~Factorization() = default;

int Factorization::negative() const {
  return mumps_->data().infog[11];
}

void Factorization::solve(Columns& x) const {
  mumps_->solve(x.value.data(), x.count);
  if (mumps_->error() < 0) throw SolverError::of_solution(mumps_->error());
}

Factorization::SolverError Factorization::SolverError::of_solution(int code) {
  return {code == -13 ? "not enough memory to solve with the factors"
          : code == -45
              ? "nothing is left to solve for: beside each other, masses or stiffnesses are too small or too large for "
                "numbers of double precision; see density, Young's modulus and dimensions, and their units"
              : fmt::format("MUMPS could not solve: INFOG(1) = {}", code)};
}

}  // namespace nugget::nvh
