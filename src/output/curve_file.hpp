// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace nugget::output {

/// A curve over frequency; as many ordinates as abscissae.
struct XyCurve {
  std::string name;
  std::vector<double> x, y;
};

/// One of LS-DYNA's ASCII files for xy-plots, in the curve format of LS-PrePost. A curve without points is left out.
/// Throws WriteError.
void write_curve_file(const std::filesystem::path& path, const std::string& title, const char* ordinate,
                      const std::vector<XyCurve>& curves);

}  // namespace nugget::output
