// SPDX-License-Identifier: Apache-2.0
#include "system/block_strains.hpp"

#include <algorithm>
#include <utility>

#include "base/index.hpp"
#include "kernel/element/c0_triangle.hpp"
#include "kernel/element/kirchhoff_triangle.hpp"
#include "kernel/element/quadratic_tetrahedron.hpp"
#include "kernel/element/quadrilateral.hpp"
#include "system/archive_by_element.hpp"

namespace nugget::system {
namespace {

/// Derivatives of a field by a brick's natural coordinates xi, eta, zeta amid the surface zeta = `height`.
template <class R>
std::array<Vec3<R>, 3> derivatives(std::span<const Vec3<R>> f, double height) {
  // Of the lower and the upper face: differences along its diagonals.
  const Vec3<R> low = f[2] - f[0], low_other = f[3] - f[1], high = f[6] - f[4], high_other = f[7] - f[5];
  const R below(0.125 * (1.0 - height)), above(0.125 * (1.0 + height));
  return {below * (low - low_other) + above * (high - high_other),
          below * (low + low_other) + above * (high + high_other),
          R(0.125) * (((f[4] + f[6]) + (f[5] + f[7])) - ((f[0] + f[2]) + (f[1] + f[3])))};
}

/// Velocity gradient there: rows are the gradients of the velocity's components.
template <class R>
std::array<Vec3<R>, 3> velocity_gradient(std::span<const Vec3<R>> x, std::span<const Vec3<R>> v, double height) {
  const std::array<Vec3<R>, 3> along = derivatives(x, height), rate = derivatives(v, height);
  const std::array<Vec3<R>, 3> area{cross(along[1], along[2]), cross(along[2], along[0]), cross(along[0], along[1])};
  const R volume = dot(along[0], area[0]);
  const R over = select(volume > R(0.0), 1.0 / volume, R(0.0));
  std::array<Vec3<R>, 3> gradient{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<R> dual = over * area[i];
    gradient[0] += rate[i].x * dual;
    gradient[1] += rate[i].y * dual;
    gradient[2] += rate[i].z * dual;
  }
  return gradient;
}

template <class R>
R load_doubles(const double* values) {
  if constexpr (is_single<R>)
    return each_lane<R>([&](int l) { return values[l]; });
  else
    return real_load<R>(values);
}

/// What a turn by the small angles `turn` about the axes adds to the tensor s, components xx yy zz xy yz zx: W s - s W.
template <class R>
std::array<R, 6> turned_by(const Vec3<R>& turn, const std::array<R, 6>& s) {
  const auto [xx, yy, zz, xy, yz, zx] = s;
  return {2.0 * (turn.y * zx - turn.z * xy),
          2.0 * (turn.z * xy - turn.x * yz),
          2.0 * (turn.x * yz - turn.y * zx),
          turn.z * (xx - yy) + turn.y * yz - turn.x * zx,
          turn.x * (yy - zz) + turn.z * zx - turn.y * xy,
          turn.y * (zz - xx) + turn.x * xy - turn.z * yz};
}

/// Adds a step with the velocity gradient `g` to the tensors whose components xx yy zz xy yz zx stand at `values`.
template <class R, class Active>
void add_step(double* values, const std::array<Vec3<R>, 3>& g, double step, const Active& active) {
  constexpr std::size_t width = lanes<R>;
  // Half the curl; the strain so far turns with the element, by what it is in the middle of the turn.
  const R dt(step), half(0.5 * step);
  const Vec3<R> turn{half * (g[2].y - g[1].z), half * (g[0].z - g[2].x), half * (g[1].x - g[0].y)};
  std::array<R, 6> strain;
  for (std::size_t c = 0; c < 6; ++c) strain[c] = load_doubles<R>(values + c * width);
  const std::array<R, 6> first = turned_by(turn, strain);
  for (std::size_t c = 0; c < 6; ++c) strain[c] += 0.5 * first[c];
  std::array<R, 6> more = turned_by(turn, strain);
  more[0] += dt * g[0].x;
  more[1] += dt * g[1].y;
  more[2] += dt * g[2].z;
  more[3] += half * (g[0].y + g[1].x);
  more[4] += half * (g[1].z + g[2].y);
  more[5] += half * (g[2].x + g[0].z);
  for (std::size_t c = 0; c < 6; ++c) add_as_doubles(values + c * width, select(active, more[c], R(0.0)));
}

/// Which of `count` nodes stands at corner a of a brick: a tetrahedron repeats its last one, a wedge its last two.
std::size_t node_at(std::size_t a, std::size_t count) {
  return count == 6 && a > 4 ? 4 + (a - 4) / 2 : std::min(a, count - 1);
}

/// Places half a step dt before `x`, of `count` nodes, of which some may be the same.
template <std::size_t count, class R>
std::array<Vec3<R>, count> at_mid_step(std::span<const Vec3<R>> x, std::span<const Vec3<R>> v, double dt) {
  std::array<Vec3<R>, count> mid;
  for (std::size_t a = 0; a < count; ++a) {
    const std::size_t own = node_at(a, x.size());
    mid[a] = x[own] - R(0.5 * dt) * v[own];
  }
  return mid;
}

/// What a step adds to the strains of a flat shell, in its frame at mid-step: at its middle, and by its distance from
/// there.
template <class R>
struct FlatStep {
  R xx, yy, xy, bent_xx, bent_yy, bent_xy, yz, zx;
};

template <class R>
FlatStep<R> step_of_quadrilateral(std::span<const Vec3<R>> x, std::span<const Vec3<R>> v, std::span<const Vec3<R>> w,
                                  const R& dt) {
  const Vec3<R> places[4] = {x[0], x[1], x[2], x[3]};
  const kernel::Quadrilateral<R> mid(places);
  const Vec3<R> v13 = mid.frame.local(v[0] - v[2]), v24 = mid.frame.local(v[1] - v[3]);
  const Vec3<R> w13 = mid.frame.local(w[0] - w[2]), w24 = mid.frame.local(w[1] - w[3]);
  const Vec3<R> spin = R(0.25) * mid.frame.local((w[0] + w[1]) + (w[2] + w[3]));
  const R half = 0.5 * dt;
  return {.xx = dt * mid.dx(v13.x, v24.x),
          .yy = dt * mid.dy(v13.y, v24.y),
          .xy = half * (mid.dx(v13.y, v24.y) + mid.dy(v13.x, v24.x)),
          .bent_xx = dt * mid.dx(w13.y, w24.y),
          .bent_yy = -dt * mid.dy(w13.x, w24.x),
          .bent_xy = half * (mid.dy(w13.y, w24.y) - mid.dx(w13.x, w24.x)),
          .yz = half * (mid.dy(v13.z, v24.z) - spin.x),
          .zx = half * (mid.dx(v13.z, v24.z) + spin.y)};
}

FlatStep<double> step_of_triangle(const std::array<Vec3d, 3>& at, std::array<Vec3d, 3> v, std::array<Vec3d, 3> w,
                                  double dt, bool follows_bubbles) {
  const Frame3d frame = kernel::triangle_frame(at);
  std::array<Vec3d, 3> x;
  for (std::size_t a = 0; a < 3; ++a) {
    x[a] = frame.local(at[a]);
    v[a] = frame.local(v[a]);
    w[a] = frame.local(w[a]);
  }
  // Gradients, b_x = (y(next) - y(before)) / 2A.
  double twice_area = 0.0;
  Vec3d v_x{}, v_y{}, w_x{}, w_y{}, spin{};
  for (std::size_t a = 0; a < 3; ++a) {
    const Vec3d &next = x[(a + 1) % 3], &before = x[(a + 2) % 3];
    const double bx = next.y - before.y, by = before.x - next.x;
    twice_area += x[a].x * bx;
    v_x += bx * v[a];
    v_y += by * v[a];
    w_x += bx * w[a];
    w_y += by * w[a];
    spin += (1.0 / 3.0) * w[a];
  }
  const double scale = dt / twice_area;
  FlatStep<double> d{.xx = scale * v_x.x,
                     .yy = scale * v_y.y,
                     .xy = 0.5 * scale * (v_y.x + v_x.y),
                     .bent_xx = scale * w_x.y,
                     .bent_yy = -scale * w_y.x,
                     .bent_xy = 0.5 * scale * (w_y.y - w_x.x),
                     .yz = 0.5 * (scale * v_y.z - dt * spin.x),
                     .zx = 0.5 * (scale * v_x.z + dt * spin.y)};
  if (!follows_bubbles) return d;
  const auto more = kernel::kirchhoff_mean_bending(x, v, w);
  d.bent_xx += dt * more[0];
  d.bent_yy += dt * more[1];
  d.bent_xy += 0.5 * dt * more[2];
  d.yz = d.zx = 0.0;
  return d;
}

template <class R, std::size_t count>
std::array<Vec3d, count> lane_of(std::span<const Vec3<R>> rows, int l) {
  std::array<Vec3d, count> own;
  for (std::size_t a = 0; a < count; ++a) own[a] = {lane(rows[a].x, l), lane(rows[a].y, l), lane(rows[a].z, l)};
  return own;
}

template <class R>
FlatStep<R> step_of_triangles(std::span<const Vec3<R>> x, std::span<const Vec3<R>> v, std::span<const Vec3<R>> w,
                              double dt, bool follows_bubbles) {
  FlatStep<R> d{};
  for (int l = 0; l < lanes<R>; ++l) {
    const FlatStep<double> own =
        step_of_triangle(lane_of<R, 3>(x, l), lane_of<R, 3>(v, l), lane_of<R, 3>(w, l), dt, follows_bubbles);
    set_lane(d.xx, l, own.xx);
    set_lane(d.yy, l, own.yy);
    set_lane(d.xy, l, own.xy);
    set_lane(d.bent_xx, l, own.bent_xx);
    set_lane(d.bent_yy, l, own.bent_yy);
    set_lane(d.bent_xy, l, own.bent_xy);
    set_lane(d.yz, l, own.yz);
    set_lane(d.zx, l, own.zx);
  }
  return d;
}

template <class R>
std::array<Vec3<R>, 3> gradient_of_quadratic_tetrahedra(std::span<const Vec3<R>> x, std::span<const Vec3<R>> v) {
  std::array<Vec3<R>, 3> gradient{};
  for (int l = 0; l < lanes<R>; ++l) {
    const auto own = kernel::quadratic_tetrahedron_gradient(lane_of<R, 10>(x, l), lane_of<R, 10>(v, l));
    for (std::size_t i = 0; i < 3; ++i) {
      set_lane(gradient[i].x, l, own[i].x);
      set_lane(gradient[i].y, l, own[i].y);
      set_lane(gradient[i].z, l, own[i].z);
    }
  }
  return gradient;
}

}  // namespace

template <class N>
void BlockStrains<N>::start(StrainRule rule, std::size_t elements) {
  rule_ = std::move(rule);
  rule_.offset.resize(rule_.of == StrainRule::Of::shells ? elements : 0);
  values_.resize(elements * rule_.numbers());
}

template <class N>
void BlockStrains<N>::add(std::size_t b, std::span<const Vec3<R>> x, std::span<const Vec3<R>> v,
                          std::span<const Vec3<R>> w, const R& active, const R& thickness, double dt) {
  const auto is_active = R(0.0) < active;
  double* const values = &values_[b * rule_.numbers() * width];
  if (rule_.of == StrainRule::Of::shells) {
    const FlatStep<R> d = x.size() == 4
                              ? step_of_quadrilateral<R>(at_mid_step<4>(x, v, dt), v, w, R(dt))
                              : step_of_triangles<R>(at_mid_step<3>(x, v, dt), v, w, dt, rule_.follows_bubbles);
    const R offset = each_lane<R>([&](int l) { return rule_.offset[b * width + at(l)]; });
    for (const bool upper : {false, true}) {
      const R z = offset + (0.5 * thickness) * R(upper ? rule_.upper : rule_.lower);
      const std::array<R, 5> more{d.xx + z * d.bent_xx, d.yy + z * d.bent_yy, d.xy + z * d.bent_xy, d.yz, d.zx};
      for (std::size_t c = 0; c < 5; ++c)
        add_as_doubles(values + ((upper ? 5 : 0) + c) * width, select(is_active, more[c], R(0.0)));
    }
    return;
  }
  if (x.size() == 10)
    return add_step(values, gradient_of_quadratic_tetrahedra<R>(at_mid_step<10>(x, v, dt), v), dt, is_active);
  const std::array<Vec3<R>, 8> mid = at_mid_step<8>(x, v, dt);
  std::array<Vec3<R>, 8> repeated;
  if (v.size() < 8) {
    for (std::size_t a = 0; a < 8; ++a) repeated[a] = v[node_at(a, v.size())];
    v = repeated;
  }
  const auto add_at = [&](double height, std::size_t first) {
    add_step(values + first * width, velocity_gradient<R>(mid, v, height), dt, is_active);
  };
  add_at(x.size() == 6 ? -1.0 / 3.0 : 0.0, 0);  // the middle of a wedge's triangles
  if (rule_.of != StrainRule::Of::thick_shells) return;
  add_at(rule_.lower, 6);
  add_at(rule_.upper, 12);
}

template <class N>
void BlockStrains<N>::leave(std::size_t first_block, std::size_t end) {
  forget(values_, first_block * rule_.numbers() * width, end * rule_.numbers() * width);
}

template <class N>
void BlockStrains<N>::carry(std::size_t first_block, std::size_t end, Parcel& parcel) {
  const std::size_t of_block = rule_.numbers() * width;
  if (of_block > 0) parcel(&values_[first_block * of_block], (end - first_block) * of_block);
}

template <class N>
void BlockStrains<N>::archive(Archive& a, const Archive::Holders& holders) {
  archive_by_element(a, values_, rule_.numbers(), width, holders);
}

template class BlockStrains<double>;
template class BlockStrains<float>;

}  // namespace nugget::system
