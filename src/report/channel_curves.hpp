// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/plot.hpp"

namespace nugget::report {

/// A curve of a run: a channel of a history over time, or a response over frequency.
struct ChannelCurve {
  std::string file;      ///< `swforc`, `frf`
  std::string entity;    ///< `weld 50002`; empty where the file is of the whole model
  std::string title;     ///< of the entity
  std::string quantity;  ///< `axial`
  std::string unit;      ///< ` N`, as unit_of() gives it; empty where the units are not known
  std::string abscissa;  ///< `time [s]`, `frequency [Hz]`
  bool over_frequency = false;
  std::optional<double> second;  ///< one second in the unit of time; nothing where the units are not known
  std::vector<double> x, y;

  std::string name() const;  ///< `swforc/weld 50002/axial`
};

/// The curves of a run in a folder: histories (output::read_histories) and the responses frf, ssd and erp. Throws
/// std::runtime_error where there is no run.
std::vector<ChannelCurve> read_channel_curves(const std::filesystem::path& directory);

/// Those that a pattern asks for: FILE, FILE/QUANTITY, FILE/ENTITY or FILE/ENTITY/QUANTITY, where ENTITY is its id, its
/// name (`weld 50002`) or its title; each with the wildcards `*`, `?`, `[...]`, in small or capital letters alike.
std::vector<const ChannelCurve*> matching(const std::vector<ChannelCurve>& curves, const std::string& pattern);

/// A list of what there is, file by file: entities, quantities with units, the range of the abscissa.
std::string listed(const std::vector<ChannelCurve>& curves);

/// Curves of one unit and abscissa in one plot, the others each in their own. Responses have logarithmic axes.
std::vector<Plot> plots_of(const std::vector<ChannelCurve>& curves);

}  // namespace nugget::report
