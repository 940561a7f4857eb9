// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/single_points.hpp"

#include <cmath>

namespace nugget::kernel {
namespace {

using Tensor = SolidTensor<double>;

/// Tensorial shears from engineering shears.
Tensor tensorial(const Tensor& d) {
  return {d.xx, d.yy, d.zz, 0.5 * d.xy, 0.5 * d.yz, 0.5 * d.zx};
}
Tensor plus(Tensor a, double x) {
  a.xx += x;
  a.yy += x;
  a.zz += x;
  return a;
}
double trace(const Tensor& a) {
  return a.xx + a.yy + a.zz;
}
double determinant(const Tensor& a) {
  return a.xx * (a.yy * a.zz - a.yz * a.yz) - a.xy * (a.xy * a.zz - a.yz * a.zx) + a.zx * (a.xy * a.yz - a.yy * a.zx);
}
Tensor inverse(const Tensor& a) {
  const double over = 1.0 / determinant(a);
  return {over * (a.yy * a.zz - a.yz * a.yz), over * (a.xx * a.zz - a.zx * a.zx), over * (a.xx * a.yy - a.xy * a.xy),
          over * (a.zx * a.yz - a.xy * a.zz), over * (a.xy * a.zx - a.xx * a.yz), over * (a.xy * a.yz - a.zx * a.yy)};
}
/// a b of symmetric tensors that commute.
Tensor times(const Tensor& a, const Tensor& b) {
  return {a.xx * b.xx + a.xy * b.xy + a.zx * b.zx, a.xy * b.xy + a.yy * b.yy + a.yz * b.yz,
          a.zx * b.zx + a.yz * b.yz + a.zz * b.zz, a.xx * b.xy + a.xy * b.yy + a.zx * b.yz,
          a.xy * b.zx + a.yy * b.yz + a.yz * b.zz, a.xx * b.zx + a.xy * b.yz + a.zx * b.zz};
}
/// c b c, both symmetric.
Tensor between(const Tensor& c, const Tensor& b) {
  const Frame3d rows{{c.xx, c.xy, c.zx}, {c.xy, c.yy, c.yz}, {c.zx, c.yz, c.zz}};
  return rotated(rows, b);
}

Tensor load(std::span<double> h) {
  return {h[0], h[1], h[2], h[3], h[4], h[5]};
}
void store(std::span<double> h, const Tensor& a) {
  h[0] = a.xx, h[1] = a.yy, h[2] = a.zz, h[3] = a.xy, h[4] = a.yz, h[5] = a.zx;
}

/// Area under a curve from 0 to x; beyond its ends with its last slopes.
double area(const Curve& curve, double x) {
  double sum = 0.0, from = 0.0;
  for (const double end : curve.x) {
    if (end <= 0.0) continue;
    if (end >= x) break;
    sum += 0.5 * (end - from) * (curve.extrapolated(from) + curve.extrapolated(end));
    from = end;
  }
  return sum + 0.5 * (x - from) * (curve.extrapolated(from) + curve.extrapolated(x));
}

/// Strains so small that a rubber is linear; its formulas would lose their digits.
bool small(const Tensor& e) {
  return std::max({std::abs(e.xx), std::abs(e.yy), std::abs(e.zz), std::abs(e.xy), std::abs(e.yz), std::abs(e.zx)}) <
         1e-8;
}
/// Linear elastic stress of b - 1.
PointUpdate linear(double E, double nu, const Tensor& e) {
  const ElasticConstants c(E, nu);
  return {plus(c.shear * e, 0.5 * c.lambda * trace(e)), c.bulk_wave()};
}

}  // namespace

Principal principal_axes(const Tensor& tensor) {
  double a[3][3] = {
      {tensor.xx, tensor.xy, tensor.zx}, {tensor.xy, tensor.yy, tensor.yz}, {tensor.zx, tensor.yz, tensor.zz}};
  double v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int sweep = 0; sweep < 30; ++sweep) {
    const double off = std::abs(a[0][1]) + std::abs(a[1][2]) + std::abs(a[0][2]);
    if (off <= 1e-16 * (std::abs(a[0][0]) + std::abs(a[1][1]) + std::abs(a[2][2]))) break;
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        if (a[p][q] == 0.0) continue;
        const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
        const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
        const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
        for (int k = 0; k < 3; ++k) {
          const double kp = a[k][p], kq = a[k][q];
          a[k][p] = c * kp - s * kq;
          a[k][q] = s * kp + c * kq;
        }
        for (int k = 0; k < 3; ++k) {
          const double pk = a[p][k], qk = a[q][k], vp = v[k][p], vq = v[k][q];
          a[p][k] = c * pk - s * qk;
          a[q][k] = s * pk + c * qk;
          v[k][p] = c * vp - s * vq;
          v[k][q] = s * vp + c * vq;
        }
      }
  }
  int order[3] = {0, 1, 2};
  std::sort(order, order + 3, [&](int i, int j) { return a[i][i] < a[j][j]; });
  Principal p;
  for (std::size_t i = 0; i < 3; ++i) {
    const int k = order[i];
    p.value[i] = a[k][k];
    p.direction[i] = {v[0][k], v[1][k], v[2][k]};
  }
  return p;
}

