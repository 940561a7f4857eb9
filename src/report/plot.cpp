// SPDX-License-Identifier: Apache-2.0
#include "report/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nugget::report {
namespace {

constexpr double width = 720.0, height = 320.0, left = 78.0, right = 24.0, top = 12.0, bottom = 44.0;
constexpr std::size_t most_points = 400;
constexpr std::array<const char*, 8> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                             "#e69f00", "#56b4e9", "#8c564b", "#7f7f7f"};

/// A range of numbers, and the round ones on it.
struct Axis {
  double low = 0.0, high = 1.0;
  bool logarithmic = false;
  std::vector<double> marks;

  Axis(double from, double to, bool log) : logarithmic(log) { log ? by_decades(from, to) : by_steps(from, to); }
  double share(double value) const {
    return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  }
  bool shows(double value) const { return std::isfinite(value) && (!logarithmic || value >= low * (1.0 - 1e-9)); }

 private:
  void by_steps(double from, double to) {
    if (!(to > from)) to = from + (from == 0.0 ? 1.0 : std::abs(from));
    const double raw = (to - from) / 5.0, power = std::pow(10.0, std::floor(std::log10(raw)));
    double step = power;
    for (const double factor : {2.0, 5.0, 10.0})
      if (step < raw) step = factor * power;
    low = step * std::floor(from / step + 1e-9);
    high = step * std::ceil(to / step - 1e-9);
    const int steps = static_cast<int>(std::lround((high - low) / step));
    for (int i = 0; i <= steps; ++i) {
      const double value = low + i * step;
      marks.push_back(std::abs(value) < 1e-9 * step ? 0.0 : value);  // without the dust of its sum
    }
  }
  /// Ends at 1, 2 or 5 times a power of ten; marks there, at powers of ten only where there are many.
  void by_decades(double from, double to) {
    to = std::max(to, 1.1 * from);
    std::vector<double> round;
    for (int e = static_cast<int>(std::floor(std::log10(from))); std::pow(10.0, e) < 10.0 * to; ++e)
      for (const double factor : {1.0, 2.0, 5.0}) round.push_back(factor * std::pow(10.0, e));
    const auto first = std::upper_bound(round.begin(), round.end(), from * (1.0 + 1e-9)) - 1;
    const auto last = std::lower_bound(round.begin(), round.end(), to * (1.0 - 1e-9));
    low = *first;
    high = *last;
    const bool many = last - first > 9;
    for (auto mark = first; mark <= last; ++mark)
      if (!many || (mark - round.begin()) % 3 == 0) marks.push_back(*mark);
  }
};

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool empty() const { return !(low <= high); }
  void add(double value, bool logarithmic) {
    if (!std::isfinite(value) || (logarithmic && !(value > 0.0))) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

std::string label(double value) {
  return fmt::format("{:.4g}", value);
}

class Canvas {
 public:
  Canvas(const Axis& x, const Axis& y) : x_(x), y_(y) {}
  double px(double value) const { return left + (width - left - right) * x_.share(value); }
  double py(double value) const { return height - bottom - (height - top - bottom) * y_.share(value); }

  void grid(const Plot& plot) {
    for (const double x : x_.marks)
      text_ += fmt::format(
          "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\"/>"
          "<text x=\"{0:.1f}\" y=\"{3:.1f}\" text-anchor=\"middle\">{4}</text>\n",
          px(x), top, height - bottom, height - bottom + 16.0, label(x));
    for (const double y : y_.marks)
      text_ += fmt::format(
          "<line class=\"grid\" y1=\"{0:.1f}\" y2=\"{0:.1f}\" x1=\"{1:.1f}\" x2=\"{2:.1f}\"/>"
          "<text x=\"{3:.1f}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>\n",
          py(y), left, width - right, left - 6.0, py(y) + 4.0, label(y));
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                         0.5 * (left + width - right), height - 8.0, escaped(plot.abscissa));
    text_ += fmt::format("<text transform=\"translate(14 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                         0.5 * (top + height - bottom), escaped(plot.ordinate));
  }

  void curve(const std::vector<double>& x, const std::vector<double>& y, const char* colour) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (x_.shows(x[i]) && y_.shows(y[i])) kept.push_back(i);
    if (kept.size() < 2) return this->points(x, y, colour);  // a line of one point is not seen
    if (kept.size() > most_points) kept = outstanding(kept, x, y);
    std::string points;
    for (const std::size_t i : kept)
      points += fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ", px(x[i]), py(y[i]));
    text_ +=
        fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" points=\"{}\"/>\n", colour, points);
  }

  void points(const std::vector<double>& x, const std::vector<double>& y, const char* colour) {
    for (std::size_t i = 0; i < x.size(); ++i)
      if (x_.shows(x[i]) && y_.shows(y[i]))
        text_ +=
            fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\" fill=\"{}\"/>\n", px(x[i]), py(y[i]), colour);
  }

  std::string take() { return std::move(text_); }

 private:
  /// Of many points both ends, and the lowest and the highest of those that fall on the same few pixels.
  std::vector<std::size_t> outstanding(const std::vector<std::size_t>& points, const std::vector<double>& x,
                                       const std::vector<double>& y) const {
    const double column = 2.0 * (width - left - right) / static_cast<double>(most_points);
    std::vector<std::size_t> kept{points.front()};
    for (auto begin = points.begin(); begin != points.end();) {
      const double place = std::floor(px(x[*begin]) / column);
      const auto end =
          std::find_if(begin, points.end(), [&](std::size_t i) { return std::floor(px(x[i]) / column) != place; });
      const auto [low, high] =
          std::minmax_element(begin, end, [&](std::size_t i, std::size_t j) { return y[i] < y[j]; });
      kept.insert(kept.end(), {std::min(*low, *high), std::max(*low, *high)});
      begin = end;
    }
    kept.push_back(points.back());
    return kept;
  }

  Axis x_, y_;
  std::string text_;
};

}  // namespace

