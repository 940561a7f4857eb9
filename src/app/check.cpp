// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include "app/audit_table.hpp"
#include "app/command.hpp"
#include "app/frf.hpp"
#include "app/linear_checks.hpp"
#include "app/linear_job.hpp"
#include "app/load_cases.hpp"
#include "app/partition_report.hpp"
#include "app/run_log.hpp"
#include "app/subcycling.hpp"
#include "impact/simulation/simulation.hpp"
#include "nvh/statics/statics.hpp"
#include "output/column_units.hpp"
#include "weld/tie/disc.hpp"
#include "weld/tie/joints.hpp"
#include "weld/tie/place_errors.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

/// The columns that --target-step adds to welds.csv.
void add_target(PreparedDeck& p, double step) {
  for (std::size_t w = 0; w < p.welds.size(); ++w) {
    const weld::StepCost target = weld::cost_of_step(p.audit[w].cost, step);
    p.welds[w].audit.emplace_back("target_mass", target.mass);
    p.welds[w].audit.emplace_back("target_young", target.young);
  }
}

/// How far the forces of each weld reach by either form of tie: two columns of welds.csv and a line on the terminal.
std::string add_holds(PreparedDeck& p) {
  const std::vector<weld::WeldReach> reaches = weld::reaches(p.model, p.ties);
  std::array<double, 2> least, most;
  least.fill(std::numeric_limits<double>::quiet_NaN());
  most = least;
  for (std::size_t w = 0; w < p.welds.size(); ++w) {
    const std::array<double, 2> hold{reaches[w].by_segment, reaches[w].by_area};
    p.welds[w].audit.emplace_back("hold_by_segment", hold[0]);
    p.welds[w].audit.emplace_back("hold_by_area", hold[1]);
    for (std::size_t form = 0; form < 2; ++form) {
      least[form] = std::fmin(least[form], hold[form]);
      most[form] = std::fmax(most[form], hold[form]);
    }
  }
  if (std::isnan(least[0])) return {};
  const bool now_by_area = by_area(p.model.control.weld_tie) ||
                           std::ranges::all_of(p.ties.welds, [](const weld::Weld& w) { return w.interpolated; });
  return fmt::format(
      "Reach of the welds' forces into the sheets over the nugget's radius: {:.2f} to {:.2f} by the element under the "
      "weld{}, {:.2f} to {:.2f} by area{}\n\n",
      least[0], most[0], now_by_area ? "" : ", as here", least[1], most[1],
      now_by_area ? ", as here" : " (--weld-tie area)");
}

/// What the joint of each weld has, where joints are asked for: columns of welds.csv, empty where a weld gets none.
void add_joints(PreparedDeck& p, const std::vector<std::optional<weld::Joint>>& joints) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const auto yield = [](double limit) { return limit < kernel::WeldJoint::never ? limit : nothing; };
  for (std::size_t w = 0; w < p.welds.size(); ++w) {
    const kernel::WeldJoint* joint = joints[w] ? &joints[w]->law : nullptr;
    const auto limit = joint && joint->flows() ? joint->limits(0.0) : std::array{nothing, nothing, nothing};
    p.welds[w].audit.emplace_back("joint_in_plane", joint ? joint->in_plane() : nothing);
    p.welds[w].audit.emplace_back("joint_bending", joint ? joint->bending() : nothing);
    p.welds[w].audit.emplace_back("joint_normal_yield", yield(limit[0]));
    p.welds[w].audit.emplace_back("joint_shear_yield", yield(limit[1]));
    p.welds[w].audit.emplace_back("joint_moment_yield", yield(limit[2]));
  }
}

/// What the place study found for welds with joints on such meshes: columns of welds.csv, and how many welds keep to
/// the limits that a body model is held to.
std::string add_place_errors(PreparedDeck& p, const std::vector<std::optional<weld::Joint>>& joints) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN(), of_lap = 0.05, of_bending = 0.12;
  const std::vector<weld::WeldReach> reaches = weld::reaches(p.model, p.ties);
  std::vector<bool> stacked(p.welds.size(), false);
  for (const weld::Stack& stack : weld::stacks_of(p.model, p.ties, joints).stacks)
    for (const weld::Stack::Member& member : stack.welds) stacked[member.weld] = true;
  std::size_t joined = 0, lap = 0, peel = 0, cross = 0, unknown = 0;
  for (std::size_t w = 0; w < p.welds.size(); ++w) {
    const weld::PlaceErrors* errors = joints[w] ? weld::place_errors(reaches[w].by_area) : nullptr;
    p.welds[w].audit.emplace_back("error_lap", errors ? errors->lap : nothing);
    p.welds[w].audit.emplace_back("error_peel", errors ? errors->peel : nothing);
    p.welds[w].audit.emplace_back("error_cross", errors ? errors->cross : nothing);
    p.welds[w].audit.emplace_back("error_stack", errors && stacked[w] ? errors->stack : nothing);
    p.welds[w].audit.emplace_back("error_force", errors ? errors->force : nothing);
    joined += joints[w].has_value();
    unknown += joints[w] && !errors;
    if (!errors) continue;
    lap += errors->lap <= of_lap;
    peel += errors->peel <= of_bending;
    cross += errors->cross <= of_bending;
  }
  if (joined == 0) return {};
  return fmt::format(
      "Welds with joints: {}. By coupons on such meshes their stiffness is within {:.0f} % in lap for {} of them, "
      "within {:.0f} % in peel for {}, in cross tension for {}{}; error_lap, error_peel, error_cross, error_force in "
      "welds.csv\n\n",
      joined, 100.0 * of_lap, lap, 100.0 * of_bending, peel, cross,
      unknown > 0 ? fmt::format("; {} on elements larger than any that was measured", unknown) : "");
}

