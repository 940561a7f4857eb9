// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::app {

/// Exit codes of the program; users and tools rely on them.
enum class ExitCode {
  normal = 0,
  refused = 1,
  wrong_command = 2,
  error_termination = 3,
  cannot_write = 4,
  interrupted = 130
};

}  // namespace nugget::app
