// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// The *DEFINE_ cards that belong to *MAT_SPOTWELD: strengths by sheet, by pair of sheets and by load rate, connection
// properties.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

const Card rupture_stress_card{{
    id("pid", IdSpace::part, required, "part of a sheet"),
    real("srsig", dimension::stress, 0, at_least(0), "axial stress at failure; 0: left out"),
    real("sigtau", dimension::stress, 0, at_least(0), "shear stress at failure; 0: left out"),
}};

const Card pair_default_card{{
    id("id", IdSpace::define, 0, "number of this table"),
    real("dsn", dimension::stress, 0, at_least(0), "axial stress at failure of pairs that are not listed; 0: left out"),
    real("dss", dimension::stress, 0, at_least(0), "shear stress at failure of them; 0: left out"),
    id("dlcidsn", IdSpace::function, 0, "curve: factor on DSN over the strain rate"),
    id("dlcidss", IdSpace::function, 0, "curve: factor on DSS over the strain rate"),
}};

const Card pair_card{{
    id("pid_i", IdSpace::part, required, "part of one sheet"),
    id("pid_j", IdSpace::part, required, "part of the other"),
    real("snij", dimension::stress, 0, at_least(0), "axial stress at failure; 0: left out"),
    real("ssij", dimension::stress, 0, at_least(0), "shear stress at failure; 0: left out"),
    id("lcidsnij", IdSpace::function, 0, "curve: factor on SNIJ over the strain rate"),
    id("lcidssij", IdSpace::function, 0, "curve: factor on SSIJ over the strain rate"),
}};

const Card load_rate_card{{
    id("id", IdSpace::define, required, "number of this table, FVAL of *MAT_SPOTWELD"),
    integer("tflag", 0, between(0, 3), "thickness: 0 thinner sheet, 1 mean, 2 thicker sheet, 3 sum"),
    real("dc1", dimension::number, 1.183, any_value, "dynamic coefficient: constant"),
    real("dc2", dimension::number, 0.002963, any_value, "dynamic coefficient of the rate of the force"),
    real("dc3", dimension::number, 0.0458, any_value, "dynamic coefficient of its logarithm"),
    real("dc4", {1, 1, -3}, 0.1, above_zero(), "rate of the force by which that rate is divided"),
    real("exn", dimension::number, 2, above_zero(), "exponent of the normal term"),
    real("exs", dimension::number, 2, above_zero(), "exponent of the shear term"),
}};

const Card load_rate_default_card{{
    integer("navg", 0, at_least(0), "load rates averaged"),
    real("d_sn", dimension::stress, 0, at_least(0), "normal stress at failure of sheets that are not listed"),
    real("d_ss", dimension::stress, 0, at_least(0), "shear stress at failure of them"),
    real("r_sult", dimension::stress, 0, only(0), "reference strength; its use is not public"),
    real("tscale", dimension::number, 1, above_zero(), "factor on the thickness"),
}};

const Card load_rate_material_card{{
    id("mid", IdSpace::material, required, "material of a sheet"),
    real("sn", dimension::stress, 0, at_least(0), "normal stress at failure; 0: left out"),
    real("ss", dimension::stress, 0, at_least(0), "shear stress at failure; 0: left out"),
}};

const Card load_rate_pair_card{{
    id("pid1", IdSpace::part, required, "part of one sheet"),
    id("pid2", IdSpace::part, required, "part of the other"),
    real("sn", dimension::stress, 0, at_least(0), "normal stress at failure; 0: left out"),
    real("ss", dimension::stress, 0, at_least(0), "shear stress at failure; 0: left out"),
}};

const Card load_rate_add_card{{id("id", IdSpace::define, required, "table to which materials are added")}};

const Card connection_card{{
    id("con_id", IdSpace::define, required, "number of this connection"),
    integer("proprul", 0, between(0, 1), "which sheet counts: 0 and 1 that of lower rank; functions are not built"),
    integer("areaeq", 0, between(-1, 1), "area: 0 as modelled, 1 of diameter 5 sqrt(t) in mm, -1 the same in m"),
    unused(),
    integer("dgtyp", 0, between(0, 5), "damage: 0 none, 1 by strain, 2 by failure value, 3 4 5 by fading energy"),
    integer("moarfl", 0, between(0, 1), "modelled area: 0 falls with shear, 1 is constant"),
}};

