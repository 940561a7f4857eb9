// SPDX-License-Identifier: Apache-2.0
#include "app/preload.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "nvh/matrices/prestress.hpp"
#include "nvh/statics/static_loads.hpp"
#include "nvh/statics/statics.hpp"

namespace nugget::app {

void check_preload(const model::Model& model, const impact::Simulation* after, Findings& findings) {
  const model::Implicit& implicit = model.implicit;
  const model::InitialState& initial = model.initial_state;
  const bool stressed = !initial.shells.empty() || !initial.solids.empty() || !initial.axial_forces.empty() ||
                        !initial.section_stresses.empty();
  if (implicit.after_run && after == nullptr)
    findings.warning({model.deck, 0, 0}, "*CONTROL_IMPLICIT_GENERAL",
                     "IMFLAG is 6: these are the modes of the structure before its explicit run",
                     "`nugget run` runs it first and has the modes of its end in the folder modes");
  if (implicit.modes < 0 && !implicit.after_run) nvh::check_statics(model, findings);
  if (!implicit.geometric && (implicit.modes < 0 || stressed))
    findings.warning({model.deck, 0, 0}, "*CONTROL_IMPLICIT_GENERAL",
                     "IGS is 2: modes are those of the structure without its stresses",
                     "write IGS 1 for the geometric stiffness of loads and initial stresses");
}

std::string stiffen_by_preload(nvh::Matrices& m, const impact::Simulation* after) {
  const model::Model& model = m.system.model;
  if (!model.implicit.geometric) return {};
  const auto prestress = std::make_shared<nvh::Prestress>(m);
  std::string text = "Preload\n\n";
  if (after != nullptr) {
    prestress->add(after->system(), after->state());
    prestress->add_loads(nvh::external_loads(m, model.control.end_time));
    text += fmt::format(" the explicit run at time {:.6g}\n", after->state().time);
  } else {
    prestress->add_initial();
  }
  if (model.implicit.modes < 0 && !model.implicit.after_run) {
    Findings ignored_findings;  // by check_preload
    const nvh::Statics statics = nvh::solve_statics(m, ignored_findings);
    prestress->add(statics.motion);
    prestress->add_loads(nvh::external_loads(m, model.control.end_time));
    double largest = 0.0;
    for (const nvh::SixDof& u : statics.motion) largest = std::max(largest, norm(Vec3d{u[0], u[1], u[2]}));
    text += fmt::format(" linear statics at time {:.6g}: largest displacement {:.6g}, out of balance {:.2g}\n",
                        model.control.end_time, largest, statics.residual);
  }
  nvh::stiffen(m, prestress);
  return text + fmt::format(" geometric stiffness of {} elements; {} directions without any stiffness are held\n\n",
                            prestress->elements(), m.auto_constrained);
}

}  // namespace nugget::app
