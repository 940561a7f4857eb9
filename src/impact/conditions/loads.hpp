// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <tuple>
#include <vector>

#include "impact/conditions/blast_load.hpp"
#include "impact/conditions/body_load.hpp"
#include "impact/conditions/gas_volume.hpp"
#include "impact/conditions/nodal_load.hpp"
#include "impact/conditions/pressure_load.hpp"
#include "impact/conditions/traction_load.hpp"
#include "impact/energy/energy.hpp"

namespace nugget::impact {

/// All loads of the model (model::LoadLists::kinds); each kind has its file, which is included here.
/// The work is booked so that it fits the discrete energy balance of the central-difference scheme
/// (docs/decisions/0002): a force F at t(n) does 1/2 F . (v(n-1/2) dt(n-1) + v(n+1/2) dt(n)).
class Loads {
 public:
  explicit Loads(const system::System& system);

  /// Adds the loads at state.time to state.f and state.m, and books their work over the step that ends there
  /// (velocities of that step in `state`, length `dt`; 0 at the start).
  void apply(system::State& state, double dt);
  double work() const;
  /// As that of the supports; the gas in volumes keeps what it has given.
  void add_energy(Energy& energy) const { energy.external += work(); }
  void reset_work();
  /// Over several ranks: what loads keep by node, on its way to another one.
  void carry(system::Carried what, const system::System::Computed& of, system::Parcel& parcel);
  /// To be called when masses have changed.
  void update_masses();
  /// The same after mass scaling that changed the masses of these nodes.
  void update_masses(std::span<const int> changed);
  /// Before `apply`: what contact covers of the faces through which gas leaks, see ActingLoad<ControlVolume>.
  void find_covered(const std::function<bool(int)>& presses);

  /// Those of one kind, in the order of the model.
  template <class Load>
  const std::vector<ActingLoad<Load>>& of() const {
    return std::get<std::vector<ActingLoad<Load>>>(loads_);
  }

  void archive(Archive& a);

 private:
  template <class... Load>
  static std::tuple<std::vector<ActingLoad<Load>>...> acting(const std::tuple<const std::vector<Load>&...>& kinds,
                                                             const system::System& system) {
    const auto each = [&]<class One>(const std::vector<One>& loads) {
      std::vector<ActingLoad<One>> made;
      for (const One& load : loads) made.emplace_back(load, system);
      return made;
    };
    return {each(std::get<const std::vector<Load>&>(kinds))...};
  }
  template <class Self, class Visit>
  static void for_each(Self& self, Visit visit) {
    const auto each = [&](auto& list) {
      for (auto& load : list) visit(load);
    };
    std::apply([&](auto&... list) { (each(list), ...); }, self.loads_);
  }

  decltype(acting(model::LoadLists{}.kinds(), std::declval<const system::System&>())) loads_;
  double work_ = 0.0;  ///< of those that do not book theirs by node
};

}  // namespace nugget::impact
