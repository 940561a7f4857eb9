// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>

#include "base/index.hpp"
#include "model/segments.hpp"
#include "reading/builder/passes.hpp"

namespace nugget::reading {

namespace {

using Source = SetStep::Source;
using Action = SetStep::Action;

std::string_view name_of(SetKind kind) {
  static constexpr std::string_view names[] = {"node", "part", "segment", "shell", "solid", "beam", "branch of parts"};
  return names[static_cast<std::size_t>(kind)];
}

/// Elements of each part, one kind of elements.
template <class Elements>
std::vector<std::vector<Index>> by_part(const Elements& elements, std::size_t parts) {
  std::vector<std::vector<Index>> lists(parts);
  for (std::size_t e = 0; e < elements.size(); ++e) lists[elements.part[e]].push_back(static_cast<Index>(e));
  return lists;
}

class Resolver {
 public:
  explicit Resolver(Builder& b)
      : b_(b),
        m_(b.model),
        shells_of_(by_part(m_.shells, m_.parts.size())),
        solids_of_(by_part(m_.solids, m_.parts.size())),
        beams_of_(by_part(m_.beams, m_.parts.size())) {}

  void run() {
    join_collected();
    for (auto& [key, set] : sets_) resolve(set);
    // In deck order, so that indices do not depend on the order in which sets refer to each other.
    for (const auto& key : order_) publish(sets_.at(key));
  }

 private:
  using OwnAttributes = decltype(Set<Index>::own_attributes);
  struct WorkingSet {
    SetRecipe recipe;
    enum { untouched, in_work, done } state = untouched;
    std::vector<Index> members;     ///< all kinds but segments
    std::vector<Segment> segments;  ///< segment sets
    OwnAttributes own_attributes;   ///< part sets
  };
  using Key = std::pair<SetKind, int>;

  void join_collected() {
    for (SetRecipe& recipe : b_.set_recipes) {
      const Key key{recipe.kind, recipe.id};
      const auto at = sets_.find(key);
      if (at == sets_.end()) {
        order_.push_back(key);
        sets_[key].recipe = std::move(recipe);
      } else if (recipe.collect || at->second.recipe.collect) {
        auto& steps = at->second.recipe.steps;
        std::move(recipe.steps.begin(), recipe.steps.end(), std::back_inserter(steps));
      } else {
        const Place& first = at->second.recipe.place;
        b_.findings.error(recipe.place, recipe.keyword,
                          fmt::format("{} set {} is defined twice; first at {}:{}", name_of(recipe.kind), recipe.id,
                                      first.file, first.line),
                          "give one of them another id, or write _COLLECT to join them");
      }
    }
    b_.set_recipes.clear();
  }

  void resolve(WorkingSet& set) {
    if (set.state != WorkingSet::untouched) return;
    set.state = WorkingSet::in_work;
    // First the sets that it refers to: the stamps of `keep_each_once` are not to be mixed.
    for (const SetStep& step : set.recipe.steps)
      if (step.source == Source::sets)
        for (const int id : step.ids) resolve_inner(set, step, id);
    if (set.recipe.kind == SetKind::segment)
      work_out_segments(set);
    else
      work_out_members(set);
    set.state = WorkingSet::done;
    if (set.members.empty() && set.segments.empty())
      b_.findings.warning(set.recipe.place, set.recipe.keyword,
                          fmt::format("{} set {} has no members", name_of(set.recipe.kind), set.recipe.id));
  }

  void resolve_inner(const WorkingSet& outer, const SetStep& step, int id) {
    const auto at = sets_.find({step.kind, id});
    if (at == sets_.end())
      return b_.findings.error(step.place, outer.recipe.keyword,
                               fmt::format("{} set {} is not defined", name_of(step.kind), id));
    if (at->second.state == WorkingSet::in_work)
      return b_.findings.error(step.place, outer.recipe.keyword,
                               fmt::format("{} set {} contains itself", name_of(step.kind), id), "break the circle");
    resolve(at->second);
  }

  /// The finished set, or null where it is missing or contains itself (reported already).
  const WorkingSet* inner(const SetStep& step, int id) const {
    const auto at = sets_.find({step.kind, id});
    return at == sets_.end() || at->second.state != WorkingSet::done ? nullptr : &at->second;
  }

  const Ids& ids_of(SetKind kind) const {
    switch (kind) {
      case SetKind::part:
      case SetKind::branch: return b_.parts;
      case SetKind::shell: return b_.shells;
      case SetKind::solid: return b_.solids;
      case SetKind::beam: return b_.beams;
      default: return b_.nodes;
    }
  }

