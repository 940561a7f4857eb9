// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/belt_tension.hpp"

#include <algorithm>
#include <utility>

namespace nugget::kernel {
namespace {

/// Of the pieces that begin at `x` at the latest, and of the next one.
double steepest_up_to(const Curve& curve, double x) {
  double most = 0.0;
  for (std::size_t i = 0; i + 1 < curve.x.size() && (i == 0 || curve.x[i - 1] <= x); ++i)
    most = std::max(most, (curve.y[i + 1] - curve.y[i]) / (curve.x[i + 1] - curve.x[i]));
  return most;
}

/// The largest abscissa at which a curve that does not fall has the ordinate `y`.
double last_place_of(const Curve& curve, double y) {
  std::size_t i = curve.x.size() - 1;
  while (i > 0 && curve.y[i - 1] > y) --i;
  if (i == 0) return curve.x.front();
  // The piece that ends here holds y, or y lies beyond the end.
  const double slope = (curve.y[i] - curve.y[i - 1]) / (curve.x[i] - curve.x[i - 1]);
  return curve.x[i - 1] + (y - curve.y[i - 1]) / slope;
}

bool falls(const Curve& curve) {
  return !std::is_sorted(curve.y.begin(), curve.y.end());
}

}  // namespace

BeltTension::BeltTension(Curve loading, Curve unloading, double least)
    : loading_(std::move(loading)), unloading_(std::move(unloading)), least_(least) {
  const auto above = std::find_if(loading_.y.begin(), loading_.y.end(), [](double y) { return y > 0.0; });
  first_ = above == loading_.y.end() ? 0.0 : *above;
}

const char* BeltTension::fault_of_loading(const Curve& curve) {
  if (curve.x.size() < 2) return "expected two points at least";
  if (curve.y.front() < 0.0 || falls(curve)) return "expected tensions of 0 and more that do not fall";
  return curve.y.back() > 0.0 ? "" : "expected a tension above 0";
}

const char* BeltTension::fault_of_unloading(const Curve& curve) {
  if (curve.x.size() < 2) return "expected two points at least";
  if (curve.y.front() != 0.0) return "expected a first tension of 0";
  if (falls(curve)) return "expected tensions that do not fall";
  return curve.y.back() > curve.y[curve.y.size() - 2] ? "" : "expected tensions that rise at the end";
}

void BeltTension::meet(State& state) const {
  if (!unloading_.empty()) state.shift = state.most - last_place_of(unloading_, loading_.extrapolated(state.most));
}

BeltTension::State BeltTension::start() const {
  State state;
  state.most = std::max(0.0, loading_.x.front());
  meet(state);
  return state;
}

double BeltTension::operator()(double x, const State& state) const {
  const double up = loading_.extrapolated(x);
  if (x >= state.most || unloading_.empty() || loading_.extrapolated(state.most) <= first_) return std::max(up, least_);
  return std::max(std::min(up, unloading_.extrapolated(x - state.shift)), least_);
}

void BeltTension::advance(double x, State& state) const {
  if (!(x > state.most)) return;
  state.most = x;
  meet(state);
}

double BeltTension::steepest(const State& state) const {
  const double loading = steepest_up_to(loading_, state.most);
  return unloading_.empty() ? loading : std::max(loading, steepest_up_to(unloading_, state.most - state.shift));
}

}  // namespace nugget::kernel
