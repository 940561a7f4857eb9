// SPDX-License-Identifier: Apache-2.0
#include "weld/placement/stack_card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "weld/placement/deck_text.hpp"

namespace nugget::weld {
namespace {

/// Characteristic shear force of a spot weld between two sheets and what limits it, EN 1993-1-3, 8.4: t in mm.
std::pair<double, const char*> shear_of_pair(const StackSheet& a, const StackSheet& b, double d) {
  const double thin = std::min(a.thickness, b.thickness), thick = std::max(a.thickness, b.thickness);
  const double weaker = std::min(a.tensile_strength, b.tensile_strength);
  std::pair<double, const char*> least{0.25 * std::numbers::pi * d * d * weaker, "shear of the nugget"};
  const auto limit = [&](double force, const char* by) {
    if (force < least.first) least = {force, by};
  };
  for (const StackSheet& sheet : {a, b})
    limit(2.7 * std::sqrt(sheet.thickness) * d * sheet.tensile_strength, "tearing and bearing of a sheet");
  if (thick > 2.5 * thin) {
    limit(0.7 * d * d * weaker, "tearing of the thin sheet (0.7 d^2)");
    limit(3.1 * thin * d * weaker, "bearing of the thin sheet (3.1 t d)");
  }
  return least;
}

constexpr double of_shear = 0.74;  // force of cross tension over that of lap shear, Chao

std::string card_line(std::initializer_list<double> values) {
  std::string s;
  for (const double v : values) s += real_field(v);
  return s + '\n';
}

}  // namespace

StackWeld weld_of_stack(const std::vector<StackSheet>& stack, double factor, double diameter) {
  StackWeld weakest;
  for (std::size_t i = 0; i + 1 < stack.size(); ++i) {
    const double thin = std::min(stack[i].thickness, stack[i + 1].thickness);
    const double d = diameter > 0.0 ? diameter : factor * std::sqrt(thin);
    const auto [shear, by] = shear_of_pair(stack[i], stack[i + 1], d);
    if (i == 0 || shear < weakest.shear) weakest = {d, shear, of_shear * shear, i, by};
  }
  return weakest;
}

std::string write_stack_card(const std::vector<StackSheet>& stack, double factor, double diameter,
                             const model::Units& units) {
  const StackWeld weld = weld_of_stack(stack, factor, diameter);
  const double mm = units.millimetre, newton = units.newton, megapascal = units.steel_young / 210000.0;
  std::string s = fmt::format("*KEYWORD\n$ A spot weld by nugget weld --stack; units: {}.\n", units.name);
  for (const StackSheet& sheet : stack)
    s += fmt::format("$ sheet {:.4g} mm, tensile strength {:.4g} MPa\n", sheet.thickness, sheet.tensile_strength);
  s += diameter > 0.0 ? fmt::format("$ diameter {:.4g} mm as asked for\n", diameter)
                      : fmt::format("$ diameter {:.4g} mm: {:g} sqrt(t) of the thinner sheet, EN 1993-1-3, 8.4 has 5\n",
                                    weld.diameter, factor);
  s += fmt::format(
      "$ nrs, nrt {:.5g} N by {} between sheets {} and {}: EN 1993-1-3, 8.4, gamma 1\n"
      "$ nrr {:.5g} N: 0.74 of it, cross tension over lap shear (Y. J. Chao, J. Eng. Mater. Technol. 125, 2003)\n"
      "$ mrr, mss, mtt 0: no published rule; tests (coach peel) give them: nugget fit\n"
      "$ sigy, eh: the nugget hardly yields. All of it is to begin with: data of no weld that was tested.\n",
      weld.shear, weld.governed, weld.pair + 1, weld.pair + 2, weld.tension);
  s += "*MAT_SPOTWELD\n$#     mid        ro         e        pr      sigy        eh        dt     tfail\n" +
       fmt::format("{:10d}", 3) +
       card_line({units.steel_density, units.steel_young, 0.3, 2000.0 * megapascal, 1000.0 * megapascal, 0.0, 0.0}) +
       "$#   efail       nrr       nrs       nrt       mrr       mss       mtt        nf\n" +
       card_line({0.0, weld.tension * newton, weld.shear * newton, weld.shear * newton, 0.0, 0.0, 0.0, 0.0});
  s += "*SECTION_BEAM\n$#   secid    elform      shrf        qr       cst\n" +
       fmt::format("{:10d}{:10d}{:10.1f}{:10d}{:10d}\n", 3, 9, 1.0, 2, 1) +
       "$#     ts1       ts2       tt1       tt2\n" + card_line({weld.diameter * mm, weld.diameter * mm, 0.0, 0.0});
  for (std::size_t k = 0; k < 2; ++k) {
    const double t = stack[weld.pair + k].thickness * mm;
    s += "*SECTION_SHELL\n$#   secid    elform      shrf       nip\n" +
         fmt::format("{:10d}{:10d}{:10.4f}{:10d}\n", static_cast<int>(k) + 1, 2, 0.8333, 5) +
         "$#      t1        t2        t3        t4\n" + card_line({t, t, t, t});
  }
  return s + "*END\n";
}

}  // namespace nugget::weld
