// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "base/index.hpp"
#include "model/segments.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *NODE_MERGE_SET and *NODE_MERGE_TOLERANCE: nodes at one place become one.
namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

const CardOf<NodeMergeCard> merge_card{
    {&NodeMergeCard::nsid,
     id("nsid", IdSpace::set, required, "node set: of its nodes those that lie together become one")},
};
struct ToleranceCard {
  double tolr = 0;
};
const CardOf<ToleranceCard> tolerance_card{
    {&ToleranceCard::tolr, real("tolr", dimension::length, 0, at_least(0),
                                "nodes so near to each other are merged; 0: 1e-5 of the sum of the sides of the "
                                "model's box over twice the root of the number of nodes")},
};

/// Which node stands for each one, while pairs are joined: the one with the smaller index, so the smaller id.
class Representatives {
 public:
  explicit Representatives(std::size_t count) : of_(count) { std::iota(of_.begin(), of_.end(), Index{0}); }
  Index find(Index n) {
    while (of_[at(n)] != n) n = of_[at(n)] = of_[at(of_[at(n)])];
    return n;
  }
  void join(Index a, Index b) {
    a = find(a);
    b = find(b);
    of_[at(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<Index> of_;
};

double tolerance_of(const Nodes& nodes, double given) {
  if (given > 0.0) return given;
  Vec3d low = nodes.x.front(), high = low;
  for (const Vec3d& p : nodes.x) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3d side = high - low;
  return 1e-5 * (side.x + side.y + side.z) / (2.0 * std::sqrt(static_cast<double>(nodes.size())));
}

/// Joins nodes of a set that are no farther apart than the tolerance: with the nodes in order of x only few are near.
void join_near(const Nodes& nodes, std::vector<Index> set, double tolerance, Representatives& joined) {
  const auto x = [&](Index n) { return nodes.x[at(n)]; };
  std::sort(set.begin(), set.end(), [&](Index a, Index b) { return std::pair(x(a).x, a) < std::pair(x(b).x, b); });
  for (std::size_t i = 0; i < set.size(); ++i)
    for (std::size_t j = i + 1; j < set.size() && x(set[j]).x - x(set[i]).x <= tolerance; ++j)
      if (norm(x(set[j]) - x(set[i])) <= tolerance) joined.join(set[i], set[j]);
}

/// Everything in the model and the builder that has nodes by then: what is read later finds them by their ids.
class Merged {
 public:
  Merged(Builder& b, const std::vector<Index>& to, const deck::Entry& field) : b_(b), to_(to), field_(field) {}

  void apply() {
    shells();
    solids();
    beams();
    Model& m = b_.model;
    for (Discrete& d : m.discretes) {
      each(d.node);
      if (!d.grounded() && d.node[0] == d.node[1]) refuse_element("spring", d.id);
    }
    for (auto& mass : m.masses) one(mass.node);
    for (auto& inertia : m.inertias) one(inertia.node);
    for (auto& spc : m.spcs) one(spc.node);
    for (auto& a : m.accelerometers) each(a.node);
    for (auto& o : m.spring_orientations) each(o.node);
    for (CoordinateSystem& s : m.systems)
      if (s.nodes)
        for (Index* n : {&s.nodes->origin, &s.nodes->on_axis, &s.nodes->in_plane}) one(*n);
    for (auto& set : m.sets.nodes) {
      each(set.members);
      keep_first(set.members);
    }
    for (auto& set : m.sets.segments)
      for (Segment& s : set.members) {
        each(s);
        if (!bring_triangle_into_form(s)) refuse_element("a segment of set", set.id);
      }
    for (std::size_t n = 0; n < to_.size(); ++n)
      if (at(to_[n]) != n) b_.nodes.give(m.nodes.id[n], to_[n]);
  }

 private:
  void one(Index& n) const {
    if (n != none) n = to_[at(n)];
  }
  void each(auto& nodes) const {
    for (Index& n : nodes) one(n);
  }
  static void keep_first(std::vector<Index>& members) {
    std::vector<Index> kept;
    std::set<Index> seen;
    for (const Index n : members)
      if (seen.insert(n).second) kept.push_back(n);
    members = std::move(kept);
  }
  void refuse_element(std::string_view what, int id) {
    refuse(b_, field_, fmt::format("{} {} would lose a side: two of its nodes are merged", what, id),
           "give a smaller TOLR, or leave its nodes out of the set");
  }

  void shells() {
    Shells& shells = b_.model.shells;
    for (std::size_t e = 0; e < shells.size(); ++e) {
      each(shells.node[e]);
      if (!bring_triangle_into_form(shells.node[e])) refuse_element("shell", shells.id[e]);
    }
  }
  /// A brick that loses an edge is refused: not all that come of it have a form of their own.
  void solids() {
    Solids& solids = b_.model.solids;
    const auto different = [](auto nodes) {
      std::sort(nodes.begin(), nodes.end());
      return std::unique(nodes.begin(), nodes.end()) - nodes.begin();
    };
    const auto merge = [&](auto& nodes, std::size_t e) {
      const auto before = different(nodes);
      each(nodes);
      if (different(nodes) != before) refuse_element("solid", solids.id[e]);
    };
    for (std::size_t e = 0; e < solids.size(); ++e) {
      merge(solids.node[e], e);
      if (e < solids.ten_row.size() && solids.ten_row[e] != none) merge(solids.ten_nodes[at(solids.ten_row[e])], e);
    }
  }
  void beams() {
    Beams& beams = b_.model.beams;
    each(beams.orientation);
    for (std::size_t e = 0; e < beams.size(); ++e) {
      each(beams.node[e]);
      if (beams.node[e][0] == beams.node[e][1]) refuse_element("beam", beams.id[e]);
    }
  }

  Builder& b_;
  const std::vector<Index>& to_;
  deck::Entry field_;
};

/// All sets of the deck at once: after the last of them nodes have their final places and sets their members.
void merge_nodes(Builder& b) {
  const Nodes& nodes = b.model.nodes;
  if (nodes.size() == 0) return;
  const double tolerance = tolerance_of(nodes, b.merge_tolerance);
  Representatives joined(nodes.size());
  for (const RowOf<NodeMergeCard>& row : b.merge_rows)
    if (const auto* set = b.node_set(row[&NodeMergeCard::nsid])) {
      Representatives before = joined;
      join_near(nodes, set->members, tolerance, joined);
      long merged = 0;
      for (const Index n : set->members) merged += before.find(n) == n && joined.find(n) != n ? 1 : 0;
      row[&NodeMergeCard::nsid].report(
          b.findings, merged > 0 ? Severity::note : Severity::warning,
          fmt::format("{} of {} nodes are merged with others within {:.4g}", merged, set->members.size(), tolerance));
    }
  std::vector<Index> to(nodes.size());
  for (std::size_t n = 0; n < to.size(); ++n) to[n] = joined.find(static_cast<Index>(n));
  Merged(b, to, b.merge_rows.front()[&NodeMergeCard::nsid]).apply();
}

void read_merge_set(Builder& builder, const Block& block, const Options&) {
  if (builder.merge_rows.empty())
    // Left behind twice: behind the sets and what moves nodes.
    builder.defer(Phase::sets, [](Builder& b) { b.defer(Phase::sets, merge_nodes); });
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);)
    builder.merge_rows.push_back(cursor.read(merge_card));
}

void read_tolerance(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  builder.merge_tolerance = cursor.read(tolerance_card)->tolr;
  expect_end(builder, cursor);
}

}  // namespace

std::vector<Keyword> node_merge_keywords() {
  return {
      {.name = "NODE_MERGE_SET", .layout = {{"", &merge_card}}, .read = read_merge_set},
      {.name = "NODE_MERGE_TOLERANCE", .layout = {{"", &tolerance_card}}, .read = read_tolerance},
  };
}

}  // namespace nugget::reading
