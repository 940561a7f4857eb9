// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "base/index.hpp"
#include "system/element_group.hpp"

namespace nugget::system {

class System;

/// Springs and dampers of one part (*ELEMENT_DISCRETE), all with two nodes or all to the ground. With n the unit vector
/// from node 1 to node 2, or that of the orientation, and d the elongation along it (the twist about it),
///     F = S (1 + KD |v|/V0) f(d, v),        +F n on node 1, -F n on node 2 (moments where DRO = 1),
/// where d of a spring with an orientation is the change of (x2 - x1) . n. Such a spring between nodes that stand apart
/// does not balance moments, as LS-DYNA warns too. Source: docs/theory/beam.md#springs-and-dampers, LS-DYNA Keyword
/// Manual.
///
/// Time step: the springs that share nodes are bounded together, and so are those whose nodes belong to one rigid body
/// or follow the same nodes. With b_t the elongation of spring t for motions of the nodes that follow no other, and M
/// their masses, row sums give omega^2 <= sum_t k_t |b M^-1 b_t| (at one node |n . n_t| / m), and with the viscosity
/// likewise 2a = sum c/m: step = 2 / (a + sqrt(a^2 + omega^2)). For a single spring that is 2 sqrt(m1 m2 / (k (m1 +
/// m2))), LS-DYNA's formula with the nodes' masses.
class SpringGroup final : public ElementGroup {
 public:
  SpringGroup(const model::Model& model, model::Index part, std::vector<model::Index> springs,
              const std::vector<int>& node_of, const std::vector<Vec3d>& x);

  static constexpr std::size_t width = 32;
  std::size_t blocks() const override { return (size() + width - 1) / width; }
  std::size_t block_width() const override { return width; }
  void cycle(std::size_t begin, std::size_t end, const State& state, double dt, Slots& slots, Slots& damping) override;
  void own_stiffness(std::size_t e, const State& start, std::span<double> k) const override;
  bool viscosity(std::size_t e, const State& start, std::span<double> c) const override;
  bool force_at_start(std::size_t e, const State& start, std::span<double> f) const override;
  void store_reference_state() override {}

  void archive(Archive& a) override;

  ElementNodes nodes(std::size_t e) const override;
  bool alive(std::size_t e) const override { return springs_[e].alive; }
  void remove(std::size_t e) override { springs_[e].alive = false; }
  void release_step(std::size_t) override {}  // a spring that is deleted gives up its step and its force together
  double stable_step(std::size_t e) const override { return springs_[e].step; }
  double internal_energy(std::size_t e) const override { return springs_[e].energy; }
  double hourglass_energy(std::size_t) const override { return 0.0; }
  Energies energies(std::size_t begin, std::size_t end) const override {
    Energies sum;
    for (std::size_t e = begin; e < end; ++e) sum.add(alive(e), internal_energy(e), 0.0, bulk_viscosity_work(e));
    return sum;
  }
  double mass(std::size_t) const override { return 0.0; }
  double nodal_inertia(std::size_t) const override { return 0.0; }
  double mass_scale(std::size_t) const override { return 1.0; }
  void scale_mass(std::size_t, double) override {}

  bool torsional() const { return section_.torsional; }
  /// Or moment; positive in tension.
  double force(std::size_t e) const { return springs_[e].cancelled ? 0.0 : springs_[e].force; }
  double elongation(std::size_t e) const { return springs_[e].elongation; }  ///< or twist
  Vec3d line(std::size_t e) const { return springs_[e].line; }               ///< unit vector

  /// Whether a spring, which goes on along its law, has no force on its nodes from the next cycle on.
  void cancel_force(std::size_t e, bool cancelled) { springs_[e].cancelled = cancelled; }

  double greatest_stiffness(std::size_t e) const;
  double greatest_viscosity(std::size_t e, double force) const;
  /// What bounds the step of spring e: the sum of the inverse masses at its nodes, that sum with the stiffnesses of
  /// all springs there, and with the viscosities of the others.
  void set_bound(std::size_t e, double inverse_mass, double stiffness_rate, double viscosity_rate);

  /// Stops (CDL, TDL): where elongation is beyond its limit and still grows, both nodes take their common velocity
  /// along the line, a plastic impact. The energy lost is booked with the spring. Nodes must be independent.
  void stop(State& state, std::span<const double> mass);
  bool has_stops() const { return section_.most_compression > 0.0 || section_.most_elongation > 0.0; }

 private:
  struct Entry {
    const model::Discrete* source = nullptr;
    std::array<int, 2> node{-1, -1};       ///< system nodes; the second -1: ground
    std::array<int, 2> direction{-1, -1};  ///< of an orientation that moves
    Vec3d ground;                          ///< where node 1 was at time 0
    double length = 0.0;                   ///< along the line at time 0
    kernel::Spring::State state;
    double elongation = 0.0, pressed = 0.0;  ///< pressed: what is left of it by the clearance
    double force = 0.0, energy = 0.0, step = 0.0;
    Vec3d line;
    bool alive = true, started = false, cancelled = false;
    double inverse_mass = 0.0, stiffness_rate = 0.0, viscosity_rate = 0.0;
    void archive(Archive& a);
  };
  /// What of OFFSET the law has at time 0, less the clearance.
  double pressed_at_start(const Entry& s) const;
  /// Whether the force is 0 for small motions about time 0: within the clearance, or deleted there.
  bool slack_at_start(const Entry& s) const;
  /// A modulus along the spring's line, as a matrix of its freedoms.
  void along_line(std::size_t e, double modulus, std::span<double> k) const;
  std::size_t at_each_node() const { return at(nodes_per_element); }
  Vec3d span(const Entry& s, const State& state) const;
  /// The line of a spring and, of one along it, the elongation's length on it.
  Vec3d line_of(const Entry& s, const State& state, double& length) const;
  void advance(Entry& s, const State& state, double dt);
  /// Stiffness-proportional damping of spring e into its slots.
  void damp(std::size_t e, const State& state, Slots& slots) const;
  double stable_step_of(const Entry& s) const;
  void find_block_step(std::size_t b);

  const model::SectionDiscrete& section_;
  const kernel::Spring& law_;
  const model::Model& model_;
  std::vector<Entry> springs_;
};

/// Gives all springs of a system their bounds; to be called when masses have changed.
void bound_springs(System& system);
/// Findings on springs that cannot be computed: a node that nothing opposes to their force, a stop at a dependent node.
void check_springs(const System& system, Findings& findings);

}  // namespace nugget::system
