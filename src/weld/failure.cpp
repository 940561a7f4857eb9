// SPDX-License-Identifier: Apache-2.0
#include "weld/failure.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::weld {

double Resultants::shear() const {
  return std::hypot(shear_s, shear_t);
}
double Resultants::moment() const {
  return std::hypot(moment_s, moment_t);
}

std::array<double, 6> failure_terms(const std::array<model::RateValue, 6>& strength, const Resultants& r) {
  const std::array<double, 6> value{std::max(r.axial, 0.0), r.shear_s, r.shear_t, r.torsion, r.moment_s, r.moment_t};
  std::array<double, 6> term{};
  for (std::size_t i = 0; i < 6; ++i) {
    if (!strength[i].given()) continue;
    const double ratio = value[i] / strength[i].value;
    term[i] = ratio * ratio;
  }
  return term;
}

Resultants Filter::operator()(const Resultants& r) {
  if (length_ <= 1) return r;
  if (kept_.size() < static_cast<std::size_t>(length_)) {
    kept_.push_back(r);
  } else {
    kept_[next_] = r;
    next_ = (next_ + 1) % kept_.size();
  }
  Resultants mean;
  for (const Resultants& k : kept_) {
    mean.axial += k.axial;
    mean.shear_s += k.shear_s;
    mean.shear_t += k.shear_t;
    mean.torsion += k.torsion;
    mean.moment_s += k.moment_s;
    mean.moment_t += k.moment_t;
  }
  const double share = 1.0 / static_cast<double>(kept_.size());
  return {mean.axial * share,   mean.shear_s * share,  mean.shear_t * share,
          mean.torsion * share, mean.moment_s * share, mean.moment_t * share};
}

std::string_view to_string(FailureMode mode) {
  switch (mode) {
    case FailureMode::intact: return "";
    case FailureMode::axial: return "axial force";
    case FailureMode::shear: return "shear force";
    case FailureMode::torsion: return "torsion";
    case FailureMode::bending: return "bending moment";
    case FailureMode::time: return "failure time";
    case FailureMode::plastic_strain: return "plastic strain";
    case FailureMode::sheet_deleted: return "deleted sheet";
  }
  return "";
}

bool History::update(double time, const Resultants& r) {
  if (failed()) return false;
  now_ = filter_(r);
  peaks_ = {std::max(peaks_[0], std::abs(now_.axial)), std::max(peaks_[1], now_.shear()),
            std::max(peaks_[2], now_.moment()), std::max(peaks_[3], std::abs(now_.torsion))};
  const std::array<double, 6> term = failure_terms(law_->strength, now_);
  value_ = term[0] + term[1] + term[2] + term[3] + term[4] + term[5];
  peak_value_ = std::max(peak_value_, value_);
  if (value_ >= 1.0) {
    const std::array<double, 4> share{term[0], term[1] + term[2], term[3], term[4] + term[5]};
    constexpr FailureMode mode[4] = {FailureMode::axial, FailureMode::shear, FailureMode::torsion,
                                     FailureMode::bending};
    fail(time, mode[std::max_element(share.begin(), share.end()) - share.begin()]);
    return true;
  }
  if (law_->failure_time > 0.0 && time >= law_->failure_time) {
    fail(time, FailureMode::time);
    return true;
  }
  return false;
}

void History::fail(double time, FailureMode mode) {
  mode_ = mode;
  failure_time_ = time;
  now_ = {};  // a failed weld carries nothing
}

}  // namespace nugget::weld
