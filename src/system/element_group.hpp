// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "base/index.hpp"
#include "kernel/law/point_damage.hpp"
#include "model/lumped_mass.hpp"
#include "system/parcel.hpp"
#include "system/slots.hpp"
#include "system/state.hpp"
#include "system/strain_rule.hpp"

namespace nugget::system {

/// System nodes of an element, as many as its group's nodes_per_element.
using ElementNodes = std::array<int, 10>;

/// Elements of the widest block there is (AVX-512). Groups are padded to a multiple of it, and what is chosen by blocks
/// is chosen so many at a time, whatever the width: results, slots and restart files must not depend on that. Of
/// groups of single precision twice as many.
inline constexpr std::size_t widest_block = 8;

/// How many elements the kernels of this program take at a time: the doubles that one of its registers holds.
int elements_at_a_time();

/// Elements of one kind, formulation, law and part, in blocks of `width` lanes. A cycle reads nodal rows and writes the
/// elements' nodal forces into slots of their own; the nodes gather the slots afterwards, always in the same order.
class ElementGroup {
 public:
  virtual ~ElementGroup() = default;
  ElementGroup() = default;
  ElementGroup(const ElementGroup&) = delete;
  ElementGroup& operator=(const ElementGroup&) = delete;

  model::ElementKind kind = model::ElementKind::nothing;
  model::Index part = model::none;
  std::vector<model::Index> element;  ///< model index of each element of the group, in the group's order
  int nodes_per_element = 0;
  bool weld = false;           ///< of spot-weld material
  bool rotational = false;     ///< elements have moments at their nodes; else forces only
  std::size_t first_slot = 0;  ///< see slot

  std::size_t size() const { return element.size(); }
  virtual std::size_t blocks() const = 0;
  virtual std::size_t block_width() const = 0;  ///< elements of a block; the last one may be padded
  /// Elements of the widest block that the group has on any machine; it is padded to a multiple of it.
  virtual std::size_t widest() const { return widest_block; }
  /// Whether its kernel, state and slots are of single precision.
  virtual bool single_precision() const { return false; }
  float* single_slots = nullptr;  ///< of a group of single precision: its slots, in the place of those of `cycle`

  /// Advances elements of blocks [begin, end) over dt with the velocities of `state` at mid-step and its positions at
  /// the end of the step; fills slots; adds the work done to the elements' internal energy. Where they are `damped()`
  /// fills slots of `damping` too, with beta K v: K v is the rate of the nodal forces if the elements, where they were
  /// in the middle of the step, were free of stress and elastic, without what a kernel resists by viscosity.
  virtual void cycle(std::size_t begin, std::size_t end, const State& state, double dt, Slots& slots,
                     Slots& damping) = 0;
  /// What all groups have; a group's own adds to it.
  virtual void archive(Archive& a);

  /// The slot of the force at node `a` of element `e`. Slots of groups of single precision are counted on behind those
  /// of all others.
  std::size_t slot(std::size_t e, int a) const {
    const std::size_t lanes = slot_lanes();
    return first_slot + (e / lanes * at(nodes_per_element) + at(a)) * (rotational ? 2 : 1) * lanes + e % lanes;
  }
  /// That of the moment, of groups that are rotational.
  std::size_t moment_slot(std::size_t e, int a) const { return slot(e, a) + slot_lanes(); }
  std::size_t slot_lanes() const { return single_precision() ? SingleSlots::lanes : Slots::lanes; }
  /// Slots that the group needs, padding lanes included.
  std::size_t slot_count() const { return blocks() * block_width() * rows_of_element(); }
  /// Nodal vectors of an element: forces, and moments.
  std::size_t rows_of_element() const { return at(nodes_per_element) * (rotational ? 2 : 1); }
  /// Of the nodal vectors of a block, element by element and node by node: that of the force at node `a` of element
  /// `e`; the next one is the moment.
  std::size_t row_in_block(std::size_t e, std::size_t a) const {
    return e % block_width() * rows_of_element() + a * (rotational ? 2 : 1);
  }