const Card connection_default_card{{
    unused(),
    real("dsigy", dimension::stress, 0, at_least(0), "yield stress"),
    real("detan", dimension::stress, 0, at_least(0), "tangent modulus"),
    real("ddg_pr", dimension::number, 1e10, at_least(0), "damage parameter of DGTYP 1"),
    real("drank", dimension::number, 0, any_value, "rank of sheets that are not listed"),
    real("dsn", dimension::stress, 0, at_least(0), "normal stress at failure; 0: left out"),
    real("dsb", dimension::stress, 0, at_least(0), "bending stress at failure; 0: left out"),
    real("dss", dimension::stress, 0, at_least(0), "shear stress at failure; 0: left out"),
}};

const Card connection_default_more_card{{
    real("dexsn", dimension::number, 1, above_zero(), "exponent of the normal term"),
    real("dexsb", dimension::number, 1, above_zero(), "exponent of the bending term"),
    real("dexss", dimension::number, 1, above_zero(), "exponent of the shear term"),
    id("dlcsn", IdSpace::function, 0, "curve: factor on DSN over the strain rate"),
    id("dlcsb", IdSpace::function, 0, "curve: factor on DSB over the strain rate"),
    id("dlcss", IdSpace::function, 0, "curve: factor on DSS over the strain rate"),
    real("dgfad", {1, 2, -2}, 0, at_least(0), "fading energy of DGTYP 3 4 5"),
    real("dsclmrr", dimension::number, 1, at_least(0), "factor on the torsion"),
}};

const Card connection_material_card{{
    id("mid", IdSpace::material, required, "material of a sheet"),
    real("sigy", dimension::stress, 0, at_least(0), "yield stress"),
    real("etan", dimension::stress, 0, at_least(0), "tangent modulus"),
    real("dg_pr", dimension::number, 1e10, at_least(0), "damage parameter of DGTYP 1"),
    real("rank", dimension::number, 0, any_value, "rank: of two sheets the lower counts"),
    real("sn", dimension::stress, 0, at_least(0), "normal stress at failure; 0: left out"),
    real("sb", dimension::stress, 0, at_least(0), "bending stress at failure; 0: left out"),
    real("ss", dimension::stress, 0, at_least(0), "shear stress at failure; 0: left out"),
}};

const Card connection_material_more_card{{
    real("exsn", dimension::number, 1, above_zero(), "exponent of the normal term"),
    real("exsb", dimension::number, 1, above_zero(), "exponent of the bending term"),
    real("exss", dimension::number, 1, above_zero(), "exponent of the shear term"),
    id("lcsn", IdSpace::function, 0, "curve: factor on SN over the strain rate"),
    id("lcsb", IdSpace::function, 0, "curve: factor on SB over the strain rate"),
    id("lcss", IdSpace::function, 0, "curve: factor on SS over the strain rate"),
    real("gfad", {1, 2, -2}, 0, at_least(0), "fading energy of DGTYP 3 4 5"),
    real("sclmrr", dimension::number, 1, at_least(0), "factor on the torsion"),
}};

RateValue rate_value(Builder& b, const Row& row, std::string_view value, std::string_view curve) {
  RateValue strength{row.real(value), {}};
  if (const Index c = b.curve(row, curve); c != none) strength.factor = b.model.curves[static_cast<std::size_t>(c)];
  return strength;
}

// Parts, materials and curves may be defined later in the deck: all of these tables are made in Phase::curves, before
// the materials' own turn.

void read_rupture_stress(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  while (!at_end(cursor)) {
    const Row row = cursor.read(rupture_stress_card);
    b.defer(Phase::curves, [row](Builder& later) {
      if (const Index part = later.part(row, "pid"); part != none)
        later.model.rupture_stresses.push_back({part, row.real("srsig"), row.real("sigtau")});
    });
  }
}

std::vector<Row> rest_of(Cursor& cursor, const Card& card) {
  std::vector<Row> rows;
  while (!at_end(cursor)) rows.push_back(cursor.read(card));
  return rows;
}

/// Adds an empty table under the id of its first card.
template <class Table>
Table* add_table(Builder& b, std::vector<Table>& tables, Ids& ids, const Row& row, std::string_view id,
                 std::string_view what) {
  if (!ids.add(row.integer(id), static_cast<Index>(tables.size()), row.place(), row.keyword(), what, b.findings))
    return nullptr;
  Table& table = tables.emplace_back();
  table.id = row.integer(id);
  table.place = row.place();
  return &table;
}

