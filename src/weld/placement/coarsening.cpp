// SPDX-License-Identifier: Apache-2.0
#include "weld/placement/coarsening.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <optional>

#include "base/index.hpp"
#include "weld/placement/adapt.hpp"
#include "weld/placement/held_nodes.hpp"
#include "weld/tie/segment.hpp"
#include "weld/tie/sheet_mesh.hpp"

namespace nugget::weld {
namespace {

constexpr double off_side = 0.1, off_edge = 0.02;  // of a side: how far its middle node may lie beside it
constexpr double least_jacobian = 0.5;

/// Four shells around a node.
struct Block {
  Index centre = none;
  std::array<Index, 4> shells{}, corners{}, mids{};  ///< mids[k]: on the side from corner k to the next one
};

class Merging {
 public:
  Merging(const model::Model& model, const Ties& ties)
      : model_(model),
        shells_(model.shells),
        mesh_(model, model.nodes.x),
        hold_(held_nodes(model, ties, mesh_, [](Index) { return true; })),
        kept_(model.shells.size(), 0),
        role_(model.nodes.size(), Role::nothing),
        merged_(model.shells.size(), 0) {
    hold_more(ties);
    keep_shells();
  }

  model::Coarsening run() {
    for (const Index n : model_.coarsen.seeds) spread(n);
    for (Index n = 0; at(n) < hold_.size(); ++n) spread(n);
    settle_nodes();
    return std::move(out_);
  }

 private:
  enum class Role : unsigned char { nothing, corner, mid, centre };

  void hold(Index node, Hold why) {
    if (node == none) return;
    Hold& held = hold_[node];
    if (held == Hold::nothing || held == Hold::free_edge || held == Hold::fold) held = why;
  }

  void hold_more(const Ties& ties) {
    for (const Index n : model_.listed_nodes) hold(n, Hold::set);
    for (const Tie& t : ties.ties) {
      for (const Index n : t.segment) hold(n, Hold::tied);
      for (const Index n : t.disc.nodes) hold(n, Hold::tied);
    }
    for (const Weld& w : ties.welds)
      for (const Projection& p : w.ends) hold(p.node, Hold::weld);
    for (const model::NodalLoad& load : model_.nodal_loads)
      for (const Index n : load.nodes) hold(n, Hold::named);
    for (const model::PrescribedMotion& motion : model_.motions)
      for (const Index n : motion.nodes) hold(n, Hold::named);
    for (const model::HangingNode& h : model_.hanging_nodes)
      for (const Index n : {h.node, h.ends[0], h.ends[1]}) hold(n, Hold::named);
  }

  void keep_shells() {
    const auto keep = [&](Index e) { kept_[e] = 1; };
    std::ranges::for_each(model_.named_shells, keep);
    std::ranges::for_each(model_.listed_shells, keep);
    for (const model::NamedEntity& e : model_.requests.history_shells) keep(e.index);
    for (const model::InitialStress& s : model_.initial_state.shells) keep(s.element);
    for (const model::InitialStrain& s : model_.initial_state.shell_strains) keep(s.shell);
    for (Index e = 0; at(e) < shells_.size(); ++e)
      if (shells_.triangle(at(e)) || shells_.own_angle(e) || is_protected(e)) keep(e);
  }

  bool is_protected(Index shell) const {
    const std::vector<Index>& parts = model_.coarsen.kept_parts;
    if (std::ranges::find(parts, shells_.part[shell]) != parts.end()) return true;
    return std::ranges::any_of(model_.coarsen.boxes, [&](const model::CoarsenControl::Box& box) {
      const bool inside = std::ranges::all_of(shells_.node[shell], [&](Index n) {
        const Vec3d& x = model_.nodes.x[n];
        return x.x >= box.low.x && x.x <= box.high.x && x.y >= box.low.y && x.y <= box.high.y && x.z >= box.low.z &&
               x.z <= box.high.z;
      });
      return inside != box.outside;
    });
  }

  Corners places(const std::array<Index, 4>& n) const {
    const std::vector<Vec3d>& x = model_.nodes.x;
    return {x[n[0]], x[n[1]], x[n[2]], x[n[3]]};
  }

  /// The shells around a node in their order, if there are four of one kind; the first one has the lowest id.
  std::optional<Block> block_around(Index centre) const {
    const std::span<const Index> around = mesh_.at(centre);
    if (around.size() != 4) return std::nullopt;
    Block b;
    b.centre = centre;
    b.shells[0] = around.front();
    const auto place_of_centre = [&](Index e) {
      return static_cast<int>(std::ranges::find(shells_.node[e], centre) - shells_.node[e].begin());
    };
    const int first = (place_of_centre(b.shells[0]) + 2) % 4;
    for (int k = 0; k < 4; ++k) {
      const Index e = b.shells[k];
      const int c = place_of_centre(e);
      if (kept_[e] != 0 || merged_[e] != 0 || !alike(e, b.shells[0])) return std::nullopt;
      b.corners[(first + k) % 4] = shells_.node[e][(c + 2) % 4];
      b.mids[(first + k) % 4] = shells_.node[e][(c + 3) % 4];
      const auto next = std::ranges::find_if(around, [&](Index other) {
        return shells_.node[other][(place_of_centre(other) + 1) % 4] == shells_.node[e][(c + 3) % 4];
      });
      if (next == around.end() || (k == 3) != (*next == b.shells[0])) return std::nullopt;
      if (k < 3) b.shells[k + 1] = *next;
    }
    return b;
  }

