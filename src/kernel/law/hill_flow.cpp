// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/hill_flow.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::kernel {
namespace {

/// A symmetric matrix of two rows: its eigenvalues, and the rows that are its eigenvectors.
struct EigenOfTwo {
  double value[2], vector[2][2];
  EigenOfTwo(double xx, double yy, double xy) {
    const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy), c = std::cos(angle), s = std::sin(angle);
    vector[0][0] = vector[1][1] = c;
    vector[0][1] = s;
    vector[1][0] = -s;
    for (int i = 0; i < 2; ++i) {
      const double a = vector[i][0], b = vector[i][1];
      value[i] = a * a * xx + b * b * yy + 2.0 * a * b * xy;
    }
  }
};

}  // namespace

HillModes::HillModes(const std::array<double, 6>& constants, double shear) {
  const double doubled[3] = {2.0 * constants[5], 2.0 * constants[3], 2.0 * constants[4]};  // of ab, bc, ca
  for (int i = 0; i < 3; ++i) {
    shear_[i] = std::sqrt(doubled[i]);
    modulus_[2 + i] = doubled[i] * shear;
  }
}

HillModes HillModes::of_layers(const std::array<double, 6>& constants, const ElasticConstants& elastic) {
  HillModes modes(constants, elastic.shear);
  const auto [F, G, H, L, M, N] = constants;
  // Roots of the elastic matrix, whose eigenvectors are (1, 1) and (1, -1): its own, and that of its inverse.
  const double sum = std::sqrt(elastic.plane * (1.0 + elastic.nu)),
               difference = std::sqrt(elastic.plane * (1.0 - elastic.nu));
  const double own = 0.5 * (sum + difference), mixed = 0.5 * (sum - difference);
  const double own_inverse = 0.5 * (1.0 / sum + 1.0 / difference), mixed_inverse = 0.5 * (1.0 / sum - 1.0 / difference);
  const double aa = G + H, bb = F + H, ab = -H;
  // root * surface * root
  const double a0 = own * aa + mixed * ab, a1 = own * ab + mixed * bb, b0 = mixed * aa + own * ab,
               b1 = mixed * ab + own * bb;
  const EigenOfTwo eigen(a0 * own + a1 * mixed, b0 * mixed + b1 * own, a0 * mixed + a1 * own);
  for (int i = 0; i < 2; ++i) {
    const double u = eigen.vector[i][0], v = eigen.vector[i][1], root = std::sqrt(eigen.value[i]);
    modes.modulus_[i] = eigen.value[i];
    modes.to_[i][0] = root * (own_inverse * u + mixed_inverse * v);
    modes.to_[i][1] = root * (mixed_inverse * u + own_inverse * v);
    modes.from_[i][0] = (own * u + mixed * v) / root;
    modes.from_[i][1] = (mixed * u + own * v) / root;
    modes.in_plane_[i] = G * modes.from_[i][0] + F * modes.from_[i][1];
  }
  modes.least_ = *std::min_element(modes.modulus_.begin(), modes.modulus_.end());
  return modes;
}

HillModes HillModes::of_solids(const std::array<double, 6>& constants, const ElasticConstants& elastic) {
  HillModes modes(constants, elastic.shear);
  const auto [F, G, H, L, M, N] = constants;
  // Two directions across the pressure.
  const double two = std::sqrt(0.5), six = std::sqrt(1.0 / 6.0);
  const double basis[2][3] = {{two, -two, 0.0}, {six, six, -2.0 * six}};
  const double surface[3][3] = {{G + H, -H, -G}, {-H, F + H, -F}, {-G, -F, F + G}};
  const auto along = [&](int i, int j) {
    double s = 0.0;
    for (int p = 0; p < 3; ++p)
      for (int q = 0; q < 3; ++q) s += basis[i][p] * surface[p][q] * basis[j][q];
    return s;
  };
  const EigenOfTwo eigen(along(0, 0), along(1, 1), along(0, 1));
  for (int i = 0; i < 2; ++i) {
    const double root = std::sqrt(eigen.value[i]);
    modes.modulus_[i] = 2.0 * elastic.shear * eigen.value[i];
    for (int p = 0; p < 3; ++p) {
      const double direction = eigen.vector[i][0] * basis[0][p] + eigen.vector[i][1] * basis[1][p];
      modes.to_[i][p] = root * direction;
      modes.from_[i][p] = direction / root;
    }
  }
  modes.least_ = *std::min_element(modes.modulus_.begin(), modes.modulus_.end());
  return modes;
}

HillFlow::HillFlow(const HillAnisotropy& law, const ElasticConstants& elastic)
    : elastic_(elastic),
      layers_(HillModes::of_layers(law.of_layers(), elastic)),
      solids_(HillModes::of_solids(law.constants, elastic)),
      axes_(law.axes) {
  for (int k = 0; k < 2; ++k) {
    if (law.back_stress[k] == 0.0 || law.back_exponent[k] == 0.0) continue;
    stress_[terms_] = law.back_stress[k];
    exponent_[terms_] = law.back_exponent[k];
    ++terms_;
  }
}

}  // namespace nugget::kernel
