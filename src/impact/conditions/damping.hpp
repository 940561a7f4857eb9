// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/archive.hpp"
#include "impact/energy/energy.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// A row of first-order filters that gives a vibration about the same share of critical damping at all frequencies of a
/// range: fed with a velocity, by a force a mass of -sum weight corner (v - low-passed v), or fed with the force F of
/// an element, by a further one of sum weight (F - low-passed F). What is in phase with the acceleration, or the
/// displacement, comes with it: mass, or stiffness, seems to grow.
struct DampingFilters {
  enum class Of { motion, deformation };
  Of of;
  std::vector<double> corner;  ///< circular frequencies of the filters [1/time]
  std::vector<double> weight;  ///< of the output of each [1]
  /// `low`, `high`: the range [cycles/time].
  DampingFilters(double share, double low, double high, Of of = Of::motion);
  /// Share of critical damping of a vibration of a circular frequency, and share by which the mass, or the stiffness,
  /// seems to grow at it.
  double share_at(double omega) const;
  double growth_at(double omega) const;

  /// Over a step: by how much each filter nears what it is fed with, if that is constant; the share of its state that
  /// is left, and of an even growth that it has not let through.
  struct Step {
    std::vector<double> nearer, left, gain;
  };
  Step over(double dt) const;
};

/// *DAMPING_...: forces against the velocities of half a step before. What they take out is the damping energy.
class Damping {
 public:
  explicit Damping(system::System& system);

  /// Adds the forces at state.time to state.f and state.m and books their work over the step that ends there
  /// (velocities of that step in `state`, length `dt`; 0 at the start).
  void apply(system::State& state, double dt);
  double energy() const;
  /// Before the first `apply` of a relaxation, or of the run after it: velocities begin anew, and so does the energy.
  void reset() {
    std::fill(energy_of_node_.begin(), energy_of_node_.end(), 0.0);
    for (ByRange& d : range_) d.started = false;
  }

  bool empty() const { return force_.empty(); }
  /// Over several ranks: forces depend on motions of others than the node's own elements.
  bool looks_everywhere() const;
  void add_energy(Energy& energy) const { energy.damping += this->energy(); }
  /// Over several ranks: what is kept of nodes and elements on its way to another one.
  void carry(system::Carried what, const system::System::Computed& of, system::Parcel& parcel);
  void archive(Archive& a);

 private:
  /// Mass of a node, or of a body at its virtual node, that a card acts upon.
  struct Member {
    std::size_t node;
    double mass, inertia;
    int body;  ///< or -1
  };
  /// The tensor of inertia of a body times a spin.
  Vec3d turned(const Member& body, const Vec3d& spin) const;
  struct ByMass {
    const model::MassDamping* card;
    std::vector<Member> members;  ///< of a part; empty where the card is for everything
  };
  struct ByRange {
    const model::FrequencyRangeDamping* card;
    DampingFilters filters;
    std::vector<Member> members;
    std::vector<Vec3d> v, w;  ///< low-passed velocities and spins, filter by filter of each member
    bool started = false;
    void archive(Archive& a);
  };
  /// Filters of the forces of one group's elements, in axes that turn with each of them.
  struct Deforming {
    int group;
    std::size_t filters;  ///< in `deform_`
    /// By element: forces and moments of the last step, then of them what each filter has let through.
    std::vector<double> passed;
    std::vector<Vec3d> across;  ///< of elements along a line, which have axes by history: a vector across it
    bool started = false;
    void archive(Archive& a);
  };
  struct Relative {
    const model::RelativeDamping* card;
    std::vector<Member> members;
  };

  std::vector<Member> everything() const;
  std::vector<Member> of_parts(const std::vector<model::Index>& parts) const;
  /// Velocity of the body's own motion at a place; zero for none.
  Vec3d carried(model::Index body, const Vec3d& x, const system::State& state) const;
  /// A force against the motion relative to a body, and the opposite on that body.
  void push(std::size_t node, model::Index body, const Vec3d& force, const system::State& state);
  void add(const ByMass& damping, const system::State& state);
  void add(ByRange& damping, const system::State& state, double dt);
  void add_deformation_damping(const model::FrequencyRangeDamping& card, std::vector<char>& taken);
  void add(const Relative& damping, const system::State& state);
  /// Adds the forces of elements that damp their deformation to the damping slots.
  void add_deforming(const system::State& state, double dt);
  void deform(Deforming& damping, const DampingFilters::Step& step, std::size_t begin, std::size_t end,
              const system::State& state, double dt);

  system::System& system_;
  std::vector<ByMass> mass_;
  std::vector<ByRange> range_;
  std::vector<DampingFilters> deform_;
  std::vector<Deforming> deforming_;
  std::vector<Relative> relative_;
  std::vector<int> deforming_of_;                               ///< by group: in `deforming_`, or -1
  std::vector<Row> force_, moment_, last_force_, last_moment_;  ///< by node, bodies included; empty without damping
  std::vector<double> energy_of_node_;                          ///< taken out so far, as `force_`
};

}  // namespace nugget::impact
