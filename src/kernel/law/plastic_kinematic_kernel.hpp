// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/j2.hpp"
#include "kernel/law/plastic_kinematic.hpp"

namespace nugget::kernel {

template <>
class LawKernel<PlasticKinematic> : public J2<BilinearHardening, true> {
 public:
  explicit LawKernel(const PlasticKinematic& law) : J2(law.E, law.nu, BilinearHardening(law), law.failure_strain) {}
  double deletion_step() const { return 0.0; }
};

}  // namespace nugget::kernel
