// SPDX-License-Identifier: Apache-2.0
#include "app/modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/frf.hpp"
#include "app/least_welds.hpp"
#include "app/linear_checks.hpp"
#include "app/linear_job.hpp"
#include "app/mode_pairs.hpp"
#include "app/preload.hpp"
#include "app/run_log.hpp"
#include "app/status.hpp"
#include "app/weld_study.hpp"
#include "model/units.hpp"
#include "nvh/eigen/mode_files.hpp"
#include "nvh/matrices/ranks.hpp"
#include "output/results.hpp"
#include "report/page.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

nvh::ModeRequest request_of(const ModesArguments& arguments, const model::Model& model) {
  const model::Implicit& deck = model.implicit;
  nvh::ModeRequest r;
  if (arguments.response && deck.modes == 0) {
    const auto highest_frequency = [&](const model::FrequencyResponse::Selection& selection,
                                       const std::vector<double>& frequency) {
      return selection.highest > 0.0 ? selection.highest : 1.5 * frequency.back();
    };
    r.high = 0.0;
    if (const auto& frf = model.frequency_response; frf && !frf->direct)
      r.high = highest_frequency(frf->modes, frf->frequency);
    if (const auto& ssd = model.steady_state; ssd && !ssd->direct) {
      if (!ssd->frequency.empty()) r.high = std::max(r.high, highest_frequency(ssd->modes, ssd->frequency));
      if (ssd->states) r.high = std::max(r.high, highest_frequency(ssd->modes, ssd->states->frequency));
      if (ssd->radiated_power && !ssd->radiated_power->frequency.empty())
        r.high = std::max(r.high, highest_frequency(ssd->modes, ssd->radiated_power->frequency));
    }
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

/// Why modes are missing: motions without stiffness are all alike, and Lanczos does not separate many of them.
std::string missing_modes(const nvh::Modes& modes) {
  const nvh::Modes::Proof& proof = modes.proof;
  std::string s = fmt::format("{} modes were counted but {} found", proof.counted, proof.found);
  const bool free = !modes.eigenvalue.empty() && modes.frequency(modes.eigenvalue.size() - 1) < 1e-6 * proof.high;
  if (free && proof.counted > 6)
    s += fmt::format(": parts of the structure move without stiffness (a mechanism); hold them, or ask for {} modes",
                     proof.counted + 1);
  return s;
}

std::string mode_table(const nvh::Modes& modes, const std::optional<model::Units>& units) {
  constexpr Dimension eigenvalue{0, 0, -2};
  std::string s = fmt::format("Modes: {}\n\n {:>6} {:>14} {:>14}   effective mass as a share: {:>7} {:>7} {:>7}\n",
                              modes.eigenvalue.size(), "mode", "frequency" + model::in_frequency(units),
                              "omega^2" + model::in_units(units, eigenvalue), "x", "y", "z");
  for (std::size_t i = 0; i < modes.eigenvalue.size(); ++i) {
    s += fmt::format(" {:>6} {:>14.6g} {:>14.6g}   {:>26}", i + 1, modes.frequency(i), modes.eigenvalue[i], "");
    for (std::size_t k = 0; k < 3; ++k) {
      const double p = modes.participation[i][k];
      s += fmt::format(" {:>7.4f}", modes.total[k] > 0.0 ? p * p / modes.total[k] : 0.0);
    }
    s += modes.elastic(i) ? "\n" : "  rigid motion\n";
  }
  const nvh::Modes::Proof& proof = modes.proof;
  return s + fmt::format("\n Sylvester's count: {} eigenvalues {} {:.6g}{}; found {}: {}\n\n", proof.counted,
                         proof.low > 0.0 ? fmt::format("between {:.6g} and", proof.low) : "below", proof.high,
                         model::unit_of_frequency(units), proof.found,
                         proof.complete() ? "no mode was missed" : "MODES ARE MISSING");
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
  const std::string memory =
      nvh::ranks() > 1 ? fmt::format(" memory of the solver: {:.0f} MB on one rank at most, {:.0f} MB on all {}\n",
                                     modes.cost.most_memory, modes.cost.memory, nvh::ranks())
                       : "";
  return fmt::format(
      "Cost\n\n {} equations, {:.4g} million entries in K, {:.4g} million in its factor\n {} factorizations {:.2f} s, "
      "{} solutions in Lanczos {:.2f} s; setup {:.2f} s, output {:.2f} s\n{}\n",
      m.size(), 1e-6 * static_cast<double>(m.stiffness.entries()), 1e-6 * modes.cost.factor_entries,
      modes.cost.factorizations, modes.cost.factor_seconds, modes.cost.solves, modes.cost.lanczos_seconds,
      summary.seconds.setup, summary.seconds.output, memory);
}

void fill_mode_reports(const nvh::Modes& modes, output::Summary& s) {
  s.mass.physical = modes.total[0];
  for (std::size_t i = 0; i < modes.eigenvalue.size(); ++i) {
    output::ModeReport r;
    r.mode = static_cast<int>(i) + 1;
    r.frequency_hz = modes.frequency(i);
    r.participation = modes.participation[i];
    for (std::size_t k = 0; k < 6; ++k) r.effective_mass[k] = r.participation[k] * r.participation[k];
    s.modes.push_back(r);
  }
}

/// The welds that `--drop-weld` names, if any; where it cannot be obeyed, why.
std::optional<DropRequest> drop_of(const ModesArguments& arguments, const nvh::ModeRequest& request,
                                   const system::System& system, std::string& error_text) {
  const std::string& word = arguments.drop;
  if (word.empty() && arguments.least_welds == 0.0) return {};
  if (request.low <= 0.0 && request.centre <= 0.0)
    return word.empty() ? std::optional<DropRequest>() : drop_request(word, system, error_text);
  error_text = "it needs the lowest modes: leave out --fmin (LFLAG, CENTER in the deck)";
  return {};
}

}  // namespace

ExitCode modes_of(const fs::path& directory, const ModesArguments& arguments, PreparedDeck prepared, Findings& findings,
                  const std::optional<nvh::ShapeFile>& other, const impact::Simulation* after) {
  LinearJob job(directory, arguments.run, std::move(prepared), findings, after != nullptr ? &after->system() : nullptr);
  const model::Model& model = job.deck().model;
  check_linear(job, {.analysis = Analysis::modes_and_responses, .responses = arguments.response, .after = after},
               findings);
  if (!job.accepted()) return ExitCode::refused;
  nvh::Matrices& matrices = job.matrices();
  const nvh::ModeRequest request = request_of(arguments, model);
  std::string error_text;
  const std::optional<DropRequest> drop = drop_of(arguments, request, matrices.system, error_text);
  if (!error_text.empty()) {
    fmt::print(stderr, "nugget: {}: {}\n",
               arguments.drop.empty() ? "--least-welds" : fmt::format("--drop-weld {}", arguments.drop), error_text);
    job.add_to_log(log_termination({impact::Termination::error, error_text}));
    return ExitCode::wrong_command;
  }

  return job.attempt([&] {
    Status status(arguments.run.quiet);
    const std::string preload = stiffen_by_preload(matrices, after);
    const nvh::Modes modes = nvh::find_modes(matrices, request, std::ref(status));
    output::Summary& summary = job.summary();
    fill_mode_reports(modes, summary);
    summary.seconds.solve = job.seconds();
    status("strain energies and files");
    const nvh::EnergyShares shares = nvh::energy_shares(matrices, modes);
    nvh::write_modes(directory, job.header(), matrices, modes, shares);
    const std::optional<model::Units> units = model::units_of(model);
    std::string more;  // that is reported after the modes
    if (arguments.response) {
      status("frequency response");
      Findings doubts;
      more = responses_of(directory, job.header(), matrices, modes, model, summary, doubts, std::ref(status));
      job.report_more(doubts);
    }
    if (arguments.least_welds > 0.0)
      more += find_least_welds(directory, matrices, modes, arguments.least_welds, units, std::ref(status));
    if (drop) more += weld_study(directory, matrices, modes, *drop, units, summary, std::ref(status));
    if (other) {
      const nvh::ModeComparison comparison = nvh::compare(matrices, modes, *other);
      nvh::write_mac(directory, modes, comparison);
      more += pair_table(modes, comparison, arguments.compare, units);
    }
    summary.seconds.output = job.seconds();
    impact::Outcome outcome{impact::Termination::normal, {}};
    if (!modes.proof.complete()) {
      outcome = {impact::Termination::error, missing_modes(modes)};
      summary.termination = "error";
      summary.message = outcome.message;
    }
    job.write_summary();
    report::write_report(directory);
    const std::string table = mode_table(modes, units);
    job.add_to_log(preload + table + energy_table(model, job.deck().ties, modes, shares) + more +
                   cost_table(matrices, modes, summary));
    status.clear();
    fmt::print("{}{}", table, more);
    return job.end(outcome, fmt::format("{} modes of {} equations in {:.2f} s", modes.eigenvalue.size(),
                                        matrices.size(), summary.seconds.solve));
  });
}

ExitCode modes(const ModesArguments& arguments) {
  return guarded(arguments.run.directory, [&](const fs::path& directory) {
    if (arguments.high > 0.0 && arguments.low >= arguments.high) {
      fmt::print(stderr, "nugget: -fmin {:g} -fmax {:g}: the interval is empty; give an -fmax above -fmin\n",
                 arguments.low, arguments.high);
      return ExitCode::wrong_command;
    }
    use_threads(arguments.run.threads);
    Findings findings;
    PreparedDeck p = prepare(arguments.run, findings, EndTime::not_needed);
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
