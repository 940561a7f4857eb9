// SPDX-License-Identifier: Apache-2.0
#include "reading/bodies/rigid_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "base/index.hpp"
#include "model/axes.hpp"
#include "model/lumped_mass.hpp"
#include "reading/bodies/seams.hpp"
#include "reading/bodies/weld_numbers.hpp"
#include "reading/builder/common_cards.hpp"

namespace nugget::reading {
namespace {

using deck::RowOf;

bool is_rigid(const Model& model, const Part& part) {
  return part.material != none && std::holds_alternative<kernel::Rigid>(model.materials[part.material].law);
}

}  // namespace

std::string name_of(const RigidBody& body) {
  switch (body.origin) {
    case RigidBody::Origin::part: return fmt::format("rigid part {}", body.id);
    case RigidBody::Origin::nodal: return fmt::format("nodal rigid body {}", body.id);
    case RigidBody::Origin::weld: break;
  }
  return fmt::format("rigid weld {}", body.id);
}

namespace {

/// Goes through the making once; its members are what the steps hand on to each other.
class Maker {
 public:
  explicit Maker(Builder& builder) : b_(builder), model_(builder.model) {}

  void make() {
    add_parts();
    for (const auto& card : b_.body_cards.nodal) add_nodal(card);
    for (const auto& card : b_.body_cards.merges) merge(card);
    merge_neighbours();
    emit();
    add_element_nodes();
    for (const auto& card : b_.body_cards.extra_nodes) add_extra_nodes(card);
    claim_all();
    number_rigid_welds(b_);
    for (const auto& card : b_.body_cards.welds) add_weld(card);
    recognise_nodal_welds();
    for (const auto& card : b_.body_cards.nodal) add_reference_node(card);
    report_empty();
    move_given_bodies();
  }

 private:
  // -- before merging: one seed for each rigid part and nodal rigid body --

  void add_parts() {
    for (std::size_t p = 0; p < model_.parts.size(); ++p) {
      const Part& part = model_.parts[p];
      if (!is_rigid(model_, part) || (part.kind == ElementKind::nothing && !is_named(part.id))) continue;
      RigidBody body;
      body.origin = RigidBody::Origin::part;
      body.id = part.id;
      body.title = part.title;
      body.parts = {static_cast<Index>(p)};
      body.place = part.place;
      if (const auto card = b_.rigid_cards.find(part.material); card != b_.rigid_cards.end())
        constrain(body, card->second.constraint);
      if (const Frame3d* axes = body_axes(b_, part.id)) body.own_axes = *axes;
      if (const auto inertia = b_.part_inertia.find(static_cast<Index>(p)); inertia != b_.part_inertia.end()) {
        body.given = true;
        body.inertia = inertia->second;
      }
      add_seed(std::move(body), "rigid part");
    }
  }

  /// A rigid part without elements is a body only where a card gives it nodes.
  bool is_named(int id) const {
    const auto& cards = b_.body_cards;
    return std::any_of(cards.extra_nodes.begin(), cards.extra_nodes.end(),
                       [&](const auto& card) { return card.row->pid == id; }) ||
           std::any_of(cards.merges.begin(), cards.merges.end(),
                       [&](const auto& card) { return card.row->pidl == id || (!card.set && card.row->pidc == id); });
  }

  void constrain(RigidBody& body, const deck::RowOf<RigidConstraintCard>& card) {
    if (card->cmo == 1.0) body.fixed = card->fixed_by_codes();
    if (card->cmo == -1.0) constrain_along_axes(body, card);
  }

