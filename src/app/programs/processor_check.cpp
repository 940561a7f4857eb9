// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include "app/programs/processor_message.hpp"

// Ends the program with a message on a processor that lacks what it is compiled for, before the first instruction of
// that kind. CMakeLists.txt compiles this file for any x86-64 processor. main() would be too late: constructors of
// static objects run before it and are compiled like all else. Functions of .preinit_array run before all constructors,
// those of shared libraries included (System V ABI, "Initialization and Termination Functions").
namespace {

bool said = false;

void say(const char* text) {
  unsigned long length = 0;
  while (text[length] != '\0') ++length;
  [[maybe_unused]] const long written = write(STDERR_FILENO, text, length);
  said = true;
}

void check_processor() {
  nugget::app::tell_what_is_lacking(say);
  if (said) _exit(2);
}

[[gnu::section(".preinit_array"), gnu::used]] void (*const before_constructors)() = check_processor;

}  // namespace
