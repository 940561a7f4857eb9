// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/archive.hpp"
#include "base/bvh.hpp"
#include "base/row.hpp"
#include "contact/contact_energies.hpp"
#include "contact/nodal_forces.hpp"
#include "contact/step.hpp"
#include "contact/surface.hpp"
#include "kernel/contact/penalty.hpp"

namespace nugget::contact {

/// What a penalty *CONTACT says, on plain arrays. Node numbers are positions in the arrays of `apply`. In a single
/// surface contact all is of side 1 and against side 1; of two sides, each node is against the segments of the other.
struct SurfaceContactSetup {
  std::vector<Segment> segments;
  std::vector<TrackedNode> nodes;  ///< see nodes_of(); nodes left out do not push
  /// Faces at nodes that are listed as such (a node set); they press nothing, glue takes the nodes' areas from them.
  std::vector<Segment> faces_at_nodes;
  double stiffness_scale = 0.1;  ///< SLSFAC
  kernel::PenaltyLaw law;        ///< SOFT, SOFSCL, VDC, friction
  double deepest = 0.0;          ///< PENMAX: a node deeper than so many thicknesses is released; 0: none
  bool edges_meet = false;       ///< an EdgeContact presses the free edges of shells apart
  double birth = 0.0, death = 1e20;
};

/// A tracked node that stands in the thickness of a segment.
struct Penetration {
  int node = 0;
  int segment = 0;     ///< position in the setup
  double depth = 0.0;  ///< by how much the surfaces overlap [length]
  Vec3d direction;     ///< unit vector along which the node leaves the segment by the shortest way
};

/// All overlaps of tracked nodes and segments at the coordinates `x`, by node in the order of the setup.
std::vector<Penetration> find_penetrations(const SurfaceContactSetup& setup, std::span<const Row> x);

/// Tracked nodes that stand deeper in a brick than its faces reach (pressing_depth), farthest in first: nothing presses
/// them.
std::vector<Penetration> find_nodes_out_of_reach(const SurfaceContactSetup& setup, std::span<const Row> x);

/// IGNORE = 0: moves tracked nodes out of the segments that they penetrate, in passes of half the depth each (the other
/// half is done by the nodes of the other side, or by the next pass), until none is deeper than 1e-3 of the thickness
/// or `passes` are done. Returns what find_penetrations() found before; what is still left the contact keeps as an
/// offset.
std::vector<Penetration> remove_penetrations(const SurfaceContactSetup& setup, std::span<Row> x, int passes = 20);

/// Penalty contact of a surface with itself, or of two surfaces with each other.
///
/// Geometry. A segment is the bilinear surface through its nodes, with a skin at half its thickness on both sides and
/// round edges of that radius (LS-DYNA's SHLEDG = 0); a tracked node carries half its own thickness. The pair overlaps
/// by depth = (t_node + t_segment)/2 - distance, the distance being that of the node from the closest point of the
/// segment, edges and corners included. A node is pressed by each segment at which its distance to the surface has a
/// local minimum: of segments that share nodes only the closest counts, and segments of the node's own neighbourhood
/// never do, however small they are against the thickness. So a node between two sheets feels both, and a flat sheet
/// does not fight itself.
///
/// Bricks. The face of a brick has no skin; a node behind it is inside, down to 0.3 of the brick's depth, and is
/// pressed out along the normal. Of the faces around an edge the closest counts; for a node that came in through a
/// body's side, being run over, the one that its own surface faces; see resolve_swept_nodes(). A node that is pressed
/// and slides out of the brick over an edge of the face gives its energy back on the way: it goes down a round edge,
/// see go_over_edges().
///
/// Edges. Where edges are checked against each other, a node of a free edge that comes to the free edge of another
/// sheet across it is left to these edges.
///
/// Sides. When a node first touches a segment, the side on which it stood a step earlier is kept until it leaves, and
/// handed on to the neighbour over whose edge it slides. So a node pressed beyond the mid-surface is pressed back, over
/// the edges and corners within a sheet as well. Off the end of a sheet and over a fold it is pressed away from the
/// edge, and may come to another side.
///
/// Initial overlaps (IGNORE = 1, 2, birth time, elements deleted) are kept as an offset that is given up as the pair
/// comes apart: a contact never starts with a force that no motion has worked against.
///
/// Force. k depth along the normal, k the smaller of the segment's and the node's stiffness (PENOPT = 1), with SOFT = 2
/// that of the two segments' masses, bounded by the stability limit of the step; see kernel/contact/penalty.hpp, also
/// for the first and the last cycle of a pair. What the node has is the mean of its segments'. Initial geometry.
///
/// Friction. A spring along the surface with the same k is drawn out as the foot moves over the segment, and slips at
/// the bound of kernel::Friction: f = f - k de, then |f| <= bound (theory manual, "Friction"). de is the way of the
/// foot over the material of the segment, so that turning together is no slip; the spring is handed on from segment to
/// segment. The force acts on the node and at the foot, half the thicknesses apart. That couple is not balanced but
/// with FTORQ: then the corners of the segment take it, see couple(). In the cycle of the touch: touch_friction().
///
/// Search. Each node lists the segments within contact distance plus a margin; the lists are renewed when two points of
/// the surface can have come closer than that margin, judged by the box of all displacements since. A pair found apart
/// is not checked until the steps taken since, each judged by the box of its displacements, can have closed the gap. No
/// contact is missed between searches and none depends on how often one searches.
///
/// Results are the same bits for any number of threads. No memory is taken between searches.
class SurfaceContact {
 public:
  /// A node that is pressed by a segment.
  struct Hit {
    int tracked = 0, segment = 0;    ///< places in the setup
    std::array<double, 4> weight{};  ///< of the segment's corners, at the foot
    Vec3d force;                     ///< on the node
    Vec3d friction;                  ///< its share
    double depth = 0.0;
  };