  /// CMO -1: CON1 is a coordinate system, CON2 has the digits of what is held.
  void constrain_along_axes(RigidBody& body, const deck::RowOf<RigidConstraintCard>& card) {
    const deck::Entry con1 = card[&RigidConstraintCard::system];
    const Index system = b_.system(con1);
    if (system == none) {
      if (con1.integer() == 0) refuse(b_, con1, "CMO -1 needs the coordinate system of its directions", "give its id");
      return;
    }
    body.fixed_axes = model_.systems[system].axes;
    // Digits x y z rx ry rz, leading zeros may be missing.
    auto digits = static_cast<int>(card->con2);
    for (int i = 5; i >= 0; --i, digits /= 10) {
      if (digits % 10 > 1)
        return refuse(b_, card[&RigidConstraintCard::con2], "expected six digits, each 0 or 1, e.g. 110111");
      if (digits % 10 == 1) body.fixed |= 1u << i;
    }
  }

  void add_nodal(const BodyCards::Nodal& card) {
    RigidBody body;
    body.origin = RigidBody::Origin::nodal;
    body.id = card.row->pid;
    body.title = card.title;
    body.place = card.row.place();
    body.fixed = card.fixed;
    if (card.spc) constrain_along_axes(body, *card.spc);
    if (const Index system = b_.system(card.row[&NodalBodyCard::cid]); system != none)
      body.own_axes = model_.systems[system].axes;
    if (const Set<Index>* nodes =
            b_.node_set(card.row[card.row->nsid == 0 ? &NodalBodyCard::pid : &NodalBodyCard::nsid]))
      body.nodes = nodes->members;
    if (card.given) {
      body.given = true;
      body.inertia = inertia_of(card);
    }
    add_seed(std::move(body), "nodal rigid body");
  }

  RigidBody::Inertia inertia_of(const BodyCards::Nodal& card) {
    RigidBody::Inertia inertia = card.inertia;
    if (const Index node = b_.node(card.center_node); node != none) inertia.center = model_.nodes.x[node];
    if (card.axes) {
      const Index system = b_.system(*card.axes);
      if (system != none) inertia.inertia = to_global(inertia.inertia, model_.systems[system].axes);
    }
    return inertia;
  }

  void add_seed(RigidBody body, std::string_view what) {
    const auto index = static_cast<Index>(seeds_.size());
    if (!seed_ids_.add(body.id, index, body.place, "*CONSTRAINED_NODAL_RIGID_BODY", what, b_.findings)) return;
    seeds_.push_back(std::move(body));
    lead_.push_back(index);
  }

  // -- merging --

  Index lead(Index seed) const {
    while (lead_[seed] != seed) seed = lead_[seed];
    return seed;
  }

  void merge(const BodyCards::Merge& card) {
    const RowOf<MergeCard>& row = card.row;
    const Index l = b_.find(seed_ids_, "rigid body", row[&MergeCard::pidl]);
    if (!card.set) {
      const Index c = b_.find(seed_ids_, "rigid body", row[&MergeCard::pidc]);
      if (l != none && c != none) merge(row, l, c);
      return;
    }
    const Set<Index>* const parts = b_.part_set(row[&MergeCard::pidc]);
    if (l == none || parts == nullptr) return;
    for (const Index p : parts->members) {
      const int id = model_.parts[p].id;
      if (id == row->pidl) continue;  // a set may hold the lead body itself
      const Index c = seed_ids_.find(id);
      if (c == none)
        refuse(b_, row[&MergeCard::pidc], fmt::format("part {} of the set is no rigid body", id),
               "take it out of the set, or give it *MAT_RIGID");
      else
        merge(row, l, c);
    }
  }

  void merge(const RowOf<MergeCard>& row, Index l, Index c) {
    const Index to = lead(l), from = lead(c);
    if (to == from) {
      row[&MergeCard::pidc].report(b_.findings, Severity::warning, "is merged into this body already");
      return;
    }
    RigidBody& into = seeds_[at(to)];
    RigidBody& merged = seeds_[from];
    if (into.given && row->iflag != 0)
      refuse(b_, row[&MergeCard::iflag], "adding to a mass that *PART_INERTIA or _INERTIA gives is not built",
             "use 0, with the mass of both given for the lead body");
    if (!into.given && merged.given)
      refuse(b_, row[&MergeCard::pidc],
             "its given mass would have to be added to one that follows from elements: not built",
             "give the mass of both for the lead body");
    report_what_ends(row, into, merged);
    into.parts.insert(into.parts.end(), merged.parts.begin(), merged.parts.end());
    into.nodes.insert(into.nodes.end(), merged.nodes.begin(), merged.nodes.end());
    lead_[from] = to;
  }

