// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "nvh/matrices/dense.hpp"
#include "nvh/matrices/factorization.hpp"
#include "nvh/response/part_damping.hpp"
#include "nvh/response/responses.hpp"
#include "nvh/response/static_answer.hpp"

namespace nugget::nvh {
namespace {

using Complex = std::complex<double>;

constexpr double two_pi = 2.0 * std::numbers::pi;

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// c / m of an oscillator.
double viscous(const model::Model& model, const model::FrequencyResponse::Damping& d, double eigenvalue, int mode) {
  const double omega = std::sqrt(eigenvalue);
  double ratio = d.ratio;
  if (d.curve != model::none) ratio = model.curves[d.curve].clamped(d.by_mode ? mode : omega / two_pi);
  return 2.0 * ratio * omega + d.mass + d.stiffness * eigenvalue;
}

/// Columns that are left when those without a part of their own are dropped, combined so that both matrices are
/// diagonal on them: M with ones, K with the values returned.
std::vector<double> ritz(const Matrices& m, Columns& x) {
  Columns moved(m.size(), x.count);
  multiply(m.mass, x, moved);
  Columns gram = inner(x, x.count, moved);
  const std::vector<double> share = diagonalize(gram);  // of columns of length 1: far from 0, or dependent
  std::vector<std::size_t> own;
  for (std::size_t i = 0; i < share.size(); ++i)
    if (share[i] > 1e-10) own.push_back(i);
  Columns basis(x.count, own.size());
  for (std::size_t j = 0; j < own.size(); ++j)
    for (std::size_t i = 0; i < x.count; ++i) basis[j][i] = gram[own[j]][i] / std::sqrt(share[own[j]]);
  Columns y(m.size(), own.size());
  add_product(1.0, x, x.count, basis, 0.0, y);
  Columns forces(m.size(), y.count);
  multiply(m.stiffness, y, forces);
  Columns turn = inner(y, y.count, forces);
  const std::vector<double> value = diagonalize(turn);
  x = Columns(m.size(), y.count);
  add_product(1.0, y, y.count, turn, 0.0, x);
  return value;
}

/// The static answer to a load without the share of the modes before `last`. Where the load sets free motions going
/// that are not among these modes it has none; a small shift gives it one, of which an oscillator with the vector's
/// Rayleigh quotient has the best multiple. Returns the square of the whole answer's size, by mass.
double static_rest(const Matrices& m, const Factorization& shifted, double shift, const Modes& modes, std::size_t last,
                   const HarmonicLoad& load, std::span<double> x) {
  std::vector<double> held(m.size(), 0.0), rest(m.size());
  double of_modes = 0.0;
  for (std::size_t i = 0; i < last; ++i) {
    const double share = dot(modes.shape[i], load.force), answer = share / (std::abs(modes.eigenvalue[i]) + shift);
    for (std::size_t k = 0; k < m.size(); ++k) held[k] += share * modes.shape[i][k];
    of_modes += answer * answer;
  }
  m.mass.multiply(held, rest);
  for (std::size_t k = 0; k < m.size(); ++k) rest[k] = load.force[k] - rest[k];
  if (!solve_statically(m, shifted, rest, x)) {
    Columns answer(m.size(), 1);
    answer.value = load.force;
    shifted.solve(answer);
    std::ranges::copy(answer.value, x.begin());
    return m.mass.quadratic(x);
  }
  return m.mass.quadratic(x) + of_modes;
}

/// Static answers to the loads without their share in the modes before `last`, each with a mass of 1; those of which
/// nothing is left are missing.
Columns residual_vectors(const Matrices& m, const Modes& modes, std::size_t last, std::span<const HarmonicLoad> loads) {
  Columns x(m.size(), loads.size());
  const double shift = small_shift(m);
  const Factorization shifted(m, shift);
  Columns rest(m.size(), 0);
  std::vector<double> momentum(m.size());
  for (std::size_t l = 0; l < loads.size(); ++l) {
    const double before = static_rest(m, shifted, shift, modes, last, loads[l], x[l]);
    for (int pass = 0; pass < 2; ++pass) {  // once more against round-off
      m.mass.multiply(x[l], momentum);
      for (std::size_t i = 0; i < last; ++i) {
        const double share = dot(modes.shape[i], momentum);
        for (std::size_t k = 0; k < m.size(); ++k) x[l][k] -= share * modes.shape[i][k];
      }
    }
    const double mass = m.mass.quadratic(x[l]);
    if (!(mass > 1e-20 * before)) continue;
    for (const double v : x[l]) rest.value.push_back(v / std::sqrt(mass));
    ++rest.count;
  }
  return rest;
}

}  // namespace

double loss_factor(const model::Model& model, double frequency, int mode) {
  const model::StructuralDamping& d = model.structural_damping;
  return d.curve == model::none ? d.factor : model.curves[d.curve].clamped(d.by_mode ? mode : frequency);
}

ModeRange modes_that_take_part(const Modes& modes, const model::FrequencyResponse::Selection& chosen) {
  std::size_t last = modes.eigenvalue.size();
  while (last > 0 && chosen.highest > 0.0 && modes.frequency(last - 1) > chosen.highest) --last;
  if (chosen.last > 0) last = std::min(last, at(chosen.last));
  std::size_t first = std::min(at(chosen.first) - 1, last);
  while (first < last && modes.frequency(first) < chosen.lowest) ++first;
  const bool from_below = chosen.first > 1 || chosen.lowest > 0.0;
  if (first == last && from_below && !modes.eigenvalue.empty())
    throw Factorization::SolverError{fmt::format(
        "no mode is left for the response: of the {} that were found, the last at {:.6g}, {} are at or below "
        "the upper end (FNMAX, MDMAX), and none of these is at or above the lower one (MDMIN {}{}); lower "
        "it, or raise NEIG of *CONTROL_IMPLICIT_EIGENVALUE",
        modes.eigenvalue.size(), modes.frequency(modes.eigenvalue.size() - 1), last, chosen.first,
        chosen.lowest > 0.0 ? fmt::format(", FNMIN {:g}", chosen.lowest) : "")};
  return {first, last};
}

Superposition::Superposition(const Matrices& m, const Modes& modes, const model::FrequencyResponse::Selection& chosen,
                             std::span<const HarmonicLoad> loads)
    : m_(m), loads_(loads.size()) {
  const auto [first, last] = modes_that_take_part(modes, chosen);
  method_.first = first;
  method_.last = last;
  const auto add = [&](std::span<const double> shape, double eigenvalue, std::size_t number) {
    Oscillator o{shape, std::max(0.0, eigenvalue), static_cast<int>(number), {}};
    for (const HarmonicLoad& load : loads) o.load.push_back(dot(shape, load.force));
    oscillators_.push_back(std::move(o));
  };
  for (std::size_t i = first; i < last; ++i) add(modes.shape[i], modes.eigenvalue[i], i + 1);
  if (m.size() == 0) return;
  rest_ = residual_vectors(m, modes, last, loads);
  if (rest_.count == 0) return;
  const std::vector<double> eigenvalue = ritz(m, rest_);
  for (std::size_t j = 0; j < rest_.count; ++j) {
    add(rest_[j], eigenvalue[j], last + 1 + j);
    method_.residual.push_back(std::sqrt(std::max(0.0, eigenvalue[j])) / two_pi);
  }
}

Responses Superposition::shares(const model::FrequencyResponse::Damping& damping,
                                std::span<const double> frequency) const {
  const model::Model& model = m_.system.model;
  Responses a(loads_, oscillators_.size(), frequency.size());
  if (damping.of_parts) {
    couple(frequency, a);
    return a;
  }
  for (std::size_t k = 0; k < frequency.size(); ++k)
    for (std::size_t i = 0; i < oscillators_.size(); ++i) {
      const Oscillator& o = oscillators_[i];
      const double omega = two_pi * frequency[k];
      const double loss = o.eigenvalue * loss_factor(model, frequency[k], o.number);
      const Complex response =
          1.0 / Complex(o.eigenvalue - omega * omega, viscous(model, damping, o.eigenvalue, o.number) * omega + loss);
      for (std::size_t l = 0; l < loads_; ++l) a(l, i, k) = o.load[l] * response;
    }
  return a;
}

/// Damping of parts couples the oscillators: (diag(omega_i^2 (1 + i g) - omega^2) + i omega phi^t C phi) a = phi^t f.
void Superposition::couple(std::span<const double> frequency, Responses& a) const {
  const std::size_t count = oscillators_.size();
  Columns shapes(m_.size(), count), forces(m_.size(), count);
  for (std::size_t i = 0; i < count; ++i) std::copy_n(oscillators_[i].shape.begin(), m_.size(), shapes[i].begin());
  multiply(part_damping(m_), shapes, forces);
  const Columns damping = inner(shapes, count, forces);
  std::vector<Complex> dynamic(count * count), x(count * loads_);
  for (std::size_t k = 0; k < frequency.size(); ++k) {
    const double omega = two_pi * frequency[k];
    for (std::size_t j = 0; j < count; ++j)
      for (std::size_t i = 0; i < count; ++i) dynamic[j * count + i] = Complex(0.0, omega * damping[j][i]);
    for (std::size_t i = 0; i < count; ++i) {
      const Oscillator& o = oscillators_[i];
      const double loss = o.eigenvalue * loss_factor(m_.system.model, frequency[k], o.number);
      dynamic[i * count + i] += Complex(o.eigenvalue - omega * omega, loss);
      for (std::size_t l = 0; l < loads_; ++l) x[l * count + i] = o.load[l];
    }
    solve(dynamic, x, count);
    for (std::size_t l = 0; l < loads_; ++l)
      for (std::size_t i = 0; i < count; ++i) a(l, i, k) = x[l * count + i];
  }
}

Responses Superposition::responses(const model::FrequencyResponse::Damping& damping, std::span<const Row> forms,
                                   std::span<const double> frequency) const {
  const Responses share = shares(damping, frequency);
  Responses a(loads_, forms.size(), frequency.size());
  parallel_for(forms.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
      for (std::size_t i = 0; i < oscillators_.size(); ++i) {
        double motion = 0.0;
        for (const Equations::Term& t : forms[f]) motion += t.factor * oscillators_[i].shape[t.equation];
        for (std::size_t l = 0; l < loads_; ++l)
          for (std::size_t k = 0; k < frequency.size(); ++k) a(l, f, k) += motion * share(l, i, k);
      }
  });
  return a;
}

}  // namespace nugget::nvh
