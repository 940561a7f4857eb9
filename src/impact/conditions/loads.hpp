// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/archive.hpp"
#include "impact/conditions/bag.hpp"
#include "impact/energy/energy.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Forces, moments, pressures, body loads and the gas in control volumes.
/// The work is booked so that it fits the discrete energy balance of the central-difference scheme
/// (docs/decisions/0002): a force F at t(n) does 1/2 F . (v(n-1/2) dt(n-1) + v(n+1/2) dt(n)).
class Loads {
 public:
  explicit Loads(const system::System& system);

  /// Adds the loads at state.time to state.f and state.m, and books their work over the step that ends there
  /// (velocities of that step in `state`, length `dt`; 0 at the start).
  void apply(system::State& state, double dt);
  double work() const { return work_; }
  /// As that of the supports; the gas in volumes keeps what it has given.
  void add_energy(Energy& energy) const { energy.external += work_; }
  void reset_work() { work_ = 0.0; }
  /// Takes the masses that body loads act on from the system, of what mass scaling added the share EMSCL: to be called
  /// when they have changed.
  void update_load_masses();

  /// Gas at the moment of the last `apply`.
  struct Volume {
    const model::ControlVolume* source = nullptr;
    double at_start = 0.0, volume = 0.0;  ///< times VSCA
    double pressure = 0.0;                ///< on the faces
    double relative_pressure = 1.0;       ///< of an adiabatic gas: absolute pressure over that at the start
    double work = 0.0;                    ///< done on the faces so far
    bool preload_over = false;
    Bag bag;                  ///< of a gas that flows
    std::vector<Vec3d> last;  ///< as of a pressure
    void archive(Archive& a);
  };
  const std::vector<Volume>& volumes() const { return volumes_; }

  void archive(Archive& a);

 private:
  struct Nodal {
    const model::NodalLoad* load;
    std::vector<int> nodes;
    Vec3d last;
    void archive(Archive& a);
  };
  struct Pressure {
    const model::PressureLoad* load;
    std::vector<Vec3d> last;  // force on each node of each segment
    void archive(Archive& a);
  };
  struct Body {
    const model::BodyLoad* load;
    std::vector<int> nodes;
    std::vector<double> mass;
    double last = 0.0;
    std::vector<Vec3d> last_force;  ///< by node of the system, of a centrifugal load
    void archive(Archive& a);
  };
  void apply(Nodal& nodal, system::State& state, double dt);
  void apply(Pressure& pressure, system::State& state, double dt);
  void apply(Volume& volume, system::State& state, double dt);
  double pressure(Volume& volume, const system::State& state, double dt) const;
  /// `pressure` on faces; `last` holds the forces on their corners.
  void press(const std::vector<model::Segment>& segments, const std::vector<model::CornerShares>& share,
             double pressure, std::vector<Vec3d>& last, system::State& state, double dt);
  void apply(Body& body, system::State& state, double dt);
  double curve_value(const model::BodyLoad& load, const system::State& state) const;
  std::vector<double> nodes_without_weight() const;
  void load_nodes(Body& body) const;
  void load_everything(Body& body) const;
  void load_parts(Body& body) const;
  void apply_centrifugal(Body& body, system::State& state, double dt, double omega);

  const system::System& system_;
  std::vector<Nodal> nodal_;
  std::vector<Pressure> pressure_;
  std::vector<Volume> volumes_;
  std::vector<Body> body_;
  double work_ = 0.0;
};

}  // namespace nugget::impact
