// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "impact/energy/energy.hpp"
#include "kernel/law/belt_tension.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Seat belts: bars between two nodes that carry tension alone, slip rings, and retractors. With L the distance of its
/// nodes and l its unstretched length a belt has the tension T(L / l - 1) of kernel::BeltTension, and a damping of 0.1
/// m / dt times the rate at which it is stretched, a tenth of the tension at most.
///
/// Slip ring: where the tensions of its two belts differ by more than exp(mu theta), theta the angle by which the belt
/// turns there, unstretched length goes to the belt of the higher tension until they differ by just that. A belt that
/// has become shorter than LMIN passes the ring: its far node comes out on the other side, 1.1 LMIN of belt from the
/// ring, where both belts have one strain; the belt behind it ends at the ring, its strain as before.
///
/// Retractor: gives out belt, or reels it in, such that its belt has the first tension of its loading curve, 0.01 LFED
/// a cycle at most. It locks once one of its sensors has responded, TDEL later, when PULL more was pulled out. Then the
/// tension goes by its curves over what is pulled out from there. A belt that is longer than LFED + LMIN lets the next
/// one come out, 1.1 LMIN long; one that is shorter than LMIN goes in.
///
/// Pretensioner: acts TIME after one of its sensors has responded. Type 1 locks its retractor and adds the pull-in of
/// its curve to what is pulled out, as a spool turned behind a torsion bar whose twist is both: the curves of the
/// retractor limit the tension. Type 5 reels that in whatever the tension, until the curve or LMTFRC ends it; then the
/// retractor locks where its loading curve has the tension of its belt. Type 2 has the force of a spring cancelled
/// until it acts, type 3 from then on.
///
/// Energy: minus the work of the belts' forces on the nodes, and what nodes gain or lose in kinetic energy when they
/// pass a ring or go in and out. What retractors reel in is put in from outside, tension times length; what is pulled
/// out of them stays in the belts' energy. Source: LS-DYNA theory manual, seat belts; docs/decisions/0118 for what is
/// ours.
class Belts {
 public:
  Belts(system::System& system, Findings& findings);

  bool empty() const { return elements_.empty() && pretensioners_.empty(); }
  /// Nodes have moved: belts pass rings, and come out of retractors.
  void move(system::State& state);
  /// Material slides; adds the forces at state.time to the nodes.
  void apply(system::State& state);
  /// The longest step at which the belts are stable; infinite where there are none [time].
  double stable_step() const { return stable_step_; }
  double energy() const { return energy_ + reeled_; }

  // For results, in the order of the model.
  double force(std::size_t belt) const { return elements_[belt].force; }
  double length(std::size_t belt) const { return elements_[belt].distance; }  ///< of its nodes
  double unstretched(std::size_t belt) const { return elements_[belt].length; }
  double slip(std::size_t ring) const { return rings_[ring].slip; }  ///< to its first belt so far
  double ring_tension(std::size_t ring, std::size_t side) const { return elements_[rings_[ring].element[side]].force; }
  double pull_out_rate(std::size_t retractor) const { return reels_[retractor].rate; }
  double pull_out(std::size_t retractor) const { return reels_[retractor].paid; }  ///< so far [length]
  double tension(std::size_t retractor) const { return elements_[reels_[retractor].mouth].force; }
  bool is_inside(std::size_t belt) const { return elements_[belt].inside; }
  bool locked(std::size_t retractor) const { return reels_[retractor].locked; }
  /// When retractors locked, pretensioners acted and belts passed, lines of run.log.
  const std::vector<std::string>& events() const { return events_; }

  void add_energy(Energy& sum) const {
    sum.internal += energy();
    sum.external += reeled_;
  }
  void archive(Archive& a);

