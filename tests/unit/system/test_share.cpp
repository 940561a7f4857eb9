// SPDX-License-Identifier: Apache-2.0
#include "system/share.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <thread>

#include "base/index.hpp"
#include "deck/deck.hpp"
#include "reading/build.hpp"
#include "system/followers.hpp"
#include "system/ghost_nodes.hpp"
#include "thread_ranks.hpp"

namespace nugget::system {
namespace {

constexpr std::size_t side = 24;

/// A bent sheet of side x side shells, and more keywords.
std::string text_of_sheet(const std::string& more) {
  std::string nodes, shells;
  char line[160];
  const int row = static_cast<int>(side) + 1;
  for (int j = 0; j < row; ++j)
    for (int i = 0; i < row; ++i) {
      std::snprintf(line, sizeof line, "%8d%16g%16g%16g\n", row * j + i + 1, 10.0 * i, 10.0 * j, 0.01 * i * i);
      nodes += line;
    }
  for (int j = 0; j < row - 1; ++j)
    for (int i = 0; i < row - 1; ++i) {
      const int n = row * j + i + 1;
      std::snprintf(line, sizeof line, "%8d%8d%8d%8d%8d%8d\n", (row - 1) * j + i + 1, 1, n, n + 1, n + row + 1,
                    n + row);
      shells += line;
    }
  return "*KEYWORD\n*CONTROL_TERMINATION\n1e-3\n*PART\nsheet\n1,1,1\n*SECTION_SHELL\n1,2\n1.0,1.0,1.0,1.0\n"
         "*MAT_ELASTIC\n1,7.85e-9,210000.0,0.3\n*NODE\n" +
         nodes + "*ELEMENT_SHELL\n" + shells + more + "*END\n";
}

struct Sheet {
  Findings findings;
  model::Model model;
  weld::Ties ties;
  System system;
  State state;
  explicit Sheet(const std::string& more = {}, System::ElementsStart start = System::ElementsStart::at_once)
      : model(reading::build(deck::read_text(text_of_sheet(more), findings), findings)),
        ties(weld::tie(model, findings)),
        system(model, ties, findings, {}, start),
        state(system.initial_state()) {}
  /// Two steps in random motion, the same in each sheet; nodes that this process does not follow get no velocity.
  void move() {
    std::mt19937 draw(7);
    std::uniform_real_distribution<double> speed(-1e3, 1e3);
    std::vector<Row> v(state.v.size());
    for (Row& row : v) row = {speed(draw), speed(draw), speed(draw), 0.0};
    system.for_each_node(64, [&](std::size_t begin, std::size_t end) {
      std::copy(v.begin() + static_cast<std::ptrdiff_t>(begin), v.begin() + static_cast<std::ptrdiff_t>(end),
                state.v.begin() + static_cast<std::ptrdiff_t>(begin));
    });
    state.dt = 1e-7;
    for (int step = 0; step < 2; ++step) {
      system.for_each_node(64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) add(state.x[k], state.dt * vec(state.v[k]));
      });
      system.internal_force(state);
      system.exchange_sums(state);
    }
  }
};

void each_element(const System& system, const std::function<void(int, std::size_t)>& visit) {
  for (std::size_t g = 0; g < system.groups.size(); ++g)
    for (std::size_t e = 0; e < system.groups[g]->size(); ++e) visit(static_cast<int>(g), e);
}

/// Each rank with a sheet of its own, moved, in a thread where `together` is done at last; `look` sees them afterwards,
/// one after the other.
void over_ranks(
    int count, bool followed_by_all, const std::function<void(int, Sheet&)>& look,
    const std::function<void(int, Sheet&)>& together = [](int, Sheet&) {}) {
  ThreadMessages messages;
  std::vector<std::unique_ptr<Sheet>> sheets(at(count));
  std::vector<std::unique_ptr<ThreadRanks>> ranks;
  std::vector<Partition> partitions;  // not in the threads: METIS draws its random numbers for the whole process
  for (int r = 0; r < count; ++r) {
    sheets[r] = std::make_unique<Sheet>("", System::ElementsStart::with_share);
    ranks.push_back(std::make_unique<ThreadRanks>(messages, count, r));
    partitions.emplace_back(sheets[r]->system, count, std::span<const System::ElementLocation>());
  }
  {
    std::vector<std::jthread> threads;
    for (int r = 0; r < count; ++r)
      threads.emplace_back([&, r] {
        Sheet& sheet = *sheets[r];
        const std::vector<char> followed(sheet.system.nodes, followed_by_all);
        sheet.system.share_out(*ranks[r], partitions[r], followed);
        sheet.move();
        sheet.system.collect(Carried::results, {}, [&](const System::Computed& of, Parcel& parcel) {
          each_element(sheet.system, [&](int g, std::size_t e) {
            if (of(g, e)) sheet.system.carry_forces({g, static_cast<int>(e)}, parcel);
          });
        });
        together(r, sheet);
      });
  }
  for (int r = 0; r < count; ++r) look(r, *sheets[r]);
}

