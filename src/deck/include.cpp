// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "deck/reader.hpp"
#include "deck/text.hpp"

namespace nugget::deck {
namespace {

namespace fs = std::filesystem;

constexpr int deepest_include = 64;

/// *INCLUDE_TRANSFORM, its five cards but the first: what ids are raised by, units are multiplied by and points are
/// moved by.
struct TransformCards {
  int idnoff = 0, ideoff = 0, idpoff = 0, idmoff = 0, idsoff = 0, idfoff = 0, iddoff = 0, idroff = 0;
  std::string prefix, suffix;
  double fctmas = 1.0, fcttim = 1.0, fctlen = 1.0, fctchg = 0.0;
  std::string fcttem;
  int incout1 = 1;
  int tranid = 0;
};
using Cards = TransformCards;

const CardOf<Cards> offsets_1{
    {&Cards::idnoff, integer("idnoff", 0, any_value, "offset of node ids")},
    {&Cards::ideoff, integer("ideoff", 0, any_value, "offset of element ids")},
    {&Cards::idpoff, integer("idpoff", 0, any_value, "offset of part ids")},
    {&Cards::idmoff, integer("idmoff", 0, any_value, "offset of material ids")},
    {&Cards::idsoff, integer("idsoff", 0, any_value, "offset of set ids")},
    {&Cards::idfoff, integer("idfoff", 0, any_value, "offset of curve, table and function ids")},
    {&Cards::iddoff, integer("iddoff", 0, any_value, "offset of other *DEFINE ids")},
};
const CardOf<Cards> offsets_2{
    {&Cards::idroff, integer("idroff", 0, any_value, "offset of all other ids")},
    unused(),
    {&Cards::prefix, text("prefix", 10, "prefix of titles")},
    {&Cards::suffix, text("suffix", 10, "suffix of titles")},
};
const CardOf<Cards> factors{
    {&Cards::fctmas, real("fctmas", dimension::number, 1.0, above_zero(), "unit factor of mass")},
    {&Cards::fcttim, real("fcttim", dimension::number, 1.0, above_zero(), "unit factor of time")},
    {&Cards::fctlen, real("fctlen", dimension::number, 1.0, above_zero(), "unit factor of length")},
    {&Cards::fcttem, text("fcttem", 10, "change of temperature unit")},
    {&Cards::incout1, integer("incout1", 1, any_value, "writes dyna.inc")},
    {&Cards::fctchg, real("fctchg", dimension::number, 0.0, any_value, "unit factor of electric charge")},
};
const CardOf<Cards> transformation{
    {&Cards::tranid, id("tranid", IdSpace::define, 0, "id of *DEFINE_TRANSFORMATION")},
};

/// The file of that name in a folder in other letters (decks come from systems that do not tell them apart); empty:
/// none.
std::string in_other_case(const fs::path& folder, const fs::path& name) {
  std::error_code fault;
  const std::string wanted = lower(name.filename().string());
  for (fs::directory_iterator entry(folder / name.parent_path(), fault), end; !fault && entry != end;
       entry.increment(fault)) {
    if (lower(entry->path().filename().string()) == wanted) return entry->path().filename().string();
  }
  return {};
}

std::string shown(const fs::path& folder) {
  return folder.empty() ? "." : folder.string();
}

}  // namespace

void Reader::include(const Block& block, const Visit& visit) {
  if (block.keyword == "INCLUDE") {
    include_files(block, visit);
  } else if (block.keyword == "INCLUDE_PATH" || block.keyword == "INCLUDE_PATH_RELATIVE") {
    include_path(block, visit);
  } else if (block.keyword == "INCLUDE_TRANSFORM") {
    include_transform(block, visit);
  } else {
    findings_.error(block.place, block.starred(), "this form of include is not supported",
                    "use *INCLUDE, *INCLUDE_PATH, *INCLUDE_PATH_RELATIVE or *INCLUDE_TRANSFORM");
  }
}

/// The next line as a file name: continued while it ends in ` +`, parameters replaced, backslashes as slashes, quotes
/// dropped.
std::string Reader::file_name(Cursor& cursor, const Block& block) {
  const Place place = cursor.place();
  std::string name;
  std::vector<std::string> unknown;
  while (cursor.left() > 0) {
    std::string piece = cursor.read_text(&unknown);
    const bool continued = piece.ends_with(" +");
    if (continued) piece = trimmed(std::string_view(piece).substr(0, piece.size() - 1));
    name += piece;
    if (!continued) break;
  }
  if (!unknown.empty()) {
    findings_.error(place, block.starred(),
                    fmt::format("the parameter '{}' in the file name is not defined before this line", unknown.front()),
                    "define it with *PARAMETER above this keyword, or correct the name");
    return {};
  }
  std::replace(name.begin(), name.end(), '\\', '/');
  if (name.size() > 1 && (name.front() == '"' || name.front() == '\'') && name.back() == name.front()) {
    name = name.substr(1, name.size() - 2);
  }
  return name;
}

void Reader::include_files(const Block& block, const Visit& visit) {
  Cursor cursor(deck_, block, findings_);
  if (!cursor.more()) {
    findings_.warning(block.place, block.starred(), "no file name stands under this keyword; nothing is included",
                      "remove the keyword, or take the $ from the names below it");
  }
  while (cursor.more()) {
    const Place place = cursor.place();
    const std::string name = file_name(cursor, block);
    if (!name.empty()) open(name, place, block, visit, visit.transform);
  }
}

void Reader::include_path(const Block& block, const Visit& visit) {
  const bool relative_to_master = block.keyword.ends_with("_RELATIVE");
  Cursor cursor(deck_, block, findings_);
  while (cursor.more()) {
    const Place place = cursor.place();
    const std::string name = file_name(cursor, block);
    if (name.empty()) continue;
    const fs::path master = deck_.path.parent_path();
    std::error_code fault;
    fs::path folder = relative_to_master ? master / name : folder_ / name;
    // LS-DYNA starts from the current folder; a deck given by a path is meant to find its own folders too.
    if (!fs::is_directory(folder, fault)) {
      const fs::path beside = visit.path.parent_path() / name;
      if (fs::is_directory(beside, fault)) folder = beside;
    }
    if (!fs::is_directory(folder, fault)) {
      findings_.warning(place, block.starred(), fmt::format("the folder '{}' does not exist", readable(name)),
                        "correct the path or remove the line");
    }
    include_folders_.push_back(folder.lexically_normal());
  }
}

void Reader::include_transform(const Block& block, const Visit& visit) {
  Cursor cursor(deck_, block, findings_);
  if (!cursor.more()) {
    findings_.error(block.place, block.starred(), "the name of the file is missing",
                    "write it on the line below the keyword");
    return;
  }
  const Place place = cursor.place();
  const std::string name = file_name(cursor, block);
  TransformCards cards;
  cursor.read(offsets_1, cards);
  const RowOf<Cards> titles = cursor.read(offsets_2, cards);
  const RowOf<Cards> units = cursor.read(factors, cards);
  const RowOf<Cards> move = cursor.read(transformation, cards);
  for (const Entry& title : {titles[&Cards::prefix], titles[&Cards::suffix]}) {
    if (!title.blank) title.report(findings_, Severity::warning, "titles of the included file stay as they are");
  }
  if (cards.fcttem.find_first_not_of("0123456789.") != std::string::npos) {
    units[&Cards::fcttem].report(findings_, Severity::error, "temperatures are not supported", "leave the field blank");
  }
  if (cards.fctchg != 0.0 && cards.fctchg != 1.0) {
    units[&Cards::fctchg].report(findings_, Severity::error, "electric charge is not supported",
                                 "leave the field blank");
  }
  if (const Entry written = units[&Cards::incout1]; !written.blank && cards.incout1 == 1) {
    written.report(findings_, Severity::note, "the file dyna.inc is not written", "nugget check shows the model");
  }
  if (cursor.more()) {
    findings_.error(cursor.place(), block.starred(), "more lines than the five cards of this keyword",
                    "give each included file its own *INCLUDE_TRANSFORM");
  }

  Transform own;
  const auto offset = [&](IdSpace space) -> long& { return own.id_offset[static_cast<std::size_t>(space)]; };
  offset(IdSpace::node) = cards.idnoff;
  offset(IdSpace::element) = cards.ideoff;
  offset(IdSpace::part) = cards.idpoff;
  offset(IdSpace::material) = cards.idmoff;
  offset(IdSpace::set) = cards.idsoff;
  offset(IdSpace::function) = cards.idfoff;
  offset(IdSpace::define) = cards.iddoff;
  offset(IdSpace::other) = cards.idroff;
  own.mass = cards.fctmas;
  own.time = cards.fcttim;
  own.length = cards.fctlen;
  Transform& target =
      deck_.impl->transforms.emplace_back(visit.transform == nullptr ? own : composed(*visit.transform, own));
  pending_.push_back({&target, visit.transform, own, cards.tranid, move[&Cards::tranid].place});
  if (!name.empty()) open(name, place, block, visit, &target);
}

std::vector<fs::path> Reader::search_folders(const Visit& visit) const {
  std::vector<fs::path> folders{folder_};
  folders.insert(folders.end(), include_folders_.begin(), include_folders_.end());
  folders.push_back(visit.path.parent_path());
  folders.push_back(deck_.path.parent_path());
  std::vector<fs::path> each_once;
  for (const fs::path& f : folders) {
    if (std::find(each_once.begin(), each_once.end(), f) == each_once.end()) each_once.push_back(f);
  }
  return each_once;
}

/// The current folder comes first, as in LS-DYNA: a deck that is run from elsewhere may meet a stranger there.
void Reader::warn_of_namesake(const fs::path& taken, const std::string& name, const Place& place, const Block& block,
                              const Visit& visit) {
  std::error_code fault;
  const fs::path beside = visit.path.parent_path() / name;
  if (!fs::is_regular_file(beside, fault) || fs::equivalent(beside, taken, fault)) return;
  findings_.warning(place, block.starred(),
                    fmt::format("{} is read; another file of that name stands beside the deck, {}", taken.string(),
                                beside.lexically_normal().string()),
                    "run the deck from its own folder, or name the file by its path");
}

void Reader::open(const std::string& name, const Place& place, const Block& block, const Visit& visit,
                  const Transform* transform) {
  std::error_code fault;
  const std::vector<fs::path> folders = search_folders(visit);
  fs::path path;
  bool folder_found = false;
  for (const fs::path& folder : folders) {
    const fs::path candidate = (folder / name).lexically_normal();
    const fs::file_status status = fs::status(candidate, fault);
    folder_found = folder_found || fs::is_directory(status);
    if (fs::exists(status) && !fs::is_directory(status)) {
      path = candidate;
      break;
    }
  }
  if (path.empty()) {
    std::vector<std::string> shown_folders;
    std::string remedy = "put the file into one of these folders, or name its folder with *INCLUDE_PATH";
    for (const fs::path& folder : folders) {
      shown_folders.push_back(shown(folder));
      const std::string other = in_other_case(folder, name);
      if (!other.empty() && !folder_found)
        remedy = fmt::format("there is a file '{}' in {}: correct the name", other, shown(folder));
    }
    findings_.error(
        place, block.starred(),
        folder_found
            ? fmt::format("'{}' is a folder, not a file", readable(name))
            : fmt::format("cannot find the file '{}'; looked in {}", readable(name), fmt::join(shown_folders, ", ")),
        folder_found ? "name a file in it; a folder to search is named with *INCLUDE_PATH" : std::move(remedy));
    return;
  }

  const fs::path canonical = fs::canonical(path, fault);
  if (std::find(open_.begin(), open_.end(), canonical) != open_.end() || visit.depth >= deepest_include) {
    findings_.error(place, block.starred(),
                    fmt::format("'{}' includes itself, directly or through its own includes", path.string()),
                    "break the circle of *INCLUDE");
    return;
  }
  warn_of_namesake(canonical, name, place, block, visit);
  Visit inner;
  const auto known = std::find(deck_.files.begin(), deck_.files.end(), path.string());
  inner.file = static_cast<std::size_t>(known - deck_.files.begin());
  if (known == deck_.files.end()) {
    deck_.files.push_back(path.string());
    const std::string trouble = deck_.impl->texts.emplace_back().open(path);
    if (!trouble.empty()) {
      findings_.error(place, block.starred(), fmt::format("cannot read '{}': {}", path.string(), trouble),
                      "check the file");
    }
  }
  deck_.inclusions.push_back({visit.file, place.line, inner.file});
  inner.format = block.format;
  inner.transform = transform;
  inner.depth = visit.depth + 1;
  inner.path = path;
  open_.push_back(canonical);
  read_file(std::move(inner));
  open_.pop_back();
}

}  // namespace nugget::deck
