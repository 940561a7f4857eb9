// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/weld_joint.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace nugget::kernel {
namespace {

/// A relation that was measured: dimensionless load over dimensionless plastic motion, and its power beyond the last.
struct MeasuredFlow {
  Curve load;
  double power;  ///< of the load over the motion
};
/// Slip of one end over d: in-plane force over d t yield stress; docs/theory/ties.md#joint.
const MeasuredFlow& measured_slip() {
  static const MeasuredFlow flow{
      {.x = {0.0, 0.0006, 0.004, 0.0142, 0.031, 0.0672}, .y = {2.105, 2.368, 2.7, 3.105, 3.474, 3.947}}, 1.0 / 6.5};
  return flow;
}
/// The same of an end that two welds pull the same way from both faces, so that it does not bend: a rigid disc in a
/// plate that does not harden.
const MeasuredFlow& measured_unbent_slip() {
  static const MeasuredFlow flow{
      {.x = {0.0, 0.0003, 0.0013, 0.0033, 0.0066, 0.017, 0.03}, .y = {2.41, 2.87, 3.2, 3.33, 3.38, 3.41, 3.42}}, 0.0};
  return flow;
}
/// Angle of both ends: moment over t^2 d yield stress.
const MeasuredFlow& measured_turn() {
  static const MeasuredFlow flow{{.x = {0.0, 0.01, 0.03, 0.06, 0.12, 0.5}, .y = {0.92, 1.3, 1.7, 1.98, 2.25, 3.2}},
                                 0.4};
  return flow;
}
/// The sheets of the measured coupons hardened by about this many yield stresses a unit of plastic strain.
constexpr double measured_hardening = 4.0;
/// A mesh whose forces reach less far than this many radii shows all that there is.
constexpr double resolved_plastic = 1.1, resolved_elastic = 1.4;

double load_of(const MeasuredFlow& flow, double motion) {
  const double last = flow.load.x.back();
  return motion <= last ? flow.load.clamped(motion) : flow.load.y.back() * std::pow(motion / last, flow.power);
}

double inverse(const Curve& curve, double y) {
  if (y <= curve.y.front()) return 0.0;
  const auto above = std::upper_bound(curve.y.begin(), curve.y.end(), y);
  const auto i = static_cast<std::size_t>(std::min(above, curve.y.end() - 1) - curve.y.begin());
  return curve.x[i - 1] + (y - curve.y[i - 1]) * (curve.x[i] - curve.x[i - 1]) / (curve.y[i] - curve.y[i - 1]);
}

/// Yield stress of a sheet around a nugget that slips or turns, over the first one: that of its curve at the strain of
/// the ring, `strain` times the dimensionless motion, less the hardening of the measured sheets.
struct GrownAtRing {
  const Curve& yield;
  double strain;
  double operator()(double motion) const {
    return yield.extrapolated(strain * motion) / (yield.y.front() * (1.0 + measured_hardening * strain * motion));
  }
};
/// The same around a rigid disc in a plate: the more a sheet hardens, the wider the strain spreads; so the power.
/// Measured on plates of 1 to 10 yield stresses a unit of strain, within 4 %.
struct GrownAroundDisc {
  const Curve& yield;
  double operator()(double motion) const { return std::pow(yield.extrapolated(7.5 * motion) / yield.y.front(), 0.43); }
};

/// Load over plastic motion of one end on a mesh that shows everything: the measured one with the sheet's own yield
/// stress, grown. `unit`: the load over the dimensionless one, at first yield.
template <class Grown>
Curve whole_flow(const MeasuredFlow& flow, double unit, const Grown& grown) {
  Curve whole;
  constexpr int points = 120;
  constexpr double first = 1e-5, ratio = 1.1;
  double motion = 0.0, most = 0.0;
  for (int i = 0; i < points; ++i, motion = motion == 0.0 ? first : ratio * motion) {
    // A sheet that hardens less than the ring spreads, or softens: the load never falls.
    most = std::max(unit * load_of(flow, motion) * grown(motion), most * (1.0 + 1e-6));
    whole.x.push_back(motion);
    whole.y.push_back(most);
  }
  return whole;
}

/// Plastic motion of an end that its mesh lacks under a load: the whole one less what a nugget as large as the mesh
/// makes it would have, under the same load.
double lacking(const Curve& whole, double load, double reach) {
  return inverse(whole, load) - reach * inverse(whole, load / reach);
}

/// A pure load over the plastic work that it does on the ends, each with its own flow and reach. `scale`: the motion
/// over the dimensionless one, by end.
struct Flowing {
  Curve whole;
  double reach, scale;
};
Curve load_over_work(const std::vector<Flowing>& ends) {
  double first = 0.0;
  for (const Flowing& end : ends)
    if (end.reach > 1.0) first = first == 0.0 ? end.whole.y.front() : std::min(first, end.whole.y.front());
  if (first == 0.0) return {.x = {0.0}, .y = {WeldJoint::never}};
  Curve curve{.x = {0.0}, .y = {first}};
  const auto motion = [&](double load) {
    double sum = 0.0;
    for (const Flowing& end : ends)
      if (end.reach > 1.0) sum += end.scale * lacking(end.whole, load, end.reach);
    return sum;
  };
  constexpr double ratio = 1.01, most = 8.0;
  double last = 0.0;
  for (double load = ratio * first; load < most * first; load *= ratio) {
    const double now = motion(load);
    if (!(now > last)) continue;
    curve.x.push_back(curve.x.back() + 0.5 * (load + curve.y.back()) * (now - last));
    curve.y.push_back(load);
    last = now;
  }
  return curve;
}

double plastic_reach(const JointEnd& end) {
  return std::max(1.0, end.reach / resolved_plastic);
}

/// d t times the first yield stress.
double shear_unit(const JointEnd& end) {
  return end.diameter * end.thickness * end.yield.y.front();
}

Curve shear_over_work(std::span<const JointEnd> ends) {
  std::vector<Flowing> flowing;
  for (const JointEnd& end : ends)
    if (!end.yield.empty())
      flowing.push_back({whole_flow(measured_slip(), shear_unit(end), GrownAtRing{end.yield, 1.0}), plastic_reach(end),
                         end.diameter});
  return load_over_work(flowing);
}

}  // namespace

