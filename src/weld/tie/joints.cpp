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

#include "kernel/law/own_kernels.hpp"
#include "weld/tie/disc.hpp"
#include "weld/tie/tie_findings.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

/// Effective stress over plastic strain of a point under shear, by steps of strain at a rate [1/time].
template <class Law>
Curve shear_test(const Law& law, double strain_rate, double most_strain) {
  constexpr std::size_t most_history = 256;
  constexpr double step = 5e-4;
  const double dt = step / strain_rate;
  const kernel::LawKernel<Law> kernel(law);
  std::array<double, most_history> history{};
  Curve curve;
  if (static_cast<std::size_t>(kernel.layer_history()) > most_history) return curve;
  kernel::LayerTensor<double> stress{}, rate{};
  rate.xy = strain_rate;
  double before = 0.0;
  for (double strain = 0.0; strain < most_strain; strain += step) {
    kernel.template layer<double>(stress, rate, dt, history.data());
    const double plastic = history[kernel::plastic_strain_field], effective = std::sqrt(3.0) * std::abs(stress.xy);
    if (effective < 0.5 * before) break;  // the point has failed
    before = effective;
    if (!(plastic > (curve.empty() ? 0.0 : curve.x.back()))) continue;
    curve.x.push_back(plastic);
    curve.y.push_back(effective);
  }
  if (curve.x.size() < 2) return {};
  // Back to the first yield by the first slope.
  curve.y.front() = curve.y[0] - curve.x[0] * (curve.y[1] - curve.y[0]) / (curve.x[1] - curve.x[0]);
  curve.x.front() = 0.0;
  return curve;
}

/// Of the laws with one yield stress in all directions that needs no element's size; empty of others.
Curve shear_test(const model::Material& material, double strain_rate, double most_strain) {
  return std::visit(
      [&](const auto& law) -> Curve {
        using Law = std::decay_t<decltype(law)>;
        if constexpr (std::is_same_v<Law, kernel::PlasticKinematic> || std::is_same_v<Law, kernel::PiecewiseLinear>) {
          return shear_test(law, strain_rate, most_strain);
        } else if constexpr (std::is_same_v<Law, kernel::ComposedLaw>) {
          const kernel::LawKernel<Law> kernel(law);
          const bool one = kernel.axes() == nullptr && kernel.size_field() == 0;
          return one ? shear_test(law, strain_rate, most_strain) : Curve{};
        } else {
          return {};
        }
      },
      material.law);
}

constexpr double at_rest = 1e-12;  // [1/time], whatever the unit of time

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

}  // namespace

Curve yield_at_rest(const model::Material& material) {
  return shear_test(material, at_rest, 1.0);
}

Curve rate_factor(const model::Material& material) {
  constexpr double strain = 0.02, enough = 0.06;  // shear strain to reach that plastic strain and more
  const Curve slow = shear_test(material, at_rest, enough);
  if (slow.empty()) return {};
  Curve factor{.x = {0.0}, .y = {1.0}};
  for (double rate = 1e-6; rate < 2e4; rate *= 3.0) {
    const Curve fast = shear_test(material, std::sqrt(3.0) * rate, enough);  // effective over shear strain
    if (fast.empty()) break;
    factor.x.push_back(rate);
    factor.y.push_back(fast.clamped(strain) / slow.clamped(strain));
  }
  const bool counts = std::any_of(factor.y.begin(), factor.y.end(), [](double y) { return std::abs(y - 1.0) > 1e-6; });
  return counts ? factor : Curve{};
}

namespace {

/// What the laws of sheets answer to shear tests, once a material: there are many welds to few of them.
class SheetTests {
 public:
  struct Answers {
    Curve yield, rate_factor;
  };
  const Answers& of(const model::Model& model, Index material) {
    const auto [found, is_new] = answers_.try_emplace(material);
    if (is_new) found->second = {yield_at_rest(model.materials[material]), rate_factor(model.materials[material])};
    return found->second;
  }

