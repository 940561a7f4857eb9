// SPDX-License-Identifier: Apache-2.0
#include "reading/bodies/seams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"

namespace nugget::reading {

AdjoiningElements::AdjoiningElements(const Model& model) : sum_(model.nodes.size()), count_(model.nodes.size(), 0) {
  const auto add = [&](const auto& elements) {
    for (std::size_t e = 0; e < elements.size(); ++e) {
      Vec3d middle;
      double corners = 0.0;
      for (const Index n : elements.nodes(e)) {
        if (n == none) continue;
        middle += model.nodes.x[n];
        corners += 1.0;
      }
      for (const Index n : elements.nodes(e)) {
        if (n == none) continue;
        sum_[n] += (1.0 / corners) * middle;
        ++count_[n];
      }
    }
  };
  add(model.shells);
  add(model.solids);
}

namespace {

/// Makes the seams of one weld.
class SeamMaker {
 public:
  SeamMaker(Builder& builder, const BodyCards::Weld& card, const AdjoiningElements& around, RigidWeld& weld)
      : b_(builder), card_(card), around_(around), weld_(weld) {}

  bool make() {
    const int errors = b_.findings.errors();
    if (weld_.kind == RigidWeld::Kind::fillet || weld_.kind == RigidWeld::Kind::butt)
      make_chain();
    else
      for (const BodyCards::Seam& seam : card_.seams) make_pair(seam);
    if (b_.findings.errors() == errors) check_pairs();
    return b_.findings.errors() == errors;
  }

 private:
  /// The nodes of the set, one after the other.
  void make_chain() {
    const std::size_t count = weld_.nodes.size(), most = weld_.kind == RigidWeld::Kind::butt ? 2 : 3;
    if (count < 2 || count > most)
      return refuse(b_, card_.first,
                    fmt::format("a {} weld joins {}, the set has {}", most == 2 ? "butt" : "fillet",
                                most == 2 ? "two nodes" : "two or three nodes", count),
                    "write a weld for each pair of nodes along the seam");
    for (std::size_t i = 0; i + 1 < count; ++i) add(card_.seams.front(), {i, i + 1});
  }

  void make_pair(const BodyCards::Seam& seam) {
    std::array<std::size_t, 2> nodes{};
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      const deck::Entry& field = k == 0 ? seam.first : seam.second;
      const Index node = b_.node(field);
      if (node == none) return;
      const auto at = std::find(weld_.nodes.begin(), weld_.nodes.end(), node);
      if (at == weld_.nodes.end())
        return refuse(b_, field, fmt::format("node {} is not in the set of the weld", field.integer()),
                      "add it to the set NSID");
      nodes[k] = static_cast<std::size_t>(at - weld_.nodes.begin());
    }
    if (nodes[0] == nodes[1]) return refuse(b_, seam.second, "a pair is two different nodes");
    add(seam, nodes);
  }

  void add(const BodyCards::Seam& card, std::array<std::size_t, 2> nodes) {
    model::Seam seam = card.seam;
    seam.nodes = nodes;
    if (const Index system = b_.system(card.system); system != none) {
      const Frame3d& axes = b_.model.systems[system].axes;
      seam.tension = card.butt ? axes.e1 : axes.e3;
      seam.normal = card.butt ? axes.e1 : std::cos(card.angle) * axes.e3 - std::sin(card.angle) * axes.e1;
      if (against(seam)) std::swap(seam.nodes[0], seam.nodes[1]);
    } else if (seam.strength > 0.0 && card.system.integer() == 0) {
      refuse(b_, card.system, "brittle failure (SIGY) needs the directions of the weld",
             card.butt
                 ? "give a coordinate system: x across the weld, in the sheets, y along it"
                 : "give a coordinate system: z from one sheet to the other, y along the weld, x towards its face");
    }
    weld_.seams.push_back(seam);
  }

  /// Whether the sheet of the second node lies against the tensile direction; where neither sheets nor nodes tell, the
  /// order of the deck holds.
  bool against(const model::Seam& seam) const {
    const Index first = weld_.nodes[seam.nodes[0]], second = weld_.nodes[seam.nodes[1]];
    const bool sheets = around_.any(first) && around_.any(second);
    const Vec3d way =
        sheets ? around_.middle(second) - around_.middle(first) : b_.model.nodes.x[second] - b_.model.nodes.x[first];
    return dot(way, seam.tension) < -1e-6 * norm(way);
  }

  void check_pairs() {
    std::vector<char> paired(weld_.nodes.size(), 0);
    for (const model::Seam& seam : weld_.seams)
      for (const std::size_t node : seam.nodes) paired[node] = 1;
    if (const auto alone = std::find(paired.begin(), paired.end(), 0); alone != paired.end())
      refuse(b_, card_.first,
             fmt::format("node {} of the set is in no pair, so that it is welded to no other node",
                         b_.model.nodes.id[weld_.nodes[static_cast<std::size_t>(alone - paired.begin())]]),
             "give it a pair, or take it out of the set");
    for (const model::Seam& a : weld_.seams)
      for (const model::Seam& b : weld_.seams)
        if (!share_a_node(a, b)) return refuse_two_groups(a, b);
  }

  static bool share_a_node(const model::Seam& a, const model::Seam& b) {
    return std::any_of(a.nodes.begin(), a.nodes.end(),
                       [&](std::size_t n) { return n == b.nodes[0] || n == b.nodes[1]; });
  }

  void refuse_two_groups(const model::Seam& a, const model::Seam& b) {
    const auto name = [&](const model::Seam& seam) {
      return fmt::format("{}-{}", b_.model.nodes.id[weld_.nodes[seam.nodes[0]]],
                         b_.model.nodes.id[weld_.nodes[seam.nodes[1]]]);
    };
    refuse(
        b_, card_.first,
        fmt::format("pairs {} and {} have no node in common: where others fail, two bodies would be left of this weld, "
                    "which is not built",
                    name(a), name(b)),
        "divide it into welds whose pairs meet in a node, or are the three of a triangle");
  }

  Builder& b_;
  const BodyCards::Weld& card_;
  const AdjoiningElements& around_;
  RigidWeld& weld_;
};

}  // namespace

bool make_seams(Builder& builder, const BodyCards::Weld& card, const AdjoiningElements& around, RigidWeld& weld) {
  return SeamMaker(builder, card, around, weld).make();
}

}  // namespace nugget::reading
