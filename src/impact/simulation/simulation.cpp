// SPDX-License-Identifier: Apache-2.0
#include "impact/simulation/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <limits>
#include <map>
#include <utility>

#include "base/free_room.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"
#include "impact/contact/contact_setup.hpp"
#include "impact/simulation/ends.hpp"
#include "impact/simulation/strains.hpp"
#include "model/bond.hpp"
#include "system/share.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::impact {
namespace {

constexpr double between_reports = 0.2;  // seconds

const char* volatile interrupted_by = nullptr;  ///< by whom; null: not at all

/// `model`: null, or that of the system.
system::State take_start(system::System& system, model::Model* model) {
  system::State start = system.initial_state();
  if (model != nullptr) system.forget_start(*model);
  return start;
}

std::string energy_is_no_number(const system::State& state) {
  return fmt::format("the solution diverged: its energy is no number that results can hold at time {:.6g}, cycle {}",
                     state.time, state.cycle);
}

}  // namespace

void Simulation::interrupt(const char* by) {
  interrupted_by = by;
}

bool Simulation::interrupted() {
  return interrupted_by != nullptr;
}

Simulation::Simulation(system::System& system, Findings& findings, model::Model* model)
    : system_(system),
      state_(take_start(system, model)),
      components_(system, state_.x, findings),
      assembled_step_(system, components_.supports, state_.x) {
  if (system.model.requests.strains) add_up_strains(system);
  history_rotation_.resize(system.model.requests.history_nodes.size() + system.bodies.size());
  for (const auto& group : system.groups)
    if (auto* springs = dynamic_cast<system::SpringGroup*>(group.get()); springs && springs->has_stops())
      stopped_springs_.push_back(springs);
  if (findings.errors() != 0) return;
  largest_input_ = energy_of_pressures_at_start();
  if (!components_.tie_forces.empty()) report_weak_ties(findings);
  if (!assembled_step_.empty()) bound_step_at_start(findings);
}

/// With the masses and the step that the run begins with.
void Simulation::report_weak_ties(Findings& findings) {
  system::State rest = state_;
  rest.dt = 0.0;
  std::fill(rest.v.begin(), rest.v.end(), Row{});
  std::fill(rest.w.begin(), rest.w.end(), Row{});
  system_.internal_force(rest);
  system_.scale_mass(true);
  update_mass_bounds();
  const model::Control& control = system_.model.control;
  double step = system_.controlling().step;
  if (control.mass_step != 0.0) step = std::min(step, std::abs(control.mass_step) * control.step_scale);
  components_.tie_forces.report_weak(state_, std::isfinite(step) ? step : 0.0, findings);
}

void Simulation::find_steps_at_rest() {
  internal_force_at_rest();
  system_.scale_mass(true);
  update_mass_bounds();
}

std::vector<std::string> Simulation::events() const {
  std::vector<std::string> lines = components_.contacts.glue_summary(system_);
  for (std::string& line : components_.contacts.drop_summary(system_)) lines.push_back(std::move(line));
  for (std::string& line : leakage_summary(components_.loads.of<model::ControlVolume>()))
    lines.push_back(std::move(line));
  std::map<model::Index, std::array<std::size_t, 2>> of_part;  // deleted, and all elements
  for (const auto& group : system_.groups) {
    const model::Part& part = system_.model.parts[group->part];
    if (weld::of_weld_material(system_.model, group->part)) continue;
    std::size_t failed = 0;
    if (!model::bond_of(system_.model, part)) {
      for (std::size_t e = 0; e < group->size(); ++e) failed += !group->alive(e);
      std::array<std::size_t, 2>& sum = of_part[group->part];
      sum = {sum[0] + failed, sum[1] + group->size()};
      continue;
    }
    double damage = 0.0;
    for (std::size_t e = 0; e < group->size(); ++e) {
      if (group->alive(e))
        damage = std::max(damage, group->layer(e, 0, state_).plastic_strain);
      else
        ++failed;
    }
    lines.push_back(fmt::format("adhesive of part {}: {} of {} bricks deleted", part.id, failed, group->size()));
    if (failed < group->size()) lines.back() += fmt::format(", largest damage of the others {:.3f}", damage);
  }
  for (const auto& [part, count] : of_part)
    if (count[0] > 0)
      lines.push_back(
          fmt::format("part {}: {} of {} elements deleted", system_.model.parts[part].id, count[0], count[1]));
  return lines;
}

