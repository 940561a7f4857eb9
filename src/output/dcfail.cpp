// SPDX-License-Identifier: Apache-2.0
#include "output/dcfail.hpp"

namespace nugget::output {

const HistoryFormat<DcfailState>& dcfail() {
  static const HistoryFormat<DcfailState> format{
      .branches = {{
          .path = "dcfail",
          .ids = ids(&DcfailState::rows, &DcfailRow::id),
          .once =
              columns(&DcfailState::rows, {{"type", &DcfailRow::connection, dimension::number, "CON_ID of a weld"}}),
          .columns = columns(
              &DcfailState::rows,
              {
                  {"time", &DcfailState::time, dimension::time, "time"},
                  {"area", &DcfailRow::area, dimension::area, "area with which stresses are formed"},
                  {"bending_term", &DcfailRow::bending, dimension::number, "part of the failure function from bending"},
                  {"effective_strain_rate", &DcfailRow::strain_rate, dimension::rate, "smoothed"},
                  {"failure_function", &DcfailRow::failure, dimension::number, "sum of the three terms; 1 is failure"},
                  {"normal_term", &DcfailRow::normal, dimension::number, "part from the axial force"},
                  {"shear_term", &DcfailRow::shear, dimension::number, "part from shear"},
                  {"area_sol", &DcfailRow::solid_area, dimension::area, "area of the bricks"},
                  {"axial_force", &DcfailRow::axial_force, dimension::force, "axial force"},
                  {"shear_force", &DcfailRow::shear_force, dimension::force, "resultant shear force"},
                  {"torsional_moment", &DcfailRow::torsional_moment, dimension::moment, "torsional moment"},
                  {"bending_moment", &DcfailRow::bending_moment, dimension::moment, "resultant bending moment"},
              }),
      }},
      .lines = {.head = "\n define connection failure, time={time:13.5E}\n    ele_id    con_id    fail_func       "
                        "normal      bending        shear         area     area_sol    eff_e_rate  axial force  shear "
                        "force  torsion mom  bending mom\n",
                .row = "{id:10}{type:10}{failure_function:13.5E}{normal_term:13.5E}{bending_term:13.5E}{shear_term:13."
                       "5E}{area:13.5E}{area_sol:13.5E}{effective_strain_rate:13.5E}{axial_force:13.5E}{shear_force:13."
                       "5E}{torsional_moment:13.5E}{bending_moment:13.5E}\n",
                .tail = ""},
  };
  return format;
}

}  // namespace nugget::output
