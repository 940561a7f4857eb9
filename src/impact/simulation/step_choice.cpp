// SPDX-License-Identifier: Apache-2.0
// The step of a run: by the elements' formulas, by what they allow as they are assembled, by joints and bodies.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "impact/simulation/simulation.hpp"

namespace nugget::impact {
namespace {

// TSSFAC is a share of the stable step. Where the formula's step goes beyond what the elements allow as they
// are assembled, it is a share of that; a run that is stable by a little keeps its step.
constexpr double default_step_scale = 0.9, bearable_share = 0.98;
// A look at what is assembled costs some 70 cycles of the chosen elements: 1.5 % of a long run at most.
constexpr long cycles_between_looks = 100, looks_at_first = 20, cycles_of_a_look = 5000;
// One at whole sheets costs some 400: less often.
constexpr long looks_at_sheets_at_first = 3, cycles_of_a_look_at_sheets = 20000;
constexpr double bearable_opening = 1e-3;  // of a joint, of the size of its bodies

}  // namespace

void Simulation::bound_step_at_start(Findings& findings) {
  find_steps_at_rest();
  at_rest_ = components_.preloads.empty();
  controlling_ = system_.controlling();
  const double step = step_of_elements();
  const AssembledStep::Limit limit = assembled_step_.limit(state_, step);
  if (!(limit.step > 0.0) || !std::isfinite(limit.step)) return;
  const model::Control& control = system_.model.control;
  const double most = control.step_scale * limit.step / step;
  step_notes_ +=
      fmt::format("elements as they are assembled allow a step of {:.6e}: TSSFAC {:.3f} at most\n", limit.step, most);
  if (step <= bearable_share * limit.step) {
    remember_bound(step, limit.step);
    return;
  }
  const double safe = default_step_scale * most;
  const std::string why = fmt::format(
      "{} vibrates, with what is around it, faster than the formula of its step knows: the limit of stability is "
      "TSSFAC {:.3f}",
      describe(limit), most);
  Place place = control.step_scale_place.line > 0 ? control.step_scale_place : Place{system_.model.deck, 0, 0};
  if (control.step_scale_given) {
    advised_scale_ = safe;
    findings.warning(std::move(place), "*CONTROL_TIMESTEP",
                     why + fmt::format("; the deck has {:.3g}", control.step_scale),
                     fmt::format("write TSSFAC {:.2f}, or leave the field empty: the run then takes that", safe));
    return;
  }
  step_factor_ = safe / control.step_scale;
  remember_bound(step, limit.step);
  findings.note(std::move(place), "*CONTROL_TIMESTEP", why + fmt::format("; the run takes {:.3f}", safe),
                "give TSSFAC to have another one");
}

void Simulation::remember_bound(double step, double limit) {
  masses_changed_ = false;
  bounded_step_ = step;
  ++looks_;
  // Shapes change the limit about as much as the step: half of the way to it may pass without a look.
  bearable_change_ = std::max(0.01, 0.5 * (limit / (step_factor_ * step) - 1.0));
}

std::string Simulation::describe(const AssembledStep::Limit& limit) const {
  return system::System::Controlling{limit.step, limit.group, static_cast<int>(limit.element)}.describe(system_);
}

void Simulation::bound_step_again() {
  const double step = step_of_elements();
  // Nodes keep the mass of elements that are deleted, so that nothing vibrates faster without them.
  if (!masses_changed_ && !(std::abs(step / bounded_step_ - 1.0) > bearable_change_)) return;
  if (looks_ >= (assembled_step_.sheets() ? looks_at_sheets_at_first + state_.cycle / cycles_of_a_look_at_sheets
                                          : looks_at_first + state_.cycle / cycles_of_a_look))
    return;
  collect(system::Carried::whole, true);
  const AssembledStep::Limit limit = assembled_step_.limit(state_, step);
  if (ranks_ != nullptr) leave_to_others();
  const double before = step_factor_;
  if (limit.step > 0.0 && std::isfinite(limit.step))
    step_factor_ = step > bearable_share * limit.step ? default_step_scale * limit.step / step : 1.0;
  remember_bound(step, limit.step);
  const double scale = system_.model.control.step_scale;
  if (std::abs(step_factor_ - before) < 0.02) return;
  step_notes_ += fmt::format("from time {:.6e} on the run takes TSSFAC {:.3f} ({})\n", state_.time,
                             scale * step_factor_, step_factor_ == 1.0 ? "the default" : describe(limit));
}

double Simulation::step_of_elements() const {
  const model::Control& control = system_.model.control;
  double dt = controlling_.step;
  if (control.mass_step < 0.0 || control.mass_step > 0.0) {
    // Mass scaling keeps every element at the wanted step; the run takes it and not more.
    dt = std::min(dt, std::max(std::abs(control.mass_step) * control.step_scale, 0.0));
    if (controlling_.step > dt && control.mass_step < 0.0) dt = controlling_.step;
  }
  return dt;
}

double Simulation::step_of_bodies(double end_time) {
  const double longest = end_time > 0.0 && std::isfinite(end_time) ? 1e-3 * end_time : 1.0;
  const auto shorten = [&](double step) {
    bodies_step_ = std::max(step, 1e-4 * longest);
    bodies_cycle_ = state_.cycle;
    components_.joints.follow(bodies_step_);
  };
  if (state_.cycle == 0) {
    if (const double step = components_.joints.step_for(bearable_opening, state_); step < longest) shorten(step);
  } else if (const double opening = components_.joints.relative_opening();
             opening > bearable_opening && state_.cycle >= bodies_cycle_ + 20 && state_.dt > 1e-4 * longest) {
    // It opens with the square of the step, and after a change needs some of its periods of 4 pi steps to close.
    shorten(std::max(0.1, 0.7 * std::sqrt(bearable_opening / opening)) * state_.dt);
  }
  return bodies_step_ > 0.0 ? std::min(longest, bodies_step_) : longest;
}

void Simulation::choose_step(double end_time) {
  const model::Control& control = system_.model.control;
  state_.dt_previous = state_.cycle == 0 ? 0.0 : state_.dt;
  if (!assembled_step_.empty() && !control.step_scale_given && state_.cycle > 0 &&
      state_.cycle % cycles_between_looks == 0)
    bound_step_again();
  double dt = step_factor_ * step_of_elements();
  if (state_.relaxing && control.relaxation.step_scale > 0.0) dt *= control.relaxation.step_scale / control.step_scale;
  if (control.step_curve != model::none)
    dt = std::min(dt, system_.model.curves[control.step_curve].clamped(state_.time));
  const double of_joints = control.step_scale * components_.joints.stable_step();
  const bool by_joints = of_joints < dt;
  if (by_joints) dt = of_joints;
  const double of_belts = control.step_scale * components_.belts.stable_step();
  const bool by_belts = of_belts < dt;
  if (by_belts) dt = of_belts;
  if (controlling_.step == std::numeric_limits<double>::infinity()) {
    const double of_bodies = step_of_bodies(end_time);
    if (dt == std::numeric_limits<double>::infinity() || (bodies_step_ > 0.0 && of_bodies < dt)) dt = of_bodies;
  }
  dt = std::min(dt, components_.tie_forces.longest_next_step());
  stable_step_ = dt;
  if (state_.cycle == 0 && control.first_step > 0.0) dt = std::min(dt, control.first_step);
  if (dt < smallest_step_) {
    smallest_step_ = dt;
    smallest_by_ = by_belts                                   ? "the seat belts"
                   : by_joints                                ? "the stiffness of a joint"
                   : bodies_step_ > 0.0 && dt <= bodies_step_ ? "the opening of joints"
                                                              : controlling_.describe(system_);
  }
  // A rest of less than a millionth of a step, which round-off leaves, belongs to this step: over a step of nothing no
  // acceleration and no reaction has a meaning.
  if (state_.time < end_time && state_.time + state_.period * (1.0 + 1e-6) * dt > end_time)
    dt = (end_time - state_.time) / state_.period;
  run_end_ = state_.period > 1 && state_.time + state_.period * (1.0 + 1e-6) * dt > end_time ? end_time : 0.0;
  state_.dt = dt;
  if (state_.cycle > 0) system_.correct_impulses(state_);
}

}  // namespace nugget::impact
