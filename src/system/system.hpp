// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/finding.hpp"
#include "base/index.hpp"
#include "base/ranks.hpp"
#include "base/zeroed.hpp"
#include "kernel/element/hexahedron.hpp"
#include "kernel/element/weld_joint.hpp"
#include "model/model.hpp"
#include "system/brick_joint.hpp"
#include "system/constraint_map.hpp"
#include "system/element_group.hpp"
#include "system/nodal_sums.hpp"
#include "system/rigid_body.hpp"
#include "system/state.hpp"
#include "system/subcycles.hpp"
#include "weld/failure/heat_zones.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::system {

enum class ShellKind;  // shell_elements.hpp
class Partition;       // partition.hpp
class Share;           // share.hpp
class SumsByRank;      // sums_by_rank.hpp

/// A model made discrete: nodes and elements in an order that keeps neighbours close in memory, lumped masses, the
/// constraint map, element blocks. Impact and NVH share it. Refers to the model and the ties, which must outlive it.
class System {
 public:
  /// When elements get the states that they start with: as the system is made, or, in a run that several ranks share,
  /// when each has its share, and then only the elements of that (docs/decisions/0133).
  enum class ElementsStart { at_once, with_share };
  /// `periods`: of elements in sub-cycling.
  System(const model::Model& model, const weld::Ties& ties, Findings& findings, ElementPeriods periods = {},
         ElementsStart elements_start = ElementsStart::at_once);
  ~System();

  const model::Model& model;
  const weld::Ties& ties;

  // Nodes: system order. `node_of[model index]` and back; virtual nodes of bodies and then of tie springs follow the
  // real ones.
  std::size_t nodes = 0;
  std::vector<int> node_of;
  std::vector<model::Index> model_node;
  /// Id in the deck of a node that is not virtual.
  int node_id(int node) const { return model.nodes.id[model_node[node]]; }
  std::size_t all_nodes() const { return nodes + bodies.size() + springs.size(); }

  /// Lumped mass and rotary inertia by node; zero for dependent nodes (theirs is handed over) and for nodes that carry
  /// nothing.
  std::vector<double> mass, inertia;
  /// The same before anything was handed over: what the elements and point masses put there.
  std::vector<double> own_mass;
  const std::vector<double>& own_inertia() const { return own_inertia_; }

  ConstraintMap map;
  std::vector<RigidBody> bodies;  ///< body b is virtual node nodes + b
  std::vector<int> body_of;       ///< by model rigid-body index

  /// A tie by penalty: a spring between the tied node and an anchor, a virtual node that follows the segment. The two
  /// stand at one place at first, unless the gap has no lever (see weld::Tie).
  struct TieSpring {
    std::size_t tie;  ///< in Ties::ties
    int node;
    int anchor;  ///< dependent in `map`
  };
  std::vector<TieSpring> springs;
  /// What makes a dependent node dependent, for messages: `*CONTACT_SPOTWELD 3`, `rigid part 5`.
  std::string constraint_name(int node) const { return name(constraint_source_[node]); }
  /// Ends a tie by constraint: its node keeps its velocity and takes its mass back. Then call
  /// `transfer_dependent_mass`.
  void release(std::size_t tie);
  /// Other weights for the nodes of the disc of a tie by area; then the same.
  void set_disc_weights(std::size_t tie, std::span<const double> weights);
  /// Of nodes that are tied until the mesh tears (model::TiedNodes), those of one place: `leaving` are free from now on
  /// with the velocity they have, `staying` move as one, or are free if it is one alone. Then the same.
  void part_tied_nodes(std::span<const int> staying, std::span<const int> leaving);
  /// Whether such a tie is why a node is dependent: then it is held and driven as the one that it follows is.
  bool follows_tied_node(int node) const { return constraint_source_[node].kind == ConstraintSource::Kind::tied; }
  /// Masses and inertias of dependent nodes to those that they follow.
  void transfer_dependent_mass();

  std::vector<std::unique_ptr<ElementGroup>> groups;
  /// Of welds of bricks; the joints of weld beams are in their groups.
  std::vector<BrickJoint> brick_joints;
  /// Welds whose joints flow by what others do as well.
  std::vector<weld::Stack> weld_stacks;
  /// In a small motion of all nodes (by system node): moves the end faces of bricks with joints against their discs as
  /// far as their elastic joints do.
  void slide_brick_faces(std::span<Row> motion) const;

