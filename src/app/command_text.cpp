// SPDX-License-Identifier: Apache-2.0
#include "app/command_text.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <ctime>

#include "app/command.hpp"
#include "app/commands.hpp"
#include "output/result_file.hpp"

namespace nugget::app {
namespace {

/// Kind of the values of an option or place; with a command it holds for that one only, and stands before the general
/// one.
struct ValueName {
  std::string_view command, name, value;
};

constexpr ValueName value_names[] = {
    {"tidy", "--output", deck_value}, {"weld", "--output", deck_value},    {"fit", "--output", deck_value},
    {"plot", "--output", file_value}, {"picture", "--output", file_value}, {"", "--output", folder_value},
    {"", "--resume", folder_value},   {"", "--compare", folder_value},     {"", "--with", folder_value},
    {"", "--weld-law", file_value},   {"", "model", deck_value},           {"", "card", deck_value},
    {"", "points", file_value},       {"", "curves", file_value},          {"", "directory", folder_value},
    {"", "other", folder_value},      {"", "folder", folder_value}};

std::string last_name(const CLI::Option& option) {
  if (!option.get_lnames().empty()) return "--" + option.get_lnames().front();
  return option.get_name(true);
}

/// The values of CLI::IsMember, which shows them as `TEXT:{a,b}`. A value may hold ", " (of `mm, t, s`).
std::vector<std::string> choices(const std::string& type) {
  const std::size_t open = type.find('{'), close = type.rfind('}');
  std::vector<std::string> found;
  if (open == std::string::npos || close == std::string::npos) return found;
  found.emplace_back();
  for (std::size_t i = open + 1; i < close; ++i) {
    if (type[i] == ',' && type[i + 1] != ' ')
      found.emplace_back();
    else
      found.back() += type[i];
  }
  return found;
}

OptionText text_of(const CLI::Option& option) {
  OptionText text;
  for (const std::string& name : option.get_snames()) text.names.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  if (option.get_positional()) text.place = option.get_name(true);
  const std::string type = option.get_type_name();
  if (option.get_items_expected_max() > 0) {
    text.value = type.substr(0, type.find(':'));
    text.choices = choices(type);
  }
  text.help = option.get_description();
  text.required = option.get_required();
  text.many = option.get_items_expected_max() > 1;
  return text;
}

CommandText text_of(const CLI::App& command, std::string name) {
  CommandText text{std::move(name), command.get_description(), {}, {}};
  for (const CLI::Option* option : command.get_options())
    if (!option->get_group().empty())
      (option->get_positional() ? text.places : text.options).push_back(text_of(*option));
  return text;
}

/// Of the build where the environment gives one (reproducible packages), otherwise today's.
std::string date_of_pages() {
  const char* given = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t seconds = given != nullptr ? std::atol(given) : std::time(nullptr);
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(seconds));
}

ExitCode write_man_pages(const std::vector<CommandText>& commands, const std::string& folder) {
  return guarded(folder, [&](const std::filesystem::path& directory) {
    for (const CommandText& command : commands) {
      const std::string name = command.name.empty() ? "nugget.1" : fmt::format("nugget-{}.1", command.name);
      output::write_whole_file(directory / name, man_page(command, commands, date_of_pages()));
    }
    return ExitCode::normal;
  });
}

}  // namespace

void name_values(CLI::App& cli) {
  for (CLI::App* command : cli.get_subcommands([](CLI::App*) { return true; }))
    for (CLI::Option* option : command->get_options()) {
      const std::string name = last_name(*option);
      for (const ValueName& known : value_names) {
        if (known.name != name || !(known.command.empty() || known.command == command->get_name())) continue;
        option->type_name(std::string(known.value));
        break;
      }
    }
}

std::vector<CommandText> command_texts(const CLI::App& cli) {
  std::vector<CommandText> texts{text_of(cli, "")};
  for (const CLI::App* command : cli.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); }))
    texts.push_back(text_of(*command, command->get_name()));
  return texts;
}

std::optional<int> write_descriptions(const CLI::App& cli, const std::vector<std::string>& words) {
  if (words.size() != 2) return {};
  if (words[0] == "--man") return static_cast<int>(write_man_pages(command_texts(cli), words[1]));
  if (words[0] != "--completion") return {};
  if (words[1] == "bash") {
    fmt::print("{}", bash_completion(command_texts(cli)));
  } else if (words[1] == "zsh") {
    fmt::print("{}", zsh_completion(command_texts(cli)));
  } else {
    fmt::print(stderr, "nugget: --completion knows bash and zsh, not '{}'\n", words[1]);
    return static_cast<int>(ExitCode::wrong_command);
  }
  return static_cast<int>(ExitCode::normal);
}

}  // namespace nugget::app