  bool alike(Index a, Index b) const {
    return shells_.part[a] == shells_.part[b] && shells_.thickness[a] == shells_.thickness[b] &&
           shells_.offset(a) == shells_.offset(b);
  }

  bool nodes_allow(const Block& b) const {
    const auto only = [&](Index n, Role role) { return role_[n] == Role::nothing || role_[n] == role; };
    if (role_[b.centre] != Role::nothing || !(hold_[b.centre] == Hold::nothing || hold_[b.centre] == Hold::fold))
      return false;
    for (std::size_t k = 0; k < 4; ++k) {
      const Hold held = hold_[b.mids[k]];
      if (!only(b.corners[k], Role::corner) || !only(b.mids[k], Role::mid)) return false;
      if (held != Hold::nothing && held != Hold::fold && held != Hold::free_edge) return false;
    }
    return true;
  }

  bool shape_allows(const Block& b) const {
    const Corners big = places(b.corners);
    const Vec3d n = normal(big);
    const double flat = std::cos(model_.coarsen.angle * std::numbers::pi / 180.0) - 1e-12;
    for (const Index e : b.shells) {
      if (dot(normal(places(shells_.node[e])), n) < flat) return false;
      for (const Index other : b.shells)
        if (dot(normal(places(shells_.node[e])), normal(places(shells_.node[other]))) < flat) return false;
    }
    for (int k = 0; k < 4; ++k) {
      const Vec3d &p = big[k], &q = big[(k + 1) % 4], m = model_.nodes.x[b.mids[k]];
      const double side = norm(q - p), share = dot(m - p, q - p) / (side * side);
      const double beside = norm(m - p - share * (q - p)) / side;
      if (!(beside <= (hold_[b.mids[k]] == Hold::free_edge ? off_edge : off_side)) || share < 0.3 || share > 0.7)
        return false;
      if (model_.coarsen.largest > 0.0 && side > model_.coarsen.largest) return false;
    }
    return shape_of(big, false).jacobian >= least_jacobian;
  }

  /// Merges around a node, and from there on.
  void spread(Index seed) {
    std::deque<Index> next{seed};
    for (; !next.empty(); next.pop_front()) {
      const std::optional<Block> b = block_around(next.front());
      if (!b || !nodes_allow(*b) || !shape_allows(*b)) continue;
      merge(*b);
      for (const Index mid : b->mids)
        if (const Index beyond = beyond_side(*b, mid); beyond != none) next.push_back(beyond);
    }
  }

  /// The node that a middle node of a side is joined to on the other side.
  Index beyond_side(const Block& b, Index mid) const {
    std::vector<Index> outer;
    for (const Index e : mesh_.at(mid))
      if (merged_[e] == 0) outer.push_back(e);
    if (outer.size() != 2) return none;
    for (const Index n : shells_.node[outer[0]])
      if (n != mid && std::ranges::find(shells_.node[outer[1]], n) != shells_.node[outer[1]].end() &&
          std::ranges::find(b.corners, n) == b.corners.end())
        return n;
    return none;
  }

  void merge(const Block& b) {
    role_[b.centre] = Role::centre;
    model::Coarsening::Merged m;
    for (std::size_t k = 0; k < 4; ++k) {
      role_[b.corners[k]] = Role::corner;
      role_[b.mids[k]] = Role::mid;
      merged_[b.shells[k]] = 1;
      m.shells[k] = shells_.id[b.shells[k]];
      m.nodes[k] = model_.nodes.id[b.corners[k]];
    }
    out_.merged.push_back(m);
    blocks_.push_back(b);
  }

  /// Nodes that no shell needs any more go; a middle node that shells beyond its side need becomes a hanging node of
  /// the side.
  void settle_nodes() {
    for (const Block& b : blocks_) {
      out_.removed_nodes.push_back(model_.nodes.id[b.centre]);
      for (std::size_t k = 0; k < 4; ++k) {
        const Index mid = b.mids[k];
        if (std::ranges::all_of(mesh_.at(mid), [&](Index e) { return merged_[e] != 0; }))
          out_.removed_nodes.push_back(model_.nodes.id[mid]);
        else
          out_.hanging.push_back(
              {model_.nodes.id[mid], {model_.nodes.id[b.corners[k]], model_.nodes.id[b.corners[(k + 1) % 4]]}});
      }
    }
    std::sort(out_.removed_nodes.begin(), out_.removed_nodes.end());
    out_.removed_nodes.erase(std::unique(out_.removed_nodes.begin(), out_.removed_nodes.end()),
                             out_.removed_nodes.end());
  }

  const model::Model& model_;
  const model::Shells& shells_;
  SheetMesh mesh_;
  std::vector<Hold> hold_;
  std::vector<char> kept_;  ///< by shell
  std::vector<Role> role_;  ///< by node
  std::vector<char> merged_;
  std::vector<Block> blocks_;
  model::Coarsening out_;
};

}  // namespace

model::Coarsening coarsening_of(const model::Model& model, const Ties& ties) {
  return Merging(model, ties).run();
}

}  // namespace nugget::weld
