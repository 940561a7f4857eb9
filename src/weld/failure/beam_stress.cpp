// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "weld/failure/function.hpp"

namespace nugget::weld::failure {
namespace {

/// Stresses of a round bar under the resultants (Toyota's):
///   normal = N_rr / A + sqrt(M_ss^2 + M_tt^2) / Z,   shear = |M_rr| / (2 Z) + sqrt(N_rs^2 + N_rt^2) / A
struct Stresses {
  double normal, shear;
};
Stresses stresses(const Resultants& r, const Geometry& weld) {
  return {r.axial / weld.area + r.moment() / weld.section_modulus,
          std::abs(r.torsion) / (2.0 * weld.section_modulus) + r.shear() / weld.area};
}

/// (normal / S_N)^2 + (shear / S_S)^2; a normal stress below 0 and strengths of 0 are left out.
Value squares(const Stresses& s, double normal, double shear) {
  const double n = normal > 0.0 ? std::max(s.normal, 0.0) / normal : 0.0, t = shear > 0.0 ? s.shear / shear : 0.0;
  Value f;
  f.add(FailureMode::normal_stress, n * n);
  f.add(FailureMode::shear_stress, t * t);
  return f;
}

/// OPT 1 (SIGAX, SIGTAU of the material) and OPT 7 (of the pair of parts).
class BeamStress final : public Function {
 public:
  BeamStress(model::RateValue normal, model::RateValue shear, const Geometry& weld)
      : normal_(std::move(normal)), shear_(std::move(shear)), weld_(weld) {}
  Value operator()(const Load& load) override {
    return squares(stresses(load.resultants, weld_), normal_.at(load.rate), shear_.at(load.rate));
  }

  void archive(Archive& a) override { a.built(normal_, shear_, weld_); }

 private:
  model::RateValue normal_, shear_;
  Geometry weld_;
};

/// OPT 6.
class SheetStress final : public Function {
 public:
  SheetStress(std::array<SheetStrength, 2> sheets, const Geometry& weld) : sheets_(sheets), weld_(weld) {}
  Value operator()(const Load& load) override {
    const Stresses s = stresses(load.resultants, weld_);
    Value weaker;
    for (const SheetStrength& sheet : sheets_) {
      const double factor = sheet.rate_c > 0.0 ? 1.0 + std::pow(load.rate / sheet.rate_c, 1.0 / sheet.rate_p) : 1.0;
      const Value f = squares(s, factor * sheet.normal, factor * sheet.shear);
      if (f.value >= weaker.value) weaker = f;
    }
    return weaker;
  }

  void archive(Archive& a) override { a.built(sheets_, weld_); }

 private:
  std::array<SheetStrength, 2> sheets_;
  Geometry weld_;
};

}  // namespace

std::unique_ptr<Function> beam_stress(model::RateValue normal, model::RateValue shear, const Geometry& weld) {
  return std::make_unique<BeamStress>(std::move(normal), std::move(shear), weld);
}
std::unique_ptr<Function> sheet_stress(std::array<SheetStrength, 2> sheets, const Geometry& weld) {
  return std::make_unique<SheetStress>(sheets, weld);
}

}  // namespace nugget::weld::failure