bool same(const Row& a, const Row& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

// Sabotage to be caught: a slot that is not sent, one in the wrong place, slots of others added behind the own ones.
TEST(Share, ForcesHaveTheBitsOfOneProcess) {
  Sheet alone;
  alone.move();
  for (const bool followed_by_all : {false, true})
    for (const int count : {2, 3, 5}) {
      std::vector<int> followers(alone.system.nodes, 0);
      over_ranks(count, followed_by_all, [&](int, Sheet& sheet) {
        sheet.system.for_each_node(64, [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k) {
            ++followers[k];
            EXPECT_TRUE(same(sheet.state.f[k], alone.state.f[k]) && same(sheet.state.m[k], alone.state.m[k])) << k;
          }
        });
      });
      for (const int n : followers) EXPECT_TRUE(followed_by_all ? n == count : n >= 1 && n <= count);
      if (!followed_by_all) {
        EXPECT_LT(std::count_if(followers.begin(), followers.end(), [](int n) { return n > 1; }), 150);
      }
    }
}

// Each rank looks at every seventh node; what it does not follow has the place and the velocity that its followers give
// it.
TEST(Share, GhostsAreWhereTheirFollowersHaveThem) {
  Sheet alone;
  alone.move();
  for (const int count : {2, 3, 5}) {
    std::vector<std::size_t> ghosts(at(count));
    const auto look_around = [&](int rank, Sheet& sheet) {
      const Share& share = *sheet.system.share();
      std::vector<int> wanted;
      for (int k = 0; k < static_cast<int>(sheet.system.nodes); k += 7) wanted.push_back(k);
      GhostNodes nodes;
      nodes.ask_for(share, wanted);
      nodes.fetch(share, sheet.state.x, sheet.state.v);
      ghosts[rank] = nodes.size();
      for (const int k : wanted)
        EXPECT_TRUE(same(sheet.state.x[k], alone.state.x[k]) && same(sheet.state.v[k], alone.state.v[k])) << k;
    };
    over_ranks(
        count, false, [](int, Sheet&) {}, look_around);
    for (const std::size_t n : ghosts) EXPECT_GT(n, 20u);
  }
}

// Nodal forces come where somebody asks for them. Sabotage: those of the next element.
TEST(Share, TheFirstRankCollectsWhatOthersComputed) {
  Sheet alone;
  alone.move();
  over_ranks(3, false, [&](int rank, Sheet& sheet) {
    if (rank != 0) return;
    for (std::size_t g = 0; g < alone.system.groups.size(); ++g)
      for (std::size_t e = 0; e < alone.system.groups[g]->size(); ++e) {
        const ElementGroup &one = *alone.system.groups[g], &shared = *sheet.system.groups[g];
        EXPECT_EQ(shared.internal_energy(e), one.internal_energy(e));
        EXPECT_EQ(shared.layer(e, 0, alone.state).stress, one.layer(e, 0, alone.state).stress);
        const System::ElementLocation place{static_cast<int>(g), static_cast<int>(e)};
        EXPECT_EQ(sheet.system.nodal_force(place, 2).z, alone.system.nodal_force(place, 2).z);
      }
  });
}

/// For an archive that goes nowhere.
class ToNowhere final : public Archive {
 public:
  ToNowhere() : Archive(false) {}

 private:
  void bytes(void*, std::size_t) override {}
};

// Sabotage: `leave` that leaves nothing; energies that are not those of the element.
TEST(Share, ARankHasTheStatesOfItsShareOnly) {
  Sheet alone;
  alone.move();
  for (const int count : {2, 3, 5}) {
    std::size_t here = 0;
    over_ranks(
        count, false,
        [&](int rank, Sheet& sheet) {
          // Results had come to the first rank, which has left them again.
          const Partition& partition = sheet.system.share()->partition();
          std::size_t own = 0;
          each_element(sheet.system, [&](int g, std::size_t e) { own += partition.of_element(g, e) == rank; });
          EXPECT_EQ(side * side - sheet.system.elements_elsewhere(), own);
          EXPECT_LE(own, side * side / at(count) + 24);
          here += own;
          ToNowhere file;
          EXPECT_THROW(file(sheet.system), std::logic_error);
          each_element(sheet.system, [&](int g, std::size_t e) {
            const ElementGroup &one = *alone.system.groups[g], &shared = *sheet.system.groups[g];
            EXPECT_TRUE(shared.alive(e));
            EXPECT_EQ(shared.mass_scale(e), 1.0);
            if (rank != 0) return;
            EXPECT_EQ(shared.internal_energy(e), one.internal_energy(e)) << e;
            EXPECT_EQ(shared.hourglass_energy(e), one.hourglass_energy(e)) << e;
          });
        },
        [](int, Sheet& sheet) {
          sheet.system.leave_to_others();
          EXPECT_GT(sheet.system.elements_elsewhere(), side * side / 3);  // on the first rank as well
          sheet.system.collect(Carried::energies, {}, [](const System::Computed&, Parcel&) {});
        });
    EXPECT_EQ(here, side * side);
  }
}