  /// The lead body's supports and motion are those of both.
  void report_what_ends(const RowOf<MergeCard>& row, const RigidBody& into, const RigidBody& merged) {
    if (merged.fixed != 0 && !constrained_alike(into, merged))
      row[&MergeCard::pidc].report(b_.findings, Severity::warning,
                                   fmt::format("{} is held, which ends with the merger: both move as {} is held",
                                               name_of(merged), name_of(into)),
                                   "hold the lead body (CMO of its *MAT_RIGID, _SPC of a nodal rigid body)");
    if (!merged.given) return;
    const auto &v = merged.inertia.velocity, &w = merged.inertia.spin;
    const bool same = into.given && norm(into.inertia.velocity - v) == 0.0 && norm(into.inertia.spin - w) == 0.0;
    if (norm(v) + norm(w) > 0.0 && !same)
      row[&MergeCard::pidc].report(b_.findings, Severity::warning,
                                   fmt::format("the initial velocity of {} does not count: both have that of {}",
                                               name_of(merged), name_of(into)),
                                   "give the velocity with the lead body");
  }

  static bool constrained_alike(const RigidBody& a, const RigidBody& b) {
    return a.fixed == b.fixed && same_axes(a, b);
  }

  static bool same_axes(const RigidBody& a, const RigidBody& b) {
    const Frame3d &f = a.fixed_axes, &g = b.fixed_axes;
    return norm(f.e1 - g.e1) + norm(f.e2 - g.e2) < 1e-9;
  }

  /// Two rigid parts with three common nodes that are not in a line cannot but move as one.
  void merge_neighbours() {
    std::vector<Index> seed_of_part(model_.parts.size(), none);
    for (std::size_t s = 0; s < seeds_.size(); ++s)
      if (seeds_[s].origin == RigidBody::Origin::part) seed_of_part[seeds_[s].parts.front()] = static_cast<Index>(s);
    std::vector<Index> first(model_.nodes.size(), none);
    std::map<std::pair<Index, Index>, std::vector<Index>> common;
    const auto look = [&](const auto& elements) {
      for (std::size_t e = 0; e < elements.size(); ++e) {
        const Index seed = elements.part[e] == none ? none : seed_of_part[elements.part[e]];
        if (seed == none) continue;
        for (const Index node : elements.nodes(e)) {
          if (node == none) continue;
          Index& owner = first[node];
          if (owner == none) owner = seed;
          if (lead(owner) != lead(seed)) common[std::minmax(owner, seed)].push_back(node);
        }
      }
    };
    look(model_.shells);
    look(model_.solids);
    look(model_.beams);
    for (const auto& [pair, nodes] : common) merge_neighbours(pair.first, pair.second, nodes);
  }

  void merge_neighbours(Index a, Index b, const std::vector<Index>& nodes) {
    const Index to = lead(a), from = lead(b);
    RigidBody& into = seeds_[at(to)];
    const RigidBody& merged = seeds_[from];
    if (to == from || into.given || merged.given || !span_a_plane(nodes)) return;
    b_.findings.warning(
        merged.place, "*PART",
        fmt::format("{} shares nodes with {}, and moves with it as one", name_of(merged), name_of(into)),
        "say so with *CONSTRAINED_RIGID_BODIES");
    constrain_both(into, merged);
    into.parts.insert(into.parts.end(), merged.parts.begin(), merged.parts.end());
    into.nodes.insert(into.nodes.end(), merged.nodes.begin(), merged.nodes.end());
    lead_[from] = to;
  }

