// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/missing_data.hpp"

#include "weld/failure/function.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld::failure {

void report_missing_data(const model::Model& model, const Ties& ties, Findings& findings) {
  for (const Weld& weld : ties.welds) {
    if (weld.part == none || weld.deleted || !of_weld_material(model, weld.part)) continue;
    const model::WeldLaw& law = law_of(model, weld);
    const bool no_table = (law.option == 7 || law.option == 10) && law.table == none;  // reported where it is named
    if (!no_table) make_function(model, law, geometry_of(model, weld), weld.place, findings);
  }
}

}  // namespace nugget::weld::failure
