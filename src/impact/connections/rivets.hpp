// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// The rivets (*CONSTRAINED_RIVET) while the model moves: rigid massless trusses that keep the distance of two nodes
/// and leave all else free. The force along a truss is that with which the step about to be taken ends at the distance
/// of time 0,
///     |x2 + dt (v2 + k (f2 - F n)/m2) - x1 - dt (v1 + k (f1 + F n)/m1)| = L,
/// k the time by which velocities are advanced, n the direction now (the SHAKE algorithm: J.-P. Ryckaert, G. Ciccotti,
/// H. J. C. Berendsen, J. Comput. Phys. 23 (1977) 327). Rivets that share nodes are iterated until all have their
/// length. They have no mass and limit no time step.
class Rivets {
 public:
  /// The system must outlive it. A node that a rivet cannot pull, as it is tied, driven or of a rigid body, is an
  /// error.
  Rivets(const system::System& system, Findings& findings);

  /// Adds the rivets' forces to state.f, when all loads are collected and the next step is chosen. `velocity_interval`:
  /// k above.
  void apply(system::State& state, double velocity_interval, std::span<const double> inverse_mass);

  std::size_t size() const { return rivets_.size(); }
  const model::RigidWeld& rivet(std::size_t i) const { return *rivets_[i].source; }
  double axial(std::size_t i) const { return rivets_[i].force; }  ///< tension positive [force]
  double peak(std::size_t i) const { return rivets_[i].peak; }    ///< largest |axial| so far [force]
  double length(std::size_t i, const system::State& state) const;
  /// Of the rivet with this number, first come first; size() where there is none.
  std::size_t find(int id) const;
  bool failed(std::size_t i) const { return rivets_[i].failed; }
  double failure_time(std::size_t i) const { return rivets_[i].failure_time; }
  int failed() const { return failed_; }
  const std::vector<std::string>& events() const { return events_; }  ///< failures, a line each, for run.log

  void archive(Archive& a);

 private:
  struct Rivet {
    const model::RigidWeld* source;
    std::array<std::size_t, 2> node;               ///< system nodes
    std::array<std::array<Vec3d, 3>, 2> mobility;  ///< of each node: rows of the matrix that leaves out held directions
    double length;                                 ///< at time 0 [length]
    double force = 0.0, peak = 0.0;
    bool failed = false;
    double failure_time = 0.0;
    void archive(Archive& a);
  };
  void find_constrained_directions(Findings& findings);
  void end(Rivet& rivet, const system::State& state);
  double length_error(const Rivet& rivet, const system::State& state, double velocity_interval,
                      std::span<const double> inverse_mass) const;
  void pull(Rivet& rivet, system::State& state, double velocity_interval, std::span<const double> inverse_mass);

  const system::System& system_;
  std::vector<Rivet> rivets_;
  int failed_ = 0;
  std::vector<std::string> events_;
};

}  // namespace nugget::impact
