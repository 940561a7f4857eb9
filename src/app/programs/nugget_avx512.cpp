// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <new>
#include <system_error>

#include "app/command_line.hpp"
#include "app/terminal.hpp"
#include "output/restart_file.hpp"

// `nugget-avx512`: the same program, whose kernels take eight elements at a time. `nugget` beside it gives it its place
// on processors that can (docs/decisions/0094).
int main(int argc, char** argv) {
  std::set_new_handler(nullptr);  // see processor_check.cpp
  // Both read each other's restart files, which hold no lanes: they go by the build, and that is known by `nugget`.
  std::error_code unknown;
  nugget::output::take_for_program(std::filesystem::read_symlink("/proc/self/exe", unknown).replace_filename("nugget"));
  nugget::app::guard_terminal();
  return nugget::app::code_after_terminal(nugget::app::command_line(argc, argv));
}
