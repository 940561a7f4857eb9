// SPDX-License-Identifier: Apache-2.0
#include "app/modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/clock.hpp"
#include "app/frf.hpp"
#include "app/mode_pairs.hpp"
#include "app/outcome.hpp"
#include "app/preload.hpp"
#include "app/run_log.hpp"
#include "app/status.hpp"
#include "app/weld_study.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"
#include "nvh/linear_model.hpp"
#include "nvh/mode_files.hpp"
#include "output/results.hpp"
#include "report/page.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

nvh::ModeRequest request_of(const ModesArguments& arguments, const model::Model& model) {
  const model::Implicit& deck = model.implicit;
  nvh::ModeRequest r;
  if (arguments.response && deck.modes == 0) {
    const auto reach = [&](const model::FrequencyResponse::Selection& selection, const std::vector<double>& frequency) {
      return selection.highest > 0.0 ? selection.highest : 1.5 * frequency.back();
    };
    r.high = 0.0;
    if (const auto& frf = model.frequency_response; frf && !frf->direct) r.high = reach(frf->modes, frf->frequency);
    if (const auto& ssd = model.steady_state; ssd && !ssd->direct)
      r.high = std::max(r.high, reach(ssd->modes, ssd->frequency));
    return r;
  }
  const bool interval = arguments.low > 0.0 || arguments.high > 0.0;
  if (interval) {
    if (arguments.low > 0.0) r.low = arguments.low;
    if (arguments.high > 0.0) r.high = arguments.high;
  } else if (arguments.count == 0) {
    if (deck.low) r.low = *deck.low;
    if (deck.high) r.high = *deck.high;
    r.centre = deck.centre;
  }
  constexpr int usual = 20;
  const bool all = interval && std::isfinite(r.high);
  r.count = arguments.count > 0 ? arguments.count : all ? 0 : deck.modes != 0 ? std::abs(deck.modes) : usual;
  return r;
}

std::string mode_table(const nvh::Modes& modes) {
  std::string s = fmt::format("Modes: {}\n\n {:>6} {:>14} {:>14}   effective mass as a share: {:>7} {:>7} {:>7}\n",
                              modes.eigenvalue.size(), "mode", "frequency", "omega^2", "x", "y", "z");
  for (std::size_t i = 0; i < modes.eigenvalue.size(); ++i) {
    s += fmt::format(" {:>6} {:>14.6g} {:>14.6g}   {:>26}", i + 1, modes.frequency(i), modes.eigenvalue[i], "");
    for (std::size_t k = 0; k < 3; ++k) {
      const double p = modes.participation[i][k];
      s += fmt::format(" {:>7.4f}", modes.total[k] > 0.0 ? p * p / modes.total[k] : 0.0);
    }
    s += '\n';
  }
  const nvh::Modes::Proof& proof = modes.proof;
  return s + fmt::format("\n Sylvester's count: {} eigenvalues {} {:.6g}; found {}: {}\n\n", proof.counted,
                         proof.low > 0.0 ? fmt::format("between {:.6g} and", proof.low) : "below", proof.high,
                         proof.found, proof.complete() ? "no mode was missed" : "MODES ARE MISSING");
}

/// The parts and welds that hold most of each mode's strain energy.
std::string energy_table(const model::Model& model, const weld::Ties& ties, const nvh::Modes& modes,
                         const nvh::EnergyShares& shares) {
  std::string s = "Strain energy, shares in percent (all of them in mode_energy.csv)\n\n";
  const auto largest = [](std::span<const double> share, std::size_t most) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < share.size(); ++i)
      if (share[i] >= 0.0005) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return share[a] > share[b]; });
    order.resize(std::min(order.size(), most));
    return order;
  };
  for (std::size_t i = 0; i < modes.eigenvalue.size(); ++i) {
    s += fmt::format(" mode {:>4}  parts", i + 1);
    for (const std::size_t p : largest(shares.part[i], 4))
      s += fmt::format("  {}: {:.1f}", model.parts[p].id, 100.0 * shares.part[i][p]);
    const std::vector<std::size_t> welds = largest(shares.weld[i], 5);
    if (!welds.empty()) s += "   welds";
    for (const std::size_t w : welds) s += fmt::format("  {}: {:.2f}", ties.welds[w].id, 100.0 * shares.weld[i][w]);
    s += '\n';
  }
  return s + '\n';
}

std::string cost_table(const nvh::Matrices& m, const nvh::Modes& modes, const output::Summary& summary) {
  return fmt::format(
      "Cost\n\n {} equations, {:.4g} million entries in K, {:.4g} million in its factor\n {} factorizations {:.2f} s, "
      "{} solutions in Lanczos {:.2f} s; setup {:.2f} s, output {:.2f} s\n\n",
      m.size(), 1e-6 * static_cast<double>(m.stiffness.entries()), 1e-6 * modes.cost.factor_entries,
      modes.cost.factorizations, modes.cost.factor_seconds, modes.cost.solves, modes.cost.lanczos_seconds,
      summary.seconds.setup, summary.seconds.output);
}

output::Summary summarise(const ModesArguments& arguments, const Prepared& p, const nvh::Modes& modes) {
  output::Summary s;
  s.version = NUGGET_VERSION;
  s.deck = arguments.run.deck;
  s.count = counts(p.model, p.ties);
  s.mass.physical = modes.total[0];
  s.seconds.read = p.read_seconds;
  s.threads = threads();
  s.welds = p.welds;
  for (std::size_t i = 0; i < modes.eigenvalue.size(); ++i) {
    output::ModeReport r;
    r.mode = static_cast<int>(i) + 1;
    r.frequency_hz = modes.frequency(i);
    r.participation = modes.participation[i];
    for (std::size_t k = 0; k < 6; ++k) r.effective_mass[k] = r.participation[k] * r.participation[k];
    s.modes.push_back(r);
  }
  return s;
}

}  // namespace

