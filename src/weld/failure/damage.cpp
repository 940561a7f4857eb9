// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/damage.hpp"

#include <algorithm>
#include <cmath>

#include "weld/failure/connection.hpp"
#include "weld/failure/function.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {

using Growth = DamageLaw::Growth;

DamageLaw damage_law(const model::Model& model, const Weld& weld) {
  const model::WeldLaw& law = law_of(model, weld);
  if (!law.connection) return damage_law(law.damage);
  if (law.properties == model::none) return {};
  const model::ConnectionProperties& properties = model.connections[law.properties];
  return damage_law(properties, connection_record(model, properties, failure::geometry_of(model, weld)), law.damage);
}

DamageLaw damage_law(const model::WeldDamage& damage) {
  DamageLaw law;
  if (damage.option < 10 || damage.rupture <= 0.0) return law;
  law.growth = damage.option == 12 ? Growth::time : Growth::strain;
  law.rupture = damage.rupture;
  law.beta = damage.beta;
  law.onset_strain = damage.failure_strain;
  law.freezes_yield = damage.option > 10;
  law.mode = damage.mode;
  law.cap = damage.cap;
  return law;
}

DamageLaw damage_law(const model::ConnectionProperties& properties, const model::ConnectionProperties::Record& record,
                     const model::WeldDamage& damage) {
  constexpr Growth growth[6] = {Growth::immediate, Growth::strain, Growth::surface,
                                Growth::energy,    Growth::energy, Growth::energy};
  DamageLaw law;
  law.growth = growth[properties.damage_type];
  law.rupture = damage.rupture;
  law.onset_strain = damage.failure_strain;
  law.fading_energy = record.fading_energy;
  return law;
}

bool Damage::begins(const WeldState& now) const {
  return now.at_surface || (law_.onset_strain > 0.0 && now.plastic_strain > law_.onset_strain);
}

Damage::State Damage::update(const WeldState& now) {
  if (!begun_) {
    if (!begins(now)) return State::intact;
    const bool brittle = law_.mode > 0.0 && now.at_surface && std::sqrt(now.sliding) >= law_.mode;
    if (law_.growth == Growth::immediate || brittle) return State::failed;
    begun_ = true;
    onset_ = now;
  } else if (law_.cap > 0.0 && now.value >= law_.cap) {
    return State::failed;
  }
  damage_ = std::max(damage_, grown(now));
  return damage_ >= 1.0 ? State::failed : State::damaged;
}

/// The damage w that the state asks for; 1 and more: the weld has failed.
double Damage::grown(const WeldState& now) {
  switch (law_.growth) {
    case Growth::strain: {
      // RS below the strain at the onset is taken for the strain from there on.
      const double span = law_.rupture > onset_.plastic_strain ? law_.rupture - onset_.plastic_strain : law_.rupture;
      return (now.plastic_strain - onset_.plastic_strain) / span;
    }
    case Growth::time: return (now.time - onset_.time) / law_.rupture;
    case Growth::surface:
      if (law_.rupture > 0.0 && now.plastic_strain > law_.rupture) return 1.0;
      return now.load > 1.0 ? 1.0 - 1.0 / now.load : 0.0;
    case Growth::energy: {
      // F = F0 (1 - u / u_max) does the work W = GFAD (1 - (1 - u / u_max)^2) up to u, with GFAD = F0 u_max / 2. Solved
      // for the force it needs no displacement, and holds for moments and for mixed loads too.
      work_ = std::max(work_, now.energy - onset_.energy);
      if (work_ >= law_.fading_energy) return 1.0;
      const double faded = std::sqrt(1.0 - work_ / law_.fading_energy);
      return now.load > faded ? 1.0 - faded / now.load : 0.0;
    }
    case Growth::immediate: break;
  }
  return 1.0;
}

double Damage::integrity() const {
  return law_.beta > 0.0 ? std::exp(-law_.beta * damage_) : 1.0 - damage_;
}

void Damage::archive(Archive& a) {
  a(begun_, onset_, damage_, work_);
  a.built(law_);
}

}  // namespace nugget::weld
