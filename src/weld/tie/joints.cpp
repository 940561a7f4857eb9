// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <variant>

#include "kernel/element/weld_stack.hpp"
#include "model/sheet_yield.hpp"
#include "weld/tie/disc.hpp"
#include "weld/tie/tie_findings.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

bool may_be_joined(const model::Model& model, const Weld& weld) {
  return model.control.weld_tie == model::WeldTie::joint && (weld.kind == Weld::Kind::beam || weld.of_bricks()) &&
         !weld.deleted && of_weld_material(model, weld.part);
}

const Tie* tie_of(const Ties& ties, Index node) {
  const auto tie =
      std::lower_bound(ties.ties.begin(), ties.ties.end(), node, [](const Tie& t, Index n) { return t.node < n; });
  return tie == ties.ties.end() || tie->node != node ? nullptr : &*tie;
}

/// The tie that stands for those of an end's nodes; null unless all of them are tied by area.
const Tie* disc_of(const Ties& ties, std::span<const Index> end) {
  const Tie* first = nullptr;
  for (const Index node : end) {
    const Tie* tie = tie_of(ties, node);
    if (tie == nullptr || !tie->by_area() || tie->shell == none) return nullptr;
    if (first == nullptr) first = tie;
  }
  return first;
}

/// How many welds have each node in an end face.
std::map<Index, int> welds_at_nodes(const Ties& ties) {
  std::map<Index, int> count;
  for (const Weld& weld : ties.welds)
    for (const std::vector<Index>& face : weld.face)
      for (const Index node : face) ++count[node];
  return count;
}

/// Whether all nodes of the bricks lie in the end faces.
bool has_one_layer(const model::Model& model, const Weld& weld) {
  return std::all_of(weld.elements.begin(), weld.elements.end(), [&](Index e) {
    return std::all_of(model.solids.node[e].begin(), model.solids.node[e].begin() + 8, [&](Index node) {
      return std::any_of(weld.face.begin(), weld.face.end(), [&](const std::vector<Index>& face) {
        return std::find(face.begin(), face.end(), node) != face.end();
      });
    });
  });
}

/// Whether a joint can move the face of an end against its sheet; the bricks would be torn from what else has the
/// nodes.
bool moves(const Ties& ties, const Weld& weld, std::size_t end, const std::map<Index, int>& welds_at) {
  return disc_of(ties, weld.face[end]) != nullptr &&
         std::all_of(weld.face[end].begin(), weld.face[end].end(),
                     [&](Index node) { return welds_at.at(node) == 1 && !tie_of(ties, node)->spring; });
}

/// Why a weld of bricks that is tied by area has no joint; empty: it has.
std::string why_no_joint(const model::Model& model, const Ties& ties, const Weld& weld,
                         const std::map<Index, int>& welds_at) {
  if (weld.held_by_bricks) return "it is a brick inside a larger nugget";
  if (!has_one_layer(model, weld)) return "it has more than one layer of bricks";
  if (!moves(ties, weld, 0, welds_at) && !moves(ties, weld, 1, welds_at))
    return "no end face follows its sheet by a constraint with all its nodes and has them for itself";
  return {};
}

/// What the laws of sheets answer to shear tests, once a material: there are many welds to few of them.
class SheetTests {
 public:
  struct Answers {
    Curve yield, rate_factor;
  };
  const Answers& of(const model::Model& model, Index material) {
    const auto [found, is_new] = answers_.try_emplace(material);
    if (is_new) {
      const double thickness = thinnest(model, material);
      found->second = {model::yield_at_rest(model.materials[material], thickness),
                       model::rate_factor(model.materials[material], thickness)};
    }
    return found->second;
  }

 private:
  static double thinnest(const model::Model& model, Index material) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < model.shells.part.size(); ++e)
      if (model.parts[model.shells.part[e]].material == material) least = std::min(least, model.shells.thickness[e]);
    return least;
  }

  std::map<Index, Answers> answers_;
};

/// Where an end of a weld is tied: the mean of its nodes' feet.
Vec3d foot_of(const Ties& ties, const std::vector<Index>& face) {
  Vec3d middle;
  for (const Index node : face) middle += (1.0 / static_cast<double>(face.size())) * tie_of(ties, node)->point;
  return middle;
}

using Ends = std::array<std::optional<kernel::JointEnd>, 2>;
Ends joint_ends(const model::Model& model, const Ties& ties, const Weld& weld, SheetTests& tests) {
  Ends ends;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Tie* tie = disc_of(ties, weld.face[i]);
    if (tie == nullptr) continue;
    const model::Material& material = model.materials[model.parts[tie->part].material];
    const double young = material.young();
    if (!(young > 0.0) || std::holds_alternative<kernel::Rigid>(material.law)) continue;
    const double reach = effective_radius(tie->disc.nodes, tie->disc.weights, ties.x, foot_of(ties, weld.face[i]));
    ends[i] = {.E = young,
               .nu = material.poisson(),
               .thickness = model.shells.thickness[tie->shell],
               .diameter = weld.diameter,
               .reach = reach / (0.5 * weld.diameter),
               .yield = tests.of(model, model.parts[tie->part].material).yield,
               .rate_factor = tests.of(model, model.parts[tie->part].material).rate_factor};
  }
  return ends;
}