Tensor with_values(const Principal& axes, const std::array<double, 3>& value) {
  Tensor t{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d& n = axes.direction[i];
    t = t + value[i] * Tensor{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
  }
  return t;
}

void stretch(Tensor& b_less_one, const Tensor& d, double dt) {
  // With g = c - 1 = (1 - d dt/2)^-1 d dt: c b c - 1 = 2 g + g g + c (b - 1) c. Nothing is subtracted from 1, so that
  // the smallest steps count (docs/decisions/0017).
  const Tensor change = dt * tensorial(d);
  const Tensor g = times(inverse(plus(-0.5 * change, 1.0)), change);
  b_less_one = 2.0 * g + times(g, g) + between(plus(g, 1.0), b_less_one);
}

MooneyRivlinPoint::MooneyRivlinPoint(const MooneyRivlin& law)
    : E_(law.E),
      nu_(law.nu),
      a_(law.a),
      b_(law.b),
      c_(0.5 * law.a + law.b),
      d_((law.a * (5.0 * law.nu - 2.0) + law.b * (11.0 * law.nu - 5.0)) / (2.0 * (1.0 - 2.0 * law.nu))) {}

PointUpdate MooneyRivlinPoint::update(const Tensor&, const Tensor& d, double dt, std::span<double> h) const {
  Tensor e = load(h);
  stretch(e, d, dt);
  store(h, e);
  if (small(e)) return linear(E_, nu_, e);
  const Tensor b = plus(e, 1.0);
  const double first = trace(b), third = determinant(b), J = std::sqrt(third);
  // sigma = 2/J [(W1 + I W2) b - W2 b b + III W3]
  const double volume = third * (-2.0 * c_ / (third * third * third) + 2.0 * d_ * (third - 1.0));
  const Tensor stress = (2.0 / J) * plus((a_ + first * b_) * b + (-b_) * times(b, b), volume);
  // d(2 III W3 / J) / d ln J, and at most 2 (A + 2 B I) I / J of the rest.
  const double V = 20.0 * c_ / std::pow(J, 5.0) + 4.0 * d_ * (3.0 * J * J * J - J);
  return {stress, V + 2.0 / J * (std::abs(a_) + 2.0 * std::abs(b_) * first) * first};
}

OgdenPoint::OgdenPoint(const Ogden& law)
    : E_(law.E), nu_(law.nu), terms_(law.terms), bulk_(law.E / (3.0 * (1.0 - 2.0 * law.nu))) {}

PointUpdate OgdenPoint::update(const Tensor&, const Tensor& d, double dt, std::span<double> h) const {
  Tensor e = load(h);
  stretch(e, d, dt);
  store(h, e);
  if (small(e)) return linear(E_, nu_, e);
  const Tensor b = plus(e, 1.0);
  const Principal axes = principal_axes(b);
  const double J = std::sqrt(determinant(b)), shrink = 1.0 / std::cbrt(J);
  std::array<double, 3> stress{};
  double stiffness = 0.0;
  for (const Ogden::Term& term : terms_) {
    std::array<double, 3> power;
    for (std::size_t i = 0; i < 3; ++i)
      power[i] = term.mu * std::pow(shrink * std::sqrt(axes.value[i]), term.alpha) / J;
    const double mean = (power[0] + power[1] + power[2]) / 3.0;
    for (std::size_t i = 0; i < 3; ++i) stress[i] += power[i] - mean;
    stiffness += std::abs(term.alpha) * std::abs(std::max(std::abs(power[0]), std::abs(power[2])));
  }
  for (double& s : stress) s += bulk_ * (J - 1.0) / J;
  return {with_values(axes, stress), bulk_ / J + 2.0 * stiffness};
}

PointUpdate LowDensityFoamPoint::update(const Tensor&, const Tensor& d, double dt, std::span<double> h) const {
  Tensor e = load(h);
  stretch(e, d, dt);
  store(h, e);
  const Principal axes = principal_axes(e);
  const double J = std::sqrt(determinant(plus(e, 1.0)));
  std::array<double, 3> stress{}, stretches{};
  double energy = 0.0, slope = law_.E;
  for (std::size_t i = 0; i < 3; ++i) {
    const double l = std::sqrt(1.0 + axes.value[i]), strain = axes.value[i] / (1.0 + l);  // l - 1
    stretches[i] = l;
    if (strain < 0.0) {
      stress[i] = -law_.compression.extrapolated(-strain);
      energy += area(law_.compression, -strain);
      slope = std::max(slope, law_.compression.slope(-strain));
    } else {
      const double pull = law_.E * strain;
      if (law_.tears && pull >= law_.cutoff) h[7] = 1.0;
      stress[i] = h[7] > 0.0 ? 0.0 : std::min(pull, law_.cutoff);
    }
  }
  h[6] = std::max(h[6], energy);
  const double left = h[6] > 0.0 ? law_.unloading + (1.0 - law_.unloading) * std::pow(energy / h[6], law_.shape) : 1.0;
  double most = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (stress[i] < 0.0) stress[i] *= left;
    // Nominal stress to true stress; a nominal slope to a true one.
    most = std::max(most, stretches[i] * stretches[i] / J);
    stress[i] *= stretches[i] / J;
  }
  return {with_values(axes, stress), slope * most};
}