  /// No card says which of them leads, so what holds either of them holds both.
  void constrain_both(RigidBody& into, const RigidBody& merged) {
    if (into.fixed == 0) into.fixed_axes = merged.fixed_axes;
    if (merged.fixed != 0 && !same_axes(into, merged))
      b_.findings.error(
          merged.place, "*PART",
          fmt::format("{} and {} share nodes, and are held in different axes", name_of(merged), name_of(into)),
          "merge them with *CONSTRAINED_RIGID_BODIES, and hold the lead body");
    into.fixed |= merged.fixed;
  }

  bool span_a_plane(const std::vector<Index>& nodes) const {
    const auto from_first = [&](Index node) { return model_.nodes.x[node] - model_.nodes.x[nodes.front()]; };
    const auto farther = [&](Index m, Index n) { return norm(from_first(m)) < norm(from_first(n)); };
    const Vec3d longest = from_first(*std::max_element(nodes.begin(), nodes.end(), farther));
    return std::any_of(nodes.begin(), nodes.end(), [&](Index node) {
      return norm(cross(longest, from_first(node))) > 1e-3 * dot(longest, longest);
    });
  }

  void emit() {
    std::vector<Index> body_of_seed(seeds_.size(), none);
    for (std::size_t s = 0; s < seeds_.size(); ++s)
      if (lead_[s] == static_cast<Index>(s)) {
        body_of_seed[s] = static_cast<Index>(model_.rigid_bodies.size());
        model_.rigid_bodies.push_back(seeds_[s]);
      }
    for (std::size_t s = 0; s < seeds_.size(); ++s) {
      const Index body = body_of_seed[lead(static_cast<Index>(s))];
      b_.bodies.add(seeds_[s].id, body, seeds_[s].place, {}, "rigid body", b_.findings);
      for (const Index part : seeds_[s].parts) model_.parts[part].rigid_body = body;
    }
  }

  // -- nodes --

  RigidBody& body(Index index) { return model_.rigid_bodies[index]; }

  void add_element_nodes() {
    const auto collect = [&](const auto& elements) {
      for (std::size_t e = 0; e < elements.size(); ++e) {
        if (elements.part[e] == none) continue;
        const Index owner = model_.parts[elements.part[e]].rigid_body;
        if (owner == none) continue;
        for (const Index node : elements.nodes(e))
          if (node != none) body(owner).nodes.push_back(node);
      }
    };
    collect(model_.shells);
    collect(model_.solids);
    collect(model_.beams);
    for (RigidBody& each : model_.rigid_bodies) make_unique(each.nodes);
  }

  void add_extra_nodes(const BodyCards::ExtraNodes& card) {
    const Index owner = find_body(b_, card.row[&ExtraNodesCard::pid]);
    refuse_nonzero(b_, card.row[&ExtraNodesCard::iflag],
                   "adding the mass of extra nodes to a given inertia is not built", "use 0");
    std::vector<Index> nodes;
    if (card.set) {
      if (const Set<Index>* set = b_.node_set(card.row[&ExtraNodesCard::nodes])) nodes = set->members;
    } else if (const Index node = b_.node(card.row[&ExtraNodesCard::nodes]); node != none) {
      nodes = {node};
    }
    if (owner != none) give(owner, nodes);
  }

  /// Decks give thousands of nodes to one body, each on a card of its own: the body's nodes are not sorted anew.
  void give(Index owner, std::vector<Index> nodes) {
    make_unique(nodes);
    auto& held = body(owner).nodes;
    const auto old = static_cast<std::ptrdiff_t>(held.size());
    held.insert(held.end(), nodes.begin(), nodes.end());
    std::inplace_merge(held.begin(), held.begin() + old, held.end());
    held.erase(std::unique(held.begin(), held.end()), held.end());
  }

