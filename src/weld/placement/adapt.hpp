// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "weld/tie/segment.hpp"
#include "weld/tie/ties.hpp"

// The sheet around a weld, meshed so that the weld stands over the centre of an element of its size.
namespace nugget::weld {

/// How good shells are: of one, or the worst of several.
struct ShellShape {
  double jacobian = 1.0;  ///< scaled Jacobian: 1 a square or an equilateral triangle, 0 or less a shell turned over [1]
  double aspect = 1.0;    ///< longest side over shortest side [1]
  double warp = 0.0;      ///< between the normals of a quadrilateral's two triangles [degrees]
  double length = 0.0;    ///< area over longest side, of a triangle twice that: what its time step goes by [length]
};
/// Formulas: docs/theory/adapted_patch.md#quality.
ShellShape shape_of(const Corners& corners, bool triangle);
ShellShape shape_of(const model::Shells& shells, Index shell, const std::vector<Vec3d>& x);

/// What a patch must keep. A shell that is worse than a limit already may stay as it is.
struct AdaptLimits {
  double jacobian = 0.6;
  double aspect = 2.5;
  double warp = 5.0;    ///< [degrees]
  double length = 0.7;  ///< of the patch's shortest, over that before
};

/// What became of the sheet under one end of a weld.
struct AdaptedEnd {
  Index weld = none;      ///< in Ties::welds
  Index part = none;      ///< of the sheet, or none
  Index shell = none;     ///< under the weld in the end, or none
  double diameter = 0.0;  ///< [length]
  /// How far from the centre of its element the weld stands: the larger of its bilinear coordinates, 0 over the
  /// centre, 1 over an edge or a node.
  double off_before = 0.0, off_after = 0.0;
  double edge_before = 0.0, edge_after = 0.0;  ///< mean side of that element [length]
  std::vector<Index> moved;                    ///< nodes, ascending
  double farthest = 0.0;                       ///< of these, as they were in the deck [length]
  ShellShape before, after;                    ///< worst of the patch, in the deck and then; where nodes were moved
  std::string left;                            ///< why nothing was moved; empty: nodes were
};

struct Adapted {
  std::vector<Vec3d> x;          ///< of all nodes [length]
  std::vector<AdaptedEnd> ends;  ///< of beams and bricks, in the order of the welds; a node that two beams share: once
};

/// Moves nodes of sheets so that each weld stands over the centre of a quadrilateral whose side is the weld's diameter,
/// or between that and what it was, as the limits allow; the shells around it follow. Nodes stay on the surface of
/// their sheet as it is in the model. Nodes keep their place on free edges, folds of more than 10 degrees and seams;
/// where shells of other parts or thicknesses, other elements, rigid bodies, initial stresses, other ties, sets or
/// cards hold them (sets of whole parts do not); under welds that are done; and where `can_move` says no.
/// `ties`: of the model in its own places. Method: docs/theory/adapted_patch.md.
Adapted adapt(const model::Model& model, const Ties& ties, const std::function<bool(Index node)>& can_move,
              const AdaptLimits& limits = {});

}  // namespace nugget::weld
