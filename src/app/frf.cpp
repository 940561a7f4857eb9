// SPDX-License-Identifier: Apache-2.0
#include "app/frf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/command.hpp"
#include "app/modes.hpp"
#include "nvh/frequency_response.hpp"
#include "output/results.hpp"

namespace nugget::app {
namespace {

std::string modes_used(const nvh::Modes& modes, const nvh::FrfResult& result, double highest_asked) {
  if (result.last == result.first) return " no mode takes part, only the static response\n";
  const double highest = modes.frequency(result.last - 1);
  std::string s = fmt::format(" modes {} to {}, up to {:.6g}", result.first + 1, result.last, highest);
  if (result.residual > 0.0) s += fmt::format(", and a residual vector at {:.6g} for all above", result.residual);
  s += '\n';
  if (highest < highest_asked)
    s += fmt::format(
        " warning: the response is asked for up to {:.6g}, above the last mode: it is doubtful there; raise NEIG of "
        "*CONTROL_IMPLICIT_EIGENVALUE, FNMAX or MDMAX\n",
        highest_asked);
  return s;
}

/// Of each response its largest amplitude.
std::string peaks(const nvh::FrfResult& result, const model::FrequencyResponse& request) {
  constexpr std::size_t most = 40;
  std::string s = fmt::format("\n {:>10} {:>10} {:>14} {:>14} {:>10}   {}\n", "node", "direction", "frequency",
                              "amplitude", "phase", "at the largest amplitude");
  for (std::size_t c = 0; c < std::min(most, result.curve.size()); ++c) {
    const nvh::FrfCurve& curve = result.curve[c];
    const auto k = static_cast<std::size_t>(
        std::max_element(curve.value.begin(), curve.value.end(),
                         [](const auto& a, const auto& b) { return std::abs(a) < std::abs(b); }) -
        curve.value.begin());
    s += fmt::format(" {:>10} {:>10} {:>14.6g} {:>14.6g} {:>10.2f}\n", curve.node, nvh::direction_name(curve.direction),
                     request.frequency[k], std::abs(curve.value[k]), nvh::degrees(curve.value[k]));
  }
  if (result.curve.size() > most) s += fmt::format(" ... and {} more in frf.csv\n", result.curve.size() - most);
  return s + '\n';
}

}  // namespace

std::string frf_of(const std::filesystem::path& directory, const nvh::Matrices& matrices, const nvh::Modes& modes,
                   const model::FrequencyResponse& request) {
  const nvh::FrfResult result = nvh::frequency_response(matrices, modes, request);
  nvh::write_frf(directory, request, result);
  return fmt::format("Frequency response: {} of {} nodes, {} frequencies from {:.6g} to {:.6g}\n\n",
                     nvh::to_string(request.response.quantity), request.response.nodes.size(), request.frequency.size(),
                     request.frequency.front(), request.frequency.back()) +
         modes_used(modes, result, request.frequency.back()) + peaks(result, request);
}

ExitCode frf(const RunArguments& arguments) {
  return guarded(arguments.directory, [&](const std::filesystem::path& directory) {
    use_threads(arguments.threads);
    Findings findings;
    Prepared p = prepare(arguments, findings);
    if (!p.has_text) return refuse_missing(findings);
    if (findings.errors() == 0 && !p.model.frequency_response)
      findings.error({p.model.deck, 0, 0}, "*FREQUENCY_DOMAIN_FRF", "the deck asks for no frequency response",
                     "give this keyword, or use `nugget modes`");
    output::remove_old_results(directory);
    ModesArguments modes;
    modes.run = arguments;
    modes.response = true;
    return modes_of(directory, modes, std::move(p), findings);
  });
}

}  // namespace nugget::app
