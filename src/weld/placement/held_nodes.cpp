// SPDX-License-Identifier: Apache-2.0
#include "weld/placement/held_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <utility>

#include "base/index.hpp"
#include "weld/tie/segment.hpp"

namespace nugget::weld {
namespace {

constexpr double sharpest_fold = 10.0;  // degrees

class Holding {
 public:
  Holding(const model::Model& model, const Ties& ties, const SheetMesh& mesh)
      : model_(model),
        ties_(ties),
        mesh_(mesh),
        hold_(model.nodes.size(), Hold::nothing),
        nodes_of_(model.parts.size(), 0) {
    for (Index n = 0; at(n) < hold_.size(); ++n)
      if (!mesh_.at(n).empty()) ++nodes_of_[part_at(n)];
  }

  std::vector<Hold> nodes(const std::function<bool(Index node)>& can_move) {
    hold_where(Hold::no_shell, [&](Index n) { return mesh_.at(n).empty(); });
    hold_at_elements();
    hold_where(Hold::other_part, [&](Index n) { return differ(n, model_.shells.part); });
    const model::Shells& shells = model_.shells;
    hold_where(Hold::thickness, [&](Index n) {
      return differ(n, shells.thickness) || (!shells.offsets.empty() && differ(n, shells.offsets));
    });
    hold_named();
    hold_tied();
    hold_where(Hold::text, [&](Index n) { return !can_move(n); });
    hold_at_sides();  // last: who keeps sides in another way looks for what nothing else holds
    return std::move(hold_);
  }

 private:
  void hold(Index node, Hold why) {
    if (node != none && hold_[node] == Hold::nothing) hold_[node] = why;
  }
  void hold(std::span<const Index> nodes, Hold why) {
    for (const Index n : nodes) hold(n, why);
  }
  template <class Is>
  void hold_where(Hold why, Is is) {
    for (Index n = 0; at(n) < hold_.size(); ++n)
      if (hold_[n] == Hold::nothing && is(n)) hold(n, why);
  }

  template <class Values>
  bool differ(Index node, const Values& of_shells) const {
    const std::span<const Index> shells = mesh_.at(node);
    for (const Index e : shells)
      if (of_shells[e] != of_shells[shells.front()]) return true;
    return false;
  }

  void hold_at_elements() {
    for (std::size_t e = 0; e < model_.solids.size(); ++e) hold(model_.solids.nodes(e), Hold::other_element);
    for (std::size_t e = 0; e < model_.beams.size(); ++e) {
      hold(model_.beams.nodes(e), Hold::other_element);
      hold(model_.beams.orientation[e], Hold::other_element);
    }
    for (const model::Discrete& d : model_.discretes) hold(d.node, Hold::other_element);
    for (const model::PointMass& m : model_.masses) hold(m.node, Hold::other_element);
    for (const model::PointInertia& m : model_.inertias) hold(m.node, Hold::other_element);
    for (const model::RigidBody& body : model_.rigid_bodies) hold(body.nodes, Hold::rigid_body);
    const auto hold_shell = [&](Index shell) { hold(model_.shells.node[shell], Hold::initial_state); };
    for (const model::InitialStress& s : model_.initial_state.shells) hold_shell(s.element);
    for (const model::InitialStrain& s : model_.initial_state.shell_strains) hold_shell(s.shell);
    for (Index e = 0; at(e) < model_.shells.angle.size(); ++e)
      if (model_.shells.own_angle(e)) hold(model_.shells.node[e], Hold::thickness);
  }

  Vec3d normal_of(Index shell) const {
    const std::array<Index, 4>& n = model_.shells.node[shell];
    const std::vector<Vec3d>& x = model_.nodes.x;
    return normal({x[n[0]], x[n[1]], x[n[2]], x[n[3]]});
  }

