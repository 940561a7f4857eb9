// SPDX-License-Identifier: Apache-2.0
#include "app/commands.hpp"

#include <fmt/format.h>
#include <sys/time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <functional>
#include <optional>

#include "app/audit_table.hpp"
#include "app/clock.hpp"
#include "app/command.hpp"
#include "app/contact_warnings.hpp"
#include "app/frf.hpp"
#include "app/history_columns.hpp"
#include "app/linear_checks.hpp"
#include "app/load_cases.hpp"
#include "app/modes.hpp"
#include "app/outcome.hpp"
#include "app/progress.hpp"
#include "app/rank_team.hpp"
#include "app/restart.hpp"
#include "app/run_log.hpp"
#include "app/run_status.hpp"
#include "app/statics.hpp"
#include "app/subcycling.hpp"
#include "app/weld_drop_runs.hpp"
#include "base/free_room.hpp"
#include "base/large_arrays.hpp"
#include "base/parallel.hpp"
#include "base/peak_memory.hpp"
#include "impact/recording/result_files.hpp"
#include "impact/recording/weld_results.hpp"
#include "impact/simulation/simulation.hpp"
#include "nvh/matrices/ranks.hpp"
#include "output/column_units.hpp"
#include "output/results.hpp"
#include "reading/describe.hpp"
#include "report/page.hpp"
#include "report/run_data.hpp"
#include "report/vtk.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

output::Summary::ElementsByPrecision elements_by_precision(const system::System& system) {
  output::Summary::ElementsByPrecision count;
  for (const auto& group : system.groups)
    (group->single_precision() ? count.single : count.of_double) += static_cast<long>(group->size());
  return count;
}

output::Summary summarise(const RunArguments& arguments, const impact::Simulation& run, const impact::Outcome& outcome,
                          const PreparedDeck& p, double setup_seconds) {
  const system::System& system = run.system();
  output::Summary s;
  s.version = NUGGET_VERSION;
  s.deck = arguments.deck;
  s.load_case = arguments.load_case;
  s.files = p.files;
  s.units = unit_name(p.model);
  s.title = p.model.title;
  s.date = today();
  s.termination = outcome.termination == impact::Termination::normal  ? "normal"
                  : outcome.termination == impact::Termination::error ? "error"
                                                                      : "interrupted";
  s.message = outcome.message;
  s.count = counts(p.model, p.ties);
  s.cycles = run.state().cycle;
  s.time = run.state().time;
  s.time_step = {run.first_step(), run.smallest_step(), run.smallest_by()};
  if (system.model.control.relaxation.on()) {
    const impact::Relaxation& r = run.relaxation();
    s.relaxation = {r.cycles(), r.time(), r.kinetic_energy_ratio(), r.at_rest()};
  }
  const system::System::Masses m = system.masses();
  s.mass = {m.physical, m.added, m.added_to_welds};
  const impact::Energy& e = run.energy();
  const contact::ContactEnergies of_contact = run.components().contacts.energies();
  s.energy = {e.kinetic,
              e.internal,
              e.hourglass,
              e.contact,
              e.damping,
              e.external,
              e.eroded + e.eroded_kinetic,
              e.step_change,
              e.initial,
              e.ratio(),
              e.ratio_without_step_change(),
              e.bulk_viscosity,
              of_contact.springs,
              of_contact.friction,
              of_contact.damping,
              of_contact.lost()};
  s.seconds.read = p.read_seconds;
  s.seconds.setup = setup_seconds;
  s.seconds.solve = run.solve_seconds();
  s.seconds.output = run.seconds()[impact::Simulation::output];
  for (int i = 0; i < impact::Simulation::phases; ++i)
    s.seconds.phases.emplace_back(impact::Simulation::phase_names[i], run.seconds()[i]);
  std::size_t elements = 0;
  for (const auto& group : system.groups) elements += group->size();
  const double work = static_cast<double>(elements) * static_cast<double>(s.cycles);
  if (work > 0.0) s.ns_per_element_cycle = 1e9 * (run.solve_seconds() - s.seconds.output) / work;
  s.peak_memory = peak_memory();
  s.threads = threads();
  s.ranks = nvh::ranks();
  for (const impact::Simulation::RankReport& r : run.rank_reports())
    s.rank.push_back({static_cast<long>(r.elements), static_cast<long>(r.states), static_cast<long>(r.segments),
                      static_cast<long>(r.nodes), static_cast<long>(r.shared_nodes), static_cast<long>(r.neighbours),
                      r.cost, r.contact, r.messages, r.bytes, r.busy, r.waiting, r.peak_memory});
  s.lanes = system::elements_at_a_time();
  s.precision = system.model.control.single_precision ? "single" : "double";
  s.elements_by_precision = elements_by_precision(system);
  s.periods = element_periods(system);
  s.welds = p.welds;
  return s;
}

