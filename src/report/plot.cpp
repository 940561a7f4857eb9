// SPDX-License-Identifier: Apache-2.0
#include "report/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nugget::report {
namespace {

constexpr double width = 720.0, height = 320.0, left = 78.0, right = 12.0, top = 12.0, bottom = 44.0;
constexpr std::size_t most_points = 400;
constexpr std::array<const char*, 8> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                             "#e69f00", "#56b4e9", "#8c564b", "#7f7f7f"};

/// A range of numbers and the round steps that divide it.
struct Axis {
  double low = 0.0, high = 1.0, step = 0.2;

  Axis(double from, double to) {
    if (!(to > from)) to = from + (from == 0.0 ? 1.0 : std::abs(from));
    const double raw = (to - from) / 5.0, power = std::pow(10.0, std::floor(std::log10(raw)));
    step = power;
    for (const double factor : {2.0, 5.0, 10.0})
      if (step < raw) step = factor * power;
    low = step * std::floor(from / step + 1e-9);
    high = step * std::ceil(to / step - 1e-9);
  }
  double share(double value) const { return (value - low) / (high - low); }
  int steps() const { return static_cast<int>(std::lround((high - low) / step)); }
  /// Number on the axis, without the dust of its sum.
  double at(int i) const {
    const double value = low + i * step;
    return std::abs(value) < 1e-9 * step ? 0.0 : value;
  }
};

std::string number(double value) {
  return fmt::format("{:.4g}", value);
}

class Canvas {
 public:
  Canvas(const Axis& x, const Axis& y) : x_(x), y_(y) {}
  double px(double value) const { return left + (width - left - right) * x_.share(value); }
  double py(double value) const { return height - bottom - (height - top - bottom) * y_.share(value); }

  void grid(const Plot& plot) {
    for (int i = 0; i <= x_.steps(); ++i)
      text_ += fmt::format(
          "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\"/>"
          "<text x=\"{0:.1f}\" y=\"{3:.1f}\" text-anchor=\"middle\">{4}</text>\n",
          px(x_.at(i)), top, height - bottom, height - bottom + 16.0, number(x_.at(i)));
    for (int i = 0; i <= y_.steps(); ++i)
      text_ += fmt::format(
          "<line class=\"grid\" y1=\"{0:.1f}\" y2=\"{0:.1f}\" x1=\"{1:.1f}\" x2=\"{2:.1f}\"/>"
          "<text x=\"{3:.1f}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>\n",
          py(y_.at(i)), left, width - right, left - 6.0, py(y_.at(i)) + 4.0, number(y_.at(i)));
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                         0.5 * (left + width - right), height - 8.0, escaped(plot.abscissa));
    text_ += fmt::format("<text transform=\"translate(14 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                         0.5 * (top + height - bottom), escaped(plot.ordinate));
  }

  void curve(const std::vector<double>& x, const std::vector<double>& y, const char* colour) {
    const std::size_t stride = std::max<std::size_t>(1, x.size() / most_points);
    std::string points;
    for (std::size_t i = 0; i < x.size(); ++i)
      if ((i % stride == 0 || i + 1 == x.size()) && std::isfinite(y[i]))
        points += fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ", px(x[i]), py(y[i]));
    text_ +=
        fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" points=\"{}\"/>\n", colour, points);
  }

  std::string take() { return std::move(text_); }

 private:
  Axis x_, y_;
  std::string text_;
};

}  // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  return out;
}

std::string to_svg(const Plot& plot) {
  if (plot.x.empty() || plot.curves.empty()) return {};
  double low = 0.0, high = 0.0;  // zero is always in sight
  for (const auto& [name, values] : plot.curves)
    for (const double value : values)
      if (std::isfinite(value)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
  const auto [first, last] = std::minmax_element(plot.x.begin(), plot.x.end());
  Canvas canvas(Axis(*first, *last), Axis(low, high));
  canvas.grid(plot);
  std::string legend;
  for (std::size_t c = 0; c < plot.curves.size(); ++c) {
    const char* colour = colours[c % colours.size()];
    canvas.curve(plot.x, plot.curves[c].second, colour);
    legend += fmt::format("<span><i style=\"background:{}\"></i>{}</span>", colour, escaped(plot.curves[c].first));
  }
  return fmt::format(
      "<figure><svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" xmlns=\"http://www.w3.org/2000/svg\">\n{}</svg>\n"
      "<figcaption class=\"legend\">{}</figcaption></figure>\n",
      width, height, canvas.take(), legend);
}

}  // namespace nugget::report