 private:
  std::map<Index, Answers> answers_;
};

std::vector<kernel::JointEnd> joint_ends(const model::Model& model, const Ties& ties, const Weld& weld,
                                         SheetTests& tests) {
  std::vector<kernel::JointEnd> ends;
  for (const std::vector<Index>& face : weld.face) {
    const Tie* tie = disc_of(ties, face);
    if (tie == nullptr) continue;
    const model::Material& material = model.materials[model.parts[tie->part].material];
    const double young = material.young();
    if (!(young > 0.0) || std::holds_alternative<kernel::Rigid>(material.law)) continue;
    Vec3d middle;
    for (const Index node : face) middle += (1.0 / static_cast<double>(face.size())) * tie_of(ties, node)->point;
    ends.push_back(
        {.E = young,
         .nu = material.poisson(),
         .thickness = model.shells.thickness[tie->shell],
         .diameter = weld.diameter,
         .reach = effective_radius(tie->disc.nodes, tie->disc.weights, ties.x, middle) / (0.5 * weld.diameter),
         .yield = tests.of(model, model.parts[tie->part].material).yield,
         .rate_factor = tests.of(model, model.parts[tie->part].material).rate_factor});
  }
  return ends;
}

}  // namespace

std::vector<kernel::JointEnd> joint_ends(const model::Model& model, const Ties& ties, const Weld& weld) {
  SheetTests tests;
  return joint_ends(model, ties, weld, tests);
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
    const std::vector<kernel::JointEnd> ends = joint_ends(model, ties, weld, tests);
    if (ends.empty()) continue;
    joints[w] = Joint{kernel::WeldJoint(ends)};
    if (!weld.of_bricks()) continue;
    const bool first = moves(ties, weld, 0, welds_at), second = moves(ties, weld, 1, welds_at);
    if (!first || !second) joints[w]->share = {first ? 1.0 : 0.0, second ? 1.0 : 0.0};
  }
  return joints;
}

void report_joints(const model::Model& model, const Ties& ties, Findings& findings) {
  if (model.control.weld_tie != model::WeldTie::joint) return;
  std::size_t beams = 0, clusters = 0, flowing = 0;
  std::map<std::string, std::vector<const Weld*>> without;
  std::vector<const Weld*> stacked;
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
    const auto shared = [&](Index node) { return welds_at.at(node) > 1; };
    if (std::any_of(weld.face.begin(), weld.face.end(), [&](const std::vector<Index>& face) {
          return disc_of(ties, face) != nullptr && std::any_of(face.begin(), face.end(), shared);
        }))
      stacked.push_back(&weld);
    flowing += joint.flows();
    most_in_plane = std::max(most_in_plane, joint.in_plane());
    most_bending = std::max(most_bending, joint.bending());
  }
  findings.note({model.deck, 0, 0}, "*NUGGET_WELD_TIE",
                fmt::format("{} weld beams and {} welds of bricks have joints, {} of them plastic; most flexibility in "
                            "the plane {:.3g} length/force, in bending {:.3g} 1/moment",
                            beams, clusters, flowing, most_in_plane, most_bending));
  if (!stacked.empty())
    findings.warning(
        stacked.front()->place, keyword_of(*stacked.front()),
        fmt::format("{} welds share a sheet's nugget with another weld of their stack, first of them {}: "
                    "the joint of each goes by its own force, so a sheet in the middle that both pull the "
                    "same way yields around the nugget too late",
                    stacked.size(), name_weld(*stacked.front())),
        "refine that sheet to elements of half the diameter, or judge such welds by their own forces only; "
        "docs/evidence/weld_place.md has the errors of three sheets");
  for (const auto& [reason, welds] : without)
    findings.warning(welds.front()->place, keyword_of(*welds.front()),
                     fmt::format("{} weld{} of bricks, tied by area, without a joint, first of {}: {}", welds.size(),
                                 welds.size() == 1 ? "" : "s", name_weld(*welds.front()), reason),
                     "joints are built for weld beams and for one layer of bricks between two sheets");
}

}  // namespace nugget::weld