void read_pair_strengths(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const Row first = cursor.read(pair_default_card);
  const std::vector<Row> pairs = rest_of(cursor, pair_card);
  b.defer(Phase::curves, [first, pairs](Builder& later) {
    PairStrengths* table =
        add_table(later, later.model.pair_strengths, later.pair_strengths, first, "id", "table of pairs");
    if (!table) return;
    table->standard = {
        {none, none}, rate_value(later, first, "dsn", "dlcidsn"), rate_value(later, first, "dss", "dlcidss")};
    for (const Row& row : pairs)
      table->pairs.push_back({{later.part(row, "pid_i"), later.part(row, "pid_j")},
                              rate_value(later, row, "snij", "lcidsnij"),
                              rate_value(later, row, "ssij", "lcidssij")});
  });
}

LoadRateStrengths::Entry load_rate_entry(Builder& b, const Row& row, bool by_pair) {
  LoadRateStrengths::Entry entry;
  entry.normal = row.real("sn");
  entry.shear = row.real("ss");
  if (by_pair)
    entry.parts = {b.part(row, "pid1"), b.part(row, "pid2")};
  else
    entry.material = b.find(b.materials, "material", row, "mid");
  return entry;
}

void read_load_rate(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const bool by_pair = options.contains("PID");
  const Row first = cursor.read(load_rate_card), second = cursor.read(load_rate_default_card);
  const std::vector<Row> rows = rest_of(cursor, by_pair ? load_rate_pair_card : load_rate_material_card);
  b.defer(Phase::curves, [first, second, rows, by_pair](Builder& later) {
    LoadRateStrengths* table = add_table(later, later.model.load_rate_strengths, later.load_rate_strengths, first, "id",
                                         "table of weld strengths");
    if (!table) return;
    table->thickness_rule = first.integer("tflag");
    table->dynamic = {first.real("dc1"), first.real("dc2"), first.real("dc3"), first.real("dc4")};
    table->normal_exponent = first.real("exn");
    table->shear_exponent = first.real("exs");
    table->averaged = second.integer("navg");
    table->normal = second.real("d_sn");
    table->shear = second.real("d_ss");
    table->reference = second.real("r_sult");
    table->thickness_scale = second.real("tscale");
    for (const Row& row : rows) table->entries.push_back(load_rate_entry(later, row, by_pair));
  });
}

void read_load_rate_add(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const Row first = cursor.read(load_rate_add_card);
  const std::vector<Row> rows = rest_of(cursor, load_rate_material_card);
  // One phase later than the tables themselves.
  b.defer(Phase::mesh, [first, rows](Builder& later) {
    const Index table = later.find(later.load_rate_strengths, "*DEFINE_SPOTWELD_FAILURE", first, "id");
    if (table == none) return;
    for (const Row& row : rows)
      later.model.load_rate_strengths[static_cast<std::size_t>(table)].entries.push_back(
          load_rate_entry(later, row, false));
  });
}

struct MaterialRows {
  Row strength, more;
};

std::vector<MaterialRows> material_rows(Cursor& cursor) {
  std::vector<MaterialRows> rows;
  while (!at_end(cursor)) {
    Row strength = cursor.read(connection_material_card);
    rows.push_back({std::move(strength), cursor.read(connection_material_more_card)});
  }
  return rows;
}

/// A record; the default's fields are the material's with a D before them.
ConnectionProperties::Record record(Builder& b, const Row& first, const Row& more, bool of_default) {
  const auto name = [of_default](const char* field) { return fmt::format("{}{}", of_default ? "d" : "", field); };
  ConnectionProperties::Record r;
  r.yield = first.real(name("sigy"));
  r.tangent_modulus = first.real(name("etan"));
  r.damage_parameter = first.real(name("dg_pr"));
  r.rank = first.real(name("rank"));
  const auto strength = [&](const char* value, const char* curve) {
    RateValue v{first.real(name(value)), {}};
    if (const Index c = b.curve(more, name(curve)); c != none) v.factor = b.model.curves[static_cast<std::size_t>(c)];
    return v;
  };
  r.normal = strength("sn", "lcsn");
  r.bending = strength("sb", "lcsb");
  r.shear = strength("ss", "lcss");
  r.normal_exponent = more.real(name("exsn"));
  r.bending_exponent = more.real(name("exsb"));
  r.shear_exponent = more.real(name("exss"));
  r.fading_energy = more.real(name("gfad"));
  r.torsion_factor = more.real(name("sclmrr"));
  if (!of_default) r.material = b.find(b.materials, "material", first, "mid");
  return r;
}

