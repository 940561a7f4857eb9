// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "app/command.hpp"
#include "app/commands.hpp"
#include "base/sae_filter.hpp"
#include "report/channel_curves.hpp"
#include "report/picture_file.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;
using report::ChannelCurve;

/// What the patterns ask for, in their order. Throws std::runtime_error that says what there is where one finds
/// nothing.
std::vector<ChannelCurve> chosen_curves(const std::string& directory, const std::vector<std::string>& patterns) {
  const std::vector<ChannelCurve> all = report::read_channel_curves(directory);
  std::vector<ChannelCurve> chosen;
  for (const std::string& pattern : patterns) {
    const std::vector<const ChannelCurve*> found = report::matching(all, pattern);
    if (found.empty()) {
      std::vector<ChannelCurve> of_file;
      for (const ChannelCurve* curve : report::matching(all, pattern.substr(0, pattern.find('/'))))
        of_file.push_back(*curve);
      throw std::runtime_error(fmt::format("{} has no channel '{}', expected FILE/ENTITY/QUANTITY of these:\n{}",
                                           directory, pattern, report::listed(of_file.empty() ? all : of_file)));
    }
    for (const ChannelCurve* curve : found) chosen.push_back(*curve);
  }
  return chosen;
}

void filter_curves(const PlotArguments& arguments, const std::string& directory, std::vector<ChannelCurve>& curves) {
  const std::optional<double> second = report::second_of(directory);
  if (!second)
    throw std::runtime_error(
        fmt::format("--cfc: the units of {} are not known, so that nothing says how long a second is", directory));
  for (ChannelCurve& curve : curves) {
    if (curve.over_frequency) throw std::runtime_error(fmt::format("--cfc: {} is no history over time", curve.name()));
    try {
      TimeHistory filtered = sae_filtered(curve.x, curve.y, arguments.channel_class, *second);
      curve.x = std::move(filtered.times);
      curve.y = std::move(filtered.values);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("{}: {}", curve.name(), error.what()));
    }
  }
}

/// The value of a channel at another time, on straight lines between its samples; its first and last beyond them.
double value_at(const ChannelCurve& curve, double x) {
  const auto after = std::lower_bound(curve.x.begin(), curve.x.end(), x);
  const auto i = static_cast<std::size_t>(after - curve.x.begin());
  if (i == 0) return curve.y.front();
  if (i == curve.x.size()) return curve.y.back();
  const double share = (x - curve.x[i - 1]) / (curve.x[i] - curve.x[i - 1]);
  return curve.y[i - 1] + share * (curve.y[i] - curve.y[i - 1]);
}

/// The curves over another channel instead of over time: force over displacement.
void put_over(const ChannelCurve& other, std::vector<ChannelCurve>& curves) {
  for (ChannelCurve& curve : curves) {
    for (double& x : curve.x) x = value_at(other, x);
    curve.abscissa = other.name() + (other.unit.empty() ? std::string() : fmt::format(" [{}]", other.unit.substr(1)));
  }
}

std::vector<ChannelCurve> curves_of(const PlotArguments& arguments, const std::string& directory) {
  std::vector<ChannelCurve> curves = chosen_curves(directory, arguments.channels);
  if (arguments.channel_class != 0) filter_curves(arguments, directory, curves);
  if (arguments.over.empty()) return curves;
  const std::vector<ChannelCurve> other = chosen_curves(directory, {arguments.over});
  if (other.size() > 1)
    throw std::runtime_error(
        fmt::format("--over {}: {} channels, expected one:\n{}", arguments.over, other.size(), report::listed(other)));
  for (const ChannelCurve& curve : curves)
    if (curve.over_frequency != other[0].over_frequency)
      throw std::runtime_error(
          fmt::format("--over {}: one of both is over time, {} is not", arguments.over, curve.name()));
  put_over(other[0], curves);
  return curves;
}

/// A line for each curve: where it is lowest and highest, and how it ends.
void print_extremes(const std::vector<ChannelCurve>& curves) {
  std::size_t width = 7;
  for (const ChannelCurve& curve : curves) width = std::max(width, curve.name().size() + curve.unit.size());
  fmt::print("{:<{}}  {:>12} {:>12}  {:>12} {:>12}  {:>12}\n", "channel", width, "lowest", "at", "highest", "at",
             "last");
  for (const ChannelCurve& curve : curves) {
    const auto [low, high] = std::minmax_element(curve.y.begin(), curve.y.end());
    const auto x_at = [&](auto value) { return curve.x[static_cast<std::size_t>(value - curve.y.begin())]; };
    fmt::print("{:<{}}  {:>12.6g} {:>12.6g}  {:>12.6g} {:>12.6g}  {:>12.6g}\n", curve.name() + curve.unit, width, *low,
               x_at(low), *high, x_at(high), curve.y.back());
  }
}

ExitCode draw_plot(const PlotArguments& arguments) {
  if (arguments.channels.empty()) {
    fmt::print("{}", report::listed(report::read_channel_curves(arguments.directory)));
    return ExitCode::normal;
  }
  std::vector<ChannelCurve> curves = curves_of(arguments, arguments.directory);
  if (!arguments.other.empty())
    for (ChannelCurve& curve : curves_of(arguments, arguments.other)) {
      curve.file = fmt::format("{}: {}", arguments.other, curve.file);
      curves.push_back(std::move(curve));
    }
  print_extremes(curves);
  if (arguments.picture.empty()) return ExitCode::normal;
  const fs::path file(arguments.picture);
  return guarded(file.has_parent_path() ? file.parent_path().string() : ".", [&](const fs::path&) {
    report::write_picture(file, report::to_svg_file(report::plots_of(curves)), arguments.width);
    return ExitCode::normal;
  });
}

}  // namespace

ExitCode plot(const PlotArguments& arguments) {
  try {
    return draw_plot(arguments);
  } catch (const std::runtime_error& error) {
    fmt::print(stderr, "nugget: {}\n", error.what());
    return ExitCode::wrong_command;
  }
}

}  // namespace nugget::app
