// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "base/index.hpp"
#include "kernel/law/belt_tension.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/builder/passes.hpp"
#include "reading/cards/families.hpp"

// Seat belts: *ELEMENT_SEATBELT, _SLIPRING, _RETRACTOR, _SENSOR, *SECTION_SEATBELT, *MAT_SEATBELT.
// Layouts: public keyword tables (PyDYNA).
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

// ---- belts

struct BeltCard {
  int eid = 0, pid = 0, n1 = 0, n2 = 0, sbrid = 0, n3 = 0, n4 = 0;
  double slen = 0;
};
const CardOf<BeltCard> belt_card{
    {&BeltCard::eid, wide(id("eid", IdSpace::element, required, "element id"), 8)},
    {&BeltCard::pid, wide(id("pid", IdSpace::part, required, "part id"), 8)},
    {&BeltCard::n1, wide(id("n1", IdSpace::node, required, "node 1"), 8)},
    {&BeltCard::n2, wide(id("n2", IdSpace::node, required, "node 2"), 8)},
    {&BeltCard::sbrid, wide(id("sbrid", IdSpace::other, 0, "retractor in which it is wound up at the start"), 8)},
    {&BeltCard::slen,
     wide(real("slen", dimension::length, 0, at_least(0), "slack: unstretched length beyond the distance of the nodes"),
          16)},
    {&BeltCard::n3, wide(id("n3", IdSpace::node, 0, "only 0: belts of shells are not built"), 8)},
    {&BeltCard::n4, wide(id("n4", IdSpace::node, 0, "only 0: belts of shells are not built"), 8)},
};

struct BeltSectionCard {
  int secid = 0;
};
const CardOf<BeltSectionCard> belt_section_card{
    {&BeltSectionCard::secid, id("secid", IdSpace::other, required, "section id")},
    real("area", dimension::area, 0, any_value, "for the contact of elements, which these have none of"),
    real("thick", dimension::length, 0, any_value, "the same"),
};

struct BeltMaterialCard {
  int mid = 0, llcid = 0, ulcid = 0;
  double mpul = 0, lmin = 0, e = 0;
};
const CardOf<BeltMaterialCard> belt_material_card{
    {&BeltMaterialCard::mid, id("mid", IdSpace::material, required, "material id")},
    {&BeltMaterialCard::mpul, real("mpul", {1, -1, 0}, required, above_zero(), "mass per unit length")},
    {&BeltMaterialCard::llcid,
     id("llcid", IdSpace::function, required, "loading curve: tension over engineering strain")},
    {&BeltMaterialCard::ulcid, id("ulcid", IdSpace::function, 0, "unloading curve; 0: as loading")},
    {&BeltMaterialCard::lmin,
     real("lmin", dimension::length, 0, at_least(0), "least length, at slip rings and retractors")},
    real("cse", dimension::number, 0, any_value, "of belts of shells only"),
    real("damp", dimension::number, 0, any_value, "of belts of shells only"),
    {&BeltMaterialCard::e, real("e", dimension::stress, 0, any_value, "bending and compression: not built")},
};

Curve tension_curve(Builder& b, const deck::Entry& field, const char* (*fault)(const Curve&)) {
  const Index found = b.curve(field);
  if (found == none) return {};
  const std::string why = fault(b.model.curves[found]);
  if (!why.empty()) refuse(b, field, why, "correct the curve");
  return b.model.curves[found];
}

void read_belt_material(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    Material material;
    material.title = read_title(cursor, options);
    const auto row = cursor.read(belt_material_card);
    if (row->e > 0.0) {
      refuse(builder, row[&BeltMaterialCard::e], "bending and compression of belts are not built", "leave it 0");
      return;
    }
    material.id = row->mid;
    material.keyword = "MAT_SEATBELT";
    material.place = row.place();
    material.law = kernel::Spring{};
    BeltMaterial belt;
    belt.id = row->mid;
    belt.line_density = row->mpul;
    belt.least_length = row->lmin;
    belt.place = row.place();
    const auto index = static_cast<Index>(builder.model.materials.size()),
               place = static_cast<Index>(builder.model.belts.materials.size());
    builder.materials.add(material.id, index, material.place, row.keyword(), "material", builder.findings);
    builder.model.materials.push_back(std::move(material));
    builder.model.belts.materials.push_back(std::move(belt));
    builder.belt_materials[index] = place;
    builder.defer(Phase::conditions, [row, place](Builder& b) {
      BeltMaterial& of = b.model.belts.materials[at(place)];
      tension_curve(b, row[&BeltMaterialCard::llcid], kernel::BeltTension::fault_of_loading);
      tension_curve(b, row[&BeltMaterialCard::ulcid], kernel::BeltTension::fault_of_unloading);
      of.loading = b.curves.find(row->llcid);
      of.unloading = row->ulcid == 0 ? none : b.curves.find(row->ulcid);
    });
  }
}

