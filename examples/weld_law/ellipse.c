// SPDX-License-Identifier: Apache-2.0
// A failure function of one's own in C: an ellipse with exponents and strengths that grow with the strain rate.
//
//     f = (max(N_rr, 0) / s USRV1)^USRV3 + (sqrt(N_rs^2 + N_rt^2) / s USRV2)^USRV3,   s = 1 + USRV4 ln(1 + rate / USRV5)
//
//     cc -O2 -shared -fPIC -I src/model examples/weld_law/ellipse.c -o ellipse.so -lm
//     nugget run MODEL.k --weld-law ./ellipse.so
#include <math.h>

#include "nugget_weld_law.h"

int nugget_weld_law_version(void) {
  return NUGGET_WELD_LAW_VERSION;
}

double nugget_weld_law(const struct nugget_weld* weld, const struct nugget_weld_load* load, double* memory) {
  (void)memory;
  const double *given = weld->value, tension = load->axial > 0.0 ? load->axial : 0.0;
  const double shear = sqrt(load->shear_s * load->shear_s + load->shear_t * load->shear_t);
  const double scale = given[4] > 0.0 ? 1.0 + given[3] * log(1.0 + load->strain_rate / given[4]) : 1.0;
  return pow(tension / (scale * given[0]), given[2]) + pow(shear / (scale * given[1]), given[2]);
}