Curve unbent_shear_over_work(const JointEnd& end) {
  if (end.yield.empty()) return load_over_work({});
  return load_over_work({{whole_flow(measured_unbent_slip(), shear_unit(end), GrownAroundDisc{end.yield}),
                          plastic_reach(end), end.diameter}});
}

double work_of_strain(const JointEnd& end) {
  return 2.0 * end.diameter * measured_slip().load.y.front() * end.diameter * end.thickness * end.yield.y.front();
}

namespace {

Curve moment_over_work(std::span<const JointEnd> ends) {
  std::vector<Flowing> flowing;
  for (const JointEnd& end : ends)
    if (!end.yield.empty())
      flowing.push_back({whole_flow(measured_turn(), end.thickness * shear_unit(end),
                                    GrownAtRing{end.yield, end.thickness / end.diameter}),
                         plastic_reach(end), 0.5});
  return load_over_work(flowing);
}

/// Normal force at which the sheet shears through around the nugget: pi d t times the yield stress in shear.
double normal_limit(const JointEnd& end, double strain) {
  return std::numbers::pi / std::sqrt(3.0) * end.diameter * end.thickness * end.yield.extrapolated(strain);
}
/// Null where no end is plastic.
const JointEnd* weaker_end(std::span<const JointEnd> ends) {
  const JointEnd* weaker = nullptr;
  for (const JointEnd& end : ends)
    if (!end.yield.empty() && (weaker == nullptr || normal_limit(end, 0.0) < normal_limit(*weaker, 0.0))) weaker = &end;
  return weaker;
}
/// That of the weaker end over the work of a shear strain through the thickness.
Curve normal_over_work(std::span<const JointEnd> ends) {
  const JointEnd* weaker = weaker_end(ends);
  if (weaker == nullptr) return {.x = {0.0}, .y = {WeldJoint::never}};
  Curve curve{.x = {0.0}, .y = {normal_limit(*weaker, 0.0)}};
  constexpr double step = 0.005, last = 1.0;
  for (double strain = step; strain <= last; strain += step) {
    const double now = normal_limit(*weaker, strain);
    // The shear strain is sqrt(3) times the effective one.
    curve.x.push_back(curve.x.back() + 0.5 * (now + curve.y.back()) * std::sqrt(3.0) * step * weaker->thickness);
    curve.y.push_back(now);
  }
  return curve;
}

double in_plane_flexibility(const JointEnd& e) {
  return (3.0 - e.nu) * (1.0 + e.nu) / (4.0 * std::numbers::pi * e.E * e.thickness) *
         std::max(0.0, std::log(e.reach / resolved_elastic));
}
double bending_flexibility(const JointEnd& e) {
  const double plate = e.E * e.thickness * e.thickness * e.thickness / (12.0 * (1.0 - e.nu * e.nu));
  return std::max(0.0, std::log(e.reach / resolved_elastic)) / (4.0 * std::numbers::pi * plate);
}

}  // namespace

WeldJoint::WeldJoint(std::span<const JointEnd> ends)
    : flows_(std::any_of(ends.begin(), ends.end(), [](const JointEnd& e) { return !e.yield.empty(); })),
      normal_(normal_over_work(ends)),
      shear_(shear_over_work(ends)),
      moment_(moment_over_work(ends)) {
  for (const JointEnd& end : ends) {
    flexibility_[1] += in_plane_flexibility(end);
    flexibility_[3] += bending_flexibility(end);
  }
  const JointEnd* weaker = weaker_end(ends);
  if (weaker != nullptr) {
    work_of_strain_ = work_of_strain(*weaker);
    rate_factor_ = weaker->rate_factor;
  }
  flexibility_[2] = flexibility_[1];
  flexibility_[4] = flexibility_[3];
}

