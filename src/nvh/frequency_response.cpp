// SPDX-License-Identifier: Apache-2.0
#include "nvh/frequency_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "output/result_file.hpp"

namespace nugget::nvh {
namespace {

using Complex = std::complex<double>;
using Quantity = model::FrequencyResponse::Quantity;

constexpr double two_pi = 2.0 * std::numbers::pi;

/// T^t of the load whose amplitude is 1: forces, or the inertia forces -M r of a base acceleration.
std::vector<double> load_of(const Matrices& m, const model::FrequencyResponse::Excitation& excitation) {
  std::vector<double> f(m.size(), 0.0);
  const Vec3d& d = excitation.direction;
  if (excitation.base)
    for (std::size_t k = 0; k < m.nodal_mass.size(); ++k) {
      if (m.nodal_mass[k].none()) continue;
      m.equations.add_load(static_cast<int>(k), m.nodal_mass[k].momentum({-d.x, -d.y, -d.z, 0, 0, 0}), f);
    }
  else
    for (const model::Index n : excitation.nodes)
      m.equations.add_load(m.system.node_of[at(n)], {d.x, d.y, d.z, 0, 0, 0}, f);
  return f;
}

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// A mass-normalized motion that answers the load as one oscillator.
struct Oscillator {
  std::span<const double> shape;
  double eigenvalue, damping, load;  ///< omega^2, c / m, shape^t f

  Complex answer(double omega) const { return load / Complex(eigenvalue - omega * omega, damping * omega); }
};

double damping_of(const model::Model& model, const model::FrequencyResponse::Damping& d, double eigenvalue, int mode) {
  const double omega = std::sqrt(eigenvalue);
  double ratio = d.ratio;
  if (d.curve != model::none) ratio = model.curves[at(d.curve)].clamped(d.by_mode ? mode : omega / two_pi);
  return 2.0 * ratio * omega + d.mass + d.stiffness * eigenvalue;
}

/// Static answer to the load without its share in the modes before `last`, mass-normalized; empty where nothing is
/// left. A small shift lets bodies without supports have one; the answer of an oscillator with its Rayleigh quotient
/// is the best multiple of the vector, so that the error is of second order in that shift.
std::vector<double> residual_vector(const Matrices& m, const Modes& modes, std::size_t last,
                                    std::span<const double> f) {
  const Factorization factor(m, small_shift(m));
  Columns x(m.size(), 1);
  std::copy(f.begin(), f.end(), x[0].begin());
  factor.solve(x);
  std::vector<double> momentum(m.size());
  const double before = m.mass.quadratic(x[0]);
  for (int pass = 0; pass < 2; ++pass) {  // once more against round-off
    m.mass.multiply(x[0], momentum);
    for (std::size_t i = 0; i < last; ++i) {
      const double share = dot(modes.shape[i], momentum);
      for (std::size_t k = 0; k < m.size(); ++k) x[0][k] -= share * modes.shape[i][k];
    }
  }
  const double mass = m.mass.quadratic(x[0]);
  if (!(mass > 1e-20 * before)) return {};
  for (double& v : x[0]) v /= std::sqrt(mass);
  return x.value;
}

/// What the amplitude of a displacement is to be multiplied with.
Complex derivative(Quantity quantity, double omega) {
  switch (quantity) {
    case Quantity::velocity: return {0.0, omega};
    case Quantity::acceleration: return -omega * omega;
    case Quantity::displacement: return 1.0;
  }
  return 1.0;
}

}  // namespace

FrfResult frequency_response(const Matrices& m, const Modes& modes, const model::FrequencyResponse& request) {
  FrfResult result;
  result.last = modes.eigenvalue.size();
  const auto& chosen = request.modes;
  while (result.last > 0 && chosen.highest > 0.0 && modes.frequency(result.last - 1) > chosen.highest) --result.last;
  if (chosen.last > 0) result.last = std::min(result.last, at(chosen.last));
  result.first = std::min(at(chosen.first) - 1, result.last);

  const std::vector<double> f = load_of(m, request.excitation);
  std::vector<Oscillator> oscillators;
  for (std::size_t i = result.first; i < result.last; ++i) {
    const double eigenvalue = std::max(0.0, modes.eigenvalue[i]);
    oscillators.push_back({modes.shape[i], eigenvalue,
                           damping_of(m.system.model, request.damping, eigenvalue, static_cast<int>(i) + 1),
                           dot(modes.shape[i], f)});
  }
  const std::vector<double> rest = residual_vector(m, modes, result.last, f);
  if (!rest.empty()) {
    const double eigenvalue = m.stiffness.quadratic(rest);
    result.residual = std::sqrt(eigenvalue) / two_pi;
    oscillators.push_back({rest, eigenvalue,
                           damping_of(m.system.model, request.damping, eigenvalue, static_cast<int>(result.last) + 1),
                           dot(rest, f)});
  }

  for (const model::Index n : request.response.nodes)
    for (const Vec3d& d : request.response.directions)
      result.curve.push_back({m.system.model.nodes.id[at(n)], d, std::vector<Complex>(request.frequency.size())});
  const std::size_t directions = request.response.directions.size();
  const model::FrequencyResponse::Excitation& excitation = request.excitation;
  parallel_for(result.curve.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      FrfCurve& curve = result.curve[c];
      const int node = m.system.node_of[at(request.response.nodes[c / directions])];
      std::vector<double> motion;
      for (const Oscillator& o : oscillators) {
        const Six u = m.equations.motion(node, o.shape);
        motion.push_back(nugget::dot(curve.direction, Vec3d{u[0], u[1], u[2]}));
      }
      const bool moves_with_base = excitation.base && !request.response.relative;
      const double carried = moves_with_base ? nugget::dot(curve.direction, excitation.direction) : 0.0;
      for (std::size_t k = 0; k < request.frequency.size(); ++k) {
        const double omega = two_pi * request.frequency[k];
        Complex u = 0.0;
        for (std::size_t i = 0; i < oscillators.size(); ++i) u += motion[i] * oscillators[i].answer(omega);
        // (response / base acceleration) or (response / base displacement), without dividing by a frequency of 0
        const Complex wanted = derivative(request.response.quantity, omega);
        if (!excitation.base)
          curve.value[k] = wanted * u;
        else if (excitation.quantity == request.response.quantity)
          curve.value[k] = carried - omega * omega * u;
        else
          curve.value[k] = wanted / derivative(excitation.quantity, omega) * (carried - omega * omega * u);
      }
    }
  });
  return result;
}

const char* to_string(Quantity quantity) {
  switch (quantity) {
    case Quantity::velocity: return "velocity";
    case Quantity::acceleration: return "acceleration";
    case Quantity::displacement: return "displacement";
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

void write_frf(const std::filesystem::path& directory, const model::FrequencyResponse& request,
               const FrfResult& result) {
  std::string text = "node,direction,response,frequency,amplitude,phase,real,imaginary\n";
  const auto number = [](double v) { return std::isfinite(v) ? fmt::format("{:.9g}", v) : std::string{}; };
  for (const FrfCurve& curve : result.curve)
    for (std::size_t k = 0; k < curve.value.size(); ++k) {
      const Complex v = curve.value[k];
      text += fmt::format("{},{},{},{:.9g},{},{},{},{}\n", curve.node, direction_name(curve.direction),
                          to_string(request.response.quantity), request.frequency[k], number(std::abs(v)),
                          number(degrees(v)), number(v.real()), number(v.imag()));
    }
  output::write_whole_file(directory / "frf.csv", text);
}

}  // namespace nugget::nvh
