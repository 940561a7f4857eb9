// SPDX-License-Identifier: Apache-2.0
#include "weld/placement/interpolation_deck.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "weld/placement/deck_text.hpp"

namespace nugget::weld {
namespace {

std::string reals(std::initializer_list<double> values) {
  std::string line;
  for (const double v : values) line += real_field(v);
  return line;
}

std::string curve_card(int id, const std::array<double, 2>& x, const std::array<double, 2>& y) {
  std::string s = fmt::format("*DEFINE_CURVE\n$#    lcid\n{:10d}\n$#                a1                  o1\n", id);
  for (std::size_t i = 0; i < 2; ++i) s += fmt::format("{:>20}{:>20}\n", real_field(x[i]), real_field(y[i]));
  return s;
}

/// What the weld yields at.
struct Yield {
  double tension, shear;                // [force]
  double bending_share, torsion_share;  // of moments in them [1/length]
  double hardening;                     // of the factor on both, over plastic displacement [1/length]
};

Yield yield_of(const WeldFields& f, double d, double length) {
  const auto share = [](double force, double moment) { return moment > 0.0 ? force / moment : 0.0; };
  const double nrr = f.at("nrr"), nrs = f.at("nrs");
  if (nrr > 0.0) return {nrr, nrs, share(nrr, f.at("mss")), share(nrs, f.at("mrr")), 0.0};
  // The section of a round bar: forces A s and A s/sqrt(3), plastic moments s d^3/6 and s/sqrt(3) pi d^3/12.
  const double area = 0.25 * std::numbers::pi * d * d, s = f.at("sigy"), shear = s / std::sqrt(3.0);
  return {area * s, area * shear, 1.5 * std::numbers::pi / d, 3.0 / d, f.at("eh") / (s * length)};
}

}  // namespace

std::string interpolation_fault(const WeldFields& f) {
  if ((f.at("nrr") > 0.0) != (f.at("nrs") > 0.0)) return "tension and shear flow together: NRR and NRS need each other";
  if (!(f.at("nrr") > 0.0) && f.at("mss") + f.at("mrr") > 0.0) return "MSS and MRR count beside NRR and NRS only";
  if (f.at("upr") != 0.0 || f.at("upf") != 0.0)
    if (!(f.at("upf") >= 0.0 && f.at("upr") > f.at("upf")))
      return "damage begins at the plastic displacement UPF, and UPR, above it, is where the weld breaks";
  return {};
}

std::string interpolation_card(const InterpolationWelds& welds, int node_set, const WeldFields& f, int& curve) {
  const double d = std::strtod(welds.diameter.c_str(), nullptr), length = welds.reach;
  const double area = 0.25 * std::numbers::pi * d * d, inertia = area * d * d / 16.0;
  const double young = f.at("e"), shear = young / (2.0 * (1.0 + f.at("pr")));
  const Yield yield = yield_of(f, d, length);
  const int flow = ++curve;
  const bool breaks = f.at("upr") > 0.0;
  const int begins = breaks ? ++curve : 0, ends = breaks ? ++curve : 0;
  std::string s = "*CONSTRAINED_INTERPOLATION_SPOTWELD\n";
  s += "$#    pid1      pid2      nsid     thick         r     stiff    alpha1     model\n";
  s += fmt::format("{:10d}{:10d}{:10d}", welds.first_part, welds.second_part, node_set) +
       reals({length, 0.5 * d, young * area / length, yield.bending_share}) + fmt::format("{:10d}\n", 1);
  s += "$#      rn        rs      beta       lcf     lcupf     lcupr      dens      intp\n";
  s += reals({yield.tension, yield.shear, 2.0}) + fmt::format("{:10d}{:10d}{:10d}", flow, begins, ends) +
       reals({f.at("ro")}) + fmt::format("{:10d}\n", 0);
  s += "$#  stiff2    stiff3    stiff4    lcdexp     gamma     sropt     pidvb\n";
  s += reals({shear * area / length, young * inertia / length, 2.0 * shear * inertia / length}) +
       fmt::format("{:10d}", 0) + reals({yield.torsion_share}) + '\n';
  s += curve_card(flow, {0.0, d}, {1.0, 1.0 + yield.hardening * d});
  if (breaks) {
    s += "$ Over the mode mixity, 0 shear, 1 tension.\n";
    s += curve_card(begins, {0.0, 1.0}, {f.at("upf"), f.at("upf")});
    s += curve_card(ends, {0.0, 1.0}, {f.at("upr"), f.at("upr")});
  }
  return s;
}

}  // namespace nugget::weld
