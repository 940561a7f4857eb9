// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "deck/deck.hpp"
#include "model/parts.hpp"
#include "model/rigid_weld.hpp"

// The cards of *CONSTRAINED_... that make rigid bodies or change them, as read, until Phase::bodies.
namespace nugget::reading {

/// The codes 0..7 of LS-DYNA (x, y, z, xy, yz, zx, xyz) as bits 0..2.
unsigned bits_of_code(int code);

/// What holds a rigid body: the second card of *MAT_RIGID, and that of _SPC of nodal rigid bodies.
struct RigidConstraintCard {
  double cmo = 0;   ///< 1: codes in global axes, -1: six digits in the axes of a coordinate system, 0: free
  double con1 = 0;  ///< CMO 1: code of held translations 0..7
  int system = 0;   ///< CMO -1: CON1 is the id of the coordinate system
  double con2 = 0;  ///< CMO 1: code of held rotations 0..7; CMO -1: digits xyz and rx ry rz, e.g. 110111
  int spcnid = 0;
  double xspc = 0, yspc = 0, zspc = 0;
  /// Bits 0..5 of what CMO 1 holds.
  unsigned fixed_by_codes() const {
    return bits_of_code(static_cast<int>(con1)) | bits_of_code(static_cast<int>(con2)) << 3;
  }
};
/// *MAT_RIGID, beside its law.
struct RigidCard {
  int lco = 0;                         ///< LCO: id of the coordinate system of local motions and output, 0 none
  std::optional<Frame3d> output_axes;  ///< instead of it, by two vectors
  deck::RowOf<RigidConstraintCard> constraint;
};

struct NodalBodyCard {
  int pid = 0, cid = 0, nsid = 0, pnode = 0, iprt = 0;
};
struct ExtraNodesCard {
  int pid = 0, nodes = 0, iflag = 0;  ///< `nodes`: one node, or a set
};
struct MergeCard {
  int pidl = 0, pidc = 0, iflag = 0;
};

struct BodyCards {
  struct Nodal {
    std::string title;
    deck::RowOf<NodalBodyCard> row;
    std::optional<deck::RowOf<RigidConstraintCard>> spc;  ///< _SPC with CMO -1: held in axes that are found later
    unsigned fixed = 0;                                   ///< what that card holds
    bool given = false;                                   ///< with _INERTIA
    model::RigidBody::Inertia inertia;
    deck::Entry center_node;          ///< with _INERTIA: the node at its centre, if any
    std::optional<deck::Entry> axes;  ///< a coordinate system of the tensor
  };
  struct ExtraNodes {
    bool set = false;  ///< a node set, else one node
    deck::RowOf<ExtraNodesCard> row;
  };
  /// A fillet or butt weld between two nodes.
  struct Seam {
    model::Seam seam;              ///< its nodes and directions are found later
    bool butt = false;             ///< its tensile direction is x, that of a fillet z
    double angle = 0.0;            ///< ALPHA of a fillet: throat against the sheet [rad]
    deck::Entry first, second;     ///< NODEA and NODEB; blank: the next two of the set
    deck::Entry system, strength;  ///< NCID, or CID; SIGY
  };
  struct Merge {
    bool set = false;  ///< PIDC is a set of parts
    deck::RowOf<MergeCard> row;
  };
  struct Weld {
    model::RigidWeld weld;      ///< nodes, body and axis are found later
    deck::Entry first, second;  ///< generalized: the node set and the coordinate system; else the two nodes
    std::vector<Seam> seams;
  };

  std::vector<Nodal> nodal;
  std::vector<ExtraNodes> extra_nodes;
  std::vector<Merge> merges;
  std::vector<Weld> welds;

  /// Adds a weld; one without a number gets it with the bodies (reading/bodies/weld_numbers.hpp).
  void add(Weld weld) { welds.push_back(std::move(weld)); }
};

}  // namespace nugget::reading
