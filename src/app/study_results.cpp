// SPDX-License-Identifier: Apache-2.0
#include "app/study_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "app/plotted_curves.hpp"
#include "deck/text.hpp"
#include "report/quantity.hpp"
#include "report/response_page.hpp"
#include "report/run_data.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;
using How = ResultRequest::How;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t frequencies_shown = 5;
constexpr auto hows = std::to_array<std::pair<const char*, How>>(
    {{"peak", How::peak}, {"max", How::max}, {"min", How::min}, {"last", How::last}, {"mean", How::mean}});

std::string words_of(How how) {
  switch (how) {
    case How::peak: return "value of largest size";
    case How::max: return "largest value";
    case How::min: return "smallest value";
    case How::last: return "last value";
    case How::mean: return "mean over its abscissa";
  }
  return {};
}

/// By the trapezoidal rule: samples need not be equally far apart.
double mean(const report::ChannelCurve& curve) {
  double sum = 0.0;
  for (std::size_t i = 1; i < curve.x.size(); ++i)
    sum += 0.5 * (curve.y[i] + curve.y[i - 1]) * (curve.x[i] - curve.x[i - 1]);
  const double length = curve.x.back() - curve.x.front();
  return length > 0.0 ? sum / length : curve.y.front();
}

double value_of(const report::ChannelCurve& curve, How how) {
  const auto [low, high] = std::minmax_element(curve.y.begin(), curve.y.end());
  switch (how) {
    case How::peak: return std::abs(*low) > std::abs(*high) ? *low : *high;
    case How::max: return *high;
    case How::min: return *low;
    case How::last: return curve.y.back();
    case How::mean: return mean(curve);
  }
  return unknown;
}

/// Column by column; a column comes into being with its first value.
class Gathering {
 public:
  explicit Gathering(report::Study& study) : study_(study) {}

  void put(std::size_t run, const std::string& name, const std::string& quantity, const std::string& unit,
           double value) {
    auto column = std::find_if(study_.results.begin(), study_.results.end(),
                               [&](const report::Study::Result& r) { return r.name == name; });
    if (column == study_.results.end())
      column = study_.results.insert(study_.results.end(),
                                     {name, quantity, unit, std::vector<double>(study_.runs.size(), unknown)});
    column->values[run] = value;
  }

  void put_impact(std::size_t run, const report::RunData& data) {
    const nlohmann::json& energy = data.summary.at("energy");
    put(run, "internal energy", "internal energy at the end", report::unit_of(data.summary, dimension::energy),
        energy.value("internal", unknown));
    put(run, "energy ratio", "energy at the end over what there was and came in", {}, energy.value("ratio", unknown));
    if (data.welds.empty()) return;
    double failed = 0.0, first = unknown;
    for (const report::WeldRow& weld : data.welds) {
      if (weld.at("failed") != "yes") continue;
      failed += 1.0;
      const std::string& time = weld.at("failure_time");
      if (!time.empty()) first = std::fmin(first, std::strtod(time.c_str(), nullptr));
    }
    put(run, "welds failed", "number of welds that failed", {}, failed);
    put(run, "first failure", "time at which the first weld failed", report::unit_of(data.summary, dimension::time),
        first);
  }

  void put_frequencies(std::size_t run, const report::RunData& data) {
    const nlohmann::json modes = data.summary.value("modes", nlohmann::json::array());
    const std::size_t rigid = modes.empty() ? 0 : report::rigid_modes(modes);
    for (std::size_t i = rigid; i < std::min(modes.size(), rigid + frequencies_shown); ++i)
      put(run, fmt::format("frequency {}", i - rigid + 1), "natural frequency, rigid motions left out",
          report::frequency_unit(data.summary), modes[i].value("frequency_hz", unknown));
  }

 private:
  report::Study& study_;
};

}  // namespace

std::optional<ResultRequest> read_result_request(const std::string& text, std::string& why) {
  ResultRequest request;
  const std::size_t equals = text.find('='), colon = text.rfind(':');
  const std::size_t begin = equals == text.npos ? 0 : equals + 1;
  const std::size_t end = colon == text.npos || colon < begin ? text.size() : colon;
  request.channel = deck::trimmed(text.substr(begin, end - begin));
  request.name = deck::trimmed(equals == text.npos ? text : text.substr(0, equals));
  if (end < text.size()) {
    const std::string how = text.substr(end + 1);
    const auto found = std::find_if(hows.begin(), hows.end(), [&](const auto& known) { return how == known.first; });
    if (found == hows.end()) {
      why = fmt::format("'{}', expected peak, max, min, last or mean behind the colon", text);
      return {};
    }
    request.how = found->second;
  }
  if (request.channel.empty() || request.name.empty() || request.name.find_first_of(",\"\n") != request.name.npos) {
    why = fmt::format("'{}', expected [NAME =] CHANNEL[:peak|max|min|last|mean], a channel as of nugget plot", text);
    return {};
  }
  return request;
}

std::vector<std::string> gather_results(const std::string& directory, const std::vector<ResultRequest>& requests,
                                        int channel_class, report::Study& study) {
  Gathering gathering(study);
  std::vector<std::string> faults;
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    if (study.runs[i].exit_code != 0) continue;
    const std::string folder = (fs::path(directory) / study.runs[i].name).string();
    try {
      const report::RunData data = report::read_run(folder);
      study.units = data.summary.value("units", "");
      study.title = data.summary.value("title", "");
      if (report::of_linear_analysis(data.summary))
        gathering.put_frequencies(i, data);
      else
        gathering.put_impact(i, data);
      for (const ResultRequest& request : requests) {
        PlotArguments plot;
        plot.directory = folder;
        plot.channels = {request.channel};
        plot.channel_class = channel_class;
        const std::vector<report::ChannelCurve> curves = plotted_curves(plot);
        if (curves.size() > 1)
          throw std::runtime_error(fmt::format("result: {}: {} channels, expected one:\n{}", request.channel,
                                               curves.size(), report::listed(curves)));
        gathering.put(i, request.name, fmt::format("{}: {}", curves[0].name(), words_of(request.how)), curves[0].unit,
                      value_of(curves[0], request.how));
      }
    } catch (const std::runtime_error& error) {
      faults.emplace_back(error.what());
    }
  }
  return faults;
}

}  // namespace nugget::app
