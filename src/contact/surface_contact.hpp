// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "base/bvh.hpp"
#include "base/row.hpp"
#include "base/runs.hpp"
#include "base/zeroed.hpp"
#include "contact/contact_energies.hpp"
#include "contact/nodal_forces.hpp"
#include "contact/step.hpp"
#include "contact/surface.hpp"
#include "kernel/contact/penalty.hpp"
#include "system/ghost_nodes.hpp"
#include "system/parcel.hpp"

namespace nugget::system {
struct ContactCosts;
}  // namespace nugget::system

namespace nugget::contact {

struct DividedSurface;  // surface_part.hpp

/// What is known of a whole surface where a setup holds some of its segments and tracked nodes only.
struct SurfaceOutline {
  std::size_t segments = 0;
  std::vector<unsigned char> sides;  ///< by node: of the segments at it, as bits of Segment::side
  std::vector<int> tracked;          ///< tracked nodes, ascending
  std::vector<char> stays_active;    ///< by node: TrackedNode::stays_active; empty: none does
  double thickest_node = 0.0;        ///< no tracked node has a larger contact thickness [length]
  unsigned pressing = 0;             ///< sides whose segments press any tracked node
  bool covers = false;               ///< some segments are exposed by the deletion of elements
};

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
  CommonPlaces places;           ///< a node is not pressed by segments that stand at one of these with it
  double birth = 0.0, death = 1e20;
  // Of the surface that this is a part of (part_of); of a whole one they follow from the segments.
  double margin = 0.0;  ///< of its search, see search_margin() [length]
  /// Where it holds some segments and tracked nodes, as a SurfaceChoice asks for: the whole surface, and which of its
  /// segments these are, rising.
  std::optional<SurfaceOutline> whole;
  std::vector<int> number;
};

/// Which segments and tracked nodes of a surface a setup is to hold.
struct SurfaceChoice {
  /// Asked once for each segment of the surface in order, while its side may be that of the first of two alone.
  std::function<bool(const Segment&)> segment;
  std::function<bool(int node)> tracked;
};
/// Makes the setup of a surface with what is chosen; a node's thickness comes from the chosen segments at it.
using SurfaceSource = std::function<SurfaceContactSetup(const SurfaceChoice&)>;

