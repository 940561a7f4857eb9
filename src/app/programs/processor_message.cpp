// SPDX-License-Identifier: Apache-2.0
#include "app/programs/processor_message.hpp"

#include <cpuid.h>

#include "app/programs/processor_features.hpp"

namespace nugget::app {
namespace {

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

}  // namespace

void tell_what_is_lacking(void (*say)(const char* text)) {
  bool lacks = false;
  for (const ProcessorFeature* f = needed_features; f->name != nullptr; ++f) {
    if (has(*f)) continue;
    say(lacks ? ", " : "nugget: this processor, or the machine that shows it to us, lacks ");
    say(f->name);
    lacks = true;
  }
  if (lacks)
    say("; the program is compiled for " NUGGET_ARCH
        ". Take a newer processor (x86-64-v3: Intel since 2013, AMD since 2015; a virtual machine must pass it on), or "
        "compile for this one: cmake --preset release -DNUGGET_ARCH=x86-64 && cmake --build build\n");
}

}  // namespace nugget::app
