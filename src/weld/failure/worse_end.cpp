// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/function.hpp"

namespace nugget::weld::failure {
namespace {

/// The failure value at the end of the weld where it is larger. The moments there are those at mid-length and a couple
/// of the shear force, M -/+ h/2 r x N at the second and the first end. A thickness TRUE_T below the modelled length
/// takes the part of that couple away that only a weld modelled too thick has. See docs/theory/failure.md#worse-end
/// (the project's own form; what LS-DYNA documents is that TRUE_T scales the moments of shear down, in the failure
/// function alone).
class WorseEnd final : public Function {
 public:
  WorseEnd(std::unique_ptr<Function> inner, double height, bool once)
      : inner_(std::move(inner)), height_(height), once_(once) {}

  Value operator()(const Load& load) override {
    const Load first = at_end(load, -0.5 * height_), second = at_end(load, 0.5 * height_);
    if (once_) return (*inner_)(second.resultants.moment() > first.resultants.moment() ? second : first);
    const Value f = (*inner_)(first), g = (*inner_)(second);
    return g.value > f.value ? g : f;
  }

  void archive(Archive& a) override {
    a(inner_);
    a.built(height_, once_);
  }

 private:
  static Load at_end(Load load, double half) {
    const double s = load.resultants.shear_s, t = load.resultants.shear_t;
    load.resultants.moment_s += half * t;
    load.resultants.moment_t -= half * s;
    return load;
  }
  std::unique_ptr<Function> inner_;
  double height_;
  bool once_;
};

}  // namespace

std::unique_ptr<Function> worse_end(std::unique_ptr<Function> inner, double height, bool once) {
  return std::make_unique<WorseEnd>(std::move(inner), height, once);
}

}  // namespace nugget::weld::failure
