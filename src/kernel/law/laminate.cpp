// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/laminate.hpp"

#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

namespace nugget::kernel {
namespace {

/// Wave modulus in the plane.
double plane_modulus(const ComposedLaw& law) {
  return law.E / (1.0 - law.nu * law.nu);
}
double shear_modulus(const ComposedLaw& law) {
  return law.E / (2.0 * (1.0 + law.nu));
}

/// Mean of a value over the thickness, each layer by its share times `weight`. Exact where all values are the same.
template <class Value, class Weight>
double mean(const std::vector<Laminate::Layer>& layers, const Value& value, const Weight& weight) {
  const double first = value(layers.front());
  double sum = 0.0, differences = 0.0;
  for (const Laminate::Layer& layer : layers) {
    sum += layer.share * weight(layer);
    differences += layer.share * weight(layer) * (value(layer) - first);
  }
  return first + differences / sum;
}

/// Centre and spread of what is spread over the thickness by `density`. What all layers share lies as in one material.
template <class Density>
std::pair<double, double> moments(const std::vector<Laminate::Layer>& layers, const Density& density) {
  const double first = density(layers.front());
  double excess = 0.0, total = 0.0, moment = 0.0, second = 0.0;
  for (const Laminate::Layer& layer : layers) {
    const double more = layer.share * (density(layer) - first);
    total += layer.share;
    excess += more;
    moment += more * layer.place;
    second += more * (3.0 * layer.place * layer.place + layer.share * layer.share);
  }
  const double all = first * total + excess, centre = moment / all;
  return {centre, (first * total + second) / all - 3.0 * centre * centre};
}

}  // namespace

Laminate laminate(std::vector<Laminate::Layer> layers, bool kept_by_unfailing_layers) {
  const auto plane = [](const Laminate::Layer& l) { return plane_modulus(l.law); };
  const auto even = [](const Laminate::Layer&) { return 1.0; };
  Laminate made;
  made.nu = mean(
      layers, [](const auto& l) { return l.law.nu; }, plane);
  made.E = mean(
      layers, [&](const auto& l) { return l.law.E * ((1.0 - made.nu * made.nu) / (1.0 - l.law.nu * l.law.nu)); }, even);
  made.density = mean(
      layers, [](const auto& l) { return l.density; }, even);
  made.kept_by_unfailing_layers = kept_by_unfailing_layers;
  std::tie(made.profile.mass_centre, made.profile.mass_spread) =
      moments(layers, [](const auto& l) { return l.density; });
  std::tie(made.profile.stiffness_centre, made.profile.stiffness_spread) = moments(layers, plane);
  made.layers = std::make_shared<const std::vector<Laminate::Layer>>(std::move(layers));
  return made;
}

void use_laminated_shear(Laminate& laminate) {
  std::vector<Laminate::Layer> layers = *laminate.layers;
  double whole = 0.0, stiffness = 0.0, moment = 0.0, shear = 0.0;
  for (const Laminate::Layer& l : layers) {
    const double q = l.share * plane_modulus(l.law);
    moment += q * (whole + 0.5 * l.share);
    stiffness += q;
    shear += l.share * shear_modulus(l.law);
    whole += l.share;
  }
  // Over z from 0 to the sum of the shares.
  const double centre = moment / stiffness;
  constexpr double points[] = {-0.77459666924148338, 0.0, 0.77459666924148338};  // Gauss: exact for g^2
  constexpr double weights[] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  double below = -centre, flow = 0.0, bending = 0.0, compliance = 0.0;  // flow: g at the bottom of the slice
  std::vector<double> square;
  for (const Laminate::Layer& l : layers) {
    const double q = plane_modulus(l.law), above = below + l.share;
    const auto flow_at = [&](double z) { return flow - 0.5 * q * (z * z - below * below); };
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
      const double g = flow_at(below + 0.5 * (1.0 + points[i]) * l.share);
      sum += weights[i] * g * g;
    }
    square.push_back(sum);
    compliance += l.share * sum / shear_modulus(l.law);
    bending += q * (above * above * above - below * below * below) / 3.0;
    flow = flow_at(above);
    below = above;
  }
  const double section = bending * bending / compliance;
  laminate.shear_factor = section / shear;
  for (std::size_t k = 0; k < layers.size(); ++k)
    layers[k].shear = section * std::sqrt(square[k]) / (bending * shear_modulus(layers[k].law));
  laminate.layers = std::make_shared<const std::vector<Laminate::Layer>>(std::move(layers));
}

double share_of_bending(const Laminate& laminate) {
  double points = 0.0, slices = 0.0;
  for (const Laminate::Layer& l : *laminate.layers) {
    const double q = l.share * plane_modulus(l.law), arm = l.place - laminate.profile.stiffness_centre;
    points += q * 3.0 * arm * arm;
    slices += q * (3.0 * arm * arm + l.share * l.share);
  }
  return points / slices;
}

}  // namespace nugget::kernel
