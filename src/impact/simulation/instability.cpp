// SPDX-License-Identifier: Apache-2.0
// How a run knows that its energy comes from nowhere.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "impact/simulation/simulation.hpp"
#include "kernel/law/law_components.hpp"

namespace nugget::impact {

double Simulation::energy_of_pressures_at_start() const {
  double sum = 0.0;
  for (const auto& group : system_.groups) {
    const model::Index material = system_.model.parts[group->part].material;
    if (material == model::none) continue;
    const model::Material& of = system_.model.materials[material];
    const auto* law = std::get_if<kernel::ComposedLaw>(&of.law);
    if (law == nullptr || !law->components->state) continue;
    const double share = kernel::EquationOfStateKernel(*law->components->state).energy_at_start() / of.density;
    for (std::size_t e = 0; share > 0.0 && e < group->size(); ++e) sum += share * group->mass(e);
  }
  return sum;
}

double Simulation::input() const {
  return std::max(largest_input_, std::abs(energy_.initial + energy_.external));
}

/// What is given beyond this was never got: it is most of what there is, and ten times what was put in.
double Simulation::most_given() const {
  return std::max(10.0 * input(), 0.1 * energy_.size());
}

/// Springs of contacts and of ties are without force at the start, friction and damping take energy: what they took in
/// all is not below 0.
bool Simulation::contact_gives() const {
  return -energy_.contact > most_given();
}

/// The part, if any, whose elements have given more energy than they ever got: without stress at the start, and without
/// an equation of state, which may hold some (E0), their internal energy is not below 0.
std::vector<PartEnergy>::const_iterator Simulation::giving_part() const {
  const model::InitialState& initial = system_.model.initial_state;
  const bool stressed = !initial.shells.empty() || !initial.solids.empty() || !initial.axial_forces.empty() ||
                        !initial.section_stresses.empty() || system_.model.control.relaxation.on();
  const auto starts_empty = [this](const model::Part& part) {
    const kernel::ComposedLaw* law = nullptr;
    if (part.material != model::none)
      law = std::get_if<kernel::ComposedLaw>(&system_.model.materials[part.material].law);
    return (part.kind == model::ElementKind::shell || part.kind == model::ElementKind::solid) &&
           !(law != nullptr && law->components->state);
  };
  for (auto part = parts_.begin(); part != parts_.end() && !stressed; ++part)
    if (-part->internal > most_given() &&
        starts_empty(system_.model.parts[static_cast<std::size_t>(part - parts_.begin())]))
      return part;
  return parts_.end();
}

bool Simulation::energy_is_made() const {
  const double input = this->input();
  // What deleted elements took with them does no harm any more.
  const double gone = energy_.eroded + energy_.eroded_kinetic, made = energy_.created() - gone;
  // A product of the velocities half a step before and after is far below 0 where they alternate without bound; what
  // is made is then the small difference of two huge numbers. Just below its limit a step makes it -1 / sin^2 of the
  // phase in a step, with a bound; and where nothing was put in there is nothing to compare with.
  const bool alternates = input > 0.0 && -energy_.kinetic > 1e3 * input;
  if (!alternates && !gives_energy_ && (made < 0.5 * (energy_.size() - std::abs(gone)) || made <= 10.0 * input))
    return false;
  // What the round-off of places makes of a model at rest grows into nothing.
  double farthest = 0.0;
  for (const Row& x : state_.x) farthest = std::max({farthest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  const double noise = std::numeric_limits<double>::epsilon() * farthest / state_.dt;
  return energy_.size() > masses_.physical * noise * noise;
}

std::string Simulation::describe_inverted(const system::ElementGroup& group) const {
  const model::Index e = group.element[group.inverted];
  const char* const remedy =
      state_.cycle <= 2
          ? "see what loads, drives and ties its nodes, and the units of its material"
          : "ERODE 1 in *CONTROL_TIMESTEP deletes such bricks; to keep them: a smaller TSSFAC, hourglass type 6, "
            "in foams *CONTACT_INTERIOR or a curve that goes on to larger compression";
  return fmt::format("negative volume in solid {} of part {} at time {:.6g}, cycle {} [{}]", system_.model.solids.id[e],
                     system_.model.parts[group.part].id, state_.time, state_.cycle, remedy);
}

std::string Simulation::describe_instability() const {
  if (contact_gives())
    return fmt::format(
        "the run is unstable: contacts have given {:.3g} more energy than they ever got, by time {:.6g}, cycle {}, "
        "most of it {} [look in run.log at what stands in each other at the start, and there in d3plot; move the "
        "bodies "
        "apart, or give SAST, SBST or OPTT of *PART_CONTACT no larger than the elements]",
        -energy_.contact, state_.time, state_.cycle, components_.contacts.giving_most(system_));
  if (const auto giving = giving_part(); giving != parts_.end())
    return fmt::format(
        "the run is unstable: part {} has given {:.3g} more energy than it ever got, by time {:.6g}, cycle {}: its "
        "internal energy is below 0 [give a smaller TSSFAC in *CONTROL_TIMESTEP; look at the moduli of its material, "
        "which may lie too far apart, and at folded elements]",
        system_.model.parts[static_cast<std::size_t>(giving - parts_.begin())].id, -giving->internal, state_.time,
        state_.cycle);
  const auto worst = std::max_element(parts_.begin(), parts_.end(), [](const PartEnergy& a, const PartEnergy& b) {
    return a.internal + a.hourglass < b.internal + b.hourglass;
  });
  return fmt::format(
      "the run is unstable: of its energy of {:.3g}, {:.3g} is made by the time integration, by time {:.6g}, cycle "
      "{}{}: the step is too long [give a smaller TSSFAC in *CONTROL_TIMESTEP, e.g. {:.2g}]",
      energy_.size(), std::max(energy_.created(), -energy_.kinetic), state_.time, state_.cycle,
      worst == parts_.end() ? std::string()
                            : fmt::format(", most of it in part {}",
                                          system_.model.parts[static_cast<std::size_t>(worst - parts_.begin())].id),
      advised_scale_ > 0.0 ? advised_scale_ : 0.75 * step_factor_ * system_.model.control.step_scale);
}

}  // namespace nugget::impact
