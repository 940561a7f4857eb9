// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "base/ranks.hpp"

// Several processes that solve together (`mpirun -n N nugget`): the first runs the program; the others answer its calls
// and hold their shares of matrices, factors and Lanczos vectors. What carries the calls, MPI, is known to the program
// `nugget-mpi` only.
namespace nugget::nvh {

/// What all ranks do together: a call of MUMPS, or a search for eigenpairs.
struct SolverCall {
  enum class Kind : int { real, complex, eigenpairs, end };
  Kind kind = Kind::end;
  int instance = 0;  ///< of MUMPS, numbered by the first rank
  int job = 0;       ///< MUMPS' word for what is to be done; -1 makes an instance, -2 ends it
};

/// How many processes solve together: 1 if nobody leads.
int ranks();

/// On the first rank: from now on `send` passes each call on to the others before it is made here.
void lead_ranks(Ranks& ranks, std::function<void(const SolverCall&)> send);

/// Whether the first rank has left what the others are still in, by an error of its own: they wait for ever.
bool left_ranks_waiting();

/// Whether a call of MUMPS is under way. Where a program ends within one, the Fortran runtime ended it: MUMPS 5.5.1
/// does so on its way out of a solution for which memory did not suffice.
bool within_mumps();

}  // namespace nugget::nvh
