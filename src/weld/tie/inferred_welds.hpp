// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "weld/tie/ties.hpp"

// A deck whose mesh, materials or sections are missing is refused, but its welds are there. Elements without a material
// are taken for welds where they lie as only welds do.
namespace nugget::weld {

/// Beams without a material that are not part of a frame: chains of at most three beams (a stack of four sheets) whose
/// nodes belong to no shell, brick or other beam. Ascending. A section other than of a weld or a discrete beam (ELFORM
/// 9 and 6) says that they are none.
std::vector<model::Index> inferred_beams(const model::Model& model);

/// Bricks without a material in lumps of at most sixteen bricks, or a stack of three such, that share nodes with no
/// other element. Ascending.
std::vector<model::Index> inferred_bricks(const model::Model& model);

/// Whether a weld is only taken for one.
bool is_inferred(const model::Model& model, const Weld& weld);

}  // namespace nugget::weld
