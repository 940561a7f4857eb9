// SPDX-License-Identifier: Apache-2.0
#include "app/statics.hpp"

#include <fmt/format.h>

#include <optional>

#include "app/clock.hpp"
#include "app/outcome.hpp"
#include "app/run_log.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"
#include "nvh/linear_model.hpp"
#include "nvh/static_files.hpp"
#include "output/results.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

/// Adds to the welds' reports what they carry.
void tell_forces(const nvh::Statics& statics, std::vector<output::WeldReport>& welds) {
  for (std::size_t i = 0; i < welds.size(); ++i) {
    if (!statics.weld[i]) continue;
    const weld::Resultants& r = statics.weld[i]->resultants;
    welds[i].peak = {std::abs(r.axial), r.shear(), r.moment(), std::abs(r.torsion)};
    welds[i].peak_failure = statics.weld[i]->failure;
    welds[i].last = {r.axial, r.shear(), r.moment(), r.torsion, 0.0, statics.weld[i]->failure, {}};
  }
}

/// Largest displacement, sums of support forces, balance.
std::string result_table(const nvh::Matrices& m, const nvh::Statics& s) {
  std::size_t most = 0;
  Vec3d largest{};
  for (std::size_t n = 0; n < m.system.model.nodes.size(); ++n) {
    const nvh::Six& u = s.motion[at(m.system.node_of[n])];
    const Vec3d d{u[0], u[1], u[2]};
    if (norm(d) <= norm(largest)) continue;
    largest = d;
    most = n;
  }
  Vec3d held{}, driven{};
  const std::vector<nvh::Equations::Support>& supports = m.equations.supports();
  for (std::size_t i = 0; i < supports.size(); ++i) {
    if (supports[i].rotation) continue;
    const bool motion = supports[i].source == nvh::Equations::Support::Source::motion;
    (motion ? driven : held) += s.support_force[i] * supports[i].taken;
  }
  std::string text = "Linear statics at the end time\n\n";
  if (m.system.model.nodes.size() > 0)
    text += fmt::format(" largest displacement   {:14.6g} at node {}  ({:.6g} {:.6g} {:.6g})\n", norm(largest),
                        m.system.model.nodes.id[most], largest.x, largest.y, largest.z);
  text += fmt::format(" forces of supports     {:14.6g} {:14.6g} {:14.6g}\n", held.x, held.y, held.z);
  text += fmt::format(" of prescribed motions  {:14.6g} {:14.6g} {:14.6g}\n", driven.x, driven.y, driven.z);
  text += fmt::format(" strain energy          {:14.6g}, half the external work {:.6g}\n", s.energy, s.external);
  return text +
         fmt::format(" out of balance         {:14.3g} of the largest force\n\n {} equations, factored in {:.2f} s\n\n",
                     s.residual, m.size(), s.cost.seconds);
}

}  // namespace

ExitCode statics_of(const fs::path& directory, const RunArguments& arguments, Prepared p, Findings& findings) {
  Log log(directory / "run.log");
  Clock clock;
  std::optional<model::Model> linear;
  std::optional<system::System> system;
  std::optional<nvh::Matrices> matrices;
  nvh::check_statics(p.model, findings);
  const weld::Ties ties = nvh::linear_ties(p.ties, findings);
  if (findings.errors() == 0) linear.emplace(nvh::linear_model(p.model, findings));
  if (findings.errors() == 0) system.emplace(*linear, ties, findings);
  if (findings.errors() == 0) matrices.emplace(*system, findings);
  const double setup = p.tie_seconds + clock.seconds();
  try {
    std::optional<nvh::Statics> statics;
    if (findings.errors() == 0) statics.emplace(nvh::solve_statics(*matrices, findings));
    const double solve = clock.seconds();
    start_log(log, arguments, p, findings);
    if (findings.errors() > 0) return refuse(directory, log, findings);
    print_findings(findings);
    output::write_findings(directory, findings.all());
    log.add(log_model(p.model));
    log.add(log_ties(p.model, p.ties, all_of_them) + log_tied_nodes(p.model, p.ties));

    nvh::write_statics(directory, {p.model.title, fmt::format("nugget {}", NUGGET_VERSION), today()}, *matrices,
                       *statics);
    tell_forces(*statics, p.welds);
    output::write_welds(directory, p.welds);
    output::Summary summary;
    summary.version = NUGGET_VERSION;
    summary.deck = arguments.deck;
    summary.count = counts(p.model, p.ties);
    summary.time = p.model.control.end_time;
    summary.energy.internal = statics->energy;
    summary.energy.external = statics->external;
    summary.seconds.read = p.read_seconds;
    summary.seconds.setup = setup;
    summary.seconds.solve = solve;
    summary.seconds.output = clock.seconds();
    summary.threads = threads();
    summary.welds = p.welds;
    output::write_summary(directory, summary);
    const std::string table = result_table(*matrices, *statics);
    log.add(table);
    fmt::print("{}", table);
    const std::string end = log_termination({impact::Termination::normal, {}});
    log.add(end);
    fmt::print("{}", end);
    return ExitCode::normal;
  } catch (const nvh::Factorization::SolverError& error) {
    start_log(log, arguments, p, findings);
    print_findings(findings);
    output::write_findings(directory, findings.all());
    log.add(log_termination({impact::Termination::error, error.text}));
    fmt::print(stderr, "{}\n", error.text);
    fmt::print("{}", log_termination({impact::Termination::error, {}}));
    return ExitCode::error_termination;
  }
}

}  // namespace nugget::app
