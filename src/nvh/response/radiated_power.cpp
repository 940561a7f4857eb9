// SPDX-License-Identifier: Apache-2.0
#include "nvh/response/radiated_power.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "nvh/response/frequencies.hpp"
#include "nvh/response/frequency_response.hpp"
#include "nvh/response/response_states.hpp"
#include "output/curve_file.hpp"
#include "output/result_file.hpp"

namespace nugget::nvh {
namespace {

using Complex = std::complex<double>;
using Velocity = std::array<Complex, 3>;

/// |v n|^2 of shape functions' sum, n of any length.
double squared(std::span<const double, 4> share, std::span<const Velocity, 4> v, const Vec3d& n) {
  Complex sum = 0.0;
  for (std::size_t a = 0; a < 4; ++a) sum += share[a] * (v[a][0] * n.x + v[a][1] * n.y + v[a][2] * n.z);
  return std::norm(sum);
}

/// The vector of the area, for a unit of both coordinates, where the shape functions have these derivatives.
Vec3d normal(std::span<const Vec3d, 4> x, std::span<const double, 4> along, std::span<const double, 4> across) {
  Vec3d r{}, s{};
  for (std::size_t a = 0; a < 4; ++a) {
    r += along[a] * x[a];
    s += across[a] * x[a];
  }
  return cross(r, s);
}

/// Calls with the shares of the corners and the vector of the area of each point of integration.
template <class Visit>
void each_point(std::span<const Vec3d, 4> x, Visit visit) {
  if (norm(x[3] - x[2]) == 0.0) {  // a triangle
    constexpr std::array<std::array<double, 4>, 3> middle{{{0.5, 0.5, 0, 0}, {0, 0.5, 0.5, 0}, {0.5, 0, 0.5, 0}}};
    const Vec3d area = (1.0 / 6.0) * cross(x[1] - x[0], x[2] - x[0]);
    for (const std::array<double, 4>& share : middle) visit(share, area);
    return;
  }
  constexpr std::array<double, 4> r{-1.0, 1.0, 1.0, -1.0}, s{-1.0, -1.0, 1.0, 1.0};
  const double gauss = 1.0 / std::sqrt(3.0);
  for (std::size_t p = 0; p < 4; ++p) {
    std::array<double, 4> share{}, along{}, across{};
    for (std::size_t a = 0; a < 4; ++a) {
      const double one = 1.0 + gauss * r[p] * r[a], other = 1.0 + gauss * s[p] * s[a];
      share[a] = 0.25 * one * other;
      along[a] = 0.25 * r[a] * other;
      across[a] = 0.25 * s[a] * one;
    }
    visit(share, normal(x, along, across));
  }
}

std::array<Vec3d, 4> corners(const Matrices& m, const model::Segment& segment) {
  std::array<Vec3d, 4> x;
  for (std::size_t a = 0; a < 4; ++a) x[a] = m.system.ties.x[segment[a]];
  return x;
}

double area(std::span<const Vec3d, 4> x) {
  double sum = 0.0;
  each_point(x, [&](const std::array<double, 4>&, const Vec3d& a) { sum += norm(a); });
  return sum;
}

double loss_factor(const model::Model& model, const model::SteadyState::RadiatedPower& p, double frequency) {
  return p.loss_curve == model::none ? p.loss_factor : model.curves[p.loss_curve].clamped(frequency);
}

}  // namespace

double square_of_normal_velocity(std::span<const Vec3d, 4> x, std::span<const Velocity, 4> v) {
  double sum = 0.0;
  each_point(x, [&](const std::array<double, 4>& share, const Vec3d& a) {
    if (const double size = norm(a); size > 0.0) sum += squared(share, v, a) / size;
  });
  return sum;
}

RadiatedPower radiated_power(const Matrices& m, const Modes& modes, const model::SteadyState& request,
                             const ProgressCallback& progress) {
  const model::SteadyState::RadiatedPower& wanted = *request.radiated_power;
  model::SteadyState absolute = request;
  absolute.relative = false;
  RadiatedPower result;
  result.frequency = frequencies(request.frequencies_of_power(), modes);
  for (const auto& panel : wanted.panels) {
    result.panels.push_back({panel.name, 0.0, {}});
    for (const model::Segment& s : panel.segments) result.panels.back().area += area(corners(m, s));
  }
  const auto add = [&](const MotionAt& now) {
    const Complex rate(0.0, 2.0 * std::numbers::pi * now.frequency);
    const double factor =
        0.5 * wanted.density * wanted.sound_speed * loss_factor(m.system.model, wanted, now.frequency);
    for (std::size_t p = 0; p < wanted.panels.size(); ++p) {
      double sum = 0.0;
      for (const model::Segment& s : wanted.panels[p].segments) {
        std::array<Velocity, 4> v;
        for (std::size_t a = 0; a < 4; ++a)
          for (std::size_t i = 0; i < 3; ++i) v[a][i] = rate * now.u[s[a]][i];
        sum += square_of_normal_velocity(corners(m, s), v);
      }
      result.panels[p].power.push_back(factor * sum);
    }
  };
  each_motion(m, modes, absolute, absolute.cases.front(), result.frequency, add, progress);
  if (result.panels.size() < 2) return result;
  RadiatedPower::Panel all{"all", 0.0, std::vector<double>(result.frequency.size(), 0.0)};
  for (const RadiatedPower::Panel& panel : result.panels) {
    all.area += panel.area;
    for (std::size_t k = 0; k < all.power.size(); ++k) all.power[k] += panel.power[k];
  }
  result.panels.push_back(std::move(all));
  return result;
}

double decibels(double power, double reference) {
  return 10.0 * std::log10(power / reference);
}

void write_radiated_power(const std::filesystem::path& directory, const output::Header& header,
                          const model::SteadyState& request, const RadiatedPower& result) {
  const double reference = request.radiated_power->reference;
  std::string text = "panel,frequency,power,decibels\n";
  std::vector<output::XyCurve> absolute, logarithmic;
  for (const RadiatedPower::Panel& panel : result.panels) {
    absolute.push_back({"ERP-" + panel.name, {}, {}});
    logarithmic.push_back(absolute.back());
    for (std::size_t k = 0; k < result.frequency.size(); ++k) {
      const double f = result.frequency[k], power = panel.power[k],
                   level = reference > 0.0 ? decibels(power, reference) : std::nan("");
      text += fmt::format("{},{:.9g},{},{}\n", panel.name, f, cell(power), cell(level));
      const auto add = [&](output::XyCurve& curve, double value) {
        if (!std::isfinite(value)) return;
        curve.x.push_back(f);
        curve.y.push_back(value);
      };
      add(absolute.back(), power);
      add(logarithmic.back(), level);
    }
  }
  output::write_whole_file(directory / "erp.csv", text);
  output::write_curve_file(directory / "ERP_abs", header.title, "Equivalent radiated power", absolute);
  if (reference > 0.0) output::write_curve_file(directory / "ERP_dB", header.title, "ERP [dB]", logarithmic);
}

}  // namespace nugget::nvh
