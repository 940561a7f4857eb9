// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
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
  /// Elements of more than 1.4 diameters are divided. Their pieces may be longer and shorter than shells that were
  /// moved: what carries the weld is to be of its size.
  bool divides = false;
  double divided_aspect = 3.5;
  double divided_length = 0.4;  ///< of each piece, over the diameter
};

/// A quadrilateral that becomes five: a square of the weld's diameter within it, and between each of its sides and that
/// of the square another one.
struct DividedShell {
  Index shell = none;
  Corners square;  ///< each corner on the side of the corner of the same number [length]
};
/// Corners of the five pieces, the square first, then that at each side; as numbers of the shell's corners, 0 to 3, and
/// of the square's, 4 to 7. They have the sense of the shell.
inline constexpr std::array<std::array<int, 4>, 5> pieces{
    {{4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

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
  bool divided = false;                        ///< its element was
  std::string whole;                           ///< why it was not, though it is far larger than the weld
  std::string left;                            ///< why nothing was moved; empty: nodes were
};

struct Adapted {
  std::vector<Vec3d> x;          ///< of all nodes [length]
  std::vector<AdaptedEnd> ends;  ///< of beams and bricks, in the order of the welds; a node that two beams share: once
  std::vector<DividedShell> divided;  ///< in the order of the ends
};

/// Why a shell cannot be divided; empty: it can.
using WhyWhole = std::function<std::string(Index shell)>;
/// What of the model names a shell or its nodes so that pieces of it would not be named.
std::vector<std::string> whole_shells(const model::Model& model, const Ties& ties);

/// Moves nodes of sheets so that each weld stands over the centre of a quadrilateral whose side is the weld's diameter,
/// or between that and what it was, as the limits allow; the shells around it follow. Nodes stay on the surface of
/// their sheet as it is in the model. Nodes keep their place on free edges, folds of more than 10 degrees and seams;
/// where shells of other parts or thicknesses, other elements, rigid bodies, initial stresses, other ties, sets or
/// cards hold them (sets of whole parts do not); under welds that are done; and where `can_move` says no.
/// Where the limits say so, and `why_whole` nothing against it, elements far larger than the diameter are divided.
/// `ties`: of the model in its own places. Method: docs/theory/adapted_patch.md.
Adapted adapt(const model::Model& model, const Ties& ties, const std::function<bool(Index node)>& can_move,
              const AdaptLimits& limits = {}, const WhyWhole& why_whole = {});

}  // namespace nugget::weld
