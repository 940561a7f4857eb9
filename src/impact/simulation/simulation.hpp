// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "impact/simulation/assembled_step.hpp"
#include "impact/simulation/checkpoint_schedule.hpp"
#include "impact/simulation/options.hpp"
#include "impact/simulation/relaxation.hpp"
#include "impact/simulation/snapshot.hpp"
#include "system/partition.hpp"
#include "system/spring_group.hpp"

namespace nugget::impact {

/// Explicit dynamics by central differences. The loop reads as the method: accelerate, prescribe, constrain, move,
/// forces.
class Simulation {
 public:
  /// Builds contacts, walls, supports and loads; faults of the input become findings. The system must outlive it.
  /// `model`, where it is given: what of the system's model is asked for by the start alone is set free.
  Simulation(system::System& system, Findings& findings, model::Model* model = nullptr);

  /// Runs to the end. Never throws for a run that diverges: the outcome says why it stopped.
  Outcome run(const Options& options, Recorder& recorder, const ProgressCallback& progress);

  // What the summary wants to know afterwards.
  const system::System& system() const { return system_; }
  const system::State& state() const { return state_; }
  const Energy& energy() const { return energy_; }
  const std::vector<PartEnergy>& part_energies() const { return parts_; }
  const Components& components() const { return components_; }
  const Relaxation& relaxation() const { return relaxation_; }
  /// How many nodes the glue of each contact held and lost, and how many elements of each part are deleted (of adhesive
  /// also where none is; welds have their own account), a line each, for run.log.
  std::vector<std::string> events() const;
  double first_step() const { return first_step_; }
  const system::System::Controlling& controlling() const { return controlling_; }  ///< what the step goes by
  /// Steps of so small a share of the time to go reach no end, however fast a cycle is; a number of cycles (ENDCYC) or
  /// what *TERMINATION_... looks at may end the run.
  bool without_end(double time_to_go, double step) const;
  /// What else the run tells of its step, in lines.
  const std::string& step_notes() const { return step_notes_; }
  double smallest_step() const { return smallest_step_; }
  const std::string& smallest_by() const { return smallest_by_; }

  enum Phase { elements, contacts, loads, constraints, motion, output, phases };
  static constexpr std::array<std::string_view, phases> phase_names{"elements",    "contact", "loads",
                                                                    "constraints", "motion",  "output"};
  const std::array<double, phases>& seconds() const { return seconds_; }
  double solve_seconds() const { return solve_seconds_; }

  /// What a rank of the run did; of a run by one process there is none.
  struct RankReport {
    std::size_t elements = 0;  ///< that it computes
    std::size_t states = 0;    ///< elements whose states it holds
    std::size_t segments = 0;  ///< of contact surfaces, that it holds
    std::size_t nodes = 0, shared_nodes = 0, neighbours = 0;
    double cost = 0.0;     ///< of its elements, over the mean of all ranks, as expected by system::element_cost
    double contact = 0.0;  ///< of what its nodes cost in contact, likewise; 0: there is none
    double messages = 0.0, bytes = 0.0;  ///< sent, a cycle
    double busy = 0.0, waiting = 0.0;    ///< seconds
    double peak_memory = 0.0;            ///< MB
  };
  const std::vector<RankReport>& rank_reports() const { return rank_reports_; }
  /// What several ranks do not share out: every one of them computes it whole, and follows its nodes besides those of
  /// its own elements, of supports and of loads.
  struct ComputedByAll {
    std::vector<std::string> names;
    bool every_node = false;  ///< some of it looks at all nodes, so that every rank follows them
  };
  ComputedByAll computed_by_all() const;
  /// Nodes, by system number, that every rank follows: those, and all others that somebody looks at between results.
  std::vector<char> followed_by_all() const;
  /// What contact costs at the start; `ranks`: all of them look, and the first one gets it. Null: this process looks.
  system::ContactCosts contact_costs(Ranks* ranks);
  /// How so many ranks would share out the elements.
  system::Partition partition(int ranks, const system::ContactCosts& contact, system::DeletedElements deleted = {});

  /// Asks a running simulation to stop after the current cycle (from a signal handler).
  static void interrupt(const char* by = "the user");
  static bool interrupted();

  void archive(Archive& a);
  /// Over several ranks a run goes on with elements shared out anew: by this, which stands before the state.
  void archive_costs(Archive& a);

