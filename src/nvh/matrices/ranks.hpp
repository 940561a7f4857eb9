// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

// Several processes that solve together (`mpirun -n N nugget`): the first runs the program, the others answer its calls
// of MUMPS and hold their parts of the factors. What carries the calls, MPI, is known to the program `nugget-mpi` only.
namespace nugget::nvh {

/// A call of MUMPS, which all ranks make together.
struct SolverCall {
  enum class Kind : int { real, complex, end };
  Kind kind = Kind::end;
  int instance = 0;  ///< of MUMPS, numbered by the first rank
  int job = 0;       ///< MUMPS' word for what is to be done; -1 makes an instance, -2 ends it
};

/// How many processes solve together: 1 if nobody leads.
int ranks();

/// On the first rank: from now on `send` passes each call on to the others before it is made here.
void lead_ranks(int count, std::function<void(const SolverCall&)> send);

/// On the others: makes the calls that `next` waits for, to the end.
void follow_calls(const std::function<SolverCall()>& next);

}  // namespace nugget::nvh
