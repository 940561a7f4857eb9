// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/axes_field.hpp"

namespace nugget::kernel {

void start_layer_axes(double* history, int stride, double cosine, double sine) {
  double* axis = history + first_axis_field * stride;
  axis[0] = cosine;
  axis[stride] = sine;
}

void start_solid_axes(double* history, int stride, const Frame3d& axes) {
  double* axis = history + first_axis_field * stride;
  for (const double component : {axes.e1.x, axes.e1.y, axes.e1.z, axes.e2.x, axes.e2.y, axes.e2.z}) {
    *axis = component;
    axis += stride;
  }
}

}  // namespace nugget::kernel
