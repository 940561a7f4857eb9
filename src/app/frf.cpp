// SPDX-License-Identifier: Apache-2.0
#include "app/frf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/command.hpp"
#include "app/linear_checks.hpp"
#include "app/linear_job.hpp"
#include "app/modes.hpp"
#include "app/preload.hpp"
#include "app/status.hpp"
#include "model/units.hpp"
#include "nvh/response/radiated_power.hpp"
#include "nvh/response/response_states.hpp"
#include "output/column_units.hpp"
#include "output/results.hpp"
#include "report/page.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;
using Complex = std::complex<double>;

/// A curve as the tables want it.
struct Response {
  const char* kind;  ///< frf, ssd
  int load_case, node;
  std::string direction, quantity;
  const std::vector<Complex>& value;
};

/// How the responses of a keyword were computed.
std::string describe_method(const nvh::Modes& modes, const nvh::SolutionMethod& method, const std::string& unit) {
  if (method.direct) return " direct solution at each frequency\n";
  std::string s = " no mode takes part, only the static response";
  if (method.last > method.first)
    s = fmt::format(" modes {} to {}, up to {:.6g}{}", method.first + 1, method.last, modes.frequency(method.last - 1),
                    unit);
  if (!method.residual.empty())
    s += fmt::format(", and {} residual vector{} from {:.6g}{} on for all above", method.residual.size(),
                     method.residual.size() == 1 ? "" : "s", method.residual.front(), unit);
  return s + '\n';
}

/// Up to which frequency all modes take part: from there on there is only the residual vector.
double reach_of(const nvh::Modes& modes, const model::FrequencyResponse::Selection& selection) {
  const nvh::ModeRange range = nvh::modes_that_take_part(modes, selection);
  const double last = range.last > range.first ? modes.frequency(range.last - 1) : 0.0;
  if (selection.last > 0 && range.last < modes.eigenvalue.size()) return last;  // cut by MDMAX, or by what is lower
  const double known = modes.proof.complete() ? modes.proof.high : last;
  return std::max(last, selection.highest > 0.0 ? std::min(known, selection.highest) : known);
}

void doubt_modes(const nvh::Matrices& matrices, const nvh::Modes& modes,
                 const model::FrequencyResponse::Selection& selection, double highest_asked, const Place& place,
                 const char* keyword, Findings& doubts) {
  const double reach = reach_of(modes, selection);
  const bool all = modes.eigenvalue.size() == matrices.size() && selection.last == 0 && selection.highest == 0.0;
  if (all || reach >= highest_asked) return;
  const std::string unit = model::unit_of_frequency(model::units_of(matrices.system.model));
  doubts.warning(place, keyword,
                 fmt::format("the response is asked for up to {:.6g}{}, and modes take part up to {:.6g}{}: it is "
                             "doubtful above",
                             highest_asked, unit, reach, unit),
                 "raise NEIG of *CONTROL_IMPLICIT_EIGENVALUE, FNMAX or MDMAX, or solve directly (nugget frf --direct)");
}

/// The highest frequency of all that is asked for.
double highest_of(const model::SteadyState& request) {
  double most = 0.0;
  const auto take = [&](const model::Frequencies& f) {
    if (!f.frequency.empty()) most = std::max(most, f.frequency.back());
  };
  take(request);
  if (request.states) take(*request.states);
  if (request.radiated_power) take(request.frequencies_of_power());
  return most;
}

/// Where a response is largest; infinite ones (of free bodies at frequency 0) do not count.
std::size_t largest(const std::vector<Complex>& value) {
  std::size_t best = 0;
  double most = -1.0;
  for (std::size_t k = 0; k < value.size(); ++k)
    if (const double v = std::abs(value[k]); std::isfinite(v) && v > most) {
      most = v;
      best = k;
    }
  return best;
}

/// Of each response its largest amplitude, for run.log and for the summary.
std::string peaks(const std::vector<Response>& responses, const std::vector<double>& frequency, const char* file,
                  output::Summary& summary) {
  constexpr std::size_t most = 40;
  const auto units = model::units_named(summary.units);
  const bool cases = !responses.empty() && responses.back().load_case > 0;
  std::string s =
      fmt::format("\n{} {:>10} {:>10} {:<30} {:>14} {:>14} {:>15}   {}\n", cases ? fmt::format(" {:>5}", "case") : "",
                  "node", "direction", "response", "frequency" + model::in_frequency(units), "amplitude",
                  "phase [degree]", "at the largest amplitude");
  for (std::size_t c = 0; c < responses.size(); ++c) {
    const Response& r = responses[c];
    const std::size_t k = largest(r.value);
    const double amplitude = std::abs(r.value[k]), phase = nvh::degrees(r.value[k]);
    summary.responses.push_back({r.kind, r.node, r.direction, r.quantity, frequency[k], amplitude, phase, r.load_case});
    if (c < most)
      s += fmt::format("{} {:>10} {:>10} {:<30} {:>14.6g} {:>14.6g} {:>15.2f}\n",
                       cases ? fmt::format(" {:>5}", r.load_case) : "", r.node, r.direction,
                       r.quantity + model::in_units(units, output::dimension_of_response(r.quantity)), frequency[k],
                       amplitude, phase);
  }
  if (responses.size() > most) s += fmt::format(" ... and {} more in {}\n", responses.size() - most, file);
  return s + '\n';
}

