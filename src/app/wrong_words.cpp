// SPDX-License-Identifier: Apache-2.0
#include "app/wrong_words.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "app/command_text.hpp"
#include "base/spelling.hpp"

namespace nugget::app {
namespace {

/// Of the words of a program the one that is meant by `written`: by a slip or two, or of which that is a part.
class Meant {
 public:
  explicit Meant(std::string_view written)
      : written_(written),
        nearest_(written.size() < 4   ? 1
                 : written.size() < 8 ? 2
                                      : 3) {}
  void consider(const std::string& known) {
    if (const std::size_t apart = letters_apart(written_, known); apart < nearest_) {
      nearest_ = apart;
      best_ = known;
    } else if (part_.empty() && bare(written_).size() > 2 && known.find(bare(written_)) != std::string::npos) {
      part_ = known;
    }
  }
  /// In words; empty: none.
  std::string asked() const {
    const std::string& meant = best_.empty() ? part_ : best_;
    return meant.empty() ? std::string{} : fmt::format("; is it {}?", meant);
  }

 private:
  static std::string_view bare(std::string_view word) {
    return word.substr(std::min(word.find_first_not_of('-'), word.size()));
  }

  std::string_view written_;
  std::size_t nearest_;  ///< no word that is so far away or farther is meant
  std::string best_, part_;
};

/// The command that was read last, and its name as one writes it.
struct Reached {
  const CLI::App* command;
  std::string name;
};
Reached reached(const CLI::App& cli) {
  const std::vector<CLI::App*> parsed = cli.get_subcommands();
  if (parsed.empty()) return {&cli, cli.get_name()};
  return {parsed.back(), fmt::format("{} {}", cli.get_name(), parsed.back()->get_name())};
}

std::string unknown_option(const CLI::App& cli, const Reached& at, const std::string& option) {
  Meant meant(option);
  const std::string name = at.command == &cli ? std::string{} : at.command->get_name();
  for (const CommandText& command : command_texts(cli))
    if (command.name == name)
      for (const OptionText& known : command.options)
        for (const std::string& one : known.names) meant.consider(one);
  return fmt::format("there is no option '{}'{}", option, meant.asked());
}

}  // namespace

std::string unknown_command(const CLI::App& cli, const std::vector<std::string>& words) {
  if (words.empty() || words.front().starts_with('-')) return {};
  Meant meant(words.front());
  for (const CLI::App* command : cli.get_subcommands({})) {
    if (command->get_name() == words.front()) return {};
    meant.consider(command->get_name());
  }
  return fmt::format(
      "nugget: there is no command '{}'{}\nTo run a deck: nugget run MODEL.k; for all commands: nugget --help\n",
      words.front(), meant.asked());
}

std::string wrong_words(const CLI::App& cli, const CLI::ParseError& error) {
  const Reached at = reached(cli);
  // What is missing may be missing because of a word that was not understood.
  const auto code = static_cast<CLI::ExitCodes>(error.get_exit_code());
  const bool unexpected = code == CLI::ExitCodes::ExtrasError || code == CLI::ExitCodes::RequiredError;
  const std::vector<std::string> words = unexpected ? at.command->remaining() : std::vector<std::string>{};
  const auto is_option = [](const std::string& word) { return word.starts_with('-'); };
  const auto option = std::ranges::find_if(words, is_option);
  const std::string why = option != words.end() ? unknown_option(cli, at, option->substr(0, option->find('=')))
                          : !words.empty()      ? fmt::format("'{}' is one word too many", words.front())
                                                : std::string(error.what());
  return fmt::format("{}: {}\nAll that it takes: {} --help\n", at.name, why, at.name);
}

}  // namespace nugget::app
