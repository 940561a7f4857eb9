// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/weld_function.hpp"

// The *DEFINE_ cards that belong to *MAT_SPOTWELD: strengths by sheet, by pair of sheets and by load rate, connection
// properties.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;
using deck::RowOf;

struct RuptureStressCard {
  int pid = 0;
  double srsig = 0, sigtau = 0;
};
const CardOf<RuptureStressCard> rupture_stress_card{
    {&RuptureStressCard::pid, id("pid", IdSpace::part, required, "part of a sheet")},
    {&RuptureStressCard::srsig,
     real("srsig", dimension::stress, 0, at_least(0), "axial stress at failure; 0: left out")},
    {&RuptureStressCard::sigtau,
     real("sigtau", dimension::stress, 0, at_least(0), "shear stress at failure; 0: left out")},
};

struct PairDefaultCard {
  int id = 0;
  double dsn = 0, dss = 0;
  int dlcidsn = 0, dlcidss = 0;
};
const CardOf<PairDefaultCard> pair_default_card{
    {&PairDefaultCard::id, id("id", IdSpace::define, 0, "number of this table")},
    {&PairDefaultCard::dsn, real("dsn", dimension::stress, 0, at_least(0),
                                 "axial stress at failure of pairs that are not listed; 0: left out")},
    {&PairDefaultCard::dss,
     real("dss", dimension::stress, 0, at_least(0), "shear stress at failure of them; 0: left out")},
    {&PairDefaultCard::dlcidsn, id("dlcidsn", IdSpace::function, 0, "curve: factor on DSN over the strain rate")},
    {&PairDefaultCard::dlcidss, id("dlcidss", IdSpace::function, 0, "curve: factor on DSS over the strain rate")},
};

struct StrengthPairCard {
  int pid_i = 0, pid_j = 0;
  double snij = 0, ssij = 0;
  int lcidsnij = 0, lcidssij = 0;
};
const CardOf<StrengthPairCard> strength_pair_card{
    {&StrengthPairCard::pid_i, id("pid_i", IdSpace::part, required, "part of one sheet")},
    {&StrengthPairCard::pid_j, id("pid_j", IdSpace::part, required, "part of the other")},
    {&StrengthPairCard::snij, real("snij", dimension::stress, 0, at_least(0), "axial stress at failure; 0: left out")},
    {&StrengthPairCard::ssij, real("ssij", dimension::stress, 0, at_least(0), "shear stress at failure; 0: left out")},
    {&StrengthPairCard::lcidsnij, id("lcidsnij", IdSpace::function, 0, "curve: factor on SNIJ over the strain rate")},
    {&StrengthPairCard::lcidssij, id("lcidssij", IdSpace::function, 0, "curve: factor on SSIJ over the strain rate")},
};

struct LoadRateCard {
  int id = 0, tflag = 0;
  double dc1 = 0, dc2 = 0, dc3 = 0, dc4 = 0, exn = 0, exs = 0;
};
const CardOf<LoadRateCard> load_rate_card{
    {&LoadRateCard::id, id("id", IdSpace::define, required, "number of this table, FVAL of *MAT_SPOTWELD")},
    {&LoadRateCard::tflag,
     integer("tflag", 0, between(0, 3), "thickness: 0 thinner sheet, 1 mean, 2 thicker sheet, 3 sum")},
    {&LoadRateCard::dc1, real("dc1", dimension::number, 1.183, any_value, "dynamic coefficient: constant")},
    {&LoadRateCard::dc2,
     real("dc2", dimension::number, 0.002963, any_value, "dynamic coefficient of the rate of the force")},
    {&LoadRateCard::dc3, real("dc3", dimension::number, 0.0458, any_value, "dynamic coefficient of its logarithm")},
    {&LoadRateCard::dc4, real("dc4", {1, 1, -3}, 0.1, above_zero(), "rate of the force by which that rate is divided")},
    {&LoadRateCard::exn, real("exn", dimension::number, 2, above_zero(), "exponent of the normal term")},
    {&LoadRateCard::exs, real("exs", dimension::number, 2, above_zero(), "exponent of the shear term")},
};

