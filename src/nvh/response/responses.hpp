// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <functional>
#include <span>
#include <vector>

#include "nvh/eigen/modes.hpp"
#include "nvh/response/harmonic_load.hpp"
#include "nvh/response/response_point.hpp"

namespace nugget::nvh {

/// Steady motions q exp(+i omega t) under each of some loads of amplitude 1, of which only linear forms are kept.
struct Responses {
  std::size_t forms = 0, frequencies = 0;
  std::vector<std::complex<double>> value;

  Responses(std::size_t loads, std::size_t form_count, std::size_t frequency_count)
      : forms(form_count), frequencies(frequency_count), value(loads * form_count * frequency_count) {}
  std::complex<double>& operator()(std::size_t load, std::size_t form, std::size_t k) {
    return value[(load * forms + form) * frequencies + k];
  }
  const std::complex<double>& operator()(std::size_t load, std::size_t form, std::size_t k) const {
    return value[(load * forms + form) * frequencies + k];
  }
};

/// How the equations of motion were solved: modes and residual vectors, or directly.
struct SolutionMethod {
  bool direct = false;
  std::size_t first = 0, last = 0;  ///< modes that took part: first, ..., last - 1, counted from 0
  std::vector<double> residual;     ///< frequencies of the residual vectors [cycles/time]
};

/// Which modes take part: first, ..., last - 1, counted from 0; none where all lie above FNMAX. Throws
/// Factorization::SolverError where MDMIN or FNMIN leave none: the static answer alone is not what they ask for.
struct ModeRange {
  std::size_t first = 0, last = 0;
};
ModeRange modes_that_take_part(const Modes& modes, const model::FrequencyResponse::Selection& selection);

using Row = std::vector<Equations::Term>;  ///< a form over the unknowns

/// Modes, and one residual vector for each load: the static answer to what the modes leave out, which moves as one more
/// mode with the frequency of its Rayleigh quotient (modal truncation augmentation: Dickens, Nakagawa, Wittbrodt,
/// Computers & Structures 62 (1997) 985). Those of several loads are made orthogonal in K and M by Ritz's method.
class Superposition {
 public:
  /// `modes` must be the lowest ones, and outlive this. Throws Factorization::SolverError.
  Superposition(const Matrices& matrices, const Modes& modes, const model::FrequencyResponse::Selection& selection,
                std::span<const HarmonicLoad> loads);

  Responses responses(const model::FrequencyResponse::Damping& damping, std::span<const Row> forms,
                      std::span<const double> frequency) const;
  /// How much of each oscillator, mode or residual vector, answers each load of amplitude 1; as forms of Responses.
  Responses shares(const model::FrequencyResponse::Damping& damping, std::span<const double> frequency) const;
  std::size_t oscillators() const { return oscillators_.size(); }
  std::span<const double> shape(std::size_t i) const { return oscillators_[i].shape; }

  const SolutionMethod& method() const { return method_; }

 private:
  struct Oscillator {
    std::span<const double> shape;
    double eigenvalue = 0.0;
    int number = 0;            ///< as a mode, counted from 1
    std::vector<double> load;  ///< shape^t f of each load
  };
  void couple(std::span<const double> frequency, Responses& shares) const;
  const Matrices& m_;
  std::size_t loads_ = 0;
  SolutionMethod method_;
  Columns rest_;
  std::vector<Oscillator> oscillators_;
};

/// Solutions of (K (1 + i g + i omega beta) + i omega (alpha M + C) - omega^2 M) q = f, whatever the modes are; C is
/// part_damping, where the damping is of parts. Damping by modes has no matrix and must not be there. Of each frequency
/// `load` gives the right-hand sides, one after the other, and `visit` gets the answers in their place. Throws
/// Factorization::SolverError.
using OneFrequency = std::function<void(std::size_t k, std::vector<std::complex<double>>& x)>;
void solve_directly(const Matrices& matrices, const model::FrequencyResponse::Damping& damping,
                    std::span<const double> frequency, std::size_t loads, const OneFrequency& load,
                    const OneFrequency& visit, const ProgressCallback& progress);

/// What is kept of them, for loads of amplitude 1.
Responses solve_responses(const Matrices& matrices, std::span<const HarmonicLoad> loads,
                          const model::FrequencyResponse::Damping& damping, std::span<const Row> forms,
                          std::span<const double> frequency, const ProgressCallback& progress = {});

/// Errors for damping and frequencies that belong to modes.
void check_direct(const model::Model& model, const model::FrequencyResponse::Damping& damping, bool near_modes,
                  const Place& place, const char* keyword, Findings& findings);

/// The loss factor of *DAMPING_STRUCTURAL at a frequency of the excitation, for a mode counted from 1.
double loss_factor(const model::Model& model, double frequency, int mode);

}  // namespace nugget::nvh