void read_belt_section(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(belt_section_card);
    builder.belt_sections.add(row->secid, 0, row.place(), row.keyword(), "section", builder.findings);
  }
}

void add_belt(Builder& b, const RowOf<BeltCard>& row) {
  Belt belt;
  belt.id = row->eid;
  belt.place = row.place();
  belt.slack = row->slen;
  belt.part = b.part(row[&BeltCard::pid]);
  belt.node = {b.node(row[&BeltCard::n1]), b.node(row[&BeltCard::n2])};
  if (belt.part == none || belt.node[0] == none || belt.node[1] == none) return;
  const Part& part = b.model.parts[belt.part];
  const auto material = b.belt_materials.find(part.material);
  if (part.kind != ElementKind::nothing || material == b.belt_materials.end())
    return refuse(b, row[&BeltCard::pid],
                  "a part of belts has *MAT_SEATBELT and *SECTION_SEATBELT, and no other elements",
                  "give the belts a part of their own");
  belt.material = material->second;
  if (row->sbrid != 0 && b.retractors.find(row->sbrid) == none)
    return refuse(b, row[&BeltCard::sbrid], "no *ELEMENT_SEATBELT_RETRACTOR has this id", "define it");
  if (row->sbrid != 0) belt.retractor = b.retractors.find(row->sbrid);
  const auto index = static_cast<Index>(b.model.belts.elements.size());
  if (!b.belts.add(belt.id, index, belt.place, row.keyword(), "seat belt", b.findings)) return;
  b.model.belts.elements.push_back(belt);  // also one that is refused: its index is known by now
  if (belt.retractor == none && !(norm(b.model.nodes.x[belt.node[1]] - b.model.nodes.x[belt.node[0]]) > 0.0))
    refuse(b, row[&BeltCard::n2], "both nodes are at one place", "give the belt a length");
}

void read_belt(Builder& builder, const Block& block, const Options&) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const auto row = cursor.read(belt_card);
    refuse_nonzero(builder, row[&BeltCard::n3], "belts of shells are not built", "give the belt two nodes");
    builder.defer(Phase::sets, [row](Builder& b) { add_belt(b, row); });
  }
}

// ---- rings and retractors

/// Runs when all belts are known, and before masses are needed.
void behind_belts(Builder& builder, std::function<void(Builder&)> work) {
  builder.defer(Phase::sets, [work = std::move(work)](Builder& b) { b.defer(Phase::sets, work); });
}

/// Places of belts and nodes that count as one.
bool at_one_place(const Builder& b, Index one, Index other, double size) {
  return norm(b.model.nodes.x[one] - b.model.nodes.x[other]) <= 1e-3 * size;
}

double length_of_belt(const Builder& b, const Belt& belt) {
  return norm(b.model.nodes.x[belt.node[1]] - b.model.nodes.x[belt.node[0]]);
}

/// The belt in a field, which is not wound up; none and a finding where there is none.
Index belt_in(Builder& b, const deck::Entry& field) {
  const Index found = b.find(b.belts, "seat belt", field);
  if (found == none) return none;
  if (b.model.belts.elements[found].retractor != none) {
    refuse(b, field, "this belt is wound up in a retractor (SBRID)", "name one that is outside");
    return none;
  }
  return found;
}

