// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

// The commands and options of the program as plain text, out of the tree that `--help` prints: shells complete by it
// and the manual pages are written from it, so that neither can know another option than the program has.
namespace nugget::app {

/// What stands for a value in help. Shells offer files by it.
inline constexpr std::string_view deck_value = "DECK", folder_value = "FOLDER", file_value = "FILE";

/// An option, or a word that is known by its place (`names` is empty then).
struct OptionText {
  std::vector<std::string> names;    ///< with their dashes, the short ones first
  std::string place;                 ///< name of a word known by its place
  std::string value;                 ///< kind of its value: one of the above, or `TEXT`, `INT`...; empty: a flag
  std::vector<std::string> choices;  ///< its values, where only these are allowed
  std::string help;
  bool required = false;
  bool many = false;  ///< takes several values: the last of the places
};

struct CommandText {
  std::string name;  ///< empty: `nugget` itself
  std::string help;
  std::vector<OptionText> options, places;
};

/// Says in help which values are decks, folders and files. To be called when all commands are there.
void name_values(CLI::App& cli);

/// `nugget` itself first, then its commands in the order of help.
std::vector<CommandText> command_texts(const CLI::App& cli);

/// Script for the shell `bash` or `zsh` that completes commands, options, choices, decks and folders.
std::string bash_completion(const std::vector<CommandText>& commands);
std::string zsh_completion(const std::vector<CommandText>& commands);

/// The manual page of a command in man(7) macros. `date`: of the page, YYYY-MM-DD.
std::string man_page(const CommandText& command, const std::vector<CommandText>& all, const std::string& date);

/// `nugget --completion SHELL` prints a script, `nugget --man FOLDER` writes nugget.1 and nugget-COMMAND.1; the exit
/// code, or nothing where `words` ask for neither. They are for those who install the program, and not shown in help.
std::optional<int> write_descriptions(const CLI::App& cli, const std::vector<std::string>& words);

}  // namespace nugget::app
