// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "kernel/law/composed_law.hpp"
#include "kernel/law/equation_of_state.hpp"
#include "kernel/law/failure_rules.hpp"
#include "kernel/law/gissmo.hpp"
#include "kernel/law/laws.hpp"
#include "kernel/law/material_axes.hpp"
#include "kernel/law/point_damage.hpp"

namespace nugget::kernel {

struct CohesiveBond;  // law/cohesive_bond.hpp

/// What a compound law is made of: how a point flows, and when it and its element fail.
struct LawComponents {
  LawComponents(Flow of_points);
  LawComponents(const LawComponents&);
  LawComponents(LawComponents&&) noexcept;
  LawComponents& operator=(const LawComponents&);
  LawComponents& operator=(LawComponents&&) noexcept;
  ~LawComponents();

  Flow flow;                              ///< its own deletion step is not used
  double failure_strain = 0.0;            ///< effective plastic strain at which a point fails [1]; 0: none
  Curve failure_strain_over_rate{};       ///< the same over the total strain rate; empty: none
  std::optional<PlasticDamage> damage{};  ///< takes (1 - w) of all stresses, over the effective plastic strain
  std::optional<PlasticDamage> directional_damage{};  ///< of layers, see Cracks
  std::optional<EnergyDamage> energy_damage{};        ///< takes D of all stresses
  std::vector<FailureRule> rules{};                   ///< by any of which a point fails
  std::optional<Gissmo> gissmo{};
  StrainLimits limits{};
  std::optional<Erosion> erosion{};
  std::optional<EquationOfState> state{};  ///< of bricks: gives the mean stress instead of the flow's bulk modulus
  std::optional<Spall> spall{};            ///< with an equation of state
  double solid_shear = 0.0;                ///< G that goes with an equation of state [stress]; 0: of E and nu
  double points_to_delete = 0.0;  ///< failed points of an element that delete it; 0: all; below 0: percentage of a
                                  ///< shell's layers, of which one failed point makes a layer a failed one
  double deletion_step = 0.0;     ///< an element whose stable time step falls below is deleted [time]; 0: never
  bool for_layers_only = false;   ///< bricks may not have the law, though its flow could be theirs
  bool bulk_viscosity = true;     ///< whether bricks have it
  double contact_modulus = 0.0;   ///< KCON: for the stiffness of contacts in place of E [stress]; 0: E
  /// Of cohesive bricks, which have no strains and for which nothing else of this holds; null: of other elements.
  std::shared_ptr<const CohesiveBond> bond{};
};

inline ComposedLaw composed_law(LawComponents components) {
  const auto [E, nu] = std::visit([](const auto& flow) { return std::pair{flow.E, flow.nu}; }, components.flow);
  return {E, nu, std::make_shared<const LawComponents>(std::move(components))};
}

/// Whether shells, bricks, and beams may have the law.
bool for_shells(const LawComponents& law);
bool for_bricks(const LawComponents& law);
/// Whether beams of ELFORM 1 and 3 may have it: of what is added, a failure strain and erosion.
bool for_beams(const LawComponents& law);
bool has_plastic_strain(const Flow& flow);

/// A law of membranes only, which keep their thickness.
inline bool is_fabric(const Flow& flow) {
  return std::holds_alternative<Fabric>(flow) || std::holds_alternative<WovenFabric>(flow);
}

/// Material axes of a flow at the start; null: it has none.
inline MaterialAxes* axes_of(Flow& flow) {
  return std::visit(
      [](auto& law) -> MaterialAxes* {
        if constexpr (requires { law.axes; })
          return &law.axes;
        else if constexpr (requires { law.anisotropy->axes; })
          return law.anisotropy ? &law.anisotropy->axes : nullptr;
        else
          return nullptr;
      },
      flow);
}
inline const MaterialAxes* axes_of(const Flow& flow) {
  return axes_of(const_cast<Flow&>(flow));
}

template <class Law, class... Laws>
constexpr bool is_among(const std::variant<Laws...>*) {
  return (std::is_same_v<Law, Laws> || ...);
}

/// Laws that can be put together with others at run time.
template <class Law>
concept ComposableLaw = is_among<Law>(static_cast<const Flow*>(nullptr));

/// A flow as a law put together at run time. What it says of failure and deletion becomes that of the whole.
template <ComposableLaw Law>
LawComponents components_of(Law flow) {
  LawComponents law{Elastic{}};
  if constexpr (requires { flow.failure_strain; }) law.failure_strain = std::exchange(flow.failure_strain, 0.0);
  if constexpr (requires { flow.deletion_step; }) law.deletion_step = std::exchange(flow.deletion_step, 0.0);
  law.flow = std::move(flow);
  return law;
}

}  // namespace nugget::kernel