 private:
  void start();
  /// Takes over the state of a restart file.
  void resume(const Options& options);
  /// Internal forces of what is there, without a step.
  void internal_force_at_rest();
  /// Dynamic relaxation, where the deck asks for it. Afterwards the run begins at time 0 with the stresses and places
  /// that are reached and the initial velocities. Gives a reason to stop the run, if there is one.
  Outcome relax(const Options& options, Recorder& recorder, const ProgressCallback& progress);
  /// From now on several ranks compute the run together.
  void share_out(Ranks& ranks, const Options& options);
  void forget_costs();
  /// The element that controls the step.
  system::System::Controlling controlling_of_all() const;
  void report_ranks();
  int first_not_finite() const;
  bool on_first_rank() const { return ranks_ == nullptr || ranks_->rank() == 0; }
  /// Once a cycle, before it begins: the element that controls the step, and whether the run is to stop, to write a
  /// restart file or a state that is not due. Of several ranks all take the same.
  void agree(const Options& options);
  /// Elements that other ranks compute, and what components keep of them; see System::collect.
  void collect(system::Carried what, bool to_all = false);
  /// States, nodal forces and nodes of the elements that cross sections and discrete beams of histories show.
  void collect_shown();
  void find_shown();
  /// Sets free what of other ranks came with these, when it has been used.
  void leave_to_others();
  /// Whether results are due at the state that is about to be complete.
  bool results_due(Recorder& recorder) const;
  /// Whether what is due shows energies.
  bool balance_due(Recorder& recorder) const;
  /// A velocity is no number, or so large that energies may be none.
  bool runs_away() const;
  /// Whether what is due looks at elements; in one process they are there anyway.
  bool elements_due() const;
  /// Whether what is written looks at states of elements.
  bool shows_elements(bool last) const;
  /// After a balance of energies, which the first rank makes: what others must know of it.
  void pass_on_balance(const Recorder& recorder);
  /// Velocities from t(n-1/2) to t(n+1/2), with supports and walls.
  void update_velocities();
  /// The step from t(n) to t(n+1), up to the forces there.
  void step();
  /// As many steps as the time takes from one at which all elements have forces to the next.
  void advance();
  void choose_step(double end_time);
  /// Gives the free nodes and bodies their velocities at t(n+1/2), and books `step_change` of the nodes;
  /// `power_on_change_` begins anew.
  void accelerate();
  double step_change(std::size_t node) const;
  double step_change_before_now(std::size_t node) const;
  void move();
  void contact_forces();
  void apply_contacts(const contact::Step& step, std::span<Row> force);
  void applied_forces();  // of ties with springs, joints, loads and damping
  /// Removes the elements that were deleted from contacts and ties.
  void remove_deleted_elements();
  /// Transfers the loads of dependent nodes to the independent ones; rigid welds that they overload are released.
  void transfer_dependent_forces();
  void update_inverse_mass();
  /// The same after System::scale_mass(false): of the nodes whose masses that changed.
  void update_scaled_mass();
  /// At the start, and where nodes were released: bounds that follow from nodal masses.
  void update_mass_bounds();
  void report_weak_ties(Findings& findings);
  /// Stable steps and scaled masses of the undeformed mesh, before the run.
  void find_steps_at_rest();
  /// What bricks and doubtful shells allow as they are assembled: a finding, and a shorter step where the deck leaves
  /// TSSFAC to the program.
  void bound_step_at_start(Findings& findings);
  std::string describe(const AssembledStep::Limit& limit) const;
  void remember_bound(double step, double limit);
  /// Every `cycles_between_looks` cycles, where elements were deformed or nodes released.
  void bound_step_again();
  /// The step by the elements' formulas, mass scaling included; `bound_step_...` may shorten it.
  double step_of_elements() const;
  /// Without deformable elements nothing but the joints says how long a step may be.
  double step_of_bodies(double end_time);
  /// Stores the velocities at t(n-1/2), before `update_velocities`.
  void store_velocities();
  /// The first rank writes, and others give their share of what is as large as the model.
  void write_results(Recorder& recorder, bool last);
  Snapshot snapshot() const;
  void report_progress(const ProgressCallback& progress, double end_time) const;
  /// Does between two cycles what somebody has asked for.
  void obey(const SenseSwitches& switches, Recorder& recorder);
  /// Energies at the present time; the previous ones stay where the solution is not a number.
  void update_energy_balance();
  /// Ten times the energy that was ever put in has come from nowhere, and it is most of what there is, or a part or the
  /// contacts gave it.
  bool energy_is_made() const;
  std::vector<PartEnergy>::const_iterator giving_part() const;
  bool contact_gives() const;
  double most_given() const;
  double input() const;                         ///< the most energy that was ever put in
  double energy_of_pressures_at_start() const;  ///< what equations of state may give at most
  std::string describe_instability() const;
  /// Of the first brick of negative volume of a group: which, when, and what to do.
  std::string describe_inverted(const system::ElementGroup& group) const;
  /// Between two cycles: writes a restart file if one is due, or the run was interrupted.
  void write_checkpoint_if_due(const Options& options);
  bool state_asked_ = false;  ///< a state of d3plot that is not due
  Outcome reason_to_stop(const Options& options, double end_time) const;
  /// Adds the time since the last call to a phase.
  void add_time(Phase phase);
  double elapsed() const;  ///< seconds since the run began, without those between a restart file and the resumption

