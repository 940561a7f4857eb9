// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <numbers>
#include <optional>

#include "base/index.hpp"
#include "nvh/matrices/complex_factorization.hpp"
#include "nvh/response/part_damping.hpp"
#include "nvh/response/responses.hpp"

namespace nugget::nvh {

void check_direct(const model::Model& model, const model::FrequencyResponse::Damping& damping, bool near_modes,
                  const Place& place, const char* keyword, Findings& findings) {
  if (near_modes)
    findings.error(place, keyword, "FSPACE 2 and 3 ask for frequencies by the modes, which the direct solution has not",
                   "write FSPACE 0 or 1, list the frequencies by LCFREQ, or solve by modes");
  if (damping.ratio != 0.0 || damping.curve != model::none)
    findings.error(place, keyword, "damping by modes (DAMPF, LCDAM) has no matrix for the direct solution",
                   "give DMPMAS, DMPSTF or *DAMPING_STRUCTURAL, or solve by modes");
  if (model.structural_damping.curve != model::none && model.structural_damping.by_mode)
    findings.error(place, "*DAMPING_STRUCTURAL",
                   "LCTYP 1, a loss factor by mode, has no matrix for the direct solution",
                   "give the curve over frequency (LCTYP 0), or solve by modes");
}

using Complex = std::complex<double>;

void solve_directly(const Matrices& m, const model::FrequencyResponse::Damping& damping,
                    std::span<const double> frequency, std::size_t loads, const OneFrequency& load,
                    const OneFrequency& visit, const ProgressCallback& progress) {
  if (m.size() == 0) return;
  std::optional<Symmetric> dampers;
  if (damping.of_parts) dampers = part_damping(m);
  ComplexFactorization factorization(m, dampers ? &*dampers : nullptr);
  std::vector<Complex> x(m.size() * loads);
  for (std::size_t k = 0; k < frequency.size(); ++k) {
    if (progress) progress(fmt::format("direct solution {} of {}", k + 1, frequency.size()));
    const double omega = 2.0 * std::numbers::pi * frequency[k];
    const double loss = loss_factor(m.system.model, frequency[k], 1) + omega * damping.stiffness;
    factorization.factor(Complex(1.0, loss), Complex(-omega * omega, omega * damping.mass), Complex(0.0, omega));
    load(k, x);
    factorization.solve(x, loads);
    visit(k, x);
  }
}

Responses solve_responses(const Matrices& m, std::span<const HarmonicLoad> loads,
                          const model::FrequencyResponse::Damping& damping, std::span<const Row> forms,
                          std::span<const double> frequency, const ProgressCallback& progress) {
  Responses a(loads.size(), forms.size(), frequency.size());
  const auto load = [&](std::size_t, std::vector<Complex>& x) {
    for (std::size_t l = 0; l < loads.size(); ++l)
      for (std::size_t i = 0; i < m.size(); ++i) x[l * m.size() + i] = loads[l].force[i];
  };
  const auto keep = [&](std::size_t k, const std::vector<Complex>& x) {
    for (std::size_t l = 0; l < loads.size(); ++l)
      for (std::size_t f = 0; f < forms.size(); ++f)
        for (const Equations::Term& t : forms[f]) a(l, f, k) += t.factor * x[l * m.size() + at(t.equation)];
  };
  solve_directly(m, damping, frequency, loads.size(), load, keep, progress);
  return a;
}

}  // namespace nugget::nvh
