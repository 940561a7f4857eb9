// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/failure.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"

namespace nugget::weld {

failure::Load Filter::operator()(const failure::Load& load) {
  if (length_ <= 1) return load;
  if (kept_.size() < at(length_)) {
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
  failure::Load smooth = load;
  smooth.resultants = {r.axial * share,   r.shear_s * share,  r.shear_t * share,
                       r.torsion * share, r.moment_s * share, r.moment_t * share};
  smooth.rate = mean.rate * share;
  return smooth;
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
    case FailureMode::user: return "user's function";
    case FailureMode::time: return "failure time";
    case FailureMode::plastic_strain: return "plastic strain";
    case FailureMode::sheet_deleted: return "deleted sheet";
    case FailureMode::element_deleted: return "element death";
    case FailureMode::distortion: return "distortion";
  }
  return "";
}

bool History::update(const failure::Load& load) {
  if (failed()) return false;
  now_ = last_ = filter_(load);
  const Resultants& r = now_.resultants;
  peaks_.add(r.axial, r.shear(), r.moment(), r.torsion);
  value_ = (*function_)(now_);
  course_.add(load.time, value_.value);
  if (value_.value > peak_value_) {
    peak_value_ = value_.value;
    peak_time_ = load.time;
  }
  if (advance_damage(load) == Damage::State::failed)
    fail(load.time, onset_mode_);
  else if (law_->failure_time > 0.0 && load.time >= law_->failure_time)
    fail(load.time, FailureMode::time);
  return failed();
}

/// Carries the damage on, from the cycle on in which the failure function is reached; without a law of damage the weld
/// fails immediately.
Damage::State History::advance_damage(const failure::Load& load) {
  Damage::WeldState now{load.time, load.plastic_strain, load.energy, surface_reached(), value_.value, 0.0, 0.0};
  for (int i = 0; i < value_.terms; ++i) {
    const failure::Value::Term& term = value_.term[i];
    const bool slides = term.mode == FailureMode::shear || term.mode == FailureMode::torsion;
    if (slides && term.value > 0.0) now.sliding += term.value / value_.value;
  }
  now.load = value_.load / damage_.integrity();
  if (!damage_.begun()) onset_mode_ = now.at_surface ? value_.largest() : FailureMode::plastic_strain;
  return damage_.update(now);
}

/// OPT -1 and -2 only give the value; OPT 6 wants it for FVAL cycles on end.
bool History::surface_reached() {
  beyond_ = value_.value >= 1.0 ? beyond_ + 1 : 0;
  return law_->option >= 0 && beyond_ >= std::max(law_->cycles, 1);
}

void History::fail(double time, FailureMode mode) {
  mode_ = mode;
  failure_time_ = time;
  now_ = {};  // a failed weld carries nothing
}

void Filter::archive(Archive& a) {
  a(next_, kept_);
  a.built(length_);
}

void History::archive(Archive& a) {
  a(function_, filter_, now_, last_, value_, peak_value_, peak_time_, course_, beyond_, damage_, onset_mode_,
    failure_time_, mode_, peaks_);
  a.built(law_);
}

}  // namespace nugget::weld
