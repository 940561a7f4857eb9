// SPDX-License-Identifier: Apache-2.0
#include "nvh/response/steady_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "nvh/response/frequencies.hpp"
#include "nvh/response/part_damping.hpp"
#include "nvh/response/transfer.hpp"
#include "output/nodout_ssd.hpp"

namespace nugget::nvh {
namespace {

using Complex = std::complex<double>;
using Response = model::FrequencyResponse::Response;

std::vector<ResponsePoint> response_points_of(const Matrices& m) {
  const model::Model& model = m.system.model;
  std::vector<ResponsePoint> points;
  for (const model::NamedEntity& entity : model.requests.history_nodes) {
    Response response;
    response.nodes = {entity.index};
    response.directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (entity.system != model::none) {
      const Frame3d& own = model.systems[entity.system].axes;
      response.directions = {own.e1, own.e2, own.e3};
    }
    for (ResponsePoint& p : nvh::response_points_of(m, response)) points.push_back(std::move(p));
  }
  return points;
}

}  // namespace

Complex amplitude(const model::Model& model, const model::SteadyState& request, const model::SteadyState::Load& load,
                  double frequency) {
  const auto value = [&](model::Index curve) {
    return curve == model::none ? 0.0 : model.curves[curve].zero_outside(frequency);
  };
  const double first = load.scale * value(load.first), second = value(load.second);
  if (request.by_parts) return {first, load.scale * second};
  return std::polar(1.0, second * std::numbers::pi / 180.0) * first;
}

namespace {

/// Loads whose curve ends before the frequencies do: it is 0 outside.
void warn_of_short_curves(const model::Model& model, const model::SteadyState& request, const char* keyword,
                          Findings& findings) {
  double low = std::numeric_limits<double>::infinity(), high = 0.0;
  const auto cover = [&](const model::Frequencies& f) {
    if (f.frequency.empty()) return;
    low = std::min(low, f.frequency.front());
    high = std::max(high, f.frequency.back());
  };
  cover(request);
  if (request.states) cover(*request.states);
  if (request.radiated_power) cover(request.frequencies_of_power());
  for (const model::SteadyState::Case& c : request.cases)
    for (const model::SteadyState::Load& load : c.loads) {
      const Curve& curve = model.curves[load.first];
      if (curve.x.front() <= low && curve.x.back() >= high) continue;
      findings.warning(load.excitation.place, keyword,
                       fmt::format("curve {} of a load goes from {:g} to {:g}, the frequencies from {:g} to {:g}: the "
                                   "load is 0 where the curve is not",
                                   curve.id, curve.x.front(), curve.x.back(), low, high),
                       "let the curve cover all frequencies");
    }
}

}  // namespace

void check_steady_state(const Matrices& m, const model::SteadyState& request, Findings& findings) {
  constexpr const char* keyword = "*FREQUENCY_DOMAIN_SSD";
  for (const model::SteadyState::Case& c : request.cases)
    for (const model::SteadyState::Load& load : c.loads) check_excitation(m, load.excitation, keyword, findings);
  warn_of_short_curves(m.system.model, request, keyword, findings);
  const Place& place = request.cases.front().loads.front().excitation.place;
  const bool near_modes = request.near_modes || (request.states && request.states->near_modes) ||
                          (request.radiated_power && request.radiated_power->near_modes);
  if (request.direct) check_direct(m.system.model, request.damping, near_modes, place, keyword, findings);
  warn_of_idle_damping(m.system.model, request.damping.of_parts, place, keyword,
                       request.damping.of_parts ? "write *DAMPING_PART_MASS or _STIFFNESS for the parts"
                                                : "give DAMPF, LCDAM, DMPMAS or DMPSTF; DMPFLG 1 has that of parts",
                       findings);
  if (request.damping.of_parts)
    check_part_damping(m, place, keyword, findings);
  else if (has_dashpots(m))
    findings.warning(place, keyword, "dashpots take no part in it: DMPFLG is 0", "write DMPFLG 1");
  for (const model::SteadyState::Case& c : request.cases)
    for (const model::SteadyState::Load& load : c.loads)
      if (request.damping.of_parts && load.excitation.kind == model::FrequencyResponse::Excitation::Kind::enforced)
        findings.error(load.excitation.place, keyword,
                       "enforced motion of nodes does not know the damping of parts (DMPFLG 1)",
                       "drive the base, apply forces, or write DMPFLG 0");
}

SteadyResult steady_state(const Matrices& m, const Modes& modes, const model::SteadyState& request,
                          const ProgressCallback& progress) {
  std::vector<Transfer::Excitation> excitations;
  for (const model::SteadyState::Case& c : request.cases)
    for (const model::SteadyState::Load& load : c.loads) excitations.push_back(load.excitation);
  Transfer transfer(m, response_points_of(m), excitations);
  SteadyResult result;
  result.frequency = frequencies(request, modes);
  result.method = request.direct ? transfer.solve_directly(request.damping, result.frequency, progress)
                                 : transfer.solve(modes, request.modes, request.damping, result.frequency);
  std::size_t first = 0;  // of the loads of a case among all
  for (std::size_t c = 0; c < request.cases.size(); ++c) {
    const std::vector<model::SteadyState::Load>& loads = request.cases[c].loads;
    for (std::size_t p = 0; p < transfer.points().size(); ++p) {
      const int number = request.cases[c].id.empty() ? 0 : static_cast<int>(c) + 1;
      SteadyCurve curve{number, transfer.points()[p].id, transfer.points()[p].direction, {}};
      for (std::size_t q = 0; q < steady_quantities.size(); ++q)
        for (std::size_t k = 0; k < result.frequency.size(); ++k) {
          Complex sum = 0.0;
          for (std::size_t l = 0; l < loads.size(); ++l) {
            const Complex a = amplitude(m.system.model, request, loads[l], result.frequency[k]);
            const bool base = loads[l].excitation.kind == Transfer::Excitation::Kind::base;
            if (a != 0.0) sum += a * transfer.motion(first + l, p, k, steady_quantities[q], base && request.relative);
          }
          curve.value[q].push_back(sum);
        }
      result.curve.push_back(std::move(curve));
    }
    first += loads.size();
  }
  return result;
}

std::string file_of_case(const char* name, const model::SteadyState::Case& loads) {
  return loads.id.empty() ? std::string(name) : fmt::format("{}_{}", name, loads.id);
}

void write_steady_state(const std::filesystem::path& directory, const output::Header& header,
                        const model::SteadyState& request, const SteadyResult& result) {
  const bool several = !request.cases.front().id.empty();
  std::string text =
      fmt::format("node,direction,response,frequency,amplitude,phase,real,imaginary{}\n", several ? ",case" : "");
  for (const SteadyCurve& curve : result.curve)
    for (std::size_t q = 0; q < steady_quantities.size(); ++q)
      for (std::size_t k = 0; k < result.frequency.size(); ++k) {
        const Complex v = curve.value[q][k];
        text += fmt::format("{},{},{},{:.9g},{},{},{},{}{}\n", curve.node, direction_name(curve.direction),
                            to_string(steady_quantities[q]), result.frequency[k], cell(std::abs(v)), cell(degrees(v)),
                            cell(v.real()), cell(v.imag()), several ? fmt::format(",{}", curve.load_case) : "");
      }
  output::write_whole_file(directory / "ssd.csv", text);

  const std::size_t curves = result.curve.size() / request.cases.size();  // of a case
  for (std::size_t number = 0; number < request.cases.size(); ++number) {
    output::NodoutSsd file(directory / file_of_case("nodout_ssd", request.cases[number]), header);
    std::vector<output::NodoutSsdRow> rows(curves / 3);
    for (std::size_t k = 0; k < result.frequency.size(); ++k) {
      for (std::size_t c = 0; c < curves; ++c) {
        const SteadyCurve& curve = result.curve[number * curves + c];
        output::NodoutSsdRow& row = rows[c / 3];
        row.node = curve.node;
        for (std::size_t q = 0; q < steady_quantities.size(); ++q) row.amplitude[3 * q + c % 3] = curve.value[q][k];
      }
      file.write(result.frequency[k], rows);
    }
  }
}

}  // namespace nugget::nvh
