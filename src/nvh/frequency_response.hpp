// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <filesystem>

#include "nvh/modes.hpp"

namespace nugget::nvh {

/// Response of one node in one direction per unit of excitation, as the amplitude of exp(+i omega t).
struct FrfCurve {
  int node = 0;                             ///< user id
  Vec3d direction;                          ///< unit vector
  std::vector<std::complex<double>> value;  ///< by frequency
};

/// Transfer functions by superposition.
struct FrfResult {
  std::vector<FrfCurve> curve;
  std::size_t first = 0, last = 0;  ///< modes that took part: first, ..., last - 1, counted from 0
  double residual = 0.0;            ///< frequency of the residual vector [cycles/time]; 0: there is none
};

/// Steady response of a linear model to harmonic excitation of unit amplitude: modes, each as an oscillator, and one
/// residual vector, the static response of all that the modes leave out, which moves as one more mode with the
/// frequency of its Rayleigh quotient (modal truncation augmentation: Dickens, Nakagawa, Wittbrodt, Computers &
/// Structures 62 (1997) 985). At frequency 0 the response is then the static one however few modes there are. `modes`
/// must be the lowest ones. Throws Factorization::SolverError.
FrfResult frequency_response(const Matrices& matrices, const Modes& modes, const model::FrequencyResponse& request);

/// frf.csv: a line for each frequency of each response. Throws output::WriteError.
void write_frf(const std::filesystem::path& directory, const model::FrequencyResponse& request,
               const FrfResult& result);

/// Of the response, in the deck's words: displacement, velocity, acceleration.
const char* to_string(model::FrequencyResponse::Quantity quantity);
/// Phase of an amplitude [degrees].
double degrees(const std::complex<double>& amplitude);
/// x, y, z, or the components of a vector.
std::string direction_name(const Vec3d& direction);

}  // namespace nugget::nvh
