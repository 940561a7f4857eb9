// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/command_text.hpp"

namespace nugget::app {
namespace {

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

/// One word for a shell, whatever is in it.
std::string shell_quoted(const std::string& text) {
  return '\'' + replaced(text, "'", "'\\''") + '\'';
}

/// The function of the bash script that offers values of this kind; choices follow as its arguments.
std::string bash_offer(const OptionText& option) {
  if (!option.choices.empty()) {
    std::string words;
    for (const std::string& choice : option.choices) words += ' ' + shell_quoted(choice);
    return "_nugget_words" + words;
  }
  if (option.value == deck_value) return "_nugget_decks";
  if (option.value == folder_value) return "_nugget_folders";
  if (option.value == file_value) return "_nugget_files";
  return ":";
}

/// `case` branches of one command: values of its options, which options take one, its options, its words by place.
std::string bash_command(const CommandText& command) {
  std::string values, places, names;
  std::vector<std::string> with_value;
  for (const OptionText& option : command.options) {
    names += fmt::format(" {}", fmt::join(option.names, " "));
    if (option.value.empty()) continue;
    with_value.insert(with_value.end(), option.names.begin(), option.names.end());
    values += fmt::format("        {}) {}; return ;;\n", fmt::join(option.names, "|"), bash_offer(option));
  }
  for (std::size_t i = 0; i < command.places.size(); ++i)
    places += fmt::format("        {}) {} ;;\n", command.places[i].many ? "*" : std::to_string(i),
                          bash_offer(command.places[i]));
  // Which word comes next: those before that are neither options nor their values are counted.
  const std::string skip =
      with_value.empty() ? "" : fmt::format("        case $word in {}) skip=1 ;; esac\n", fmt::join(with_value, "|"));
  const std::string count =
      "      for word in \"${before[@]}\"; do\n        [[ $word == -* ]] || ((skip)) || ((++place))\n        skip=0\n" +
      skip + "      done\n";
  return fmt::format("    {})\n", command.name) + "      case $previous in\n" + values + "      esac\n" +
         fmt::format("      if [[ $current == -* ]]; then _nugget_words{}; return; fi\n", names) + count +
         "      case $place in\n" + places + "      esac ;;\n";
}

constexpr std::string_view bash_head = R"sh(# Completion of nugget for bash, written by `nugget --completion bash`.
_nugget_words() {
  local word
  for word in "$@"; do
    [[ $word == "$current"* ]] && COMPREPLY+=("$(printf '%q' "$word")")
  done
}
_nugget_take() { local line; while IFS= read -r line; do COMPREPLY+=("$line"); done; }
_nugget_folders() { compopt -o filenames 2>/dev/null; _nugget_take < <(compgen -d -- "$current"); }
_nugget_files() { compopt -o filenames 2>/dev/null; _nugget_take < <(compgen -f -- "$current"); }
_nugget_decks() {
  local ending
  _nugget_folders
  for ending in k key dyn K KEY DYN; do _nugget_take < <(compgen -f -X "!*.$ending" -- "$current"); done
}
_nugget() {
  local current=${COMP_WORDS[COMP_CWORD]} previous= command= word skip=0 place=0
  local before=() at
  COMPREPLY=()
  # bash cuts words at `=`: --sort=energy, i=model.k
  for ((at = 1; at < COMP_CWORD; ++at)); do
    [[ ${COMP_WORDS[at]} == = ]] || before+=("${COMP_WORDS[at]}")
  done
  [[ $current != = ]] || current=
  ((${#before[@]})) && { previous=${before[-1]} command=${before[0]} before=("${before[@]:1}"); }
  [[ $previous != i ]] || { _nugget_decks; return; }
  case $command in
)sh";

/// A description within the brackets of zsh's _arguments.
std::string zsh_described(const std::string& text) {
  return replaced(replaced(replaced(replaced(text, "\\", "\\\\"), "[", "\\["), "]", "\\]"), ":", "\\:");
}

/// The action of _arguments that offers values of this kind.
std::string zsh_offer(const OptionText& option) {
  if (!option.choices.empty()) {
    std::string words;
    for (const std::string& choice : option.choices) words += (words.empty() ? "" : " ") + replaced(choice, " ", "\\ ");
    return '(' + words + ')';
  }
  if (option.value == deck_value) return "_files -g \"*.(k|key|dyn|K|KEY|DYN)(-.)\"";
  if (option.value == folder_value) return "_files -/";
  if (option.value == file_value) return "_files";
  return " ";
}

std::string zsh_command(const CommandText& command) {
  std::string out = fmt::format("    {})\n      _arguments -s", command.name);
  for (const OptionText& option : command.options) {
    const std::string value = option.value.empty() ? "" : fmt::format(":{}:{}", option.value, zsh_offer(option));
    const std::string all = fmt::format("({})", fmt::join(option.names, " "));
    for (const std::string& name : option.names)
      out += " \\\n        " +
             shell_quoted(fmt::format("{}{}{}[{}]{}", all, name, !value.empty() && name.starts_with("--") ? "=" : "",
                                      zsh_described(option.help), value));
  }
  for (std::size_t i = 0; i < command.places.size(); ++i)
    out += " \\\n        " + shell_quoted(fmt::format("{}:{}:{}", command.places[i].many ? "*" : std::to_string(i + 1),
                                                      command.places[i].place, zsh_offer(command.places[i])));
  return out + " ;;\n";
}

}  // namespace

std::string bash_completion(const std::vector<CommandText>& commands) {
  std::string out(bash_head), names;
  for (const CommandText& command : commands) {
    if (command.name.empty()) continue;
    names += ' ' + command.name;
    out += bash_command(command);
  }
  for (const OptionText& option : commands.front().options) names += fmt::format(" {}", fmt::join(option.names, " "));
  return out + fmt::format("    '') _nugget_words{} ;;\n", names) + "  esac\n}\ncomplete -F _nugget nugget\n";
}

std::string zsh_completion(const std::vector<CommandText>& commands) {
  std::string out =
      "#compdef nugget\n# Completion of nugget for zsh, written by `nugget --completion zsh`.\n_nugget() {\n";
  out += "  if ((CURRENT == 2)); then\n    local -a commands=(\n";
  for (const CommandText& command : commands)
    if (!command.name.empty()) out += "      " + shell_quoted(command.name + ':' + zsh_described(command.help)) + '\n';
  out += "    )\n    _describe command commands\n    _arguments";
  for (const OptionText& option : commands.front().options)
    for (const std::string& name : option.names)
      out += ' ' + shell_quoted(fmt::format("{}[{}]", name, zsh_described(option.help)));
  out += "\n    return\n  fi\n  local command=$words[2]\n  shift words\n  ((CURRENT--))\n  case $command in\n";
  for (const CommandText& command : commands)
    if (!command.name.empty()) out += zsh_command(command);
  return out + "  esac\n}\n_nugget \"$@\"\n";
}

}  // namespace nugget::app
