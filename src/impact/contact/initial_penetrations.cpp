// SPDX-License-Identifier: Apache-2.0
#include "impact/contact/initial_penetrations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "base/index.hpp"
#include "contact/crossings.hpp"
#include "contact/surface_contact.hpp"
#include "contact/surface_part.hpp"
#include "impact/contact/contact_setup.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::impact {
namespace {

constexpr int removal_passes = 20;
constexpr std::size_t proposals = 5;  // with IGNORE = 2: coordinates of the deepest nodes only

std::string element_name(const model::Model& model, const contact::Segment& segment) {
  const auto shells = static_cast<int>(model.shells.size());
  if (segment.element < shells) return fmt::format("shell {}", model.shells.id[segment.element]);
  return fmt::format("solid {}", model.solids.id[segment.element - shells]);
}

/// A node in the thickness of a segment, or in the brick behind it, on whichever rank that was found.
struct Overlap {
  contact::Penetration found;
  contact::Segment segment;
};

/// By node; over several ranks what all of them have found in their parts of the surface.
std::vector<Overlap> overlaps_of_all(const contact::SurfaceContactSetup& part,
                                     const std::vector<contact::Penetration>& found, Ranks* ranks) {
  std::vector<Overlap> all;
  all.reserve(found.size());
  for (const contact::Penetration& p : found) all.push_back({p, part.segments[p.segment]});
  if (ranks == nullptr) return all;
  all = gather_lists(*ranks, all);
  std::ranges::stable_sort(all, {}, [](const Overlap& o) { return o.found.node; });
  return all;
}

/// How many nodes they are.
std::size_t nodes_in(const std::vector<Overlap>& overlaps) {
  std::set<int> nodes;
  for (const Overlap& o : overlaps) nodes.insert(o.found.node);
  return nodes.size();
}

void sort_deepest_first(std::vector<Overlap>& overlaps) {
  std::ranges::stable_sort(overlaps, std::ranges::greater{}, [](const Overlap& o) { return o.found.depth; });
}

std::string proposal(const model::Model& model, const contact::Penetration& p, std::span<const Row> x) {
  const Vec3d out = vec(x[p.node]) + p.depth * p.direction;
  return fmt::format("node {} to ({:.6g}, {:.6g}, {:.6g})", model.nodes.id[p.node], out.x, out.y, out.z);
}

/// A node of the back of a body that is one brick thick stands behind the face in front, deep in its own brick: what
/// shares a brick with a face is not pressed by it.
void leave_own_bricks_out(const model::Model& model, std::vector<Overlap>& found) {
  std::map<int, std::set<int>> neighbours;  // by node that was found: all nodes of its bricks
  for (const Overlap& o : found) neighbours[o.found.node];
  for (std::size_t e = 0; e < model.solids.size(); ++e)
    for (const model::Index n : model.solids.nodes(e))
      if (const auto it = neighbours.find(n); it != neighbours.end())
        it->second.insert(model.solids.nodes(e).begin(), model.solids.nodes(e).end());
  std::erase_if(found, [&](const Overlap& o) {
    return std::ranges::any_of(o.segment.node, [&](int n) { return neighbours[o.found.node].contains(n); });
  });
}

/// Bricks that start so far in each other that nothing presses them apart.
void report_out_of_reach(const model::Model& model, const model::Contact& card,
                         const contact::SurfaceContactSetup& part, std::span<const Row> x, Ranks* ranks,
                         Findings& findings) {
  if (model.solids.size() == 0) return;
  std::vector<Overlap> deep = overlaps_of_all(part, contact::find_nodes_out_of_reach(part, x), ranks);
  sort_deepest_first(deep);
  leave_own_bricks_out(model, deep);
  if (deep.empty()) return;
  const Overlap& worst = deep.front();
  findings.warning(
      card.place, '*' + card.keyword,
      fmt::format("{} nodes stand deeper in bricks at the start than contact presses, {:g} of a brick's depth: nothing "
                  "holds the two bodies apart there; the deepest is node {}, {:.4g} deep in {}",
                  nodes_in(deep), contact::pressing_depth, model.nodes.id[worst.found.node], worst.found.depth,
                  element_name(model, worst.segment)),
      "move the bodies apart, or leave one of them out of the contact");
}

/// `divided`: among the ranks; null: this process has it whole. Returns what was found, the deepest first.
std::vector<Overlap> treat(const model::Model& model, const model::Contact& card,
                           const contact::SurfaceContactSetup& setup, std::span<Row> x,
                           const contact::DividedSurface* divided, Findings& findings) {
  std::vector<Overlap> found =
      overlaps_of_all(setup,
                      card.ignore == 0 ? contact::remove_penetrations(setup, x, removal_passes, divided)
                                       : contact::find_penetrations(setup, x),
                      divided != nullptr ? &divided->ranks : nullptr);
  // What round-off makes of sheets or bricks that just touch is none.
  std::erase_if(found, [](const Overlap& o) {
    return o.found.depth <= 1e-6 * (o.segment.volume > 0.0 ? std::cbrt(o.segment.volume) : o.segment.thickness);
  });
  if (found.empty()) return found;
  sort_deepest_first(found);
  const Overlap& worst = found.front();
  const std::string what = fmt::format(
      "{} nodes stand in the thickness of a sheet or in a brick at the start; the deepest is node {}, "
      "{:.4g} deep in {}",
      nodes_in(found), model.nodes.id[worst.found.node], worst.found.depth, element_name(model, worst.segment));
  const std::string keyword = '*' + card.keyword;
  if (card.ignore == 0)
    findings.warning(card.place, keyword, what + "; they were moved out (IGNORE = 0)",
                     "IGNORE = 1 keeps the coordinates and tracks the initial penetration");
  if (card.ignore == 1)
    findings.note(card.place, keyword,
                  fmt::format("{}; the overlap is kept and gives no force ({})", what,
                              card.soft == 2 ? "SOFT = 2" : "IGNORE = 1"));
  if (card.ignore == 0 || card.ignore == 1) return found;
  std::string advice = "move";
  for (std::size_t i = 0; i < std::min(proposals, found.size()); ++i)
    advice += (i == 0 ? " " : "; ") + proposal(model, found[i].found, x);
  findings.warning(card.place, keyword, what + "; the overlap is kept and gives no force (IGNORE = 2)", advice);
  return found;
}

/// Shells that the contact sees thinner than they are.
void report_thin_shells(const model::Model& model, const model::Contact& card,
                        const contact::SurfaceContactSetup& setup, Findings& findings) {
  std::set<int> thin;
  int worst = model::none;
  double least = 0.99, seen = 0.0;  // what is a hundredth thinner is not worth a word
  for (const contact::Segment& s : setup.segments) {
    if (s.volume > 0.0 || s.element < 0) continue;
    const model::Part& part = model.parts[model.shells.part[s.element]];
    const double own = contact_thickness(card, part, model.shells.thickness[s.element], true);
    const double now = shell_contact_thickness(model, card, at(s.element), true, model.nodes.x);
    if (!(now < 0.99 * own)) continue;
    thin.insert(s.element);
    if (now >= least * own) continue;
    least = now / own;
    seen = now;
    worst = s.element;
  }
  if (thin.empty()) return;
  findings.note(card.place, '*' + card.keyword,
                fmt::format("{} shells are thinner for this contact than they are, 0.4 of their shortest side (SSTHK = "
                            "0): {:.4g} in place of {:.4g} in shell {}; SSTHK = 1 of *CONTROL_CONTACT leaves them as "
                            "thick as they are",
                            thin.size(), seen, seen / least, model.shells.id[worst]));
}

/// Deep in a sheet, as nodes are where sheets go through each other.
bool stands_near_the_middle(const Overlap& o) {
  return !(o.segment.volume > 0.0) && o.found.depth > 0.5 * o.segment.thickness;
}

/// Sheets that go through each other from the start: each side of the one pushes its own way. `setup`: the whole
/// surface, on each rank.
void report_crossings(const model::Model& model, const model::Contact& card, const contact::SurfaceContactSetup& setup,
                      std::span<const Row> x, Ranks* ranks, Findings& findings) {
  const auto rank = at(ranks != nullptr ? ranks->rank() : 0), count = at(ranks != nullptr ? ranks->count() : 1);
  const std::size_t segments = setup.segments.size();
  std::vector<contact::Crossing> all =
      contact::find_crossings(setup, x, segments * rank / count, segments * (rank + 1) / count);
  if (ranks != nullptr) all = gather_lists(*ranks, all);
  if (all.empty()) return;
  std::sort(all.begin(), all.end());
  std::set<std::array<int, 2>> edges;
  for (const contact::Crossing& c : all) edges.insert(c.edge);
  const contact::Crossing& first = all.front();
  const auto& [a, b] = first.edge;
  const Vec3d middle = 0.5 * (vec(x[a]) + vec(x[b]));
  findings.warning(
      card.place, '*' + card.keyword,
      fmt::format("{} edges of shells go through other shells at the start, which nothing pulls out again; "
                  "the first is from node {} to {}, near ({:.6g}, {:.6g}, {:.6g}), through {}",
                  edges.size(), model.nodes.id[a], model.nodes.id[b], middle.x, middle.y, middle.z,
                  element_name(model, setup.segments[at(first.segment)])),
      "move the sheets apart, cut the one off where it meets the other, or leave one of them out of the "
      "contact");
}

/// The welds that SPOTHIN goes by: tied to the sheets where they stand in the deck.
std::vector<weld::Weld> welds_that_thin(const model::Model& model) {
  if (model.control.weld_thinning <= 0.0 || model.control.weld_thinning >= 1.0) return {};
  Findings reported_later;
  return weld::tie(model, reported_later).welds;
}

}  // namespace

