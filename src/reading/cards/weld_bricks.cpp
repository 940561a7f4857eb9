// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// Welds of bricks: *DEFINE_HEX_SPOTWELD_ASSEMBLY, and *CONTROL_SPOTWELD_BEAM, which replaces weld beams by bricks.
namespace nugget::reading {

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
    id("t_ort", IdSpace::function, 0, "table: factor over the place on the shell; in shear too where T_ORS is 0"),
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
    b.defer(Phase::conditions, [head, rows, wanted](Builder& later) {
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

bool positive(Builder& b, const Row& row, std::string_view field, const Curve& factor) {
  if (factor.empty() || *std::min_element(factor.y.begin(), factor.y.end()) > 0.0) return true;
  refuse(b, row, field, fmt::format("curve {} has a factor that is not above 0", factor.id),
         "give factors on the strength of the weld; 1 changes nothing");
  return false;
}

Index size_factor(Builder& b, const Row& row, std::string_view field) {
  const Index c = b.curve(row, field);
  return c != none && positive(b, row, field, b.model.curves[static_cast<std::size_t>(c)]) ? c : none;
}

/// LS-DYNA's documents name the two axes of T_ORT but not which is the table's and which the curves': angles go on to
/// 45 degrees, places to 1.
PlaceFactor place_factor(Builder& b, const Row& row, std::string_view field) {
  PlaceFactor factor{b.table_with_curves(b.find(b.tables, "table", row, field)), false};
  if (!factor.table.given()) return {};
  constexpr double farthest_place = 1.05;  // a weld may be tied a little beyond the border
  for (const Curve& curve : factor.table.curve) {
    if (curve.empty() || !positive(b, row, field, curve)) return {};
    factor.curves_over_angle |= curve.x.back() > farthest_place;
  }
  const bool values_are_angles = factor.table.value.back() > farthest_place;
  if (values_are_angles != factor.curves_over_angle) return factor;
  refuse(b, row, field,
         fmt::format("table {}: its values and the abscissae of its curves {} reach beyond 1, so that it is not known "
                     "which are angles",
                     factor.table.id, values_are_angles ? "both" : "do not"),
         "give angles from 0 to 45 degrees on one of the axes, places from 0 (middle of the shell) to 1 (its border) "
         "on the other");
  return {};
}

void read_weld_beam(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const Row row = cursor.read(weld_beam_card);
  expect_end(b, cursor);
  const int bricks = row.integer("rpbhx");
  if (bricks != 0 && bricks != 1 && bricks != 4 && bricks != 8)
    return refuse(b, row, "rpbhx", "expected 0, 1, 4 or 8", "assemblies of 16 bricks have to stand in the deck");
  if (bricks > 0)
    for (const auto* field : {"t_ort", "t_ors"})
      refuse_nonzero(b, row, field, "the nodes of the bricks of RPBHX stand on more than one place of a shell",
                     "leave it 0, or keep the beams (RPBHX 0)");
  b.defer(Phase::conditions, [row, bricks](Builder& later) {
    WeldBeamControl& c = later.model.control.weld_beams;
    c.tension_curve = size_factor(later, row, "lct");
    c.shear_curve = size_factor(later, row, "lcs");
    c.tension_place = place_factor(later, row, "t_ort");
    c.shear_place = row.integer("t_ors") == 0 ? c.tension_place : place_factor(later, row, "t_ors");
    c.list = row.integer("prtflg") == 1;
    c.bricks = bricks;
    c.part_offset = row.integer("id_off");
    c.place = row.place();
    if (const Set<Index>* set = later.beam_set(row, "bmsid")) {
      c.only_listed = true;
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

}  // namespace nugget::reading
