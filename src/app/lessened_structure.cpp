// SPDX-License-Identifier: Apache-2.0
#include "app/lessened_structure.hpp"

#include "app/preload.hpp"
#include "base/index.hpp"

namespace nugget::app {

std::unique_ptr<LessenedStructure> LessenedStructure::make(const nvh::Matrices& whole, const nvh::WeldGroup& without) {
  std::unique_ptr<LessenedStructure> less(new LessenedStructure(whole));
  system::System& system = less->system_;
  for (const std::size_t w : without) {
    const weld::Weld& weld = system.ties.welds[w];
    for (const model::Index element : weld.elements) {
      const system::System::ElementLocation location = system.location_of(weld, element);
      if (location.group >= 0) system.groups[location.group]->remove(at(location.element));
    }
  }
  less->matrices_ = std::make_unique<nvh::Matrices>(system, less->findings_);
  try {
    stiffen_by_preload(*less->matrices_);
  } catch (const nvh::Factorization::SolverError&) {
    return nullptr;
  }
  return less;
}

}  // namespace nugget::app