  std::size_t count_of(SetKind kind) const {
    switch (kind) {
      case SetKind::part:
      case SetKind::branch: return m_.parts.size();
      case SetKind::shell: return m_.shells.size();
      case SetKind::solid: return m_.solids.size();
      case SetKind::beam: return m_.beams.size();
      default: return m_.nodes.size();
    }
  }

  int user_id(SetKind kind, std::size_t i) const {
    switch (kind) {
      case SetKind::part:
      case SetKind::branch: return m_.parts[i].id;
      case SetKind::shell: return m_.shells.id[i];
      case SetKind::solid: return m_.solids.id[i];
      case SetKind::beam: return m_.beams.id[i];
      default: return m_.nodes.id[i];
    }
  }

  /// Indices of the ids of a step; unknown ones are findings.
  std::vector<Index> known(const SetStep& step, SetKind kind, Tally& unknown) const {
    std::vector<Index> out;
    out.reserve(step.ids.size());
    for (const int id : step.ids) {
      const Index i = ids_of(kind).find(id);
      if (i == none)
        unknown.add(
            step.place, [&] { return fmt::format("{} {} is not defined", name_of(kind), id); },
            "remove it from the set, or define it");
      else
        out.push_back(i);
    }
    if (kind == SetKind::node) append(m_.listed_nodes, out);
    if (kind == SetKind::shell) append(m_.listed_shells, out);
    return out;
  }

  std::vector<Index> in_range(const SetStep& step, SetKind kind) const {
    std::vector<Index> out;
    const int begin = step.ids[0], end = step.ids[1], increment = std::max(step.ids[2], 1);
    const bool ascends = kind != SetKind::part && kind != SetKind::branch;  // as the mesh is sorted
    std::size_t i = 0;
    if (ascends)
      for (std::size_t last = count_of(kind); i < last;) {
        const std::size_t middle = i + (last - i) / 2;
        user_id(kind, middle) < begin ? i = middle + 1 : last = middle;
      }
    for (; i < count_of(kind); ++i) {
      const int id = user_id(kind, i);
      if (ascends && id > end) break;
      if (id >= begin && id <= end && (id - begin) % increment == 0) out.push_back(static_cast<Index>(i));
    }
    return out;
  }

  // ---- sets of nodes, parts and elements

  void work_out_members(WorkingSet& set) {
    const SetKind kind = set.recipe.kind;
    Tally unknown(b_.findings, Severity::error, set.recipe.keyword);
    std::vector<char>& inside = inside_[static_cast<std::size_t>(kind)];  // all 0 between two sets
    inside.resize(count_of(kind), 0);
    for (const SetStep& step : set.recipe.steps) apply(step.action, gather(step, kind, unknown), set.members, inside);
    for (const Index i : set.members) inside[i] = 0;
    if (kind == SetKind::part) set.own_attributes = attributes_by_part(set.recipe);
  }

  /// Of parts that a _COLUMN lists with attributes, and of those that come from sets with attributes.
  OwnAttributes attributes_by_part(const SetRecipe& recipe) const {
    static constexpr std::array<double, 4> nothing{};
    OwnAttributes own;
    for (const SetStep& step : recipe.steps) {
      if (step.attributes != nothing)
        for (const int id : step.ids)
          if (const Index part = b_.parts.find(id); part != none) own.emplace_back(part, step.attributes);
      if (step.source != Source::sets || step.kind != SetKind::part) continue;
      for (const int id : step.ids) {
        const WorkingSet* set = inner(step, id);
        if (!set) continue;
        own.insert(own.end(), set->own_attributes.begin(), set->own_attributes.end());
        if (set->recipe.attributes != nothing)
          for (const Index part : set->members) own.emplace_back(part, set->recipe.attributes);
      }
    }
    return own;
  }

  static void apply(Action action, const std::vector<Index>& found, std::vector<Index>& members,
                    std::vector<char>& inside) {
    if (action == Action::add) {
      for (const Index i : found)
        if (!std::exchange(inside[i], char{1})) members.push_back(i);
      return;
    }
    std::vector<char> named(inside.size(), 0);
    for (const Index i : found) named[i] = 1;
    std::erase_if(members, [&](Index i) {
      const bool goes = (named[i] != 0) == (action == Action::remove);
      if (goes) inside[i] = 0;
      return goes;
    });
  }

