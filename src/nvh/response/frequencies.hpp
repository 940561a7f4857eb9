// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/frequency.hpp"
#include "nvh/eigen/modes.hpp"

namespace nugget::nvh {

/// The frequencies that a card asks for [cycles/time], ascending.
///
/// Near modes (FSPACE 2): the ends of the range and the natural frequencies in it are there; the others are shared
/// equally among the intervals between them, and in an interval stand at mid - half cos(pi i / (n + 1)), close to its
/// ends (Chebyshev's points). The natural frequencies alone: FSPACE 3. Rigid motions are none. Throws
/// Factorization::SolverError where there are more natural frequencies than asked for in all, or none to be alone.
std::vector<double> frequencies(const model::Frequencies& wanted, const Modes& modes);

}  // namespace nugget::nvh