/// Of a run that leaves nothing behind.
class NoResults final : public impact::Recorder {
 public:
  bool due(const system::State&) override { return false; }
  void write(const impact::Snapshot&, bool) override {}
};

/// Where the material stands of what the step goes by.
Place place_of_material(const model::Model& model, const impact::Simulation& simulation) {
  const system::System::Controlling& by = simulation.controlling();
  if (by.group < 0) return {model.deck, 0, 0};
  const model::Index material = model.parts[simulation.system().groups[by.group]->part].material;
  return material == model::none ? Place{model.deck, 0, 0} : model.materials[material].place;
}

/// Many faults of a model show in the first forces: an element inside out, a contact that throws, a step of nothing.
/// What ends a run there is an error of the check. A dynamic relaxation is not tried: it is a whole run.
void try_first_cycles(const model::Model& model, impact::Simulation& simulation, Findings& findings) {
  if (model.control.relaxation.on()) return;
  NoResults nothing;
  const impact::Outcome outcome = simulation.run({.max_cycles = 2}, nothing, {});
  if (outcome.termination == impact::Termination::error)
    findings.error({model.deck, 0, 0}, {}, "a run ends at its start: " + outcome.message,
                   "look at this place of the model, and at what was reported above");
  else if (simulation.without_end(model.control.end_time, simulation.first_step()))
    findings.error(
        place_of_material(model, simulation), {},
        fmt::format("a run would have no end: the time step {:.4g} of {} is so small a share of the end time",
                    simulation.first_step(), simulation.smallest_by()),
        "see density, stiffness and dimensions there, and ENDTIM of *CONTROL_TERMINATION");
}

/// What the linear analysis that the deck asks for refuses; its equations are set up, not solved.
void try_linear_setup(const fs::path& directory, const RunArguments& arguments, const PreparedDeck& p,
                      Analysis analysis, Findings& findings) {
  if (analysis == Analysis::statics) nvh::check_statics(p.model, findings);
  LinearJob job(directory, arguments, p, findings);
  check_linear(job, {.analysis = analysis}, findings);
}

ExitCode check_in(const fs::path& directory, const CheckArguments& arguments) {
  use_threads(arguments.deck.threads);
  Findings findings;
  PreparedDeck p = prepare(arguments.deck, findings);
  if (!p.has_text) return refuse_missing(findings);
  warn_of_response_in_explicit_run(p.model, findings);
  Log log(directory / "check.log");
  // Faults of ties, of the system and of what acts in it are reported together.
  const Analysis analysis = analysis_of(p.model);
  std::string ranks;
  if (analysis != Analysis::explicit_dynamics) {
    try_linear_setup(directory, arguments.deck, p, analysis, findings);
  } else if (p.is_tied) {
    std::optional<system::System> system;
    make_system(p, system, findings);
    impact::Simulation simulation(*system, findings);
    check_subcycling(simulation, findings);
    if (p.model.implicit.after_run && findings.errors() == 0)
      check_modes_after(directory, arguments.deck, p, simulation, findings);
    if (findings.errors() == 0) try_first_cycles(p.model, simulation, findings);
    if (findings.errors() == 0 && arguments.ranks > 0) ranks = report_partition(directory, simulation, arguments.ranks);
  }
  const std::string refused = findings.errors() > 0 ? report_refused_welds(p, findings) : std::string();
  start_log(log, arguments.deck, p, findings);
  output::write_findings(directory, findings.all());
  print_findings(findings);
  if (findings.errors() > 0 && p.welds.empty()) return ExitCode::refused;
  constexpr std::size_t most_on_terminal = 10;
  std::string audit = refused + audit_table(p.model, p.ties, p.audit);
  if (arguments.target_step > 0.0) {
    add_target(p, arguments.target_step);
    audit += target_table(p.model, p.ties, p.audit, arguments.target_step);
  }
  audit += add_holds(p);
  if (p.model.control.weld_tie == model::WeldTie::joint) {
    const std::vector<std::optional<weld::Joint>> joints = weld::joints_of(p.model, p.ties);
    add_joints(p, joints);
    audit += add_place_errors(p, joints);
  }
  audit += ranks;
  audit += weld_table(p.model, p.ties, p.audit);
  audit +=
      fmt::format("\nSeconds: read {:.2f}, tie {:.2f}, audit {:.2f}\n", p.read_seconds, p.tie_seconds, p.audit_seconds);
  log.add(log_model(p.model) + log_ties(p.model, p.ties, no_limit) + log_tied_nodes(p.model, p.ties) + audit);
  output::write_welds(directory, p.welds);
  output::write_column_units(directory, model::units_of(p.model));
  fmt::print("{}{}{}", log_model(p.model), log_ties(p.model, p.ties, most_on_terminal), audit);
  return findings.errors() > 0 ? ExitCode::refused : ExitCode::normal;
}

}  // namespace

ExitCode check(const CheckArguments& arguments) {
  if (has_cases(arguments.deck))
    return each_case(arguments.deck, [&](const RunArguments& one) {
      return check({one, arguments.ranks, arguments.target_step});
    });
  // A check must not take the place of results: those of a run in the same folder stay whole (decision 0015).
  const fs::path asked = arguments.deck.directory;
  std::error_code error;
  const bool holds_a_run = fs::exists(asked / "summary.json", error);
  const fs::path directory = holds_a_run ? asked / "check" : asked;
  const ExitCode code =
      guarded(directory.string(), [&](const fs::path& folder) { return check_in(folder, arguments); });
  if (holds_a_run)
    fmt::print(stderr, "{} holds the results of a run and was left as it is; this check is in {}\n", asked.string(),
               directory.string());
  return code;
}

}  // namespace nugget::app
