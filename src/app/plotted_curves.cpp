// SPDX-License-Identifier: Apache-2.0
#include "app/plotted_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/sae_filter.hpp"

namespace nugget::app {
namespace {

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

void filter_curves(int channel_class, std::vector<ChannelCurve>& curves) {
  for (ChannelCurve& curve : curves) {
    if (curve.over_frequency) throw std::runtime_error(fmt::format("--cfc: {} is no history over time", curve.name()));
    if (!curve.second)
      throw std::runtime_error(
          fmt::format("--cfc: {}: the units of the deck are not known, so that nothing says how long a second is "
                      "[run it again with --units]",
                      curve.name()));
    try {
      TimeHistory filtered = sae_filtered(curve.x, curve.y, channel_class, *curve.second);
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
  if (arguments.channel_class != 0) filter_curves(arguments.channel_class, curves);
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

}  // namespace

std::vector<ChannelCurve> plotted_curves(const PlotArguments& arguments) {
  std::vector<ChannelCurve> curves = curves_of(arguments, arguments.directory);
  if (arguments.other.empty()) return curves;
  for (ChannelCurve& curve : curves_of(arguments, arguments.other)) {
    curve.file = fmt::format("{}: {}", arguments.other, curve.file);
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace nugget::app
