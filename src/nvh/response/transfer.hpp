// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nvh/response/responses.hpp"

namespace nugget::nvh {

/// Derivatives with respect to time that lead from a displacement to a quantity.
int order(model::FrequencyResponse::Quantity quantity);
/// (i omega)^n
std::complex<double> derivative(double omega, int n);

/// Responses of probes to harmonic loads of amplitude 1, put together from the answers of the equations of motion: what
/// moves with the base is added, motions are turned into velocities and accelerations, supports carry what elements,
/// masses and damping hand them.
class Transfer {
 public:
  using Excitation = model::FrequencyResponse::Excitation;
  using Quantity = model::FrequencyResponse::Quantity;

  Transfer(const Matrices& matrices, std::vector<ResponsePoint> points, const std::vector<Excitation>& excitations);

  /// By superposition of the lowest modes.
  SolutionMethod solve(const Modes& modes, const model::FrequencyResponse::Selection& selection,
                       const model::FrequencyResponse::Damping& damping, std::span<const double> frequency);
  /// By one solution for each frequency.
  SolutionMethod solve_directly(const model::FrequencyResponse::Damping& damping, std::span<const double> frequency,
                                const ProgressCallback& progress);

  const std::vector<ResponsePoint>& points() const { return points_; }
  /// Of a probe of motion; `wanted` is a displacement, velocity or acceleration, relative to the base or not.
  std::complex<double> motion(std::size_t load, std::size_t point, std::size_t k, Quantity wanted, bool relative) const;
  /// Of a probe of force.
  std::complex<double> force(std::size_t load, std::size_t point, std::size_t k) const;

 private:
  const Matrices& m_;
  std::vector<ResponsePoint> points_;
  std::vector<Excitation> excitations_;
  std::vector<HarmonicLoad> loads_;
  std::vector<Row> forms_;          ///< of the probes, one of a motion, two of a force
  std::vector<std::size_t> start_;  ///< first form of each probe
  std::vector<double> frequency_;
  model::FrequencyResponse::Damping damping_;
  Responses responses_{0, 0, 0};
};

}  // namespace nugget::nvh