std::vector<kernel::JointEnd> those_of(const Ends& ends) {
  std::vector<kernel::JointEnd> those;
  for (const std::optional<kernel::JointEnd>& end : ends)
    if (end) those.push_back(*end);
  return those;
}

}  // namespace

std::vector<kernel::JointEnd> joint_ends(const model::Model& model, const Ties& ties, const Weld& weld) {
  SheetTests tests;
  return those_of(joint_ends(model, ties, weld, tests));
}

std::vector<std::optional<Joint>> joints_of(const model::Model& model, const Ties& ties) {
  std::vector<std::optional<Joint>> joints(ties.welds.size());
  if (model.control.weld_tie != model::WeldTie::joint) return joints;
  const std::map<Index, int> welds_at = welds_at_nodes(ties);
  SheetTests tests;
  for (std::size_t w = 0; w < joints.size(); ++w) {
    const Weld& weld = ties.welds[w];
    if (!may_be_joined(model, weld)) continue;
    if (weld.of_bricks() && !why_no_joint(model, ties, weld, welds_at).empty()) continue;
    const Ends ends = joint_ends(model, ties, weld, tests);
    const std::vector<kernel::JointEnd> those = those_of(ends);
    if (those.empty()) continue;
    joints[w] = Joint{.law = kernel::WeldJoint(those), .end = ends};
    if (!weld.of_bricks()) continue;
    const bool first = moves(ties, weld, 0, welds_at), second = moves(ties, weld, 1, welds_at);
    if (!first || !second) joints[w]->share = {first ? 1.0 : 0.0, second ? 1.0 : 0.0};
  }
  return joints;
}

namespace {

/// An end of a weld: weld and 0 or 1.
struct EndOf {
  std::size_t weld = 0, end = 0;
};

/// The ends that stand at one place of a sheet with each of the others, by 2 weld + end.
class Neighbours {
 public:
  Neighbours(const Ties& ties, const std::vector<std::optional<Joint>>& joints) : at_(2 * joints.size()) {
    struct Place {
      EndOf of;
      Index part;
      Vec3d foot, along;
      double reach;
    };
    std::vector<Place> places;
    for (std::size_t w = 0; w < joints.size(); ++w) {
      if (!joints[w] || !joints[w]->law.flows()) continue;
      const Weld& weld = ties.welds[w];
      const std::array<Vec3d, 2> centre{centre_of(ties, weld.face[0]), centre_of(ties, weld.face[1])};
      for (std::size_t e = 0; e < 2; ++e) {
        const Tie* tie = disc_of(ties, weld.face[e]);
        if (tie != nullptr)
          places.push_back({{w, e},
                            tie->part,
                            foot_of(ties, weld.face[e]),
                            centre[1 - e] - centre[e],
                            share_of_diameter * weld.diameter});
      }
    }
    std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
      return a.part != b.part ? a.part < b.part : a.foot.x < b.foot.x;
    });
    double widest = 0.0;
    for (const Place& p : places) widest = std::max(widest, p.reach);
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t j = i + 1; j < places.size(); ++j) {
        const Place &a = places[i], &b = places[j];
        if (a.part != b.part || b.foot.x - a.foot.x > widest) break;
        if (a.of.weld == b.of.weld || norm(a.foot - b.foot) > std::min(a.reach, b.reach)) continue;
        const bool opposite = dot(a.along, b.along) < 0.0;
        at_[2 * a.of.weld + a.of.end].push_back({b.of, opposite});
        at_[2 * b.of.weld + b.of.end].push_back({a.of, opposite});
      }
  }
  /// Null where there is none, or not one only, or it comes from the same side.
  const EndOf* opposite(const EndOf& end) const {
    const auto& all = at_[2 * end.weld + end.end];
    return all.size() == 1 && all[0].opposite ? &all[0].of : nullptr;
  }
  bool crowded(const EndOf& end) const { return !at_[2 * end.weld + end.end].empty() && opposite(end) == nullptr; }

 private:
  static constexpr double share_of_diameter = 0.25;  // as far apart two ends may be at one nugget
  static Vec3d centre_of(const Ties& ties, const std::vector<Index>& face) {
    Vec3d middle;
    for (const Index node : face) middle += (1.0 / static_cast<double>(face.size())) * ties.x[node];
    return middle;
  }
  struct Neighbour {
    EndOf of;
    bool opposite;
  };
  std::vector<std::vector<Neighbour>> at_;
};

/// Of a sheet that two nuggets share: the wider of them counts.
const std::optional<kernel::JointEnd>& wider(const std::optional<kernel::JointEnd>& a,
                                             const std::optional<kernel::JointEnd>& b) {
  return !a || (b && b->diameter > a->diameter) ? b : a;
}

}  // namespace

