// SPDX-License-Identifier: Apache-2.0
// Which pairs can touch in a cycle, and where their feet are.
#include <algorithm>
#include <bit>
#include <cmath>

#include "base/index.hpp"
#include "contact/surface_contact.hpp"
#include "contact/surface_work.hpp"

namespace nugget::contact {

void SurfaceContact::ask_for(const Block& block) const {
  const auto lines = [](const auto& list) { ask_for_lines(list.data(), list.size() * sizeof list[0]); };
  lines(block.near);
  lines(block.seen);
  if (block.asleep_until > block.travelled) return;
  lines(block.next_check_travel);
  lines(block.first);
  lines(block.pairs);
  lines(block.touches);
}

/// Asks for what a pair of those that are awake needs to press, where it did so in the cycle before.
void SurfaceContact::ask_for_touching(const Block& block, const Awake& awake, std::size_t begin, std::size_t end,
                                      const Step& step) const {
  for (std::size_t i = begin; i < end; ++i) {
    const Pair& pair = block.pairs[awake.pairs[i].pair];
    if (!block.pressed(pair)) continue;
    for (const int n : faces_[pair.segment].node) {
      __builtin_prefetch(&step.v[n]);
      step.mass.ask_for(n);
      forces_.ask_for_place(n);
    }
  }
}

/// Lists the pairs that can touch in this cycle, and the order in which they are projected: lanes whose feet stay
/// inside need no look at edges, and together they save it.
void SurfaceContact::wake(const Block& block, Awake& awake) const {
  awake.nodes.clear();
  awake.pairs.clear();
  if (block.asleep_until > block.travelled) return;
  const int listed = static_cast<int>(block.pairs.size());
  Work& work = work_of_thread();
  if (work.waking.size() < at(listed)) {
    work.waking.resize(at(listed));
    work.in_order.resize(at(listed));
  }
  // Kept in registers: what is stored could be them, for all that the compiler knows.
  const double travelled = block.travelled;
  const Pair* const pairs = block.pairs.data();
  const Face* const faces = faces_.data();
  Awake::One* const ones = work.waking.data();
  int* const order = work.in_order.data();
  int count = 0, inside = 0, on_border = listed;
  for (int t = block.begin; t < block.end; ++t) {
    if (block.next_check_travel[t - block.begin] > travelled) continue;
    if (excluded_ != nullptr && (*excluded_)[t]) continue;
    double asleep_until = Box::infinity;
    const int node = nodes_[t].node, first = count;
    const int end = block.first[t - block.begin + 1];
    int touching = 0;  // where others may wait for these
    for (int i = block.first[t - block.begin]; i < end; ++i) {
      // Without branches, which nothing foresees.
      const Pair& pair = pairs[i];
      touching += pair.touch != none ? 1 : 0;
      const bool sleeps = pair.next_check_travel > travelled;
      asleep_until = std::min(asleep_until, sleeps ? pair.next_check_travel : Box::infinity);
      ones[count] = {i, node, none};
      count += sleeps ? 0 : 1;
    }
    if (block.depth_of(t) > 0.0) touching = 0;
    for (int k = first; k < count; ++k) {
      const Pair& pair = pairs[ones[k].pair];
      __builtin_prefetch(faces + pair.segment);
      if (touching > 0 && pair.touch == none) continue;
      ones[k].turn = inside;
      const int border = std::max(std::abs(pair.xi), std::abs(pair.eta)) >= 1.0 ? 1 : 0;
      on_border -= border;
      order[border != 0 ? on_border : inside] = k;
      inside += 1 - border;
    }
    awake.nodes.push_back({t, at(count), asleep_until, at(touching)});
  }
  std::copy(order + on_border, order + listed, order + inside);
  const int projected = inside + listed - on_border;
  for (int turn = inside; turn < projected; ++turn) ones[order[turn]].turn = turn;
  awake.pairs.assign(ones, ones + count);
  awake.order.assign(order, order + projected);
}

/// Projects the nodes of the pairs that are awake and do not wait onto their segments.
void SurfaceContact::project(const Block& block, Work& work, const Step& step) const {
  work.feet.clear();
  work.found.clear();
  // No pair that is closer than this sleeps; the others need a bound on the distance.
  work.close_by = Box::infinity;
  for (const Awake::Node& n : work.awake.nodes)
    work.close_by = std::min(work.close_by, Work::surely_close * block.widest_of(n.tracked));
  project(block, work, work.awake.order, step);
}

/// The same of the pairs in `order`, as many at a time as a register has lanes; their feet come behind those that are
/// there.
void SurfaceContact::project(const Block& block, Work& work, const std::vector<int>& order, const Step& step) const {
  using R = NativeBatch;
  constexpr std::size_t width = Work::width, ahead = 3 * width;
  const Awake& awake = work.awake;
  const std::size_t count = order.size();
  const auto ask_for_corners = [&](std::size_t first) {
    for (std::size_t k = first; k < std::min(count, first + width); ++k)
      for (const int n : faces_[block.pairs[awake.pairs[order[k]].pair].segment].node) __builtin_prefetch(&step.x[n]);
  };
  for (std::size_t first = 0; first < std::min(count, ahead); first += width) ask_for_corners(first);
  const std::size_t before = work.feet.size();
  work.feet.resize(before + (count + width - 1) / width);
  work.found.resize(work.feet.size());
  for (std::size_t first = 0; first < count; first += width) {
    ask_for_corners(first + ahead);
    std::array<std::array<int, width>, 4> id;
    std::array<int, width> node;
    std::array<double, width> xi, eta;
    unsigned special = 0;
    for (std::size_t l = 0; l < width; ++l) {
      const Awake::One& candidate = awake.pairs[order[std::min(first + l, count - 1)]];
      const Pair& pair = block.pairs[candidate.pair];
      const Face& face = faces_[pair.segment];
      for (std::size_t c = 0; c < 4; ++c) id[c][l] = face.node[c];
      if (face.triangle() || face.inner > 0.0) special |= 1u << l;
      node[l] = candidate.node;
      xi[l] = pair.xi;
      eta[l] = pair.eta;
    }
    kernel::CornersOf<R> corners;
    for (std::size_t c = 0; c < 4; ++c) corners[c] = gather<R>(step.x.data(), id[c].data());
    const Vec3<R> x = gather<R>(step.x.data(), node.data());
    kernel::Feet<R>& feet = work.feet[before + first / width];
    kernel::closest_points(corners, x, real_load<R>(xi.data()), real_load<R>(eta.data()), feet);
    Work::Found& found = work.found[before + first / width];
    real_store(found.xi.data(), feet.xi);
    real_store(found.eta.data(), feet.eta);
    real_store(found.distance.data(), feet.distance);
    const Vec3<R> r = x - feet.point, away = (R(1.0) / feet.distance) * r;
    real_store(found.height.data(), dot(r, feet.normal));
    real_store(found.length.data(), dot(r, away));
    real_store(found.up.data(), dot(away, feet.normal));
    if (special != 0 || any(!(feet.distance < work.close_by)))
      real_store(found.least.data(), kernel::least_distance(corners, x));
    for (; special != 0; special &= special - 1) found.distance[std::countr_zero(special)] = Box::infinity;
  }
}

namespace {

/// Corners of a segment in an order that begins with what it shares with another one: the ends of an edge, or a corner.
struct SharedFirst {
  int first = -1;  ///< none: it shares neither
  bool edge = false;
};
/// `shared`: see shared_corners().
constexpr SharedFirst shared_first(unsigned shared) {
  for (int c = 0; c < 4; ++c)
    if ((shared >> c & 1u) && (shared >> (c + 1) % 4 & 1u)) return {c, true};
  for (int c = 0; c < 4; ++c)
    if (shared == 1u << c) return {c, false};
  return {};
}
constexpr std::array<SharedFirst, 16> shared_first_of = [] {
  std::array<SharedFirst, 16> all{};
  for (unsigned shared = 0; shared < 16; ++shared) all[shared] = shared_first(shared);
  return all;
}();

}  // namespace

/// Of the pairs that wait those sleep whose closest point lies on an edge or corner that the segment shares with one
/// which the node touches: that one is no farther and hides them, as hidden_by() has it. They do so until points
/// can have moved so much that it is otherwise, whether the touch lasts or not. The others are projected.
void SurfaceContact::let_hidden_sleep(Block& block, Work& work, const Step& step) const {
  using R = NativeBatch;
  constexpr std::size_t width = Work::width;
  Awake& awake = work.awake;
  std::vector<int>& left = work.left;
  left.clear();
  std::array<std::array<int, width>, 4> id;
  std::array<int, width> node, one;
  std::array<double, width> edge, tilt, room;
  std::size_t filled = 0;
  const auto look = [&] {
    for (std::size_t l = filled; l < width; ++l) {
      for (std::size_t c = 0; c < 4; ++c) id[c][l] = id[c][0];
      node[l] = node[0];
      edge[l] = edge[0];
      tilt[l] = tilt[0];
    }
    kernel::CornersOf<R> corners;
    for (std::size_t c = 0; c < 4; ++c) corners[c] = gather<R>(step.x.data(), id[c].data());
    const Vec3<R> x = gather<R>(step.x.data(), node.data());
    real_store(room.data(), kernel::room_at_first(corners, real_load<R>(edge.data()), x, real_load<R>(tilt.data())));
    for (std::size_t l = 0; l < filled; ++l)
      if (room[l] > 0.0)
        block.pairs[awake.pairs[one[l]].pair].next_check_travel = block.travelled + room[l];
      else
        left.push_back(one[l]);
    filled = 0;
  };
  std::size_t begin = 0;
  for (const Awake::Node& n : awake.nodes) {
    const std::size_t first = std::exchange(begin, n.end);
    if (n.touching == 0 || n.end - first == n.touching) continue;  // none waits
    work.hiding.clear();
    for (std::size_t i = first; i < n.end; ++i) {
      const Pair& pair = block.pairs[awake.pairs[i].pair];
      const Face& face = faces_[pair.segment];
      if (pair.touch != none && pair.near_own == 0 && face.inner == 0.0 && is_exposed(face, step.element_alive))
        work.hiding.push_back({&face, Work::Lane(work, awake.pairs[i].turn).boundary()});
    }
    for (std::size_t i = first; i < n.end; ++i) {
      if (awake.pairs[i].turn >= 0) continue;
      const Face& face = faces_[block.pairs[awake.pairs[i].pair].segment];
      SharedFirst shared;
      bool over_border = false;
      for (const Work::Hiding& hiding : work.hiding) {
        if (shared.first >= 0) break;
        shared = shared_first_of[shared_corners(*hiding.face, face)];
        over_border = hiding.face->triangle() || has_boundary(face, *hiding.face, hiding.boundary);
      }
      if (shared.first < 0 || face.inner > 0.0) {
        left.push_back(static_cast<int>(i));
        continue;
      }
      for (int c = 0; c < 4; ++c) id[at(c)][filled] = face.node[at((shared.first + c) % 4)];
      node[filled] = awake.pairs[i].node;
      one[filled] = static_cast<int>(i);
      edge[filled] = shared.edge ? 1.0 : 0.0;
      tilt[filled] = over_border ? Work::border_tilt : Work::hollow_tilt;
      if (++filled == width) look();
    }
  }
  if (filled > 0) look();
  if (left.empty()) return;
  int turn = static_cast<int>(work.feet.size() * width);
  for (const int i : left) awake.pairs[i].turn = turn++;
  project(block, work, left, step);
}

/// All pairs of a node are looked at in the next cycle: it came behind a sheet, where other rules hold, or what hid
/// them is deleted.
void SurfaceContact::wake_all(Block& block, int tracked) const {
  for (int i = block.first[tracked - block.begin]; i < block.first[tracked - block.begin + 1]; ++i)
    if (block.pairs[i].next_check_travel < Box::infinity)
      block.pairs[i].next_check_travel = std::min(block.pairs[i].next_check_travel, block.travelled);
  double& first_check_travel = block.next_check_travel[tracked - block.begin];
  first_check_travel = std::min(first_check_travel, block.travelled);
}

}  // namespace nugget::contact