WeldJoint::PureLoads WeldJoint::pure_loads(std::span<const JointEnd> ends) {
  return {normal_over_work(ends), shear_over_work(ends), moment_over_work(ends)};
}

std::array<double, 3> WeldJoint::limits(double work) const {
  return {normal_(work), shear_(work), moment_(work)};
}

namespace {
/// Which limit a freedom of a joint has.
constexpr std::array<std::size_t, WeldJoint::size> limit_of{0, 1, 1, 2, 2};

/// What is left of a force of the trial after plastic work `more`; compression does not flow.
double relaxed(std::size_t i, double trial, double stiffness, double limit, double more) {
  if (i == 0 && trial <= 0.0) return trial;
  return trial / (1.0 + more * stiffness / (limit * limit));
}
}  // namespace

double WeldJoint::used(const Trial& trial, double work, double more) const {
  const std::array<double, 3> limit = limits(work + more);
  double sum = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    if (i == 0 && trial.force[i] <= 0.0) continue;
    const double share = relaxed(i, trial.force[i], trial.stiffness[i], limit[limit_of[i]], more) / limit[limit_of[i]];
    sum += share * share;
  }
  return std::sqrt(sum);
}

/// The surface is homogeneous of first degree, so its multiplier is the plastic work itself.
double WeldJoint::plastic_work(const Trial& trial, double work) const {
  const double at_start = used(trial, work, 0.0) - 1.0;
  if (!(at_start > 0.0)) return 0.0;
  const std::array<double, 3> limit = limits(work);
  double high = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    const double y = limit[limit_of[i]];
    if (trial.stiffness[i] > 0.0) high = std::max(high, y * std::abs(trial.force[i]) / trial.stiffness[i]);
  }
  if (!(high > 0.0)) return 0.0;
  double low = 0.0, below = at_start, above = used(trial, work, high) - 1.0;
  for (int i = 0; i < 200 && above > 0.0; ++i) {
    low = high, below = above;
    high *= 2.0;
    above = used(trial, work, high) - 1.0;
  }
  // False position with halved ends (Illinois).
  constexpr double round_off = 1e-13;
  int side = 0;
  for (int i = 0; i < 200; ++i) {
    const double more = high - above * (high - low) / (above - below), value = used(trial, work, more) - 1.0;
    if (std::abs(value) <= round_off) return more;
    if (value > 0.0) {
      low = more, below = value;
      if (side == 1) above *= 0.5;
      side = 1;
    } else {
      high = more, above = value;
      if (side == -1) below *= 0.5;
      side = -1;
    }
    if (high - low <= round_off * high) return high;
  }
  return high;
}

WeldJoint::Trial WeldJoint::trial(const State& state, const Freedoms& moved, const Freedoms& stiffness,
                                  const Freedoms& force) const {
  Trial trial;
  for (std::size_t i = 0; i < size; ++i) {
    const double c = flexibility_[i], k = stiffness[i];
    trial.stiffness[i] = k / (1.0 + c * k);
    trial.force[i] = force[i] + trial.stiffness[i] * (moved[i] + state.elastic[i] - c * force[i]);
  }
  return trial;
}

WeldJoint::Freedoms WeldJoint::advance(State& state, const Freedoms& moved, const Freedoms& stiffness,
                                       const Freedoms& force, double dt) const {
  const Trial trial = this->trial(state, moved, stiffness, force);
  if (from_outside_) {
    Freedoms beam = moved;
    for (std::size_t i = 0; i < size; ++i) {
      if (!(stiffness[i] > 0.0)) continue;
      beam[i] = (trial.force[i] - trial.stiffness[i] * state.flow[i] - force[i]) / stiffness[i];
      state.elastic[i] += moved[i] - beam[i] - state.flow[i];
    }
    state.flow = {};
    return beam;
  }
  const double factor = rate_factor_.empty() ? 1.0 : rate_factor_.clamped(state.rate);
  // A factor on the limits is its inverse on forces and stiffness, the work taken at rest.
  Trial at_rest = trial;
  for (std::size_t i = 0; i < size; ++i) {
    at_rest.force[i] /= factor;
    at_rest.stiffness[i] /= factor;
  }
  const double more = flows_ ? plastic_work(at_rest, state.work) : 0.0;
  const std::array<double, 3> limit = limits(state.work + more);
  Freedoms beam = moved;
  for (std::size_t i = 0; i < size; ++i) {
    const double k = stiffness[i], y = limit[limit_of[i]];
    if (!(k > 0.0)) continue;
    const double now = relaxed(i, trial.force[i], at_rest.stiffness[i], y, more);
    const double flow = now == trial.force[i] ? 0.0 : more * now / (factor * y * y);
    beam[i] = (now - force[i]) / k;
    state.elastic[i] += moved[i] - beam[i] - flow;
  }
  state.work += more;
  constexpr double smoothing = 0.05;  // flow comes and goes from cycle to cycle
  if (work_of_strain_ > 0.0) state.rate += smoothing * (more / (work_of_strain_ * dt) - state.rate);
  return beam;
}

}  // namespace nugget::kernel
