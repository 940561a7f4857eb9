// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "base/vec3.hpp"

namespace nugget::kernel {

/// How the material axes a, b, c of an element lie at the start (AOPT); from then on they turn with it.
struct MaterialAxes {
  enum class By {
    nodes,    ///< AOPT 0: a along nodes 1-2, c normal to 1-2 and 1-4 (in shells: to the element)
    vectors,  ///< AOPT 2: a and d, c = a x d; in shells a as seen along the normal
    cross     ///< AOPT 3: a = v x normal, in bricks that of the surface midway between the first and last four nodes
  };
  By by = By::nodes;
  Vec3d a, d;          ///< vectors of AOPT 2; `a` is v of AOPT 3
  double angle = 0.0;  ///< BETA: of AOPT 0 and 3 in shells, turns a about the normal [rad]

  /// Direction a in the plane of a shell with unit normal `normal`: not of unit length; zero where the vector that
  /// gives it stands along the normal. `along`: from node 1 to node 2; `own`: the element's BETA, if it has one [rad].
  Vec3d in_shell(const Vec3d& along, const Vec3d& normal, std::optional<double> own) const {
    Vec3d seen = by == By::cross ? cross(a, normal) : by == By::vectors ? a : along;
    seen -= dot(seen, normal) * normal;
    if (by == By::vectors) return seen;
    const double beta = own.value_or(angle);
    return std::cos(beta) * seen + std::sin(beta) * cross(normal, seen);
  }
  /// Direction normal to the surface midway between nodes 1 to 4 and 5 to 8 of a brick: not of unit length.
  template <class Places>
  static Vec3d midway_normal(const Places& x) {
    return nugget::cross(x[2] + x[6] - x[0] - x[4], x[3] + x[7] - x[1] - x[5]);
  }
  /// Axes of a solid; `along`, `across`: from node 1 to nodes 2 and 4. `normal`: midway_normal(), of hexahedra only.
  Frame3d in_brick(const Vec3d& along, const Vec3d& across, const Vec3d& normal = {}) const {
    if (by == By::cross) {
      const Vec3d e1 = unit(nugget::cross(a, normal)), e3 = unit(normal);
      return {e1, nugget::cross(e3, e1), e3};
    }
    const Vec3d first = by == By::vectors ? a : along, second = by == By::vectors ? d : across;
    const Vec3d e1 = unit(first), e3 = unit(cross(first, second));
    return {e1, cross(e3, e1), e3};
  }
};

/// Puts the material axes into the history of a point that begins at `history`, its numbers `stride` apart: of a layer
/// the components of a in the element's frame, of a solid a and b in global axes.
void start_layer_axes(double* history, int stride, double cosine, double sine);
void start_solid_axes(double* history, int stride, const Frame3d& axes);

}  // namespace nugget::kernel
