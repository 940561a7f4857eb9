// SPDX-License-Identifier: Apache-2.0
#include "app/preload.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "nvh/prestress.hpp"

namespace nugget::app {

void check_preload(const model::Model& model, Findings& findings) {
  const model::Implicit& implicit = model.implicit;
  const model::InitialState& initial = model.initial_state;
  const bool stressed = !initial.shells.empty() || !initial.solids.empty() || !initial.axial_forces.empty() ||
                        !initial.section_stresses.empty();
  if (implicit.modes < 0) nvh::check_statics(model, findings);
  if (!implicit.geometric && (implicit.modes < 0 || stressed))
    findings.warning({model.deck, 0, 0}, "*CONTROL_IMPLICIT_GENERAL",
                     "IGS is 2: modes are those of the structure without its stresses",
                     "write IGS 1 for the geometric stiffness of loads and initial stresses");
}

std::string stiffen_by_preload(nvh::Matrices& m) {
  const model::Model& model = m.system.model;
  if (!model.implicit.geometric) return {};
  const auto prestress = std::make_shared<nvh::Prestress>(m);
  prestress->add_initial();
  std::string text = "Preload\n\n";
  if (model.implicit.modes < 0) {
    Findings told;  // by check_preload
    const nvh::Statics statics = nvh::solve_statics(m, told);
    prestress->add(statics);
    double largest = 0.0;
    for (const nvh::Six& u : statics.motion) largest = std::max(largest, norm(Vec3d{u[0], u[1], u[2]}));
    text += fmt::format(" linear statics at time {:.6g}: largest displacement {:.6g}, out of balance {:.2g}\n",
                        model.control.end_time, largest, statics.residual);
  }
  nvh::stiffen(m, prestress);
  return text + fmt::format(" geometric stiffness of {} elements; {} directions without any stiffness are held\n\n",
                            prestress->elements(), m.held);
}

}  // namespace nugget::app
