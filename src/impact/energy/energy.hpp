// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "impact/energy/part_nodes.hpp"
#include "system/sums_by_rank.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Energies and momentum of one part. Kinetic energy contains that of spins. `kinetic` is of nodes that have an active
/// element, or never had one of their own; `eroded_kinetic` of those that have lost all of theirs.
struct PartEnergy {
  double internal = 0.0, kinetic = 0.0, hourglass = 0.0, eroded = 0.0, eroded_kinetic = 0.0, mass = 0.0;
  double bulk_viscosity = 0.0;  ///< the part of `internal`, and of `eroded`, that went against bulk viscosity
  Vec3d momentum;

  PartEnergy& operator+=(const PartEnergy& other);
};

/// The energy balance at one time. The total changes only by external work; `ratio` is total over (initial + external
/// work).
struct Energy {
  double kinetic = 0.0, internal = 0.0, hourglass = 0.0;
  double contact = 0.0;  ///< stored in and dissipated by penalty contact and springs of ties (LS-DYNA: sliding
                         ///< interface energy)
  double wall = 0.0;     ///< taken out by rigid walls (stonewall energy)
  double damping = 0.0;
  double bulk_viscosity = 0.0;  ///< work done against it; a part of `internal` and `eroded`
  double eroded = 0.0;          ///< internal and hourglass energy of deleted elements
  double eroded_kinetic = 0.0;  ///< of nodes that have lost all their elements; not in `kinetic`
  double external = 0.0;        ///< work of loads and supports
  double initial = 0.0;         ///< total at time 0
  /// What the kinetic energy lost because the time step changed (docs/decisions/0021); no work, and 0 at a constant
  /// step.
  double step_change = 0.0;
  PartEnergy lumped;  ///< mass, momentum and share of `kinetic` that belong to no part

  double total() const {
    return kinetic + internal + hourglass + contact + wall + damping + eroded + eroded_kinetic + step_change;
  }
  double ratio() const { return over_input(total()); }
  /// The same without the correction for a changing step: what ENDENG is compared with, since an unstable step shows in
  /// it.
  double ratio_without_step_change() const { return over_input(total() - step_change); }
  /// What is there beyond what was there at the start and put in: the time integration has made it. Next to nothing in
  /// a stable run, and grows without bound in an unstable one, while `step_change` takes it out of `total`.
  double created() const { return total() - step_change - initial - external; }
  /// Sum of the sizes of all that is stored or spent.
  double size() const {
    return std::abs(kinetic) + std::abs(internal) + std::abs(hourglass) + std::abs(contact) + std::abs(wall) +
           std::abs(damping) + std::abs(eroded) + std::abs(eroded_kinetic);
  }

 private:
  double over_input(double energy) const {
    const double input = initial + external;
    return input != 0.0 ? energy / input : 1.0;
  }
};

/// Share of the time from t(n-1/2) to t(n+1/2) that lies before t(n): 1/2 at a constant step, 0 at the start.
double share_before_now(const system::State& state);

/// What the energy of a node goes by, where its velocities are on another rank.
struct NodalMotion {
  double linear = 0.0, angular = 0.0;  ///< v(n-1/2) . v and w(n-1/2) . w, the second as the energy at t(n) wants it
  Vec3d velocity;                      ///< at t(n)
};
/// What a rank of several has summed up, or, on the first one, what all others have: by rows of elements, those of all
/// groups behind each other, by pieces of parts, and by rows of nodes (system::SumsByRank). Empty: nobody has.
struct SumsOfRanks {
  std::vector<system::ElementGroup::Energies> elements;
  std::vector<PartEnergy> pieces;
  std::vector<double> kinetic, step_change;
  /// Calls `visit` with each sum that `rank` makes.
  template <class Visit>
  void each_of(const system::System& system, const PartNodes& nodes, int rank, const Visit& visit) {
    const system::SumsByRank& by_rank = *system.sums_by_rank();
    std::size_t row = 0;
    for (std::size_t g = 0; g < system.groups.size(); ++g)
      for (std::size_t i = 0; i < by_rank.rows_of_elements(g); ++i, ++row)
        if (by_rank.of_elements(g, i) == rank) visit(elements[row]);
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (by_rank.of_nodes(nodes.pieces()[i].row) == rank) visit(pieces[i]);
    for (std::size_t i = 0; i < by_rank.rows_of_nodes(); ++i)
      if (by_rank.of_nodes(i) == rank) {
        visit(kinetic[i]);
        visit(step_change[i]);
      }
  }
};