  /// Where a model element stands; group -1 for elements that have no kernel (rigid parts, MAT_NULL, deleted welds).
  struct ElementLocation {
    int group = -1;
    int element = -1;
  };
  std::vector<ElementLocation> shell_location, solid_location, beam_location, discrete_location;
  /// Of a shell, a solid or a beam.
  ElementLocation location_of(model::ElementKind kind, model::Index element) const {
    return (kind == model::ElementKind::shell   ? shell_location
            : kind == model::ElementKind::solid ? solid_location
                                                : beam_location)[element];
  }
  /// Of an element of a weld.
  ElementLocation location_of(const weld::Weld& weld, model::Index element) const {
    return location_of(weld.element_kind(), element);
  }
  /// Internal force of an element at its node `a` after the last cycle; on the node itself acts the opposite [force].
  Vec3d nodal_force(ElementLocation location, int a) const;
  /// The moment that belongs to it; zero for elements without rotations [force length].
  Vec3d nodal_moment(ElementLocation location, int a) const;

  /// Elements that have mass but no kernel (rigid parts, MAT_NULL).
  struct MassOnlyElement {
    model::Index part;
    int corners;
    ElementNodes node;
    double mass;           ///< of the element
    double nodal_inertia;  ///< at each node
    double nodal_mass(int a) const { return model::mass_at(mass, at(corners), at(a)); }
  };
  const std::vector<MassOnlyElement>& mass_only_elements() const { return mass_only_elements_; }

  /// State at time 0: positions after tying, initial velocities, momenta of the bodies.
  State initial_state();
  /// That state is there and is not asked for again: what of `m`, the model, it alone needs takes no room any more.
  /// `initial_state` then throws std::logic_error.
  void forget_start(model::Model& m);

  /// Forces of all elements at the end of a step into state.f and state.m (overwritten); keeps the smallest stable
  /// step.
  void internal_force(State& state);
  /// Over several ranks, after that and when forces of contacts are there: sums of nodes that everyone follows, but
  /// only one rank adds up.
  void exchange_sums(State& state);
  /// Cycles from one time at which all elements have forces to the next; 1 but in sub-cycling.
  int period() const { return subcycles_.period(); }
  /// In sub-cycling: the velocities of the nodes, in the mean since the last call or the last period.
  std::span<const Row> mean_velocities() { return subcycles_.mean_velocities(); }
  /// In sub-cycling, between two periods: elements whose stable step has become shorter, as that of those with a period
  /// of 1 has not, have their forces more often.
  void shorten_periods() { subcycles_.shorten(*this); }
  /// Then, when the step is chosen.
  void correct_impulses(State& state) { subcycles_.correct_impulses(*this, state); }
  /// Whether elements have no states as yet: these come with the share.
  bool starts_with_share() const { return !elements_have_started_; }
  /// Gives all elements the states that they start with, where these were to come with the share.
  void start_elements();
  /// Elements whose states this process has not.
  std::size_t elements_elsewhere() const;
  /// Stable steps and scaled masses of the elements where they stand.
  void compute_at_rest();
  /// Calls `body(group, begin, end)` for ranges of blocks of elements, all of all groups, side by side.
  void for_each_block(const std::function<void(int, std::size_t, std::size_t)>& body) const {
    system::for_each_block(blocks_, body);
  }
  /// Calls `body(begin, end)` for ranges of nodes that this rank follows, side by side; all, in one process. Virtual
  /// ones are among them.
  void for_each_node(std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) const;
  /// Forces by which elements damp themselves, by ElementGroup::slot; empty until `allocate_damping_slots`.
  Slots damping_slots;
  void allocate_damping_slots() {
    if (damping_slots.empty()) damping_slots.resize(slots_.size() + single_slots_.size());
  }
  /// Takes the sum of its damping slots from each node. Rows of bodies become 0.
  void gather_damping(std::span<Row> force, std::span<Row> moment);

  /// The element that controls the time step.
  struct Controlling {
    double step = 0.0;  ///< the step to take, TSSFAC included; infinite without elements
    int group = -1;
    int element = -1;
    std::string describe(const System&) const;  ///< `shell 17 of part 5`
  };
  Controlling controlling() const;
  /// `shell`, `solid`, `beam`, `spring`; and the user's id of a model element of the group's kind.
  std::string_view kind_name(const ElementGroup& group) const;
  int element_id(const ElementGroup& group, model::Index element) const;

  /// Mass scaling to the deck's DT2MS and the welds' DT: raises the density of elements whose stable step is too small.
  /// True if any mass was added; nodal masses are then assembled anew.
  bool scale_mass(bool at_start);
  /// Nodes whose masses the last scale_mass(false) changed, their own or those handed over to them; ascending.
  std::span<const int> nodes_of_changed_mass() const { return changed_mass_; }
  /// Elements of a group whose density has ever been scaled; ascending.
  std::span<const int> scaled_elements(std::size_t group) const { return scaled_elements_[group]; }