/// Options of the run, and how its state goes into restart files and, if `from` is not null, comes out of one.
impact::Options options_of(const RunArguments& arguments, const output::RestartHead& head, const fs::path& directory,
                           impact::Simulation& simulation, impact::Recorder& recorder, output::RestartReader* from,
                           Ranks* ranks) {
  impact::Options options{.until = arguments.until, .max_cycles = arguments.max_cycles};
  if (!arguments.checkpoint.empty()) options.checkpoints = *read_checkpoints(arguments.checkpoint);
  options.ranks = ranks;
  options.write_checkpoint = [=, &simulation, &recorder] {
    output::RestartHead now = head;
    now.program = output::checksum_of_program();  // found when it is needed: the program is large
    now.time = simulation.state().time;
    now.cycle = simulation.state().cycle;
    output::RestartWriter file(directory, now, ranks);
    simulation.archive_costs(file);
    file(simulation, recorder);
    file.finish();
  };
  if (from == nullptr) return options;
  options.restore_costs = [=, &simulation] { simulation.archive_costs(*from); };
  options.restore = [=, &simulation, &recorder] { (*from)(simulation, recorder); };
  return options;
}

/// A batch system says by one of these that a job's time is up; all leave a restart file, as Ctrl-C does.
void interrupt_on_signals(double stop_after) {
  std::signal(SIGINT, [](int) { impact::Simulation::interrupt(); });
  std::signal(SIGTERM, [](int) { impact::Simulation::interrupt("SIGTERM"); });
  std::signal(SIGHUP, [](int) { impact::Simulation::interrupt("SIGHUP"); });
  std::signal(SIGXCPU, [](int) { impact::Simulation::interrupt("SIGXCPU, the limit of processor time,"); });
  std::signal(SIGUSR1, [](int) { impact::Simulation::interrupt("SIGUSR1"); });
  std::signal(SIGALRM, [](int) { impact::Simulation::interrupt("--stop-after"); });
  if (stop_after <= 0.0) return;
  itimerval timer{};
  double seconds = 0.0;
  timer.it_value.tv_usec = static_cast<suseconds_t>(1e6 * std::modf(stop_after, &seconds));
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  setitimer(ITIMER_REAL, &timer, nullptr);
}