// What others do to elements that are elsewhere. Sabotage: `leave` that leaves nothing.
TEST(Share, WhatHappensToElementsElsewhereIsKnown) {
  over_ranks(
      2, false,
      [](int rank, Sheet& sheet) {
        ElementGroup& group = *sheet.system.groups[0];
        const Partition& partition = sheet.system.share()->partition();
        std::size_t other = 0;
        while (partition.of_element(0, other) == rank) ++other;
        const std::size_t block = other / group.block_width();
        group.take_step(other, 1e-9);
        EXPECT_EQ(group.stable_step(other), 1e-9);
        EXPECT_EQ(group.block_step[block], 1e-9);
        group.release_step(other);
        EXPECT_TRUE(std::isinf(group.block_step[block]));
        group.scale_mass(other, 2.5);
        EXPECT_EQ(group.mass_scale(other), 2.5);
        EXPECT_EQ(group.mass_scale(other + 1), 1.0);
        group.remove(other);
        EXPECT_FALSE(group.alive(other));
        EXPECT_TRUE(group.alive(other + 1));
        EXPECT_EQ(side * side - group.elsewhere(), sheet.system.share()->blocks().size() * group.block_width());
      },
      [](int, Sheet& sheet) { sheet.system.leave_to_others(); });
}

// Of a square of 24 x 24 shells two ranks share a line of 25 nodes at best, whatever the machine.
TEST(Partition, CutsASquareInHalves) {
  const Sheet sheet;
  const Partition halves(sheet.system, 2, {});
  const std::vector<Partition::Share> shares = halves.shares(sheet.system, {});
  for (const Partition::Share& share : shares) {
    EXPECT_NEAR(static_cast<double>(share.elements), 288.0, 8.0);
    EXPECT_GE(share.shared_nodes, 25u);
    EXPECT_LE(share.shared_nodes, 40u);
    EXPECT_NEAR(share.cost, 1.0, 0.03);
    EXPECT_EQ(share.neighbours.size(), 1u);
  }
  const Partition again(sheet.system, 2, {});
  for (std::size_t e = 0; e < side * side; ++e) EXPECT_EQ(again.of_element(0, e), halves.of_element(0, e));
}

// Contact in one quarter of the square: each rank has half of the shells and half of the contact.
TEST(Partition, BalancesContactAsWell) {
  const Sheet sheet;
  ContactCosts contact{std::vector<double>(sheet.system.all_nodes()), {}};
  for (std::size_t e = 0; e < side * side; ++e)
    if (e % side < side / 2 && e / side < side / 2)
      for (const int node : sheet.system.groups[0]->nodes(e)) contact.of_node[at(node)] = 5.0;
  for (const Partition::Share& share : Partition(sheet.system, 2, {}, contact).shares(sheet.system, {})) {
    EXPECT_NEAR(share.cost, 1.0, 0.06);
    EXPECT_NEAR(share.contact, 1.0, 0.1);
    EXPECT_LE(share.shared_nodes, 60u);
  }
}

// After a restart: the deleted quarter of a sheet costs nothing.
TEST(Partition, DeletedElementsCostNothing) {
  Sheet sheet;
  for (std::size_t e = 0; e < side * side; ++e)
    if (e % side < side / 2 && e / side < side / 2) sheet.system.groups[0]->remove(e);
  const Partition partition(sheet.system, 2, {});
  std::array<int, 2> alive{};
  for (std::size_t e = 0; e < side * side; ++e)
    if (sheet.system.groups[0]->alive(e)) ++alive[at(partition.of_element(0, e))];
  EXPECT_NEAR(alive[0], 0.375 * side * side, 12);
  EXPECT_NEAR(alive[1], 0.375 * side * side, 12);
}