struct LoadRateDefaultCard {
  int navg = 0;
  double d_sn = 0, d_ss = 0, r_sult = 0, tscale = 0;
};
const CardOf<LoadRateDefaultCard> load_rate_default_card{
    {&LoadRateDefaultCard::navg, integer("navg", 0, at_least(0), "load rates averaged")},
    {&LoadRateDefaultCard::d_sn,
     real("d_sn", dimension::stress, 0, at_least(0), "normal stress at failure of sheets that are not listed")},
    {&LoadRateDefaultCard::d_ss, real("d_ss", dimension::stress, 0, at_least(0), "shear stress at failure of them")},
    {&LoadRateDefaultCard::r_sult,
     real("r_sult", dimension::stress, 0, only(0), "reference strength; its use is not public")},
    {&LoadRateDefaultCard::tscale, real("tscale", dimension::number, 1, above_zero(), "factor on the thickness")},
};

struct LoadRateMaterialCard {
  int mid = 0;
  double sn = 0, ss = 0;
  int pid1 = 0, pid2 = 0;
};
const CardOf<LoadRateMaterialCard> load_rate_material_card{
    {&LoadRateMaterialCard::mid, id("mid", IdSpace::material, required, "material of a sheet")},
    {&LoadRateMaterialCard::sn, real("sn", dimension::stress, 0, at_least(0), "normal stress at failure; 0: left out")},
    {&LoadRateMaterialCard::ss, real("ss", dimension::stress, 0, at_least(0), "shear stress at failure; 0: left out")},
};

const CardOf<LoadRateMaterialCard> load_rate_pair_card{
    {&LoadRateMaterialCard::pid1, id("pid1", IdSpace::part, required, "part of one sheet")},
    {&LoadRateMaterialCard::pid2, id("pid2", IdSpace::part, required, "part of the other")},
    {&LoadRateMaterialCard::sn, real("sn", dimension::stress, 0, at_least(0), "normal stress at failure; 0: left out")},
    {&LoadRateMaterialCard::ss, real("ss", dimension::stress, 0, at_least(0), "shear stress at failure; 0: left out")},
};

struct LoadRateAddCard {
  int id = 0;
};
const CardOf<LoadRateAddCard> load_rate_add_card{
    {&LoadRateAddCard::id, id("id", IdSpace::define, required, "table to which materials are added")},
};

struct ConnectionCard {
  int con_id = 0, proprul = 0, areaeq = 0, dgtyp = 0, moarfl = 0;
};
const CardOf<ConnectionCard> connection_table_card{
    {&ConnectionCard::con_id, id("con_id", IdSpace::define, required, "number of this connection")},
    {&ConnectionCard::proprul,
     integer("proprul", 0, at_least(0),
             "which sheet counts: 0 and 1 that of lower rank; 2: DSIGY to DGFAD are functions of both")},
    {&ConnectionCard::areaeq,
     integer("areaeq", 0, between(-1, 1), "area: 0 as modelled, 1 of diameter 5 sqrt(t) in mm, -1 the same in m")},
    unused(),
    {&ConnectionCard::dgtyp,
     integer("dgtyp", 0, between(0, 5), "damage: 0 none, 1 by strain, 2 by failure value, 3 4 5 by fading energy")},
    {&ConnectionCard::moarfl, integer("moarfl", 0, between(0, 1), "modelled area: 0 falls with shear, 1 is constant")},
};

