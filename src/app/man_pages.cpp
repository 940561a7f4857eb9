// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>

#include "app/command_text.hpp"
#include "app/commands.hpp"

namespace nugget::app {
namespace {

struct CodeMeaning {
  ExitCode code;
  const char* meaning;
};

constexpr CodeMeaning code_meanings[] = {
    {ExitCode::normal, "Normal termination."},
    {ExitCode::refused, "The deck is refused: every finding is printed, nothing was run."},
    {ExitCode::wrong_command, "The command line is wrong."},
    {ExitCode::error_termination, "Error termination while running; results up to there are kept and readable."},
    {ExitCode::cannot_write, "A result cannot be written (disk full, no permission)."},
    {ExitCode::interrupted, "Interrupted; a restart file was written."}};

/// Text as troff prints it: no escape, no hyphen for a minus, no request at the start of a line. Lines of at most 78.
std::string troff(std::string_view text) {
  std::string out, word;
  std::size_t width = 0;
  const auto end_word = [&] {
    if (word.empty()) return;
    const bool breaks = width > 0 && width + 1 + word.size() > 78;
    if (width > 0) out += breaks ? '\n' : ' ';
    if (breaks) width = 0;
    if (width == 0 && (word[0] == '.' || word[0] == '\'')) word.insert(0, "\\&");
    out += word;
    width += word.size() + 1;
    word.clear();
  };
  for (const char c : text) {
    if (std::isspace(static_cast<unsigned char>(c)))
      end_word();
    else if (c == '\\')
      word += "\\e";
    else if (c == '-')
      word += "\\-";
    else
      word += c;
  }
  end_word();
  return out;
}

std::string sentence(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return troff(text.empty() || text.back() == '.' ? text : text + '.');
}

std::string page_name(const CommandText& command) {
  return command.name.empty() ? "nugget" : "nugget-" + command.name;
}

std::string value_of(const OptionText& option) {
  return option.value.empty() ? "" : fmt::format(" \\fI{}\\fR", troff(option.value));
}

std::string synopsis(const CommandText& command) {
  if (command.name.empty()) return ".B nugget\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR] ...\n";
  std::string out = fmt::format(".B nugget {}\n[\\fIOPTIONS\\fR]", command.name);
  for (const OptionText& place : command.places)
    out += fmt::format(" {}\\fI{}\\fR{}{}", place.required ? "" : "[", troff(place.place), place.many ? " ..." : "",
                       place.required ? "" : "]");
  return out + '\n';
}

std::string entry(const OptionText& option) {
  std::string head;
  for (const std::string& name : option.names)
    head += fmt::format("{}\\fB{}\\fR", head.empty() ? "" : ", ", troff(name));
  if (option.names.empty()) head = fmt::format("\\fI{}\\fR", troff(option.place));
  std::string out =
      fmt::format(".TP\n{}{}\n{}\n", head, option.names.empty() ? "" : value_of(option), sentence(option.help));
  if (!option.choices.empty())
    out += fmt::format("One of: {}.\n", troff(fmt::format("{}", fmt::join(option.choices, "; "))));
  return out;
}

std::string see_also(const CommandText& command, const std::vector<CommandText>& all) {
  std::string out;
  for (const CommandText& other : all)
    if (other.name != command.name && (command.name.empty() || other.name.empty()))
      out += fmt::format("{}.BR {} (1)", out.empty() ? "" : ",\n", troff(page_name(other)));
  return out + '\n';
}

}  // namespace

std::string man_page(const CommandText& command, const std::vector<CommandText>& all, const std::string& date) {
  std::string title = page_name(command);
  for (char& c : title) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const bool whole = command.name.empty();
  std::string out = fmt::format(".\\\" Written by nugget \\-\\-man.\n.TH {} 1 {} \"nugget {}\" \"User Commands\"\n",
                                troff(title), date, NUGGET_VERSION);
  out += fmt::format(".SH NAME\n{} \\- {}\n", troff(page_name(command)),
                     troff(whole ? "spot-welded structures from one LS-DYNA keyword deck" : command.help));
  out += ".SH SYNOPSIS\n" + synopsis(command);
  out += ".SH DESCRIPTION\n" + sentence(command.help) + '\n';
  if (whole) {
    out += ".SH COMMANDS\n";
    for (const CommandText& other : all)
      if (!other.name.empty())
        out += fmt::format(".TP\n.BR {} (1)\n{}\n", troff(page_name(other)), sentence(other.help));
  }
  if (!command.places.empty()) {
    out += ".SH ARGUMENTS\n";
    for (const OptionText& place : command.places) out += entry(place);
  }
  out += ".SH OPTIONS\n";
  for (const OptionText& option : command.options) out += entry(option);
  out += ".SH EXIT STATUS\n";
  for (const CodeMeaning& code : code_meanings)
    out += fmt::format(".TP\n.B {}\n{}\n", static_cast<int>(code.code), troff(code.meaning));
  return out + ".SH SEE ALSO\n" + see_also(command, all);
}

}  // namespace nugget::app
