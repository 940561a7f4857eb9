// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/parts.hpp"

namespace nugget::model {

struct Model;

/// A plane that cuts: the side to which `normal` points is its head side. Bounded by edges l and m from the origin
/// where their lengths are not 0, or by a circle about the origin.
struct CuttingPlane {
  Vec3d origin, normal;
  Vec3d edge_l, edge_m;                   ///< unit vectors
  double length_l = 0.0, length_m = 0.0;  ///< 0: infinite
  double radius = 0.0;                    ///< 0: no circle
};

/// *DATABASE_CROSS_SECTION_...: nodes, and the elements on one side of them whose internal forces on these nodes are
/// added up.
struct CrossSection {
  /// A point that goes with the material, on the line between two nodes, or a node itself (`from` = `to`).
  struct Corner {
    Index from = none, to = none;
    double share = 0.0;  ///< of the way from `from` to `to`
  };
  /// An element of the section and the piece of the section's area that is its own: a polygon of three and more corners
  /// (bricks), a line of two that has the shell's thickness, or a point where a beam passes. No corner: no area.
  struct Facet {
    ElementKind kind = ElementKind::nothing;
    Index element = none;
    std::vector<Corner> corners;
  };
  int id = 0;
  std::string title;
  std::vector<Index> nodes;  ///< ascending
  std::vector<Facet> facets;
  std::optional<CuttingPlane> plane;  ///< of the plane form, at time 0
  std::vector<Index> parts;           ///< that the plane cuts
  Index rigid_body = none;            ///< ITYPE 0: forces in the axes of this body (`axes` at time 0) ...
  Frame3d axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Index accelerometer = none;  ///< ... ITYPE 1: of this one of Model::accelerometers ...
  Index system = none;         ///< ... ITYPE 2: of this coordinate system; none of them: global axes
  Place place;
};

/// *DATABASE_NODAL_FORCE_GROUP.
struct NodalForceGroup {
  int set_id = 0;
  std::vector<Index> nodes;
  Index system = none;  ///< CID: the sum is written in its axes as well
};

/// Facets of elements between the nodes of a section (of `marked`, by node): the side or face that these nodes span.
std::vector<CrossSection::Facet> facets_between(const Model& model, ElementKind kind,
                                                const std::vector<Index>& elements, const std::vector<char>& marked);
/// Gives the section all elements of its parts that its plane passes through with the nodes at the places `x`
/// [length], and as its nodes those of their nodes that lie on the head side; what lies in the plane up to round-off is
/// on that side. An element that reaches over an edge of the plane is left out.
void cut(const Model& model, const std::vector<Vec3d>& x, CrossSection& section);
/// Its bricks in these parts, or, where none are named, all.
std::vector<Index> bricks_of(const Model& model, const CrossSection& section, const std::vector<Index>& parts);

}  // namespace nugget::model
