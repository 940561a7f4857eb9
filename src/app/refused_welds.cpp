// SPDX-License-Identifier: Apache-2.0
#include "app/refused_welds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>

#include "app/audit_table.hpp"
#include "base/index.hpp"
#include "weld/tie/inferred_welds.hpp"
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
struct WeldSummary {
  std::size_t inferred = 0;
  std::array<std::size_t, 3> on_sheets{};   ///< on none, one, two sheets
  std::map<double, std::size_t> diameters;  ///< rounded to three digits; 0: not known
  std::map<std::string, std::size_t>
      reasons;  ///< of ends that are tied to nothing, without the numbers of their elements
  std::vector<int> without_section, without_material;  ///< parts
  std::size_t other_beams = 0, other_bricks = 0;       ///< without a material, but no welds by the way they lie
};

/// `without_ties`: of a deck that has no tie contact.
std::string reason_of(const weld::Projection& p, const std::string& without_ties) {
  if (p.projection_case == 0) return without_ties.empty() ? "no contact tracks them" : without_ties;
  if (p.only_sheet_taken) return "the only sheet in reach holds the other end";
  return p.projection_case == 5 ? "no sheet is in reach of their contact"
                                : "projection would turn the weld over or crush it";
}

WeldSummary summarize(const model::Model& model, const weld::Ties& ties, const std::string& refused) {
  WeldSummary summary;
  const bool any_tie = std::ranges::any_of(model.contacts, [](const model::Contact& c) { return c.tie(); });
  const std::string without_ties = any_tie           ? ""
                                   : refused.empty() ? "the deck has no tie contact"
                                                     : refused + " is refused";
  std::set<model::Index> parts;
  for (const weld::Weld& w : ties.welds) {
    if (weld::is_inferred(model, w)) {
      ++summary.inferred;
      (w.of_bricks() ? summary.other_bricks : summary.other_beams) += w.elements.size();
    }
    const bool one = w.sheets[0] != model::none;
    const bool other = w.sheets[1] != model::none && (w.tied || w.sheets[1] != w.sheets[0]);
    ++summary.on_sheets[at(one) + at(other)];
    if (w.part != model::none) parts.insert(w.part);
    if (w.kind != weld::Weld::Kind::rigid && w.kind != weld::Weld::Kind::connector)
      // Of any number that is printed; std::stod throws at the smallest ones.
      ++summary.diameters[std::strtod(fmt::format("{:.3g}", w.diameter).c_str(), nullptr)];
    std::vector<std::string> reported;
    for (const weld::Projection& p : w.ends) {
      if (p.tied) continue;
      const std::string reason = reason_of(p, without_ties);
      if (std::find(reported.begin(), reported.end(), reason) != reported.end()) continue;
      reported.push_back(reason);
      ++summary.reasons[reason];
    }
  }
  const auto unknown = [&](const std::vector<model::Index>& part_of) {
    return static_cast<std::size_t>(std::count_if(
        part_of.begin(), part_of.end(), [&](model::Index p) { return model.parts[p].material == model::none; }));
  };
  summary.other_beams = unknown(model.beams.part) - summary.other_beams;
  summary.other_bricks = unknown(model.solids.part) - summary.other_bricks;
  for (const model::Index index : parts) {
    const model::Part& part = model.parts[index];
    if (part.section == model::none) summary.without_section.push_back(part.id);
    if (part.material == model::none) summary.without_material.push_back(part.id);
  }
  std::sort(summary.without_section.begin(), summary.without_section.end());
  std::sort(summary.without_material.begin(), summary.without_material.end());
  return summary;
}

/// The usual diameters first.
std::string diameters(const WeldSummary& summary) {
  std::vector<std::pair<double, std::size_t>> order(summary.diameters.begin(), summary.diameters.end());
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
std::string why(const model::Model& model, const WeldSummary& summary, const std::vector<std::string>& files) {
  std::vector<std::string> causes;
  for (const auto& [reason, count] : summary.reasons) causes.push_back(reason);
  const auto weld_part = [&](const model::Part& p) { return p.kind == model::ElementKind::shell; };
  if (std::none_of(model.parts.begin(), model.parts.end(), weld_part)) causes.emplace_back("the deck has no shells");
  if (!files.empty())
    causes.push_back(fmt::format("{} {}, which *INCLUDE names, {} not here",
                                 files.size() == 1 ? "the file" : "the files", first_of(files),
                                 files.size() == 1 ? "is" : "are"));
  return fmt::format("{}", fmt::join(causes, ", and "));
}

std::string sheets_sentence(const WeldSummary& summary, std::size_t welds) {
  const auto [none, one, two] = summary.on_sheets;
  if (none == welds) return "none has a sheet";
  if (two == welds) return "each on two sheets";
  return fmt::format("{} on two sheets, {} on one, {} on none", two, one, none);
}

/// The welds without those that are only taken for some and that nothing holds: where there are welds besides, or
/// nothing in the deck speaks of any. Without places and ties.
weld::Ties without_doubtful_welds(const model::Model& model, const weld::Ties& ties, bool something_is_missing) {
  const auto is_sure = [&model](const weld::Weld& w) {
    return !weld::is_inferred(model, w) ||
           std::any_of(w.ends.begin(), w.ends.end(), [](const weld::Projection& p) { return p.tied; });
  };
  const bool speaks_of_welds = something_is_missing || !model.weld_laws.empty() ||
                               std::ranges::any_of(model.contacts, [](const model::Contact& c) { return c.tie(); });
  weld::Ties sure;
  std::ranges::copy_if(ties.welds, std::back_inserter(sure.welds), is_sure);
  if (sure.welds.empty() && speaks_of_welds) sure.welds = ties.welds;
  return sure;
}

}  // namespace