/// DG_PR: how it bends the damage of DGTYP 1 is not public.
void warn_of_hyperbola(Builder& b, const Row& row, std::string_view field) {
  if (row.real(field) != 1e10)
    row.report(b.findings, Severity::warning, field, "hyperbolic damage is not public: the damage is linear",
               "leave it blank");
}

void read_connection(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const Row first = cursor.read(connection_card), second = cursor.read(connection_default_card),
            third = cursor.read(connection_default_more_card);
  const std::vector<MaterialRows> rows = material_rows(cursor);
  b.defer(Phase::curves, [=](Builder& later) {
    ConnectionProperties* table =
        add_table(later, later.model.connections, later.connections, first, "con_id", "connection");
    if (!table) return;
    table->rule = first.integer("proprul");
    table->area_rule = first.integer("areaeq");
    table->damage_type = first.integer("dgtyp");
    table->area_change = first.integer("moarfl");
    table->standard = record(later, second, third, true);
    for (const MaterialRows& row : rows) table->records.push_back(record(later, row.strength, row.more, false));
    if (table->damage_type != 1) return;
    warn_of_hyperbola(later, second, "ddg_pr");
    for (const MaterialRows& row : rows) warn_of_hyperbola(later, row.strength, "dg_pr");
  });
}

void read_connection_add(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const Row first = cursor.read(connection_card);
  const std::vector<MaterialRows> rows = material_rows(cursor);
  // One phase later than the connections themselves.
  b.defer(Phase::mesh, [first, rows](Builder& later) {
    const Index table = later.find(later.connections, "*DEFINE_CONNECTION_PROPERTIES", first, "con_id");
    if (table == none) return;
    for (const MaterialRows& row : rows)
      later.model.connections[static_cast<std::size_t>(table)].records.push_back(
          record(later, row.strength, row.more, false));
  });
}

}  // namespace

std::vector<Keyword> weld_table_keywords() {
  return {
      {.name = "DEFINE_SPOTWELD_RUPTURE_STRESS",
       .options = {"TITLE"},
       .layout = {{"repeated", &rupture_stress_card}},
       .read = read_rupture_stress},
      {.name = "DEFINE_SPOTWELD_FAILURE_RESULTANTS",
       .options = {"TITLE"},
       .layout = {{"", &pair_default_card}, {"repeated", &pair_card}},
       .read = read_pair_strengths},
      {.name = "DEFINE_SPOTWELD_FAILURE",
       .options = {"PID", "TITLE"},
       .layout = {{"", &load_rate_card},
                  {"", &load_rate_default_card},
                  {"repeated, without _PID", &load_rate_material_card},
                  {"repeated, with _PID", &load_rate_pair_card}},
       .read = read_load_rate},
      {.name = "DEFINE_SPOTWELD_FAILURE_ADD",
       .options = {"TITLE"},
       .layout = {{"", &load_rate_add_card}, {"repeated", &load_rate_material_card}},
       .read = read_load_rate_add},
      {.name = "DEFINE_CONNECTION_PROPERTIES",
       .options = {"TITLE"},
       .layout = {{"", &connection_card},
                  {"", &connection_default_card},
                  {"", &connection_default_more_card},
                  {"repeated with the next", &connection_material_card},
                  {"repeated with the last", &connection_material_more_card}},
       .read = read_connection},
      {.name = "DEFINE_CONNECTION_PROPERTIES_ADD",
       .options = {"TITLE"},
       .layout = {{"only CON_ID counts", &connection_card},
                  {"repeated with the next", &connection_material_card},
                  {"repeated with the last", &connection_material_more_card}},
       .read = read_connection_add},
      {.name = "DEFINE_SPOTWELD_RUPTURE_PARAMETER",
       .status = KeywordStatus::refused,
       .why = "data of OPT 9 of *MAT_SPOTWELD, the formula of which is not public; use OPT 0, 1, 6 or 7"},
  };
}

}  // namespace nugget::reading