  /// Releases nodes of a rigid body while the model moves: they are free from now on, with their own mass and the
  /// velocity they have. What the body keeps moves on as a body of its own mass and inertia; linear momentum is
  /// conserved to round-off, angular momentum to the square of the angle turned in a step. `kept`: its other nodes;
  /// where there are none it is at rest and has no mass. Loads of all these nodes stand in `state`, not yet collected.
  void release_nodes(std::size_t body, std::span<const int> released, std::span<const int> kept, State& state);

  struct Masses {
    double physical = 0.0;        ///< of the model as the deck describes it, DT of welds included
    double added = 0.0;           ///< by DT2MS
    double added_to_welds = 0.0;  ///< the share of it that went into welds, and what DT of the weld material added
    std::vector<double> added_by_part;
  };
  const Masses& masses() const;
  /// How often masses of elements or nodes have changed, or nodes were released: what is made from them is made anew.
  int mass_changes() const { return mass_changes_; }
  /// Physical mass of a part (its elements and point masses assigned to it).
  double part_mass(model::Index part) const;
  /// The rigid body that carries a node, in `bodies`; -1: none.
  int rigid_body_of_node(int node) const;

  // ---- A run over several ranks

  /// From now on this rank computes its share of the elements only. All ranks do so at the same state, which is whole
  /// on each of them. `followed`: by node, whether all ranks follow its motion. `of_nodes`: rows of which those of
  /// nodes that this rank does not follow are set free, as soon as it knows them.
  void share_out(Ranks& ranks, Partition partition, std::span<const char> followed,
                 std::span<Rows* const> of_nodes = {});
  /// Share of the stable step below which all ranks are to know an element's; 0: none.
  double reported_below = 0.0;
  /// What this rank does; null in a run by one process.
  Share* share() const { return share_.get(); }
  /// Which sums it and others can make alone; null in a run by one process.
  const SumsByRank* sums_by_rank() const { return sums_by_rank_.get(); }
  /// Elements of all ranks, of which each has computed its own, come to the first rank; `to_all`: to all of them.
  /// `more(of, parcel)` puts into each parcel, or takes out of it, what others keep of the elements for which
  /// `of(group, element)` is true. With the elements go the rows `of_nodes` of nodes that not all ranks follow.
  struct Computed {
    int rank = 0;  ///< whose parcel it is
    const Share& share;
    std::function<bool(int group, std::size_t element)> element;
    bool operator()(int group, std::size_t e) const { return element(group, e); }
  };
  void collect(Carried what, std::span<Rows* const> of_nodes,
               const std::function<void(const Computed& of, Parcel&)>& more, bool to_all = false);
  /// The nodal forces of an element, which `results` lack.
  void carry_forces(ElementLocation location, Parcel& parcel);
  /// Whether this process follows a node: always, where it is alone.
  bool follows(std::size_t node) const;
  /// Whether this process computes an element: always, where it is alone.
  bool computes(ElementLocation location) const;
  /// Whether elements look at places of nodes that are not their own (BeforeCycle).
  bool looks_at_neighbours() const;
  /// Over several ranks: who holds values of a node; empty in a run by one process.
  Archive::Holders holders_of_nodes() const;
  /// Sets the states of elements free that other ranks compute, and takes their steps out of the choice: after
  /// `collect` with results or `whole`, when they have been used.
  void leave_to_others();

  void archive(Archive& a);

 private:
  void order_nodes();

  /// Elements of one part and the system nodes of each.
  struct Members {
    std::vector<model::Index> element;
    std::vector<ElementNodes> node;
  };
  template <class Elements>
  Members members(const Elements& elements, const std::vector<model::Index>& chosen) const;
  /// Those of one period together.
  std::map<int, Members> by_period(model::ElementKind kind, const Members& m) const;
  template <class Element>
  void add_group(const Element& element, model::ElementKind kind, std::size_t part, const Members& m,
                 std::vector<ElementLocation>& locations);
  const model::Hourglass& hourglass_of(const model::Part& part) const;
  void make_groups(Findings& findings);
  void make_shells();
  /// `softening`: by shell; empty: none is softened.
  template <ShellKind Kind>
  void add_shells(std::size_t part, const std::vector<model::Index>& chosen,
                  const std::vector<weld::Softening>& softening);
  template <ShellKind Kind>
  void add_shells(std::size_t part, const std::vector<model::Index>& chosen, const weld::Softening& softening);
  void make_bricks();
  /// The different nodes of solids only; see model::Solids::different_nodes.
  Members different_nodes(const std::vector<model::Index>& solids) const;
  /// Solids of a part by the kernel that runs them; wedges of formulation 15 are among the fully integrated bricks.
  struct Formulations {
    std::vector<model::Index> quadratic, tetrahedra, full, others;
  };
  Formulations by_formulation(const std::vector<model::Index>& solids, int elform) const;
  void add_weld_bricks(std::size_t part, const std::vector<model::Index>& chosen,
                       const kernel::HexahedronProperties& brick, const kernel::Spotweld& law);
  /// By model element of a kind: whether SPOTSTP = 2 took its weld out; it then has no mass and no group.
  std::vector<bool> deleted_with_welds(bool bricks) const;
  /// DT of the weld material, and DT2MS for welds that are held by sheets, or not.
  void scale_weld_mass(ElementGroup& group, const kernel::Spotweld& law, bool held) const;
  void make_weld_beams(Findings& findings);
  void make_brick_joints();
  void make_springs();
  void add_beams(std::size_t part, const std::vector<model::Index>& chosen);
  void add_discrete_beams(std::size_t part, const std::vector<model::Index>& chosen, Findings& findings);
  /// `joints`: in series with the beams, by beam of the model; empty: none.
  void add_weld_beams(std::size_t part, const std::vector<model::Index>& chosen, bool torsion, bool held,
                      const std::vector<std::optional<kernel::WeldJoint>>& joints);

