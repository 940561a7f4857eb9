// SPDX-License-Identifier: Apache-2.0
#include "weld/failure.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::weld {

failure::Load Filter::operator()(const failure::Load& load) {
  if (length_ <= 1) return load;
  if (kept_.size() < static_cast<std::size_t>(length_)) {
    kept_.push_back(load);
  } else {
    kept_[next_] = load;
    next_ = (next_ + 1) % kept_.size();
  }
  failure::Load mean;
  for (const failure::Load& k : kept_) {
    mean.resultants.axial += k.resultants.axial;
    mean.resultants.shear_s += k.resultants.shear_s;
    mean.resultants.shear_t += k.resultants.shear_t;
    mean.resultants.torsion += k.resultants.torsion;
    mean.resultants.moment_s += k.resultants.moment_s;
    mean.resultants.moment_t += k.resultants.moment_t;
    mean.rate += k.rate;
  }
  const double share = 1.0 / static_cast<double>(kept_.size());
  const Resultants& r = mean.resultants;
  return {{r.axial * share, r.shear_s * share, r.shear_t * share, r.torsion * share, r.moment_s * share,
           r.moment_t * share},
          mean.rate * share,
          load.time};
}

std::string_view to_string(FailureMode mode) {
  switch (mode) {
    case FailureMode::intact: return "";
    case FailureMode::axial: return "axial force";
    case FailureMode::shear: return "shear force";
    case FailureMode::torsion: return "torsion";
    case FailureMode::bending: return "bending moment";
    case FailureMode::normal_stress: return "normal stress";
    case FailureMode::shear_stress: return "shear stress";
    case FailureMode::sheet_1: return "stress in sheet 1";
    case FailureMode::sheet_2: return "stress in sheet 2";
    case FailureMode::nugget: return "stress in the nugget";
    case FailureMode::tension: return "tension at its angle";
    case FailureMode::compression: return "compression at its angle";
    case FailureMode::time: return "failure time";
    case FailureMode::plastic_strain: return "plastic strain";
    case FailureMode::sheet_deleted: return "deleted sheet";
  }
  return "";
}

bool History::update(const failure::Load& load) {
  if (failed()) return false;
  now_ = last_ = filter_(load);
  const Resultants& r = now_.resultants;
  peaks_ = {std::max(peaks_[0], std::abs(r.axial)), std::max(peaks_[1], r.shear()), std::max(peaks_[2], r.moment()),
            std::max(peaks_[3], std::abs(r.torsion))};
  value_ = (*function_)(now_);
  if (value_.value > peak_value_) {
    peak_value_ = value_.value;
    peak_time_ = load.time;
  }
  if (surface_reached())
    fail(load.time, value_.largest());
  else if (law_->failure_time > 0.0 && load.time >= law_->failure_time)
    fail(load.time, FailureMode::time);
  return failed();
}

/// OPT -1 and -2 only tell the value; OPT 6 wants it for FVAL cycles on end.
bool History::surface_reached() {
  beyond_ = value_.value >= 1.0 ? beyond_ + 1 : 0;
  return law_->option >= 0 && beyond_ >= std::max(law_->cycles, 1);
}

void History::fail(double time, FailureMode mode) {
  mode_ = mode;
  failure_time_ = time;
  now_ = {};  // a failed weld carries nothing
}

}  // namespace nugget::weld
