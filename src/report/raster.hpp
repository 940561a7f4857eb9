// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace nugget::report {

/// Red, green, blue from 0 to 255.
using Colour = std::array<double, 3>;

/// A point of a picture: pixels to the right and down, and how near it is to the eye.
struct PicturePoint {
  double u = 0.0, v = 0.0, near = 0.0;
};

/// Triangles and lines seen from one side: each pixel keeps the mark of what is nearest to the eye there.
class Raster {
 public:
  using Mark = std::uint32_t;
  static constexpr Mark nothing = 0;

  Raster(int width, int height);

  void triangle(const std::array<PicturePoint, 3>& corners, Mark mark);
  /// A line one pixel wide, where nothing is nearer by more than `slack`.
  void line(const PicturePoint& a, const PicturePoint& b, double slack, Mark mark);
  /// Whether something is nearer there by more than `slack`.
  bool hides(const PicturePoint& point, double slack) const;
  /// Mark of each pixel, row by row.
  const std::vector<Mark>& marks() const { return marks_; }

  /// Half as wide and high, each pixel the mean of four: ARGB, transparent where nothing is; the colour is the mean of
  /// what is there. Mark m has the colour of place m in `palette`.
  std::vector<std::uint32_t> halved(const std::vector<Colour>& palette) const;

 private:
  std::size_t place(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(u);
  }

  int width_, height_;
  std::vector<float> near_;  // minus infinity where nothing is
  std::vector<Mark> marks_;
};

}  // namespace nugget::report