  /// Degrees of freedom of a node: three translations, then three rotations where `rotational`.
  int freedoms() const { return rotational ? 6 : 3; }
  /// Stiffness of element e in its initial, unstressed state: row i, column j of `k` is the force in freedom i of the
  /// element for a unit motion of freedom j, d f_i / d u_j, global axes, freedoms node by node. It comes out of the
  /// cycle's own kernel, so that modes and impact cannot disagree; what a kernel resists by viscosity is not in it.
  /// `k` holds (nodes_per_element freedoms())^2 numbers.
  void stiffness(std::size_t e, const State& start, std::span<double> k) const;
  /// What a joint in series with a weld of bricks takes away from the stiffness of one of them, to be added to it
  /// (System::BrickJoint).
  void soften(std::size_t e, std::vector<double> change) { softening_[e] = std::move(change); }
  /// Likewise d f_i / d v_j of the dashpots in element e; false, and `c` as it was, where there is none.
  virtual bool viscosity(std::size_t, const State&, std::span<double>) const { return false; }

  /// Internal forces in the freedoms of element e at time 0, of a spring or discrete beam that has some by its offset
  /// or preload; false, and `f` as it was, where there are none. Initial stresses are not among them.
  virtual bool force_at_start(std::size_t, const State&, std::span<double>) const { return false; }

  /// Nodal forces by row_in_block, of the elements of block b where they are now, free of stress and elastic,
  /// after a step dt with small velocities `v` and spins `w`: dt/2 K v + C v. Of C the hourglass viscosity counts whole
  /// and the linear bulk viscosity of solids half, since it acts under compression only; damping of the part does not.
  /// K grows with the square of the element's stable step over its present one. By `stiffness` and `viscosity`, unless
  /// a group knows better.
  virtual void vibrate(std::size_t b, const State& now, std::span<const Row> v, std::span<const Row> w, double dt,
                       std::span<Row> forces) const;

  /// Gives the elements of those blocks for which `here(block)` is true their state free of stress at the places
  /// `place(node)`, where the group was made without. Of the others is known that they are active.
  virtual void start(const std::function<Vec3d(int)>& place, const std::function<bool(std::size_t)>& here) {
    static_cast<void>(place);
    static_cast<void>(here);
  }
  /// Sets the states of all blocks free for which `here(block)` is false: another rank computes them, and what is known
  /// of them is what `remove`, `scale_mass`, `take_step` and `carry` say. Groups of welds keep them.
  virtual void leave(const std::function<bool(std::size_t)>& here) { static_cast<void>(here); }
  /// How many elements have their states elsewhere.
  virtual std::size_t elsewhere() const { return 0; }

  // What is known of element e of the group.
  virtual ElementNodes nodes(std::size_t e) const = 0;
  virtual bool alive(std::size_t e) const = 0;
  /// Deletes element e. Its last force still acts over the step to come, so its own step stays in the choice for that.
  virtual void remove(std::size_t e) = 0;
  /// Numbers of an element's state that say, by 1, that it stands beside a deleted one, of laws that are weaker there
  /// (SOFT of MAT_054); none of others.
  virtual std::vector<int> crash_front_fields() const { return {}; }
  /// Sets number i of the state of element e, unless that is elsewhere.
  virtual void set_number(std::size_t, int, double) {}
  /// Takes the step of a deleted element out of the choice at once: the step is why it was deleted.
  virtual void release_step(std::size_t e) = 0;
  /// Puts the step of an element that another rank computes into the choice; `release_step` takes it out again.
  virtual void take_step(std::size_t, double) {}
  /// Blocks [begin, end) on their way from the rank that computes them to another. Groups that all ranks compute have
  /// nothing to carry.
  virtual void carry(std::size_t, std::size_t, Carried, Parcel&) {}
  virtual double stable_step(std::size_t e) const = 0;      ///< before TSSFAC, mass scaling included; of the last cycle
  virtual double internal_energy(std::size_t e) const = 0;  ///< hourglass work not included
  virtual double hourglass_energy(std::size_t e) const = 0;
  /// Books work that something in series with element e took up as its internal energy.
  virtual void add_internal_energy(std::size_t, double) {}
  /// Work done against bulk viscosity so far; a part of the internal energy.
  virtual double bulk_viscosity_work(std::size_t) const { return 0.0; }
  /// Energies of elements [begin, end), added up one after the other.
  struct Energies {
    double internal = 0.0, hourglass = 0.0;  ///< of active elements
    double deleted = 0.0;                    ///< both, of deleted ones
    double bulk_viscosity = 0.0;             ///< of all

