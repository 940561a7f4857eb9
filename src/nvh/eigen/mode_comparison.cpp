// SPDX-License-Identifier: Apache-2.0
#include "nvh/eigen/mode_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "nvh/eigen/mode_files.hpp"
#include "output/result_file.hpp"

namespace nugget::nvh {
namespace {

double size_of(const std::vector<Vec3d>& x) {
  Vec3d low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (const Vec3d& p : x) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return x.empty() ? 0.0 : norm(high - low);
}

/// Points in the order of x.
class Places {
 public:
  explicit Places(const std::vector<Vec3d>& x) : x_(x), order_(x.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return x[a].x < x[b].x; });
  }
  /// The nearest one within a distance, or their number.
  std::size_t nearest(const Vec3d& p, double dof_map) const {
    const auto before = [&](std::size_t i, double value) { return x_[i].x < value; };
    std::size_t best = x_.size();
    for (auto i = std::lower_bound(order_.begin(), order_.end(), p.x - dof_map, before);
         i != order_.end() && x_[*i].x <= p.x + dof_map; ++i)
      if (const double away = norm(x_[*i] - p); away <= dof_map) {
        if (away < dof_map || best == x_.size()) best = *i;
        dof_map = away;
      }
    return best;
  }

 private:
  const std::vector<Vec3d>& x_;
  std::vector<std::size_t> order_;
};

Columns only(const Columns& shapes, const std::vector<std::size_t>& nodes) {
  Columns kept(3 * nodes.size(), shapes.count);
  for (std::size_t j = 0; j < shapes.count; ++j)
    for (std::size_t n = 0; n < nodes.size(); ++n)
      for (std::size_t i = 0; i < 3; ++i) kept[j][3 * n + i] = shapes[j][3 * nodes[n] + i];
  return kept;
}

}  // namespace

ModeComparison compare(const Matrices& m, const Modes& modes, const ShapeFile& other) {
  ModeComparison c;
  const std::vector<Vec3d>& x = m.system.ties.x;
  const double near = 1e-3 * size_of(x);
  const Places places(other.x);
  std::vector<std::size_t> here, there;
  for (std::size_t n = 0; n < x.size(); ++n) {
    const int id = m.system.model.nodes.id[n];
    const auto found = std::lower_bound(other.node.begin(), other.node.end(), id);
    auto k = static_cast<std::size_t>(found - other.node.begin());
    const bool same = found != other.node.end() && *found == id && norm(other.x[k] - x[n]) <= near;
    if (!same) k = places.nearest(x[n], near);
    if (k == other.x.size()) {
      ++c.absent;
      continue;
    }
    c.renumbered += !same;
    here.push_back(n);
    there.push_back(k);
  }
  c.nodes = here.size();
  c.frequency = other.frequency;
  c.mac = compute_mac(only(nodal_shapes(m, modes), here), only(other.shape, there));
  c.partner = partners(c.mac);
  return c;
}

void write_mac(const std::filesystem::path& directory, const Modes& modes, const ModeComparison& c) {
  std::string text = "mode,frequency";
  for (std::size_t j = 0; j < c.frequency.size(); ++j) text += fmt::format(",other {}", j + 1);
  text += "\n,";
  for (const double f : c.frequency) text += fmt::format(",{:.9g}", f);
  for (std::size_t i = 0; i < c.mac.count; ++i) {
    text += fmt::format("\n{},{:.9g}", i + 1, modes.frequency(i));
    for (const double value : c.mac[i]) text += fmt::format(",{:.6f}", value);
  }
  output::write_whole_file(directory / "mac.csv", text + '\n');
}

}  // namespace nugget::nvh
