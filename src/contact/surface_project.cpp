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
  if (block.asleep_until > travelled_) return;
  const auto lines = [](const auto& list) { ask_for_lines(list.data(), list.size() * sizeof list[0]); };
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
    if (pair.touch == none) continue;
    ask_for_lines(&block.touches[pair.touch], sizeof(Touch));
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
  if (block.asleep_until > travelled_) return;
  const int listed = static_cast<int>(block.pairs.size());
  awake.pairs.resize(at(listed));
  awake.order.resize(at(listed));
  // Kept in registers: what is stored could be them, for all that the compiler knows.
  const double travelled = travelled_;
  const Pair* const pairs = block.pairs.data();
  const Face* const faces = faces_.data();
  Awake::One* const ones = awake.pairs.data();
  int* const order = awake.order.data();
  int count = 0, inside = 0, on_border = listed;
  for (int t = block.begin; t < block.end; ++t) {
    if (block.next_check_travel[t - block.begin] > travelled) continue;
    if (excluded_ != nullptr && (*excluded_)[t]) continue;
    double asleep_until = Box::infinity;
    const int node = nodes_[t].node, end = block.first[t - block.begin + 1];
    for (int i = block.first[t - block.begin]; i < end; ++i) {
      const Pair& pair = pairs[i];
      if (pair.next_check_travel > travelled) {
        asleep_until = std::min(asleep_until, pair.next_check_travel);
        continue;
      }
      __builtin_prefetch(faces + pair.segment);
      ones[count] = {i, node, inside};
      const int border = std::max(std::abs(pair.xi), std::abs(pair.eta)) >= 1.0 ? 1 : 0;
      on_border -= border;
      order[border != 0 ? on_border : inside] = count++;
      inside += 1 - border;
    }
    awake.nodes.push_back({t, at(count), asleep_until});
  }
  std::copy(order + on_border, order + listed, order + inside);
  for (int turn = inside; turn < count; ++turn) ones[order[turn]].turn = turn;
  awake.pairs.resize(at(count));
  awake.order.resize(at(count));
}

/// Projects the nodes of the pairs that are awake onto their segments, as many pairs at a time as a register has lanes.
void SurfaceContact::project(const Block& block, Work& work, const Step& step) const {
  using R = NativeBatch;
  constexpr std::size_t width = Work::width, ahead = 3 * width;
  const Awake& awake = work.awake;
  const std::size_t count = awake.pairs.size();
  const auto ask_for_corners = [&](std::size_t first) {
    for (std::size_t k = first; k < std::min(count, first + width); ++k)
      for (const int n : faces_[block.pairs[awake.pairs[awake.order[k]].pair].segment].node)
        __builtin_prefetch(&step.x[n]);
  };
  for (std::size_t first = 0; first < std::min(count, ahead); first += width) ask_for_corners(first);
  work.feet.resize((count + width - 1) / width);
  work.found.resize(work.feet.size());
  // No pair that is closer than this sleeps; the others need a bound on the distance.
  double close_by = Box::infinity;
  for (const Awake::Node& n : awake.nodes) close_by = std::min(close_by, Work::surely_close * widest(n.tracked));
  for (std::size_t first = 0; first < count; first += width) {
    ask_for_corners(first + ahead);
    std::array<std::array<int, width>, 4> id;
    std::array<int, width> node;
    std::array<double, width> xi, eta;
    unsigned special = 0;
    for (std::size_t l = 0; l < width; ++l) {
      const Awake::One& candidate = awake.pairs[awake.order[std::min(first + l, count - 1)]];
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
    kernel::Feet<R>& feet = work.feet[first / width];
    kernel::closest_points(corners, x, real_load<R>(xi.data()), real_load<R>(eta.data()), feet);
    Work::Found& found = work.found[first / width];
    real_store(found.xi.data(), feet.xi);
    real_store(found.eta.data(), feet.eta);
    real_store(found.distance.data(), feet.distance);
    if (special != 0 || any(!(feet.distance < close_by)))
      real_store(found.least.data(), kernel::least_distance(corners, x));
    for (; special != 0; special &= special - 1) found.distance[std::countr_zero(special)] = Box::infinity;
  }
}

}  // namespace nugget::contact