    void add(bool is_active, double internal_of_one, double hourglass_of_one, double bulk_viscosity_of_one) {
      bulk_viscosity += bulk_viscosity_of_one;
      if (is_active) {
        internal += internal_of_one;
        hourglass += hourglass_of_one;
      } else {
        deleted += internal_of_one + hourglass_of_one;
      }
    }
  };
  virtual Energies energies(std::size_t begin, std::size_t end) const = 0;
  virtual double mass(std::size_t e) const = 0;  ///< physical, of the whole element
  /// Its share at node a, physical.
  double nodal_mass(std::size_t e, int a) const { return model::mass_at(mass(e), at(nodes_per_element), at(a)); }
  virtual double nodal_inertia(std::size_t e) const = 0;  ///< physical rotary inertia at each of its nodes
  virtual double mass_scale(std::size_t e) const = 0;     ///< factor on the density by mass scaling
  virtual double kept_mass_scale(double factor) const { return factor; }  ///< what is kept of it, rounded up
  virtual void scale_mass(std::size_t e, double factor) = 0;              ///< sets that factor

  /// Stiffness-proportional damping: a share of critical at the highest frequency of each element, or beta [time].
  double damping_share = 0.0, damping_time = 0.0;
  bool damped() const { return damping_share > 0.0 || damping_time > 0.0; }
  double damping_time_at(double step) const { return damping_time > 0.0 ? damping_time : damping_share * step; }
  /// Share by which damping of the elements' forces over a range of frequencies stiffens them above it.
  double damping_stiffness_ratio = 0.0;
  /// Stable step of an element that is so stiffened and damped, with the velocities of half a step before (Belytschko):
  /// s (sqrt(1 + x^2) - x), x = beta / s.
  double damped_step(double s) const {
    if (damping_stiffness_ratio > 0.0) s /= std::sqrt(1.0 + damping_stiffness_ratio);
    if (!damped() || !(s < std::numeric_limits<double>::infinity())) return s;
    const double beta = damping_time_at(s);
    return std::sqrt(s * s + beta * beta) - beta;
  }
  /// Keeps the state as it is, free of stress, for stiffness-proportional damping and `vibrate`. Once is enough.
  virtual void store_reference_state() = 0;

  // Damage of a weld as a whole, from outside its elements. Elements of other kinds are always undamaged.
  virtual double integrity(std::size_t) const { return 1.0; }  ///< share of the undamaged element's force that is left
  virtual void set_integrity(std::size_t, double) {}           ///< from the next cycle on
  /// Lets no point's stress grow beyond what it is now; where the material says that this may happen.
  virtual void freeze_yield(std::size_t) {}

