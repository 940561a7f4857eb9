// SPDX-License-Identifier: Apache-2.0
#pragma once

// Standard output and standard error of a program that must not end because nobody can read them: a closed or full one
// takes nothing more, and is told of at the end.
namespace nugget::app {

/// Takes the place of stdout and stderr; a broken pipe and a file beyond `ulimit -f` are errors of writing then, not
/// signals that end the program.
void guard_terminal();

/// The exit code of the program, which was to be `code`: 4 where it ended well but something could not be written to a
/// terminal or its file, with a word to the other one. A reader that closed its pipe (`| head`) has what it wanted.
int code_after_terminal(int code);

}  // namespace nugget::app
