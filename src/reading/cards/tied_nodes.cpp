// SPDX-License-Identifier: Apache-2.0
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *CONSTRAINED_TIED_NODES_FAILURE. Which nodes of a set stand at one place is found when the model is whole.
namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;

struct TiedNodesCard {
  int nsid = 0, etype = 0;
  double eppf = 0.0;
};
const CardOf<TiedNodesCard> tied_nodes_card{
    {&TiedNodesCard::nsid,
     id("nsid", IdSpace::set, required, "nodes of which those at one place move as one until the mesh tears there")},
    {&TiedNodesCard::eppf,
     real("eppf", dimension::number, required, above_zero(),
          "plastic strain at which it tears, in the mean of the elements at that place; of GISSMO its damage")},
    {&TiedNodesCard::etype, integer("etype", 0, between(0, 1), "elements that count: 0 shells, 1 solids")},
};

void read_tied_nodes(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(tied_nodes_card);
    builder.defer(Phase::conditions, [row](Builder& b) {
      const Set<Index>* set = b.node_set(row[&TiedNodesCard::nsid]);
      if (set == nullptr) return;
      TiedNodes tied;
      tied.set = row->nsid;
      tied.nodes = set->members;
      tied.failure = row->eppf;
      tied.kind = row->etype == 1 ? ElementKind::solid : ElementKind::shell;
      tied.place = row.place();
      b.model.tied_nodes.push_back(std::move(tied));
    });
  }
}

}  // namespace

std::vector<Keyword> tied_node_keywords() {
  return {{.name = "CONSTRAINED_TIED_NODES_FAILURE", .layout = {{{}, &tied_nodes_card}}, .read = read_tied_nodes}};
}

}  // namespace nugget::reading