struct SlipRingCard {
  int sbsrid = 0, sbid1 = 0, sbid2 = 0, sbrnid = 0, onid = 0;
  double fc = 0, ltime = 0, fcs = 0;
};
const CardOf<SlipRingCard> slip_ring_card{
    {&SlipRingCard::sbsrid, id("sbsrid", IdSpace::other, required, "slip ring")},
    {&SlipRingCard::sbid1, id("sbid1", IdSpace::element, required, "belt 1")},
    {&SlipRingCard::sbid2, id("sbid2", IdSpace::element, required, "belt 2")},
    {&SlipRingCard::fc, real("fc", dimension::number, 0, any_value, "friction; below 0: its curve over time")},
    {&SlipRingCard::sbrnid, id("sbrnid", IdSpace::node, required, "node of the ring, where both belts meet")},
    {&SlipRingCard::ltime, real("ltime", dimension::time, 1e20, any_value, "nothing slides from this time on")},
    {&SlipRingCard::fcs,
     real("fcs", dimension::number, 0, any_value, "friction at rest; 0: FC; below 0: its curve over time")},
    {&SlipRingCard::onid, id("onid", IdSpace::node, 0, "skew of the belt: not built")},
};
struct RingFrictionCard {
  int funcid = 0, direct = 0, lcnffd = 0, lcnffs = 0;
  double k = 0, dc = 0;
};
const CardOf<RingFrictionCard> ring_friction_card{
    {&RingFrictionCard::k, real("k", dimension::number, 0, any_value, "friction by the skew: not built")},
    {&RingFrictionCard::funcid, id("funcid", IdSpace::function, 0, "friction by a function: not built")},
    {&RingFrictionCard::direct,
     integer("direct", 0, any_value, "0 both ways; 12 from belt 1 to belt 2 only, 21 the other way only")},
    {&RingFrictionCard::dc,
     real("dc", {0, -1, 1}, 0, at_least(0), "friction is FC + (FCS - FC) exp(-DC v), v the speed of sliding")},
    unused(),
    {&RingFrictionCard::lcnffd, id("lcnffd", IdSpace::function, 0, "friction by the normal force: not built")},
    {&RingFrictionCard::lcnffs, id("lcnffs", IdSpace::function, 0, "friction by the normal force: not built")},
};

Index ring_friction_curve(Builder& b, const deck::Entry& field) {
  const Index found = b.curves.find(std::abs(field.integer()));
  if (found == none) refuse(b, field, "no curve has this number", "give the curve of the friction over time");
  return found;
}

void add_slip_ring(Builder& b, const RowOf<SlipRingCard>& row, SlipRing ring) {
  ring.node = b.node(row[&SlipRingCard::sbrnid]);
  ring.belt = {belt_in(b, row[&SlipRingCard::sbid1]), belt_in(b, row[&SlipRingCard::sbid2])};
  if (ring.node == none || ring.belt[0] == none || ring.belt[1] == none) return;
  if (row->fc < 0.0) ring.friction_curve = ring_friction_curve(b, row[&SlipRingCard::fc]);
  if (row->fcs < 0.0) ring.static_curve = ring_friction_curve(b, row[&SlipRingCard::fcs]);
  Belt &one = b.model.belts.elements[ring.belt[0]], &other = b.model.belts.elements[ring.belt[1]];
  const double size = std::min(length_of_belt(b, one), length_of_belt(b, other));
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      if (one.node[i] != other.node[j] || &one == &other) continue;
      if (!at_one_place(b, one.node[i], ring.node, size))
        return refuse(b, row[&SlipRingCard::sbrnid], "the node where both belts meet is not where the ring is",
                      "give both one place");
      for (const Index m : {one.material, other.material})
        if (!(b.model.belts.materials[m].least_length > 0.0))
          return refuse(b, row[&SlipRingCard::sbid1], "belts at slip rings need a least length",
                        "give LMIN of *MAT_SEATBELT");
      b.nodes_of_rings.push_back(one.node[i]);
      one.node[i] = other.node[j] = ring.node;
      b.slip_rings.add(ring.id, static_cast<Index>(b.model.belts.rings.size()), ring.place, row.keyword(), "slip ring",
                       b.findings);
      b.model.belts.rings.push_back(ring);
      return;
    }
  refuse(b, row[&SlipRingCard::sbid2], "both belts have no node in common", "name neighbours that meet at the ring");
}

