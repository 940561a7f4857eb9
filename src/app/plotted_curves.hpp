// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/commands.hpp"
#include "report/channel_curves.hpp"

namespace nugget::app {

/// The curves that a plot shows: the channels asked for, filtered and over another channel where that is asked, then
/// those of the other run. Throws std::runtime_error that says what there is where a name finds nothing.
std::vector<report::ChannelCurve> plotted_curves(const PlotArguments& arguments);

}  // namespace nugget::app
