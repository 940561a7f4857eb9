// SPDX-License-Identifier: Apache-2.0
#include "base/archive.hpp"

#include "weld/failure/failure.hpp"
#include "weld/failure/rigid_weld.hpp"

// What of welds goes into restart files.
namespace nugget::weld {

void Filter::archive(Archive& a) {
  a(next_, kept_);
  a.built(length_);
}

void Damage::archive(Archive& a) {
  a(begun_, onset_, damage_, work_);
  a.built(law_);
}

void History::archive(Archive& a) {
  a(function_, filter_, now_, last_, value_, peak_value_, peak_time_, beyond_, damage_, onset_mode_, failure_time_,
    mode_, peaks_);
  a.built(law_);
}

void ForceFilter::archive(Archive& a) {
  a(kept_);
  a.built(length_, window_);
}

void RigidWeldHistory::archive(Archive& a) {
  a(filter_, axial_, shear_, moment_, torsion_, value_, failure_time_, mode_, peaks_, last_, peak_value_, peak_time_);
  a.built(law_);
}

}  // namespace nugget::weld
