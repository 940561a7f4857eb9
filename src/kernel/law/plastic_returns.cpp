// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/piecewise_linear_kernel.hpp"
#include "kernel/law/plastic_kinematic_kernel.hpp"
#include "kernel/law/spotweld_kernel.hpp"

namespace nugget::kernel {

template void J2<CurveHardening, false>::flow<NativeBatch>(LayerTensor<NativeBatch>&, double, Number<NativeBatch>*,
                                                           ThicknessStrain<NativeBatch>&) const;
template void J2<CurveHardening, false>::flow<NativeBatch>(SolidTensor<NativeBatch>&, double,
                                                           Number<NativeBatch>*) const;
template void J2<CurveHardening, false>::flow<SingleBatch>(LayerTensor<SingleBatch>&, double, Number<SingleBatch>*,
                                                           ThicknessStrain<SingleBatch>&) const;
template void J2<CurveHardening, false>::flow<SingleBatch>(SolidTensor<SingleBatch>&, double,
                                                           Number<SingleBatch>*) const;
template void J2<CurveHardening, false>::flow<NativeBatch>(FibreTensor<NativeBatch>&, double,
                                                           Number<NativeBatch>*) const;

template void J2<BilinearHardening, true>::flow<NativeBatch>(LayerTensor<NativeBatch>&, double, Number<NativeBatch>*,
                                                             ThicknessStrain<NativeBatch>&) const;
template void J2<BilinearHardening, true>::flow<NativeBatch>(SolidTensor<NativeBatch>&, double,
                                                             Number<NativeBatch>*) const;
template void J2<BilinearHardening, true>::flow<SingleBatch>(LayerTensor<SingleBatch>&, double, Number<SingleBatch>*,
                                                             ThicknessStrain<SingleBatch>&) const;
template void J2<BilinearHardening, true>::flow<SingleBatch>(SolidTensor<SingleBatch>&, double,
                                                             Number<SingleBatch>*) const;
template void J2<BilinearHardening, true>::flow<NativeBatch>(FibreTensor<NativeBatch>&, double,
                                                             Number<NativeBatch>*) const;

template void J2<WeldHardening, false>::flow<NativeBatch>(SolidTensor<NativeBatch>&, double,
                                                          Number<NativeBatch>*) const;
template void J2<WeldHardening, false>::flow<NativeBatch>(FibreTensor<NativeBatch>&, double,
                                                          Number<NativeBatch>*) const;

}  // namespace nugget::kernel