/// Runs with results, progress and the keyboard's interrupt. A result that cannot be written is reported in run.log, as
/// far as that can still be done.
impact::Outcome simulate(impact::Simulation& simulation, const fs::path& directory, const RunArguments& arguments,
                         output::RestartHead head, output::RestartReader* from, Ranks* ranks,
                         const std::function<void()>& made, Log& log) {
  interrupt_on_signals(arguments.stop_after);
  ProgressDisplay display;
  StatusFile status(directory, arguments.deck);
  const auto progress = [&](const impact::Progress& p) {
    status.update(p);
    if (arguments.progress)
      arguments.progress(p);
    else if (!arguments.quiet)
      display(p);
  };
  try {
    const system::System& system = simulation.system();
    if (from != nullptr) head.date = from->head().date;
    impact::ResultFiles files(system, directory,
                              {system.model.title, fmt::format("nugget {}", NUGGET_VERSION), head.date,
                               from == nullptr ? output::OpenMode::create : output::OpenMode::append});
    impact::Options options = options_of(arguments, head, directory, simulation, files, from, ranks);
    options.made = made;
    options.sense_switches = [&] {
      const impact::SenseSwitches asked = take_sense_switch(directory);
      if (asked.report || asked.restart_file || asked.state) {
        display.finish();
        fmt::print(stderr, "d3kil: {}\n", progress_line(status.last()));
      }
      if (asked.state && !system.model.requests.d3plot.asked())
        fmt::print(stderr, "d3kil: sw4 writes nothing, since the deck asks for no d3plot [*DATABASE_BINARY_D3PLOT]\n");
      return asked;
    };
    impact::Outcome outcome = simulation.run(options, files, progress);
    display.finish();
    // In a dynamic relaxation there is none.
    if (outcome.termination == impact::Termination::interrupted && fs::exists(directory / "restart"))
      outcome.message += fmt::format("; to go on: nugget run --resume {}", directory.string());
    return outcome;
  } catch (const output::WriteError& error) {
    display.finish();
    status.fail();
    log.try_to_add(log_termination({impact::Termination::error, error.what()}));
    throw;
  } catch (const std::bad_alloc&) {
    display.finish();
    status.fail();
    log.try_to_add(log_termination({impact::Termination::error, no_memory}));
    throw;
  }
}

constexpr double doubtful = 0.05;  // of the energy: off the ratio of 1, or taken by the change of step

/// A run may reach its end time with results that nobody should use.
std::string energy_warning(const output::Summary& summary) {
  const output::Summary::Energies& e = summary.energy;
  if (summary.termination == "error") return {};
  if (std::abs(e.ratio - 1.0) > doubtful)
    return fmt::format(
        "warning: the energy ratio ended at {:.4g}, expected 1: results are doubtful from the time on when it left 1 "
        "(see glstat)",
        e.ratio);
  // A striker that hardly slows down hides an error that is large beside the work on the structure.
  const double input = e.initial + e.external, error = std::abs((e.ratio - 1.0) * input);
  if (error > output::EnergyLimits::error_of_internal * (std::abs(e.internal) + std::abs(e.eroded)) &&
      error > 1e-3 * std::abs(input))
    return fmt::format(
        "warning: the energy balance is off by {:.3g}, beside an internal energy of {:.3g}: results are doubtful (see "
        "glstat)",
        error, e.internal);
  // Where a moving wall brings the energy, none is put in from outside; initial stresses give theirs, which is not
  // counted, until the internal energy is below 0.
  const double all = std::max(std::abs(e.initial + e.external), e.kinetic + std::abs(e.internal));
  const bool much_of_internal =
      std::abs(e.step_change) > output::EnergyLimits::error_of_internal * (std::abs(e.internal) + std::abs(e.eroded)) &&
      std::abs(e.step_change) > 1e-2 * all;
  if (std::abs(e.step_change) <= doubtful * all && !much_of_internal) return {};
  return fmt::format(
      "warning: the change of the time step took {:.2g} % of the energy{}: much of it is in vibrations that the step "
      "hardly resolves [a smaller TSSFAC shows whether they matter]",
      100.0 * e.step_change / all,
      much_of_internal ? fmt::format(", {:.3g} beside an internal energy of {:.3g}", e.step_change, e.internal) : "");
}

/// What the elements of a part are, and what keeps them from hourglassing.
std::pair<std::string, std::string_view> elements_and_remedy(const model::Model& model, const model::Part& part) {
  if (part.kind == model::ElementKind::shell) {
    const int form = model.shell_sections[part.section].elform;
    return {
        fmt::format("shells of ELFORM {}", form),
        form == 16  ? "a smaller DRCPRM of *CONTROL_SHELL: these shells have no hourglass modes, it is their stiffness "
                      "against drilling"
        : form == 5 ? "ELFORM 9 in its *SECTION_SHELL, or *HOURGLASS with IHQ 4 and QM 0.05; smaller elements where "
                      "single nodes are pushed"
                    : "ELFORM 16 in its *SECTION_SHELL, or *HOURGLASS with IHQ 4 and QM 0.05; smaller elements where "
                      "single nodes are pushed"};
  }
  if (part.kind == model::ElementKind::solid && model.solid_sections[part.section].thickness)
    return {
        fmt::format("thick shells of ELFORM {}", model.solid_sections[part.section].elform),
        model.solid_sections[part.section].elform == 1
            ? "ELFORM 2 in its *SECTION_TSHELL, or *HOURGLASS with IHQ 4 and QM 0.05; smaller elements where single "
              "nodes are pushed"
            : "smaller elements where they fold or single nodes are pushed; QM below 1 in an *HOURGLASS with IHQ 6 of "
              "the part"};
  if (part.kind == model::ElementKind::solid)
    return {fmt::format("bricks of ELFORM {}", model.solid_sections[part.section].elform),
            "*HOURGLASS with IHQ 5 and QM 0.05 where it is crushed, IHQ 6 and QM 1 where it bends, or ELFORM 2 in its "
            "*SECTION_SOLID; smaller elements where single nodes are pushed"};
  return {"its elements", "*HOURGLASS with IHQ 4 and QM 0.05"};
}

