// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "base/bvh.hpp"
#include "base/row.hpp"
#include "contact/approach.hpp"
#include "contact/contact_energies.hpp"
#include "contact/nodal_forces.hpp"
#include "contact/step.hpp"
#include "contact/surface.hpp"
#include "kernel/contact/closest_edges.hpp"
#include "kernel/contact/penalty.hpp"

namespace nugget::contact {

/// Sine of the angle below which edges of surfaces lie beside each other: their nodes meet the other surface.
constexpr double side_by_side = 0.2;

/// A straight line between two nodes that must not pass through another: the edge of a shell or of a brick, or a beam.
struct Edge {
  std::array<int, 2> node{};
  double thickness = 0.0;     ///< of the round bar around it: the shell's, or the diameter of the beam [length]
  double stiffness = 0.0;     ///< penalty stiffness before scaling [force/length]
  double mass = 0.0;          ///< of the segments that it bounds, or of the beam; counts with SOFT = 2
  double scale = 1.0;         ///< of the stiffness by masses
  int kind = 0;               ///< of friction, as of Segment
  unsigned side = 1;          ///< as of Segment
  int part = -1;              ///< edges of one part, if it is not -1, never press each other
  std::vector<int> elements;  ///< the shells or bricks that have it, or the beam, as indices in `alive`
  std::vector<std::array<int, 2>> beyond;  ///< of a shell, by element: its nodes that are not on the edge
  std::vector<Segment> faces;  ///< of bricks: those that meet there, with those that others cover; empty: a round bar
  double depth = 0.0;          ///< of bricks: how deep another may stand in it and still be pressed out [length]
  bool of_surface = false;     ///< of segments that press the nodes of others of this kind, and the other way round

  bool has(int n) const { return node[0] == n || node[1] == n; }
};

/// The edges of the shells among the segments, each once, as thick, stiff and heavy as its shells in the mean; and
/// with `bricks` those of the faces of bricks that no shell has. Initial geometry `x`.
std::vector<Edge> edges_of(const std::vector<Segment>& segments, std::span<const Row> x, bool bricks = false);

struct EdgeContactSetup {
  std::vector<Edge> edges;       ///< all edges, interior ones too: they become exterior as shells are deleted
  bool interior = false;         ///< edges that more than one active shell has take part as well
  bool two_sides = false;        ///< edges of either side meet those of the other alone
  CommonPlaces places;           ///< edges that stand at one of these together never press each other
  double stiffness_scale = 0.1;  ///< SLSFAC
  kernel::PenaltyLaw law;
  double birth = 0.0, death = 1e20;
};

/// Penalty contact of edges with each other.
///
/// Geometry. An edge is a round bar. Two of them overlap by depth = (t_a + t_b)/2 - distance of their closest points.
/// A pair counts where this distance has a local minimum along the lines that the edges form: where a closest point is
/// the end of an edge, the pairs of the neighbours there count instead if they are closer, and edges that meet, or
/// belong to one element or Edge::part, never press each other. Of edges of shells that go straight on only the closest
/// of neighbouring pairs counts: lines that cross at a small angle have several minima once they bend.
///
/// Bricks. Their edges have no thickness. Two of them overlap, or one and a bar, where the closest points lie inside
/// both, along the common normal: where that stands in the angle between the outward normals of the two exposed faces
/// at an edge, grown by 0.1, and no deeper than 0.3 of the brick's depth. Where it does not, a node meets a face. An
/// edge between faces that stand at an inward angle meets nothing.
///
/// Nodes. Where edges of surfaces cross near an end of both, or lie along each other, it is the nodes that meet the
/// segments of the other surface. There the stiffness of the pair of edges fades to nothing, so that meshes that lie
/// corner over corner do not meet several times over. The share that a pair has once had it keeps until it leaves. Not
/// so two ridges of bricks, whose nodes have no face before them, nor where free edges of shells cross, whose nodes
/// SurfaceContact leaves to them.
///
/// Flat sheets. An edge of a surface presses as far as the faces beside it form a ridge towards the other edge. Those
/// of sheets that lie flat on each other overlap no deeper than the nodes do, which meet the segments, and add nothing.
///
/// What a pair remembers goes to one other as the crossing slides on, and to none while the pair itself goes on.
///
/// Sides. Of bars, the direction in which the first edge is pressed away from the second is that in which it stood when
/// they met, and turns with them. So an edge that came beyond the other is pressed back.
///
/// Forces are those of SurfaceContact: k depth, shared out to the ends of each edge by the lever rule, so that momentum
/// is kept; k of the softer edge, or by masses, bounded by the stability limit of the step; initial overlap gives no
/// force; friction by a spring that is drawn out as the closest points wander along both edges.
///
/// Results are the same bits for any number of threads. No memory is taken between searches but for the few pairs that
/// touch.
class EdgeContact {
 public:
  /// `x`: initial coordinates, for the margin of the search.
  EdgeContact(EdgeContactSetup setup, std::span<const Row> x);

  /// As SurfaceContact::apply; for the elements see Edge::elements.
  void apply(const Step& step, std::span<Row> force);
  /// Elements were deleted: the lists are made anew before the next forces.
  void surface_changed() { searched_ = false; }

