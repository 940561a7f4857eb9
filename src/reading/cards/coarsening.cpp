// SPDX-License-Identifier: Apache-2.0
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *CONTROL_COARSEN, *DEFINE_BOX_COARSEN, *CONSTRAINED_ADAPTIVITY.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;

struct CoarsenCard {
  int icoarse = 0;
  double angle = 0.0;
  int nseed = 0, psid = 0;
  double smax = 0.0;
};
const CardOf<CoarsenCard> coarsen_card{
    {&CoarsenCard::icoarse,
     integer("icoarse", 0, between(0, 2), "0 nothing; 1, 2 (here the same) four shells become one before the run")},
    {&CoarsenCard::angle,
     real("angle", dimension::number, 8.0, between(0, 90), "largest angle between shells that are merged, in degrees")},
    {&CoarsenCard::nseed, integer("nseed", 0, between(0, 8), "number of seed nodes on card 2")},
    {&CoarsenCard::psid, id("psid", IdSpace::set, 0, "part set that is left alone")},
    {&CoarsenCard::smax,
     real("smax", dimension::length, 0, at_least(0), "longest side of a merged shell; 0: no limit")},
};

struct SeedCard {
  std::array<int, 8> node{};
};
const CardOf<SeedCard> seed_card{
    {at(&SeedCard::node, 0), id("n1", IdSpace::node, 0, "node amid four shells at which merging begins")},
    {at(&SeedCard::node, 1), id("n2", IdSpace::node, 0, "another one")},
    {at(&SeedCard::node, 2), id("n3", IdSpace::node, 0, "another one")},
    {at(&SeedCard::node, 3), id("n4", IdSpace::node, 0, "another one")},
    {at(&SeedCard::node, 4), id("n5", IdSpace::node, 0, "another one")},
    {at(&SeedCard::node, 5), id("n6", IdSpace::node, 0, "another one")},
    {at(&SeedCard::node, 6), id("n7", IdSpace::node, 0, "another one")},
    {at(&SeedCard::node, 7), id("n8", IdSpace::node, 0, "another one")},
};

void read_coarsen(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  const auto row = cursor.read(coarsen_card);
  std::vector<deck::RowOf<SeedCard>> seeds;
  if (!at_end(cursor)) seeds.push_back(cursor.read(seed_card));
  expect_end(builder, cursor);
  CoarsenControl& control = builder.model.coarsen;
  control.on = row->icoarse > 0;
  control.angle = row->angle;
  control.largest = row->smax;
  control.place = row.place();
  builder.defer(Phase::conditions, [row, seeds](Builder& b) {
    if (const Set<Index>* parts = b.part_set(row[&CoarsenCard::psid])) b.model.coarsen.kept_parts = parts->members;
    // Of a deck that is read for the second time seeds may be gone.
    if (seeds.empty() || b.coarsening != nullptr) return;
    for (std::size_t k = 0; k < static_cast<std::size_t>(row->nseed); ++k)
      if (const Index n = b.find(b.nodes, "node", seeds[0][at(&SeedCard::node, k)]); n != none)
        b.model.coarsen.seeds.push_back(n);
  });
}

struct CoarsenBoxCard {
  int boxid = 0;
  double xmn = 0, xmx = 0, ymn = 0, ymx = 0, zmn = 0, zmx = 0;
  int iflag = 0;
};
const CardOf<CoarsenBoxCard> coarsen_box_card{
    {&CoarsenBoxCard::boxid, id("boxid", IdSpace::define, required, "id of the box")},
    {&CoarsenBoxCard::xmn, real("xmn", dimension::length, 0, any_value, "least x")},
    {&CoarsenBoxCard::xmx, real("xmx", dimension::length, 0, any_value, "largest x")},
    {&CoarsenBoxCard::ymn, real("ymn", dimension::length, 0, any_value, "least y")},
    {&CoarsenBoxCard::ymx, real("ymx", dimension::length, 0, any_value, "largest y")},
    {&CoarsenBoxCard::zmn, real("zmn", dimension::length, 0, any_value, "least z")},
    {&CoarsenBoxCard::zmx, real("zmx", dimension::length, 0, any_value, "largest z")},
    {&CoarsenBoxCard::iflag,
     integer("iflag", 0, between(0, 1), "shells that are left alone: 0 inside, 1 outside of the box")},
};

void read_coarsen_box(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  read_title(cursor, options);
  while (!at_end(cursor)) {
    const auto row = cursor.read(coarsen_box_card);
    builder.model.coarsen.boxes.push_back(
        {{row->xmn, row->ymn, row->zmn}, {row->xmx, row->ymx, row->zmx}, row->iflag == 1});
  }
}

struct AdaptivityCard {
  int sn = 0, mn1 = 0, mn2 = 0;
};
const CardOf<AdaptivityCard> adaptivity_card{
    {&AdaptivityCard::sn, id("sn", IdSpace::node, required, "node on the side of a shell")},
    {&AdaptivityCard::mn1, id("mn1", IdSpace::node, required, "end of the side that it follows")},
    {&AdaptivityCard::mn2, id("mn2", IdSpace::node, required, "other end")},
};

void read_adaptivity(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(adaptivity_card);
    builder.defer(Phase::conditions, [row](Builder& b) {
      HangingNode h;
      h.node = b.node(row[&AdaptivityCard::sn]);
      h.ends = {b.node(row[&AdaptivityCard::mn1]), b.node(row[&AdaptivityCard::mn2])};
      h.place = row.place();
      if (h.node == none || h.ends[0] == none || h.ends[1] == none) return;
      const std::vector<Vec3d>& x = b.model.nodes.x;
      if (norm(x[h.ends[1]] - x[h.ends[0]]) == 0.0 || h.node == h.ends[0] || h.node == h.ends[1])
        return refuse(b, row[&AdaptivityCard::mn1], "the node and the ends of its side are not three places",
                      "name the corners of the shell's side on which the node lies");
      b.model.hanging_nodes.push_back(h);
    });
  }
}

}  // namespace

std::vector<Keyword> coarsening_keywords() {
  return {
      {.name = "CONTROL_COARSEN", .layout = {{"", &coarsen_card}, {"optional", &seed_card}}, .read = read_coarsen},
      {.name = "DEFINE_BOX_COARSEN",
       .options = {"TITLE"},
       .layout = {{"", &coarsen_box_card}},
       .read = read_coarsen_box},
      {.name = "CONSTRAINED_ADAPTIVITY", .layout = {{"", &adaptivity_card}}, .read = read_adaptivity},
  };
}

}  // namespace nugget::reading
