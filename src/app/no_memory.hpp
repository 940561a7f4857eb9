// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::app {

/// What a run says that has no memory left; its exit code is 3.
constexpr const char* no_memory =
    "not enough memory for this model [a machine with more of it; --precision single, fewer modes or results need "
    "less]";

}  // namespace nugget::app