  std::vector<Index> gather(const SetStep& step, SetKind own, Tally& unknown) const {
    std::vector<Index> out;
    switch (step.source) {
      case Source::all:
        out.resize(count_of(own));
        std::iota(out.begin(), out.end(), 0);
        break;
      case Source::members: return turned(known(step, step.kind, unknown), step.kind, own);
      case Source::range: return in_range(step, own);
      case Source::boxes:
        for (const int id : step.ids)
          if (const Box* box = box_of(step, id, unknown)) append(out, inside_box(*box, own));
        break;
      case Source::sets:
        for (const int id : step.ids)
          if (const WorkingSet* set = inner(step, id))
            append(out, step.kind == SetKind::segment ? corners(set->segments) : turned(set->members, step.kind, own));
        break;
    }
    return out;
  }

  static void append(std::vector<Index>& out, const std::vector<Index>& more) {
    out.insert(out.end(), more.begin(), more.end());
  }

  static std::vector<Index> corners(const std::vector<Segment>& segments) {
    std::vector<Index> out;
    for (const Segment& s : segments) out.insert(out.end(), s.begin(), s.end());
    return out;
  }

  /// Things of one kind as things of another: elements of parts, nodes of elements and parts.
  std::vector<Index> turned(std::vector<Index> from, SetKind kind, SetKind own) const {
    const bool are_parts = kind == SetKind::part || kind == SetKind::branch;
    if (kind == own || (are_parts && own == SetKind::branch)) return from;
    std::vector<Index> out;
    const auto add_nodes = [&](const auto& elements, const std::vector<Index>& list) {
      for (const Index e : list)
        for (const Index n : elements.nodes(at(e))) out.push_back(n);
    };
    if (kind == SetKind::shell) add_nodes(m_.shells, from);
    if (kind == SetKind::solid) add_nodes(m_.solids, from);
    if (kind == SetKind::beam) add_nodes(m_.beams, from);
    if (!are_parts) return out;
    for (const Index part : from) {
      const auto p = at(part);
      if (own == SetKind::shell) append(out, shells_of_[p]);
      if (own == SetKind::solid) append(out, solids_of_[p]);
      if (own == SetKind::beam) append(out, beams_of_[p]);
      if (own != SetKind::node) continue;
      add_nodes(m_.shells, shells_of_[p]);
      add_nodes(m_.solids, solids_of_[p]);
      add_nodes(m_.beams, beams_of_[p]);
    }
    std::sort(out.begin(), out.end());
    return out;
  }

  const Box* box_of(const SetStep& step, int id, Tally& unknown) const {
    const Index i = b_.boxes.find(id);
    if (i != none) return &b_.box_list[i];
    unknown.add(step.place, [&] { return fmt::format("box {} is not defined", id); });
    return nullptr;
  }

  bool is_inside(const Box& box, Index node) const { return box.holds(m_.nodes.x[node]); }

  /// Nodes inside; elements with all their nodes inside.
  std::vector<Index> inside_box(const Box& box, SetKind own) const {
    std::vector<Index> out;
    const auto add_elements = [&](const auto& elements) {
      for (std::size_t e = 0; e < elements.size(); ++e)
        if (std::ranges::all_of(elements.nodes(e), [&](Index n) { return is_inside(box, n); }))
          out.push_back(static_cast<Index>(e));
    };
    if (own == SetKind::shell) add_elements(m_.shells);
    if (own == SetKind::solid) add_elements(m_.solids);
    if (own == SetKind::beam) add_elements(m_.beams);
    if (own == SetKind::node)
      for (std::size_t n = 0; n < m_.nodes.size(); ++n)
        if (box.holds(m_.nodes.x[n])) out.push_back(static_cast<Index>(n));
    return out;
  }

  // ---- sets of segments

  void work_out_segments(WorkingSet& set) {
    Tally unknown(b_.findings, Severity::error, set.recipe.keyword);
    std::set<Segment> inside;
    for (const SetStep& step : set.recipe.steps) {
      const auto found = gather_segments(step, unknown);
      if (step.action == Action::add) {
        for (const Segment& s : found)
          if (inside.insert(sorted_corners(s)).second) set.segments.push_back(s);
        continue;
      }
      std::set<Segment> named;
      for (const Segment& s : found) named.insert(sorted_corners(s));
      std::erase_if(set.segments, [&](const Segment& s) {
        const bool goes = named.contains(sorted_corners(s)) == (step.action == Action::remove);
        if (goes) inside.erase(sorted_corners(s));
        return goes;
      });
    }
  }