void read_slip_ring(Builder& builder, const Block& block, const Options&) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const auto row = cursor.read(slip_ring_card);
    SlipRing ring;
    ring.id = row->sbsrid;
    ring.place = row.place();
    ring.friction = row->fc;
    ring.static_friction = row->fcs;
    ring.lock_time = row->ltime > 0.0 ? row->ltime : forever;
    refuse_nonzero(builder, row[&SlipRingCard::onid], "the skew of belts at a ring is not built", "leave it 0");
    // The second card is left out in older decks; the first one of the next ring names a node in its fifth field.
    if (cursor.more() && cursor.peek_number(4) == 0.0) {
      const auto more = cursor.read(ring_friction_card);
      for (const deck::Entry& field : {more[&RingFrictionCard::k], more[&RingFrictionCard::funcid],
                                       more[&RingFrictionCard::lcnffd], more[&RingFrictionCard::lcnffs]})
        refuse_nonzero(builder, field, "friction by skew, function or normal force is not built",
                       "give FC, FCS and DC");
      if (more->direct != 0 && more->direct != 12 && more->direct != 21)
        refuse(builder, more[&RingFrictionCard::direct], "expected 0, 12 or 21");
      ring.decay = more->dc;
      ring.to_first = more->direct != 12;
      ring.to_second = more->direct != 21;
    }
    behind_belts(builder, [row, ring](Builder& b) { add_slip_ring(b, row, ring); });
  }
}

struct RetractorCard {
  int sbrid = 0, sbrnid = 0, sbid = 0, dsid = 0;
  std::array<int, 4> sid{};
};
const CardOf<RetractorCard> retractor_card{
    {&RetractorCard::sbrid, id("sbrid", IdSpace::other, required, "retractor")},
    {&RetractorCard::sbrnid, id("sbrnid", IdSpace::node, required, "its node, where its belt ends")},
    {&RetractorCard::sbid, id("sbid", IdSpace::element, required, "the belt that comes out of it")},
    {at(&RetractorCard::sid, 0), id("sid1", IdSpace::other, 0, "*ELEMENT_SEATBELT_SENSOR that makes it lock")},
    {at(&RetractorCard::sid, 1), id("sid2", IdSpace::other, 0, "or this one")},
    {at(&RetractorCard::sid, 2), id("sid3", IdSpace::other, 0, "or this one")},
    {at(&RetractorCard::sid, 3), id("sid4", IdSpace::other, 0, "or this one")},
    {&RetractorCard::dsid, id("dsid", IdSpace::other, 0, "sensor that unlocks it: not built")},
};
struct RetractorLawCard {
  double tdel = 0, pull = 0, lfed = 0;
  int llcid = 0, ulcid = 0, lcfl = 0;
};
const CardOf<RetractorLawCard> retractor_law_card{
    {&RetractorLawCard::tdel, real("tdel", dimension::time, 0, at_least(0), "delay after the sensor has responded")},
    {&RetractorLawCard::pull,
     real("pull", dimension::length, 0, at_least(0), "what can be pulled out after that before it locks")},
    {&RetractorLawCard::llcid, id("llcid", IdSpace::function, required,
                                  "tension over what is pulled out of the locked retractor; the first tension is that "
                                  "of the unlocked one")},
    {&RetractorLawCard::ulcid, id("ulcid", IdSpace::function, 0, "the same as tension falls; 0: as it rises")},
    {&RetractorLawCard::lfed,
     real("lfed", dimension::length, required, above_zero(), "fed length: how long belts are that come out")},
    {&RetractorLawCard::lcfl, id("lcfl", IdSpace::function, 0, "load limiter of several levels: not built")},
    integer("flopt", 0, any_value, "of LCFL only"),
};