std::string refused_contact(const Findings& findings) {
  const auto refuses = [](const Finding& f) {
    return f.severity == Severity::error && f.keyword.starts_with("*CONTACT_") && f.field.empty();
  };
  const auto found = std::ranges::find_if(findings.all(), refuses);
  return found == findings.all().end() ? std::string() : found->keyword;
}

std::vector<std::string> leave_out_broken_ties(model::Model& model) {
  std::vector<std::string> names;
  std::erase_if(model.contacts, [&](const model::Contact& contact) {
    const bool broken = contact.tie() && (contact.a.empty() || contact.b.empty());
    if (broken) names.push_back(weld::name_contact(contact));
    return broken;
  });
  return names;
}

std::string summarize_refused_welds(const model::Model& model, const weld::Ties& of_model,
                                    const std::vector<std::string>& left_out, Findings& findings) {
  const std::vector<std::string> files = missing_files(findings);
  const weld::Ties ties = without_doubtful_welds(model, of_model, !files.empty() || !left_out.empty());
  if (ties.welds.empty()) return {};
  const std::size_t count = ties.welds.size();
  const WeldSummary summary = summarize(model, ties, refused_contact(findings));
  std::string cause = why(model, summary, files);
  if (!left_out.empty())
    cause += fmt::format("{}{} {} left out, as a side of {} is not here", cause.empty() ? "" : ", and ",
                         first_of(left_out), left_out.size() == 1 ? "is" : "are", left_out.size() == 1 ? "it" : "each");
  const bool all = summary.on_sheets[2] == count;

  Finding finding;
  finding.severity = all ? Severity::note : Severity::warning;
  finding.place.file = model.deck;
  finding.keyword = weld::keyword_of(ties.welds.front());
  finding.text = fmt::format("{}, {}{}", several(count, "weld"), sheets_sentence(summary, count),
                             all || cause.empty() ? "" : ": " + cause);
  findings.add(finding);

  const auto line = [](std::string_view name, const std::string& text) {
    return fmt::format(" {:<12}{}\n", name, text);
  };
  std::string s = "The deck is refused; what can be said of its welds all the same:\n\n";
  s += line("welds", weld_kinds(ties));
  if (summary.inferred > 0)
    s += line("",
              fmt::format("{} of them in parts without a material: taken for welds, as they share nodes with nothing "
                          "but each other",
                          summary.inferred));
  s += line("sheets", sheets_sentence(summary, count));
  if (!summary.diameters.empty()) s += line("diameters", diameters(summary));
  for (const auto& [n, what] : {std::pair{summary.other_beams, "beam"}, std::pair{summary.other_bricks, "brick"}})
    if (n > 0)
      s += line(
          "", fmt::format("{} without a material {} held by no sheet or part of something larger, and not taken for {}",
                          several(n, "more " + std::string(what)), n == 1 ? "is" : "are", n == 1 ? "a weld" : "welds"));
  std::string missing;
  for (const auto& [reason, welds] : summary.reasons)
    missing += line("sheets", fmt::format("{} with ends on nothing: {}", several(welds, "weld"), reason));
  if (!left_out.empty())
    missing += line("contacts", fmt::format("{} left out: what names a side was refused, or is not in the deck",
                                            first_of(left_out)));
  const auto parts = [&](std::string_view what, const std::vector<int>& ids) {
    if (ids.empty()) return std::string();
    return line(what, fmt::format("weld part{} {} {} none in the deck", ids.size() == 1 ? "" : "s", first_of(ids),
                                  ids.size() == 1 ? "has" : "have"));
  };
  missing += parts("sections", summary.without_section) + parts("materials", summary.without_material);
  if (const std::size_t unused = unused_weld_materials(model); unused > 0)
    missing += line("", fmt::format("{} *MAT_SPOTWELD that no part uses", unused));
  if (!files.empty()) missing += line("files", fmt::format("{}: named by *INCLUDE, not found", first_of(files)));
  if (!missing.empty()) s += "\nMissing, and why:\n\n" + missing;
  return s + '\n';
}

}  // namespace nugget::app
