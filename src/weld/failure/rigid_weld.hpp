// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <deque>

#include "base/archive.hpp"
#include "model/rigid_weld.hpp"
#include "weld/failure/failure.hpp"

namespace nugget::weld {

/// What a rigid weld transmits between its outermost node and the others.
struct RigidWeldLoad {
  Vec3d force;           ///< of the weld on the node, in axes that turn with the weld [force]
  Vec3d axis;            ///< from the node into the weld, unit, in the same axes
  Vec3d normal;          ///< of a seam: of its throat, unit or zero, in the same axes
  double moment = 0.0;   ///< bending at mid-length [force length]
  double torsion = 0.0;  ///< about the axis [force length]
};

/// Mean of the latest force vectors: at most `length` of them, and of these only those within `window` if that is
/// given. Where the window holds more than `length` vectors, all `length` count (LS-DYNA: the window is then ignored).
class ForceFilter {
 public:
  ForceFilter(int length, double window) : length_(static_cast<std::size_t>(std::max(length, 1))), window_(window) {}
  Vec3d operator()(double time, const Vec3d& force);
  void archive(Archive& a);

 private:
  struct Kept {
    double time;
    Vec3d force;
  };
  std::size_t length_;
  double window_;
  std::deque<Kept> kept_;
};

/// What happened to the outermost joint of a rigid weld: its filtered forces now, its peaks and its end.
///
///     (max(f_n, 0) / SN)^N + (|f_s| / SS)^M >= 1     brittle; a strength of 0 leaves its term out
///     plastic strain > EP                            ductile
///     t >= TF
///
/// or, of a seam, by the stresses on its throat (model::Seam). With f_n along the weld, tension positive, f_s across it
/// (LS-DYNA Keyword Manual, docs/theory/weld.md#rigid-welds).
class RigidWeldHistory {
 public:
  explicit RigidWeldHistory(const model::RigidWeld& law, const model::Seam* seam = nullptr)
      : law_(&law), seam_(seam), filter_(law.filter, law.window) {}

  /// Takes the load at `time` and the largest plastic strain of the adjoining elements. True if the joint fails now.
  bool update(double time, const RigidWeldLoad& load, double plastic_strain);
  /// Begins anew for the joint that is the outermost after one has failed; peaks stay.
  void move_inward();
  /// Forgets the forces that are averaged: their axes are others from now on.
  void restart_filter() { filter_ = ForceFilter(law_->filter, law_->window); }

  double axial() const { return axial_; }      ///< f_n, filtered [force]
  double shear() const { return shear_; }      ///< |f_s|, filtered [force]
  double moment() const { return moment_; }    ///< [force length]
  double torsion() const { return torsion_; }  ///< [force length]
  double failure_value() const { return value_; }
  bool failed() const { return mode_ != FailureMode::intact; }
  double failure_time() const { return failure_time_; }
  FailureMode mode() const { return mode_; }
  const Peaks& peaks() const { return peaks_; }

  struct Last {
    double axial = 0.0, shear = 0.0;             ///< [force]
    double moment = 0.0, torsion = 0.0;          ///< [force length]
    double value = 0.0;                          ///< of the criterion; failure from 1 on
    double normal_term = 0.0, shear_term = 0.0;  ///< whose sum it is; of a seam the square of it
  };
  /// The load in the cycle of failure; while the weld holds, the latest.
  const Last& last() const { return last_; }
  double peak_failure_value() const { return peak_value_; }
  double peak_failure_time() const { return peak_time_; }
  /// The failure value over time, up to failure.
  const FailureCourse& course() const { return course_; }
  void restart_course() { course_.restart(); }

  void archive(Archive& a);

 private:
  struct Terms {
    double value, normal, shear;
  };
  Terms of_spot() const;
  Terms of_seam(const Vec3d& force, const Vec3d& normal) const;
  void fail(double time, FailureMode mode);

  const model::RigidWeld* law_;
  const model::Seam* seam_;  ///< null of a spot
  ForceFilter filter_;
  double axial_ = 0.0, shear_ = 0.0, moment_ = 0.0, torsion_ = 0.0;
  double value_ = 0.0, failure_time_ = 0.0;
  FailureMode mode_ = FailureMode::intact;
  Peaks peaks_;
  Last last_;
  double peak_value_ = 0.0, peak_time_ = 0.0;
  FailureCourse course_;
};

}  // namespace nugget::weld