  void hold_at_sides() {
    static const double flat = std::cos(sharpest_fold * std::numbers::pi / 180.0);
    for (Index e = 0; at(e) < model_.shells.size(); ++e)
      for (int k = 0; k < 4; ++k) {
        const std::array<Index, 2> side = mesh_.side(e, k);
        if (side[0] == side[1]) continue;
        const std::vector<Index> across = mesh_.across_side(e, k);
        if (across.empty()) hold(side, Hold::free_edge);
        if (across.size() > 1) hold(side, Hold::seam);
        // Whichever way its neighbour is numbered: sheets do not turn back upon themselves in one side.
        if (across.size() == 1 && std::abs(dot(normal_of(e), normal_of(across[0]))) < flat) hold(side, Hold::fold);
      }
  }

  /// The part of a node of a sheet; of one that several share the part of its first shell.
  Index part_at(Index node) const { return model_.shells.part[mesh_.at(node).front()]; }

  /// A list of nodes, whether a set or the side of a contact. Of parts with all their nodes in it, it is a list of
  /// parts, and holds none of them.
  void hold_listed(std::vector<Index> nodes, Hold why) {
    std::erase_if(nodes, [&](Index n) { return n == none || mesh_.at(n).empty(); });
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    std::map<Index, int> listed;  // of each part
    for (const Index n : nodes) ++listed[part_at(n)];
    for (const Index n : nodes)
      if (listed[part_at(n)] < nodes_of_[part_at(n)]) hold(n, why);
  }
  void hold_listed(const std::vector<model::Segment>& segments, Hold why) {
    std::vector<Index> nodes;
    for (const model::Segment& s : segments) nodes.insert(nodes.end(), s.begin(), s.end());
    hold_listed(std::move(nodes), why);
  }

  void hold_named() {
    hold(model_.named_nodes, Hold::named);
    for (const model::SinglePointConstraint& s : model_.spcs) hold(s.node, Hold::named);
    for (const model::NamedEntity& n : model_.requests.history_nodes) hold(n.index, Hold::named);
    for (const model::Set<Index>& s : model_.sets.nodes) hold_listed(s.members, Hold::set);
    for (const model::Set<model::Segment>& s : model_.sets.segments) hold_listed(s.members, Hold::set);
    for (const model::Contact& c : model_.contacts)
      for (const model::Surface* side : {&c.a, &c.b}) {
        hold_listed(side->nodes, Hold::contact);
        hold_listed(side->segments, Hold::contact);
      }
  }

  /// What other ties than those of welds are made to.
  void hold_tied() {
    std::vector<char> of_weld(hold_.size(), 0);
    for (const Weld& w : ties_.welds)
      for (const Projection& p : w.ends) of_weld[p.node] = 1;
    for (const Tie& t : ties_.ties) {
      if (of_weld[t.node] != 0) continue;
      hold(t.node, Hold::tied);
      hold(t.segment, Hold::tied);
      hold(t.disc.nodes, Hold::tied);
    }
  }

  const model::Model& model_;
  const Ties& ties_;
  const SheetMesh& mesh_;
  std::vector<Hold> hold_;
  std::vector<int> nodes_of_;  ///< by part: how many
};

}  // namespace

std::string_view to_string(Hold hold) {
  switch (hold) {
    case Hold::no_shell: return "of no sheet";
    case Hold::text: return "of a line that cannot be rewritten";
    case Hold::free_edge: return "on a free edge";
    case Hold::seam: return "on a seam of three shells";
    case Hold::fold: return "on a fold";
    case Hold::other_part: return "shared with another part";
    case Hold::other_element: return "of another element";
    case Hold::thickness: return "between shells of different thickness, offset or axes";
    case Hold::initial_state: return "of a shell with initial stress";
    case Hold::rigid_body: return "of a rigid body";
    case Hold::named: return "named by a card";
    case Hold::set: return "in a set";
    case Hold::contact: return "listed by a contact";
    case Hold::tied: return "of another tie";
    case Hold::weld: return "under another weld";
    case Hold::nothing: break;
  }
  return "free";
}

std::vector<Hold> held_nodes(const model::Model& model, const Ties& ties, const SheetMesh& mesh,
                             const std::function<bool(Index node)>& can_move) {
  return Holding(model, ties, mesh).nodes(can_move);
}

}  // namespace nugget::weld
