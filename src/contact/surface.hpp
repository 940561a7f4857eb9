// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "base/row.hpp"
#include "kernel/contact/closest_point.hpp"
#include "kernel/contact/penalty.hpp"

namespace nugget::contact {

/// The corners of a segment.
struct Facet {
  std::array<int, 4> node{};  ///< a triangle repeats its third node

  bool triangle() const { return node[3] == node[2]; }
  int corners() const { return triangle() ? 3 : 4; }
  bool has(int n) const { return node[0] == n || node[1] == n || node[2] == n || node[3] == n; }
};

/// A facet of a contact surface: a shell, or the face of a brick.
struct Segment : Facet {
  double thickness = 0.0;     ///< contact thickness, scale factors applied; 0 for the face of a brick [length]
  double bulk_modulus = 0.0;  ///< K = E/(3(1-2 nu)), times SSF of *PART_CONTACT and SFSA or SFSB [stress]
  double volume = 0.0;        ///< of the brick behind the face; 0: a shell [length^3]
  double mass = 0.0;          ///< of the shell, or half that of the brick; counts with SOFT = 2
  double scale = 1.0;         ///< what bulk_modulus is scaled by, for the stiffness that does not come from it
  int element = -1;     ///< whose deletion ends the segment, as an index in `element_alive`; -1: it is never deleted
  int covered_by = -1;  ///< the brick on the other side of the face: only its deletion exposes the segment
  int kind = 0;         ///< of its part, in the contact's kernel::FrictionTable
  unsigned side = 1;    ///< of the contact: bit 0 the tracked side (SURFA), bit 1 the reference side (SURFB)
};

/// By node: which of the places it stands at where nodes of several elements are tied until the mesh tears, -1: at
/// none. Empty: there are none. What stands at one of them is no stranger to what else does, tied or torn.
using CommonPlaces = std::vector<int>;
inline bool at_one_place(const CommonPlaces& places, int a, int b) {
  return !places.empty() && places[a] >= 0 && places[a] == places[b];
}
/// Whether any corner of a facet stands at one place with the node.
inline bool meets_at_place(const CommonPlaces& places, const Facet& facet, int n) {
  return !places.empty() && (at_one_place(places, facet.node[0], n) || at_one_place(places, facet.node[1], n) ||
                             at_one_place(places, facet.node[2], n) || at_one_place(places, facet.node[3], n));
}

/// How deep into a brick its face presses a node out again, as a share of the brick's depth.
inline constexpr double pressing_depth = 0.3;

/// Whether a place is still a number (that of a run that diverges is none).
inline bool finite(const Row& r) {
  return std::isfinite(r.x + r.y + r.z);
}

/// Whether the segment is there, by its `element` and what it is `covered_by`. `element_alive`: by element; empty: all
/// are active.
template <class OfElement>
bool is_exposed(const OfElement& s, std::span<const unsigned char> element_alive) {
  if (element_alive.empty()) return s.covered_by < 0;
  return (s.element < 0 || element_alive[s.element]) && (s.covered_by < 0 || !element_alive[s.covered_by]);
}

/// A node that must not pass through the segments.
struct TrackedNode {
  int node = 0;
  double thickness = 0.0;     ///< contact thickness: the mean of the adjoining segments' [length]
  unsigned against = 1;       ///< the sides whose segments press it, by the bits of Segment::side
  bool stays_active = false;  ///< it is pressed even when all its segments are deleted
  int kind = 0;               ///< as of Segment, where no segment of the contact is at it
};

/// The nodes of the segments of `side`, ascending, each with the mean thickness of these segments; to be pressed by
/// those of the sides `against`.
std::vector<TrackedNode> nodes_of(const std::vector<Segment>& segments, unsigned side = 1, unsigned against = 1);

kernel::Corners corners_of(const Facet& facet, std::span<const Row> x);
double area(const Facet& facet, std::span<const Row> x);
/// Sum of the rows of the corners, each with its weight.
inline Vec3d interpolate(const Facet& facet, const std::array<double, 4>& weight, std::span<const Row> rows) {
  FourReals sum{};
  for (int c = 0; c < facet.corners(); ++c) sum += weight[c] * four(rows[facet.node[c]]);
  Row row;
  set(row, sum);
  return vec(row);
}
/// Penalty stiffness of the segment before scaling; see kernel/contact/penalty.hpp. 0 for a segment without area.
double penalty_stiffness(const Segment& segment, std::span<const Row> x);

/// +1 if the right-hand normals of two segments that share an edge lie on the same side of the surface that they form,
/// -1 if on opposite sides, 0 if they share no edge.
int same_side(const Facet& a, const Facet& b);

/// The kind that most of these are, the lowest of equally many; 0 of none. Sorts them.
int commonest(std::span<int> kinds);
/// Which segments stand at a node.
class NodeSegments {
 public:
  NodeSegments() = default;
  explicit NodeSegments(const std::vector<Segment>& segments);
  /// Those of `all`, which are Facets, whose numbers are in `which`, rising.
  template <class Facets>
  NodeSegments(const Facets& all, std::span<const int> which) {
    int highest = -1;
    const auto each_corner = [&](const auto& visit) {
      for (const int s : which)
        for (int c = 0; c < all[s].corners(); ++c) visit(all[s].node[c], s);
    };
    each_corner([&](int n, int) { highest = n > highest ? n : highest; });
    first_.assign(static_cast<std::size_t>(highest) + 3, 0);
    // Counted two places on, so that in the end each place holds where its node's segments begin.
    each_corner([&](int n, int) { ++first_[n + 2]; });
    for (std::size_t n = 1; n < first_.size(); ++n) first_[n] += first_[n - 1];
    segment_.resize(static_cast<std::size_t>(first_.back()));
    each_corner([&](int n, int s) { segment_[first_[n + 1]++] = s; });
    first_.pop_back();
  }
  /// Segments at `node`, ascending.
  std::span<const int> at(int node) const {
    if (node + 1 >= static_cast<int>(first_.size())) return {};
    return std::span(segment_).subspan(first_[node], first_[node + 1] - first_[node]);
  }

 private:
  std::vector<int> first_, segment_;
};

/// Gives each node with segments at it the kind of most of these.
void set_kinds(std::vector<TrackedNode>& nodes, const NodeSegments& around, const std::vector<Segment>& segments);

}  // namespace nugget::contact
