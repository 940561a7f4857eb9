// SPDX-License-Identifier: Apache-2.0
#include "nvh/response/transfer.hpp"

#include <numbers>

namespace nugget::nvh {

using Complex = std::complex<double>;
using Quantity = Transfer::Quantity;

int order(Quantity quantity) {
  return quantity == Quantity::acceleration ? 2 : quantity == Quantity::velocity ? 1 : 0;
}

Complex derivative(double omega, int n) {
  Complex power = 1.0;
  for (int i = 0; i < n; ++i) power *= Complex(0.0, omega);
  for (int i = 0; i > n; --i) power /= Complex(0.0, omega);
  return power;
}

Transfer::Transfer(const Matrices& m, std::vector<ResponsePoint> points, const std::vector<Excitation>& excitations)
    : m_(m), points_(std::move(points)), excitations_(excitations) {
  for (const Excitation& e : excitations_) loads_.push_back(harmonic_load(m, e));
  for (const ResponsePoint& p : points_) {
    start_.push_back(forms_.size());
    if (p.force) {
      forms_.push_back(p.elastic.over(m.equations));
      forms_.push_back(p.inertia.over(m.equations));
    } else {
      forms_.push_back(p.motion.over(m.equations));
    }
  }
}

SolutionMethod Transfer::solve(const Modes& modes, const model::FrequencyResponse::Selection& selection,
                               const model::FrequencyResponse::Damping& damping, std::span<const double> frequency) {
  damping_ = damping;
  frequency_.assign(frequency.begin(), frequency.end());
  const Superposition superposition(m_, modes, selection, loads_);
  responses_ = superposition.responses(damping, forms_, frequency);
  return superposition.method();
}

SolutionMethod Transfer::solve_directly(const model::FrequencyResponse::Damping& damping,
                                        std::span<const double> frequency, const ProgressCallback& progress) {
  damping_ = damping;
  frequency_.assign(frequency.begin(), frequency.end());
  responses_ = solve_responses(m_, loads_, damping, forms_, frequency, progress);
  return {true, 0, 0, {}};
}

Complex Transfer::motion(std::size_t load, std::size_t point, std::size_t k, Quantity wanted, bool relative) const {
  const double omega = 2.0 * std::numbers::pi * frequency_[k];
  const Complex response = responses_(load, start_[point], k);
  const Excitation& e = excitations_[load];
  if (!e.moves()) return derivative(omega, order(wanted)) * response;
  const int n = order(wanted) - order(e.quantity);
  const double carried = relative ? 0.0 : points_[point].motion.of(loads_[load].carried);
  const Complex along = carried == 0.0 ? 0.0 : carried * derivative(omega, n);
  return along + derivative(omega, n + 2) * response;  // the answer is that to a unit acceleration
}

Complex Transfer::force(std::size_t load, std::size_t point, std::size_t k) const {
  const double omega = 2.0 * std::numbers::pi * frequency_[k];
  const ResponsePoint& p = points_[point];
  const Excitation& e = excitations_[load];
  const Complex stiffness(1.0, loss_factor(m_.system.model, frequency_[k], 1) + omega * damping_.stiffness);
  const Complex dashpot(0.0, omega * damping_.mass);
  const Complex elastic = responses_(load, start_[point], k), inertia = responses_(load, start_[point] + 1, k);
  const Complex moving = stiffness * elastic + (dashpot - omega * omega) * inertia;
  if (!e.moves()) {
    const SixDof& f = loads_[load].applied[p.node];
    return moving - dot(part_of(f, p.rotation), p.direction);
  }
  const Nodal& s = loads_[load].carried;
  const int n = -order(e.quantity);
  return stiffness * p.elastic.of(s) * derivative(omega, n) + p.inertia.of(s) * derivative(omega, n + 2) +
         moving * derivative(omega, n + 2);
}

}  // namespace nugget::nvh
