// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <optional>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "base/index.hpp"
#include "base/period_mean.hpp"
#include "contact/held_nodes.hpp"
#include "impact/energy/energy.hpp"
#include "system/parcel.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Nodes and bodies whose motion is prescribed, by *BOUNDARY_SPC (to zero) and *BOUNDARY_PRESCRIBED_MOTION.
/// The work is booked so that it fits the discrete energy balance of the central-difference scheme
/// (docs/decisions/0002): a force F at t(n) does 1/2 F . (v(n-1/2) dt(n-1) + v(n+1/2) dt(n)). It stands with each
/// reaction and is summed up when somebody asks, so that a rank of several meets the supports of the nodes that it
/// follows only (docs/decisions/0130).
class Supports : public contact::HeldNodes {
 public:
  Supports(const system::System& system, Findings& findings);

  /// Components of v and w that the supports hold at time 0 are set to zero (fixed ones only).
  void constrain_at_start(system::State& state);
  /// Takes out of velocities and spins, by node, what is held or driven from the start to the end of the run. Bodies
  /// that are driven keep their spins.
  void hold_for_good(std::span<Row> v, std::span<Row> w) const;
  /// After `accelerate`: replaces prescribed components, keeps the reactions, books the closing half of their work.
  /// `velocity_interval` is the time by which the velocities were advanced.
  void prescribe(system::State& state, double velocity_interval, std::span<system::RigidBody> bodies);
  /// Books the opening half, with the velocities that `prescribe` left.
  void book_opening_work(double dt);
  double work() const { return sum_of(&Reaction::energy); }
  /// Energy::step_change by what is held or driven, up to the last `book_opening_work` [energy].
  double step_change() const { return sum_of(&Reaction::step_change); }
  /// Sets the work done so far to zero: the run begins after a relaxation.
  void reset_work() {
    for (std::vector<Reaction>* reactions : {&spc_, &motion_})
      for (Reaction& r : *reactions) r.energy = r.step_change = 0.0;
  }

  /// Reaction on one node (or body) at t(n).
  struct Reaction {
    int node = 0;                       ///< system node
    model::Index source = model::none;  ///< SPC or motion in the model
    int set_id = 0;
    Vec3d force, moment;  ///< on the structure; in sub-cycling, means over a period
    double energy = 0.0;  ///< work done so far
    PeriodMean mean_force, mean_moment;
    double power = 0.0;        ///< of the other forces at t(n) on what the last `prescribe` changed in the velocity
    double step_change = 0.0;  ///< so far, see Supports::step_change
    void archive(Archive& a);
  };
  const std::vector<Reaction>& spc_reactions() const { return spc_; }
  const std::vector<Reaction>& motion_reactions() const { return motion_; }

  /// What of a node's translations or rotations is held or driven, for those who share out forces among nodes.
  struct OfNode {
    std::vector<Vec3d> held;          ///< directions
    std::vector<std::size_t> driven;  ///< numbers for `axis_of` and `coming_velocity`
    bool passing = false;             ///< some of it not from the beginning to the end
    bool turning = false;             ///< some of it on a circle, or askew to what holds the node
  };
  OfNode of_node(int node, bool rotation) const;
  const Vec3d& axis_of(std::size_t driven) const { return prescribed_dofs_[driven].axis; }
  /// The velocity along it that the next `prescribe` will set; nothing where its curve is not in force.
  std::optional<double> coming_velocity(std::size_t driven, const system::State& state, double velocity_interval) const;

  /// Motions of a body's centre, or of its spin: numbers for `axis_of`, `drives` and `meet_stop`.
  std::vector<std::size_t> motions_of_body(int body, bool rotation) const;
  /// Whether the last `prescribe` met it.
  bool drives(std::size_t driven) const { return prescribed_dofs_[driven].active; }
  /// After a stop has changed the velocity of the body by which the last `prescribe` left it: `impulse` is what the
  /// motion does, along its axis, beside what it did then.
  void meet_stop(std::size_t driven, double impulse, double velocity_interval, const system::State& state);
  /// What the last `prescribe` met of a node's translations.
  Held held(int node) const override;
  void take_up(int node, const Vec3d& impulse) override;
  /// In sub-cycling, behind all that adds to reactions: these become what results show.
  void average_reactions(const system::State& state);

