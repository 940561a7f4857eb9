// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/programs/started_ranks.hpp"
#include "app/terminal.hpp"

namespace {

/// Under mpirun the program with MPI takes this one's place; it stands beside it. Returns where that fails.
int become_a_rank(char** argv) {
  std::error_code unknown;
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe", unknown).replace_filename("nugget-mpi");
  execv(program.c_str(), argv);
  fmt::print(stderr, "nugget: started by mpirun with several ranks, which need {}: {}\n", program.string(),
             std::strerror(errno));
  return static_cast<int>(nugget::app::ExitCode::wrong_command);
}

}  // namespace

int main(int argc, char** argv) {
  if (nugget::app::started_ranks() > 1) return become_a_rank(argv);
  nugget::app::guard_terminal();
  return nugget::app::code_after_terminal(nugget::app::command_line(argc, argv));
}
