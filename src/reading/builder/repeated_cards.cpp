// SPDX-License-Identifier: Apache-2.0
#include "reading/builder/repeated_cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "deck/text.hpp"

namespace nugget::reading {
namespace {

/// Of which a second one replaces the first.
bool replaces(std::string_view keyword) {
  static constexpr std::array<std::string_view, 4> lists{"DATABASE_HISTORY", "DATABASE_CROSS_SECTION",
                                                         "DATABASE_NODAL_FORCE", "DATABASE_FREQUENCY"};
  const auto begins = [&](std::string_view list) { return keyword.starts_with(list); };
  return keyword.starts_with("CONTROL_") || (keyword.starts_with("DATABASE_") && std::ranges::none_of(lists, begins));
}

/// Of which the same twice acts twice.
bool adds_up(std::string_view keyword) {
  static constexpr std::array<std::string_view, 8> families{
      "LOAD_", "ELEMENT_MASS", "ELEMENT_INERTIA", "DAMPING_", "CONTACT_", "RIGIDWALL_", "AIRBAG_", "CONSTRAINED_"};
  return std::ranges::any_of(families, [&](std::string_view family) { return keyword.starts_with(family); });
}

bool has_parameters(const deck::Block& block) {
  return std::ranges::any_of(block.lines,
                             [](const deck::Line& line) { return line.text.find('&') != std::string_view::npos; });
}

bool same_lines(const deck::Block& one, const deck::Block& other) {
  return std::ranges::equal(
      one.lines, other.lines, {}, [](const deck::Line& l) { return deck::trimmed(l.text); },
      [](const deck::Line& l) { return deck::trimmed(l.text); });
}

std::string line_of(const Place& place) {
  return fmt::format("{}:{}", place.file, place.line);
}

/// FNV-1a, 64 bits.
std::uint64_t mixed(std::uint64_t hash, std::string_view text) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return (hash ^ 0xffU) * 0x100000001b3U;
}

}  // namespace

void RepeatedCards::look_at(const deck::Block& block, const Keyword& row, Findings& findings) {
  if (replaces(block.keyword)) warn_of_second(block, findings);
  if (adds_up(block.keyword)) warn_of_same(block, row, findings);
}

void RepeatedCards::warn_of_second(const deck::Block& block, Findings& findings) {
  const auto [last, is_first] = last_.try_emplace(block.keyword, &block);
  if (is_first) return;
  if (!same_lines(*last->second, block) || has_parameters(block))
    findings.warning(block.place, block.starred(),
                     fmt::format("stands a second time, with other lines; first at {}: this one is obeyed",
                                 line_of(last->second->place)),
                     "leave the one that is meant");
  last->second = &block;
}

void RepeatedCards::warn_of_same(const deck::Block& block, const Keyword& row, Findings& findings) {
  if (has_parameters(block)) return;
  const auto transform = reinterpret_cast<std::uintptr_t>(block.transform);
  const std::uint64_t start = mixed(mixed(0xcbf29ce484222325U, block.keyword), fmt::format("{}", transform));
  const auto is_new = [&](std::uint64_t hash, const Place& place, std::string_view what) {
    const auto [first, is_first] = first_.try_emplace(hash, place);
    if (!is_first)
      findings.warning(place, block.starred(),
                       fmt::format("{} again as at {}: both count", what, line_of(first->second)),
                       "take one of them out, or add them up in one");
    return is_first;
  };
  if (row.layout.size() > 1) {
    std::uint64_t hash = start;
    for (const deck::Line& line : block.lines) hash = mixed(hash, deck::trimmed(line.text));
    is_new(hash, block.place, "stands with the same lines");
    return;
  }
  for (const deck::Line& line : block.lines)  // each is a card of its own
    if (const std::string_view text = deck::trimmed(line.text);
        !text.empty() && !is_new(mixed(start, text), {block.place.file, line.number, 1}, "this line stands"))
      return;  // of many the first
}

void warn_of_nothing(const deck::Block& block, const Keyword& row, Findings& findings) {
  if (row.layout.empty() || !block.bulk.empty()) return;
  // Programs write the heads of empty lists; what refers to nodes and elements says if some lack.
  if (block.keyword == "NODE" || block.keyword.starts_with("ELEMENT_")) return;
  const auto is_blank = [](const deck::Line& line) { return deck::trimmed(line.text).empty(); };
  // A blank line is a card of defaults where there is one card; in a list it is nothing.
  const bool defaults = block.keyword.starts_with("CONTROL_") || block.keyword.starts_with("DATABASE_");
  if (defaults ? !block.lines.empty() : !std::ranges::all_of(block.lines, is_blank)) return;
  findings.warning(block.place, block.starred(), "no line follows it: it says nothing",
                   "give its cards, or take it out");
}

}  // namespace nugget::reading