/// The belts that are wound up, in the order in which they come out, and the nodes between them.
void find_wound_up(Builder& b, const RowOf<RetractorCard>& row, Retractor& retractor, Index index, Index last,
                   double size) {
  std::vector<Index> left;
  for (std::size_t e = 0; e < b.model.belts.elements.size(); ++e)
    if (b.model.belts.elements[e].retractor == index) left.push_back(static_cast<Index>(e));
  while (!left.empty()) {
    const auto next = std::ranges::find_if(left, [&](Index e) {
      const auto& node = b.model.belts.elements[e].node;
      return node[0] == last || node[1] == last;
    });
    if (next == left.end())
      return refuse(b, row[&RetractorCard::sbid],
                    fmt::format("belt {} is wound up in it, but does not go on from the one that comes out of it",
                                b.model.belts.elements[left.front()].id),
                    "number its nodes such that belts follow each other");
    Belt& belt = b.model.belts.elements[*next];
    retractor.inside.push_back(*next);
    retractor.inside_nodes.push_back(last);
    last = belt.node[0] == last ? belt.node[1] : belt.node[0];
    left.erase(next);
    if (left.empty()) {
      std::ranges::replace(belt.node, last, retractor.node);
      b.nodes_of_rings.push_back(last);
    }
    if (!at_one_place(b, last, retractor.node, size))
      return refuse(b, row[&RetractorCard::sbrnid],
                    fmt::format("node {} of belt {}, which is wound up, is not where the retractor is",
                                b.model.nodes.id[last], belt.id),
                    "give both one place");
  }
}

void add_retractor(Builder& b, const RowOf<RetractorCard>& row, const RowOf<RetractorLawCard>& law, Index index) {
  Retractor& retractor = b.model.belts.retractors[at(index)];
  retractor.node = b.node(row[&RetractorCard::sbrnid]);
  retractor.belt = belt_in(b, row[&RetractorCard::sbid]);
  tension_curve(b, law[&RetractorLawCard::llcid], kernel::BeltTension::fault_of_loading);
  tension_curve(b, law[&RetractorLawCard::ulcid], kernel::BeltTension::fault_of_unloading);
  retractor.loading = b.curves.find(law->llcid);
  retractor.unloading = law->ulcid == 0 ? none : b.curves.find(law->ulcid);
  for (std::size_t i = 0; i < row->sid.size(); ++i) {
    if (row->sid[i] == 0) continue;
    const deck::Entry field = row[at(&RetractorCard::sid, i)];
    if (const Index found = b.find(b.belt_sensors, "seat belt sensor", field); found != none)
      retractor.sensors.push_back(found);
  }
  if (retractor.node == none || retractor.belt == none) return;
  Belt& belt = b.model.belts.elements[retractor.belt];
  if (!(b.model.belts.materials[belt.material].least_length > 0.0))
    return refuse(b, row[&RetractorCard::sbid], "belts at retractors need a least length",
                  "give LMIN of *MAT_SEATBELT");
  const double size = length_of_belt(b, belt);
  for (Index& node : belt.node) {
    if (node != retractor.node && !at_one_place(b, node, retractor.node, size)) continue;
    const Index meets = node;
    node = retractor.node;
    b.nodes_of_rings.push_back(meets);
    return find_wound_up(b, row, retractor, index, meets, size);
  }
  refuse(b, row[&RetractorCard::sbid], "the belt does not end where the retractor is", "give both one place");
}

void read_retractor(Builder& builder, const Block& block, const Options&) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const auto row = cursor.read(retractor_card);
    const auto law = cursor.read(retractor_law_card);
    refuse_nonzero(builder, row[&RetractorCard::dsid], "a retractor that unlocks again is not built", "leave it 0");
    refuse_nonzero(builder, law[&RetractorLawCard::lcfl], "load limiters by switches are not built",
                   "give the limit in LLCID");
    Retractor retractor;
    retractor.id = row->sbrid;
    retractor.place = row.place();
    retractor.delay = law->tdel;
    retractor.pull = law->pull;
    retractor.fed_length = law->lfed;
    const auto index = static_cast<Index>(builder.model.belts.retractors.size());
    builder.retractors.add(retractor.id, index, retractor.place, row.keyword(), "retractor", builder.findings);
    builder.model.belts.retractors.push_back(std::move(retractor));
    behind_belts(builder, [row, law, index](Builder& b) { add_retractor(b, row, law, index); });
  }
}

// ---- pretensioners

