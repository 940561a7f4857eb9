// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/parts.hpp"

namespace nugget::model {

/// *FREQUENCY_DOMAIN_FRF: steady response to one harmonic excitation of unit amplitude, over frequency.
struct FrequencyResponse {
  enum class Quantity { velocity, acceleration, displacement };

  struct Excitation {
    bool base = false;                       ///< all supports move together; else forces and pressure
    Quantity quantity = Quantity::velocity;  ///< of the base, which has amplitude 1
    std::vector<Index> nodes;                ///< each carries a force of amplitude 1
    Vec3d direction;                         ///< unit vector
    std::vector<Segment> pressed;            ///< each carries a pressure of amplitude 1, against its normal
  } excitation;

  struct Response {
    std::vector<Index> nodes;
    std::vector<Vec3d> directions;  ///< unit vectors
    Quantity quantity = Quantity::displacement;
    bool relative = false;  ///< to the base
  } response;

  /// Which of the modes take part, from the lowest on.
  struct Selection {
    double highest = 0.0;     ///< FNMAX: none above this natural frequency [cycles/time]; 0: no such end
    int first = 1, last = 0;  ///< MDMIN, MDMAX; last 0: no such end
    double lowest = 0.0;      ///< FNMIN: none below this natural frequency
  } modes;

  /// Mode r has 2 zeta omega_r + mass + stiffness omega_r^2 in place of c / m.
  struct Damping {
    double ratio = 0.0;      ///< zeta of all modes, where there is no curve
    Index curve = none;      ///< zeta over natural frequency [cycles/time] or number of mode; end values hold outside
    bool by_mode = false;    ///< the curve is over the number of the mode
    double mass = 0.0;       ///< alpha of Rayleigh's damping [1/time]
    double stiffness = 0.0;  ///< beta [time]
  } damping;

  std::vector<double> frequency;  ///< at which the response is wanted, ascending [cycles/time]
};

/// *FREQUENCY_DOMAIN_SSD: steady response to harmonic loads together, each with its amplitude and phase over frequency.
struct SteadyState {
  struct Load {
    FrequencyResponse::Excitation excitation;
    double scale = 1.0;
    Index first = none, second = none;  ///< curves over frequency: amplitude and phase [degree], or real and imaginary
  };
  std::vector<Load> loads;
  bool by_parts = false;  ///< the curves are real and imaginary part
  bool relative = false;  ///< responses to the base's motion are relative to it
  FrequencyResponse::Selection modes;
  FrequencyResponse::Damping damping;
  std::vector<double> frequency;  ///< of *DATABASE_FREQUENCY_ASCII_NODOUT_SSD, ascending [cycles/time]
};

}  // namespace nugget::model
