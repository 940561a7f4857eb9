// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "nvh/eigen/modes.hpp"

namespace nugget::nvh {

/// The places of the spectrum from which modes are sought: one factorization after the other, the next in the place of
/// the last. What they cost goes into the cost of the modes. Matrices, callback and modes must outlive it.
class Shifts {
 public:
  Shifts(const Matrices& matrices, const ProgressCallback& progress, Modes& modes)
      : m_(matrices), progress_(progress), modes_(modes) {}

  /// Factors K - lambda M; the number of eigenvalues below lambda (Sylvester). Moves lambda a little where it hits an
  /// eigenvalue. Throws Factorization::SolverError.
  int below(double& lambda);
  /// Pairs near the last lambda. For the progress line: `known` modes of `all` are found already.
  Eigenpairs nearest(const NearestPairs& wanted, std::size_t known, std::size_t all);
  const Matrices& matrices() const { return m_; }

 private:
  void report(const std::string& text) const {
    if (progress_) progress_(text);
  }
  const Matrices& m_;
  const ProgressCallback& progress_;
  Modes& modes_;
  std::optional<Factorization> factor_;
};

}  // namespace nugget::nvh