double Simulation::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void Simulation::add_time(Phase phase) {
  const auto now = std::chrono::steady_clock::now();
  seconds_[phase] += std::chrono::duration<double>(now - timed_until_).count();
  timed_until_ = now;
}

Outcome Simulation::run(const Options& options, Recorder& recorder, const ProgressCallback& progress) {
  begin_ = timed_until_ = std::chrono::steady_clock::now();
  const double end_time = options.until > 0.0 ? options.until : system_.model.control.end_time;

  if (options.restore_costs) options.restore_costs();
  if (options.ranks != nullptr) share_out(*options.ranks, options);
  if (options.ranks == nullptr && options.made) options.made();
  forget_costs();
  start();
  if (options.restore) resume(options);
  checkpoints_.written(state_.cycle, state_.time, solve_seconds_);
  if (ranks_ != nullptr) {
    system_.reported_below = components_.erosion.smallest_step(first_step_);
    pass_on_balance(recorder);
  }
  add_time(elements);
  const Outcome relaxed = options.restore ? Outcome{} : relax(options, recorder, progress);
  Outcome outcome;
  double next_report = 0.0;
  for (bool last = false; !last;) {
    if (state_.cycle > 0) system_.shorten_periods();
    state_.period = system_.period();
    agree(options);
    if (!relaxed.stops()) write_checkpoint_if_due(options);
    choose_step(end_time);
    outcome = relaxed.stops() ? relaxed : reason_to_stop(options, end_time);
    components_.sensors.update(state_, components_);
    if (!outcome.stops()) outcome.message = reason_to_end(system_, state_, components_.sensors);
    last = outcome.stops() || state_.time >= end_time;
    const bool record = last || results_due(recorder);
    const bool balance = last || state_.cycle % 100 == 0 || (record && balance_due(recorder));
    if (record || balance) store_velocities();
    update_velocities();
    if (record || balance) {
      // Dependent nodes follow at the start of the step, which turns the arms of their rows: here those of a copy.
      system::ConstraintMap(system_.map).apply_to_velocities(state_.dt, state_.v, state_.w);
      const bool energies = balance || runs_away();
      collect(last && system_.model.implicit.after_run ? system::Carried::results
              : last                                   ? system::Carried::end
              : energies                               ? system::Carried::energies
                                                       : system::Carried::histories);
      if (on_first_rank() && energies) {
        update_energy_balance();
        if (record) masses_ = system_.masses();
        free_room(motion_of_others_);
        free_room(step_change_of_others_);
        sums_of_ranks_ = {};
      }
    }
    if (record) write_results(recorder, last);
    if (record || balance) pass_on_balance(recorder);
    if (elapsed() >= next_report) {
      if (progress) report_progress(progress, end_time);
      if (options.sense_switches) obey(options.sense_switches(), recorder);
      next_report = elapsed() + between_reports;
    }
    add_time(output);
    if (!last) advance();
  }
  recorder.finish();
  add_time(output);
  solve_seconds_ = elapsed();
  if (ranks_ != nullptr) report_ranks();
  interrupted_by = nullptr;  // not at the start: a signal that came while files were opened counts
  if (progress) report_progress(progress, end_time);
  // Of the last balance nobody has asked yet.
  if (outcome.termination == Termination::normal && diverged_) return {Termination::error, energy_is_no_number(state_)};
  if (outcome.termination == Termination::normal && energy_is_made())
    return {Termination::error, describe_instability()};
  return outcome;
}

void Simulation::resume(const Options& options) {
  options.restore();
  begin_ -=
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(solve_seconds_));
}

void Simulation::store_velocities() {
  system_.for_each_node(2048, [this](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      v_before_[k] = state_.v[k];
      w_before_[k] = state_.w[k];
    }
  });
  for (std::size_t b = 0; b < system_.bodies.size(); ++b) momentum_before_[b] = system_.bodies[b].angular_momentum;
}