struct RecordCard {
  int mid = 0;
  double sigy = 0, etan = 0, dg_pr = 0, rank = 0, sn = 0, sb = 0, ss = 0;
};
struct MoreCard {
  double exsn = 0, exsb = 0, exss = 0;
  int lcsn = 0, lcsb = 0, lcss = 0;
  double gfad = 0, sclmrr = 0;
};
const CardOf<RecordCard> connection_default_card{
    unused(),
    {&RecordCard::sigy, real("dsigy", dimension::stress, 0, at_least(0), "yield stress")},
    {&RecordCard::etan, real("detan", dimension::stress, 0, at_least(0), "tangent modulus")},
    {&RecordCard::dg_pr, real("ddg_pr", dimension::number, 1e10, at_least(0), "damage parameter of DGTYP 1")},
    {&RecordCard::rank, real("drank", dimension::number, 0, any_value, "rank of sheets that are not listed")},
    {&RecordCard::sn, real("dsn", dimension::stress, 0, at_least(0), "normal stress at failure; 0: left out")},
    {&RecordCard::sb, real("dsb", dimension::stress, 0, at_least(0), "bending stress at failure; 0: left out")},
    {&RecordCard::ss, real("dss", dimension::stress, 0, at_least(0), "shear stress at failure; 0: left out")},
};

const CardOf<MoreCard> connection_default_more_card{
    {&MoreCard::exsn, real("dexsn", dimension::number, 1, above_zero(), "exponent of the normal term")},
    {&MoreCard::exsb, real("dexsb", dimension::number, 1, above_zero(), "exponent of the bending term")},
    {&MoreCard::exss, real("dexss", dimension::number, 1, above_zero(), "exponent of the shear term")},
    {&MoreCard::lcsn, id("dlcsn", IdSpace::function, 0, "curve: factor on DSN over the strain rate")},
    {&MoreCard::lcsb, id("dlcsb", IdSpace::function, 0, "curve: factor on DSB over the strain rate")},
    {&MoreCard::lcss, id("dlcss", IdSpace::function, 0, "curve: factor on DSS over the strain rate")},
    {&MoreCard::gfad, real("dgfad", {1, 2, -2}, 0, at_least(0), "fading energy of DGTYP 3 4 5")},
    {&MoreCard::sclmrr, real("dsclmrr", dimension::number, 1, at_least(0), "factor on the torsion")},
};

const CardOf<RecordCard> connection_material_card{
    {&RecordCard::mid, id("mid", IdSpace::material, required, "material of a sheet")},
    {&RecordCard::sigy, real("sigy", dimension::stress, 0, at_least(0), "yield stress")},
    {&RecordCard::etan, real("etan", dimension::stress, 0, at_least(0), "tangent modulus")},
    {&RecordCard::dg_pr, real("dg_pr", dimension::number, 1e10, at_least(0), "damage parameter of DGTYP 1")},
    {&RecordCard::rank, real("rank", dimension::number, 0, any_value, "rank: of two sheets the lower counts")},
    {&RecordCard::sn, real("sn", dimension::stress, 0, at_least(0), "normal stress at failure; 0: left out")},
    {&RecordCard::sb, real("sb", dimension::stress, 0, at_least(0), "bending stress at failure; 0: left out")},
    {&RecordCard::ss, real("ss", dimension::stress, 0, at_least(0), "shear stress at failure; 0: left out")},
};

const CardOf<MoreCard> connection_material_more_card{
    {&MoreCard::exsn, real("exsn", dimension::number, 1, above_zero(), "exponent of the normal term")},
    {&MoreCard::exsb, real("exsb", dimension::number, 1, above_zero(), "exponent of the bending term")},
    {&MoreCard::exss, real("exss", dimension::number, 1, above_zero(), "exponent of the shear term")},
    {&MoreCard::lcsn, id("lcsn", IdSpace::function, 0, "curve: factor on SN over the strain rate")},
    {&MoreCard::lcsb, id("lcsb", IdSpace::function, 0, "curve: factor on SB over the strain rate")},
    {&MoreCard::lcss, id("lcss", IdSpace::function, 0, "curve: factor on SS over the strain rate")},
    {&MoreCard::gfad, real("gfad", {1, 2, -2}, 0, at_least(0), "fading energy of DGTYP 3 4 5")},
    {&MoreCard::sclmrr, real("sclmrr", dimension::number, 1, at_least(0), "factor on the torsion")},
};

