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

// The plastic return is not inlined: law/plastic_returns.cpp has it for all elements.
extern template void J2<CurveHardening, false>::flow<NativeBatch>(LayerTensor<NativeBatch>&, double,
                                                                  Number<NativeBatch>*,
                                                                  ThicknessStrain<NativeBatch>&) const;
extern template void J2<CurveHardening, false>::flow<NativeBatch>(SolidTensor<NativeBatch>&, double,
                                                                  Number<NativeBatch>*) const;
extern template void J2<CurveHardening, false>::flow<SingleBatch>(LayerTensor<SingleBatch>&, double,
                                                                  Number<SingleBatch>*,
                                                                  ThicknessStrain<SingleBatch>&) const;
extern template void J2<CurveHardening, false>::flow<SingleBatch>(SolidTensor<SingleBatch>&, double,
                                                                  Number<SingleBatch>*) const;
extern template void J2<CurveHardening, false>::flow<NativeBatch>(FibreTensor<NativeBatch>&, double,
                                                                  Number<NativeBatch>*) const;

}  // namespace nugget::kernel