  void make_constraints(Findings& findings);
  void make_bodies();
  /// Adds the row by which `dependent`, at `place`, follows the rigid motion that fits that of `nodes` best.
  void add_best_fit(int dependent, bool rotations, std::span<const model::Index> nodes, std::span<const double> weights,
                    const Vec3d& place);
  /// Adds the row by which `dependent` follows the sheet of a tie at a distance `arm` from its foot.
  void add_tie(int dependent, const weld::Tie& tie, const Vec3d& arm, bool rotations);
  void assemble_mass();
  void link_slots();
  /// Forces of bodies and anchors begin at 0.
  void clear_virtual(std::span<Row> force, std::span<Row> moment) const;
  /// Sets the density factor of an element of group g and puts the change on its nodes.
  void set_mass_scale(std::size_t g, std::size_t e, double factor);
  void find_scaled_elements();
  /// What transfer_dependent_mass() does, after changes in the own masses of `changed_mass_`, which then has all nodes
  /// whose masses change by that.
  void transfer_changed_mass();

  std::vector<Vec3d> start_;  ///< positions at time 0, by system node; empty once all is made
  bool start_is_forgotten_ = false;
  bool elements_have_started_;
  /// Whether this process computes block b of group g.
  bool computes_block(std::size_t g, std::size_t b) const;
  /// What of a group goes with that.
  Carried carried_of(const ElementGroup& group, Carried what) const;
  std::vector<MassOnlyElement> mass_only_elements_;
  std::vector<double> own_inertia_;
  int mass_changes_ = 0;
  mutable Masses masses_;  ///< by the masses of then
  mutable int masses_are_of_ = -1;
  /// What makes a node dependent: a rigid body, a tie contact, an interpolation or a side of a shell of the model. Of
  /// nodes that are tied until the mesh tears all have it, the one that the others follow too.
  struct ConstraintSource {
    enum class Kind : unsigned char { none, body, contact, interpolation, side, tied };
    Kind kind = Kind::none;
    model::Index index = model::none;
    bool none() const { return kind == Kind::none; }
  };
  std::string name(const ConstraintSource& constraint_name) const;
  std::vector<ConstraintSource> constraint_source_;     ///< by system node
  std::vector<double> carried_mass_, carried_inertia_;  ///< own, and handed over by ties; also of nodes of bodies
  std::vector<int> linked_nodes_;                       ///< dependent ones and those they follow; empty: not known
  std::vector<int> changed_mass_;
  std::vector<std::vector<int>> scaled_elements_;  ///< by group

  Vec3d in_slot(std::size_t slot) const {
    return slot < slots_.size() ? slots_[slot] : single_slots_[slot - slots_.size()];
  }

  ElementPeriods periods_;
  Subcycles subcycles_;
  friend class Subcycles;
  Slots slots_;
  SingleSlots single_slots_;  ///< of groups of single precision, counted on behind slots_
  NodalSums sums_;
  std::vector<std::pair<int, std::size_t>> blocks_;  ///< all blocks of all groups, or of the share: group, block

  /// Elements deleted by their law, inverted ones and, where small steps delete, those with one, become known to all.
  void exchange_news();
  std::vector<std::pair<int, std::size_t>> steps_of_others_;  ///< elements with a step by the last exchange_news
  /// Deleted elements, by group, as far as all ranks know them.
  void note_deleted();
  void carry(int rank, Carried what, Parcel& parcel);
  void take_share_of_what_was_read();
  std::unique_ptr<Share> share_;
  std::unique_ptr<const SumsByRank> sums_by_rank_;
  std::vector<std::pair<int, std::size_t>> computed_;  ///< its blocks, in the order of groups
  std::vector<std::vector<char>> deleted_;             ///< known to all, by group and element
  std::vector<int> deletions_seen_;                    ///< by group: ElementGroup::deletions when `deleted_` was made
};

}  // namespace nugget::system