  /// PNODE: a node without elements goes with the body, drawn at its centre of mass.
  void add_reference_node(const BodyCards::Nodal& card) {
    const Index node = b_.node(card.row[&NodalBodyCard::pnode]), owner = b_.bodies.find(card.row->pid);
    if (node == none || owner == none || b_.body_of_node[node] != none) return;
    if (has_element(node)) {
      card.row[&NodalBodyCard::pnode].report(b_.findings, Severity::warning,
                                             "belongs to an element but not to the body: it stays where it is",
                                             "name a node without elements, or add it to the body's nodes");
      return;
    }
    const Vec3d center = center_of_mass(b_, body(owner));
    Vec3d& x = model_.nodes.x[node];
    if (norm(x - center) > 0.0) {
      card.row[&NodalBodyCard::pnode].report(
          b_.findings, Severity::note,
          fmt::format("is moved by {:.4g} to the centre of mass of its body", norm(x - center)));
      x = center;
    }
    give(owner, {node});
    b_.body_of_node[node] = owner;
  }

  bool has_element(Index node) {
    if (has_element_.empty()) {
      has_element_.assign(model_.nodes.size(), 0);
      const auto mark = [&](const auto& elements) {
        for (std::size_t e = 0; e < elements.size(); ++e)
          for (const Index n : elements.nodes(e))
            if (n != none) has_element_[n] = 1;
      };
      mark(model_.shells);
      mark(model_.solids);
      mark(model_.beams);
    }
    return has_element_[node] != 0;
  }

  /// Writes down who holds each node.
  void claim_all() {
    b_.body_of_node.assign(model_.nodes.size(), none);
    for (std::size_t i = 0; i < model_.rigid_bodies.size(); ++i) claim(static_cast<Index>(i));
  }

  void claim(Index owner) {
    Tally conflicts(b_.findings, Severity::error, "*CONSTRAINED", 5);
    for (const Index node : body(owner).nodes) {
      Index& owner_of_node = b_.body_of_node[node];
      if (owner_of_node == none) {
        owner_of_node = owner;
      } else if (owner_of_node != owner) {
        conflicts.add(
            body(owner).place,
            [&] {
              return fmt::format("node {} belongs to two rigid bodies: {} and {}", model_.nodes.id[node],
                                 name_of(body(owner_of_node)), name_of(body(owner)));
            },
            "merge the bodies with *CONSTRAINED_RIGID_BODIES, or take the node out of one of them");
      }
    }
  }

  // -- rigid welds --

  void add_weld(const BodyCards::Weld& card) {
    RigidWeld weld = card.weld;
    const bool generalized = weld.on_a_set();
    if (!find_weld_nodes(card, weld)) return;
    std::vector<Index> different = weld.nodes;
    make_unique(different);
    if (different.size() < 2)
      return refuse(b_, card.first, "a weld joins two nodes or more",
                    generalized ? "add nodes to the set" : "give two different nodes");
    if (!card.seams.empty() && !make_seams(b_, card, adjoining(), weld)) return;
    if (const Index part_body = touched_part(weld.nodes); part_body != none) {
      if (weld.can_fail())
        return refuse(
            b_, card.first,
            fmt::format("a weld to {} cannot fail: its nodes would be part of that body", name_of(body(part_body))),
            "weld deformable sheets, or take the failure values out");
      card.first.report(b_.findings, Severity::note,
                        fmt::format("touches {}: its nodes become extra nodes of that body", name_of(body(part_body))));
      give(part_body, weld.nodes);
      claim(part_body);
      return;
    }
    if (!find_axis(card, weld)) return;
    RigidBody held;
    held.origin = RigidBody::Origin::weld;
    held.id = weld.id;
    held.place = weld.place;
    held.nodes = std::move(different);
    weld.body = static_cast<Index>(model_.rigid_bodies.size());
    model_.rigid_bodies.push_back(std::move(held));
    model_.rigid_welds.push_back(std::move(weld));
    claim(static_cast<Index>(model_.rigid_bodies.size()) - 1);
  }

  bool find_weld_nodes(const BodyCards::Weld& card, RigidWeld& weld) {
    if (weld.on_a_set()) {
      const Set<Index>* set = b_.node_set(card.first);
      if (set) weld.nodes = set->members;
      return set != nullptr;
    }
    weld.nodes = {b_.node(card.first), b_.node(card.second)};
    return weld.nodes[0] != none && weld.nodes[1] != none;
  }

