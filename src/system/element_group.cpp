// SPDX-License-Identifier: Apache-2.0
#include "system/element_group.hpp"

namespace nugget::system {

void ElementGroup::archive(Archive& a) {
  a(deletions, inverted, block_step, step_share);
  a.built(kind, part, element, nodes_per_element, weld, rotational, first_slot, damping_share, damping_time,
          damping_stiffness_ratio, mass_step, added_mass_is_physical);
}

}  // namespace nugget::system