Snapshot Simulation::snapshot() const {
  return {.system = system_,
          .state = state_,
          .components = components_,
          .v_before = v_before_,
          .w_before = w_before_,
          .v_period = v_period_.empty() ? v_before_ : v_period_,
          .w_period = w_period_.empty() ? w_before_ : w_period_,
          .energy = energy_,
          .parts = parts_,
          .controlling = controlling_,
          .masses = masses_,
          .history_rotation = history_rotation_};
}

void Simulation::report_progress(const ProgressCallback& progress, double end_time) const {
  progress({state_.time, end_time, state_.dt, state_.cycle, energy_.ratio(), static_cast<int>(components_.welds.size()),
            components_.failed_welds(), elapsed()});
}

void Simulation::obey(const SenseSwitches& switches, Recorder& recorder) {
  if (switches.stop) interrupt("d3kil");
  if (switches.state) {
    recorder.ask_for_state();
    state_asked_ = true;
  }
  if (switches.restart_file) checkpoints_.ask();
}

void Simulation::update_velocities() {
  if (state_.cycle == 0) components_.stoppers.start(state_);
  components_.rivets.apply(state_, 0.5 * (state_.dt + state_.dt_previous), inverse_mass_);
  components_.linear_constraints.apply(state_, 0.5 * (state_.dt + state_.dt_previous), inverse_mass_, inverse_inertia_,
                                       components_.supports);
  accelerate();
  components_.supports.prescribe(state_, 0.5 * (state_.dt + state_.dt_previous), system_.bodies);
  for (system::SpringGroup* springs : stopped_springs_) springs->stop(state_, system_.mass);
  components_.walls.constrain(system_, state_, dependent_, components_.supports, power_on_change_);
  components_.stoppers.apply(state_, 0.5 * (state_.dt + state_.dt_previous), system_.bodies, components_.supports);
  components_.supports.average_reactions(state_);
  power_on_change_ += components_.stoppers.power_on_change();
  add_time(motion);
}

void Simulation::advance() {
  if (state_.period > 1) {
    v_period_ = state_.v;
    w_period_ = state_.w;
  }
  step();
  for (int i = 1; i < state_.period; ++i) {
    state_.dt_previous = state_.dt;
    update_velocities();
    step();
  }
  if (run_end_ > 0.0) state_.time = run_end_;  // steps of equal length need not add up to it
}

void Simulation::step() {
  // The forces' work is booked with each velocity over its own step, 1/2 F . (v dt before + v dt after), while the
  // kinetic energy changes by F . (v before + v after) (dt before + dt after) / 4 (docs/decisions/0021).
  step_change_ += 0.25 * (state_.dt - state_.dt_previous) * power_on_change_;
  components_.supports.book_opening_work(state_.dt);
  components_.stoppers.book_opening_work(state_.dt);
  system_.map.apply_to_velocities(state_.dt, state_.v, state_.w);
  components_.welds.open_joints(state_);
  components_.accelerometers.add_step(state_);
  add_time(constraints);
  move();
  components_.belts.move(state_);
  add_time(motion);
  components_.preloads.apply(state_);
  system_.internal_force(state_);
  components_.erosion.update(state_, first_step_);
  components_.nodal_forces.update(state_);
  components_.welds.update(state_);
  components_.connectors.update(state_);
  remove_deleted_elements();
  add_time(elements);
  contact_forces();
  add_time(contacts);
  applied_forces();
  add_time(loads);
  transfer_dependent_forces();
  if (system_.scale_mass(false)) update_scaled_mass();
  add_time(constraints);
}

