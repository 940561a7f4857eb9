// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/batch.hpp"
#include "base/index.hpp"
#include "contact/surface_contact.hpp"

// Included by the .cpp files of SurfaceContact only.
namespace nugget::contact {

/// Asks the memory for `size` bytes from `data` on.
inline void ask_for_lines(const void* data, std::size_t size) {
  for (std::size_t byte = 0; byte < size; byte += 64) __builtin_prefetch(static_cast<const char*>(data) + byte);
}

/// Which corners of `b` are corners of `a` too: a bit for each.
inline unsigned shared_corners(const Facet& a, const Facet& b) {
#if defined(__AVX__)
  const auto load = [](const Facet& f) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(f.node.data())); };
  const __m128i of_a = load(a), of_b = load(b);
  const auto same = [&](const __m128i& turned) { return _mm_cmpeq_epi32(of_b, turned); };
  const __m128i even = _mm_or_si128(same(of_a), same(_mm_shuffle_epi32(of_a, 0x4e)));
  const __m128i odd = _mm_or_si128(same(_mm_shuffle_epi32(of_a, 0x39)), same(_mm_shuffle_epi32(of_a, 0x93)));
  return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(_mm_or_si128(even, odd))));
#else
  unsigned corners = 0;
  for (unsigned c = 0; c < 4; ++c) corners |= a.has(b.node[c]) ? 1u << c : 0u;
  return corners;
#endif
}

/// Whether the edge or corner of `segment` that `boundary` names belongs to `other` too.
inline bool has_boundary(const Facet& other, const Facet& segment, unsigned boundary) {
  return boundary != 0 && (boundary & ~shared_corners(other, segment)) == 0;
}

/// In sides or thicknesses: no farther from a border is on it.
inline constexpr double round_off = 1e-6;

/// Two feet, by their distances from the node and their points, are one point but for round-off of the `thickness`.
inline bool are_in_one_place(double distance, const Vec3d& point, double other_distance, const Vec3d& other_point,
                             double thickness) {
  const double reach = round_off * thickness;
  return std::abs(distance - other_distance) <= reach && norm(point - other_point) <= reach;
}

/// What a thread needs for the block that it works on. Apart from the class: how many pairs are projected at a time
/// depends on the program (docs/decisions/0094), what others see of a contact does not.
struct SurfaceContact::Work {
  static constexpr std::size_t width = lanes<NativeBatch>;  ///< pairs that are projected at a time
  /// Share of the distance where pairs sleep: what is closer does not, round-off being far less.
  static constexpr double surely_close = 1.0 - 1e-6;

  Awake awake, next;                            ///< of the block, and of the one after it
  std::vector<Awake::One> waking;               ///< room for their pairs
  std::vector<int> in_order;                    ///< and for the order of these
  std::vector<kernel::Feet<NativeBatch>> feet;  ///< of the pairs that are awake
  /// Of the same what is looked at first; the distance of a triangle and of the face of a brick is infinite there.
  /// Where one of them may sleep: least_distance(). Of the way from the foot to the node: `height` is its share along
  /// the normal, `length` that along itself, `up` the cosine between the two.
  struct Found {
    std::array<double, width> xi, eta, distance, least, height, length, up;
  };
  std::vector<Found> found;
  double close_by = 0.0;  ///< no pair of the block that is closer sleeps
  /// A segment that a node touches hides its neighbour until the node is over that by this angle (its sine), in a
  /// hollow: there its distances from the two are the same but for round_off. Where it is over the border itself, at
  /// once.
  static constexpr double hollow_tilt = 1.4e-3, border_tilt = round_off;
  struct Hiding {
    const Facet* face = nullptr;
    unsigned boundary = 0;  ///< on which the foot lies
  };
  std::vector<Hiding> hiding;               ///< segments that a node touches
  std::vector<int> left;                    ///< pairs that waited and are not hidden
  std::vector<int> close;                   ///< of the pairs of a node that are awake: those close enough
  std::vector<int> touching;                ///< of these, those that touched in the cycle before
  std::size_t touching_count = 0;           ///< how many
  std::vector<Candidate> candidates;        ///< of a node, and of earlier ones
  std::vector<Pair> listed;                 ///< the new lists of a block, in a search
  std::vector<std::pair<int, Box>> around;  ///< segments near some nodes of the block, with their boxes

