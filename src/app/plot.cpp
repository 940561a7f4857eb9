// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "app/command.hpp"
#include "app/commands.hpp"
#include "app/plotted_curves.hpp"
#include "report/channel_curves.hpp"
#include "report/picture_file.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;
using report::ChannelCurve;

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
  const std::vector<ChannelCurve> curves = plotted_curves(arguments);
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