 private:
  using Tension = kernel::BeltTension;
  struct Element {
    const Tension* tension = nullptr;
    std::array<int, 2> node{};
    double length = 0.0, distance = 0.0;  ///< unstretched, and of its nodes
    double strain = 0.0, force = 0.0;
    double mass = 0.0, least = 0.0;  ///< LMIN
    bool inside = false;
    Tension::State state;
    Vec3d pull;  ///< on its first node
    void archive(Archive& a);
  };
  struct Ring {
    const model::SlipRing* source = nullptr;
    int node = 0;
    std::array<int, 2> element{};
    double slip = 0.0, speed = 0.0;  ///< to the first belt; of the last cycle
    void archive(Archive& a);
  };
  struct Reel {
    const model::Retractor* source = nullptr;
    Tension tension;
    int node = 0, mouth = 0;
    std::vector<int> inside, nodes;  ///< elements and nodes, the next to come out first
    double paid = 0.0, rate = 0.0;   ///< so far; in the last cycle
    double responded = -1.0;         ///< when a sensor did; below 0: none has
    double armed = -1.0;             ///< TDEL after that
    double paid_then = 0.0;          ///< what was paid out at that time
    bool locked = false;
    double pulled = 0.0;  ///< out since it was locked
    Tension::State state;
    void archive(Archive& a);
  };
  struct Tightening {
    const model::Pretensioner* source = nullptr;
    double responded = -1.0;  ///< when a sensor did; below 0: none has
    double acting = -1.0;     ///< TIME after that
    double drawn = 0.0;       ///< of its curve so far [length]
    bool ended = false;
    void archive(Archive& a);
  };
  struct Sensing {
    double since = -1.0;  ///< from when it has responded without a break
    bool on = false;      ///< once it was for long enough, for good
    Vec3d velocity;
    double step = 0.0;
    bool known = false;
    void archive(Archive& a) { a(since, on, velocity, step, known); }
  };
  int far(int element, int node) const;
  double tension_at(const Element& e, double length) const { return (*e.tension)(e.distance / length - 1.0, e.state); }
  void measure(Element& e, const system::State& state) const;
  /// The other belt at a node where two belts meet and nothing else holds; -1: there is none.
  int next(int element, int node) const;
  void book(const system::State& state);
  void put(int node, int from, int to, double share, system::State& state);
  void sense(const system::State& state);
  double sensed(const model::BeltSensor& sensor, Sensing& sensing, const system::State& state) const;
  void pass(Ring& ring, int short_one, system::State& state);
  void slide(Ring& ring, const system::State& state);
  double friction(const Ring& ring, const system::State& state) const;
  void come_out(Reel& reel, system::State& state);
  void go_in(Reel& reel, system::State& state);
  void wind(Reel& reel, std::optional<double> drawn, const system::State& state);
  void lock(Reel& reel, const system::State& state);
  void lock_now(Reel& reel, const system::State& state);
  bool any_on(const std::vector<model::Index>& sensors, model::Index control, const system::State& state) const;
  std::optional<double> act(Tightening& pretensioner, const system::State& state);
  void cancel_force(const model::Pretensioner& of, bool cancelled);
  double longest_change(const Reel& reel) const;
  void pull(Element& e, system::State& state);
  void find_step();

  system::System& system_;
  std::vector<Tension> tensions_;  ///< by material
  std::vector<Element> elements_;
  std::vector<Ring> rings_;
  std::vector<Reel> reels_;
  std::vector<Sensing> sensors_;
  std::vector<Tightening> pretensioners_;
  std::vector<double> mobility_;   ///< by system node, of belts' nodes: largest inverse mass that a force meets there
  std::vector<double> stiffness_;  ///< the same: sum of its belts'
  std::vector<int> nodes_;         ///< of belts
  std::vector<unsigned char> fixed_;  ///< by system node: something else holds it
  double energy_ = 0.0, reeled_ = 0.0;
  double stable_step_ = std::numeric_limits<double>::infinity();
  std::vector<std::string> events_;
};

}  // namespace nugget::impact
