// SPDX-License-Identifier: Apache-2.0
// *CONSTRAINED_GENERALIZED_WELD_FILLET, _BUTT, _CROSS_FILLET, _COMBINED: nodes that are one rigid body, joined pair by
// pair by seams that fail. The cards wait in Builder::body_cards; bodies/seams.cpp finds nodes and directions.
#include <numbers>
#include <utility>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

/// SIGY from which on a weld does not break.
constexpr double unbreakable_stress = 1e16;

struct SeamIdCard {
  int wid = 0;
};
const CardOf<SeamIdCard> seam_id_card{
    {&SeamIdCard::wid, id("wid", IdSpace::other, 0, "number of the weld")},
};

struct SeamSetCard {
  int nsid = 0, cid = 0, filter = 0, npr = 0;
  double window = 0;
};
CardOf<SeamSetCard> seam_set_card(const char* nodes, const char* system, IntegerField npr) {
  return {
      {&SeamSetCard::nsid, id("nsid", IdSpace::set, required, nodes)},
      {&SeamSetCard::cid, id("cid", IdSpace::define, 0, system)},
      {&SeamSetCard::filter,
       integer("filter", 0, at_least(0), "force vectors that are averaged for failure; up to 1: none")},
      {&SeamSetCard::window,
       real("window", dimension::time, 0, at_least(0), "time window of that average; 0: all FILTER vectors")},
      {&SeamSetCard::npr, npr},
      integer("nprt", 0, any_value, "output in rbdout"),
  };
}
constexpr IntegerField no_pair_count =
    integer("npr", 0, any_value, "pairs of nodes: of _CROSS_FILLET and _COMBINED only");
constexpr IntegerField pair_count = integer("npr", required, at_least(1), "number of pairs of nodes that follow");
constexpr const char* system_of_fillet = "coordinate system: z tensile direction, y along the weld, x towards its face";
constexpr const char* system_of_pairs = "coordinate system of pairs without one of their own";
const CardOf<SeamSetCard> fillet_set_card =
    seam_set_card("two or three nodes, in their order through the weld", system_of_fillet, no_pair_count);
const CardOf<SeamSetCard> butt_set_card =
    seam_set_card("the two nodes that are welded together", "coordinate system: x tensile direction, y along the weld",
                  no_pair_count);
const CardOf<SeamSetCard> pair_set_card =
    seam_set_card("nodes of the weld, each in a pair", system_of_pairs, pair_count);

struct SeamCard {
  double tfail = 0, epsf = 0, sigy = 0, beta = 0, l = 0, thickness = 0, alpha = 0, no_effect = 0;
};
constexpr RealField seam_time = real("tfail", dimension::time, forever, at_least(0), "time of failure");
constexpr RealField seam_strain =
    real("epsf", dimension::number, 0, at_least(0), "plastic strain of the adjoining elements at failure; 0: none");
constexpr RealField seam_strength =
    real("sigy", dimension::stress, unbreakable_stress, at_least(0), "stress at brittle failure; blank: none");
constexpr RealField seam_factor = real("beta", dimension::number, 1, above_zero(), "factor on the stress of the weld");
constexpr RealField seam_length =
    real("l", dimension::length, 0, at_least(0), "length of the weld that the pair of nodes stands for");
const CardOf<SeamCard> fillet_card{
    {&SeamCard::tfail, seam_time},
    {&SeamCard::epsf, seam_strain},
    {&SeamCard::sigy, seam_strength},
    {&SeamCard::beta, seam_factor},
    {&SeamCard::l, seam_length},
    {&SeamCard::no_effect,
     real("w", dimension::length, 0, at_least(0), "width of the flange; how it enters is not public: it does not")},
    {&SeamCard::thickness, real("a", dimension::length, 0, at_least(0), "thickness of the throat")},
    {&SeamCard::alpha, real("alpha", dimension::number, 0, between(0, 90),
                            "angle of the throat against the plane across the tensile direction [degrees]")},
};
const CardOf<SeamCard> butt_card{
    {&SeamCard::tfail, seam_time},
    {&SeamCard::epsf, seam_strain},
    {&SeamCard::sigy, seam_strength},
    {&SeamCard::beta, seam_factor},
    {&SeamCard::l, seam_length},
    {&SeamCard::thickness, real("d", dimension::length, 0, at_least(0), "thickness of the weld")},
    {&SeamCard::no_effect,
     real("lt", dimension::length, 0, at_least(0), "transverse length; how it enters is not public: it does not")},
};

struct SeamPairCard {
  int nodea = 0, nodeb = 0, ncid = 0, wtyp = 0;
};
CardOf<SeamPairCard> seam_pair_card(const char* system) {
  return {
      {&SeamPairCard::nodea, id("nodea", IdSpace::node, required, "node A of the pair")},
      {&SeamPairCard::nodeb, id("nodeb", IdSpace::node, required, "node B of the pair")},
      {&SeamPairCard::ncid, id("ncid", IdSpace::define, 0, system)},
  };
}
const CardOf<SeamPairCard> cross_fillet_pair = seam_pair_card("its coordinate system, as of a fillet; 0: CID");
const CardOf<SeamPairCard> combined_pair = [] {
  CardOf<SeamPairCard> card = seam_pair_card("its coordinate system, as of its kind of weld; 0: CID");
  card.add({&SeamPairCard::wtyp, integer("wtyp", 0, between(0, 1), "0 fillet, 1 butt (thickness A, x tensile)")});
  return card;
}();