  const AdjoiningElements& adjoining() {
    if (!adjoining_) adjoining_.emplace(model_);
    return *adjoining_;
  }

  /// The axis of CID. Without one the first and the last node must determine it, where it is needed.
  bool find_axis(const BodyCards::Weld& card, RigidWeld& weld) {
    if (!weld.seams.empty()) return true;  // they have directions of their own
    const bool generalized = weld.on_a_set();
    if (generalized)
      if (const Index system = b_.system(card.second); system != none) weld.axis = model_.systems[system].axes.e3;
    const auto place = [&](Index node) { return model_.nodes.x[node]; };
    const bool apart = norm(place(weld.nodes.back()) - place(weld.nodes.front())) > 0.0;
    if (apart || weld.axis || (generalized && !weld.can_fail())) return true;
    if (generalized)
      refuse(b_, card.second, "the nodes are at one place, so they define no direction in which the weld fails",
             "give a coordinate system whose z axis is the normal of the sheets");
    else
      refuse(b_, card.second, "both nodes are at one place", "use *CONSTRAINED_GENERALIZED_WELD_SPOT for such nodes");
    return false;
  }

  /// The rigid part that one of the nodes belongs to, or none.
  Index touched_part(const std::vector<Index>& nodes) {
    for (const Index node : nodes) {
      const Index owner_of_node = b_.body_of_node[node];
      if (owner_of_node != none && body(owner_of_node).origin == RigidBody::Origin::part) return owner_of_node;
    }
    return none;
  }

  /// Nodal rigid bodies of a few nodes, each on another sheet, are how many models write a rigid weld.
  void recognise_nodal_welds() {
    constexpr std::size_t most_sheets = 4;
    std::vector<Index> shell_at;
    for (std::size_t i = 0; i < model_.rigid_bodies.size(); ++i) {
      const RigidBody& each = model_.rigid_bodies[i];
      const std::size_t count = each.nodes.size();
      if (each.origin != RigidBody::Origin::nodal || !each.parts.empty() || each.given || each.fixed != 0) continue;
      if (count < 2 || count > most_sheets) continue;
      if (shell_at.empty()) shell_at = first_shells();
      if (!on_different_sheets(each.nodes, shell_at)) continue;
      RigidWeld weld;
      weld.kind = RigidWeld::Kind::nodal_body;
      weld.id = each.id;
      weld.body = static_cast<Index>(i);
      weld.nodes = in_line(each.nodes);
      weld.place = each.place;
      model_.rigid_welds.push_back(std::move(weld));
    }
  }

  /// By node: its first shell, or none.
  std::vector<Index> first_shells() const {
    std::vector<Index> first(model_.nodes.size(), none);
    for (std::size_t e = model_.shells.size(); e-- > 0;)
      for (const Index node : model_.shells.node[e]) first[node] = static_cast<Index>(e);
    return first;
  }

  /// Each node on a sheet of its own, and all of them within a few thicknesses: a longer body is a strut.
  bool on_different_sheets(const std::vector<Index>& nodes, const std::vector<Index>& shell_at) const {
    constexpr double most_thicknesses = 5.0;
    std::vector<Index> sheets;
    double thickness = 0.0, length = 0.0;
    for (const Index node : nodes) {
      const Index shell = shell_at[node];
      if (shell == none) return false;
      sheets.push_back(model_.shells.part[shell]);
      thickness += model_.shells.thickness[shell];
      for (const Index other : nodes) length = std::max(length, norm(place_of(node) - place_of(other)));
    }
    make_unique(sheets);
    return sheets.size() == nodes.size() && length <= most_thicknesses * thickness;
  }

