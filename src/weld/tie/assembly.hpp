// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <set>
#include <vector>

#include "weld/tie/ties.hpp"

// Welds made of bricks: which bricks are one weld, and which of their faces are its ends.
namespace nugget::weld {

/// The part whose sheet a node is attached to, or none.
using SheetAt = std::function<Index(Index node)>;

/// Makes assemblies of brick welds that belong together without a *DEFINE_HEX_SPOTWELD_ASSEMBLY saying so. Two bricks
/// of one part are of one weld if they share at least an edge (two nodes), unless all nodes that they share lie on one
/// and the same sheet: such bricks are stacked through that sheet and are two welds. An assembly takes the place of its
/// first brick and the least of its bricks' ids; a note says so. More than 16 bricks (LS-DYNA's limit) are not joined:
/// a warning.
std::vector<Weld> join_clusters(const model::Model& model, std::vector<Weld> welds, const SheetAt& sheet_at,
                                Findings& findings);

/// A face whatever corner it starts at and which way round it runs.
Facet sorted(Facet face);

/// The faces, `sorted`, that bricks of different welds of one part share.
std::set<Facet> faces_between_welds(const model::Model& model, const std::vector<Weld>& welds);

/// Lays the end faces of a weld of bricks, and with them `ends`. They are the outer faces of its bricks that lie with
/// all corners on one of two sheets. Where there are no two such sheets, each brick gives the pair of opposite faces
/// that it shares least with others of the weld, of equal ones the pair with the shortest distance; a single brick that
/// shares a face with another weld (`between`) the pair that is held best: on a sheet, then by such a brick.
void find_end_faces(const model::Model& model, Weld& weld, const SheetAt& sheet_at, const std::set<Facet>& between);

}  // namespace nugget::weld
