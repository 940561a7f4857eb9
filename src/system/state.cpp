// SPDX-License-Identifier: Apache-2.0
#include "system/state.hpp"

namespace nugget::system {

void State::archive(Archive& a) {
  a(time, dt, dt_previous, period, cycle, relaxing, controls);
  a.built(x, v, w, f, m);  // of several ranks each holds some: who knows which, archives them
}

}  // namespace nugget::system
