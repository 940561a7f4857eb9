// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/programs/started_ranks.hpp"
#include "app/terminal.hpp"

namespace {

/// Another program that stands beside this one takes its place. Returns, with the path of it, where that fails.
std::string become(const char* name, char** argv) {
  // OpenBLAS makes its threads as it is loaded. We use one (docs/decisions/0016); where memory is short the others
  // would wait for theirs without end, and the program with them when it ends.
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  std::error_code unknown;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unknown).replace_filename(name);
  execv(program.c_str(), argv);
  return program.string();
}

int refuse(const std::string& why) {
  fmt::print(stderr, "nugget: {}\n", why);
  return static_cast<int>(nugget::app::ExitCode::wrong_command);
}

/// What x86-64-v4 has beyond v3. Systems that keep the wide registers only (__builtin_cpu_supports asks for that, too).
bool has_avx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512vl");
}

}  // namespace

int main(int argc, char** argv) {
  std::set_new_handler(nullptr);  // see processor_check.cpp
  const bool several_ranks = nugget::app::started_ranks() > 1;
  // Eight lanes where the processor has them and that program was built; NUGGET_LANES asks for one of the two.
  const char* asked = std::getenv("NUGGET_LANES");
  const std::string_view lanes = asked == nullptr ? "" : asked;
  if (!lanes.empty() && lanes != "4" && lanes != "8")
    return refuse(fmt::format("NUGGET_LANES is '{}', expected 4 (AVX2) or 8 (AVX-512)", lanes));
  if (lanes == "8" || (lanes.empty() && has_avx512())) {
    const std::string program = become(several_ranks ? "nugget-mpi-avx512" : "nugget-avx512", argv);
    if (lanes == "8")
      return refuse(fmt::format(
          "NUGGET_LANES=8 needs {}: {} [./dev build nugget-avx512 makes it; without NUGGET_LANES this one runs]",
          program, std::strerror(errno)));
  }
  if (several_ranks) {
    const std::string program = become("nugget-mpi", argv);
    return refuse(
        fmt::format("started by mpirun with several ranks, which need {}: {}", program, std::strerror(errno)));
  }
  nugget::app::guard_terminal();
  return nugget::app::code_after_terminal(nugget::app::command_line(argc, argv));
}