// What rests on each other is not parted: with two opposite edges joined the cut runs from the one to the other.
TEST(Partition, KeepsTogetherWhatRestsOnEachOther) {
  const Sheet sheet;
  for (const bool rows : {true, false}) {
    const auto element = [rows](std::size_t along, std::size_t across) {
      return rows ? along * side + across : across * side + along;
    };
    ContactCosts contact{std::vector<double>(sheet.system.all_nodes(), 1.0), {}};
    for (std::size_t i = 0; i < side; ++i)
      for (int k = 0; k < 20; ++k)
        contact.together.push_back(
            {sheet.system.groups[0]->nodes(element(i, 0))[0], sheet.system.groups[0]->nodes(element(i, side - 1))[0]});
    const Partition partition(sheet.system, 2, {}, contact);
    std::size_t together = 0;
    for (std::size_t i = 0; i < side; ++i)
      together += partition.of_element(0, element(i, 0)) == partition.of_element(0, element(i, side - 1));
    EXPECT_GE(together, side - 2) << (rows ? "rows" : "columns");
  }
}

TEST(Partition, ElementsThatAreLookedAtAreEveryones) {
  const Sheet sheet;
  const std::vector<System::ElementLocation> looked_at{{0, 100}};
  const Partition partition(sheet.system, 3, looked_at);
  EXPECT_EQ(partition.of_element(0, 100), Partition::everyone);
  EXPECT_EQ(partition.elements_of_everyone(sheet.system), Partition::unit_size(*sheet.system.groups[0]));
}

// The elements of a weld, say, in two units or in three that hang together; as many as there are hang together for all.
TEST(Partition, OneRankHasWhatOneLooksAt) {
  const Sheet sheet;
  const std::size_t last = side * side - 1, middle = 284;
  const auto list = [](std::initializer_list<std::size_t> elements) {
    std::vector<System::ElementLocation> all;
    for (const std::size_t e : elements) all.push_back({0, static_cast<int>(e)});
    return all;
  };
  using Lists = std::vector<std::vector<System::ElementLocation>>;
  const Lists apart{list({0, last})}, chained{list({0, middle}), list({middle + 1, last})};
  EXPECT_NE(Partition(sheet.system, 4, {}).of_element(0, 0), Partition(sheet.system, 4, {}).of_element(0, last));
  for (const Lists& lists : {apart, chained}) {
    const Partition partition(sheet.system, 4, {}, {}, lists);
    EXPECT_EQ(partition.of_element(0, 0), partition.of_element(0, last));
    EXPECT_NE(partition.of_element(0, 0), Partition::everyone);
    EXPECT_TRUE(lists.size() == 1 || partition.of_element(0, 0) == partition.of_element(0, middle));
  }
  Lists long_chain;
  for (std::size_t e = 0; e + 8 <= last; e += 8) long_chain.push_back(list({e, e + 8}));
  const Partition whole(sheet.system, 4, {}, {}, long_chain);
  EXPECT_EQ(whole.elements_of_everyone(sheet.system), side * side);
}

// A node that hangs between two corners of the sheet is followed, like them, by the ranks of both: its force goes
// there.
TEST(Followers, ThoseOfATiedNodeFollowWhatItFollows) {
  const Sheet sheet(
      "*NODE\n    9001           120.0           120.0            2.88\n*CONSTRAINED_ADAPTIVITY\n9001,1,625\n");
  ASSERT_EQ(sheet.findings.errors(), 0u);
  const auto node = [&](int id) {
    return at(sheet.system.node_of[std::ranges::find(sheet.model.nodes.id, id) - sheet.model.nodes.id.begin()]);
  };
  for (const int ranks : {2, 4}) {
    const Partition partition(sheet.system, ranks, {});
    const FollowersOfNodes of_node(sheet.system, partition, {});
    const Followers first = of_node[node(1)], second = of_node[node(625)], between = of_node[node(9001)];
    ASSERT_EQ(first.owners.size() + second.owners.size(), 2u);
    ASSERT_FALSE(std::ranges::equal(first.owners, second.owners));
    EXPECT_TRUE(between.owners.empty());
    for (const Followers* one : {&first, &second, &between}) {
      EXPECT_FALSE(one->all);
      EXPECT_EQ(one->owners.size() + one->others.size(), 2u);
      EXPECT_TRUE(one->has(first.owners.front()) && one->has(second.owners.front()));
    }
    EXPECT_TRUE(of_node[node(313)].others.empty());
  }
  std::vector<char> for_everyone(sheet.system.nodes, 0);
  for_everyone[node(625)] = 1;
  const FollowersOfNodes of_node(sheet.system, Partition(sheet.system, 2, {}), for_everyone);
  EXPECT_TRUE(of_node[node(1)].all && of_node[node(9001)].all);
}

TEST(Partition, MoreRanksThanUnits) {
  const Sheet sheet;
  const Partition partition(sheet.system, 200, {});
  std::size_t sum = 0;
  for (const Partition::Share& share : partition.shares(sheet.system, {})) sum += share.elements;
  EXPECT_EQ(sum, side * side);
}

}  // namespace
}  // namespace nugget::system