  /// One of `feet`.
  class Lane {
   public:
    Lane(const Work& work, int turn) : feet_(work.feet[at(turn) / width]), l_(turn % static_cast<int>(width)) {}
    double xi() const { return number(feet_.xi); }
    double eta() const { return number(feet_.eta); }
    double distance() const { return number(feet_.distance); }
    Vec3d point() const { return vector(feet_.point); }
    Vec3d normal() const { return vector(feet_.normal); }
    unsigned boundary() const { return static_cast<unsigned>(static_cast<int>(number(feet_.boundary))); }
    std::array<double, 4> weight() const {
      return {number(feet_.weight[0]), number(feet_.weight[1]), number(feet_.weight[2]), number(feet_.weight[3])};
    }

   private:
    double number(const NativeBatch& a) const { return kernel::stored_lane(a, l_); }
    Vec3d vector(const Vec3<NativeBatch>& a) const { return {number(a.x), number(a.y), number(a.z)}; }

    const kernel::Feet<NativeBatch>& feet_;
    int l_;
  };
  /// Unit vector along which a node leaves a segment, `r` from its foot there. `side`: on which it is remembered to be,
  /// 0 where that is not known; what is inside a brick's face has no way through it.
  template <class Foot>
  static Vec3d way_out(const Face& face, const Foot& foot, const Vec3d& r, int side) {
    const Vec3d away = foot.distance > 0.0 ? (1.0 / foot.distance) * r : foot.normal;
    if (side == 0) return away;
    const Vec3d out = static_cast<double>(side) * foot.normal;
    if (foot.boundary == 0) return out;
    return face.inner == 0.0 && dot(away, out) <= -side_change_cosine ? -away : away;
  }
  /// Where a node stands at a segment: the way on which it is pressed, and the side to be remembered.
  struct Stand {
    Vec3d direction;
    int side = 0;
  };
  /// The same of a node outside of bricks, `r` from its foot, with its way_out() and the side that is remembered.
  /// `velocity()`: of the node less that of the foot; asked for where the side is not known.
  template <class Foot, class Velocity>
  static Stand stand(const SurfaceContact& contact, int segment, const Foot& foot, const Vec3d& r, const Vec3d& away,
                     int side, const Velocity& velocity, const Step& step) {
    const Face& face = contact.faces_[segment];
    if (foot.boundary == 0) {
      // A brick holds nothing inside.
      if (side == 0) side = dot(r - step.dt * velocity(), foot.normal) < 0.0 && face.inner == 0.0 ? -1 : 1;
      return {static_cast<double>(side) * foot.normal, side};
    }
    if (side == 0) side = contact.side_over_edge(segment, foot.normal, foot.boundary, r - step.dt * velocity(), step);
    const double up = side * dot(away, foot.normal);
    if (face.inner == 0.0 && up <= -side_change_cosine) return {-away, side};  // it came through
    // Beyond an edge lies the other face of a free edge, the next one of a fold.
    return {away, up < side_change_cosine ? 0 : side};
  }
  /// What of the overlap of a pair gives no force, by what it was `before`. What the motion of this step cannot have
  /// made was there before, or comes from a change of the surface or of the foot (of a segment that is folded up there
  /// are several), and is an offset too.
  template <class Velocity>
  static double offset_of(const Touch& before, double overlap, const Velocity& velocity, double dt) {
    double offset = before.offset;
    if (overlap - before.depth > offset) offset = std::max(offset, overlap - before.depth - dt * norm(velocity()));
    return std::min(offset, overlap);
  }