JointStacks stacks_of(const model::Model& model, const Ties& ties, const std::vector<std::optional<Joint>>& joints) {
  JointStacks found;
  if (model.control.weld_tie != model::WeldTie::joint) return found;
  const Neighbours neighbours(ties, joints);
  std::vector<bool> done(joints.size(), false);
  const auto flows = [&](std::size_t w) { return joints[w] && joints[w]->law.flows(); };
  for (std::size_t w = 0; w < joints.size(); ++w)
    if (flows(w) && (neighbours.crowded({w, 0}) || neighbours.crowded({w, 1}))) found.crowded.push_back(w);
  for (std::size_t w = 0; w < joints.size(); ++w) {
    if (!flows(w) || done[w]) continue;
    for (std::size_t e = 0; e < 2 && !done[w]; ++e) {
      if (neighbours.opposite({w, e}) != nullptr || neighbours.opposite({w, 1 - e}) == nullptr) continue;
      Stack stack;
      EndOf first{w, e};  // of each weld, the one at its earlier sheet
      stack.sheets.push_back(joints[w]->end[e]);
      for (;;) {
        done[first.weld] = true;
        stack.welds.push_back({first.weld, first.end == 1});
        const EndOf last{first.weld, 1 - first.end};
        const EndOf* next = neighbours.opposite(last);
        const std::optional<kernel::JointEnd>& own = joints[last.weld]->end[last.end];
        stack.sheets.push_back(next == nullptr ? own : wider(own, joints[next->weld]->end[next->end]));
        if (next == nullptr) break;
        first = *next;
      }
      if (stack.welds.size() <= kernel::StackJoint::most_welds) {
        found.stacks.push_back(std::move(stack));
      } else {
        for (const Stack::Member& member : stack.welds) found.crowded.push_back(member.weld);
      }
    }
  }
  return found;
}

void report_joints(const model::Model& model, const Ties& ties, Findings& findings) {
  if (model.control.weld_tie != model::WeldTie::joint) return;
  std::size_t beams = 0, clusters = 0, flowing = 0;
  std::map<std::string, std::vector<const Weld*>> without;
  double most_in_plane = 0.0, most_bending = 0.0;
  const std::map<Index, int> welds_at = welds_at_nodes(ties);
  const std::vector<std::optional<Joint>> joints = joints_of(model, ties);
  for (std::size_t w = 0; w < joints.size(); ++w) {
    const Weld& weld = ties.welds[w];
    if (!joints[w]) {
      if (may_be_joined(model, weld) && weld.of_bricks() && !joint_ends(model, ties, weld).empty())
        without[why_no_joint(model, ties, weld, welds_at)].push_back(&weld);
      continue;
    }
    const kernel::WeldJoint& joint = joints[w]->law;
    ++(weld.of_bricks() ? clusters : beams);
    flowing += joint.flows();
    most_in_plane = std::max(most_in_plane, joint.in_plane());
    most_bending = std::max(most_bending, joint.bending());
  }
  findings.note({model.deck, 0, 0}, "*NUGGET_WELD_TIE",
                fmt::format("{} weld beams and {} welds of bricks have joints, {} of them plastic; most flexibility in "
                            "the plane {:.3g} length/force, in bending {:.3g} 1/moment",
                            beams, clusters, flowing, most_in_plane, most_bending));
  const JointStacks stacks = stacks_of(model, ties, joints);
  if (!stacks.stacks.empty()) {
    std::size_t in_stacks = 0;
    for (const Stack& stack : stacks.stacks) in_stacks += stack.welds.size();
    findings.note({model.deck, 0, 0}, "*NUGGET_WELD_TIE",
                  fmt::format("{} welds with joints follow each other in {} stacks: a sheet between two of them yields "
                              "by the forces of both",
                              in_stacks, stacks.stacks.size()));
  }
  if (!stacks.crowded.empty()) {
    const Weld& first = ties.welds[stacks.crowded.front()];
    findings.warning(
        first.place, keyword_of(first),
        fmt::format("{} welds end at a place of a sheet at which more than one other weld ends, or another "
                    "from the same side, or stand in a stack of more than {} sheets, first of them {}: the "
                    "joint of each goes by its own force, so what the others do to the sheet is missing",
                    stacks.crowded.size(), kernel::StackJoint::most_welds + 1, name_weld(first)),
        "leave one weld between two sheets at a place");
  }
  for (const auto& [reason, welds] : without)
    findings.warning(welds.front()->place, keyword_of(*welds.front()),
                     fmt::format("{} weld{} of bricks, tied by area, without a joint, first of {}: {}", welds.size(),
                                 welds.size() == 1 ? "" : "s", name_weld(*welds.front()), reason),
                     "joints are built for weld beams and for one layer of bricks between two sheets");
}

}  // namespace nugget::weld
