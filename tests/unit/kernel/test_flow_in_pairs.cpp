// SPDX-License-Identifier: Apache-2.0
// Layers that flow two at a time: the bits that each has alone.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "base/batch.hpp"
#include "base/row.hpp"
#include "kernel/element/shell_layers.hpp"
#include "kernel/law/own_kernels.hpp"
#include "motion.hpp"

namespace nugget::kernel {
namespace {

/// A curve of six points, times `factor`.
Curve hardening(double factor) {
  Curve curve{0, {0.0, 0.01, 0.05, 0.1, 0.2, 1.0}, {300.0, 330.0, 390.0, 430.0, 480.0, 600.0}};
  for (double& y : curve.y) y *= factor;
  return curve;
}

PiecewiseLinear steel() {
  PiecewiseLinear law;
  law.E = 2.1e5;
  law.nu = 0.3;
  law.yield = {hardening(1.0)};
  return law;
}

PiecewiseLinear with_table(bool over_logarithm) {
  PiecewiseLinear law = steel();
  law.yield = {hardening(1.0), hardening(1.1), hardening(1.3)};
  law.rates = {1e-3, 1.0, 100.0};
  law.log_rates = over_logarithm;
  return law;
}

/// A column of layers, strained at random, some lanes hardly and others far beyond yield.
template <class R, class Law>
class Strained {
 public:
  Strained(const Law& law, int layers) : law_(law) {
    shell_.layers = gauss_layers(layers);
    shell_.offset = 0.3;
    const auto numbers = at((LayerTensor<R>::size + law_.layer_history()) * layers * lanes<R>);
    state_[0].assign(numbers, 0.0);
    state_[1].assign(numbers, 0.0);
  }

  void expect_same_bits(int steps) {
    for (int i = 0; i < steps; ++i) {
      ShellRates<R> d;
      for (R* rate : {&d.xx, &d.yy, &d.xy, &d.kxx, &d.kyy, &d.kxy, &d.xz, &d.yz})
        for (int l = 0; l < lanes<R>; ++l) set_lane(*rate, l, (l % 3 == 0 ? 50.0 : 4000.0) * random_());
      const Column<R> pairs = advance_column(shell_, law_, d, R(1.2), 1e-6, state_[0].data());
      const Column<R> alone = advance_one_by_one(shell_, law_, d, R(1.2), 1e-6, state_[1].data());
      ASSERT_EQ(std::memcmp(state_[0].data(), state_[1].data(), state_[0].size() * sizeof state_[0][0]), 0) << i;
      for (int l = 0; l < lanes<R>; ++l) {
        ASSERT_EQ(lane(pairs.n.nxx, l), lane(alone.n.nxx, l));
        ASSERT_EQ(lane(pairs.n.mxy, l), lane(alone.n.mxy, l));
        ASSERT_EQ(lane(pairs.n.qy, l), lane(alone.n.qy, l));
        ASSERT_EQ(lane(pairs.thinning.total, l), lane(alone.thinning.total, l));
        ASSERT_EQ(lane(pairs.thinning.plastic, l), lane(alone.thinning.plastic, l));
        flowed_ += lane(pairs.thinning.plastic, l) != 0.0 ? 1 : 0;
      }
    }
    EXPECT_GT(flowed_, steps / 4) << "hardly anything flowed";
  }

 private:
  LawKernel<Law> law_;
  ShellProperties shell_;
  std::vector<Number<R>, Aligned<Number<R>>> state_[2];
  Random random_;
  int flowed_ = 0;
};

/// In double and in single precision, with one layer and more.
template <class Law>
void expect_same_bits(const Law& law) {
  for (int layers = 1; layers <= 9; ++layers) {
    SCOPED_TRACE(layers);
    Strained<NativeBatch, Law>(law, layers).expect_same_bits(100);
    Strained<SingleBatch, Law>(law, layers).expect_same_bits(100);
  }
}

TEST(FlowInPairs, EachLayerHasTheBitsThatItHasAlone) {
  PiecewiseLinear straight = steel(), rates = steel(), fails = steel();
  straight.yield = {Curve{0, {0.0, 1.0}, {300.0, 1300.0}}};
  rates.rate_c = 40.4;
  rates.rate_p = 5.0;
  fails.failure_strain = 0.2;
  for (const PiecewiseLinear& law : {steel(), straight, rates, fails, with_table(false), with_table(true)})
    expect_same_bits(law);
}

TEST(FlowInPairs, KinematicHardening) {
  PlasticKinematic law;
  law.E = 2.1e5;
  law.nu = 0.3;
  law.yield = 300.0;
  law.tangent_modulus = 1000.0;
  law.beta = 0.3;
  expect_same_bits(law);
  law.rate_c = 40.4;
  law.rate_p = 5.0;
  expect_same_bits(law);
}

}  // namespace
}  // namespace nugget::kernel