  /// Stresses and strains for output, global axes where not said otherwise.
  struct Layer {
    std::array<double, 6> stress{};  ///< xx yy zz xy yz zx
    double plastic_strain = 0.0;
    kernel::DamageNumbers damage{};
  };
  virtual int layers() const { return 0; }
  virtual Layer layer(std::size_t, int, const State&) const { return {}; }
  /// The layers from the first on, as many as there is room for: faster than one by one. `axes`: as `axes` gives them.
  virtual void through(std::size_t e, const State& now, const std::optional<Frame3d>& /*axes*/,
                       std::span<Layer> layers) const {
    for (std::size_t k = 0; k < layers.size(); ++k) layers[k] = layer(e, static_cast<int>(k), now);
  }
  /// Gives a layer stress and plastic strain from outside (preloads, states of an earlier run), as `layer` gives them.
  /// False where this kind of element cannot take it.
  virtual bool set_layer(std::size_t, int, const Layer&, const State&) { return false; }
  /// Of a point of a weld; 0 of other elements.
  virtual double plastic_strain(std::size_t, int) const { return 0.0; }
  /// Of shells, at the positions given, and of discrete beams: the axes in which their `resultants` stand.
  virtual std::optional<Frame3d> axes(std::size_t, const State&) const { return {}; }
  /// Axes a, b, c of the material in a layer, of laws that have them (AOPT).
  virtual std::optional<Frame3d> material_axes(std::size_t, int, const State&) const { return {}; }
  /// Current thickness of a shell, length of a beam.
  virtual double thickness(std::size_t) const { return 0.0; }
  /// Shells: Mx My Mxy Qx Qy Nx Ny Nxy in local axes, per unit length. Beams: N_rr N_rs N_rt M_rr M_ss M_tt; of a joint
  /// between sheets its plastic displacement and its damage besides.
  virtual std::array<double, 8> resultants(std::size_t) const { return {}; }
  /// Of discrete beams: motion of node 2 relative to node 1 along r, s, t [length] and about them [radian].
  virtual std::array<double, 6> displacements(std::size_t) const { return {}; }
  /// Effective strain rate of a weld element in the last cycle, sqrt(2/3 e:e) of the deviator [1/time]; 0 of others.
  virtual double strain_rate(std::size_t) const { return 0.0; }

  /// From the next cycle on adds up these strains for results; groups without kernels have none.
  virtual void add_up_strains(StrainRule) {}
  /// Which strains are added up; null: none.
  virtual const StrainRule* strain_rule() const { return nullptr; }
  /// Number i of the strains of element e, as StrainRule::Of lists them; where there is a rule.
  virtual double strain(std::size_t, std::size_t) const { return 0.0; }
  virtual void set_strain(std::size_t, std::size_t, double) {}

  /// How many elements were deleted so far; of elements and not of blocks, so that ranks count alike.
  std::atomic<int> deletions{0};
  /// An element whose volume has become negative, or -1: the run must stop.
  std::atomic<int> inverted{-1};

  /// Over several ranks: who holds the states of an element (of one that fills up the last block, too).
  Archive::Holders holders;

  /// Cycles from one time at which these elements have their forces to the next: 1 but in sub-cycling (Subcycles).
  int period = 1;

  /// Smallest stable step of each block's active elements in the last cycle, mass scaling included (infinite where none
  /// is active).
  std::vector<double> block_step;
  /// Share of the stable step that may be taken: TSSFAC, or 1 for welds whose mass was scaled to a step that contains
  /// it.
  double step_share = 0.9;
  /// Step below which the density of these elements is raised by DT2MS; 0: never. Set by System.
  double mass_step = 0.0;
  /// DT of the weld material, to which the density is raised before that; 0: none. The mass that it adds is physical.
  double physical_mass_step = 0.0;
  /// The part of mass_scale(e) that comes from that DT.
  double physical_mass_scale(std::size_t e) const {
    return physical_mass_scale_.empty() ? 1.0 : physical_mass_scale_[e];
  }
  /// Another process has computed element e, and has found this.
  void take_physical_mass_scale(std::size_t e, double physical);
  /// The density factor that brings element e up to these steps; that of DT is kept.
  double wanted_mass_scale(std::size_t e);

 private:
  /// That of the element's own kernel.
  virtual void own_stiffness(std::size_t e, const State& start, std::span<double> k) const = 0;

  std::vector<double> physical_mass_scale_;
  std::map<std::size_t, std::vector<double>> softening_;  ///< by element
};

}  // namespace nugget::system