using OnePart = std::vector<impact::PartEnergy>::const_iterator;
OnePart part_with_most_hourglass(const impact::Simulation& run) {
  return std::ranges::max_element(run.part_energies(), {}, &impact::PartEnergy::hourglass);
}

/// The part that has most of the hourglass energy, and what to change there.
std::optional<output::Summary::Hourglass> most_hourglass(const impact::Simulation& run) {
  const std::vector<impact::PartEnergy>& parts = run.part_energies();
  const OnePart worst = part_with_most_hourglass(run);
  if (worst == parts.end() || !(worst->hourglass > 0.0)) return std::nullopt;
  const model::Model& model = run.system().model;
  const model::Part& part = model.parts[static_cast<std::size_t>(worst - parts.begin())];
  const auto [elements, remedy] = elements_and_remedy(model, part);
  return output::Summary::Hourglass{part.id, worst->hourglass, elements, std::string(remedy)};
}

/// Hourglass energy is work that no material did. Where all flies or swings and little is internal, it says little.
std::string hourglass_warning(const impact::Simulation& run, const output::Summary& summary) {
  const output::Summary::Energies& e = summary.energy;
  if (summary.termination == "error" || !summary.hourglass ||
      e.hourglass <= output::EnergyLimits::hourglass * e.internal ||
      e.hourglass <= 0.01 * std::abs(e.initial + e.external))
    return {};
  const output::Summary::Hourglass& most = *summary.hourglass;
  return fmt::format(
      "warning: the hourglass energy, {:.3g}, is more than a tenth of the internal energy, {:.3g}; 5 % is usual: "
      "elements fold in patterns in which their material has no stress, and hourglass control alone resists, so that "
      "part "
      "of the forces is none of the material's; most of it, {:.3g}, in part {} ({}), beside an internal energy of "
      "{:.3g} "
      "there [{}; matsum has all parts]",
      e.hourglass, e.internal, most.energy, most.part, most.elements, part_with_most_hourglass(run)->internal,
      most.remedy);
}

/// A run in which nothing happens looks sound.
std::string idle_warning(const output::Summary& summary) {
  const output::Summary::Energies& e = summary.energy;
  if (summary.termination != "normal" || e.initial != 0.0 || e.external != 0.0 || e.kinetic != 0.0 || e.internal != 0.0)
    return {};
  return "warning: nothing moved: there was no energy in the whole run [give a velocity, a load or a motion; a "
         "velocity "
         "along a held direction (*BOUNDARY_SPC, CON1 and CON2 of *MAT_RIGID) is none]";
}

std::string loose_weld_warning(const output::Summary& summary) {
  const auto loose = std::ranges::count_if(summary.welds, [](const output::WeldReport& w) { return !w.tied; });
  if (loose == 0 || summary.termination == "error") return {};
  return fmt::format(
      "warning: {} of {} welds are not tied to their sheets and hold nothing [welds.csv says which and why]", loose,
      summary.welds.size());
}