  /// `x`: initial coordinates, for stiffness and search margin.
  SurfaceContact(SurfaceContactSetup setup, std::span<const Row> x);

  /// Adds the contact forces at the end of a step to `force`, by node. Sign: forces that act on the nodes (an external
  /// force; the solver's a = (force - internal)/m).
  void apply(const Step& step, std::span<Row> force);

  /// Tracked nodes (in the order of the setup) that something else holds are not looked at while their entry is not 0;
  /// the vector must outlive the contact.
  void exclude(const std::vector<unsigned char>& excluded) { excluded_ = &excluded; }
  /// Elements were deleted and their faces exposed: the lists are made anew before the next forces.
  void surface_changed() { searched_ = false; }

  /// Sliding energy: stored in the penalty springs and dissipated by damping [energy]. It is minus the work of the
  /// contact forces, sum over steps of 1/2 (f_n + f_n+1) . v_n+1/2 dt, exactly what they take from the nodes' energy
  /// balance.
  double energy() const { return energy_[0] + energy_[1]; }
  /// Its shares: what the tracked side (SURFA) and what the reference side gave. In a single surface contact all is of
  /// the first.
  const std::array<double, 2>& energy_of_sides() const { return energy_; }
  /// What became of it.
  const ContactEnergies& energies() const { return energies_; }
  /// Force on the tracked side (SURFA) as a whole. In a single surface contact, where that is zero: the sum over the
  /// tracked nodes as such, without the reactions on segments [force].
  const Vec3d& resultant() const { return resultant_; }
  /// Sum of the forces on the nodes that are marked (by node; nodes beyond its end are not) [force].
  Vec3d force_on(std::span<const unsigned char> marked) const { return forces_.sum(marked); }
  /// Force on the first body by the second: the sum over those pairs that have one side in each [force].
  Vec3d force_between(const TwoBodies& bodies) const;
  int touching() const { return touching_; }  ///< pairs that carry force
  /// Visits the hits of this step, by tracked node and segment.
  template <class Visit>
  void each_hit(const Visit& visit) const {
    if (touching_ == 0) return;
    for (int b : active_blocks_)
      for (const Hit& hit : blocks_[b].hits) visit(hit);
  }
  double deepest() const { return deepest_; }  ///< largest depth that counts in a force [length]
  long searches() const { return searches_; }  ///< how often the lists were made
  std::size_t listed() const;                  ///< pairs in the lists

  void archive(Archive& a);

 private:
  /// A node and a segment that are near each other.
  struct Pair {
    int segment = 0;
    signed char side = 0;   ///< +1, -1: on which side of the segment's normal the node is kept; 0: not known
    bool touching = false;  ///< did so in the cycle before
    bool inside = false;    ///< behind a brick's face or a sheet's mid-surface then, or going out over its edge
    double xi = 0.0, eta = 0.0;
    double offset = 0.0;  ///< overlap that the pair came with and that gives no force [length]
    double depth = 0.0;   ///< overlap that does [length]
    Vec3d friction;       ///< force on the node along the surface [force]
    kernel::PairMemory memory;
    double next_check_travel = 0.0;  ///< before `travelled_` gets here the two cannot touch [length]

