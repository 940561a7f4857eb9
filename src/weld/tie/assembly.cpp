// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/assembly.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

/// Of *DEFINE_HEX_SPOTWELD_ASSEMBLY.
constexpr std::size_t most_bricks = 16;

Facet reversed(const Facet& face) {
  return {face[0], face[3], face[2], face[1]};
}

/// How many bricks of the weld have each face.
std::map<Facet, int> count_faces(const model::Model& model, const Weld& weld) {
  std::map<Facet, int> count;
  for (Index e : weld.elements)
    for (const auto& pair : opposite_faces(model.solids.node[e]))
      for (const Facet& face : pair) ++count[sorted(face)];
  return count;
}

/// The one sheet that all corners of a face lie on, or none.
Index sheet_of(const Facet& face, const SheetAt& sheet_at) {
  const Index sheet = sheet_at(face[0]);
  const bool one = std::all_of(face.begin(), face.end(), [&](Index n) { return sheet_at(n) == sheet; });
  return one ? sheet : none;
}

/// The end faces on the first two sheets that carry outer faces; false if there are no two.
bool find_faces_on_sheets(const model::Model& model, Weld& weld, const std::map<Facet, int>& count,
                          const SheetAt& sheet_at) {
  std::array<Index, 2> sheets{none, none};
  std::array<std::vector<Facet>, 2> facets;
  for (Index e : weld.elements)
    for (const auto& pair : opposite_faces(model.solids.node[e]))
      for (std::size_t side = 0; side < 2; ++side) {
        const Facet& face = pair[side];
        const Index sheet = count.at(sorted(face)) == 1 ? sheet_of(face, sheet_at) : none;
        if (sheet == none) continue;
        if (sheets[0] == none) sheets[0] = sheet;
        if (sheet != sheets[0] && sheets[1] == none) sheets[1] = sheet;
        // The corners run in the sense of the brick's own axis, from the first face of the pair to the second.
        for (std::size_t end = 0; end < 2; ++end)
          if (sheet == sheets[end]) facets[end].push_back(end == side ? face : reversed(face));
      }
  if (sheets[1] == none) return false;
  weld.facets = std::move(facets);
  return true;
}

void find_faces_by_shape(const model::Model& model, Weld& weld, const std::map<Facet, int>& count) {
  const std::vector<Vec3d>& x = model.nodes.x;
  const auto centre = [&](const Facet& f) { return 0.25 * (x[f[0]] + x[f[1]] + x[f[2]] + x[f[3]]); };
  weld.facets = {};
  Vec3d axis;
  for (Index e : weld.elements) {
    std::array<Facet, 2> chosen{};
    int least = std::numeric_limits<int>::max();
    double shortest = 0.0;
    for (const auto& pair : opposite_faces(model.solids.node[e])) {
      const int shared = count.at(sorted(pair[0])) + count.at(sorted(pair[1]));
      const double length = norm(centre(pair[1]) - centre(pair[0]));
      if (shared > least || (shared == least && length >= shortest)) continue;
      chosen = pair;
      least = shared;
      shortest = length;
    }
    const Vec3d own = centre(chosen[1]) - centre(chosen[0]);
    if (norm(axis) == 0.0) axis = own;
    if (dot(own, axis) < 0.0) chosen = {reversed(chosen[1]), reversed(chosen[0])};
    for (std::size_t end = 0; end < 2; ++end)
      if (count.at(sorted(chosen[end])) == 1) weld.facets[end].push_back(chosen[end]);
  }
}

/// Of a brick that shares a face with another weld: the pair of faces that is held best, of equal ones the one with the
/// shortest distance; false for any other weld.
bool find_held_faces(const model::Model& model, Weld& weld, const SheetAt& sheet_at, const std::set<Facet>& between) {
  if (weld.elements.size() != 1 || between.empty()) return false;
  const std::vector<Vec3d>& x = model.nodes.x;
  const auto held = [&](const Facet& f) {
    return sheet_of(f, sheet_at) != none ? 3 : between.contains(sorted(f)) ? 1 : 0;
  };
  const auto centre = [&](const Facet& f) { return 0.25 * (x[f[0]] + x[f[1]] + x[f[2]] + x[f[3]]); };
  bool shares = false;
  int most = -1;
  double shortest = 0.0;
  for (const auto& pair : opposite_faces(model.solids.node[weld.elements.front()])) {
    shares = shares || between.contains(sorted(pair[0])) || between.contains(sorted(pair[1]));
    const int hold = held(pair[0]) + held(pair[1]);
    const double length = norm(centre(pair[1]) - centre(pair[0]));
    if (hold < most || (hold == most && length >= shortest)) continue;
    most = hold;
    shortest = length;
    weld.facets = {std::vector<Facet>{pair[0]}, {pair[1]}};
  }
  return shares;
}