void Simulation::start() {
  v_before_.resize(state_.v.size());
  w_before_.resize(state_.w.size());
  momentum_before_.resize(system_.bodies.size());
  store_velocities();
  components_.supports.constrain_at_start(state_);
  system_.map.apply_to_velocities(0.0, state_.v, state_.w);

  // Stable steps of the undeformed mesh: one pass without a step, then mass scaling, then a second pass with the new
  // masses.
  components_.preloads.start(state_);
  if (system_.model.requests.strains) start_strains(system_, state_);
  components_.accelerometers.start(state_);
  components_.erosion.start(state_);
  if (!at_rest_) find_steps_at_rest();
  components_.linear_constraints.constrain_at_start(state_, inverse_mass_, inverse_inertia_);
  state_.dt = 0.0;
  remove_deleted_elements();
  contact_forces();
  applied_forces();
  transfer_dependent_forces();
  masses_ = system_.masses();

  controlling_ = controlling_of_all();
  first_step_ = step_factor_ * controlling_.step;
  smallest_step_ = std::numeric_limits<double>::infinity();
}

void Simulation::internal_force_at_rest() {
  state_.dt = 0.0;
  system::Rows v(state_.v.size()), w(state_.w.size());
  v.swap(state_.v);
  w.swap(state_.w);
  components_.preloads.apply(state_);
  system_.internal_force(state_);
  v.swap(state_.v);
  w.swap(state_.w);
}

Outcome Simulation::relax(const Options& options, Recorder& recorder, const ProgressCallback& progress) {
  const model::Relaxation& control = system_.model.control.relaxation;
  if (!control.on()) return {};
  const system::Rows v(state_.v), w(state_.w);
  std::vector<Vec3d> momentum;
  for (system::RigidBody& body : system_.bodies) momentum.push_back(std::exchange(body.angular_momentum, {}));
  std::fill(state_.v.begin(), state_.v.end(), Row{});
  std::fill(state_.w.begin(), state_.w.end(), Row{});
  const auto restart_at_zero = [&](bool relaxing) {
    state_.relaxing = relaxing;
    state_.time = 0.0;
    state_.cycle = 0;
    internal_force_at_rest();
    components_.damping.reset();
    contact_forces();
    applied_forces();
    transfer_dependent_forces();
  };

  restart_at_zero(true);
  Outcome stop;
  relaxation_ = Relaxation(control);
  const double end_time = control.end_time > 0.0 ? control.end_time : std::numeric_limits<double>::infinity();
  for (double next_report = 0.0; !relaxation_.at_rest() && state_.time < end_time;) {
    agree(options);
    choose_step(end_time);
    if (stop = reason_to_stop(options, end_time); stop.stops()) break;
    relaxation_.damp(system_, state_);
    update_velocities();
    step();
    relaxation_.watch(system_, state_);
    if (elapsed() >= next_report) {
      Progress p{state_.time, 0.0, state_.dt, state_.cycle, 1.0, 0, 0, elapsed()};
      p.kinetic_energy_ratio = relaxation_.kinetic_energy_ratio();
      if (progress) progress(p);
      if (options.sense_switches) obey(options.sense_switches(), recorder);
      next_report = elapsed() + between_reports;
    }
  }
  if (stop.stops()) {
    stop.message = "in the dynamic relaxation: " + stop.message;
    return stop;
  }

  state_.v = v;
  state_.w = w;
  for (std::size_t b = 0; b < momentum.size(); ++b) system_.bodies[b].angular_momentum = momentum[b];
  restart_at_zero(false);
  components_.accelerometers.start(state_);
  components_.for_each([](auto& component) {
    if constexpr (requires { component.reset_work(); }) component.reset_work();
  });
  step_change_ = 0.0;
  std::ranges::fill(step_change_of_node_, 0.0);
  smallest_step_ = std::numeric_limits<double>::infinity();
  return {};
}

bool Simulation::without_end(double time_to_go, double step) const {
  const model::Model& model = system_.model;
  const bool may_end_before = model.control.end_cycle > 0 || !model.run_ends.empty();
  return !may_end_before && step > 0.0 && std::isfinite(time_to_go) && time_to_go > 1e15 * step;
}

