// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/loads.hpp"

#include "impact/conditions/in_force.hpp"

namespace nugget::impact {

double load_value(const Curve& curve, double time, const system::State& state) {
  if (!in_force(curve, state)) return 0.0;
  const double end = curve.x.back();
  return curve.zero_outside(time > end && time - end <= 1e-9 * time ? end : time);
}

Loads::Loads(const system::System& system) : loads_(acting(system.model.kinds(), system)) {}

void Loads::apply(system::State& state, double dt) {
  for_each(*this, [&](auto& load) { load.apply(state, dt, work_); });
}

double Loads::work() const {
  double work = work_;
  for_each(*this, [&work](const auto& load) {
    if constexpr (requires { load.work(); }) work += load.work();
  });
  return work;
}

void Loads::reset_work() {
  work_ = 0.0;
  for_each(*this, [](auto& load) {
    if constexpr (requires { load.reset_work(); }) load.reset_work();
  });
}

void Loads::carry(system::Carried what, const system::System::Computed& of, system::Parcel& parcel) {
  for_each(*this, [&](auto& load) {
    if constexpr (requires { load.carry(what, of, parcel); }) load.carry(what, of, parcel);
  });
}

void Loads::update_masses() {
  for_each(*this, [](auto& load) {
    if constexpr (requires { load.update_masses(); }) load.update_masses();
  });
}

void Loads::update_masses(std::span<const int> changed) {
  for_each(*this, [&](auto& load) {
    if constexpr (requires { load.update_masses(changed); }) load.update_masses(changed);
  });
}

void Loads::find_covered(const std::function<bool(int)>& presses) {
  for_each(*this, [&](auto& load) {
    if constexpr (requires { load.find_covered(presses); }) load.find_covered(presses);
  });
}

void Loads::archive(Archive& a) {
  std::apply([&](auto&... list) { a(list...); }, loads_);
  a(work_);
}

}  // namespace nugget::impact