  static constexpr std::size_t most_at_rest = 2;  ///< pairs of a node: a sheet lies between two others at most
  /// A pair that touched in the cycle before, and what it remembers where it is not pressed now.
  struct Rest {
    Pair* pair = nullptr;
    Touch* touch = nullptr;
    int segment = 0, turn = 0, node = 0, side = 0;
    double contact_distance = 0.0;
    struct {
      Vec3d point, normal;
      double distance = 0.0;
      unsigned boundary = 0;
    } foot;
    Vec3d r;  ///< from the foot to the node
    Vec3d away;
    bool touches = false, inside = false;
    double offset = 0.0, depth = 0.0;

    /// In the pair's Touch: what press() would have it remember of a pair that has no force, its foot at (xi, eta).
    void remember(double xi, double eta) const {
      touch->xi = xi;
      touch->eta = eta;
      touch->inside = inside;
      touch->side = static_cast<signed char>(side);
      touch->offset = offset;
      touch->depth = depth;
      touch->friction = {};
      touch->memory = {};
    }
  };
  std::array<Rest, most_at_rest> at_rest;  ///< of a node, and of earlier ones
  /// Of a node whose pairs that touched are all that it has: the others are out of reach, or hidden.
  enum class Alone { no, rests, may_press };
  Alone look_alone(const SurfaceContact& contact, Block& block, const Awake::Node& node, std::size_t first,
                   const Step& step);
  bool stands_simply(Rest& rest) const;
  bool stays_alone(const SurfaceContact& contact, Rest& rest, int tracked, const Step& step) const;
  enum class Resting { yes, may_press, others_matter, unknown };
  Resting rest(const SurfaceContact& contact, Block& block, std::size_t count, int tracked, const Step& step);
  void find_foot(Rest& rest, const SurfaceContact& contact, const Awake::One& one, int tracked, const Step& step) const;
  bool stays(const SurfaceContact& contact, Rest& rest, const Step& step) const;
  template <class Known>
  bool others_matter(const SurfaceContact& contact, const Block& block, std::span<Known> known, double ahead,
                     std::size_t count, int tracked, const Step& step) const;
};

/// Whether the other close pairs of a node, of shells all, matter beside those that touched in the cycle before
/// (`known`: candidates, or pairs at rest). They do not where each is out of reach, or hidden by one that touched,
/// and hides none: so it is with most nodes of a flange, and only those that touched need be looked at. `ahead`: by how
/// much more than the contact distance a pair reaches, see check_node().
template <class Known>
bool SurfaceContact::Work::others_matter(const SurfaceContact& contact, const Block& block, std::span<Known> known,
                                         double ahead, std::size_t count, int tracked, const Step& step) const {
  for (std::size_t k = 0; k < count; ++k) {
    const Awake::One& one = awake.pairs[close[k]];
    const Pair& pair = block.pairs[one.pair];
    if (pair.touch != none) continue;
    const auto segment = static_cast<int>(pair.segment);
    const Lane foot(*this, one.turn);
    const unsigned boundary = foot.boundary();
    const double distance = foot.distance(), reach = contact.contact_distance(tracked, segment);
    bool hidden = false;
    for (const auto& c : known) {
      const unsigned shared = shared_corners(contact.faces_[c.segment], contact.faces_[segment]);
      const bool closer = c.foot.distance < distance || (c.foot.distance == distance && c.segment < segment);
      if (closer && (hidden || (boundary != 0 && (boundary & ~shared) == 0))) {
        hidden = true;
        continue;
      }
      if (shared == 0) continue;
      const Vec3d point = foot.point();
      const double thinner = std::min(reach, c.contact_distance);
      const bool in_place = are_in_one_place(distance, point, c.foot.distance, c.foot.point, thinner);
      if (!in_place && !closer) return true;
      hidden = hidden || in_place || dot(vec(step.x[one.node]) - point, c.away) > 0.5 * distance;
    }
    if (!hidden && distance < reach + ahead) return true;
  }
  return false;
}

}  // namespace nugget::contact
