// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nvh/eigen/shifts.hpp"

namespace nugget::nvh {

/// The part of the spectrum in which modes are sought, in eigenvalues; `low` may be minus, `high` plus infinity.
struct Spectrum {
  double low, high;
  int before = 0;          ///< eigenvalues below `low`
  int inside = 0;          ///< between `low` and `high`
  std::size_t wanted = 0;  ///< so many of them
  bool whole() const { return wanted == static_cast<std::size_t>(inside); }
};

/// A place, and how many eigenvalues lie below it.
struct Counted {
  double place;
  int below;
};

/// The lowest eigenpairs of a part of the spectrum, ascending, from several shifts one above the other (Grimes, Lewis,
/// Simon, SIAM J. Matrix Anal. Appl. 15 (1994) 228, section 4): each finds pairs around it, and all those down to the
/// pairs of the shift before, whose number is known from the counts at both: as many as there is memory for where the
/// last shift finds `slice` of them. So memory grows as the modes do. `first` is the lowest shift,
/// below `low` or at it, where `shifts` stand already and counted. Fills in the proof: counted and found differ where a
/// pair could not be found. Throws Factorization::SolverError.
Eigenpairs find_in_slices(Shifts& shifts, const Spectrum& spectrum, Counted first, std::size_t slice,
                          Modes::Proof& proof);

}  // namespace nugget::nvh