ExitCode modes_of(const fs::path& directory, const ModesArguments& arguments, Prepared p, Findings& findings,
                  const std::optional<nvh::ShapeFile>& other) {
  Log log(directory / "run.log");
  Clock clock;
  std::optional<model::Model> linear;
  const weld::Ties ties = nvh::linear_ties(p.ties, findings);
  std::optional<system::System> system;
  std::optional<nvh::Matrices> matrices;
  if (findings.errors() == 0) linear.emplace(nvh::linear_model(p.model, findings));
  if (findings.errors() == 0) system.emplace(*linear, ties, findings);
  if (findings.errors() == 0) matrices.emplace(*system, findings);
  if (matrices) nvh::tell_held_motions(matrices->equations, p.model, findings);
  if (matrices && arguments.response) check_responses(*matrices, p.model, findings);
  check_preload(p.model, findings);
  start_log(log, arguments.run, p, findings);
  if (findings.errors() > 0) return refuse(directory, log, findings);
  print_findings(findings);
  output::write_findings(directory, findings.all());
  log.add(log_model(p.model));
  log.add(log_ties(p.model, p.ties, all_of_them) + log_tied_nodes(p.model, p.ties));
  const double setup = p.tie_seconds + clock.seconds();
  const nvh::ModeRequest request = request_of(arguments, p.model);
  std::optional<DropRequest> drop;
  if (!arguments.drop.empty()) {
    std::string complaint;
    if (p.model.implicit.geometric)
      complaint = "it is not built for preloaded structures: write IGS 2 in *CONTROL_IMPLICIT_GENERAL";
    else if (request.low > 0.0 || request.centre > 0.0)
      complaint = "it needs the lowest modes: leave out --fmin (LFLAG, CENTER in the deck)";
    else
      drop = drop_request(arguments.drop, *system, complaint);
    if (!drop) {
      fmt::print(stderr, "nugget: --drop-weld {}: {}\n", arguments.drop, complaint);
      log.add(log_termination({impact::Termination::error, complaint}));
      return ExitCode::wrong_command;
    }
  }

  try {
    Status status(arguments.run.quiet);
    const std::string preload = stiffen_by_preload(*matrices);
    const nvh::Modes modes = nvh::find_modes(*matrices, request, std::ref(status));
    const double solve = clock.seconds();
    status("strain energies and files");
    const nvh::EnergyShares shares = nvh::energy_shares(*matrices, modes);
    output::Summary summary = summarise(arguments, p, modes);
    summary.seconds.setup = setup;
    summary.seconds.solve = solve;
    const output::Header header{p.model.title, fmt::format("nugget {}", NUGGET_VERSION), today()};
    nvh::write_modes(directory, header, *matrices, modes, shares);
    std::string response;  // and what else is told after the modes
    if (arguments.response) {
      status("frequency response");
      response = responses_of(directory, header, *matrices, modes, p.model, summary, std::ref(status));
    }
    if (drop) response += weld_study(directory, *matrices, modes, *drop, summary, std::ref(status));
    if (other) {
      const nvh::ModeComparison comparison = nvh::compare(*matrices, modes, *other);
      nvh::write_mac(directory, modes, comparison);
      response += pair_table(modes, comparison, arguments.compare);
    }
    output::write_welds(directory, p.welds);
    summary.seconds.output = clock.seconds();
    if (!modes.proof.complete()) {
      summary.termination = "error";
      summary.message = fmt::format("{} modes were counted but {} found", modes.proof.counted, modes.proof.found);
    }
    output::write_summary(directory, summary);
    report::write_report(directory);
    const std::string table = mode_table(modes);
    log.add(preload + table + energy_table(p.model, p.ties, modes, shares) + response +
            cost_table(*matrices, modes, summary));
    status.clear();
    fmt::print("{}{}", table, response);
    const impact::Termination end = modes.proof.complete() ? impact::Termination::normal : impact::Termination::error;
    log.add(log_termination({end, summary.message}));
    if (!summary.message.empty()) fmt::print(stderr, "{}\n", summary.message);
    if (!arguments.run.quiet)
      fmt::print(stderr, "{} modes of {} equations in {:.2f} s; results in {}\n", modes.eigenvalue.size(),
                 matrices->size(), solve, directory.string());
    fmt::print("{}", log_termination({end, {}}));
    return end == impact::Termination::normal ? ExitCode::normal : ExitCode::error_termination;
  } catch (const nvh::Factorization::SolverError& error) {
    const impact::Outcome outcome{impact::Termination::error, error.text};
    log.add(log_termination(outcome));
    fmt::print(stderr, "{}\n", error.text);
    fmt::print("{}", log_termination({outcome.termination, {}}));
    return ExitCode::error_termination;
  }
}

ExitCode modes(const ModesArguments& arguments) {
  return guarded(arguments.run.directory, [&](const fs::path& directory) {
    use_threads(arguments.run.threads);
    Findings findings;
    Prepared p = prepare(arguments.run, findings);
    if (!p.has_text) return refuse_missing(findings);
    std::optional<nvh::ShapeFile> other;
    try {  // before old results go: it may be this very folder
      if (!arguments.compare.empty()) other.emplace(arguments.compare);
    } catch (const nvh::ShapeFile::ReadError& error) {
      fmt::print(stderr, "nugget: --compare {}: {}\n", arguments.compare, error.what());
      return ExitCode::wrong_command;
    }
    output::remove_old_results(directory);
    return modes_of(directory, arguments, std::move(p), findings, other);
  });
}

}  // namespace nugget::app