RateValue rate_value(Builder& b, double value, const deck::Entry& curve) {
  RateValue strength{value, {}};
  if (const Index c = b.curve(curve); c != none) strength.factor = b.model.curves[c];
  return strength;
}

// Parts, materials and curves may be defined later in the deck: all of these tables are made in Phase::curves, before
// the materials' own turn.

void read_rupture_stress(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  while (!at_end(cursor)) {
    const auto row = cursor.read(rupture_stress_card);
    b.defer(Phase::curves, [row](Builder& later) {
      if (const Index part = later.part(row[&RuptureStressCard::pid]); part != none)
        later.model.rupture_stresses.push_back({part, row->srsig, row->sigtau});
    });
  }
}

template <class Values>
std::vector<RowOf<Values>> rest_of(Cursor& cursor, const CardOf<Values>& card) {
  std::vector<RowOf<Values>> rows;
  while (!at_end(cursor)) rows.push_back(cursor.read(card));
  return rows;
}

/// Adds an empty table under the id of its first card.
template <class Table>
Table* add_weld_table(Builder& b, std::vector<Table>& tables, Ids& ids, const Row& row, int id, std::string_view what) {
  if (!ids.add(id, static_cast<Index>(tables.size()), row.place(), row.keyword(), what, b.findings)) return nullptr;
  Table& table = tables.emplace_back();
  table.id = id;
  table.place = row.place();
  return &table;
}

void read_pair_strengths(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto first = cursor.read(pair_default_card);
  const auto pairs = rest_of(cursor, strength_pair_card);
  b.defer(Phase::curves, [first, pairs](Builder& later) {
    PairStrengths* table =
        add_weld_table(later, later.model.pair_strengths, later.pair_strengths, first, first->id, "table of pairs");
    if (!table) return;
    table->standard = {{none, none},
                       rate_value(later, first->dsn, first[&PairDefaultCard::dlcidsn]),
                       rate_value(later, first->dss, first[&PairDefaultCard::dlcidss])};
    for (const auto& row : pairs)
      table->pairs.push_back({{later.part(row[&StrengthPairCard::pid_i]), later.part(row[&StrengthPairCard::pid_j])},
                              rate_value(later, row->snij, row[&StrengthPairCard::lcidsnij]),
                              rate_value(later, row->ssij, row[&StrengthPairCard::lcidssij])});
  });
}

LoadRateStrengths::Entry load_rate_entry(Builder& b, const RowOf<LoadRateMaterialCard>& row, bool by_pair) {
  LoadRateStrengths::Entry entry;
  entry.normal = row->sn;
  entry.shear = row->ss;
  if (by_pair)
    entry.parts = {b.part(row[&LoadRateMaterialCard::pid1]), b.part(row[&LoadRateMaterialCard::pid2])};
  else
    entry.material = b.find(b.materials, "material", row[&LoadRateMaterialCard::mid]);
  return entry;
}

void read_load_rate(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const bool by_pair = options.contains("PID");
  const auto first = cursor.read(load_rate_card);
  const auto second = cursor.read(load_rate_default_card);
  const auto rows = rest_of(cursor, by_pair ? load_rate_pair_card : load_rate_material_card);
  b.defer(Phase::curves, [first, second, rows, by_pair](Builder& later) {
    LoadRateStrengths* table = add_weld_table(later, later.model.load_rate_strengths, later.load_rate_strengths, first,
                                              first->id, "table of weld strengths");
    if (!table) return;
    table->thickness_rule = first->tflag;
    table->dynamic = {first->dc1, first->dc2, first->dc3, first->dc4};
    table->normal_exponent = first->exn;
    table->shear_exponent = first->exs;
    table->averaged = second->navg;
    table->normal = second->d_sn;
    table->shear = second->d_ss;
    table->reference = second->r_sult;
    table->thickness_scale = second->tscale;
    for (const auto& row : rows) table->entries.push_back(load_rate_entry(later, row, by_pair));
  });
}

