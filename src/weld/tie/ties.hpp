// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/finding.hpp"
#include "base/vec3.hpp"
#include "model/model.hpp"

// What a weld is and how it is tied to its sheets. The eight projection cases are those of S. Bala, "Deformable
// Spotwelds in LS-DYNA for Impact and NVH Applications".
namespace nugget::weld {

using model::Index;
using model::none;

/// The part of a sheet that the end of a weld is tied to where it is tied by area: the nodes whose shape functions
/// reach into the nugget's disc, each with the mean of its shape function over it. See disc_on_sheet.
struct Disc {
  /// What one shell brings in: the integral of its corners' shape functions over all that the disc covers. Of a
  /// triangle the fourth is 0.
  struct Piece {
    Index shell = none;
    std::array<double, 4> weight{};
    double sum() const { return weight[0] + weight[1] + weight[2] + weight[3]; }
  };
  double radius = 0.0;          ///< [length]
  double covered = 0.0;         ///< share of its area that lies on the sheet [1]
  std::vector<Index> nodes;     ///< ascending
  std::vector<double> weights;  ///< of each node, adding up to 1
  std::vector<Piece> pieces;    ///< adding up to `weights`

  bool empty() const { return nodes.empty(); }
};

/// A node that follows a segment: v = sum of weight_k v_k, and the spins likewise if `rotations`. A node that is not
/// moved onto the segment keeps its gap, which turns with the segment.
struct Tie {
  Index node = none;
  Index contact = none;                            ///< in Model::contacts
  Index shell = none;                              ///< whose face the segment is; none for the face of a brick
  Index part = none;                               ///< of the shell or brick; none for a segment of neither
  model::Segment segment{none, none, none, none};  ///< nodes; a triangle repeats its third
  double xi = 0.0, eta = 0.0;      ///< bilinear coordinates; on a triangle the area coordinates of its corners 2 and 3
  std::array<double, 4> weight{};  ///< shape functions, summing to 1; on a triangle the fourth is 0
  Vec3d point;                     ///< the node projected onto the surface through the segment's nodes [length]
  double gap = 0.0;                ///< from the node's place before the projection to `point` [length]
  double moved = 0.0;     ///< how far projection moved the node: `gap`, or 0 where TIEDPRJ = 1 keeps the gap [length]
  bool rotations = true;  ///< moments are handed over
  bool twist = false;     ///< the moment about the segment's normal as in-plane forces (_WITH_TORSION)
  bool couples = false;   ///< all moments as forces: the face of a brick, whose nodes have no rotations
  bool spring = false;    ///< by penalty: the node is held by springs instead of a constraint
  bool lever = true;      ///< the gap counts as a lever; false: _OFFSET
  /// Of parts that touch (*CONTACT_AUTOMATIC_SINGLE_SURFACE_TIED): the node's own part, the distance from surface to
  /// surface, negative where they overlap, and whether the node's SPCs hold nothing that those of the segment do not.
  Index own_part = none;
  double between = 0.0;  ///< [length]
  bool held_alike = false;
  bool arched = false;  ///< between its corners the segment is as bent as their rotations say; see arm_from
  Index rigid_body =
      none;  ///< in Model::rigid_bodies, if it carries all nodes of the segment: the node then belongs to it
  /// If not empty the node follows the rigid motion that fits the disc's nodes best, in place of the segment, unless
  /// one rigid body carries it.
  Disc disc;