Outcome Simulation::reason_to_stop(const Options& options, double end_time) const {
  const model::Control& control = system_.model.control;
  const auto error = [](std::string why) { return Outcome{Termination::error, std::move(why)}; };
  if (stop_requested_)
    return {Termination::interrupted,
            fmt::format("interrupted by {} at time {:.6g}, cycle {}; results up to there are kept",
                        static_cast<const char*>(interrupted_by), state_.time, state_.cycle)};
  for (const auto& group : system_.groups) {
    if (group->inverted >= 0) return error(describe_inverted(*group));
  }
  if (state_.time < end_time && state_.time + state_.dt == state_.time)
    return error(fmt::format("the time step {:.4g} of {} is too small to go on from time {:.6g}, cycle {}", state_.dt,
                             controlling_.describe(system_), state_.time, state_.cycle));
  if (state_.cycle == 0 && options.max_cycles == 0 && without_end(end_time - state_.time, state_.dt))
    return error(fmt::format("the time step {:.4g} of {} would take {:.1g} cycles to the end time {:.6g}", state_.dt,
                             controlling_.describe(system_), (end_time - state_.time) / state_.dt, end_time));
  if (diverged_) return error(energy_is_no_number(state_));
  if (unstable_) return error(describe_instability());
  if (!components_.erosion.reason_to_stop().empty()) return error(components_.erosion.reason_to_stop());
  if (std::isnan(state_.dt))
    return error(
        fmt::format("the solution diverged: {} has no stable time step (not a number) at time {:.6g}, cycle {}",
                    controlling_.describe(system_), state_.time, state_.cycle));
  if (control.smallest_step > 0.0 && step_factor_ * controlling_.step < control.smallest_step * first_step_ &&
      state_.time < end_time)
    return error(fmt::format("the time step {:.4g} of {} fell below DTMIN times the first step, {:.4g}",
                             step_factor_ * controlling_.step, controlling_.describe(system_),
                             control.smallest_step * first_step_));
  if (control.energy_limit > 0.0 && std::abs(energy_.ratio_without_step_change() - 1.0) > 0.01 * control.energy_limit &&
      state_.cycle > 0)
    return error(fmt::format("the energy ratio {:.4g} left the limit ENDENG = {:.4g} %",
                             energy_.ratio_without_step_change(), control.energy_limit));
  if (masses_.physical > 0.0 && 100.0 * masses_.added / masses_.physical > control.added_mass_limit)
    return error(fmt::format("the added mass, {:.4g} % of the physical one, exceeds ENDMAS = {:.4g} %",
                             100.0 * masses_.added / masses_.physical, control.added_mass_limit));
  if (not_finite_ >= 0)
    return error(fmt::format("the solution diverged: the velocity of node {} is not a number at time {:.6g}, cycle {}",
                             system_.node_id(not_finite_), state_.time, state_.cycle));
  const long most = options.max_cycles > 0 ? options.max_cycles : control.end_cycle;
  if (most > 0 && state_.cycle >= most) return {Termination::normal, fmt::format("stopped after {} cycles", most)};
  return {};
}

void Simulation::accelerate() {
  const double velocity_interval = 0.5 * (state_.dt + state_.dt_previous);
  const double change = 0.25 * (state_.dt - state_.dt_previous);
  step_change_of_node_.resize(system_.nodes);
  system_.for_each_node(1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < std::min(end, system_.nodes); ++k) {
      const double a = velocity_interval * inverse_mass_[k], b = velocity_interval * inverse_inertia_[k];
      Row &v = state_.v[k], &w = state_.w[k];
      const Row &f = state_.f[k], &m = state_.m[k];
      if (change != 0.0)  // as in step_change()
        step_change_of_node_[k] +=
            change * (a * (f.x * f.x + f.y * f.y + f.z * f.z) + b * (m.x * m.x + m.y * m.y + m.z * m.z));
      v = {v.x + a * f.x, v.y + a * f.y, v.z + a * f.z, 0.0};
      w = {w.x + b * m.x, w.y + b * m.y, w.z + b * m.z, 0.0};
    }
  });
  power_on_change_ = 0.0;
  for (system::RigidBody& body : system_.bodies) power_on_change_ += body.advance(velocity_interval, state_.dt, state_);
}

