// SPDX-License-Identifier: Apache-2.0
#include "output/dcfail.hpp"

namespace nugget::output {

Dcfail::Dcfail(std::filesystem::path path, const Header& header) : file_(std::move(path), header) {}

void Dcfail::write(const DcfailState& state) {
  file_.print(
      "\n define connection failure, time={:13.5E}\n    ele_id    con_id    fail_func       normal      bending        "
      "shear         area     area_sol    eff_e_rate  axial force  shear force  torsion mom  bending mom\n",
      column(state.time));
  for (const DcfailRow& row : state.rows) {
    file_.print("{:10}{:10}", row.id, row.connection);
    for (const double value :
         {row.failure, row.normal, row.bending, row.shear, row.area, row.solid_area, row.strain_rate, row.axial_force,
          row.shear_force, row.torsional_moment, row.bending_moment})
      file_.print("{:13.5E}", column(value));
    file_.print("\n");
  }
  file_.end_state();
}

}  // namespace nugget::output
