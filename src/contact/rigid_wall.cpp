// SPDX-License-Identifier: Apache-2.0
#include "contact/rigid_wall.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/free_room.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"
#include "system/parcel.hpp"
#include "system/share.hpp"

namespace nugget::contact {
namespace {

constexpr std::size_t nodes_per_sum = 1024;
constexpr std::size_t nodes_ahead = 16;
// Groups sleep for half of the way that they have, if that is so many steps: they wake before a node can touch.
constexpr double steps_of_sleep = 32.0;
constexpr int most_pushes = 8;

kernel::WallShape shape_of(const model::RigidWall& wall) {
  switch (wall.shape) {
    case model::RigidWall::Shape::cylinder: return kernel::CylinderWall{wall.normal, wall.radius, wall.length};
    case model::RigidWall::Shape::sphere: return kernel::SphereWall{wall.radius};
    case model::RigidWall::Shape::prism:
      return kernel::PrismWall{wall.normal, wall.edge_l, wall.edge_m, wall.length_l, wall.length_m, wall.depth};
    case model::RigidWall::Shape::plane: break;
  }
  if (!wall.finite) return kernel::PlaneWall{wall.normal, {}, {}};
  return kernel::PlaneWall{wall.normal, wall.edge_l, wall.edge_m, wall.length_l, wall.length_m};
}

}  // namespace

RigidWall::RigidWall(const model::RigidWall& wall, std::vector<int> nodes, const Curve* motion,
                     std::optional<WallPenalty> bodies)
    : shape_(shape_of(wall)),
      origin_(wall.origin),
      normal_(wall.normal),
      friction_(wall.friction),
      weld_velocity_(wall.weld_velocity),
      mass_(wall.mass),
      velocity_(wall.velocity),
      motion_is_displacement_(wall.motion_is_displacement),
      motion_direction_(wall.motion_direction),
      birth_(wall.birth),
      death_(wall.death),
      bodies_(std::move(bodies)) {
  if (motion != nullptr) motion_ = *motion;
  nodes_ = std::move(nodes);
  attachment_.resize(nodes_.size());
  groups_.resize((nodes_.size() + nodes_per_sum - 1) / nodes_per_sum);
  found_.resize(groups_.size());
}

std::size_t RigidWall::sum_apart(std::vector<int> nodes) {
  apart_.push_back({std::move(nodes), model::none, {}, {}});
  return apart_.size() - 1;
}

std::size_t RigidWall::sum_apart(const std::array<Vec3d, 4>& area) {
  apart_.push_back({{}, static_cast<int>(areas_.size()), {}, {}});
  areas_.push_back(area);
  for (Vec3d& corner : areas_.back()) corner -= origin_;
  return apart_.size() - 1;
}

/// The first area that has a place (off the reference point) within its corners, seen along its normal; or none.
int RigidWall::area_at(const Vec3d& place) const {
  for (std::size_t k = 0; k < areas_.size(); ++k) {
    const std::array<Vec3d, 4>& x = areas_[k];
    const Vec3d across = cross(x[2] - x[0], x[3] - x[1]);
    const double edge = -1e-9 * dot(across, across);
    bool within = true;
    for (std::size_t i = 0; i < 4 && within; ++i)
      within = dot(cross(x[(i + 1) % 4] - x[i], place - x[i]), across) >= edge;
    if (within) return static_cast<int>(k);
  }
  return model::none;
}

/// What the wall has just done to nodes and areas that are looked at apart.
void RigidWall::sum_up_apart(double between_middles, bool active) {
  for (Apart& apart : apart_) apart.force = {};
  const auto add_to_sums = [this](int node, int area, const Vec3d& force) {
    for (Apart& apart : apart_)
      if (apart.area == model::none ? std::ranges::binary_search(apart.nodes, node) : apart.area == area)
        apart.force += force;
  };
  for (std::size_t g = 0; active && g < groups_.size(); ++g) {
    if (groups_[g].slept) continue;
    for (const Stopped& s : found_[g].stopped)
      add_to_sums(nodes_[s.tracked], s.area, (1.0 / between_middles) * s.sum.impulse);
  }
  if (bodies_)
    bodies_->for_each_force([&](int node, const Vec3d& place, const Vec3d& force) {
      add_to_sums(node, areas_.empty() ? model::none : area_at(place), force);
    });
}

/// In the step `dt` from `time` on. The curve's time counts from the birth of the wall (keyword manual, BIRTH).
Vec3d RigidWall::prescribed_velocity(double time, double dt) const {
  if (!motion_ || motion_->empty()) return {};
  const double begin = time - birth_, end = begin + dt, middle = begin + 0.5 * dt;
  if (!motion_is_displacement_) return middle < 0.0 ? Vec3d{} : motion_->zero_outside(middle) * motion_direction_;
  // A displacement holds its last value when the curve ends.
  const double way = motion_->clamped(std::max(0.0, end)) - motion_->clamped(std::max(0.0, begin));
  return (way / dt) * motion_direction_;
}

void RigidWall::turn(bool on) {
  if (on_ && !on) std::ranges::fill(attachment_, kernel::WallAttachment::none);
  on_ = on;
}

void RigidWall::press(const contact::Step& step, std::span<Row> f) {
  if (!bodies_) return;
  if (acts(step.time))
    bodies_->apply(step, shape_, origin_, wall_velocity_, f);
  else
    bodies_->release();
}

void RigidWall::constrain(double time, double dt, double dt_previous, std::span<const Row> x, std::span<Row> v,
                          std::span<const Row> f, std::span<const double> mass, std::span<const unsigned char> skip,
                          double fastest, const system::Share* share, HeldNodes* supports) {
  force_ = {};
  normal_force_ = 0.0;
  touching_ = 0;
  pending_energy_ = power_on_change_ = 0.0;
  const double between_middles = 0.5 * (dt + dt_previous);
  Step step{dt, between_middles, x, v, f, mass, skip, prescribed_velocity(time, dt), fastest, share, supports};
  if (share != nullptr) list_followed(*share);
  const bool active = acts(time);
  if (mass_ > 0.0 && time >= birth_) {
    if (bodies_) velocity_ -= between_middles / mass_ * dot(bodies_->force(), normal_);
    if (active) std::visit([&](const auto& shape) { collide(shape, step); }, shape_);
    step.wall_velocity = velocity_ * normal_;
  }
  if (active) {
    const Sum all = std::visit([&](const auto& shape) { return stop(shape, step); }, shape_);
    force_ = (1.0 / between_middles) * all.impulse;
    normal_force_ = all.normal / between_middles;
    impulse_ += all.impulse;
    normal_impulse_ += all.normal;
    energy_ += all.opening + all.closing;
    const double until_now = dt_previous / between_middles;
    pending_energy_ = (1.0 - until_now) * all.opening + all.closing;
    touching_ = all.touching;
    power_on_change_ = all.power_on_change;
  }
  if (bodies_) {
    force_ += bodies_->force();
    normal_force_ += bodies_->normal_force();
    impulse_ += between_middles * bodies_->force();
    normal_impulse_ += between_middles * bodies_->normal_force();
    touching_ += bodies_->touching();
  }
  if (!apart_.empty()) sum_up_apart(between_middles, active);
  if (!active) std::fill(groups_.begin(), groups_.end(), Group{});
  started_ = active;
  wall_velocity_ = step.wall_velocity;
  origin_ += dt * step.wall_velocity;
}

/// The nodes that a wall with mass catches up with at its present velocity, of all ranks, in the order of the wall.
template <class Shape>
std::vector<RigidWall::Caught> RigidWall::find_caught(const Shape& shape, const Step& step) const {
  std::vector<Caught> caught;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const int node = nodes_[i];
    if (!step.skip.empty() && step.skip[node]) continue;
    if (step.share != nullptr && step.share->answering(node) != step.share->ranks().rank()) continue;
    const Vec3d from = vec(step.x[node]) - origin_, v = vec(step.v[node]);
    const kernel::WallPush p = push(shape, from, from + step.dt * (v - step.wall_velocity), attachment_[i]);
    if (!p.touching) continue;
    const HeldNodes::Held held = step.held(node);
    const Vec3d way = held.free_part(p.normal);
    const double share = held.count > 0 ? dot(way, way) : 1.0;
    if (share >= least_free) caught.push_back({static_cast<int>(i), attachment_[i], step.mass[node] / share, from, v});
  }
  if (step.share == nullptr) return caught;
  caught = gather_lists(step.share->ranks(), caught);
  std::ranges::sort(caught, {}, &Caught::tracked);
  return caught;
}

