// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/woven_fabric.hpp"

#include <cmath>

#include "kernel/law/orthotropic.hpp"

namespace nugget::kernel {
namespace {

std::array<double, 3> moduli_of_threads(const WovenFabric& law) {
  return {law.young_a, law.young_b, law.shear_ab};
}

}  // namespace

double WovenFabric::wave_modulus() const {
  if (!by_curves) return Fabric::wave_modulus();
  std::array<double, 3> steepest = moduli_of_threads(*this);
  for (std::size_t k = 0; k < 3; ++k) {
    if (curves[k]) steepest[k] = curves[k]->steepest();
    steepest[k] *= 1.0 - liner_share;
  }
  const SheetModuli l = liner_moduli();
  return fastest_wave_modulus({{{steepest[0] + l.aa, l.ab, 0.0}, {l.ab, steepest[1] + l.bb, 0.0}, {0.0, 0.0, 0.0}}},
                              steepest[2] + l.shear, 0.0, 0.0);
}

LawKernel<WovenFabric>::LawKernel(const WovenFabric& law)
    : axes_(law.axes),
      fabric_(law.fabric_moduli()),
      liner_(law.liner_moduli()),
      wrinkling_(fabric_),
      curves_(law.curves),
      moduli_(moduli_of_threads(law)),
      share_(1.0 - law.liner_share),
      no_compression_(law.no_compression),
      has_liner_(law.liner_share > 0.0),
      by_curves_(law.by_curves),
      damping_(law.damping),
      step_share_(1.0 / std::sqrt(1.0 + 2.0 * law.damping)),
      wave_modulus_(law.wave_modulus()) {}

}  // namespace nugget::kernel
