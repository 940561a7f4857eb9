// SPDX-License-Identifier: Apache-2.0
#include "reading/cards/friction.hpp"

#include <fmt/format.h>

#include <cmath>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *DEFINE_FRICTION: friction between pairs of parts, for contacts with FS = -2.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

struct DefaultCard {
  int id = 0;
  double fs_d = 0, fd_d = 0, dc_d = 0, vc_d = 0;
  int icnep = 0;
};
const CardOf<DefaultCard> default_card{
    {&DefaultCard::id, id("id", IdSpace::define, 0, "friction; FD of a contact names it")},
    {&DefaultCard::fs_d, real("fs_d", dimension::number, 0, at_least(0), "static friction of parts that no pair has")},
    {&DefaultCard::fd_d, real("fd_d", dimension::number, 0, at_least(0), "dynamic friction")},
    {&DefaultCard::dc_d, real("dc_d", {0, -1, 1}, 0, at_least(0), "decay of the friction with the speed")},
    {&DefaultCard::vc_d, real("vc_d", dimension::stress, 0, at_least(0), "greatest shear stress; 0: none")},
    {&DefaultCard::icnep, integer("icnep", 0, between(0, 1), "1: pairs of parts that are not there are left out")},
};

struct FrictionPairCard {
  int pid_i = 0, pid_j = 0;
  double fs_ij = 0, fd_ij = 0, dc_ij = 0, vc_ij = 0;
};
CardOf<FrictionPairCard> friction_pair_card(IdSpace one, IdSpace other) {
  return {
      {&FrictionPairCard::pid_i, id("pid_i", one, required, "part or part set")},
      {&FrictionPairCard::pid_j, id("pid_j", other, required, "part or part set")},
      {&FrictionPairCard::fs_ij, real("fs_ij", dimension::number, 0, at_least(0), "static friction between them")},
      {&FrictionPairCard::fd_ij, real("fd_ij", dimension::number, 0, at_least(0), "dynamic friction")},
      {&FrictionPairCard::dc_ij, real("dc_ij", {0, -1, 1}, 0, at_least(0), "decay of the friction with the speed")},
      {&FrictionPairCard::vc_ij, real("vc_ij", dimension::stress, 0, at_least(0), "greatest shear stress; 0: none")},
      text("ptypei", 10, "PART or PSET: what pid_i is; blank: PART"),
      text("ptypej", 10, "the same of pid_j"),
  };
}
const CardOf<FrictionPairCard> parts_card = friction_pair_card(IdSpace::part, IdSpace::part),
                               set_and_part_card = friction_pair_card(IdSpace::set, IdSpace::part),
                               part_and_set_card = friction_pair_card(IdSpace::part, IdSpace::set),
                               sets_card = friction_pair_card(IdSpace::set, IdSpace::set);

/// A line as it is written, for what it says of its own fields.
struct WordsCard {
  std::string ptypei, ptypej;
};
const CardOf<WordsCard> words_card{
    text("1", 10, ""),
    text("2", 10, ""),
    text("3", 10, ""),
    text("4", 10, ""),
    text("5", 10, ""),
    text("6", 10, ""),
    {&WordsCard::ptypei, text("ptypei", 10, "")},
    {&WordsCard::ptypej, text("ptypej", 10, "")},
};

struct PairRow {
  RowOf<FrictionPairCard> row;
  bool one_is_set, other_is_set;
};

PairRow read_pair(Builder& b, Cursor& cursor) {
  Cursor ahead = cursor;
  const auto words = ahead.read(words_card);
  const auto is_set = [&](const deck::Entry& type_field) {
    const std::string& type = type_field.text;
    if (!type.empty() && type != "PART" && type != "PSET")
      refuse(b, type_field, "expected PART or PSET", "leave it blank for a part");
    return type == "PSET";
  };
  const bool one = is_set(words[&WordsCard::ptypei]), other = is_set(words[&WordsCard::ptypej]);
  return {cursor.read(one ? (other ? sets_card : set_and_part_card) : (other ? part_and_set_card : parts_card)), one,
          other};
}

void read_friction(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto row = cursor.read(default_card);
  PartFriction f;
  f.id = row->id;
  f.otherwise = {row->fs_d, row->fd_d, row->dc_d, row->vc_d};
  const auto index = static_cast<Index>(b.model.part_friction.size());
  b.part_friction.add(f.id, index, row.place(), row.keyword(), "friction", b.findings);
  b.model.part_friction.push_back(f);
  const bool may_be_absent = row->icnep == 1;
  std::vector<PairRow> rows;
  while (!at_end(cursor)) rows.push_back(read_pair(b, cursor));
  b.defer(Phase::bodies, [index, rows, may_be_absent](Builder& later) {
    for (const PairRow& r : rows) {
      const auto parts = [&](const deck::Entry& field, bool is_set) -> std::vector<Index> {
        if (may_be_absent && (is_set ? later.part_sets : later.parts).find(field.integer()) == none) return {};
        if (is_set) {
          const Set<Index>* set = later.part_set(field);
          return set != nullptr ? set->members : std::vector<Index>{};
        }
        const Index part = later.part(field);
        return part != none ? std::vector<Index>{part} : std::vector<Index>{};
      };
      later.model.part_friction[index].pairs.push_back({parts(r.row[&FrictionPairCard::pid_i], r.one_is_set),
                                                        parts(r.row[&FrictionPairCard::pid_j], r.other_is_set),
                                                        {r.row->fs_ij, r.row->fd_ij, r.row->dc_ij, r.row->vc_ij}});
    }
  });
}

}  // namespace

Index friction_table(Builder& builder, const deck::Entry& fs, const deck::Entry& fd, long offset) {
  const long written = std::lround(fd.value);
  const int id = static_cast<int>(written != 0 ? written + offset : 0);
  const Index found = id != 0 ? builder.part_friction.find(id) : builder.model.part_friction.empty() ? none : 0;
  if (found == none)
    refuse(builder, id != 0 ? fd : fs,
           id != 0 ? fmt::format("*DEFINE_FRICTION {} is not defined", id) : "there is no *DEFINE_FRICTION in the deck",
           "define it");
  return found;
}

std::vector<Keyword> friction_keywords() {
  return {
      {.name = "DEFINE_FRICTION",
       .options = {"TITLE"},
       .layout = {{"", &default_card}, {"repeated", &parts_card}},
       .read = read_friction},
  };
}

}  // namespace nugget::reading