/// Joints are springs; one that opens far has let its bodies go where they cannot be.
std::string joint_warning(const impact::Simulation& run, const output::Summary& summary) {
  constexpr double bearable = 0.01;
  const impact::Joints& joints = run.components().joints;
  if (summary.termination == "error") return {};
  std::size_t worst = 0;
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (joints.largest_relative_opening(i) > joints.largest_relative_opening(worst)) worst = i;
  if (joints.size() == 0 || joints.largest_relative_opening(worst) <= bearable) return {};
  return fmt::format(
      "warning: joint {} opened by {:.3g}, {:.2g} % of its bodies' size: the step is too long for its forces [give a "
      "smaller step: curve LCTM of *CONTROL_TIMESTEP, or TSSFAC]",
      run.system().model.joints[worst].id, joints.largest_opening(worst),
      100.0 * joints.largest_relative_opening(worst));
}

/// Modes of the state in which a run has ended, into a folder of their own (IMFLAG 6).
ExitCode modes_after(const fs::path& directory, const RunArguments& arguments, const PreparedDeck& prepared,
                     const impact::Simulation& run) {
  const fs::path folder = directory / "modes";
  fs::create_directories(folder);
  output::remove_old_results(folder);
  ModesArguments modes;
  modes.run = arguments;
  modes.response = true;
  Findings findings;
  return modes_of(folder, modes, prepared, findings, {}, &run);
}

/// What is wrong with the command for such an analysis; empty: nothing.
std::string wrong_command(Analysis analysis, const RunArguments& arguments, const model::Model& model,
                          const Findings& findings) {
  const bool is_explicit = analysis == Analysis::explicit_dynamics;
  if (!is_explicit && !arguments.checkpoint.empty())
    return "--checkpoint: this deck asks for an implicit solution, which has no restart files";
  if (arguments.precision == "single" && !is_explicit)
    return "--precision single: this deck asks for an implicit solution, which is of double precision only [leave the "
           "option out]";
  if (arguments.precision == "single" && model.implicit.after_run)
    return "--precision single: this deck asks for modes after the run (IMFLAG 6), whose stiffness is of double "
           "precision only [leave the option out]";
  if (arguments.subcycle && !is_explicit)
    return "--subcycle: this deck asks for an implicit solution, which has no cycles [leave the option out]";
  if (findings.errors() == 0 && is_explicit && nvh::ranks() > 1 && !arguments.over_ranks)
    return fmt::format(
        "{}: explicit runs of this command are one process each, with -j N threads; several ranks are for nugget run, "
        "modes, responses and statics; nothing was run",
        arguments.deck);
  return {};
}

/// Of --precision single: which elements it does not change.
void say_what_stays_double(const system::System& system, Findings& findings) {
  const auto count = elements_by_precision(system);
  if (count.single == 0)
    findings.warning(
        {system.model.deck, 0}, "",
        "--precision single: no element of this deck has a kernel in single precision; all are computed in "
        "double precision",
        "leave the option out");
  else if (count.of_double > 0)
    findings.note(
        {system.model.deck, 0}, "",
        fmt::format("--precision single: {} of {} elements have no kernel in single precision and are computed "
                    "in double precision; run.log lists them by part",
                    count.of_double, count.single + count.of_double));
}

/// Of stresses that are the sum of so many changes that rounding shows (docs/manual/precision.md#when-to-use-it).
std::string precision_warning(const output::Summary& summary) {
  constexpr long many = 300000;
  const long cycles = summary.cycles + (summary.relaxation ? summary.relaxation->cycles : 0);
  if (summary.elements_by_precision.single == 0 || cycles <= many) return {};
  return fmt::format(
      "warning: {} cycles in single precision: stresses that are built up evenly over more than {} may be wrong by "
      "some "
      "percent [--precision double]",
      cycles, many);
}

