// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "kernel/law/honeycomb.hpp"
#include "kernel/law/orthotropic.hpp"

namespace nugget::kernel {
namespace {

/// The compacted modulus of component i.
double modulus_of(const ElasticConstants& e, std::size_t i) {
  return i < 3 ? e.E : e.shear;
}

/// Of a point whose normal strains make no stress across.
double uncoupled_wave_modulus(const std::array<double, 6>& m) {
  return fastest_wave_modulus({{{m[0], 0.0, 0.0}, {0.0, m[1], 0.0}, {0.0, 0.0, m[2]}}}, m[3], m[4], m[5]);
}

}  // namespace

LawKernel<Honeycomb>::LawKernel(const Honeycomb& law)
    : law_(law), compacted_(law.E, law.nu), soft_share_(*std::max_element(&law.modulus[0], &law.modulus[3]) / law.E) {
  for (std::size_t i = 0; i < 6; ++i) {
    std::size_t first = 0;
    while (law.limit[first].x != law.limit[i].x || law.limit[first].y != law.limit[i].y) ++first;
    same_[i] = static_cast<int>(first);
  }
  std::array<double, 6> dense{};
  for (std::size_t i = 0; i < 6; ++i) dense[i] = modulus_of(compacted_, i);
  const double longer = std::sqrt(1.0 + law.viscosity * law.viscosity) + law.viscosity;
  // Every state between is a mean of the two, and so slower than one of them.
  wave_modulus_ =
      longer * longer *
      std::max({compacted_.bulk_wave(), uncoupled_wave_modulus(dense), uncoupled_wave_modulus(law.modulus)});
}

template <class R>
std::array<R, 6> LawKernel<Honeycomb>::limits(const R& crushed, const std::array<R, 6>& strain) const {
  const bool by_volume = law_.over == Honeycomb::Over::volume;
  std::array<R, 6> most;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto same = at(same_[i]);
    if (by_volume && same < i) {
      most[i] = most[same];
      continue;
    }
    const R at = by_volume ? crushed : i < 3 ? -strain[i] : abs(strain[i]);
    most[i] = map([&](double x) { return std::max(law_.limit[i].extrapolated(x), 0.0); }, at);
  }
  return most;
}

template <class R>
SolidTensor<R> LawKernel<Honeycomb>::compacted(const SolidTensor<R>& s, const SolidTensor<R>& e) const {
  const double twice = 2.0 * compacted_.shear, bulk = compacted_.lambda + twice / 3.0;
  const R volume = e.xx + e.yy + e.zz, third = (1.0 / 3.0) * volume, mean = (1.0 / 3.0) * (s.xx + s.yy + s.zz);
  const SolidTensor<R> d{s.xx - mean + twice * (e.xx - third),
                         s.yy - mean + twice * (e.yy - third),
                         s.zz - mean + twice * (e.zz - third),
                         s.xy + twice * e.xy,
                         s.yz + twice * e.yz,
                         s.zx + twice * e.zx};
  const R effective =
      sqrt(1.5 * (d.xx * d.xx + d.yy * d.yy + d.zz * d.zz) + 3.0 * (d.xy * d.xy + d.yz * d.yz + d.zx * d.zx));
  SolidTensor<R> held = (law_.yield / max(effective, R(law_.yield))) * d;
  const R now = mean + bulk * volume;
  held.xx += now;
  held.yy += now;
  held.zz += now;
  return held;
}

template <class R>
void LawKernel<Honeycomb>::solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const {
  const Frame<R> axes = load_solid_axes<R>(history);
  const SolidTensor<R> e = strain_in_axes(axes, rate, dt), old = rotated(axes, s);
  const std::array<R, 6> change{e.xx, e.yy, e.zz, 2.0 * e.xy, 2.0 * e.yz, 2.0 * e.zx};

  // V grows by (1 + h) / (1 - h) with h of the mid-step rate: exact for a straight pull.
  const auto grow = [&](int field, const R& by) {
    const R before = load_field<R>(history, field), half = 0.5 * by;
    const R now = before + (1.0 + before) * (by / (1.0 - half));
    store_field(history, field, now);
    return now;
  };
  const R grown = grow(volume_field, change[0] + change[1] + change[2]), beta = compaction(grown);
  std::array<R, 6> strain;
  for (int i = 0; i < 6; ++i) {
    R& now = strain[i];
    const R& by = change[i];
    if (i < 3 && law_.over == Honeycomb::Over::engineering_strain) {
      now = grow(strain_field + i, by);
    } else {
      now = load_field<R>(history, strain_field + i) + by;
      store_field(history, strain_field + i, now);
    }
  }

  const std::array<R, 6> most = limits(-grown, strain);
  R factor(1.0);
  if (!law_.rate_factor.empty() && dt > 0.0) {
    const R third = (1.0 / 3.0) * (e.xx + e.yy + e.zz), x = e.xx - third, y = e.yy - third, z = e.zz - third;
    const R norm = (1.0 / dt) * sqrt(x * x + y * y + z * z + 2.0 * (e.xy * e.xy + e.yz * e.yz + e.zx * e.zx));
    factor = map([&](double d) { return law_.rate_factor.clamped(d); }, norm);
  }
  std::array<R, 6> elastic{old.xx, old.yy, old.zz, old.xy, old.yz, old.zx}, viscous, held;
  for (std::size_t i = 0; i < 6; ++i) {
    const R modulus = R(law_.modulus[i]) + (modulus_of(compacted_, i) - law_.modulus[i]) * beta;
    const int field = viscous_field + static_cast<int>(i);
    elastic[i] -= load_field<R>(history, field);
    viscous[i] = law_.viscosity * modulus * change[i];
    store_field(history, field, viscous[i]);
    const R limit = factor * most[i];
    held[i] = min(max(elastic[i] + modulus * change[i], -limit), limit);
  }
  const auto tensor = [](const std::array<R, 6>& t) { return SolidTensor<R>{t[0], t[1], t[2], t[3], t[4], t[5]}; };
  SolidTensor<R> now = tensor(held);
  const auto dense = beta >= R(1.0);
  if (any(dense)) now = select(dense, compacted(tensor(elastic), e), now);
  s = out_of_axes(axes, now + tensor(viscous));
}

template void LawKernel<Honeycomb>::solid(SolidTensor<NativeBatch>&, const SolidTensor<NativeBatch>&, double,
                                          double*) const;

}  // namespace nugget::kernel
