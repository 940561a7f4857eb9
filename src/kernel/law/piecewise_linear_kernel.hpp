// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/j2.hpp"
#include "kernel/law/piecewise_linear.hpp"

namespace nugget::kernel {

template <>
class LawKernel<PiecewiseLinear> : public J2<CurveHardening, false> {
 public:
  explicit LawKernel(const PiecewiseLinear& law)
      : J2(law.E, law.nu, CurveHardening(law), law.failure_strain), deletion_step_(law.deletion_step) {}
  double deletion_step() const { return deletion_step_; }

 private:
  double deletion_step_;
};

}  // namespace nugget::kernel
