// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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

bool is_joined(const model::Model& model, const Weld& weld) {
  return model.control.weld_tie == model::WeldTie::joint && weld.kind == Weld::Kind::beam &&
         of_weld_material(model, weld.part);
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

std::vector<kernel::JointEnd> joint_ends(const model::Model& model, const Ties& ties, const Weld& weld) {
  std::vector<kernel::JointEnd> ends;
  for (const Projection& end : weld.ends) {
    const auto tie = std::lower_bound(ties.ties.begin(), ties.ties.end(), end.node,
                                      [](const Tie& t, Index n) { return t.node < n; });
    if (tie == ties.ties.end() || tie->node != end.node || !tie->by_area() || tie->shell == none) continue;
    const model::Material& material = model.materials[model.parts[tie->part].material];
    const double young = material.young();
    if (!(young > 0.0) || std::holds_alternative<kernel::Rigid>(material.law)) continue;
    ends.push_back(
        {.E = young,
         .nu = material.poisson(),
         .thickness = model.shells.thickness[tie->shell],
         .diameter = weld.diameter,
         .reach = effective_radius(tie->disc.nodes, tie->disc.weights, ties.x, tie->point) / (0.5 * weld.diameter),
         .yield = yield_at_rest(material),
         .rate_factor = rate_factor(material)});
  }
  return ends;
}

std::optional<kernel::WeldJoint> joint_of(const model::Model& model, const Ties& ties, const Weld& weld) {
  if (!is_joined(model, weld)) return std::nullopt;
  const std::vector<kernel::JointEnd> ends = joint_ends(model, ties, weld);
  if (ends.empty()) return std::nullopt;
  return kernel::WeldJoint(ends);
}

void report_joints(const model::Model& model, const Ties& ties, Findings& findings) {
  if (model.control.weld_tie != model::WeldTie::joint) return;
  std::size_t joints = 0, flowing = 0;
  std::vector<const Weld*> bricks;
  double most_in_plane = 0.0, most_bending = 0.0;
  for (const Weld& weld : ties.welds) {
    if (weld.of_bricks()) bricks.push_back(&weld);
    const auto joint = joint_of(model, ties, weld);
    if (!joint) continue;
    ++joints;
    flowing += joint->flows();
    most_in_plane = std::max(most_in_plane, joint->in_plane());
    most_bending = std::max(most_bending, joint->bending());
  }
  findings.note({model.deck, 0, 0}, "*NUGGET_WELD_TIE",
                fmt::format("{} weld beams have joints, {} of them plastic; most flexibility in the plane {:.3g} "
                            "length/force, in bending {:.3g} 1/moment",
                            joints, flowing, most_in_plane, most_bending));
  if (!bricks.empty())
    findings.warning(bricks.front()->place, keyword_of(*bricks.front()),
                     fmt::format("{} welds of bricks get no joint, first of {}; they are tied by area", bricks.size(),
                                 name_weld(*bricks.front())),
                     "joints are built for weld beams of *MAT_SPOTWELD");
}

}  // namespace nugget::weld
