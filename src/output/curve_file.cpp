// SPDX-License-Identifier: Apache-2.0
#include "output/curve_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "output/ascii.hpp"
#include "output/result_file.hpp"

namespace nugget::output {

void write_curve_file(const std::filesystem::path& path, const std::string& title, const char* ordinate,
                      const std::vector<XyCurve>& curves) {
  std::string text = fmt::format("Curveplot\n{}\nFrequency\n{}\n", title, ordinate);
  for (const XyCurve& curve : curves) {
    const std::vector<double>&x = curve.x, &y = curve.y;
    if (y.empty()) continue;
    const auto low = std::ranges::min_element(y), high = std::ranges::max_element(y);
    const auto abscissa = [&](auto place) { return x[place - y.begin()]; };
    text += fmt::format("{} #pts={:>5}\n* Minval= {:14.7E} at time= {:14.7E}\n* Maxval= {:14.7E} at time= {:14.7E}\n",
                        curve.name, y.size(), *low, abscissa(low), *high, abscissa(high));
    for (std::size_t k = 0; k < y.size(); ++k) text += fmt::format(" {:14.7E} {:14.7E}\n", x[k], column(y[k]));
    text += "endcurve\n";
  }
  write_whole_file(path, text);
}

}  // namespace nugget::output