/// What a node's forces at t(n) add to Energy::step_change, by their power on the change of velocity that they make
/// from t(n-1/2) to t(n+1/2).
double Simulation::step_change(std::size_t node) const {
  const double velocity_interval = 0.5 * (state_.dt + state_.dt_previous);
  const Row &f = state_.f[node], &m = state_.m[node];
  const double power = velocity_interval * inverse_mass_[node] * (f.x * f.x + f.y * f.y + f.z * f.z) +
                       velocity_interval * inverse_inertia_[node] * (m.x * m.x + m.y * m.y + m.z * m.z);
  return 0.25 * (state_.dt - state_.dt_previous) * power;
}

/// What those before t(n) have added.
double Simulation::step_change_before_now(std::size_t node) const {
  return step_change_of_node_[node] - step_change(node);
}

void Simulation::move() {
  system_.for_each_node(2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      Row& x = state_.x[k];
      const Row& v = state_.v[k];
      x = {x.x + state_.dt * v.x, x.y + state_.dt * v.y, x.z + state_.dt * v.z, 0.0};
    }
  });
  for (system::RigidBody& body : system_.bodies) body.turn(state_.dt, state_);
  const auto turn = [&](std::size_t i, std::size_t k) { history_rotation_[i] += state_.dt * vec(state_.w[k]); };
  const std::vector<model::NamedEntity>& asked = system_.model.requests.history_nodes;
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (const std::size_t k = at(system_.node_of[asked[i].index]); system_.follows(k)) turn(i, k);
  for (std::size_t b = 0; b < system_.bodies.size(); ++b) turn(asked.size() + b, at(system_.bodies[b].node));
  state_.time += state_.dt;
  ++state_.cycle;
}

void Simulation::contact_forces() {
  const int period = state_.dt > 0.0 ? std::min(system_.model.control.subcycling.contact_period, state_.period) : 1;
  if (state_.cycle % period != 0) return;
  longest_step_ = std::max(longest_step_, period * stable_step_);
  const contact::NodalMasses mass = contact_mass_.empty()
                                        ? contact::NodalMasses(system_.mass, dependent_, system_.own_mass)
                                        : contact::NodalMasses(contact_mass_);
  contact::Step step{state_.time,
                     period * state_.dt,
                     period * stable_step_,
                     longest_step_,
                     state_.x,
                     state_.v,
                     mass,
                     components_.element_alive.all(),
                     components_.element_alive.faces_are_whole(),
                     nullptr};
  if (ranks_ != nullptr) {
    const contact::SharedNodes shared{*system_.share(), state_.x, state_.v};
    step.shared = &shared;
    apply_contacts(step, state_.f);
    return system_.exchange_sums(state_);
  }
  if (period == 1) {
    apply_contacts(step, state_.f);
    return;
  }
  // An impulse as long as the period, as those of elements.
  step.v = system_.mean_velocities();
  contact_forces_.assign(state_.f.size(), Row{});
  apply_contacts(step, contact_forces_);
  parallel_for(contact_forces_.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) add(state_.f[k], period * vec(contact_forces_[k]));
  });
}

void Simulation::apply_contacts(const contact::Step& step, std::span<Row> force) {
  components_.contacts.apply(step, state_, force);
  components_.interiors.apply(step, force);
  components_.walls.press(step, force);
}

void Simulation::applied_forces() {
  components_.tie_forces.apply(state_);
  components_.joints.apply(state_);
  components_.belts.apply(state_);
  components_.loads.find_covered([this](int node) { return components_.contacts.presses(node); });
  components_.loads.apply(state_, state_.dt);
  components_.damping.apply(state_, state_.dt);
}

void Simulation::remove_deleted_elements() {
  const ElementAlive::Deletions deletions = components_.element_alive.update(system_);
  if (deletions.any) components_.contacts.elements_deleted(deletions.faces);
  if (deletions.shells) components_.crash_fronts.update(system_);
  const bool released =
      components_.tie_releases.update(state_, components_.element_alive.all(), deletions.shells, deletions.any);
  if (components_.torn_nodes.update(state_) || released) update_mass_bounds();
}

void Simulation::transfer_dependent_forces() {
  components_.rigid_welds.store_loads(state_);
  components_.tie_forces.store_loads(state_);
  system_.map.transfer_forces(state_.f, state_.m);
  if (!components_.rigid_welds.update(state_)) return;
  update_mass_bounds();
}

