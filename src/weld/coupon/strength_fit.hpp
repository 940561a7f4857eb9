// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

namespace nugget::weld {

/// How a weld was loaded when its test bore the largest force that was measured: N+ (tension), shear force, torsion,
/// bending moment.
struct StrengthSample {
  std::string test;
  std::array<double, 4> load{};
};

/// How loads and strengths make a weld fail: f = sum over groups of (sum of load_k / S_k in the group)^exponent = 1.
struct StrengthForm {
  std::array<const char*, 4> name;  ///< of the strengths against N+, shear, torsion, bending
  std::array<int, 4> group;         ///< of each load, 0 to 3
  double exponent = 2.0;
};
/// Of OPT 0 with NRS = NRT and MSS = MTT: each load by itself.
inline constexpr StrengthForm form_of_resultants{{"NRR", "NRS = NRT", "MRR", "MSS = MTT"}, {0, 1, 2, 3}, 2.0};
/// Of an interpolation spot weld with this BETA: bending adds to tension, torsion to shear.
constexpr StrengthForm form_of_interpolation(double beta) {
  return {{"tension (RN)", "shear (RS)", "torsion (RS/GAMMA)", "bending (RN/ALPHA1)"}, {0, 1, 1, 0}, beta};
}

/// Against tension, shear, torsion, bending.
struct StrengthFit {
  std::array<double, 4> strength{};     ///< 0: left out
  std::array<double, 4> low{}, high{};  ///< 95 % confidence; 0: no more samples than strengths
  double scatter = 0.0;                 ///< standard deviation of a force, as a share of it
  std::vector<double> ratio;            ///< of each sample: force by the strengths over measured
  std::string fault;                    ///< why there is no fit; empty: there is one
};

/// The strengths S that make the failure value of every sample 1 as nearly as they can,
///     least squares of r_i = 1/b ln f_i,   b the exponent of f (StrengthForm),
/// by Levenberg and Marquardt over ln S_k: r is the error of the force at failure as a share of it, since a
/// load that grows in proportion fails at f^(-1/b) of it. Confidence from the scatter that is left, by Student's t
/// with as many degrees of freedom as there are samples beyond the strengths
/// (docs/theory/failure.md#strengths-from-tests). `start` above 0: a strength that is sought. Refused: too few samples,
/// a strength that no sample tells from the others.
StrengthFit fit_strengths(const std::vector<StrengthSample>& samples, const std::array<double, 4>& start,
                          const StrengthForm& form = form_of_resultants);

/// The number that Student's t with `freedom` degrees of freedom exceeds in magnitude with a probability of 5 %.
double student_limit(int freedom);

}  // namespace nugget::weld