PointUpdate CrushableFoamPoint::update(const Tensor& s, const Tensor& d, double dt, std::span<double> h) const {
  const double half = 0.5 * dt * trace(d);
  h[0] += std::log((1.0 + half) / (1.0 - half));
  const double crushed = 1.0 - std::exp(h[0]), yield = law_.yield.extrapolated(std::max(crushed, 0.0));
  const Tensor trial = s + (law_.E * dt) * tensorial(d);
  const Principal axes = principal_axes(trial);
  if (axes.value[0] >= -yield && axes.value[2] <= law_.cutoff) return {trial, law_.E};
  std::array<double, 3> stress = axes.value;
  for (double& value : stress) value = std::clamp(value, -yield, law_.cutoff);
  return {with_values(axes, stress), law_.E};
}

PointUpdate ViscoelasticPoint::update(const Tensor& s, const Tensor& d, double dt, std::span<double> h) const {
  const double volume = trace(d), x = law_.decay * dt;
  const double kept = std::exp(-x), mean = x > 0.0 ? -std::expm1(-x) / x : 1.0;
  const Tensor deviator = plus(tensorial(d), -volume / 3.0), old = load(h);
  const Tensor decaying = kept * old + (2.0 * (law_.at_once - law_.in_the_end) * mean * dt) * deviator;
  store(h, decaying);
  const Tensor lasting = s + (-1.0) * old + (2.0 * law_.in_the_end * dt) * deviator;
  return {plus(lasting + decaying, law_.bulk * dt * volume), law_.bulk + 4.0 / 3.0 * law_.at_once};
}

}  // namespace nugget::kernel