/// The velocity of a wall with mass after a plastic collision with all nodes that it catches up with:
/// M (V_old - V) = sum m_i (V - w_i), w_i the node's normal velocity plus what closes its gap in this step. Nodes that
/// the slowed wall no longer reaches drop out, until none does.
template <class Shape>
void RigidWall::collide(const Shape& shape, Step& step) {
  const double before = velocity_;
  step.wall_velocity = velocity_ * normal_;
  const std::vector<Caught> reached = find_caught(shape, step);
  std::size_t caught_before = reached.size() + 1;
  for (bool converged = false; !converged;) {
    step.wall_velocity = velocity_ * normal_;
    double momentum = mass_ * before, total = mass_;
    std::size_t caught = 0;
    for (const Caught& c : reached) {
      const kernel::WallPush p = push(shape, c.from, c.from + step.dt * (c.v - step.wall_velocity), c.attachment);
      if (!p.touching) continue;
      const double gap = c.attachment == kernel::WallAttachment::welded ? 0.0 : std::max(0.0, dot(c.from, normal_));
      momentum += c.mass * (dot(c.v, normal_) + gap / step.dt);
      total += c.mass;
      ++caught;
    }
    velocity_ = caught > 0 ? momentum / total : before;
    converged = caught == 0 || caught >= caught_before;
    caught_before = caught;
  }
}

