// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "impact/conditions/supports.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// The linear equations between displacements (*CONSTRAINED_LINEAR_GLOBAL, _LOCAL) while the model moves, C u = 0. The
/// forces C^t lambda on their nodes are those with which the velocities of the step about to be taken obey them,
///     C (v + k M^-1 (f + C^t lambda)) = 0,
/// k the time by which velocities are advanced, with what supports hold or drive in its place. They do no work, have no
/// mass and limit no time step: on the subspace that the equations leave no frequency is higher. Solved by conjugate
/// gradients, preconditioned by the diagonal, in the order of the deck: the same bits for any number of threads.
class LinearConstraints {
 public:
  /// The system must outlive it. A node without mass in a direction that nothing drives is an error.
  LinearConstraints(const system::System& system, const Supports& supports, Findings& findings);

  /// Initial velocities that the equations allow: the nearest ones by kinetic energy.
  void constrain_at_start(system::State& state, std::span<const double> inverse_mass,
                          std::span<const double> inverse_inertia);
  /// Adds the forces to state.f and state.m, when all loads are collected and the next step is chosen.
  void apply(system::State& state, double velocity_interval, std::span<const double> inverse_mass,
             std::span<const double> inverse_inertia, const Supports& supports);

  std::size_t size() const { return rows_.size(); }
  bool empty() const { return rows_.empty(); }
  void archive(Archive& a);

 private:
  /// Translations or rotations of a node.
  struct Site {
    std::size_t node = 0;
    bool rotation = false;
    std::vector<Vec3d> held;          ///< directions that supports hold, at right angles
    std::vector<std::size_t> driven;  ///< of Supports
    std::array<Vec3d, 3> mobility{};  ///< now, times the inverse mass
    Vec3d after, force;               ///< velocity without the equations; C^t lambda
  };
  struct Term {
    std::size_t site;
    Vec3d c;
  };
  struct Equation {
    std::size_t begin, end;
    double diagonal = 0.0;
  };
  void hold(Site& site, double inverse);
  /// lambda of C (after + k mobility C^t lambda) = 0, and the sites' forces.
  void solve(double velocity_interval);
  void spread(const std::vector<double>& x);
  double residual(std::size_t equation, double velocity_interval) const;

  const system::System& system_;
  std::vector<Site> sites_;
  std::vector<Term> terms_;
  std::vector<Equation> rows_;
  std::vector<double> lambda_, rest_, direction_, image_;  // of a solution, kept for their memory
};

}  // namespace nugget::impact
