// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/curve.hpp"
#include "kernel/law/law_cards.hpp"
#include "kernel/law/relaxation.hpp"
#include "kernel/law/single_points.hpp"

// Rubbers, laws of solids and layers. I, II, III: invariants of the Cauchy-Green tensor; J relative volume.
namespace nugget::kernel {

class MooneyRivlinPoint;
class BlatzKoPoint;
template <class Energy>
class RubberPoint;
class OgdenEnergy;
class PolynomialEnergy;

/// Compressible rubber of Mooney and Rivlin (MAT_027):
///   W = A (I - 3) + B (II - 3) + C (III^-2 - 1) + D (III - 1)^2,
///   C = A / 2 + B,  D = [A (5 nu - 2) + B (11 nu - 5)] / (2 (1 - 2 nu)).
struct MooneyRivlin {
  using Point = MooneyRivlinPoint;

  double E = 0.0;           ///< Young's modulus of small strains, 4 (A + B) (1 + nu) [stress]
  double nu = 0.0;          ///< Poisson's ratio of small strains [1]
  double a = 0.0, b = 0.0;  ///< [stress]

  static LawCards<MooneyRivlin> cards() {
    using Law = MooneyRivlin;
    return {.name = "MAT_MOONEY-RIVLIN_RUBBER",
            .aliases = {"MAT_027"},
            .cards = {{{&Law::nu, law_field::compressible},
                       {&Law::a, real("a", dimension::stress, required, above_zero(), "constant A of the energy")},
                       {&Law::b, real("b", dimension::stress, 0, at_least(0), "constant B of the energy")},
                       law_field::reference},
                      {real("sgl", dimension::length, 0, any_value, "specimen, for LCID only"),
                       real("sw", dimension::length, 0, any_value, "specimen, for LCID only"),
                       real("st", dimension::length, 0, any_value, "specimen, for LCID only"),
                       integer("lcid", 0, only(0), "curve to which A and B would be fitted")}},
            .complete = [](Law& law) { law.E = 4.0 * (law.a + law.b) * (1.0 + law.nu); }};
  }
};

/// Foamed rubber of Blatz and Ko (MAT_007; Trans. Soc. Rheol. 6, 1962, with f = 1):
///   W = G / 2 [I - 3 + (J^(-2 beta) - 1) / beta],  beta = nu / (1 - 2 nu).
struct BlatzKo {
  using Point = BlatzKoPoint;

  double E = 0.0;      ///< Young's modulus of small strains, 2 G (1 + nu) [stress]
  double nu = 0.463;   ///< Poisson's ratio of small strains [1]
  double shear = 0.0;  ///< G [stress]

  static LawCards<BlatzKo> cards() {
    using Law = BlatzKo;
    return {.name = "MAT_BLATZ-KO_RUBBER",
            .aliases = {"MAT_007"},
            .cards = {{{&Law::shear, real("g", dimension::stress, required, above_zero(),
                                          "shear modulus; Poisson's ratio is 0.463")},
                       law_field::reference}},
            .complete = [](Law& law) { law.E = 2.0 * law.shear * (1.0 + law.nu); }};
  }
};

/// Rubber of Ogden (MAT_077_O):
///   W = sum_j mu_j / alpha_j (l1^alpha_j + l2^alpha_j + l3^alpha_j - 3) + K (J - 1 - ln J),
/// l_i principal stretches less the change of volume.
struct Ogden {
  using Point = RubberPoint<OgdenEnergy>;

  struct Term {
    double mu = 0.0;     ///< [stress]
    double alpha = 0.0;  ///< [1]
  };
  double E = 0.0;   ///< Young's modulus of small strains, 2 (1 + nu) G, G = sum mu alpha / 2 [stress]
  double nu = 0.0;  ///< Poisson's ratio of small strains [1]
  std::vector<Term> terms;
  Overstress overstress;
};

/// Rubber of a polynomial (MAT_077_H):
///   W = sum_pq C_pq (J1 - 3)^p (J2 - 3)^q + K (J - 1 - ln J),  J1 = I III^(-1/3),  J2 = II III^(-2/3).
struct PolynomialRubber {
  using Point = RubberPoint<PolynomialEnergy>;

  double E = 0.0;   ///< Young's modulus of small strains, 2 (1 + nu) G, G = 2 (C10 + C01) [stress]
  double nu = 0.0;  ///< Poisson's ratio of small strains [1]
  double c10 = 0.0, c01 = 0.0, c11 = 0.0, c20 = 0.0, c02 = 0.0, c30 = 0.0;  ///< [stress]
  Overstress overstress;
};

// Point by point. The history of each begins with b - 1.

class MooneyRivlinPoint {
 public:
  static constexpr bool in_layers = true;
  explicit MooneyRivlinPoint(const MooneyRivlin& law);
  int history() const { return SolidTensor<double>::size; }
  int tensors() const { return 1; }
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  double E_, nu_, a_, b_, c_, d_;
};

class BlatzKoPoint {
 public:
  static constexpr bool in_layers = true;
  explicit BlatzKoPoint(const BlatzKo& law);
  int history() const { return SolidTensor<double>::size; }
  int tensors() const { return 1; }
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  double E_, nu_, shear_, power_;  ///< 2 beta
};

/// What the rubbers of MAT_077 share: `Energy` gives the stress and the wave modulus of a tensor b - 1, to which the
/// overstress adds its own.
template <class Energy>
class RubberPoint {
 public:
  static constexpr bool in_layers = true;
  template <class Law>
  explicit RubberPoint(const Law& law) : energy_(law), overstress_(law.overstress) {}
  int history() const { return SolidTensor<double>::size + overstress_.history(); }
  int tensors() const { return 1 + overstress_.tensors(); }
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  Energy energy_;
  OverstressBranches overstress_;
};

class OgdenEnergy {
 public:
  explicit OgdenEnergy(const Ogden& law);
  PointUpdate at(const SolidTensor<double>& b_less_one) const;

 private:
  double E_, nu_;
  std::vector<Ogden::Term> terms_;
  double bulk_;
};

class PolynomialEnergy {
 public:
  explicit PolynomialEnergy(const PolynomialRubber& law);
  PointUpdate at(const SolidTensor<double>& b_less_one) const;

 private:
  PolynomialRubber law_;
  double bulk_;
};

}  // namespace nugget::kernel
