// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <mpi.h>

#include <array>
#include <chrono>
#include <thread>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/programs/started_ranks.hpp"
#include "app/terminal.hpp"
#include "nvh/matrices/ranks.hpp"

// `nugget-mpi`: the same program with MPI. The first rank does what the command line asks for, the others answer its
// calls of the solver.
namespace {

using nugget::nvh::SolverCall;

/// Passes on a call of the first rank. Who waits for one sleeps between two checks: the cores belong to the first rank
/// meanwhile.
void pass_on(SolverCall& call, MPI_Comm ranks) {
  std::array<int, 3> words{static_cast<int>(call.kind), call.instance, call.job};
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibcast(words.data(), static_cast<int>(words.size()), MPI_INT, 0, ranks, &request);
  for (int done = 0;;) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done) break;
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
  call = {static_cast<SolverCall::Kind>(words[0]), words[1], words[2]};
}

int lead(int argc, char** argv, int count, MPI_Comm ranks) {
  const auto send = [&](SolverCall call) { pass_on(call, ranks); };
  nugget::nvh::lead_ranks(count, send);
  const int code = nugget::app::command_line(argc, argv);
  send({SolverCall::Kind::end});
  return code;
}

int run(int argc, char** argv) {
  int count = 1, rank = 0;
  MPI_Comm ranks = MPI_COMM_NULL;
  MPI_Comm_dup(MPI_COMM_WORLD, &ranks);  // calls do not meet the solver's own messages
  MPI_Comm_size(ranks, &count);
  MPI_Comm_rank(ranks, &rank);
  if (count != nugget::app::started_ranks()) {
    fmt::print(stderr, "nugget: the mpirun that started this is not that of the MPI with which nugget-mpi was built\n");
    return static_cast<int>(nugget::app::ExitCode::wrong_command);
  }
  if (rank == 0) {
    nugget::app::guard_terminal();
    return nugget::app::code_after_terminal(lead(argc, argv, count, ranks));
  }
  nugget::nvh::follow_calls([&] {
    SolverCall call;
    pass_on(call, ranks);
    return call;
  });
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  int given = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &given);
  const int code = run(argc, argv);
  MPI_Finalize();
  return code;
}