/// What friction changes in the velocity relative to the wall, given what the wall changes in its normal part.
Vec3d RigidWall::friction(const Vec3d& slip, double normal_change) const {
  if (friction_ == 1.0 || friction_ == 3.0) return -slip;
  if (friction_ == 2.0) return {};
  return kernel::friction_change(slip, friction_, normal_change);
}

void RigidWall::Sum::add(const Sum& more) {
  impulse += more.impulse;
  normal += more.normal;
  opening += more.opening;
  closing += more.closing;
  power_on_change += more.power_on_change;
  touching += more.touching;
}

/// Stops the nodes; returns what that is in all, on all ranks.
template <class Shape>
RigidWall::Sum RigidWall::stop(const Shape& shape, const Step& step) {
  const double way = step.dt * (step.fastest + norm(step.wall_velocity));
  if (std::isfinite(travelled_ + way)) {
    travelled_ += way;
  } else {
    for (Group& group : groups_) group.asleep_until = 0.0;
    travelled_ = 0.0;
  }
  parallel_for(groups_.size(), 1, [this, &shape, &step](std::size_t begin, std::size_t end) {
    for (std::size_t g = begin; g < end; ++g) look_at_group(shape, g, step);
  });
  if (step.share != nullptr) share_found(*step.share);
  Sum all;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (groups_[g].slept) continue;
    const Found& found = found_[g];
    const bool far = !found.attached && found.clear > steps_of_sleep * way;
    groups_[g].asleep_until = far ? travelled_ - way + 0.5 * found.clear : 0.0;
    if (far) free_room(groups_[g].last);  // a large model has few nodes near a wall
    Sum of_group;
    for (const Stopped& stopped : found.stopped) of_group.add(stopped.sum);
    all.add(of_group);
  }
  return all;
}

