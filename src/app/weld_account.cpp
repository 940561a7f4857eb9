// SPDX-License-Identifier: Apache-2.0
#include "app/weld_account.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "app/audit_table.hpp"
#include "base/index.hpp"
#include "weld/tie/presumed.hpp"
#include "weld/tie/tie_findings.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::app {
namespace {

/// The first few of a list: `7, 5000033 and 97 more`.
template <class Items>
std::string first_of(const Items& items) {
  constexpr std::size_t few = 6;
  std::string text;
  std::size_t i = 0;
  for (const auto& item : items) {
    if (i == few) return text + fmt::format(" and {} more", items.size() - few);
    text += fmt::format("{}{}", i++ == 0 ? "" : ", ", item);
  }
  return text;
}

std::string several(std::size_t n, std::string_view what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

/// What the welds are like, counted.
struct Account {
  std::size_t presumed = 0;
  std::array<std::size_t, 3> on_sheets{};      ///< on none, one, two different sheets
  std::map<double, std::size_t> diameters;     ///< rounded to three digits; 0: not known
  std::map<std::string, std::size_t> reasons;  ///< of ends that hang on nothing, without the numbers of their elements
  std::vector<int> without_section, without_material;  ///< parts
  std::size_t other_beams = 0, other_bricks = 0;       ///< without a material, but no welds by the way they lie
};

std::string reason_of(const weld::Projection& p, bool any_tie) {
  if (p.kase == 0) return any_tie ? "no contact tracks them" : "the deck has no tie contact";
  if (p.only_sheet_taken) return "the only sheet in reach holds the other end";
  return p.kase == 5 ? "no sheet is in reach of their contact" : "projection would turn the weld over or crush it";
}

Account take_account(const model::Model& model, const weld::Ties& ties) {
  Account account;
  const bool any_tie =
      std::any_of(model.contacts.begin(), model.contacts.end(), [](const model::Contact& c) { return c.tie(); });
  std::set<model::Index> parts;
  for (const weld::Weld& w : ties.welds) {
    if (weld::presumed(model, w)) {
      ++account.presumed;
      (w.of_bricks() ? account.other_bricks : account.other_beams) += w.elements.size();
    }
    const bool one = w.sheets[0] != model::none, other = w.sheets[1] != model::none && w.sheets[1] != w.sheets[0];
    ++account.on_sheets[static_cast<std::size_t>(one) + static_cast<std::size_t>(other)];
    if (w.part != model::none) parts.insert(w.part);
    if (w.kind != weld::Weld::Kind::rigid && w.kind != weld::Weld::Kind::connector)
      // Of any number that is printed; std::stod throws at the smallest ones.
      ++account.diameters[std::strtod(fmt::format("{:.3g}", w.diameter).c_str(), nullptr)];
    std::vector<std::string> told;
    for (const weld::Projection& p : w.ends) {
      if (p.tied) continue;
      const std::string reason = reason_of(p, any_tie);
      if (std::find(told.begin(), told.end(), reason) != told.end()) continue;
      told.push_back(reason);
      ++account.reasons[reason];
    }
  }
  const auto unknown = [&](const std::vector<model::Index>& part_of) {
    return static_cast<std::size_t>(std::count_if(
        part_of.begin(), part_of.end(), [&](model::Index p) { return model.parts[at(p)].material == model::none; }));
  };
  account.other_beams = unknown(model.beams.part) - account.other_beams;
  account.other_bricks = unknown(model.solids.part) - account.other_bricks;
  for (const model::Index index : parts) {
    const model::Part& part = model.parts[at(index)];
    if (part.section == model::none) account.without_section.push_back(part.id);
    if (part.material == model::none) account.without_material.push_back(part.id);
  }
  std::sort(account.without_section.begin(), account.without_section.end());
  std::sort(account.without_material.begin(), account.without_material.end());
  return account;
}

/// The usual diameters first.
std::string diameters(const Account& account) {
  std::vector<std::pair<double, std::size_t>> order(account.diameters.begin(), account.diameters.end());
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<std::string> list;
  for (const auto& [diameter, count] : order)
    list.push_back(diameter > 0.0 ? fmt::format("{:g} ({})", diameter, count) : fmt::format("not known ({})", count));
  return first_of(list);
}

/// *MAT_SPOTWELD that no part uses: what the weld parts may have lost.
std::size_t unused_weld_materials(const model::Model& model) {
  std::size_t unused = 0;
  for (std::size_t m = 0; m < model.materials.size(); ++m) {
    const auto uses = [m](const model::Part& p) { return p.material == static_cast<model::Index>(m); };
    unused += model.materials[m].weld != model::none && std::none_of(model.parts.begin(), model.parts.end(), uses);
  }
  return unused;
}

/// The names in quotes of files that *INCLUDE did not find.
std::vector<std::string> missing_files(const Findings& findings) {
  std::vector<std::string> files;
  for (const Finding& f : findings.all()) {
    if (!f.keyword.starts_with("*INCLUDE") || f.severity != Severity::error) continue;
    const std::size_t begin = f.text.find('\''), end = f.text.find('\'', begin + 1);
    if (begin != std::string::npos && end != std::string::npos)
      files.push_back(f.text.substr(begin + 1, end - begin - 1));
  }
  return files;
}

/// Why welds have no sheets, in one sentence.
std::string why(const model::Model& model, const Account& account, const std::vector<std::string>& files) {
  std::vector<std::string> causes;
  for (const auto& [reason, count] : account.reasons) causes.push_back(reason);
  const auto weld_part = [&](const model::Part& p) { return p.kind == model::ElementKind::shell; };
  if (std::none_of(model.parts.begin(), model.parts.end(), weld_part)) causes.emplace_back("the deck has no shells");
  if (!files.empty())
    causes.push_back(fmt::format("{} {}, which *INCLUDE names, {} not here",
                                 files.size() == 1 ? "the file" : "the files", first_of(files),
                                 files.size() == 1 ? "is" : "are"));
  return fmt::format("{}", fmt::join(causes, ", and "));
}

std::string sheets_sentence(const Account& account, std::size_t welds) {
  const auto [none, one, two] = account.on_sheets;
  if (none == welds) return "none has a sheet";
  if (two == welds) return "each on two sheets";
  return fmt::format("{} on two sheets, {} on one, {} on none", two, one, none);
}

}  // namespace

std::vector<std::string> leave_out_broken_ties(model::Model& model) {
  std::vector<std::string> names;
  std::erase_if(model.contacts, [&](const model::Contact& contact) {
    const bool broken = contact.tie() && (contact.a.empty() || contact.b.empty());
    if (broken) names.push_back(weld::name_contact(contact));
    return broken;
  });
  return names;
}

std::string weld_account(const model::Model& model, const weld::Ties& ties, const std::vector<std::string>& left_out,
                         Findings& findings) {
  if (ties.welds.empty()) return {};
  const std::size_t count = ties.welds.size();
  const Account account = take_account(model, ties);
  const std::vector<std::string> files = missing_files(findings);
  std::string cause = why(model, account, files);
  if (!left_out.empty())
    cause += fmt::format("{}{} {} left out, as a side of {} is not here", cause.empty() ? "" : ", and ",
                         first_of(left_out), left_out.size() == 1 ? "is" : "are", left_out.size() == 1 ? "it" : "each");
  const bool all = account.on_sheets[2] == count;

  Finding told;
  told.severity = all ? Severity::note : Severity::warning;
  told.place.file = model.deck;
  told.keyword = weld::keyword_of(ties.welds.front());
  told.text = fmt::format("{}, {}{}", several(count, "weld"), sheets_sentence(account, count),
                          all || cause.empty() ? "" : ": " + cause);
  findings.add(told);

  const auto line = [](std::string_view name, const std::string& text) {
    return fmt::format(" {:<12}{}\n", name, text);
  };
  std::string s = "The deck is refused; what can be said of its welds all the same:\n\n";
  s += line("welds", weld_kinds(ties));
  if (account.presumed > 0)
    s += line("",
              fmt::format("{} of them in parts without a material: taken for welds, as they share nodes with nothing "
                          "but each other",
                          account.presumed));
  s += line("sheets", sheets_sentence(account, count));
  if (!account.diameters.empty()) s += line("diameters", diameters(account));
  for (const auto& [n, what] : {std::pair{account.other_beams, "beam"}, std::pair{account.other_bricks, "brick"}})
    if (n > 0)
      s += line(
          "", fmt::format("{} without a material {} part of something larger, and not taken for {}",
                          several(n, "more " + std::string(what)), n == 1 ? "is" : "are", n == 1 ? "a weld" : "welds"));
  std::string missing;
  for (const auto& [reason, welds] : account.reasons)
    missing += line("sheets", fmt::format("{} with ends on nothing: {}", several(welds, "weld"), reason));
  if (!left_out.empty())
    missing += line("contacts", fmt::format("{} left out: what names a side was refused, or is not in the deck",
                                            first_of(left_out)));
  const auto parts = [&](std::string_view what, const std::vector<int>& ids) {
    if (ids.empty()) return std::string();
    return line(what, fmt::format("weld part{} {} {} none in the deck", ids.size() == 1 ? "" : "s", first_of(ids),
                                  ids.size() == 1 ? "has" : "have"));
  };
  missing += parts("sections", account.without_section) + parts("materials", account.without_material);
  if (const std::size_t unused = unused_weld_materials(model); unused > 0)
    missing += line("", fmt::format("{} *MAT_SPOTWELD that no part uses", unused));
  if (!files.empty()) missing += line("files", fmt::format("{}: named by *INCLUDE, not found", first_of(files)));
  if (!missing.empty()) s += "\nMissing, and why:\n\n" + missing;
  return s + '\n';
}

}  // namespace nugget::app