void read_load_rate_add(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto first = cursor.read(load_rate_add_card);
  const auto rows = rest_of(cursor, load_rate_material_card);
  // One phase later than the tables themselves.
  b.defer(Phase::mesh, [first, rows](Builder& later) {
    const Index table = later.find(later.load_rate_strengths, "*DEFINE_SPOTWELD_FAILURE", first[&LoadRateAddCard::id]);
    if (table == none) return;
    for (const auto& row : rows)
      later.model.load_rate_strengths[table].entries.push_back(load_rate_entry(later, row, false));
  });
}

struct MaterialRows {
  RowOf<RecordCard> strength;
  RowOf<MoreCard> more;
};

std::vector<MaterialRows> material_rows(Cursor& cursor) {
  std::vector<MaterialRows> rows;
  while (!at_end(cursor)) {
    auto strength = cursor.read(connection_material_card);
    rows.push_back({std::move(strength), cursor.read(connection_material_more_card)});
  }
  return rows;
}

/// A record; the default has no material.
ConnectionProperties::Record record(Builder& b, const RowOf<RecordCard>& first, const RowOf<MoreCard>& more,
                                    bool of_default) {
  ConnectionProperties::Record r;
  r.yield = first->sigy;
  r.tangent_modulus = first->etan;
  r.damage_parameter = first->dg_pr;
  r.rank = first->rank;
  r.normal = rate_value(b, first->sn, more[&MoreCard::lcsn]);
  r.bending = rate_value(b, first->sb, more[&MoreCard::lcsb]);
  r.shear = rate_value(b, first->ss, more[&MoreCard::lcss]);
  r.normal_exponent = more->exsn;
  r.bending_exponent = more->exsb;
  r.shear_exponent = more->exss;
  r.fading_energy = more->gfad;
  r.torsion_factor = more->sclmrr;
  if (!of_default) r.material = b.find(b.materials, "material", first[&RecordCard::mid]);
  return r;
}

/// DG_PR: how it bends the damage of DGTYP 1 is not public.
void warn_of_hyperbola(Builder& b, const RowOf<RecordCard>& row) {
  if (row->dg_pr != 1e10)
    row[&RecordCard::dg_pr].report(b.findings, Severity::warning,
                                   "hyperbolic damage is not public: the damage is linear", "leave it blank");
}

/// PROPRUL 2: the function of both sheets that stands in place of a number; none where the field is blank.
template <class Values, class Member>
Index function_of_both_sheets(Builder& b, const RowOf<Values>& row, Member field) {
  const deck::Entry& entry = row[field];
  return entry.blank ? none : weld_function(b, entry);
}

/// A number that holds for the whole run.
template <class Values, class Member>
Index function_without_rate(Builder& b, const RowOf<Values>& row, Member field) {
  const Index function = function_of_both_sheets(b, row, field);
  if (function != none && b.model.functions[function].formula.uses(model::rate_argument))
    refuse(b, row[field], "it depends on the strain rate r, and would change during the run: not built",
           "let only DSN, DSB and DSS depend on r");
  return function;
}

ConnectionProperties::Functions functions_of_both_sheets(Builder& b, const RowOf<RecordCard>& first,
                                                         const RowOf<MoreCard>& more) {
  for (const auto curve : {&MoreCard::lcsn, &MoreCard::lcsb, &MoreCard::lcss})
    refuse_nonzero(b, more[curve], "with PROPRUL 2 the strain rate is an argument of the functions", "leave it blank");
  return {.yield = function_without_rate(b, first, &RecordCard::sigy),
          .tangent_modulus = function_without_rate(b, first, &RecordCard::etan),
          .normal = function_of_both_sheets(b, first, &RecordCard::sn),
          .bending = function_of_both_sheets(b, first, &RecordCard::sb),
          .shear = function_of_both_sheets(b, first, &RecordCard::ss),
          .normal_exponent = function_without_rate(b, more, &MoreCard::exsn),
          .bending_exponent = function_without_rate(b, more, &MoreCard::exsb),
          .shear_exponent = function_without_rate(b, more, &MoreCard::exss),
          .fading_energy = function_without_rate(b, more, &MoreCard::gfad)};
}

