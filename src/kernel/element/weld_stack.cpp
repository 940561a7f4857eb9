// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/weld_stack.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nugget::kernel {
namespace {

constexpr std::size_t most_sheets = StackJoint::most_welds + 1;
constexpr std::size_t freedoms = WeldJoint::size;
template <class T>
using OfSheets = std::array<T, most_sheets>;
template <class T>
using OfWelds = std::array<T, StackJoint::most_welds>;

const Curve& never() {
  static const Curve curve{.x = {0.0}, .y = {WeldJoint::never}};
  return curve;
}

/// Solves a x = b of the first n unknowns, in place, by elimination with the largest pivot; false where a is singular.
template <std::size_t most>
bool solve(std::array<std::array<double, most>, most>& a, std::array<double, most>& b, std::size_t n) {
  for (std::size_t p = 0; p < n; ++p) {
    std::size_t largest = p;
    for (std::size_t i = p + 1; i < n; ++i)
      if (std::abs(a[i][p]) > std::abs(a[largest][p])) largest = i;
    if (!(std::abs(a[largest][p]) > 0.0)) return false;
    std::swap(a[p], a[largest]);
    std::swap(b[p], b[largest]);
    for (std::size_t i = p + 1; i < n; ++i) {
      const double factor = a[i][p] / a[p][p];
      if (factor == 0.0) continue;
      for (std::size_t j = p; j < n; ++j) a[i][j] -= factor * a[p][j];
      b[i] -= factor * b[p];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) b[i] -= a[i][j] * b[j];
    b[i] /= a[i][i];
  }
  return true;
}

}  // namespace

/// One step: the works of the sheets are sought.
struct StackJoint::Step {
  const std::vector<Sheet>& sheets;
  std::span<const SheetState> state;
  std::span<const Weld> welds;
  OfSheets<double> factor{}, more{};  ///< by the rate; plastic work of the step at rest
  OfWelds<Freedoms> force{};          ///< after it

  /// A weld acts on its sheets in a freedom; only tension makes it flow along the normal.
  bool acts(std::size_t w, std::size_t i) const { return welds[w].holds && (i > 0 || welds[w].trial.force[i] > 0.0); }
  /// A sheet's yield condition as a sum of squares of sums over the forces of the welds below and above it: the normal
  /// force, the shears, the couples about its middle.
  using Form = std::array<Freedoms, 2>;
  using Surface = std::array<Form, freedoms>;
  /// Which weld is below (0) or above (1) a sheet; of a stack's outer sheets one is out of range.
  static std::size_t weld_at(std::size_t s, std::size_t side) { return side == 0 ? s - 1 : s; }
  Surface surface(std::size_t s) const {
    const Sheet& sheet = sheets[s];
    const double work = state[s].work + more[s], v = sheet.shear(work), u = sheet.unbent(work);
    const double by_normal = 1.0 / (factor[s] * sheet.normal(work)), by_shear = 1.0 / (factor[s] * std::max(u, v)),
                 by_moment = 1.0 / (factor[s] * sheet.moment(work));
    const double by_couple = std::sqrt(std::max(0.0, 1.0 / (v * v) - 1.0 / (u * u))) / factor[s];
    Surface surface{};
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t w = weld_at(s, side);
      if (w >= welds.size()) continue;
      const double sign = side == 0 ? 1.0 : -1.0;  // of what the weld does to the sheet
      const auto put = [&](std::size_t form, std::size_t i, double value) {
        if (acts(w, i)) surface[form][side][i] = value;
      };
      put(0, 0, sign * by_normal);
      put(1, 1, sign * by_shear);
      put(2, 2, sign * by_shear);
      put(3, 3, sign * by_moment);
      put(3, 2, by_couple);
      put(4, 4, sign * by_moment);
      put(4, 1, -by_couple);
    }
    return surface;
  }
  double value(const Form& form, std::size_t s) const {
    double sum = 0.0;
    for (std::size_t side = 0; side < 2; ++side)
      if (const std::size_t w = weld_at(s, side); w < welds.size())
        for (std::size_t i = 0; i < freedoms; ++i) sum += form[side][i] * force[w][i];
    return sum;
  }

  /// The forces that are left of the trial after the works.
  void relax() {
    for (std::size_t w = 0; w < welds.size(); ++w) force[w] = welds[w].trial.force;
    constexpr std::size_t most = freedoms * most_welds;
    const std::size_t n = freedoms * welds.size();
    std::array<std::array<double, most>, most> matrix{};
    std::array<double, most> left{};
    for (std::size_t k = 0; k < n; ++k) {
      matrix[k][k] = 1.0;
      left[k] = force[k / freedoms][k % freedoms];
    }
    for (std::size_t s = 0; s < sheets.size(); ++s) {
      if (!(more[s] > 0.0)) continue;
      const double work = factor[s] * more[s];
      for (const Form& form : surface(s))
        for (std::size_t of = 0; of < 2; ++of)
          for (std::size_t by = 0; by < 2; ++by) {
            const std::size_t w = weld_at(s, of), other = weld_at(s, by);
            if (w >= welds.size() || other >= welds.size()) continue;
            for (std::size_t i = 0; i < freedoms; ++i)
              for (std::size_t j = 0; j < freedoms; ++j)
                matrix[freedoms * w + i][freedoms * other + j] +=
                    work * welds[w].trial.stiffness[i] * form[of][i] * form[by][j];
          }
    }
    if (!solve(matrix, left, n)) return;
    for (std::size_t k = 0; k < n; ++k) force[k / freedoms][k % freedoms] = left[k];
  }
  /// The left side of a sheet's yield condition, its root less 1.
  double over(std::size_t s) const {
    if (!sheets[s].flows) return -1.0;
    double sum = 0.0;
    for (const Form& form : surface(s)) {
      const double one = value(form, s);
      sum += one * one;
    }
    return std::sqrt(sum) - 1.0;
  }
  /// About the work of a sheet that takes a force of the size of its limits away from its welds.
  double unit_of_work(std::size_t s) const {
    double most = 0.0;
    for (const Form& form : surface(s))
      for (std::size_t side = 0; side < 2; ++side)
        if (const std::size_t w = weld_at(s, side); w < welds.size())
          for (std::size_t i = 0; i < freedoms; ++i) {
            const double slope = std::abs(form[side][i]) * factor[s] * welds[w].trial.stiffness[i];
            if (slope > 0.0) most = std::max(most, std::abs(welds[w].trial.force[i]) / slope);
          }
    return most;
  }
};