class Clusters {
 public:
  explicit Clusters(std::size_t count) : root_(count) { std::iota(root_.begin(), root_.end(), std::size_t{0}); }
  std::size_t root(std::size_t i) const { return root_[i] == i ? i : root(root_[i]); }
  void join(std::size_t i, std::size_t j) {
    const std::size_t a = root(i), b = root(j);
    root_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> root_;
};

/// Whether two bricks of a part are of one weld.
bool belong_together(const std::array<Index, 8>& a, const std::array<Index, 8>& b, const SheetAt& sheet_at) {
  std::vector<Index> shared;
  for (Index n : a)
    if (std::find(b.begin(), b.end(), n) != b.end() && std::find(shared.begin(), shared.end(), n) == shared.end())
      shared.push_back(n);
  if (shared.size() < 2) return false;
  const Index sheet = sheet_at(shared[0]);
  return sheet == none || std::any_of(shared.begin(), shared.end(), [&](Index n) { return sheet_at(n) != sheet; });
}

/// Joins the single bricks among `welds`.
Clusters cluster(const model::Model& model, const std::vector<Weld>& welds, const SheetAt& sheet_at) {
  Clusters clusters(welds.size());
  std::map<Index, std::vector<std::size_t>> at_node;
  for (std::size_t w = 0; w < welds.size(); ++w) {
    if (welds[w].kind != Weld::Kind::solid) continue;
    const std::array<Index, 8>& nodes = model.solids.node[welds[w].element];
    for (Index n : nodes)
      for (std::size_t other : at_node[n])
        if (welds[other].part == welds[w].part && clusters.root(other) != clusters.root(w) &&
            belong_together(model.solids.node[welds[other].element], nodes, sheet_at))
          clusters.join(other, w);
    for (Index n : nodes) at_node[n].push_back(w);
  }
  return clusters;
}

}  // namespace

std::vector<Weld> join_clusters(const model::Model& model, std::vector<Weld> welds, const SheetAt& sheet_at,
                                Findings& findings) {
  const Clusters clusters = cluster(model, welds, sheet_at);
  std::map<std::size_t, std::vector<std::size_t>> members;  // of each cluster, by its first weld
  for (std::size_t w = 0; w < welds.size(); ++w)
    if (welds[w].kind == Weld::Kind::solid) members[clusters.root(w)].push_back(w);
  std::size_t joined = 0;
  const Weld* first_joined = nullptr;
  for (const auto& [root, all] : members) {
    if (all.size() == 1) continue;
    Weld& first = welds[root];
    if (all.size() > most_bricks) {
      findings.warning(
          first.place, "*ELEMENT_SOLID",
          fmt::format("{} bricks of part {} share nodes, from brick {} on: more than the {} that one weld "
                      "may have; each is taken for a weld of its own",
                      all.size(), model.parts[first.part].id, first.id, most_bricks),
          "see whether the part is a weld at all; *DEFINE_HEX_SPOTWELD_ASSEMBLY says which bricks are one");
      continue;
    }
    for (std::size_t w : all) {
      first.id = std::min(first.id, welds[w].id);
      if (w == root) continue;
      first.elements.push_back(welds[w].element);
      welds[w].elements.clear();
    }
    first.kind = Weld::Kind::assembly;
    if (joined++ == 0) first_joined = &first;
  }
  if (joined > 0)
    findings.note(
        first_joined->place, "*ELEMENT_SOLID",
        fmt::format("{} weld{} recognised as assemblies: bricks of a weld part that share nodes are one weld, "
                    "its id the least of theirs; the first is {}, of {} bricks of part {}",
                    joined, joined == 1 ? "" : "s", first_joined->id, first_joined->elements.size(),
                    model.parts[first_joined->part].id),
        "*DEFINE_HEX_SPOTWELD_ASSEMBLY says which bricks are one weld, and gives it an id of its own");
  std::erase_if(welds, [](const Weld& w) { return w.elements.empty(); });
  return welds;
}

Facet sorted(Facet face) {
  std::sort(face.begin(), face.end());
  return face;
}

std::set<Facet> faces_between_welds(const model::Model& model, const std::vector<Weld>& welds) {
  std::map<Facet, std::size_t> first;
  std::set<Facet> shared;
  for (std::size_t w = 0; w < welds.size(); ++w) {
    if (!welds[w].of_bricks()) continue;
    for (Index e : welds[w].elements)
      for (const auto& pair : opposite_faces(model.solids.node[e]))
        for (const Facet& face : pair) {
          const auto [place, is_new] = first.emplace(sorted(face), w);
          if (!is_new && place->second != w && welds[place->second].part == welds[w].part) shared.insert(place->first);
        }
  }
  return shared;
}

void find_end_faces(const model::Model& model, Weld& weld, const SheetAt& sheet_at, const std::set<Facet>& between) {
  const std::map<Facet, int> count = count_faces(model, weld);
  if (!find_faces_on_sheets(model, weld, count, sheet_at) && !find_held_faces(model, weld, sheet_at, between))
    find_faces_by_shape(model, weld, count);
  const auto take = [](std::vector<Index>& nodes, Index n) {
    if (std::find(nodes.begin(), nodes.end(), n) == nodes.end()) nodes.push_back(n);
  };
  std::vector<Index> at_ends;
  for (std::size_t end = 0; end < 2; ++end) {
    weld.face[end].clear();
    for (const Facet& facet : weld.facets[end])
      for (Index n : facet) take(weld.face[end], n);
    at_ends.insert(at_ends.end(), weld.face[end].begin(), weld.face[end].end());
  }
  std::vector<Index> in_order;
  for (Index e : weld.elements)
    for (Index n : model.solids.node[e])
      if (std::find(at_ends.begin(), at_ends.end(), n) != at_ends.end()) take(in_order, n);
  weld.ends.clear();
  for (Index n : in_order) weld.ends.emplace_back().node = n;
}

}  // namespace nugget::weld