/// By how much more than the contact distance segments are looked for around a node, with the nodes at `x`: a quarter
/// of an element, so that few pairs are listed in vain and a search lasts some hundred cycles at crash speeds [length].
double search_margin(const SurfaceContactSetup& setup, std::span<const Row> x);

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
/// offset. `divided`: all ranks do it together, the setup is the part of this one, and nodes move in the `x` of all.
std::vector<Penetration> remove_penetrations(const SurfaceContactSetup& setup, std::span<Row> x, int passes = 20,
                                             const DividedSurface* divided = nullptr);

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
/// Results are the same bits for any number of threads.
///
/// Layout. Tracked nodes stand in blocks, which the threads take one after the other. In a cycle a block lists the
/// pairs that are awake, projects them a register full at a time, whosever they are, and then looks at each of its
/// nodes. Of a node that touches most other pairs are hidden: they are not projected, see decision 0156. The lists of
/// pairs, the longest, hold 32 bytes a pair; what a pair that touches remembers stands apart. Of a segment one line of
/// the cache is read. The forces are spread to the nodes by parts of these; see decision 0092.
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

  /// `x`: initial coordinates, for stiffness and search margin. A setup with an outline of the whole surface gives that
  /// alone: segments and tracked nodes come with add_costs and take_share (docs/decisions/0141).
  SurfaceContact(const SurfaceContactSetup& setup, std::span<const Row> x) : SurfaceContact(setup, x, nullptr) {}
  /// Sets the segments and nodes of the setup free while it makes its own.
  SurfaceContact(SurfaceContactSetup&& setup, std::span<const Row> x) : SurfaceContact(setup, x, &setup) {}

  /// Adds the contact forces at the end of a step to `force`, by node. Sign: forces that act on the nodes (an external
  /// force; the solver's a = (force - internal)/m).
  void apply(const Step& step, std::span<Row> force);

  /// Adds about what each node costs in a cycle, in pairs that rest, at the start: by lists that are made at the places
  /// `x`, and set free again. A contact with a birth time costs nothing. `ranks`: all of them ask, each looks at some
  /// blocks, and the first one gets the costs; null: this process looks at all. `source`: of this surface, where it was
  /// made by its outline alone.
  void add_costs(std::span<const Row> x, system::ContactCosts& costs, Ranks* ranks, const SurfaceSource& source = {});
  /// The same in the course of a run, by the lists that are there. `nodes`: of the system.
  void add_costs_now(std::size_t nodes, system::ContactCosts& costs, Ranks* ranks) const;
  /// Over several ranks, before the first step that they share: who does what from now on. All ranks call it. `source`
  /// as in add_costs.
  void take_share(const SharedNodes& shared, const SurfaceSource& source = {});
  /// Over several ranks (Step::shared): what results show of the blocks of a rank and of the nodes for which it
  /// answers, on its way to another one.
  void carry(int rank, system::Carried what, system::Parcel& parcel);
  /// Results are to show force_on() or force_between(): of several ranks the first one gets the hits of all.
  void keep_hits_for_results() { results_need_hits_ = true; }

  /// Over several ranks all add up all forces of this contact, and follow all its nodes: something else looks at them.
  void look_everywhere() { looks_everywhere_ = true; }
  bool looks_everywhere() const { return looks_everywhere_; }
  const std::vector<int>& nodes() const { return forces_.nodes(); }  ///< all that it can press

  /// Tracked nodes (in the order of the setup) that something else holds are not looked at while their entry is not 0;
  /// the vector must outlive the contact.
  void exclude(const std::vector<unsigned char>& excluded) { excluded_ = &excluded; }
  /// Elements were deleted and their faces exposed: the lists are made anew before the next forces.
  void surface_changed() { searched_ = false; }

  /// Sliding energy: stored in the penalty springs and dissipated by damping [energy]. It is minus the work of the
  /// contact forces, sum over steps of 1/2 (f_n + f_n+1) . v_n+1/2 dt, exactly what they take from the nodes' energy
  /// balance.
  double energy() const { return energy_of_sides()[0] + energy_of_sides()[1]; }
  /// Its shares: what the tracked side (SURFA) and what the reference side gave. In a single surface contact all is of
  /// the first.
  std::array<double, 2> energy_of_sides() const { return forces_.energy_of_sides(); }
  /// What became of it.
  ContactEnergies energies() const;
  /// Force on the tracked side (SURFA) as a whole. In a single surface contact, where that is zero: the sum over the
  /// tracked nodes as such, without the reactions on segments [force].
  Vec3d resultant() const;
  /// The same where several ranks look at the pairs, each at some: on all of them, and all must ask.
  Vec3d resultant_of_all_ranks() const;
  /// Sum of the forces on the nodes that are marked (by node; nodes beyond its end are not) [force].
  Vec3d force_on(std::span<const unsigned char> marked) const;
  Vec3d force_on(int node) const { return forces_.on(node); }        ///< [force]
  unsigned char side(int node) const { return forces_.side(node); }  ///< of one of nodes(): 0 tracked, 1 reference
  bool presses(int node) const { return forces_.acts_on(node); }     ///< a force of this cycle acts on the node
  /// Force on the first body by the second: the sum over those pairs that have one side in each [force].
  Vec3d force_between(const TwoBodies& bodies) const;
  int touching() const;  ///< pairs that carry force
  /// Visits the hits of this step, by tracked node and segment.
  template <class Visit>
  void each_hit(const Visit& visit) const {
    if (!acts_) return;
    for (const Block& block : blocks_)
      for (const Hit& hit : block.hits) visit(hit);
  }
  double deepest() const;                      ///< largest depth that counts in a force [length]
  long searches() const { return searches_; }  ///< how often the lists were made
  std::size_t listed() const;                  ///< pairs in the lists
  /// Segments that this process holds: all, but for ranks that hold them by share.
  std::size_t held() const { return holds_some() ? held_.size() : faces_.size(); }

  void archive(Archive& a);

 private:
  /// What the passes over pairs read of a segment: one line of the cache.
  struct alignas(64) Face : Facet {
    double thickness = 0.0;
    double stiffness = 0.0;  ///< scaled; with SOFT = 2 what scales that by masses [1]
    double mass = 0.0;       ///< counts with SOFT = 2
    double inner = 0.0;      ///< how deep inside its brick it still presses; 0: a shell
    int element = -1, covered_by = -1, kind = 0;
    unsigned char side = 1;
    bool of_brick = false;
  };
  /// The same of a tracked node.
  struct Tracked {
    int node = 0, kind = 0;
    double thickness = 0.0;
    double stiffness = 0.0;  ///< mean of its segments', scaled; with SOFT = 2 the mean of their masses
    unsigned against = 1;
  };
  /// A node and a segment that are near each other.
  struct Pair {
    unsigned segment : 31 = 0;
    unsigned near_own : 1 = 0;  ///< the segment has a corner of one of the node's own
    int touch = none;           ///< place of what it remembers, while it touches
    double xi = 0.0, eta = 0.0;
    double next_check_travel = 0.0;  ///< before `travelled` of the block gets here the two cannot touch [length]
  };
  static constexpr int none = -1;
  /// What a pair that touches remembers from cycle to cycle.
  struct Touch {
    double xi = 0.0, eta = 0.0;
    double offset = 0.0;  ///< overlap that the pair came with and that gives no force [length]
    double depth = 0.0;   ///< overlap that does [length]
    Vec3d friction;       ///< force on the node along the surface [force]
    kernel::PairMemory memory;
    int segment = 0;
    signed char side = 0;   ///< +1, -1: on which side of the segment's normal the node is kept; 0: not known
    bool touching = false;  ///< false: a pair that does not
    bool inside = false;    ///< behind a brick's face or a sheet's mid-surface, or going out over its edge

    bool pressed() const { return touching && memory.force > 0.0; }
    bool pressed_inside() const { return inside && pressed(); }
    /// What the spring holds [energy].
    double held() const { return 0.5 * memory.force * depth; }
  };
  /// A pair close enough to be looked at in this cycle.
  struct Candidate {
    Pair* pair = nullptr;
    int segment = 0;
    Touch before;  ///< the pair as the cycle before left it
    kernel::Foot foot;
    Vec3d away;                     ///< unit vector along which the node would leave
    double gap = 0.0;               ///< from the foot to the node, negative inside a brick [length]
    bool extended = false;          ///< behind the extension of a brick's face beyond its border
    bool to_an_edge = false;        ///< inside a brick, and an edge of the face is the closest way out
    bool over_an_edge = false;      ///< went from inside over an edge of the face, see go_over_edges()
    double came_from = 0.0;         ///< height above the brick's face at the start of the step [length]
    bool came_through = false;      ///< came through the brick's face in this step, from clearly before it, or under it
    double contact_distance = 0.0;  ///< distance at which the two touch

    bool touching() const { return pair->touch != none; }  ///< in this cycle
  };
  /// Those of one node.
  using Candidates = std::span<Candidate>;
  /// Places in NodalForces of the node that is hit and of the corners of the segment, -1 where nothing is to be added.
  using Places = std::array<int, 5>;
  /// The pairs of a block that can touch in this cycle. Those of a node that did not touch in the cycle before wait for
  /// those that did, which hide most of them: see let_hidden_sleep().
  struct Awake {
    struct Node {
      int tracked = 0;
      std::size_t end = 0;        ///< of its pairs
      double asleep_until = 0.0;  ///< `next_check_travel` of the first of those that are not awake
      std::size_t touching = 0;   ///< of its pairs those for which the others wait
    };
    struct One {
      int pair = 0;  ///< its place in the block
      int node = 0;  ///< its node
      int turn = 0;  ///< where its foot stands in Work::feet; none: it waits, or is hidden
    };
    std::vector<Node> nodes;
    std::vector<One> pairs;
    std::vector<int> order;  ///< in which those that do not wait are projected: those with a foot inside first
  };
  struct Work;
  /// A fixed group of tracked nodes: what one thread works on at a time.
  struct Block {
    int begin = 0, end = 0;     // tracked nodes
    double travelled = 0.0;     // by how much two points of its pairs can have approached each other, at most [length]
    std::vector<int> near;      // the nodes of its pairs: tracked ones and corners; since the last search
    std::vector<Vec3d> seen;    // where they were in the cycle before
    double asleep_until = 0.0;  // the first of `next_check_travel`
    std::vector<int> first;     // of the pairs of each node; empty before its first search
    std::vector<double> next_check_travel;  // of each node: the first of its pairs'; empty likewise
    // Of each node: the largest distance at which one of its pairs touches; empty likewise. One that does not touch,
    // but is closer, may hide one that would.
    std::vector<double> widest;
    std::vector<double> deep;    // of each node: how deep it was inside in the cycle before, if it was; empty: none was
    std::vector<Pair> pairs;     // by node, then by segment
    std::vector<Touch> touches;  // of pairs, where Pair::touch says
    std::vector<int> free;       // of these, those that no pair has
    std::vector<Hit> hits;
    std::vector<Places> places;  // of the hits
    std::vector<int> parts;      // of the nodes: those in which they are, in the order in which they are met
    // Of the hits: their sum as it stands in rcforc, the deepest.
    Vec3d resultant;
    double deepest = 0.0;
    ContactEnergies energies;  // so far; of springs: what they hold now; that of friction stands with the nodes

    double widest_of(int tracked) const { return widest[tracked - begin]; }
    double depth_of(int tracked) const { return deep.empty() ? 0.0 : deep[tracked - begin]; }
    const Touch* touch_of(const Pair& pair) const { return pair.touch == none ? nullptr : &touches[pair.touch]; }
    bool pressed(const Pair& pair) const { return pair.touch != none && touches[pair.touch].pressed(); }
    void release(Pair& pair);
    Touch& touch(Pair& pair);
    void clear_hits();
    void archive(Archive& a);
  };
  /// `given`: null, or the setup.
  SurfaceContact(const SurfaceContactSetup& setup, std::span<const Row> x, SurfaceContactSetup* given);
  static constexpr double side_change_cosine = 0.5;  // cosine from the side that is remembered, over an edge
  friend std::vector<Penetration> find_penetrations(const SurfaceContactSetup&, std::span<const Row>);
  friend std::vector<Penetration> find_nodes_out_of_reach(const SurfaceContactSetup&, std::span<const Row>);
  friend std::vector<Penetration> remove_penetrations(const SurfaceContactSetup&, std::span<Row>, int,
                                                      const DividedSurface*);
  std::vector<Penetration> penetrations(std::span<const Row> x);
  void find_overlaps(Block& block, const Step& step, std::vector<Penetration>& found) const;

  /// Kept between the tasks of a thread.
  static Work& work_of_thread();
  bool alive(int segment, std::span<const unsigned char> element_alive) const {
    return is_exposed(faces_[segment], element_alive);
  }
  bool node_alive(int node, std::span<const unsigned char> element_alive) const;
  double penalty(int segment, int tracked, const Step& step) const;
  double contact_distance(int tracked, int segment) const {
    return 0.5 * (nodes_[tracked].thickness + faces_[segment].thickness);
  }

  Face face_of(const Segment& segment, double stiffness_scale, std::span<const Row> x) const;
  Tracked tracked_of(const TrackedNode& node) const;
  void make_blocks(std::size_t tracked);
  /// Whether it has some segments, or none as yet, of which `held_` are here.
  bool holds_some() const { return by_share_ || outline_ != nullptr; }
  int tracked_node(int tracked) const {
    return outline_ != nullptr ? outline_->tracked[tracked] : nodes_[tracked].node;
  }
  void fill(const SurfaceContactSetup& part, std::span<const Row> x);
  void fill_near_own_blocks(const SurfaceSource& source, std::span<const Row> x);
  void fill_share(const SurfaceSource& source, std::span<const Row> x);
  static void leave(Block& block);
  Box over_all_ranks(const Box& own) const;
  void list_followed_nodes();
  void hold_what_was_read();
  /// What nodes of some blocks cost, and those that rest on each other.
  struct OwnCosts {
    struct OfNode {
      int node = 0;
      double value = 0.0;
    };
    std::vector<OfNode> of_nodes;
    std::vector<std::array<int, 2>> pairs;
  };
  bool costs_something() const;
  template <class IsAwake, class Touches>
  OwnCosts costs_of_own_blocks(const IsAwake& is_awake, const Touches& touches) const;
  static void add_to_first(OwnCosts own, system::ContactCosts& costs, Ranks* ranks);
  std::function<int(std::size_t)> giver_of_places() const;
  Archive::Holders holders_of_active_nodes() const;
  Archive::Holders holders_of_blocks() const;
  void hold(std::vector<int> segments);
  void list_active_nodes(const Step& step);
  std::vector<int> fetch_segments_near(const Step& step);
  void hold_segments_of_pairs();
  void list_all(std::span<const Row> x, std::span<const unsigned char> element_alive);
  /// Coordinates of active_nodes_, over several ranks of those that this one follows.
  ZeroedVector<Vec3d> places_of_active_nodes(std::span<const Row> x) const;
  void ask_for_ghosts();
  void list_active_blocks();
  bool moved_too_far(std::span<const Row> x);
  bool lists_are_good_for(std::span<const Row> x);
  template <class Displacement>
  double approach(const Displacement& displacement);
  void search(const Step& step);
  static void follow(Block& block, std::span<const Row> x);
  void list_near(Block& block, std::span<const Row> x) const;
  void forget_lists();
  Box box_of_own_blocks(std::span<const Row> x) const;
  /// Whether this process looks at a block.
  bool computes(std::size_t block) const { return rank_of_block_.empty() || rank_of_block_[block] == rank_; }
  void exchange_hits();
  void put_hits(int block);
  void list_neighbours(Block& block, const BoxTree& tree, Work& work, std::span<const Row> x,
                       std::span<const unsigned char> element_alive) const;
  Box around(const Block& block, int tracked, const Vec3d& p) const;
  int find_around(const Block& block, int first, const BoxTree& tree, Work& work, std::span<const Row> x) const;
  static Box box_of(const Face& face, std::span<const Row> x);
  bool is_near_own(int node, const Facet& segment) const;
  void look_at(std::size_t begin, std::size_t end, Work& work, const Step& step);
  void look_at(Block& block, Work& work, const Step& step) const;
  void ask_for(const Block& block) const;
  void ask_for_touching(const Block& block, const Awake& awake, std::size_t begin, std::size_t end,
                        const Step& step) const;
  void wake(const Block& block, Awake& awake) const;
  void project(const Block& block, Work& work, const Step& step) const;
  void project(const Block& block, Work& work, const std::vector<int>& order, const Step& step) const;
  void let_hidden_sleep(Block& block, Work& work, const Step& step) const;
  void wake_all(Block& block, int tracked) const;
  void check_node(Block& block, Candidates candidates, int tracked, const Step& step) const;
  Candidates gather_candidates(Block& block, Work& work, const Awake::Node& node, std::size_t first,
                               const Step& step) const;
  static double reach_ahead(Candidates candidates);
  void fill(Candidate& candidate, const Block& block, Pair& pair, const Work& work, std::size_t turn, int tracked,
            const Step& step) const;
  double reach(const Block& block, int tracked, int segment) const {
    return faces_[segment].inner + block.depth_of(tracked);
  }
  void stay_inside(Candidates candidates, int node, const Step& step) const;
  void go_over_edges(Candidates candidates, int node, const Step& step) const;
  bool round_edge(Candidate& candidate, int side, const Vec3d& p, const Step& step) const;
  bool is_beyond(const Candidate& candidate, const Vec3d& r, const Step& step) const;
  bool is_free_edge(const Facet& segment, int corner, const Step& step) const;
  void drop_stray_candidates(Candidates candidates, int node, const Step& step) const;
  void resolve_swept_nodes(Candidates candidates, int node, const Step& step) const;
  double faces(int node, const Vec3d& normal, const Step& step) const;
  void measure_inside_brick(Candidate& candidate, double deepest, const Vec3d& p, const Step& step) const;
  bool outside_adjacent_face(const Candidate& candidate, const Vec3d& p, const Step& step) const;
  bool presses(Candidates candidates, const Candidate& candidate, int node, const Step& step) const;
  bool is_own_neighbourhood(const Candidate& candidate, int node, std::span<const unsigned char> element_alive) const;
  bool hidden_by(const Candidate& other, const Candidate& candidate) const;
  bool in_one_place(const Candidate& a, const Candidate& b) const;
  bool goes_before(const Candidate& a, const Candidate& b) const;
  const Candidate* predecessor(Candidates candidates, const Candidate& candidate) const;
  int remembered_side(const Candidate& candidate, const Candidate* from) const;
  bool handled_by_edge_contact(const Candidate& candidate, int node, const Step& step) const;
  int side_over_edge(int segment, const Vec3d& normal, unsigned boundary, const Vec3d& was_at, const Step& step) const;
  Vec3d friction(const kernel::Friction& law, const Candidate& candidate, const Touch& before, const Vec3d& direction,
                 double stiffness, double normal_force, const Step& step) const;
  bool too_deep(double overlap, int segment) const;
  struct Spring {
    double inverse_mass = 0.0;  ///< of the mass that the pair moves
    double stiffness = 0.0;     ///< [force/length]
  };
  Spring spring(const Candidate& candidate, int tracked, const Step& step) const;
  void press(Block& block, Candidates candidates, const Candidate& candidate, int tracked, const Step& step) const;
  void press_alone(Block& block, Work& work, int tracked, const Step& step) const;
  bool has_parted(Candidates candidates, const Candidate& candidate) const;
  double part(Block& block, const Candidate& candidate, int tracked, const Step& step) const;
  bool is_handed_on(Candidates candidates, const Candidate& candidate) const;
  void book_drop(Block& block, Candidates candidates, const Candidate& candidate, int tracked, double given_back,
                 const Step& step) const;
  void sum_up(Block& block) const;
  void share_out(Block& block) const;
  void spread(std::size_t part, const Step& step);
  void add_forces(const Step& step, std::span<Row> force);

  kernel::PenaltyLaw law_;
  double deepest_allowed_ = 0.0, birth_ = 0.0, death_ = 0.0;
  bool edges_meet_ = false, covers_ = false;  // covers_: deleted elements expose segments
  CommonPlaces places_;
  // The segments and the tracked nodes. Of several ranks each holds those that it looks at; of others all is 0.
  ZeroedVector<Face> faces_;
  ZeroedVector<Tracked> nodes_;
  NodeSegments around_;
  std::unique_ptr<const SurfaceOutline> outline_;  // of a surface that has no segments as yet; else null
  const std::vector<unsigned char>* excluded_ = nullptr;
  std::vector<char> stays_active_;  // by node: TrackedNode::stays_active
  unsigned pressing_ = 0;           // sides whose segments press any node
  double margin_ = 0.0;

  NodalForces forces_;             // on all nodes of segments and all tracked nodes
  std::vector<int> active_nodes_;  // those of them with active segments at the last search
  // Coordinates of active_nodes_ then; over several ranks of those that this one follows.
  ZeroedVector<Vec3d> searched_at_;
  bool searched_ = false;
  long searches_ = 0;
  ZeroedVector<Vec3d> seen_at_;  // the same in the cycle before
  double travelled_ = 0.0;       // by how much two points can have approached each other in all cycles, at most
  double searched_when_ = 0.0;   // travelled_ at the last search
  std::vector<Box> moved_;       // displacements of active_nodes_, by group of nodes
  std::vector<Block> blocks_;
  std::vector<int> active_blocks_;         // blocks that have pairs and that this process looks at
  std::vector<std::vector<int>> sources_;  // of forces, by part of the nodes: blocks
  bool acts_ = false;                      // in the last cycle, by birth and death
  bool results_need_hits_ = false;
  // Over several ranks, of which each looks at some of the blocks:
  const system::Share* share_ = nullptr;  // null: one process
  int rank_ = 0;
  std::vector<int> rank_of_block_;
  bool looks_everywhere_ = false;
  std::vector<char> others_add_;  // by place in forces_: other ranks add up the forces on the node
  std::vector<char> at_border_;   // by block: some of its pairs touch such nodes
  std::vector<int> arrived_;      // blocks whose hits in this cycle came from others, rising
  std::vector<int> followed_;     // places in active_nodes_ of nodes that this rank follows
  bool by_share_ = false;         // segments and tracked nodes are held by share
  std::vector<int> held_;         // then: segments that are here, rising
  std::vector<int> at_own_;       // of them those at nodes whose forces this rank adds up, and at those of its blocks
  std::vector<int> boxed_;        // of them those whose boxes it makes for all
  system::GhostNodes tracked_ghosts_;  // tracked nodes of its blocks
  system::GhostNodes ghosts_;
  std::vector<Runs> answered_;                    // by rank: places in forces_ of the nodes for which it answers
  std::vector<int> rank_of_part_;                 // of forces_: who books the work on all its nodes
  std::vector<std::vector<std::byte>> out_, in_;  // hits for, and of, each rank; they keep their room
  std::vector<std::vector<int>> hits_for_;        // by rank: those of the block that is looked at
};

}  // namespace nugget::contact