/// run.log and the terminal, from the end of the run on.
void report_end(const RunArguments& arguments, const fs::path& directory, const impact::Simulation& simulation,
                const impact::Outcome& outcome, const output::Summary& summary, Log& log) {
  log.add(log_mass(simulation.system()));
  log.add(log_run(simulation, summary));
  const std::array<std::string, 8> warnings{idle_warning(summary),
                                            precision_warning(summary),
                                            loose_weld_warning(summary),
                                            energy_warning(summary),
                                            hourglass_warning(simulation, summary),
                                            joint_warning(simulation, summary),
                                            dropped_spring_warning(simulation, summary),
                                            giving_contact_warning(simulation, summary)};
  for (const std::string& line : warnings) log.add(line.empty() ? "" : ' ' + line + "\n\n");
  log.add(log_termination(outcome));
  if (!outcome.message.empty()) fmt::print(stderr, "{}\n", outcome.message);
  for (const std::string& line : warnings)
    if (!line.empty()) fmt::print(stderr, "{}\n", line);
  if (!arguments.quiet)
    fmt::print(stderr, "{}results in {}, to begin with {}\n", in_short(summary), directory.string(),
               (directory / "report.html").string());
  fmt::print("{}", log_termination({outcome.termination, {}}));
}

/// What the ranks of a run compare before it begins.
JoinedRun::Ready ready(const JoinedRun& joined, const PreparedDeck& p, const Findings& findings,
                       const output::RestartReader* from) {
  JoinedRun::Ready own{.willing = findings.errors() == 0};
  if (joined.ranks() == nullptr) return own;
  own.deck = p.deck_checksum;
  own.program = output::checksum_of_program();  // takes as long as some hundred cycles of a small model
  own.lanes = system::elements_at_a_time();
  own.restart_file = from != nullptr ? from->checksum() : 0;
  return own;
}

/// Ranks of an explicit run work together from the moment on when they have read their decks.
WorkTogether together(JoinedRun& joined, const Findings& findings, const output::RestartReader* from) {
  return [&joined, &findings, from](const PreparedDeck& read, const std::function<void(Ranks*)>& work) {
    if (joined.ranks() == nullptr || analysis_of(read.model) != Analysis::explicit_dynamics) return work(nullptr);
    joined.work_together(ready(joined, read, findings, from), work);
  };
}

/// Several ranks give elements their states when they have been shared out.
system::System::ElementsStart elements_start(const JoinedRun& joined) {
  using Start = system::System::ElementsStart;
  return joined.ranks() != nullptr ? Start::with_share : Start::at_once;
}

