// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <variant>

#include "kernel/law/cable.hpp"
#include "kernel/law/discrete_spring.hpp"
#include "kernel/law/spr2.hpp"
#include "kernel/law/spr3.hpp"

namespace nugget::kernel {

/// Law of a discrete beam (ELFORM 6): six uncoupled degrees of freedom, displacements along r, s,
/// t, then rotations about them; and when the beam fails. Source: LS-DYNA Keyword Manual. With `joint` the six flow and
/// fail together; `dof` then holds the stiffnesses alone.
struct DiscreteBeam {
  DiscreteBeam();
  DiscreteBeam(const DiscreteBeam&);
  DiscreteBeam(DiscreteBeam&&) noexcept;
  DiscreteBeam& operator=(const DiscreteBeam&);
  DiscreteBeam& operator=(DiscreteBeam&&) noexcept;
  ~DiscreteBeam();

  static constexpr double E = 0.0, nu = 0.0;  ///< it has none; asked of every law
  std::array<DiscreteSpring, 6> dof;
  /// A spring between two points (MAT_074, 121), whose displacement is the change of their distance. Where they are at
  /// one place it acts along the r axis.
  bool between_points = false;
  /// A cable between two points; `dof` is empty then.
  std::optional<Cable> cable;
  /// Of *CONSTRAINED_INTERPOLATION_SPOTWELD, of *CONSTRAINED_SPR2.
  std::optional<std::variant<Spr3, Spr2>> joint;

  /// How the limits of displacement act together. A limit of 0 is none.
  enum class Rule {
    any,       ///< one displacement beyond its limit is enough (MAT_074, 121, 196)
    sides,     ///< sum of squares, the positive and the negative displacements apart (MAT_119, FCRIT 0)
    together,  ///< sum of squares of all (MAT_067, 068; MAT_119, FCRIT 1)
  };
  Rule rule = Rule::any;
  std::array<double, 6> force_limit{};                         ///< sum of squares of force/limit reaches 1
  std::array<double, 6> tension_limit{}, compression_limit{};  ///< both positive

  /// Whether forces and displacements are beyond the limits.
  bool fails(const std::array<double, 6>& force, const std::array<double, 6>& displacement) const;
  /// The value that reaches 1 at failure.
  double failure_value(const std::array<double, 6>& force, const std::array<double, 6>& displacement) const;
};

}  // namespace nugget::kernel