/// Of node k; `share`: share_of_interval, all else as of kinetic_energy.
inline NodalMotion nodal_motion(const system::State& state, std::span<const Row> v_before,
                                std::span<const Row> w_before, std::size_t k, double share) {
  const auto between = [](FourReals before, FourReals after, double part) { return before + part * (after - before); };
  const FourReals v = four(v_before[k]), v_after = four(state.v[k]), w = four(w_before[k]), w_after = four(state.w[k]);
  const FourReals linear = v * between(v, v_after, share), angular = w * between(w, w_after, share),
                  velocity = between(v, v_after, 0.5 * share);
  return {
      linear[0] + linear[1] + linear[2], angular[0] + angular[1] + angular[2], {velocity[0], velocity[1], velocity[2]}};
}
/// Share of the way from t(n-1/2) to t(n+1/2) at which the second velocity of the product v(n-1/2) . v stands, so that
/// the energy fits the work booked until t(n), 1/2 F . v(n-1/2) dt(n-1): 1 at a constant step, 0 at the start.
double share_of_interval(const system::State& state);

/// Kinetic energy of all nodes at t(n) as the discrete balance wants it, 1/2 m v(n-1/2) . v(n+1/2)
/// (docs/decisions/0002): `before` are the velocities and spins at t(n-1/2), those in `state` stand at t(n+1/2).
/// `of_others`: by node, the motion of those that this rank does not follow, as far as sums of others, `sums`, leave it
/// open; empty: all velocities are here.
double kinetic_energy(const system::System& system, const system::State& state, std::span<const Row> v_before,
                      std::span<const Row> w_before, std::span<const Vec3d> momentum_before,
                      std::span<const NodalMotion> of_others = {}, const SumsOfRanks& sums = {});

/// Sum over all nodes, made of `row(begin, end)` over SumsByRank::in_a_row of them each; `of_others`: by rows, the sums
/// that other ranks have made; empty: none.
double sum_over_nodes(const system::System& system, std::span<const double> of_others,
                      const std::function<double(std::size_t begin, std::size_t end)>& row);

/// Sum of `term(k)` over [begin, end), one after the other.
template <class Term>
double sum_of_row(std::size_t begin, std::size_t end, const Term& term) {
  double sum = 0.0;
  for (std::size_t k = begin; k < end; ++k) sum += term(k);
  return sum;
}

/// The sums that this rank makes for the first one; on that one, room for those of the others. `step_change`: over a
/// row of nodes that it follows.
SumsOfRanks sums_for_first(const system::System& system, const system::State& state, std::span<const Row> v_before,
                           std::span<const Row> w_before, const PartNodes& nodes,
                           const std::function<double(std::size_t begin, std::size_t end)>& step_change);

/// Adds up the elements' energies: internal, hourglass, bulk viscosity, eroded and eroded kinetic of `energy`, and all
/// of `parts` (size: number of parts). A part whose body's mass is given (*PART_INERTIA) has the kinetic energy and the
/// momentum of the body. Point masses and nodal rigid bodies with masses of their own belong to no part: they are
/// `lumped`, so that the parts' kinetic energies, eroded ones too, and theirs are `kinetic_energy`.
void element_energies(const system::System& system, const system::State& state, std::span<const Row> v_before,
                      std::span<const Row> w_before, std::span<const Vec3d> momentum_before, const PartNodes& nodes,
                      Energy& energy, std::vector<PartEnergy>& parts, std::span<const NodalMotion> of_others = {},
                      const SumsOfRanks& sums = {});

/// Momentum over mass of all `parts` and of what belongs to none [velocity]; 0 where there is no mass.
Vec3d mean_velocity(const Energy& energy, const std::vector<PartEnergy>& parts);

}  // namespace nugget::impact
