// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "nvh/eigen/modes.hpp"
#include "output/ascii.hpp"

namespace nugget::nvh {

/// Equivalent radiated power of panels over frequency: r rho c / 2 times the integral of |v_n|^2 over the panel, with
/// the amplitude v_n of its normal velocity and the radiation loss factor r. It is what the panel radiates if each
/// point of it does so as part of a large flat piston, an upper bound in the mean.
struct RadiatedPower {
  std::vector<double> frequency;
  struct Panel {
    std::string name;
    double area = 0.0;
    std::vector<double> power;  ///< by frequency; not finite for a free body at frequency 0
  };
  std::vector<Panel> panels;  ///< of more than one the last is all of them together
};

/// Under the loads of a request with RadiatedPower. Velocities are absolute, whatever RELATV is. `modes`: the lowest
/// ones; not used where the request is direct. Throws Factorization::SolverError.
RadiatedPower radiated_power(const Matrices& matrices, const Modes& modes, const model::SteadyState& request,
                             const ProgressCallback& progress = {});

/// Integral of |v_n|^2 over a quad or triangle (its last corner twice), bilinear in between: two by two points of Gauss
/// in a quad, exact in a parallelogram; the exact rule of three points in a triangle. `x`, `v`: of its corners.
double square_of_normal_velocity(std::span<const Vec3d, 4> x,
                                 std::span<const std::array<std::complex<double>, 3>, 4> v);

/// 10 log10(power / reference).
double decibels(double power, double reference);

/// erp.csv, ERP_abs and, where the request has a reference, ERP_dB. Throws output::WriteError.
void write_radiated_power(const std::filesystem::path& directory, const output::Header& header,
                          const model::SteadyState& request, const RadiatedPower& result);

}  // namespace nugget::nvh
