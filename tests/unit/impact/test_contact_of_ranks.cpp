// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "base/index.hpp"
#include "deck/deck.hpp"
#include "impact/contact/contact_setup.hpp"
#include "impact/simulation/simulation.hpp"
#include "reading/build.hpp"
#include "thread_ranks.hpp"
#include "weld/tie/ties.hpp"

// Contact that several ranks share: each makes the segments of its share only (docs/decisions/0141), and what is summed
// up travels as sums (docs/decisions/0142).
namespace nugget::impact {
namespace {

constexpr int along = 200, across = 60;  // so that ranks have rows of 1,024 nodes that touch for themselves

struct Text {
  std::string nodes, shells, solids;
  int next_node = 1, next_shell = 1;

  template <class... Values>
  static std::string line(const char* format, Values... values) {
    char text[200];
    std::snprintf(text, sizeof text, format, values...);
    return text;
  }
  /// A wavy sheet; its first node.
  int add_sheet(int part, double z) {
    const int first = next_node;
    for (int j = 0; j <= across; ++j)
      for (int i = 0; i <= along; ++i)
        nodes += line("%8d%16g%16g%16g\n", next_node++, 5.0 * i, 5.0 * j, z + 0.2 * ((7 * i + 3 * j) % 5));
    for (int j = 0; j < across; ++j)
      for (int i = 0; i < along; ++i) {
        const int n = first + j * (along + 1) + i;
        shells += line("%8d%8d%8d%8d%8d%8d\n", next_shell++, part, n, n + 1, n + along + 2, n + along + 1);
      }
    return first;
  }
  /// Two bricks, one on the other, that stand on the place.
  void add_bricks(double x, double z) {
    const int first = next_node;
    for (int level = 0; level < 3; ++level)
      for (const auto& [a, b] : {std::pair{0.0, 0.0}, {9.0, 0.0}, {9.0, 9.0}, {0.0, 9.0}})
        nodes += line("%8d%16g%16g%16g\n", next_node++, x + a, 21.0 + b, z + 8.0 * level);
    for (int n = first, e = 1; e <= 2; ++e, n += 4)
      solids += line("%8d%8d%8d%8d%8d%8d%8d%8d%8d%8d\n", e, 3, n, n + 1, n + 2, n + 3, n + 4, n + 5, n + 6, n + 7);
  }
  std::string deck(const std::string& contact) const {
    return "*KEYWORD\n*CONTROL_TERMINATION\n2.0e-5\n"
           "*PART\nlower\n1,1,1\n*PART\nupper\n2,2,1\n*PART\nbricks\n3,3,1\n"
           "*SECTION_SHELL\n1,2\n1.0,1.0,1.0,1.0\n*SECTION_SHELL\n2,2\n1.5,1.5,1.5,1.5\n*SECTION_SOLID\n3,1\n"
           "*MAT_ELASTIC\n1,7.85e-9,210000.0,0.3\n*SET_PART_LIST\n7\n2,3\n"
           "*INITIAL_VELOCITY_GENERATION\n2,2,0.0,4000.0,0.0,-2.0e5\n\n" +
           contact + "*NODE\n" + nodes + "*ELEMENT_SHELL\n" + shells + "*ELEMENT_SOLID\n" + solids + "*END\n";
  }
};

std::string two_sheets_and_bricks(const std::string& contact) {
  Text text;
  text.add_sheet(1, 0.0);
  text.add_sheet(2, 1.24);  // in touch: then the ranks cut both sheets at one place
  text.add_bricks(60.0, 5.0);
  return text.deck(contact);
}

const std::string single = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.1,0.1\n\n";
const std::string two_sides = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,7,3,2\n\n\n";
const std::string one_way = "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n7,1,2,3\n\n\n";
const std::string eroding = "*CONTROL_CONTACT\n\n,,,,1\n*CONTACT_ERODING_SINGLE_SURFACE\n0\n\n\n1,1,1\n";

struct DeckRun {
  Findings findings;
  model::Model model;
  weld::Ties ties;
  system::System system;
  explicit DeckRun(const std::string& text,
                   system::System::ElementsStart start = system::System::ElementsStart::at_once)
      : model(reading::build(deck::read_text(text, findings), findings)),
        ties(weld::tie(model, findings)),
        system(model, ties, findings, {}, start) {}
};

bool same(const contact::Segment& a, const contact::Segment& b) {
  return a.node == b.node && a.thickness == b.thickness && a.bulk_modulus == b.bulk_modulus && a.volume == b.volume &&
         a.mass == b.mass && a.scale == b.scale && a.element == b.element && a.covered_by == b.covered_by &&
         a.kind == b.kind && a.side == b.side;
}

bool same(const contact::TrackedNode& a, const contact::TrackedNode& b) {
  return a.node == b.node && a.thickness == b.thickness && a.against == b.against && a.stays_active == b.stays_active &&
         a.kind == b.kind;
}

/// What a setup says of the whole surface by its outline.
void expect_outline(const contact::SurfaceContactSetup& whole, const contact::SurfaceContactSetup& part,
                    std::span<const Row> x) {
  ASSERT_TRUE(part.whole.has_value());
  const contact::SurfaceOutline& outline = *part.whole;
  EXPECT_EQ(outline.segments, whole.segments.size());
  EXPECT_EQ(part.margin, contact::search_margin(whole, x));
  std::vector<unsigned> sides(outline.sides.size());
  double thickest = 0.0;
  bool covers = false;
  for (const contact::Segment& s : whole.segments) {
    for (const int n : s.node) sides[n] |= s.side;
    thickest = std::max(thickest, s.thickness);
    covers = covers || s.covered_by >= 0;
  }
  EXPECT_TRUE(std::ranges::equal(outline.sides, sides));
  EXPECT_EQ(outline.covers, covers);
  unsigned pressing = 0;
  ASSERT_EQ(outline.tracked.size(), whole.nodes.size());
  for (std::size_t i = 0; i < whole.nodes.size(); ++i) {
    const contact::TrackedNode& t = whole.nodes[i];
    EXPECT_EQ(outline.tracked[i], t.node);
    EXPECT_LE(t.thickness, outline.thickest_node);
    thickest = std::max(thickest, t.thickness);
    EXPECT_EQ(!outline.stays_active.empty() && outline.stays_active[t.node] != 0, t.stays_active);
    pressing |= t.against;
  }
  EXPECT_EQ(outline.pressing, pressing);
  EXPECT_EQ(outline.thickest_node, thickest);
}

TEST(ContactOfRanks, APartOfASurfaceIsThatOfTheWhole) {
  for (const std::string& contact : {single, two_sides, one_way, eroding}) {
    SCOPED_TRACE(contact);
    DeckRun run(two_sheets_and_bricks(contact));
    for (const Finding& f : run.findings.all()) EXPECT_NE(f.severity, Severity::error) << to_string(f);
    ASSERT_EQ(run.model.contacts.size(), 1u);
    const system::State state = run.system.initial_state();
    const model::Contact& card = run.model.contacts.front();
    const contact::SurfaceContactSetup whole = contact_setup(run.system, card);
    std::vector<char> wanted(run.system.nodes);
    std::mt19937 draw(5);
    for (char& node : wanted) node = draw() % 10 == 0;
    const auto is_wanted = [&](int n) { return wanted[n] != 0; };
    int asked = 0;
    const contact::SurfaceChoice choice{[&](const contact::Segment& s) {
                                          ++asked;
                                          return std::ranges::any_of(s.node, is_wanted);
                                        },
                                        is_wanted};
    const contact::SurfaceContactSetup part = contact_setup(run.system, card, &choice);
    EXPECT_EQ(at(asked), whole.segments.size());
    expect_outline(whole, part, state.x);
    std::vector<int> number;
    for (std::size_t s = 0; s < whole.segments.size(); ++s)
      if (std::ranges::any_of(whole.segments[s].node, is_wanted)) number.push_back(static_cast<int>(s));
    ASSERT_GT(number.size(), 100u);
    ASSERT_EQ(part.number, number);
    for (std::size_t i = 0; i < number.size(); ++i) EXPECT_TRUE(same(part.segments[i], whole.segments[number[i]]));
    std::vector<contact::TrackedNode> nodes = whole.nodes;
    std::erase_if(nodes, [&](const contact::TrackedNode& t) { return !is_wanted(t.node); });
    ASSERT_EQ(part.nodes.size(), nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_TRUE(same(part.nodes[i], nodes[i]));
  }
}

class Nobody : public Recorder {
 public:
  bool due(const system::State&) override { return false; }
  void write(const Snapshot&, bool) override {}
};

std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

TEST(ContactOfRanks, SegmentsComeWithTheShareAndSumsInPlaceOfWhatTheyAreMadeFrom) {
  const std::string text = two_sheets_and_bricks(single);
  DeckRun whole(text);
  Simulation alone(whole.system, whole.findings);
  Nobody nobody;
  const Options options{.max_cycles = 25};
  alone.run(options, nobody, {});
  const std::size_t segments = alone.components().contacts.all().front().surface().held();
  ASSERT_GT(std::abs(alone.energy().contact), 1.0);
  int rows_of_nodes = 0, rows_of_elements = 0;  // that others than the first rank sum up
  for (const int count : {2, 3}) {
    ThreadMessages messages;
    std::vector<std::unique_ptr<ThreadRanks>> ranks;
    std::vector<std::unique_ptr<DeckRun>> runs;
    std::vector<std::unique_ptr<Simulation>> simulations;
    for (int r = 0; r < count; ++r) {
      ranks.push_back(std::make_unique<ThreadRanks>(messages, count, r));
      runs.push_back(std::make_unique<DeckRun>(text, system::System::ElementsStart::with_share));
      simulations.push_back(std::make_unique<Simulation>(runs[r]->system, runs[r]->findings));
      // Sabotage to be caught: a contact that is made whole before anybody has a share.
      EXPECT_EQ(simulations[r]->components().contacts.all().front().surface().held(), 0u);
    }
    {
      std::vector<std::jthread> threads;
      for (int r = 0; r < count; ++r)
        threads.emplace_back([&, r] {
          Options shared = options;
          shared.ranks = ranks[r].get();
          Nobody nothing;
          simulations[r]->run(shared, nothing, {});
        });
    }
    std::size_t held = 0;
    for (int r = 0; r < count; ++r) {
      const std::size_t own = simulations[r]->components().contacts.all().front().surface().held();
      EXPECT_LT(own, segments);
      held += own;
      const system::System& system = runs[r]->system;
      for (std::size_t k = 0; k < system.nodes; ++k)
        if (system.follows(k)) {
          ASSERT_EQ(bits(simulations[r]->state().x[k].z), bits(alone.state().x[k].z));
          ASSERT_EQ(bits(simulations[r]->state().v[k].x), bits(alone.state().v[k].x));
        }
    }
    EXPECT_GE(held, segments);
    const system::SumsByRank& by_rank = *runs[0]->system.sums_by_rank();
    std::size_t before = 0;
    for (int k = 0; k < static_cast<int>(runs[0]->system.nodes); ++k) {
      if (by_rank.travels(k)) {
        ASSERT_EQ(by_rank.place_among_travelling(k), before++);
      } else {
        ASSERT_THROW(by_rank.place_among_travelling(k), std::logic_error);
      }
    }
    EXPECT_GT(before, 0u);
    EXPECT_LT(before, runs[0]->system.nodes);
    EXPECT_EQ(by_rank.travelling(), before);
    for (std::size_t i = 0; i < by_rank.rows_of_nodes(); ++i) rows_of_nodes += by_rank.of_nodes(i) > 0;
    for (std::size_t g = 0; g < runs[0]->system.groups.size(); ++g)
      for (std::size_t i = 0; i < by_rank.rows_of_elements(g); ++i) rows_of_elements += by_rank.of_elements(g, i) > 0;
    // Sabotage to be caught: a sum of another rank that is left out, or is that of other elements or nodes, or of other
    // nodes of the contact.
    const Energy &a = alone.energy(), &b = simulations[0]->energy();
    EXPECT_EQ(bits(b.kinetic), bits(a.kinetic));
    EXPECT_EQ(bits(b.internal), bits(a.internal));
    EXPECT_EQ(bits(b.hourglass), bits(a.hourglass));
    EXPECT_EQ(bits(b.contact), bits(a.contact));
    EXPECT_EQ(bits(b.step_change), bits(a.step_change));
    for (std::size_t p = 0; p < whole.model.parts.size(); ++p) {
      EXPECT_EQ(bits(simulations[0]->part_energies()[p].kinetic), bits(alone.part_energies()[p].kinetic));
      EXPECT_EQ(bits(simulations[0]->part_energies()[p].momentum.z), bits(alone.part_energies()[p].momentum.z));
    }
  }
  EXPECT_GT(rows_of_nodes, 0);
  EXPECT_GT(rows_of_elements, 0);
}

}  // namespace
}  // namespace nugget::impact