struct PretensionerCard {
  int sbprid = 0, sbprty = 0;
  std::array<int, 4> sbsid{};
};
const CardOf<PretensionerCard> pretensioner_card{
    {&PretensionerCard::sbprid, id("sbprid", IdSpace::other, required, "pretensioner")},
    {&PretensionerCard::sbprty,
     integer("sbprty", 1, between(1, 9),
             "1 pull-in of a retractor, its tension limited by LLCID; 2 a spring acts from then on; 3 a spring's force "
             "ends; 5 pull-in of a retractor whatever the tension; others are not built")},
    {at(&PretensionerCard::sbsid, 0), id("sbsid1", IdSpace::other, 0, "*ELEMENT_SEATBELT_SENSOR that makes it act")},
    {at(&PretensionerCard::sbsid, 1), id("sbsid2", IdSpace::other, 0, "or this one")},
    {at(&PretensionerCard::sbsid, 2), id("sbsid3", IdSpace::other, 0, "or this one")},
    {at(&PretensionerCard::sbsid, 3), id("sbsid4", IdSpace::other, 0, "or this one")},
};
struct PretensionerActsCard {
  int sbrid = 0, ptlcid = 0;
  double time = 0, lmtfrc = 0;
};
const CardOf<PretensionerActsCard> pretensioner_acts_card{
    {&PretensionerActsCard::sbrid, id("sbrid", IdSpace::other, required, "its retractor; of types 2 and 3 its spring")},
    {&PretensionerActsCard::time,
     real("time", dimension::time, 0, at_least(0), "delay after the sensor has responded")},
    {&PretensionerActsCard::ptlcid,
     id("ptlcid", IdSpace::function, 0, "types 1 and 5: pull-in over the time since it acts")},
    {&PretensionerActsCard::lmtfrc,
     real("lmtfrc", dimension::force, 0, at_least(0), "type 5: tension at which pull-in ends; 0: none")},
};

/// Runs when *SENSOR_CONTROL has said what it controls.
void behind_controls(Builder& builder, std::function<void(Builder&)> work) {
  builder.defer(Phase::checks, [work = std::move(work)](Builder& b) {
    b.defer(Phase::checks, [work](Builder& late) { late.defer(Phase::checks, work); });
  });
}

void add_pretensioner(Builder& b, const RowOf<PretensionerCard>& row, const RowOf<PretensionerActsCard>& acts,
                      Index index) {
  using enum Pretensioner::Kind;
  Pretensioner& of = b.model.belts.pretensioners[at(index)];
  for (std::size_t i = 0; i < row->sbsid.size(); ++i) {
    if (row->sbsid[i] == 0) continue;
    const deck::Entry field = row[at(&PretensionerCard::sbsid, i)];
    if (const Index found = b.find(b.belt_sensors, "seat belt sensor", field); found != none)
      of.sensors.push_back(found);
  }
  const deck::Entry target = acts[&PretensionerActsCard::sbrid];
  if (of.kind == spring_acts || of.kind == spring_ends) {
    of.discrete = b.find(b.discretes, "discrete element", target);
    return;
  }
  of.retractor = b.find(b.retractors, "retractor", target);
  for (Index other = 0; other < index && of.retractor != none; ++other)
    if (b.model.belts.pretensioners[at(other)].retractor == of.retractor)
      refuse(b, target, "this retractor has a pretensioner already", "give it one");
  of.curve = b.curve(acts[&PretensionerActsCard::ptlcid]);
  if (of.curve == none) return;
  const std::vector<double>& lengths = b.model.curves[of.curve].y;
  if (lengths.front() < 0.0 || !std::ranges::is_sorted(lengths))
    refuse(b, acts[&PretensionerActsCard::ptlcid], "expected lengths of 0 and more that do not fall",
           "correct the curve");
}