  bool by_area() const { return !disc.empty() && rigid_body == none; }
};

/// What became of one node of a weld.
///
/// `projection_case`, after docs/theory/projection.md#the-eight-cases: 1 over the interior of an element (its centroid
/// is the ideal), 2 on an element's edge, 3 on a corner node, 4 over sheets that penetrate each other in the deck,
/// moved apart before or not, 5 no segment in reach, 6 not over its own sheet but another segment is in reach, 7 sheets
/// that cross so that the weld would be turned over or crushed, 8 the same with normals that point outward. 5, 7 and 8
/// are not tied. 0: no projection is needed (the node is a sheet's own node or belongs to a rigid body) or none was
/// asked for (no contact tracks it).
struct Projection {
  Index node = none;
  bool tied = false;  ///< attached to a sheet, by a tie or otherwise
  int projection_case = 0;
  std::string reason;  ///< one sentence for welds.csv
  Tie tie;             ///< meaningful if `tied` and `projection_case` is not 0
  /// Of the closest segment, tied or not; of a node of shells the first of them. none: there is none, or it is no
  /// shell's.
  Index closest_shell = none;
  double distance = 0.0;          ///< to the closest segment that it may be tied to; infinite: there is none [length]
  double tolerance = 0.0;         ///< within which that segment would be in reach [length]
  bool only_sheet_taken = false;  ///< not tied: what is in reach is the sheet that holds the weld's other end
  bool faces_sheet = false;       ///< that segment lies over or under the node and across the weld; false: beside it
};

/// Corners of one face of a brick.
using Facet = std::array<Index, 4>;

/// A spot weld: a beam, a brick or an assembly of bricks of spot-weld material, or a rigid weld.
struct Weld {
  enum class Kind { beam, solid, assembly, rigid, connector };  ///< connector: a discrete beam between sheets
  /// What a rigid weld is written as.
  enum class Rigid : unsigned char { spotweld, generalized, nodal_body, rivet, fillet, butt, cross_fillet, combined };
  Kind kind = Kind::beam;
  int id = 0;                               ///< element id; of an assembly or a rigid weld its own
  Index part = none;                        ///< none for a rigid weld
  Index element = none;                     ///< in beams or solids by kind; of a rigid weld in Model::rigid_bodies
  std::vector<Index> elements;              ///< all of them, `element` the first; more than one in assemblies only
  Rigid rigid = Rigid::spotweld;            ///< of a rigid weld only
  bool interpolated = false;                ///< a connector of *CONSTRAINED_INTERPOLATION_SPOTWELD or _SPR2
  bool self_piercing = false;               ///< and that a rivet of _SPR2
  std::array<Index, 2> sheets{none, none};  ///< parts that its two ends are attached to
  /// The nodes of its two end faces, each once; of a beam or rigid weld one node each.
  std::array<std::vector<Index>, 2> face;
  /// Of bricks: the faces of its elements that make up the end faces, all with their corners in the sense of the axis
  /// from the first end to the second.
  std::array<std::vector<Facet>, 2> facets;
  std::array<Index, 2> tied_parts{none, none};  ///< that its ends are to be tied to (*ELEMENT_BEAM_PID), or none
  /// Of an assembly: direction in which its s axis starts; zero: by the rule of beams (see BrickSection).
  Vec3d orientation;
  double diameter = 0.0;  ///< of bricks: of the circle with the area of their end faces; of a rigid weld 0 [length]
  double length = 0.0, length_before = 0.0;  ///< after and before projection [length]
  bool tied = false;                         ///< every node of it is attached
  bool deleted = false;                      ///< by SPOTSTP = 2
  bool held_by_bricks = false;               ///< a brick inside a large nugget: by neighbours in place of a sheet
  std::vector<Projection>
      ends;  ///< beam: end 1, end 2; bricks: each node of the end faces once, in the elements' order; rigid: its nodes
  Place place;

  bool is_seam() const { return kind == Kind::rigid && rigid > Rigid::rivet; }
  bool of_bricks() const { return kind == Kind::solid || kind == Kind::assembly; }
  /// Of its elements, where it has some.
  model::ElementKind element_kind() const { return of_bricks() ? model::ElementKind::solid : model::ElementKind::beam; }
};

std::string_view to_string(Weld::Kind kind);

/// All ties of a model. `x` are the node coordinates at the start of the run, after projection, from which lengths and
/// masses follow.
struct Ties {
  std::vector<Tie> ties;    ///< ascending by node; a node occurs once
  std::vector<Weld> welds;  ///< beams, then bricks, then rigid welds, each in the order of the model
  std::vector<Vec3d> x;     ///< [length]
};

/// Ties the tracked nodes of all tie contacts to their closest segments. A segment is in reach of a node within
///     max(0.6 (t_node + t_segment), 0.05 shortest diagonal),   or   0.6 (|SAST| + |SBST|)   if one of these is
///     negative,
/// where t_node is the diameter of a beam, the thickness of a shell, 0 for a brick. The closest one wins, of equal ones
/// (within 1e-6 of that tolerance) the first in the order of the reference side. The two ends of a beam weld go to
/// different parts; so do those of an edge of a weld brick that one part would crush, or the farther one stays free:
/// the nodes between the layers of a nugget. The parts of *ELEMENT_BEAM_PID are obeyed; of two contacts that could tie
/// a node the first does. Projection goes onto the surface through the segment's nodes (LS-DYNA's CNTCO = 0), unless
/// TIEDPRJ = 1.
///
/// `x`: where the nodes stand once sliding contacts have resolved initial penetrations, by node of the model [length]
/// (impact::resolve_initial_penetrations). The closest segment is that in the deck's
/// places, its foot that in `x`.
///
/// Findings: each weld node out of reach (then SPOTSTP: 0 and 3 go on, 1 makes an error after all are listed, 2 deletes
/// the weld), sheets that penetrate or cross, nodes constrained twice, segments that are constrained themselves,
/// segments of rigid bodies. The result does not depend on the number of threads.
Ties tie(const model::Model& model, std::vector<Vec3d> x, Findings& findings);
/// The same with the nodes in the deck's places: right where no sliding contact moves any.
Ties tie(const model::Model& model, Findings& findings);

/// Weights below this are round-off of a node on an edge or a corner.
inline constexpr double no_weight = 1e-10;
/// The arm by which the rotation of a corner of its segment moves a tied node: `gap`, its distance from Tie::point; of
/// an arched segment half the way from the corner to that point besides, so that the surface is a parabola between
/// corners whose rotations differ (docs/theory/ties.md#parts-that-touch). `corner`: its place [length]
inline Vec3d arm_from(const Tie& tie, const Vec3d& corner, const Vec3d& gap) {
  return tie.arched ? gap + 0.5 * (tie.point - corner) : gap;
}
/// The nodes of the sheet that the tied node follows.
std::vector<Index> carriers(const Tie& tie);

/// A line of the list that OUTSEG = 1 asks for: node, segment, shell, position on it and distance moved, in user ids.
std::string describe(const model::Model& model, const Tie& tie);

}  // namespace nugget::weld
