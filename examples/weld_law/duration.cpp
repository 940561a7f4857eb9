// SPDX-License-Identifier: Apache-2.0
// A failure function of one's own in C++ that remembers: the weld fails when its resultant force F has been above USRV1
// for long enough, short loads far above it sooner than long ones a little above it.
//
//     f = integral of max(F / USRV1 - 1, 0) dt / USRV2
//
//     c++ -std=c++17 -O2 -shared -fPIC -I src/model examples/weld_law/duration.cpp -o duration.so
//     nugget run MODEL.k --weld-law ./duration.so
#include <algorithm>
#include <cmath>

#include "nugget_weld_law.h"

int nugget_weld_law_version(void) {
  return NUGGET_WELD_LAW_VERSION;
}

int nugget_weld_law_memory(const nugget_weld*) {
  return 1;  // the integral so far: it stands in restart files
}

double nugget_weld_law(const nugget_weld* weld, const nugget_weld_load* load, double* memory) {
  const double force = std::hypot(load->axial, load->shear_s, load->shear_t);
  memory[0] += std::max(force / weld->value[0] - 1.0, 0.0) * load->step;
  return memory[0] / weld->value[1];
}
