// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
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

/// What a thread needs for the block that it works on. Apart from the class: how many pairs are projected at a time
/// depends on the program (docs/decisions/0094), what others see of a contact does not.
struct SurfaceContact::Work {
  static constexpr std::size_t width = lanes<NativeBatch>;  ///< pairs that are projected at a time
  /// Share of the distance where pairs sleep: what is closer does not, round-off being far less.
  static constexpr double surely_close = 1.0 - 1e-6;

  Awake awake, next;                            ///< of the block, and of the one after it
  std::vector<kernel::Feet<NativeBatch>> feet;  ///< of the pairs that are awake
  /// Of the same what is looked at first; the distance of a triangle and of the face of a brick is infinite there.
  /// Where one of them may sleep: least_distance().
  struct Found {
    std::array<double, width> xi, eta, distance, least;
  };
  std::vector<Found> found;
  std::vector<int> close;                   ///< of the pairs of a node that are awake: those close enough
  std::vector<int> touching;                ///< of these, those that touched in the cycle before
  std::vector<Candidate> candidates;        ///< of a node, and of earlier ones
  std::vector<Pair> listed;                 ///< the new lists of a block, in a search
  std::vector<std::pair<int, Box>> around;  ///< segments near some nodes of the block, with their boxes
  std::vector<Share> shares;                ///< of the hits of a block, in the order of these

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
  static constexpr std::size_t most_at_rest = 2;  ///< pairs of a node: a sheet lies between two others at most
  /// A pair that touched in the cycle before, and what it remembers where it is not pressed now.
  struct Rest {
    Pair* pair = nullptr;
    Touch* touch = nullptr;
    int segment = 0, turn = 0, node = 0, side = 0;
    double distance = 0.0, contact_distance = 0.0;
    Vec3d point, normal;
    Vec3d r;  ///< from the foot to the node
    Vec3d away;
    unsigned boundary = 0;
    bool touches = false, inside = false;
    double offset = 0.0, depth = 0.0;
  };
  enum class Resting { yes, may_press, others_matter, unknown };
  Resting rest(const SurfaceContact& contact, Block& block, std::size_t count, std::size_t touching_count, int tracked,
               const Step& step) const;
  void find_foot(Rest& rest, const SurfaceContact& contact, const Awake::One& one, int tracked, const Step& step) const;
  bool stays(const SurfaceContact& contact, Rest& rest, const Step& step) const;
  bool matter(const SurfaceContact& contact, std::span<const Rest> known, int segment, const Awake::One& one,
              int tracked, const Step& step) const;
};

}  // namespace nugget::contact
