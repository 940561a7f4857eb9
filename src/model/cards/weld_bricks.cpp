// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "model/cards/families.hpp"
#include "model/cards/reading.hpp"

// Welds of bricks: *DEFINE_HEX_SPOTWELD_ASSEMBLY, and *CONTROL_SPOTWELD_BEAM, which replaces weld beams by bricks.
namespace nugget::model {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

const Card assembly_card{{
    id("id_sw", IdSpace::element, required, "number of the weld in results"),
}};

constexpr Field brick(std::string_view name) {
  return id(name, IdSpace::element, 0, "a brick of the weld");
}
const Card bricks_card{{brick("eid1"), brick("eid2"), brick("eid3"), brick("eid4"), brick("eid5"), brick("eid6"),
                        brick("eid7"), brick("eid8")}};
const Card more_bricks_card{{brick("eid9"), brick("eid10"), brick("eid11"), brick("eid12"), brick("eid13"),
                             brick("eid14"), brick("eid15"), brick("eid16")}};

const Card weld_beam_card{{
    id("lct", IdSpace::function, 0, "curve: factor on the response in tension over the size of the shell tied to"),
    id("lcs", IdSpace::function, 0, "curve: factor on the response in shear over the size of the shell tied to"),
    id("t_ort", IdSpace::function, 0, "table: factor over the place on the shell"),
    integer("prtflg", 0, between(0, 1), "1: list the welds and these factors in run.log"),
    id("t_ors", IdSpace::function, 0, "table: factor over the place on the shell, in shear"),
    integer("rpbhx", 0, any_value, "replace each weld beam by 1, 4 or 8 bricks; 0: do not"),
    id("bmsid", IdSpace::set, 0, "set of the beams to be replaced; 0: all weld beams"),
    integer("id_off", 0, any_value, "offset of the new ids of parts whose beams stay; 0: the next free id"),
}};

/// The bricks of a row, one a field that is not blank.
void take_bricks(Builder& b, const Row& row, int first, std::vector<Index>& solids) {
  for (int i = first; i < first + 8; ++i) {
    const std::string field = fmt::format("eid{}", i);
    if (row.integer(field) == 0) continue;
    const Index e = b.solid(row, field);
    if (e == none) continue;
    const auto& m = b.model;
    const Index part = m.solids.part[static_cast<std::size_t>(e)];
    const Index material = m.parts[static_cast<std::size_t>(part)].material;
    const bool is_weld = material != none && m.materials[static_cast<std::size_t>(material)].weld != none;
    const bool same_part = solids.empty() || m.solids.part[static_cast<std::size_t>(solids.front())] == part;
    const auto has = [e](const HexAssembly& a) {
      return std::find(a.solids.begin(), a.solids.end(), e) != a.solids.end();
    };
    if (!is_weld)
      refuse(b, row, field, "the brick is not of *MAT_SPOTWELD", "give its part *MAT_SPOTWELD, or remove it here");
    else if (!same_part)
      refuse(b, row, field, "the brick is of another part than the first of its assembly",
             "give all bricks of a weld one part");
    else if (std::find(solids.begin(), solids.end(), e) != solids.end() ||
             std::any_of(m.hex_assemblies.begin(), m.hex_assemblies.end(), has))
      refuse(b, row, field, "the brick belongs to an assembly already", "name each brick once");
    else
      solids.push_back(e);
  }
}

void read_assembly(Builder& b, const Block& block, const Options& options) {
  int wanted = 0;
  for (const int n : {4, 8, 16})
    if (options.contains(std::to_string(n))) wanted = n;
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    const Row head = cursor.read(assembly_card);
    std::vector<Row> rows{cursor.read(bricks_card)};
    if (wanted == 16) rows.push_back(cursor.read(more_bricks_card));
    b.later(Phase::conditions, [head, rows, wanted](Builder& later) {
      HexAssembly assembly{head.integer("id_sw"), {}, {}, {none, none}, head.place()};
      const int errors = later.findings.errors();
      int first = 1;
      for (const Row& row : rows) {
        take_bricks(later, row, first, assembly.solids);
        first += 8;
      }
      const auto count = static_cast<int>(assembly.solids.size());
      if (later.findings.errors() > errors) return;
      if (count == 0 || (wanted > 0 && count != wanted))
        return refuse(later, rows[0], "eid1",
                      wanted > 0 ? fmt::format("{} bricks are named, expected {}", count, wanted) : "no brick is named",
                      "name the bricks of the weld");
      later.model.hex_assemblies.push_back(std::move(assembly));
    });
  }
}

void read_weld_beam(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const Row row = cursor.read(weld_beam_card);
  expect_end(b, cursor);
  const int bricks = row.integer("rpbhx");
  if (bricks != 0 && bricks != 1 && bricks != 4 && bricks != 8)
    return refuse(b, row, "rpbhx", "expected 0, 1, 4 or 8", "assemblies of 16 bricks have to stand in the deck");
  for (const auto* field : {"t_ort", "t_ors"})
    refuse_nonzero(b, row, field,
                   "factors over the place of a weld on its shell are not built: how LS-DYNA measures "
                   "that place is not public",
                   "leave it 0; LCT and LCS, factors over the shell's size, are obeyed");
  b.later(Phase::conditions, [row, bricks](Builder& later) {
    WeldBeamControl& c = later.model.control.weld_beams;
    c.tension_curve = later.curve(row, "lct");
    c.shear_curve = later.curve(row, "lcs");
    c.list = row.integer("prtflg") == 1;
    c.bricks = bricks;
    c.part_offset = row.integer("id_off");
    c.place = row.place();
    if (const Set<Index>* set = later.beam_set(row, "bmsid")) {
      c.only_some = true;
      c.beams = set->members;
    }
  });
}

}  // namespace

std::vector<Keyword> weld_brick_keywords() {
  return {
      {.name = "DEFINE_HEX_SPOTWELD_ASSEMBLY",
       .options = {"4", "8", "16"},
       .layout = {{"", &assembly_card}, {"", &bricks_card}, {"with _16", &more_bricks_card}},
       .read = read_assembly},
      {.name = "CONTROL_SPOTWELD_BEAM", .layout = {{"", &weld_beam_card}}, .read = read_weld_beam},
  };
}

}  // namespace nugget::model