StackJoint::StackJoint(std::span<const std::optional<JointEnd>> sheets) {
  for (const std::optional<JointEnd>& end : sheets) {
    Sheet sheet{false, YieldCurve(never()), YieldCurve(never()), YieldCurve(never()), YieldCurve(never()), {}, 0.0};
    if (end && !end->yield.empty()) {
      const WeldJoint::PureLoads loads = WeldJoint::pure_loads(std::span(&*end, 1));
      sheet = {true,
               YieldCurve(loads.normal),
               YieldCurve(loads.shear),
               YieldCurve(loads.moment),
               YieldCurve(unbent_shear_over_work(*end)),
               end->rate_factor,
               kernel::work_of_strain(*end)};
    }
    sheets_.push_back(std::move(sheet));
  }
}

/// Newton's method on the works of the sheets that flow, with differences; the conditions are convex and fall with the
/// works, so it comes from below and does not oscillate.
void StackJoint::advance(std::span<SheetState> state, std::span<const Weld> welds, double dt,
                         std::span<Freedoms> flow) const {
  constexpr double round_off = 1e-11, difference = 1e-7;
  constexpr int most_rounds = 60;
  Step step{sheets_, state, welds, {}, {}, {}};
  for (std::size_t s = 0; s < sheets_.size(); ++s)
    step.factor[s] = sheets_[s].rate_factor.empty() ? 1.0 : sheets_[s].rate_factor.clamped(state[s].rate);
  std::fill(flow.begin(), flow.end(), Freedoms{});
  step.relax();
  for (int round = 0; round < most_rounds; ++round) {
    OfSheets<std::size_t> flowing{};
    OfSheets<double> missing{};
    std::size_t count = 0;
    double largest = 0.0;
    for (std::size_t s = 0; s < sheets_.size(); ++s) {
      const double over = step.over(s);
      if (!(over > round_off) && !(step.more[s] > 0.0)) continue;
      largest = std::max(largest, std::abs(over));
      flowing[count] = s;
      missing[count++] = -over;
    }
    if (count == 0 || largest <= round_off) break;
    OfSheets<OfSheets<double>> slope{};
    for (std::size_t j = 0; j < count; ++j) {
      Step moved = step;
      const double by = difference * step.unit_of_work(flowing[j]);
      moved.more[flowing[j]] += by;
      moved.relax();
      for (std::size_t i = 0; i < count; ++i) slope[i][j] = (moved.over(flowing[i]) + missing[i]) / by;
    }
    if (!solve(slope, missing, count)) break;
    for (std::size_t j = 0; j < count; ++j) step.more[flowing[j]] = std::max(0.0, step.more[flowing[j]] + missing[j]);
    step.relax();
  }
  for (std::size_t s = 0; s < sheets_.size(); ++s) {
    constexpr double smoothing = 0.05;  // as WeldJoint has it
    if (sheets_[s].work_of_strain > 0.0)
      state[s].rate += smoothing * (step.more[s] / (sheets_[s].work_of_strain * dt) - state[s].rate);
    if (!(step.more[s] > 0.0)) continue;
    for (const Step::Form& form : step.surface(s)) {
      const double share = step.more[s] * step.factor[s] * step.value(form, s);
      for (std::size_t side = 0; side < 2; ++side)
        if (const std::size_t w = Step::weld_at(s, side); w < welds.size())
          for (std::size_t i = 0; i < freedoms; ++i) flow[w][i] += share * form[side][i];
    }
  }
  for (std::size_t s = 0; s < sheets_.size(); ++s) state[s].work += step.more[s];
}

}  // namespace nugget::kernel
