// SPDX-License-Identifier: Apache-2.0
#include "nvh/response/frequency_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nvh/response/frequencies.hpp"
#include "nvh/response/part_damping.hpp"
#include "nvh/response/transfer.hpp"
#include "output/curve_file.hpp"
#include "output/result_file.hpp"

namespace nugget::nvh {
namespace {

using Complex = std::complex<double>;
using Quantity = model::FrequencyResponse::Quantity;

/// A file of curves; infinite values (of free bodies at frequency 0) are 0 there.
void write_curves(const std::filesystem::path& path, const output::Header& header, const FrfResult& result,
                  const char* ordinate, double (*part)(const Complex&)) {
  std::vector<output::XyCurve> curves;
  for (const FrfCurve& curve : result.curve) {
    output::XyCurve xy{fmt::format("{}N-{}-{}{}", curve.load_case > 0 ? fmt::format("C-{}-", curve.load_case) : "",
                                   curve.node, curve.rotation ? "r" : "", direction_name(curve.direction)),
                       result.frequency,
                       {}};
    for (const Complex& v : curve.value) xy.y.push_back(std::isfinite(part(v)) ? part(v) : 0.0);
    curves.push_back(std::move(xy));
  }
  output::write_curve_file(path, header.title, ordinate, curves);
}

}  // namespace

void check_frequency_response(const Matrices& m, const model::FrequencyResponse& request, Findings& findings) {
  constexpr const char* keyword = "*FREQUENCY_DOMAIN_FRF";
  for (const model::FrequencyResponse::Case& c : request.cases) {
    check_excitation(m, c.excitation, keyword, findings);
    check_response(m, c.response, keyword, findings);
  }
  const Place& place = request.cases.front().excitation.place;
  if (request.direct)
    check_direct(m.system.model, request.damping, request.near_modes.has_value(), place, keyword, findings);
  warn_of_idle_damping(
      m.system.model, false, place, keyword,
      "give DAMPF, LCDAM, DMPMAS or DMPSTF, or use *FREQUENCY_DOMAIN_SSD with DMPFLG 1, which has that "
      "of parts",
      findings);
  if (has_dashpots(m))
    findings.warning(place, keyword, "dashpots take no part in it: damping is that of its second card",
                     "use *FREQUENCY_DOMAIN_SSD with DMPFLG 1");
}

FrfResult frequency_response(const Matrices& m, const Modes& modes, const model::FrequencyResponse& request,
                             const ProgressCallback& progress) {
  std::vector<ResponsePoint> points;
  std::vector<std::size_t> case_of;  // of each probe
  std::vector<model::FrequencyResponse::Excitation> excitations;
  for (std::size_t c = 0; c < request.cases.size(); ++c) {
    excitations.push_back(request.cases[c].excitation);
    for (ResponsePoint& p : response_points_of(m, request.cases[c].response)) points.push_back(std::move(p));
    case_of.resize(points.size(), c);
  }
  Transfer transfer(m, std::move(points), excitations);
  FrfResult result;
  result.frequency = frequencies(request, modes);
  result.method = request.direct ? transfer.solve_directly(request.damping, result.frequency, progress)
                                 : transfer.solve(modes, request.modes, request.damping, result.frequency);
  for (std::size_t p = 0; p < transfer.points().size(); ++p) {
    const ResponsePoint& point = transfer.points()[p];
    const std::size_t c = case_of[p];
    const model::FrequencyResponse::Response& response = request.cases[c].response;
    const int number = request.cases.size() > 1 ? static_cast<int>(c) + 1 : 0;
    FrfCurve curve{number, point.id, point.direction, point.rotation, response.quantity, {}};
    for (std::size_t k = 0; k < result.frequency.size(); ++k)
      curve.value.push_back(point.force ? transfer.force(c, p, k)
                                        : transfer.motion(c, p, k, response.quantity, response.relative));
    result.curve.push_back(std::move(curve));
  }
  return result;
}

const char* to_string(Quantity quantity, bool rotation) {
  switch (quantity) {
    case Quantity::velocity: return rotation ? "angular velocity" : "velocity";
    case Quantity::acceleration: return rotation ? "angular acceleration" : "acceleration";
    case Quantity::displacement: return rotation ? "rotation" : "displacement";
    case Quantity::force: return rotation ? "moment" : "force";
  }
  return "";
}

double degrees(const Complex& amplitude) {
  return std::arg(amplitude) * 180.0 / std::numbers::pi;
}

std::string direction_name(const Vec3d& d) {
  if (d.x == 1.0) return "x";
  if (d.y == 1.0) return "y";
  if (d.z == 1.0) return "z";
  return fmt::format("({:.4g} {:.4g} {:.4g})", d.x, d.y, d.z);
}

std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{:.9g}", value) : std::string{};
}

void write_frf(const std::filesystem::path& directory, const output::Header& header,
               const model::FrequencyResponse& request, const FrfResult& result) {
  const bool several = request.cases.size() > 1;
  std::string text =
      fmt::format("node,direction,response,frequency,amplitude,phase,real,imaginary{}\n", several ? ",case" : "");
  for (const FrfCurve& curve : result.curve)
    for (std::size_t k = 0; k < curve.value.size(); ++k) {
      const Complex v = curve.value[k];
      text += fmt::format("{},{},{},{:.9g},{},{},{},{}{}\n", curve.node, direction_name(curve.direction),
                          to_string(curve.quantity, curve.rotation), result.frequency[k], cell(std::abs(v)),
                          cell(degrees(v)), cell(v.real()), cell(v.imag()),
                          several ? fmt::format(",{}", curve.load_case) : "");
    }
  output::write_whole_file(directory / "frf.csv", text);
  const auto write = [&](const char* name, const char* ordinate, double (*part)(const Complex&)) {
    write_curves(directory / name, header, result, ordinate, part);
  };
  if (request.by_parts) {
    write("frf_real", "Real part", [](const Complex& v) { return v.real(); });
    write("frf_imag", "Imaginary part", [](const Complex& v) { return v.imag(); });
  } else {
    write("frf_amplitude", "Amplitude", [](const Complex& v) { return std::abs(v); });
    write("frf_angle", "Phase angle", [](const Complex& v) { return degrees(v); });
  }
}

}  // namespace nugget::nvh
