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
using deck::RowOf;

struct AssemblyCard {
  int id_sw = 0;
};
const CardOf<AssemblyCard> assembly_card{
    {&AssemblyCard::id_sw, id("id_sw", IdSpace::element, required, "number of the weld in results")},
};

constexpr IntegerField brick(std::string_view name) {
  return id(name, IdSpace::element, 0, "a brick of the weld");
}
struct BricksCard {
  std::array<int, 8> eid{};
};
CardOf<BricksCard> eight_bricks(const std::array<std::string_view, 8>& names) {
  CardOf<BricksCard> card;
  for (std::size_t i = 0; i < 8; ++i) card.add({at(&BricksCard::eid, i), brick(names[i])});
  return card;
}
const CardOf<BricksCard> bricks_card = eight_bricks({"eid1", "eid2", "eid3", "eid4", "eid5", "eid6", "eid7", "eid8"});
const CardOf<BricksCard> more_bricks_card =
    eight_bricks({"eid9", "eid10", "eid11", "eid12", "eid13", "eid14", "eid15", "eid16"});

struct WeldBeamCard {
  int lct = 0, lcs = 0, t_ort = 0, prtflg = 0, t_ors = 0, rpbhx = 0, bmsid = 0, id_off = 0;
};
const CardOf<WeldBeamCard> weld_beam_card{
    {&WeldBeamCard::lct,
     id("lct", IdSpace::function, 0, "curve: factor on the response in tension over the size of the shell tied to")},
    {&WeldBeamCard::lcs,
     id("lcs", IdSpace::function, 0, "curve: factor on the response in shear over the size of the shell tied to")},
    {&WeldBeamCard::t_ort,
     id("t_ort", IdSpace::function, 0, "table: factor over the place on the shell; in shear too where T_ORS is 0")},
    {&WeldBeamCard::prtflg, integer("prtflg", 0, between(0, 1), "1: list the welds and these factors in run.log")},
    {&WeldBeamCard::t_ors, id("t_ors", IdSpace::function, 0, "table: factor over the place on the shell, in shear")},
    {&WeldBeamCard::rpbhx, integer("rpbhx", 0, any_value, "replace each weld beam by 1, 4 or 8 bricks; 0: do not")},
    {&WeldBeamCard::bmsid, id("bmsid", IdSpace::set, 0, "set of the beams to be replaced; 0: all weld beams")},
    {&WeldBeamCard::id_off,
     integer("id_off", 0, any_value, "offset of the new ids of parts whose beams stay; 0: the next free id")},
};

/// The bricks of a row, one a field that is not blank.
void take_bricks(Builder& b, const RowOf<BricksCard>& row, std::vector<Index>& solids) {
  for (std::size_t i = 0; i < 8; ++i) {
    const deck::Entry field = row[at(&BricksCard::eid, i)];
    if (row->eid[i] == 0) continue;
    const Index e = b.solid(field);
    if (e == none) continue;
    const auto& m = b.model;
    const Index part = m.solids.part[e];
    const Index material = m.parts[part].material;
    const bool is_weld = material != none && m.materials[material].weld != none;
    const bool same_part = solids.empty() || m.solids.part[solids.front()] == part;
    const auto has = [e](const HexAssembly& a) {
      return std::find(a.solids.begin(), a.solids.end(), e) != a.solids.end();
    };
    if (!is_weld)
      refuse(b, field, "the brick is not of *MAT_SPOTWELD", "give its part *MAT_SPOTWELD, or remove it here");
    else if (!same_part)
      refuse(b, field, "the brick is of another part than the first of its assembly",
             "give all bricks of a weld one part");
    else if (std::find(solids.begin(), solids.end(), e) != solids.end() ||
             std::any_of(m.hex_assemblies.begin(), m.hex_assemblies.end(), has))
      refuse(b, field, "the brick belongs to an assembly already", "name each brick once");
    else
      solids.push_back(e);
  }
}

