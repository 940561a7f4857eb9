// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/cohesive_brick.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nugget::kernel {
namespace {

using L = CohesiveBrickLayout;

/// Corner a of the surface midway stands at (xi, eta)[a]; so do the points, times `place`.
constexpr double xi[4] = {-1, 1, 1, -1}, eta[4] = {-1, -1, 1, 1};

/// Shape functions of the four corners at the points: Gauss's, or where bricks are never deleted those at the corners
/// (Newton-Cotes).
struct Shapes {
  double n[4][4];
  double place;
  explicit Shapes(bool at_corners) : place(at_corners ? 1.0 : 1.0 / std::sqrt(3.0)) {
    for (int p = 0; p < 4; ++p)
      for (int a = 0; a < 4; ++a) n[p][a] = 0.25 * (1.0 + place * xi[p] * xi[a]) * (1.0 + place * eta[p] * eta[a]);
  }
};

Shapes shapes_of(const CohesiveBond& bond) {
  return Shapes(bond.points_to_delete == 0);
}

std::array<Vec3d, 4> midway(const std::array<Vec3d, 8>& x) {
  std::array<Vec3d, 4> m;
  for (std::size_t a = 0; a < 4; ++a) m[a] = 0.5 * (x[a] + x[a + 4]);
  return m;
}

/// Area that belongs to the point at (s, t) of the square: the Jacobian determinant, with weights of 1.
double area_at(const std::array<Vec3d, 4>& m, double s, double t) {
  Vec3d by_xi{}, by_eta{};
  for (std::size_t a = 0; a < 4; ++a) {
    by_xi += 0.25 * xi[a] * (1.0 + t * eta[a]) * m[a];
    by_eta += 0.25 * eta[a] * (1.0 + s * xi[a]) * m[a];
  }
  return norm(cross(by_xi, by_eta));
}

/// Mean directions of the surface midway: from side 4-1 to side 2-3, and from side 1-2 to side 3-4.
template <class R>
struct Directions {
  Vec3<R> g1{}, g2{};
  explicit Directions(const Vec3<R>* x) {
    for (int a = 0; a < 4; ++a) {
      const Vec3<R> pair = x[a] + x[a + 4];
      g1 += R(0.25 * xi[a]) * pair;
      g2 += R(0.25 * eta[a]) * pair;
    }
  }
};

template <class R>
Frame<R> axes_of(const Directions<R>& d) {
  const Vec3<R> a = unit(d.g1), b = unit(d.g2), across = unit(cross(a, b));
  const Vec3<R> along = unit(a + b), off = cross(along, across);
  const R half(std::sqrt(0.5));
  return {half * (along + off), half * (along - off), across};
}

/// What turns the axes: their spin, in themselves, for rates of both directions, and the forces on these directions
/// whose power is that of a moment on the spin.
template <class R>
class Spin {
 public:
  Spin(const Directions<R>& d, const Frame<R>& f) : f_(f) {
    const R area = dot(cross(d.g1, d.g2), f.e3);
    const R over = R(1.0) / area;
    x1_ = over * dot(d.g1, f.e1), y1_ = over * dot(d.g1, f.e2);
    x2_ = over * dot(d.g2, f.e1), y2_ = over * dot(d.g2, f.e2);
    turn1_ = (R(0.5) / dot(d.g1, d.g1)) * cross(f.e3, d.g1);
    turn2_ = (R(0.5) / dot(d.g2, d.g2)) * cross(f.e3, d.g2);
  }
  Vec3<R> of(const Directions<R>& rate) const {
    const R up1 = dot(f_.e3, rate.g1), up2 = dot(f_.e3, rate.g2);
    return {x1_ * up2 - x2_ * up1, y1_ * up2 - y2_ * up1, dot(turn1_, rate.g1) + dot(turn2_, rate.g2)};
  }
  /// `moment`: in the axes.
  Vec3<R> on_first(const Vec3<R>& moment) const {
    return (-(x2_ * moment.x) - y2_ * moment.y) * f_.e3 + moment.z * turn1_;
  }
  Vec3<R> on_second(const Vec3<R>& moment) const {
    return (x1_ * moment.x + y1_ * moment.y) * f_.e3 + moment.z * turn2_;
  }

 private:
  Frame<R> f_;
  R x1_, y1_, x2_, y2_;
  Vec3<R> turn1_, turn2_;
};

}  // namespace

