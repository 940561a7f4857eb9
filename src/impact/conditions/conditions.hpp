// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/archive.hpp"
#include "impact/conditions/bag.hpp"
#include "system/system.hpp"

// What the deck imposes on nodes: held and driven degrees of freedom, and loads. The work of each is booked so that it
// fits the discrete energy balance of the central-difference scheme (docs/decisions/0002): a force F at t(n) does 1/2 F
// . (v(n-1/2) dt(n-1) + v(n+1/2) dt(n)).
namespace nugget::impact {

/// Whether loads and motions follow this curve in the phase of the moment (SIDR).
inline bool in_force(const Curve& curve, const system::State& state) {
  return state.relaxing ? curve.in_relaxation : curve.in_run;
}

/// Nodes and bodies whose motion is prescribed, by *BOUNDARY_SPC (to zero) and *BOUNDARY_PRESCRIBED_MOTION.
class Supports {
 public:
  Supports(const system::System& system, Findings& findings);

  /// Components of v and w that the supports hold at time 0 are set to zero (fixed ones only).
  void constrain_at_start(system::State& state);
  /// After `accelerate`: replaces prescribed components, keeps the reactions, books the closing half of their work.
  /// `velocity_interval` is the time by which the velocities were advanced.
  void prescribe(system::State& state, double velocity_interval, std::span<system::RigidBody> bodies);
  /// Books the opening half, with the velocities that `prescribe` left.
  void book_opening_work(double dt);
  double work() const { return work_; }
  /// Sets the work done so far to zero: the run begins after a relaxation.
  void reset_work() {
    work_ = 0.0;
    for (std::vector<Reaction>* reactions : {&spc_, &motion_})
      for (Reaction& r : *reactions) r.energy = 0.0;
  }
  /// Sum over what is held of the other forces times what the last `prescribe` changed in the velocities [power].
  double power_on_change() const { return power_on_change_; }

  /// Reaction on one node (or body) at t(n).
  struct Reaction {
    int node = 0;                       ///< system node
    model::Index source = model::none;  ///< SPC or motion in the model
    int set_id = 0;
    Vec3d force, moment;  ///< on the structure
    double energy = 0.0;  ///< work done so far
  };
  const std::vector<Reaction>& spc_reactions() const { return spc_; }
  const std::vector<Reaction>& motion_reactions() const { return motion_; }

  void archive(Archive& a);

 private:
  struct ConstrainedDof {
    std::size_t reaction;
    int node;
    Vec3d axis;
    bool rotation;
    double birth, death;
    double force = 0.0, before = 0.0, velocity = 0.0;  // of the last prescribe: velocities before and after it
    bool active = false;
    void archive(Archive& a);
  };
  struct PrescribedDof : ConstrainedDof {
    const model::PrescribedMotion* motion = nullptr;
    int body = -1;
    bool constrain_others = false;  ///< across the direction that is driven; of a circle: the radius
    Vec3d at_start;                 ///< the axis at time 0: a body's own axes turn with it
    std::vector<std::size_t>
        oblique_to;  ///< places in constrained_dofs_: supports of its node neither along nor across it
    // Of a circle, whose directions turn:
    Vec3d left;         ///< velocity of the node after the last prescribe
    double rate = 0.0;  ///< angular velocity, where the curve is its rate [1/time]
    void archive(Archive& a);
  };
  double target(PrescribedDof& prescribed, const system::State& state, double old_velocity,
                double velocity_interval) const;
  double circular_target(PrescribedDof& prescribed, const system::State& state, double old_velocity,
                         double velocity_interval) const;
  void set_component(ConstrainedDof& dof, double target, int body, system::State& state, double velocity_interval,
                     std::span<system::RigidBody> bodies, std::vector<Reaction>& reactions);
  /// Drives a node that supports hold in oblique directions: both are met, and both have their reactions.
  void prescribe_beside_supports(PrescribedDof& prescribed, double target, system::State& state,
                                 double velocity_interval);

  const system::System& system_;
  std::vector<ConstrainedDof> constrained_dofs_;
  std::vector<PrescribedDof> prescribed_dofs_;
  std::vector<Reaction> spc_, motion_;
  double work_ = 0.0;
  double dt_previous_ = 0.0;  ///< of the last prescribe
  double power_on_change_ = 0.0;
};

/// Forces, moments, pressures, body loads and the gas in control volumes.
class Loads {
 public:
  explicit Loads(const system::System& system);

  /// Adds the loads at state.time to state.f and state.m, and books their work over the step that ends there
  /// (velocities of that step in `state`, length `dt`; 0 at the start).
  void apply(system::State& state, double dt);
  double work() const { return work_; }
  /// As that of the supports; the gas in volumes keeps what it has given.
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
