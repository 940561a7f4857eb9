// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>
#include <variant>

#include "kernel/law/composed_law.hpp"
#include "kernel/law/elastic.hpp"
#include "kernel/law/equation_of_state.hpp"
#include "kernel/law/fluid.hpp"
#include "kernel/law/foam.hpp"
#include "kernel/law/gissmo.hpp"
#include "kernel/law/honeycomb.hpp"
#include "kernel/law/johnson_cook.hpp"
#include "kernel/law/orthotropic.hpp"
#include "kernel/law/piecewise_linear.hpp"
#include "kernel/law/plastic_kinematic.hpp"
#include "kernel/law/point_damage.hpp"
#include "kernel/law/power_law.hpp"
#include "kernel/law/rubber.hpp"
#include "kernel/law/viscoelastic.hpp"

namespace nugget::kernel {

struct CohesiveBond;  // law/cohesive_bond.hpp

/// How a point flows.
using Flow = std::variant<Elastic, PlasticKinematic, PiecewiseLinear, JohnsonCook, PowerLaw, BlatzKo, MooneyRivlin,
                          Ogden, PolynomialRubber, LowDensityFoam, CrushableFoam, RateFoam, Viscoelastic, Orthotropic,
                          Honeycomb, Fluid>;

/// What a compound law is made of: how a point flows, and when it and its element fail.
struct LawComponents {
  Flow flow;                              ///< its own failure strain and deletion step are not used
  double failure_strain = 0.0;            ///< effective plastic strain at which a point fails [1]; 0: none
  Curve failure_strain_over_rate{};       ///< the same over the total strain rate; empty: none
  std::optional<PlasticDamage> damage{};  ///< takes (1 - w) of all stresses, over the effective plastic strain
  std::optional<PlasticDamage> directional_damage{};  ///< of layers, see Cracks
  std::optional<JohnsonCookFracture> fracture{};
  std::optional<Gissmo> gissmo{};
  StrainLimits limits{};
  std::optional<Erosion> erosion{};
  std::optional<EquationOfState> state{};  ///< of bricks: gives the mean stress instead of the flow's bulk modulus
  std::optional<Spall> spall{};            ///< with an equation of state
  double solid_shear = 0.0;                ///< G that goes with an equation of state [stress]; 0: of E and nu
  double points_to_delete = 0.0;  ///< failed points of an element that delete it; 0: all; below 0: percentage of a
                                  ///< shell's layers, of which one failed point makes a layer a failed one
  double deletion_step = 0.0;     ///< an element whose stable time step falls below is deleted [time]; 0: never
  bool for_shells = true, for_bricks = true;  ///< elements that may have the law
  bool bulk_viscosity = true;                 ///< whether bricks have it
  /// Of cohesive bricks, which have no strains and for which nothing else of this holds; null: of other elements.
  std::shared_ptr<const CohesiveBond> bond{};
};

inline ComposedLaw composed_law(LawComponents components) {
  const auto [E, nu] = std::visit([](const auto& flow) { return std::pair{flow.E, flow.nu}; }, components.flow);
  return {E, nu, std::make_shared<const LawComponents>(std::move(components))};
}

}  // namespace nugget::kernel
