// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a processor must have for this program, taken from what the compiler was told to use (-march). Macros and plain
// data only: the check of it is compiled for any x86-64 processor and must not share an inline function with the rest.
namespace nugget::app {

/// A feature as CPUID shows it: bit `bit` of register `word` (0 eax, 1 ebx, 2 ecx, 3 edx) of a leaf (subleaf 0).
struct ProcessorFeature {
  const char* name;
  unsigned leaf, word, bit;
  unsigned kept;  ///< bits of XCR0: registers that the operating system must keep for it
};

/// Ends with a feature without a name.
extern const ProcessorFeature needed_features[];

}  // namespace nugget::app