double cohesive_brick_area(const std::array<Vec3d, 8>& x) {
  const std::array<Vec3d, 4> m = midway(x);
  const double place = 1.0 / std::sqrt(3.0);
  double sum = 0.0;
  for (int p = 0; p < 4; ++p) sum += area_at(m, place * xi[p], place * eta[p]);
  return sum;
}

double cohesive_brick_thickness(const std::array<Vec3d, 8>& x) {
  const Frame3d f = axes_of(Directions<double>(x.data()));
  double sum = 0.0;
  for (std::size_t a = 0; a < 4; ++a) sum += 0.25 * dot(f.e3, x[a + 4] - x[a]);
  return sum;
}

double cohesive_brick_mass(const CohesiveBrickProperties& brick, const CohesiveBond& bond,
                           const std::array<Vec3d, 8>& x) {
  const double area = cohesive_brick_area(x);
  return brick.density * (bond.density_by_area ? area : area * cohesive_brick_thickness(x));
}

double cohesive_brick_nodal_inertia(const CohesiveBrickProperties& brick, const CohesiveBond& bond,
                                    const std::array<Vec3d, 8>& x) {
  if (!brick.between_shells) return 0.0;
  double longest = 0.0;
  for (std::size_t a = 0; a < 4; ++a) longest = std::max(longest, dot(x[a + 4] - x[a], x[a + 4] - x[a]));
  return 0.125 * cohesive_brick_mass(brick, bond, x) * 0.25 * longest;
}

void start_cohesive_brick(const CohesiveBrickProperties& brick, const CohesiveBond& bond, const std::array<Vec3d, 8>& x,
                          double* state, int width, int lane) {
  const auto put = [&](int i, double value) { state[i * width + lane] = value; };
  for (int i = 0; i < L::count; ++i) put(i, 0.0);
  put(L::alive, 1.0);
  put(L::density_scale, 1.0);
  put(L::nodal_mass, 0.125 * cohesive_brick_mass(brick, bond, x));
  put(L::nodal_inertia, cohesive_brick_nodal_inertia(brick, bond, x));
  const std::array<Vec3d, 4> m = midway(x);
  const double place = shapes_of(bond).place;
  put(L::thickness, cohesive_brick_thickness(x));
  for (int p = 0; p < 4; ++p) {
    put(L::point(p) + L::area, area_at(m, place * xi[p], place * eta[p]));
    put(L::point(p) + L::rate_at_yield, -1.0);
  }
}

