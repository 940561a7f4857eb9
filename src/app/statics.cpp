// SPDX-License-Identifier: Apache-2.0
#include "app/statics.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "app/linear_checks.hpp"
#include "app/linear_job.hpp"
#include "model/units.hpp"
#include "nvh/statics/static_files.hpp"
#include "nvh/statics/static_loads.hpp"
#include "output/history.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

/// Adds to the welds' reports what they carry; of those whose force is not known, that it is not.
void fill_weld_forces(const nvh::Statics& statics, std::vector<output::WeldReport>& welds) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < welds.size(); ++i) {
    if (!statics.weld[i]) {
      welds[i].peak = {unknown, unknown, unknown, unknown, unknown};
      welds[i].peak_failure = welds[i].peak_failure_time = welds[i].energy = unknown;
      welds[i].last = {unknown, unknown, unknown, unknown, unknown, unknown, {}, {unknown, unknown}};
      continue;
    }
    const weld::Resultants& r = statics.weld[i]->resultants;
    const auto at_end = [&](double half) {
      return std::hypot(r.moment_s + half * r.shear_t, r.moment_t - half * r.shear_s);
    };
    const double half = 0.5 * welds[i].length;
    welds[i].peak = {std::abs(r.axial), r.shear(), r.moment(), std::abs(r.torsion), r.force()};
    welds[i].peak_failure = statics.weld[i]->failure;
    welds[i].last = {
        r.axial, r.shear(), r.moment(), r.torsion, 0.0, statics.weld[i]->failure, {}, {at_end(-half), at_end(half)}};
  }
}

/// Largest displacement, sums of support forces, balance.
std::string result_table(const nvh::Matrices& m, const nvh::Statics& s) {
  std::size_t most = 0;
  Vec3d largest{};
  for (std::size_t n = 0; n < m.system.model.nodes.size(); ++n) {
    const nvh::SixDof& u = s.motion[m.system.node_of[n]];
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
  const auto units = model::units_of(m.system.model);
  const std::string length = model::unit_of(units, dimension::length), force = model::unit_of(units, dimension::force),
                    energy = model::unit_of(units, dimension::energy);
  std::string text = "Linear statics at the end time\n\n";
  if (m.system.model.nodes.size() > 0)
    text += fmt::format(" largest displacement   {:14.6g}{} at node {}  ({:.6g} {:.6g} {:.6g})\n", norm(largest),
                        length, m.system.model.nodes.id[most], largest.x, largest.y, largest.z);
  text += fmt::format(" forces of supports     {:14.6g} {:14.6g} {:14.6g}{}\n", held.x, held.y, held.z, force);
  text += fmt::format(" of prescribed motions  {:14.6g} {:14.6g} {:14.6g}{}\n", driven.x, driven.y, driven.z, force);
  text += fmt::format(" strain energy          {:14.6g}{}, half the external work {:.6g}{}\n", s.energy, energy,
                      s.external, energy);
  return text +
         fmt::format(" out of balance         {:14.3g} of the largest force\n\n {} equations, factored in {:.2f} s\n\n",
                     s.residual, m.size(), s.cost.seconds);
}

}  // namespace

ExitCode statics_of(const fs::path& directory, const RunArguments& arguments, PreparedDeck prepared,
                    Findings& findings) {
  nvh::check_statics(prepared.model, findings);
  LinearJob job(directory, arguments, std::move(prepared), findings);
  check_linear(job, {.analysis = Analysis::statics}, findings);
  return job.attempt([&] {
    std::optional<nvh::Statics> statics;
    if (job.assembled() && findings.errors() == 0) {
      Findings again;  // what check_linear has found
      statics.emplace(nvh::solve_statics(job.matrices(), again));
    }
    const double solve = job.seconds();
    if (!job.accepted()) return ExitCode::refused;

    nvh::write_statics(directory, job.header(), job.matrices(), *statics);
    fill_weld_forces(*statics, job.deck().welds);
    output::Summary& summary = job.summary();
    summary.time = job.deck().model.control.end_time;
    summary.energy.internal = statics->energy;
    summary.energy.external = statics->external;
    summary.seconds.solve = solve;
    summary.seconds.output = job.seconds();
    job.write_summary();
    const std::string table = result_table(job.matrices(), *statics);
    job.add_to_log(table);
    fmt::print("{}", table);
    return job.end({impact::Termination::normal, {}});
  });
}

}  // namespace nugget::app
