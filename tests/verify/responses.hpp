// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "linear.hpp"
#include "nvh/response/frequency_response.hpp"
#include "specimen.hpp"

// Decks of responses over frequency, and closed forms for them.
namespace nugget::verify {

using Complex = std::complex<double>;

/// Bricks in a row along x that stretch only: springs E A / h between masses rho A h, half of it at the ends.
struct Row {
  static constexpr double h = 10.0, young = 210000.0, density = 7.85e-9;
  static double spring() { return young * h; }
  static double mass() { return density * h * h * h; }  ///< of a node inside, four nodes of the mesh together
  static double omega0() { return std::sqrt(2.0 * spring() / mass()); }  ///< of one brick, clamped and free

  Specimen specimen;
  Grid grid;
  int first = 2, last = 3;  ///< node sets at the ends

  explicit Row(int bricks) {
    specimen.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {4});
    specimen.card("MAT_ELASTIC", {1, density, young, 0.0}).card("SECTION_SOLID", {1, 1}).part(1, 1, 1);
    grid = specimen.bricks(1, {}, {h * bricks, h, h}, {bricks, 1, 1});
    specimen.node_set(1, grid.all()).card("BOUNDARY_SPC_SET", {1, 0, 0, 1, 1});
    specimen.node_set(first, grid.across(0)).node_set(last, grid.across(bricks));
  }
  Row& hold(int set) {
    specimen.card("BOUNDARY_SPC_SET", {1.0 * set, 0, 1, 0, 0});
    return *this;
  }
  /// *FREQUENCY_DOMAIN_FRF by its first, second and third card.
  std::string frf(const std::string& excitation, const std::string& damping, const std::string& response) {
    specimen.text("*FREQUENCY_DOMAIN_FRF\n" + excitation + damping + response + fields({1, 10, 2}));
    return specimen.deck();
  }
};

/// Values of the curves of a deck's *FREQUENCY_DOMAIN_FRF at one frequency; without modes: directly.
inline std::vector<Complex> response_at(const LinearExperiment& e, const nvh::Modes& modes, double frequency) {
  model::FrequencyResponse request = *e.system().model.frequency_response;
  request.frequency = {frequency};
  request.direct = modes.eigenvalue.empty();
  std::vector<Complex> values;
  for (const nvh::FrfCurve& curve : nvh::frequency_response(e.matrices(), modes, request).curve)
    values.push_back(curve.value[0]);
  return values;
}
inline std::vector<Complex> response_at(const LinearExperiment& e, int modes, double frequency) {
  return response_at(e, modes > 0 ? e.modes(modes) : nvh::Modes{}, frequency);
}

inline Complex sum(const std::vector<Complex>& values) {
  Complex s = 0.0;
  for (const Complex& v : values) s += v;
  return s;
}

inline double distance(const Complex& found, const Complex& expected) {
  return std::abs(found - expected) / std::abs(expected);
}

/// (i omega)^n for velocity (VAD 0), acceleration (1) and displacement (2).
inline Complex derivative(int vad, double omega) {
  return vad == 2 ? Complex(1.0) : vad == 0 ? Complex(0.0, omega) : Complex(-omega * omega);
}

inline double cycles(double omega) {
  return omega / (2.0 * std::numbers::pi);
}

}  // namespace nugget::verify