template <class Shape>
void RigidWall::look_at_group(const Shape& shape, std::size_t g, const Step& step) {
  Group& group = groups_[g];
  const bool slept = std::exchange(group.slept, group.asleep_until > travelled_);
  if (group.slept) return;
  Found& found = found_[g];
  found.clear = std::numeric_limits<double>::infinity();
  found.attached = false;
  found.stopped.clear();
  const bool all = step.share == nullptr;
  const auto tracked = [&](std::size_t i) { return all ? i : at(followed_[i]); };
  const std::size_t size = std::min(nodes_per_sum, nodes_.size() - g * nodes_per_sum);
  const bool begins = slept || !started_ || group.last.size() != size;
  group.last.resize(size);
  const std::size_t begin = all ? g * nodes_per_sum : first_followed_[g],
                    end = all ? std::min(nodes_.size(), (g + 1) * nodes_per_sum) : first_followed_[g + 1];
  for (std::size_t i = begin; i < end; ++i) {
    // The nodes of a wall are in the order of the deck, not of memory: not asked for ahead, each is waited for.
    const int soon = nodes_[tracked(std::min(i + nodes_ahead, end - 1))];
    __builtin_prefetch(&step.x[soon]);
    __builtin_prefetch(&step.v[soon], 1);
    const std::size_t now = tracked(i);
    stop(shape, static_cast<int>(now), group, begins, step, found.stopped);
    const double free = clearance(shape, vec(step.x[nodes_[now]]) - origin_);
    if (!(free >= found.clear)) found.clear = free;
    found.attached = found.attached || attachment_[now] != kernel::WallAttachment::none;
  }
}

template <class Shape>
void RigidWall::stop(const Shape& shape, int index, Group& group, bool begins, const Step& step,
                     std::vector<Stopped>& stopped) {
  const int node = nodes_[index];
  kernel::WallAttachment& attachment = attachment_[index];
  Vec3d& last = group.last[at(index) % nodes_per_sum];
  if (!step.skip.empty() && step.skip[node]) {
    attachment = kernel::WallAttachment::none;
    return;
  }
  const Vec3d from = vec(step.x[node]) - origin_;
  const Vec3d free = vec(step.v[node]);
  Vec3d relative = free - step.wall_velocity;
  kernel::WallPush p = push(shape, from, from + step.dt * relative, attachment);
  const HeldNodes::Held held = p.touching ? step.held(node) : HeldNodes::Held{};
  Vec3d before = begins ? free : last;
  // Of a wall that begins, what the forces have changed since then is no velocity that the wall has stopped; and only a
  // node that in one step goes half of its way to the wall meets it as the group wakes.
  if (begins && step.mass[node] > 0.0)
    before = free - (step.between_middles / step.mass[node]) * held.free_part(vec(step.f[node]));
  last = free;
  const Vec3d way = held.free_part(p.normal);
  const double share = held.count > 0 ? dot(way, way) : 1.0;
  if (!p.touching || share < least_free) {
    attachment = kernel::WallAttachment::none;
    return;
  }
  const Vec3d normal = p.normal;
  const bool first = attachment == kernel::WallAttachment::none;
  const double speed = dot(relative, normal);
  attachment = attachment == kernel::WallAttachment::welded || (friction_ >= 2.0 && first && -speed > weld_velocity_)
                   ? kernel::WallAttachment::welded
                   : kernel::WallAttachment::touching;

  Vec3d slid;  // what friction changes
  if (friction_ > 0.0) {
    slid = friction(relative - speed * p.normal, std::abs(p.distance) / step.dt / share);
    // Where the node is held it slides along the wall in the directions that are left.
    if (held.count > 0) {
      slid = held.free_part(slid);
      slid -= dot(slid, way) / share * way;
    }
    relative += slid;
    // On a round wall less sliding needs another push.
    const kernel::WallPush again = push(shape, from, from + step.dt * relative, attachment);
    if (again.touching) p = again;
  }
  if (held.count == 0) {
    relative += (p.distance / step.dt) * p.normal;
  } else {
    // Not along the normal: on a round wall one push does not bring it all the way.
    for (int pushes = 0; p.touching && pushes < most_pushes; ++pushes) {
      relative += (p.distance / step.dt / share) * way;
      p = push(shape, from, from + step.dt * relative, attachment);
    }
    p.normal = normal;
  }

  const Vec3d after = relative + step.wall_velocity;
  Vec3d impulse = step.mass[node] * (after - free);
  if (held.count > 0) {
    const Vec3d of_both = impulse;
    impulse = (dot(of_both, way) / share) * normal + step.mass[node] * slid;
    step.supports->take_up(node, of_both - impulse);
  }
  last = after;
  set(step.v[node], after);
  stopped.push_back({index,
                     areas_.empty() ? model::none : area_at(from),
                     {impulse, dot(impulse, p.normal), -0.5 * dot(impulse, before), -0.5 * dot(impulse, after),
                      dot(vec(step.f[node]), after - free), 1}});
}