double seam_failure_value(double written) {
  return written >= forever ? 0.0 : written;
}

/// TFAIL to ALPHA. Where a stress at failure is given, the section it acts on must be, too.
BodyCards::Seam take_seam(Builder& builder, const RowOf<SeamCard>& row) {
  BodyCards::Seam seam;
  seam.angle = row->alpha * std::numbers::pi / 180.0;
  seam.strength = row[&SeamCard::sigy];
  seam.seam.failure_time = seam_failure_value(row->tfail);
  seam.seam.failure_strain = seam_failure_value(row->epsf);
  if (row->sigy >= unbreakable_stress) return seam;
  seam.seam.strength = row->sigy * row->l * row->thickness / row->beta;
  for (const deck::Entry& size : {row[&SeamCard::l], row[&SeamCard::thickness]})
    if (!(size.value > 0.0))
      refuse(builder, size, "SIGY acts on length times thickness of the weld", "give both, or leave SIGY out");
  return seam;
}

/// A weld's cards up to the set of nodes.
BodyCards::Weld read_seam_head(Cursor& cursor, const Options& options, const CardOf<SeamSetCard>& card, int& npr) {
  BodyCards::Weld weld;
  if (options.contains("ID")) weld.weld.id = cursor.read(seam_id_card)->wid;
  const auto set = cursor.read(card);
  weld.weld.place = set.place();
  weld.first = set[&SeamSetCard::nsid];
  weld.second = set[&SeamSetCard::cid];
  weld.weld.filter = set->filter;
  weld.weld.window = set->window;
  npr = set->npr;
  return weld;
}

/// Reads the card of the failure; W and LT, which have no effect, are told of once a block.
class SeamReader {
 public:
  SeamReader(Builder& builder, Cursor& cursor) : builder_(builder), cursor_(cursor) {}
  BodyCards::Seam operator()(const CardOf<SeamCard>& card) {
    const auto row = cursor_.read(card);
    if (row->no_effect != 0.0 && !std::exchange(told_, true))
      row[&SeamCard::no_effect].report(
          builder_.findings, Severity::warning,
          "how it enters is not public: stresses are those on length times thickness alone", "leave it blank");
    return take_seam(builder_, row);
  }

 private:
  Builder& builder_;
  Cursor& cursor_;
  bool told_ = false;
};

template <bool butt>
void read_plain_seam(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  SeamReader read_seam(builder, cursor);
  while (!at_end(cursor)) {
    int npr = 0;
    BodyCards::Weld weld = read_seam_head(cursor, options, butt ? butt_set_card : fillet_set_card, npr);
    weld.weld.kind = butt ? RigidWeld::Kind::butt : RigidWeld::Kind::fillet;
    weld.seams = {read_seam(butt ? butt_card : fillet_card)};
    weld.seams.front().butt = butt;
    weld.seams.front().system = weld.second;
    builder.body_cards.add(std::move(weld));
  }
}

template <bool combined>
void read_paired_seams(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  SeamReader read_seam(builder, cursor);
  while (!at_end(cursor)) {
    int npr = 0;
    BodyCards::Weld weld = read_seam_head(cursor, options, pair_set_card, npr);
    weld.weld.kind = combined ? RigidWeld::Kind::combined : RigidWeld::Kind::cross_fillet;
    BodyCards::Seam seam;
    if (!combined) seam = read_seam(fillet_card);
    for (int i = 0; i < npr && (i == 0 || !at_end(cursor)); ++i) {
      if (combined) seam = read_seam(fillet_card);
      const auto pair = cursor.read(combined ? combined_pair : cross_fillet_pair);
      seam.butt = pair->wtyp == 1;
      seam.first = pair[&SeamPairCard::nodea];
      seam.second = pair[&SeamPairCard::nodeb];
      seam.system = pair->ncid == 0 ? weld.second : pair[&SeamPairCard::ncid];
      weld.seams.push_back(seam);
    }
    builder.body_cards.add(std::move(weld));
  }
}

}  // namespace

std::vector<Keyword> seam_weld_keywords() {
  const LayoutCard head{"with _ID", &seam_id_card};
  return {
      {.name = "CONSTRAINED_GENERALIZED_WELD_FILLET",
       .options = {"ID"},
       .layout = {head, {{}, &fillet_set_card}, {{}, &fillet_card}},
       .read = read_plain_seam<false>},
      {.name = "CONSTRAINED_GENERALIZED_WELD_BUTT",
       .options = {"ID"},
       .layout = {head, {{}, &butt_set_card}, {{}, &butt_card}},
       .read = read_plain_seam<true>},
      {.name = "CONSTRAINED_GENERALIZED_WELD_CROSS_FILLET",
       .options = {"ID"},
       .layout = {head, {{}, &pair_set_card}, {{}, &fillet_card}, {"NPR times", &cross_fillet_pair}},
       .read = read_paired_seams<false>},
      {.name = "CONSTRAINED_GENERALIZED_WELD_COMBINED",
       .options = {"ID"},
       .layout =
           {head, {{}, &pair_set_card}, {"NPR times, with the next", &fillet_card}, {"NPR times", &combined_pair}},
       .read = read_paired_seams<true>},
  };
}

}  // namespace nugget::reading
