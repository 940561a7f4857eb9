// SPDX-License-Identifier: Apache-2.0
#include "reading/describe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>
#include <vector>

#include "base/spelling.hpp"
#include "reading/builder/builder.hpp"

namespace nugget::reading {

std::string text_of(const Dimension& dimension) {
  std::string text;
  const auto add = [&](char symbol, int exponent) {
    if (exponent == 0) return;
    if (!text.empty()) text += ' ';
    text += symbol;
    if (exponent != 1) text += fmt::format("^{}", exponent);
  };
  add('M', dimension.mass);
  add('L', dimension.length);
  add('T', dimension.time);
  return text.empty() ? "-" : text;
}

namespace {

std::string_view word(KeywordStatus status) {
  switch (status) {
    case KeywordStatus::used: return "used";
    case KeywordStatus::ignored: return "ignored";
    case KeywordStatus::refused: break;
  }
  return "refused";
}

std::string kind_of(const Field& field) {
  if (field.kind == Kind::text) return "text";
  if (field.id != IdSpace::none) return "id";
  return field.kind == Kind::integer ? "integer" : "real";
}

std::string default_of(const Field& field) {
  if (field.kind == Kind::text) return "";
  return std::isnan(field.fallback) ? "required" : fmt::format("{}", field.fallback);
}

std::string range_of(const Field& field) {
  const auto [low, high] = field.range;
  if (field.kind == Kind::text || (std::isinf(low) && std::isinf(high))) return "any";
  if (low == high) return fmt::format("only {}", low);
  if (low == std::numeric_limits<double>::min()) return std::isinf(high) ? "> 0" : fmt::format("> 0, <= {}", high);
  if (std::isinf(high)) return fmt::format(">= {}", low);
  if (std::isinf(low)) return fmt::format("<= {}", high);
  return fmt::format("{} to {}", low, high);
}

std::string card_table(const Card& card) {
  std::string text;
  int column = 1;
  for (const Field& field : card.fields) {
    const int last = column + field.width - 1;
    if (!field.name.empty())
      text += fmt::format("  {:>3}-{:<3} {:<9} {:<8} {:<9} {:<12} {:<11} {}\n", column, last, field.name,
                          kind_of(field), default_of(field), range_of(field), text_of(field.dimension), field.meaning);
    column = last + 1;
  }
  return text;
}

std::string joined(const std::vector<std::string_view>& words, std::string_view before = {}) {
  std::string text;
  for (const auto each : words) text += fmt::format("{}{}{}", text.empty() ? "" : ", ", before, each);
  return text;
}

std::string upper(std::string_view name) {
  if (name.starts_with('*')) name.remove_prefix(1);
  std::string text(name);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string describe(const Keyword& keyword) {
  std::string text = fmt::format("*{}: {}\n", keyword.name, word(keyword.status));
  if (!keyword.why.empty()) text += fmt::format("{}\n", keyword.why);
  if (!keyword.aliases.empty()) text += fmt::format("also written: {}\n", joined(keyword.aliases, "*"));
  if (keyword.status == KeywordStatus::used && !keyword.options.empty())
    text += fmt::format("options: {}\n", joined(keyword.options, "_"));
  int number = 0;
  for (const LayoutCard& card : keyword.layout) {
    const std::string when = card.when.empty() ? "" : fmt::format(" ({})", card.when);
    text += fmt::format("\ncard {}{}\n  columns field     kind     default   allowed      dimension   meaning\n",
                        ++number, when);
    text += card_table(*card.card);
  }
  return text;
}

std::string list_of_used(const std::function<bool(std::string_view)>& asked_for) {
  std::string text;
  for (const Keyword& keyword : keywords())
    if (keyword.status == KeywordStatus::used && asked_for(keyword.name)) text += fmt::format("  *{}\n", keyword.name);
  return text.empty() ? text : "used are\n" + text;
}

/// The used keywords that begin with what was asked for, one a line; for a name that stands for a family.
std::string family(std::string_view beginning) {
  return list_of_used([=](std::string_view name) { return name.starts_with(beginning); });
}

/// Those that have it anywhere.
std::string namesakes(std::string_view part) {
  constexpr std::size_t shortest = 3;
  if (part.size() < shortest) return {};
  return list_of_used([=](std::string_view name) { return name.find(part) != std::string_view::npos; });
}

}  // namespace

std::string describe_keywords() {
  std::vector<const Keyword*> rows;
  for (const Keyword& keyword : keywords()) rows.push_back(&keyword);
  std::sort(rows.begin(), rows.end(), [](const Keyword* a, const Keyword* b) { return a->name < b->name; });
  std::string text = fmt::format("{:<44} {:<8} {:<34} {}\n", "keyword", "verdict", "options", "note");
  for (const Keyword* row : rows) {
    std::string note(row->why);
    if (!row->aliases.empty())
      note = fmt::format("also {}{}{}", joined(row->aliases, "*"), note.empty() ? "" : "; ", note);
    text += fmt::format("*{:<43} {:<8} {:<34} {}\n", row->name, word(row->status),
                        row->status == KeywordStatus::used ? joined(row->options, "_") : "", note);
  }
  return text;
}

std::string describe_keyword(std::string_view name) {
  const std::string written = upper(name);
  Options options;
  const Keyword* keyword = find_keyword(written, options);
  if (keyword && !keyword->name.ends_with('*')) return describe(*keyword);
  if (const std::string members = family(written); !members.empty()) return fmt::format("*{}...: {}", written, members);
  if (const std::string members = namesakes(written); !keyword && !members.empty())
    return fmt::format("*...{}...: {}", written, members);
  const std::string similar = similar_keyword(written);
  if (keyword) return describe(*keyword) + (similar.empty() ? "" : fmt::format("is it *{}?\n", similar));
  return fmt::format("*{}: not a keyword that this program knows{}\n", written,
                     similar.empty() ? "" : fmt::format("; is it *{}?", similar));
}

std::string built_of_family(std::string_view beginning) {
  constexpr std::size_t few = 12;
  const std::string_view base = beginning.substr(0, beginning.size() - 1);  // without its last _
  std::vector<std::string> built;
  for (const Keyword& keyword : keywords()) {
    if (keyword.status != KeywordStatus::used) continue;
    if (keyword.name.starts_with(beginning)) built.emplace_back(keyword.name);
    if (keyword.name != base) continue;
    for (const std::string_view option : keyword.options)
      if (option != "TITLE" && option != "ID") built.push_back(fmt::format("{}{}", beginning, option));
  }
  if (built.empty()) return {};
  if (built.size() > few) return fmt::format("`nugget keywords {}` lists what is built", beginning);
  std::sort(built.begin(), built.end());
  std::string text = fmt::format("*{}", built.front());
  for (std::size_t i = 1; i < built.size(); ++i)
    text += fmt::format("{}_{}", i + 1 < built.size() ? ", " : " and ", built[i].substr(beginning.size()));
  return fmt::format("built {} {}", built.size() == 1 ? "is" : "are", text);
}

std::string keyword_use_table(const Model& model) {
  std::size_t width = 8;
  for (const KeywordUse& entry : model.keyword_uses) width = std::max(width, entry.keyword.size() + 1);
  std::string text =
      fmt::format("{:<{}} {:>7} {:<8} {}\n", "keyword", width, "times", "verdict", "why, and where first");
  for (const KeywordUse& entry : model.keyword_uses) {
    const std::string where = fmt::format("{}:{}", entry.first.file, entry.first.line);
    const std::string note = entry.status == KeywordStatus::used ? "" : fmt::format("{} ({})", entry.why, where);
    std::string line =
        fmt::format("*{:<{}} {:>7} {:<8} {}", entry.keyword, width - 1, entry.count, word(entry.status), note);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string similar_keyword(std::string_view written) {
  const std::string whole = upper(written);
  std::string_view name = whole;
  std::vector<std::string_view> options;
  for (const std::string_view option : {"_TITLE", "_ID", "_MPP"})
    if (name.ends_with(option)) {
      name.remove_suffix(option.size());
      options.push_back(option);
    }
  // One slip in a short name, two in a long one; numbers of laws (MAT_123) are too short to be guessed at.
  const std::size_t allowed = name.size() < 8 ? 0 : name.size() < 16 ? 1 : 2;
  std::string best;
  std::size_t nearest = allowed + 1;
  const auto consider = [&](const std::string& known, const Keyword& row) {
    const std::size_t difference = known.size() > name.size() ? known.size() - name.size() : name.size() - known.size();
    if (difference > allowed) return;
    if (const std::size_t d = letters_apart(name, known); d > 0 && d < nearest) {
      nearest = d;
      best = known;
      for (auto option = options.rbegin(); option != options.rend(); ++option)
        if (std::ranges::find(row.options, option->substr(1)) != row.options.end()) best += *option;
    }
  };
  const auto consider_forms = [&](std::string_view known, const Keyword& row) {
    if (known.ends_with('*')) return;
    consider(std::string(known), row);
    for (const auto first : row.options) {
      consider(fmt::format("{}_{}", known, first), row);
      for (const auto second : row.options)
        if (second != first) consider(fmt::format("{}_{}_{}", known, first, second), row);
    }
  };
  for (const Keyword& keyword : keywords()) {
    if (keyword.status == KeywordStatus::refused) continue;
    consider_forms(keyword.name, keyword);
    for (const auto alias : keyword.aliases) consider_forms(alias, keyword);
  }
  return best;
}

}  // namespace nugget::reading