/// `16 frequencies from 0 to 300 Hz`.
std::string spelled(const std::vector<double>& frequency, const output::Summary& summary) {
  const std::string unit = model::unit_of_frequency(model::units_named(summary.units));
  if (frequency.size() == 1) return fmt::format("at {:.6g}{}", frequency.front(), unit);
  return fmt::format("{} frequencies from {:.6g} to {:.6g}{}", frequency.size(), frequency.front(), frequency.back(),
                     unit);
}

std::string title(const char* what, std::size_t count, const std::vector<double>& frequency,
                  const output::Summary& summary) {
  return fmt::format("{}: {} response{}, {}\n\n", what, count, count == 1 ? "" : "s", spelled(frequency, summary));
}

std::string frf_of(const fs::path& directory, const output::Header& header, const nvh::Matrices& matrices,
                   const nvh::Modes& modes, const model::FrequencyResponse& request, output::Summary& summary,
                   const nvh::ProgressCallback& progress) {
  const nvh::FrfResult result = nvh::frequency_response(matrices, modes, request, progress);
  nvh::write_frf(directory, header, request, result);
  std::vector<Response> responses;
  for (const nvh::FrfCurve& c : result.curve)
    responses.push_back({"frf", c.load_case, c.node, nvh::direction_name(c.direction),
                         nvh::to_string(c.quantity, c.rotation), c.value});
  std::string titles;
  if (request.cases.size() > 1)
    for (std::size_t i = 0; i < request.cases.size(); ++i)
      titles += fmt::format(" case {}: {}\n", i + 1, request.cases[i].title);
  return title("Frequency response", responses.size(), result.frequency, summary) + titles +
         describe_method(modes, result.method, model::unit_of_frequency(model::units_named(summary.units))) +
         peaks(responses, result.frequency, "frf.csv", summary);
}

std::string ssd_of(const fs::path& directory, const output::Header& header, const nvh::Matrices& matrices,
                   const nvh::Modes& modes, const model::SteadyState& request, output::Summary& summary,
                   const nvh::ProgressCallback& progress) {
  const nvh::SteadyResult result = nvh::steady_state(matrices, modes, request, progress);
  nvh::write_steady_state(directory, header, request, result);
  std::vector<Response> responses;
  for (const nvh::SteadyCurve& c : result.curve)
    for (std::size_t q = 0; q < nvh::steady_quantities.size(); ++q)
      responses.push_back({"ssd", c.load_case, c.node, nvh::direction_name(c.direction),
                           nvh::to_string(nvh::steady_quantities[q]), c.value[q]});
  std::string titles;
  for (std::size_t i = 0; i < request.cases.size(); ++i)
    if (const auto& c = request.cases[i]; !c.id.empty())
      titles += fmt::format(" case {}: {} {}\n", i + 1, c.id, c.title);
  return title("Steady state", responses.size(), result.frequency, summary) + titles +
         describe_method(modes, result.method, model::unit_of_frequency(model::units_named(summary.units))) +
         peaks(responses, result.frequency, "ssd.csv", summary);
}

std::string power_of(const fs::path& directory, const output::Header& header, const nvh::Matrices& matrices,
                     const nvh::Modes& modes, const model::SteadyState& request, output::Summary& summary,
                     const nvh::ProgressCallback& progress) {
  const nvh::RadiatedPower result = nvh::radiated_power(matrices, modes, request, progress);
  nvh::write_radiated_power(directory, header, request, result);
  const double reference = request.radiated_power->reference;
  const auto units = model::units_named(summary.units);
  std::string s = fmt::format(
      "Equivalent radiated power: {} panels, {}\n\n {:<24} {:>14} {:>14} "
      "{:>14} {:>10}   at the largest power\n",
      request.radiated_power->panels.size(), spelled(result.frequency, summary), "panel",
      "area" + model::in_units(units, dimension::area), "frequency" + model::in_frequency(units),
      "power" + model::in_units(units, output::dimension_of_response("radiated power")), "dB");
  for (const nvh::RadiatedPower::Panel& panel : result.panels) {
    const std::vector<Complex> value(panel.power.begin(), panel.power.end());
    const std::size_t k = largest(value);
    const double power = panel.power[k];
    summary.responses.push_back({"erp", 0, panel.name, "radiated power", result.frequency[k], power, 0.0, 0});
    s += fmt::format(" {:<24} {:>14.6g} {:>14.6g} {:>14.6g} {:>10}\n", panel.name, panel.area, result.frequency[k],
                     power,
                     reference > 0.0 && power > 0.0 ? fmt::format("{:.2f}", nvh::decibels(power, reference)) : "");
  }
  return s + '\n';
}

}  // namespace