  std::vector<Segment> gather_segments(const SetStep& step, Tally& unknown) const {
    std::vector<Segment> out;
    switch (step.source) {
      case Source::all: add_faces(out, all_of(m_.shells.size()), all_of(m_.solids.size())); break;
      case Source::members:
        if (step.kind == SetKind::segment)
          add_written(out, step, unknown);
        else
          add_faces_of(out, known(step, step.kind, unknown), step.kind);
        break;
      case Source::range: break;  // no such form
      case Source::boxes:
        for (const int id : step.ids)
          if (const Box* box = box_of(step, id, unknown)) add_faces_in(out, *box, step);
        break;
      case Source::sets:
        for (const int id : step.ids)
          if (const WorkingSet* set = inner(step, id)) {
            out.insert(out.end(), set->segments.begin(), set->segments.end());
            add_faces_of(out, set->members, step.kind);
          }
        break;
    }
    return out;
  }

  static std::vector<Index> all_of(std::size_t count) {
    std::vector<Index> out(count);
    std::iota(out.begin(), out.end(), 0);
    return out;
  }

  void add_faces(std::vector<Segment>& out, const std::vector<Index>& shells, const std::vector<Index>& solids) const {
    for (const Index e : shells) out.push_back(m_.shells.node[e]);
    const auto faces = exterior_faces(m_, solids);
    out.insert(out.end(), faces.begin(), faces.end());
  }

  void add_faces_of(std::vector<Segment>& out, const std::vector<Index>& things, SetKind kind) const {
    if (kind == SetKind::shell) add_faces(out, things, {});
    if (kind == SetKind::solid) add_faces(out, {}, things);
    if (kind == SetKind::part || kind == SetKind::branch)
      for (const Index p : things) add_faces(out, shells_of_[p], solids_of_[p]);
  }

  void add_faces_in(std::vector<Segment>& out, const Box& box, const SetStep& step) const {
    std::vector<Segment> faces;
    add_faces(faces, step.of_shells ? all_of(m_.shells.size()) : std::vector<Index>{},
              step.of_solids ? all_of(m_.solids.size()) : std::vector<Index>{});
    std::copy_if(faces.begin(), faces.end(), std::back_inserter(out), [&](const Segment& s) {
      return std::all_of(s.begin(), s.end(), [&](Index n) { return is_inside(box, n); });
    });
  }

  void add_written(std::vector<Segment>& out, const SetStep& step, Tally& unknown) const {
    const auto nodes = known(step, SetKind::node, unknown);
    if (nodes.size() != step.ids.size()) return;
    Segment face{none, none, none, none};
    std::copy_n(nodes.begin(), std::min<std::size_t>(nodes.size(), 4), face.begin());
    if (nodes.size() >= 3 && bring_triangle_into_form(face))
      return out.push_back(step.turned_over ? turned_over(face) : face);
    unknown.add(step.place, [] { return std::string("a segment needs three or four different nodes"); });
  }

  // ---- the result

  void publish(WorkingSet& set) {
    const int id = set.recipe.id;
    const Place& place = set.recipe.place;
    const auto put = [&](Ids& ids, auto& sets, auto& members) {
      ids.add(id, static_cast<Index>(sets.size()), place, set.recipe.keyword, "set", b_.findings);
      sets.push_back({id, std::move(members), place, set.recipe.attributes, {}});
    };
    switch (set.recipe.kind) {
      case SetKind::node: return put(b_.node_sets, m_.sets.nodes, set.members);
      case SetKind::part:
        put(b_.part_sets, m_.sets.parts, set.members);
        m_.sets.parts.back().own_attributes = std::move(set.own_attributes);
        return;
      case SetKind::shell: return put(b_.shell_sets, m_.sets.shells, set.members);
      case SetKind::solid: return put(b_.solid_sets, m_.sets.solids, set.members);
      case SetKind::beam: return put(b_.beam_sets, m_.sets.beams, set.members);
      case SetKind::branch: return put(b_.branches, m_.sets.branches, set.members);
      case SetKind::segment:
        split_quadratic_faces(m_, set.segments);
        return put(b_.segment_sets, m_.sets.segments, set.segments);
    }
  }

  Builder& b_;
  Model& m_;
  std::vector<std::vector<Index>> shells_of_, solids_of_, beams_of_;
  std::array<std::vector<char>, 7> inside_;  ///< by kind: the members of the set in work
  std::map<Key, WorkingSet> sets_;
  std::vector<Key> order_;
};

}  // namespace

void resolve_sets(Builder& builder) {
  if (!builder.set_recipes.empty()) Resolver(builder).run();
}

}  // namespace nugget::reading
