// SPDX-License-Identifier: Apache-2.0
#pragma once

// Compiled for any x86-64 processor, like the check that uses it: no header of the rest, no library.
namespace nugget::app {

/// Hands to `say`, piece by piece, what this processor lacks and what to do; nothing where it lacks nothing.
void tell_what_is_lacking(void (*say)(const char* text));

}  // namespace nugget::app