    bool pressed() const { return touching && memory.force > 0.0; }
    bool pressed_inside() const { return inside && pressed(); }
    /// What the spring holds [energy].
    double held() const { return 0.5 * memory.force * depth; }

    void release() {
      touching = inside = false;
      side = 0;
      offset = depth = 0.0;
      friction = {};
      memory = {};
    }
  };
  /// A pair close enough to be looked at in this cycle.
  struct Candidate {
    Pair* pair = nullptr;
    Pair before;  ///< the pair as the cycle before left it
    kernel::Foot foot;
    Vec3d away;                     ///< unit vector along which the node would leave
    double gap = 0.0;               ///< from the foot to the node, negative inside a brick [length]
    bool extended = false;          ///< behind the extension of a brick's face beyond its border
    bool to_an_edge = false;        ///< inside a brick, and an edge of the face is the closest way out
    bool over_an_edge = false;      ///< went from inside over an edge of the face, see go_over_edges()
    double came_from = 0.0;         ///< height above the brick's face at the start of the step [length]
    bool came_through = false;      ///< came through the brick's face in this step, from clearly before it, or under it
    double contact_distance = 0.0;  ///< distance at which the two touch
  };
  /// A fixed group of tracked nodes: what one thread works on at a time.
  struct Block {
    int begin = 0, end = 0;                 // tracked nodes
    std::vector<int> first;                 // of the pairs of each node
    std::vector<double> next_check_travel;  // of each node: the first of its pairs'
    std::vector<double> deep;               // of each node: how deep it was inside in the cycle before, if it was
    std::vector<Pair> pairs;                // by node, then by segment
    std::vector<int> old_first;             // the lists before the search
    std::vector<Pair> old_pairs;
    std::vector<Candidate> candidates;
    std::vector<Hit> hits;
    // Of the hits: their sum as it stands in rcforc, the deepest, and from where to where nodes take part in them.
    Vec3d resultant;
    double deepest = 0.0;
    int lowest = 0, highest = -1;
    ContactEnergies energies;  // what this cycle adds; of springs: what they hold
    void sum_up(const SurfaceContactSetup& setup, unsigned pressing);
    void archive(Archive& a);
  };
  static constexpr double side_change_cosine = 0.5;  // cosine from the side that is remembered, over an edge
  friend std::vector<Penetration> find_penetrations(const SurfaceContactSetup&, std::span<const Row>);
  friend std::vector<Penetration> find_nodes_out_of_reach(const SurfaceContactSetup&, std::span<const Row>);
  std::vector<Penetration> penetrations(std::span<const Row> x);

  bool alive(int segment, std::span<const unsigned char> element_alive) const {
    return is_exposed(setup_.segments[segment], element_alive);
  }
  bool node_alive(int node, std::span<const unsigned char> element_alive) const;
  double penalty(int segment, int tracked, const Step& step) const;
  double contact_distance(int tracked, int segment) const {
    return 0.5 * (setup_.nodes[tracked].thickness + setup_.segments[segment].thickness);
  }