  double energy() const { return energy_of_sides()[0] + energy_of_sides()[1]; }  ///< as SurfaceContact::energy()
  std::array<double, 2> energy_of_sides() const { return forces_.energy_of_sides(); }
  /// As SurfaceContact::energies().
  ContactEnergies energies() const {
    ContactEnergies all = energies_;
    all.friction = forces_.friction_energy();
    return all;
  }
  /// Force on the tracked side as a whole; zero where there are not two sides [force].
  const Vec3d& resultant() const { return resultant_; }
  const std::vector<int>& nodes() const { return forces_.nodes(); }  ///< all that it can press
  Vec3d force_on(std::span<const unsigned char> marked) const { return forces_.sum(marked); }
  Vec3d force_on(int node) const { return forces_.on(node); }
  unsigned char side(int node) const { return forces_.side(node); }
  bool presses(int node) const { return forces_.acts_on(node); }
  /// As SurfaceContact::force_between.
  Vec3d force_between(const TwoBodies& bodies) const;
  int touching() const { return static_cast<int>(touches_.size()); }  ///< pairs that touch
  double deepest() const { return deepest_; }                         ///< [length]
  long searches() const { return searches_; }

  void archive(Archive& a);

 private:
  struct Pair {
    int a = 0, b = 0;       // a < b
    bool touching = false;  // did so in the cycle before
    kernel::EdgeFeet feet;
    Vec3d direction;  // in which a is pressed away from b
    double offset = 0.0, depth = 0.0;
    Vec3d friction;  // on a
    kernel::PairMemory memory;
    double share = 1.0;              // of its stiffness, see share()
    Vec3d force;                     // on a, friction included
    double next_check_travel = 0.0;  // before the approach gets here the two cannot touch

    double held() const { return 0.5 * memory.force * depth; }  // by the spring
  };
  /// A pair that is close enough to touch, with what it was in the cycle before.
  struct Candidate {
    Pair* pair = nullptr;
    Pair before;
  };
  struct Block {
    int begin = 0, end = 0;  // edges
    std::vector<Pair> pairs;
    std::vector<Candidate> close;
    void archive(Archive& a);
  };

  bool takes_part(int edge, std::span<const unsigned char> alive) const;
  bool is_free(int edge, std::span<const unsigned char> alive) const;
  double sine_of_free(const Pair& pair, const Step& step) const;
  bool face_each_other(int a, int b) const;
  bool belong_together(int a, int b) const;
  double penalty(const Edge& e, const Edge& f, const Step& step) const;
  double contact_distance(int a, int b) const { return 0.5 * (setup_.edges[a].thickness + setup_.edges[b].thickness); }
  kernel::EdgeFeet feet_of(int a, int b, std::span<const Row> x) const;
  bool of_bricks(const Pair& pair) const {
    return !setup_.edges[pair.a].faces.empty() || !setup_.edges[pair.b].faces.empty();
  }
  /// How deep inside a brick the edges still press each other.
  double depth(int a, int b) const { return std::max(setup_.edges[a].depth, setup_.edges[b].depth); }
  Vec3d out_of_bricks(const Pair& pair, const Step& step) const;
  double sharpness(const Edge& edge, const Vec3d& toward, const Step& step) const;
  double share(const Pair& pair, const Step& step) const;
  void search(std::span<const Row> x, std::span<const unsigned char> alive);
  void list_neighbours(Block& block, const std::vector<int>& listed, const BoxTree& tree, std::span<const Row> x) const;
  void find_close(Block& block, const Step& step) const;
  std::span<const int> neighbours(int edge, double place) const;
  bool presses(const Candidate& candidate, std::span<const Row> x) const;
  bool another_stretch_is_closer(const Pair& pair, std::span<const Row> x) const;
  const Pair* close_pair(int a, int b) const;
  bool closer(int a, int b, const Candidate& than) const;
  Pair predecessor(const Candidate& candidate);
  Vec3d direction(const Pair& pair, const Pair& before, const Vec3d& was_at, std::span<const Row> x) const;
  Vec3d friction(const kernel::Friction& law, const Pair& pair, const Pair& before, double stiffness,
                 double normal_force, const Step& step) const;
  void press(const Candidate& candidate, const Step& step);
  void book_drops(const Step& step);
  void balance(const Pair& pair, const Step& step);
  void add(int node, const Vec3d& force, const Vec3d& friction);

  EdgeContactSetup setup_;
  std::vector<int> first_at_, edge_at_;  // edges at each node
  double margin_ = 0.0;
  Approach approach_;
  bool searched_ = false;
  long searches_ = 0;
  std::vector<char> active_;  // by edge, at the last search
  std::vector<Block> blocks_;
  std::vector<const Candidate*> close_;         // of all blocks, by a, then b
  std::vector<Pair> touches_, touched_before_;  // pairs that touch, in this order
  NodalForces forces_;
  ContactEnergies energies_;  // but that of friction
  Vec3d resultant_;
  double deepest_ = 0.0;
};

}  // namespace nugget::contact