template <class R>
NodalForces<R, 8> cohesive_brick_cycle(const CohesiveBrickProperties& brick, const CohesiveBond& bond,
                                       const NodalMotion<R, 8>& nodes, double dt, double* state) {
  const Shapes shapes = shapes_of(bond);
  const R zero(0.0);

  Vec3<R> middle[8];
  for (int a = 0; a < 8; ++a) middle[a] = nodes.x[a] - R(0.5 * dt) * nodes.v[a];
  const Directions<R> mid(middle), rate(nodes.v), end(nodes.x);
  const Frame<R> mid_axes = axes_of(mid), axes = axes_of(end);
  const Vec3<R> spin = mid_axes.global(Spin<R>(mid, mid_axes).of(rate));

  // Of the pairs of nodes: rate of separation as an observer on the surface midway sees it, and vectors at the end.
  Vec3<R> parting[4], gap[4];
  for (int a = 0; a < 4; ++a) {
    gap[a] = nodes.x[a + 4] - nodes.x[a];
    const Vec3<R> apart = nodes.v[a + 4] - nodes.v[a], gap_mid = gap[a] - R(0.5 * dt) * apart;
    Vec3<R> turning = spin;
    if (brick.between_shells) {
      // Velocities are chords of arcs; the factor tan(phi/2)/(phi/2) makes the nodes' spin one as well.
      turning = R(0.5) * (nodes.w[a] + nodes.w[a + 4]);
      const R q = R(dt * dt) * dot(turning, turning);
      turning = (R(1.0) + q * R(1.0 / 12.0) * (R(1.0) + R(0.1) * q)) * turning;
    }
    parting[a] = mid_axes.local(apart - cross(turning, gap_mid));
  }

  const R lives = load_field<R>(state, L::alive), thickness = load_field<R>(state, L::thickness);
  R failed(0.0), share[4]{}, spread(0.0);
  Vec3<R> force[4], moment{};  // on the upper corners; on the axes
  for (int p = 0; p < 4; ++p) {
    double* point = state + L::point(p) * lanes<R>;
    const R area = load_field<R>(point, L::area);
    Vec3<R> grows{}, apart{};
    for (int a = 0; a < 4; ++a) {
      const R n(shapes.n[p][a]);
      grows += n * parting[a];
      apart += n * gap[a];
      share[a] += n * area;
    }
    const Vec3<R> separation = load_vector<R>(point, L::separation) + R(dt) * grows;
    R damage = load_field<R>(point, L::damage);
    Vec3<R> traction;
    Vec3<R> plastic = load_vector<R>(point, L::plastic);
    R yielded = load_field<R>(point, L::rate_at_yield);
    for (int l = 0; l < lanes<R>; ++l) {
      if (!(lane(lives, l) > 0.5)) continue;
      const auto lane_of = [l](const Vec3<R>& a) { return Vec3d{lane(a.x, l), lane(a.y, l), lane(a.z, l)}; };
      CohesiveState now{lane(damage, l), 0.0, lane_of(plastic), lane(yielded, l)};
      const Vec3d t = bond_traction(bond, lane(thickness, l), lane_of(separation), lane_of(grows), now);
      const auto put = [l](Vec3<R>& to, const Vec3d& from) {
        set_lane(to.x, l, from.x);
        set_lane(to.y, l, from.y);
        set_lane(to.z, l, from.z);
      };
      put(traction, t);
      put(plastic, now.plastic);
      set_lane(damage, l, now.damage);
      set_lane(yielded, l, now.rate_at_yield);
    }
    store_vector(point, L::plastic, plastic);
    store_field(point, L::rate_at_yield, yielded);
    store_vector(point, L::separation, separation);
    store_vector(point, L::traction, traction);
    store_field(point, L::damage, damage);
    const auto is_lost = damage >= R(1.0);
    failed += select(is_lost, R(1.0), zero);
    spread += select(is_lost && separation.z >= zero, zero, area * dot(apart, apart));

    const Vec3<R> pull = area * axes.global(traction);
    for (int a = 0; a < 4; ++a) force[a] += R(shapes.n[p][a]) * pull;
    moment -= cross(apart, pull);
  }

  const auto alive =
      bond.points_to_delete > 0 ? lives > R(0.5) && failed < R(bond.points_to_delete - 0.5) : lives > R(0.5);
  store_field(state, L::alive, select(alive, R(1.0), zero));
  const Vec3<R> nothing{};
  NodalForces<R, 8> out;
  for (int a = 0; a < 4; ++a) {
    out.f[a + 4] = select(alive, force[a], nothing);
    out.f[a] = -out.f[a + 4];
  }
  const R scale = load_field<R>(state, L::density_scale);
  const R mass = scale * load_field<R>(state, L::nodal_mass);
  const Vec3<R> normal = cross(end.g1, end.g2);
  R largest = max(max(share[0], share[1]), max(share[2], share[3]));
  R reach = R(2.0) * largest;
  if (brick.between_shells) {
    R longest(0.0);
    for (int a = 0; a < 4; ++a) {
      const Vec3<R> couple = R(-0.5) * cross(gap[a], out.f[a + 4]);
      out.m[a] = out.m[a + 4] = couple;
      longest = max(longest, dot(gap[a], gap[a]));
    }
    const R inertia = scale * load_field<R>(state, L::nodal_inertia);
    const auto turns = inertia > zero;
    reach *= R(1.0) + select(turns, R(0.25) * longest * mass / select(turns, inertia, R(1.0)), zero);
  } else {
    const Spin<R> turner(end, axes);
    const Vec3<R> own = axes.local(moment);
    const Vec3<R> first = select(alive, turner.on_first(own), nothing),
                  second = select(alive, turner.on_second(own), nothing);
    for (int a = 0; a < 4; ++a) {
      const Vec3<R> both = R(0.25 * xi[a]) * first + R(0.25 * eta[a]) * second;
      out.f[a] += both;
      out.f[a + 4] += both;
    }
    reach += (R(0.5) * (dot(end.g1, end.g1) + dot(end.g2, end.g2)) / dot(normal, normal)) * spread;
  }
  const R stiffest = map([&bond](double t) { return bond.stiffest_in(t); }, thickness);
  out.stable_step = select(alive, R(2.0) * sqrt(mass / (stiffest * reach)), R(std::numeric_limits<double>::infinity()));
  return out;
}

template NodalForces<NativeBatch, 8> cohesive_brick_cycle(const CohesiveBrickProperties&, const CohesiveBond&,
                                                          const NodalMotion<NativeBatch, 8>&, double, double*);

}  // namespace nugget::kernel
