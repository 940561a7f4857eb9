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

// The plastic return is not inlined: law/plastic_returns.cpp has it for all elements.
extern template void J2<BilinearHardening, true>::flow<NativeBatch>(LayerTensor<NativeBatch>&, double,
                                                                    Number<NativeBatch>*,
                                                                    ThicknessStrain<NativeBatch>&) const;
extern template void J2<BilinearHardening, true>::flow<NativeBatch>(SolidTensor<NativeBatch>&, double,
                                                                    Number<NativeBatch>*) const;
extern template void J2<BilinearHardening, true>::flow<SingleBatch>(LayerTensor<SingleBatch>&, double,
                                                                    Number<SingleBatch>*,
                                                                    ThicknessStrain<SingleBatch>&) const;
extern template void J2<BilinearHardening, true>::flow<SingleBatch>(SolidTensor<SingleBatch>&, double,
                                                                    Number<SingleBatch>*) const;
extern template void J2<BilinearHardening, true>::flow<NativeBatch>(FibreTensor<NativeBatch>&, double,
                                                                    Number<NativeBatch>*) const;

}  // namespace nugget::kernel
