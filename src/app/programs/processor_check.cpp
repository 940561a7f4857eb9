// SPDX-License-Identifier: Apache-2.0
#include <cpuid.h>
#include <unistd.h>

#include "app/programs/processor_features.hpp"

// Ends the program with a message on a processor that lacks what it is compiled for, before the first instruction of
// that kind. CMakeLists.txt compiles this file for any x86-64 processor. main() would be too late: constructors of
// static objects run before it and are compiled like all else. Functions of .preinit_array run before all constructors,
// those of shared libraries included (System V ABI, "Initialization and Termination Functions").
namespace {

using nugget::app::ProcessorFeature;

/// Which registers the operating system keeps: XCR0. XGETBV exists where OSXSAVE is set.
unsigned kept_registers() {
  unsigned a = 0, b = 0, c = 0, d = 0;
  if (!__get_cpuid(1, &a, &b, &c, &d) || (c & bit_OSXSAVE) == 0) return 0;
  unsigned low = 0, high = 0;
  __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  return low;
}

bool has(const ProcessorFeature& feature) {
  unsigned words[4] = {};
  if (!__get_cpuid_count(feature.leaf, 0, &words[0], &words[1], &words[2], &words[3])) return false;
  return (words[feature.word] >> feature.bit & 1u) != 0 && (kept_registers() & feature.kept) == feature.kept;
}

void say(const char* text) {
  unsigned long length = 0;
  while (text[length] != '\0') ++length;
  [[maybe_unused]] const long written = write(STDERR_FILENO, text, length);
}

void check_processor() {
  bool lacks = false;
  for (const ProcessorFeature* f = nugget::app::needed_features; f->name != nullptr; ++f) {
    if (has(*f)) continue;
    say(lacks ? ", " : "nugget: this processor, or the machine that shows it to us, lacks ");
    say(f->name);
    lacks = true;
  }
  if (!lacks) return;
  say("; the program is compiled for " NUGGET_ARCH
      ". Take a newer processor (x86-64-v3: Intel since 2013, AMD since 2015; a virtual machine must pass it on), or "
      "compile for this one: cmake --preset release -DNUGGET_ARCH=x86-64 && cmake --build build\n");
  _exit(2);
}

[[gnu::section(".preinit_array"), gnu::used]] void (*const before_constructors)() = check_processor;

}  // namespace
