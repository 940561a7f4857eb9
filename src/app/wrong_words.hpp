// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace nugget::app {

/// Why the first of `words` is no command, with the one that may be meant; empty where it is one.
std::string unknown_command(const CLI::App& cli, const std::vector<std::string>& words);
/// Why the words of a command could not be read: which option it does not have, with the one that may be meant; which
/// word is one too many; or what CLI11 says.
std::string wrong_words(const CLI::App& cli, const CLI::ParseError& error);

}  // namespace nugget::app
