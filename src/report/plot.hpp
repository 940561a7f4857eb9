// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace nugget::report {

/// Curves over one abscissa.
struct Plot {
  std::string abscissa, ordinate;  ///< names of the axes
  std::vector<double> x;
  std::vector<std::pair<std::string, std::vector<double>>> curves;  ///< name, a value for each x
  bool log_x = false, log_y = false;  ///< logarithmic axes; what is not above 0 is not shown there
  /// A curve, or points, with abscissas of its own.
  struct Trace {
    std::string name;
    std::vector<double> x, y;
    bool points = false;
  };
  std::vector<Trace> traces{};
};

/// The plot as an <svg> element that needs nothing else: axes with round numbers, a legend, at most some hundred points
/// a curve, peaks among them. Empty without points. Colours follow the page's (currentColor for lines and text).
std::string to_svg(const Plot& plot);

/// Plots below each other as a file of its own, their legends in the picture; black on white.
std::string to_svg_file(std::span<const Plot> plots);

/// A number in six digits, as the page shows it.
std::string number(double value);

/// Text with what HTML and SVG take for markup replaced.
std::string escaped(const std::string& text);

}  // namespace nugget::report