  void add_energy(Energy& energy) const { energy.external += work(); }
  /// Over several ranks: reactions on nodes that not all follow.
  void carry(system::Carried what, const system::System::Computed& of, system::Parcel& parcel);
  void archive(Archive& a);

 private:
  struct ConstrainedDof {
    std::size_t reaction;
    int node;
    Vec3d axis;
    bool rotation;
    double birth, death;
    model::Index control = model::none;                ///< *SENSOR_CONTROL that turns it on and off
    double force = 0.0, before = 0.0, velocity = 0.0;  // of the last prescribe: velocities before and after it
    bool active = false;
    bool together = false;  ///< in one of together_
    void archive(Archive& a);
  };
  struct PrescribedDof : ConstrainedDof {
    const model::PrescribedMotion* motion = nullptr;
    int body = -1;
    bool constrain_others = false;  ///< across the direction that is driven; of a circle: the radius
    Vec3d at_start;                 ///< the axis at time 0: a body's own axes turn with it
    bool oblique = false;           ///< to another motion or support of its node
    // Of a circle, whose directions turn:
    Vec3d left;         ///< velocity of the node after the last prescribe
    double rate = 0.0;  ///< angular velocity, where the curve is its rate [1/time]
    void archive(Archive& a);
  };
  /// What holds and drives one node or body in directions that are not all at right angles, or a body's spin, whose
  /// components are coupled by its inertia: met at one time, each with its own reaction.
  struct Together {
    int node;
    bool rotation;
    int body;
    std::vector<std::size_t> driven,
        held;  ///< places in prescribed_dofs_, of the last card first; in constrained_dofs_
  };
  void find_together(Findings& findings);
  /// What holds and drives the translations of a node in the step that the last `prescribe` met, motions first.
  struct Holding;
  Holding holding(int node) const;
  void add_force(ConstrainedDof& dof, Reaction& reaction, double force);
  double target(PrescribedDof& prescribed, const system::State& state, double old_velocity,
                double velocity_interval) const;
  double circular_target(PrescribedDof& prescribed, const system::State& state, double old_velocity,
                         double velocity_interval) const;
  /// `body`: the rigid body whose virtual node this is, if any.
  void set_component(ConstrainedDof& dof, double target, const system::RigidBody* body, system::State& state,
                     double velocity_interval, std::vector<Reaction>& reactions);
  void meet(const Together& group, system::State& state, double velocity_interval, std::span<system::RigidBody> bodies);
  bool acts(const ConstrainedDof& dof, const system::State& state) const {
    return state.time >= dof.birth && state.time < dof.death && state.acts(dof.control);
  }
  bool acts(const PrescribedDof& dof, const system::State& state) const;
  /// What is held or driven from the next step on starts from the velocity that it has now: the forces of that step are
  /// not in it.
  void release(ConstrainedDof& dof, const system::State& state) const;
  /// The velocity that the coming step asks for.
  double wanted(PrescribedDof& dof, const system::State& state, double velocity_interval,
                std::span<const system::RigidBody> bodies) const;

  const system::System& system_;
  std::vector<ConstrainedDof> constrained_dofs_;
  std::vector<PrescribedDof> prescribed_dofs_;
  std::vector<Together> together_;
  double sum_of(double Reaction::*value) const {
    double sum = 0.0;
    for (const std::vector<Reaction>* reactions : {&spc_, &motion_})
      for (const Reaction& r : *reactions) sum += r.*value;
    return sum;
  }
  /// Whether this process meets what holds or drives a node.
  bool meets(const ConstrainedDof& dof) const { return system_.follows(at(dof.node)); }

  std::vector<Reaction> spc_, motion_;
  double dt_previous_ = 0.0;        ///< of the last prescribe
  double velocity_interval_ = 0.0;  ///< of the last prescribe
  /// A motion or an SPC of a node's translations, by node.
  struct OfTranslations {
    int node;
    bool is_held;        ///< by an SPC
    std::size_t number;  ///< in prescribed_dofs_ or constrained_dofs_
    auto operator<=>(const OfTranslations&) const = default;
  };
  std::vector<OfTranslations> of_translations_;
};

}  // namespace nugget::impact