  system::System& system_;
  system::State state_;
  Components components_;
  std::vector<system::SpringGroup*> stopped_springs_;    ///< those with stops
  std::vector<double> contact_mass_;                     ///< by node, where that of rigid parts is not that of nodes
  std::vector<int> rigid_contact_nodes_;                 ///< nodes of such parts; ascending
  std::vector<unsigned char> dependent_;                 ///< by node
  ZeroedVector<double> inverse_mass_, inverse_inertia_;  ///< by node; over several ranks of those that it follows
  system::Rows v_before_, w_before_;
  /// Of nodes whose motion travels (SumsByRank), on the first of several ranks while it adds up energies: that, and
  /// what of `step_change` is booked there.
  std::vector<NodalMotion> motion_of_others_;
  std::vector<double> step_change_of_others_;
  SumsOfRanks sums_of_ranks_;  ///< likewise
  PartNodes part_nodes_;
  /// What `collect_shown` brings; empty in a run by one process.
  struct Shown {
    std::vector<system::System::ElementLocation> elements;
    std::vector<std::pair<int, std::size_t>> blocks;  ///< that they stand in: group, block
    std::vector<int> nodes;
  };
  Shown shown_;
  system::ContactCosts contact_costs_now_;  ///< while a restart file is written, or read before shares are known
  system::DeletedElements deleted_now_;     ///< likewise
  system::Rows v_period_, w_period_;        ///< in sub-cycling: velocities and spins after those of the last period
  std::vector<Row> contact_forces_;         ///< in sub-cycling, where contacts have theirs not in each cycle
  double run_end_ = 0.0;                    ///< where the period that begins ends the run: its time; else 0
  std::vector<Vec3d> momentum_before_;
  std::vector<Vec3d> history_rotation_;
  bool stop_requested_ = false;  ///< the run was interrupted before this cycle
  bool restart_file_due_ = false;
  std::vector<RankReport> rank_reports_;
  std::vector<system::Partition::Share> shares_;  ///< of the ranks, as they were shared out; on the first one
  Ranks::Traffic traffic_before_;
  long cycle_before_ = 0;       ///< when ranks began
  Ranks* ranks_ = nullptr;      ///< null: one process
  int not_finite_ = -1;         ///< a node whose velocity is not a number, every 50 cycles
  double shared_out_at_ = 0.0;  ///< seconds: when ranks began
  Recorder::Marks next_marks_;  ///< over several ranks: those of the first one's files
  CheckpointSchedule checkpoints_;
  bool diverged_ = false;
  bool gives_energy_ = false;  ///< a part or the contacts do so, by the last balance
  bool unstable_ = false;      ///< energy_is_made at the last cycle that is a multiple of 100
  Relaxation relaxation_;
  double step_change_ = 0.0;                  ///< Energy::step_change so far, but for what nodes and supports add
  ZeroedVector<double> step_change_of_node_;  ///< this, with what their forces at t(n) add
  double largest_input_ = 0.0;                ///< of the energy balances so far: what was there and put in, its size
  double power_on_change_ = 0.0;  ///< forces at t(n), but on free nodes, times what they change in velocities

  Energy energy_;
  std::vector<PartEnergy> parts_;
  system::System::Controlling controlling_;
  system::System::Masses masses_;
  double first_step_ = 0.0, smallest_step_ = 0.0;
  double stable_step_ = 0.0;   ///< of this step, before DTINIT or the end of the run cut it; 0 at the start
  double longest_step_ = 0.0;  ///< of those
  AssembledStep assembled_step_;
  bool at_rest_ = false;          ///< find_steps_at_rest has been there
  double advised_scale_ = 0.0;    ///< TSSFAC that the deck should give; 0: none
  double step_factor_ = 1.0;      ///< on the step of the elements, by what elements allow as they are assembled
  double bounded_step_ = 0.0;     ///< the elements' step when it was found
  double bearable_change_ = 0.0;  ///< of that step, as a share, until it is found anew
  long looks_ = 0;                ///< how often it was found
  bool masses_changed_ = false;   ///< nodes were released since then
  double bodies_step_ = 0.0;      ///< of a model of rigid bodies, by their joints; 0: not limited
  long bodies_cycle_ = 0;         ///< when it was found
  std::string step_notes_;
  std::string smallest_by_;
  std::array<double, phases> seconds_{};
  std::chrono::steady_clock::time_point begin_, timed_until_;
  double solve_seconds_ = 0.0;
};

}  // namespace nugget::impact
