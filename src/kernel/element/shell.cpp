// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/shell.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace nugget::kernel {
namespace {

struct Legendre {
  double value, slope;
};

Legendre legendre(int degree, double x) {
  double before = 1.0, here = x;
  for (int k = 2; k <= degree; ++k) {
    const double next = ((2.0 * k - 1.0) * x * here - (k - 1.0) * before) / k;
    before = here;
    here = next;
  }
  if (degree == 0) return {1.0, 0.0};
  if (x * x == 1.0) return {here, (degree % 2 == 1 || x > 0.0 ? 0.5 : -0.5) * degree * (degree + 1.0)};
  return {here, degree * (x * here - before) / (x * x - 1.0)};
}

}  // namespace

LayerRule gauss_layers(int count) {
  LayerRule rule;
  rule.count = count;
  for (int k = 0; k < count; ++k) {
    double x = -std::cos(std::numbers::pi * (k + 0.75) / (count + 0.5));
    for (int i = 0; i < 20; ++i) x -= legendre(count, x).value / legendre(count, x).slope;
    if (2 * k + 1 == count) x = 0.0;
    const double slope = legendre(count, x).slope;
    rule.zeta[k] = x;
    rule.weight[k] = 1.0 / ((1.0 - x * x) * slope * slope);
  }
  return rule;
}

LayerRule equally_spaced_layers(int count) {
  LayerRule rule;
  rule.count = count;
  for (int k = 0; k < count; ++k) {
    const auto point = static_cast<std::size_t>(k);
    rule.zeta[point] = count == 1 ? 0.0 : -1.0 + 2.0 * k / (count - 1);
    rule.weight[point] = count == 1 ? 1.0 : (k == 0 || k == count - 1 ? 0.5 : 1.0) / (count - 1);
  }
  return rule;
}

LayerRule lobatto_layers(int count) {
  if (count < 3) return gauss_layers(count);
  const int degree = count - 1;
  LayerRule rule;
  rule.count = count;
  for (int k = 0; k < count; ++k) {
    double x = -std::cos(std::numbers::pi * k / degree);
    const bool inside = k > 0 && k < degree;
    for (int i = 0; inside && i < 40; ++i) {
      // The inner points are the zeros of P'; P'' follows from Legendre's equation.
      const Legendre p = legendre(degree, x);
      const double curvature = (2.0 * x * p.slope - degree * (degree + 1.0) * p.value) / (1.0 - x * x);
      x -= p.slope / curvature;
    }
    if (2 * k == degree) x = 0.0;
    if (!inside) x = k == 0 ? -1.0 : 1.0;
    const double value = legendre(degree, x).value;
    rule.zeta[k] = x;
    rule.weight[k] = 1.0 / (degree * (degree + 1.0) * value * value);
  }
  return rule;
}

void start_shell(const ShellLayout& layout, double thickness, double* state, int width, int lane) {
  for (int i = 0; i < layout.size(); ++i) state[i * width + lane] = 0.0;
  state[ShellLayout::alive * width + lane] = 1.0;
  state[ShellLayout::density_scale * width + lane] = 1.0;
  state[ShellLayout::thickness * width + lane] = thickness;
}

}  // namespace nugget::kernel