void RigidWall::list_followed(const system::Share& share) {
  if (!first_followed_.empty()) return;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (i % nodes_per_sum == 0) first_followed_.push_back(followed_.size());
    if (share.follows(nodes_[i])) followed_.push_back(static_cast<int>(i));
  }
  first_followed_.push_back(followed_.size());
}

/// What all ranks have found in the groups that are awake takes the place of what this one has.
void RigidWall::share_found(const system::Share& share) {
  Ranks& ranks = share.ranks();
  struct Near {
    double clear, attached;
  };
  std::vector<std::size_t> awake;
  std::vector<Near> own;
  std::vector<Stopped> stopped;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (groups_[g].slept) continue;
    awake.push_back(g);
    own.push_back({found_[g].clear, found_[g].attached ? 1.0 : 0.0});
    for (const Stopped& s : found_[g].stopped)
      if (share.answering(nodes_[s.tracked]) == ranks.rank()) stopped.push_back(s);
    found_[g].stopped.clear();
  }
  if (awake.empty()) return;
  std::vector<Near> of_all;
  stopped = stopped_of_ranks_.gather(ranks, stopped, own, of_all);
  for (std::size_t i = 0; i < of_all.size(); ++i) {
    Found& found = found_[awake[i % awake.size()]];
    if (!(of_all[i].clear >= found.clear)) found.clear = of_all[i].clear;
    found.attached = found.attached || of_all[i].attached != 0.0;
  }
  std::ranges::sort(stopped, {}, &Stopped::tracked);
  for (const Stopped& s : stopped) found_[at(s.tracked) / nodes_per_sum].stopped.push_back(s);
}

void RigidWall::carry(int rank, const system::Share& share, system::Parcel& parcel) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const int node = nodes_[i];
    if (share.everyone_follows(node) || share.answering(node) != rank) continue;
    parcel(&attachment_[i], 1);
    // All ranks look at the same groups.
    if (std::vector<Vec3d>& last = groups_[i / nodes_per_sum].last; !last.empty()) parcel(&last[i % nodes_per_sum], 1);
  }
}

std::size_t RigidWall::awake() const {
  std::size_t count = 0;
  for (std::size_t g = 0; g < groups_.size(); ++g)
    if (!groups_[g].slept) count += std::min(nodes_.size(), (g + 1) * nodes_per_sum) - g * nodes_per_sum;
  return count;
}

void RigidWall::average(double time, bool begins) {
  force_ = mean_force_.add(force_, time, begins);
  normal_force_ = mean_normal_.add({normal_force_, 0.0, 0.0}, time, begins).x;
  for (Apart& apart : apart_) apart.force = apart.mean.add(apart.force, time, begins);
}

void RigidWall::archive(Archive& a) {
  a.section("wall");
  a(origin_, velocity_, attachment_, groups_, travelled_, started_, force_, impulse_, normal_force_, normal_impulse_,
    energy_, pending_energy_, mean_force_, mean_normal_, power_on_change_, touching_, wall_velocity_, on_, apart_);
  if (bodies_) a(*bodies_);
  a.built(areas_, nodes_, shape_, normal_, friction_, weld_velocity_, mass_, motion_, motion_is_displacement_,
          motion_direction_, birth_, death_, found_, followed_, first_followed_, stopped_of_ranks_);
}

}  // namespace nugget::contact