void read_pretensioner(Builder& builder, const Block& block, const Options&) {
  using enum Pretensioner::Kind;
  static const std::map<int, Pretensioner::Kind> kinds{
      {1, limited_pull_in}, {2, spring_acts}, {3, spring_ends}, {5, pull_in}};
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const auto row = cursor.read(pretensioner_card);
    const auto acts = cursor.read(pretensioner_acts_card);
    const auto kind = kinds.find(row->sbprty);
    if (kind == kinds.end()) {
      refuse(builder, row[&PretensionerCard::sbprty], "this type of pretensioner is not built",
             "give the pull-in over time (types 1 and 5), or a spring that acts (2) or ends (3)");
      continue;
    }
    Pretensioner of;
    of.id = row->sbprid;
    of.kind = kind->second;
    of.place = row.place();
    of.delay = acts->time;
    of.most_tension = of.kind == pull_in ? acts->lmtfrc : 0.0;
    if (of.kind != pull_in && acts->lmtfrc > 0.0)
      expect(builder, Severity::warning,
             {{acts[&PretensionerActsCard::lmtfrc], 0, "of type 5 only: it has no effect"}});
    const auto index = static_cast<Index>(builder.model.belts.pretensioners.size());
    builder.pretensioners.add(of.id, index, of.place, row.keyword(), "pretensioner", builder.findings);
    builder.model.belts.pretensioners.push_back(std::move(of));
    builder.defer(Phase::conditions, [row, acts, index](Builder& b) { add_pretensioner(b, row, acts, index); });
    behind_controls(builder, [row, index](Builder& b) {
      const Pretensioner& known = b.model.belts.pretensioners[at(index)];
      if (known.sensors.empty() && known.control == none)
        refuse(b, row[at(&PretensionerCard::sbsid, 0)], "nothing makes it act",
               "name a *ELEMENT_SEATBELT_SENSOR, or control it (*SENSOR_CONTROL, BELTPRET)");
    });
  }
}

// ---- sensors

struct BeltSensorCard {
  int sbsid = 0, sbstyp = 0, sbsfl = 0;
};
const CardOf<BeltSensorCard> belt_sensor_card{
    {&BeltSensorCard::sbsid, id("sbsid", IdSpace::other, required, "sensor")},
    {&BeltSensorCard::sbstyp,
     integer("sbstyp", 1, between(1, 5),
             "1 acceleration of a node, 2 rate of pull-out, 3 time, 4 distance of nodes, 5 pull-out")},
    {&BeltSensorCard::sbsfl, integer("sbsfl", 0, between(0, 1), "1: responds in dynamic relaxation as well")},
};
struct SensingCard {
  int first = 0, second = 0, dof = 0;
  double most = 0, least = 0;
};
const CardOf<SensingCard> belt_by_acceleration{
    {&SensingCard::first, id("nid", IdSpace::node, required, "node")},
    {&SensingCard::dof, integer("dof", 1, between(1, 3), "1 x, 2 y, 3 z")},
    {&SensingCard::most, real("acc", dimension::acceleration, required, any_value,
                              "it responds above this acceleration, or below one that is below 0")},
    {&SensingCard::least, real("atime", dimension::time, 0, at_least(0), "for so long")}},
    belt_by_rate{{&SensingCard::first, id("sbrid", IdSpace::other, required, "retractor")},
                 {&SensingCard::most, real("pulrat", dimension::velocity, required, any_value, "above this rate")},
                 {&SensingCard::least, real("pultim", dimension::time, 0, at_least(0), "for so long")}},
    belt_by_time{{&SensingCard::most, real("time", dimension::time, 0, at_least(0), "after this time")}},
    belt_by_distance{
        {&SensingCard::first, id("nid1", IdSpace::node, required, "node 1")},
        {&SensingCard::second, id("nid2", IdSpace::node, required, "node 2")},
        {&SensingCard::most, real("dmx", dimension::length, 0, at_least(0), "above this; 0: no bound")},
        {&SensingCard::least, real("dmn", dimension::length, 0, at_least(0), "and below this; 0: no bound")}},
    belt_by_pull_out{{&SensingCard::first, id("sbrid", IdSpace::other, required, "retractor")},
                     {&SensingCard::most, real("pulmx", dimension::length, 1e16, any_value, "above this")},
                     {&SensingCard::least, real("pulmn", dimension::length, -1e16, any_value, "and below this")}};