/// `from`: the restart file of a run that is resumed; null: a new one.
ExitCode run_explicit(const fs::path& directory, const RunArguments& arguments, PreparedDeck p, Findings& findings,
                      output::RestartReader* from, JoinedRun& joined) {
  Log log(directory / "run.log");
  Clock clock;
  std::optional<system::System> system;
  std::optional<impact::Simulation> simulation;
  // Faults of ties, of the system and of what acts in it are reported together.
  make_system(p, system, findings, elements_start(joined));
  if (system) simulation.emplace(*system, findings, p.model.implicit.after_run ? nullptr : &p.model);
  if (system) check_subcycling(*simulation, findings);
  // Each rank of several has its own share of the run only.
  if (system && p.model.implicit.after_run && findings.errors() == 0 && joined.ranks() == nullptr)
    check_modes_after(directory / "modes", arguments, p, *simulation, findings);
  if (system && p.model.control.single_precision) say_what_stays_double(*system, findings);
  std::string welds;  // of a deck that is refused, as `nugget check` reports them: all that is to be mended, at once
  if (from != nullptr) {
    log.read();
    log.add(log_resumption(from->head(), today()));
  } else {
    if (findings.errors() > 0) {
      welds = report_refused_welds(p, findings);
      welds += audit_table(p.model, p.ties, p.audit);
    }
    start_log(log, arguments, p, findings);
    log.add(welds);
  }
  if (findings.errors() > 0) {
    const ExitCode code = refuse(directory, log, findings);
    if (!arguments.quiet) fmt::print(stderr, "{}", welds);
    return code;
  }
  if (from == nullptr) {
    print_findings(findings);
    output::write_findings(directory, findings.all());
    log.add(log_model(p.model));
    if (p.model.control.single_precision) log.add(log_precision(simulation->system()));
    log.add(log_subcycling(simulation->system()));
    log.add(log_ties(p.model, p.ties, no_limit) + log_tied_nodes(p.model, p.ties));
    log.add(audit_table(p.model, p.ties, p.audit));
  }
  std::string why;
  if (!joined.agree(ready(joined, p, findings, from), why)) {
    log.add(fmt::format(" {}\n\n E r r o r   t e r m i n a t i o n\n", why));
    fmt::print(stderr, "nugget: {}; nothing was run\n", why);
    return ExitCode::refused;
  }
  if (const std::string crowded = joined.use_threads(arguments.threads); !crowded.empty()) {
    log.add(fmt::format(" {}\n\n", crowded));
    fmt::print(stderr, "note: {}\n", crowded);
  }
  if (!p.model.implicit.after_run) {
    system->forget_start(p.model);
    free_room(p.audit);
    // Displacements of nodes, and areas of beams, count from there.
    if (p.model.requests.history_nodes.empty() && p.model.requests.cross_sections.empty()) free_room(p.model.nodes.x);
  }
  const auto made = [&p] {
    if (!p.model.implicit.after_run) free_room(p.ties.x);
  };
  const double setup_seconds = p.penetration_seconds + p.tie_seconds + p.audit_seconds + clock.seconds();

  const impact::Outcome outcome =
      simulate(*simulation, directory, arguments, head_of(arguments, p.deck_checksum), from, joined.ranks(), made, log);

  impact::add_weld_results(simulation->system(), simulation->components(), p.welds);
  output::Summary summary = summarise(arguments, *simulation, outcome, p, setup_seconds);
  summary.hourglass = most_hourglass(*simulation);
  output::write_welds(directory, p.welds);
  output::write_column_units(directory, model::units_of(p.model));
  output::write_summary(directory, summary);
  remove_status(directory);
  report_end(arguments, directory, *simulation, outcome, summary, log);
  const bool goes_on = outcome.termination == impact::Termination::normal && p.model.implicit.after_run;
  if (!goes_on) {  // the report of a large run needs the room
    simulation.reset();
    system.reset();
    p = PreparedDeck();
  }
  report::write_report(directory);
  switch (outcome.termination) {
    case impact::Termination::normal:
      return goes_on ? modes_after(directory, arguments, p, *simulation) : ExitCode::normal;
    case impact::Termination::error: return ExitCode::error_termination;
    case impact::Termination::interrupted: return ExitCode::interrupted;
  }
  return ExitCode::error_termination;
}

/// `from` as of run_explicit.
ExitCode run_in(const fs::path& directory, const RunArguments& arguments, output::RestartReader* from) {
  use_threads(arguments.threads);
  give_large_arrays_back();
  JoinedRun joined(arguments.over_ranks ? rank_team() : nullptr, arguments.load_case);
  Findings findings;
  PreparedDeck p = prepare(arguments, findings, EndTime::needed, together(joined, findings, from));
  if (!p.has_text) return refuse_missing(findings);
  warn_of_response_in_explicit_run(p.model, findings);
  const Analysis analysis = analysis_of(p.model);
  if (const std::string why = wrong_command(analysis, arguments, p.model, findings); !why.empty()) {
    fmt::print(stderr, "nugget: {}\n", why);
    return ExitCode::wrong_command;
  }
  if (from != nullptr)
    expect_same_deck(arguments.deck, p.deck_checksum, from->head());
  else
    output::remove_old_results(directory);
  if (analysis != Analysis::explicit_dynamics) joined.decline();
  switch (analysis) {
    case Analysis::explicit_dynamics: return run_explicit(directory, arguments, std::move(p), findings, from, joined);
    case Analysis::direct_response: return direct_responses(directory, arguments, std::move(p), findings);
    case Analysis::statics: return statics_of(directory, arguments, std::move(p), findings);
    case Analysis::modes_and_responses: {
      ModesArguments modes;
      modes.run = arguments;
      modes.response = true;
      return modes_of(directory, modes, std::move(p), findings);
    }
  }
  return ExitCode::error_termination;
}