  bool moved_too_far(std::span<const Row> x);
  template <class Displacement>
  double approach(const Displacement& displacement);
  double widest(int tracked) const { return 0.5 * (setup_.nodes[tracked].thickness + thickest_segment_); }
  void search(std::span<const Row> x, std::span<const unsigned char> element_alive);
  void list_neighbours(Block& block, std::span<const Row> x, std::span<const unsigned char> element_alive);
  void work(Block& block, const Step& step) const;
  void check_node(Block& block, int tracked, const Step& step) const;
  static std::span<const Pair> pairs_of(const Block& block, int tracked) {
    const int first = block.first[tracked - block.begin], last = block.first[tracked - block.begin + 1];
    return std::span(block.pairs).subspan(first, last - first);
  }
  void prefetch_segments(const Block& block, int tracked) const;
  void prefetch_corners(const Block& block, int tracked, const Step& step) const;
  void gather_candidates(Block& block, int tracked, const Step& step) const;
  void add_candidates(Block& block, std::span<Pair* const> near, int tracked, const Step& step) const;
  double reach(const Block& block, int tracked, int segment) const {
    return inner_[segment] + block.deep[tracked - block.begin];
  }
  void stay_inside(Block& block, int node, const Step& step) const;
  void go_over_edges(Block& block, int node, const Step& step) const;
  bool round_edge(Candidate& candidate, int side, const Vec3d& p, const Step& step) const;
  bool is_beyond(const Candidate& candidate, const Vec3d& r, const Step& step) const;
  bool is_free_edge(const Segment& segment, int corner, const Step& step) const;
  void drop_stray_candidates(Block& block, int node, const Step& step) const;
  void resolve_swept_nodes(Block& block, int node, const Step& step) const;
  double faces(int node, const Vec3d& normal, const Step& step) const;
  void measure_inside_brick(Candidate& candidate, double deepest, const Vec3d& p, const Step& step) const;
  bool outside_adjacent_face(const Candidate& candidate, const Vec3d& p, const Step& step) const;
  bool presses(const Block& block, const Candidate& candidate, int node, const Step& step) const;
  bool is_own_neighbourhood(const Candidate& candidate, int node, std::span<const unsigned char> element_alive) const;
  bool hidden_by(const Candidate& other, const Candidate& candidate) const;
  const Candidate* predecessor(const Block& block, const Candidate& candidate) const;
  int remembered_side(const Candidate& candidate, const Candidate* from) const;
  bool handled_by_edge_contact(const Candidate& candidate, int node, const Step& step) const;
  int side_over_edge(const Candidate& candidate, const Vec3d& was_at, const Step& step) const;
  Vec3d friction(const kernel::Friction& law, const Candidate& candidate, const Pair* before, const Vec3d& direction,
                 double stiffness, double normal_force, const Step& step) const;
  bool too_deep(double overlap, int segment) const;
  struct Spring {
    double inverse_mass = 0.0;  ///< of the mass that the pair moves
    double stiffness = 0.0;     ///< [force/length]
  };
  Spring spring(const Candidate& candidate, int tracked, const Step& step) const;
  void press(Block& block, Candidate& candidate, int tracked, const Step& step) const;
  bool has_parted(const Block& block, const Candidate& candidate) const;
  double part(Block& block, const Candidate& candidate, int tracked, const Step& step) const;
  bool is_handed_on(const Block& block, const Candidate& candidate) const;
  void book_drop(Block& block, const Candidate& candidate, int tracked, double given_back, const Step& step) const;
  void add_forces(const Step& step, std::span<Row> force);
  void update_energy(double dt, std::span<const Row> v);
  void next_cycle();

  SurfaceContactSetup setup_;
  NodeSegments around_;
  std::vector<double> segment_stiffness_;  // scaled
  std::vector<double> inner_;              // how deep inside its brick a segment still presses; 0: a shell
  std::vector<double> node_stiffness_;     // scaled, by tracked node
  std::vector<double> node_mass_;          // mean of its segments', by tracked node
  const std::vector<unsigned char>* excluded_ = nullptr;
  std::vector<char> stays_active_;  // by node: TrackedNode::stays
  double thickest_segment_ = 0.0;
  unsigned pressing_ = 0;  // sides whose segments press any node
  double margin_ = 0.0;

  NodalForces forces_;             // on all nodes of segments and all tracked nodes
  NodalForces frictions_;          // what of them is friction, if there is any
  std::vector<int> active_nodes_;  // those of them with active segments at the last search
  std::vector<Row> searched_at_;   // coordinates of active_nodes_ then
  bool searched_ = false;
  long searches_ = 0;
  std::vector<Row> seen_at_;          // coordinates of active_nodes_ in the cycle before
  double travelled_ = 0.0;            // by how much two points can have approached each other since the start, at most
  double searched_when_ = 0.0;        // travelled_ at the last search
  std::vector<Box> moved_;            // displacements of active_nodes_, by group of nodes
  std::vector<int> active_segments_;  // active segments at the last search
  std::vector<Box> boxes_;            // of these, with their skin
  BoxTree tree_;
  std::vector<Block> blocks_;
  std::vector<int> active_blocks_;  // blocks that have pairs

  std::array<double, 2> energy_{};
  ContactEnergies energies_;
  Vec3d resultant_;
  int touching_ = 0;
  double deepest_ = 0.0;
};

}  // namespace nugget::contact