void refuse_records(Builder& b, const std::vector<MaterialRows>& rows) {
  if (!rows.empty())
    refuse(b, rows.front().strength[&RecordCard::mid],
           "with PROPRUL 2 the functions of the defaults hold for all sheets, and records of materials are not read",
           "delete the record, or take PROPRUL 1 and numbers");
}

void read_connection_table(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto first = cursor.read(connection_table_card);
  if (first->proprul > 2)
    refuse(b, first[&ConnectionCard::proprul],
           "what 3 does other than 2 (functions of both sheets) is not public; expected 0, 1 or 2",
           "take 2, with functions that do not depend on the order of the sheets");
  if (first->proprul == 2) refuse_transformed_functions(b, block, first[&ConnectionCard::proprul]);
  const auto second = cursor.read(connection_default_card);
  const auto third = cursor.read(connection_default_more_card);
  const std::vector<MaterialRows> rows = material_rows(cursor);
  b.defer(Phase::curves, [=](Builder& later) {
    ConnectionProperties* table =
        add_weld_table(later, later.model.connections, later.connections, first, first->con_id, "connection");
    if (!table) return;
    table->area_rule = first->areaeq;
    table->damage_type = first->dgtyp;
    table->area_change = first->moarfl;
    if (first->proprul == 2) {
      table->functions = functions_of_both_sheets(later, second, third);
      table->standard.torsion_factor = third->sclmrr;
      return refuse_records(later, rows);
    }
    table->standard = record(later, second, third, true);
    for (const MaterialRows& row : rows) table->records.push_back(record(later, row.strength, row.more, false));
    if (table->damage_type != 1) return;
    warn_of_hyperbola(later, second);
    for (const MaterialRows& row : rows) warn_of_hyperbola(later, row.strength);
  });
}

void read_connection_add(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto first = cursor.read(connection_table_card);
  const std::vector<MaterialRows> rows = material_rows(cursor);
  // One phase later than the connections themselves.
  b.defer(Phase::mesh, [first, rows](Builder& later) {
    const Index table = later.find(later.connections, "*DEFINE_CONNECTION_PROPERTIES", first[&ConnectionCard::con_id]);
    if (table == none) return;
    if (later.model.connections[table].functions) return refuse_records(later, rows);
    for (const MaterialRows& row : rows)
      later.model.connections[table].records.push_back(record(later, row.strength, row.more, false));
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
       .layout = {{"", &pair_default_card}, {"repeated", &strength_pair_card}},
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
       .layout = {{"", &connection_table_card},
                  {"", &connection_default_card},
                  {"", &connection_default_more_card},
                  {"repeated with the next", &connection_material_card},
                  {"repeated with the last", &connection_material_more_card}},
       .read = read_connection_table},
      {.name = "DEFINE_CONNECTION_PROPERTIES_ADD",
       .options = {"TITLE"},
       .layout = {{"only CON_ID counts", &connection_table_card},
                  {"repeated with the next", &connection_material_card},
                  {"repeated with the last", &connection_material_more_card}},
       .read = read_connection_add},
      {.name = "DEFINE_SPOTWELD_RUPTURE_PARAMETER",
       .options = {"TITLE"},
       .status = KeywordStatus::refused,
       .why = "data of OPT 9 of *MAT_SPOTWELD, the formula of which is not public; use OPT 0, 1, 6 or 7"},
  };
}

}  // namespace nugget::reading
