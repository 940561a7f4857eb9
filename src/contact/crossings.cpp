// SPDX-License-Identifier: Apache-2.0
#include "contact/crossings.hpp"

#include <algorithm>
#include <cmath>

#include "base/bvh.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"

namespace nugget::contact {
namespace {

constexpr double clear = 0.01;  // of the contact thickness: an edge that ends on a sheet does not go through it

/// Whether the line from p to q meets a triangle, clear of its sides from a to b and from b to c by `low`; from c to a
/// the facet goes on, or (`alone`) does not. Both ends are as far from its plane.
bool goes_through(const Vec3d& p, const Vec3d& q, const Vec3d& a, const Vec3d& b, const Vec3d& c, double low,
                  bool alone) {
  const Vec3d n = cross(b - a, c - a);
  const double size = norm(n), of_p = dot(p - a, n), of_q = dot(q - a, n);
  if (!(size > 0.0) || std::abs(of_p) <= low * size || std::abs(of_q) <= low * size || (of_p > 0.0) == (of_q > 0.0))
    return false;
  const Vec3d meets = p + (of_p / (of_p - of_q)) * (q - p);
  const auto inside = [&](const Vec3d& from, const Vec3d& to, double by) {
    return dot(cross(to - from, meets - from), n) >= by * norm(to - from) * size;
  };
  return inside(a, b, low) && inside(b, c, low) && inside(c, a, alone ? low : 0.0);
}

class Search {
 public:
  Search(const SurfaceContactSetup& setup, std::span<const Row> x) : setup_(setup), x_(x) {
    std::vector<BoxTree::Entry> boxes;
    boxes.reserve(setup.segments.size());
    for (std::size_t s = 0; s < setup.segments.size(); ++s) {
      const Segment& segment = setup.segments[s];
      if (is_sheet(segment)) boxes.push_back({box_of(segment), static_cast<int>(s)});
      two_sided_ = two_sided_ || segment.side != setup.segments.front().side;
    }
    tree_ = BoxTree(std::move(boxes));
  }

  void look_at(std::size_t s, std::vector<Crossing>& found) const {
    const Segment& own = setup_.segments[s];
    if (!is_sheet(own)) return;
    const kernel::Corners corners = corners_of(own, x_);
    tree_.overlapping(box_of(own), [&](int other) {
      const Segment& facet = setup_.segments[at(other)];
      const auto stands_there = [&](int node) { return stands_at(facet, node); };
      if ((two_sided_ && facet.side == own.side) || std::ranges::any_of(own.node, stands_there)) return;
      if (lies_beside(corners, facet)) return;
      for (int c = 0; c < own.corners(); ++c) {
        const int from = own.node[at(c)], to = own.node[at((c + 1) % own.corners())];
        if (!goes_through(facet, from, to)) continue;
        found.push_back({{std::min(from, to), std::max(from, to)}, other});
      }
    });
  }

 private:
  static bool is_sheet(const Segment& s) { return !(s.volume > 0.0); }
  Box box_of(const Segment& s) const {
    Box box;
    for (const Vec3d& c : corners_of(s, x_)) box.add(c);
    return box;
  }
  bool stands_at(const Segment& facet, int node) const {
    return facet.has(node) || meets_at_place(setup_.places, facet, node);
  }
  /// All corners are on one side of a facet: so it is with sheets that lie on each other.
  bool lies_beside(const kernel::Corners& corners, const Segment& facet) const {
    const kernel::Corners k = corners_of(facet, x_);
    const Vec3d n = cross(k[2] - k[0], k[3] - k[1]), centre = 0.25 * (k[0] + k[1] + k[2] + k[3]);
    const double warp = std::abs(dot(k[0] - centre, n));
    double least = Box::infinity, most = -Box::infinity;
    for (const Vec3d& c : corners) {
      const double height = dot(c - centre, n);
      least = std::min(least, height);
      most = std::max(most, height);
    }
    return least > warp || most < -warp;
  }
  bool goes_through(const Segment& facet, int from, int to) const {
    const kernel::Corners k = corners_of(facet, x_);
    const Vec3d p = vec(x_[at(from)]), q = vec(x_[at(to)]);
    const double low = clear * facet.thickness;
    return contact::goes_through(p, q, k[0], k[1], k[2], low, facet.triangle()) ||
           (!facet.triangle() && contact::goes_through(p, q, k[2], k[3], k[0], low, false));
  }

  const SurfaceContactSetup& setup_;
  std::span<const Row> x_;
  BoxTree tree_;
  bool two_sided_ = false;
};

}  // namespace

std::vector<Crossing> find_crossings(const SurfaceContactSetup& setup, std::span<const Row> x, std::size_t begin,
                                     std::size_t end) {
  constexpr std::size_t together = 1024;
  const Search search(setup, x);
  std::vector<std::vector<Crossing>> of_stretch((end - begin + together - 1) / together);
  parallel_for(of_stretch.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k)
      for (std::size_t s = begin + k * together; s < std::min(end, begin + (k + 1) * together); ++s)
        search.look_at(s, of_stretch[k]);
  });
  std::vector<Crossing> all;
  for (const std::vector<Crossing>& some : of_stretch) all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace nugget::contact