void Simulation::update_energy_balance() {
  const Energy before = energy_;
  part_nodes_.update(system_, sums_of_ranks_.pieces.empty() ? PartNodes::Sums::all : PartNodes::Sums::own);
  element_energies(system_, state_, v_before_, w_before_, momentum_before_, part_nodes_, energy_, parts_,
                   motion_of_others_, sums_of_ranks_);
  energy_.kinetic =
      kinetic_energy(system_, state_, v_before_, w_before_, momentum_before_, motion_of_others_, sums_of_ranks_) -
      energy_.eroded_kinetic;
  energy_.contact = energy_.wall = energy_.external = energy_.damping = 0.0;
  components_.for_each([&](const auto& component) {
    if constexpr (requires { component.add_energy(energy_); }) component.add_energy(energy_);
  });
  energy_.step_change =
      step_change_ + components_.supports.step_change() +
      sum_over_nodes(system_, sums_of_ranks_.step_change, [this](std::size_t begin, std::size_t end) {
        return sum_of_row(begin, end, [this](std::size_t k) {
          if (system_.follows(k)) return step_change_before_now(k);
          if (step_change_of_others_.empty()) return step_change_of_node_[k];
          return step_change_of_others_[system_.sums_by_rank()->place_among_travelling(static_cast<int>(k))];
        });
      });
  if (state_.cycle == 0) energy_.initial = energy_.total();
  gives_energy_ = giving_part() != parts_.end() || contact_gives();
  // Other balances come with the output, which must not change how a run ends.
  if (state_.cycle % 100 == 0) {
    largest_input_ = input();
    unstable_ = energy_is_made();
  }
  // Beyond what the result files' words hold a number is none either.
  const auto fits = [](double energy) { return std::abs(energy) < std::numeric_limits<float>::max(); };
  if (fits(energy_.total()) && fits(energy_.initial) && fits(energy_.external)) return;
  diverged_ = true;
  energy_ = before;
}

void Simulation::archive(Archive& a) {
  a(system_);
  a.section("nodes");
  const Archive::Holders of_nodes = system_.holders_of_nodes();
  a(state_);
  const std::vector<model::NamedEntity>& asked = system_.model.requests.history_nodes;
  const auto node = [&](std::size_t i) { return at(system_.node_of[asked[i].index]); };
  a.parts(history_rotation_,
          {[&](std::size_t i) { return i < asked.size() && of_nodes.giver ? of_nodes.giver(node(i)) : a.everyone; },
           [&](std::size_t i) { return i >= asked.size() || system_.follows(node(i)); }});
  for (system::Rows* rows : {&state_.x, &state_.v, &state_.w, &state_.f, &state_.m}) a.parts(*rows, of_nodes);
  a(components_);
  a.section("balance");
  a(energy_, parts_, controlling_);
  a(masses_.physical, masses_.added, masses_.added_to_welds, masses_.added_by_part);
  for (ZeroedVector<double>* numbers : {&inverse_mass_, &inverse_inertia_, &step_change_of_node_})
    a.parts(*numbers, of_nodes);
  a(contact_mass_, dependent_, diverged_, unstable_, relaxation_, step_change_, largest_input_, power_on_change_,
    first_step_, smallest_step_, stable_step_, longest_step_, smallest_by_);
  a(step_factor_, bounded_step_, bearable_change_, looks_, masses_changed_, bodies_step_, bodies_cycle_, step_notes_);
  a(v_period_, w_period_);
  a.section("clock");
  a(seconds_, solve_seconds_);
  a.built(rigid_contact_nodes_, contact_forces_, run_end_, contact_costs_now_, deleted_now_);
  a.built(gives_energy_, assembled_step_, at_rest_, advised_scale_, stopped_springs_, v_before_, w_before_,
          momentum_before_, not_finite_, stop_requested_, restart_file_due_, state_asked_, ranks_, next_marks_,
          rank_reports_, traffic_before_, cycle_before_, shared_out_at_, checkpoints_, begin_, timed_until_, shares_,
          motion_of_others_, step_change_of_others_, sums_of_ranks_, part_nodes_, shown_);
}

}  // namespace nugget::impact