/// A rank of a run that another one leads: computes its share and writes nothing.
ExitCode join(const RunArguments& arguments, output::RestartReader* from) {
  use_threads(arguments.threads);
  give_large_arrays_back();
  JoinedRun joined(rank_team(), arguments.load_case);
  Findings findings;
  PreparedDeck p = prepare(arguments, findings, EndTime::needed, together(joined, findings, from));
  free_room(p.audit);  // for those who write
  free_room(p.welds);
  if (!p.has_text || analysis_of(p.model) != Analysis::explicit_dynamics || !p.is_tied) return ExitCode::normal;
  system::System system(p.model, p.ties, findings, {}, elements_start(joined));
  impact::Simulation simulation(system, findings, &p.model);
  std::string why;
  if (!joined.agree(ready(joined, p, findings, from), why)) return ExitCode::normal;
  joined.use_threads(arguments.threads);
  system.forget_start(p.model);
  free_room(p.model.nodes.x);  // for those who write
  interrupt_on_signals(0.0);
  impact::Options options{.until = arguments.until, .max_cycles = arguments.max_cycles, .ranks = joined.ranks()};
  options.made = [&p] { free_room(p.ties.x); };
  options.write_checkpoint = [&] {
    output::RestartSender file(*joined.ranks());
    simulation.archive_costs(file);
    file(simulation);
    file.finish();
  };
  if (from != nullptr) {
    options.restore_costs = [&] { simulation.archive_costs(*from); };
    options.restore = [&] { (*from)(simulation); };
  }
  impact::ResultShares shares;
  simulation.run(options, shares, {});
  return ExitCode::normal;
}

/// The same, and its results for ParaView where they are asked for.
ExitCode run_and_convert(const fs::path& directory, const RunArguments& arguments, output::RestartReader* from) {
  const ExitCode code = run_in(directory, arguments, from);
  const bool has_results =
      code == ExitCode::normal || code == ExitCode::error_termination || code == ExitCode::interrupted;
  if (!arguments.vtk || !has_results) return code;
  try {
    report::write_vtk(directory, directory, report::read_run(directory));
  } catch (const std::runtime_error& error) {
    fmt::print(stderr, "warning: --vtk: {}\n", error.what());
  }
  return code;
}

}  // namespace

ExitCode run(const RunArguments& arguments) {
  const RankTeam* team = rank_team();
  const bool called = team != nullptr && team->called;
  if (called && arguments.resume.empty()) {
    RunArguments one = arguments;
    if (team->load_case != 0) one.load_case = team->load_case;
    return join(one, nullptr);
  }
  if (drops_each(arguments.drop_weld)) {
    if (nvh::ranks() > 1) {
      fmt::print(
          stderr,
          "nugget: --drop-weld {}: these are many runs, each a process of its own: leave mpirun out, and give -j "
          "N\n",
          arguments.drop_weld);
      return ExitCode::wrong_command;
    }
    return run_without_each(arguments);
  }
  if (has_cases(arguments)) return each_case(arguments, run);
  if (arguments.resume.empty())
    return guarded(arguments.directory,
                   [&](const fs::path& directory) { return run_and_convert(directory, arguments, nullptr); });
  return guarded(".", [&](const fs::path&) {
    std::string warning;
    std::unique_ptr<output::RestartReader> from;
    RunArguments run;
    try {
      from = output::open_restart(fs::absolute(arguments.resume), warning);
      run = resumed_arguments(arguments, from->head());
    } catch (const ArchiveError&) {
      if (called) const JoinedRun unwilling(rank_team(), arguments.load_case);  // the first one waits for an answer
      throw;
    }
    if (!warning.empty())
      fmt::print(stderr, "warning: {}; the one before it is taken, {}\n", warning, from->path().string());
    if (run.until > 0.0 && run.until < from->head().time)
      throw ArchiveError(
          fmt::format("--until {:g} lies before the restart file, whose time is {:g}: give a later end, "
                      "or run the deck again",
                      run.until, from->head().time));
    return called ? join(run, from.get()) : run_and_convert(run.directory, run, from.get());
  });
}

ExitCode keywords(const std::string& name) {
  if (name.empty())
    fmt::print("{}", reading::describe_keywords());
  else
    fmt::print("{}{}", reading::describe_keyword(name), describe_history(name));
  return ExitCode::normal;
}

}  // namespace nugget::app
