// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nvh/eigen/modes.hpp"

namespace nugget::nvh {

/// sqrt(lambda) / (2 pi), of round-off below zero 0 [1/time]
double frequency_of(double eigenvalue);
/// (2 pi frequency)^2
double eigenvalue_of(double frequency);

/// The eigenpairs of a request, ascending, by shift and invert at one place: below zero for the lowest, at the centre,
/// at the lower end or in the middle of an interval; where many are wanted, at several (mode_slices.hpp). Fills in the
/// proof and the cost. That none was missed is proved by Sylvester's count at the ends of the interval, or at the
/// distance from the shift to which all were found, in a gap of the spectrum. Throws Factorization::SolverError, also
/// where eigenvalues are negative.
Eigenpairs search_modes(const Matrices& matrices, const ModeRequest& request, const ProgressCallback& progress,
                        Modes& modes);

}  // namespace nugget::nvh