std::string number(double value) {
  return fmt::format("{:.6g}", value);
}

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

namespace {

/// Axes, curves and points; nothing where there is nothing to see. Names with their colours go to `legend`.
std::string drawing(const Plot& plot, std::vector<std::pair<std::string, const char*>>& legend) {
  constexpr double decades = 1e8;  // below the highest value nothing is of interest on a logarithmic axis
  Range x, y;
  for (const double value : plot.x) x.add(value, plot.log_x);
  for (const auto& [name, values] : plot.curves)
    for (const double value : values) y.add(value, plot.log_y);
  for (const Plot::Trace& trace : plot.traces) {
    for (const double value : trace.x) x.add(value, plot.log_x);
    for (const double value : trace.y) y.add(value, plot.log_y);
  }
  if ((plot.curves.empty() && plot.traces.empty()) || x.empty() || y.empty()) return {};
  if (plot.log_y)
    y.low = std::max(y.low, y.high / decades);
  else
    y.add(0.0, false);  // always in sight
  Canvas canvas(Axis(x.low, x.high, plot.log_x), Axis(y.low, y.high, plot.log_y));
  canvas.grid(plot);
  const auto next_colour = [&](const std::string& name) {
    legend.emplace_back(name, colours[legend.size() % colours.size()]);
    return legend.back().second;
  };
  for (const auto& [name, values] : plot.curves) canvas.curve(plot.x, values, next_colour(name));
  for (const Plot::Trace& trace : plot.traces) {
    const char* colour = next_colour(trace.name);
    trace.points ? canvas.points(trace.x, trace.y, colour) : canvas.curve(trace.x, trace.y, colour);
  }
  return canvas.take();
}

}  // namespace

std::string to_svg(const Plot& plot) {
  std::vector<std::pair<std::string, const char*>> names;
  const std::string drawn = drawing(plot, names);
  if (drawn.empty()) return {};
  std::string legend;
  for (const auto& [name, colour] : names)
    legend += fmt::format("<span><i style=\"background:{}\"></i>{}</span>", colour, escaped(name));
  return fmt::format(
      "<figure><svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" xmlns=\"http://www.w3.org/2000/svg\">\n{}</svg>\n"
      "<figcaption class=\"legend\">{}</figcaption></figure>\n",
      width, height, drawn, legend);
}

std::string to_svg_file(std::span<const Plot> plots) {
  constexpr double line = 16.0;
  std::string all;
  double down = 0.0;
  for (const Plot& plot : plots) {
    std::vector<std::pair<std::string, const char*>> names;
    all += fmt::format("<g transform=\"translate(0 {:.0f})\">\n{}", down, drawing(plot, names));
    for (std::size_t i = 0; i < names.size(); ++i) {
      const double y = height + line * static_cast<double>(i) + 4.0;
      all += fmt::format(
          "<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"14\" height=\"4\" fill=\"{}\"/><text x=\"{:.0f}\" "
          "y=\"{:.0f}\">{}</text>\n",
          left, y, names[i].second, left + 20.0, y + 6.0, escaped(names[i].first));
    }
    all += "</g>\n";
    down += height + line * static_cast<double>(names.size()) + 8.0;
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\">\n<style>text {{ font: 11px sans-serif; }} .grid {{ stroke: #ddd; }}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{2}</svg>\n",
      width, down, all);
}

}  // namespace nugget::report