void read_belt_sensor(Builder& builder, const Block& block, const Options&) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const auto row = cursor.read(belt_sensor_card);
    BeltSensor sensor;
    sensor.id = row->sbsid;
    sensor.place = row.place();
    sensor.in_relaxation = row->sbsfl == 1;
    using enum BeltSensor::Kind;
    constexpr std::array<BeltSensor::Kind, 5> kinds{acceleration, pull_out_rate, time, distance, pull_out};
    const std::array<const CardOf<SensingCard>*, 5> cards{&belt_by_acceleration, &belt_by_rate, &belt_by_time,
                                                          &belt_by_distance, &belt_by_pull_out};
    const auto type = at(row->sbstyp >= 1 && row->sbstyp <= 5 ? row->sbstyp - 1 : 2);
    sensor.kind = kinds[type];
    const auto by = cursor.read(*cards[type]);
    sensor.above = by->most;
    if (sensor.kind == acceleration || sensor.kind == pull_out_rate) sensor.duration = by->least;
    if (sensor.kind == pull_out) sensor.below = by->least;
    if (sensor.kind == distance) {
      if (by->most == 0.0) sensor.above = forever;
      if (by->least > 0.0) sensor.below = by->least;
    }
    if (sensor.kind == acceleration) {
      warn_of_global_axis(builder, block, by[&SensingCard::dof]);
      sensor.direction = {by->dof == 1 ? 1.0 : 0.0, by->dof == 2 ? 1.0 : 0.0, by->dof == 3 ? 1.0 : 0.0};
      if (by->most < 0.0) {
        sensor.below = by->most;
        sensor.above = forever;
      }
    }
    const auto index = static_cast<Index>(builder.model.belts.sensors.size());
    builder.belt_sensors.add(sensor.id, index, sensor.place, row.keyword(), "seat belt sensor", builder.findings);
    builder.model.belts.sensors.push_back(sensor);
    behind_belts(builder, [by, index](Builder& b) {
      BeltSensor& of = b.model.belts.sensors[at(index)];
      if (of.kind == acceleration || of.kind == distance) of.node[0] = b.node(by[&SensingCard::first]);
      if (of.kind == distance) of.node[1] = b.node(by[&SensingCard::second]);
      if (of.kind == pull_out || of.kind == pull_out_rate)
        of.retractor = b.find(b.retractors, "retractor", by[&SensingCard::first]);
    });
  }
}

}  // namespace

void weigh_belts(Builder& b) {
  Belts& belts = b.model.belts;
  const auto add = [&](Index node, double mass) { b.model.masses.push_back({0, node, mass}); };
  const auto weigh = [&](Belt& belt, double length) {
    belt.mass = belts.materials[belt.material].line_density * length;
    return 0.5 * belt.mass;
  };
  for (Belt& belt : belts.elements) {
    if (belt.retractor != none) continue;
    const double half = weigh(belt, length_of_belt(b, belt) + belt.slack);
    for (const Index node : belt.node) add(node, half);
  }
  for (const Retractor& retractor : belts.retractors)
    for (std::size_t i = 0; i < retractor.inside.size(); ++i) {
      const double half = weigh(belts.elements[retractor.inside[i]], retractor.fed_length);
      add(retractor.inside_nodes[i], half);
      add(retractor.node, half);
    }
}

std::vector<Keyword> belt_keywords() {
  const std::vector<std::string_view> title{"TITLE"};
  return {
      {.name = "ELEMENT_SEATBELT", .layout = {{"", &belt_card}}, .read = read_belt},
      {.name = "ELEMENT_SEATBELT_SLIPRING",
       .layout = {{"", &slip_ring_card}, {"left out in older decks", &ring_friction_card}},
       .read = read_slip_ring},
      {.name = "ELEMENT_SEATBELT_RETRACTOR",
       .layout = {{"", &retractor_card}, {"", &retractor_law_card}},
       .read = read_retractor},
      {.name = "ELEMENT_SEATBELT_PRETENSIONER",
       .layout = {{"", &pretensioner_card}, {"", &pretensioner_acts_card}},
       .read = read_pretensioner},
      {.name = "ELEMENT_SEATBELT_SENSOR",
       .layout = {{"", &belt_sensor_card},
                  {"SBSTYP 1", &belt_by_acceleration},
                  {"SBSTYP 2", &belt_by_rate},
                  {"SBSTYP 3", &belt_by_time},
                  {"SBSTYP 4", &belt_by_distance},
                  {"SBSTYP 5", &belt_by_pull_out}},
       .read = read_belt_sensor},
      {.name = "SECTION_SEATBELT", .options = title, .layout = {{"", &belt_section_card}}, .read = read_belt_section},
      {.name = "MAT_SEATBELT",
       .aliases = {"MAT_B01"},
       .options = title,
       .layout = {{"", &belt_material_card}},
       .read = read_belt_material},
  };
}

}  // namespace nugget::reading
