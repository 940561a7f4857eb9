// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "app/command.hpp"
#include "deck/tidied_text.hpp"
#include "output/result_file.hpp"
#include "reading/build.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view remark_of_tidy = "$ nugget tidy: values between commas, names of fields above them.\n";

/// The file of the deck that one of those to be written would replace; empty: none.
std::string overwritten(const deck::Deck& deck, const std::vector<deck::EditedText::File>& files) {
  std::error_code none;
  for (const auto& file : files)
    for (const std::string& input : deck.files)
      if (fs::equivalent(file.path, input, none)) return input;
  return {};
}

ExitCode write_tidied(const TidyArguments& arguments) {
  Findings findings;
  deck::Deck deck = deck::read(arguments.deck, findings, arguments.load_case);
  if (deck.bytes == 0) return refuse_missing(findings);
  deck::TidiedText tidied(deck);
  deck.card_read = [&](const deck::Block& block, std::size_t line, const Card& card) { tidied.add(block, line, card); };
  deck.reports_bulk_lines = true;
  reading::build(deck, findings);
  deck.card_read = {};
  tidied.write(findings);
  const bool is_marked = tidied.text().text_of(0).find(remark_of_tidy) != std::string_view::npos;
  const std::vector<deck::EditedText::File> files =
      tidied.text().files(arguments.output, is_marked ? std::string_view() : remark_of_tidy);
  if (const std::string input = overwritten(deck, files); !input.empty()) {
    fmt::print(stderr, "nugget: {} would be overwritten; give another name after -o\n", input);
    return ExitCode::wrong_command;
  }
  for (const auto& file : files) output::write_whole_file(file.path, file.text);
  print_findings(findings);
  for (const auto& file : files) fmt::print("{}\n", file.path.string());
  fmt::print("{} lines in comma form, {} as they were\n", tidied.tidied(), tidied.kept());
  return findings.errors() > 0 ? ExitCode::refused : ExitCode::normal;
}

}  // namespace

ExitCode tidy(const TidyArguments& arguments) {
  const fs::path folder = fs::path(arguments.output).parent_path();
  return guarded(folder.empty() ? "." : folder.string(), [&](const fs::path&) { return write_tidied(arguments); });
}

}  // namespace nugget::app