void read_assembly(Builder& b, const Block& block, const Options& options) {
  int wanted = 0;
  for (const int n : {4, 8, 16})
    if (options.contains(std::to_string(n))) wanted = n;
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  while (!at_end(cursor)) {
    const auto head = cursor.read(assembly_card);
    std::vector<RowOf<BricksCard>> rows{cursor.read(bricks_card)};
    if (wanted == 16) rows.push_back(cursor.read(more_bricks_card));
    b.defer(Phase::conditions, [head, rows, wanted](Builder& later) {
      HexAssembly assembly{head->id_sw, {}, {}, {none, none}, head.place()};
      const int errors = later.findings.errors();
      for (const auto& row : rows) take_bricks(later, row, assembly.solids);
      const auto count = static_cast<int>(assembly.solids.size());
      if (later.findings.errors() > errors) return;
      if (count == 0 || (wanted > 0 && count != wanted))
        return refuse(later, rows[0][at(&BricksCard::eid, 0)],
                      wanted > 0 ? fmt::format("{} bricks are named, expected {}", count, wanted) : "no brick is named",
                      "name the bricks of the weld");
      later.model.hex_assemblies.push_back(std::move(assembly));
    });
  }
}

bool positive(Builder& b, const deck::Entry& field, const Curve& factor) {
  if (factor.empty() || *std::min_element(factor.y.begin(), factor.y.end()) > 0.0) return true;
  refuse(b, field, fmt::format("curve {} has a factor that is not above 0", factor.id),
         "give factors on the strength of the weld; 1 changes nothing");
  return false;
}

Index size_factor(Builder& b, const deck::Entry& field) {
  const Index c = b.curve(field);
  return c != none && positive(b, field, b.model.curves[c]) ? c : none;
}

/// LS-DYNA's documents name the two axes of T_ORT but not which is the table's and which the curves': angles go on to
/// 45 degrees, places to 1.
PlaceFactor place_factor(Builder& b, const deck::Entry& field) {
  PlaceFactor factor{b.table_with_curves(b.find(b.tables, "table", field)), false};
  if (!factor.table.given()) return {};
  constexpr double farthest_place = 1.05;  // a weld may be tied a little beyond the border
  for (const Curve& curve : factor.table.curve) {
    if (curve.empty() || !positive(b, field, curve)) return {};
    factor.curves_over_angle |= curve.x.back() > farthest_place;
  }
  const bool values_are_angles = factor.table.value.back() > farthest_place;
  if (values_are_angles != factor.curves_over_angle) return factor;
  refuse(b, field,
         fmt::format("table {}: its values and the abscissae of its curves {} reach beyond 1, so that it is not known "
                     "which are angles",
                     factor.table.id, values_are_angles ? "both" : "do not"),
         "give angles from 0 to 45 degrees on one of the axes, places from 0 (middle of the shell) to 1 (its border) "
         "on the other");
  return {};
}

void read_weld_beam(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const auto row = cursor.read(weld_beam_card);
  expect_end(b, cursor);
  const int bricks = row->rpbhx;
  if (bricks != 0 && bricks != 1 && bricks != 4 && bricks != 8)
    return refuse(b, row[&WeldBeamCard::rpbhx], "expected 0, 1, 4 or 8",
                  "assemblies of 16 bricks have to stand in the deck");
  if (bricks > 0)
    for (const deck::Entry& field : {row[&WeldBeamCard::t_ort], row[&WeldBeamCard::t_ors]})
      refuse_nonzero(b, field, "the nodes of the bricks of RPBHX stand on more than one place of a shell",
                     "leave it 0, or keep the beams (RPBHX 0)");
  b.defer(Phase::conditions, [row, bricks](Builder& later) {
    WeldBeamControl& c = later.model.control.weld_beams;
    c.tension_curve = size_factor(later, row[&WeldBeamCard::lct]);
    c.shear_curve = size_factor(later, row[&WeldBeamCard::lcs]);
    c.tension_place = place_factor(later, row[&WeldBeamCard::t_ort]);
    c.shear_place = row->t_ors == 0 ? c.tension_place : place_factor(later, row[&WeldBeamCard::t_ors]);
    c.list = row->prtflg == 1;
    c.bricks = bricks;
    c.part_offset = row->id_off;
    c.place = row.place();
    if (const Set<Index>* set = later.beam_set(row[&WeldBeamCard::bmsid])) {
      c.only_listed = true;
      c.beams = set->members;
    }
  });
}

}  // namespace

std::vector<Keyword> weld_brick_keywords() {
  return {
      {.name = "DEFINE_HEX_SPOTWELD_ASSEMBLY",
       .options = {"4", "8", "16", "TITLE"},
       .layout = {{"", &assembly_card}, {"", &bricks_card}, {"with _16", &more_bricks_card}},
       .read = read_assembly},
      {.name = "CONTROL_SPOTWELD_BEAM", .layout = {{"", &weld_beam_card}}, .read = read_weld_beam},
  };
}

}  // namespace nugget::reading