  /// From one end of the line that the nodes lie on to the other.
  std::vector<Index> in_line(std::vector<Index> nodes) const {
    std::pair<Index, Index> ends{nodes.front(), nodes.back()};
    for (const Index a : nodes)
      for (const Index b : nodes)
        if (a < b && norm(place_of(b) - place_of(a)) > norm(place_of(ends.second) - place_of(ends.first)))
          ends = {a, b};
    const Vec3d start = place_of(ends.first), line = place_of(ends.second) - start;
    std::stable_sort(nodes.begin(), nodes.end(),
                     [&](Index a, Index b) { return dot(place_of(a) - start, line) < dot(place_of(b) - start, line); });
    return nodes;
  }

  const Vec3d& place_of(Index node) const { return model_.nodes.x[node]; }

  // -- the end --

  void report_empty() {
    // Elements of a part that none is left of have been refused.
    const auto had_elements = [&](Index part) { return model_.parts[part].kind != ElementKind::nothing; };
    for (const RigidBody& each : model_.rigid_bodies)
      if (each.nodes.empty() && std::ranges::none_of(each.parts, had_elements))
        b_.findings.error(each.place, "*CONSTRAINED", name_of(each) + " has no nodes",
                          "give it elements, nodes or extra nodes");
  }

  void move_given_bodies() {
    for (const RigidBody& each : model_.rigid_bodies)
      if (each.given && (norm(each.inertia.velocity) > 0.0 || norm(each.inertia.spin) > 0.0))
        set_motion(model_, each, each.inertia.center, each.inertia.velocity, each.inertia.spin);
  }

  Builder& b_;
  Model& model_;
  std::vector<RigidBody> seeds_;
  std::vector<Index> lead_;  ///< by seed: the seed that it is merged into, or itself
  Ids seed_ids_;
  std::vector<char> has_element_;  ///< by node; empty until it is asked for
  std::optional<AdjoiningElements> adjoining_;
};

}  // namespace

void make_rigid_bodies(Builder& builder) {
  Maker(builder).make();
}

Index find_body(Builder& builder, const deck::Entry& field) {
  const int id = field.integer();
  if (id == 0) return none;
  const Index body = builder.bodies.find(id);
  if (body == none) {
    const bool is_part = builder.parts.find(id) != none;
    refuse(builder, field,
           is_part ? fmt::format("part {} is not rigid", id) : fmt::format("rigid body {} is not defined", id),
           "name a part with *MAT_RIGID or a *CONSTRAINED_NODAL_RIGID_BODY");
  }
  return body;
}

const Frame3d* body_axes(Builder& builder, int id) {
  const auto axes = [&](Index system) { return system == none ? nullptr : &builder.model.systems[system].axes; };
  if (const Index part = builder.parts.find(id); part != none) {
    const auto card = builder.rigid_cards.find(builder.model.parts[part].material);
    if (card == builder.rigid_cards.end()) return nullptr;
    return card->second.output_axes ? &*card->second.output_axes : axes(builder.systems.find(card->second.lco));
  }
  for (const auto& nodal : builder.body_cards.nodal)
    if (nodal.row->pid == id) return axes(builder.systems.find(nodal.row->cid));
  return nullptr;
}

Vec3d center_of_mass(Builder& builder, const RigidBody& body) {
  if (body.given) return body.inertia.center;
  const std::vector<double>& masses = builder.nodal_mass();
  double mass = 0.0;
  Vec3d moment;
  for (const Index n : body.nodes) {
    const auto node = at(n);
    mass += masses[node];
    moment += masses[node] * builder.model.nodes.x[node];
  }
  return mass > 0.0 ? (1.0 / mass) * moment : Vec3d{};
}

void set_motion(Model& model, const RigidBody& body, const Vec3d& center, const Vec3d& velocity, const Vec3d& spin) {
  model.initial_velocity.resize(model.nodes.size());
  if (norm(spin) > 0.0 || !model.initial_spin.empty()) model.initial_spin.resize(model.nodes.size());
  for (const Index n : body.nodes) {
    const auto node = at(n);
    model.initial_velocity[node] = velocity + cross(spin, model.nodes.x[node] - center);
    if (!model.initial_spin.empty()) model.initial_spin[node] = spin;
  }
}

}  // namespace nugget::reading
