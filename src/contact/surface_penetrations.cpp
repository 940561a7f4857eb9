// SPDX-License-Identifier: Apache-2.0
// Overlaps at the start, found as a contact finds them in a cycle.
#include <algorithm>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "contact/surface_contact.hpp"
#include "contact/surface_part.hpp"
#include "contact/surface_work.hpp"

namespace nugget::contact {
namespace {

bool any_bricks(const SurfaceContactSetup& setup) {
  return std::any_of(setup.segments.begin(), setup.segments.end(), [](const Segment& s) { return s.volume > 0.0; });
}

}  // namespace

/// The overlaps of a contact that has not been applied yet. The lists of the last call stay, where no nodes have moved
/// too far for them; what is found is the same.
std::vector<Penetration> SurfaceContact::penetrations(std::span<const Row> x) {
  Step step;
  step.x = x;
  if (!searched_ || !lists_are_good_for(x)) search(step);
  list_active_blocks();
  std::vector<std::vector<Penetration>> found(active_blocks_.size());
  parallel_for(active_blocks_.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) find_overlaps(blocks_[active_blocks_[b]], step, found[b]);
  });
  std::vector<Penetration> all;
  for (const std::vector<Penetration>& of_block : found) all.insert(all.end(), of_block.begin(), of_block.end());
  return all;
}

void SurfaceContact::find_overlaps(Block& block, const Step& step, std::vector<Penetration>& found) const {
  Work& work = work_of_thread();
  std::fill(block.next_check_travel.begin(), block.next_check_travel.end(), block.travelled);
  for (Pair& pair : block.pairs) {
    pair.xi = pair.eta = 0.0;
    pair.next_check_travel = block.travelled;
  }
  wake(block, work.awake);
  // From the middle, as a search does, and from there again, as the first cycle does: so the feet have its bits.
  project(block, work, step);
  for (const Awake::One& one : work.awake.pairs) {
    const kernel::Feet<NativeBatch>& feet = work.feet[at(one.turn) / Work::width];
    const int l = one.turn % static_cast<int>(Work::width);
    block.pairs[one.pair].xi = kernel::stored_lane(feet.xi, l);
    block.pairs[one.pair].eta = kernel::stored_lane(feet.eta, l);
  }
  project(block, work, step);
  std::size_t first = 0;
  for (const Awake::Node& node : work.awake.nodes) {
    const Candidates candidates = gather_candidates(block, work, node, std::exchange(first, node.end), step);
    const int n = nodes_[node.tracked].node;
    for (const Candidate& c : candidates)
      if (c.gap < c.contact_distance && presses(candidates, c, n, step))
        found.push_back({n, c.segment, c.contact_distance - c.gap, c.away});
  }
}

std::vector<Penetration> find_penetrations(const SurfaceContactSetup& setup, std::span<const Row> x) {
  return SurfaceContact(setup, x).penetrations(x);
}

std::vector<Penetration> find_nodes_out_of_reach(const SurfaceContactSetup& setup, std::span<const Row> x) {
  if (!any_bricks(setup)) return {};
  SurfaceContact contact(setup, x);
  std::vector<double> reached;
  for (SurfaceContact::Face& face : contact.faces_) {
    reached.push_back(face.inner);
    face.inner /= pressing_depth;
  }
  std::vector<Penetration> found = contact.penetrations(x);
  std::erase_if(found, [&](const Penetration& p) {
    const auto tracked =
        std::find_if(setup.nodes.begin(), setup.nodes.end(), [&p](const TrackedNode& t) { return t.node == p.node; });
    return reached[p.segment] == 0.0 || p.depth <= reached[p.segment] + 0.5 * tracked->thickness;
  });
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.depth > b.depth; });
  return found;
}

std::vector<Penetration> remove_penetrations(const SurfaceContactSetup& setup, std::span<Row> x, int passes,
                                             const DividedSurface* divided) {
  struct Way {
    Vec3d step;
    int node = 0;
  };
  SurfaceContactSetup again;  // the part of this rank, once the nodes have moved far
  const SurfaceContactSetup* now = &setup;
  std::optional<SurfaceContact> contact(std::in_place, setup, x);
  const bool bricks = any_bricks(setup);
  const std::vector<Penetration> before = contact->penetrations(x);
  std::vector<Penetration> left = before;
  double moved = 0.0;  // since the surface was divided, at most
  for (int pass = 0; pass < passes; ++pass) {
    std::vector<Way> ways;
    for (auto first = left.begin(); first != left.end();) {
      const auto end = std::find_if(first, left.end(), [&](const Penetration& p) { return p.node != first->node; });
      // Of several penetrations of a node the deepest is mended in a pass, in whatever order segments are numbered.
      const Penetration& deepest =
          *std::max_element(first, end, [](const Penetration& a, const Penetration& b) { return a.depth < b.depth; });
      first = end;
      if (deepest.depth <= 1e-3 * now->segments[deepest.segment].thickness) continue;
      ways.push_back({0.5 * deepest.depth * deepest.direction, deepest.node});
    }
    if (divided != nullptr) ways = gather_lists(divided->ranks, ways);
    if (ways.empty()) break;
    double farthest = 0.0;
    for (const Way& way : ways) {
      add(x[way.node], way.step);
      farthest = std::max(farthest, norm(way.step));
    }
    moved += farthest;
    if (divided != nullptr && (bricks || moved > divided->room)) {
      again = divided->part(x);
      now = &again;
      contact.emplace(again, x);
      moved = 0.0;
    } else if (bricks) {
      contact.emplace(setup, x);  // they have become more or less deep
    }
    left = contact->penetrations(x);
  }
  return before;
}

}  // namespace nugget::contact
