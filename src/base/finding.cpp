// SPDX-License-Identifier: Apache-2.0
#include "base/finding.hpp"

#include <fmt/format.h>

namespace nugget {

std::string_view to_string(Severity severity) {
  switch (severity) {
    case Severity::note: return "note";
    case Severity::warning: return "warning";
    case Severity::error: return "error";
  }
  return "error";
}

std::string to_string(const Finding& f) {
  std::string s;
  if (!f.place.file.empty()) {
    s = f.place.file + ':';
    if (f.place.line > 0) s += fmt::format("{}:", f.place.line);
    if (f.place.line > 0 && f.place.column > 0) s += fmt::format("{}:", f.place.column);
    s += ' ';
  }
  s += fmt::format("{}: ", to_string(f.severity));
  if (!f.keyword.empty()) s += f.keyword;
  if (!f.field.empty())
    s += fmt::format("{}{} = {}", f.keyword.empty() ? "" : " ", f.field, f.value.empty() ? "(blank)" : f.value);
  if (!f.keyword.empty() || !f.field.empty()) s += ": ";
  s += f.text;
  if (!f.remedy.empty()) s += fmt::format(" [{}]", f.remedy);
  return s;
}

std::string totals(const Findings& findings) {
  const auto several = [](int n, std::string_view what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); };
  return several(findings.errors(), "error") + ", " + several(findings.warnings(), "warning");
}

void Findings::add(Finding finding) {
  if (finding.severity == Severity::error) ++errors_;
  if (finding.severity == Severity::warning) ++warnings_;
  findings_.push_back(std::move(finding));
}

void Findings::error(Place place, std::string keyword, std::string text, std::string remedy) {
  add({Severity::error, std::move(place), std::move(keyword), {}, {}, std::move(text), std::move(remedy)});
}

void Findings::warning(Place place, std::string keyword, std::string text, std::string remedy) {
  add({Severity::warning, std::move(place), std::move(keyword), {}, {}, std::move(text), std::move(remedy)});
}

void Findings::note(Place place, std::string keyword, std::string text, std::string remedy) {
  add({Severity::note, std::move(place), std::move(keyword), {}, {}, std::move(text), std::move(remedy)});
}

}  // namespace nugget
