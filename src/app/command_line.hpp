// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::app {

/// Does what the command line asks for; the exit code of the program.
int command_line(int argc, char** argv);

}  // namespace nugget::app
