// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/index.hpp"
#include "deck/deck.hpp"

// Any bytes are a deck: they may be refused, but never crash the reader. Every block is walked by cards as the model's
// readers do, and the bulk tables must stay rectangular.
namespace {

using namespace nugget;

const Card numbers{{integer("a", 0, at_least(0), "an integer"),
                    real("b", dimension::stress, 1.0, above_zero(), "a real"),
                    id("c", IdSpace::part, required, "an id"), unused(), text("d", 10, "a text"),
                    wide(real("e", dimension::length, required, any_value, "a wide real"), 16)}};
const Card heading{{id("id", IdSpace::set, 0, "an id"), text("heading", 70, "a heading")}};

void walk(const deck::Deck& deck, const deck::Block& block, Findings& findings) {
  deck::Cursor cursor(deck, block, findings);
  for (int card = 0; cursor.more(); ++card) {
    cursor.peek();
    cursor.peek_number(at(card % 9));
    switch (card % 4) {
      case 0: cursor.read(numbers).integer("c"); break;
      case 1: cursor.read(heading).text("heading"); break;
      case 2: cursor.read_text(); break;
      default: cursor.skip();
    }
  }
  cursor.read(numbers);
  deck::Cursor(deck, block, findings).read_ids(IdSpace::node);
}

void require(bool holds) {
  if (!holds) std::abort();
}

void check(const deck::ElementTable& t) {
  const std::size_t n = t.id.size();
  require(t.part.size() == n && t.line.size() == n && t.file.size() == n);
  require(t.node.size() == n * at(t.nodes_per_element));
  const auto fits = [n](const auto& column) { return column.empty() || column.size() == n; };
  require(fits(t.thickness) && fits(t.angle) && fits(t.system) && fits(t.offset));
  require(fits(t.tied_parts) && fits(t.orientation) && fits(t.section));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Findings findings;
  const deck::Deck deck =
      deck::read_text(std::string(reinterpret_cast<const char*>(data), size), findings, "/nonexistent/folder");
  deck::NodeTable nodes;
  deck::ElementTable shells, solids, beams;
  for (const deck::Block& block : deck.blocks) {
    walk(deck, block, findings);
    if (block.keyword == "NODE") deck::read_nodes(deck, block, nodes, findings);
    if (block.keyword.starts_with("ELEMENT_SHELL")) deck::read_shells(deck, block, shells, findings);
    if (block.keyword.starts_with("ELEMENT_SOLID")) deck::read_solids(deck, block, solids, findings);
    if (block.keyword.starts_with("ELEMENT_BEAM")) deck::read_beams(deck, block, beams, findings);
  }
  require(nodes.x.size() == nodes.id.size() && nodes.tc.size() == nodes.id.size() &&
          nodes.line.size() == nodes.id.size());
  check(shells);
  check(solids);
  check(beams);
  for (const Finding& finding : findings.all()) require(!to_string(finding).empty());
  return 0;
}