std::vector<Vec3d> resolve_initial_penetrations(const model::Model& model, Findings& findings, Ranks* ranks) {
  std::vector<Vec3d> x = model.nodes.x;
  if (std::none_of(model.contacts.begin(), model.contacts.end(), [](const auto& c) { return c.slides(); })) return x;
  const std::vector<weld::Weld> welds = welds_that_thin(model);
  const ContactMesh mesh(model, x, welds);
  std::vector<Row> rows(x.size());
  for (std::size_t n = 0; n < x.size(); ++n) set(rows[n], x[n]);
  for (const model::Contact& card : model.contacts) {
    if (!card.slides()) continue;
    contact::SurfaceContactSetup setup = contact_setup(mesh, card);
    if (setup.segments.empty()) continue;
    report_thin_shells(model, card, setup, findings);
    std::optional<contact::DividedSurface> divided;
    if (ranks != nullptr) {
      const double room = contact::search_margin(setup, rows);
      const auto part = [ranks, room](const contact::SurfaceContactSetup& whole, std::span<const Row> now) {
        return contact::part_of(whole, now, ranks->rank(), ranks->count(), room);
      };
      // Places in the mesh are those from before this contact.
      divided.emplace(contact::DividedSurface{*ranks, room, [&mesh, &card, part](std::span<const Row> now) {
                                                return part(contact_setup(mesh, card), now);
                                              }});
      setup = part(setup, rows);
    }
    const std::vector<Overlap> found = treat(model, card, setup, rows, divided ? &*divided : nullptr, findings);
    if (std::ranges::any_of(found, stands_near_the_middle))
      report_crossings(model, card, divided ? contact_setup(mesh, card) : setup, rows, ranks, findings);
    if (divided && card.ignore == 0) setup = divided->part(rows);
    report_out_of_reach(model, card, setup, rows, ranks, findings);
    if (card.ignore != 0) continue;
    for (std::size_t n = 0; n < x.size(); ++n) x[n] = vec(rows[n]);
  }
  return x;
}

}  // namespace nugget::impact
