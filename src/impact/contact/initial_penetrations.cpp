// SPDX-License-Identifier: Apache-2.0
#include "impact/contact/initial_penetrations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <span>

#include "base/index.hpp"
#include "contact/surface_contact.hpp"
#include "impact/contact/contact_setup.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::impact {
namespace {

constexpr std::size_t proposals = 5;  // with IGNORE = 2: coordinates of the deepest nodes only

std::string element_name(const model::Model& model, const contact::Segment& segment) {
  const auto shells = static_cast<int>(model.shells.size());
  if (segment.element < shells) return fmt::format("shell {}", model.shells.id[segment.element]);
  return fmt::format("solid {}", model.solids.id[segment.element - shells]);
}

std::string proposal(const model::Model& model, const contact::Penetration& p, std::span<const Row> x) {
  const Vec3d out = vec(x[p.node]) + p.depth * p.direction;
  return fmt::format("node {} to ({:.6g}, {:.6g}, {:.6g})", model.nodes.id[p.node], out.x, out.y, out.z);
}

/// A node of the back of a body that is one brick thick stands behind the face in front, deep in its own brick: what
/// shares a brick with a face is not pressed by it.
void leave_own_bricks_out(const model::Model& model, const contact::SurfaceContactSetup& setup,
                          std::vector<contact::Penetration>& found) {
  std::map<int, std::set<int>> neighbours;  // by node that was found: all nodes of its bricks
  for (const contact::Penetration& p : found) neighbours[p.node];
  for (std::size_t e = 0; e < model.solids.size(); ++e)
    for (const model::Index n : model.solids.nodes(e))
      if (const auto it = neighbours.find(n); it != neighbours.end())
        it->second.insert(model.solids.nodes(e).begin(), model.solids.nodes(e).end());
  std::erase_if(found, [&](const contact::Penetration& p) {
    const auto& face = setup.segments[p.segment].node;
    return std::any_of(std::begin(face), std::end(face), [&](int n) { return neighbours[p.node].contains(n); });
  });
}

/// Bricks that start so far in each other that nothing presses them apart.
void report_out_of_reach(const model::Model& model, const model::Contact& card,
                         const contact::SurfaceContactSetup& setup, std::span<const Row> x, Findings& findings) {
  std::vector<contact::Penetration> deep = contact::find_nodes_out_of_reach(setup, x);
  leave_own_bricks_out(model, setup, deep);
  if (deep.empty()) return;
  std::vector<int> nodes;
  for (const contact::Penetration& p : deep) nodes.push_back(p.node);
  std::sort(nodes.begin(), nodes.end());
  const auto count = std::unique(nodes.begin(), nodes.end()) - nodes.begin();
  findings.warning(
      card.place, '*' + card.keyword,
      fmt::format("{} nodes stand deeper in bricks at the start than contact presses, {:g} of a brick's depth: nothing "
                  "holds the two bodies apart there; the deepest is node {}, {:.4g} deep in {}",
                  count, contact::pressing_depth, model.nodes.id[deep.front().node], deep.front().depth,
                  element_name(model, setup.segments[deep.front().segment])),
      "move the bodies apart, or leave one of them out of the contact");
}

void treat(const model::Model& model, const model::Contact& card, const contact::SurfaceContactSetup& setup,
           std::span<Row> x, Findings& findings) {
  std::vector<contact::Penetration> found =
      card.ignore == 0 ? contact::remove_penetrations(setup, x) : contact::find_penetrations(setup, x);
  // What round-off makes of sheets or bricks that just touch is none.
  std::erase_if(found, [&setup](const contact::Penetration& p) {
    const contact::Segment& s = setup.segments[p.segment];
    return p.depth <= 1e-6 * (s.volume > 0.0 ? std::cbrt(s.volume) : s.thickness);
  });
  if (found.empty()) return;
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.depth > b.depth; });
  std::vector<int> nodes;
  for (const contact::Penetration& p : found) nodes.push_back(p.node);
  std::sort(nodes.begin(), nodes.end());
  const auto count = std::unique(nodes.begin(), nodes.end()) - nodes.begin();
  const contact::Penetration& worst = found.front();
  const std::string what = fmt::format(
      "{} nodes stand in the thickness of a sheet or in a brick at the start; the deepest is node {}, "
      "{:.4g} deep in {}",
      count, model.nodes.id[worst.node], worst.depth, element_name(model, setup.segments[worst.segment]));
  const std::string keyword = '*' + card.keyword;
  if (card.ignore == 0)
    return findings.warning(card.place, keyword, what + "; they were moved out (IGNORE = 0)",
                            "IGNORE = 1 keeps the coordinates and tracks the initial penetration");
  if (card.ignore == 1)
    return findings.note(card.place, keyword,
                         fmt::format("{}; the overlap is kept and gives no force ({})", what,
                                     card.soft == 2 ? "SOFT = 2" : "IGNORE = 1"));
  std::string advice = "move";
  for (std::size_t i = 0; i < std::min(proposals, found.size()); ++i)
    advice += (i == 0 ? " " : "; ") + proposal(model, found[i], x);
  findings.warning(card.place, keyword, what + "; the overlap is kept and gives no force (IGNORE = 2)", advice);
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

/// The welds that SPOTHIN goes by: tied to the sheets where they stand in the deck.
std::vector<weld::Weld> welds_that_thin(const model::Model& model) {
  if (model.control.weld_thinning <= 0.0 || model.control.weld_thinning >= 1.0) return {};
  Findings reported_later;
  return weld::tie(model, reported_later).welds;
}

}  // namespace

std::vector<Vec3d> resolve_initial_penetrations(const model::Model& model, Findings& findings) {
  std::vector<Vec3d> x = model.nodes.x;
  if (std::none_of(model.contacts.begin(), model.contacts.end(), [](const auto& c) { return c.slides(); })) return x;
  const std::vector<weld::Weld> welds = welds_that_thin(model);
  const ContactMesh mesh(model, x, welds);
  std::vector<Row> rows(x.size());
  for (std::size_t n = 0; n < x.size(); ++n) set(rows[n], x[n]);
  for (const model::Contact& card : model.contacts) {
    if (!card.slides()) continue;
    const contact::SurfaceContactSetup setup = contact_setup(mesh, card);
    if (setup.segments.empty()) continue;
    report_thin_shells(model, card, setup, findings);
    treat(model, card, setup, rows, findings);
    report_out_of_reach(model, card, setup, rows, findings);
    if (card.ignore != 0) continue;
    for (std::size_t n = 0; n < x.size(); ++n) x[n] = vec(rows[n]);
  }
  return x;
}

}  // namespace nugget::impact
