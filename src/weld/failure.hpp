// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "model/weld_law.hpp"

namespace nugget::weld {

/// Forces and moments on a weld's cross-section at mid-length, in its own axes (r along the weld).
struct Resultants {
  double axial = 0.0;                     ///< N_rr, tension positive [force]
  double shear_s = 0.0, shear_t = 0.0;    ///< N_rs, N_rt [force]
  double torsion = 0.0;                   ///< M_rr [moment]
  double moment_s = 0.0, moment_t = 0.0;  ///< M_ss, M_tt [moment]

  double shear() const;   ///< sqrt(N_rs^2 + N_rt^2)
  double moment() const;  ///< sqrt(M_ss^2 + M_tt^2)
};

/// The six terms (R_i / R_iF)^2 of the resultant failure surface, N_rr N_rs N_rt M_rr M_ss M_tt; a strength of 0 omits
/// its term, compression does not count (MAT_100, OPT 0; reference: spotweld-theory.md 4.3). The weld fails when they
/// add up to 1.
std::array<double, 6> failure_terms(const std::array<model::RateValue, 6>& strength, const Resultants& r);

/// Mean of the last `length` resultant vectors (NF of MAT_100); fewer at the start.
class Filter {
 public:
  explicit Filter(int length = 0) : length_(length) {}
  Resultants operator()(const Resultants& r);

 private:
  int length_;
  std::size_t next_ = 0;
  std::vector<Resultants> kept_;
};

enum class FailureMode { intact, axial, shear, torsion, bending, time, plastic_strain, sheet_deleted };
std::string_view to_string(FailureMode mode);

/// What happened to one weld: its filtered resultants now, its peaks, and its end.
class History {
 public:
  explicit History(const model::WeldLaw& law) : law_(&law), filter_(law.filter) {}

  /// Takes the resultants at `time`. True if the weld fails now by the resultant surface or by time.
  bool update(double time, const Resultants& r);
  /// Tells that the weld was removed for a reason of its element (all section points failed).
  void fail(double time, FailureMode mode);

  const Resultants& resultants() const { return now_; }
  double failure_value() const { return value_; }  ///< of the surface; 1 is failure
  double peak_failure_value() const { return peak_value_; }
  bool failed() const { return mode_ != FailureMode::intact; }
  double failure_time() const { return failure_time_; }
  FailureMode mode() const { return mode_; }
  /// Largest |axial|, shear, bending moment and |torsion| so far.
  const std::array<double, 4>& peaks() const { return peaks_; }

 private:
  const model::WeldLaw* law_;
  Filter filter_;
  Resultants now_;
  double value_ = 0.0, peak_value_ = 0.0;
  double failure_time_ = 0.0;
  FailureMode mode_ = FailureMode::intact;
  std::array<double, 4> peaks_{};
};

}  // namespace nugget::weld
