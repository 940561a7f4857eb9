// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <new>

#include "app/no_memory.hpp"
#include "app/programs/processor_message.hpp"

// Ends the program with a message on a processor that lacks what it is compiled for, before the first instruction of
// that kind. CMakeLists.txt compiles this file for any x86-64 processor. main() would be too late: constructors of
// static objects run before it and are compiled like all else. Functions of .preinit_array run before all constructors,
// those of shared libraries included (System V ABI, "Initialization and Termination Functions"). Likewise where there
// is no memory for what these constructors make, whose exception nobody could catch; main() takes that back.
namespace {

bool said = false;

void say(const char* text) {
  unsigned long length = 0;
  while (text[length] != '\0') ++length;
  [[maybe_unused]] const long written = write(STDERR_FILENO, text, length);
  said = true;
}

void end_without_memory() {
  say("nugget: ");
  say(nugget::app::no_memory);
  say("\n");
  _exit(3);
}

void check_processor() {
  nugget::app::tell_what_is_lacking(say);
  if (said) _exit(2);
  std::set_new_handler(end_without_memory);
}

[[gnu::section(".preinit_array"), gnu::used]] void (*const before_constructors)() = check_processor;

}  // namespace
