// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <filesystem>

#include "nvh/response/responses.hpp"
#include "output/ascii.hpp"

namespace nugget::nvh {

/// Response of one node in one direction, as the amplitude of exp(+i omega t).
struct FrfCurve {
  int load_case = 0;      ///< counted from 1 where there are several, else 0
  int node = 0;           ///< user id
  Vec3d direction;        ///< unit vector
  bool rotation = false;  ///< about it
  model::FrequencyResponse::Quantity quantity = model::FrequencyResponse::Quantity::displacement;
  std::vector<std::complex<double>> value;  ///< by frequency
};

/// Responses to one excitation of amplitude 1, or to each of several.
struct FrfResult {
  std::vector<double> frequency;
  std::vector<FrfCurve> curve;
  SolutionMethod method;
};

/// Findings for what the equations cannot answer.
void check_frequency_response(const Matrices& matrices, const model::FrequencyResponse& request, Findings& findings);

/// Steady response of a linear model to harmonic excitation of unit amplitude: by the lowest modes and a residual
/// vector (Superposition), or, where the request says so, by a solution for each frequency, which needs no modes.
/// Throws Factorization::SolverError.
FrfResult frequency_response(const Matrices& matrices, const Modes& modes, const model::FrequencyResponse& request,
                             const ProgressCallback& progress = {});

/// frf.csv: a line for each frequency of each response, with its case in a last column where there are several; and
/// LS-DYNA's files, frf_amplitude and frf_angle or frf_real and frf_imag, one curve a response. Throws
/// output::WriteError.
void write_frf(const std::filesystem::path& directory, const output::Header& header,
               const model::FrequencyResponse& request, const FrfResult& result);

/// Of the response, in the deck's words: displacement, velocity, acceleration, force; of rotations: rotation, ...,
/// moment.
const char* to_string(model::FrequencyResponse::Quantity quantity, bool rotation = false);
/// Phase of an amplitude [degrees].
double degrees(const std::complex<double>& amplitude);
/// x, y, z, or the components of a vector.
std::string direction_name(const Vec3d& direction);
/// One number of a table; empty where it is infinite.
std::string cell(double value);

}  // namespace nugget::nvh
