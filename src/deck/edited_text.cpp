// SPDX-License-Identifier: Apache-2.0
#include "deck/edited_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <stdexcept>

#include "deck/impl.hpp"
#include "deck/text.hpp"

namespace nugget::deck {
namespace {

namespace fs = std::filesystem;

/// The line after that at `offset`.
std::size_t next_line(std::string_view text, std::size_t offset) {
  const std::size_t end = text.find('\n', offset);
  return end == std::string_view::npos ? text.size() : end + 1;
}

}  // namespace

std::string_view EditedText::text_of(std::size_t file) const {
  return deck_.impl->texts[file].view();
}

std::size_t EditedText::file_of(std::string_view piece) const {
  const std::less_equal<const char*> before;
  for (std::size_t f = 0; f < deck_.files.size(); ++f) {
    const std::string_view text = text_of(f);
    if (before(text.data(), piece.data()) && before(piece.data() + piece.size(), text.data() + text.size())) return f;
  }
  throw std::logic_error("a piece of text that is none of the deck's");
}

bool EditedText::is_read_twice(std::size_t file) const {
  return std::ranges::count(deck_.inclusions, file, &Deck::Inclusion::file) > 1 ||
         std::ranges::count(deck_.files, deck_.files[file]) > 1;
}

std::string_view EditedText::line(std::size_t file, int number) const {
  const std::string_view text = text_of(file);
  std::size_t begin = 0;
  for (int i = 1; i < number; ++i) begin = next_line(text, begin);
  std::string_view found = text.substr(begin, text.find('\n', begin) - begin);
  if (found.ends_with('\r')) found.remove_suffix(1);
  return found;
}

const std::string* EditedText::current(std::string_view piece) const {
  const auto own = edits_.find(file_of(piece));
  if (own == edits_.end()) return nullptr;
  const auto edit = own->second.find(static_cast<std::size_t>(piece.data() - text_of(own->first).data()));
  return edit == own->second.end() || edit->second.first != piece.size() ? nullptr : &edit->second.second;
}

bool EditedText::replace(std::string_view piece, std::string text) {
  const std::size_t file = file_of(piece);
  const auto begin = static_cast<std::size_t>(piece.data() - text_of(file).data()), end = begin + piece.size();
  Edits& edits = edits_[file];
  const auto first = edits.lower_bound(begin);
  if (first != edits.begin() && std::prev(first)->first + std::prev(first)->second.first > begin) return false;
  auto last = first;
  for (; last != edits.end() && (last->first < end || last->first == begin); ++last)
    if (last->first + last->second.first > end) return false;
  edits.erase(first, last);
  edits[begin] = {piece.size(), std::move(text)};
  return true;
}

std::vector<bool> EditedText::changed_files() const {
  std::vector<bool> changed(deck_.files.size(), false);
  for (const auto& [file, edits] : edits_) changed[file] = true;
  // A file is included by one that was opened before it, so that one walk from the last on reaches the master; a file
  // opened twice may stand before: once more until nothing changes.
  for (bool more = true; more;) {
    more = false;
    for (const Deck::Inclusion& i : deck_.inclusions)
      if (changed[i.file] && !changed[i.from]) changed[i.from] = more = true;
  }
  changed[0] = true;
  return changed;
}

void EditedText::replace_name(std::size_t file, int line, std::string name, Edits& edits) const {
  const std::string_view text = text_of(file);
  std::size_t begin = 0;
  for (int i = 1; i < line; ++i) begin = next_line(text, begin);
  std::size_t end = begin;
  bool continued = true;
  while (continued && end < text.size()) {
    const std::size_t next = next_line(text, end);
    const std::string_view piece = text.substr(end, next - end);
    const bool remark = piece.starts_with('$');
    continued = remark || trimmed(piece.substr(0, piece.find('\n'))).ends_with(" +");
    end = next;
  }
  edits[begin] = {end - begin, name_lines(std::move(name))};
}

std::string EditedText::with_edits(std::size_t file, const Edits& edits, std::string_view remark) const {
  const std::string_view text = text_of(file);
  std::string out;
  std::size_t done = 0;
  if (const std::size_t keyword = text.find("*KEYWORD"); file == 0) {
    done = keyword == std::string_view::npos ? 0 : next_line(text, keyword);
    out.append(text.substr(0, done)).append(remark);
  }
  for (const auto& [offset, edit] : edits) {
    out.append(text.substr(done, offset - done)).append(edit.second);
    done = offset + edit.first;
  }
  return out.append(text.substr(done));
}

std::vector<EditedText::File> EditedText::files(const fs::path& master, std::string_view remark) const {
  const std::vector<bool> changed = changed_files();
  const fs::path folder = fs::absolute(master).parent_path();
  std::vector<std::string> names(deck_.files.size());
  std::set<std::string> taken{master.filename().string()};
  for (std::size_t f = 0; f < names.size(); ++f) {
    const fs::path old(deck_.files[f]);
    if (!changed[f] || f == 0) {
      names[f] = f == 0 ? master.filename().string() : fs::proximate(fs::absolute(old), folder).generic_string();
      continue;
    }
    const std::string stem = master.stem().string() + '_' + old.stem().string();
    names[f] = stem + old.extension().string();
    for (int k = 2; !taken.insert(names[f]).second; ++k)
      names[f] = fmt::format("{}_{}{}", stem, k, old.extension().string());
  }
  std::vector<File> out;
  for (std::size_t f = 0; f < names.size(); ++f) {
    if (!changed[f]) continue;
    const auto own = edits_.find(f);
    Edits edits = own == edits_.end() ? Edits{} : own->second;
    for (const Deck::Inclusion& i : deck_.inclusions)
      if (i.from == f) replace_name(f, i.line, names[i.file], edits);
    out.push_back({f == 0 ? master : master.parent_path() / names[f], with_edits(f, edits, remark)});
  }
  return out;
}

}  // namespace nugget::deck
