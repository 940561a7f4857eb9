// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "weld/failure/function.hpp"

namespace nugget::weld::failure {
namespace {

bool is_tension(FailureMode mode) {
  return mode == FailureMode::axial || mode == FailureMode::bending || mode == FailureMode::normal_stress;
}

/// LCT, LCS, T_ORT and T_ORS of *CONTROL_SPOTWELD_BEAM: the parts of the failure value by tension and bending and by
/// shear and torsion, each over its factors at the size of the shell and the place on it; the end with the larger value
/// counts. See docs/theory/failure.md#size-of-the-shell (the project's own form).
class ShellSize final : public Function {
 public:
  ShellSize(std::unique_ptr<Function> inner, const std::array<Geometry::ShellFactor, 2>& ends)
      : inner_(std::move(inner)), ends_(ends) {}

  Value operator()(const Load& load) override {
    const Value plain = (*inner_)(load);
    Value worse;
    for (const Geometry::ShellFactor& end : ends_) {
      Value f;
      for (int i = 0; i < plain.terms; ++i) {
        const Value::Term& term = plain.term[i];
        f.add(term.mode, term.value / (is_tension(term.mode) ? end.tension : end.shear));
      }
      if (f.value >= worse.value) worse = f;
    }
    return worse;
  }

  void archive(Archive& a) override {
    a(inner_);
    a.built(ends_);
  }

 private:
  std::unique_ptr<Function> inner_;
  std::array<Geometry::ShellFactor, 2> ends_;
};

double shell_size(const model::Model& model, model::Index shell) {
  const auto& n = model.shells.node[shell];
  const auto x = [&](std::size_t i) { return model.nodes.x[n[i]]; };
  return std::sqrt(0.5 * norm(cross(x(2) - x(0), x(3) - x(1))));
}

/// Where a weld stands on its shell, as T_ORT has it: the larger of the bilinear coordinates, and the angle between it
/// and their resultant; of a triangle how far from its middle to its border, at angle 0.
void set_place(const Tie& tie, Geometry::ShellFactor& end) {
  if (tie.segment[2] == tie.segment[3]) {
    end.place = 1.0 - 3.0 * std::min({tie.weight[0], tie.weight[1], tie.weight[2]});
    return;
  }
  const double a = std::abs(tie.xi), b = std::abs(tie.eta);
  end.place = std::max(a, b);
  end.angle = std::atan2(std::min(a, b), end.place) * 180.0 / std::numbers::pi;
}

}  // namespace

std::array<Geometry::ShellFactor, 2> shell_factors(const model::Model& model, const Weld& weld) {
  const model::WeldBeamControl& control = model.control.weld_beams;
  std::array<Geometry::ShellFactor, 2> ends;
  // Bricks that stand for a beam (RPBHX) have the s axis of that beam; bricks of the deck have none.
  if (weld.kind != Weld::Kind::beam && norm(weld.orientation) == 0.0) return ends;
  for (std::size_t k = 0; k < 2; ++k) {
    double sum = 0.0;
    int shells = 0;
    for (const Projection& end : weld.ends) {
      const bool here = std::find(weld.face[k].begin(), weld.face[k].end(), end.node) != weld.face[k].end();
      if (!here || !end.tied || end.tie.shell == model::none) continue;
      sum += shell_size(model, end.tie.shell);
      ++shells;
      if (weld.kind == Weld::Kind::beam) set_place(end.tie, ends[k]);
    }
    if (shells == 0) continue;
    ends[k].size = sum / shells;
    const auto factor = [&](model::Index curve) {
      return curve == model::none ? 1.0 : model.curves[curve].clamped(ends[k].size);
    };
    ends[k].tension = factor(control.tension_curve) * control.tension_place.at(ends[k].place, ends[k].angle);
    ends[k].shear = factor(control.shear_curve) * control.shear_place.at(ends[k].place, ends[k].angle);
  }
  return ends;
}

std::unique_ptr<Function> by_shell_size(std::unique_ptr<Function> inner,
                                        const std::array<Geometry::ShellFactor, 2>& ends) {
  return std::make_unique<ShellSize>(std::move(inner), ends);
}

}  // namespace nugget::weld::failure