std::string responses_of(const fs::path& directory, const output::Header& header, const nvh::Matrices& matrices,
                         const nvh::Modes& modes, const model::Model& model, output::Summary& summary, Findings& doubts,
                         const nvh::ProgressCallback& progress) {
  if (const auto& frf = model.frequency_response; frf && !frf->direct)
    doubt_modes(matrices, modes, frf->modes, frf->frequency.back(), frf->cases.front().excitation.place,
                "*FREQUENCY_DOMAIN_FRF", doubts);
  if (const auto& ssd = model.steady_state; ssd && !ssd->direct)
    doubt_modes(matrices, modes, ssd->modes, highest_of(*ssd), ssd->cases.front().loads.front().excitation.place,
                "*FREQUENCY_DOMAIN_SSD", doubts);
  std::string text;
  if (model.frequency_response)
    text += frf_of(directory, header, matrices, modes, *model.frequency_response, summary, progress);
  if (!model.steady_state) return text;
  if (!model.steady_state->frequency.empty() && !model.requests.history_nodes.empty())
    text += ssd_of(directory, header, matrices, modes, *model.steady_state, summary, progress);
  if (model.steady_state->states)
    text += fmt::format("d3ssd: the motion of all nodes at {} frequencies\n\n",
                        nvh::write_d3ssd(directory, matrices, modes, *model.steady_state, progress));
  if (model.steady_state->radiated_power)
    text += power_of(directory, header, matrices, modes, *model.steady_state, summary, progress);
  return text;
}

void check_responses(const nvh::Matrices& matrices, const model::Model& model, Findings& findings) {
  if (model.frequency_response) nvh::check_frequency_response(matrices, *model.frequency_response, findings);
  if (model.steady_state) nvh::check_steady_state(matrices, *model.steady_state, findings);
}

bool all_direct(const model::Model& model) {
  return (model.frequency_response || model.steady_state) &&
         (!model.frequency_response || model.frequency_response->direct) &&
         (!model.steady_state || model.steady_state->direct);
}

Analysis analysis_of(const model::Model& model) {
  if (!model.implicit.active) return Analysis::explicit_dynamics;
  if (model.implicit.modes != 0) return Analysis::modes_and_responses;
  if (all_direct(model)) return Analysis::direct_response;
  return model.frequency_response || model.steady_state ? Analysis::modes_and_responses : Analysis::statics;
}

ExitCode direct_responses(const fs::path& directory, const RunArguments& arguments, PreparedDeck prepared,
                          Findings& findings) {
  LinearJob job(directory, arguments, std::move(prepared), findings);
  const model::Model& model = job.deck().model;
  check_linear(job, {.analysis = Analysis::direct_response}, findings);
  if (!job.accepted()) return ExitCode::refused;
  return job.attempt([&] {
    Status status(arguments.quiet);
    output::Summary& summary = job.summary();
    const std::string preload = stiffen_by_preload(job.matrices());
    Findings doubts;
    const std::string text =
        responses_of(directory, job.header(), job.matrices(), {}, model, summary, doubts, std::ref(status));
    job.report_more(doubts);
    summary.seconds.solve = job.seconds();
    job.write_summary();
    report::write_report(directory);
    status.clear();
    job.add_to_log(preload + text);
    fmt::print("{}", text);
    return job.end({impact::Termination::normal, {}},
                   fmt::format("{} equations in {:.2f} s", job.matrices().size(), summary.seconds.solve));
  });
}

ExitCode frf(const RunArguments& arguments, bool direct) {
  return guarded(arguments.directory, [&](const fs::path& directory) {
    use_threads(arguments.threads);
    Findings findings;
    PreparedDeck p = prepare(arguments, findings, EndTime::not_needed);
    if (!p.has_text) return refuse_missing(findings);
    if (findings.errors() == 0 && !p.model.frequency_response && !p.model.steady_state)
      findings.error({p.model.deck, 0, 0}, "*FREQUENCY_DOMAIN_FRF", "the deck asks for no frequency response",
                     "give this keyword or *FREQUENCY_DOMAIN_SSD, or use `nugget modes`");
    if (direct && p.model.frequency_response) p.model.frequency_response->direct = true;
    if (direct && p.model.steady_state) p.model.steady_state->direct = true;
    output::remove_old_results(directory);
    if (all_direct(p.model)) return direct_responses(directory, arguments, std::move(p), findings);
    ModesArguments modes;
    modes.run = arguments;
    modes.response = true;
    return modes_of(directory, modes, std::move(p), findings);
  });
}

}  // namespace nugget::app
