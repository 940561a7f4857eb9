// SPDX-License-Identifier: Apache-2.0
#include "contact/couple.hpp"

namespace nugget::contact {

std::array<Vec3d, 4> couple(std::span<const int> nodes, const Vec3d& moment, std::span<const Row> x) {
  Vec3d middle;
  for (const int n : nodes) middle += (1.0 / static_cast<double>(nodes.size())) * vec(x[n]);
  // J theta = moment with J = sum of r^2 - r r^T.
  double size = 0.0;
  std::array<Vec3d, 3> row{};
  for (const int n : nodes) {
    const Vec3d r = vec(x[n]) - middle;
    size += dot(r, r);
    row[0] -= r.x * r;
    row[1] -= r.y * r;
    row[2] -= r.z * r;
  }
  row[0].x += size;
  row[1].y += size;
  row[2].z += size;
  Vec3d theta;
  if (nodes.size() == 2) {  // J is size but along the bar, where it is 0
    const Vec3d axis = vec(x[nodes[1]]) - vec(x[nodes[0]]);
    if (size > 0.0) theta = (1.0 / size) * (moment - (dot(moment, axis) / dot(axis, axis)) * axis);
  } else {
    const double determinant = dot(row[0], cross(row[1], row[2]));
    if (determinant > 1e-12 * size * size * size)
      theta = (1.0 / determinant) *
              (moment.x * cross(row[1], row[2]) + moment.y * cross(row[2], row[0]) + moment.z * cross(row[0], row[1]));
  }
  std::array<Vec3d, 4> forces;
  for (std::size_t i = 0; i < nodes.size(); ++i) forces[i] = cross(theta, vec(x[nodes[i]]) - middle);
  return forces;
}

}  // namespace nugget::contact
